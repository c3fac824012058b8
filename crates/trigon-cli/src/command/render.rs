//! `trigon render`: models in, one picture out.

use super::studio::Studio;
use crate::failure::Failure;
use crate::options::RenderOptions;
use crate::output::{Destination, Encoding};
use crate::view;
use std::time::Instant;

pub(crate) fn render(options: &RenderOptions) -> Result<(), Failure> {
    let output = Destination::new(&options.output.output);
    let encoding = Encoding::choose(&options.output, &output)?;
    let mut studio = Studio::open(options, &output, &encoding)?;
    let camera = view::camera(&options.view, &studio.scene, studio.up, studio.aspect())?;
    let images = studio.draw(&camera)?;
    let started = Instant::now();
    output.write(&encoding.encode(&images)?)?;
    studio.close(started.elapsed())
}
