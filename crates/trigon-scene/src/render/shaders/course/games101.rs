//! GAMES101, homework 3: its five fragment shaders.
//!
//! With n the unit normal and p the point in view space, where the camera looks along -z:
//!
//! ```text
//! normal        (n + 1) / 2
//! phong         sum over lights: ka Ia + kd I/r^2 max(0, n . l) + ks I/r^2 max(0, n . h)^e,   h = unit(l + v)
//! texture       the same, kd from a picture
//! bump          n' = unit(t dU + b dV + n),   dU = -kh kn (H(u + 1/w, v) - H(u, v)),   dV alike along v
//! displacement  phong at p + kn n H(u, v) with n'
//! ```
//!
//! in display values, without a transfer function. H is the length of a texel as a vector of bytes, and
//! `t = (x y / q, q, z y / q)` with `q = sqrt(x^2 + z^2)` of the normal (x, y, z), `b = n x t`: a frame that turns with
//! the normal and knows nothing of u and v. v is the direction to a viewer who stands 10 units behind the camera, because
//! the program takes the position of its camera, (0, 0, 10), for one in view space. Lingqi Yan, "GAMES101" (2020),
//! homework 3; Jim Blinn, "Models of Light Reflection for Computer Synthesized Pictures", 1977.

use crate::render::course::games101::Homework3;
use crate::render::frame::FrameUniforms;
use crate::render::material::Surface;
use crate::render::shaders::display::displayed;
use crate::render::shaders::maps::Footprint;
use crate::render::shaders::obstacles::{Effects, Obstacles};
use crate::render::shaders::point::SurfacePoint;
use crate::render::shaders::vertex::{MeshView, Plain, PlainVarying};
use crate::render::working_space::to_display;
use trigon::lanes::{F32, Lanes, Mat4, Rgba, U32, Vec2, Vec3};
use trigon::math::{exp2, log2};
use trigon::shade::{Fragment, Shader, SurfaceLanes, Vertex};

/// Draws one material on one mesh.
pub(in crate::render) struct Games101<'a> {
    frame: &'a FrameUniforms,
    mesh: MeshView<'a>,
    surface: &'a Surface<'a>,
    shading: Homework3,
    /// The inverse of the view: directions of the camera in the world.
    world_from_view: Mat4,
    /// Where highlights are seen from, in world space.
    viewer: [f32; 3],
    /// Display values of the material.
    ambient: [f32; 3],
    diffuse: [f32; 3],
    specular: [f32; 3],
}

/// How far behind the camera highlights are seen from.
const VIEWER_BEHIND_CAMERA: f32 = 10.0;

impl<'a> Games101<'a> {
    pub(in crate::render) fn new(
        frame: &'a FrameUniforms,
        mesh: MeshView<'a>,
        surface: &'a Surface<'a>,
        shading: Homework3,
    ) -> Self {
        let display = |color| to_display(frame.color_space, color);
        let columns = &frame.view_from_world.columns;
        let [right, up, back] = [0, 1, 2].map(|row| [columns[0][row], columns[1][row], columns[2][row], 0.0]);
        let origin = columns[3];
        let viewer = [-origin[0], -origin[1], VIEWER_BEHIND_CAMERA - origin[2]];
        Self {
            frame,
            mesh,
            surface,
            shading,
            world_from_view: Mat4 { columns: [right, up, back, [0.0, 0.0, 0.0, 1.0]] },
            viewer: [0, 1, 2].map(|i| (right[i] * viewer[0] + up[i] * viewer[1]) + back[i] * viewer[2]),
            ambient: display(surface.ambient),
            diffuse: display(surface.diffuse),
            specular: display(surface.specular),
        }
    }

    /// The colour of sixteen points.
    #[inline(never)]
    fn shade<L: Lanes>(&self, l: L, point: &SurfacePoint<L>, pixel: Vec2<L>) -> Rgba<L> {
        l.vectorize(
            #[inline(always)]
            || self.shade_inline(l, point, pixel),
        )
    }

    #[inline(always)]
    fn shade_inline<L: Lanes>(&self, l: L, point: &SurfacePoint<L>, pixel: Vec2<L>) -> Rgba<L> {
        let n = self.smooth_normal(point);
        let color = match self.shading {
            Homework3::Normal => self.to_view(n) * 0.5 + l.vec3([0.5; 3]),
            Homework3::Phong => self.reflect(l, point, pixel, point.position, n, l.vec3(self.diffuse)),
            Homework3::Texture => {
                let texel = match self.surface.diffuse_map() {
                    Some(map) => map.sample(l, &point.footprint).rgb(),
                    None => l.vec3(self.diffuse),
                };
                self.reflect(l, point, pixel, point.position, n, texel)
            }
            Homework3::Bump => self.to_view(self.bumped(l, point, n)),
            Homework3::Displacement => {
                let moved = point.position + n * (self.height(l, &point.footprint) * self.frame.relief.scale);
                self.reflect(l, point, pixel, moved, self.bumped(l, point, n), l.vec3(self.diffuse))
            }
        };
        l.note_topic("colour", None);
        l.note("of the formula", color);
        displayed(color, self.frame.color_space)
    }

