//! Tests of several modules together: round trips, broken files, and real files.

mod animations;
mod broken_files;
mod jpeg_pixels;
mod real_files;
mod round_trips;
pub(crate) mod samples;
