//! A whole filter: primitives that read the source or earlier results, run in order on one picture.
//!
//! All pictures of a run have the size of the filter region, and positions are pixels of it. Each result is transparent
//! outside its primitive's own region. A result is dropped after its last reader, so memory is bounded by the number of
//! results that are really alive. Filter Effects 1, "filter primitive subregion" and "color-interpolation-filters".

use std::rc::Rc;
use std::sync::Arc;

use super::blend::blend;
use super::blur::gaussian_blur;
use super::color::{ColorMatrix, Transfer, color_matrix, component_transfer};
use super::composite::{Operator, composite, draw_over, flood_in, offset, tile};
use super::convolve::{Convolution, convolve};
use super::displace::displace;
use super::lighting::{Lamp, Surface, lighting};
use super::morphology::{Morphology, morphology};
use super::raster::{ColorSpace, Pixel, Raster, Region, convert_color, multiply};
use super::turbulence::{Grid, Turbulence, turbulence};
use crate::canvas::BlendMode;
use trigon::schedule::Deadline;

/// A filter, ready to run.
#[derive(Clone)]
pub struct Graph {
    /// The primitives in order; the last one's result is the filter's. Without any, the result is transparent.
    pub steps: Vec<Step>,
}

/// One primitive of a filter.
#[derive(Clone)]
pub struct Step {
    /// What is done.
    pub primitive: Primitive,
    /// The color space that it works in.
    pub space: ColorSpace,
    /// Where its result lies.
    pub region: Region,
    /// Whether the result is cut to `region`; if not, the region still is what [`Primitive::Tile`] repeats.
    pub is_clipped: bool,
}

/// What a primitive reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Input {
    /// The picture the filter is applied to.
    Source,
    /// Its alpha, with black.
    SourceAlpha,
    /// The result of an earlier step.
    Step(usize),
}

/// Draws a picture of `width * height` pixels, in sRGB; after the deadline nobody sees it.
pub type DrawPicture = Arc<dyn Fn(usize, usize, Deadline) -> Raster + Send + Sync>;

/// A filter primitive with its inputs; lengths in pixels, colors sRGB with straight alpha.
#[derive(Clone)]
#[expect(missing_docs, reason = "the functions that do the work document the fields")]
pub enum Primitive {
    Blend { source: Input, backdrop: Input, mode: BlendMode },
    ColorMatrix { input: Input, matrix: ColorMatrix },
    ComponentTransfer { input: Input, curves: [Transfer; 4] },
    Composite { source: Input, backdrop: Input, operator: Operator },
    Convolve { input: Input, convolution: Convolution },
    Displace { source: Input, map: Input, scale: (f32, f32), channels: (usize, usize) },
    DropShadow { input: Input, offset: (i32, i32), deviation: (f32, f32), color: Pixel },
    Flood { color: Pixel },
    Blur { input: Input, deviation: (f32, f32) },
    Picture { draw: DrawPicture },
    Lighting { input: Input, surface: Surface, surface_scale: f32, color: [u8; 3], lamp: Lamp },
    Merge { inputs: Vec<Input> },
    Morphology { input: Input, operator: Morphology, radius: (usize, usize) },
    Offset { input: Input, offset: (i32, i32) },
    Tile { input: Input },
    Turbulence { grid: Grid, noise: Turbulence },
    Transparent,
}

/// The picture of a step.
#[derive(Clone)]
struct Outcome {
    raster: Rc<Raster>,
    space: ColorSpace,
    region: Region,
}

impl Graph {
    /// Runs the filter on `source`, in sRGB; the result is sRGB and of the same size. `None` if the deadline came first.
    ///
    /// An input that names a later step, or none, reads as the source.
    #[must_use]
    pub fn run(&self, source: Raster, deadline: Deadline) -> Option<Raster> {
        let (width, height) = (source.width(), source.height());
        let region = source.bounds();
        let mut run =
            Run { source: Rc::new(source), outcomes: vec![None; self.steps.len()], width, height, region, deadline };
        let last_reader = self.last_readers();
        for (index, step) in self.steps.iter().enumerate() {
            run.outcomes[index] = Some(run.step(step));
            if deadline.is_over() {
                return None;
            }
            for (outcome, last) in run.outcomes.iter_mut().zip(&last_reader) {
                if *last <= index {
                    *outcome = None;
                }
            }
        }
        Some(match run.outcomes.pop().flatten() {
            Some(outcome) => in_space(outcome, ColorSpace::Srgb),
            None => Raster::new(width, height),
        })
    }

