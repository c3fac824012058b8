//! One drawing, one rectangle of the plane, its pixels.

use super::band::Worker;
use super::color;
use super::compile::compile;
use super::coverage::BAND_ROWS;
use super::samples::SampleRows;
use crate::canvas::{Drawing, Item, Renderer, Transform};
use trigon_image::Color;

/// What is there before the first step.
#[derive(Clone, Copy)]
pub(crate) enum Below {
    /// One premultiplied colour.
    Color(u32),
    /// The pixels that the memory of the result holds.
    Pixels,
}

impl Below {
    /// The pixels of a picture on which nothing is drawn.
    pub(crate) fn fill(self, out: &mut [[u8; 4]]) {
        if let Self::Color(color) = self {
            out.fill(color.to_le_bytes());
        }
    }
}

/// Draws what of `drawing` lies in a picture of `size` pixels, over `background`, into all of `out`.
pub(crate) fn draw(renderer: &Renderer, drawing: &Drawing, size: [u32; 2], background: Color, out: &mut [[u8; 4]]) {
    let below = Below::Color(color::premultiplied(background, 1.0));
    draw_items(renderer, drawing.items(), Transform::IDENTITY, size, below, 0, out);
}

/// Draws what of `drawing` lies in a picture of `size` pixels over the pixels that `out` holds.
pub(crate) fn draw_over(renderer: &Renderer, drawing: &Drawing, size: [u32; 2], out: &mut [[u8; 4]]) {
    draw_items(renderer, drawing.items(), Transform::IDENTITY, size, Below::Pixels, 0, out);
}

/// A picture of items moved by `base`, inside `depth` layers, on transparent black.
pub(crate) fn picture_of(
    renderer: &Renderer,
    items: &[Item],
    base: Transform,
    size: [u32; 2],
    depth: u32,
) -> Vec<[u8; 4]> {
    let mut pixels = vec![[0; 4]; size[0] as usize * size[1] as usize];
    draw_items(renderer, items, base, size, Below::Color(0), depth, &mut pixels);
    pixels
}

fn draw_items(
    renderer: &Renderer,
    items: &[Item],
    base: Transform,
    size: [u32; 2],
    below: Below,
    depth: u32,
    out: &mut [[u8; 4]],
) {
    let [width, height] = size;
    if out.is_empty() || depth > renderer.max_depth || renderer.deadline.is_over() {
        below.fill(out);
        return;
    }
    let samples = SampleRows::new(renderer.pattern);
    let (program, tables) = compile(renderer, &samples, items, base, size, depth);
    let band_pixels = (BAND_ROWS * width) as usize;
    let threads = (height.div_ceil(BAND_ROWS) as usize).min(renderer.threads.max(1));
    let mut workers: Vec<Worker<'_>> =
        (0..threads).map(|_| Worker::new(&samples, &tables, width, renderer.deadline)).collect();
    let tasks = (0..).zip(out.chunks_mut(band_pixels));
    trigon::schedule::share(&mut workers, tasks, |worker, (band, out): (u32, &mut [[u8; 4]])| {
        worker.draw_band(renderer, &program, band, below, out);
    });
}
