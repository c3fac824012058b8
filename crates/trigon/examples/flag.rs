//! A flag in the wind, to `flag.png`: a shader whose vertex stage bends a grid, with no mesh but the numbers of its vertices.
//!
//! The emblem is a triangle: inside three lines, as in the rasterizer, smooth by the exact size of a pixel on the cloth.

use trigon::lanes::{Lanes, Mat4, Rgba, U32, Vec2, Vec3};
use trigon::math::{cos, sin};
use trigon::pipeline::{Draw, Frame, Picture, Renderer, RendererOptions};
use trigon::shade::{Fragment, Shader, Vertex};
use trigon::{Indices, Primitives, target::SamplePattern};
use trigon_image::{EncodeOptions, Format, Rgba8Image, encode};

trigon::varying! {
    struct Cloth { uv: Vec2, normal: Vec3 } // interpolated between the corners of a triangle
}

struct Flag {
    clip_from_world: Mat4,
}
impl Shader for Flag {
    type Varying<L: Lanes> = Cloth<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, Cloth<L>> {
        let (u, v) = ((index & l.u32(63)).to_f32() / 63.0, (index >> 6).to_f32() / 63.0); // 64 x 64 vertices
        let (phase, height) = (u * 10.0 - v * 2.5, u * 0.24); // waves grow away from the pole
        let position = Vec3 { x: u * 3.0 - 1.5, y: 1.0 - v * 2.0 - u * u * 0.15, z: height * sin(phase) };
        let slope = height * cos(phase);
        let normal = Vec3 { x: slope * (-10.0 / 3.0), y: slope * -1.25, z: l.f32(1.0) };
        let varying = Cloth { uv: Vec2 { x: u, y: v }, normal };
        Vertex { position: self.clip_from_world.transform_point(l, position), varying }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, Cloth<L>>) -> Rgba<L> {
        let (x, y) = (f.uv.x * 1.5 - 0.75, f.uv.y - 0.56); // in heights of the flag, from the middle of the emblem
        let inside = (0.16 - y).min((x * 0.866 + y * 0.5) + 0.16).min((y * 0.5 - x * 0.866) + 0.16);
        let pixel = f.dx.uv.y.abs() + f.dy.uv.y.abs() + 1e-6;
        let color = l.vec3([0.01, 0.10, 0.16]).mix(l.vec3([0.95, 0.62, 0.12]), (inside / pixel + 0.5).saturate());
        let light = f.normal.normalize().dot(l.vec3([-0.60, 0.48, 0.64])).max(0.0) * 1.1 + 0.15;
        (color * light).rgba(1.0)
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let quads = (0..63 * 63).map(|i| i / 63 * 64 + i % 63); // the number of each one's upper left vertex
    let triangles: Vec<u32> = quads.flat_map(|i| [i, i + 64, i + 1, i + 1, i + 64, i + 65]).collect();
    // The columns are where the axes and the origin go: turned by 20 degrees, 4.6 in front of the eye, near plane at 1.
    let columns = [[2.0, 0., 0., 0.34], [0., 3.2, 0., 0.], [0.73, 0., 0., -0.94], [0.25, 0.25, 1., 4.6]];
    let flag = Flag { clip_from_world: Mat4 { columns } };

    let samples = SamplePattern::standard(8).ok_or("a standard pattern has 1, 2, 4, 8 or 16 samples")?;
    let frame = Frame { samples, clear: [0.79, 0.81, 0.83, 1.0], ..Frame::new(720, 480) };
    let mut picture = Picture::default();
    let draw = Draw::new(&flag, Primitives::Triangles(Indices::List(&triangles)));
    Renderer::new(RendererOptions::from_env()?)?.render(&frame, &[draw], &mut picture)?;
    let pixels = picture.color.ok_or("a frame has colour unless told otherwise")?.into_values();
    let image = Rgba8Image::from_pixels(720, 480, pixels)?;
    Ok(std::fs::write("flag.png", encode(&image, Format::Png, &EncodeOptions::default())?)?)
}
