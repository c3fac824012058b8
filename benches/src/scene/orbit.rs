//! Cameras of the scenes: a frame number in, eye and matrix out. An orbit has 36 frames.

use core::f32::consts::PI;
use trigon::math::host::{cos, sin, tan};
use trigon_scene::math::{Mat4, vec3};
use trigon_scene::scene::{Camera, Projection};

/// Frames of a whole orbit.
pub const FRAMES: u32 = 36;

/// Distance of the eye from the origin in all scenes but the hall.
const DISTANCE: f32 = 2.2;

/// Vertical field of view in all scenes but the hall, in degrees.
const FOV_Y_DEGREES: f32 = 45.0;

/// How the camera moves.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Orbit {
    /// Around the origin, from above.
    Around,
    /// To and fro, a quarter radian to each side.
    Sway,
    /// Not at all.
    Fixed,
    /// Around the inside of the hall, looking ahead.
    Walk,
}

/// A camera at one frame.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct View {
    /// World-space position.
    pub eye: [f32; 3],
    /// Depth is reversed.
    pub clip_from_world: Mat4,
}

impl Orbit {
    /// The camera at `frame`, for a picture of `size` pixels.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "there are 36 frames")]
    pub fn view(self, frame: u32, size: [u32; 2]) -> View {
        let t = 2.0 * PI * (frame % FRAMES) as f32 / FRAMES as f32;
        let (eye, target) = self.eye_and_target(t);
        let fov_y_degrees: f32 = if self == Self::Walk { 60.0 } else { FOV_Y_DEGREES };
        let camera = Camera {
            eye: vec3::widen(eye),
            target: vec3::widen(target),
            up: [0.0, 1.0, 0.0],
            projection: Projection::Perspective { fov_y: f64::from(fov_y_degrees).to_radians() },
            near: 0.05,
            far: 60.0,
        };
        View { eye, clip_from_world: camera.clip_from_world(f64::from(size[0]) / f64::from(size[1])) }
    }

    fn eye_and_target(self, t: f32) -> ([f32; 3], [f32; 3]) {
        let origin = [0.0; 3];
        match self {
            Self::Around => {
                let elevation = 20.0f32.to_radians();
                let (up, along) = (sin(elevation), cos(elevation));
                ([along * sin(t), up, along * cos(t)].map(|c| DISTANCE * c), origin)
            }
            Self::Sway => {
                let angle = 0.25 * sin(t);
                ([sin(angle), 0.0, cos(angle)].map(|c| DISTANCE * c), origin)
            }
            Self::Fixed => ([0.0, 0.0, DISTANCE], origin),
            Self::Walk => {
                let eye = [7.0 * cos(t), 1.7, 1.2 * sin(t)];
                let ahead = t + 0.5 * PI;
                (eye, [eye[0] + cos(ahead), eye[1] - 0.05, eye[2] + sin(ahead)])
            }
        }
    }
}

/// Half the width and height of what the camera of `Sway` and `Fixed` sees at z = 0.
#[expect(clippy::cast_precision_loss, reason = "picture sizes are below 2^24")]
pub(super) fn half_view_at_origin(size: [u32; 2]) -> [f32; 2] {
    let half_height = DISTANCE * tan((FOV_Y_DEGREES / 2.0).to_radians());
    [half_height * (size[0] as f32 / size[1] as f32), half_height]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_section_at_the_origin_touches_the_sides_of_the_picture() {
        let size = [640, 480];
        let [x, y] = half_view_at_origin(size);
        let [cx, cy, cz, cw] = Orbit::Fixed.view(0, size).clip_from_world.transform_point([x.into(), y.into(), 0.0]);
        assert!((cx / cw - 1.0).abs() < 1e-5 && (cy / cw - 1.0).abs() < 1e-5, "{cx} {cy} {cw}");
        assert!(cz > 0.0 && cz < cw);
    }

    #[test]
    fn orbits_close() {
        for orbit in [Orbit::Around, Orbit::Sway, Orbit::Fixed, Orbit::Walk] {
            assert_eq!(orbit.view(5, [4, 3]), orbit.view(5 + FRAMES, [4, 3]));
        }
    }
}
