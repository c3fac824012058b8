//! What is drawn: meshes placed in the world, their materials and textures, lights and a camera.
//!
//! Conventions: right-handed world, y up; a camera looks down -z in view space; clip space as WebGPU with reversed
//! depth (near 1, far 0); texture coordinates have u to the right and v **down** from the top row of the picture, as
//! its rows are stored (loaders convert); vertex colours are linear; angles are radians.

mod camera;
mod displacement;
mod framing;
mod light;
mod material;
mod mesh;
mod scalar_source;
#[expect(clippy::module_inception, reason = "the central type of the folder")]
mod scene;
mod texture;

pub use camera::{Camera, Projection};
pub use displacement::{Displaced, Displacement};
pub use framing::Framing;
pub use light::{Light, LightKind};
pub use material::{Illumination, Maps, Material};
pub use mesh::{Mesh, MeshError, Part, Submesh};
pub(crate) use scalar_source::ScalarSource;
pub use scene::{Instance, MaterialId, MeshId, Scene, TextureId};
pub use texture::{Channel, MapProjection, Texture, TextureOptions, TextureRef};