    /// For each step, the last step that reads it; the last step's result is read after all.
    fn last_readers(&self) -> Vec<usize> {
        let mut last_reader: Vec<usize> = (0..self.steps.len()).collect();
        for (index, step) in self.steps.iter().enumerate() {
            for input in step.primitive.inputs() {
                if let Input::Step(read) = input
                    && let Some(last) = last_reader.get_mut(read)
                {
                    *last = (*last).max(index);
                }
            }
        }
        if let Some(last) = last_reader.last_mut() {
            *last = usize::MAX;
        }
        last_reader
    }
}

impl Primitive {
    /// What it reads.
    #[must_use]
    pub fn inputs(&self) -> Vec<Input> {
        match self {
            Self::Blend { source, backdrop, .. } | Self::Composite { source, backdrop, .. } => {
                vec![*source, *backdrop]
            }
            Self::Displace { source, map, .. } => vec![*source, *map],
            Self::Merge { inputs } => inputs.clone(),
            Self::ColorMatrix { input, .. }
            | Self::ComponentTransfer { input, .. }
            | Self::Convolve { input, .. }
            | Self::DropShadow { input, .. }
            | Self::Blur { input, .. }
            | Self::Lighting { input, .. }
            | Self::Morphology { input, .. }
            | Self::Offset { input, .. }
            | Self::Tile { input } => vec![*input],
            Self::Flood { .. } | Self::Picture { .. } | Self::Turbulence { .. } | Self::Transparent => Vec::new(),
        }
    }
}

/// A run in progress.
struct Run {
    source: Rc<Raster>,
    outcomes: Vec<Option<Outcome>>,
    width: usize,
    height: usize,
    region: Region,
    deadline: Deadline,
}

impl Run {
    fn step(&self, step: &Step) -> Outcome {
        let (mut raster, space) = self.result(&step.primitive, step.space);
        if !step.is_clipped || step.region == self.region {
            return Outcome { raster, space, region: step.region };
        }
        Rc::make_mut(&mut raster).clear_outside(step.region);
        Outcome { raster, space, region: step.region }
    }

    /// The primitive's picture, not yet cut, and its color space.
    fn result(&self, primitive: &Primitive, space: ColorSpace) -> (Rc<Raster>, ColorSpace) {
        let raster = match primitive {
            Primitive::Flood { color } => return self.plain(*color),
            Primitive::Picture { draw } => {
                return (Rc::new(draw(self.width, self.height, self.deadline)), ColorSpace::Srgb);
            }
            Primitive::Offset { input, offset: (dx, dy) } => {
                let input = self.input(*input);
                return (Rc::new(offset(&input.raster, *dx, *dy)), input.space);
            }
            Primitive::Tile { input } => {
                let input = self.input(*input);
                return (Rc::new(tile(&input.raster, input.region)), input.space);
            }
            Primitive::Blend { source, backdrop, mode } => {
                blend(&self.read(*source, space), self.read(*backdrop, space), *mode)
            }
            Primitive::Composite { source, backdrop, operator } => {
                composite(&self.read(*source, space), self.read(*backdrop, space), *operator)
            }
            Primitive::Displace { source, map, scale, channels } => {
                displace(&self.read(*source, space), &self.read(*map, space), *scale, *channels)
            }
            Primitive::Merge { inputs } => {
                let mut merged = Raster::new(self.width, self.height);
                for input in inputs {
                    draw_over(&mut merged, &self.read(*input, space));
                }
                merged
            }
            Primitive::Turbulence { grid, noise } => turbulence(self.width, self.height, *grid, noise, self.deadline),
            Primitive::Transparent => Raster::new(self.width, self.height),
            _ => self.of_one_input(primitive, space),
        };
        (Rc::new(raster), space)
    }

    /// Primitives with one input, read in the working space.
    fn of_one_input(&self, primitive: &Primitive, space: ColorSpace) -> Raster {
        let Some(input) = primitive.inputs().first().copied() else { return Raster::new(self.width, self.height) };
        let mut raster = self.read(input, space);
        match primitive {
            Primitive::ColorMatrix { matrix, .. } => color_matrix(&mut raster, matrix),
            Primitive::ComponentTransfer { curves, .. } => component_transfer(&mut raster, curves),
            Primitive::Convolve { convolution, .. } => return convolve(raster, convolution, self.deadline),
            Primitive::Blur { deviation: (x, y), .. } => return gaussian_blur(raster, *x, *y),
            Primitive::Morphology { operator, radius: (x, y), .. } => return morphology(raster, *operator, *x, *y),
            Primitive::Lighting { surface, surface_scale, color, lamp, .. } => {
                return lighting(&raster, *surface, *surface_scale, *color, lamp, self.deadline);
            }
            Primitive::DropShadow { offset: (dx, dy), deviation: (x, y), color: [r, g, b, a], .. } => {
                let [r, g, b] = convert_color([*r, *g, *b], ColorSpace::Srgb, space);
                let shadow = flood_in(gaussian_blur(raster.clone(), *x, *y), [r, g, b, *a]);
                let mut result = offset(&shadow, *dx, *dy);
                draw_over(&mut result, &raster);
                return result;
            }
            _ => {}
        }
        raster
    }

