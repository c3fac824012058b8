//! Finding the files a model names: what is written in the file in, bytes out, each file read once.
//!
//! Names come from other machines: backslashes, drive letters, blanks, wrong letter case. In order are tried: the path
//! as written, relative to the file that names it; the same with `/` for `\`; its last component alone, beside
//! the file that names it; the last component beside the model.

use super::{Resolver, WarningKind};
use crate::scene::{Texture, TextureId};
use crate::text::decode_name;
use std::collections::HashMap;

/// The side files of one model.
pub(crate) struct SideFiles<'a> {
    resolver: &'a dyn Resolver,
    textures: Vec<Texture>,
    /// Outcome per path found.
    texture_ids: HashMap<String, Result<TextureId, Problem>>,
    max_textures: u64,
    max_texture_bytes: u64,
    max_texture_pixels: u64,
}

/// Why a side file cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Problem {
    pub(crate) kind: WarningKind,
    pub(crate) message: String,
}

impl Problem {
    fn new(message: String) -> Self {
        Self { kind: WarningKind::MissingFile, message }
    }
}

impl<'a> SideFiles<'a> {
    pub(crate) fn new(resolver: &'a dyn Resolver, limits: &super::Limits) -> Self {
        Self {
            resolver,
            textures: Vec::new(),
            texture_ids: HashMap::new(),
            max_textures: limits.textures,
            max_texture_bytes: limits.texture_bytes,
            max_texture_pixels: limits.texture_pixels,
        }
    }

    /// The textures read so far.
    pub(crate) fn into_textures(self) -> Vec<Texture> {
        self.textures
    }

    /// The path of the file that `written` means in the file `from` (a path itself, empty for the model).
    pub(crate) fn find(&self, written: &[u8], from: &str) -> Option<String> {
        let written = decode_name(written);
        candidates(unquoted(&written), from).iter().find_map(|path| self.resolver.find(path))
    }

    /// Whether `written`, all of it and not its last component alone, is a path from the model's folder.
    pub(crate) fn has_beside_model(&self, written: &[u8]) -> bool {
        let written = decode_name(written);
        relative_paths(unquoted(&written), "").iter().any(|path| self.resolver.find(path).is_some())
    }

    /// Reads a file that [`SideFiles::find`] found.
    pub(crate) fn read(&self, found: &str, max_bytes: u64) -> Result<Vec<u8>, Problem> {
        match self.resolver.read(found, max_bytes) {
            Ok(bytes) if u64::try_from(bytes.len()).unwrap_or(u64::MAX) > max_bytes => {
                Err(Problem::new(format!("{found} is larger than the limit of {max_bytes} bytes")))
            }
            Ok(bytes) => Ok(bytes),
            Err(error) => Err(Problem::new(format!("cannot read {found}: {error}"))),
        }
    }

    /// The texture that `written` means in the file `from`, read now if it is new.
    pub(crate) fn texture(&mut self, written: &[u8], from: &str) -> Result<TextureId, Problem> {
        let Some(found) = self.find(written, from) else {
            return Err(Problem::new(format!("texture {} not found; drawn without it", decode_name(written))));
        };
        if let Some(known) = self.texture_ids.get(&found) {
            return known.clone();
        }
        let outcome = self.read_texture(&found);
        self.texture_ids.insert(found, outcome.clone());
        outcome
    }

    fn read_texture(&mut self, found: &str) -> Result<TextureId, Problem> {
        let id = u32::try_from(self.textures.len()).unwrap_or(u32::MAX);
        if u64::from(id) >= self.max_textures {
            return Err(Problem::new(format!("texture {found} left out: more than {} textures", self.max_textures)));
        }
        let bytes = self.read(found, self.max_texture_bytes)?;
        self.textures.push(Texture { max_pixels: self.max_texture_pixels, ..Texture::new(found, bytes) });
        Ok(TextureId(id))
    }
}

/// The paths to try, best first, without repetition.
fn candidates(written: &str, from: &str) -> Vec<String> {
    let slashed = slashed(written);
    let last = slashed.rsplit('/').next().unwrap_or_default();
    let mut paths = Vec::new();
    for path in relative_paths(written, from).into_iter().chain([format!("{}{last}", folder(from)), last.to_owned()]) {
        if !last.is_empty() && !paths.contains(&path) {
            paths.push(path);
        }
    }
    paths
}

/// The path as written and with `/` for `\`, relative to the file that names it.
fn relative_paths(written: &str, from: &str) -> [String; 2] {
    [written, &slashed(written)].map(|path| {
        let path = path.trim_start_matches("./");
        if path.starts_with('/') { path.to_owned() } else { format!("{}{path}", folder(from)) }
    })
}

/// With `/` for `\`; a blank may be escaped as on a command line.
fn slashed(written: &str) -> String {
    written.replace("\\ ", " ").replace('\\', "/")
}

/// The folder of a path, with the slash at its end.
fn folder(path: &str) -> &str {
    path.rfind('/').map_or("", |end| &path[..=end])
}

fn unquoted(written: &str) -> &str {
    written.trim().trim_matches('"')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::{Limits, MemoryResolver};

    #[test]
    fn awkward_paths_are_found() {
        let resolver = MemoryResolver::new().with("mtl/tex/Wood 1.png", "w").with("crate_1.jpg", "c");
        let files = SideFiles::new(&resolver, &Limits::default());
        for written in [
            "tex/Wood 1.png",
            ".\\tex\\Wood 1.png",
            "TEX\\wood 1.PNG",
            "\"tex/Wood 1.png\"",
            "./tex/Wood 1.png",
            "tex\\Wood\\ 1.png",
        ] {
            let found = files.find(written.as_bytes(), "mtl/a.mtl");
            assert_eq!(found.as_deref(), Some("mtl/tex/Wood 1.png"), "{written}");
        }
        let found = files.find(b"C:\\Users\\me\\crate_1.jpg", "mtl/a.mtl");
        assert_eq!(found.as_deref(), Some("crate_1.jpg"));
        assert_eq!(files.find(b"", "a.mtl"), None);
        assert_eq!(files.find(b"..", "a.mtl"), None);
    }

    #[test]
    fn one_file_is_one_texture() {
        let resolver = MemoryResolver::new().with("a.png", "12345").with("b.png", "6");
        let limits = Limits { texture_bytes: 4, ..Limits::default() };
        let mut files = SideFiles::new(&resolver, &limits);
        assert_eq!(files.texture(b"b.png", ""), Ok(TextureId(0)));
        assert_eq!(files.texture(b"./B.png", "x.mtl"), Ok(TextureId(0)));
        assert!(files.texture(b"a.png", "").unwrap_err().message.contains("larger than the limit"));
        assert!(files.texture(b"c.png", "").unwrap_err().message.contains("not found"));
        assert_eq!(files.into_textures().len(), 1);
    }
}
