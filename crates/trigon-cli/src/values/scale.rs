//! Scale factors: one for all axes, or one for each.

use super::Vector;
use super::number::parse_finite;
use std::str::FromStr;

/// Three factors, none of them zero, written `2` or `1,1,0.5`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scale(pub(crate) [f64; 3]);

impl FromStr for Scale {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let factors = if text.contains(',') { text.parse::<Vector>()?.0 } else { [parse_finite(text)?; 3] };
        if factors.contains(&0.0) {
            Err("a factor of zero leaves nothing to draw".to_owned())
        } else {
            Ok(Self(factors))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_factor_or_three() {
        assert_eq!("2".parse(), Ok(Scale([2.0; 3])));
        assert_eq!("1,-1,0.5".parse(), Ok(Scale([1.0, -1.0, 0.5])));
        assert!("0".parse::<Scale>().unwrap_err().contains("zero"));
        assert!("1,2".parse::<Scale>().is_err());
    }
}
