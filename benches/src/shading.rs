//! The scenes' shaders: textured and lit, lit, and textured.
//!
//! Blinn-Phong per pixel, in linear light, with one point light and one directional light. Surfaces are lit on the side
//! that faces the eye.

use crate::scene::Mesh;
use trigon::lanes::{F32, Lanes, Mat4, Rgba, U32, Vec3};
use trigon::shade::texture::{Sampler, Texture};
use trigon::shade::{Fragment, Shader, Vertex};

/// Reflectance of untextured surfaces.
const GREY: [f32; 3] = [0.8; 3];
/// Light from everywhere.
const AMBIENT: f32 = 0.06;
/// Specular reflectance.
const SPECULAR: f32 = 0.3;

/// Where the vertices are and how they reach clip space.
#[derive(Clone, Copy, Debug)]
pub struct Placement<'a> {
    /// World-space vertices.
    pub mesh: &'a Mesh,
    /// The camera.
    pub clip_from_world: Mat4,
}

/// Lights and the eye, in world space.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Lighting {
    /// The camera's position.
    pub eye: [f32; 3],
    /// The point light's position.
    pub point: [f32; 3],
    /// The point light's colour.
    pub point_color: [f32; 3],
    /// The point light's colour is divided by 1 + falloff * distance^2.
    pub falloff: f32,
    /// Unit vector towards the directional light.
    pub sun: [f32; 3],
    /// The directional light's colour.
    pub sun_color: [f32; 3],
}

trigon::varying! {
    /// A point of a textured, lit surface.
    pub struct TexturedPoint {
        /// In world space.
        position: Vec3,
        /// Of any length.
        normal: Vec3,
        /// Texture coordinates.
        uv: Vec2,
    }
}

trigon::varying! {
    /// A point of a lit surface.
    pub struct LitPoint {
        /// In world space.
        position: Vec3,
        /// Of any length.
        normal: Vec3,
    }
}

/// Texture and lights.
pub struct TexturedLit<'a> {
    /// The vertices.
    pub placement: Placement<'a>,
    /// The lights.
    pub lighting: Lighting,
    /// Reflectance.
    pub texture: &'a Texture,
}

/// Lights on grey.
pub struct Lit<'a> {
    /// The vertices.
    pub placement: Placement<'a>,
    /// The lights.
    pub lighting: Lighting,
}

/// The texture as it is.
pub struct Textured<'a> {
    /// The vertices.
    pub placement: Placement<'a>,
    /// Colour.
    pub texture: &'a Texture,
}

impl Shader for TexturedLit<'_> {
    type Varying<L: Lanes> = TexturedPoint<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, TexturedPoint<L>> {
        let Placement { mesh, clip_from_world } = self.placement;
        let position = index.gather_vec3(&mesh.positions);
        let (normal, uv) = (index.gather_vec3(&mesh.normals), index.gather_vec2(&mesh.uvs));
        let varying = TexturedPoint { position, normal, uv };
        Vertex { position: clip_from_world.transform_point(l, position), varying }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, TexturedPoint<L>>) -> Rgba<L> {
        let texel = self.texture.sample(l, &Sampler::TRILINEAR, f.uv, f.dx.uv, f.dy.uv);
        self.lighting.shade(l, f.position, f.normal, texel.rgb()).rgba(1.0)
    }
}

impl Shader for Lit<'_> {
    type Varying<L: Lanes> = LitPoint<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, LitPoint<L>> {
        let Placement { mesh, clip_from_world } = self.placement;
        let position = index.gather_vec3(&mesh.positions);
        let varying = LitPoint { position, normal: index.gather_vec3(&mesh.normals) };
        Vertex { position: clip_from_world.transform_point(l, position), varying }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, LitPoint<L>>) -> Rgba<L> {
        self.lighting.shade(l, f.position, f.normal, l.vec3(GREY)).rgba(1.0)
    }
}

impl Shader for Textured<'_> {
    type Varying<L: Lanes> = trigon::lanes::Vec2<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, Self::Varying<L>> {
        let Placement { mesh, clip_from_world } = self.placement;
        let position = clip_from_world.transform_point(l, index.gather_vec3(&mesh.positions));
        Vertex { position, varying: index.gather_vec2(&mesh.uvs) }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, Self::Varying<L>>) -> Rgba<L> {
        self.texture.sample(l, &Sampler::TRILINEAR, f.varying, f.dx, f.dy).rgb().rgba(1.0)
    }
}

impl Lighting {
    /// Light that reaches the eye from sixteen surface points.
    #[inline(always)]
    fn shade<L: Lanes>(&self, l: L, position: Vec3<L>, normal: Vec3<L>, albedo: Vec3<L>) -> Vec3<L> {
        let to_eye = (l.vec3(self.eye) - position).normalize();
        let outward = normal.normalize();
        let normal = outward.dot(to_eye).lt(0.0).select(-outward, outward);
        let mut color = albedo * AMBIENT;

        let to_point = l.vec3(self.point) - position;
        let squared = to_point.dot(to_point);
        let to_light = to_point * (1.0 / squared.sqrt());
        let cosine = normal.dot(to_light);
        let is_lit = cosine.gt(0.0);
        if is_lit.any() {
            let strength = is_lit.select(1.0 / (1.0 + squared * self.falloff), l.f32(0.0));
            let reflected = reflect(normal, to_light, to_eye, cosine, albedo);
            color += l.vec3(self.point_color) * reflected * strength;
        }

        let sun = l.vec3(self.sun);
        let cosine = normal.dot(sun);
        let is_lit = cosine.gt(0.0);
        if is_lit.any() {
            let strength = is_lit.select(l.f32(1.0), l.f32(0.0));
            color += l.vec3(self.sun_color) * reflect(normal, sun, to_eye, cosine, albedo) * strength;
        }
        color
    }
}

/// Diffuse and specular reflection, by channel: Blinn, "Models of Light Reflection for Computer Synthesized Pictures",
/// 1977, with an exponent of 32.
#[inline(always)]
fn reflect<L: Lanes>(normal: Vec3<L>, to_light: Vec3<L>, to_eye: Vec3<L>, cosine: F32<L>, albedo: Vec3<L>) -> Vec3<L> {
    let halfway = to_light + to_eye;
    // The square of the cosine needs no root: (n.h)^2 / h.h.
    let along = normal.dot(halfway).max(0.0);
    let squared = (along * along) / halfway.dot(halfway).max(f32::MIN_POSITIVE);
    let fourth = squared * squared;
    let eighth = fourth * fourth;
    let sixteenth = eighth * eighth;
    let specular = (sixteenth * sixteenth) * SPECULAR;
    let reflected = albedo * cosine;
    Vec3 { x: reflected.x + specular, y: reflected.y + specular, z: reflected.z + specular }
}
