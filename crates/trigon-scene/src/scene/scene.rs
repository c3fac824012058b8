//! The scene: lists of things that refer to each other by index.

use super::{Camera, Light, Material, Mesh, Texture};
use crate::math::{Aabb, Mat4, vec3};

/// Index into [`Scene::meshes`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct MeshId(pub u32);

/// Index into [`Scene::materials`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct MaterialId(pub u32);

/// Index into [`Scene::textures`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TextureId(pub u32);

/// A mesh placed in the world.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// The mesh that is drawn.
    pub mesh: MeshId,
    /// Affine transform from the mesh's model space to world space.
    pub world_from_model: Mat4,
    /// A name for people, such as that of the file.
    pub name: String,
}

/// Everything a picture is made from.
///
/// Invariant: every id held by an instance, a submesh or a material map is a valid index into its list.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Geometry, in model space.
    pub meshes: Vec<Mesh>,
    /// Where geometry stands in the world.
    pub instances: Vec<Instance>,
    /// Surface descriptions that submeshes refer to.
    pub materials: Vec<Material>,
    /// Pictures that materials refer to, still encoded.
    pub textures: Vec<Texture>,
    /// Lights in world space; a renderer with none uses a rig of its own.
    pub lights: Vec<Light>,
    /// The view the file asks for, where the format has one.
    pub camera: Option<Camera>,
}

impl Scene {
    /// The smallest box in world space around every vertex that something drawn refers to.
    #[must_use]
    pub fn bounding_box(&self) -> Aabb {
        let mut aabb = Aabb::EMPTY;
        self.for_each_point(|point| aabb.insert(vec3::narrow(point)));
        aabb
    }

    /// Applies `transform` to every instance, after the transform it has.
    pub fn transform(&mut self, transform: Mat4) {
        for instance in &mut self.instances {
            instance.world_from_model = transform * instance.world_from_model;
        }
    }

    /// Makes tangents for all triangles whose material has a tangent-space normal map; see [`Mesh::generate_tangents`].
    pub fn generate_tangents(&mut self) {
        let has_normal_map: Vec<bool> = self.materials.iter().map(|material| material.maps.normal.is_some()).collect();
        let needs_tangents =
            |id: MaterialId| usize::try_from(id.0).is_ok_and(|id| has_normal_map.get(id) == Some(&true));
        for mesh in &mut self.meshes {
            mesh.generate_tangents(needs_tangents);
        }
    }

    /// Adds all of `other` to this scene, renumbering its ids. Keeps the camera of the first scene that has one.
    ///
    /// # Panics
    ///
    /// If the lists together exceed `u32::MAX` entries.
    pub fn merge(&mut self, other: Self) {
        let count = |n: usize| u32::try_from(n).expect("fewer than 2^32 scene entries");
        let (mesh_base, material_base) = (count(self.meshes.len()), count(self.materials.len()));
        let texture_base = count(self.textures.len());
        self.meshes.extend(other.meshes.into_iter().map(|mut mesh| {
            for submesh in &mut mesh.submeshes {
                submesh.material.0 += material_base;
            }
            mesh
        }));
        self.instances.extend(
            other
                .instances
                .into_iter()
                .map(|instance| Instance { mesh: MeshId(instance.mesh.0 + mesh_base), ..instance }),
        );
        self.materials.extend(other.materials.into_iter().map(|mut material| {
            material.maps.for_each_mut(|map| map.texture.0 += texture_base);
            material
        }));
        self.textures.extend(other.textures);
        self.lights.extend(other.lights);
        self.camera = self.camera.take().or(other.camera);
    }

    /// The number of triangles over all instances.
    #[must_use]
    pub fn triangle_count(&self) -> usize {
        self.instances.iter().filter_map(|i| self.mesh(i.mesh)).map(|mesh| mesh.triangles.len()).sum()
    }

    /// The mesh with this id, if it exists.
    #[must_use]
    pub fn mesh(&self, id: MeshId) -> Option<&Mesh> {
        self.meshes.get(usize::try_from(id.0).ok()?)
    }

    /// The material with this id, if it exists.
    #[must_use]
    pub fn material(&self, id: MaterialId) -> Option<&Material> {
        self.materials.get(usize::try_from(id.0).ok()?)
    }

    /// The texture with this id, if it exists.
    #[must_use]
    pub fn texture(&self, id: TextureId) -> Option<&Texture> {
        self.textures.get(usize::try_from(id.0).ok()?)
    }

    /// Calls `visit` with the world position of each finite vertex that is drawn, once per instance.
    pub(super) fn for_each_point(&self, mut visit: impl FnMut(vec3::Vec3)) {
        for instance in &self.instances {
            let Some(mesh) = self.mesh(instance.mesh) else { continue };
            let is_used = mesh.used_vertices();
            let matrix = &instance.world_from_model;
            let moves = *matrix != Mat4::IDENTITY;
            for (&position, _) in mesh.positions.iter().zip(&is_used).filter(|(_, used)| **used) {
                if !position.iter().all(|c| c.is_finite()) {
                    continue;
                }
                let point = vec3::widen(position);
                if moves {
                    let [x, y, z, _] = matrix.transform_point(point);
                    visit([x, y, z]);
                } else {
                    visit(point);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Submesh, TextureRef};

    fn one_triangle() -> Scene {
        let mesh = Mesh {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [50.0; 3]],
            triangles: vec![[0, 1, 2]],
            submeshes: vec![Submesh { triangles: 0..1, ..Submesh::new(0, MaterialId(0)) }],
            ..Mesh::default()
        };
        let mut material = Material::default();
        material.maps.diffuse = Some(TextureRef::new(TextureId(0)));
        Scene {
            meshes: vec![mesh],
            instances: vec![Instance { mesh: MeshId(0), world_from_model: Mat4::IDENTITY, name: String::new() }],
            materials: vec![material],
            textures: vec![Texture::new("a.png", Vec::new())],
            ..Scene::default()
        }
    }

    #[test]
    fn bounding_box_follows_instances_and_skips_unused_vertices() {
        let mut scene = one_triangle();
        scene.transform(Mat4::translation([0.0, 0.0, 3.0]));
        assert_eq!(scene.bounding_box(), Aabb { min: [0.0, 0.0, 3.0], max: [1.0, 1.0, 3.0] });
        assert!(Scene::default().bounding_box().is_empty());
    }

    #[test]
    fn merging_renumbers_every_id() {
        let mut scene = one_triangle();
        scene.merge(one_triangle());
        assert_eq!(scene.instances[1].mesh, MeshId(1));
        assert_eq!(scene.meshes[1].submeshes[0].material, MaterialId(1));
        assert_eq!(scene.materials[1].maps.diffuse.as_ref().unwrap().texture, TextureId(1));
        assert_eq!(scene.triangle_count(), 2);
    }
}
