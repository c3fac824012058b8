//! `model` and `model_flat`: a model from files, moved to the origin and scaled to a bounding box diagonal of 2.

use super::grid::Mesh;
use super::kind::{ModelFiles, SceneError};
use trigon::shade::texture::{TexelFormat, Texture, TextureDesc};
use trigon_image::Limits;
use trigon_scene::load::{LoadOptions, load_path};
use trigon_scene::math::vec3;

/// The model's triangles.
pub(super) fn mesh(files: &ModelFiles) -> Result<Mesh, SceneError> {
    let path = files.obj.as_ref().ok_or(SceneError::NoModel)?;
    let mut options = LoadOptions::default();
    options.skip_textures = true;
    // Where the file has no normals they are smooth everywhere.
    options.crease_angle = Some(std::f64::consts::PI);
    let loaded = load_path(path, &options)?;
    let mut mesh = Mesh::default();
    for part in loaded.scene.meshes {
        let zero_uvs = vec![[0.0; 2]; if part.uvs.is_empty() { part.positions.len() } else { 0 }];
        mesh.append(&Mesh {
            normals: part.normals,
            uvs: if part.uvs.is_empty() { zero_uvs } else { part.uvs },
            triangles: part.triangles,
            positions: part.positions,
        });
    }
    normalize(&mut mesh);
    Ok(mesh)
}

/// Centre at the origin, bounding box diagonal 2.
#[expect(clippy::cast_possible_truncation, reason = "the model's size is rounded once")]
fn normalize(mesh: &mut Mesh) {
    let bounds = trigon_scene::math::Aabb::from_points(&mesh.positions);
    let center = vec3::narrow(bounds.center());
    let scale = (2.0 / vec3::length(bounds.size())) as f32;
    for position in &mut mesh.positions {
        *position = core::array::from_fn(|k| (position[k] - center[k]) * scale);
    }
}

/// The texture file, or `None` if there is none.
pub(super) fn texture(files: &ModelFiles) -> Result<Option<Texture>, SceneError> {
    let Some(path) = &files.texture else { return Ok(None) };
    let bytes = std::fs::read(path).map_err(|error| SceneError::ReadTexture(path.clone(), error))?;
    let image = trigon_image::decode(&bytes, None, &Limits::default())
        .map_err(|error| SceneError::DecodeTexture(path.clone(), error))?
        .into_rgba8();
    let desc = TextureDesc::new([image.width(), image.height()], TexelFormat::Rgba8Srgb);
    Ok(Some(Texture::from_bytes(&desc, image.as_bytes())?))
}
