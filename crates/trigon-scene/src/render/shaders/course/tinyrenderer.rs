//! tinyrenderer: the Phong reflection of its last lesson, and the lessons on the way there.
//!
//! With n the unit normal, l the unit vector to the light and v the direction against the view, the same everywhere:
//!
//! ```text
//! r      = 2 n (n . l) - l                            l mirrored at the surface
//! colour = texel * (a + d max(0, n . l) + (s + m gloss) max(0, r . v)^35)
//! ```
//!
//! in bytes as they are stored, without a transfer function, cut to 255 and rounded down. The lessons differ in the
//! weights a, d, s, m ([`Weights`]) and in where n comes from; three have formulas of their own:
//!
//! ```text
//! ssao   255 o                                        o: how open the pixel is
//! toon   colour * (1, 0.66 or 0.33),                  as 0.15 + max(0, n . l) is above 0.66, above 0.33, or not
//! depth  (z + 1) / 2 * 255                            z: as the program's depth buffer has it
//! ```
//!
//! Dmitry Sokolov, "tinyrenderer" (2025),
//! <https://github.com/ssloy/tinyrenderer>; Bui Tuong Phong, "Illumination for Computer Generated Pictures", 1975.

use crate::render::course::tinyrenderer::Lesson;
use crate::render::frame::FrameUniforms;
use crate::render::lights::Source;
use crate::render::material::{MapUse, Slot, Surface};
use crate::render::shaders::display::displayed;
use crate::render::shaders::maps::Footprint;
use crate::render::shaders::obstacles::{Effects, Obstacles};
use crate::render::shaders::point::SurfacePoint;
use crate::render::shaders::vertex::{MeshView, Plain, PlainVarying};
use crate::render::working_space::to_display;
use trigon::lanes::{F32, Lanes, Rgba, U32, Vec2, Vec3};
use trigon::math::powi;
use trigon::shade::{Fragment, Shader, SurfaceLanes, Vertex};

/// Draws one material on one mesh.
pub(in crate::render) struct Tinyrenderer<'a> {
    frame: &'a FrameUniforms,
    mesh: MeshView<'a>,
    surface: &'a Surface<'a>,
    lesson: Lesson,
    weights: Weights,
    /// Stored values where there is no diffuse map.
    color: [f32; 3],
}

/// The colours of models in the toon lesson, by turns: the first is cut to 255 only after its step.
const TOON_COLORS: [[f32; 3]; 2] =
    [[147.0 * 4.0 / 255.0, 56.0 * 4.0 / 255.0, 22.0 * 4.0 / 255.0], [88.0 / 255.0, 98.0 / 255.0, 123.0 / 255.0]];

/// The terms of the formula.
struct Weights {
    ambient: f32,
    diffuse: f32,
    specular: f32,
    /// Added to `specular`, times the gloss map.
    gloss: f32,
}

impl Weights {
    fn of(lesson: Lesson) -> Self {
        let [ambient, diffuse, specular, gloss] = match lesson {
            Lesson::Final | Lesson::Glow => [0.4, 1.0, 0.5, 2.0],
            Lesson::TangentNormals => [0.4, 1.0, 0.0, 3.0],
            Lesson::Phong | Lesson::ObjectNormals => [0.3, 0.4, 0.9, 0.0],
            Lesson::Flat => [30.0 / 255.0, 1.0, 0.0, 0.0],
            Lesson::Toon => [0.15, 1.0, 0.0, 0.0],
            Lesson::Occlusion | Lesson::Depth => [1.0, 0.0, 0.0, 0.0],
        };
        Self { ambient, diffuse, specular, gloss }
    }
}

/// A colour in shadow is made darker until it is no longer than this, as a vector of bytes.
const LONGEST_IN_SHADOW: f32 = 80.0;

