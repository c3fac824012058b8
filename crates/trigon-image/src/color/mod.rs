//! Colour: the exact sRGB transfer function, straight and premultiplied alpha, and colours written by people.

mod alpha;
mod convert;
mod inks;
mod names;
mod parse;
mod tables;
mod transfer;

pub use alpha::{premultiply, unit_to_u8, unit_to_u16, unpremultiply};
pub(crate) use alpha::{unpremultiply_u8, unpremultiply_u16};
pub(crate) use convert::u16_to_u8;
pub(crate) use inks::without_inks;
pub use parse::{Color, ParseColorError};
pub use transfer::{
    SRGB8_STEPS, SRGB8_STEPS_FIRST_BITS, linear_to_srgb, linear_to_srgb16, srgb_decode, srgb_encode, srgb_to_linear,
    srgb16_to_linear,
};
