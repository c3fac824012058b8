//! Factor maps: the textures of a surface in, one colour per factor out.
//!
//! Maps are read in a loop, so that there is one copy of the sampler's code however many maps a material has, and so
//! that those it has not cost nothing.

use crate::render::material::{MapUse, Slot};
use trigon::lanes::{F32, Lanes, Rgba, Vec2};

/// What multiplies the factors of a surface: 1 where there is no map.
pub(super) struct Factors<L: Lanes> {
    values: [Rgba<L>; Slot::FACTORS],
}

/// Texture coordinates and their change per pixel.
#[derive(Clone, Copy)]
pub(super) struct Footprint<L: Lanes> {
    pub(super) uv: Vec2<L>,
    pub(super) dx: Vec2<L>,
    pub(super) dy: Vec2<L>,
}

impl<L: Lanes> Factors<L> {
    /// Reads every map of `maps` at `footprint`.
    #[inline(always)]
    pub(super) fn read(l: L, maps: &[MapUse<'_>], footprint: &Footprint<L>) -> Self {
        let one = l.f32(1.0);
        let mut values = [Rgba { r: one, g: one, b: one, a: one }; Slot::FACTORS];
        for map in maps {
            let value = map.sample(l, footprint);
            // Slots of factors only; the remainder tells the compiler so.
            let factor = &mut values[map.slot as usize % Slot::FACTORS];
            *factor = *factor * value;
        }
        Self { values }
    }

    #[inline(always)]
    pub(super) fn get(&self, slot: Slot) -> Rgba<L> {
        self.values[slot as usize % Slot::FACTORS]
    }

    /// The product of all opacities.
    #[inline(always)]
    pub(super) fn opacity(&self) -> F32<L> {
        self.get(Slot::Diffuse).a * self.get(Slot::Opacity).r
    }
}

impl<L: Lanes> Footprint<L> {
    /// The coordinates that `map` is read at.
    #[inline(always)]
    pub(super) fn placed(&self, l: L, map: &MapUse<'_>) -> Self {
        let (scale, offset) = (l.vec2(map.scale), l.vec2(map.offset));
        Self { uv: self.uv * scale + offset, dx: self.dx * scale, dy: self.dy * scale }
    }
}

impl MapUse<'_> {
    /// For u and v, -1 where the map runs backwards.
    #[inline(always)]
    pub(super) fn direction(&self) -> [f32; 2] {
        [1.0_f32.copysign(self.scale[0]), 1.0_f32.copysign(self.scale[1])]
    }

    /// Sixteen values: a colour premultiplied by its alpha, or one number in all channels.
    #[inline(never)]
    pub(super) fn sample<L: Lanes>(&self, l: L, footprint: &Footprint<L>) -> Rgba<L> {
        l.vectorize(
            #[inline(always)]
            || self.sample_inline(l, footprint),
        )
    }

    #[inline(always)]
    fn sample_inline<L: Lanes>(&self, l: L, footprint: &Footprint<L>) -> Rgba<L> {
        l.note_topic(self.slot.name(), None);
        let at = footprint.placed(l, self);
        let mut value = self.texture.sample(l, &self.sampler, at.uv, at.dx, at.dy);
        if self.is_scalar {
            value = Rgba { r: value.r, g: value.r, b: value.r, a: l.f32(1.0) };
        }
        if self.gain != 1.0 || self.base != 0.0 {
            let base = value.a * self.base;
            value = Rgba {
                r: value.r * self.gain + base,
                g: value.g * self.gain + base,
                b: value.b * self.gain + base,
                a: value.a,
            };
        }
        if self.is_clamped {
            let one = l.f32(1.0);
            let inside = at.uv.x.ge(0.0) & at.uv.x.le(1.0) & at.uv.y.ge(0.0) & at.uv.y.le(1.0);
            value = inside.select(value, Rgba { r: one, g: one, b: one, a: one });
        }
        l.note("value of the map", value);
        value
    }
}
