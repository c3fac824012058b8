//! What each subcommand does.

mod completions;
mod man;
mod render;
mod studio;
mod turntable;

pub(crate) use completions::completions;
pub(crate) use man::man;
pub(crate) use render::render;
pub(crate) use turntable::turntable;
