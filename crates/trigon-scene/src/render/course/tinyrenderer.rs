//! The scene of tinyrenderer: a camera, a light, pictures by the name of the model, and settings.
//!
//! In: models as loaded, without materials. Out: a scene that [`SceneRenderer`](crate::render::SceneRenderer) draws as
//! the program does. Dmitry Sokolov, "tinyrenderer" (2025), <https://github.com/ssloy/tinyrenderer>.

use super::pictures::Finder;
use crate::load::{Resolver, Warning};
use crate::math::vec3;
use crate::render::{AlphaMode, RenderSettings, ShaderKind};
use crate::scene::{Camera, Light, LightKind, Maps, Material, Projection, Scene, TextureRef};
use trigon::geometry::Cull;
use trigon::shade::texture::{LevelFilter, PixelFilter, Wrap};
use trigon::target::SamplePattern;
use trigon_image::color::srgb_to_linear;

/// The lessons of tinyrenderer that have shaders of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Lesson {
    /// Colours, tangent-space normals and gloss from pictures: what the program has become.
    Final,
    /// Diffuse light on flat triangles.
    Flat,
    /// The same with ambient light and highlights.
    Phong,
    /// Normals from a picture, in the coordinates of the model.
    ObjectNormals,
    /// Normals from a picture, in the coordinates of the surface.
    TangentNormals,
    /// As the final one, and parts that give off light.
    Glow,
    /// White, and darker where what is around is nearer to the eye.
    Occlusion,
    /// Three steps of diffuse light on a colour, by turns orange and grey for each model, with black outlines.
    Toon,
    /// Depths as greys: black at -1 and white at 1, the point that is looked at in the middle.
    Depth,
}

impl Lesson {
    /// All of them, the final one first.
    pub const ALL: [Self; 9] = [
        Self::Final,
        Self::Flat,
        Self::Phong,
        Self::ObjectNormals,
        Self::TangentNormals,
        Self::Glow,
        Self::Occlusion,
        Self::Toon,
        Self::Depth,
    ];

    /// The name of its shader.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Final => "tinyrenderer",
            Self::Flat => "tinyrenderer-flat",
            Self::Phong => "tinyrenderer-phong",
            Self::ObjectNormals => "tinyrenderer-object-normals",
            Self::TangentNormals => "tinyrenderer-tangent-normals",
            Self::Glow => "tinyrenderer-glow",
            Self::Occlusion => "tinyrenderer-ssao",
            Self::Toon => "tinyrenderer-toon",
            Self::Depth => "tinyrenderer-depth",
        }
    }

    /// What it shows, in a few words.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::Final => "tinyrenderer: colours, normals and gloss from pictures",
            Self::Flat => "tinyrenderer: diffuse light on flat triangles",
            Self::Phong => "tinyrenderer: flat triangles with highlights",
            Self::ObjectNormals => "tinyrenderer: normals in the model's coordinates",
            Self::TangentNormals => "tinyrenderer: normals in the surface's coordinates",
            Self::Glow => "tinyrenderer: parts give off light",
            Self::Occlusion => "tinyrenderer: white, dark where little light comes",
            Self::Toon => "tinyrenderer: three steps of light and outlines",
            Self::Depth => "tinyrenderer: depths as greys",
        }
    }

    /// Whether the diffuse map is drawn; the others show white.
    pub(in crate::render) fn has_colors(self) -> bool {
        matches!(self, Self::Final | Self::TangentNormals | Self::Glow)
    }

    /// Whether normals come from vertices; the others have one for each triangle.
    pub(in crate::render) fn is_bent(self) -> bool {
        !matches!(self, Self::Flat | Self::Phong)
    }

    /// Whether a map tilts these normals.
    pub(in crate::render) fn has_normal_map(self) -> bool {
        self.has_colors() || self == Self::ObjectNormals
    }

    /// The end of the name of its normal map.
    fn normal_map(self) -> &'static str {
        if self == Self::ObjectNormals { "_nm.tga" } else { "_nm_tangent.tga" }
    }
}

/// Where the program's camera stands, and what it looks at.
pub const EYE: [f64; 3] = [-1.0, 0.0, 2.0];

/// It samples at whole coordinates, the lower left corners of pixels.
pub const SHIFT_PX: [f32; 2] = [0.5; 2];

