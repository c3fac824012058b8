//! Displacement of a scene: height maps of materials in, finer meshes with that relief out.
//!
//! Made once for a view, before drawing: what comes out are meshes like any others, whose silhouettes, shadows and
//! outlines show the relief. How fine they are depends on the view; see [`Displacement::max_edge_px`].

use super::{Camera, Instance, MeshId, Scene};
use crate::geometry::{HeightMap, Relief, displace};
use crate::load::{Location, Place, Warning, WarningKind};
use crate::math::{Mat4, vec3};
use trigon_image::Limits;

/// How height maps (`disp`, `map_Disp`) become geometry.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Displacement {
    /// How far a surface moves along its normal where the map is white, in units of the model (before its instance's
    /// transform). `None` is [`Displacement::FITTED_SCALE`] of the mesh's radius.
    pub scale: Option<f32>,
    /// The height that stays where it is: 0 (black) by default; lower ones move inwards.
    pub middle: f32,
    /// Edges are halved until they look no longer than this, in pixels; outside of the picture until eight times as long. At
    /// cliffs, where the heights of two maps meet, they may stay longer.
    pub max_edge_px: f32,
    /// The most triangles that a scene may have afterwards. Where they do not suffice, the longest edges are halved.
    pub max_triangles: usize,
}

impl Displacement {
    /// The default scale, as a part of half the diagonal of the box around a mesh.
    pub const FITTED_SCALE: f32 = 0.05;
}

impl Default for Displacement {
    /// Outwards by a fitted scale, edges of two pixels, at most four million triangles.
    fn default() -> Self {
        Self { scale: None, middle: 0.0, max_edge_px: 2.0, max_triangles: 4_000_000 }
    }
}

/// What [`Scene::displace`] has done.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Displaced {
    /// How many meshes have changed.
    pub meshes: usize,
    /// Triangles of these meshes now.
    pub triangles: usize,
    /// Whether all edges became as short as they should.
    pub is_fine: bool,
    /// Height maps that could not be used, each once.
    pub warnings: Vec<Warning>,
}

/// Edges outside of the picture may be this much longer: what they shape are shadows.
const OUTSIDE: f64 = 8.0;

impl Scene {
    /// Gives every surface whose material has a height map, and that has texture coordinates, the relief of that map, fine
    /// enough for a picture of `size` pixels of what `camera` sees.
    ///
    /// Meshes that break their invariants ([`Mesh::validate`](super::Mesh::validate)) stay as they are. Surfaces stay closed: where vertices share a position they move together. The maps are no longer used for shading
    /// afterwards.
    pub fn displace(&mut self, camera: &Camera, size: [u32; 2], settings: &Displacement) -> Displaced {
        let mut displaced = Displaced { is_fine: true, ..Displaced::default() };
        let maps = self.height_maps(&mut displaced.warnings);
        let view = View::new(camera, size);
        let mut room = settings.max_triangles.saturating_sub(self.meshes.iter().map(|mesh| mesh.triangles.len()).sum());
        for index in 0..self.meshes.len() {
            let mesh = &self.meshes[index];
            let map = |material: super::MaterialId| maps.get(usize::try_from(material.0).ok()?)?.as_ref();
            let relief = Relief {
                maps: mesh.submeshes.iter().map(|submesh| map(submesh.material)).collect(),
                scale: settings.scale.unwrap_or(Displacement::FITTED_SCALE * radius(mesh)),
                middle: settings.middle,
            };
            let has_map =
                relief.maps.iter().zip(&mesh.submeshes).any(|(map, s)| map.is_some() && !s.triangles.is_empty());
            if mesh.uvs.is_empty() || !has_map || mesh.validate().is_err() {
                continue;
            }
            let instances: Vec<Mat4> = self.placed(index).map(|instance| instance.world_from_model).collect();
            let limit = f64::from(settings.max_edge_px).max(0.1);
            let excess = |a: [f32; 3], b: [f32; 3]| view.longest(&instances, a, b) / limit;
            let before = mesh.triangles.len();
            let (mesh, is_fine) = displace(mesh, &relief, before + room, &excess);
            room = room.saturating_sub(mesh.triangles.len() - before);
            displaced.meshes += 1;
            displaced.triangles += mesh.triangles.len();
            displaced.is_fine &= is_fine;
            self.meshes[index] = mesh;
        }
        for (material, _) in self.materials.iter_mut().zip(&maps).filter(|(_, map)| map.is_some()) {
            material.maps.displacement = None;
        }
        displaced
    }

