//! Materials as shaders read them: factors in the frame's colour space, and the maps that it needs.
//!
//! In: a [`Material`], what the frame shows, the uploaded textures. Out: a [`Surface`].
//!
//! `Kd`, `Ka`, `Ks` and `Ke` are taken as display values and decoded from sRGB: the MTL specification names no colour
//! space, but its values were chosen on screens of programs that drew them unchanged, and nearly all programs still
//! show them so. Above 1 (emission) a value is taken as it is.

use super::course::games101::Homework3;
use super::course::tinyrenderer::Lesson;
use super::settings::{AlphaMode, RenderSettings};
use super::shader_kind::ShaderKind;
use super::texture_cache::TextureCache;
use super::texture_upload::{Opacity, Usage};
use super::working_space::from_display;
use crate::scene::{Illumination, Material, ScalarSource, TextureId, TextureRef};
use trigon::shade::texture::{PixelFilter, Sampler, Texture, Wrap};
use trigon::target::ColorSpace;

/// A material, ready for a shader.
pub(super) struct Surface<'a> {
    pub(super) ambient: [f32; 3],
    pub(super) diffuse: [f32; 3],
    pub(super) specular: [f32; 3],
    pub(super) emissive: [f32; 3],
    pub(super) exponent: f32,
    pub(super) opacity: f32,
    pub(super) is_halo: bool,
    pub(super) illumination: Illumination,
    pub(super) coverage: Coverage,
    /// Nothing says what colour it has.
    pub(super) is_neutral: bool,
    /// Maps that multiply factors.
    pub(super) maps: Vec<MapUse<'a>>,
    /// Those of them that hold opacity.
    pub(super) opacity_maps: Vec<MapUse<'a>>,
    /// A `norm` map, or a `bump` map that holds normals.
    pub(super) normal: Option<MapUse<'a>>,
    pub(super) bump: Option<MapUse<'a>>,
}

/// How much of what lies behind a surface shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Coverage {
    /// Nothing.
    Opaque,
    /// All or nothing, fragment by fragment: opaque where opacity is at least one half.
    CutOut,
    /// As much as opacity lets through.
    Blend,
}

/// What a map multiplies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slot {
    Diffuse,
    Ambient,
    Specular,
    Emissive,
    Exponent,
    Opacity,
    /// Not a factor: tilts the normal.
    Normal,
    /// Not a factor: tilts the normal.
    Bump,
}

impl Slot {
    /// The number of those that are factors; they come first.
    pub(super) const FACTORS: usize = 6;

    /// What a story calls it.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Diffuse => "diffuse map",
            Self::Ambient => "ambient map",
            Self::Specular => "specular map",
            Self::Emissive => "emissive map",
            Self::Exponent => "exponent map",
            Self::Opacity => "opacity map",
            Self::Normal => "normal map",
            Self::Bump => "bump map",
        }
    }
}

/// One texture read.
#[derive(Clone, Copy)]
pub(super) struct MapUse<'a> {
    pub(super) slot: Slot,
    pub(super) texture: &'a Texture,
    pub(super) sampler: Sampler,
    /// `uv * scale + offset`.
    pub(super) scale: [f32; 2],
    pub(super) offset: [f32; 2],
    /// `texel * gain + base`.
    pub(super) gain: f32,
    pub(super) base: f32,
    /// One number instead of a colour.
    pub(super) is_scalar: bool,
    /// Without effect outside of 0..=1.
    pub(super) is_clamped: bool,
    /// For bump maps.
    pub(super) strength: f32,
}

/// What the vertices of a mesh say about its surface.
#[derive(Clone, Copy)]
pub(super) struct VertexFacts {
    /// Without texture coordinates no map is read.
    pub(super) has_uv: bool,
    pub(super) has_colors: bool,
    /// Some colour is translucent.
    pub(super) has_alpha: bool,
}

/// A texture that a material needs in a frame.
pub(super) struct Request<'a> {
    pub(super) slot: Slot,
    pub(super) map: &'a TextureRef,
    pub(super) usage: Usage,
    /// 1 - value.
    pub(super) is_inverted: bool,
}

/// What a frame needs of its materials.
#[derive(Clone, Copy)]
pub(super) struct Needs {
    shader: ShaderKind,
    alpha: AlphaMode,
    has_ambient_light: bool,
    normals: bool,
    color_space: ColorSpace,
}

impl Needs {
    pub(super) fn new(settings: &RenderSettings, has_ambient_light: bool) -> Self {
        let normals = settings.outputs.normal
            || matches!(settings.shader, ShaderKind::BlinnPhong | ShaderKind::Toon | ShaderKind::Normal);
        let (shader, alpha, color_space) = (settings.shader, settings.alpha, settings.color_space);
        Self { shader, alpha, has_ambient_light, normals, color_space }
    }

    fn is_lit(&self) -> bool {
        self.shader.is_lit()
    }

    /// The lighting model that is drawn.
    fn illumination(&self, material: &Material) -> Illumination {
        if self.is_lit() { material.illumination } else { Illumination::Color }
    }

