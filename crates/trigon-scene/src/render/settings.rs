//! How a scene is drawn: everything that is neither scene nor camera.

use super::course::depth_buffer;
use super::course::games101::Relief;
use super::course::tinyrenderer::Lesson;
use super::{AmbientOcclusion, Outline, ShaderKind, Shadows};
use trigon::geometry::Cull;
use trigon::pipeline::Outputs;
use trigon::shade::Interpolation;
use trigon::shade::texture::{LevelFilter, PixelFilter, Wrap};
use trigon::target::{ColorSpace, SamplePattern, ShadingRate};

/// How a scene is drawn. Start from [`RenderSettings::new`] and change what differs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RenderSettings {
    /// Pixels in a row, 1..=16 384.
    pub width: u32,
    /// Rows, 1..=16 384.
    pub height: u32,
    /// Where coverage and depth are tested; 4 standard positions by default.
    pub samples: SamplePattern,
    /// How far the picture is moved, in pixels right and up. Half a pixel each way puts the sample in the middle of a pixel
    /// where its lower left corner was, for programs that sample at whole coordinates.
    pub shift_px: [f32; 2],
    /// How often pixels are shaded.
    pub shading: ShadingRate,
    /// How the attributes of vertices vary over triangles.
    pub interpolation: Interpolation,
    /// What colours are while light is added up, textures are filtered and samples are averaged: linear light, or display
    /// values as they are stored, as in programs without a transfer function. Lights are numbers in both. The colours of
    /// settings, scenes and float pictures are linear light whatever this is.
    pub color_space: ColorSpace,
    /// Which images are made. `primitive` holds indices into the mesh's triangles (segments, points), `object` numbers
    /// the parts of all instances in order, `normal` is the one that shading uses. Blended surfaces and wireframes
    /// appear in colour only.
    pub outputs: Outputs,
    /// What the colours show.
    pub shader: ShaderKind,
    /// Colour where nothing is drawn: linear light, premultiplied by alpha; `[0.0; 4]` for a transparent picture.
    pub background: [f32; 4],
    /// Which sides of triangles are dropped. Surfaces are two-sided: the default draws and lights both.
    pub cull: Cull,
    /// How textures are read.
    pub sampling: TextureSampling,
    /// What becomes of translucent materials.
    pub alpha: AlphaMode,
    /// Edges of the triangles, drawn as lines.
    pub wireframe: Option<Wireframe>,
    /// Width of the scene's own line elements, in pixels.
    pub line_width_px: f32,
    /// Size of the scene's points, in pixels.
    pub point_size_px: f32,
    /// Whether lights cast shadows, and how; none by default.
    pub shadows: Option<Shadows>,
    /// Whether cracks and corners are darkened, and how; not by default. [`ShaderKind::Occlusion`] shows it alone.
    pub ambient_occlusion: Option<AmbientOcclusion>,
    /// Steps of light of [`ShaderKind::Toon`], 1 to [`RenderSettings::MAX_TOON_LEVELS`].
    pub toon_levels: u32,
    /// How high the relief of [`ShaderKind::Games101`] is.
    pub relief: Relief,
    /// Whether the outlines of things are drawn, and how; not by default.
    pub outline: Option<Outline>,
}

