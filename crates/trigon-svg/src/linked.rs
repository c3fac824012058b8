//! Files that an SVG file links to: a path in, bytes or a picture out; only ordinary files, and only up to a size.
//!
//! The path comes from the file, which may mean harm: `/dev/zero` has no end, and a pipe never answers.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use trigon_image::{Format, Limits, Rgba8Image, decode};

/// The bytes of a file of at most `max_bytes`; else the reason in words.
pub(crate) fn read(path: &Path, max_bytes: usize) -> Result<Vec<u8>, String> {
    // Before it is opened: to open a pipe waits for somebody to write.
    let metadata = std::fs::metadata(path).map_err(|error| error.to_string())?;
    if !metadata.is_file() {
        return Err("it is not an ordinary file".to_owned());
    }
    let limit = u64::try_from(max_bytes).unwrap_or(u64::MAX);
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(|error| error.to_string())?;
    file.take(limit.saturating_add(1)).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    if bytes.len() > max_bytes { Err(format!("it has over {max_bytes} bytes")) } else { Ok(bytes) }
}

/// The picture in a file beside the one that names it; else the reason in words. Without a folder nothing is read.
pub(crate) fn picture(
    folder: Option<&Path>,
    file: &str,
    max_bytes: usize,
    max_pixels: u64,
) -> Result<Rgba8Image, String> {
    let path = folder.ok_or("linked files are not read")?.join(file);
    let limits = Limits::default().with_max_pixels(max_pixels);
    let decoded = decode(&read(&path, max_bytes)?, Format::from_path(&path), &limits);
    Ok(decoded.map_err(|error| error.to_string())?.into_rgba8())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_ordinary_files_of_limited_size_are_read() {
        let this = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/linked.rs");
        let size = std::fs::read(&this).unwrap().len();
        assert_eq!(read(&this, size).unwrap().len(), size);
        assert!(read(&this, size - 1).unwrap_err().contains("over"));
        assert!(read(this.parent().unwrap(), size).unwrap_err().contains("ordinary"));
        // It would be as large as the limit allows if it were read.
        assert!(read(Path::new("/dev/zero"), 1 << 20).is_err_and(|error| !error.contains("over")));
    }
}
