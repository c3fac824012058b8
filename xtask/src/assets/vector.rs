//! Vectors of two and three `f64`, and rigid motions: as much as the generator needs.

/// Position or direction: x right, y up, z towards the viewer.
pub(crate) type V3 = [f64; 3];
/// Texture coordinate, or a point of a profile curve.
pub(crate) type V2 = [f64; 2];

pub(crate) fn add(a: V3, b: V3) -> V3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(crate) fn sub(a: V3, b: V3) -> V3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn scale(a: V3, factor: f64) -> V3 {
    [a[0] * factor, a[1] * factor, a[2] * factor]
}

pub(crate) fn dot(a: V3, b: V3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: V3, b: V3) -> V3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn length(a: V3) -> f64 {
    dot(a, a).sqrt()
}

/// `a` at length one; a vector too short to have a direction stays as it is.
pub(crate) fn normalize(a: V3) -> V3 {
    let length = length(a);
    if length > 1e-12 { scale(a, 1.0 / length) } else { a }
}

pub(crate) fn lerp(a: f64, b: f64, t: f64) -> f64 {
    a + (b - a) * t
}

/// 0 up to `low`, 1 from `high` on, a smooth cubic in between.
pub(crate) fn smoothstep(low: f64, high: f64, x: f64) -> f64 {
    let t = ((x - low) / (high - low)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

/// Where an object stands: scaled, turned about x, then about y, then moved.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Placement {
    scale: f64,
    pitch: (f64, f64),
    yaw: (f64, f64),
    position: V3,
}

impl Placement {
    /// At `position`, in its own size and direction.
    pub(crate) fn at(position: V3) -> Self {
        Self { scale: 1.0, pitch: (0.0, 1.0), yaw: (0.0, 1.0), position }
    }

    pub(crate) fn scaled(self, scale: f64) -> Self {
        Self { scale, ..self }
    }

    /// Turned about the x axis: a positive angle tips the top towards the viewer.
    pub(crate) fn pitched(self, degrees: f64) -> Self {
        Self { pitch: libm::sincos(degrees.to_radians()), ..self }
    }

    /// Turned about the y axis, counter-clockwise seen from above.
    pub(crate) fn turned(self, degrees: f64) -> Self {
        Self { yaw: libm::sincos(degrees.to_radians()), ..self }
    }

    pub(crate) fn point(&self, p: V3) -> V3 {
        add(self.direction(scale(p, self.scale)), self.position)
    }

    pub(crate) fn direction(&self, d: V3) -> V3 {
        let (s, c) = self.pitch;
        let d = [d[0], c * d[1] - s * d[2], s * d[1] + c * d[2]];
        let (s, c) = self.yaw;
        [c * d[0] + s * d[2], d[1], c * d[2] - s * d[0]]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_quarter_turn_takes_x_to_minus_z() {
        let turned = Placement::at([0.0; 3]).turned(90.0).direction([1.0, 0.0, 0.0]);
        assert!(length(sub(turned, [0.0, 0.0, -1.0])) < 1e-12);
        let pitched = Placement::at([0.0; 3]).pitched(90.0).direction([0.0, 1.0, 0.0]);
        assert!(length(sub(pitched, [0.0, 0.0, 1.0])) < 1e-12);
    }
}
