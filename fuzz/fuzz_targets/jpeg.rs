//! Any bytes as a JPEG file; see `checks.rs`.
#![no_main]

#[path = "../checks.rs"]
#[expect(dead_code, reason = "the other targets use the rest")]
mod checks;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| checks::jpeg(bytes));
