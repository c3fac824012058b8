//! What to draw and into what: the arguments of a frame.

use crate::geometry::{Cull, GeometryStatistics, Primitives};
use crate::raster::DepthTest;
use crate::resolve::Blend;
use crate::shade::{ErasedShader, Interpolation};
use crate::target::{ColorSpace, MAX_SIZE, SamplePattern, ShadingRate};
use core::fmt;

/// One submission: a shader, primitives and fixed-function state.
#[derive(Clone, Copy)]
pub struct Draw<'a> {
    /// Places vertices and colours fragments. Any [`Shader`](crate::shade::Shader) will do.
    pub shader: &'a dyn ErasedShader,
    /// What to draw.
    pub primitives: Primitives<'a>,
    /// Which sides are dropped.
    pub cull: Cull,
    /// Use of depth.
    pub depth: DepthTest,
    /// Combination with what is there. Anything but `Replace` is drawn in submission order.
    pub blend: Blend,
    /// Written to the object output.
    pub object: u32,
}

impl<'a> Draw<'a> {
    /// An opaque, depth-tested draw of both sides.
    pub fn new(shader: &'a dyn ErasedShader, primitives: Primitives<'a>) -> Self {
        Self { shader, primitives, cull: Cull::None, depth: DepthTest::NEARER_WRITE, blend: Blend::Replace, object: 0 }
    }

    /// Must be shaded in submission order, before later draws.
    pub(crate) fn is_ordered(&self) -> bool {
        self.blend != Blend::Replace || self.depth != DepthTest::NEARER_WRITE
    }
}

/// Which images a frame makes. What is not asked for is not computed: without colour nothing is shaded.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Outputs {
    /// 8-bit sRGB, straight alpha.
    pub color: bool,
    /// The means of samples, in the frame's colour space: linear f32 as a rule, premultiplied alpha.
    pub color_f32: bool,
    /// NDC depth: 1 near, 0 far, and 0 where nothing was drawn.
    pub depth: bool,
    /// Number of the primitive within its draw; `u32::MAX` where nothing was drawn.
    pub primitive: bool,
    /// [`Draw::object`]; `u32::MAX` where nothing was drawn.
    pub object: bool,
    /// World-space normal, zero where nothing was drawn.
    pub normal: bool,
    /// World-space position, zero where nothing was drawn.
    pub position: bool,
    /// Texture coordinates, zero where nothing was drawn.
    pub uv: bool,
    /// One value per sample instead of that of the pixel's nearest sample, for the outputs from `depth` on.
    pub per_sample: bool,
}

impl Outputs {
    /// Nothing.
    pub const NONE: Self = Self {
        color: false,
        color_f32: false,
        depth: false,
        primitive: false,
        object: false,
        normal: false,
        position: false,
        uv: false,
        per_sample: false,
    };
    /// 8-bit colour only.
    pub const COLOR: Self = Self { color: true, ..Self::NONE };
    /// Depth only.
    pub const DEPTH: Self = Self { depth: true, ..Self::NONE };

    pub(crate) fn any_color(self) -> bool {
        self.color || self.color_f32
    }

    pub(crate) fn any_surface(self) -> bool {
        self.normal || self.position || self.uv
    }

    pub(crate) fn any_beside_color(self) -> bool {
        self.depth || self.primitive || self.object || self.any_surface()
    }
}

/// Size, samples and outputs of a picture.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Frame {
    /// Pixels in a row, 1..=16 384.
    pub width: u32,
    /// Rows, 1..=16 384.
    pub height: u32,
    /// Where coverage and depth are tested.
    pub samples: SamplePattern,
    /// How often pixels are shaded.
    pub shading: ShadingRate,
    /// How the attributes of vertices vary over triangles. Depth is linear over the picture in both ways.
    pub interpolation: Interpolation,
    /// What the numbers are that shaders return: linear light, or values as they are stored.
    pub color_space: ColorSpace,
    /// Colour where nothing is drawn, in that space, premultiplied.
    pub clear: [f32; 4],
    /// Which images are made.
    pub outputs: Outputs,
}

impl Frame {
    /// An opaque black 8-bit picture with one sample per pixel.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            width,
            height,
            samples: SamplePattern::CENTER,
            shading: ShadingRate::Pixel,
            interpolation: Interpolation::Perspective,
            color_space: ColorSpace::Linear,
            clear: [0.0, 0.0, 0.0, 1.0],
            outputs: Outputs::COLOR,
        }
    }

    pub(crate) fn check(&self) -> Result<(), FrameError> {
        let fits = |size: u32| (1..=MAX_SIZE).contains(&size);
        if fits(self.width) && fits(self.height) {
            Ok(())
        } else {
            Err(FrameError::Size { width: self.width, height: self.height })
        }
    }
}

/// Why a frame cannot be drawn.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub enum FrameError {
    /// A side is zero or beyond 16 384 pixels.
    Size {
        /// As asked for.
        width: u32,
        /// As asked for.
        height: u32,
    },
    /// A pixel to be explained that the frame does not have.
    NoPixel {
        /// Column.
        x: u32,
        /// Row.
        y: u32,
        /// Of the frame.
        width: u32,
        /// Of the frame.
        height: u32,
    },
    /// More primitives than a draw's 32-bit numbers can name.
    TooManyPrimitives(usize),
    /// The renderer's [`Deadline`](crate::schedule::Deadline) came before the end of the frame.
    TimeOver,
}

impl fmt::Display for FrameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Size { width, height } => {
                write!(f, "picture size {width}x{height} is outside 1..={MAX_SIZE} pixels a side")
            }
            Self::NoPixel { x, y, width, height } => {
                write!(f, "there is no pixel {x},{y} in a picture of {width}x{height}; both count from 0")
            }
            Self::TooManyPrimitives(count) => write!(f, "a draw has {count} primitives, more than {}", u32::MAX),
            Self::TimeOver => {
                write!(f, "the frame was not done in the time allowed; allow more, or draw something smaller")
            }
        }
    }
}

impl core::error::Error for FrameError {}

/// What happened in a frame. The counts do not depend on threads or SIMD level; the times do.
#[derive(Clone, Copy, Default, Debug)]
pub struct FrameStatistics {
    /// Primitives by fate.
    pub geometry: GeometryStatistics,
    /// Tiles of the picture.
    pub tiles: u64,
    /// Triangles over all tiles' lists.
    pub tile_triangles: u64,
    /// Wall time of the geometry stage.
    pub geometry_time: core::time::Duration,
    /// Wall time of rasterization, shading and resolve.
    pub tile_time: core::time::Duration,
}
