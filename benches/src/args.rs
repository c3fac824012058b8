//! The command line: words in, a [`Command`] out. Where several configurations make sense an option takes a list,
//! separated by commas.

use core::fmt::Display;
use core::str::FromStr;
use lexopt::{Arg, Parser, ValueExt};
use std::path::PathBuf;
use std::time::Duration;
use trigon::lanes::SimdLevel;
use trigon::target::SamplePattern;
use trigon_bench::coverage::CoveragePath;
use trigon_bench::measure::Budget;
use trigon_bench::scene::{FRAMES, ModelFiles, SceneKind};

/// How to call the command.
pub(crate) const USAGE: &str = "\
usage: trigon-bench --scene LIST [--size LIST] [--samples LIST] [--threads LIST] [--simd LIST] [--frames N]
                    [--max-seconds S] [--obj FILE] [--tex FILE] [--png OUT [--frame I]]
       trigon-bench coverage --csv FILE --out RAW [--size WxH] [--samples N] [--path opaque|discarding]
                    [--threads N] [--simd LEVEL]

Draws benchmark scenes and prints one line of JSON per configuration: milliseconds a frame, and the 64-bit FNV-1a hash
of the 8-bit pixels of orbit frame 0. LIST is one value or several, separated by commas.

scenes    model model_flat (need --obj) big small fill_ftb fill_btf hall, or all
--size    1920x1080
--samples 1; 2, 4, 8 and 16 are the standard patterns, shaded per pixel
--threads one per core
--simd    scalar, sse4.2, avx2, avx512, neon, or all; the best of this CPU
--frames  36; 0 draws the --png only
--png     writes frame I (3) of the orbit

coverage counts the triangles of a CSV file (x,y,x,y,x,y in pixels) that cover each sample and writes one 32-bit word
per sample, [y][x][sample]; byte c counts the triangles whose index modulo 4 is c.";

/// What to do.
pub(crate) enum Command {
    Help,
    Timing(TimingArgs),
    Coverage(CoverageArgs),
}

/// Configurations to time.
pub(crate) struct TimingArgs {
    pub(crate) scenes: Vec<SceneKind>,
    pub(crate) sizes: Vec<[u32; 2]>,
    pub(crate) samples: Vec<u32>,
    pub(crate) threads: Vec<usize>,
    pub(crate) simd: Vec<SimdLevel>,
    pub(crate) model: ModelFiles,
    pub(crate) budget: Budget,
    pub(crate) png: Option<PathBuf>,
    pub(crate) png_frame: u32,
}

/// Triangles whose coverage is counted.
pub(crate) struct CoverageArgs {
    pub(crate) csv: PathBuf,
    pub(crate) out: PathBuf,
    pub(crate) size: [u32; 2],
    pub(crate) samples: SamplePattern,
    pub(crate) path: CoveragePath,
    pub(crate) threads: usize,
    pub(crate) simd: SimdLevel,
}

/// Reads this process's command line.
pub(crate) fn parse() -> Result<Command, lexopt::Error> {
    let mut parser = Parser::from_env();
    let is_coverage = std::env::args_os().nth(1).is_some_and(|word| word == "coverage");
    if is_coverage {
        parser.next()?;
        parse_coverage(&mut parser)
    } else {
        parse_timing(&mut parser)
    }
}

