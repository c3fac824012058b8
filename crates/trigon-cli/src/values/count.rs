//! Counts with a suffix: `100000`, `64k`, `20M`, `4G`.

use std::str::FromStr;

/// A count. Suffixes are powers of 1024, as for memory: k, M, G, T.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Count(pub(crate) u64);

impl FromStr for Count {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        let digits = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        if digits.is_empty() {
            return Err(no_count(text));
        }
        let shift = match text[digits.len()..].to_ascii_lowercase().as_str() {
            "" => 0,
            "k" | "kib" => 10,
            "m" | "mib" => 20,
            "g" | "gib" => 30,
            "t" | "tib" => 40,
            suffix => return Err(format!("\"{suffix}\" is no suffix of counts: write k, M, G or T")),
        };
        let number: u64 = digits.parse().map_err(|_| no_count(text))?;
        number.checked_mul(1 << shift).map(Self).ok_or_else(|| format!("{text} is too large"))
    }
}

fn no_count(text: &str) -> String {
    format!("\"{text}\" is no count: write such as 500000 or 64M")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn suffixes_are_powers_of_1024() {
        assert_eq!("12".parse(), Ok(Count(12)));
        assert_eq!("3k".parse(), Ok(Count(3 << 10)));
        assert_eq!("4GiB".parse(), Ok(Count(4 << 30)));
        for text in ["", "k", "-1", "1.5M", "3x", "99999999T"] {
            assert!(text.parse::<Count>().is_err(), "{text}");
        }
    }
}
