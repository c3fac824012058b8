//! The story of one pixel, as plain data: what [`Renderer::explain`](super::Renderer::explain) tells.

use crate::explain::{FragmentFacts, Note};
use crate::raster::DepthTest;
use crate::resolve::Blend;
use crate::shade::Interpolation;
use crate::target::{ColorSpace, ShadingRate};

/// How one pixel came about, from the triangles that may touch it to its bytes.
#[derive(Clone, PartialEq, Debug)]
pub struct PixelStory {
    /// Column and row, from the top left.
    pub pixel: [u32; 2],
    /// Where coverage and depth are tested, in 1/256 px from the pixel's top-left corner.
    pub samples: Vec<[i16; 2]>,
    /// How often the pixel is shaded.
    pub shading: ShadingRate,
    /// How attributes vary over triangles.
    pub interpolation: Interpolation,
    /// What the numbers of all colours stand for.
    pub color_space: ColorSpace,
    /// The colour before anything is drawn, premultiplied.
    pub clear: [f32; 4],
    /// Every triangle whose box touches the pixel, in the order in which they are drawn.
    pub triangles: Vec<TriangleStory>,
    /// What was shaded for the pixel, in the order in which it was done.
    pub fragments: Vec<FragmentStory>,
    /// The end.
    pub resolve: ResolveStory,
}

/// One triangle and the pixel.
#[derive(Clone, PartialEq, Debug)]
pub struct TriangleStory {
    /// Number of the draw.
    pub draw: u32,
    /// Number of the primitive within the draw.
    pub primitive: u32,
    /// [`Draw::object`](super::Draw::object).
    pub object: u32,
    /// The primitive's vertices as submitted; lines and points repeat some.
    pub vertices: [u32; 3],
    /// Their positions in clip space.
    pub clip: [[f32; 4]; 3],
    /// The corners in the framebuffer, in 1/256 px; the topmost first. Corner k is vertex `vertex_of_corner[k]`, unless
    /// the triangle is clipped or made of a line or point.
    pub corners: [[i32; 2]; 3],
    /// Which of `vertices` each corner is.
    pub vertex_of_corner: [usize; 3],
    /// 1/w at the corners.
    pub inverse_w: [f32; 3],
    /// Depth at corner 0, and its change per pixel to the right and down.
    pub depth: [f32; 3],
    /// A piece of a primitive that crossed the near plane or left the guard band.
    pub is_clipped: bool,
    /// The vertices appear counter-clockwise.
    pub is_front: bool,
    /// Its box is at most 4 x 4 pixels, and its coverage was found sixteen triangles at a time.
    pub is_micro: bool,
    /// The 8 x 8 pixels around were decided at once: the triangle covers them all and is the nearest.
    pub is_whole_block: bool,
    /// How the draw uses depth.
    pub depth_test: DepthTest,
    /// How the draw's colours combine with what is there.
    pub blend: Blend,
    /// One for each sample.
    pub tests: Vec<SampleTest>,
}

/// One sample and a triangle.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct SampleTest {
    /// The three edge functions, in 1/256 px^2 rounded down, from corner k to corner k + 1, as they are compared: the
    /// sample is covered if none is negative. (An edge that is no top or left one loses the samples that lie on it.)
    pub edges: [i32; 3],
    /// Covered.
    pub is_covered: bool,
    /// Depth of the triangle's plane: 1 near, 0 far. It is meaningful where the sample is covered.
    pub depth: f32,
    /// The depth before.
    pub stored: f32,
    /// What came of it.
    pub outcome: Outcome,
}

/// What came of a triangle at a sample.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Outcome {
    /// The sample lies outside.
    Outside,
    /// Something nearer was there.
    Hidden,
    /// The shader discarded the fragment.
    Discarded,
    /// It is drawn.
    Drawn,
}

/// A fragment: a pixel and a triangle, with all samples that share its colour.
#[derive(Clone, PartialEq, Debug)]
pub struct FragmentStory {
    /// Index into [`PixelStory::triangles`].
    pub triangle: usize,
    /// One bit for each sample.
    pub samples: u32,
    /// What the pipeline gave to the shader.
    pub facts: FragmentFacts,
    /// What the shader noted.
    pub notes: Vec<Note>,
    /// The colour that the shader returned: linear, premultiplied; `None` for an alpha test.
    pub color: Option<[f32; 4]>,
    /// The colours of all samples before and after.
    pub before: Vec<[f32; 4]>,
    /// For an alpha test the same as before.
    pub after: Vec<[f32; 4]>,
}

/// From samples to bytes.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct ResolveStory {
    /// One for each sample: linear, premultiplied.
    pub samples: Vec<[f32; 4]>,
    /// Their mean.
    pub mean: [f32; 4],
    /// The mean as 8-bit sRGB with straight alpha: what the picture holds.
    pub bytes: [u8; 4],
}
