//! The scenes of GAMES101's homeworks 2 and 3: two triangles, and a model under two lights.
//!
//! In: nothing, or a model as loaded. Out: a scene, a camera and settings that
//! [`SceneRenderer`](crate::render::SceneRenderer) draws as the program does. Lingqi Yan, "GAMES101: Introduction to
//! Computer Graphics" (2020), <https://sites.cs.ucsb.edu/~lingqi/teaching/games101.html>.

use super::pictures::Finder;
use crate::load::{Resolver, Warning};
use crate::math::Mat4;
use crate::math::vec3::{self, Vec3};
use crate::render::{AlphaMode, RenderSettings};
use crate::scene::{
    Camera, Illumination, Instance, Light, LightKind, Material, MaterialId, Mesh, MeshId, Part, Projection, Scene,
    Submesh,
};
use trigon::shade::texture::{LevelFilter, PixelFilter, Wrap};
use trigon::target::{ColorSpace, SamplePattern};

/// The fragment shaders of homework 3.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Homework3 {
    /// Normals as colours.
    Normal,
    /// Blinn-Phong with colours from a picture.
    Texture,
    /// Blinn-Phong in one colour.
    Phong,
    /// Normals tilted by a picture of heights, as colours.
    Bump,
    /// The same normals, and points moved by the heights, under Blinn-Phong: the silhouette stays.
    Displacement,
}

impl Homework3 {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Normal, Self::Texture, Self::Phong, Self::Bump, Self::Displacement];

    /// The name of its shader.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Normal => "games101-normal",
            Self::Texture => "games101-texture",
            Self::Phong => "games101-phong",
            Self::Bump => "games101-bump",
            Self::Displacement => "games101-displacement",
        }
    }

    /// What it shows, in a few words.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::Normal => "GAMES101: view-space normals as colours",
            Self::Texture => "GAMES101: Blinn-Phong with a colour map",
            Self::Phong => "GAMES101: Blinn-Phong in one colour",
            Self::Bump => "GAMES101: normals tilted by a height map",
            Self::Displacement => "GAMES101: Blinn-Phong with these normals",
        }
    }

    /// Whether it reads a picture of heights.
    #[must_use]
    pub fn has_relief(self) -> bool {
        matches!(self, Self::Bump | Self::Displacement)
    }
}

/// How high the relief of [`Homework3::Bump`] and [`Homework3::Displacement`] is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Relief {
    /// `kh`: times `kn`, the slope for one unit of height per texel; heights go from 0 to 441.
    pub height: f32,
    /// `kn`: how far one unit of height moves a point.
    pub scale: f32,
}

impl Default for Relief {
    fn default() -> Self {
        Self { height: 0.2, scale: 0.1 }
    }
}

/// Where the camera of homework 2 stands.
pub const EYE_2: Vec3 = [0.0, 0.0, 5.0];

/// Where the camera of homework 3 stands.
pub const EYE_3: Vec3 = [0.0, 0.0, 10.0];

/// The angle in degrees that homework 3 turns its model about the y axis by, after scaling it.
pub const ANGLE: f64 = 140.0;

/// The factor that homework 3 scales its model by.
pub const SCALE: f64 = 2.5;

/// The camera at `eye`, looking along -z.
#[must_use]
pub fn camera(eye: Vec3) -> Camera {
    Camera {
        eye,
        target: vec3::sub(eye, [0.0, 0.0, 1.0]),
        up: [0.0, 1.0, 0.0],
        projection: Projection::Perspective { fov_y: 45_f64.to_radians() },
        near: 0.1,
        far: 50.0,
    }
}

/// One sample in the middle of each pixel, colours without a transfer function, textures without filters, the colour of
/// the edge outside of them, on black.
#[must_use]
pub fn settings() -> RenderSettings {
    let mut settings = RenderSettings::new(700, 700);
    settings.background = [0.0, 0.0, 0.0, 1.0];
    settings.samples = SamplePattern::CENTER;
    settings.color_space = ColorSpace::Encoded;
    settings.alpha = AlphaMode::Opaque;
    settings.sampling.pixel = PixelFilter::Nearest;
    settings.sampling.level = LevelFilter::Zero;
    settings.sampling.wrap = Some(Wrap::ClampToEdge);
    settings
}

