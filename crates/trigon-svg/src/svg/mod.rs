//! SVG files: bytes in, a [`Drawing`](crate::canvas::Drawing) in pixels out.
//!
//! The `usvg` crate resolves the text of the file (styles, references, units, fonts) to a tree of groups, paths and images;
//! what is here turns that tree into layers, paints and filters, and says what of the file is not drawn.
//!
//! ```
//! use trigon_image::Color;
//! use trigon_svg::canvas::Renderer;
//! use trigon_svg::svg::{Document, Options, Size, View};
//!
//! let file = b"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2 1'><rect width='1' height='1' fill='teal'/></svg>";
//! let document = Document::parse(file, &Options::default())?;
//! let view = View { size: Size::Width(100), ..View::default() };
//! let (picture, warnings) = document.draw(&view, &Renderer::new(), Color::WHITE)?;
//! assert_eq!((picture.width(), picture.height(), warnings.len()), (100, 50, 0));
//! assert_eq!(picture.pixels()[0], [0, 128, 128, 255]);
//! # Ok::<(), trigon_svg::svg::SvgError>(())
//! ```

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
mod pictures;
mod primitives;
mod recognize;
mod triangles;
mod view;
mod warnings;

pub use document::{Document, Prepared, READER_THREAD};
pub use error::SvgError;
pub use fonts::FontOptions;
pub use limits::Limits;
pub use options::Options;
pub use recognize::is_svg;
pub use view::{Area, Size, View};
pub use warnings::Warning;
