//! SVG files: bytes in, a [`Drawing`](crate::canvas::Drawing) in pixels out.
//!
//! The `usvg` crate resolves the text of the file (styles, references, units, fonts) to a tree of groups, paths and images;
//! what is here turns that tree into layers, paints and filters, and says what of the file is not drawn.

mod bounds;
mod clip;
mod convert;
mod document;
mod error;
mod filters;
mod fonts;
mod images;
mod limits;
mod options;
mod paint;
mod path;
mod primitives;
mod recognize;
mod view;
mod warnings;

pub use document::{Document, Prepared};
pub use error::SvgError;
pub use fonts::FontOptions;
pub use limits::Limits;
pub use options::Options;
pub use recognize::is_svg;
pub use view::{Area, Size, View};
pub use warnings::Warning;
