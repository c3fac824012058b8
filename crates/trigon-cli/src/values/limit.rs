//! Bounds on what is read, for files of strangers: `triangles=10M`.

use super::{Count, closest};
use std::str::FromStr;

/// One bound: which, and how much.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Limit {
    pub(crate) name: LimitName,
    pub(crate) value: u64,
}

/// What is bounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum LimitName {
    /// Bytes of a model or material file, uncompressed.
    FileSize,
    /// Vertices of a model.
    Vertices,
    /// Triangles of a model.
    Triangles,
    /// Materials of a model.
    Materials,
    /// Textures of a model.
    Textures,
    /// Bytes of a texture file.
    TextureSize,
    /// Width times height of a texture.
    TexturePixels,
}

const NAMES: [(&str, LimitName); 7] = [
    ("file-size", LimitName::FileSize),
    ("vertices", LimitName::Vertices),
    ("triangles", LimitName::Triangles),
    ("materials", LimitName::Materials),
    ("textures", LimitName::Textures),
    ("texture-size", LimitName::TextureSize),
    ("texture-pixels", LimitName::TexturePixels),
];

impl FromStr for Limit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (word, value) = text.split_once('=').ok_or("write NAME=COUNT, such as triangles=10M")?;
        let Some(&(_, name)) = NAMES.iter().find(|entry| entry.0 == word.trim()) else {
            let names = NAMES.map(|entry| entry.0);
            return Err(match closest(word, names) {
                Some(name) => format!("there is no limit \"{word}\"; did you mean {name}?"),
                None => format!("there is no limit \"{word}\"; the limits are {}", names.join(", ")),
            });
        };
        Ok(Self { name, value: value.parse::<Count>()?.0 })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_counts() {
        assert_eq!("triangles=10k".parse(), Ok(Limit { name: LimitName::Triangles, value: 10_240 }));
        let message = |text: &str| text.parse::<Limit>().unwrap_err();
        assert!(message("triangels=1").contains("did you mean triangles?"));
        assert!(message("pixels=1").contains("the limits are"));
        assert!(message("triangles").contains("NAME=COUNT"));
        assert!(message("triangles=lots").contains("no count"));
    }
}
