//! The scenes by name: what to build in, geometry, textures and camera path out.

use super::grid::Mesh;
use super::layers::LayerOrder;
use super::orbit::Orbit;
use super::{bumpy_sphere, hall, height_field, layers, model, pattern};
use core::fmt;
use core::ops::Range;
use core::str::FromStr;
use std::path::PathBuf;
use trigon::shade::texture::{Texture, TextureError};
use trigon_image::DecodeError;
use trigon_scene::load::LoadError;

/// A scene's name.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SceneKind {
    /// A loaded model, textured and lit.
    Model,
    /// The same without texture.
    ModelFlat,
    /// A million triangles.
    Big,
    /// Triangles of two square pixels, all over the picture.
    Small,
    /// Sixteen layers, front to back.
    FillFrontToBack,
    /// Sixteen layers, back to front.
    FillBackToFront,
    /// An interior.
    Hall,
}

impl SceneKind {
    /// Every scene.
    pub const ALL: [Self; 7] = [
        Self::Model,
        Self::ModelFlat,
        Self::Big,
        Self::Small,
        Self::FillFrontToBack,
        Self::FillBackToFront,
        Self::Hall,
    ];

    /// The name that [`FromStr`] reads.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Model => "model",
            Self::ModelFlat => "model_flat",
            Self::Big => "big",
            Self::Small => "small",
            Self::FillFrontToBack => "fill_ftb",
            Self::FillBackToFront => "fill_btf",
            Self::Hall => "hall",
        }
    }

    /// True if the scene is drawn from [`ModelFiles`].
    #[must_use]
    pub fn needs_model(self) -> bool {
        matches!(self, Self::Model | Self::ModelFlat)
    }

    /// Builds the scene for pictures of `size` pixels: some scenes are made to fill the view.
    ///
    /// # Errors
    /// A model file is missing or broken.
    pub fn build(self, size: [u32; 2], files: &ModelFiles) -> Result<BenchScene, SceneError> {
        let one = |mesh, surface, orbit, textures| BenchScene::single(self, mesh, surface, orbit, textures);
        Ok(match self {
            Self::Model => {
                let texture = match model::texture(files)? {
                    Some(texture) => texture,
                    None => pattern::texture(1024, 1)?,
                };
                one(model::mesh(files)?, Surface::TexturedLit, Orbit::Around, vec![texture])
            }
            Self::ModelFlat => one(model::mesh(files)?, Surface::Lit, Orbit::Around, Vec::new()),
            Self::Big => one(bumpy_sphere::build(), Surface::Lit, Orbit::Around, Vec::new()),
            Self::Small => {
                let textures = vec![pattern::texture(1024, 1)?];
                one(height_field::build(size), Surface::TexturedLit, Orbit::Sway, textures)
            }
            Self::FillFrontToBack | Self::FillBackToFront => {
                let is_front_first = self == Self::FillFrontToBack;
                let order = if is_front_first { LayerOrder::FrontToBack } else { LayerOrder::BackToFront };
                let textures = vec![pattern::texture(1024, 1)?];
                one(layers::build(size, order), Surface::Textured, Orbit::Fixed, textures)
            }
            Self::Hall => BenchScene::hall()?,
        })
    }
}

impl FromStr for SceneKind {
    type Err = String;

    fn from_str(name: &str) -> Result<Self, String> {
        Self::ALL.into_iter().find(|kind| kind.name() == name).ok_or_else(|| {
            let names = Self::ALL.map(Self::name).join(", ");
            format!("unknown scene '{name}'; the scenes are {names}")
        })
    }
}

/// Where the model comes from.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct ModelFiles {
    /// The model.
    pub obj: Option<PathBuf>,
    /// Its texture; without, a pattern.
    pub texture: Option<PathBuf>,
}

/// What a scene's surfaces look like.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Surface {
    /// Texture and lights.
    TexturedLit,
    /// Lights on grey.
    Lit,
    /// Texture alone.
    Textured,
}

