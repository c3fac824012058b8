//! The turning of a turntable: a scene and its camera in, the camera and lights of each frame out.
//!
//! The camera is framed once, on everything that the model sweeps through in a turn, so that it neither jumps nor cuts.
//! Turning the model before a fixed camera and lights is the same picture as turning those the other way about it.

use crate::view::Horizon;
use std::f64::consts::TAU;
use trigon_scene::math::Mat4;
use trigon_scene::math::vec3::{self, Vec3};
use trigon_scene::scene::{Camera, Instance, Light, LightKind, MaterialId, Mesh, MeshId, Scene, Submesh};

/// A turn about the up axis through the middle of a scene.
pub(crate) struct Turn {
    horizon: Horizon,
    center: Vec3,
}

/// Slices across the axis; each counts as wide as its widest vertex.
const SLICES: usize = 128;
/// Corners of the polygon that stands for a circle.
const CORNERS: u32 = 48;

impl Turn {
    pub(crate) fn new(scene: &Scene, up: Vec3) -> Self {
        Self { horizon: Horizon::new(up), center: scene.bounding_box().center() }
    }

    /// A scene of points around everything that the model sweeps through: what the camera has to frame.
    pub(crate) fn swept(&self, scene: &Scene) -> Scene {
        let points: Vec<Vec3> = self.cylinder_points(scene);
        let (lowest, highest) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(lowest, highest), point| {
            (lowest.min(point[1]), highest.max(point[1]))
        });
        if lowest > highest {
            return Scene::default();
        }
        let height = (highest - lowest) / SLICES_F64;
        let mut radii = vec![None; SLICES];
        for [right, up, front] in points {
            let slice = slice_of((up - lowest) / height);
            let radius = (right * right + front * front).sqrt();
            let widest: &mut Option<f64> = &mut radii[slice];
            *widest = Some(widest.map_or(radius, |widest| widest.max(radius)));
        }
        let mut positions = Vec::new();
        for (slice, radius) in radii.into_iter().enumerate() {
            let Some(radius) = radius else { continue };
            let bottom = lowest + height * f64::from(u32::try_from(slice).unwrap_or(0));
            for up in [bottom, bottom + height] {
                positions.extend((0..CORNERS).map(|corner| self.on_circle(radius, up, corner)));
            }
        }
        scene_of_points(positions)
    }

    /// Coordinates of all vertices along right, up and front, from the center.
    fn cylinder_points(&self, scene: &Scene) -> Vec<Vec3> {
        let mut points = Vec::new();
        for instance in &scene.instances {
            let Some(mesh) = scene.mesh(instance.mesh) else { continue };
            for (position, _) in mesh.positions.iter().zip(mesh.used_vertices()).filter(|(_, is_used)| *is_used) {
                let [x, y, z, _] = instance.world_from_model.transform_point(vec3::widen(*position));
                let point = self.horizon.project(vec3::sub([x, y, z], self.center));
                if point.iter().all(|c| c.is_finite()) {
                    points.push(point);
                }
            }
        }
        points
    }

    /// A corner of the polygon around the circle.
    fn on_circle(&self, radius: f64, up: f64, corner: u32) -> [f32; 3] {
        let angle = TAU * f64::from(corner) / f64::from(CORNERS);
        let outer = radius / libm::cos(0.5 * TAU / f64::from(CORNERS));
        let offset = self.horizon.unproject([outer * libm::sin(angle), up, outer * libm::cos(angle)]);
        vec3::narrow(vec3::add(self.center, offset))
    }

    /// The camera before which the model appears turned by `angle`, counterclockwise seen from above.
    pub(crate) fn camera(&self, camera: &Camera, angle: f64) -> Camera {
        Camera {
            eye: self.turn_point(camera.eye, -angle),
            target: self.turn_point(camera.target, -angle),
            up: self.horizon.turn(camera.up, -angle),
            ..*camera
        }
    }

    /// The lights that stand still beside that camera.
    pub(crate) fn lights(&self, lights: &[Light], angle: f64) -> Vec<Light> {
        let mut turned = lights.to_vec();
        for light in &mut turned {
            match &mut light.kind {
                LightKind::Directional { direction } => *direction = self.horizon.turn(*direction, -angle),
                LightKind::Point { position } => *position = self.turn_point(*position, -angle),
                LightKind::Spot { position, direction, .. } => {
                    *position = self.turn_point(*position, -angle);
                    *direction = self.horizon.turn(*direction, -angle);
                }
                _ => {}
            }
        }
        turned
    }

    fn turn_point(&self, point: Vec3, angle: f64) -> Vec3 {
        vec3::add(self.center, self.horizon.turn(vec3::sub(point, self.center), angle))
    }
}

