//! `trigon compare`: a model or SVG file and options to vary in; a labelled sheet of all combinations out.

use super::drawing;
use super::render::check_kind;
use crate::compare::{Drawer, Entry, Layout, Reference, Subject, Variant, check_size, rmse, sheet, variants};
use crate::failure::Failure;
use crate::hash::PictureHash;
use crate::json::Json;
use crate::load;
use crate::options::{CompareOptions, Given};
use crate::output::{Destination, Encoding, Images};
use crate::report::{ReportTarget, write_report};
use crate::terminal::Terminal;
use crate::{settings, view};
use std::ffi::OsString;
use std::time::Duration;
use trigon::pipeline::Outputs;
use trigon_image::Rgba8Image;

/// What one combination gave.
struct Compared {
    variant: Variant,
    image: Rgba8Image,
    time: Duration,
    rmse: f64,
}

pub(crate) fn compare(options: &CompareOptions, given: Given, arguments: &[OsString]) -> Result<(), Failure> {
    let render = &options.render.render;
    let output = Destination::new(&render.output.output);
    let encoding = Encoding::choose(&render.output, &output)?;
    if encoding.is_float() {
        return Err(Failure::usage("sheets have 8 bits per channel; leave out --bit-depth, and write PNG"));
    }
    output.check(&render.models)?;
    output.check_not_among(&render.picture.layer_files())?;
    let target = ReportTarget::choose(render.output.json.as_ref(), &output);
    target.as_ref().map_or(Ok(()), |target| target.check(&render.models))?;
    let subject = match drawing::is_drawing(&render.models, load::max_file_bytes(&render.input)) {
        true => Subject::Drawing,
        false => Subject::Model,
    };
    let variants = variants(arguments, options, given)?;
    variants.iter().try_for_each(|variant| check(subject, variant))?;
    // All models have the size of the options; of SVG files it is known once the first is drawn.
    let size = render.picture.size;
    if subject == Subject::Model {
        check_picture(options, (size.width, size.height))?;
    }

    let mut reference = Reference::default();
    let cells = draw_all(arguments, subject, variants, &mut reference, options)?;
    let picture = sheet(&entries(options, &cells, &reference), &layout(options, &cells))?;
    output.write(&encoding.encode(&Images { bytes: Some(picture), floats: None })?)?;
    match target {
        Some(target) => write_report(&report(options, &cells), &target, Terminal::detect(render.output.quiet)),
        None => Ok(()),
    }
}

/// Finds what is wrong with a combination before any is drawn.
fn check(subject: Subject, variant: &Variant) -> Result<(), Failure> {
    let render = &variant.options.render;
    check_kind(subject == Subject::Drawing, render, &variant.written)?;
    match subject {
        Subject::Model => {
            view::check(&render.view)?;
            settings::render_settings(render, Outputs::COLOR).map(drop)
        }
        Subject::Drawing => settings::sample_pattern(render.picture.pattern, render.picture.samples).map(drop),
    }
}

fn draw_all(
    arguments: &[OsString],
    subject: Subject,
    variants: Vec<Variant>,
    reference: &mut Reference,
    options: &CompareOptions,
) -> Result<Vec<Compared>, Failure> {
    let mut drawer = Drawer::new(subject);
    let mut cells = Vec::with_capacity(variants.len());
    for mut variant in variants {
        // What is odd about the file is told once.
        variant.options.render.output.quiet |= !cells.is_empty();
        let cell = drawer.draw(&variant, false, !options.no_times)?;
        let image = cell.images.bytes.ok_or_else(|| Failure::work("the picture was not drawn"))?;
        check_picture(options, (image.width(), image.height()))?;
        let ideal = reference.of(arguments, &mut drawer, &variant, (image.width(), image.height()))?;
        let rmse = rmse(&image, ideal).unwrap_or(f64::NAN);
        cells.push(Compared { variant, image, time: cell.time, rmse });
    }
    Ok(cells)
}

/// Refuses a picture of this size: too large, or without the square that is to be shown enlarged.
fn check_picture(options: &CompareOptions, (width, height): (u32, u32)) -> Result<(), Failure> {
    check_size((width, height))?;
    let Some(inset) = options.inset else { return Ok(()) };
    let ends = |start: u32, side: u32| start.checked_add(inset.size).is_some_and(|end| end <= side);
    if ends(inset.x, width) && ends(inset.y, height) {
        return Ok(());
    }
    Err(Failure::usage(format!(
        "--inset {},{},{} is not within the picture of {width}x{height} pixels; write its left column, top row and side",
        inset.x, inset.y, inset.size
    )))
}

