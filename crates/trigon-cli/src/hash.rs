//! The hash of a picture: its bytes in, 64 bits out, the same on every machine.
//!
//! FNV-1a (Fowler, Noll, Vo; RFC 9923): a few lines in any language, so that anyone can check a report.

use trigon_image::Rgba8Image;

const OFFSET_BASIS: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

/// A hash that grows with each picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PictureHash(u64);

impl PictureHash {
    /// The hash of nothing.
    pub(crate) fn new() -> Self {
        Self(OFFSET_BASIS)
    }

    /// Adds the pixels, row by row from the top: red, green, blue, alpha; sRGB-encoded, straight alpha.
    pub(crate) fn add(&mut self, picture: &Rgba8Image) {
        for byte in picture.pixels().as_flattened() {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(PRIME);
        }
    }

    /// Sixteen hexadecimal digits.
    pub(crate) fn to_hex(self) -> String {
        format!("{:016x}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values() {
        // Computed from the definition; pixels have four bytes, so the published vectors do not fit.
        let mut hash = PictureHash::new();
        assert_eq!(hash.to_hex(), "cbf29ce484222325");
        hash.add(&Rgba8Image::filled(1, 1, *b"foob"));
        assert_eq!(hash.to_hex(), "dd120e790c2512af");
    }
}
