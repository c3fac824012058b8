//! Textures of a scene, made when a frame first needs them and kept for the next.
//!
//! In: the textures that materials use. Out: uploaded textures by (texture, usage), and warnings for those that cannot
//! be decoded. Pictures are decoded in parallel; the result does not depend on it.

use super::texture_upload::{Opacity, Uploaded, Usage, upload};
use crate::load::{Location, Place, Warning, WarningKind, parallel_map};
use crate::scene::{Scene, TextureId};
use std::collections::HashMap;
use std::sync::Arc;
use trigon::shade::texture::Texture;
use trigon_image::Limits;

/// Uploaded textures.
#[derive(Default)]
pub(super) struct TextureCache {
    entries: HashMap<(TextureId, Usage), Entry>,
}

struct Entry {
    /// The bytes it was made from: another scene may hold another picture under the same number.
    source: Arc<[u8]>,
    uploaded: Option<Uploaded>,
}

impl TextureCache {
    /// Makes every texture of `wanted` that is not there yet; returns what was wrong with them.
    pub(super) fn ensure(&mut self, scene: &Scene, wanted: &[(TextureId, Usage)], threads: usize) -> Vec<Warning> {
        let mut missing: Vec<(TextureId, Vec<Usage>)> = Vec::new();
        for &(id, usage) in wanted {
            let Some(texture) = scene.texture(id) else { continue };
            let known = self.entries.get(&(id, usage));
            if known.is_some_and(|entry| Arc::ptr_eq(&entry.source, &texture.encoded)) {
                continue;
            }
            match missing.iter_mut().find(|(other, _)| *other == id) {
                Some((_, usages)) if usages.contains(&usage) => {}
                Some((_, usages)) => usages.push(usage),
                None => missing.push((id, vec![usage])),
            }
        }
        let made = parallel_map(threads, missing, |_, (id, usages)| (id, make(scene, id, &usages)));
        let mut warnings = Vec::new();
        for (id, (uploads, problem)) in made {
            let Some(texture) = scene.texture(id) else { continue };
            for (usage, uploaded) in uploads {
                self.entries.insert((id, usage), Entry { source: texture.encoded.clone(), uploaded });
            }
            warnings.extend(problem.map(|problem| warning(&texture.name, &problem)));
        }
        warnings
    }

    /// The texture, if it is there and could be made.
    pub(super) fn get(&self, id: TextureId, usage: Usage) -> Option<&Texture> {
        Some(&self.uploaded(id, usage)?.texture)
    }

    /// Whether it was asked for as heights and turned out to hold normals.
    pub(super) fn holds_normals(&self, id: TextureId, usage: Usage) -> bool {
        self.uploaded(id, usage).is_some_and(|uploaded| uploaded.holds_normals)
    }

    /// Which opacities the texture holds.
    pub(super) fn opacity(&self, id: TextureId, usage: Usage) -> Opacity {
        self.uploaded(id, usage).map_or(Opacity::Opaque, |uploaded| uploaded.opacity)
    }

    fn uploaded(&self, id: TextureId, usage: Usage) -> Option<&Uploaded> {
        self.entries.get(&(id, usage))?.uploaded.as_ref()
    }
}

type Uploads = Vec<(Usage, Option<Uploaded>)>;

/// Decodes a texture once, and makes what each use of it needs.
fn make(scene: &Scene, id: TextureId, usages: &[Usage]) -> (Uploads, Option<String>) {
    let mut problem = None;
    let image = scene
        .texture(id)
        .and_then(|texture| texture.decode(&Limits::default()).map_err(|error| problem = Some(error.to_string())).ok());
    let mut uploads = Vec::with_capacity(usages.len());
    for &usage in usages {
        let uploaded = image
            .as_ref()
            .and_then(|image| upload(image, usage).map_err(|error| problem = Some(error.to_string())).ok());
        uploads.push((usage, uploaded));
    }
    (uploads, problem)
}

fn warning(name: &str, problem: &str) -> Warning {
    Warning {
        location: Location { file: name.to_owned(), place: Place::File },
        kind: WarningKind::MissingFile,
        message: format!("texture cannot be used: {problem}; drawn without it"),
    }
}
