//! One picture, whatever draws it: equal hashes over SIMD levels, thread counts and tile orders, in 8 bits and in f32.

use trigon::geometry::{Cull, Indices, Primitives};
use trigon::lanes::SimdLevel;
use trigon::pipeline::{Draw, Frame, Outputs, RendererOptions};
use trigon::raster::DepthTest;
use trigon::resolve::Blend;
use trigon::schedule::TileOrder;
use trigon::target::{SamplePattern, ShadingRate};
use trigon_tests::frames::{draw_with, hash, levels};
use trigon_tests::random::Random;
use trigon_tests::shaders::ClipShader;

const ALL_OUTPUTS: Outputs = Outputs {
    color: true,
    color_f32: true,
    depth: true,
    primitive: true,
    object: true,
    normal: true,
    position: true,
    uv: true,
    per_sample: false,
};

/// Triangles of all sizes in perspective, some crossing the near plane, some far outside.
fn soup(seed: u64, count: usize, alpha: f32) -> ClipShader {
    let mut r = Random::new(seed);
    let mut shader = ClipShader::default();
    for _ in 0..count {
        let size = [0.01, 0.05, 0.3, 3.0][r.below(4) as usize];
        let center = [r.between(-1.2, 1.2), r.between(-1.2, 1.2), r.between(-0.05, 0.9)];
        for _ in 0..3 {
            let p = center.map(|c| c + r.between(-size, size));
            let w = 1.2 - p[2];
            shader.positions.push([p[0] * w, p[1] * w, 0.1, w]);
            shader.colors.push([r.unit() * alpha, r.unit() * alpha, r.unit() * alpha, alpha]);
        }
    }
    shader
}

struct Case {
    name: &'static str,
    samples: SamplePattern,
    shading: ShadingRate,
    outputs: Outputs,
    draws: fn(&[ClipShader; 3]) -> Vec<Draw<'_>>,
}

fn triangles(shader: &ClipShader) -> Draw<'_> {
    Draw::new(shader, Primitives::Triangles(Indices::Sequence(shader.positions.len() as u32)))
}

fn cases() -> Vec<Case> {
    let per_sample = Outputs { per_sample: true, ..ALL_OUTPUTS };
    let (one, four) = (SamplePattern::CENTER, SamplePattern::standard(4).unwrap());
    let opaque: fn(&[ClipShader; 3]) -> Vec<Draw<'_>> = |s| vec![triangles(&s[0])];
    let mixed: fn(&[ClipShader; 3]) -> Vec<Draw<'_>> = |s| {
        let lines = Primitives::Lines { indices: Indices::Sequence(200), width_px: 2.5 };
        let points = Primitives::Points { indices: Indices::Sequence(300), size_px: 3.0 };
        vec![
            triangles(&s[0]),
            Draw { blend: Blend::Over, depth: DepthTest::NEARER, ..triangles(&s[1]) },
            Draw { cull: Cull::Back, object: 7, ..triangles(&s[2]) },
            Draw { object: 8, ..Draw::new(&s[0], lines) },
            Draw { object: 9, ..Draw::new(&s[1], points) },
            Draw { blend: Blend::Add, depth: DepthTest::OFF, ..triangles(&s[1]) },
        ]
    };
    let case = |name, samples, shading, outputs, draws| Case { name, samples, shading, outputs, draws };
    vec![
        case("opaque, 1 sample", one, ShadingRate::Pixel, ALL_OUTPUTS, opaque),
        case("opaque, 4 samples", four, ShadingRate::Pixel, ALL_OUTPUTS, opaque),
        case("opaque, grid 9, per sample", SamplePattern::grid(9).unwrap(), ShadingRate::Sample, per_sample, opaque),
        case("mixed, 1 sample", one, ShadingRate::Pixel, ALL_OUTPUTS, mixed),
        case("mixed, 4 samples", four, ShadingRate::Pixel, ALL_OUTPUTS, mixed),
        case("mixed, 16 samples", SamplePattern::standard(16).unwrap(), ShadingRate::Pixel, per_sample, mixed),
        case("depth only", four, ShadingRate::Pixel, Outputs::DEPTH, opaque),
    ]
}

#[test]
fn hashes_agree_over_levels_threads_and_tile_orders() {
    let mut shaders = [soup(1, 3000, 1.0), soup(2, 150, 0.5), soup(3, 400, 1.0)];
    shaders[2].discard_below = 0.4;
    let levels = levels();
    for case in cases() {
        let frame = Frame {
            samples: case.samples,
            shading: case.shading,
            outputs: case.outputs,
            clear: [0.1, 0.2, 0.3, 0.5],
            ..Frame::new(301, 199)
        };
        let draws = (case.draws)(&shaders);
        let run = |threads, simd, tile_order| {
            hash(&draw_with(RendererOptions { threads, simd, tile_order }, &frame, &draws).0)
        };
        let expected = run(1, SimdLevel::Scalar, TileOrder::Rows);
        for &simd in &levels {
            for threads in [1, 2, 3, 7] {
                for order in [TileOrder::MostWorkFirst, TileOrder::Rows, TileOrder::RowsReversed, TileOrder::Scattered]
                {
                    assert_eq!(run(threads, simd, order), expected, "{}: {simd} {threads} {order:?}", case.name);
                }
            }
        }
        println!("{}: {expected:016x}", case.name);
    }
}

#[test]
fn a_rotated_index_list_draws_the_same_bits() {
    let shader = soup(5, 1500, 1.0);
    let count = shader.positions.len() as u32;
    let frame = Frame {
        samples: SamplePattern::standard(4).unwrap(),
        outputs: Outputs { color: true, color_f32: true, depth: true, ..Outputs::NONE },
        ..Frame::new(200, 200)
    };
    let hashes: Vec<u64> = [[0, 1, 2], [1, 2, 0], [2, 0, 1]]
        .into_iter()
        .map(|order| {
            let indices: Vec<u32> = (0..count / 3).flat_map(|t| order.map(|k| t * 3 + k)).collect();
            let shader = ClipShader { colors: vec![[0.7; 4]; count as usize], ..shader.clone() };
            let tint = FlatTint(&shader);
            let draw = Draw::new(&tint, Primitives::Triangles(Indices::List(&indices)));
            hash(&draw_with(trigon_tests::frames::plain_options(), &frame, &[draw]).0)
        })
        .collect();
    assert_eq!(hashes, [hashes[0]; 3]);
}

/// As [`ClipShader`], but without the barycentrics, which name corners by their order.
struct FlatTint<'a>(&'a ClipShader);

impl trigon::shade::Shader for FlatTint<'_> {
    type Varying<L: trigon::lanes::Lanes> = trigon_tests::shaders::Painted<L>;

    #[inline(always)]
    fn vertex<L: trigon::lanes::Lanes>(
        &self,
        l: L,
        index: trigon::lanes::U32<L>,
    ) -> trigon::shade::Vertex<L, Self::Varying<L>> {
        self.0.vertex(l, index)
    }

    #[inline(always)]
    fn fragment<L: trigon::lanes::Lanes>(
        &self,
        _l: L,
        f: &trigon::shade::Fragment<L, Self::Varying<L>>,
    ) -> trigon::lanes::Rgba<L> {
        let slope = f.dx.uv.x + f.dy.uv.y;
        trigon::lanes::Rgba { r: f.uv.x + slope, g: f.uv.y, b: f.depth, a: f.color.w }
    }
}
