//! Auto-framing: a scene and a view direction in, the camera out that shows all of it as large as possible.
//!
//! The eye is found exactly, from the vertices themselves: each vertex bounds the eye by four half-spaces (the sides
//! of the view pyramid), so the closest eye that sees them all follows from four maxima, in one pass. A bounding
//! sphere or box would leave the model small in the picture.

use super::camera::ViewAxes;
use super::{Camera, Projection, Scene};
use crate::math::vec3::{self, Vec3};

/// How to look at a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Framing {
    /// Angle around the up axis, in radians: 0 looks from the front (+z), positive moves the eye to the right (+x).
    pub azimuth: f64,
    /// Angle above the horizontal plane, in radians; positive looks down on the model.
    pub elevation: f64,
    /// Magnification of the fitted picture about its center; 1 fits, 2 doubles.
    pub zoom: f64,
    /// The part of the picture's width and height left free on each side, 0 to 0.5.
    pub margin: f64,
    /// Width / height of the picture.
    pub aspect: f64,
    /// Perspective with its field of view; an orthographic height is replaced by the fitted one.
    pub projection: Projection,
}

impl Default for Framing {
    /// Three-quarter view from the front right, 20 degrees above the horizon, with a margin of 4 %.
    fn default() -> Self {
        Self {
            azimuth: 35.0_f64.to_radians(),
            elevation: 20.0_f64.to_radians(),
            zoom: 1.0,
            margin: 0.04,
            aspect: 1.0,
            projection: Projection::default(),
        }
    }
}

impl Framing {
    /// The camera that shows every drawn vertex of `scene` inside the margin, as large as possible (at zoom 1).
    ///
    /// The scene's up axis is +y. An empty scene is looked at from a distance of a few units; a single point is shown
    /// in the middle.
    #[must_use]
    pub fn camera(&self, scene: &Scene) -> Camera {
        let (sin_a, cos_a) = (libm::sin(self.azimuth), libm::cos(self.azimuth));
        let (sin_e, cos_e) = (libm::sin(self.elevation), libm::cos(self.elevation));
        let forward = [-sin_a * cos_e, -sin_e, -cos_a * cos_e];
        self.camera_along(scene, forward, [0.0, 1.0, 0.0])
    }

    /// Like [`Framing::camera`], looking along the world-space direction `forward` instead of by angles.
    #[must_use]
    pub fn camera_along(&self, scene: &Scene, forward: Vec3, up: Vec3) -> Camera {
        let axes = ViewAxes::looking(forward, up);
        let origin = scene.bounding_box().center();
        let mut extent = Extent::new(self.slopes());
        scene.for_each_point(|point| extent.insert(axes.project(vec3::sub(point, origin))));
        extent.or_unit_cube().camera(&axes, origin, self)
    }

    /// Horizontal and vertical slope (offset per depth) of the sides of the view pyramid inside the margin.
    fn slopes(&self) -> [f64; 2] {
        let aspect = if self.aspect > 0.0 && self.aspect.is_finite() { self.aspect } else { 1.0 };
        let free = 1.0 - 2.0 * self.margin.clamp(0.0, 0.49);
        match self.projection {
            Projection::Perspective { fov_y } => {
                let tan = libm::tan(fov_y.clamp(1e-3, 3.1) * 0.5) * free;
                [tan * aspect, tan]
            }
            Projection::Orthographic { .. } => [aspect * free, free],
        }
    }

    fn zoom(&self) -> f64 {
        if self.zoom > 0.0 && self.zoom.is_finite() { self.zoom } else { 1.0 }
    }
}

/// What a set of view-space points demands of the camera.
struct Extent {
    slopes: [f64; 2],
    /// For x and y: the largest `+coordinate - slope * depth` and `-coordinate - slope * depth`.
    sides: [[f64; 2]; 2],
    /// For x, y and depth: least and greatest coordinate.
    range: [[f64; 2]; 3],
}

impl Extent {
    fn new(slopes: [f64; 2]) -> Self {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        Self { slopes, sides: [[f64::NEG_INFINITY; 2]; 2], range: [none; 3] }
    }

