//! Pictures that the programs of courses find by their names, beside the model.
//!
//! In: a name. Out: a texture of the scene, or a warning that says why there is none.

use crate::load::{Location, Place, Resolver, Warning, WarningKind};
use crate::scene::{Scene, Texture, TextureId, TextureRef};

/// Looks for pictures, and collects what it did not find.
pub(super) struct Finder<'a> {
    resolver: &'a dyn Resolver,
    max_bytes: u64,
    warnings: Vec<Warning>,
}

impl<'a> Finder<'a> {
    /// `max_bytes` is the limit for the file of a picture.
    pub(super) fn new(resolver: &'a dyn Resolver, max_bytes: u64) -> Self {
        Self { resolver, max_bytes, warnings: Vec::new() }
    }

    /// Adds the picture `name` to the textures of `scene`, if it is there.
    pub(super) fn find(&mut self, scene: &mut Scene, name: &str) -> Option<TextureRef> {
        match self.add(scene, name) {
            Ok(texture) => Some(texture),
            Err(problem) => {
                let location = Location { file: name.to_owned(), place: Place::File };
                let message = format!("{problem}; drawn without it");
                self.warnings.push(Warning { location, kind: WarningKind::MissingFile, message });
                None
            }
        }
    }

    /// What was not found.
    pub(super) fn into_warnings(self) -> Vec<Warning> {
        self.warnings
    }

    fn add(&self, scene: &mut Scene, name: &str) -> Result<TextureRef, String> {
        let path = self.resolver.find(name).ok_or("picture not found")?;
        let bytes = self.resolver.read(&path, self.max_bytes).map_err(|error| error.to_string())?;
        if u64::try_from(bytes.len()).unwrap_or(u64::MAX) > self.max_bytes {
            return Err(format!("picture is larger than the limit of {} bytes", self.max_bytes));
        }
        let id = u32::try_from(scene.textures.len()).map_err(|error| error.to_string())?;
        scene.textures.push(Texture::new(path, bytes));
        Ok(TextureRef::new(TextureId(id)))
    }
}
