//! 3D and 2D in one picture: an octahedron before a drawn background, with its measures drawn over it.
//!
//! `cargo run --release --package trigon-svg --example labels -- labels.png`
//!
//! Three steps: the background is a [`Drawing`]; the frame of the model, cleared to nothing, is drawn on it as an image;
//! the measures are drawn over both by [`Renderer::draw_over`].

use std::error::Error;
use trigon::lanes::{Lanes, Mat4, Rgba, U32, Vec3};
use trigon::pipeline::{Draw, Frame, Picture as ModelPicture, Renderer as ModelRenderer, RendererOptions};
use trigon::shade::{Fragment, Shader, Vertex};
use trigon::{Indices, Primitives, target::SamplePattern};
use trigon_image::{Color, EncodeOptions, Format, Rgba8Image, encode};
use trigon_svg::canvas::{
    BlendMode, Cap, Drawing, FillRule, GradientStop, Image, ImageFilter, Path, RadialGradient, Renderer, Spread,
    Stroke, Transform,
};

const SIZE: [u32; 2] = [640, 480];

/// Half of the octahedron's height; its other half axes are 1.
const HEIGHT: f32 = 1.3;

/// Where the axes and the origin go: turned by 30 degrees, seen from 15 degrees above, 5 in front of the eye, near plane at 1.
const CLIP_FROM_WORLD: [[f32; 4]; 4] =
    [[1.754, 0.349, 0.0, 0.483], [0.0, 2.608, 0.0, -0.259], [1.013, -0.605, 0.0, -0.837], [0.0, 0.0, 1.0, 5.0]];

/// The corners of eight triangles, and the side that each faces.
struct Octahedron {
    clip_from_world: Mat4,
    corners: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
}

impl Octahedron {
    fn new(clip_from_world: Mat4) -> Self {
        let (mut corners, mut normals) = (Vec::new(), Vec::new());
        for face in 0..8u8 {
            let sign = |axis: u8| if face >> axis & 1 == 0 { 1.0 } else { -1.0 };
            let [x, y, z] = [sign(0), sign(1), sign(2)];
            corners.extend([[x, 0.0, 0.0], [0.0, y * HEIGHT, 0.0], [0.0, 0.0, z]]);
            normals.extend([[x, y / HEIGHT, z]; 3]);
        }
        Self { clip_from_world, corners, normals }
    }
}

impl Shader for Octahedron {
    type Varying<L: Lanes> = Vec3<L>; // the normal

    #[inline(always)]
    fn vertex<L: Lanes>(&self, l: L, index: U32<L>) -> Vertex<L, Vec3<L>> {
        let position = self.clip_from_world.transform_point(l, index.gather_vec3(&self.corners));
        Vertex { position, varying: index.gather_vec3(&self.normals) }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, fragment: &Fragment<L, Vec3<L>>) -> Rgba<L> {
        let light = fragment.varying.normalize().dot(l.vec3([-0.45, 0.65, 0.61])).max(0.0) * 0.8 + 0.12;
        (l.vec3([0.1, 0.42, 0.55]) * light).rgba(1.0)
    }
}

/// The model alone, transparent where it is not.
fn model() -> Result<Rgba8Image, Box<dyn Error>> {
    let octahedron = Octahedron::new(Mat4 { columns: CLIP_FROM_WORLD });
    let samples = SamplePattern::standard(16).ok_or("a standard pattern has up to 16 samples")?;
    let frame = Frame { samples, clear: [0.0; 4], ..Frame::new(SIZE[0], SIZE[1]) };
    let draw = Draw::new(&octahedron, Primitives::Triangles(Indices::Sequence(24)));
    let mut picture = ModelPicture::default();
    ModelRenderer::new(RendererOptions::from_env()?)?.render(&frame, &[draw], &mut picture)?;
    let pixels = picture.color.ok_or("a frame has colour unless told otherwise")?.into_values();
    Ok(Rgba8Image::from_pixels(SIZE[0], SIZE[1], pixels)?)
}

