//! `image` elements: embedded and linked pictures, decoded once each.

use std::collections::HashMap;
use std::sync::Arc;

use trigon_image::decode;
use usvg::{ImageKind, ImageRendering};

use super::limits::Limits;
use super::warnings::Warnings;
use crate::canvas::{Image, ImageFilter};

/// Pictures decoded so far, by the address of their bytes, which the tree keeps alive.
#[derive(Default)]
pub(super) struct Images {
    decoded: HashMap<*const u8, Option<Image>>,
    pixels: u64,
}

impl Images {
    /// The picture; `None`, with a warning, where it is broken or over the limit.
    pub(super) fn get(&mut self, kind: &ImageKind, limits: &Limits, warnings: &mut Warnings) -> Option<Image> {
        let (name, bytes): (&str, &Arc<Vec<u8>>) = match kind {
            ImageKind::PNG(bytes) => ("PNG", bytes),
            ImageKind::JPEG(bytes) => ("JPEG", bytes),
            ImageKind::GIF(bytes) => ("GIF", bytes),
            ImageKind::WEBP(bytes) => ("WebP", bytes),
            ImageKind::SVG(_) => return None,
        };
        if let Some(known) = self.decoded.get(&bytes.as_ptr()) {
            return known.clone();
        }
        let image = self.decode(name, bytes, limits, warnings);
        self.decoded.insert(bytes.as_ptr(), image.clone());
        image
    }

    fn decode(&mut self, name: &str, bytes: &[u8], limits: &Limits, warnings: &mut Warnings) -> Option<Image> {
        let left = limits.max_image_pixels.saturating_sub(self.pixels);
        let pixels = match decode(bytes, None, &trigon_image::Limits::default().with_max_pixels(left)) {
            Ok(decoded) => decoded.into_rgba8(),
            Err(error) => {
                warnings.add(format!("an image ({name}) is not drawn: {error}"));
                return None;
            }
        };
        self.pixels += u64::from(pixels.width()) * u64::from(pixels.height());
        match Image::new(&pixels) {
            Ok(image) => Some(image),
            Err(error) => {
                warnings.add(format!("an image ({name}) is not drawn: {error}"));
                None
            }
        }
    }
}

/// How `image-rendering` samples.
pub(super) fn image_filter(rendering: ImageRendering) -> ImageFilter {
    match rendering {
        ImageRendering::OptimizeSpeed | ImageRendering::CrispEdges | ImageRendering::Pixelated => ImageFilter::NEAREST,
        ImageRendering::OptimizeQuality | ImageRendering::Smooth | ImageRendering::HighQuality => ImageFilter::SMOOTH,
    }
}
