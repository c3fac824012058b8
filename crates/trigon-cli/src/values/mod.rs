//! Values as people write them on the command line: text in, a checked value or a message that says what to write out.
//!
//! Each type reads itself by `FromStr`; the message of a failure becomes part of the usage error of its option.

mod angle;
mod axis;
mod count;
mod direction;
mod inset;
mod light;
mod limit;
mod number;
mod page_area;
mod pixel;
mod scale;
mod size;
mod suggest;
mod vector;

pub(crate) use angle::Angle;
pub(crate) use axis::Axis;
pub(crate) use count::Count;
pub(crate) use direction::UpDirection;
pub(crate) use inset::Inset;
pub(crate) use light::LightValue;
pub(crate) use limit::{Limit, LimitName};
pub(crate) use number::{NonNegative, Positive, Real};
pub(crate) use page_area::PageArea;
pub(crate) use pixel::PixelPlace;
pub(crate) use scale::Scale;
pub(crate) use size::PictureSize;
pub(crate) use suggest::closest;
pub(crate) use vector::Vector;
