//! The camera: view options and a scene in, a [`Camera`] out.
//!
//! Without an eye the scene is framed from two angles about its up direction; with one, the camera stands there. Near
//! and far planes are fitted to the scene unless given.

use crate::failure::Failure;
use crate::options::ViewOptions;
use crate::values::UpDirection;
use std::f64::consts::PI;
use trigon_scene::math::vec3::{self, Vec3};
use trigon_scene::scene::{Camera, Framing, Projection, Scene};

/// Finds contradictions that the option table cannot express, before anything is read.
pub(crate) fn check(view: &ViewOptions) -> Result<(), Failure> {
    let fov = view.fov.0;
    if !(fov > 0.0 && fov < PI) {
        return Err(Failure::usage(format!("--fov {} is not between 0 and 180 degrees", fov.to_degrees())));
    }
    for (name, distance) in [("--near", view.near), ("--far", view.far)] {
        if distance.is_some_and(f64::is_nan) {
            return Err(Failure::usage(format!("{name} is no number")));
        }
    }
    if view.orthographic.is_none() && view.near.is_some_and(|near| near <= 0.0) {
        return Err(Failure::usage("--near must be above zero; only --orthographic allows other distances"));
    }
    if let (Some(near), Some(far)) = (view.near, view.far)
        && near >= far
    {
        return Err(Failure::usage(format!("--near {near} is not less than --far {far}")));
    }
    if view.eye.is_some() && view.eye == view.target {
        return Err(Failure::usage("--eye and --target are the same point; nothing can be seen along that view"));
    }
    Ok(())
}

/// The camera that the options ask for.
pub(crate) fn camera(view: &ViewOptions, scene: &Scene, up: UpDirection, aspect: f64) -> Result<Camera, Failure> {
    let up = view.up.unwrap_or(up).0;
    let camera = match view.eye {
        Some(eye) => standing(view, scene, eye.0, up),
        None => framing(view, scene, up, aspect),
    };
    with_planes(camera, view)
}

/// The scene as large as fits, seen from the angles about its up direction.
fn framing(view: &ViewOptions, scene: &Scene, up: Vec3, aspect: f64) -> Camera {
    let default = Framing::default();
    let azimuth = view.azimuth.map_or(default.azimuth, |angle| angle.0);
    let elevation = view.elevation.map_or(default.elevation, |angle| angle.0);
    let projection = match view.orthographic {
        Some(_) => Projection::Orthographic { height: 1.0 },
        None => Projection::Perspective { fov_y: view.fov.0 },
    };
    let framing = Framing { zoom: view.zoom.0, aspect, projection, ..default };
    let axes = Horizon::new(up);
    let mut camera = framing.camera_along(scene, axes.forward(azimuth, elevation), axes.up_at(azimuth, elevation));
    // Tells the sky light where up is; straight up and down the picture's up has to do.
    if libm::cos(elevation).abs() > 0.01 {
        camera.up = vec3::scale(axes.up, libm::cos(elevation).signum());
    }
    if let Some(Some(height)) = view.orthographic {
        camera.projection = Projection::Orthographic { height: height.0 / view.zoom.0 };
    }
    match view.target {
        None => camera,
        Some(target) => {
            let offset = vec3::sub(target.0, camera.target);
            Camera { eye: vec3::add(camera.eye, offset), target: target.0, ..camera }
                .with_depth_range_of(&scene.bounding_box())
        }
    }
}

/// A camera at a given place.
fn standing(view: &ViewOptions, scene: &Scene, eye: Vec3, up: Vec3) -> Camera {
    let bounds = scene.bounding_box();
    let target = view.target.map_or(bounds.center(), |target| target.0);
    let tan = libm::tan(view.fov.0 * 0.5) / view.zoom.0;
    let distance = vec3::length(vec3::sub(target, eye));
    let projection = match view.orthographic {
        None => Projection::Perspective { fov_y: 2.0 * libm::atan(tan) },
        Some(Some(height)) => Projection::Orthographic { height: height.0 / view.zoom.0 },
        Some(None) => Projection::Orthographic { height: 2.0 * distance * tan },
    };
    Camera { eye, target, up, projection, near: 1.0, far: 2.0 }.with_depth_range_of(&bounds)
}

/// Puts the planes where the options ask for them.
fn with_planes(camera: Camera, view: &ViewOptions) -> Result<Camera, Failure> {
    let near = view.near.unwrap_or(camera.near);
    let far = view.far.unwrap_or(camera.far);
    if near < far {
        return Ok(Camera { near, far, ..camera });
    }
    match (view.near, view.far) {
        // Everything is in front of the near plane or behind the far one: an empty picture, as asked for.
        (Some(near), None) => Ok(Camera { near, far: near + near.abs().max(1.0), ..camera }),
        (None, Some(far)) if far > 0.0 => Ok(Camera { near: far * 0.5, far, ..camera }),
        _ => Err(Failure::usage(format!("--far {far} lies behind the eye"))),
    }
}

