//! One picture, whatever draws it: equal hashes over SIMD levels, thread counts and tile orders, in 8 bits and in f32.

use std::collections::BTreeSet;
use trigon::geometry::{Indices, Primitives};
use trigon::lanes::SimdLevel;
use trigon::pipeline::{Draw, Frame, Outputs, RendererOptions};
use trigon::schedule::TileOrder;
use trigon::target::SamplePattern;
use trigon_tests::corpus;
use trigon_tests::corpus::soup;
use trigon_tests::frames::{draw_with, hash, levels, plain_options};
use trigon_tests::shaders::ClipShader;

const ORDERS: [TileOrder; 4] =
    [TileOrder::MostWorkFirst, TileOrder::Rows, TileOrder::RowsReversed, TileOrder::Scattered];

#[test]
fn frames_agree_over_levels_threads_and_tile_orders() {
    let levels = levels();
    for frame in corpus::all() {
        let expected = frame.hash(RendererOptions { simd: SimdLevel::Scalar, ..plain_options() });
        for &simd in &levels {
            // Small frames are drawn by one thread, whatever the options say.
            let threads: &[usize] = if frame.is_large { &[1, 2, 3, 7] } else { &[1] };
            for (&threads, tile_order) in threads.iter().flat_map(|t| ORDERS.map(|order| (t, order))) {
                if frame.is_large || tile_order == TileOrder::Scattered {
                    let hash = frame.hash(RendererOptions { threads, simd, tile_order });
                    assert_eq!(hash, expected, "{}: {simd}, {threads} threads, {tile_order:?}", frame.name);
                }
            }
        }
    }
}

#[test]
fn names_of_frames_are_unique_and_hashes_differ() {
    let frames = corpus::all();
    let names: BTreeSet<&str> = frames.iter().map(|frame| frame.name.as_str()).collect();
    let hashes: BTreeSet<u64> = frames.iter().map(|frame| frame.hash(plain_options())).collect();
    assert_eq!((names.len(), hashes.len()), (frames.len(), frames.len()));
}

#[test]
fn a_rotated_index_list_draws_the_same_bits() {
    let shader = soup(5, 1500, 1.0);
    let count = u32::try_from(shader.positions.len()).unwrap();
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
            hash(&draw_with(plain_options(), &frame, &[draw]).0)
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
