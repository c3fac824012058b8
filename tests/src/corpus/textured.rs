//! Frames of textures: every filter, wrap, format, anisotropy and level-of-detail control, on a floor that runs to the
//! horizon and a wall seen face on.

use super::NamedFrame;
use super::clip_space::ALL_OUTPUTS;
use crate::frames::draw_with;
use crate::random::Random;
use std::sync::Arc;
use trigon::geometry::{Indices, Primitives};
use trigon::lanes::{Lanes, Mask, Rgba, U32};
use trigon::pipeline::{Draw, Frame};
use trigon::resolve::Blend;
use trigon::shade::texture::{
    Alpha, LevelFilter, MipChain, PixelFilter, Sampler, TexelFormat, Texture, TextureDesc, Wrap,
};
use trigon::shade::{Fragment, Shader, Vertex};
use trigon::target::SamplePattern;

/// Clip positions of the floor and the wall, two triangles each.
const POSITIONS: [[f32; 4]; 12] = [
    [-6.0, -1.0, 0.1, 1.0],
    [6.0, -1.0, 0.1, 1.0],
    [6.0, -1.0, 0.1, 40.0],
    [-6.0, -1.0, 0.1, 1.0],
    [6.0, -1.0, 0.1, 40.0],
    [-6.0, -1.0, 0.1, 40.0],
    [-0.9, 0.1, 0.2, 1.0],
    [0.8, 0.0, 0.2, 1.0],
    [0.9, 0.9, 0.2, 1.0],
    [-0.9, 0.1, 0.2, 1.0],
    [0.9, 0.9, 0.2, 1.0],
    [-0.8, 1.0, 0.2, 1.0],
];

/// Their texture coordinates.
const UVS: [[f32; 2]; 12] = [
    [-5.0, 0.0],
    [5.0, 0.0],
    [5.0, 40.0],
    [-5.0, 0.0],
    [5.0, 40.0],
    [-5.0, 40.0],
    [-0.6, 1.7],
    [1.3, 1.6],
    [1.5, -0.4],
    [-0.6, 1.7],
    [1.5, -0.4],
    [-0.5, -0.3],
];

trigon::varying! {
    /// Where on the texture.
    struct Place {
        /// v down.
        uv: Vec2,
    }
}

/// Shows a texture as it is, or only where its alpha is at least one half.
struct Textured {
    texture: Arc<Texture>,
    sampler: Sampler,
    is_cut_out: bool,
}

impl Textured {
    #[inline(always)]
    fn sample<L: Lanes>(&self, l: L, f: &Fragment<L, Place<L>>) -> Rgba<L> {
        self.texture.sample(l, &self.sampler, f.uv, f.dx.uv, f.dy.uv)
    }
}

impl Shader for Textured {
    type Varying<L: Lanes> = Place<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, _l: L, index: U32<L>) -> Vertex<L, Place<L>> {
        Vertex { position: index.gather_vec4(&POSITIONS), varying: Place { uv: index.gather_vec2(&UVS) } }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, Place<L>>) -> Rgba<L> {
        self.sample(l, f)
    }

    #[inline(always)]
    fn keep<L: Lanes>(&self, l: L, f: &Fragment<L, Place<L>>) -> Mask<L> {
        self.sample(l, f).a.ge(0.5)
    }

    fn discards(&self) -> bool {
        self.is_cut_out
    }
}

pub(super) fn frames() -> Vec<NamedFrame> {
    let srgb = Arc::new(noise([37, 50], TexelFormat::Rgba8Srgb, Alpha::Coverage, MipChain::Box));
    let trilinear = Sampler::TRILINEAR;
    let mut frames = Vec::new();
    for (pixel, name) in [(PixelFilter::Nearest, "nearest"), (PixelFilter::Bilinear, "bilinear")] {
        for (level, of) in
            [(LevelFilter::Zero, "zero"), (LevelFilter::Nearest, "nearest"), (LevelFilter::Linear, "linear")]
        {
            frames.push(opaque(&format!("{name}-level-{of}"), &srgb, trilinear.with_filters(pixel, level)));
        }
    }
    for most in [2, 5, 16] {
        frames.push(opaque(&format!("anisotropy-{most}"), &srgb, trilinear.with_anisotropy(most)));
    }
    let border = Wrap::Border([0.5, 0.1, 0.2, 0.7]);
    for (wrap, name) in [(Wrap::Mirror, "mirror"), (Wrap::ClampToEdge, "clamp"), (border, "border")] {
        frames.push(opaque(&format!("wrap-{name}"), &srgb, trilinear.with_wrap(wrap)));
    }
    let lod = Sampler { lod_bias: 0.7, lod_min: 1.25, lod_max: 3.5, ..trilinear };
    frames.push(opaque("lod-bias-and-clamp", &srgb, lod));
    for (format, name) in [
        (TexelFormat::Rgba8, "rgba8"),
        (TexelFormat::R8, "r8"),
        (TexelFormat::R32Float, "r32-float"),
        (TexelFormat::Rgba32Float, "rgba32-float"),
    ] {
        let texture = noise([64, 33], format, Alpha::Independent, MipChain::Box);
        frames.push(opaque(&format!("format-{name}"), &Arc::new(texture), trilinear));
    }
    let row = noise([129, 1], TexelFormat::Rgba32Float, Alpha::Coverage, MipChain::Box);
    frames.push(opaque("one-row", &Arc::new(row), trilinear));
    let single = noise([20, 20], TexelFormat::Rgba8Srgb, Alpha::Coverage, MipChain::None);
    frames.push(opaque("no-mips", &Arc::new(single), trilinear));
    frames.push(frame("blended", &srgb, trilinear, false, Blend::Over));
    frames.push(frame("cut-out", &srgb, trilinear, true, Blend::Replace));
    frames
}

fn opaque(name: &str, texture: &Arc<Texture>, sampler: Sampler) -> NamedFrame {
    frame(name, texture, sampler, false, Blend::Replace)
}

fn frame(name: &str, texture: &Arc<Texture>, sampler: Sampler, is_cut_out: bool, blend: Blend) -> NamedFrame {
    let shader = Textured { texture: Arc::clone(texture), sampler, is_cut_out };
    let samples = SamplePattern::standard(2).expect("a standard pattern");
    let frame = Frame { samples, clear: [0.02, 0.0, 0.1, 1.0], outputs: ALL_OUTPUTS, ..Frame::new(97, 83) };
    NamedFrame::new(format!("texture/{name}"), move |options| {
        let floor_and_wall = Primitives::Triangles(Indices::Sequence(12));
        draw_with(options, &frame, &[Draw { blend, ..Draw::new(&shader, floor_and_wall) }]).0
    })
}

/// Random texels, so that a wrong weight of any of them shows.
fn noise(size: [u32; 2], format: TexelFormat, alpha: Alpha, mips: MipChain) -> Texture {
    let desc = TextureDesc { size, format, alpha, mips };
    let mut random = Random::new(u64::from(size[0]));
    let texture = if format.is_float() {
        let values: Vec<f32> = (0..desc.values()).map(|_| random.between(0.0, 1.5)).collect();
        Texture::from_floats(&desc, &values)
    } else {
        let bytes: Vec<u8> = (0..desc.values()).map(|_| (random.bits() >> 24) as u8).collect();
        Texture::from_bytes(&desc, &bytes)
    };
    texture.expect("as many values as the size asks for")
}