    fn plain(&self, color: Pixel) -> (Rc<Raster>, ColorSpace) {
        (Rc::new(Raster::filled(self.width, self.height, multiply(color))), ColorSpace::Srgb)
    }

    fn read(&self, input: Input, space: ColorSpace) -> Raster {
        in_space(self.input(input), space)
    }

    fn input(&self, input: Input) -> Outcome {
        let source = || Outcome { raster: Rc::clone(&self.source), space: ColorSpace::Srgb, region: self.region };
        match input {
            Input::Source => source(),
            Input::SourceAlpha => {
                let mut outcome = source();
                for pixel in Rc::make_mut(&mut outcome.raster).pixels_mut() {
                    *pixel = [0, 0, 0, pixel[3]];
                }
                outcome
            }
            Input::Step(index) => self.outcomes.get(index).cloned().flatten().unwrap_or_else(source),
        }
    }
}

fn in_space(outcome: Outcome, space: ColorSpace) -> Raster {
    let mut raster = Rc::unwrap_or_clone(outcome.raster);
    raster.convert(outcome.space, space);
    raster
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: Region = Region { left: 0, top: 0, right: 8, bottom: 8 };

    fn step(primitive: Primitive) -> Step {
        Step { primitive, space: ColorSpace::Srgb, region: ALL, is_clipped: true }
    }

    #[test]
    fn results_are_cut_to_their_region() {
        let region = Region { left: 2, top: 3, right: 4, bottom: 5 };
        let flood = Step { region, ..step(Primitive::Flood { color: [0, 128, 0, 255] }) };
        let result = Graph { steps: vec![flood] }.run(Raster::new(8, 8), Deadline::NEVER).unwrap();
        assert_eq!(result.pixels().iter().filter(|pixel| pixel[3] == 255).count(), 4);
    }

    #[test]
    fn a_result_can_be_read_twice_and_out_of_order() {
        let steps = vec![
            step(Primitive::Flood { color: [255, 0, 0, 255] }),
            step(Primitive::Offset { input: Input::Source, offset: (1, 0) }),
            step(Primitive::Composite { source: Input::Step(0), backdrop: Input::Step(1), operator: Operator::In }),
            step(Primitive::Merge { inputs: vec![Input::Step(0), Input::Step(2), Input::Source] }),
        ];
        let mut source = Raster::new(8, 8);
        source.pixels_mut()[0] = [0, 0, 255, 255];
        let result = Graph { steps }.run(source, Deadline::NEVER).unwrap();
        assert_eq!(result.pixel(0, 0), [0, 0, 255, 255]);
        assert_eq!(result.pixel(5, 5), [255, 0, 0, 255]);
    }

    #[test]
    fn no_primitive_and_unknown_inputs() {
        let run = |steps| Graph { steps }.run(Raster::filled(8, 8, [255; 4]), Deadline::NEVER);
        assert_eq!(run(Vec::new()), Some(Raster::new(8, 8)));
        let stray = step(Primitive::Offset { input: Input::Step(7), offset: (0, 0) });
        assert_eq!(run(vec![stray]), Some(Raster::filled(8, 8, [255; 4])));
    }

    #[test]
    fn linear_light_is_used_where_asked() {
        let blur = |space| {
            let mut source = Raster::filled(8, 8, [0, 0, 0, 255]);
            for row in source.pixels_mut().chunks_exact_mut(8) {
                row[4..].fill([255; 4]);
            }
            let primitive = Primitive::Blur { input: Input::Source, deviation: (2.0, 0.0) };
            let graph = Graph { steps: vec![Step { space, ..step(primitive) }] };
            graph.run(source, Deadline::NEVER).unwrap().pixel(4, 4)[0]
        };
        assert!(blur(ColorSpace::LinearRgb) > blur(ColorSpace::Srgb) + 20);
    }
}