impl<'a> Tinyrenderer<'a> {
    /// `model` is the number of the model among those of the scene.
    pub(in crate::render) fn new(
        frame: &'a FrameUniforms,
        mesh: MeshView<'a>,
        surface: &'a Surface<'a>,
        lesson: Lesson,
        model: usize,
    ) -> Self {
        let color = match lesson {
            Lesson::Toon => TOON_COLORS[model % TOON_COLORS.len()],
            _ if lesson.has_colors() => to_display(frame.color_space, surface.diffuse),
            _ => [1.0; 3],
        };
        Self { frame, mesh, surface, lesson, weights: Weights::of(lesson), color }
    }

    /// The colour of sixteen points, which is stored as the bytes of the formula.
    #[inline(never)]
    fn shade<L: Lanes>(&self, l: L, point: &SurfacePoint<L>, pixel: Vec2<L>) -> Rgba<L> {
        l.vectorize(
            #[inline(always)]
            || self.shade_inline(l, point, pixel),
        )
    }

    #[inline(always)]
    fn shade_inline<L: Lanes>(&self, l: L, point: &SurfacePoint<L>, pixel: Vec2<L>) -> Rgba<L> {
        let n = self.normal(l, point);
        let texel = self.texel(l, Slot::Diffuse, &point.footprint, self.color);
        let gloss = self.texel(l, Slot::Specular, &point.footprint, [0.0; 3]).x;
        let effects = Effects::new(l, self.frame.occlusion.as_ref(), pixel, point);
        let mut light = effects.dim(l, l.vec3([self.weights.ambient; 3])).x;
        let mut shown = l.f32(1.0);
        l.note_topic("surface, in world space", None);
        l.note("unit normal n", n);
        l.note("texel", texel);
        l.note("gloss", gloss);
        l.note("ambient a", light);
        if let Some(source) = self.frame.lighting.sources.first() {
            let to_light = to_light(l, source, point);
            let cosine = n.dot(to_light);
            let mirrored = n * (cosine * 2.0) - to_light;
            let towards_viewer = mirrored.dot(l.vec3(self.frame.against_view)).max(0.0);
            let diffuse = cosine.max(0.0) * self.weights.diffuse;
            let weight = gloss * self.weights.gloss + self.weights.specular;
            let highlight = powi(towards_viewer, 35);
            light += diffuse;
            light += weight * highlight;
            l.note_topic("light", Some(0));
            l.note("unit vector to the light l", to_light);
            l.note("n.l", cosine);
            l.note("diffuse, d max(0, n.l)", diffuse);
            l.note("l mirrored, r", mirrored);
            l.note("max(0, r.v)", towards_viewer);
            l.note("its power of 35", highlight);
            l.note("weight, s + m gloss", weight);
            // A shadow darkens both sides of a surface.
            shown = effects.pass(l, source, point, to_light, l.f32(1.0), shown);
        }
        l.note_topic("sum", None);
        l.note("of all terms", light);
        match self.lesson {
            Lesson::Toon => {
                light = stepped(l, light);
                l.note("its step", light);
            }
            Lesson::Depth => {
                let depth = self.frame.depth_scale.at(l, point.position);
                light = ((depth + 1.0) * 0.5).max(0.0);
                l.note("depth z", depth);
            }
            _ => {}
        }
        let mut bytes = (texel * 255.0) * light;
        l.note("times the texel, in bytes", bytes);
        if self.lesson == Lesson::Glow {
            bytes += self.texel(l, Slot::Emissive, &point.footprint, [0.0; 3]) * 255.0;
        }
        let bytes = Vec3 { x: bytes.x.min(255.0), y: bytes.y.min(255.0), z: bytes.z.min(255.0) };
        let length = bytes.length().max(LONGEST_IN_SHADOW);
        let bytes = (bytes * (LONGEST_IN_SHADOW / length)).mix(bytes, shown);
        let whole = Vec3 { x: bytes.x.floor(), y: bytes.y.floor(), z: bytes.z.floor() };
        l.note_topic("colour", None);
        l.note("bytes", whole);
        displayed(whole * (1.0 / 255.0), self.frame.color_space)
    }

