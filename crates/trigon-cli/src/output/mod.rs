//! Where pictures go: the format, the file or stream, and names of numbered files.

mod destination;
mod encoding;
mod template;

pub(crate) use destination::Destination;
pub(crate) use encoding::{Encoding, Images};
pub(crate) use template::FrameTemplate;
