//! The corpus as a WebAssembly module: `run` draws it, and then `text` and `text_length` say where the lines
//! `name hash` lie in memory, or the message of a panic.
//!
//! Raw exports and nothing imported, so that the module runs in any host without further tools.
#![cfg(target_family = "wasm")]

use std::sync::{Mutex, MutexGuard, PoisonError};
use trigon_tests::corpus;
use trigon_tests::frames::plain_options;

static TEXT: Mutex<String> = Mutex::new(String::new());

fn text_lock() -> MutexGuard<'static, String> {
    TEXT.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Draws every frame; traps on a panic.
// SAFETY: nothing else in the module has this name.
#[expect(unsafe_code, reason = "an export needs a fixed name")]
#[unsafe(no_mangle)]
pub extern "C" fn run() {
    std::panic::set_hook(Box::new(|info| *text_lock() = info.to_string()));
    let options = plain_options();
    let report = corpus::report(options);
    *text_lock() = format!("SIMD level {}\n{report}", options.simd);
}

/// Address of the text's first byte; it is UTF-8.
// SAFETY: nothing else in the module has this name.
#[expect(unsafe_code, reason = "an export needs a fixed name")]
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    text_lock().as_ptr()
}

/// Bytes of the text.
// SAFETY: nothing else in the module has this name.
#[expect(unsafe_code, reason = "an export needs a fixed name")]
#[unsafe(no_mangle)]
pub extern "C" fn text_length() -> usize {
    text_lock().len()
}
