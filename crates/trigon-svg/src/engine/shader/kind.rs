//! The kinds of paint behind one name.

use super::{Gradient, ImageShader, Tile};
use trigon::lanes::Lanes;

/// The colour of each pixel of a shape.
pub(crate) enum Shader {
    /// The same everywhere.
    Solid(u32),
    Gradient(Box<Gradient>),
    Image(Box<ImageShader>),
    Tile(Box<Tile>),
}

impl Shader {
    /// The colours of the pixels of row `y` from column `x` on, one per element of `out`.
    #[inline(always)]
    pub(crate) fn row<L: Lanes>(&self, l: L, x: u32, y: u32, out: &mut [u32]) {
        match self {
            Self::Solid(color) => out.fill(*color),
            Self::Gradient(gradient) => gradient.row(l, x, y, out),
            Self::Image(image) => image.row(l, x, y, out),
            Self::Tile(tile) => tile.row(x, y, out),
        }
    }

    /// True if every pixel is opaque.
    pub(crate) fn is_opaque(&self) -> bool {
        match self {
            Self::Solid(color) => color >> 24 == 255,
            Self::Gradient(gradient) => gradient.is_opaque(),
            Self::Image(_) | Self::Tile(_) => false,
        }
    }

    /// True if no pixel is drawn.
    pub(crate) fn is_nothing(&self) -> bool {
        matches!(self, Self::Solid(0))
    }
}