    /// The textures that `material` needs.
    pub(super) fn requests<'m>(&self, material: &'m Material) -> Vec<Request<'m>> {
        match self.shader {
            ShaderKind::Tinyrenderer(lesson) => return stored_values(material, lesson),
            ShaderKind::Games101(shading) => return its_picture(material, shading).into_iter().collect(),
            _ => {}
        }
        let maps = &material.maps;
        let illumination = self.illumination(material);
        let is_lit = illumination != Illumination::Color;
        let shines = illumination == Illumination::Specular && has_highlight(material);
        let has_alpha = self.alpha != AlphaMode::Opaque;
        let space = self.color_space;
        let color = if has_alpha { Usage::Color(space) } else { Usage::OpaqueColor(space) };
        let scalar = |map: &'m Option<TextureRef>, default| {
            map.as_ref().map(|map| (map, Usage::Scalar(ScalarSource::new(map.options.channel, default))))
        };
        let opaque = |map: &'m Option<TextureRef>| map.as_ref().map(|map| (map, Usage::OpaqueColor(space)));
        let mut requests = Vec::new();
        let mut add = |slot, needed: bool, map: Option<(&'m TextureRef, Usage)>| {
            if let Some((map, usage)) = map.filter(|_| needed) {
                requests.push(Request { slot, map, usage, is_inverted: false });
            }
        };
        let shows_diffuse = self.shader.shows_materials() || self.shader == ShaderKind::MipLevel;
        add(Slot::Diffuse, shows_diffuse || has_alpha, maps.diffuse.as_ref().map(|map| (map, color)));
        // Toon shading knows one colour of a surface.
        let has_ambient = is_lit && self.has_ambient_light && self.shader != ShaderKind::Toon;
        add(Slot::Ambient, has_ambient && material.ambient != [0.0; 3], opaque(&maps.ambient));
        add(Slot::Specular, shines, opaque(&maps.specular));
        add(Slot::Exponent, shines, scalar(&maps.specular_exponent, ScalarSource::Luminance));
        let glows = self.is_lit() && material.emissive != [0.0; 3];
        add(Slot::Emissive, glows, opaque(&maps.emissive));
        add(Slot::Opacity, has_alpha, scalar(&maps.opacity, ScalarSource::AlphaOrLuminance));
        add(Slot::Normal, self.normals, maps.normal.as_ref().map(|map| (map, Usage::Vector)));
        let bumps = self.normals && maps.normal.is_none();
        add(Slot::Bump, bumps, maps.bump.as_ref().or(maps.displacement.as_ref()).map(|map| (map, height_usage(map))));
        if let Some((map, usage)) = scalar(&maps.transparency, ScalarSource::Luminance).filter(|_| has_alpha) {
            requests.push(Request { slot: Slot::Opacity, map, usage, is_inverted: true });
        }
        requests
    }
}

/// The maps of a lesson of tinyrenderer, which counts in bytes: as they are stored, without a transfer function. Gloss is
/// one channel: the blue one, the first in the files of the course.
fn stored_values(material: &Material, lesson: Lesson) -> Vec<Request<'_>> {
    let maps = &material.maps;
    let requests = [
        (Slot::Diffuse, lesson.has_colors(), &maps.diffuse, Usage::Vector),
        (Slot::Normal, lesson.has_normal_map(), &maps.normal, Usage::Vector),
        (Slot::Specular, lesson.has_colors(), &maps.specular, Usage::Scalar(ScalarSource::Blue)),
        (Slot::Emissive, lesson == Lesson::Glow, &maps.emissive, Usage::Vector),
    ];
    requests
        .into_iter()
        .filter(|(_, is_read, ..)| *is_read)
        .filter_map(|(slot, _, map, usage)| map.as_ref().map(|map| Request { slot, map, usage, is_inverted: false }))
        .collect()
}

/// The one picture that a shader of GAMES101 reads, as it is stored.
fn its_picture(material: &Material, shading: Homework3) -> Option<Request<'_>> {
    let maps = &material.maps;
    let (slot, map) = match shading {
        Homework3::Normal | Homework3::Phong => return None,
        Homework3::Texture => (Slot::Diffuse, maps.diffuse.as_ref()),
        Homework3::Bump | Homework3::Displacement => (Slot::Bump, maps.displacement.as_ref().or(maps.bump.as_ref())),
    };
    map.map(|map| Request { slot, map, usage: Usage::Vector, is_inverted: false })
}

/// A bump map with a channel of its own is heights for sure; one without is a normal map now and then, because some
/// exporters have no other statement for these.
fn height_usage(map: &TextureRef) -> Usage {
    match map.options.channel {
        None => Usage::Height,
        channel => Usage::Scalar(ScalarSource::new(channel, ScalarSource::Luminance)),
    }
}

/// The textures that the materials of a scene need.
pub(super) fn wanted(materials: &[Material], needs: &Needs) -> Vec<(TextureId, Usage)> {
    materials.iter().flat_map(|m| needs.requests(m)).map(|r| (r.map.texture, r.usage)).collect()
}

