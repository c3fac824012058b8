//! `trigon render` of an SVG file: the file in, one picture and a report out.
//!
//! How it is drawn is told apart by `--preset`; what is checked before, written and reported after is the same.

pub(crate) use super::document::Reader;
use super::{cs184, document};
use crate::failure::Failure;
use crate::hash::PictureHash;
use crate::json::Json;
use crate::options::{Given, Preset, RenderCommandOptions, RenderOptions};
use crate::output::{Destination, Encoding, Images};
use crate::report::{ReportTarget, write_report};
use crate::stdin;
use crate::terminal::Terminal;
use crate::warnings;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use trigon_image::Rgba8Image;
use trigon_svg::svg::{SvgError, is_svg};

/// A picture that was drawn, and what the report says about it.
pub(crate) struct Drawn {
    pub(crate) image: Rgba8Image,
    /// Each with the file's name.
    pub(crate) warnings: Vec<String>,
    pub(crate) samples: String,
    pub(crate) simd: &'static str,
    pub(crate) threads: usize,
    pub(crate) load: Duration,
    pub(crate) draw: Duration,
}

/// Whether the only input is an SVG file, by its content, or by its name where the content says nothing.
pub(crate) fn is_drawing(models: &[PathBuf], max_bytes: u64) -> bool {
    let [path] = models else { return false };
    if path.as_os_str() == "-" {
        return stdin::bytes(max_bytes).is_ok_and(is_svg);
    }
    let mut start = Vec::new();
    let read = File::open(path).and_then(|file| file.take(1 << 16).read_to_end(&mut start));
    let is_named_so =
        path.extension().is_some_and(|end| end.eq_ignore_ascii_case("svg") || end.eq_ignore_ascii_case("svgz"));
    read.is_ok() && (is_svg(&start) || is_named_so)
}

/// Draws the SVG file that is the only input.
pub(super) fn draw(options: &RenderCommandOptions, given: Given, max_bytes: u64) -> Result<(), Failure> {
    let (render, started) = (&options.render, Instant::now());
    let output = Destination::new(&render.output.output);
    let encoding = Encoding::choose(&render.output, &output)?;
    output.check(&render.models)?;
    output.check_not_among(&render.picture.layer_files())?;
    let report_target = ReportTarget::choose(render.output.json.as_ref(), &output);
    report_target.as_ref().map_or(Ok(()), |target| target.check(&render.models))?;

    let mut drawn = make(&mut Reader::default(), options, given, max_bytes)?;
    tell(render, &drawn.warnings)?;
    let (terminal, path) = (Terminal::detect(render.output.quiet), render.models[0].display());
    let encode_started = Instant::now();
    let mut hash = PictureHash::new();
    hash.add(&drawn.image);
    let (width, height) = (drawn.image.width(), drawn.image.height());
    let image = std::mem::replace(&mut drawn.image, Rgba8Image::new(0, 0));
    let floats = encoding.is_float().then(|| image.to_linear());
    output.write(&encoding.encode(&Images { bytes: Some(image), floats })?)?;
    let Some(target) = report_target else { return Ok(()) };
    let ms = |time: Duration| Json::Decimal(time.as_secs_f64() * 1e3);
    let times = vec![
        ("load", ms(drawn.load)),
        ("draw", ms(drawn.draw)),
        ("encode", ms(encode_started.elapsed())),
        ("total", ms(started.elapsed())),
    ];
    let report = Json::Object(vec![
        ("version", env!("CARGO_PKG_VERSION").into()),
        ("input", path.to_string().into()),
        ("output", output.name().into()),
        ("format", encoding.format.name().into()),
        ("width", width.into()),
        ("height", height.into()),
        ("samples", drawn.samples.into()),
        ("warnings", Json::List(drawn.warnings.into_iter().map(Json::from).collect())),
        ("hash", hash.to_hex().into()),
        ("simd", drawn.simd.into()),
        ("threads", drawn.threads.into()),
        ("times_ms", Json::Object(times)),
    ]);
    write_report(&report, &target, terminal)
}

/// Reads the file, unless `reader` has it, and draws it. (The program of the course reads a file each time.)
pub(crate) fn make(
    reader: &mut Reader,
    options: &RenderCommandOptions,
    given: Given,
    max_bytes: u64,
) -> Result<Drawn, Failure> {
    match options.render.preset.preset {
        Some(Preset::Cs184) => cs184::draw(options, given, max_bytes),
        // Those of models were refused.
        _ => document::draw(reader, options, given, max_bytes),
    }
}

/// Says what is odd about the file and the pictures around it; an error if the options are strict.
pub(crate) fn tell(options: &RenderOptions, warnings: &[String]) -> Result<(), Failure> {
    let terminal = Terminal::detect(options.output.quiet);
    for warning in warnings {
        if options.input.strict {
            return Err(warnings::strict(warning));
        }
        terminal.warning(warning);
    }
    Ok(())
}

/// The bytes of a file, or of standard input.
pub(super) fn read(path: &Path, max_bytes: u64) -> Result<Vec<u8>, Failure> {
    if path.as_os_str() == "-" {
        return stdin::bytes(max_bytes)
            .map(<[u8]>::to_vec)
            .map_err(|error| Failure::work(format!("cannot read standard input: {error}")));
    }
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(max_bytes.saturating_add(1)).read_to_end(&mut bytes));
    read.map_err(|error| Failure::work(format!("cannot read {}: {error}", path.display())))?;
    Ok(bytes)
}

/// Where the files that an SVG file links to are looked for: beside it, those of standard input in the current folder.
pub(super) fn folder_of(path: &Path) -> PathBuf {
    let parent = if path.as_os_str() == "-" { None } else { path.parent() };
    parent.unwrap_or(Path::new("")).to_owned()
}

/// An error about a file.
pub(super) fn failure(path: &Path, error: &SvgError) -> Failure {
    Failure::work(format!("{}: {error}", path.display()))
}
