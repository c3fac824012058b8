//! What each subcommand does.

mod compare;
mod completions;
mod cs184;
mod document;
pub(crate) mod drawing;
mod explain;
mod man;
mod render;
pub(crate) mod studio;
mod turntable;

pub(crate) use compare::compare;
pub(crate) use completions::completions;
pub(crate) use explain::explain;
pub(crate) use man::man;
pub(crate) use render::render;
pub(crate) use turntable::turntable;
