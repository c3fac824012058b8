//! Images as paints: pixels with their mip chain, and how they are sampled.

use core::fmt;
use std::sync::Arc;
use trigon::shade::texture::{Alpha, LevelFilter, PixelFilter, TexelFormat, Texture, TextureDesc, TextureError};
use trigon_image::Rgba8Image;

/// An image to draw. Cheap to clone.
#[derive(Clone)]
pub struct Image {
    texture: Arc<Texture>,
}

/// How an image is sampled at the centre of each pixel.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct ImageFilter {
    /// Within a level.
    pub pixel: PixelFilter,
    /// Between the levels of the mip chain.
    pub level: LevelFilter,
}

impl ImageFilter {
    /// Bilinear, and averaged exactly as far as it is reduced.
    pub const SMOOTH: Self = Self { pixel: PixelFilter::Bilinear, level: LevelFilter::Linear };
    /// The pixel that holds the point (`image-rendering: pixelated`).
    pub const NEAREST: Self = Self { pixel: PixelFilter::Nearest, level: LevelFilter::Zero };
}

impl Image {
    /// Takes straight alpha, sRGB-encoded; filters mix encoded values, as SVG does.
    ///
    /// # Errors
    /// If a side is 0 or above 32,768.
    pub fn new(pixels: &Rgba8Image) -> Result<Self, TextureError> {
        let size = [pixels.width(), pixels.height()];
        let desc = TextureDesc { alpha: Alpha::Coverage, ..TextureDesc::new(size, TexelFormat::Rgba8) };
        Ok(Self { texture: Arc::new(Texture::from_bytes(&desc, pixels.as_bytes())?) })
    }

    /// Takes a texture as it is.
    #[must_use]
    pub fn from_texture(texture: Arc<Texture>) -> Self {
        Self { texture }
    }

    /// Width and height in pixels.
    #[must_use]
    pub fn size(&self) -> [u32; 2] {
        self.texture.desc().size
    }

    /// The pixels as the sampler sees them.
    #[must_use]
    pub fn texture(&self) -> &Arc<Texture> {
        &self.texture
    }
}

impl fmt::Debug for Image {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Image({}x{})", self.size()[0], self.size()[1])
    }
}
