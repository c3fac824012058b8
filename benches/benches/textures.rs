//! Texture sampling: one square that fills the picture, at about 1.4 texels a pixel, through each filter.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use std::time::Duration;
use trigon::geometry::{Indices, Primitives};
use trigon::lanes::{Lanes, Rgba, SimdLevel, U32, Vec2};
use trigon::pipeline::{Draw, Frame, Picture, Renderer, RendererOptions};
use trigon::schedule::TileOrder;
use trigon::shade::texture::{LevelFilter, PixelFilter, Sampler, TexelFormat, Texture, TextureDesc};
use trigon::shade::{Fragment, Shader, Vertex};

const SIDE: u32 = 1024;

/// Corners of the square in NDC, two triangles.
const CORNERS: [[f32; 2]; 6] = [[-1.0, 1.0], [-1.0, -1.0], [1.0, 1.0], [1.0, 1.0], [-1.0, -1.0], [1.0, -1.0]];

struct Square<'a> {
    texture: &'a Texture,
    sampler: Sampler,
}

impl Shader for Square<'_> {
    type Varying<L: Lanes> = Vec2<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, Vec2<L>> {
        let at = index.gather_vec2(&CORNERS);
        let position = at.x.token().vec4([0.0, 0.0, 0.5, 1.0]);
        let position = trigon::lanes::Vec4 { x: at.x, y: at.y, ..position };
        // Turned a little, so that no row of texels is a row of pixels.
        let turned = Vec2 { x: at.x * 0.66 + at.y * 0.2, y: at.y * 0.66 - at.x * 0.2 };
        Vertex { position, varying: turned + l.vec2([0.5, 0.5]) }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, Vec2<L>>) -> Rgba<L> {
        self.texture.sample(l, &self.sampler, f.varying, f.dx, f.dy)
    }
}

fn grain(format: TexelFormat) -> Texture {
    let bytes: Vec<u8> = (0..SIDE * SIDE).flat_map(|i| i.wrapping_mul(2_654_435_761).to_le_bytes()).collect();
    let opaque: Vec<u8> = bytes.chunks_exact(4).flat_map(|t| [t[1], t[2], t[3], u8::MAX]).collect();
    Texture::from_bytes(&TextureDesc::new([SIDE, SIDE], format), &opaque).expect("a valid description")
}

fn filters(criterion: &mut Criterion) {
    let options = RendererOptions { threads: 1, simd: SimdLevel::detect(), tile_order: TileOrder::default() };
    let mut renderer = Renderer::new(options).expect("the detected level is available");
    let (srgb, linear) = (grain(TexelFormat::Rgba8Srgb), grain(TexelFormat::Rgba8));
    let of = |pixel, level| Sampler::TRILINEAR.with_filters(pixel, level);
    let trilinear = Sampler::TRILINEAR;
    let cases = [
        ("nearest", &srgb, of(PixelFilter::Nearest, LevelFilter::Zero)),
        ("bilinear", &srgb, of(PixelFilter::Bilinear, LevelFilter::Zero)),
        ("nearest level", &srgb, of(PixelFilter::Bilinear, LevelFilter::Nearest)),
        ("trilinear", &srgb, trilinear),
        ("trilinear, not sRGB", &linear, trilinear),
        ("anisotropic 8", &srgb, trilinear.with_anisotropy(8)),
    ];
    let mut group = criterion.benchmark_group("textures");
    group.sample_size(20).throughput(Throughput::Elements(u64::from(SIDE) * u64::from(SIDE)));
    for (name, texture, sampler) in cases {
        let shader = Square { texture, sampler };
        let draw = Draw::new(&shader, Primitives::Triangles(Indices::Sequence(6)));
        let (frame, mut picture) = (Frame::new(SIDE, SIDE), Picture::default());
        group.bench_function(name, |bencher| {
            bencher.iter_custom(|count| {
                let render = |_| renderer.render(&frame, &[draw], &mut picture).expect("the frame is not too large");
                (0..count).map(render).map(|statistics| statistics.tile_time).sum::<Duration>()
            });
        });
    }
    group.finish();
}

criterion_group!(benches, filters);
criterion_main!(benches);
