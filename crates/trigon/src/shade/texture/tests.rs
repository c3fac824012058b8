//! The sampler against a plain scalar one, and promises that span files: same bits at every level, no panics.

use super::reference::{self, Point};
use super::*;
use crate::lanes::{LANES, Lanes, SimdLevel, Vec2, dispatch};

type Pair = [[f32; LANES]; 2];

/// Uv and its derivatives of sixteen points.
#[derive(Clone, Copy)]
struct Points {
    uv: Pair,
    ddx: Pair,
    ddy: Pair,
}

impl Points {
    fn lane(&self, i: usize) -> Point {
        let pair = |p: &Pair| [f64::from(p[0][i]), f64::from(p[1][i])];
        Point { uv: pair(&self.uv), ddx: pair(&self.ddx), ddy: pair(&self.ddy) }
    }

    /// The point of one lane in all lanes.
    fn broadcast(&self, i: usize) -> Self {
        let pair = |p: &Pair| [[p[0][i]; LANES], [p[1][i]; LANES]];
        Self { uv: pair(&self.uv), ddx: pair(&self.ddx), ddy: pair(&self.ddy) }
    }
}

/// Colours and levels of detail at one SIMD level, lane by lane.
fn sample_at(
    level: SimdLevel,
    texture: &Texture,
    sampler: &Sampler,
    points: &Points,
) -> ([[f32; 4]; LANES], [f32; LANES]) {
    dispatch!(level.to_level().expect("the level is available"), l => {
        let (ddx, ddy) = (lanes(l, &points.ddx), lanes(l, &points.ddy));
        let colour = texture.sample(l, sampler, lanes(l, &points.uv), ddx, ddy);
        let [r, g, b, a] = [colour.r.to_array(), colour.g.to_array(), colour.b.to_array(), colour.a.to_array()];
        let mut colours = [[0.0; 4]; LANES];
        for i in 0..LANES {
            colours[i] = [r[i], g[i], b[i], a[i]];
        }
        (colours, texture.lod(l, sampler, ddx, ddy).to_array())
    })
}

#[inline(always)]
fn lanes<L: Lanes>(l: L, pair: &Pair) -> Vec2<L> {
    Vec2 { x: l.f32_array(&pair[0]), y: l.f32_array(&pair[1]) }
}

/// The samples, asserted to be the same bits at every SIMD level.
fn sample(texture: &Texture, sampler: &Sampler, points: &Points) -> [[f32; 4]; LANES] {
    let (scalar, lod) = sample_at(SimdLevel::Scalar, texture, sampler, points);
    for level in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
        let (colours, lods) = sample_at(level, texture, sampler, points);
        assert_eq!(colours.map(|c| c.map(f32::to_bits)), scalar.map(|c| c.map(f32::to_bits)), "{level} {sampler:?}");
        assert_eq!(lods.map(f32::to_bits), lod.map(f32::to_bits), "{level}");
    }
    scalar
}

/// A small generator of test values (xorshift).
struct Random(u32);

impl Random {
    fn bits(&mut self) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 17;
        self.0 ^= self.0 << 5;
        self.0
    }

    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * ((self.bits() >> 8) as f32 / 16_777_216.0)
    }

    fn pair(&mut self, low: f32, high: f32) -> Pair {
        core::array::from_fn(|_| core::array::from_fn(|_| self.between(low, high)))
    }

    /// Points in and around the image, with footprints of 2^-2 to 2^5 texels of a texture of this size.
    fn points(&mut self, size: [u32; 2]) -> Points {
        let mut points = Points { uv: self.pair(-2.0, 3.0), ddx: self.pair(-1.0, 1.0), ddy: self.pair(-1.0, 1.0) };
        for i in 0..LANES {
            let texels = self.between(0.25, 1.0) * f32::from(1_u8 << (self.bits() % 6));
            for d in [&mut points.ddx, &mut points.ddy] {
                d[0][i] *= texels / size[0] as f32;
                d[1][i] *= texels / size[1] as f32;
            }
        }
        points
    }

    fn texture(&mut self, size: [u32; 2], format: TexelFormat) -> Texture {
        let desc = TextureDesc::new(size, format);
        let count = desc.values() as usize;
        if format.is_float() {
            let values: Vec<f32> = (0..count).map(|_| self.between(-1.0, 1.0)).collect();
            Texture::from_floats(&desc, &values).unwrap()
        } else {
            let bytes: Vec<u8> = (0..count).map(|_| (self.bits() >> 9) as u8).collect();
            Texture::from_bytes(&desc, &bytes).unwrap()
        }
    }
}

const FORMATS: [TexelFormat; 5] =
    [TexelFormat::Rgba8Srgb, TexelFormat::Rgba8, TexelFormat::R8, TexelFormat::R32Float, TexelFormat::Rgba32Float];