    /// Light that the surface sends from `place` to the viewer. All of it is in world space: lengths and angles are
    /// those of view space.
    #[inline(always)]
    fn reflect<L: Lanes>(
        &self,
        l: L,
        point: &SurfacePoint<L>,
        pixel: Vec2<L>,
        place: Vec3<L>,
        n: Vec3<L>,
        diffuse: Vec3<L>,
    ) -> Vec3<L> {
        let effects = Effects::new(l, self.frame.occlusion.as_ref(), pixel, point);
        let lighting = &self.frame.lighting;
        let mut sum = l.vec3(self.ambient) * effects.dim(l, l.vec3(lighting.ambient));
        let to_viewer = (l.vec3(self.viewer) - place).normalize();
        l.note_topic("surface, in world space", None);
        l.note("place that is lit", place);
        l.note("unit normal N", n);
        l.note("kd, diffuse reflectance", diffuse);
        l.note("unit vector to the viewer V", to_viewer);
        l.note("ambient term", sum);
        for (number, source) in (0..).zip(&lighting.sources) {
            let (to_light, strength) = source.reach(l, place);
            l.note_topic("light", Some(number));
            l.note("unit vector to the light L", to_light);
            let cosine = n.dot(to_light);
            // The highlight of the course counts on both sides of a surface, and so does a shadow.
            let strength = effects.pass(l, source, point, to_light, l.f32(1.0), strength);
            let cosine_of_half = n.dot((to_light + to_viewer).normalize());
            let highlight = exp2(log2(cosine_of_half.clamp(0.0, 1.0)) * self.surface.exponent);
            let light = l.vec3(source.color) * strength;
            let diffuse_term = (diffuse * light) * cosine.max(0.0);
            let specular_term = (l.vec3(self.specular) * light) * highlight;
            sum += diffuse_term;
            sum += specular_term;
            l.note("I/r^2, light at the surface", light);
            l.note("N.L", cosine);
            l.note("diffuse term", diffuse_term);
            l.note("N.H", cosine_of_half);
            l.note("its power of the exponent", highlight);
            l.note("specular term", specular_term);
        }
        l.note_topic("sum", None);
        l.note("of all terms", sum);
        sum
    }

    /// The unit normal between those of the vertices, or that of the triangle where there are none. World space.
    #[inline(always)]
    fn smooth_normal<L: Lanes>(&self, point: &SurfacePoint<L>) -> Vec3<L> {
        let is_usable = point.normal.dot(point.normal).gt(f32::MIN_POSITIVE);
        is_usable.select(point.normal, point.plane()).normalize()
    }

    /// `normal`, tilted by the slope of the heights. World space.
    #[inline(always)]
    fn bumped<L: Lanes>(&self, l: L, point: &SurfacePoint<L>, normal: Vec3<L>) -> Vec3<L> {
        let Some(map) = &self.surface.bump else { return normal };
        let n = self.to_view(normal);
        let q = (n.x * n.x + n.z * n.z).sqrt().max(f32::MIN_POSITIVE);
        let t = Vec3 { x: (n.x * n.y) / q, y: q, z: (n.z * n.y) / q };
        let b = n.cross(t);
        let [width, height] = map.texture.level_size(0).unwrap_or([1, 1]);
        let here = self.height(l, &point.footprint);
        let right = self.height(l, &stepped(l, &point.footprint, [1.0 / width as f32, 0.0]));
        // v of the course runs up.
        let above = self.height(l, &stepped(l, &point.footprint, [0.0, -1.0 / height as f32]));
        let steepness = self.frame.relief.height * self.frame.relief.scale;
        let (du, dv) = ((right - here) * -steepness, (above - here) * -steepness);
        let tilted = ((t * du + b * dv) + n).normalize();
        l.note_topic("relief, in view space", None);
        l.note("unit normal n", n);
        l.note("tangent t", t);
        l.note("bitangent b", b);
        l.note("height here", here);
        l.note("height a texel to the right", right);
        l.note("height a texel up", above);
        l.note("dU", du);
        l.note("dV", dv);
        l.note("tilted normal n'", tilted);
        self.to_world(tilted)
    }

    /// The length of a texel as a vector of bytes: 0 to 441.
    #[inline(always)]
    fn height<L: Lanes>(&self, l: L, footprint: &Footprint<L>) -> F32<L> {
        match &self.surface.bump {
            Some(map) => (map.sample(l, footprint).rgb() * 255.0).length(),
            None => l.f32(0.0),
        }
    }

    #[inline(always)]
    fn to_view<L: Lanes>(&self, direction: Vec3<L>) -> Vec3<L> {
        self.frame.view_from_world.transform_vector(direction)
    }

    #[inline(always)]
    fn to_world<L: Lanes>(&self, direction: Vec3<L>) -> Vec3<L> {
        self.world_from_view.transform_vector(direction)
    }
}

#[inline(always)]
fn stepped<L: Lanes>(l: L, footprint: &Footprint<L>, step: [f32; 2]) -> Footprint<L> {
    Footprint { uv: footprint.uv + l.vec2(step), ..*footprint }
}

impl Shader for Games101<'_> {
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
        let mut normal = self.smooth_normal(&point);
        if self.shading.has_relief() {
            normal = self.bumped(l, &point, normal);
        }
        SurfaceLanes { position: point.position, normal, uv: f.uv }
    }
}
