//! What must hold for any bytes given as an SVG file: it is drawn or refused, and drawn alike by one thread and by two.
//!
//! Used by the fuzz target here and by the test in `crates/trigon-svg/tests/fuzz_corpus.rs` that replays the corpus on
//! the stable toolchain.

use trigon_image::Color;
use trigon_svg::canvas::Renderer;
use trigon_svg::svg::{Document, FontOptions, Options, Size, View};

/// An SVG file of up to 64 KiB, drawn 48 pixels wide.
pub(crate) fn svg(bytes: &[u8]) {
    let mut options =
        Options { fonts: FontOptions { use_system_fonts: false, ..FontOptions::default() }, ..Options::default() };
    options.limits.max_bytes = 1 << 16;
    options.limits.max_elements = 1 << 12;
    options.limits.max_filter_pixels = 1 << 16;
    options.limits.max_tile_pixels = 1 << 14;
    options.limits.max_convolution_steps = 1 << 20;
    options.limits.max_image_pixels = 1 << 16;
    let Ok(document) = Document::parse(bytes, &options) else { return };
    // Inside a square, so that no aspect ratio makes the picture large.
    let view = View { size: Size::Inside(48, 48), ..View::default() };
    let draw = |threads| {
        let renderer = Renderer { threads, ..Renderer::new() };
        document.draw(&view, &renderer, Color::TRANSPARENT).map(|(picture, warnings)| (picture.into_pixels(), warnings))
    };
    let one = draw(1);
    assert!(one == draw(2), "one and two threads disagree");
    if let Ok((pixels, _)) = one {
        assert!(pixels.iter().all(|[r, g, b, a]| r <= a && g <= a && b <= a), "a color exceeds its alpha");
    }
}
