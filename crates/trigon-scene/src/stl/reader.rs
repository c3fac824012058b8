//! Text or binary: which one a file is, and the steps common to both.

use super::{binary, text};
use crate::geometry::{Extra, Facets, Welder};
use crate::load::{Findings, LoadError, LoadOptions, has_binary_stl_length};
use crate::math::Mat4;
use crate::scene::{Instance, Material, MaterialId, MeshId, Scene};
use std::collections::HashMap;

/// Reads an STL file: one mesh, one instance, a neutral material.
pub(crate) fn read(
    bytes: &[u8],
    file: &str,
    options: &LoadOptions,
    findings: &mut Findings,
) -> Result<Scene, LoadError> {
    let is_text = !has_binary_stl_length(bytes) && text::begins_with_solid(bytes);
    let soup = match is_text {
        true => text::read(bytes, file, &options.limits, findings)?,
        false => binary::read(bytes, file, &options.limits, findings)?,
    };
    let mesh = soup.into_facets().into_mesh(MaterialId(0), options);
    let instance = Instance { mesh: MeshId(0), world_from_model: Mat4::IDENTITY, name: file.to_owned() };
    Ok(Scene {
        meshes: vec![mesh],
        instances: vec![instance],
        materials: vec![Material::default()],
        ..Scene::default()
    })
}

/// Loose triangles, welded as they come.
pub(super) struct Soup {
    welder: Welder,
    triangles: Vec<[u32; 3]>,
    extras: Vec<Extra>,
    triangle_extras: Vec<[u32; 3]>,
    extra_ids: HashMap<u32, u32>,
    pub(super) parts: Vec<(String, usize)>,
}

impl Soup {
    pub(super) fn with_capacity(triangles: usize) -> Self {
        Self {
            welder: Welder::with_capacity(triangles / 2),
            triangles: Vec::with_capacity(triangles),
            extras: Vec::new(),
            triangle_extras: Vec::new(),
            extra_ids: HashMap::new(),
            parts: Vec::new(),
        }
    }

    pub(super) fn len(&self) -> usize {
        self.triangles.len()
    }

    pub(super) fn push(&mut self, corners: [[f32; 3]; 3]) {
        let triangle = corners.map(|position| self.welder.index(position));
        self.triangles.push(triangle);
    }

    /// Gives all triangles up to now without a colour, and the last one, this colour. `key` identifies it.
    pub(super) fn color_last(&mut self, key: u32, color: impl FnOnce() -> [f32; 4]) {
        let extras = &mut self.extras;
        let id = *self.extra_ids.entry(key).or_insert_with(|| {
            extras.push(Extra { uv: None, color: Some(color()) });
            u32::try_from(extras.len() - 1).unwrap_or(u32::MAX)
        });
        self.triangle_extras.resize(self.triangles.len(), [crate::geometry::ABSENT; 3]);
        if let Some(last) = self.triangle_extras.last_mut() {
            *last = [id; 3];
        }
    }

    fn into_facets(mut self) -> Facets {
        if !self.triangle_extras.is_empty() {
            self.triangle_extras.resize(self.triangles.len(), [crate::geometry::ABSENT; 3]);
        }
        Facets {
            positions: self.welder.into_positions(),
            triangles: self.triangles,
            triangle_extras: self.triangle_extras,
            extras: self.extras,
            parts: self.parts,
            ..Facets::default()
        }
    }
}
