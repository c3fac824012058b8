//! Golden pictures: what a test draws is compared with a picture in `tests/golden`, byte for byte.
//!
//! A test is three lines: a [`Shot`] of a model, what differs from the usual, the name of the case. `TRIGON_BLESS=1`
//! accepts what is drawn; without it a difference fails the test and is shown on a page below the target folder.

mod check;
mod report;
mod shapes;
mod shot;

pub use check::{check, check_text, stored_cases};
pub use shapes::{floor, sphere, square};
pub use shot::Shot;
