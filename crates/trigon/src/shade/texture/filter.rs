//! Sampling: coordinates and footprints in, filtered values out.
//!
//! From the outside in: samples along the long axis of the footprint are averaged; each is mixed from two levels; each
//! level gives one texel or mixes four. A mix of a and b is `a + t * (b - a)`, along u first, then v, then the levels.
//! What is the same in all lanes (filters, wrapping, format) is decided by branches.

use super::address;
use super::fetch::{LevelLanes, TexelQuad};
use super::footprint::Footprint;
use super::notes::{note_color, note_tap};
use super::pyramid::Texture;
use super::sampler::{LevelFilter, PixelFilter, Sampler, Wrap};
use super::texel::sanitize;
use crate::lanes::{F32, I32, LANES, Lanes, Mask, Rgba, Vec2, dispatch, outline};
use fearless_simd::Level;

impl Texture {
    /// Sixteen filtered colours, in linear light; premultiplied where alpha is coverage.
    ///
    /// `uv` from (0, 0), the top left corner, to (1, 1); `ddx` and `ddy` are its derivatives by the pixel's x and y.
    /// Any value is allowed in any lane: NaN and infinities give some colour of the texture or its border, so lanes
    /// that are not used may hold anything. (It is faster if they hold what a used one holds.)
    #[inline(always)]
    pub fn sample<L: Lanes>(&self, l: L, sampler: &Sampler, uv: Vec2<L>, ddx: Vec2<L>, ddy: Vec2<L>) -> Rgba<L> {
        let request = Request { uv: stored(uv), extent: Extent::Gradients(stored(ddx), stored(ddy)) };
        loaded(l, &self.answer(l.level(), sampler, &request))
    }

    /// As [`sample`](Self::sample), with the level of detail given; bias and clamps of the sampler apply.
    #[inline(always)]
    pub fn sample_lod<L: Lanes>(&self, l: L, sampler: &Sampler, uv: Vec2<L>, lod: F32<L>) -> Rgba<L> {
        let request = Request { uv: stored(uv), extent: Extent::Lod(lod.to_array()) };
        loaded(l, &self.answer(l.level(), sampler, &request))
    }

    /// The red channel of [`sample`](Self::sample).
    #[inline(always)]
    pub fn sample_r<L: Lanes>(&self, l: L, sampler: &Sampler, uv: Vec2<L>, ddx: Vec2<L>, ddy: Vec2<L>) -> F32<L> {
        self.sample(l, sampler, uv, ddx, ddy).r
    }

    /// The border between shaders and sampling, in memory instead of lanes: not generic, so that sampling is compiled
    /// once per level and not into every shader. The price is a store and a load of each operand.
    #[inline(never)]
    fn answer(&self, level: Level, sampler: &Sampler, request: &Request) -> [[f32; LANES]; 4] {
        dispatch!(level, l => {
            let uv = reloaded(l, &request.uv);
            let footprint = match &request.extent {
                Extent::Gradients(ddx, ddy) => self.footprint(l, sampler, reloaded(l, ddx), reloaded(l, ddy)),
                Extent::Lod(lod) => {
                    let lod = self.clamp_lod(sampler, l.f32_array(lod));
                    Footprint { lod, taps: l.f32(1.0), axis: l.vec2([0.0, 0.0]) }
                }
            };
            self.note_request(l, request, &footprint);
            let colour = self.sample_taps(l, sampler, uv, &footprint);
            note_color(l, colour);
            [colour.r.to_array(), colour.g.to_array(), colour.b.to_array(), colour.a.to_array()]
        })
    }

    /// The mean of the samples along the long axis.
    #[inline(always)]
    fn sample_taps<L: Lanes>(&self, l: L, sampler: &Sampler, uv: Vec2<L>, footprint: &Footprint<L>) -> Rgba<L> {
        let Footprint { lod, taps, axis } = *footprint;
        let mut sum = zero(l);
        let mut tap = 1.0;
        loop {
            let wanted = taps.ge(tap);
            let along = l.f32(tap) / (taps + 1.0) - 0.5;
            let at = uv + axis * along;
            note_tap(l, wanted, at);
            let value = self.sample_levels(l, sampler, at, lod);
            sum += wanted.select(value, zero(l));
            tap += 1.0;
            if !taps.ge(tap).any() {
                break;
            }
        }
        sum / taps
    }

    /// One sample: one level, or two mixed.
    #[inline(always)]
    fn sample_levels<L: Lanes>(&self, l: L, sampler: &Sampler, uv: Vec2<L>, lod: F32<L>) -> Rgba<L> {
        let level = match sampler.level {
            LevelFilter::Zero => l.f32(0.0),
            LevelFilter::Nearest => (lod + 0.5).floor(),
            LevelFilter::Linear => lod.floor(),
        };
        let fraction = lod - level;
        let index = level.to_i32_in_range();
        self.note_level(l, sampler, index, fraction, false);
        let value = self.sample_level(l, sampler, uv, &self.level_lanes(l, index));
        // A fraction of zero changes nothing: magnification needs one level only.
        if sampler.level != LevelFilter::Linear || !fraction.gt(0.0).any() {
            return value;
        }
        let next = index + l.i32(1);
        self.note_level(l, sampler, next, fraction, true);
        value.mix(self.sample_level(l, sampler, uv, &self.level_lanes(l, next)), fraction)
    }

