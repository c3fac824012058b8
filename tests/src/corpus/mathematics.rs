//! Frames of `trigon::math`: each pixel is a value of four functions, over ranges that contain their hard places.

use super::NamedFrame;
use crate::frames::draw_with;
use trigon::geometry::{Indices, Primitives};
use trigon::lanes::{Lanes, Rgba, U32};
use trigon::math::{acos, atan2, cos, exp, exp2, linear_to_srgb8, log2, pow, powi, rsqrt, sin, srgb8_to_linear};
use trigon::pipeline::{Draw, Frame, Outputs};
use trigon::shade::{Fragment, Shader, Vertex};

/// One triangle that covers the picture.
const POSITIONS: [[f32; 4]; 3] = [[-1.0, -1.0, 0.5, 1.0], [3.0, -1.0, 0.5, 1.0], [-1.0, 3.0, 0.5, 1.0]];

const SIDE: u32 = 128;

/// Which functions.
#[derive(Clone, Copy)]
enum Group {
    Powers,
    Angles,
    Encodings,
}

/// Functions of the pixel's position, scaled to `-1..1`, times `range`.
struct Functions {
    group: Group,
    range: f32,
}

impl Shader for Functions {
    type Varying<L: Lanes> = ();

    #[inline(always)]
    fn vertex<L: Lanes>(&self, _l: L, index: U32<L>) -> Vertex<L, ()> {
        Vertex { position: index.gather_vec4(&POSITIONS), varying: () }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, _l: L, f: &Fragment<L, ()>) -> Rgba<L> {
        let half = SIDE as f32 * 0.5;
        let x = (f.pixel.x / half - 1.0) * self.range;
        let y = (f.pixel.y / half - 1.0) * self.range;
        match self.group {
            Group::Powers => Rgba { r: pow(x.abs(), y), g: powi(x, 13), b: exp2(x) + log2(y.abs()), a: exp(y) },
            Group::Angles => Rgba { r: sin(x * y), g: cos(x) + sin(y), b: atan2(y, x), a: acos(x / self.range) },
            Group::Encodings => {
                let code = linear_to_srgb8(x);
                Rgba { r: code.to_f32(), g: srgb8_to_linear(code), b: rsqrt(y.abs()), a: x.abs().sqrt() / y }
            }
        }
    }
}

pub(super) fn frames() -> Vec<NamedFrame> {
    let mut frames = Vec::new();
    for (group, name) in [(Group::Powers, "powers"), (Group::Angles, "angles"), (Group::Encodings, "encodings")] {
        for (range, scale) in [(1.25, "small"), (40.0, "large")] {
            let shader = Functions { group, range };
            let outputs = Outputs { color: true, color_f32: true, ..Outputs::NONE };
            let frame = Frame { outputs, ..Frame::new(SIDE, SIDE) };
            frames.push(NamedFrame::new(format!("math/{name}-{scale}"), move |options| {
                let draw = Draw::new(&shader, Primitives::Triangles(Indices::Sequence(3)));
                draw_with(options, &frame, &[draw]).0
            }));
        }
    }
    frames
}
