//! Cameras: where the eye is and how view space is projected to clip space.
//!
//! View space is right-handed, x right, y up, looking down -z. Clip space is that of WebGPU with reversed depth: after
//! the divide x and y in -1..=1 (y up), depth 1 at the near plane and 0 at the far plane. Matrices are composed in
//! `f64` and rounded once.

use crate::math::vec3::{self, Vec3};
use crate::math::{Aabb, Mat4};

/// A camera in world space.
///
/// Any values are accepted; where they are degenerate (eye on the target, up along the view, an empty depth range) the
/// matrices fall back to something usable instead of NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The position of the eye.
    pub eye: Vec3,
    /// The point in the middle of the picture.
    pub target: Vec3,
    /// The direction that is up in the picture; need not be a unit vector or perpendicular to the view.
    pub up: Vec3,
    /// Perspective or orthographic.
    pub projection: Projection,
    /// Distance of the near plane in front of the eye; positive for perspective.
    pub near: f64,
    /// Distance of the far plane; greater than `near`, infinity allowed for perspective.
    pub far: f64,
}

/// How view space becomes a picture.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Projection {
    /// Central projection.
    Perspective {
        /// The vertical field of view in radians, between 0 and pi.
        fov_y: f64,
    },
    /// Parallel projection.
    Orthographic {
        /// The height of the picture in world units.
        height: f64,
    },
}

impl Default for Projection {
    /// Perspective with a vertical field of view of 35 degrees: about a 57 mm lens on 35 mm film.
    fn default() -> Self {
        Self::Perspective { fov_y: 35.0_f64.to_radians() }
    }
}

/// The orthonormal axes of view space, as world-space directions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct ViewAxes {
    pub(super) right: Vec3,
    pub(super) up: Vec3,
    pub(super) forward: Vec3,
}

impl ViewAxes {
    /// Axes that look along `forward` with `up` upwards in the picture; any input gives an orthonormal result.
    pub(super) fn looking(forward: Vec3, up: Vec3) -> Self {
        let forward = vec3::normalized(forward).unwrap_or([0.0, 0.0, -1.0]);
        let right = vec3::normalized(vec3::cross(forward, vec3::normalized(up).unwrap_or([0.0, 1.0, 0.0])))
            .filter(|_| !is_parallel(forward, up))
            .or_else(|| vec3::normalized(vec3::cross(forward, least_aligned_axis(forward))))
            .unwrap_or([1.0, 0.0, 0.0]);
        Self { right, up: vec3::cross(right, forward), forward }
    }

    /// View-space coordinates of a world-space direction: right, up, and depth along the view.
    pub(super) fn project(&self, v: Vec3) -> Vec3 {
        [vec3::dot(self.right, v), vec3::dot(self.up, v), vec3::dot(self.forward, v)]
    }
}

impl Camera {
    /// Moves points from world to view space.
    #[must_use]
    pub fn view_from_world(&self) -> Mat4 {
        Mat4::from_rows(self.view_rows())
    }

    /// Projects view space to clip space for a picture of the given aspect ratio, width / height.
    #[must_use]
    pub fn clip_from_view(&self, aspect: f64) -> Mat4 {
        Mat4::from_rows(self.projection_rows(aspect))
    }

    /// The product of both, rounded once. Prefer it for transforming positions: far from the origin the rounded
    /// factors lose precision.
    #[must_use]
    pub fn clip_from_world(&self, aspect: f64) -> Mat4 {
        let (clip, view) = (self.projection_rows(aspect), self.view_rows());
        Mat4::from_rows(std::array::from_fn(|r| {
            std::array::from_fn(|c| {
                ((clip[r][0] * view[0][c] + clip[r][1] * view[1][c]) + clip[r][2] * view[2][c])
                    + clip[r][3] * view[3][c]
            })
        }))
    }

    /// The unit vector from the eye to the target.
    #[must_use]
    pub fn forward(&self) -> Vec3 {
        self.axes().forward
    }

