//! Names of numbered files: `frame-{frame:3}.png` and a number in, `frame-007.png` out.

use crate::failure::Failure;
use std::path::{Path, PathBuf};

/// A file name with a place for the frame's number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct FrameTemplate {
    pieces: Vec<Piece>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Piece {
    Text(String),
    /// The frame's number, with zeros in front up to this many digits.
    Frame {
        digits: usize,
    },
}

/// More digits than any number of frames has.
const MAX_DIGITS: usize = 20;

impl FrameTemplate {
    /// Reads a name; `None` if it has no `{frame}`.
    pub(crate) fn parse(path: &Path) -> Result<Option<Self>, Failure> {
        // A name that is no text has no places either.
        let Some(text) = path.to_str() else { return Ok(None) };
        let pieces = parse_pieces(text).map_err(|problem| {
            Failure::usage(format!("the output \"{text}\" {problem}; write such as frame-{{frame:3}}.png"))
        })?;
        let has_place = pieces.iter().any(|piece| matches!(piece, Piece::Frame { .. }));
        Ok(has_place.then_some(Self { pieces }))
    }

    /// The name of a frame.
    pub(crate) fn path(&self, frame: u32) -> PathBuf {
        let texts = self.pieces.iter().map(|piece| match piece {
            Piece::Text(text) => text.clone(),
            Piece::Frame { digits } => format!("{frame:0digits$}"),
        });
        PathBuf::from(texts.collect::<String>())
    }
}

fn parse_pieces(text: &str) -> Result<Vec<Piece>, String> {
    let (mut pieces, mut literal) = (Vec::new(), String::new());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        rest = &rest[c.len_utf8()..];
        let is_doubled = matches!(c, '{' | '}') && rest.starts_with(c);
        match c {
            '{' | '}' if is_doubled => {
                literal.push(c);
                rest = &rest[1..];
            }
            '{' => {
                let (place, after) = rest.split_once('}').ok_or("has a { without its }")?;
                pieces.push(Piece::Text(std::mem::take(&mut literal)));
                pieces.push(Piece::Frame { digits: parse_place(place)? });
                rest = after;
            }
            '}' => return Err("has a } without its {".to_owned()),
            _ => literal.push(c),
        }
    }
    pieces.push(Piece::Text(literal));
    Ok(pieces)
}

/// What stands between the braces: `frame` or `frame:DIGITS`.
fn parse_place(place: &str) -> Result<usize, String> {
    let (name, digits) = place.split_once(':').unwrap_or((place, "1"));
    match digits.parse() {
        Ok(digits) if name == "frame" && digits <= MAX_DIGITS => Ok(digits),
        _ => Err(format!("has the unknown place {{{place}}}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn path(template: &str, frame: u32) -> String {
        let template = FrameTemplate::parse(Path::new(template)).unwrap().unwrap();
        template.path(frame).to_str().unwrap().to_owned()
    }

    #[test]
    fn numbers_are_padded_and_braces_doubled() {
        assert_eq!(path("frame-{frame:3}.png", 7), "frame-007.png");
        assert_eq!(path("{frame}.png", 12), "12.png");
        assert_eq!(path("{frame:2}.png", 1234), "1234.png");
        assert_eq!(path("{{é}}/{frame:2}-{frame}.png", 5), "{é}/05-5.png");
        assert_eq!(FrameTemplate::parse(Path::new("a{{b}}.gif")), Ok(None));
    }

    #[test]
    fn broken_templates_are_usage_errors() {
        for (template, part) in
            [("{fram:3}.png", "{fram:3}"), ("a{frame", "without its }"), ("a}b", "without its {"), ("{frame:x}", ":x")]
        {
            let Err(Failure::Usage(message)) = FrameTemplate::parse(Path::new(template)) else {
                panic!("{template} is broken")
            };
            assert!(message.contains(part) && message.contains("frame-{frame:3}.png"), "{message}");
        }
    }
}
