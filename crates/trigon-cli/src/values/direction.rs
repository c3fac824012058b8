//! The up direction: an axis with its sign, or a vector.

use super::Vector;
use std::str::FromStr;

/// A direction, written `+Y`, `-z`, `X` or `x,y,z`; never zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct UpDirection(pub(crate) [f64; 3]);

impl UpDirection {
    pub(crate) const PLUS_Y: Self = Self([0.0, 1.0, 0.0]);
    pub(crate) const PLUS_Z: Self = Self([0.0, 0.0, 1.0]);
}

impl FromStr for UpDirection {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        if text.contains(',') {
            return Ok(Self(text.parse::<Vector>()?.as_direction()?));
        }
        let (sign, axis) = match text.strip_prefix('-') {
            Some(axis) => (-1.0, axis),
            None => (1.0, text.strip_prefix('+').unwrap_or(text)),
        };
        match axis.to_ascii_lowercase().as_str() {
            "x" => Ok(Self([sign, 0.0, 0.0])),
            "y" => Ok(Self([0.0, sign, 0.0])),
            "z" => Ok(Self([0.0, 0.0, sign])),
            _ => Err(format!("\"{text}\" is no direction: write an axis such as +Y or -Z, or a vector x,y,z")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_and_vectors() {
        assert_eq!("+Z".parse(), Ok(UpDirection::PLUS_Z));
        assert_eq!("y".parse(), Ok(UpDirection::PLUS_Y));
        assert_eq!("-x".parse(), Ok(UpDirection([-1.0, 0.0, 0.0])));
        assert_eq!("0.5,1,-2".parse(), Ok(UpDirection([0.5, 1.0, -2.0])));
        for text in ["", "+", "w", "0,0,0", "+-Y", "1,2"] {
            assert!(text.parse::<UpDirection>().is_err(), "{text}");
        }
    }
}
