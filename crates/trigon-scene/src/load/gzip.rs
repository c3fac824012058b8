//! Gzip, recognized by its magic number: compressed or plain bytes in, plain bytes out, within a limit.

use super::LoadError;
use flate2::read::MultiGzDecoder;
use std::borrow::Cow;
use std::io::Read;

/// The decompressed content of a gzip file; any other file as it is.
pub(crate) fn inflate<'a>(bytes: &'a [u8], file: &str, max_bytes: u64) -> Result<Cow<'a, [u8]>, LoadError> {
    if !bytes.starts_with(&[0x1f, 0x8b, 8]) {
        return Ok(Cow::Borrowed(bytes));
    }
    // The last four bytes give the size modulo 2^32; a hint only, since a hostile file may lie: deflate grows data at
    // most 1032-fold.
    let claimed = bytes.last_chunk::<4>().map_or(0, |size| u64::from(u32::from_le_bytes(*size)));
    let compressed = u64::try_from(bytes.len()).unwrap_or(u64::MAX);
    let hint = claimed.min(max_bytes).min(compressed.saturating_mul(8));
    let mut plain = Vec::with_capacity(usize::try_from(hint).unwrap_or(0) + 1);
    let read = MultiGzDecoder::new(bytes).take(max_bytes.saturating_add(1)).read_to_end(&mut plain);
    read.map_err(|source| LoadError::Io { file: file.to_owned(), source })?;
    if u64::try_from(plain.len()).unwrap_or(u64::MAX) > max_bytes {
        return Err(LoadError::limit(file, "file_bytes", max_bytes));
    }
    Ok(Cow::Owned(plain))
}

#[cfg(test)]
mod tests {
    use super::*;
    use flate2::{Compression, write::GzEncoder};
    use std::io::Write;

    fn compress(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn plain_and_compressed_files_read_the_same() {
        let text = b"v 1 2 3\n".repeat(1000);
        assert_eq!(inflate(&text, "a", 1 << 20).unwrap(), text.as_slice());
        assert_eq!(inflate(&compress(&text), "a", 1 << 20).unwrap(), text.as_slice());
    }

    #[test]
    fn bombs_stop_at_the_limit_and_damage_is_an_error() {
        let bomb = compress(&vec![0; 10 << 20]);
        assert!(matches!(inflate(&bomb, "a", 1 << 20), Err(LoadError::LimitExceeded { .. })));
        assert!(inflate(&bomb[..bomb.len() / 2], "a", 100 << 20).is_err());
    }
}
