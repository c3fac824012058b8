//! Light sources, in world space and linear light.

use crate::math::vec3::Vec3;

/// A light source.
///
/// A surface receives `color * intensity * attenuation`, where [`LightKind`] states the attenuation.
#[derive(Clone, Debug, PartialEq)]
pub struct Light {
    /// Where the light comes from.
    pub kind: LightKind,
    /// Linear RGB; usually within 0..=1, with the strength in `intensity`.
    pub color: [f32; 3],
    /// Strength: for point and spot lights what a surface at distance 1 receives, else what any surface receives.
    pub intensity: f32,
}

/// The geometry of a light; positions and directions are in world space, directions need not be unit vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum LightKind {
    /// Reaches every surface from everywhere; no attenuation. Multiplies the material's ambient reflectance.
    Ambient,
    /// Parallel light, as from the sun; no attenuation.
    Directional {
        /// The way the light travels, from the source towards the scene.
        direction: Vec3,
    },
    /// Light from one point in all directions; attenuation `1 / distance^2`.
    Point {
        /// The position of the source.
        position: Vec3,
    },
    /// Light from one point within a cone; attenuation `1 / distance^2` times the cone's falloff: 1 inside the inner
    /// angle, 0 outside the outer one, between them smooth in the cosine of the angle.
    Spot {
        /// The position of the source.
        position: Vec3,
        /// The axis of the cone, from the source towards the scene.
        direction: Vec3,
        /// Half-angle of the fully lit cone, in radians.
        inner_angle: f64,
        /// Half-angle of the whole cone, in radians; at least `inner_angle`.
        outer_angle: f64,
    },
}

impl Light {
    /// A white light of the given kind and strength.
    #[must_use]
    pub fn new(kind: LightKind, intensity: f32) -> Self {
        Self { kind, color: [1.0; 3], intensity }
    }

    /// The same light in another color (linear RGB).
    #[must_use]
    pub fn with_color(self, color: [f32; 3]) -> Self {
        Self { color, ..self }
    }
}
