//! What lies behind and before a model: pictures in, a frame between them out.
//!
//! All is composed in linear light and premultiplied, as the frame itself was, and encoded once at the end.

use super::cover;
use crate::failure::Failure;
use crate::machine;
use crate::options::RenderOptions;
use crate::output::Images;
use std::path::Path;
use trigon_image::{Color, RgbaF32Image};
use trigon_scene::render::RenderSettings;
use trigon_svg::canvas::Renderer;

/// The pictures behind and before every frame.
#[derive(Default)]
pub(crate) struct Layers {
    behind: Option<RgbaF32Image>,
    before: Option<RgbaF32Image>,
    /// What is odd about the pictures, each with the file's name.
    pub(crate) warnings: Vec<String>,
    wants_bytes: bool,
    wants_floats: bool,
}

impl Layers {
    /// Reads the pictures that the options name, in the size of the frame, and asks the settings for what
    /// [`compose`](Self::compose) needs: without pictures, for nothing more.
    pub(crate) fn read(options: &RenderOptions, settings: &mut RenderSettings) -> Result<Self, Failure> {
        let picture = &options.picture;
        if picture.backdrop.is_none() && picture.overlay.is_none() {
            return Ok(Self::default());
        }
        let machine = machine::renderer_options(&options.machine)?;
        let renderer = Renderer { threads: machine.threads, simd: machine.simd, ..Renderer::new() };
        let mut warnings = Vec::new();
        let mut read = |path: &Path| {
            let size = (settings.width, settings.height);
            let drawing = cover(path, size, options, &renderer, &mut warnings)?;
            let drawn = renderer.draw(&drawing, size.0, size.1, Color::TRANSPARENT);
            let picture = drawn.map_err(|error| Failure::work(format!("{}: {error}", path.display())))?;
            Ok(picture.to_image().to_linear())
        };
        let mut behind = picture.backdrop.as_deref().map(&mut read).transpose()?;
        let before = picture.overlay.as_deref().map(&mut read).transpose()?;
        if let Some(behind) = &mut behind {
            let color = picture.background.unwrap_or(Color::TRANSPARENT).to_linear_premultiplied();
            for pixel in behind.pixels_mut() {
                *pixel = over(*pixel, color);
            }
            settings.background = [0.0; 4];
        }
        let wanted = settings.outputs;
        (settings.outputs.color, settings.outputs.color_f32) = (false, true);
        Ok(Self { behind, before, warnings, wants_bytes: wanted.color, wants_floats: wanted.color_f32 })
    }

    /// True without pictures.
    pub(crate) fn is_empty(&self) -> bool {
        self.behind.is_none() && self.before.is_none()
    }

    /// The frame between the pictures.
    pub(crate) fn compose(&self, frame: Images) -> Images {
        if self.is_empty() {
            return frame;
        }
        let Some(mut floats) = frame.floats else { return frame };
        if let Some(behind) = &self.behind {
            for (pixel, below) in floats.pixels_mut().iter_mut().zip(behind.pixels()) {
                *pixel = over(*pixel, *below);
            }
        }
        if let Some(before) = &self.before {
            for (pixel, above) in floats.pixels_mut().iter_mut().zip(before.pixels()) {
                *pixel = over(*above, *pixel);
            }
        }
        let bytes = self.wants_bytes.then(|| floats.to_srgb8());
        Images { bytes, floats: self.wants_floats.then_some(floats) }
    }
}

/// A premultiplied colour over another.
fn over(above: [f32; 4], below: [f32; 4]) -> [f32; 4] {
    let rest = 1.0 - above[3];
    [0, 1, 2, 3].map(|i| above[i] + below[i] * rest)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_one_colour_and_half_of_the_other() {
        assert_eq!(over([0.5, 0.0, 0.0, 0.5], [0.0, 1.0, 0.0, 1.0]), [0.5, 0.5, 0.0, 1.0]);
        assert_eq!(over([0.0; 4], [0.25, 0.5, 0.0, 0.5]), [0.25, 0.5, 0.0, 0.5]);
    }
}