/// Where a point of the world is in the picture, in pixels.
fn project(point: [f32; 3]) -> [f32; 2] {
    let [x, y, z, o] = CLIP_FROM_WORLD;
    let clip = |i: usize| (point[0] * x[i] + point[1] * y[i]) + (point[2] * z[i] + o[i]);
    [(1.0 + clip(0) / clip(3)) * 320.0, (1.0 - clip(1) / clip(3)) * 240.0]
}

/// Light that falls off towards the corners.
fn background() -> Result<Drawing, Box<dyn Error>> {
    let stop =
        |offset, name| Ok::<_, Box<dyn Error>>(GradientStop { offset, color: Color::parse(name)?, opacity: 1.0 });
    let light = RadialGradient {
        center: [320.0, 190.0],
        radius: 420.0,
        focus: [320.0, 190.0],
        focal_radius: 0.0,
        stops: vec![stop(0.0, "#fdfbf5")?, stop(1.0, "#c9cfd6")?],
        spread: Spread::Pad,
        transform: Transform::IDENTITY,
    };
    let mut drawing = Drawing::new();
    let page = Path::rect(0.0, 0.0, 640.0, 480.0);
    drawing.fill(page, FillRule::NonZero, Transform::IDENTITY, light, 1.0, BlendMode::Normal);
    Ok(drawing)
}

/// A measure beside the line from `a` to `b`: two thin lines out to it, and a line with arrows.
fn measure(drawing: &mut Drawing, a: [f32; 2], b: [f32; 2], [away_x, away_y]: [f32; 2]) -> Result<(), Box<dyn Error>> {
    let (still, normal, ink) = (Transform::IDENTITY, BlendMode::Normal, Color::parse("#a8321f")?);
    let (from, to) = ([a[0] + away_x, a[1] + away_y], [b[0] + away_x, b[1] + away_y]);
    let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
    let length = (dx * dx + dy * dy).sqrt();
    let (along, across) = ([dx / length, dy / length], [-dy / length, dx / length]);
    let (mut lines, mut arrows) = (Path::new(), Path::new());
    for (point, end) in [(a, from), (b, to)] {
        lines.move_to(point[0], point[1]).line_to(end[0] + away_x * 0.1, end[1] + away_y * 0.1);
    }
    for (tip, sign) in [(from, 1.0), (to, -1.0)] {
        let at = |back: f32, side: f32| [0, 1].map(|i| tip[i] + along[i] * back * sign + across[i] * side);
        let ([x0, y0], [x1, y1]) = (at(13.0, 4.5), at(13.0, -4.5));
        arrows.move_to(tip[0], tip[1]).line_to(x0, y0).line_to(x1, y1).close();
    }
    let mut middle = Path::new();
    middle.move_to(from[0], from[1]).line_to(to[0], to[1]);
    drawing.stroke(lines, &Stroke::new(0.6).with_cap(Cap::Round), still, ink, 1.0, normal);
    drawing.stroke(middle, &Stroke::new(1.6), still, ink, 1.0, normal);
    drawing.fill(arrows, FillRule::NonZero, still, ink, 1.0, normal);
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    // The model onto the background.
    let mut scene = background()?;
    scene.image(&Image::new(&model()?)?, ImageFilter::NEAREST, Transform::IDENTITY, 1.0, BlendMode::Normal);
    let renderer = Renderer { threads: 2, ..Renderer::new() };
    let mut picture = renderer.draw(&scene, SIZE[0], SIZE[1], Color::TRANSPARENT)?;

    // The measures onto what is there.
    let mut labels = Drawing::new();
    let (top, bottom) = (project([0.0, HEIGHT, 0.0]), project([0.0, -HEIGHT, 0.0]));
    measure(&mut labels, top, bottom, [-190.0, 0.0])?;
    measure(&mut labels, project([-1.0, 0.0, 0.0]), project([0.0, 0.0, 1.0]), [-25.0, 170.0])?;
    measure(&mut labels, project([0.0, 0.0, 1.0]), project([1.0, 0.0, 0.0]), [40.0, 160.0])?;
    renderer.draw_over(&labels, &mut picture)?;

    let file = std::env::args().nth(1).unwrap_or_else(|| "labels.png".to_owned());
    std::fs::write(file, encode(&picture.to_image(), Format::Png, &EncodeOptions::default())?)?;
    Ok(())
}
