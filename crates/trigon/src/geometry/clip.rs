//! Clipping in homogeneous space, for the few triangles that cross the near plane or leave the guard band.
//!
//! In: three clip positions. Out: the convex polygon inside, each corner with its weights. Sutherland and Hodgman,
//! "Reentrant Polygon Clipping" (1974). An edge is always cut from its inner end, in f64, so that the two triangles
//! that share it get the same new vertex and no crack opens.

use super::project::Viewport;

/// A corner of the clipped polygon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ClipVertex {
    /// Clip position.
    pub(crate) position: [f64; 4],
    /// Weights of vertices 1 and 2 of the primitive.
    pub(crate) weights: [f64; 2],
}

/// At most three corners, plus one per plane.
const MAX_CORNERS: usize = 9;

/// Half-spaces `dot(plane, position) >= 0` in clip space.
pub(crate) struct ClipPlanes([[f64; 4]; 6]);

impl ClipPlanes {
    /// The near plane, w > 0, and a band a pixel inside the guard band, `margin_px` less wide.
    pub(crate) fn new(viewport: Viewport, margin_px: f64) -> Self {
        let band = 16_383.0 - margin_px;
        let (w, h) = (f64::from(viewport.width), f64::from(viewport.height));
        // Framebuffer x = (ndc + 1) * w / 2, so ndc = 2 x / w - 1; y is mirrored.
        let (left, right) = (-2.0 * band / w - 1.0, 2.0 * band / w - 1.0);
        let (below, above) = (1.0 - 2.0 * band / h, 1.0 + 2.0 * band / h);
        Self([
            [0.0, 0.0, -1.0, 1.0],
            [0.0, 0.0, 0.0, 1.0],
            [1.0, 0.0, 0.0, -left],
            [-1.0, 0.0, 0.0, right],
            [0.0, 1.0, 0.0, -below],
            [0.0, -1.0, 0.0, above],
        ])
    }
}

/// A convex polygon of a few corners.
#[derive(Clone, Copy)]
pub(crate) struct Polygon {
    corners: [ClipVertex; MAX_CORNERS],
    len: usize,
}

impl Polygon {
    fn new() -> Self {
        Self { corners: [ClipVertex { position: [0.0; 4], weights: [0.0; 2] }; MAX_CORNERS], len: 0 }
    }

    fn push(&mut self, corner: ClipVertex) {
        // A convex polygon gains at most one corner per plane; rounding cannot make it concave enough for more.
        if self.len < MAX_CORNERS {
            self.corners[self.len] = corner;
            self.len += 1;
        }
    }

    /// The corners, in order.
    pub(crate) fn corners(&self) -> &[ClipVertex] {
        &self.corners[..self.len]
    }
}

/// The part of a triangle inside every plane; fewer than three corners if none.
pub(crate) fn clip_triangle(positions: [[f32; 4]; 3], planes: &ClipPlanes) -> Polygon {
    let weights = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    let mut polygon = Polygon::new();
    for (position, weights) in positions.into_iter().zip(weights) {
        polygon.push(ClipVertex { position: position.map(f64::from), weights });
    }
    for plane in &planes.0 {
        polygon = clip_by(&polygon, plane);
    }
    polygon
}

/// The part of a segment inside every plane, as parameters along it; `None` if empty.
pub(crate) fn clip_segment(ends: [[f32; 4]; 2], planes: &ClipPlanes) -> Option<[ClipVertex; 2]> {
    let [a, b] = ends.map(|end| end.map(f64::from));
    let (mut t0, mut t1) = (0.0f64, 1.0f64);
    for plane in &planes.0 {
        let (da, db) = (distance(plane, &a), distance(plane, &b));
        if !(da >= 0.0 || db >= 0.0) {
            return None;
        }
        if da < 0.0 {
            t0 = t0.max(da / (da - db));
        } else if db < 0.0 {
            t1 = t1.min(da / (da - db));
        }
    }
    let at = |t: f64| ClipVertex { position: core::array::from_fn(|i| a[i] + t * (b[i] - a[i])), weights: [t, 0.0] };
    (t0 <= t1).then(|| [at(t0), at(t1)])
}

