//! The image types: width, height and one vector of pixels, row 0 at the top.
//!
//! Four concrete types rather than one generic one, because each also fixes what its numbers mean: encoding, alpha and
//! range. All hold exactly `width * height` pixels, so a row is always there and code that draws needs no checks.

use std::fmt;

/// The number of pixels given does not equal width times height.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SizeMismatch {
    /// Width asked for, in pixels.
    pub width: u32,
    /// Height asked for, in pixels.
    pub height: u32,
    /// Number of pixels given.
    pub pixels: usize,
}

impl fmt::Display for SizeMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { width, height, pixels } = self;
        write!(f, "an image of {width}x{height} needs {} pixels, got {pixels}", u64::from(*width) * u64::from(*height))
    }
}

impl std::error::Error for SizeMismatch {}

/// Pixels of a `width * height` image, or `None` where that does not fit in memory.
fn pixel_count(width: u32, height: u32) -> Option<usize> {
    usize::try_from(u64::from(width) * u64::from(height)).ok()
}

macro_rules! image_type {
    ($(#[$doc:meta])* $name:ident of $pixel:ty, blank $blank:expr) => {
        $(#[$doc])*
        #[derive(Clone, PartialEq)]
        pub struct $name {
            width: u32,
            height: u32,
            pixels: Vec<$pixel>,
        }

        impl $name {
            /// An image of zeros (transparent black, depth 0).
            ///
            /// # Panics
            /// If `width * height` pixels do not fit in the address space.
            #[must_use]
            pub fn new(width: u32, height: u32) -> Self {
                Self::filled(width, height, $blank)
            }

            /// An image with every pixel set to `pixel`.
            ///
            /// # Panics
            /// If `width * height` pixels do not fit in the address space.
            #[must_use]
            pub fn filled(width: u32, height: u32, pixel: $pixel) -> Self {
                let count = pixel_count(width, height).expect("the image fits in the address space");
                Self { width, height, pixels: vec![pixel; count] }
            }

            /// Takes pixels in row order, row 0 at the top.
            ///
            /// # Errors
            /// If there are not exactly `width * height` of them.
            pub fn from_pixels(width: u32, height: u32, pixels: Vec<$pixel>) -> Result<Self, SizeMismatch> {
                if pixel_count(width, height) == Some(pixels.len()) {
                    Ok(Self { width, height, pixels })
                } else {
                    Err(SizeMismatch { width, height, pixels: pixels.len() })
                }
            }

            /// Width in pixels.
            #[must_use]
            pub fn width(&self) -> u32 {
                self.width
            }

            /// Height in pixels.
            #[must_use]
            pub fn height(&self) -> u32 {
                self.height
            }

            /// All pixels in row order: pixel (x, y) is at `y * width + x`.
            #[must_use]
            pub fn pixels(&self) -> &[$pixel] {
                &self.pixels
            }

            /// All pixels in row order, to write.
            pub fn pixels_mut(&mut self) -> &mut [$pixel] {
                &mut self.pixels
            }

            /// Gives the pixels away, in row order.
            #[must_use]
            pub fn into_pixels(self) -> Vec<$pixel> {
                self.pixels
            }

            /// Row `y`, `width` pixels long.
            ///
            /// # Panics
            /// If `y` is not below the height.
            #[must_use]
            pub fn row(&self, y: u32) -> &[$pixel] {
                &self.pixels[self.row_range(y)]
            }

            /// Row `y`, `width` pixels long, to write.
            ///
            /// # Panics
            /// If `y` is not below the height.
            pub fn row_mut(&mut self, y: u32) -> &mut [$pixel] {
                let range = self.row_range(y);
                &mut self.pixels[range]
            }

            /// The rows from the top down.
            pub fn rows(&self) -> impl DoubleEndedIterator<Item = &[$pixel]> + ExactSizeIterator {
                (0..self.height).map(|y| self.row(y))
            }

            /// The pixel at column `x` and row `y`.
            ///
            /// # Panics
            /// If it lies outside the image.
            #[must_use]
            pub fn pixel(&self, x: u32, y: u32) -> $pixel {
                self.row(y)[x as usize]
            }

            /// Sets the pixel at column `x` and row `y`.
            ///
            /// # Panics
            /// If it lies outside the image.
            pub fn set_pixel(&mut self, x: u32, y: u32, pixel: $pixel) {
                self.row_mut(y)[x as usize] = pixel;
            }

            fn row_range(&self, y: u32) -> std::ops::Range<usize> {
                assert!(y < self.height, "row {y} of an image of height {}", self.height);
                let width = self.width as usize;
                let start = y as usize * width;
                start..start + width
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "{}({}x{})", stringify!($name), self.width, self.height)
            }
        }
    };
}

image_type! {
    /// Eight bits a channel: red, green, blue, alpha; sRGB-encoded, straight alpha, row 0 at the top.
    ///
    /// The form of most picture files and of a finished frame. A file whose channels are not colours (a normal map) comes
    /// in this type too; its numbers are then as stored.
    Rgba8Image of [u8; 4], blank [0; 4]
}

image_type! {
    /// Sixteen bits a channel: red, green, blue, alpha; sRGB-encoded, straight alpha, row 0 at the top.
    Rgba16Image of [u16; 4], blank [0; 4]
}

image_type! {
    /// `f32` channels: red, green, blue, alpha; linear light, premultiplied alpha, row 0 at the top.
    ///
    /// Colour may exceed 1 (high dynamic range).
    RgbaF32Image of [f32; 4], blank [0.0; 4]
}

image_type! {
    /// One `f32` channel, row 0 at the top: depth, height, a mask. No transfer function.
    GrayF32Image of f32, blank 0.0
}

impl Eq for Rgba8Image {}
impl Eq for Rgba16Image {}

impl Rgba8Image {
    /// Takes `4 * width * height` bytes: red, green, blue, alpha, in row order.
    ///
    /// # Errors
    /// If the length is not that.
    pub fn from_bytes(width: u32, height: u32, bytes: &[u8]) -> Result<Self, SizeMismatch> {
        let (pixels, rest) = bytes.as_chunks::<4>();
        if rest.is_empty() {
            Self::from_pixels(width, height, pixels.to_vec())
        } else {
            Err(SizeMismatch { width, height, pixels: pixels.len() })
        }
    }

    /// The bytes red, green, blue, alpha of every pixel in row order.
    #[must_use]
    pub fn as_bytes(&self) -> &[u8] {
        self.pixels.as_flattened()
    }

    /// Whether every alpha is 255.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.pixels.iter().all(|p| p[3] == u8::MAX)
    }
}

