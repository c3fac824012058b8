//! A frame with a name, and the list of them.

use super::{clip_space, files, mathematics, scenes, textured};
use crate::frames::hash;
use trigon::pipeline::{Picture, RendererOptions};

/// Something to draw whose picture depends on nothing but the code.
pub struct NamedFrame {
    /// Topic and case, without blanks: `texture/trilinear`.
    pub name: String,
    /// Large enough that a renderer uses all of its threads.
    pub is_large: bool,
    draw: Box<dyn Fn(RendererOptions) -> Picture>,
}

impl NamedFrame {
    pub(super) fn new(name: impl Into<String>, draw: impl Fn(RendererOptions) -> Picture + 'static) -> Self {
        Self { name: name.into(), is_large: false, draw: Box::new(draw) }
    }

    pub(super) fn large(self) -> Self {
        Self { is_large: true, ..self }
    }

    /// Draws the frame in a fresh renderer and hashes every value of every image.
    #[must_use]
    pub fn hash(&self, options: RendererOptions) -> u64 {
        hash(&(self.draw)(options))
    }
}

/// Every frame of the corpus; names are unique.
#[must_use]
pub fn all() -> Vec<NamedFrame> {
    let mut frames = clip_space::frames();
    frames.extend(textured::frames());
    frames.extend(mathematics::frames());
    frames.extend(scenes::frames());
    frames
}

/// One line `name hash` for each frame, and for each file that the `files` module makes.
#[must_use]
pub fn report(options: RendererOptions) -> String {
    let frames = all().into_iter().map(|frame| (frame.hash(options), frame.name));
    let files = files::hashes().into_iter().map(|(name, hash)| (hash, name));
    frames.chain(files).map(|(hash, name)| format!("{name} {hash:016x}\n")).collect()
}
