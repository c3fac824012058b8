//! `trigon render`: models, or an SVG file, in; one picture out.

use super::drawing;
use super::studio::Studio;
use crate::failure::Failure;
use crate::load;
use crate::options::{Given, RenderCommandOptions, Written};
use crate::output::{Destination, Encoding};
use std::time::Instant;

pub(crate) fn render(options: &RenderCommandOptions, given: Given, written: &Written) -> Result<(), Failure> {
    let max_bytes = load::max_file_bytes(&options.render.input);
    let preset = options.render.preset.preset;
    if drawing::is_drawing(&options.render.models, max_bytes) {
        if let Some(preset) = preset.filter(|preset| !preset.is_for_drawings()) {
            let input = format!("{} is an SVG picture", options.render.models[0].display());
            return Err(misplaced(preset.written(), "models", &input));
        }
        if let Some(option) = &written.for_models {
            return Err(misplaced(
                option,
                "models",
                &format!("{} is an SVG picture", options.render.models[0].display()),
            ));
        }
        return drawing::draw(options, given, max_bytes);
    }
    if let Some(preset) = preset.filter(|preset| preset.is_for_drawings()) {
        return Err(misplaced(preset.written(), "SVG pictures", "this is a model"));
    }
    if let Some(option) = &written.for_drawings {
        let is_size = option == "--width" || option == "--height";
        return Err(misplaced(option, "SVG pictures", if is_size { "models have --size" } else { "this is a model" }));
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

/// An option that says nothing about this kind of input.
pub(super) fn misplaced(option: &str, kind: &str, input: &str) -> Failure {
    Failure::usage(format!("{option} concerns {kind}, and {input}; leave it out"))
}