impl<'a> Surface<'a> {
    /// `material` on `vertices`, with the uploaded `textures`.
    pub(super) fn new(
        material: &Material,
        needs: &Needs,
        settings: &RenderSettings,
        textures: &'a TextureCache,
        vertices: VertexFacts,
    ) -> Self {
        let illumination = needs.illumination(material);
        let glows = needs.is_lit();
        let shines = illumination == Illumination::Specular && has_highlight(material);
        let space = needs.color_space;
        let mut surface = Self {
            ambient: from_display(space, material.ambient),
            diffuse: from_display(space, material.diffuse),
            specular: if shines { from_display(space, material.specular) } else { [0.0; 3] },
            emissive: if glows { from_display(space, material.emissive) } else { [0.0; 3] },
            exponent: material.specular_exponent,
            opacity: material.opacity,
            is_halo: material.is_halo,
            illumination,
            coverage: Coverage::Opaque,
            is_neutral: material.is_neutral() && !vertices.has_colors,
            maps: Vec::new(),
            opacity_maps: Vec::new(),
            normal: None,
            bump: None,
        };
        if vertices.has_colors && material.is_neutral() {
            // The colours of the vertices are all there is to say.
            (surface.ambient, surface.diffuse) = ([1.0; 3], [1.0; 3]);
        }
        let mut opacity = Opacity::Opaque;
        for request in needs.requests(material).iter().filter(|_| vertices.has_uv) {
            let Some(texture) = textures.get(request.map.texture, request.usage) else { continue };
            let its_opacity = textures.opacity(request.map.texture, request.usage);
            let map = MapUse::new(request, texture, settings);
            if textures.holds_normals(request.map.texture, request.usage) {
                surface.normal = Some(map);
                continue;
            }
            surface.add(map, its_opacity);
            if matches!(request.slot, Slot::Diffuse | Slot::Opacity) {
                opacity = opacity.max(its_opacity);
            }
        }
        let is_solid = material.opacity >= 0.999 && !vertices.has_alpha;
        surface.coverage = coverage(settings.alpha, is_solid, opacity);
        surface
    }

    /// The map of the diffuse colour.
    pub(super) fn diffuse_map(&self) -> Option<&MapUse<'a>> {
        self.maps.iter().find(|map| map.slot == Slot::Diffuse)
    }

    /// Whether the normal map was there when tangents were made.
    pub(super) fn has_tangents(&self) -> bool {
        self.normal.as_ref().is_some_and(|map| map.slot == Slot::Normal)
    }

    fn add(&mut self, map: MapUse<'a>, opacity: Opacity) {
        match map.slot {
            Slot::Normal => self.normal = Some(map),
            Slot::Bump => self.bump = Some(map),
            _ => {
                let holds_opacity = opacity != Opacity::Opaque || map.gain != 1.0 || map.base != 0.0;
                if map.slot == Slot::Opacity || (map.slot == Slot::Diffuse && holds_opacity) {
                    self.opacity_maps.push(map);
                }
                self.maps.push(map);
            }
        }
    }
}

fn coverage(mode: AlphaMode, is_solid: bool, maps: Opacity) -> Coverage {
    match mode {
        AlphaMode::Opaque => Coverage::Opaque,
        _ if is_solid && maps == Opacity::Opaque => Coverage::Opaque,
        AlphaMode::CutOut => Coverage::CutOut,
        AlphaMode::Auto if is_solid && maps == Opacity::Binary => Coverage::CutOut,
        AlphaMode::Auto | AlphaMode::Blend => Coverage::Blend,
    }
}

impl<'a> MapUse<'a> {
    fn new(request: &Request<'_>, texture: &'a Texture, settings: &RenderSettings) -> Self {
        let options = &request.map.options;
        let (scale, offset) = options.uv_transform();
        let sampling = settings.sampling;
        let is_smooth = options.blend_u || options.blend_v;
        let wrap = if options.clamp { Wrap::ClampToEdge } else { sampling.wrap.unwrap_or(Wrap::Repeat) };
        let sampler = Sampler {
            pixel: if is_smooth { sampling.pixel } else { PixelFilter::Nearest },
            level: sampling.level,
            max_anisotropy: sampling.max_anisotropy,
            wrap_u: wrap,
            wrap_v: wrap,
            lod_bias: sampling.lod_bias,
            ..Sampler::TRILINEAR
        };
        let (gain, base) =
            if request.is_inverted { (-options.gain, 1.0 - options.base) } else { (options.gain, options.base) };
        Self {
            slot: request.slot,
            texture,
            sampler,
            scale,
            offset,
            gain,
            base,
            is_scalar: matches!(request.usage, Usage::Scalar(_)),
            // Beyond its edge a map has no effect on factors; heights and normals go on as they are there.
            is_clamped: options.clamp && (request.slot as usize) < Slot::FACTORS,
            strength: options.bump_multiplier,
        }
    }
}

/// Whether the material has highlights. An exponent of zero would be none, but a veil over the whole lit side that ends
/// at a sharp line; exporters write it for surfaces that do not shine.
fn has_highlight(material: &Material) -> bool {
    material.specular != [0.0; 3] && material.specular_exponent > 0.0
}