fn entries(options: &CompareOptions, cells: &[Compared], reference: &Reference) -> Vec<Entry> {
    let mut entries: Vec<Entry> = cells
        .iter()
        .map(|cell| Entry {
            image: cell.image.clone(),
            title: cell.variant.values.iter().map(|(name, value)| format!("{name} {value}")).collect(),
            numbers: match options.no_times {
                true => format!("RMSE {:.2}", cell.rmse),
                false => format!("{} ms, RMSE {:.2}", milliseconds(cell.time), cell.rmse),
            },
        })
        .collect();
    if let Some(image) = reference.only() {
        let title = vec!["reference".to_owned()];
        entries.push(Entry { image: image.clone(), title, numbers: "64 shaded samples a pixel".to_owned() });
    }
    entries
}

/// Three digits are more than a time deserves.
fn milliseconds(time: Duration) -> String {
    let ms = time.as_secs_f64() * 1e3;
    let decimals = if ms < 1.0 {
        3
    } else if ms < 10.0 {
        2
    } else {
        1
    };
    format!("{ms:.decimals$}")
}

/// Values of the last axis side by side; of a single axis as many as make a sheet that is wider than high.
fn layout(options: &CompareOptions, cells: &[Compared]) -> Layout {
    let values = |axis: &crate::values::Axis| u32::try_from(axis.values.len()).unwrap_or(u32::MAX);
    let columns = match options.axes.as_slice() {
        [only] if values(only) <= 4 => values(only) + 1,
        [only] => (values(only) + 1).min(4),
        several => several.last().map_or(1, values),
    };
    let models = options.render.render.models.iter().map(|path| path.display().to_string());
    let mut notes = vec![models.collect::<Vec<_>>().join(", ")];
    let common = cells.first().map_or(&[][..], |cell| &cell.variant.common);
    notes[0] += &common.iter().map(|(name, value)| format!(", {name} {value}")).collect::<String>();
    notes.push(
        "RMSE: root of the mean square difference to the reference over all channels, in codes of 0 to 255.".to_owned(),
    );
    if !options.no_times {
        notes[1] += " Times: the shortest of several frames.";
    }
    Layout { columns, inset: options.inset, notes }
}

fn report(options: &CompareOptions, cells: &[Compared]) -> Json {
    let texts = |texts: &[String]| Json::Row(texts.iter().map(|text| text.clone().into()).collect());
    let render = &options.render.render;
    let axes = options
        .axes
        .iter()
        .map(|axis| Json::Object(vec![("name", axis.name.clone().into()), ("values", texts(&axis.values))]));
    let named = |values: &[(String, String)]| {
        let pair = |(name, value): &(String, String)| {
            Json::Object(vec![("name", name.clone().into()), ("value", value.clone().into())])
        };
        Json::List(values.iter().map(pair).collect())
    };
    let cell = |cell: &Compared| {
        let mut hash = PictureHash::new();
        hash.add(&cell.image);
        let mut members = vec![
            ("values", named(&cell.variant.values)),
            ("width", cell.image.width().into()),
            ("height", cell.image.height().into()),
            ("rmse", Json::Decimal(cell.rmse)),
            ("hash", hash.to_hex().into()),
        ];
        if !options.no_times {
            members.push(("time_ms", Json::Decimal(cell.time.as_secs_f64() * 1e3)));
        }
        Json::Object(members)
    };
    let common = cells.first().map_or(&[][..], |cell| &cell.variant.common);
    Json::Object(vec![
        ("version", env!("CARGO_PKG_VERSION").into()),
        ("models", Json::List(render.models.iter().map(|path| path.display().to_string().into()).collect())),
        ("output", Destination::new(&render.output.output).name().into()),
        ("axes", Json::List(axes.collect())),
        ("common", named(common)),
        ("reference", "twice the size, 16 samples a pixel on a grid, each shaded; the mean of 2x2 pixels".into()),
        ("cells", Json::List(cells.iter().map(cell).collect())),
    ])
}
