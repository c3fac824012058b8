//! A drawing made ready: shapes as edges, paints as shaders, layers as steps with the pixels that they touch.
//!
//! In: a display list. Out: a [`Program`] of [`Step`]s, each with its [`Bounds`] and listed for the bands that it meets,
//! and the tables that steps refer to by number. Filters and pattern tiles are pictures of their own and are drawn here,
//! before any band.

use super::coverage::Bounds;
use super::geometry::{Geometry, bands};
use super::shader::Shader;
use crate::canvas::{BlendMode, FillRule, LayerImage, MaskKind};
use std::sync::Arc;

/// One thing to do in each band that it meets.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Step {
    /// Paint a shape.
    Fill {
        shape: usize,
        rule: FillRule,
        shader: usize,
        blend: BlendMode,
    },
    /// Paint pixels, the first at this place.
    Pixels {
        image: usize,
        at: [i64; 2],
        opacity: u32,
        blend: BlendMode,
    },
    /// Let only what is inside a clip path be painted, until the matching end.
    PushClip {
        clip: usize,
    },
    PopClip,
    /// Begin a layer of transparent black.
    PushLayer,
    /// Blend the layer with what is below. Opacity is 0..=255.
    PopLayer {
        opacity: u32,
        blend: BlendMode,
        mask: Option<usize>,
    },
}

/// Steps in order.
#[derive(Default)]
pub(crate) struct Program {
    pub(crate) steps: Vec<Step>,
    /// The pixels that each step may touch.
    pub(crate) bounds: Vec<Bounds>,
    /// For each band from `first_band` on, where its steps end in `band_steps`.
    ends: Vec<u32>,
    band_steps: Vec<u32>,
    first_band: u32,
    /// The pixels that any step may touch.
    pub(crate) extent: Bounds,
}

/// A clip path: the union of shapes, each perhaps with a clip path of its own, and a further clip path on all.
pub(crate) struct Clip {
    pub(crate) shapes: Vec<(usize, FillRule, Option<usize>)>,
    pub(crate) intersect: Option<usize>,
    pub(crate) bounds: Bounds,
}

/// A mask: what is drawn, and what of it counts.
pub(crate) struct MaskProgram {
    pub(crate) program: Program,
    pub(crate) kind: MaskKind,
    pub(crate) mask: Option<usize>,
}

/// All that steps refer to.
pub(crate) struct Tables {
    pub(crate) geometry: Geometry,
    pub(crate) shaders: Vec<Shader>,
    pub(crate) images: Vec<Arc<LayerImage>>,
    pub(crate) clips: Vec<Clip>,
    pub(crate) masks: Vec<MaskProgram>,
}

impl Program {
    /// The steps alone; [`Tables::lay_out`] does the rest.
    pub(crate) fn new(steps: Vec<Step>) -> Self {
        Self { steps, ..Self::default() }
    }

    /// The numbers of the steps that meet a band, in order.
    pub(crate) fn steps_in(&self, band: u32) -> &[u32] {
        let Some(index) = band.checked_sub(self.first_band).map(|index| index as usize) else { return &[] };
        let Some(end) = self.ends.get(index) else { return &[] };
        let start = if index == 0 { 0 } else { self.ends[index - 1] };
        &self.band_steps[start as usize..*end as usize]
    }

    /// Lists each step for the bands that it meets.
    fn sort_into_bands(&mut self) {
        let all = bands(&self.extent);
        self.first_band = all.start;
        self.ends = vec![0; all.len()];
        for bounds in &self.bounds {
            for band in bands(bounds) {
                self.ends[(band - all.start) as usize] += 1;
            }
        }
        let mut next = 0;
        for end in &mut self.ends {
            next += core::mem::replace(end, next);
        }
        self.band_steps = vec![0; next as usize];
        for (number, bounds) in (0..).zip(&self.bounds) {
            for band in bands(bounds) {
                let end = &mut self.ends[(band - all.start) as usize];
                self.band_steps[*end as usize] = number;
                *end += 1;
            }
        }
    }
}

/// A clip or layer that is open while bounds are found.
struct Open {
    /// The step that began it.
    start: usize,
    /// Nothing outside is drawn.
    limit: Bounds,
    /// What was drawn so far.
    content: Bounds,
}

impl Tables {
    /// Finds the bounds of clips, masks (inner ones come first in their lists) and of a program's steps.
    pub(crate) fn lay_out(&mut self, main: &mut Program, picture: Bounds) {
        for index in 0..self.clips.len() {
            let mut bounds = Bounds::default();
            for (shape, _, clip) in &self.clips[index].shapes {
                let own = self.geometry.shape(*shape).bounds();
                bounds = bounds.unite(&clip.map_or(own, |clip| own.intersect(&self.clips[clip].bounds)));
            }
            if let Some(other) = self.clips[index].intersect {
                bounds = bounds.intersect(&self.clips[other].bounds);
            }
            self.clips[index].bounds = bounds;
        }
        for index in 0..self.masks.len() {
            let mut program = core::mem::take(&mut self.masks[index].program);
            self.lay_out_program(&mut program, picture);
            self.masks[index].program = program;
        }
        self.lay_out_program(main, picture);
    }

    fn lay_out_program(&self, program: &mut Program, picture: Bounds) {
        program.bounds = vec![Bounds::default(); program.steps.len()];
        let mut open = vec![Open { start: 0, limit: picture, content: Bounds::default() }];
        for number in 0..program.steps.len() {
            let Some(top) = open.last() else { break };
            let limit = top.limit;
            match program.steps[number] {
                Step::PushClip { clip } => {
                    let limit = limit.intersect(&self.clips[clip].bounds);
                    open.push(Open { start: number, limit, content: Bounds::default() });
                }
                Step::PushLayer => open.push(Open { start: number, limit, content: Bounds::default() }),
                Step::PopClip | Step::PopLayer { .. } => {
                    let Some(closed) = open.pop() else { break };
                    program.bounds[closed.start] = closed.content;
                    program.bounds[number] = closed.content;
                    if let Some(below) = open.last_mut() {
                        below.content = below.content.unite(&closed.content);
                    }
                }
                Step::Fill { shape, .. } => {
                    add(&mut open, &mut program.bounds[number], self.geometry.shape(shape).bounds().intersect(&limit));
                }
                Step::Pixels { image, at, .. } => {
                    let rect = self.images[image].rect;
                    let side = |start: i64, len: u32| {
                        [start, start + i64::from(len)].map(|end| end.clamp(0, i64::from(u32::MAX)) as u32)
                    };
                    let bounds = Bounds { columns: side(at[0], rect.width), rows: side(at[1], rect.height) };
                    add(&mut open, &mut program.bounds[number], bounds.intersect(&limit));
                }
            }
        }
        program.extent = open.first().map_or(Bounds::default(), |all| all.content);
        program.sort_into_bands();
    }
}

/// Notes the bounds of a step that draws.
fn add(open: &mut [Open], of_step: &mut Bounds, bounds: Bounds) {
    if bounds.is_empty() {
        return;
    }
    *of_step = bounds;
    if let Some(top) = open.last_mut() {
        top.content = top.content.unite(&bounds);
    }
}