const WRAPS: [Wrap; 4] = [Wrap::Repeat, Wrap::Mirror, Wrap::ClampToEdge, Wrap::Border([0.25, 0.5, 0.75, 1.0])];

/// All six combinations of filters.
fn samplers() -> Vec<Sampler> {
    let pixels = [PixelFilter::Nearest, PixelFilter::Bilinear];
    let levels = [LevelFilter::Zero, LevelFilter::Nearest, LevelFilter::Linear];
    let filters = pixels.into_iter().flat_map(|pixel| levels.map(|level| (pixel, level)));
    filters.map(|(pixel, level)| Sampler::TRILINEAR.with_filters(pixel, level)).collect()
}

/// All filters with all wraps along u, and along v another wrap each time.
fn wrapped_samplers() -> Vec<Sampler> {
    let mut wrapped = Vec::new();
    for (i, filters) in samplers().into_iter().enumerate() {
        for (u, wrap_u) in WRAPS.into_iter().enumerate() {
            wrapped.push(Sampler { wrap_u, wrap_v: WRAPS[(u + i) % 4], ..filters });
        }
    }
    wrapped
}

#[test]
fn every_filter_wrap_and_format_matches_the_reference() {
    let mut random = Random(0x1234_5678);
    let mut compared = 0;
    for size in [[16, 16], [5, 7], [1, 9], [13, 1], [1, 1]] {
        for format in FORMATS {
            let texture = random.texture(size, format);
            for sampler in wrapped_samplers() {
                let points = random.points(size);
                let colours = sample(&texture, &sampler, &points);
                for (lane, colour) in colours.iter().enumerate() {
                    let Some(exact) = reference::sample(&texture, &sampler, &points.lane(lane)) else { continue };
                    let error = (0..4).map(|c| (f64::from(colour[c]) - exact[c]).abs()).fold(0.0, f64::max);
                    assert!(
                        error < 2e-5,
                        "{format:?} {size:?} {sampler:?} {:?}: {colour:?} {exact:?}",
                        points.lane(lane)
                    );
                    compared += 1;
                }
            }
        }
    }
    assert!(compared > 8000, "only {compared} samples were compared");
}

#[test]
fn levels_of_detail_match_the_reference() {
    let mut random = Random(77);
    let texture = random.texture([37, 64], TexelFormat::R8);
    for sampler in [
        Sampler::TRILINEAR,
        Sampler { lod_bias: -0.75, ..Sampler::TRILINEAR },
        Sampler { lod_min: 1.5, lod_max: 2.5, ..Sampler::TRILINEAR },
        Sampler { lod_bias: f32::NAN, lod_min: f32::NEG_INFINITY, lod_max: f32::INFINITY, ..Sampler::TRILINEAR },
    ] {
        let plain = if sampler.lod_bias.is_nan() { Sampler::TRILINEAR } else { sampler };
        for _ in 0..50 {
            let points = random.points([37, 64]);
            let (_, lods) = sample_at(SimdLevel::detect(), &texture, &sampler, &points);
            for (lane, lod) in lods.into_iter().enumerate() {
                let exact = reference::lod(&texture, &plain, &points.lane(lane));
                assert!((f64::from(lod) - exact).abs() < 2e-6, "{lod} {exact}");
            }
        }
    }
}

#[test]
fn a_sample_does_not_depend_on_its_neighbours_in_the_lanes() {
    let mut random = Random(99);
    for format in FORMATS {
        let texture = random.texture([32, 24], format);
        for sampler in samplers().into_iter().flat_map(|sampler| [sampler, sampler.with_anisotropy(8)]) {
            let points = random.points([32, 24]);
            let colours = sample(&texture, &sampler, &points);
            for (lane, colour) in colours.iter().enumerate() {
                let (alone, _) = sample_at(SimdLevel::detect(), &texture, &sampler, &points.broadcast(lane));
                assert_eq!(colour.map(f32::to_bits), alone[lane].map(f32::to_bits), "{format:?} {sampler:?}");
            }
        }
    }
}

#[test]
fn odd_coordinates_and_derivatives_give_colours_of_the_texture() {
    let odd =
        [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, -1e30, 1e9, -1e-30, -0.0, 1.0, 0.999_999_94, 1e-45];
    let mut random = Random(5);
    for format in FORMATS {
        let texture = random.texture([7, 4], format);
        for (i, sampler) in wrapped_samplers().into_iter().enumerate() {
            let sampler = sampler.with_anisotropy(if i % 3 == 0 { 255 } else { 1 });
            for round in 0..odd.len() {
                let pair = |shift: usize| {
                    let value = |lane: usize| odd[(lane + round * shift) % odd.len()];
                    [core::array::from_fn(value), core::array::from_fn(|lane| value(lane * 3 + shift))]
                };
                let points = Points { uv: pair(1), ddx: pair(2), ddy: pair(5) };
                for value in sample(&texture, &sampler, &points).into_iter().flatten() {
                    assert!((-1.0..=1.0).contains(&value), "{value} {format:?} {sampler:?}");
                }
            }
        }
    }
}

