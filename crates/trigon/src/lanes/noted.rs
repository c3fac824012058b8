//! Values that can be noted when a pixel is explained (see [`Lanes::note`]).

use super::{F32, LANES, Lanes, Mask, Rgba, Vec2, Vec3, Vec4};
use crate::explain;

/// A lane value whose components have a place in a story.
pub trait Noted<L: Lanes>: Copy {
    /// Notes the value; called at the plain level alone.
    #[doc(hidden)]
    fn note(self, name: &'static str);
}

macro_rules! noted {
    ($name:ident { $($component:ident),+ }) => {
        impl<L: Lanes> Noted<L> for $name<L> {
            #[inline(always)]
            fn note(self, name: &'static str) {
                explain::note(name, &[$(self.$component.to_array()),+]);
            }
        }
    };
}

noted!(Vec2 { x, y });
noted!(Vec3 { x, y, z });
noted!(Vec4 { x, y, z, w });
noted!(Rgba { r, g, b, a });

impl<L: Lanes> Noted<L> for F32<L> {
    #[inline(always)]
    fn note(self, name: &'static str) {
        explain::note(name, &[self.to_array()]);
    }
}

impl<L: Lanes> Noted<L> for Mask<L> {
    #[inline(always)]
    fn note(self, name: &'static str) {
        let bits = self.bits();
        let mut values = [0.0; LANES];
        for (lane, value) in values.iter_mut().enumerate() {
            *value = f32::from(bits >> lane & 1);
        }
        explain::note(name, &[values]);
    }
}
