//! Images: sampled at pixel centres, by trigon's samplers.

use crate::canvas::{Image, ImageFilter, Transform};
use trigon::lanes::{F32, LANES, Lanes, U32};
use trigon::shade::texture::Sampler;

/// An image with the map from pixels to its coordinates.
pub(crate) struct ImageShader {
    image: Image,
    sampler: Sampler,
    /// Texture coordinates from pixels: u is `[0] * x + [1] * y + [2]` and so on.
    u: [f32; 3],
    v: [f32; 3],
    opacity: f32,
}

impl ImageShader {
    /// `None` if the image has no area.
    pub(crate) fn new(image: &Image, filter: ImageFilter, from_image: &Transform, opacity: f32) -> Option<Self> {
        let [width, height] = image.size().map(f64::from);
        let to_uv = (*from_image * Transform::scale(width, height)).inverse()?;
        let sampler = Sampler {
            max_anisotropy: filter.max_anisotropy,
            wrap_u: filter.wrap,
            wrap_v: filter.wrap,
            ..Sampler::TRILINEAR.with_filters(filter.pixel, filter.level)
        };
        Some(Self {
            image: image.clone(),
            sampler,
            u: [to_uv.a as f32, to_uv.c as f32, to_uv.e as f32],
            v: [to_uv.b as f32, to_uv.d as f32, to_uv.f as f32],
            opacity: crate::engine::color::unit(opacity),
        })
    }

    /// The colours of the pixels of row `y` from column `x` on.
    #[inline(always)]
    pub(crate) fn row<L: Lanes>(&self, l: L, x: u32, y: u32, out: &mut [u32]) {
        let center_y = y as f32 + 0.5;
        let mut column = x;
        for chunk in out.chunks_mut(LANES) {
            let pixels = self.pixels(l, column, center_y).to_array();
            chunk.copy_from_slice(&pixels[..chunk.len()]);
            column += LANES as u32;
        }
    }

    /// Sixteen pixels.
    #[inline(always)]
    fn pixels<L: Lanes>(&self, l: L, column: u32, center_y: f32) -> U32<L> {
        let center_x = l.lane_numbers() + (column as f32 + 0.5);
        let mut uv = l.vec2([0.0; 2]);
        uv.x = center_x * self.u[0] + (self.u[1] * center_y + self.u[2]);
        uv.y = center_x * self.v[0] + (self.v[1] * center_y + self.v[2]);
        let (ddx, ddy) = (l.vec2([self.u[0], self.v[0]]), l.vec2([self.u[1], self.v[1]]));
        let color = self.image.texture().sample(l, &self.sampler, uv, ddx, ddy);
        let alpha = color.a.saturate() * self.opacity;
        let a = to_byte(alpha);
        let mut packed = a << 24;
        packed = packed | to_byte(color.r * self.opacity).min(a);
        packed = packed | (to_byte(color.g * self.opacity).min(a) << 8);
        packed | (to_byte(color.b * self.opacity).min(a) << 16)
    }
}

/// 0..=1 to 0..=255, halves up; what lies outside is clamped.
#[inline(always)]
fn to_byte<L: Lanes>(value: F32<L>) -> U32<L> {
    (value * 255.0 + 0.5).to_i32_within(0.0, 255.0).as_u32()
}
