//! Reading shadow maps: points of a surface in, the part of a light that reaches them out.
//!
//! A point is lit where the map shows nothing nearer to the light (Williams 1978). Depths must not be filtered like
//! colours: the mean of two depths is that of no surface. So comparisons are averaged instead (percentage-closer
//! filtering, Reeves et al. 1987): here over a square whose border texels count by the part of them that lies inside, so
//! that the edge of a shadow is a smooth ramp at any place.
//!
//! A slanting surface is not at one depth within that square. Its plane is known exactly, so each texel is compared with
//! the depth that the plane has at that texel's middle (receiver plane depth: Isidoro, "Shadow Mapping: GPU-based Tips
//! and Techniques", 2006), and the bias has to hide the curvature of surfaces only, not their slope.

use super::point::SurfacePoint;
use crate::render::shadow_map::{ShadowFace, ShadowMap};
use trigon::lanes::{F32, Lanes, Mat4, Vec2, Vec3, Vec4};

/// The steepest plane that is followed, in widths of a texel along the light per texel across.
const STEEPEST: f32 = 8.0;

impl ShadowMap {
    /// The part of the light that arrives, 0 to 1. `to_light` is the unit vector to the light.
    #[inline(never)]
    pub(super) fn visibility<L: Lanes>(
        &self,
        l: L,
        point: &SurfacePoint<L>,
        place: [f32; 3],
        to_light: Vec3<L>,
    ) -> F32<L> {
        l.vectorize(
            #[inline(always)]
            || self.visibility_inline(l, point, place, to_light),
        )
    }

    #[inline(always)]
    fn visibility_inline<L: Lanes>(&self, l: L, point: &SurfacePoint<L>, place: [f32; 3], to_light: Vec3<L>) -> F32<L> {
        if let [face] = self.faces.as_slice() {
            return self.lit_part(l, face, point, to_light);
        }
        let side = cube_side(l, point.position - l.vec3(place));
        let mut lit = l.f32(1.0);
        for (number, face) in self.faces.iter().enumerate() {
            let is_here = side.eq(number as f32);
            if is_here.any() {
                lit = is_here.select(self.lit_part(l, face, point, to_light), lit);
            }
        }
        lit
    }

    /// The part of the filter's square in which nothing is nearer to the light than the surface.
    #[inline(always)]
    fn lit_part<L: Lanes>(&self, l: L, face: &ShadowFace, point: &SurfacePoint<L>, to_light: Vec3<L>) -> F32<L> {
        let receiver = self.receiver(l, &face.clip_from_world, point, to_light);
        let depths = face.depth.values();
        if self.softness == 0.0 {
            return self.is_lit(l, depths, &receiver, receiver.at.x.floor(), receiver.at.y.floor(), l.f32(1.0));
        }
        let (left, top) = (receiver.at.x - self.softness, receiver.at.y - self.softness);
        let (right, bottom) = (receiver.at.x + self.softness, receiver.at.y + self.softness);
        let (first_x, first_y) = (left.floor(), top.floor());
        let mut sum = l.f32(0.0);
        for row in 0..self.taps {
            let y = first_y + row as f32;
            let height = ((y + 1.0).min(bottom) - y.max(top)).max(0.0);
            for column in 0..self.taps {
                let x = first_x + column as f32;
                let width = ((x + 1.0).min(right) - x.max(left)).max(0.0);
                sum += self.is_lit(l, depths, &receiver, x, y, width * height);
            }
        }
        (sum * (0.25 / (self.softness * self.softness))).min(1.0)
    }

    /// `weight` where the texel (`x`, `y`) is not nearer to the light than the surface, else 0.
    #[inline(always)]
    fn is_lit<L: Lanes>(
        &self,
        l: L,
        depths: &[f32],
        receiver: &Receiver<L>,
        x: F32<L>,
        y: F32<L>,
        weight: F32<L>,
    ) -> F32<L> {
        let last = (self.size - 1) as f32;
        let (column, row) = (x.to_i32_within(0.0, last).as_u32(), y.to_i32_within(0.0, last).as_u32());
        let stored = (row * l.u32(self.size) + column).gather_f32(depths);
        let (right, down) = ((x + 0.5) - receiver.at.x, (y + 0.5) - receiver.at.y);
        // Nothing is farther away than what an empty texel holds.
        let surface = (receiver.depth + (receiver.slope.x * right + receiver.slope.y * down)).max(0.0);
        stored.le(surface).select(weight, l.f32(0.0))
    }

