//! Texels of sixteen lanes: indices in, linear values out.
//!
//! The format is the same in all lanes, so it is one branch. Four-channel texels are filtered pixel by pixel, across
//! their channels, and turned into lanes afterwards; single-channel ones across lanes.

use super::layout::MAX_LEVELS;
use super::pyramid::Texture;
use super::texel::{BYTE_SCALE, FourChannels, Texels};
use crate::lanes::{Channels, F32, I32, LANES, Lanes, PixelColumns, Rgba, Zero, fetch, outline};

/// The level of each lane.
#[derive(Clone, Copy)]
pub(super) struct LevelLanes<L: Lanes> {
    pub(super) offset: I32<L>,
    pub(super) width: I32<L>,
    pub(super) height: I32<L>,
    pub(super) row_texels: I32<L>,
}

/// Four texels around a point and the weights to mix them.
#[derive(Clone, Copy)]
pub(super) struct TexelQuad<L: Lanes> {
    /// Indices: top left, top right, bottom left, bottom right.
    pub(super) texels: [I32<L>; 4],
    /// The weight of the right ones.
    pub(super) right: F32<L>,
    /// The weight of the bottom ones.
    pub(super) bottom: F32<L>,
}

impl Texture {
    /// The same level in every lane.
    #[inline(always)]
    pub(super) fn level_of_all<L: Lanes>(&self, l: L, level: i32) -> LevelLanes<L> {
        let i = level as usize % MAX_LEVELS;
        let tables = &self.tables;
        LevelLanes {
            offset: l.i32(tables.offset[i]),
            width: l.i32(tables.width[i]),
            height: l.i32(tables.height[i]),
            row_texels: l.i32(tables.row_texels[i]),
        }
    }

    /// Its own level in every lane.
    #[inline(always)]
    pub(super) fn level_of_each<L: Lanes>(&self, level: I32<L>) -> LevelLanes<L> {
        let i = level.as_u32();
        let tables = &self.tables;
        LevelLanes {
            offset: i.gather_i32(&tables.offset),
            width: i.gather_i32(&tables.width),
            height: i.gather_i32(&tables.height),
            row_texels: i.gather_i32(&tables.row_texels),
        }
    }

    /// One texel per lane. Never inlined, for the sake of code size.
    #[inline(never)]
    pub(super) fn fetch<L: Lanes>(&self, l: L, index: I32<L>) -> Rgba<L> {
        outline!(l => self.fetch_of_format(l, index))
    }

    #[inline(always)]
    fn fetch_of_format<L: Lanes>(&self, l: L, index: I32<L>) -> Rgba<L> {
        let index = index.as_u32().to_array();
        match &self.texels {
            Texels::Roots16(texels) => fetch_pixels(l, texels.as_slice(), &index),
            Texels::Rgba8(texels) => fetch_pixels(l, texels.as_slice(), &index),
            Texels::Rgba32Float(texels) => fetch_pixels(l, texels.as_slice(), &index),
            Texels::R8(texels) => red(fetch_red(l, texels.as_slice(), &index) * BYTE_SCALE),
            Texels::R32Float(texels) => red(fetch_red(l, texels.as_slice(), &index)),
        }
    }

    /// Four texels per lane, mixed. Never inlined, for the sake of code size.
    #[inline(never)]
    pub(super) fn fetch_mixed<L: Lanes>(&self, l: L, quad: &TexelQuad<L>) -> Rgba<L> {
        outline!(l => self.mix_of_format(l, quad))
    }

    #[inline(always)]
    fn mix_of_format<L: Lanes>(&self, l: L, quad: &TexelQuad<L>) -> Rgba<L> {
        match &self.texels {
            Texels::Roots16(texels) => mix_pixels(l, texels.as_slice(), quad),
            Texels::Rgba8(texels) => mix_pixels(l, texels.as_slice(), quad),
            Texels::Rgba32Float(texels) => mix_pixels(l, texels.as_slice(), quad),
            Texels::R8(texels) => red(mix_red(l, texels.as_slice(), quad) * BYTE_SCALE),
            Texels::R32Float(texels) => red(mix_red(l, texels.as_slice(), quad)),
        }
    }
}

