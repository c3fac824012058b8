//! `trigon render`: models, or an SVG file, in; one picture out.

use super::drawing;
use super::studio::Studio;
use crate::failure::Failure;
use crate::load;
use crate::options::{Given, Preset, RenderCommandOptions, RenderOptions, Written};
use crate::output::{Destination, Encoding};
use std::time::Instant;

pub(crate) fn render(options: &RenderCommandOptions, given: Given, written: &Written) -> Result<(), Failure> {
    let max_bytes = load::max_file_bytes(&options.render.input);
    let is_drawing = drawing::is_drawing(&options.render.models, max_bytes);
    check_kind(is_drawing, &options.render, written)?;
    if is_drawing {
        return drawing::draw(options, given, max_bytes);
    }
    let options = &options.render;
    let output = Destination::new(&options.output.output);
    let encoding = Encoding::choose(&options.output, &output)?;
    let mut studio = Studio::open(options, &output, &encoding)?;
    let camera = studio.look(options, None)?;
    let images = studio.draw(&camera)?;
    let started = Instant::now();
    output.write(&encoding.encode(&images)?)?;
    studio.close(started.elapsed())
}

/// Refuses what was written though it says nothing about this kind of input, a preset of the other kind before all.
pub(super) fn check_kind(is_drawing: bool, options: &RenderOptions, written: &Written) -> Result<(), Failure> {
    let preset = options.preset.preset.filter(|preset| preset.is_for_drawings() != is_drawing).map(Preset::written);
    if is_drawing {
        let Some(option) = preset.or(written.for_models.as_deref()) else { return Ok(()) };
        return Err(misplaced(option, "models", &format!("{} is an SVG picture", options.models[0].display())));
    }
    let Some(option) = preset.or(written.for_drawings.as_deref()) else { return Ok(()) };
    let is_size = option == "--width" || option == "--height";
    Err(misplaced(option, "SVG pictures", if is_size { "models have --size" } else { "this is a model" }))
}

/// An option that says nothing about this kind of input.
fn misplaced(option: &str, kind: &str, input: &str) -> Failure {
    Failure::usage(format!("{option} concerns {kind}, and {input}; leave it out"))
}
