//! The sampler against a plain scalar one, and promises that span files: same bits at every level, no panics.

use super::*;
use crate::lanes::{LANES, Lanes, SimdLevel, Vec2, dispatch};

pub(super) type Pair = [[f32; LANES]; 2];

/// Sixteen samples at a level: red, green, blue and alpha arrays.
pub(super) fn sample_at(
    level: SimdLevel,
    texture: &Texture,
    sampler: &Sampler,
    [uv, ddx, ddy]: &[Pair; 3],
) -> [[f32; LANES]; 4] {
    let level = level.to_level().expect("the level is available");
    dispatch!(level, l => {
        let colour = texture.sample(l, sampler, lanes(l, uv), lanes(l, ddx), lanes(l, ddy));
        [colour.r.to_array(), colour.g.to_array(), colour.b.to_array(), colour.a.to_array()]
    })
}

#[inline(always)]
fn lanes<L: Lanes>(l: L, pair: &Pair) -> Vec2<L> {
    Vec2 { x: l.f32_array(&pair[0]), y: l.f32_array(&pair[1]) }
}

#[test]
fn texel_centres_give_texels() {
    let bytes: Vec<u8> = (0..5 * 3 * 4).map(|i: u8| i.wrapping_mul(7)).collect();
    let texture = Texture::from_bytes(&TextureDesc::new([5, 3], TexelFormat::Rgba8), &bytes).unwrap();
    for level in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
        for pixel in [PixelFilter::Nearest, PixelFilter::Bilinear] {
            let sampler = Sampler::TRILINEAR.with_filters(pixel, LevelFilter::Linear);
            let u = core::array::from_fn(|i| ((i % 5) as f32 + 0.5) / 5.0);
            let v = core::array::from_fn(|i| ((i / 5 % 3) as f32 + 0.5) / 3.0);
            let zero = [[0.0; LANES]; 2];
            let colours = sample_at(level, &texture, &sampler, &[[u, v], zero, zero]);
            for i in 0..15 {
                let texel = texture.texel(0, i % 5, i / 5).unwrap();
                for c in 0..4 {
                    assert!((colours[c][i as usize] - texel[c]).abs() < 1e-6, "{level} {pixel:?} {i}");
                }
            }
        }
    }
}
