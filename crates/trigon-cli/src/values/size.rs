//! Picture sizes: `1920x1080`, `512` for a square, or a name.

use super::closest;
use std::fmt;
use std::str::FromStr;
use trigon::target::MAX_SIZE;

/// Width and height in pixels, each 1 to [`MAX_SIZE`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PictureSize {
    pub(crate) width: u32,
    pub(crate) height: u32,
}

const NAMED_SIZES: [(&str, u32, u32); 5] =
    [("hd720", 1280, 720), ("hd1080", 1920, 1080), ("qhd", 2560, 1440), ("4k", 3840, 2160), ("8k", 7680, 4320)];

impl FromStr for PictureSize {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let lower = text.trim().to_ascii_lowercase();
        if let Some(&(_, width, height)) = NAMED_SIZES.iter().find(|entry| entry.0 == lower) {
            return Ok(Self { width, height });
        }
        let (width, height) = lower.split_once('x').unwrap_or((&lower, &lower));
        match (width.trim().parse::<u64>(), height.trim().parse::<u64>()) {
            (Ok(width), Ok(height)) => Self::checked(width, height),
            _ => Err(not_a_size(text, &lower)),
        }
    }
}

impl PictureSize {
    fn checked(width: u64, height: u64) -> Result<Self, String> {
        let side = |pixels: u64| u32::try_from(pixels).ok().filter(|pixels| (1..=MAX_SIZE).contains(pixels));
        match (side(width), side(height)) {
            (Some(width), Some(height)) => Ok(Self { width, height }),
            _ => Err(format!("{width}x{height} is out of range: each side has 1 to {MAX_SIZE} pixels")),
        }
    }
}

fn not_a_size(text: &str, lower: &str) -> String {
    match closest(lower, NAMED_SIZES.map(|entry| entry.0)) {
        Some(name) => format!("\"{text}\" is no size; did you mean {name}?"),
        None => format!(
            "\"{text}\" is no size: write WIDTHxHEIGHT such as 1920x1080, one number for a square, or hd720, hd1080, \
             qhd, 4k or 8k"
        ),
    }
}

impl fmt::Display for PictureSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(width: u32, height: u32) -> Result<PictureSize, String> {
        Ok(PictureSize { width, height })
    }

    #[test]
    fn all_forms_are_read() {
        assert_eq!("1920x1080".parse(), size(1920, 1080));
        assert_eq!("640X480".parse(), size(640, 480));
        assert_eq!("512".parse(), size(512, 512));
        assert_eq!("HD1080".parse(), size(1920, 1080));
        assert_eq!("4k".parse(), size(3840, 2160));
        assert_eq!("7x3".parse::<PictureSize>().unwrap().to_string(), "7x3");
    }

    #[test]
    fn errors_say_what_to_write() {
        let message = |text: &str| text.parse::<PictureSize>().unwrap_err();
        assert!(message("hd1081").contains("did you mean hd1080?"));
        assert!(message("big").contains("1920x1080"));
        assert!(message("0").contains("1 to 16384"));
        assert!(message("20000x10").contains("out of range"));
        assert!(message("99999999999x1").contains("out of range"));
        assert!(message("-5x5").contains("is no size"));
        assert!(message("1920x").contains("is no size"));
    }
}