    /// The size of a pixel in world units: `a + b * d` at distance d along the view, for `[a, b]` and a picture with so
    /// many rows.
    pub(crate) fn pixel_size(&self, rows: u32) -> [f64; 2] {
        let rows = f64::from(rows.max(1));
        match self.projection {
            Projection::Perspective { fov_y } => [0.0, 2.0 * libm::tan(fov_y * 0.5) / rows],
            Projection::Orthographic { height } => [height / rows, 0.0],
        }
    }

    /// The unit vectors to the right and up in the picture, and along the view.
    #[must_use]
    pub fn right_up_forward(&self) -> [Vec3; 3] {
        let axes = self.axes();
        [axes.right, axes.up, axes.forward]
    }

    /// The same camera with the depth range fitted around `aabb` (world space), so that nothing in it is cut and no
    /// depth precision is wasted; what is behind the eye stays out.
    #[must_use]
    pub fn with_depth_range_of(self, aabb: &Aabb) -> Self {
        let axes = self.axes();
        let to_center = vec3::sub(aabb.center(), self.eye);
        let half = vec3::scale(aabb.size(), 0.5);
        let reach: f64 = (0..3).map(|i| axes.forward[i].abs() * half[i]).sum();
        let depth = vec3::dot(axes.forward, to_center);
        Self { near: depth - reach, far: depth + reach, ..self }.with_padded_depth_range()
    }

    /// Widens the depth range a little against rounding and, for perspective, keeps it in front of the eye.
    pub(super) fn with_padded_depth_range(self) -> Self {
        let size = self.far.abs().max(self.near.abs()).max(f64::from(f32::MIN_POSITIVE));
        let padding = (self.far - self.near) * 0.01 + size * 1e-5;
        let (near, far) = (self.near - padding, self.far + padding);
        let near = match self.projection {
            Projection::Perspective { .. } => near.max(far * 1e-4).max(f64::from(f32::MIN_POSITIVE)),
            Projection::Orthographic { .. } => near,
        };
        Self { near, far: if far > near { far } else { near * 2.0 }, ..self }
    }

    pub(super) fn axes(&self) -> ViewAxes {
        ViewAxes::looking(vec3::sub(self.target, self.eye), self.up)
    }

    fn view_rows(&self) -> [[f64; 4]; 4] {
        let axes = self.axes();
        let backward = vec3::scale(axes.forward, -1.0);
        let row = |axis: Vec3| [axis[0], axis[1], axis[2], -vec3::dot(axis, self.eye)];
        [row(axes.right), row(axes.up), row(backward), [0.0, 0.0, 0.0, 1.0]]
    }

    fn projection_rows(&self, aspect: f64) -> [[f64; 4]; 4] {
        let aspect = if aspect > 0.0 && aspect.is_finite() { aspect } else { 1.0 };
        let (near, far) = (self.near, self.far);
        match self.projection {
            Projection::Perspective { fov_y } => {
                let focal = 1.0 / libm::tan(fov_y * 0.5);
                // Depth near * (far - d) / (d * (far - near)) at distance d: 1 at the near plane, 0 at the far plane.
                let (slope, offset) = match far.is_finite() {
                    true => (near / (far - near), near * (far / (far - near))),
                    false => (0.0, near),
                };
                [
                    [focal / aspect, 0.0, 0.0, 0.0],
                    [0.0, focal, 0.0, 0.0],
                    [0.0, 0.0, slope, offset],
                    [0.0, 0.0, -1.0, 0.0],
                ]
            }
            Projection::Orthographic { height } => {
                // Depth (far - d) / (far - near).
                let per_unit = 1.0 / (far - near);
                [
                    [2.0 / (height * aspect), 0.0, 0.0, 0.0],
                    [0.0, 2.0 / height, 0.0, 0.0],
                    [0.0, 0.0, per_unit, far * per_unit],
                    [0.0, 0.0, 0.0, 1.0],
                ]
            }
        }
    }
}

fn is_parallel(forward: Vec3, up: Vec3) -> bool {
    match vec3::normalized(up) {
        Some(up) => vec3::length(vec3::cross(forward, up)) < 1e-9,
        None => false,
    }
}

