//! Frames of triangles, lines and points given in clip space: coverage, depth, blending, discard, samples, outputs.

use super::NamedFrame;
use crate::frames::draw_with;
use crate::random::Random;
use crate::shaders::ClipShader;
use std::rc::Rc;
use trigon::geometry::{Cull, Indices, Primitives};
use trigon::pipeline::{Draw, Frame, Outputs};
use trigon::raster::{DepthCompare, DepthTest};
use trigon::resolve::Blend;
use trigon::target::{SamplePattern, ShadingRate};

/// Every image that a frame can have.
pub(super) const ALL_OUTPUTS: Outputs = Outputs {
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

const PER_SAMPLE: Outputs = Outputs { per_sample: true, ..ALL_OUTPUTS };

/// Beyond 40 000 pixels a renderer uses all of its threads.
const LARGE: [u32; 2] = [301, 199];
const SMALL: [u32; 2] = [97, 83];

type Shaders = [ClipShader; 3];
type Draws = fn(&Shaders) -> Vec<Draw<'_>>;

pub(super) fn frames() -> Vec<NamedFrame> {
    let mut shaders = [soup(1, 3000, 1.0), soup(2, 150, 0.5), soup(3, 400, 1.0)];
    shaders[2].discard_below = 0.4;
    let shaders = Rc::new(shaders);
    let standard = |n| SamplePattern::standard(n).expect("a standard pattern");
    let frame = |name: &str, [width, height]: [u32; 2], samples, shading, outputs, draws: Draws| {
        let clear = [0.1, 0.2, 0.3, 0.5];
        let frame = Frame { samples, shading, outputs, clear, ..Frame::new(width, height) };
        let shaders = Rc::clone(&shaders);
        NamedFrame::new(format!("clip-space/{name}"), move |options| draw_with(options, &frame, &draws(&shaders)).0)
    };
    let (center, by_pixel) = (SamplePattern::CENTER, ShadingRate::Pixel);
    let mut frames = vec![
        frame("opaque-1", LARGE, center, by_pixel, ALL_OUTPUTS, opaque).large(),
        frame("mixed-1", LARGE, center, by_pixel, ALL_OUTPUTS, mixed).large(),
        frame("mixed-standard-4", LARGE, standard(4), by_pixel, ALL_OUTPUTS, mixed).large(),
        frame("mixed-standard-16", SMALL, standard(16), by_pixel, PER_SAMPLE, mixed),
        frame("mixed-standard-4-shaded-by-sample", SMALL, standard(4), ShadingRate::Sample, ALL_OUTPUTS, mixed),
        frame("depth-only", LARGE, standard(4), by_pixel, Outputs::DEPTH, opaque).large(),
        frame("blends", SMALL, standard(4), by_pixel, ALL_OUTPUTS, blends),
        frame("strokes", SMALL, standard(8), by_pixel, ALL_OUTPUTS, strokes),
    ];
    for pattern in patterns() {
        let name = format!("opaque-{pattern}-shaded-by-sample").replace(' ', "-");
        frames.push(frame(&name, SMALL, pattern, ShadingRate::Sample, PER_SAMPLE, opaque));
    }
    frames
}

/// Every sample pattern with more than one sample.
fn patterns() -> impl Iterator<Item = SamplePattern> {
    let grids = [4, 9, 16].into_iter().filter_map(SamplePattern::grid);
    grids.chain([2, 4, 8, 16].into_iter().filter_map(SamplePattern::standard))
}

/// Triangles of all sizes in perspective, some crossing the near plane, some far outside.
#[must_use]
pub fn soup(seed: u64, count: usize, alpha: f32) -> ClipShader {
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

fn triangles(shader: &ClipShader) -> Draw<'_> {
    let count = u32::try_from(shader.positions.len()).unwrap_or(0);
    shader.draw(Primitives::Triangles(Indices::Sequence(count)))
}

fn lines(shader: &ClipShader, count: u32, width_px: f32) -> Draw<'_> {
    shader.draw(Primitives::Lines { indices: Indices::Sequence(count), width_px })
}

fn points(shader: &ClipShader, count: u32, size_px: f32) -> Draw<'_> {
    shader.draw(Primitives::Points { indices: Indices::Sequence(count), size_px })
}

fn opaque(s: &Shaders) -> Vec<Draw<'_>> {
    vec![triangles(&s[0])]
}

fn mixed(s: &Shaders) -> Vec<Draw<'_>> {
    vec![
        triangles(&s[0]),
        Draw { blend: Blend::Over, depth: DepthTest::NEARER, ..triangles(&s[1]) },
        Draw { cull: Cull::Back, object: 7, ..triangles(&s[2]) },
        Draw { object: 8, ..lines(&s[0], 200, 2.5) },
        Draw { object: 9, ..points(&s[1], 300, 3.0) },
        Draw { blend: Blend::Add, depth: DepthTest::OFF, ..triangles(&s[1]) },
    ]
}

fn blends(s: &Shaders) -> Vec<Draw<'_>> {
    let or_equal = |write| DepthTest { compare: DepthCompare::NearerOrEqual, write };
    vec![
        Draw { depth: or_equal(true), ..triangles(&s[1]) },
        Draw { blend: Blend::Multiply, depth: or_equal(false), ..triangles(&s[1]) },
        Draw { blend: Blend::Add, cull: Cull::Front, ..triangles(&s[2]) },
        Draw { blend: Blend::Over, ..triangles(&s[2]) },
        Draw { blend: Blend::Replace, depth: DepthTest::OFF, ..points(&s[2], 200, 9.0) },
        Draw { blend: Blend::Multiply, depth: DepthTest::OFF, ..triangles(&s[0]) },
    ]
}

fn strokes(s: &Shaders) -> Vec<Draw<'_>> {
    let widths = [0.3, 1.0, 1.5, 7.0, 40.0];
    let lines = (1..).zip(widths).map(|(object, width)| Draw { object, ..lines(&s[0], 120 * object, width) });
    let points = (11..).zip(widths).map(|(object, size)| Draw { object, ..points(&s[1], 12 * object, size) });
    lines.chain(points).collect()
}
