//! Points and directions: three numbers with commas between them.

use super::number::parse_finite;
use std::str::FromStr;

/// Three finite numbers, written `x,y,z`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Vector(pub(crate) [f64; 3]);

impl FromStr for Vector {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split(',').map(parse_finite).collect::<Result<Vec<_>, _>>()?;
        match <[f64; 3]>::try_from(numbers) {
            Ok(vector) => Ok(Self(vector)),
            Err(numbers) => Err(format!("three numbers are needed, x,y,z, not {}", numbers.len())),
        }
    }
}

impl Vector {
    /// The same vector, if it has a direction.
    pub(super) fn as_direction(self) -> Result<[f64; 3], String> {
        if self.0 == [0.0; 3] { Err("0,0,0 has no direction".to_owned()) } else { Ok(self.0) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_numbers_and_nothing_else() {
        assert_eq!("-1, 2.5,3e2".parse(), Ok(Vector([-1.0, 2.5, 300.0])));
        assert!("1,2".parse::<Vector>().unwrap_err().contains("not 2"));
        assert!("1,2,3,4".parse::<Vector>().is_err());
        assert!("1,,3".parse::<Vector>().unwrap_err().contains("missing"));
        assert!("1 2 3".parse::<Vector>().is_err());
        assert!(Vector([0.0; 3]).as_direction().is_err());
    }
}
