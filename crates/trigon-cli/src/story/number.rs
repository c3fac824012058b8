//! Numbers in texts: six significant digits, right-aligned in columns.

/// A float with six significant digits, without zeros at its end.
pub(super) fn number(value: f32) -> String {
    let magnitude = value.abs();
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() || !(1e-4..1e7).contains(&magnitude) {
        return trimmed_exponent(&format!("{value:.5e}"));
    }
    let digits_before =
        if magnitude >= 1.0 { format!("{}", magnitude.trunc()).len() } else { leading_zeros(magnitude) };
    let decimals = if magnitude >= 1.0 { 6_usize.saturating_sub(digits_before) } else { 6 + digits_before };
    trimmed(&format!("{value:.decimals$}"))
}

/// Zeros between the point and the first digit.
fn leading_zeros(magnitude: f32) -> usize {
    [0.1, 0.01, 0.001].iter().filter(|limit| magnitude < **limit).count()
}

fn trimmed(text: &str) -> String {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text.to_owned() }
}

fn trimmed_exponent(text: &str) -> String {
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{}e{exponent}", trimmed(mantissa)),
        None => text.to_owned(),
    }
}

/// Numbers side by side, each right-aligned in a column of 13.
pub(super) fn columns(values: &[f32]) -> String {
    values.iter().map(|value| format!("{:>13}", number(*value))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn six_digits_whatever_the_size() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (-2.5, "-2.5"),
            (0.123_456_79, "0.123457"),
            (0.001_234_567_8, "0.00123457"),
            (12_345.678, "12345.7"),
            (3_000_000.0, "3000000"),
            (1e-7, "1e-7"),
            (-2.5e20, "-2.5e20"),
            (f32::INFINITY, "inf"),
            (f32::NAN, "NaN"),
        ] {
            assert_eq!(number(value), text);
        }
    }
}
