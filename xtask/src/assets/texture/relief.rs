//! Distances to outlines, and raised shapes made of them.

/// The distance inside a star of two squares, one upright, one standing on a corner; negative outside.
pub(crate) fn star(x: f64, y: f64, half: f64) -> f64 {
    let upright = half - x.abs().max(y.abs());
    let turned = half - (x.abs() + y.abs()) * std::f64::consts::FRAC_1_SQRT_2;
    upright.max(turned)
}

/// 0 outside, 1 where the outline is at least `bevel` away, a straight slope between.
pub(crate) fn raised(inside: f64, bevel: f64) -> f64 {
    (inside / bevel).clamp(0.0, 1.0)
}

/// The distance of (x, y) from the segment between `a` and `b`.
pub(crate) fn segment(x: f64, y: f64, a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    let along = (((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    let (rx, ry) = (x - a[0] - along * dx, y - a[1] - along * dy);
    (rx * rx + ry * ry).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_star_has_eight_points() {
        let half = 0.5;
        let tip = half * std::f64::consts::SQRT_2;
        for eighth in 0..8 {
            let (sin, cos) = libm::sincos(f64::from(eighth) * std::f64::consts::FRAC_PI_4);
            assert!(star(0.98 * tip * cos, 0.98 * tip * sin, half) > 0.0);
            assert!(star(1.02 * tip * cos, 1.02 * tip * sin, half) < 0.0);
            let (sin, cos) = libm::sincos((f64::from(eighth) + 0.5) * std::f64::consts::FRAC_PI_4);
            assert!(star(0.8 * tip * cos, 0.8 * tip * sin, half) < 0.0);
        }
    }

    #[test]
    fn segments_measure_to_their_ends() {
        assert!((segment(-3.0, 4.0, [0.0, 0.0], [1.0, 0.0]) - 5.0).abs() < 1e-12);
        assert!((segment(0.5, 2.0, [0.0, 0.0], [1.0, 0.0]) - 2.0).abs() < 1e-12);
    }
}