    /// The unit normal in world space.
    #[inline(always)]
    fn normal<L: Lanes>(&self, l: L, point: &SurfacePoint<L>) -> Vec3<L> {
        let face = unit(point.plane());
        if !self.lesson.is_bent() {
            return face;
        }
        let length_squared = point.normal.dot(point.normal);
        let smooth = length_squared.gt(f32::MIN_POSITIVE).select(unit(point.normal), face);
        let Some(map) = &self.surface.normal else { return smooth };
        let m = map.sample(l, &point.footprint).rgb() * 2.0 - l.vec3([1.0; 3]);
        if self.lesson == Lesson::ObjectNormals {
            return unit(self.mesh.world_normal(m));
        }
        let [tangent, bitangent] = tangents(point);
        unit((tangent * m.x + bitangent * m.y) + smooth * m.z)
    }

    /// What the map of `slot` holds, as stored, 0 to 1; `or` where there is none.
    #[inline(always)]
    fn texel<L: Lanes>(&self, l: L, slot: Slot, footprint: &Footprint<L>, or: [f32; 3]) -> Vec3<L> {
        match map_of(&self.surface.maps, slot) {
            Some(map) => map.sample(l, footprint).rgb(),
            None => l.vec3(or),
        }
    }
}

fn map_of<'m, 'a>(maps: &'m [MapUse<'a>], slot: Slot) -> Option<&'m MapUse<'a>> {
    maps.iter().find(|map| map.slot == slot)
}

/// The unit vectors along which u and v grow on the surface.
///
/// Position is an affine function of (u, v) on a triangle, so its changes per pixel are `p_x = T u_x + B v_x` and
/// `p_y = T u_y + B v_y`: two equations for T and B. The course solves the same ones for two edges of the triangle.
#[inline(always)]
fn tangents<L: Lanes>(point: &SurfacePoint<L>) -> [Vec3<L>; 2] {
    let (uv_x, uv_y) = (point.footprint.dx, point.footprint.dy);
    let determinant = uv_x.x * uv_y.y - uv_y.x * uv_x.y;
    // Its size is lost when both are made unit vectors; its sign is not.
    let is_mirrored = determinant.lt(0.0);
    let tangent = point.dx * uv_y.y - point.dy * uv_x.y;
    let bitangent = point.dy * uv_x.x - point.dx * uv_y.x;
    [unit(is_mirrored.select(-tangent, tangent)), unit(is_mirrored.select(-bitangent, bitangent))]
}

/// Three steps of light.
#[inline(always)]
fn stepped<L: Lanes>(l: L, light: F32<L>) -> F32<L> {
    let lit = light.gt(0.33).select(l.f32(0.66), l.f32(0.33));
    light.gt(0.66).select(l.f32(1.0), lit)
}

/// The unit vector to the light.
#[inline(always)]
fn to_light<L: Lanes>(l: L, source: &Source, point: &SurfacePoint<L>) -> Vec3<L> {
    let place = l.vec3(source.place);
    if source.is_directional { place } else { unit(place - point.position) }
}

/// A unit vector, or zero where there is no direction.
#[inline(always)]
fn unit<L: Lanes>(v: Vec3<L>) -> Vec3<L> {
    // Scaled first: derivatives per pixel are small, and their squares would vanish.
    let largest = v.x.abs().max(v.y.abs()).max(v.z.abs()).max(f32::MIN_POSITIVE);
    let v = v * (1.0 / largest);
    v * (1.0 / v.dot(v).max(f32::MIN_POSITIVE).sqrt())
}

impl Shader for Tinyrenderer<'_> {
    type Varying<L: Lanes> = PlainVarying<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, PlainVarying<L>> {
        self.mesh.vertex::<L, Plain>(l, index)
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, PlainVarying<L>>) -> Rgba<L> {
        self.shade(l, &SurfacePoint::new(l, self.frame, f), f.pixel)
    }

    #[inline(always)]
    fn surface<L: Lanes>(&self, l: L, f: &Fragment<L, PlainVarying<L>>) -> SurfaceLanes<L> {
        let point = SurfacePoint::new(l, self.frame, f);
        SurfaceLanes { position: point.position, normal: self.normal(l, &point), uv: f.uv }
    }
}
