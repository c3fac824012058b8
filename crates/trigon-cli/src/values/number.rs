//! Finite numbers: text in, an `f64` or a message out.

use std::str::FromStr;

/// Reads a finite number.
pub(super) fn parse_finite(text: &str) -> Result<f64, String> {
    let text = text.trim();
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(_) => Err(format!("{text} is not a finite number")),
        Err(_) if text.is_empty() => Err("a number is missing".to_owned()),
        Err(_) => Err(format!("\"{text}\" is no number")),
    }
}

/// Reads a finite number and rounds it to `f32`.
#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
pub(super) fn parse_finite_f32(text: &str) -> Result<f32, String> {
    let rounded = parse_finite(text)? as f32;
    if rounded.is_finite() { Ok(rounded) } else { Err(format!("{text} is too large")) }
}

/// A finite number above zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Positive(pub(crate) f64);

impl Positive {
    /// The number, rounded to `f32`.
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    pub(crate) fn to_f32(self) -> f32 {
        self.0 as f32
    }
}

/// A finite number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Real(f32);

impl Real {
    /// The number.
    pub(crate) fn to_f32(self) -> f32 {
        self.0
    }
}

impl FromStr for Real {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        parse_finite_f32(text).map(Self)
    }
}

/// A finite number, zero or above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct NonNegative(pub(crate) f64);

impl NonNegative {
    /// The number, rounded to `f32`.
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    pub(crate) fn to_f32(self) -> f32 {
        self.0 as f32
    }
}

impl FromStr for NonNegative {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = f64::from(parse_finite_f32(text)?);
        if number >= 0.0 { Ok(Self(number)) } else { Err(format!("{number} is below zero")) }
    }
}

impl FromStr for Positive {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = parse_finite(text)?;
        if number > 0.0 { Ok(Self(number)) } else { Err(format!("{number} is not above zero")) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_finite_numbers_are_read() {
        assert_eq!(parse_finite(" -1.5e2 "), Ok(-150.0));
        for text in ["", "inf", "nan", "1e999", "1,5", "0x10"] {
            assert!(parse_finite(text).is_err(), "{text}");
        }
        assert!(parse_finite_f32("1e39").unwrap_err().contains("too large"));
    }

    #[test]
    fn positive_excludes_zero() {
        assert_eq!("0.25".parse(), Ok(Positive(0.25)));
        assert!("0".parse::<Positive>().unwrap_err().contains("above zero"));
        assert!("-1".parse::<Positive>().is_err());
        assert_eq!("0".parse(), Ok(NonNegative(0.0)));
        assert!("-1".parse::<NonNegative>().unwrap_err().contains("below zero"));
    }
}