#[test]
fn odd_sampler_values_are_clamped() {
    let mut random = Random(6);
    let texture = random.texture([7, 4], TexelFormat::Rgba8);
    let odd = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX];
    for (i, value) in odd.into_iter().enumerate() {
        let sampler = Sampler {
            lod_bias: value,
            lod_min: odd[(i + 1) % 4],
            lod_max: odd[(i + 2) % 4],
            max_anisotropy: 0,
            wrap_u: Wrap::Border([value; 4]),
            ..Sampler::TRILINEAR
        };
        let points = random.points([7, 4]);
        assert!(sample(&texture, &sampler, &points).into_iter().flatten().all(f32::is_finite));
    }
}

#[test]
fn what_is_transparent_does_not_bleed() {
    // Opaque red beside transparent green, in no even pattern.
    let texels: Vec<u8> = (0..13 * 9).flat_map(|i| if i % 5 < 3 { [255, 0, 0, 255] } else { [0, 255, 0, 0] }).collect();
    let floats: Vec<f32> = texels.iter().map(|byte| f32::from(*byte) / 255.0).collect();
    let mut random = Random(11);
    for format in [TexelFormat::Rgba8Srgb, TexelFormat::Rgba8, TexelFormat::Rgba32Float] {
        let desc = TextureDesc { alpha: Alpha::Coverage, ..TextureDesc::new([13, 9], format) };
        let texture = if format.is_float() {
            Texture::from_floats(&desc, &floats).unwrap()
        } else {
            Texture::from_bytes(&desc, &texels).unwrap()
        };
        for sampler in samplers() {
            for [r, g, b, a] in sample(&texture, &sampler, &random.points([13, 9])) {
                assert_eq!([g, b], [0.0, 0.0], "{format:?} {sampler:?}");
                assert!((r - a).abs() < 1e-6, "premultiplied red is alpha: {r} {a}");
            }
        }
    }
}

#[test]
fn an_even_colour_stays_exactly_itself() {
    for format in [TexelFormat::Rgba8Srgb, TexelFormat::Rgba8] {
        let bytes = [255, 188, 0, 255].repeat(21 * 13);
        let texture = Texture::from_bytes(&TextureDesc::new([21, 13], format), &bytes).unwrap();
        let expected = texture.texel(0, 0, 0).unwrap();
        assert_eq!([expected[0], expected[2], expected[3]], [1.0, 0.0, 1.0]);
        let mut random = Random(3);
        for sampler in samplers() {
            for colour in sample(&texture, &sampler, &random.points([21, 13])) {
                assert_eq!(colour, expected, "{format:?} {sampler:?}");
            }
        }
    }
}

#[test]
fn anisotropic_filtering_keeps_detail_across_the_long_axis() {
    // Stripes along u; a footprint of 16 texels along u and half a texel across.
    let bytes: Vec<u8> = (0..64 * 64).map(|i| if i / 64 % 2 == 0 { 255 } else { 0 }).collect();
    let texture = Texture::from_bytes(&TextureDesc::new([64, 64], TexelFormat::R8), &bytes).unwrap();
    let centres = core::array::from_fn(|i| (i as f32 + 0.5) / 64.0);
    let along = [[16.0 / 64.0; LANES], [0.0; LANES]];
    let across = [[0.0; LANES], [0.5 / 64.0; LANES]];
    let points = Points { uv: [[0.31; LANES], centres], ddx: along, ddy: across };
    let contrast = |sampler: &Sampler| {
        let reds = sample(&texture, sampler, &points).map(|colour| colour[0]);
        (0..LANES - 1).map(|i| (reds[i] - reds[i + 1]).abs()).fold(0.0, f32::max)
    };
    assert!(contrast(&Sampler::TRILINEAR) < 0.01);
    assert!(contrast(&Sampler::TRILINEAR.with_anisotropy(16)) > 0.99);
    let (four, sixteen) =
        (contrast(&Sampler::TRILINEAR.with_anisotropy(4)), contrast(&Sampler::TRILINEAR.with_anisotropy(16)));
    assert!(four < sixteen, "{four} {sixteen}");
}

#[test]
fn anisotropic_filtering_of_a_round_footprint_is_isotropic() {
    let mut random = Random(21);
    let texture = random.texture([32, 32], TexelFormat::Rgba8);
    let size = 3.0 / 32.0;
    let points =
        Points { uv: random.pair(0.0, 1.0), ddx: [[size; LANES], [0.0; LANES]], ddy: [[0.0; LANES], [size; LANES]] };
    let isotropic = sample(&texture, &Sampler::TRILINEAR, &points);
    assert_eq!(sample(&texture, &Sampler::TRILINEAR.with_anisotropy(16), &points), isotropic);
}