const SLICES_F64: f64 = 128.0;

/// The slice of a height in 0..=[`SLICES`]; a flat model (0 / 0) has one slice.
fn slice_of(height: f64) -> usize {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped; NaN becomes 0")]
    let slice = height.clamp(0.0, SLICES_F64 - 1.0) as usize;
    slice
}

fn scene_of_points(positions: Vec<[f32; 3]>) -> Scene {
    let points: Vec<u32> = (0..u32::try_from(positions.len()).unwrap_or(0)).collect();
    let submesh = Submesh { points: 0..points.len(), ..Submesh::new(0, MaterialId(0)) };
    let mesh = Mesh { positions, points, submeshes: vec![submesh], ..Mesh::default() };
    let instance = Instance { mesh: MeshId(0), world_from_model: Mat4::IDENTITY, name: String::new() };
    Scene { meshes: vec![mesh], instances: vec![instance], ..Scene::default() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon_scene::scene::Framing;

    #[test]
    fn every_frame_shows_the_whole_model() {
        // A tall plate that stands off the axis.
        let positions = vec![[-1.0, 0.0, 0.0], [3.0, 0.0, 0.2], [3.0, 5.0, 0.0], [-1.0, 5.0, -0.5]];
        let scene = scene_of_points(positions.clone());
        let up = [0.0, 1.0, 0.0];
        let turn = Turn::new(&scene, up);
        let base = Framing { margin: 0.0, aspect: 1.5, ..Framing::default() }.camera(&turn.swept(&scene));
        let mut largest: f64 = 0.0;
        for frame in 0..90 {
            let clip_from_world = turn.camera(&base, TAU * f64::from(frame) / 90.0).clip_from_world(1.5);
            for &position in &positions {
                let [x, y, z, w] = clip_from_world.transform_point(vec3::widen(position));
                assert!(w > 0.0 && (0.0..=1.0).contains(&(z / w)));
                largest = largest.max((x / w).abs()).max((y / w).abs());
            }
        }
        assert!(largest <= 1.0001, "{largest}");
        assert!(largest > 0.9, "{largest} leaves much of the picture empty");
    }

    #[test]
    fn the_model_turns_counterclockwise_from_above() {
        let turn = Turn { horizon: Horizon::new([0.0, 1.0, 0.0]), center: [0.0; 3] };
        let camera = Framing { azimuth: 0.0, elevation: 0.0, ..Framing::default() }.camera(&Scene::default());
        let x_in_picture = |angle: f64| {
            let [x, _, _, w] = turn.camera(&camera, angle).clip_from_world(1.0).transform_point([0.0, 0.0, 1.0]);
            x / w
        };
        // The front comes from the middle and goes right, then on to the back.
        assert!(x_in_picture(0.0).abs() < 1e-6);
        assert!(x_in_picture(0.5) > 0.05);
        assert!(x_in_picture(-0.5) < -0.05);
    }

    #[test]
    fn lights_keep_their_place_before_the_camera() {
        let turn = Turn { horizon: Horizon::new([0.0, 0.0, 1.0]), center: [1.0, 2.0, 3.0] };
        let camera = Framing::default().camera(&Scene::default());
        let light = Light::new(LightKind::Point { position: [4.0, 5.0, 6.0] }, 1.0);
        let in_view = |camera: &Camera, light: &Light| match light.kind {
            LightKind::Point { position } => camera.view_from_world().transform_point(position),
            _ => [0.0; 4],
        };
        let before = in_view(&camera, &light);
        let after = in_view(&turn.camera(&camera, 2.0), &turn.lights(&[light], 2.0)[0]);
        assert!(before.iter().zip(after).all(|(b, a)| (b - a).abs() < 1e-5), "{before:?} {after:?}");
    }

    #[test]
    fn empty_and_flat_models_are_swept_too() {
        let up = [0.0, 1.0, 0.0];
        let empty = Scene::default();
        assert!(Turn::new(&empty, up).swept(&empty).meshes.is_empty());
        let flat = scene_of_points(vec![[0.0; 3], [1.0, 0.0, 1.0]]);
        let swept = Turn::new(&flat, up).swept(&flat);
        assert!(!swept.bounding_box().is_empty());
    }
}
