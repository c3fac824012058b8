//! Pictures side by side: what is varied in, cells with times and errors out, on a sheet.
//!
//! `variant` makes one command line of each combination, `cell` draws it, `reference` what it is measured against,
//! `sheet` puts all on one picture.

mod cell;
mod reference;
mod sheet;
mod variant;

pub(crate) use cell::{Drawer, Subject};
pub(crate) use reference::{Reference, check_size, rmse};
pub(crate) use sheet::{Entry, Layout, sheet};
pub(crate) use variant::{Variant, variants};
