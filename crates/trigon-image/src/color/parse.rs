//! Colours as people write them: `#rgb`, `#rgba`, `#rrggbb`, `#rrggbbaa`, the names of CSS, `transparent` and `none`.

use std::fmt;
use std::str::FromStr;

use super::names::NAMED_COLORS;
use super::{premultiply, srgb_to_linear};

/// A colour of a user: four codes of 8 bits, sRGB-encoded, straight alpha.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Color {
    /// Red.
    pub r: u8,
    /// Green.
    pub g: u8,
    /// Blue.
    pub b: u8,
    /// Alpha: 0 is transparent, 255 opaque.
    pub a: u8,
}

impl Color {
    /// Opaque black.
    pub const BLACK: Self = Self::rgb(0, 0, 0);
    /// Opaque white.
    pub const WHITE: Self = Self::rgb(255, 255, 255);
    /// Transparent black.
    pub const TRANSPARENT: Self = Self { r: 0, g: 0, b: 0, a: 0 };

    /// An opaque colour.
    #[must_use]
    pub const fn rgb(r: u8, g: u8, b: u8) -> Self {
        Self { r, g, b, a: u8::MAX }
    }

    /// Reads `#rgb`, `#rgba`, `#rrggbb`, `#rrggbbaa`, a colour name of CSS, `transparent` or `none`, in any case, with
    /// blanks around it allowed.
    ///
    /// # Errors
    /// If it is none of these; the message says which forms there are.
    pub fn parse(text: &str) -> Result<Self, ParseColorError> {
        let error = |kind| ParseColorError { text: text.to_owned(), kind };
        let trimmed = text.trim();
        if let Some(digits) = trimmed.strip_prefix('#') {
            return parse_hex(digits).map_err(error);
        }
        let name = trimmed.to_ascii_lowercase();
        if name == "transparent" || name == "none" {
            return Ok(Self::TRANSPARENT);
        }
        match NAMED_COLORS.binary_search_by_key(&name.as_str(), |entry| entry.0) {
            Ok(found) => {
                let [_, r, g, b] = NAMED_COLORS[found].1.to_be_bytes();
                Ok(Self::rgb(r, g, b))
            }
            Err(_) => Err(error(ErrorKind::Name)),
        }
    }

    /// Red, green, blue, alpha as a pixel of [`Rgba8Image`](crate::Rgba8Image).
    #[must_use]
    pub const fn to_rgba8(self) -> [u8; 4] {
        [self.r, self.g, self.b, self.a]
    }

    /// Linear red, green, blue and alpha in 0..=1; straight alpha.
    #[must_use]
    pub fn to_linear(self) -> [f32; 4] {
        [srgb_to_linear(self.r), srgb_to_linear(self.g), srgb_to_linear(self.b), f32::from(self.a) / 255.0]
    }

    /// Linear and premultiplied: a pixel of [`RgbaF32Image`](crate::RgbaF32Image).
    #[must_use]
    pub fn to_linear_premultiplied(self) -> [f32; 4] {
        premultiply(self.to_linear())
    }
}

impl FromStr for Color {
    type Err = ParseColorError;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Self::parse(text)
    }
}

impl fmt::Display for Color {
    /// `#rrggbb`, or `#rrggbbaa` unless opaque.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { r, g, b, a } = self;
        write!(f, "#{r:02x}{g:02x}{b:02x}")?;
        if *a == u8::MAX { Ok(()) } else { write!(f, "{a:02x}") }
    }
}

/// Text that is no colour.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ParseColorError {
    text: String,
    kind: ErrorKind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum ErrorKind {
    /// A name that CSS does not have.
    Name,
    /// A number of digits other than 3, 4, 6, 8.
    Length(usize),
    /// A character that is no hexadecimal digit.
    Digit(char),
}

impl fmt::Display for ParseColorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = &self.text;
        match self.kind {
            ErrorKind::Name => {
                write!(
                    f,
                    "\"{text}\" is no colour: use #rgb, #rgba, #rrggbb, #rrggbbaa, a CSS name such as teal, or none"
                )
            }
            ErrorKind::Length(n) => {
                write!(f, "\"{text}\" is no colour: 3, 4, 6 or 8 hexadecimal digits follow #, not {n}")
            }
            ErrorKind::Digit(c) => write!(f, "\"{text}\" is no colour: '{c}' is no hexadecimal digit"),
        }
    }
}

impl std::error::Error for ParseColorError {}

fn parse_hex(text: &str) -> Result<Color, ErrorKind> {
    let digits = text
        .chars()
        .map(|c| c.to_digit(16).and_then(|digit| u8::try_from(digit).ok()).ok_or(ErrorKind::Digit(c)))
        .collect::<Result<Vec<u8>, _>>()?;
    let pair = |i: usize| digits[2 * i] * 16 + digits[2 * i + 1];
    let (r, g, b, a) = match *digits.as_slice() {
        [r, g, b] => (r * 17, g * 17, b * 17, u8::MAX),
        [r, g, b, a] => (r * 17, g * 17, b * 17, a * 17),
        [_, _, _, _, _, _] => (pair(0), pair(1), pair(2), u8::MAX),
        [_, _, _, _, _, _, _, _] => (pair(0), pair(1), pair(2), pair(3)),
        _ => return Err(ErrorKind::Length(digits.len())),
    };
    Ok(Color { r, g, b, a })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_forms_are_read() {
        for (text, rgba) in [
            ("#f80", [255, 136, 0, 255]),
            ("#F808", [255, 136, 0, 136]),
            ("#123456", [0x12, 0x34, 0x56, 255]),
            (" #12345678 ", [0x12, 0x34, 0x56, 0x78]),
            ("RebeccaPurple", [0x66, 0x33, 0x99, 255]),
            ("transparent", [0; 4]),
            ("none", [0; 4]),
        ] {
            assert_eq!(Color::parse(text).unwrap().to_rgba8(), rgba, "{text}");
        }
    }

    #[test]
    fn names_are_sorted_and_complete() {
        assert!(NAMED_COLORS.is_sorted_by(|a, b| a.0 < b.0));
        // 148 names in CSS Color 4.
        assert_eq!(NAMED_COLORS.len(), 148);
        for &(name, code) in NAMED_COLORS {
            assert_eq!(Color::parse(name).unwrap().to_string(), format!("#{code:06x}"));
        }
    }

    #[test]
    fn errors_say_what_and_why() {
        for (text, part) in
            [("", "is no colour"), ("#12345", "not 5"), ("#12g", "'g'"), ("#é", "'é'"), ("redd", "CSS name")]
        {
            let message = Color::parse(text).unwrap_err().to_string();
            assert!(message.contains(part), "{message}");
        }
    }
}
