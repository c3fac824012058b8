//! How large a picture a decoder may make: checked against the header, before anything is allocated.

use crate::DecodeError;

/// The largest picture a decoder accepts.
///
/// A file of a hundred bytes can claim a picture of many gigabytes. Every decoder of this crate checks the size in the
/// header against these limits before it allocates.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub struct Limits {
    /// Largest width, in pixels.
    pub max_width: u32,
    /// Largest height, in pixels.
    pub max_height: u32,
    /// Largest width times height.
    pub max_pixels: u64,
    /// Largest size of the decoded picture in memory, in bytes (4 a pixel for 8-bit pictures, 8 for 16-bit,
    /// 16 for float; 8 for a progressive JPEG file in colour, which takes more to work with).
    ///
    /// A decoder may need as much again for its own working memory.
    pub max_bytes: u64,
}

impl Default for Limits {
    /// 32768 pixels a side, 2^27 pixels (134 million), 1 GiB.
    fn default() -> Self {
        Self { max_width: 1 << 15, max_height: 1 << 15, max_pixels: 1 << 27, max_bytes: 1 << 30 }
    }
}

impl Limits {
    /// No limit but the address space, for files that are trusted.
    #[must_use]
    pub fn none() -> Self {
        Self { max_width: u32::MAX, max_height: u32::MAX, max_pixels: u64::MAX, max_bytes: u64::MAX }
    }

    /// These limits with at most `pixels` pixels (width times height).
    #[must_use]
    pub fn with_max_pixels(self, pixels: u64) -> Self {
        Self { max_pixels: pixels, ..self }
    }

    /// These limits with at most `side` pixels in width and in height.
    #[must_use]
    pub fn with_max_side(self, side: u32) -> Self {
        Self { max_width: side, max_height: side, ..self }
    }

    /// These limits with at most `bytes` bytes in memory.
    #[must_use]
    pub fn with_max_bytes(self, bytes: u64) -> Self {
        Self { max_bytes: bytes, ..self }
    }

    /// Checks the size of a picture with pixels of `pixel_bytes` bytes; gives width times height.
    ///
    /// # Errors
    /// [`DecodeError::LimitExceeded`] with the limit, what was asked and what is allowed.
    pub fn check(&self, width: u32, height: u32, pixel_bytes: usize) -> Result<usize, DecodeError> {
        let pixels = u64::from(width) * u64::from(height);
        let bytes = pixels.saturating_mul(pixel_bytes as u64);
        // A vector holds at most isize::MAX bytes, whatever the caller allows.
        let addressable = u64::try_from(isize::MAX).unwrap_or(u64::MAX);
        for (limit, asked, allowed) in [
            ("max_width", u64::from(width), u64::from(self.max_width)),
            ("max_height", u64::from(height), u64::from(self.max_height)),
            ("max_pixels", pixels, self.max_pixels),
            ("max_bytes", bytes, self.max_bytes.min(addressable)),
        ] {
            if asked > allowed {
                return Err(DecodeError::LimitExceeded { limit, asked, allowed });
            }
        }
        usize::try_from(pixels).map_err(|_| DecodeError::LimitExceeded {
            limit: "max_pixels",
            asked: pixels,
            allowed: usize::MAX as u64,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_limit_is_named() {
        let limits = Limits { max_width: 10, max_height: 20, max_pixels: 100, max_bytes: 200 };
        assert_eq!(limits.check(10, 5, 4).unwrap(), 50);
        for (width, height, name) in
            [(11, 1, "max_width"), (1, 21, "max_height"), (10, 11, "max_pixels"), (10, 6, "max_bytes")]
        {
            let Err(DecodeError::LimitExceeded { limit, asked, allowed }) = limits.check(width, height, 4) else {
                panic!("{width}x{height} must exceed {name}")
            };
            assert_eq!(limit, name);
            assert!(asked > allowed);
        }
    }

    #[test]
    fn the_largest_header_does_not_overflow() {
        assert!(Limits::none().check(u32::MAX, u32::MAX, 16).is_err());
    }
}
