//! `cargo xtask assets`: everything under `assets/`, made from nothing by arithmetic.

mod write;

pub(crate) use write::{check, write};
