//! Cutting an OBJ file into blocks of whole logical lines.

/// The usual size of a block: large enough to make the per-block work vanish, small enough to stay in the cache and to
/// share out evenly.
pub(super) const BLOCK_BYTES: usize = 1 << 20;

/// Cuts `text` after line feeds into blocks of about `block_bytes`; a line feed after a backslash does not end a line.
/// The blocks together are the text.
pub(super) fn split(text: &[u8], block_bytes: usize) -> Vec<&[u8]> {
    let mut blocks = Vec::with_capacity(text.len() / block_bytes.max(1) + 1);
    let mut rest = text;
    while !rest.is_empty() {
        let (block, tail) = rest.split_at(block_end(rest, block_bytes));
        blocks.push(block);
        rest = tail;
    }
    blocks
}

/// The first line end at or after `block_bytes`, exclusive end.
fn block_end(text: &[u8], block_bytes: usize) -> usize {
    let mut at = block_bytes.min(text.len());
    while let Some(offset) = text[at..].iter().position(|&b| b == b'\n') {
        let line = &text[..at + offset];
        at += offset + 1;
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        if !line.ends_with(b"\\") {
            return at;
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_are_whole_logical_lines() {
        let text = b"v 1 2 3\nf 1 2 \\\n 3\nf 1 2 \\\r\n 3\r\n# end";
        for size in 0..=text.len() {
            let blocks = split(text, size);
            assert_eq!(blocks.concat(), text);
            for block in &blocks[..blocks.len() - 1] {
                assert!(block.ends_with(b"\n") && !block.ends_with(b"\\\n") && !block.ends_with(b"\\\r\n"));
            }
        }
        assert!(split(b"", 10).is_empty());
    }
}
