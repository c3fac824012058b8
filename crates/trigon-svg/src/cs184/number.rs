//! Numbers and colors as the course's program reads them from attributes.

/// The number a text begins with, after blanks; what follows, such as `px`, does not count.
pub(super) fn leading(text: &str) -> Option<f64> {
    let text = text.trim_start();
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '+' | '-' | 'e' | 'E');
    let mut end = text.find(|c| !is_part(c)).unwrap_or(text.len());
    while end > 0 {
        match text[..end].parse::<f64>() {
            Ok(number) if number.is_finite() => return Some(number),
            _ => end -= 1,
        }
    }
    None
}

/// All numbers of a list, separated by blanks or commas.
pub(crate) fn list(text: &str) -> Vec<f64> {
    text.split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty()).map_while(leading).collect()
}

/// `#rrggbb` or `rrggbb`, each channel 0..=1; what is not hexadecimal ends the number, so that `none` is black.
pub(super) fn color(text: &str) -> [f32; 3] {
    let text = text.trim_start();
    let digits = text.strip_prefix('#').unwrap_or(text);
    let code = digits.chars().map_while(|c| c.to_digit(16)).take(8).fold(0u32, |code, digit| code << 4 | digit);
    let [_, r, g, b] = code.to_be_bytes();
    [r, g, b].map(|channel| f32::from(channel) / 255.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_end_where_they_end() {
        assert_eq!(leading("200.0px"), Some(200.0));
        assert_eq!(leading(" -1.5e2em"), Some(-150.0));
        assert_eq!(leading("px"), None);
        assert_eq!(leading("1e999"), Some(1e99));
        assert_eq!(list("1,2  3.5 ,4x"), [1.0, 2.0, 3.5, 4.0]);
    }

    #[test]
    fn colors_are_hexadecimal() {
        assert_eq!(color("#ff0033"), [1.0, 0.0, 0.2]);
        assert_eq!(color("FF0033"), [1.0, 0.0, 0.2]);
        assert_eq!(color("none"), [0.0; 3]);
    }
}
