//! Angles: degrees unless a unit follows; radians out.

use super::number::parse_finite;
use std::str::FromStr;

/// An angle in radians, written in degrees (`30`, `30deg`), radians (`0.5rad`) or turns (`0.25turn`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Angle(pub(crate) f64);

impl FromStr for Angle {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let split = text.find(|c: char| c.is_alphabetic() && c != 'e' && c != 'E').unwrap_or(text.len());
        let (number, unit) = text.split_at(split);
        let number = parse_finite(number)?;
        match unit.to_ascii_lowercase().as_str() {
            "" | "d" | "deg" => Ok(Self(number.to_radians())),
            "rad" => Ok(Self(number)),
            "turn" => Ok(Self(number * std::f64::consts::TAU)),
            _ => Err(format!("\"{unit}\" is no unit of angles: write degrees, or a number with deg, rad or turn")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn units_agree() {
        for text in ["90", " 90deg", "90d", "0.25turn", "9e1"] {
            let Angle(angle) = text.parse().unwrap();
            assert!((angle - FRAC_PI_2).abs() < 1e-15, "{text}: {angle}");
        }
        assert_eq!("-180".parse(), Ok(Angle(-PI)));
        assert_eq!("1.5rad".parse(), Ok(Angle(1.5)));
    }

    #[test]
    fn errors_name_the_part_that_is_wrong() {
        assert!("90grad".parse::<Angle>().unwrap_err().contains("\"grad\" is no unit"));
        assert!("x".parse::<Angle>().is_err());
        assert!("".parse::<Angle>().unwrap_err().contains("missing"));
    }
}
