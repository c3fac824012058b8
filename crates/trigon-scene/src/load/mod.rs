//! Loading files into scenes: format recognition, side files, limits, errors and warnings.

mod entry;
mod error;
mod format;
mod gzip;
mod options;
mod parallel;
mod resolver;
mod side_files;
mod warnings;

pub use entry::{Loaded, load_bytes, load_path};
pub use error::{LoadError, Location, Place};
pub use format::Format;
pub use options::{Limits, LoadOptions, UpAxis};
pub use resolver::{DirectoryResolver, MemoryResolver, NoSideFiles, Resolver};
pub use warnings::{Warning, WarningKind};

pub(crate) use format::has_binary_stl_length;
pub(crate) use parallel::parallel_map;
pub(crate) use side_files::SideFiles;
pub(crate) use warnings::Findings;
