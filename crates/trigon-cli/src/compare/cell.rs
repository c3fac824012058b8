//! One picture of a sheet: options in; pixels and the time of a frame out.

use super::variant::Variant;
use crate::command::drawing::{self, Reader};
use crate::command::studio::Studio;
use crate::failure::Failure;
use crate::load;
use crate::output::{Destination, Encoding, Images};
use std::time::Duration;

/// What is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Subject {
    Model,
    /// An SVG file.
    Drawing,
}

/// A picture and what it cost.
pub(crate) struct Cell {
    pub(crate) images: Images,
    /// The shortest time of several frames, or of the only one where no times are wanted: geometry, tiles and resolve,
    /// or for SVG the drawing of the file that was read.
    pub(crate) time: Duration,
}

/// SVG files are drawn so often.
const DRAWINGS: u32 = 3;

/// What draws all pictures of a sheet; an SVG file is read once for all of them.
pub(crate) struct Drawer {
    pub(crate) subject: Subject,
    reader: Reader,
}

impl Drawer {
    pub(crate) fn new(subject: Subject) -> Self {
        Self { subject, reader: Reader::default() }
    }

    /// Draws one combination; `is_float` makes linear floats instead of bytes, where the subject has them. Where the
    /// time counts it is drawn several times.
    pub(crate) fn draw(&mut self, variant: &Variant, is_float: bool, is_timed: bool) -> Result<Cell, Failure> {
        let options = &variant.options.render;
        if self.subject == Subject::Drawing {
            return self.draw_svg(variant, load::max_file_bytes(&options.input), if is_timed { DRAWINGS } else { 1 });
        }
        let output = Destination::new(&options.output.output);
        let mut studio = Studio::open(options, &output, &Encoding::in_memory(is_float))?;
        let camera = studio.look(options, None)?;
        let (images, time) = studio.draw_timed(&camera, is_timed)?;
        Ok(Cell { images, time })
    }

    fn draw_svg(&mut self, variant: &Variant, max_bytes: u64, drawings: u32) -> Result<Cell, Failure> {
        let mut best: Option<Cell> = None;
        for _ in 0..drawings {
            let drawn = drawing::make(&mut self.reader, &variant.options, variant.given, max_bytes)?;
            if best.is_none() {
                drawing::tell(&variant.options.render, &drawn.warnings)?;
            }
            let time = best.as_ref().map_or(drawn.draw, |best| best.time.min(drawn.draw));
            best = Some(Cell { images: Images { bytes: Some(drawn.image), floats: None }, time });
        }
        best.ok_or_else(|| Failure::work("the picture was not drawn"))
    }
}
