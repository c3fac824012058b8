//! Pictures put together from pictures: placed, laid over each other, enlarged.

use trigon_image::Rgba8Image;

/// Lays `over` on `picture`, its top left corner at `place`; what does not fit is cut off.
pub(crate) fn lay_over(picture: &mut Rgba8Image, over: &Rgba8Image, place: [u32; 2]) {
    let [left, top] = place;
    let width = over.width().min(picture.width().saturating_sub(left));
    let height = over.height().min(picture.height().saturating_sub(top));
    for y in 0..height {
        for x in 0..width {
            let below = picture.pixel(left + x, top + y);
            picture.set_pixel(left + x, top + y, blended(over.pixel(x, y), below));
        }
    }
}

/// One straight colour over another, sRGB-encoded as pictures on a page are.
fn blended(over: [u8; 4], below: [u8; 4]) -> [u8; 4] {
    let [alpha, below_alpha] = [u32::from(over[3]), u32::from(below[3])];
    if alpha == 255 || below_alpha == 0 {
        return over;
    }
    let rest = below_alpha * (255 - alpha);
    let whole = alpha * 255 + rest;
    let mix = |c: usize| (u32::from(over[c]) * alpha * 255 + u32::from(below[c]) * rest + whole / 2) / whole;
    let narrow = |value: u32| u8::try_from(value).unwrap_or(u8::MAX);
    [narrow(mix(0)), narrow(mix(1)), narrow(mix(2)), narrow((whole + 127) / 255)]
}

/// Part of a picture with each pixel a square of `scale` pixels; transparent outside of the picture.
pub(crate) fn enlarged(
    picture: &Rgba8Image,
    [left, top]: [i64; 2],
    [width, height]: [u32; 2],
    scale: u32,
) -> Rgba8Image {
    let mut out = Rgba8Image::new(width * scale, height * scale);
    for y in 0..height * scale {
        for x in 0..width * scale {
            let column = u32::try_from(left + i64::from(x / scale)).ok().filter(|x| *x < picture.width());
            let row = u32::try_from(top + i64::from(y / scale)).ok().filter(|y| *y < picture.height());
            if let (Some(column), Some(row)) = (column, row) {
                out.set_pixel(x, y, picture.pixel(column, row));
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opaque_covers_and_transparent_does_not() {
        let below = [10, 20, 30, 255];
        assert_eq!(blended([1, 2, 3, 255], below), [1, 2, 3, 255]);
        assert_eq!(blended([1, 2, 3, 0], below), below);
        assert_eq!(blended([255, 255, 255, 128], [0, 0, 0, 255]), [128, 128, 128, 255]);
        assert_eq!(blended([9, 9, 9, 77], [0, 0, 0, 0]), [9, 9, 9, 77]);
    }

    #[test]
    fn parts_are_enlarged_and_empty_outside() {
        let mut picture = Rgba8Image::filled(2, 2, [1, 1, 1, 255]);
        picture.set_pixel(1, 1, [5, 6, 7, 255]);
        let part = enlarged(&picture, [1, 1], [2, 2], 3);
        assert_eq!((part.width(), part.height()), (6, 6));
        assert_eq!((part.pixel(2, 2), part.pixel(3, 0)), ([5, 6, 7, 255], [0; 4]));
        assert_eq!(enlarged(&picture, [-1, 0], [1, 1], 1).pixel(0, 0), [0; 4]);
    }
}
