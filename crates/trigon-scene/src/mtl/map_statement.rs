//! Texture map statements: `map_Kd -s 2 2 -clamp on some name.png` in, options and file name out.
//!
//! Options come before the name, but some exporters write them behind it; names may hold blanks. So: options are read
//! from the front, the name is the rest, less any tail that consists of well-formed options only.

use crate::scene::{Channel, MapProjection, TextureOptions};

/// What a map statement says.
pub(super) struct MapStatement<'a> {
    pub(super) options: TextureOptions,
    /// The file as written; may be empty.
    pub(super) file: &'a [u8],
    /// Options that are not known.
    pub(super) unknown: Vec<&'a [u8]>,
}

impl<'a> MapStatement<'a> {
    /// Reads what follows the keyword.
    pub(super) fn parse(arguments: &'a [u8]) -> Self {
        let mut statement = Self { options: TextureOptions::default(), file: b"", unknown: Vec::new() };
        let mut words = Words::new(arguments);
        let mut file_start = words.clone();
        while let Some(option) = words.option() {
            if !read_option(option, &mut words, &mut statement.options) {
                statement.unknown.push(option);
            }
            file_start = words.clone();
        }
        statement.file = statement.without_trailing_options(file_start.rest());
        statement
    }

    /// Reads options at the end of `text`; what is before them.
    fn without_trailing_options(&mut self, text: &'a [u8]) -> &'a [u8] {
        let mut words = Words::new(text);
        words.word();
        loop {
            let end = words.at;
            let mut options = self.options.clone();
            if words.clone().option().is_some() && read_all(&mut words.clone(), &mut options) {
                self.options = options;
                return text[..end].trim_ascii();
            }
            if words.word().is_none() {
                return text.trim_ascii();
            }
        }
    }
}

/// Reads options up to the end; `false` if anything else comes.
fn read_all(words: &mut Words<'_>, options: &mut TextureOptions) -> bool {
    while let Some(option) = words.option() {
        if !read_option(option, words, options) {
            return false;
        }
    }
    words.rest().is_empty()
}

/// Reads the arguments of one option; `false` if it is not known.
fn read_option(option: &[u8], words: &mut Words<'_>, options: &mut TextureOptions) -> bool {
    match option.to_ascii_lowercase().as_slice() {
        b"-o" => options.offset = words.vector([0.0; 3]),
        b"-s" => options.scale = words.vector([1.0; 3]),
        b"-t" => options.turbulence = words.vector([0.0; 3]),
        b"-mm" => {
            options.base = words.number().unwrap_or(0.0);
            options.gain = words.number().unwrap_or(1.0);
        }
        b"-bm" => options.bump_multiplier = words.number().unwrap_or(1.0),
        b"-boost" => options.boost = words.number().unwrap_or(0.0),
        b"-texres" => options.resolution = words.number(),
        b"-clamp" => options.clamp = words.switch(),
        b"-blendu" => options.blend_u = words.switch(),
        b"-blendv" => options.blend_v = words.switch(),
        b"-cc" => options.color_correction = words.switch(),
        b"-imfchan" => options.channel = words.word().and_then(channel),
        b"-colorspace" => options.is_linear = words.word().map(|name| name.eq_ignore_ascii_case(b"linear")),
        b"-type" => options.projection = words.word().and_then(projection),
        _ => return false,
    }
    true
}

fn channel(name: &[u8]) -> Option<Channel> {
    Some(match name.to_ascii_lowercase().as_slice() {
        b"r" => Channel::Red,
        b"g" => Channel::Green,
        b"b" => Channel::Blue,
        b"m" => Channel::Matte,
        b"l" => Channel::Luminance,
        b"z" => Channel::Depth,
        _ => return None,
    })
}

fn projection(name: &[u8]) -> Option<MapProjection> {
    Some(match name.to_ascii_lowercase().as_slice() {
        b"sphere" => MapProjection::Sphere,
        b"cube_top" => MapProjection::CubeTop,
        b"cube_bottom" => MapProjection::CubeBottom,
        b"cube_front" => MapProjection::CubeFront,
        b"cube_back" => MapProjection::CubeBack,
        b"cube_left" => MapProjection::CubeLeft,
        b"cube_right" => MapProjection::CubeRight,
        _ => return None,
    })
}

/// A walk over blank-separated words.
#[derive(Clone)]
pub(super) struct Words<'a> {
    text: &'a [u8],
    at: usize,
}

