//! Any bytes as an SVG file; see `checks_svg.rs`.
#![no_main]

#[path = "../checks_svg.rs"]
mod checks_svg;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| checks_svg::svg(bytes));
