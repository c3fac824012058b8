//! What `trigon compare` varies: an option's name and the values it takes.

use std::str::FromStr;

/// An option and its values, written `name=value,value,..`; with semicolons between values that have commas in them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Axis {
    /// The long name, without dashes.
    pub(crate) name: String,
    pub(crate) values: Vec<String>,
}

impl FromStr for Axis {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let Some((name, values)) = text.split_once('=') else {
            return Err(format!("\"{text}\" has no values: write NAME=VALUE,VALUE such as samples=1,4,16"));
        };
        let separator = if values.contains(';') { ';' } else { ',' };
        let mut values: Vec<String> = values.split(separator).map(|value| value.trim().to_owned()).collect();
        if separator == ';' && values.last().is_some_and(String::is_empty) {
            values.pop();
        }
        let mut seen = values.clone();
        seen.sort_unstable();
        seen.dedup();
        match values.iter().any(String::is_empty) {
            true => Err(format!("\"{text}\" has a value that is empty")),
            false if seen.len() < values.len() => Err(format!("\"{text}\" has the same value twice")),
            false => Ok(Self { name: name.trim().trim_start_matches('-').to_owned(), values }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axis(name: &str, values: &[&str]) -> Result<Axis, String> {
        Ok(Axis { name: name.to_owned(), values: values.iter().map(ToString::to_string).collect() })
    }

    #[test]
    fn commas_or_semicolons_separate_values() {
        assert_eq!("samples=1,4, 9".parse(), axis("samples", &["1", "4", "9"]));
        assert_eq!("--eye=0,2,6;1,2,6".parse(), axis("eye", &["0,2,6", "1,2,6"]));
        assert_eq!("eye=0,2,6;".parse(), axis("eye", &["0,2,6"]));
        for (text, words) in [("samples", "no values"), ("samples=", "empty"), ("a=1,,2", "empty"), ("a=1,1", "twice")]
        {
            assert!(text.parse::<Axis>().unwrap_err().contains(words), "{text}");
        }
    }
}