/// The coordinate axis that `v` points along least; for a view straight up or down this is z.
fn least_aligned_axis(v: Vec3) -> Vec3 {
    let mut axis = [0.0; 3];
    let order = [2, 0, 1];
    let least = order.into_iter().fold(2, |best, i| if v[i].abs() < v[best].abs() { i } else { best });
    // Looking straight down, the top of the picture is what was far away: -z.
    axis[least] = if least == 2 { -1.0 } else { 1.0 };
    axis
}

#[cfg(test)]
mod tests {
    use super::*;

    fn camera(projection: Projection) -> Camera {
        Camera { eye: [1.0, 2.0, 5.0], target: [1.0, 2.0, 0.0], up: [0.0, 1.0, 0.0], projection, near: 1.0, far: 9.0 }
    }

    fn ndc(camera: &Camera, point: Vec3) -> Vec3 {
        let [x, y, z, w] = camera.clip_from_world(2.0).transform_point(point);
        [x / w, y / w, z / w]
    }

    fn assert_close(got: Vec3, want: Vec3) {
        assert!(got.iter().zip(want).all(|(g, w)| (g - w).abs() < 1e-6), "{got:?} is not {want:?}");
    }

    #[test]
    fn depth_is_reversed_and_y_is_up() {
        let tan = libm::tan(0.4);
        for projection in [Projection::Perspective { fov_y: 0.8 }, Projection::Orthographic { height: 4.0 }] {
            let camera = camera(projection);
            assert_close(ndc(&camera, [1.0, 2.0, 4.0]), [0.0, 0.0, 1.0]);
            assert_close(ndc(&camera, [1.0, 2.0, -4.0]), [0.0, 0.0, 0.0]);
            let half_height = match projection {
                Projection::Perspective { .. } => 5.0 * tan,
                Projection::Orthographic { height } => height * 0.5,
            };
            let [x, y, _] = ndc(&camera, [1.0 + 2.0 * half_height, 2.0 + half_height, 0.0]);
            assert_close([x, y, 0.0], [1.0, 1.0, 0.0]);
        }
    }

    #[test]
    fn infinite_far_plane_keeps_the_near_plane_at_one() {
        let camera = Camera { far: f64::INFINITY, ..camera(Projection::default()) };
        assert_close(ndc(&camera, [1.0, 2.0, 4.0]), [0.0, 0.0, 1.0]);
        assert_close(ndc(&camera, [1.0, 2.0, -1e9]), [0.0, 0.0, 0.0]);
    }

    #[test]
    fn combined_matrix_is_the_product_of_both() {
        let camera = camera(Projection::default());
        let product = camera.clip_from_view(1.5) * camera.view_from_world();
        let combined = camera.clip_from_world(1.5);
        for (a, b) in product.columns.iter().flatten().zip(combined.columns.iter().flatten()) {
            assert!((a - b).abs() < 1e-5);
        }
    }

    #[test]
    fn degenerate_views_still_have_orthonormal_axes() {
        let views = [([0.0; 3], [0.0, 1.0, 0.0]), ([0.0, -3.0, 0.0], [0.0, 1.0, 0.0]), ([f64::NAN; 3], [0.0; 3])];
        for (forward, up) in views {
            let axes = ViewAxes::looking(forward, up);
            assert!(vec3::dot(axes.right, axes.up).abs() < 1e-12);
            assert!(vec3::dot(axes.forward, axes.up).abs() < 1e-12);
            assert!((vec3::length(vec3::cross(axes.right, axes.up)) - 1.0).abs() < 1e-12);
        }
        // Straight down: north (-z) is up in the picture, as on a map.
        let axes = ViewAxes::looking([0.0, -1.0, 0.0], [0.0, 1.0, 0.0]);
        assert_close(axes.up, [0.0, 0.0, -1.0]);
        assert_close(axes.right, [1.0, 0.0, 0.0]);
    }

    #[test]
    fn depth_range_holds_the_box() {
        let aabb = Aabb { min: [-1.0; 3], max: [1.0; 3] };
        let camera = camera(Projection::default()).with_depth_range_of(&aabb);
        for z in [-1.0, 1.0] {
            let depth = ndc(&camera, [0.0, 0.0, z])[2];
            assert!((0.0..=1.0).contains(&depth), "{depth}");
        }
        assert!(camera.near > 3.5 && camera.far < 6.5, "{camera:?}");
    }
}