    /// The records of the lanes' levels; without a gather where all are the same.
    #[inline(always)]
    fn level_lanes<L: Lanes>(&self, l: L, index: I32<L>) -> LevelLanes<L> {
        let first = index.to_array()[0];
        if index.eq(l.i32(first)).all() { self.level_of_all(l, first) } else { self.level_of_each(index) }
    }

    /// One texel of a level, or four mixed.
    ///
    /// Never inlined: the optimizer would make a copy of the loops around it for each combination of its branches.
    #[inline(never)]
    fn sample_level<L: Lanes>(&self, l: L, sampler: &Sampler, uv: Vec2<L>, level: &LevelLanes<L>) -> Rgba<L> {
        outline!(l => self.sample_level_inline(l, sampler, uv, level))
    }

    #[inline(always)]
    fn sample_level_inline<L: Lanes>(&self, l: L, sampler: &Sampler, uv: Vec2<L>, level: &LevelLanes<L>) -> Rgba<L> {
        if sampler.pixel == PixelFilter::Nearest {
            let (x, inside_x) = address::nearest(l, sampler.wrap_u, uv.x, level.width);
            let (y, inside_y) = address::nearest(l, sampler.wrap_v, uv.y, level.height);
            self.note_nearest(l, sampler, (x, inside_x), (y, inside_y));
            let texel = self.fetch(l, level.column(l, x) + level.row(l, y));
            return with_border(l, sampler, inside_x, inside_y, texel);
        }
        let u = address::bilinear(l, sampler.wrap_u, uv.x, level.width);
        let v = address::bilinear(l, sampler.wrap_v, uv.y, level.height);
        self.note_mixed(l, sampler, &u, &v);
        let (left, right) = (level.column(l, u.texels[0]), level.column(l, u.texels[1]));
        let (top, bottom) = (level.row(l, v.texels[0]), level.row(l, v.texels[1]));
        let texels = [left + top, right + top, left + bottom, right + bottom];
        if !sampler.has_border() {
            return self.fetch_mixed(l, &TexelQuad { texels, right: u.weight, bottom: v.weight });
        }
        let mut corners = [zero(l); 4];
        for i in 0..4 {
            corners[i] = with_border(l, sampler, u.inside[i % 2], v.inside[i / 2], self.fetch(l, texels[i]));
        }
        let [a, b, c, d] = corners;
        a.mix(b, u.weight).mix(c.mix(d, u.weight), v.weight)
    }
}

/// Two coordinates of sixteen points.
pub(super) type Pair = [[f32; LANES]; 2];

/// What sixteen fragments ask for.
pub(super) struct Request {
    pub(super) uv: Pair,
    pub(super) extent: Extent,
}

/// How large their footprints are.
pub(super) enum Extent {
    /// The derivatives of uv by the pixel's x and y.
    Gradients(Pair, Pair),
    /// The level of detail before bias and clamps.
    Lod([f32; LANES]),
}

#[inline(always)]
fn stored<L: Lanes>(v: Vec2<L>) -> Pair {
    [v.x.to_array(), v.y.to_array()]
}

#[inline(always)]
fn reloaded<L: Lanes>(l: L, v: &Pair) -> Vec2<L> {
    Vec2 { x: l.f32_array(&v[0]), y: l.f32_array(&v[1]) }
}

#[inline(always)]
fn loaded<L: Lanes>(l: L, [r, g, b, a]: &[[f32; LANES]; 4]) -> Rgba<L> {
    Rgba { r: l.f32_array(r), g: l.f32_array(g), b: l.f32_array(b), a: l.f32_array(a) }
}

#[inline(always)]
fn zero<L: Lanes>(l: L) -> Rgba<L> {
    l.vec3([0.0; 3]).rgba(0.0)
}

/// The border colour where a texel is not of the image. Where both axes have one, that of u.
#[inline(always)]
fn with_border<L: Lanes>(l: L, sampler: &Sampler, inside_x: Mask<L>, inside_y: Mask<L>, texel: Rgba<L>) -> Rgba<L> {
    let mut value = texel;
    for (wrap, inside) in [(sampler.wrap_v, inside_y), (sampler.wrap_u, inside_x)] {
        if let Wrap::Border([r, g, b, a]) = wrap {
            let [r, g, b, a] = [sanitize(r), sanitize(g), sanitize(b), sanitize(a)];
            value = inside.select(value, l.vec3([r, g, b]).rgba(a));
        }
    }
    value
}