    #[inline]
    fn insert(&mut self, point: Vec3) {
        let [x, y, depth] = point;
        for (([high, low], slope), coordinate) in self.sides.iter_mut().zip(self.slopes).zip([x, y]) {
            let reach = slope * depth;
            *high = high.max(coordinate - reach);
            *low = low.max(-coordinate - reach);
        }
        for (axis, &coordinate) in point.iter().enumerate() {
            let [least, greatest] = &mut self.range[axis];
            *least = least.min(coordinate);
            *greatest = greatest.max(coordinate);
        }
    }

    /// Nothing to see is looked at like a cube of edge 2 around the origin.
    fn or_unit_cube(mut self) -> Self {
        if self.range[0][0] > self.range[0][1] {
            for corner in 0..8_u8 {
                self.insert([0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { -1.0 } else { 1.0 }));
            }
        }
        self
    }

    fn camera(&self, axes: &ViewAxes, origin: Vec3, framing: &Framing) -> Camera {
        let [x, y, depth] = self.range;
        let size = (x[1] - x[0]).max(y[1] - y[0]).max(depth[1] - depth[0]);
        // A single point still needs a distance; a tiny one far from the origin needs one that survives rounding.
        let far_from_origin = origin.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        let size = if size > 0.0 { size } else { 1.0 }.max(far_from_origin * 1e-6);
        let (eye, projection) = match framing.projection {
            Projection::Perspective { fov_y } => {
                let fov_y = 2.0 * libm::atan(libm::tan(fov_y.clamp(1e-3, 3.1) * 0.5) / framing.zoom());
                (self.perspective_eye(size), Projection::Perspective { fov_y })
            }
            Projection::Orthographic { .. } => {
                let height = ((x[1] - x[0]) / self.slopes[0]).max((y[1] - y[0]) / self.slopes[1]);
                let height = if height > 0.0 { height } else { size } / framing.zoom();
                let eye = [0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]), depth[0] - size];
                (eye, Projection::Orthographic { height })
            }
        };
        let in_world = |p: Vec3| {
            let offset = vec3::add(vec3::scale(axes.right, p[0]), vec3::scale(axes.up, p[1]));
            vec3::add(origin, vec3::add(offset, vec3::scale(axes.forward, p[2])))
        };
        let middle = (0.5 * (depth[0] + depth[1])).max(eye[2] + 0.01 * size);
        Camera {
            eye: in_world(eye),
            target: in_world([eye[0], eye[1], middle]),
            up: axes.up,
            projection,
            near: depth[0] - eye[2],
            far: depth[1] - eye[2],
        }
        .with_padded_depth_range()
    }

    /// The closest eye with every point between the sides, centered where one pair of sides leaves room.
    ///
    /// A point at offset x and depth d is inside if |x - eye_x| <= slope * (d - eye_depth).
    fn perspective_eye(&self, size: f64) -> Vec3 {
        let deepest = |axis: usize| -(self.sides[axis][0] + self.sides[axis][1]) / (2.0 * self.slopes[axis]);
        let center = |axis: usize| 0.5 * (self.sides[axis][0] - self.sides[axis][1]);
        // Never on the nearest point itself, which happens where the points lie in the line of sight.
        let depth = deepest(0).min(deepest(1)).min(self.range[2][0] - 0.05 * size);
        let depth = if self.range[0][0] == self.range[0][1] && self.range[1][0] == self.range[1][1] {
            depth.min(self.range[2][0] - 2.0 * size)
        } else {
            depth
        };
        [center(0), center(1), depth]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Mat4;
    use crate::scene::{Instance, MaterialId, Mesh, MeshId, Submesh};

    /// A cloud of points in an uneven box, by a linear congruential generator.
    fn cloud(seed: u32, offset: f32) -> Scene {
        let mut state = seed;
        let mut next = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f32::from(u16::try_from(state >> 16).unwrap()) / 65_535.0
        };
        let positions: Vec<_> = (0..200).map(|_| [next() * 3.0 + offset, next(), next() * 0.5 - offset]).collect();
        scene_of(positions)
    }

    fn scene_of(positions: Vec<[f32; 3]>) -> Scene {
        let points: Vec<u32> = (0..u32::try_from(positions.len()).unwrap()).collect();
        let submesh = Submesh { points: 0..points.len(), ..Submesh::new(0, MaterialId(0)) };
        let mesh = Mesh { positions, points, submeshes: vec![submesh], ..Mesh::default() };
        let instance = Instance { mesh: MeshId(0), world_from_model: Mat4::IDENTITY, name: String::new() };
        Scene { meshes: vec![mesh], instances: vec![instance], ..Scene::default() }
    }

    /// Least and greatest NDC x and y over all points; asserts that depths are in range.
    fn ndc_range(scene: &Scene, camera: &Camera, aspect: f64) -> [[f64; 2]; 2] {
        let clip_from_world = camera.clip_from_world(aspect);
        let mut range = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for &p in &scene.meshes[0].positions {
            let [x, y, z, w] = clip_from_world.transform_point(vec3::widen(p));
            assert!(w > 0.0 && (0.0..=1.0).contains(&(z / w)), "depth {}", z / w);
            for (range, value) in range.iter_mut().zip([x / w, y / w]) {
                *range = [range[0].min(value), range[1].max(value)];
            }
        }
        range
    }

    #[test]
    fn every_vertex_is_inside_and_one_pair_of_sides_is_touched() {
        let projections = [Projection::Perspective { fov_y: 0.6 }, Projection::Orthographic { height: 1.0 }];
        for seed in 0..20 {
            for projection in projections {
                let aspect = 0.4 + f64::from(seed) * 0.13;
                let azimuth = f64::from(seed);
                let framing = Framing { aspect, azimuth, projection, margin: 0.05, ..Framing::default() };
                let scene = cloud(seed, 0.0);
                let [x, y] = ndc_range(&scene, &framing.camera(&scene), aspect);
                let fits = |r: [f64; 2]| r[0] >= -0.9001 && r[1] <= 0.9001;
                let touches = |r: [f64; 2]| r[0] <= -0.8999 && r[1] >= 0.8999;
                assert!(fits(x) && fits(y), "{x:?} {y:?}");
                assert!(touches(x) || touches(y), "{x:?} {y:?}");
            }
        }
    }

    #[test]
    fn zoom_magnifies_about_the_center() {
        let scene = cloud(3, 0.0);
        for projection in [Projection::default(), Projection::Orthographic { height: 1.0 }] {
            let framing = Framing { projection, margin: 0.0, ..Framing::default() };
            let fitted = ndc_range(&scene, &framing.camera(&scene), 1.0);
            let zoomed = ndc_range(&scene, &Framing { zoom: 0.5, ..framing }.camera(&scene), 1.0);
            for (z, f) in zoomed.as_flattened().iter().zip(fitted.as_flattened()) {
                assert!((z * 2.0 - f).abs() < 1e-4, "{zoomed:?} {fitted:?}");
            }
        }
    }

    #[test]
    fn degenerate_scenes_get_a_usable_camera() {
        let scenes = [
            Scene::default(),
            scene_of(vec![[0.0; 3]]),
            scene_of(vec![[1e6, 2.0, -1e6]]),
            scene_of(vec![[0.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
            scene_of(vec![[0.0; 3], [1.0, 0.0, 0.0], [f32::NAN; 3]]),
            scene_of(vec![[-1e30; 3], [1e30; 3]]),
        ];
        for scene in scenes {
            for elevation in [0.0, 1.5, std::f64::consts::FRAC_PI_2] {
                let camera = Framing { elevation, ..Framing::default() }.camera(&scene);
                let matrix = camera.clip_from_world(1.0);
                assert!(matrix.columns.iter().flatten().all(|m| m.is_finite()), "{camera:?}");
                assert!(camera.near < camera.far, "{camera:?}");
            }
        }
    }

    #[test]
    fn default_view_is_from_the_front_right_and_above() {
        let camera = Framing::default().camera(&cloud(1, 0.0));
        let forward = camera.forward();
        assert!(forward[0] < 0.0 && forward[1] < 0.0 && forward[2] < 0.0, "{forward:?}");
    }
}
