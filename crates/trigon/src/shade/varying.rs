//! Varyings: what a vertex shader hands to the fragment shader, interpolated perspective-correctly.
//!
//! In: the values at a primitive's three corners. Out: the value at a fragment and its derivatives. A varying is any
//! fixed set of floats; [`varying!`](crate::varying) makes one from a struct of lane vectors.

use crate::lanes::{F32, Lanes, Vec2, Vec3, Vec4};

/// A set of floats that can be interpolated, component by component.
pub trait Varying<L: Lanes>: Copy {
    /// How many floats.
    const COMPONENTS: usize;

    /// Hands each component's values at the three corners to `sink`, in order.
    fn write<S: CornerSink<L>>(corners: [Self; 3], sink: &mut S);

    /// Takes each component's value and its derivatives along framebuffer x and y from `source`, in order.
    fn read<S: FragmentSource<L>>(source: &mut S) -> [Self; 3];

    /// Appends the name of each component, in order: `prefix`, with the component where there are several.
    fn names(prefix: &str, out: &mut Vec<String>);
}

/// Receives the components of a varying at a primitive's corners.
pub trait CornerSink<L: Lanes> {
    /// One component at the three corners.
    fn push(&mut self, corners: [F32<L>; 3]);
}

/// Yields the components of a varying at a fragment.
pub trait FragmentSource<L: Lanes> {
    /// One component: its value, and its change per pixel to the right and per pixel down.
    fn next(&mut self) -> [F32<L>; 3];
}

impl<L: Lanes> Varying<L> for () {
    const COMPONENTS: usize = 0;
    #[inline(always)]
    fn write<S: CornerSink<L>>(_: [Self; 3], _: &mut S) {}
    #[inline(always)]
    fn read<S: FragmentSource<L>>(_: &mut S) -> [Self; 3] {
        [(); 3]
    }
    fn names(_: &str, _: &mut Vec<String>) {}
}

impl<L: Lanes> Varying<L> for F32<L> {
    const COMPONENTS: usize = 1;
    #[inline(always)]
    fn write<S: CornerSink<L>>(corners: [Self; 3], sink: &mut S) {
        sink.push(corners);
    }
    #[inline(always)]
    fn read<S: FragmentSource<L>>(source: &mut S) -> [Self; 3] {
        source.next()
    }
    fn names(prefix: &str, out: &mut Vec<String>) {
        out.push(prefix.to_owned());
    }
}

/// Implements [`Varying`] for a struct of lanes, field by field.
macro_rules! fields {
    ($name:ident, $count:literal, $($field:ident),+) => {
        impl<L: Lanes> Varying<L> for $name<L> {
            const COMPONENTS: usize = $count;
            #[inline(always)]
            fn write<S: CornerSink<L>>(corners: [Self; 3], sink: &mut S) {
                let [a, b, c] = corners;
                $(sink.push([a.$field, b.$field, c.$field]);)+
            }
            #[inline(always)]
            fn read<S: FragmentSource<L>>(source: &mut S) -> [Self; 3] {
                $(let $field = source.next();)+
                [
                    $name { $($field: $field[0]),+ },
                    $name { $($field: $field[1]),+ },
                    $name { $($field: $field[2]),+ },
                ]
            }
            fn names(prefix: &str, out: &mut Vec<String>) {
                let dot = if prefix.is_empty() { "" } else { "." };
                $(out.push(format!("{prefix}{dot}{}", stringify!($field)));)+
            }
        }
    };
}

fields!(Vec2, 2, x, y);
fields!(Vec3, 3, x, y, z);
fields!(Vec4, 4, x, y, z, w);

/// Declares a struct of lane values and makes it a [`Varying`](crate::shade::Varying).
///
/// ```
/// trigon::varying! {
///     /// What the fragment shader sees of the surface.
///     pub struct Surface {
///         /// Unit length at the vertices only.
///         normal: Vec3,
///         /// Texture coordinates.
///         uv: Vec2,
///     }
/// }
/// ```
#[macro_export]
macro_rules! varying {
    ($(#[$meta:meta])* $vis:vis struct $name:ident { $($(#[$field_meta:meta])* $field:ident: $ty:ident),+ $(,)? }) => {
        $(#[$meta])*
        #[derive(Clone, Copy)]
        $vis struct $name<L: $crate::lanes::Lanes> {
            $($(#[$field_meta])* pub $field: $crate::lanes::$ty<L>),+
        }

        impl<L: $crate::lanes::Lanes> $crate::shade::Varying<L> for $name<L> {
            const COMPONENTS: usize = 0 $(+ <$crate::lanes::$ty<L> as $crate::shade::Varying<L>>::COMPONENTS)+;

            #[inline(always)]
            fn write<S: $crate::shade::CornerSink<L>>(corners: [Self; 3], sink: &mut S) {
                let [a, b, c] = corners;
                $($crate::shade::Varying::write([a.$field, b.$field, c.$field], sink);)+
            }

            #[inline(always)]
            fn read<S: $crate::shade::FragmentSource<L>>(source: &mut S) -> [Self; 3] {
                $(let $field: [$crate::lanes::$ty<L>; 3] = $crate::shade::Varying::read(source);)+
                [
                    $name { $($field: $field[0]),+ },
                    $name { $($field: $field[1]),+ },
                    $name { $($field: $field[2]),+ },
                ]
            }

            fn names(prefix: &str, out: &mut ::std::vec::Vec<::std::string::String>) {
                let dot = if prefix.is_empty() { "" } else { "." };
                $({
                    let name = ::std::format!("{prefix}{dot}{}", ::core::stringify!($field));
                    <$crate::lanes::$ty<L> as $crate::shade::Varying<L>>::names(&name, out);
                })+
            }
        }
    };
}
