//! Squares of a picture: the left column, the top row and the side, with commas between them.

use std::str::FromStr;

/// A square of pixels, written `x,y,size`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Inset {
    pub(crate) x: u32,
    pub(crate) y: u32,
    /// At least 1.
    pub(crate) size: u32,
}

impl FromStr for Inset {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers: Option<Vec<u32>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
        match numbers.as_deref() {
            Some(&[x, y, size]) if size > 0 => Ok(Self { x, y, size }),
            _ => Err(format!("\"{text}\" is no square: write its left column, top row and side, such as 40,30,16")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_whole_numbers() {
        assert_eq!("3, 4,16".parse(), Ok(Inset { x: 3, y: 4, size: 16 }));
        for text in ["3,4", "3,4,0", "-1,2,3", "a,b,c", ""] {
            assert!(text.parse::<Inset>().unwrap_err().contains("40,30,16"), "{text}");
        }
    }
}
