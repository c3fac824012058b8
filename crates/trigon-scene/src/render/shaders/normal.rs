//! The shading normal: interpolated, turned to the side that is seen, and tilted by normal and bump maps.
//!
//! In: a fragment. Out: unit normals that face the viewer. Surfaces are two-sided; which side is seen follows from the
//! plane of the triangle, not from its winding, which many models get wrong.
//!
//! Maps tilt by gradients over the surface, found from derivatives alone: with R1 = dP/dy x N and R2 = N x dP/dx, the
//! gradient of any f is (f_x R1 + f_y R2) / (dP/dx . R1) (Mikkelsen, "Bump Mapping Unparametrized Surfaces on the GPU",
//! 2010). The gradients of u and v are the tangent frame of normal maps where vertices have none.

use super::maps::Footprint;
use super::point::SurfacePoint;
use crate::render::material::MapUse;
use trigon::lanes::{F32, Lanes, Vec2, Vec3};

/// Where normals come from.
#[derive(Clone, Copy)]
pub(super) struct NormalSource<'a> {
    /// The triangle's own normal.
    pub(super) is_flat: bool,
    /// Points have no plane.
    pub(super) is_point: bool,
    pub(super) has_tangents: bool,
    pub(super) normal: Option<&'a MapUse<'a>>,
    pub(super) bump: Option<&'a MapUse<'a>>,
}

/// How high a bump map's full range is at `-bm 1`: this part of the texture's width on the surface.
const BUMP_HEIGHT: f32 = 1.0 / 32.0;

impl NormalSource<'_> {
    /// The unit normal that faces the viewer.
    #[inline(always)]
    pub(super) fn normal<L: Lanes>(&self, l: L, p: &SurfacePoint<L>) -> Vec3<L> {
        if self.is_point {
            let normal = p.normal.normalize();
            return normal.dot(p.to_eye).lt(0.0).select(-normal, normal);
        }
        let plane = p.plane();
        if self.is_flat {
            return plane.normalize();
        }
        let length_squared = p.normal.dot(p.normal);
        let mut normal = p.normal * (1.0 / length_squared.max(f32::MIN_POSITIVE).sqrt());
        let is_usable = length_squared.gt(f32::MIN_POSITIVE);
        if !is_usable.all() {
            normal = is_usable.select(normal, plane.normalize());
        }
        let is_back = normal.dot(plane).lt(0.0);
        if self.normal.is_some() || self.bump.is_some() {
            normal = self.tilted(l, p, normal);
        }
        is_back.select(-normal, normal)
    }

    /// The normal with its maps, on the front of the surface.
    #[inline(never)]
    fn tilted<L: Lanes>(&self, l: L, p: &SurfacePoint<L>, normal: Vec3<L>) -> Vec3<L> {
        l.vectorize(
            #[inline(always)]
            || self.tilted_inline(l, p, normal),
        )
    }

    #[inline(always)]
    fn tilted_inline<L: Lanes>(&self, l: L, p: &SurfacePoint<L>, normal: Vec3<L>) -> Vec3<L> {
        let gradient = SurfaceGradient::new(p.dx, p.dy, normal);
        if let Some(map) = self.normal {
            let texel = map.sample(l, &p.footprint).rgb();
            // 128 is zero, as painters of normal maps have it; 255 is one.
            let m = texel * (255.0 / 127.0) - l.vec3([128.0 / 127.0; 3]);
            if !self.has_tangents {
                return gradient.by_normal_map(&p.footprint.placed(l, map), normal, m);
            }
            // As MikkTSpace has it: interpolated, and not made orthogonal again.
            let tangent = p.tangent.xyz();
            let bitangent = p.normal.cross(tangent) * p.tangent.w;
            let [u, v] = map.direction();
            return ((tangent * (m.x * u) + bitangent * (m.y * v)) + p.normal * m.z).normalize();
        }
        match self.bump {
            Some(map) => gradient.by_height(l, map, &p.footprint, normal),
            None => normal,
        }
    }
}

/// Gradients over a surface whose points and normal are known.
struct SurfaceGradient<L: Lanes> {
    r1: Vec3<L>,
    r2: Vec3<L>,
    /// The area of a pixel on the surface, and the sign of its orientation.
    area: F32<L>,
    sign: F32<L>,
}

impl<L: Lanes> SurfaceGradient<L> {
    #[inline(always)]
    fn new(dx: Vec3<L>, dy: Vec3<L>, normal: Vec3<L>) -> Self {
        let (r1, r2) = (dy.cross(normal), normal.cross(dx));
        let determinant = dx.dot(r1);
        let one = determinant.token().f32(1.0);
        Self { r1, r2, area: determinant.abs(), sign: determinant.lt(0.0).select(-one, one) }
    }

    /// Times the area.
    #[inline(always)]
    fn of(&self, fx: F32<L>, fy: F32<L>) -> Vec3<L> {
        (self.r1 * fx + self.r2 * fy) * self.sign
    }

    /// `m` in the frame of the gradients of u and -v, scaled alike, and the normal.
    #[inline(always)]
    fn by_normal_map(&self, at: &Footprint<L>, normal: Vec3<L>, m: Vec3<L>) -> Vec3<L> {
        let tangent = self.of(at.dx.x, at.dy.x);
        let bitangent = -self.of(at.dx.y, at.dy.y);
        let longest = tangent.dot(tangent).max(bitangent.dot(bitangent));
        let scale = 1.0 / longest.max(f32::MIN_POSITIVE).sqrt();
        ((tangent * m.x + bitangent * m.y) * scale + normal * m.z).normalize()
    }

    /// Heights at the fragment and one pixel further along x and y.
    #[inline(always)]
    fn by_height(&self, l: L, map: &MapUse<'_>, footprint: &Footprint<L>, normal: Vec3<L>) -> Vec3<L> {
        let mut heights = [l.f32(0.0); 3];
        let zero = l.vec2([0.0; 2]);
        for (step, height) in [zero, footprint.dx, footprint.dy].into_iter().zip(&mut heights) {
            let at = Footprint { uv: footprint.uv + step, ..*footprint };
            *height = map.sample(l, &at).r;
        }
        let at = footprint.placed(l, map);
        let unit = self.uv_unit(at.dx, at.dy) * (map.strength * BUMP_HEIGHT);
        let (hx, hy) = ((heights[1] - heights[0]) * unit, (heights[2] - heights[0]) * unit);
        (normal * self.area - self.of(hx, hy)).normalize()
    }

    /// How long one unit of texture coordinates is on the surface; zero where they do not change.
    #[inline(always)]
    fn uv_unit(&self, dx: Vec2<L>, dy: Vec2<L>) -> F32<L> {
        let uv_area = (dx.x * dy.y - dx.y * dy.x).abs();
        let ratio = self.area / uv_area.max(f32::MIN_POSITIVE);
        uv_area.gt(f32::MIN_POSITIVE).select(ratio.sqrt(), self.area.token().f32(0.0))
    }
}
