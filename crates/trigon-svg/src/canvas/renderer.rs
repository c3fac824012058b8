//! From a drawing to pixels: the settings, the call, the result.

use super::Drawing;
use crate::engine;
use core::fmt;
use trigon::lanes::SimdLevel;
use trigon::schedule::Deadline;
use trigon::target::{MAX_SIZE, SamplePattern};
use trigon_image::{Color, Rgba8Image};

/// How drawings are turned into pixels. Threads and level change the speed of a picture, never a bit of it.
#[derive(Clone, Debug)]
pub struct Renderer {
    /// Where in each pixel coverage is tested; 1, 4, 9 or 16 samples as a grid, or a standard pattern.
    pub pattern: SamplePattern,
    /// Threads at work, the caller's included; 0 counts as 1.
    pub threads: usize,
    /// The instruction set of the kernels.
    pub simd: SimdLevel,
    /// Most pixels of any one picture that is held in memory: the result, the layer of a filter, the tile of a pattern.
    /// Layers of filters are cut to it, pattern tiles reduced.
    pub max_pixels: u64,
    /// Most layers, masks, patterns and filters inside each other; deeper ones are not drawn.
    pub max_depth: u32,
    /// When to give up. Work stops within the time that it takes to flatten or stroke one shape, to draw one in sixteen
    /// rows of pixels, or to do one step of a filter.
    pub deadline: Deadline,
}

/// A finished picture: sRGB-encoded, premultiplied, row 0 at the top.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Picture {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) pixels: Vec<[u8; 4]>,
}

/// Why nothing was drawn.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum DrawError {
    /// A side is above 16,384 pixels, or the picture has more pixels than [`Renderer::max_pixels`].
    TooLarge {
        /// Width asked for.
        width: u32,
        /// Height asked for.
        height: u32,
    },
    /// This CPU lacks the level of [`Renderer::simd`].
    SimdUnavailable(SimdLevel),
    /// [`Renderer::deadline`] came before the end.
    TimeOver,
}

impl Renderer {
    /// Sixteen samples on a grid, one thread, the best level of this CPU.
    #[must_use]
    pub fn new() -> Self {
        let pattern = SamplePattern::grid(16).unwrap_or(SamplePattern::CENTER);
        let (max_pixels, max_depth, deadline) = (1 << 28, 64, Deadline::NEVER);
        Self { pattern, threads: 1, simd: SimdLevel::detect(), max_pixels, max_depth, deadline }
    }

    /// Draws what of `drawing` lies in 0..`width` and 0..`height`, over `background` (often transparent).
    ///
    /// # Errors
    /// If the size is over a limit, the CPU lacks the SIMD level, or the deadline comes before the end.
    pub fn draw(&self, drawing: &Drawing, width: u32, height: u32, background: Color) -> Result<Picture, DrawError> {
        self.check(width, height)?;
        let pixels = vec![[0; 4]; width as usize * height as usize];
        let mut picture = Picture { width, height, pixels };
        engine::draw(self, drawing, [width, height], background, &mut picture.pixels);
        self.in_time()?;
        Ok(picture)
    }

    /// As [`draw`](Self::draw), in the memory and with the size of a picture that is no longer wanted: faster than to ask
    /// the system for new memory.
    ///
    /// # Errors
    /// As [`draw`](Self::draw); after the deadline the picture is transparent.
    pub fn draw_into(&self, drawing: &Drawing, background: Color, picture: &mut Picture) -> Result<(), DrawError> {
        self.check(picture.width, picture.height)?;
        engine::draw(self, drawing, [picture.width, picture.height], background, &mut picture.pixels);
        self.in_time().inspect_err(|_| picture.pixels.fill([0; 4]))
    }

    /// Draws what of `drawing` lies in `picture` over what the picture holds: labels over a model.
    /// Its pixels are below the first shape as a background is, for blend modes too.
    ///
    /// # Errors
    /// As [`draw`](Self::draw); the picture is then as it was.
    pub fn draw_over(&self, drawing: &Drawing, picture: &mut Picture) -> Result<(), DrawError> {
        self.check(picture.width, picture.height)?;
        let size = [picture.width, picture.height];
        if self.deadline == Deadline::NEVER {
            engine::draw_over(self, drawing, size, &mut picture.pixels);
            return Ok(());
        }
        let mut pixels = picture.pixels.clone();
        engine::draw_over(self, drawing, size, &mut pixels);
        self.in_time()?;
        picture.pixels = pixels;
        Ok(())
    }

    /// An error once the deadline is over. Work that it cut short ends after it, so what is done before is whole.
    pub(crate) fn in_time(&self) -> Result<(), DrawError> {
        if self.deadline.is_over() { Err(DrawError::TimeOver) } else { Ok(()) }
    }

    fn check(&self, width: u32, height: u32) -> Result<(), DrawError> {
        let too_large = u64::from(width) * u64::from(height) > self.max_pixels;
        if width > MAX_SIZE || height > MAX_SIZE || too_large {
            return Err(DrawError::TooLarge { width, height });
        }
        self.simd.require().map_err(|_| DrawError::SimdUnavailable(self.simd))?;
        Ok(())
    }
}

impl Default for Renderer {
    fn default() -> Self {
        Self::new()
    }
}

impl Picture {
    /// A picture to draw on, from straight alpha as files and the rasterizer have it: each colour is multiplied by alpha
    /// and rounded to nearest.
    #[must_use]
    pub fn from_image(image: &Rgba8Image) -> Self {
        let pixels = image.pixels().iter().map(|pixel| engine::premultiplied_pixel(*pixel)).collect();
        Self { width: image.width(), height: image.height(), pixels }
    }

    /// Width in pixels.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Height in pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// Red, green, blue, alpha of pixel (x, y) at `y * width + x`, premultiplied.
    #[must_use]
    pub fn pixels(&self) -> &[[u8; 4]] {
        &self.pixels
    }

    /// Gives the pixels away.
    #[must_use]
    pub fn into_pixels(self) -> Vec<[u8; 4]> {
        self.pixels
    }

    /// With straight alpha, as files want it: each colour is divided by alpha and rounded to nearest.
    #[must_use]
    pub fn to_image(&self) -> Rgba8Image {
        let mut image = Rgba8Image::new(self.width, self.height);
        for (out, pixel) in image.pixels_mut().iter_mut().zip(&self.pixels) {
            *out = engine::straight(*pixel);
        }
        image
    }
}

impl fmt::Display for DrawError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooLarge { width, height } => {
                write!(f, "a picture of {width}x{height} pixels is over the limit; draw it smaller or in parts")
            }
            Self::TimeOver => write!(f, "not drawn in the time allowed; allow more, or draw something smaller"),
            Self::SimdUnavailable(level) => write!(f, "SIMD level '{level}' is not available on this CPU"),
        }
    }
}

impl std::error::Error for DrawError {}
