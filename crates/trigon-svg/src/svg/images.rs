//! `image` elements: embedded and linked pictures, decoded once each, and enlarged by a smooth curve.
//!
//! Reduced pictures are read from their mip chain. Enlarged ones are first resampled to up to four times their size with
//! the filter of Mitchell and Netravali ("Reconstruction Filters in Computer Graphics", 1988, B = C = 1/3), so that the
//! bilinear sampling that follows shows no facets.

use std::collections::HashMap;
use std::sync::Arc;

use trigon_image::{Rgba8Image, decode};
use usvg::{ImageKind, ImageRendering};

use super::limits::Limits;
use super::warnings::Warnings;
use crate::canvas::{Image, ImageFilter};
use crate::filter::{Pixel, Raster, divide, multiply};

/// Times a picture is resampled along x and y.
type Enlargement = [u32; 2];

/// Pictures decoded so far, by the address of their bytes, which the tree keeps alive.
#[derive(Default)]
pub(super) struct Images {
    decoded: HashMap<*const u8, Option<Arc<Rgba8Image>>>,
    made: HashMap<(*const u8, Enlargement), Option<Image>>,
    pixels: u64,
}

impl Images {
    /// The picture for a place where a pixel of it covers `scales` pixels, and how many times its size it has become;
    /// `None`, with a warning, where it is broken or over the limit.
    pub(super) fn get(
        &mut self,
        kind: &ImageKind,
        scales: [f64; 2],
        limits: &Limits,
        warnings: &mut Warnings,
    ) -> Option<(Image, Enlargement)> {
        let (name, bytes): (&str, &Arc<Vec<u8>>) = match kind {
            ImageKind::PNG(bytes) => ("PNG", bytes),
            ImageKind::JPEG(bytes) => ("JPEG", bytes),
            ImageKind::GIF(bytes) => ("GIF", bytes),
            ImageKind::WEBP(bytes) => ("WebP", bytes),
            ImageKind::SVG(_) => return None,
        };
        let key = bytes.as_ptr();
        if !self.decoded.contains_key(&key) {
            let decoded = self.decode(name, bytes, limits, warnings).map(Arc::new);
            self.decoded.insert(key, decoded);
        }
        let pixels = self.decoded.get(&key)?.clone()?;
        let enlargement = self.enlargement(&pixels, scales, limits);
        let made = self.made.entry((key, enlargement)).or_insert_with(|| {
            let image = enlarged(&pixels, enlargement).as_ref().map_or_else(|| Image::new(&pixels), Image::new);
            image.map_err(|error| warnings.add(format!("an image ({name}) is not drawn: {error}"))).ok()
        });
        made.clone().map(|image| (image, enlargement))
    }

    fn decode(&mut self, name: &str, bytes: &[u8], limits: &Limits, warnings: &mut Warnings) -> Option<Rgba8Image> {
        let left = limits.max_image_pixels.saturating_sub(self.pixels);
        match decode(bytes, None, &trigon_image::Limits::default().with_max_pixels(left)) {
            Ok(decoded) => {
                let pixels = decoded.into_rgba8();
                self.pixels += area(&pixels);
                Some(pixels)
            }
            Err(error) => {
                warnings.add(format!("an image ({name}) is not drawn: {error}"));
                None
            }
        }
    }

    /// As many times as needed to have a pixel for each of the picture drawn, at most four and within the limit.
    fn enlargement(&mut self, pixels: &Rgba8Image, scales: [f64; 2], limits: &Limits) -> Enlargement {
        let wanted = scales.map(|scale| [1.01, 2.0, 3.0].into_iter().fold(1, |n, step| n + u32::from(scale > step)));
        let more = area(pixels) * u64::from(wanted[0] * wanted[1]);
        if wanted == [1, 1] || self.pixels + more > limits.max_image_pixels {
            return [1, 1];
        }
        self.pixels += more;
        wanted
    }
}

fn area(pixels: &Rgba8Image) -> u64 {
    u64::from(pixels.width()) * u64::from(pixels.height())
}

/// How `image-rendering` samples.
pub(super) fn image_filter(rendering: ImageRendering) -> ImageFilter {
    match rendering {
        ImageRendering::OptimizeSpeed | ImageRendering::CrispEdges | ImageRendering::Pixelated => ImageFilter::NEAREST,
        ImageRendering::OptimizeQuality | ImageRendering::Smooth | ImageRendering::HighQuality => ImageFilter::SMOOTH,
    }
}

