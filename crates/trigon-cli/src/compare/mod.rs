//! Pictures side by side: what is varied in, cells with times and errors out, on a sheet.
//!
//! `variant` makes one command line of each combination, `cell` draws it, `reference` what it is measured against,
//! `sheet` puts all on one picture.

mod cell;
mod reference;
mod sheet;
mod variant;

pub(crate) use cell::{Subject, draw};
pub(crate) use reference::{Reference, rmse};
pub(crate) use sheet::{Entry, Layout, sheet};
pub(crate) use variant::{Variant, variants};
