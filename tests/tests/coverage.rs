//! Coverage against a brute-force reference in 128-bit integers, and watertightness at every sample pattern.
#![expect(clippy::cast_possible_truncation, reason = "numbers of pixels")]

use trigon::geometry::{Indices, Primitives};
use trigon::pipeline::{Frame, Outputs, Picture, Renderer};
use trigon::target::SamplePattern;
use trigon_tests::frames::plain_options;
use trigon_tests::random::Random;
use trigon_tests::shaders::ClipShader;

const WIDTH: u32 = 128;
const HEIGHT: u32 = 128;

type Triangle = [[f32; 2]; 3];

fn patterns() -> Vec<SamplePattern> {
    let grids = [1, 4, 9, 16].into_iter().filter_map(SamplePattern::grid);
    grids.chain([1, 2, 4, 8, 16].into_iter().filter_map(SamplePattern::standard)).collect()
}

/// Snaps to 1/256 px, half to even, and evaluates the edge functions exactly, with the top-left rule.
fn reference(triangle: &Triangle, pattern: SamplePattern) -> Vec<bool> {
    let snap = |v: f32| (f64::from(v) * 256.0).round_ties_even() as i128;
    let mut p = triangle.map(|[x, y]| [snap(x), snap(y)]);
    let cross =
        |a: [i128; 2], b: [i128; 2], c: [i128; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if cross(p[0], p[1], p[2]) < 0 {
        p.swap(1, 2);
    }
    let has_area = cross(p[0], p[1], p[2]) != 0;
    let mut covered = Vec::new();
    for position in pattern.positions() {
        for y in 0..i128::from(HEIGHT) {
            for x in 0..i128::from(WIDTH) {
                let s = [x * 256 + i128::from(position[0]), y * 256 + i128::from(position[1])];
                let inside = (0..3).all(|k| {
                    let (a, b) = (p[k], p[(k + 1) % 3]);
                    let e = cross(a, b, s);
                    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
                    e > 0 || (e == 0 && (dy < 0 || (dy == 0 && dx > 0)))
                });
                covered.push(has_area && inside);
            }
        }
    }
    covered
}

/// Draws one triangle and returns `[sample][y][x]`.
fn drawn(renderer: &mut Renderer, picture: &mut Picture, triangle: &Triangle, pattern: SamplePattern) -> Vec<bool> {
    let shader = ClipShader::in_pixels(triangle, WIDTH, HEIGHT);
    let outputs = Outputs { primitive: true, per_sample: true, ..Outputs::NONE };
    let frame = Frame { samples: pattern, outputs, ..Frame::new(WIDTH, HEIGHT) };
    let draws = [shader.draw(Primitives::Triangles(Indices::Sequence(3)))];
    renderer.render(&frame, &draws, picture).unwrap();
    picture.primitive.as_ref().unwrap().values().iter().map(|id| *id == 0).collect()
}

/// Some samples are covered, and those of the reference.
fn check(name: &str, count: u32, make: impl FnMut(&mut Random) -> Triangle) {
    assert!(agreeing(name, count, make) > 0, "{name}: nothing was covered");
}

/// The number of covered samples, all as in the reference.
fn agreeing(name: &str, count: u32, mut make: impl FnMut(&mut Random) -> Triangle) -> usize {
    let mut renderer = Renderer::new(plain_options()).unwrap();
    let mut picture = Picture::default();
    let mut covered = 0;
    for (p, pattern) in patterns().into_iter().enumerate() {
        let mut random = Random::new(p as u64 + 1);
        for i in 0..count {
            let triangle = make(&mut random);
            let expected = reference(&triangle, pattern);
            let actual = drawn(&mut renderer, &mut picture, &triangle, pattern);
            covered += expected.iter().filter(|c| **c).count();
            let first = expected.iter().zip(&actual).position(|(e, a)| e != a);
            assert_eq!(first, None, "{name} {i} at {pattern}: {triangle:?}");
        }
    }
    covered
}

fn any_point(r: &mut Random, low: f32, high: f32) -> [f32; 2] {
    [r.between(low, high), r.between(low, high)]
}

#[test]
fn random_triangles() {
    check("random", 24, |r| [0; 3].map(|_| any_point(r, -20.0, 150.0)));
}

#[test]
fn tiny_triangles() {
    check("tiny", 60, |r| {
        let at = any_point(r, 0.0, 126.0);
        [0; 3].map(|_| [at[0] + r.between(0.0, 3.0), at[1] + r.between(0.0, 3.0)])
    });
}

#[test]
fn slivers() {
    check("sliver", 24, |r| {
        let (a, b) = (any_point(r, 0.0, 128.0), any_point(r, 0.0, 128.0));
        [a, b, [a[0] + r.between(-0.1, 0.1), a[1] + r.between(-0.1, 0.1)]]
    });
}

#[test]
fn huge_triangles_to_the_edge_of_the_guard_band() {
    // Multiples of 1/4 px: exact in f32 up to the guard band.
    let quarter = |r: &mut Random| (r.below(131_073) as f32 - 65_536.0) / 4.0;
    check("huge", 24, |r| [0; 3].map(|_| [quarter(r), quarter(r)]));
}

#[test]
fn vertices_on_centres_and_corners() {
    check("half pixels", 60, |r| {
        let at = [r.below(100), r.below(100)];
        [0; 3].map(|_| [(at[0] * 2 + r.below(30)) as f32 / 2.0, (at[1] * 2 + r.below(30)) as f32 / 2.0])
    });
}

#[test]
fn vertices_on_samples() {
    check("sixteenths", 60, |r| {
        let at = [r.below(100), r.below(100)];
        [0; 3].map(|_| [(at[0] * 16 + r.below(200)) as f32 / 16.0, (at[1] * 16 + r.below(200)) as f32 / 16.0])
    });
}

#[test]
fn degenerate_triangles_cover_nothing() {
    let covered = agreeing("degenerate", 20, |r| {
        let (a, b) = (any_point(r, 0.0, 128.0), any_point(r, 0.0, 128.0));
        [a, b, if r.below(2) == 0 { a } else { b }]
    });
    assert_eq!(covered, 0);
}

#[test]
fn a_closed_mesh_covers_every_sample_exactly_once() {
    let mut renderer = Renderer::new(plain_options()).unwrap();
    let mut picture = Picture::default();
    for (p, pattern) in patterns().into_iter().enumerate() {
        let mut counts = vec![0u32; (WIDTH * HEIGHT) as usize * pattern.count()];
        for triangle in jittered_grid(&mut Random::new(77 + p as u64)) {
            let covered = drawn(&mut renderer, &mut picture, &triangle, pattern);
            for (count, covered) in counts.iter_mut().zip(covered) {
                *count += u32::from(covered);
            }
        }
        assert_eq!(counts.iter().position(|c| *c != 1), None, "at {pattern}");
    }
}

/// Triangles that tile more than the picture, with random diagonals and windings.
fn jittered_grid(r: &mut Random) -> Vec<Triangle> {
    let (cells, size) = (9usize, 17.3f32);
    let mut points = Vec::new();
    for j in 0..=cells {
        for i in 0..=cells {
            points.push([i as f32 * size - 8.0 + r.between(-4.0, 4.0), j as f32 * size - 8.0 + r.between(-4.0, 4.0)]);
        }
    }
    let mut triangles = Vec::new();
    for j in 0..cells {
        for i in 0..cells {
            let at = |i: usize, j: usize| points[j * (cells + 1) + i];
            let (a, b, c, d) = (at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1));
            let pair = if r.below(2) == 0 { [[a, c, b], [b, c, d]] } else { [[a, c, d], [a, d, b]] };
            triangles.extend(pair.map(|t| if r.below(2) == 0 { t } else { [t[0], t[2], t[1]] }));
        }
    }
    triangles
}
