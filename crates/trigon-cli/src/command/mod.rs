//! What each subcommand does.

mod completions;
mod cs184;
mod document;
mod drawing;
mod explain;
mod man;
mod render;
mod studio;
mod turntable;

pub(crate) use completions::completions;
pub(crate) use explain::explain;
pub(crate) use man::man;
pub(crate) use render::render;
pub(crate) use turntable::turntable;
