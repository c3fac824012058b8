//! Images as paints: pixels with their mip chain, and how they are sampled.

use core::fmt;
use std::sync::Arc;
use trigon::shade::texture::{Alpha, LevelFilter, PixelFilter, TexelFormat, Texture, TextureDesc, TextureError, Wrap};
use trigon_image::Rgba8Image;

/// An image to draw. Cheap to clone.
#[derive(Clone)]
pub struct Image {
    texture: Arc<Texture>,
}

/// How an image is sampled at the centre of each pixel.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ImageFilter {
    /// Within a level.
    pub pixel: PixelFilter,
    /// Between the levels of the mip chain.
    pub level: LevelFilter,
    /// Most samples along the direction in which the image is reduced most, 1 to 16; 1 reduces alike in all directions.
    pub max_anisotropy: u8,
    /// What lies outside the image.
    pub wrap: Wrap,
}

impl ImageFilter {
    /// Bilinear, and averaged exactly as far as it is reduced.
    pub const SMOOTH: Self = Self::new(PixelFilter::Bilinear, LevelFilter::Linear);
    /// The pixel that holds the point (`image-rendering: pixelated`).
    pub const NEAREST: Self = Self::new(PixelFilter::Nearest, LevelFilter::Zero);

    /// These filters, isotropic; outside the image its edge goes on.
    #[must_use]
    pub const fn new(pixel: PixelFilter, level: LevelFilter) -> Self {
        Self { pixel, level, max_anisotropy: 1, wrap: Wrap::ClampToEdge }
    }
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