fn parse_timing(parser: &mut Parser) -> Result<Command, lexopt::Error> {
    let mut args = TimingArgs {
        scenes: Vec::new(),
        sizes: vec![[1920, 1080]],
        samples: vec![1],
        threads: vec![available_threads()],
        simd: vec![default_simd()?],
        model: ModelFiles::default(),
        budget: Budget { frames: FRAMES, longest: Duration::from_secs(30) },
        png: None,
        png_frame: 3,
    };
    while let Some(arg) = parser.next()? {
        match arg {
            Arg::Long("help") | Arg::Short('h') => return Ok(Command::Help),
            Arg::Long("scene") => args.scenes = list(parser, &SceneKind::ALL)?,
            Arg::Long("size") => args.sizes = list::<Size>(parser, &[])?.into_iter().map(|size| size.0).collect(),
            Arg::Long("samples") => args.samples = list(parser, &[])?,
            Arg::Long("threads") => args.threads = list(parser, &[])?,
            Arg::Long("simd") => args.simd = list(parser, &available_levels())?,
            Arg::Long("frames") => args.budget.frames = parser.value()?.parse()?,
            Arg::Long("max-seconds") => args.budget.longest = seconds(parser)?,
            Arg::Long("obj") => args.model.obj = Some(parser.value()?.into()),
            Arg::Long("tex") => args.model.texture = Some(parser.value()?.into()),
            Arg::Long("png") => args.png = Some(parser.value()?.into()),
            Arg::Long("frame") => args.png_frame = parser.value()?.parse()?,
            _ => return Err(arg.unexpected()),
        }
    }
    if args.scenes.is_empty() {
        return Err("--scene is missing".into());
    }
    Ok(Command::Timing(args))
}

fn parse_coverage(parser: &mut Parser) -> Result<Command, lexopt::Error> {
    let (mut csv, mut out) = (None, None);
    let mut args = CoverageArgs {
        csv: PathBuf::new(),
        out: PathBuf::new(),
        size: [512, 512],
        samples: SamplePattern::CENTER,
        path: CoveragePath::default(),
        threads: available_threads(),
        simd: default_simd()?,
    };
    while let Some(arg) = parser.next()? {
        match arg {
            Arg::Long("help") | Arg::Short('h') => return Ok(Command::Help),
            Arg::Long("csv") => csv = Some(parser.value()?.into()),
            Arg::Long("out") => out = Some(parser.value()?.into()),
            Arg::Long("size") => args.size = parser.value()?.parse::<Size>()?.0,
            Arg::Long("samples") => {
                let samples = parser.value()?.parse()?;
                args.samples = SamplePattern::standard(samples).ok_or("samples are 1, 2, 4, 8 or 16")?;
            }
            Arg::Long("path") => {
                args.path = match parser.value()?.to_str() {
                    Some("opaque") => CoveragePath::Opaque,
                    Some("discarding") => CoveragePath::Discarding,
                    _ => return Err("--path is opaque or discarding".into()),
                }
            }
            Arg::Long("threads") => args.threads = parser.value()?.parse()?,
            Arg::Long("simd") => args.simd = parser.value()?.parse()?,
            _ => return Err(arg.unexpected()),
        }
    }
    args.csv = csv.ok_or("--csv is missing")?;
    args.out = out.ok_or("--out is missing")?;
    Ok(Command::Coverage(args))
}

/// The values of a list; `all` where there is a list of all.
fn list<T: FromStr + Clone>(parser: &mut Parser, all: &[T]) -> Result<Vec<T>, lexopt::Error>
where
    T::Err: Display,
{
    let text = parser.value()?.string()?;
    if text == "all" && !all.is_empty() {
        return Ok(all.to_vec());
    }
    text.split(',').map(|word| word.parse().map_err(|error| format!("'{word}': {error}").into())).collect()
}

fn seconds(parser: &mut Parser) -> Result<Duration, lexopt::Error> {
    let seconds: f64 = parser.value()?.parse()?;
    Duration::try_from_secs_f64(seconds).map_err(|error| format!("--max-seconds: {error}").into())
}

fn available_threads() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

fn available_levels() -> Vec<SimdLevel> {
    SimdLevel::ALL.into_iter().filter(|level| level.is_available()).collect()
}

fn default_simd() -> Result<SimdLevel, lexopt::Error> {
    SimdLevel::from_env().map_err(|error| error.to_string().into())
}

/// Width and height, written `1920x1080`.
#[derive(Clone, Copy)]
struct Size([u32; 2]);

impl FromStr for Size {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (width, height) = text.split_once('x').ok_or("a size is written 1920x1080")?;
        match (width.parse(), height.parse()) {
            (Ok(width), Ok(height)) if width > 0 && height > 0 => Ok(Self([width, height])),
            _ => Err("a size is written 1920x1080"),
        }
    }
}
