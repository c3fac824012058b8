//! Axis-aligned bounding boxes: points in, the smallest box out.

use super::vec3::{self, Vec3};

/// The smallest axis-aligned box around a set of points; both corners are inclusive.
///
/// Invariant: `min <= max` on each axis, or the box is [`Aabb::EMPTY`]. Points that are not finite are never inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Aabb {
    /// The corner with the least coordinates.
    pub min: [f32; 3],
    /// The corner with the greatest coordinates.
    pub max: [f32; 3],
}

impl Aabb {
    /// The box around no point: `min` is +infinity, `max` is -infinity.
    pub const EMPTY: Self = Self { min: [f32::INFINITY; 3], max: [f32::NEG_INFINITY; 3] };

    /// The box around the finite ones of `points`.
    #[must_use]
    pub fn from_points<'a>(points: impl IntoIterator<Item = &'a [f32; 3]>) -> Self {
        let mut aabb = Self::EMPTY;
        for &point in points {
            aabb.insert(point);
        }
        aabb
    }

    /// Grows the box to hold `point`; a point that is not finite is ignored.
    pub fn insert(&mut self, point: [f32; 3]) {
        if !point.iter().all(|c| c.is_finite()) {
            return;
        }
        for ((min, max), coordinate) in self.min.iter_mut().zip(&mut self.max).zip(point) {
            if coordinate < *min {
                *min = coordinate;
            }
            if coordinate > *max {
                *max = coordinate;
            }
        }
    }

    /// The smallest box that holds both.
    #[must_use]
    pub fn union(mut self, other: Self) -> Self {
        if !other.is_empty() {
            self.insert(other.min);
            self.insert(other.max);
        }
        self
    }

    /// Whether the box holds no point.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.min[0] > self.max[0]
    }

    /// The midpoint; the origin for an empty box.
    #[must_use]
    pub fn center(&self) -> Vec3 {
        if self.is_empty() {
            return [0.0; 3];
        }
        vec3::scale(vec3::add(vec3::widen(self.min), vec3::widen(self.max)), 0.5)
    }

    /// The edge lengths; zero for an empty box.
    #[must_use]
    pub fn size(&self) -> Vec3 {
        if self.is_empty() {
            return [0.0; 3];
        }
        vec3::sub(vec3::widen(self.max), vec3::widen(self.min))
    }

    /// Half the diagonal: the radius of the sphere about the center through the corners.
    #[must_use]
    pub fn radius(&self) -> f64 {
        0.5 * vec3::length(self.size())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ignores_points_that_are_not_finite() {
        let aabb = Aabb::from_points(&[[0.0, 1.0, 2.0], [f32::NAN, 0.0, 0.0], [f32::INFINITY; 3], [-1.0, 5.0, 2.0]]);
        assert_eq!(aabb, Aabb { min: [-1.0, 1.0, 2.0], max: [0.0, 5.0, 2.0] });
        assert!(Aabb::from_points(&[]).is_empty());
        assert_eq!(aabb.union(Aabb::EMPTY), aabb);
        assert_eq!(Aabb::EMPTY.union(aabb), aabb);
    }
}