/// Triangles with one texture, drawn at once.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct MaterialRun {
    /// Into the mesh's triangles.
    pub triangles: Range<usize>,
    /// Into the scene's textures; ignored where surfaces have none.
    pub texture: usize,
}

/// A scene, ready to be drawn.
#[derive(Debug)]
pub struct BenchScene {
    /// Its name.
    pub kind: SceneKind,
    /// All triangles, in world space.
    pub mesh: Mesh,
    /// In the order in which they are drawn.
    pub runs: Vec<MaterialRun>,
    /// One per material; none where surfaces have no texture.
    pub textures: Vec<Texture>,
    /// The same for the whole scene.
    pub surface: Surface,
    /// The camera's path.
    pub orbit: Orbit,
}

impl BenchScene {
    fn single(kind: SceneKind, mesh: Mesh, surface: Surface, orbit: Orbit, textures: Vec<Texture>) -> Self {
        let runs = vec![MaterialRun { triangles: 0..mesh.triangles.len(), texture: 0 }];
        Self { kind, mesh, runs, textures, surface, orbit }
    }

    fn hall() -> Result<Self, SceneError> {
        let (mut mesh, mut runs, mut textures) = (Mesh::default(), Vec::new(), Vec::new());
        for (texture, (material, seed)) in hall::build().iter().zip(1..).enumerate() {
            let first = mesh.triangles.len();
            mesh.append(material);
            runs.push(MaterialRun { triangles: first..mesh.triangles.len(), texture });
            textures.push(pattern::texture(512, seed)?);
        }
        Ok(Self { kind: SceneKind::Hall, mesh, runs, textures, surface: Surface::TexturedLit, orbit: Orbit::Walk })
    }
}

/// Why a scene cannot be built.
#[derive(Debug)]
#[non_exhaustive]
pub enum SceneError {
    /// The scene needs a model, and none is named.
    NoModel,
    /// The model cannot be loaded.
    Load(LoadError),
    /// The texture file cannot be read.
    ReadTexture(PathBuf, std::io::Error),
    /// The texture file is no picture.
    DecodeTexture(PathBuf, DecodeError),
    /// The texture is too large.
    Texture(TextureError),
}

impl From<LoadError> for SceneError {
    fn from(error: LoadError) -> Self {
        Self::Load(error)
    }
}

impl From<TextureError> for SceneError {
    fn from(error: TextureError) -> Self {
        Self::Texture(error)
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoModel => f.write_str("this scene draws a model: name it with --obj"),
            Self::Load(error) => error.fmt(f),
            Self::ReadTexture(path, error) => write!(f, "{}: {error}", path.display()),
            Self::DecodeTexture(path, error) => write!(f, "{}: {error}", path.display()),
            Self::Texture(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for SceneError {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn generated_scenes_are_consistent() {
        for kind in SceneKind::ALL.into_iter().filter(|kind| !kind.needs_model()) {
            let scene = kind.build([320, 200], &ModelFiles::default()).unwrap();
            let mesh = &scene.mesh;
            assert_eq!([mesh.normals.len(), mesh.uvs.len()], [mesh.positions.len(); 2], "{kind:?}");
            assert!(mesh.triangles.as_flattened().iter().all(|v| (*v as usize) < mesh.positions.len()), "{kind:?}");
            assert_eq!(scene.runs.iter().map(|run| run.triangles.len()).sum::<usize>(), mesh.triangles.len());
            assert!(scene.surface == Surface::Lit || scene.runs.iter().all(|run| run.texture < scene.textures.len()));
            assert_eq!(kind.name().parse(), Ok(kind));
        }
    }

    #[test]
    fn a_model_scene_without_model_says_what_to_do() {
        let error = SceneKind::Model.build([8, 8], &ModelFiles::default()).unwrap_err().to_string();
        assert!(error.contains("--obj"), "{error}");
    }
}