/// The direction to its light.
pub const TO_LIGHT: [f64; 3] = [1.0, 1.0, 1.0];

/// The camera at `eye` that looks at the origin.
///
/// The program keeps the origin where it is and divides by 1 - z/f, f being the distance of the eye: what lies in the
/// plane of the origin keeps its size. Its viewport leaves a margin of one sixteenth on every side. Together that is a
/// common perspective whose focal length is 7/8 f.
#[must_use]
pub fn camera(eye: [f64; 3], scene: &Scene) -> Camera {
    let fov_y = 2.0 * libm::atan(1.0 / (0.875 * vec3::length(eye)));
    let camera = Camera {
        eye,
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        projection: Projection::Perspective { fov_y },
        near: 0.1,
        far: 100.0,
    };
    camera.with_depth_range_of(&scene.bounding_box())
}

/// The light, from infinitely far away.
#[must_use]
pub fn light() -> Light {
    Light::new(LightKind::Directional { direction: vec3::scale(TO_LIGHT, -1.0) }, 1.0)
}

/// One sample per pixel, at its lower left corner; textures without filters, black outside; back faces dropped.
#[must_use]
pub fn settings(lesson: Lesson) -> RenderSettings {
    let mut settings = RenderSettings::new(800, 800);
    let [r, g, b] = [209, 195, 177].map(srgb_to_linear);
    settings.background = [r, g, b, 1.0];
    settings.shader = ShaderKind::Tinyrenderer(lesson);
    settings.samples = SamplePattern::CENTER;
    settings.shift_px = SHIFT_PX;
    settings.cull = Cull::Back;
    settings.alpha = AlphaMode::Opaque;
    settings.sampling.pixel = PixelFilter::Nearest;
    settings.sampling.level = LevelFilter::Zero;
    settings.sampling.wrap = Some(Wrap::Border([0.0; 4]));
    settings
}

/// Gives every material of `scene` the pictures that the program finds by the model's name: for `head.obj` the files
/// `head_diffuse.tga`, `head_nm_tangent.tga` (object-space normals: `head_nm.tga`), `head_spec.tga` and, for
/// [`Lesson::Glow`], `head_glow.tga`. `resolver` opens them; `model` is the name of the model as it knows it.
///
/// Maps that materials have already stay. Returns what was not found, cannot be read, or is above `max_bytes`. The program samples such pictures as 0; here the
/// model is drawn without: in the material's colour, with the normals of the vertices, without gloss and glow.
pub fn dress(scene: &mut Scene, model: &str, lesson: Lesson, resolver: &dyn Resolver, max_bytes: u64) -> Vec<Warning> {
    let stem = model.strip_suffix(".gz").unwrap_or(model);
    let stem = stem.rsplit_once('.').map_or(stem, |(stem, _)| stem);
    let has = |pick: fn(&Maps) -> &Option<TextureRef>| {
        !scene.materials.is_empty() && scene.materials.iter().all(|material| pick(&material.maps).is_some())
    };
    let [has_diffuse, has_normal] = [has(|maps| &maps.diffuse), has(|maps| &maps.normal)];
    let [has_specular, has_emissive] = [has(|maps| &maps.specular), has(|maps| &maps.emissive)];
    let mut finder = Finder::new(resolver, max_bytes);
    let mut find = |end: &str, is_needed: bool| {
        if is_needed { finder.find(scene, &format!("{stem}{end}")) } else { None }
    };
    let diffuse = find("_diffuse.tga", lesson.has_colors() && !has_diffuse);
    let normal = find(lesson.normal_map(), lesson.has_normal_map() && !has_normal);
    let specular = find("_spec.tga", lesson.has_colors() && !has_specular);
    let emissive = find("_glow.tga", lesson == Lesson::Glow && !has_emissive);
    if scene.materials.is_empty() {
        scene.materials.push(Material::default());
    }
    for material in &mut scene.materials {
        let maps = &mut material.maps;
        maps.diffuse = maps.diffuse.take().or_else(|| diffuse.clone());
        maps.normal = maps.normal.take().or_else(|| normal.clone());
        maps.specular = maps.specular.take().or_else(|| specular.clone());
        maps.emissive = maps.emissive.take().or_else(|| emissive.clone());
    }
    finder.into_warnings()
}
