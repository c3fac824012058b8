//! What the rasterizer draws: points, lines, triangles and upright pictures, in framebuffer space.

use std::sync::Arc;

use super::texture::Texture;

/// A position in pixels.
pub(super) type Position = [f64; 2];
/// Red, green, blue, opacity, each 0..=1.
pub(super) type Color = [f32; 4];

/// One thing to draw.
#[derive(Debug, Clone)]
pub(super) enum Primitive {
    /// One pixel.
    Point { at: Position, color: Color },
    /// A line one pixel wide.
    Line { from: Position, to: Position, color: Color },
    /// A triangle.
    Triangle { corners: [Position; 3], paint: TrianglePaint },
    /// A picture between two corners, never turned.
    Picture { from: Position, to: Position, texture: Arc<Texture> },
}

/// What a triangle is filled with.
#[derive(Debug, Clone)]
pub(super) enum TrianglePaint {
    /// One color.
    Flat(Color),
    /// A color at each corner, mixed.
    Mixed([[f32; 3]; 3]),
    /// A texture, by the (u, v) of each corner; v grows downward.
    Textured { uv: [[f64; 2]; 3], texture: Arc<Texture> },
}

impl Primitive {
    /// The rows of pixels it can touch: first and last.
    pub(super) fn rows(&self) -> (f64, f64) {
        let of = |rows: &[f64]| {
            let least = rows.iter().copied().fold(f64::INFINITY, f64::min);
            let most = rows.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            (least.floor(), most.floor())
        };
        match self {
            Self::Point { at, .. } => of(&[at[1]]),
            Self::Line { from, to, .. } => {
                let (least, most) = of(&[from[1], to[1]]);
                // Stepping in single precision can end a row further.
                (least - 1.0, most + 1.0)
            }
            Self::Picture { from, to, .. } => of(&[from[1], to[1]]),
            Self::Triangle { corners, .. } => of(&corners.map(|corner| corner[1])),
        }
    }
}
