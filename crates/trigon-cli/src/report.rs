//! The report of `--json`: what was drawn, how long each stage took, what was wrong.
//!
//! Collected while the command runs, printed at its end. Times are wall times in milliseconds; everything else is the
//! same on every machine, but for the SIMD level and the number of threads.

use crate::failure::Failure;
use crate::hash::PictureHash;
use crate::json::Json;
use crate::output::Destination;
use crate::terminal::Terminal;
use std::path::PathBuf;
use std::time::{Duration, Instant};
use trigon::geometry::GeometryStatistics;

/// Where the report goes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum ReportTarget {
    /// Standard output.
    Stdout,
    /// Standard error, because the picture goes to standard output.
    Stderr,
    /// A file.
    File(PathBuf),
}

impl ReportTarget {
    /// The place that `--json` and `--output` together mean.
    pub(crate) fn choose(json: Option<&Option<PathBuf>>, output: &Destination) -> Option<Self> {
        match (json?, output) {
            (Some(path), _) if path.as_os_str() != "-" => Some(Self::File(path.clone())),
            (_, Destination::Stdout) => Some(Self::Stderr),
            (_, Destination::File(_)) => Some(Self::Stdout),
        }
    }

    /// Finds what would make writing fail, without touching anything.
    pub(crate) fn check(&self, inputs: &[PathBuf]) -> Result<(), Failure> {
        match self {
            Self::File(path) => Destination::File(path.clone()).check(inputs),
            Self::Stdout | Self::Stderr => Ok(()),
        }
    }
}

/// What is reported.
#[derive(Debug)]
pub(crate) struct Report {
    started: Instant,
    pub(crate) models: Vec<String>,
    pub(crate) output: String,
    pub(crate) format: &'static str,
    pub(crate) size: (u32, u32),
    pub(crate) samples: String,
    pub(crate) shader: &'static str,
    pub(crate) frames: u32,
    pub(crate) triangles: usize,
    pub(crate) geometry: GeometryStatistics,
    pub(crate) warnings: Vec<String>,
    pub(crate) stages: Stages,
    pub(crate) hash: PictureHash,
    pub(crate) simd: &'static str,
    pub(crate) threads: usize,
    /// Where the camera of the first frame stands and looks.
    pub(crate) eye: [f64; 3],
    pub(crate) target: [f64; 3],
}

/// Wall times of the stages, summed over frames.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Stages {
    /// Reading models and the files they name.
    pub(crate) load: Duration,
    /// Decoding textures, mip chains, displacement.
    pub(crate) upload: Duration,
    /// Vertices, clipping, setup, binning.
    pub(crate) geometry: Duration,
    /// Rasterization, shading, resolve; preparing draws, occlusion and outlines.
    pub(crate) tiles: Duration,
    /// Making the file's bytes, writing included.
    pub(crate) encode: Duration,
}

impl Report {
    /// An empty report; the clock of the total starts now.
    pub(crate) fn start() -> Self {
        Self {
            started: Instant::now(),
            models: Vec::new(),
            output: String::new(),
            format: "",
            size: (0, 0),
            samples: String::new(),
            shader: "",
            frames: 0,
            triangles: 0,
            geometry: GeometryStatistics::default(),
            warnings: Vec::new(),
            stages: Stages::default(),
            hash: PictureHash::new(),
            simd: "",
            threads: 0,
            eye: [0.0; 3],
            target: [0.0; 3],
        }
    }

    /// Notes a warning and shows it.
    pub(crate) fn warn(&mut self, terminal: Terminal, message: String) {
        terminal.warning(&message);
        self.warnings.push(message);
    }

    /// Writes the report where it is wanted.
    pub(crate) fn write(&self, target: &ReportTarget, terminal: Terminal) -> Result<(), Failure> {
        write_report(&self.to_json(), target, terminal)
    }

    fn to_json(&self) -> Json {
        let g = &self.geometry;
        let texts = |texts: &[String]| Json::List(texts.iter().map(|text| text.clone().into()).collect());
        Json::Object(vec![
            ("version", env!("CARGO_PKG_VERSION").into()),
            ("models", texts(&self.models)),
            ("output", self.output.clone().into()),
            ("format", self.format.into()),
            ("width", self.size.0.into()),
            ("height", self.size.1.into()),
            ("frames", self.frames.into()),
            ("samples", self.samples.clone().into()),
            ("shader", self.shader.into()),
            ("eye", Json::Point(self.eye)),
            ("target", Json::Point(self.target)),
            ("triangles", self.triangles.into()),
            ("submitted", g.submitted.into()),
            ("drawn", g.drawn.into()),
            ("clipped", g.clipped.into()),
            ("outside", g.outside.into()),
            ("culled", g.culled.into()),
            ("empty", g.empty.into()),
            ("dropped", g.dropped.into()),
            ("blank", Json::Bool(g.drawn == 0)),
            ("warnings", texts(&self.warnings)),
            ("hash", self.hash.to_hex().into()),
            ("simd", self.simd.into()),
            ("threads", self.threads.into()),
            ("times_ms", self.times()),
        ])
    }

    fn times(&self) -> Json {
        let ms = |time: Duration| Json::Decimal(time.as_secs_f64() * 1e3);
        let Stages { load, upload, geometry, tiles, encode } = self.stages;
        Json::Object(vec![
            ("load", ms(load)),
            ("upload", ms(upload)),
            ("geometry", ms(geometry)),
            ("tiles", ms(tiles)),
            ("encode", ms(encode)),
            ("total", ms(self.started.elapsed())),
        ])
    }
}

/// Writes a report where it is wanted.
pub(crate) fn write_report(report: &Json, target: &ReportTarget, terminal: Terminal) -> Result<(), Failure> {
    let text = format!("{report}\n");
    match target {
        ReportTarget::Stdout => Destination::Stdout.write(text.as_bytes()),
        ReportTarget::Stderr => {
            terminal.note(text.trim_end());
            Ok(())
        }
        ReportTarget::File(path) => Destination::File(path.clone()).write(text.as_bytes()),
    }
}
