//! `trigon render`: models, or an SVG file, in; one picture out.

use super::drawing;
use super::studio::Studio;
use crate::failure::Failure;
use crate::load;
use crate::options::{Given, RenderCommandOptions};
use crate::output::{Destination, Encoding};
use crate::view;
use std::time::Instant;

pub(crate) fn render(options: &RenderCommandOptions, given: Given) -> Result<(), Failure> {
    let max_bytes = load::max_file_bytes(&options.render.input);
    if drawing::is_drawing(&options.render.models, max_bytes) {
        return drawing::draw(options, given, max_bytes);
    }
    let options = &options.render;
    let output = Destination::new(&options.output.output);
    let encoding = Encoding::choose(&options.output, &output)?;
    let mut studio = Studio::open(options, &output, &encoding)?;
    let camera = view::camera(&options.view, &studio.scene, studio.up, studio.aspect())?;
    let images = studio.draw(&camera)?;
    let started = Instant::now();
    output.write(&encoding.encode(&images)?)?;
    studio.close(started.elapsed())
}
