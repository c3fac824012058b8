//! A position in a text file: skips blanks, reads numbers and names, and knows where lines end.
//!
//! Lines end with LF, CR LF or CR. A backslash before a line end continues the line and counts as a blank. The end of
//! the file ends the line too, so callers never test for it: [`Cursor::peek`] then answers with a line feed.

use super::float;

/// A cursor over the bytes of a text file.
#[derive(Clone)]
pub(crate) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Line ends passed so far.
    lines: u32,
}

impl<'a> Cursor<'a> {
    #[inline]
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, lines: 0 }
    }

    /// The number of line ends passed: the zero-based number of the current line.
    #[inline]
    pub(crate) fn lines(&self) -> u32 {
        self.lines
    }

    /// The offset of the next byte.
    #[inline]
    pub(crate) fn offset(&self) -> usize {
        self.at
    }

    #[inline]
    pub(crate) fn is_at_end(&self) -> bool {
        self.at >= self.bytes.len()
    }

    /// The bytes not yet read.
    #[inline]
    pub(crate) fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }

    /// The next byte; a line feed at the end of the file.
    #[inline(always)]
    pub(crate) fn peek(&self) -> u8 {
        self.byte(self.at)
    }

    /// The byte `ahead` bytes after the next.
    #[inline(always)]
    pub(crate) fn peek_ahead(&self, ahead: usize) -> u8 {
        self.byte(self.at + ahead)
    }

    /// Steps over `count` bytes that are not part of a line end.
    #[inline(always)]
    pub(crate) fn skip(&mut self, count: usize) {
        self.at += count;
    }

    #[inline(always)]
    fn byte(&self, at: usize) -> u8 {
        self.bytes.get(at).copied().unwrap_or(b'\n')
    }

    /// Skips blanks, tabs and continued line ends.
    #[inline(always)]
    pub(crate) fn skip_blanks(&mut self) {
        loop {
            match self.peek() {
                b' ' | b'\t' => self.at += 1,
                b'\\' if self.skip_continuation() => {}
                _ => return,
            }
        }
    }

    /// Whether the line ends here.
    #[inline(always)]
    pub(crate) fn is_at_line_end(&self) -> bool {
        matches!(self.peek(), b'\n' | b'\r')
    }

    /// Steps over a backslash and the line end after it; `false` (and no step) if there is no line end.
    #[cold]
    fn skip_continuation(&mut self) -> bool {
        let width = match (self.byte(self.at + 1), self.byte(self.at + 2)) {
            (b'\r', b'\n') => 3,
            (b'\n' | b'\r', _) => 2,
            _ => return false,
        };
        self.at = (self.at + width).min(self.bytes.len());
        self.lines += 1;
        true
    }

    /// Goes to the start of the next line, whatever is left of this one.
    #[inline(always)]
    pub(crate) fn finish_line(&mut self) {
        loop {
            match self.peek() {
                b'\n' => {
                    self.at += 1;
                    self.lines += 1;
                    return;
                }
                b'\r' => {
                    self.at += if self.peek_ahead(1) == b'\n' { 2 } else { 1 };
                    self.lines += 1;
                    return;
                }
                b'\\' if self.skip_continuation() => {}
                _ => self.at += 1,
            }
        }
    }

    /// Goes to the start of the next line; a backslash at the end does not continue it. For comments.
    #[inline]
    pub(crate) fn finish_comment(&mut self) {
        while !self.is_at_line_end() {
            self.at += 1;
        }
        self.finish_line();
    }

    /// The rest of the line as written, continued lines included, without blanks around it. Stays before the line end.
    pub(crate) fn rest_of_line(&mut self) -> &'a [u8] {
        self.skip_blanks();
        let start = self.at;
        while !self.is_at_line_end() {
            if self.peek() != b'\\' || !self.skip_continuation() {
                self.at += 1;
            }
        }
        self.bytes.get(start..self.at).unwrap_or_default().trim_ascii()
    }

    /// The next word: bytes up to a blank or line end; empty at the end of the line.
    pub(crate) fn word(&mut self) -> &'a [u8] {
        self.skip_blanks();
        let start = self.at;
        while !self.is_token_end() {
            self.at += 1;
        }
        self.bytes.get(start..self.at).unwrap_or_default()
    }

    /// The word that was read last: up to here from the blank before it.
    pub(crate) fn last_word(&self) -> &'a [u8] {
        let read = self.bytes.get(..self.at).unwrap_or_default();
        let start = read.iter().rposition(u8::is_ascii_whitespace).map_or(0, |blank| blank + 1);
        &read[start..]
    }

    #[inline(always)]
    fn is_token_end(&self) -> bool {
        match self.peek() {
            b' ' | b'\t' | b'\n' | b'\r' => true,
            b'\\' => matches!(self.peek_ahead(1), b'\n' | b'\r'),
            _ => false,
        }
    }

    /// The next number of the line. `Ok(None)` at the end of the line or before a comment; `Err` holds a token that is
    /// not a number, which has been stepped over.
    ///
    /// Any decimal notation: sign, leading or trailing point, exponent; `inf`, `nan` and what C runtimes print for
    /// them. Correctly rounded.
    #[inline(always)]
    pub(crate) fn float(&mut self) -> Result<Option<f32>, &'a [u8]> {
        self.skip_blanks();
        let start = self.at;
        let first = self.peek();
        let negative = first == b'-';
        if negative || first == b'+' {
            self.at += 1;
        }
        let (mut digits, mut n_digits) = self.digits(0);
        let mut exponent = 0;
        if self.peek() == b'.' {
            self.at += 1;
            let (all, n_fraction) = self.digits(digits);
            digits = all;
            exponent = -n_fraction;
            n_digits += n_fraction;
        }
        if matches!(self.peek(), b'e' | b'E') {
            self.at += 1;
            exponent += self.exponent();
        }
        // Nineteen digits always fit 64 bits.
        if (1..=19).contains(&n_digits)
            && self.is_token_end()
            && let Some(value) = float::nearest_f32(digits, exponent)
        {
            return Ok(Some(if negative { -value } else { value }));
        }
        self.at = start;
        self.unusual_float()
    }

    /// Appends decimal digits to `value` (wrapping); also how many there were.
    #[inline(always)]
    fn digits(&mut self, mut value: u64) -> (u64, i32) {
        let start = self.at;
        loop {
            let digit = self.peek().wrapping_sub(b'0');
            if digit > 9 {
                break;
            }
            value = value.wrapping_mul(10).wrapping_add(u64::from(digit));
            self.at += 1;
        }
        (value, i32::try_from(self.at - start).unwrap_or(i32::MAX / 4))
    }

    /// The digits after `e`; a result out of range of the quick conversion if there are none or too many.
    #[inline]
    fn exponent(&mut self) -> i32 {
        let first = self.peek();
        if first == b'-' || first == b'+' {
            self.at += 1;
        }
        let (value, n_digits) = self.digits(0);
        let value = if (1..=4).contains(&n_digits) { i32::try_from(value).unwrap_or(100_000) } else { 100_000 };
        if first == b'-' { -value } else { value }
    }

    #[cold]
    fn unusual_float(&mut self) -> Result<Option<f32>, &'a [u8]> {
        if self.is_at_line_end() || self.peek() == b'#' {
            return Ok(None);
        }
        let token = self.word();
        match float::parse_token(token) {
            Some(value) => Ok(Some(value)),
            None => Err(token),
        }
    }

    /// The next decimal integer with its sign, without skipping blanks; `None` (and no step) if no digit comes next.
    /// Values beyond `u32` saturate.
    #[inline(always)]
    pub(crate) fn integer(&mut self) -> Option<(bool, u32)> {
        let start = self.at;
        let first = self.peek();
        let negative = first == b'-';
        if negative || first == b'+' {
            self.at += 1;
        }
        let (value, n_digits) = self.digits(0);
        if n_digits == 0 {
            self.at = start;
            return None;
        }
        let value = if n_digits > 19 { u32::MAX } else { u32::try_from(value).unwrap_or(u32::MAX) };
        Some((negative, value))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn floats(text: &str) -> Vec<Result<f32, String>> {
        let mut cursor = Cursor::new(text.as_bytes());
        let mut all = Vec::new();
        loop {
            match cursor.float() {
                Ok(Some(value)) => all.push(Ok(value)),
                Ok(None) => return all,
                Err(token) => all.push(Err(String::from_utf8_lossy(token).into_owned())),
            }
        }
    }

    #[test]
    fn any_decimal_notation_is_read() {
        let text = "1 +1. -.5 1e3 1.5E-2 +2.e+1 007 0.1e01 123456789012345678901234567890 1e-50 1e50 -0";
        let expected = [1.0, 1.0, -0.5, 1e3, 1.5e-2, 20.0, 7.0, 1.0, 1.234_567_9e29, 0.0, f32::INFINITY, -0.0];
        let got: Vec<f32> = floats(text).into_iter().map(Result::unwrap).collect();
        let bits = |values: &[f32]| values.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&got), bits(&expected), "{got:?}");
    }

    #[test]
    fn words_that_are_not_numbers_are_handed_back() {
        assert_eq!(floats("1 abc 2"), [Ok(1.0), Err("abc".into()), Ok(2.0)]);
        assert_eq!(floats("1e 2"), [Err("1e".into()), Ok(2.0)]);
        assert_eq!(floats("- 2"), [Err("-".into()), Ok(2.0)]);
        assert_eq!(floats("3 # 4"), [Ok(3.0)]);
        assert_eq!(floats("1x"), [Err("1x".into())]);
    }

    #[test]
    fn prints_of_every_float_are_read_back_exactly() {
        let mut bits = 1_u32;
        for _ in 0..200_000 {
            bits = bits.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let value = f32::from_bits(bits);
            if value.is_finite() {
                for text in [format!("{value}"), format!("{value:e}"), format!("{value:.6}")] {
                    let expected: f32 = text.parse().unwrap();
                    assert_eq!(floats(&text)[0].clone().unwrap().to_bits(), expected.to_bits(), "{text}");
                }
            }
        }
    }

    #[test]
    fn every_line_end_counts_once_and_continuations_join() {
        let mut cursor = Cursor::new(b"a\nb\r\nc\rd \\\r\n e\\\nf\ng");
        let mut lines = Vec::new();
        while !cursor.is_at_end() {
            let number = cursor.lines();
            lines.push((number, String::from_utf8_lossy(cursor.rest_of_line()).into_owned()));
            cursor.finish_line();
        }
        let texts: Vec<_> = lines.iter().map(|(n, text)| (*n, text.as_str())).collect();
        assert_eq!(texts, [(0, "a"), (1, "b"), (2, "c"), (3, "d \\\r\n e\\\nf"), (6, "g")]);
    }

    #[test]
    fn a_backslash_at_the_end_of_the_file_is_harmless() {
        for text in ["v 1 \\", "v 1 \\\n", "\\", "\\\r", "\\\r\n"] {
            let mut cursor = Cursor::new(text.as_bytes());
            while !cursor.is_at_end() {
                cursor.skip_blanks();
                cursor.finish_line();
            }
        }
    }
}
