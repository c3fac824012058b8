//! The story of one pixel of a scene: that of the rasterizer, and what its draws are called in the scene.

use super::draws::{Item, Piece};
use crate::scene::Scene;
use trigon::pipeline::PixelStory;

/// How one pixel of a scene's picture came about.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneStory {
    /// From triangles to bytes.
    pub pixel: PixelStory,
    /// What the picture holds: 8-bit sRGB, straight alpha. The bytes of the story, but for last steps that look at the whole
    /// picture: outlines, and counts of overdraw that become colours.
    pub color: [u8; 4],
    /// What is drawn, by number of the draw.
    pub draws: Vec<DrawLabel>,
}

/// What a draw shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DrawLabel {
    /// Name of the object in the file; may be empty.
    pub object: String,
    /// Name of the group in the file; may be empty.
    pub group: String,
    /// Name of the material, if it is known which one of the object's it is.
    pub material: Option<String>,
    /// The draw's primitive 0 has this number in the mesh.
    pub first_primitive: u32,
}

impl SceneStory {
    pub(super) fn new(pixel: PixelStory, scene: &Scene, pieces: &[Piece<'_>], items: &[Item<'_>]) -> Self {
        let draws = items.iter().map(|item| label(scene, pieces, item)).collect();
        Self { color: pixel.resolve.bytes, pixel, draws }
    }
}

fn label(scene: &Scene, pieces: &[Piece<'_>], item: &Item<'_>) -> DrawLabel {
    let of_object: Vec<_> = pieces.iter().filter(|piece| piece.object == item.object).collect();
    let part = of_object.first().and_then(|piece| piece.mesh.parts.get(usize::try_from(piece.submesh.part).ok()?));
    let starts = |piece: &&&Piece<'_>| u32::try_from(piece.submesh.triangles.start) == Ok(item.first_primitive);
    let piece = match of_object.as_slice() {
        [only] => Some(*only),
        several => several.iter().find(starts).copied(),
    };
    DrawLabel {
        object: part.map_or(String::new(), |part| part.object.clone()),
        group: part.map_or(String::new(), |part| part.group.clone()),
        material: piece.and_then(|piece| scene.material(piece.submesh.material)).map(|material| material.name.clone()),
        first_primitive: item.first_primitive,
    }
}
