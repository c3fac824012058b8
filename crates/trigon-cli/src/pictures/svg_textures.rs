//! `map_Kd drawing.svg`: SVG files as textures of models, joined here because neither front end knows the other.

use crate::options::SvgInputOptions;
use crate::warnings;
use std::io;
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use trigon_image::{Color, DecodeError, DecodedImage, Limits};
use trigon_scene::load::PictureDecoder;
use trigon_svg::canvas::Renderer;
use trigon_svg::svg::{Document, Options, Size, SvgError, View, is_svg};

/// Pixels of the longer side of a texture; its mip chain makes it smaller where it is further away.
const LONGER_SIDE: u32 = 2048;

/// Draws textures that are SVG.
pub(crate) struct SvgTextures {
    options: Options,
    /// What is odd about those drawn so far, each with the file's name.
    warnings: Mutex<Vec<String>>,
}

impl SvgTextures {
    /// Pictures that a texture links to are not read: models are often those of strangers.
    pub(crate) fn new(options: &SvgInputOptions, max_bytes: u64) -> Self {
        Self { options: options.to_options(None, max_bytes), warnings: Mutex::default() }
    }

    /// What is odd about the files drawn since the last call, in the order of their names.
    pub(crate) fn take_warnings(&self) -> Vec<String> {
        let mut warnings = std::mem::take(&mut *self.warnings.lock().unwrap_or_else(PoisonError::into_inner));
        warnings.sort_unstable();
        warnings
    }

    fn draw(&self, name: &str, bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
        let unusable = |error: SvgError| DecodeError::Io(io::Error::new(io::ErrorKind::InvalidData, error.to_string()));
        let document = Document::parse(bytes, &self.options).map_err(unusable)?;
        let [width, height] = document.size();
        let size = if width < height { Size::Height(LONGER_SIDE) } else { Size::Width(LONGER_SIDE) };
        let view = View { size, ..View::default() };
        // Textures are drawn on several threads as it is.
        let renderer = Renderer::new();
        let prepared = document.prepare(&view, &renderer).map_err(unusable)?;
        let odd = warnings::about(Path::new(name), &prepared.warnings);
        self.warnings.lock().unwrap_or_else(PoisonError::into_inner).extend(odd);
        limits.check(prepared.width, prepared.height, 4)?;
        let picture = renderer.draw(&prepared.drawing, prepared.width, prepared.height, Color::TRANSPARENT);
        Ok(DecodedImage::Rgba8(picture.map_err(|error| unusable(error.into()))?.to_image()))
    }
}

impl PictureDecoder for SvgTextures {
    fn decode(&self, name: &str, bytes: &[u8], limits: &Limits) -> Option<Result<DecodedImage, DecodeError>> {
        is_svg(bytes).then(|| self.draw(name, bytes, limits))
    }
}