impl Rgba16Image {
    /// Whether every alpha is 65535.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.pixels.iter().all(|p| p[3] == u16::MAX)
    }
}

impl RgbaF32Image {
    /// Whether every alpha is 1 or more.
    #[must_use]
    pub fn is_opaque(&self) -> bool {
        self.pixels.iter().all(|p| p[3] >= 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn pixels_are_in_row_order_from_the_top() {
        let image = GrayF32Image::from_pixels(3, 2, vec![0.0, 1.0, 2.0, 3.0, 4.0, 5.0]).unwrap();
        assert_eq!(image.row(1), [3.0, 4.0, 5.0]);
        assert_eq!(image.pixel(2, 0), 2.0);
        assert_eq!(image.rows().rev().map(|row| row[0]).collect::<Vec<_>>(), [3.0, 0.0]);
    }

    #[test]
    fn a_wrong_number_of_pixels_is_an_error() {
        let error = Rgba8Image::from_pixels(2, 2, vec![[0; 4]; 3]).unwrap_err();
        assert_eq!(error.to_string(), "an image of 2x2 needs 4 pixels, got 3");
        assert!(Rgba8Image::from_bytes(1, 1, &[0; 5]).is_err());
        assert!(Rgba8Image::from_pixels(u32::MAX, u32::MAX, Vec::new()).is_err());
    }

    #[test]
    fn images_may_be_empty() {
        let image = Rgba8Image::new(0, 5);
        assert_eq!(image.rows().map(<[_]>::len).collect::<Vec<_>>(), [0; 5]);
    }

    #[test]
    fn bytes_round_trip() {
        let mut image = Rgba8Image::new(2, 1);
        image.set_pixel(1, 0, [1, 2, 3, 4]);
        assert_eq!(image.as_bytes(), [0, 0, 0, 0, 1, 2, 3, 4]);
        assert_eq!(Rgba8Image::from_bytes(2, 1, image.as_bytes()).unwrap(), image);
        assert!(!image.is_opaque());
    }
}
