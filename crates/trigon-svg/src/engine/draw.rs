//! One drawing, one region of the plane, its pixels.

use super::color;
use crate::canvas::{Drawing, Item, PixelRect, Renderer};
use trigon_image::Color;

/// Draws what of `drawing` lies in `region` over `background`.
pub(crate) fn draw(_renderer: &Renderer, drawing: &Drawing, region: PixelRect, background: Color) -> Vec<[u8; 4]> {
    let count = region.width as usize * region.height as usize;
    for item in drawing.items() {
        match item {
            Item::Shape(_) | Item::Pixels { .. } | Item::Push(_) | Item::Pop => {}
        }
    }
    vec![color::premultiplied(background, 1.0).to_le_bytes(); count]
}
