//! From the derivatives of uv to a level of detail: how large the footprint of a fragment is, in texels.
//!
//! In: d(uv)/dx and d(uv)/dy of sixteen fragments. Out: their levels, and for anisotropic filters the samples along the
//! long axis. The rule is Vulkan's (section "Image Level(s) Selection" and "Texel Anisotropic Filtering").

use super::pyramid::Texture;
use super::sampler::{LevelFilter, Sampler};
use crate::lanes::{F32, Lanes, Vec2};
use crate::math::log2;

/// How sixteen fragments are to be sampled.
#[derive(Clone, Copy)]
pub(super) struct Footprint<L: Lanes> {
    /// The level of detail: 0 to the last level.
    pub(super) lod: F32<L>,
    /// Samples along the long axis, an integer from 1 up.
    pub(super) taps: F32<L>,
    /// The long axis in uv.
    pub(super) axis: Vec2<L>,
}

impl Texture {
    /// The level of detail that [`sample`](Self::sample) uses: 0 is the full image, 1 half its size, and so on.
    ///
    /// `ddx` and `ddy` are the derivatives of uv by the pixel's x and y; rho is the greater of their lengths in texels
    /// of level 0; lod = log2(rho) + bias, clamped to the sampler's range and to the levels that there are. With
    /// anisotropy rho is the greater length divided by the lesser of the axes' ratio and the limit. Always finite.
    #[inline(always)]
    pub fn lod<L: Lanes>(&self, l: L, sampler: &Sampler, ddx: Vec2<L>, ddy: Vec2<L>) -> F32<L> {
        self.footprint(l, sampler, ddx, ddy).lod
    }

    #[inline(always)]
    pub(super) fn footprint<L: Lanes>(&self, l: L, sampler: &Sampler, ddx: Vec2<L>, ddy: Vec2<L>) -> Footprint<L> {
        let mut footprint = Footprint { lod: l.f32(0.0), taps: l.f32(1.0), axis: l.vec2([0.0, 0.0]) };
        let max_taps = f32::from(sampler.max_anisotropy.clamp(1, MAX_TAPS));
        if sampler.level == LevelFilter::Zero && max_taps == 1.0 {
            return footprint;
        }
        // rho, squared: the root is taken by halving the logarithm.
        let (x, y) = (self.texels_squared(ddx), self.texels_squared(ddy));
        let mut rho = x.max(y);
        if max_taps > 1.0 {
            // Samples closer than a texel would add nothing: the ratio of the axes is limited by the long one, too.
            let ratio = (rho / x.min(y).max(f32::MIN_POSITIVE)).min(rho).clamp(1.0, max_taps * max_taps);
            footprint.taps = -(-ratio.sqrt()).floor();
            footprint.axis = x.ge(y).select(ddx, ddy);
            rho = rho / ratio;
        }
        footprint.lod = self.clamp_lod(sampler, 0.5 * log2(rho));
        footprint
    }

    /// The squared length in texels of level 0.
    #[inline(always)]
    #[expect(clippy::cast_precision_loss, reason = "sizes are below 2^24")]
    fn texels_squared<L: Lanes>(&self, d: Vec2<L>) -> F32<L> {
        let [width, height] = self.desc.size;
        let (x, y) = (d.x * width as f32, d.y * height as f32);
        x * x + y * y
    }

    /// Bias, the sampler's range, the levels that there are.
    #[inline(always)]
    #[expect(clippy::cast_precision_loss, reason = "there are at most 16 levels")]
    pub(super) fn clamp_lod<L: Lanes>(&self, sampler: &Sampler, lod: F32<L>) -> F32<L> {
        if sampler.level == LevelFilter::Zero {
            return lod.token().f32(0.0);
        }
        let last = (self.levels.len() - 1) as f32;
        let low = clamp_number(sampler.lod_min, 0.0, last);
        let high = clamp_number(sampler.lod_max, 0.0, last);
        (lod + clamp_number(sampler.lod_bias, -BIAS_LIMIT, BIAS_LIMIT)).clamp(low, high)
    }
}

/// Into `low..=high`; NaN counts as 0.
fn clamp_number(value: f32, low: f32, high: f32) -> f32 {
    (if value.is_nan() { 0.0 } else { value }).clamp(low, high)
}

/// Most samples along the long axis.
const MAX_TAPS: u8 = 16;

/// No bias moves a level of detail further than this.
const BIAS_LIMIT: f32 = 1000.0;
