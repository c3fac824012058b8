//! Drawing scenes: a [`Scene`](crate::scene::Scene) and a camera in, a picture out.
//!
//! [`SceneRenderer`] keeps what is made from a scene once (textures with their mip chains, edges for wireframes);
//! each frame then only prepares lights, materials and draws. Meshes are drawn from where they are, without a copy.

pub mod course;
mod draws;
mod edges;
mod effects;
mod error;
mod frame;
mod lights;
mod material;
mod occlusion;
mod outline;
mod overdraw;
mod scene_renderer;
mod settings;
mod shader_kind;
mod shaders;
mod shadow_map;
mod shapes;
mod sorting;
mod story;
mod texture_cache;
mod texture_upload;
mod working_space;

pub use effects::{AmbientOcclusion, Outline, Shadows};
pub use error::RenderError;
pub use scene_renderer::SceneRenderer;
pub use settings::{AlphaMode, RenderSettings, TextureSampling, Wireframe};
pub use shader_kind::{ShaderKind, UnknownShader};
pub use story::{DrawLabel, SceneStory};