/// The picture resampled; `None` where it stays as it is.
fn enlarged(pixels: &Rgba8Image, [x, y]: Enlargement) -> Option<Rgba8Image> {
    if [x, y] == [1, 1] {
        return None;
    }
    let size = [pixels.width() as usize, pixels.height() as usize];
    let source = Raster::from_pixels(size[0], size[1], pixels.pixels().iter().copied().map(multiply).collect())?;
    let wide = with_longer_rows(&source, x as usize);
    let both = with_longer_rows(&wide.transposed(), y as usize).transposed();
    Rgba8Image::from_pixels(
        pixels.width() * x,
        pixels.height() * y,
        both.into_pixels().into_iter().map(divide).collect(),
    )
    .ok()
}

fn with_longer_rows(source: &Raster, times: usize) -> Raster {
    let weights: Vec<[f32; 4]> = (0..times).map(|phase| weights(phase, times)).collect();
    let width = source.width();
    let mut longer = Raster::new(width * times, source.height());
    let rows =
        source.pixels().chunks_exact(width.max(1)).zip(longer.pixels_mut().chunks_exact_mut((width * times).max(1)));
    for (from, to) in rows {
        for (at, pixel) in to.iter_mut().enumerate() {
            let (phase, column) = (at % times, at / times);
            // The first of the four pixels around: two before where the place is left of the pixel's centre.
            let first = column + usize::from(2 * phase + 1 >= times);
            let tap = |index: usize| from[(first + index).saturating_sub(2).min(width - 1)];
            *pixel = weighted([tap(0), tap(1), tap(2), tap(3)], weights[phase]);
        }
    }
    longer
}

fn weighted(taps: [Pixel; 4], weights: [f32; 4]) -> Pixel {
    let channel = |i: usize| {
        let [a, b, c, d] = taps.map(|tap| f32::from(tap[i]));
        ((a * weights[0] + b * weights[1]) + (c * weights[2] + d * weights[3])) / 255.0
    };
    let [r, g, b, a] = [0, 1, 2, 3].map(|i| trigon_image::color::unit_to_u8(channel(i)));
    [r.min(a), g.min(a), b.min(a), a]
}

/// Weights of the four pixels around the place `phase` of `times` within a pixel.
fn weights(phase: usize, times: usize) -> [f32; 4] {
    #[expect(clippy::cast_precision_loss, reason = "at most 8")]
    let place = (2 * phase + 1) as f32 / (2 * times) as f32 - 0.5;
    let after_first = if place < 0.0 { place + 1.0 } else { place };
    [1.0 + after_first, after_first, 1.0 - after_first, 2.0 - after_first].map(mitchell)
}

/// The filter at a distance of 0 to 2 pixels.
fn mitchell(x: f32) -> f32 {
    if x < 1.0 {
        ((7.0 * x - 12.0) * x * x) / 6.0 + 16.0 / 18.0
    } else {
        (((-7.0 / 3.0 * x + 12.0) * x - 20.0) * x) / 6.0 + 32.0 / 18.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_sum_to_one() {
        for times in 2..=4 {
            for phase in 0..times {
                let sum: f32 = weights(phase, times).iter().sum();
                assert!((sum - 1.0).abs() < 1e-6, "{phase} of {times}: {sum}");
            }
        }
    }

    #[test]
    fn enlarging_keeps_flat_colors_and_mirrors() {
        let flat = Rgba8Image::filled(3, 2, [200, 100, 50, 255]);
        let large = enlarged(&flat, [4, 3]).unwrap();
        assert_eq!(large, Rgba8Image::filled(12, 6, [200, 100, 50, 255]));
        let edge = [[0, 0, 0, 255], [255; 4]];
        let large = enlarged(&Rgba8Image::from_pixels(2, 1, edge.to_vec()).unwrap(), [4, 1]).unwrap();
        let reds: Vec<u8> = large.pixels().iter().map(|pixel| pixel[0]).collect();
        for (a, b) in reds.iter().zip(reds.iter().rev()) {
            assert!(a.abs_diff(255 - b) <= 1, "{reds:?}");
        }
        assert!(reds.is_sorted());
    }
}