impl<L: Lanes> LevelLanes<L> {
    /// What column `x` adds to the index of a texel.
    #[inline(always)]
    pub(super) fn column(&self, l: L, x: I32<L>) -> I32<L> {
        // Sixteen texels a tile of four columns.
        (x & l.i32(3)) + ((x & l.i32(!3)) << 2)
    }

    /// What row `y` adds to the index of a texel, with the offset of the level.
    #[inline(always)]
    pub(super) fn row(&self, l: L, y: I32<L>) -> I32<L> {
        (self.offset + ((y & l.i32(3)) << 2)) + (y >> 2) * self.row_texels
    }
}

#[inline(always)]
fn fetch_pixels<L: Lanes, T: FourChannels>(l: L, texels: &[T], index: &[u32; LANES]) -> Rgba<L> {
    let mut columns = PixelColumns::new(l);
    for group in 0..LANES / 4 {
        let mut pixels = [Channels::splat(l, 0.0); 4];
        for (pixel, index) in pixels.iter_mut().zip(&index[4 * group..4 * group + 4]) {
            *pixel = fetch(texels, *index).decode(l);
        }
        columns.set_group(group, pixels);
    }
    scale::<L, T>(columns.to_lanes(l))
}

#[inline(always)]
fn mix_pixels<L: Lanes, T: FourChannels>(l: L, texels: &[T], quad: &TexelQuad<L>) -> Rgba<L> {
    let [a, b, c, d] = quad.texels;
    let index = [a.as_u32().to_array(), b.as_u32().to_array(), c.as_u32().to_array(), d.as_u32().to_array()];
    let (right, bottom) = (quad.right.to_array(), quad.bottom.to_array());
    let mut columns = PixelColumns::new(l);
    for group in 0..LANES / 4 {
        let mut pixels = [Channels::splat(l, 0.0); 4];
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let lane = 4 * group + i;
            let t = Channels::splat(l, right[lane]);
            let top = fetch(texels, index[0][lane]).decode(l).mix(fetch(texels, index[1][lane]).decode(l), t);
            let low = fetch(texels, index[2][lane]).decode(l).mix(fetch(texels, index[3][lane]).decode(l), t);
            *pixel = top.mix(low, Channels::splat(l, bottom[lane]));
        }
        columns.set_group(group, pixels);
    }
    scale::<L, T>(columns.to_lanes(l))
}

#[inline(always)]
fn scale<L: Lanes, T: FourChannels>(sum: Rgba<L>) -> Rgba<L> {
    if T::SCALE == 1.0 { sum } else { sum * T::SCALE }
}

#[inline(always)]
fn fetch_red<L: Lanes, T: Zero + Into<f32>>(l: L, texels: &[T], index: &[u32; LANES]) -> F32<L> {
    let mut values = [0.0; LANES];
    for (value, index) in values.iter_mut().zip(index) {
        *value = fetch(texels, *index).into();
    }
    l.f32_array(&values)
}

#[inline(always)]
fn mix_red<L: Lanes, T: Zero + Into<f32>>(l: L, texels: &[T], quad: &TexelQuad<L>) -> F32<L> {
    let mut corners = [l.f32(0.0); 4];
    for (corner, index) in corners.iter_mut().zip(quad.texels) {
        *corner = fetch_red(l, texels, &index.as_u32().to_array());
    }
    let [a, b, c, d] = corners;
    a.mix(b, quad.right).mix(c.mix(d, quad.right), quad.bottom)
}

/// A single channel as a colour: green and blue 0, alpha 1.
#[inline(always)]
fn red<L: Lanes>(r: F32<L>) -> Rgba<L> {
    let l = r.token();
    Rgba { r, g: l.f32(0.0), b: l.f32(0.0), a: l.f32(1.0) }
}
