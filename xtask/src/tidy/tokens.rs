//! Rust text to tokens and comments, so that a rule about code does not trip over strings and comments.
//!
//! Enough of the lexical grammar to be right about where code is: nested block comments, raw and byte strings,
//! character literals against lifetimes. Joined punctuation that the rules need (`::`, `=>`, `||`, ..) is one token.

/// One token of code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Token<'t> {
    pub(crate) text: &'t str,
    /// Counted from 1.
    pub(crate) line: usize,
    pub(crate) kind: Kind,
}

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Ident,
    Lifetime,
    Literal,
    Punct,
}

/// One comment, with its slashes; a block comment is reported at its first line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Comment<'t> {
    pub(crate) text: &'t str,
    pub(crate) line: usize,
}

/// Everything in one source file.
#[derive(Debug, Default)]
pub(crate) struct Scan<'t> {
    pub(crate) tokens: Vec<Token<'t>>,
    pub(crate) comments: Vec<Comment<'t>>,
}

const JOINED: [&str; 10] = ["::", "=>", "->", "||", "&&", "|=", "==", "!=", "<=", ".."];

/// Splits `text` into tokens and comments.
pub(crate) fn scan(text: &str) -> Scan<'_> {
    let mut scan = Scan::default();
    let mut at = 0;
    let mut line = 1;
    while at < text.len() {
        let rest = &text[at..];
        let length;
        if rest.starts_with("//") {
            length = rest.find('\n').unwrap_or(rest.len());
            scan.comments.push(Comment { text: &rest[..length], line });
        } else if rest.starts_with("/*") {
            length = block_comment_length(rest);
            scan.comments.push(Comment { text: &rest[..length], line });
        } else if rest.starts_with(char::is_whitespace) {
            length = rest.chars().next().map_or(1, char::len_utf8);
        } else {
            let kind;
            (kind, length) = token(rest);
            scan.tokens.push(Token { text: &rest[..length], line, kind });
        }
        line += rest[..length].matches('\n').count();
        at += length;
    }
    scan
}

/// The kind and length of the token at the start of `rest`, which is neither blank nor a comment.
fn token(rest: &str) -> (Kind, usize) {
    if let Some(length) = string_length(rest) {
        return (Kind::Literal, length);
    }
    let first = rest.chars().next().unwrap_or(' ');
    if first == '\'' {
        return quote(rest);
    }
    if first.is_ascii_digit() {
        return (Kind::Literal, number_length(rest));
    }
    if is_word(first) {
        let prefix = if rest.starts_with("r#") { 2 } else { 0 };
        return (Kind::Ident, prefix + word_length(&rest[prefix..]));
    }
    let joined = JOINED.iter().find(|joined| rest.starts_with(**joined));
    (Kind::Punct, joined.map_or(first.len_utf8(), |joined| joined.len()))
}

fn block_comment_length(rest: &str) -> usize {
    let mut depth = 0;
    let mut at = 0;
    while at < rest.len() {
        if rest[at..].starts_with("/*") {
            depth += 1;
            at += 2;
        } else if rest[at..].starts_with("*/") {
            depth -= 1;
            at += 2;
            if depth == 0 {
                return at;
            }
        } else {
            at += rest[at..].chars().next().map_or(1, char::len_utf8);
        }
    }
    rest.len()
}

/// The length of the string literal at the start of `rest`, if there is one: `"`, `b"`, `c"`, `r"`, `r#"`, `br#"` ..
fn string_length(rest: &str) -> Option<usize> {
    let prefix = ["br", "cr", "r", "b", "c", ""].into_iter().find(|prefix| rest.starts_with(prefix))?;
    let raw = prefix.ends_with('r');
    let body = &rest[prefix.len()..];
    let hashes = if raw { body.len() - body.trim_start_matches('#').len() } else { 0 };
    let inside = body[hashes..].strip_prefix('"')?;
    let opening = prefix.len() + hashes + 1;
    if raw {
        let closing = format!("\"{}", "#".repeat(hashes));
        return Some(inside.find(&closing).map_or(rest.len(), |end| opening + end + closing.len()));
    }
    let mut escaped = false;
    for (at, byte) in inside.bytes().enumerate() {
        match byte {
            b'"' if !escaped => return Some(opening + at + 1),
            b'\\' => escaped = !escaped,
            _ => escaped = false,
        }
    }
    Some(rest.len())
}

