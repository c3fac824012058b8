//! Coverage against brute force: the winding number of each sample, summed over all segments in exact arithmetic, for
//! random paths, every pattern and both rules; and shapes that share edges, which must cover each sample once.

use trigon::target::SamplePattern;
use trigon_image::Color;
use trigon_svg::canvas::{BlendMode, Drawing, FillRule, Path, Renderer, Transform};

const SIZE: u32 = 24;

/// Numbers from a fixed seed.
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }

    /// A coordinate of -8 to 32 px, in 1/256 px; often whole, or on a row or column of samples.
    fn coordinate(&mut self) -> i64 {
        let fine = self.below(40 * 256) as i64;
        let fine = match self.below(4) {
            0 => fine & !255,
            1 => (fine & !63) + 32,
            _ => fine,
        };
        fine - 8 * 256
    }

    fn polygon(&mut self, corners: u64) -> Vec<[i64; 2]> {
        (0..corners).map(|_| [self.coordinate(), self.coordinate()]).collect()
    }
}

fn patterns() -> Vec<SamplePattern> {
    let grids = [1, 4, 9, 16].into_iter().filter_map(SamplePattern::grid);
    grids.chain([1, 2, 4, 8, 16].into_iter().filter_map(SamplePattern::standard)).collect()
}

fn path(contours: &[Vec<[i64; 2]>]) -> Path {
    let mut path = Path::new();
    for contour in contours {
        for (i, [x, y]) in contour.iter().enumerate() {
            let (x, y) = (*x as f32 / 256.0, *y as f32 / 256.0);
            if i == 0 {
                path.move_to(x, y)
            } else {
                path.line_to(x, y)
            };
        }
        path.close();
    }
    path
}

/// The winding number at a point, both in 1/256 px: segments whose upper end is at or above it, whose lower end is below
/// it, and that cross its row at or left of it.
fn winding(contours: &[Vec<[i64; 2]>], [x, y]: [i64; 2]) -> i32 {
    let mut sum = 0;
    for contour in contours {
        for (i, a) in contour.iter().enumerate() {
            let b = contour[(i + 1) % contour.len()];
            let (upper, lower, direction) = if a[1] < b[1] { (*a, b, 1) } else { (b, *a, -1) };
            if upper[1] <= y && y < lower[1] {
                // upper.x + (y - upper.y) * dx / dy <= x, times dy.
                let (dx, dy) = (i128::from(lower[0] - upper[0]), i128::from(lower[1] - upper[1]));
                let crossing = i128::from(upper[0]) * dy + i128::from(y - upper[1]) * dx;
                if crossing <= i128::from(x) * dy {
                    sum += direction;
                }
            }
        }
    }
    sum
}

/// How many samples of a pixel are inside.
fn covered(contours: &[Vec<[i64; 2]>], rule: FillRule, pattern: SamplePattern, x: u32, y: u32) -> usize {
    let origin = [i64::from(x) * 256, i64::from(y) * 256];
    let is_inside = |position: &&[i16; 2]| {
        let number = winding(contours, [origin[0] + i64::from(position[0]), origin[1] + i64::from(position[1])]);
        if rule == FillRule::NonZero { number != 0 } else { number % 2 != 0 }
    };
    pattern.positions().iter().filter(is_inside).count()
}

/// White with the alpha of `count` covered samples, premultiplied.
fn expected(count: usize, pattern: SamplePattern) -> [u8; 4] {
    [u8::try_from((count * 255 * 2 + pattern.count()) / (2 * pattern.count())).unwrap(); 4]
}

fn check(contours: &[Vec<[i64; 2]>], rule: FillRule, pattern: SamplePattern) {
    let mut drawing = Drawing::new();
    drawing.fill(path(contours), rule, Transform::IDENTITY, Color::WHITE, 1.0, BlendMode::Normal);
    let renderer = Renderer { pattern, ..Renderer::new() };
    let picture = renderer.draw(&drawing, SIZE, SIZE, Color::TRANSPARENT).unwrap();
    for (index, pixel) in (0..).zip(picture.pixels()) {
        let (x, y) = (index % SIZE, index / SIZE);
        let count = covered(contours, rule, pattern, x, y);
        assert_eq!(*pixel, expected(count, pattern), "pixel ({x}, {y}), {pattern}, {rule:?}: {contours:?}");
    }
}

#[test]
fn random_paths_cover_the_samples_of_their_winding_number() {
    let mut random = Random(1);
    for round in 0..40 {
        let contours: Vec<_> = (0..1 + round % 3).map(|_| random.polygon(3 + round % 7)).collect();
        for pattern in patterns() {
            for rule in [FillRule::NonZero, FillRule::EvenOdd] {
                check(&contours, rule, pattern);
            }
        }
    }
}

#[test]
fn winding_numbers_above_a_byte_are_exact() {
    // 256 times round, and 300 there and 44 back: sums that are 0 in eight bits.
    let square = vec![[512, 512], [4096, 700], [4000, 4096], [300, 4000]];
    let reversed: Vec<[i64; 2]> = square.iter().rev().copied().collect();
    let wound = |n: usize| std::iter::repeat_n(square.clone(), n);
    let there_and_back: Vec<_> = wound(300).chain(std::iter::repeat_n(reversed, 44)).collect();
    for contours in [wound(256).collect(), wound(257).collect(), there_and_back] {
        for pattern in [SamplePattern::grid(16).unwrap(), SamplePattern::standard(8).unwrap()] {
            check(&contours, FillRule::NonZero, pattern);
            check(&contours, FillRule::EvenOdd, pattern);
        }
    }
}

#[test]
fn shapes_that_share_edges_cover_each_sample_once() {
    let mut random = Random(9);
    for _ in 0..20 {
        // Triangles round a point inside a frame, each drawn with half of its light: doubled samples would be brighter.
        let center = [random.below(12 * 256) as i64 + 6 * 256, random.below(12 * 256) as i64 + 6 * 256];
        let frame = [
            [0, 0],
            [random.below(6144) as i64, 0],
            [6144, 0],
            [6144, 6144],
            [random.below(6144) as i64, 6144],
            [0, 6144],
        ];
        for pattern in patterns() {
            let mut drawing = Drawing::new();
            for (i, corner) in frame.iter().enumerate() {
                let triangle = path(&[vec![center, *corner, frame[(i + 1) % frame.len()]]]);
                drawing.fill(triangle, FillRule::NonZero, Transform::IDENTITY, Color::WHITE, 0.5, BlendMode::Normal);
            }
            let renderer = Renderer { pattern, ..Renderer::new() };
            let picture = renderer.draw(&drawing, SIZE, SIZE, Color::TRANSPARENT).unwrap();
            assert!(picture.pixels().iter().all(|pixel| *pixel == [128; 4]), "{pattern}");
        }
    }
}