impl RenderSettings {
    /// Good looks at a reasonable price: 4 samples, trilinear textures, an opaque light grey background.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        Self {
            width,
            height,
            samples: SamplePattern::standard(4).unwrap_or(SamplePattern::CENTER),
            shift_px: [0.0; 2],
            shading: ShadingRate::Pixel,
            interpolation: Interpolation::Perspective,
            color_space: ColorSpace::Linear,
            outputs: Outputs::COLOR,
            shader: ShaderKind::default(),
            background: Self::DEFAULT_BACKGROUND,
            cull: Cull::None,
            sampling: TextureSampling::default(),
            alpha: AlphaMode::Auto,
            wireframe: None,
            line_width_px: 1.5,
            point_size_px: 3.0,
            shadows: None,
            ambient_occlusion: None,
            toon_levels: 3,
            relief: Relief::default(),
            outline: None,
        }
    }

    /// Whether the colours depend on lights.
    pub(super) fn shows_light(&self) -> bool {
        (self.outputs.color || self.outputs.color_f32) && self.shader.is_lit()
    }

    /// Whether surfaces are drawn, be it to hide the lines behind them.
    pub(super) fn draws_surfaces(&self) -> bool {
        self.wireframe.is_none_or(|wireframe| wireframe.surface || !wireframe.hidden_lines)
    }

    /// The outlines that the colours show.
    pub(super) fn shown_outline(&self) -> Option<Outline> {
        self.outline.filter(|_| self.outputs.color || self.outputs.color_f32)
    }

    /// Whether the shader draws outlines of its own.
    pub(super) fn has_course_lines(&self) -> bool {
        self.shader == ShaderKind::Tinyrenderer(Lesson::Toon) && self.shows_light()
    }

    /// The occlusion that the colours depend on.
    pub(super) fn shown_occlusion(&self) -> Option<AmbientOcclusion> {
        if self.shader == ShaderKind::Occlusion && (self.outputs.color || self.outputs.color_f32) {
            return Some(self.ambient_occlusion.unwrap_or_default());
        }
        if self.shader == ShaderKind::Tinyrenderer(Lesson::Occlusion) && self.shows_light() {
            return Some(self.ambient_occlusion.unwrap_or(depth_buffer::OCCLUSION));
        }
        self.ambient_occlusion.filter(|_| self.shows_light())
    }

    /// The most steps of light that toon shading has; more count as these.
    pub const MAX_TOON_LEVELS: u32 = 16;

    /// The default background: sRGB #e6e8eb, a light cool grey on which light and dark models both stand out.
    pub const DEFAULT_BACKGROUND: [f32; 4] = [0.791_298, 0.806_952_3, 0.830_769_9, 1.0];

    /// The colour of lines and points that have none of their own, in linear light: near black, or light grey before a
    /// dark background. A transparent one counts as white, on which most such pictures end up.
    #[must_use]
    pub fn ink(&self) -> [f32; 3] {
        let [r, g, b, alpha] = self.background;
        let luminance = ((0.2126 * r + 0.7152 * g) + 0.0722 * b) + (1.0 - alpha);
        if luminance > 0.18 { [0.02, 0.021, 0.024] } else { [0.75; 3] }
    }
}

/// How textures are read; options of a material's map (`-clamp`, `-blendu`) come before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureSampling {
    /// Within a mip level.
    pub pixel: PixelFilter,
    /// Between mip levels.
    pub level: LevelFilter,
    /// Most samples along the long axis of a footprint, 1 to 16.
    pub max_anisotropy: u8,
    /// Outside of the image, in place of repeating it.
    pub wrap: Option<Wrap>,
    /// Added to the level of detail.
    pub lod_bias: f32,
}

impl Default for TextureSampling {
    /// Trilinear, isotropic.
    fn default() -> Self {
        Self { pixel: PixelFilter::Bilinear, level: LevelFilter::Linear, max_anisotropy: 1, wrap: None, lod_bias: 0.0 }
    }
}

/// What becomes of materials that are not opaque everywhere (`d`, `map_d`, alpha of `map_Kd` or of vertex colours).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AlphaMode {
    /// Cut out where maps hold (almost) only 0 and 1 and `d` is 1; blended otherwise.
    #[default]
    Auto,
    /// Everything with opacity of at least one half is opaque, the rest is not there.
    CutOut,
    /// Everything that is not opaque is blended.
    Blend,
    /// Opacity is ignored.
    Opaque,
}

/// The edges of triangles as lines, each edge once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wireframe {
    /// Linear light, premultiplied by alpha.
    pub color: [f32; 4],
    /// In pixels.
    pub width_px: f32,
    /// Whether the surfaces are drawn too; without them there are lines alone.
    pub surface: bool,
    /// Whether lines behind surfaces are drawn.
    pub hidden_lines: bool,
}

impl Default for Wireframe {
    /// Dark lines of one pixel over the surface, hidden ones left out.
    fn default() -> Self {
        Self { color: [0.01, 0.01, 0.012, 1.0], width_px: 1.0, surface: true, hidden_lines: false }
    }
}