/// A character literal or a lifetime: `'a'` has its closing quote right after one character or escape.
fn quote(rest: &str) -> (Kind, usize) {
    let mut inside = rest[1..].char_indices();
    match inside.next() {
        Some((_, '\\')) => {
            // Skip the escaped character itself, which may be a quote, then look for the closing one.
            let skipped = 2 + inside.next().map_or(0, |(_, escaped)| escaped.len_utf8());
            (Kind::Literal, rest[skipped..].find('\'').map_or(rest.len(), |end| skipped + end + 1))
        }
        Some((_, character)) if rest[1 + character.len_utf8()..].starts_with('\'') => {
            (Kind::Literal, 2 + character.len_utf8())
        }
        _ => (Kind::Lifetime, 1 + word_length(&rest[1..])),
    }
}

fn number_length(rest: &str) -> usize {
    let whole = word_length(rest);
    match rest[whole..].strip_prefix('.') {
        Some(fraction) if fraction.starts_with(|digit: char| digit.is_ascii_digit()) => {
            whole + 1 + word_length(fraction)
        }
        _ => whole,
    }
}

fn word_length(rest: &str) -> usize {
    rest.find(|character| !is_word(character)).unwrap_or(rest.len())
}

fn is_word(character: char) -> bool {
    character.is_alphanumeric() || character == '_'
}

impl<'t> Scan<'t> {
    /// The index of the token that closes the bracket at `open`, or the number of tokens if none does.
    pub(crate) fn closing(&self, open: usize) -> usize {
        let mut depth = 0;
        for (index, token) in self.tokens.iter().enumerate().skip(open) {
            match token.text {
                "(" | "[" | "{" => depth += 1,
                ")" | "]" | "}" => {
                    depth -= 1;
                    if depth == 0 {
                        return index;
                    }
                }
                _ => {}
            }
        }
        self.tokens.len()
    }

    /// The text of the token at `index`; empty past the end.
    pub(crate) fn text(&self, index: usize) -> &'t str {
        self.tokens.get(index).map_or("", |token| token.text)
    }

    /// Whether the tokens from `index` on are `texts`.
    pub(crate) fn is_at(&self, index: usize, texts: &[&str]) -> bool {
        texts.iter().enumerate().all(|(offset, text)| self.text(index + offset) == *text)
    }

    /// The index ranges of the bodies of `#[cfg(test)] mod .. { }`.
    pub(crate) fn test_modules(&self) -> Vec<std::ops::Range<usize>> {
        let mut bodies = Vec::new();
        for start in 0..self.tokens.len() {
            if self.is_at(start, &["#", "[", "cfg", "(", "test", ")", "]"]) {
                let mut item = start + 7;
                while self.is_at(item, &["#", "["]) {
                    item = self.closing(item + 1) + 1;
                }
                if self.text(item) == "mod" && self.text(item + 2) == "{" {
                    bodies.push(item..self.closing(item + 2));
                }
            }
        }
        bodies
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(source: &str) -> Vec<&str> {
        scan(source).tokens.iter().map(|token| token.text).collect()
    }

    #[test]
    fn strings_and_comments_are_not_code() {
        let source = "a /* x /* y */ z */ b // c\n\"d \\\" e\" r#\"f \" g\"# b'h' '\\'' 'i: 'j'";
        assert_eq!(texts(source), ["a", "b", "\"d \\\" e\"", "r#\"f \" g\"#", "b", "'h'", "'\\''", "'i", ":", "'j'"]);
        assert_eq!(scan(source).comments.len(), 2);
    }

    #[test]
    fn lines_count_through_multi_line_tokens() {
        let source = "a\n\"x\ny\"\n/* p\nq */ b";
        let lines: Vec<usize> = scan(source).tokens.iter().map(|token| token.line).collect();
        assert_eq!(lines, [1, 2, 5]);
    }

    #[test]
    fn numbers_and_ranges_are_told_apart() {
        assert_eq!(texts("1.5f32 1..2 x.0 0xff_u8"), ["1.5f32", "1", "..", "2", "x", ".", "0", "0xff_u8"]);
    }

    #[test]
    fn test_modules_are_found_behind_attributes() {
        let found = scan("fn a() {} #[cfg(test)] #[expect(x)] mod tests { fn b() {} }");
        let [body] = &found.test_modules()[..] else { panic!("one test module expected") };
        assert_eq!(found.text(body.start), "mod");
        assert_eq!(body.end, found.tokens.len() - 1);
    }

    #[test]
    fn any_text_is_scanned_without_losing_a_byte_of_code() {
        // Unfinished strings, quotes and comments must end at the end of the text, not panic.
        for source in ["\"", "r#\"", "'", "'\\", "/*", "b", "r#", "1.", "\u{e9}'\u{e9}'"] {
            let _ = scan(source);
        }
    }
}
