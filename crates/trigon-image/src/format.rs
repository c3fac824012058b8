//! Picture formats: found by content, by file extension or by name.
//!
//! Content decides first. Old TGA files have no magic number: for them the extension is needed.

use std::fmt;
use std::path::Path;

/// A picture file format.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Format {
    /// Portable Network Graphics; animated as APNG.
    Png,
    /// JPEG, baseline and progressive.
    Jpeg,
    /// Truevision TGA.
    Tga,
    /// Windows bitmap.
    Bmp,
    /// Tagged Image File Format.
    Tiff,
    /// WebP, lossy and lossless.
    WebP,
    /// Radiance RGBE.
    Hdr,
    /// Graphics Interchange Format.
    Gif,
    /// Quite OK Image.
    Qoi,
    /// OpenEXR.
    Exr,
}

/// What is known of a format in one place: its name, extensions (the usual one first) and magic numbers.
struct Entry {
    format: Format,
    name: &'static str,
    extensions: &'static [&'static str],
    writable: bool,
}

const ENTRIES: &[Entry] = &[
    Entry { format: Format::Png, name: "PNG", extensions: &["png", "apng"], writable: true },
    Entry { format: Format::Jpeg, name: "JPEG", extensions: &["jpg", "jpeg", "jpe", "jfif"], writable: true },
    Entry { format: Format::Tga, name: "TGA", extensions: &["tga", "targa", "vda", "icb", "vst"], writable: true },
    Entry { format: Format::Bmp, name: "BMP", extensions: &["bmp", "dib"], writable: false },
    Entry { format: Format::Tiff, name: "TIFF", extensions: &["tif", "tiff"], writable: false },
    Entry { format: Format::WebP, name: "WebP", extensions: &["webp"], writable: false },
    Entry { format: Format::Hdr, name: "HDR", extensions: &["hdr", "pic", "rgbe"], writable: false },
    Entry { format: Format::Gif, name: "GIF", extensions: &["gif"], writable: true },
    Entry { format: Format::Qoi, name: "QOI", extensions: &["qoi"], writable: true },
    Entry { format: Format::Exr, name: "EXR", extensions: &["exr"], writable: true },
];

impl Format {
    /// All formats.
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        ENTRIES.iter().map(|entry| entry.format)
    }

    /// The format of a file extension, without its dot, in any case: `"jpg"`, `"TGA"`.
    #[must_use]
    pub fn from_extension(extension: &str) -> Option<Self> {
        ENTRIES
            .iter()
            .find(|entry| entry.extensions.iter().any(|known| known.eq_ignore_ascii_case(extension)))
            .map(|entry| entry.format)
    }

    /// The format of a path, by its extension.
    #[must_use]
    pub fn from_path(path: &Path) -> Option<Self> {
        path.extension().and_then(|extension| Self::from_extension(extension.to_str()?))
    }

    /// The format of a name as a person writes it: the format's name or one of its extensions, in any case.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Self> {
        Self::all().find(|format| format.name().eq_ignore_ascii_case(name)).or_else(|| Self::from_extension(name))
    }

    /// The format of a file's content: by its first bytes, and for TGA by the signature that files of version 2.0 end with
    /// (older TGA files have no mark at all and are not found).
    #[must_use]
    pub fn sniff(bytes: &[u8]) -> Option<Self> {
        let starts = |magic: &[u8]| bytes.starts_with(magic);
        if starts(b"\x89PNG\r\n\x1a\n") {
            Some(Self::Png)
        } else if starts(b"\xff\xd8\xff") {
            Some(Self::Jpeg)
        } else if starts(b"GIF87a") || starts(b"GIF89a") {
            Some(Self::Gif)
        } else if starts(b"RIFF") && bytes.get(8..12) == Some(b"WEBP") {
            Some(Self::WebP)
        } else if starts(b"II\x2a\0") || starts(b"MM\0\x2a") || starts(b"II\x2b\0") || starts(b"MM\0\x2b") {
            Some(Self::Tiff)
        } else if starts(b"#?RADIANCE") || starts(b"#?RGBE") {
            Some(Self::Hdr)
        } else if starts(b"qoif") {
            Some(Self::Qoi)
        } else if starts(b"\x76\x2f\x31\x01") {
            Some(Self::Exr)
        } else if starts(b"BM") && is_bmp_header(bytes) {
            Some(Self::Bmp)
        } else if bytes.ends_with(TGA_SIGNATURE) {
            Some(Self::Tga)
        } else {
            None
        }
    }

    /// The name to show a person: `"PNG"`.
    #[must_use]
    pub fn name(self) -> &'static str {
        self.entry().name
    }

    /// The usual file extension, without its dot: `"png"`.
    #[must_use]
    pub fn extension(self) -> &'static str {
        self.entry().extensions[0]
    }

    /// Whether [`encode`](crate::encode()) writes it. All formats are read.
    #[must_use]
    pub fn is_writable(self) -> bool {
        self.entry().writable
    }

    fn entry(self) -> &'static Entry {
        ENTRIES.iter().find(|entry| entry.format == self).expect("every format has an entry")
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The last 18 bytes of a TGA file of version 2.0.
pub(crate) const TGA_SIGNATURE: &[u8; 18] = b"TRUEVISION-XFILE.\0";

/// Two letters are a weak magic number: asks also for a known size of the second header, at offset 14.
fn is_bmp_header(bytes: &[u8]) -> bool {
    matches!(bytes.get(14..18), Some(&[12 | 16 | 40 | 52 | 56 | 64 | 108 | 124, 0, 0, 0]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_format_is_found_by_its_names() {
        for format in Format::all() {
            assert_eq!(Format::from_extension(format.extension()), Some(format));
            assert_eq!(Format::from_name(format.name()), Some(format));
        }
        assert_eq!(Format::from_path(Path::new("a.b/c.TIF")), Some(Format::Tiff));
        assert_eq!(Format::from_path(Path::new("png")), None);
        assert_eq!(Format::from_name("jpeg"), Some(Format::Jpeg));
        assert_eq!(Format::from_extension(""), None);
    }

    #[test]
    fn short_files_have_no_format() {
        for bytes in [&b""[..], b"B", b"BM", b"RIFF", b"RIFFxxxxWEB", b"\x89PNG", b"GIF8"] {
            assert_eq!(Format::sniff(bytes), None);
        }
    }
}
