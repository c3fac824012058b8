//! Lights as shaders read them, and the rig that stands in where a scene has none.
//!
//! In: the scene's lights, the camera. Out: a sum of ambient light and a list of sources. The rig is attached to the
//! camera, so that a model looks good from every side: a key light from the upper left, a weak fill from the right, a
//! rim light from behind, and a sky that is brighter than the ground. Their sum keeps white surfaces just below white.

use super::shadow_map::ShadowMap;
use crate::math::vec3::{self, Vec3};
use crate::scene::{Camera, Light, LightKind};

/// The light that reaches a scene, in linear RGB.
pub(super) struct Lighting {
    /// Sum of the ambient lights: multiplies the ambient reflectance.
    pub(super) ambient: [f32; 3],
    /// Light from all around.
    pub(super) sky: Option<Sky>,
    /// Sources with a direction.
    pub(super) sources: Vec<Source>,
}

/// Diffuse light from all directions, blending from `ground` below to `above`.
pub(super) struct Sky {
    pub(super) up: [f32; 3],
    /// Half the sum and half the difference of the light from above and from below.
    pub(super) mean: [f32; 3],
    pub(super) slope: [f32; 3],
}

/// A directional, point or spot light.
pub(super) struct Source {
    /// The unit vector to a directional light, or the position of the others.
    pub(super) place: [f32; 3],
    pub(super) is_directional: bool,
    /// Times intensity.
    pub(super) color: [f32; 3],
    pub(super) cone: Option<Cone>,
    /// Whether it makes highlights.
    pub(super) has_highlight: bool,
    /// Whether it casts shadows in frames with shadows.
    pub(super) casts_shadows: bool,
    /// What it sees, if it casts shadows in this frame.
    pub(super) shadow: Option<ShadowMap>,
}

/// The cone of a spot light.
pub(super) struct Cone {
    /// Unit vector from the light towards the scene.
    pub(super) axis: [f32; 3],
    pub(super) cos_outer: f32,
    /// In radians, 0 to pi.
    pub(super) outer_angle: f64,
    /// 1 / (cosine of the inner angle - cosine of the outer one).
    pub(super) inverse_range: f32,
}

impl Lighting {
    /// The scene's lights, or the rig if it has none.
    pub(super) fn new(lights: &[Light], camera: &Camera) -> Self {
        if lights.is_empty() {
            return Self::rig(camera);
        }
        let mut lighting = Self { ambient: [0.0; 3], sky: None, sources: Vec::new() };
        for light in lights {
            let color = light.color.map(|c| c * light.intensity);
            let source = |place: Vec3, is_directional: bool, cone: Option<Cone>| Source {
                place: vec3::narrow(place),
                is_directional,
                color,
                cone,
                has_highlight: true,
                casts_shadows: true,
                shadow: None,
            };
            match light.kind {
                LightKind::Ambient => {
                    for (sum, c) in lighting.ambient.iter_mut().zip(color) {
                        *sum += c;
                    }
                }
                LightKind::Directional { direction } => {
                    let to_light = vec3::normalized(vec3::scale(direction, -1.0)).unwrap_or([0.0, 1.0, 0.0]);
                    lighting.sources.push(source(to_light, true, None));
                }
                LightKind::Point { position } => lighting.sources.push(source(position, false, None)),
                LightKind::Spot { position, direction, inner_angle, outer_angle } => {
                    let cone = Cone::new(direction, inner_angle, outer_angle);
                    lighting.sources.push(source(position, false, Some(cone)));
                }
            }
        }
        lighting
    }

    fn rig(camera: &Camera) -> Self {
        let [right, up, forward] = camera.right_up_forward();
        let from = |x: f64, y: f64, z: f64| {
            let sum = vec3::add(vec3::add(vec3::scale(right, x), vec3::scale(up, y)), vec3::scale(forward, -z));
            vec3::normalized(sum).unwrap_or([0.0, 1.0, 0.0])
        };
        // One set of shadows shows a shape; those of the weak lights would only stain it.
        let source = |to_light: Vec3, color: [f32; 3], has_highlight: bool| Source {
            place: vec3::narrow(to_light),
            is_directional: true,
            color,
            cone: None,
            has_highlight,
            casts_shadows: false,
            shadow: None,
        };
        let mut key = source(from(-0.5, 0.75, 0.8), [0.72, 0.695, 0.655], true);
        key.casts_shadows = true;
        let fill = source(from(0.9, 0.1, 0.55), [0.10, 0.12, 0.15], false);
        let rim = source(from(0.45, 0.55, -0.75), [0.28, 0.30, 0.34], true);
        let world_up = vec3::normalized(camera.up).unwrap_or(up);
        let sky = Sky::new(world_up, [0.26, 0.28, 0.305], [0.10, 0.095, 0.09]);
        Self { ambient: [0.0; 3], sky: Some(sky), sources: vec![key, fill, rim] }
    }
}

impl Sky {
    fn new(up: Vec3, above: [f32; 3], ground: [f32; 3]) -> Self {
        Self {
            up: vec3::narrow(up),
            mean: std::array::from_fn(|c| 0.5 * (above[c] + ground[c])),
            slope: std::array::from_fn(|c| 0.5 * (above[c] - ground[c])),
        }
    }
}

impl Cone {
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    fn new(direction: Vec3, inner: f64, outer: f64) -> Self {
        let half_turn = std::f64::consts::PI;
        let within = |angle: f64| if angle.is_nan() { 0.0 } else { angle.clamp(0.0, half_turn) };
        let (cos_inner, cos_outer) = (libm::cos(within(inner.min(outer))), libm::cos(within(outer)));
        // A hard edge is a very steep one.
        let range = (cos_inner - cos_outer).max(1e-4);
        Self {
            axis: vec3::narrow(vec3::normalized(direction).unwrap_or([0.0, -1.0, 0.0])),
            cos_outer: cos_outer as f32,
            outer_angle: within(outer),
            inverse_range: (1.0 / range) as f32,
        }
    }
}