    /// Where the surface is on the map.
    #[inline(always)]
    fn receiver<L: Lanes>(&self, l: L, clip: &Mat4, point: &SurfacePoint<L>, to_light: Vec3<L>) -> Receiver<L> {
        let distance = clip.transform_point(l, point.position).w;
        let texel = distance * self.texel;
        let plane = point.dx.cross(point.dy).normalize();
        let normal = plane.dot(point.to_eye).lt(0.0).select(-plane, plane);
        let towards = to_light * (texel * self.bias_texels + l.f32(self.bias));
        let moved = (point.position + towards) + normal * (texel * self.normal_offset_texels);

        let at_clip = clip.transform_point(l, moved);
        let inverse_w = 1.0 / at_clip.w;
        let ndc = at_clip.xyz() * inverse_w;
        let half = self.size as f32 * 0.5;
        // How the place on the map and the depth change over the surface, along two directions in its plane.
        let (a, b) = (
            texels(ndc_change(clip, ndc, inverse_w, point.dx), half),
            texels(ndc_change(clip, ndc, inverse_w, point.dy), half),
        );
        let area = a.x * b.y - a.y * b.x;
        let is_usable = area.abs().gt(f32::MIN_POSITIVE);
        let inverse = is_usable.select(1.0 / area, l.f32(0.0));
        let steepest = (inverse_w * (self.depth_of_texel * STEEPEST)).abs();
        let slope = Vec2 {
            x: ((a.z * b.y - a.y * b.z) * inverse).max(-steepest).min(steepest),
            y: ((a.x * b.z - a.z * b.x) * inverse).max(-steepest).min(steepest),
        };
        Receiver { at: Vec2 { x: ndc.x * half + half, y: half - ndc.y * half }, depth: ndc.z, slope }
    }
}

/// A point of a surface on a shadow map.
struct Receiver<L: Lanes> {
    /// In texels, from the top left.
    at: Vec2<L>,
    /// NDC depth there.
    depth: F32<L>,
    /// Its change per texel to the right and down.
    slope: Vec2<L>,
}

/// The change of NDC when a point moves by `step`, to first order.
#[inline(always)]
fn ndc_change<L: Lanes>(clip: &Mat4, ndc: Vec3<L>, inverse_w: F32<L>, step: Vec3<L>) -> Vec3<L> {
    let [x, y, z, _] = clip.columns;
    let Vec4 { x: dx, y: dy, z: dz, w: dw } =
        clip.transform_vector(step).extend((step.x * x[3] + step.y * y[3]) + step.z * z[3]);
    (Vec3 { x: dx, y: dy, z: dz } - ndc * dw) * inverse_w
}

/// x and y from NDC to texels; z stays.
#[inline(always)]
fn texels<L: Lanes>(change: Vec3<L>, half: f32) -> Vec3<L> {
    Vec3 { x: change.x * half, y: -(change.y * half), z: change.z }
}

/// Which face of a cube a direction leaves through: 0 to 5 for +x, -x, +y, -y, +z, -z.
#[inline(always)]
fn cube_side<L: Lanes>(l: L, direction: Vec3<L>) -> F32<L> {
    let Vec3 { x, y, z } = direction;
    let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
    let (zero, one) = (l.f32(0.0), l.f32(1.0));
    let by_z = z.lt(0.0).select(one, zero) + 4.0;
    let by_y = y.lt(0.0).select(one, zero) + 2.0;
    let by_x = x.lt(0.0).select(one, zero);
    let is_x = ax.ge(ay) & ax.ge(az);
    is_x.select(by_x, ay.ge(az).select(by_y, by_z))
}
