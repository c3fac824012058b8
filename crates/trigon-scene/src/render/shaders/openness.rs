//! Reading occlusion: fragments in, how open their surfaces are out.
//!
//! The map has one value per pixel, that of the surface in the pixel's middle. A fragment at an edge may belong to another
//! surface; then the neighbouring pixel whose surface is nearest to the fragment has the better value, and where none is
//! near (in front of a pane of glass, say) the fragment counts as open.

use crate::render::occlusion::OcclusionMap;
use trigon::lanes::{F32, Lanes, Vec2, Vec3};

impl OcclusionMap {
    /// 0 to 1, for fragments at `position` in the world and `pixel` in the picture.
    #[inline(never)]
    pub(super) fn openness<L: Lanes>(&self, l: L, pixel: Vec2<L>, position: Vec3<L>) -> F32<L> {
        l.vectorize(
            #[inline(always)]
            || self.openness_inline(l, pixel, position),
        )
    }

    #[inline(always)]
    fn openness_inline<L: Lanes>(&self, l: L, pixel: Vec2<L>, position: Vec3<L>) -> F32<L> {
        let [x, y, z, offset] = self.view_axis;
        let distance = position.dot(l.vec3([x, y, z])) + offset;
        let (mut open, mut gap) = self.at(l, pixel, [0.0, 0.0], distance);
        let is_other = gap.gt(self.reach * (1.0 / 16.0));
        if is_other.any() {
            for step in [[-1.0, 0.0], [1.0, 0.0], [0.0, -1.0], [0.0, 1.0]] {
                let (its_open, its_gap) = self.at(l, pixel, step, distance);
                let is_better = is_other & its_gap.lt(gap);
                open = is_better.select(its_open, open);
                gap = is_better.select(its_gap, gap);
            }
        }
        gap.le(self.reach).select(open, l.f32(1.0))
    }

    /// The value of a pixel, and how far its surface is from `distance`.
    #[inline(always)]
    fn at<L: Lanes>(&self, l: L, pixel: Vec2<L>, step: [f32; 2], distance: F32<L>) -> (F32<L>, F32<L>) {
        let column = (pixel.x + step[0]).to_i32_within(0.0, (self.width - 1) as f32).as_u32();
        let row = (pixel.y + step[1]).to_i32_within(0.0, (self.height - 1) as f32).as_u32();
        let index = row * l.u32(self.width) + column;
        (index.gather_f32(&self.openness), (index.gather_f32(&self.distances) - distance).abs())
    }
}
