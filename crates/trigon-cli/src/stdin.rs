//! Standard input, read once: what is there decides who reads it.

use std::io::{self, Read};
use std::sync::OnceLock;

/// All of standard input, at most `max_bytes + 1` bytes, so that a reader sees that there is too much.
///
/// # Errors
/// If reading failed, as a message.
pub(crate) fn bytes(max_bytes: u64) -> Result<&'static [u8], String> {
    static BYTES: OnceLock<Result<Vec<u8>, String>> = OnceLock::new();
    let read = BYTES.get_or_init(|| {
        let mut bytes = Vec::new();
        match io::stdin().lock().take(max_bytes.saturating_add(1)).read_to_end(&mut bytes) {
            Ok(_) => Ok(bytes),
            Err(error) => Err(error.to_string()),
        }
    });
    read.as_ref().map(Vec::as_slice).map_err(Clone::clone)
}