    /// The heights of each material that has a map which can be used.
    fn height_maps(&self, warnings: &mut Vec<Warning>) -> Vec<Option<HeightMap>> {
        let mut bad = Vec::new();
        let mut map = |material: &super::Material| {
            let map = material.maps.displacement.as_ref()?;
            let texture = self.texture(map.texture)?;
            match texture.decode(&Limits::default()) {
                Ok(image) => Some(HeightMap::new(&image, &map.options)),
                Err(error) => {
                    if !bad.contains(&map.texture) {
                        bad.push(map.texture);
                        warnings.push(Warning {
                            location: Location { file: texture.name.clone(), place: Place::File },
                            kind: WarningKind::MissingFile,
                            message: format!("height map cannot be used: {error}; its surfaces stay as they are"),
                        });
                    }
                    None
                }
            }
        };
        self.materials.iter().map(&mut map).collect()
    }

    fn placed(&self, mesh: usize) -> impl Iterator<Item = &Instance> {
        let is_it = move |id: MeshId| usize::try_from(id.0).is_ok_and(|id| id == mesh);
        self.instances.iter().filter(move |instance| is_it(instance.mesh))
    }
}

/// Half the diagonal of the box around a mesh.
#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
fn radius(mesh: &super::Mesh) -> f32 {
    mesh.bounding_box().radius() as f32
}

/// Lengths as they look in a picture.
struct View {
    clip_from_world: Mat4,
    eye: vec3::Vec3,
    /// The size of a pixel at distance d is `pixel[0] + pixel[1] * d`.
    pixel: [f64; 2],
}

impl View {
    fn new(camera: &Camera, [width, height]: [u32; 2]) -> Self {
        let aspect = f64::from(width.max(1)) / f64::from(height.max(1));
        Self { clip_from_world: camera.clip_from_world(aspect), eye: camera.eye, pixel: camera.pixel_size(height) }
    }

    /// The length of an edge in pixels, in the instance where it is longest: as if it lay across the view, because a
    /// relief that points at the eye is one that stands out.
    fn longest(&self, instances: &[Mat4], a: [f32; 3], b: [f32; 3]) -> f64 {
        let mut longest = 0.0;
        for world_from_model in instances {
            let [a, b] = [a, b].map(|p| {
                let [x, y, z, _] = world_from_model.transform_point(vec3::widen(p));
                [x, y, z]
            });
            let middle = vec3::scale(vec3::add(a, b), 0.5);
            let distance = vec3::length(vec3::sub(middle, self.eye));
            let pixel = self.pixel[0] + self.pixel[1] * distance;
            let length = vec3::length(vec3::sub(b, a)) / pixel.max(f64::MIN_POSITIVE);
            let pixels = if self.shows(middle, vec3::length(vec3::sub(b, a))) { length } else { length / OUTSIDE };
            longest = if pixels > longest { pixels } else { longest };
        }
        longest
    }

    /// Whether a point is in the picture, or nearer to it than `reach`.
    fn shows(&self, point: vec3::Vec3, reach: f64) -> bool {
        let [x, y, _, w] = self.clip_from_world.transform_point(point);
        let margin = (w.abs() + reach) * 1.1;
        w + reach > 0.0 && x.abs() <= margin + reach && y.abs() <= margin + reach
    }
}
