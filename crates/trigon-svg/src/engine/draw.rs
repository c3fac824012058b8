//! One drawing, one rectangle of the plane, its pixels.

use super::band::Worker;
use super::color;
use super::compile::compile;
use super::coverage::BAND_ROWS;
use super::samples::SampleRows;
use crate::canvas::{Drawing, Item, Renderer, Transform};
use trigon_image::Color;

/// Draws what of `drawing` lies in a picture of `size` pixels, over `background`.
pub(crate) fn draw(renderer: &Renderer, drawing: &Drawing, size: [u32; 2], background: Color) -> Vec<[u8; 4]> {
    let background = color::premultiplied(background, 1.0);
    draw_items(renderer, drawing.items(), Transform::IDENTITY, size, background, 0)
}

/// Draws items moved by `base`, inside `depth` layers.
pub(crate) fn draw_items(
    renderer: &Renderer,
    items: &[Item],
    base: Transform,
    size: [u32; 2],
    background: u32,
    depth: u32,
) -> Vec<[u8; 4]> {
    let [width, height] = size;
    let mut pixels = vec![background.to_le_bytes(); width as usize * height as usize];
    if pixels.is_empty() || depth > renderer.max_depth {
        return pixels;
    }
    let samples = SampleRows::new(renderer.pattern);
    let (program, tables) = compile(renderer, &samples, items, base, size, depth);
    let band_pixels = (BAND_ROWS * width) as usize;
    let bands = (height.div_ceil(BAND_ROWS) as usize).min(renderer.threads.max(1));
    let mut workers: Vec<Worker<'_>> = (0..bands).map(|_| Worker::new(&samples, &tables, width)).collect();
    let tasks = (0..).zip(pixels.chunks_mut(band_pixels));
    trigon::schedule::share(&mut workers, tasks, |worker, (band, out): (u32, &mut [[u8; 4]])| {
        worker.draw_band(renderer.simd, &program, band, background, out);
    });
    pixels
}
