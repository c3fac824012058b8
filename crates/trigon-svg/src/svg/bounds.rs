//! Rectangles of user space as rectangles of pixels.

use crate::canvas::{PixelRect, Transform};

/// The pixels that stand for a rectangle: `left`, `top`, `width`, `height` in user space.
///
/// Position rounds down, size rounds up and is at least 1: the rule that SVG filters are drawn with elsewhere, so that a
/// region of whole size never grows by a pixel because it starts between two.
pub(super) fn pixel_rect([left, top, width, height]: [f64; 4], pixels_from_user: &Transform) -> PixelRect {
    let (mut least, mut most) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
    for corner in [[left, top], [left + width, top], [left, top + height], [left + width, top + height]] {
        let point = pixels_from_user.apply(corner);
        for axis in 0..2 {
            least[axis] = least[axis].min(point[axis]);
            most[axis] = most[axis].max(point[axis]);
        }
    }
    let length = |axis: usize| to_u32(snapped(most[axis] - least[axis]).ceil()).max(1);
    PixelRect {
        x: to_i32(snapped(least[0]).floor()),
        y: to_i32(snapped(least[1]).floor()),
        width: length(0),
        height: length(1),
    }
}

/// A number that f32 arithmetic upstream left within 1/1000 of a whole one, as that.
fn snapped(x: f64) -> f64 {
    let nearest = (x + 0.5).floor();
    if (x - nearest).abs() < 1e-3 { nearest } else { x }
}

/// The common part; `None` where there is none.
pub(super) fn intersect(a: PixelRect, b: PixelRect) -> Option<PixelRect> {
    let (left, top) = (a.x.max(b.x), a.y.max(b.y));
    let end = |start: i32, length: u32| i64::from(start) + i64::from(length);
    let right = end(a.x, a.width).min(end(b.x, b.width));
    let bottom = end(a.y, a.height).min(end(b.y, b.height));
    let width = u32::try_from(right - i64::from(left)).ok().filter(|width| *width > 0)?;
    let height = u32::try_from(bottom - i64::from(top)).ok().filter(|height| *height > 0)?;
    Some(PixelRect { x: left, y: top, width, height })
}

/// Grown by (`dx`, `dy`) on each side, saturating.
pub(super) fn grown(rect: PixelRect, dx: u32, dy: u32) -> PixelRect {
    let start = |at: i32, by: u32| at.saturating_sub_unsigned(by);
    let length = |length: u32, by: u32| length.saturating_add(by.saturating_mul(2));
    PixelRect {
        x: start(rect.x, dx),
        y: start(rect.y, dy),
        width: length(rect.width, dx),
        height: length(rect.height, dy),
    }
}

#[expect(clippy::cast_possible_truncation, reason = "casts from float saturate")]
pub(super) fn to_i32(x: f64) -> i32 {
    x as i32
}

#[expect(clippy::cast_possible_truncation, reason = "casts from float saturate")]
#[expect(clippy::cast_sign_loss, reason = "casts from float saturate")]
pub(super) fn to_u32(x: f64) -> u32 {
    x as u32
}

/// `usvg`'s rectangle as left, top, width, height.
pub(super) fn numbers(rect: usvg::NonZeroRect) -> [f64; 4] {
    [rect.x(), rect.y(), rect.width(), rect.height()].map(f64::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn position_rounds_down_and_size_up() {
        let rect = pixel_rect([1.5, -0.5, 10.0, 10.2], &Transform::IDENTITY);
        assert_eq!(rect, PixelRect { x: 1, y: -1, width: 10, height: 11 });
        let hostile = pixel_rect([-1e30, 0.0, 1e30, 1e-9], &Transform::scale(1e5, 1.0));
        assert_eq!((hostile.x, hostile.width, hostile.height), (i32::MIN, u32::MAX, 1));
    }

    #[test]
    fn parts_in_common() {
        let a = PixelRect { x: -5, y: 0, width: 10, height: 10 };
        let b = PixelRect { x: 2, y: -3, width: u32::MAX, height: 5 };
        assert_eq!(intersect(a, b), Some(PixelRect { x: 2, y: 0, width: 3, height: 2 }));
        assert_eq!(intersect(a, PixelRect { x: 5, ..b }), None);
        assert_eq!(grown(a, 2, 1), PixelRect { x: -7, y: -1, width: 14, height: 12 });
    }
}
