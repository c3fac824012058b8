//! Pixels: column and row with a comma between them.

use std::str::FromStr;

/// Column and row, from 0 at the top left, written `x,y`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PixelPlace(pub(crate) [u32; 2]);

impl FromStr for PixelPlace {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Option<Vec<u32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
        match numbers.as_deref() {
            Some(&[x, y]) => Ok(Self([x, y])),
            _ => Err(format!("\"{text}\" is no pixel: write its column and row, such as 320,240")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_whole_numbers() {
        assert_eq!("3, 40".parse(), Ok(PixelPlace([3, 40])));
        for text in ["3", "3,4,5", "-1,2", "1.5,2", "", "a,b"] {
            assert!(text.parse::<PixelPlace>().unwrap_err().contains("320,240"), "{text}");
        }
    }
}
