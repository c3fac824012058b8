//! Shaders of the tests: vertices given in clip space or in pixels, coloured by a varying.

use trigon::geometry::Primitives;
use trigon::lanes::{Lanes, Mask, Rgba, U32};
use trigon::pipeline::Draw;
use trigon::shade::{Fragment, Shader, SurfaceLanes, Vertex};

trigon::varying! {
    /// Colour and texture coordinates at the vertices.
    pub struct Painted {
        /// Linear, premultiplied.
        color: Vec4,
        /// Texture coordinates.
        uv: Vec2,
    }
}

/// Vertices in clip space with colours; the fragment colour depends on every input that a fragment has.
#[derive(Default, Clone)]
pub struct ClipShader {
    /// Clip positions.
    pub positions: Vec<[f32; 4]>,
    /// Linear, premultiplied.
    pub colors: Vec<[f32; 4]>,
    /// Fragments whose red is below this are discarded; 0 keeps all.
    pub discard_below: f32,
}

impl ClipShader {
    /// White triangles with corners in pixels of a `width` x `height` picture, at depth 0.5.
    #[must_use]
    pub fn in_pixels(corners: &[[f32; 2]], width: u32, height: u32) -> Self {
        let ndc = |[x, y]: [f32; 2]| [2.0 * x / width as f32 - 1.0, 1.0 - 2.0 * y / height as f32, 0.5, 1.0];
        Self {
            positions: corners.iter().map(|c| ndc(*c)).collect(),
            colors: vec![[1.0; 4]; corners.len()],
            discard_below: 0.0,
        }
    }
}

impl ClipShader {
    /// Draws `primitives` with this shader.
    ///
    /// Here and not where it is used, because the kernels of a shader are compiled where its type is forgotten: once,
    /// instead of for each test program.
    #[must_use]
    #[inline(never)]
    pub fn draw<'a>(&'a self, primitives: Primitives<'a>) -> Draw<'a> {
        Draw::new(self, primitives)
    }
}

impl Shader for ClipShader {
    type Varying<L: Lanes> = Painted<L>;

    #[inline(always)]
    fn vertex<L: Lanes>(&self, _l: L, index: U32<L>) -> Vertex<L, Painted<L>> {
        let position = index.gather_vec4(&self.positions);
        let uv = trigon::lanes::Vec2 { x: position.x, y: position.y };
        Vertex { position, varying: Painted { color: index.gather_vec4(&self.colors), uv } }
    }

    #[inline(always)]
    fn fragment<L: Lanes>(&self, l: L, f: &Fragment<L, Painted<L>>) -> Rgba<L> {
        let tint = f.barycentric * 0.25 + l.vec3([0.5; 3]);
        let slope = (f.dx.uv.x.abs() + f.dy.uv.y.abs()) * 0.5;
        let facing = f.front_facing.select(l.f32(1.0), l.f32(0.75));
        let shade = facing * (f.depth * 0.5 + 0.5) + slope;
        let c = f.color;
        Rgba { r: c.x * tint.x * shade, g: c.y * tint.y * shade, b: c.z * tint.z * shade, a: c.w }
    }

    #[inline(always)]
    fn keep<L: Lanes>(&self, _l: L, f: &Fragment<L, Painted<L>>) -> Mask<L> {
        f.color.x.ge(self.discard_below)
    }

    fn discards(&self) -> bool {
        self.discard_below > 0.0
    }

    #[inline(always)]
    fn surface<L: Lanes>(&self, _l: L, f: &Fragment<L, Painted<L>>) -> SurfaceLanes<L> {
        SurfaceLanes {
            position: trigon::lanes::Vec3 { x: f.uv.x, y: f.uv.y, z: f.depth },
            normal: f.barycentric,
            uv: f.uv,
        }
    }
}