fn clip_by(polygon: &Polygon, plane: &[f64; 4]) -> Polygon {
    let mut out = Polygon::new();
    let corners = polygon.corners();
    for (i, a) in corners.iter().enumerate() {
        let b = &corners[(i + 1) % corners.len()];
        let (da, db) = (distance(plane, &a.position), distance(plane, &b.position));
        if da >= 0.0 {
            out.push(*a);
        }
        if (da >= 0.0) != (db >= 0.0) {
            out.push(if da >= 0.0 { cut(a, b, da, db) } else { cut(b, a, db, da) });
        }
    }
    out
}

/// The point of the edge on the plane, measured from the inner end.
fn cut(inner: &ClipVertex, outer: &ClipVertex, d_inner: f64, d_outer: f64) -> ClipVertex {
    let t = d_inner / (d_inner - d_outer);
    let mix = |a: f64, b: f64| a + t * (b - a);
    ClipVertex {
        position: core::array::from_fn(|i| mix(inner.position[i], outer.position[i])),
        weights: core::array::from_fn(|i| mix(inner.weights[i], outer.weights[i])),
    }
}

fn distance(plane: &[f64; 4], p: &[f64; 4]) -> f64 {
    ((plane[0] * p[0] + plane[1] * p[1]) + plane[2] * p[2]) + plane[3] * p[3]
}

#[cfg(test)]
mod tests {
    use super::*;

    const VIEWPORT: Viewport = Viewport { width: 640, height: 480 };

    #[test]
    fn a_triangle_inside_is_unchanged() {
        let positions = [[0.0, 0.0, 0.5, 1.0], [0.5, 0.0, 0.5, 1.0], [0.0, 0.5, 0.5, 1.0]];
        let polygon = clip_triangle(positions, &ClipPlanes::new(VIEWPORT, 0.0));
        let corners: Vec<[f64; 4]> = polygon.corners().iter().map(|c| c.position).collect();
        assert_eq!(corners, positions.map(|p| p.map(f64::from)));
    }

    #[test]
    fn a_triangle_behind_the_eye_vanishes() {
        let positions = [[0.0, 0.0, 0.1, -1.0], [0.5, 0.0, 0.1, -1.0], [0.0, 0.5, 0.1, -2.0]];
        assert!(clip_triangle(positions, &ClipPlanes::new(VIEWPORT, 0.0)).corners().len() < 3);
    }

    #[test]
    fn a_shared_edge_is_cut_at_one_point() {
        let planes = ClipPlanes::new(VIEWPORT, 0.0);
        let (a, b) = ([0.3, 0.1, 0.1, 3.7], [0.7, -0.2, 0.1, -0.9]);
        let one = clip_triangle([a, b, [0.0, 2.0, 0.1, 5.0]], &planes);
        let two = clip_triangle([b, a, [0.0, -2.0, 0.1, 5.0]], &planes);
        let shared = one.corners().iter().filter(|c| two.corners().iter().any(|d| d.position == c.position)).count();
        assert_eq!(shared, 2, "the inner end and the cut");
    }

    #[test]
    fn weights_reproduce_positions() {
        let positions = [[0.3, 0.1, 0.1, 3.7], [900.0, -0.2, 0.1, 0.9], [0.0, 2.0, 0.1, -5.0]];
        let polygon = clip_triangle(positions, &ClipPlanes::new(VIEWPORT, 0.0));
        assert!(polygon.corners().len() >= 3);
        for corner in polygon.corners() {
            let [w1, w2] = corner.weights;
            for i in 0..4 {
                let p = positions.map(|p| f64::from(p[i]));
                let rebuilt = (1.0 - w1 - w2) * p[0] + w1 * p[1] + w2 * p[2];
                assert!((rebuilt - corner.position[i]).abs() < 1e-9 * (1.0 + rebuilt.abs()));
            }
        }
    }

    #[test]
    fn a_segment_is_cut_at_the_near_plane() {
        let ends = [[0.0, 0.0, 0.1, 2.0], [0.0, 0.0, 0.1, -2.0]];
        let [a, b] = clip_segment(ends, &ClipPlanes::new(VIEWPORT, 0.0)).unwrap();
        assert_eq!(a.weights, [0.0, 0.0]);
        assert!((b.position[3] - 0.1).abs() < 1e-6, "{b:?}");
    }
}
