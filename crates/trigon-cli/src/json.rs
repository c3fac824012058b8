//! JSON values: built by the report, printed with two blanks of indentation (RFC 8259).

use std::fmt;

/// A value; members keep their order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Json {
    Bool(bool),
    Integer(u64),
    Signed(i64),
    /// Printed with three digits behind the point; null unless finite.
    Decimal(f64),
    /// Printed in full: the shortest decimals that read back as the same number; null unless finite.
    Float(f32),
    Text(String),
    /// Coordinates in full, on one line.
    Point([f64; 3]),
    List(Vec<Json>),
    /// A list on one line.
    Row(Vec<Json>),
    Object(Vec<(&'static str, Json)>),
}

impl From<&str> for Json {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Json {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<u64> for Json {
    fn from(number: u64) -> Self {
        Self::Integer(number)
    }
}

impl From<u32> for Json {
    fn from(number: u32) -> Self {
        Self::Integer(number.into())
    }
}

impl From<usize> for Json {
    fn from(number: usize) -> Self {
        Self::Integer(u64::try_from(number).unwrap_or(u64::MAX))
    }
}

impl fmt::Display for Json {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_value(f, self, 0)
    }
}

fn write_value(f: &mut fmt::Formatter<'_>, value: &Json, depth: usize) -> fmt::Result {
    match value {
        Json::Bool(value) => write!(f, "{value}"),
        Json::Integer(number) => write!(f, "{number}"),
        Json::Decimal(number) if number.is_finite() => write!(f, "{number:.3}"),
        Json::Signed(number) => write!(f, "{number}"),
        Json::Float(number) if number.is_finite() => write!(f, "{number:?}"),
        Json::Decimal(_) | Json::Float(_) => f.write_str("null"),
        Json::Text(text) => write_text(f, text),
        // Shortest decimals that read back as the same numbers.
        Json::Point([x, y, z]) if [x, y, z].iter().all(|c| c.is_finite()) => write!(f, "[{x}, {y}, {z}]"),
        Json::Point(_) => f.write_str("null"),
        Json::List(items) => write_all(f, depth, '[', ']', items, |f, item| write_value(f, item, depth + 1)),
        Json::Row(items) => {
            f.write_str("[")?;
            for (i, item) in items.iter().enumerate() {
                f.write_str(if i > 0 { ", " } else { "" })?;
                write_value(f, item, depth)?;
            }
            f.write_str("]")
        }
        Json::Object(members) => write_all(f, depth, '{', '}', members, |f, (name, member)| {
            write_text(f, name)?;
            f.write_str(": ")?;
            write_value(f, member, depth + 1)
        }),
    }
}

fn write_all<T>(
    f: &mut fmt::Formatter<'_>,
    depth: usize,
    open: char,
    close: char,
    items: &[T],
    write_item: impl Fn(&mut fmt::Formatter<'_>, &T) -> fmt::Result,
) -> fmt::Result {
    write!(f, "{open}")?;
    for (i, item) in items.iter().enumerate() {
        let comma = if i > 0 { "," } else { "" };
        write!(f, "{comma}\n{:1$}", "", 2 * (depth + 1))?;
        write_item(f, item)?;
    }
    if !items.is_empty() {
        write!(f, "\n{:1$}", "", 2 * depth)?;
    }
    write!(f, "{close}")
}

fn write_text(f: &mut fmt::Formatter<'_>, text: &str) -> fmt::Result {
    f.write_str("\"")?;
    for c in text.chars() {
        match c {
            '"' | '\\' => write!(f, "\\{c}")?,
            '\n' => f.write_str("\\n")?,
            '\t' => f.write_str("\\t")?,
            c if c.is_control() => write!(f, "\\u{:04x}", u32::from(c))?,
            c => write!(f, "{c}")?,
        }
    }
    f.write_str("\"")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_print_as_json() {
        let value = Json::Object(vec![
            ("text", "a \"b\"\\\n\u{1}é".into()),
            ("list", Json::List(vec![Json::Integer(u64::MAX), Json::Bool(true), Json::Decimal(0.25)])),
            ("empty", Json::List(Vec::new())),
            ("point", Json::Point([0.1, -2.0, 1e-7])),
            ("row", Json::Row(vec![Json::Signed(-3), Json::Float(0.1), Json::Float(1e-20), Json::Float(2.0)])),
            ("nothing", Json::Decimal(f64::NAN)),
        ]);
        let expected = "{\n  \"text\": \"a \\\"b\\\"\\\\\\n\\u0001é\",\n  \"list\": [\n    18446744073709551615,\n    \
                        true,\n    0.250\n  ],\n  \"empty\": [],\n  \"point\": [0.1, -2, 0.0000001],\n  \
                        \"row\": [-3, 0.1, 1e-20, 2.0],\n  \"nothing\": null\n}";
        assert_eq!(value.to_string(), expected);
    }
}
