//! `trigon explain`: a model and a pixel in; the story of the pixel, as text, JSON or a diagram, out.

use super::drawing;
use super::render::check_kind;
use super::studio::Studio;
use crate::failure::Failure;
use crate::load;
use crate::options::{ExplainOptions, Written};
use crate::output::{Destination, Encoding, Images};
use crate::story::{to_json, to_picture, to_text};
use trigon_scene::render::SceneStory;

pub(crate) fn explain(options: &ExplainOptions, written: &Written) -> Result<(), Failure> {
    let render = &options.render;
    if drawing::is_drawing(&render.models, load::max_file_bytes(&render.input)) {
        let path = render.models[0].display();
        return Err(Failure::usage(format!("{path} is an SVG file; only pixels of models can be explained")));
    }
    check_kind(false, render, written)?;
    check_pixel(options)?;
    let output = Destination::new(&render.output.output);
    let encoding = Encoding::choose(&render.output, &output)?;
    if encoding.is_float() {
        return Err(Failure::usage("diagrams have 8 bits per channel; leave out --bit-depth, and write PNG"));
    }
    let mut studio = Studio::open(render, &output, &encoding)?;
    let camera = studio.look(render, None)?;
    let story = studio.explain(&camera, options.pixel.0)?;
    if output != Destination::Stdout {
        let images = Images { bytes: studio.draw(&camera)?.bytes, floats: None };
        let picture = images.bytes.ok_or_else(|| Failure::work("the picture was not drawn"))?;
        let diagram = Images { bytes: Some(to_picture(&story, &picture)?), floats: None };
        output.write(&encoding.encode(&diagram)?)?;
    }
    write(options, &story, studio.size())
}

/// Before a model is read.
fn check_pixel(options: &ExplainOptions) -> Result<(), Failure> {
    let ([x, y], size) = (options.pixel.0, options.render.picture.size);
    if x < size.width && y < size.height {
        return Ok(());
    }
    Err(Failure::usage(format!(
        "--pixel {x},{y}: the picture has {size} pixels; columns are 0 to {}, rows 0 to {}",
        size.width - 1,
        size.height - 1
    )))
}

/// JSON where it is asked for; text unless there is a picture.
fn write(options: &ExplainOptions, story: &SceneStory, size: (u32, u32)) -> Result<(), Failure> {
    match &options.render.output.json {
        None if Destination::new(&options.render.output.output) != Destination::Stdout => Ok(()),
        None => Destination::Stdout.write(to_text(story, size).as_bytes()),
        Some(path) => {
            let target = path.as_deref().map_or(Destination::Stdout, Destination::new);
            target.write(format!("{}\n", to_json(story, size)).as_bytes())
        }
    }
}