/// The directions that angles are counted from, for any up direction.
pub(crate) struct Horizon {
    right: Vec3,
    pub(crate) up: Vec3,
    front: Vec3,
}

impl Horizon {
    /// The front is +z for +y up and -y for +z up, as modelling programs have it.
    pub(crate) fn new(up: Vec3) -> Self {
        let up = vec3::normalized(up).unwrap_or([0.0, 1.0, 0.0]);
        let [x, y, z] = up.map(f64::abs);
        let toward_front = if y >= x && y >= z {
            [0.0, 0.0, up[1].signum()]
        } else if z >= x {
            [0.0, -up[2].signum(), 0.0]
        } else {
            [0.0, 0.0, 1.0]
        };
        let right = vec3::normalized(vec3::cross(up, toward_front)).unwrap_or([1.0, 0.0, 0.0]);
        Self { right, up, front: vec3::cross(right, up) }
    }

    /// From the eye to the scene.
    fn forward(&self, azimuth: f64, elevation: f64) -> Vec3 {
        let (sin_e, cos_e) = (libm::sin(elevation), libm::cos(elevation));
        let level = self.level(azimuth);
        vec3::scale(vec3::add(vec3::scale(level, cos_e), vec3::scale(self.up, sin_e)), -1.0)
    }

    /// Up in the picture; defined where the view is straight down, too.
    fn up_at(&self, azimuth: f64, elevation: f64) -> Vec3 {
        let (sin_e, cos_e) = (libm::sin(elevation), libm::cos(elevation));
        vec3::sub(vec3::scale(self.up, cos_e), vec3::scale(self.level(azimuth), sin_e))
    }

    /// From the scene to the eye, in the horizontal plane.
    fn level(&self, azimuth: f64) -> Vec3 {
        let (sin_a, cos_a) = (libm::sin(azimuth), libm::cos(azimuth));
        vec3::add(vec3::scale(self.right, sin_a), vec3::scale(self.front, cos_a))
    }

    /// Coordinates along right, up and front.
    pub(crate) fn project(&self, v: Vec3) -> Vec3 {
        [vec3::dot(self.right, v), vec3::dot(self.up, v), vec3::dot(self.front, v)]
    }

    /// The inverse of [`project`](Self::project).
    pub(crate) fn unproject(&self, [right, up, front]: Vec3) -> Vec3 {
        let level = vec3::add(vec3::scale(self.right, right), vec3::scale(self.front, front));
        vec3::add(level, vec3::scale(self.up, up))
    }

    /// Turns a direction about the up axis, counterclockwise seen from above.
    pub(crate) fn turn(&self, v: Vec3, angle: f64) -> Vec3 {
        let (sin, cos) = (libm::sin(angle), libm::cos(angle));
        let [right, up, front] = self.project(v);
        self.unproject([right * cos + front * sin, up, front * cos - right * sin])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon_scene::math::Aabb;

    fn assert_close(got: Vec3, want: Vec3) {
        assert!(got.iter().zip(want).all(|(g, w)| (g - w).abs() < 1e-12), "{got:?} is not {want:?}");
    }

    #[test]
    fn fronts_are_those_of_modelling_programs() {
        for (up, right, front) in [
            ([0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
            ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]),
            ([0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
            ([0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]),
        ] {
            let horizon = Horizon::new(up);
            assert_close(horizon.right, right);
            assert_close(horizon.front, front);
        }
    }

    #[test]
    fn axes_are_orthonormal_for_any_up_and_turns_keep_lengths() {
        for up in [[1.0, 0.0, 0.0], [-2.0, 0.1, 0.0], [0.3, 0.4, -0.5], [1.0, 1.0, 1.0], [0.0, -3.0, 2.9]] {
            let horizon = Horizon::new(up);
            assert_close(vec3::cross(horizon.up, horizon.front), horizon.right);
            let v = [0.2, -0.7, 1.1];
            assert_close(horizon.unproject(horizon.project(v)), v);
            let turned = horizon.turn(v, 1.0);
            assert!((vec3::length(turned) - vec3::length(v)).abs() < 1e-12);
            assert!((vec3::dot(turned, horizon.up) - vec3::dot(v, horizon.up)).abs() < 1e-12);
        }
        // Counterclockwise from above: front (+z) goes right (+x).
        assert_close(Horizon::new([0.0, 1.0, 0.0]).turn([0.0, 0.0, 1.0], PI / 2.0), [1.0, 0.0, 0.0]);
    }

    #[test]
    fn the_horizon_of_y_agrees_with_the_librarys_framing() {
        let scene = Scene::default();
        let framing = Framing { azimuth: 0.7, elevation: 0.3, ..Framing::default() };
        let horizon = Horizon::new([0.0, 1.0, 0.0]);
        let ours = framing.camera_along(&scene, horizon.forward(0.7, 0.3), horizon.up_at(0.7, 0.3));
        let theirs = framing.camera(&scene);
        assert_close(ours.eye, theirs.eye);
        assert_close(ours.right_up_forward()[1], theirs.right_up_forward()[1]);
        assert!(Aabb::EMPTY.is_empty());
    }
}