impl<'a> Words<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        Self { text, at: 0 }
    }

    /// What is left, without blanks around it.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.text.get(self.at..).unwrap_or_default().trim_ascii()
    }

    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        let rest = self.text.get(self.at..)?;
        let start = self.at + rest.iter().position(|b| !b.is_ascii_whitespace())?;
        let len = self.text[start..].iter().position(u8::is_ascii_whitespace);
        self.at = len.map_or(self.text.len(), |len| start + len);
        Some(&self.text[start..self.at])
    }

    /// The next word, if `accept` takes it; else stays.
    fn word_if<T>(&mut self, accept: impl FnOnce(&'a [u8]) -> Option<T>) -> Option<T> {
        let mut ahead = self.clone();
        let value = accept(ahead.word()?)?;
        *self = ahead;
        Some(value)
    }

    /// The next word if it looks like an option: a minus and a letter.
    fn option(&mut self) -> Option<&'a [u8]> {
        self.word_if(|word| matches!(word, [b'-', second, ..] if second.is_ascii_alphabetic()).then_some(word))
    }

    /// The next word if it is a finite number.
    pub(super) fn number(&mut self) -> Option<f32> {
        let parse = |word: &[u8]| std::str::from_utf8(word).ok()?.parse().ok();
        self.word_if(|word| parse(word).filter(|value: &f32| value.is_finite()))
    }

    /// One to three numbers.
    fn vector(&mut self, default: [f32; 3]) -> [f32; 3] {
        default.map(|component| self.number().unwrap_or(component))
    }

    fn switch(&mut self) -> bool {
        let known = |word: &[u8]| match word.to_ascii_lowercase().as_slice() {
            b"on" | b"1" | b"true" => Some(true),
            b"off" | b"0" | b"false" => Some(false),
            _ => None,
        };
        self.word_if(known).unwrap_or(true)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parse(text: &str) -> (TextureOptions, String) {
        let statement = MapStatement::parse(text.as_bytes());
        assert!(statement.unknown.is_empty(), "{:?}", statement.unknown);
        (statement.options, String::from_utf8_lossy(statement.file).into_owned())
    }

    #[test]
    fn every_option_is_read() {
        let (options, file) = parse(
            "-s 2 3 4 -o 0.1 -t 1 2 -mm 0.25 2 -bm 3 -clamp on -imfchan m -blendu off -blendv off -boost 5 \
             -texres 512 -cc on -type cube_top my texture.png",
        );
        assert_eq!(file, "my texture.png");
        assert_eq!(
            (options.scale, options.offset, options.turbulence),
            ([2.0, 3.0, 4.0], [0.1, 0.0, 0.0], [1.0, 2.0, 0.0])
        );
        assert_eq!((options.base, options.gain, options.bump_multiplier), (0.25, 2.0, 3.0));
        assert_eq!((options.clamp, options.blend_u, options.blend_v), (true, false, false));
        assert_eq!((options.channel, options.boost), (Some(Channel::Matte), 5.0));
        assert_eq!((options.resolution, options.color_correction), (Some(512.0), true));
        assert_eq!(options.projection, Some(MapProjection::CubeTop));
    }

    #[test]
    fn options_may_follow_the_name() {
        let (options, file) = parse("-imfchan r bump map2.jpg -bm 1.5 -clamp on");
        assert_eq!((file.as_str(), options.bump_multiplier, options.clamp), ("bump map2.jpg", 1.5, true));
        assert_eq!(options.channel, Some(Channel::Red));
        assert_eq!(parse("wood -b side.png").1, "wood -b side.png");
        assert_eq!(parse("a -s.png").1, "a -s.png");
        assert_eq!(parse("").1, "");
    }

    #[test]
    fn names_that_begin_with_numbers_are_not_arguments() {
        let (options, file) = parse("-o 1 2 3.png");
        assert_eq!((options.offset, file.as_str()), ([1.0, 2.0, 0.0], "3.png"));
        let statement = MapStatement::parse(b"-what 7.png");
        assert_eq!((statement.unknown, statement.file), (vec![&b"-what"[..]], &b"7.png"[..]));
    }
}