/// The two triangles of homework 2, for [`ShaderKind::Unlit`](crate::render::ShaderKind): the green one is the nearer.
#[must_use]
pub fn triangles() -> Scene {
    const CORNERS: [[[f32; 3]; 3]; 2] = [
        [[2.0, 0.0, -2.0], [0.0, 2.0, -2.0], [-2.0, 0.0, -2.0]],
        [[3.5, -1.0, -5.0], [2.5, 1.5, -5.0], [-1.0, 0.5, -5.0]],
    ];
    const COLORS: [[u8; 3]; 2] = [[217, 238, 185], [185, 217, 238]];
    let mut mesh = Mesh { positions: CORNERS.as_flattened().to_vec(), parts: vec![Part::default()], ..Mesh::default() };
    let mut scene = Scene::default();
    for (number, color) in (0..).zip(COLORS) {
        let first = mesh.triangles.len();
        mesh.triangles.push([0, 1, 2].map(|corner| 3 * number + corner));
        mesh.submeshes.push(Submesh { triangles: first..first + 1, ..Submesh::new(0, MaterialId(number)) });
        scene.materials.push(Material { diffuse: display(color), ..Material::default() });
    }
    scene.meshes.push(mesh);
    scene.instances.push(Instance {
        mesh: MeshId(0),
        world_from_model: Mat4::IDENTITY,
        name: "two triangles".to_owned(),
    });
    scene
}

/// The lights of homework 3: two points in the coordinates of the camera, and 10 units of ambient light for each.
#[must_use]
pub fn lights(camera: &Camera) -> Vec<Light> {
    let [right, up, forward] = camera.right_up_forward();
    let place = |[x, y, z]: Vec3| {
        let sideways = vec3::add(vec3::scale(right, x), vec3::scale(up, y));
        vec3::add(camera.eye, vec3::sub(sideways, vec3::scale(forward, z)))
    };
    let point = |position| Light::new(LightKind::Point { position: place(position) }, 500.0);
    vec![Light::new(LightKind::Ambient, 20.0), point([20.0, 20.0, 20.0]), point([-20.0, 20.0, 0.0])]
}

/// Gives every material of `scene` the constants of homework 3, and the picture that `shading` reads: for `spot.obj` or
/// `spot_triangulated.obj` that is `spot_texture.png`, or `hmap.jpg` for heights. `resolver` opens them; `model` is the
/// name of the model as it knows it.
///
/// Maps that materials have already stay. Returns what was not found, cannot be read, or is above `max_bytes`; it is
/// drawn in one colour, or flat.
pub fn dress(
    scene: &mut Scene,
    model: &str,
    shading: Homework3,
    resolver: &dyn Resolver,
    max_bytes: u64,
) -> Vec<Warning> {
    if scene.materials.is_empty() {
        scene.materials.push(Material::default());
    }
    for material in &mut scene.materials {
        (material.ambient, material.diffuse) = ([0.005; 3], display([148, 121, 92]));
        (material.specular, material.specular_exponent) = ([0.7937; 3], 150.0);
        (material.emissive, material.opacity) = ([0.0; 3], 1.0);
        material.illumination = Illumination::Specular;
    }
    let mut finder = Finder::new(resolver, max_bytes);
    let stem = model.split(['.', '_']).next().unwrap_or(model);
    if shading == Homework3::Texture && scene.materials.iter().any(|m| m.maps.diffuse.is_none()) {
        let map = finder.find(scene, &format!("{stem}_texture.png"));
        for material in &mut scene.materials {
            material.maps.diffuse = material.maps.diffuse.take().or_else(|| map.clone());
        }
    }
    let has_heights = |m: &Material| m.maps.displacement.is_some() || m.maps.bump.is_some();
    if shading.has_relief() && !scene.materials.iter().all(has_heights) {
        let map = finder.find(scene, "hmap.jpg");
        for material in scene.materials.iter_mut().filter(|material| !has_heights(material)) {
            material.maps.displacement.clone_from(&map);
        }
    }
    finder.into_warnings()
}

fn display(color: [u8; 3]) -> [f32; 3] {
    color.map(|code| f32::from(code) / 255.0)
}
