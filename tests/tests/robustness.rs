//! Broken input: numbers that are none, indices that point nowhere, nothing at all. No panic; losses are counted.

use trigon::geometry::{Indices, Primitives};
use trigon::pipeline::{Frame, FrameError, Outputs};
use trigon::target::SamplePattern;
use trigon_tests::frames::{draw_with, plain_options};
use trigon_tests::random::Random;
use trigon_tests::shaders::ClipShader;

const ODD: [f32; 14] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    f32::NAN,
    f32::INFINITY,
    f32::NEG_INFINITY,
    f32::MAX,
    f32::MIN,
    f32::MIN_POSITIVE,
    1e-45,
    1e20,
    -1e10,
    16384.0,
];

fn odd_shader(seed: u64, count: usize) -> ClipShader {
    let mut r = Random::new(seed);
    let mut any = || if r.below(3) == 0 { ODD[r.below(14) as usize] } else { r.between(-2.0, 2.0) };
    let positions: Vec<[f32; 4]> = (0..count).map(|_| [any(), any(), any(), any()]).collect();
    let colors = (0..count).map(|_| [any(), any(), any(), any()]).collect();
    ClipShader { positions, colors, discard_below: 0.0 }
}

#[test]
fn odd_numbers_neither_panic_nor_leak_nan() {
    let outputs = Outputs { color: true, color_f32: true, depth: true, normal: true, ..Outputs::NONE };
    for samples in [SamplePattern::CENTER, SamplePattern::standard(4).unwrap()] {
        let frame = Frame { samples, outputs, ..Frame::new(97, 61) };
        for seed in 0..60 {
            let shader = odd_shader(seed as u64, 300);
            let all = Indices::Sequence(300);
            let draws = [
                shader.draw(Primitives::Triangles(all)),
                shader.draw(Primitives::Lines { indices: all, width_px: ODD[seed % ODD.len()] }),
                shader.draw(Primitives::Points { indices: all, size_px: 5.0 }),
            ];
            let (picture, statistics) = draw_with(plain_options(), &frame, &draws);
            assert_eq!(statistics.geometry.submitted, 100 + 150 + 300);
            assert!(statistics.geometry.dropped > 0, "a third of the numbers are odd");
            let depth = picture.depth.unwrap();
            assert!(depth.values().iter().all(|d| !d.is_nan()), "NaN depth at seed {seed}");
        }
    }
}

#[test]
fn indices_out_of_range_read_as_zero_vertices_and_are_dropped() {
    let shader = ClipShader::in_pixels(&[[0.0, 0.0], [50.0, 0.0], [0.0, 50.0]], 64, 64);
    let indices = [0, 1, u32::MAX, 7, 8, 9, 0, 1, 2];
    let draw = shader.draw(Primitives::Triangles(Indices::List(&indices)));
    let (_, statistics) = draw_with(plain_options(), &Frame::new(64, 64), &[draw]);
    assert_eq!(statistics.geometry.drawn, 1);
    assert_eq!(statistics.geometry.submitted, 3);
}

#[test]
fn nothing_to_draw_gives_the_clear_colour() {
    let shader = ClipShader::default();
    let frame = Frame { clear: [1.0, 0.0, 0.0, 1.0], ..Frame::new(65, 3) };
    for draws in [vec![], vec![shader.draw(Primitives::Triangles(Indices::List(&[])))]] {
        let (picture, statistics) = draw_with(plain_options(), &frame, &draws);
        assert!(picture.color.unwrap().values().iter().all(|c| *c == [255, 0, 0, 255]));
        assert_eq!(statistics.geometry.drawn, 0);
    }
}

#[test]
fn sizes_outside_the_limits_are_refused() {
    let mut renderer = trigon::pipeline::Renderer::new(plain_options()).unwrap();
    for (width, height) in [(0, 5), (5, 0), (16_385, 1), (1, u32::MAX)] {
        let result = renderer.render(&Frame::new(width, height), &[], &mut Default::default());
        assert_eq!(result.err(), Some(FrameError::Size { width, height }));
    }
}
