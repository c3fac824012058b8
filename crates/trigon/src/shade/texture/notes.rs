//! What the sampler notes when a pixel is explained: footprint, taps, levels, texels and their weights.
//!
//! In: the values that the sampler works with. Out: a [`TextureRead`](crate::explain::TextureRead) of each watched lane.
//! All of it compiles to nothing but at the plain level.

use super::address::Neighbours;
use super::filter::{Extent, Request};
use super::footprint::Footprint;
use super::pyramid::Texture;
use super::sampler::{LevelFilter, Sampler, Wrap};
use super::texel::sanitize;
use crate::explain;
use crate::lanes::{F32, I32, LANES, Lanes, Mask, Rgba, Vec2};

impl Texture {
    /// A read begins.
    #[inline(always)]
    pub(super) fn note_request<L: Lanes>(&self, l: L, request: &Request, footprint: &Footprint<L>) {
        if l.is_explaining() {
            let extent = match &request.extent {
                Extent::Gradients(ddx, ddy) => Some((ddx, ddy)),
                Extent::Lod(_) => None,
            };
            let lod = footprint.lod.to_array();
            explain::note_texture(self.desc.size, self.levels.len() as u32, &request.uv, extent, &lod);
        }
    }

    /// A level of a tap is read: the first, or the second with the fraction as its weight.
    #[inline(always)]
    pub(super) fn note_level<L: Lanes>(
        &self,
        l: L,
        sampler: &Sampler,
        index: I32<L>,
        fraction: F32<L>,
        is_second: bool,
    ) {
        if l.is_explaining() {
            let weight = match sampler.level {
                LevelFilter::Linear if is_second => fraction,
                LevelFilter::Linear => 1.0 - fraction,
                LevelFilter::Zero | LevelFilter::Nearest => l.f32(1.0),
            };
            self.note_level_of(index.to_array(), &weight.to_array());
        }
    }

    /// One texel is read.
    #[inline(always)]
    pub(super) fn note_nearest<L: Lanes>(&self, l: L, sampler: &Sampler, x: (I32<L>, Mask<L>), y: (I32<L>, Mask<L>)) {
        if l.is_explaining() {
            self.note_texel(sampler, [&x.0.to_array(), &y.0.to_array()], &[1.0; LANES], [x.1.bits(), y.1.bits()]);
        }
    }

    /// Four texels are read and mixed.
    #[inline(always)]
    pub(super) fn note_mixed<L: Lanes>(&self, l: L, sampler: &Sampler, u: &Neighbours<L>, v: &Neighbours<L>) {
        if l.is_explaining() {
            let along = [[1.0 - u.weight, u.weight], [1.0 - v.weight, v.weight]];
            for i in 0..4 {
                let (i_u, i_v) = (i % 2, i / 2);
                let place = [&u.texels[i_u].to_array(), &v.texels[i_v].to_array()];
                let weight = (along[0][i_u] * along[1][i_v]).to_array();
                self.note_texel(sampler, place, &weight, [u.inside[i_u].bits(), v.inside[i_v].bits()]);
            }
        }
    }

    fn note_level_of(&self, mut level: [i32; LANES], weight: &[f32; LANES]) {
        let last = self.levels.len() - 1;
        for level in &mut level {
            *level = (*level).clamp(0, last as i32);
        }
        let size = |level: u32| self.level_size(level as usize).unwrap_or_default();
        explain::note_level(&level, size, weight);
    }

    fn note_texel(&self, sampler: &Sampler, place: [&[i32; LANES]; 2], weight: &[f32; LANES], inside: [u16; 2]) {
        let [inside_x, inside_y] = inside;
        let color = |level: u32, x: u32, y: u32| self.texel(level as usize, x, y).unwrap_or_default();
        // Where both axes have one, that of u.
        let border = |lane: usize| {
            [(sampler.wrap_u, inside_x), (sampler.wrap_v, inside_y)].into_iter().find_map(|(wrap, inside)| match wrap {
                Wrap::Border(color) if inside >> lane & 1 == 0 => Some(color.map(sanitize)),
                _ => None,
            })
        };
        explain::note_texel(place, weight, color, border);
    }
}

/// The next point of the read.
#[inline(always)]
pub(super) fn note_tap<L: Lanes>(l: L, wanted: Mask<L>, uv: Vec2<L>) {
    if l.is_explaining() {
        explain::note_tap(wanted.bits(), &[uv.x.to_array(), uv.y.to_array()]);
    }
}

/// The result of the read.
#[inline(always)]
pub(super) fn note_color<L: Lanes>(l: L, color: Rgba<L>) {
    if l.is_explaining() {
        explain::note_texture_color(&[color.r.to_array(), color.g.to_array(), color.b.to_array(), color.a.to_array()]);
    }
}
