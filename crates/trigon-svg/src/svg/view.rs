//! Which part of a document becomes a picture, and how large.

use super::bounds::to_u32;
use crate::canvas::Transform;

/// How large the picture is, in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Size {
    /// As the document says, rounded up.
    #[default]
    Document,
    /// This wide; the height follows.
    Width(u32),
    /// This high; the width follows.
    Height(u32),
    /// As large as fits into this; the rest of the picture is empty, half of it on each side.
    Inside(u32, u32),
    /// So large that it fills this; what sticks out is cut off, half of it on each side.
    Cover(u32, u32),
    /// The document's size times this.
    Zoom(f32),
}

/// What of the document is drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Area {
    /// The page: the `svg` element's viewport.
    #[default]
    Page,
    /// What is drawn on: the bounding box of all that is visible, strokes and filters included.
    Drawing,
    /// This rectangle of user space: left, top, width, height.
    Rect([f32; 4]),
}

/// A part of a document as a picture.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct View {
    /// How large.
    pub size: Size,
    /// What part.
    pub area: Area,
    /// Only the element of this id, instead of all. The area [`Drawing`](Area::Drawing) is then that of the element.
    pub id: Option<String>,
}

/// The picture's size, and the map from user space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Fitted {
    pub(super) width: u32,
    pub(super) height: u32,
    pub(super) pixels_from_user: Transform,
}

impl Size {
    /// Fits the rectangle [left, top, width, height] of user space; `None` where it or the picture has no extent.
    pub(super) fn fit(self, [left, top, width, height]: [f64; 4]) -> Option<Fitted> {
        let is_positive = |length: f64| length > 0.0 && length.is_finite();
        if !is_positive(width) || !is_positive(height) {
            return None;
        }
        let (natural_width, natural_height) = (whole(width), whole(height));
        let ratio = natural_height / natural_width;
        let picture = match self {
            Self::Document => [natural_width, natural_height],
            Self::Width(w) => [f64::from(w), whole(f64::from(w) * ratio)],
            Self::Height(h) => [whole(f64::from(h) / ratio), f64::from(h)],
            Self::Inside(w, h) | Self::Cover(w, h) => [f64::from(w), f64::from(h)],
            Self::Zoom(zoom) => [whole(width * f64::from(zoom)), whole(height * f64::from(zoom))],
        };
        let [mut scale_x, mut scale_y] = [picture[0] / width, picture[1] / height];
        if matches!(self, Self::Inside(..)) {
            let scale = scale_x.min(scale_y);
            (scale_x, scale_y) = (scale, scale);
        } else if matches!(self, Self::Cover(..)) {
            let scale = scale_x.max(scale_y);
            (scale_x, scale_y) = (scale, scale);
        }
        let margin = |picture: f64, length: f64| (picture - length) / 2.0;
        let to_middle = Transform::translate(margin(picture[0], width * scale_x), margin(picture[1], height * scale_y));
        let pixels_from_user = to_middle * Transform::scale(scale_x, scale_y) * Transform::translate(-left, -top);
        let [width, height] = picture.map(to_u32);
        (width > 0 && height > 0).then_some(Fitted { width, height, pixels_from_user })
    }
}

/// Rounded up, at least 1; what f32 arithmetic upstream left just above a whole number is that number.
fn whole(length: f64) -> f64 {
    (length - 1e-4).ceil().max(1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(size: Size, width: f64, height: f64) -> (u32, u32) {
        let fitted = size.fit([0.0, 0.0, width, height]).unwrap();
        (fitted.width, fitted.height)
    }

    #[test]
    fn sizes_follow_the_aspect_ratio() {
        assert_eq!(size(Size::Document, 200.0, 100.2), (200, 101));
        assert_eq!(size(Size::Width(300), 200.0, 150.0), (300, 225));
        assert_eq!(size(Size::Height(300), 200.0, 150.0), (400, 300));
        assert_eq!(size(Size::Zoom(1.5), 101.0, 50.0), (152, 75));
        assert_eq!(size(Size::Inside(500, 100), 101.0, 50.0), (500, 100));
    }

    #[test]
    fn what_does_not_fill_the_picture_is_centred() {
        let fitted = Size::Inside(400, 100).fit([10.0, 20.0, 50.0, 50.0]).unwrap();
        assert_eq!(fitted.pixels_from_user.apply([10.0, 20.0]), [150.0, 0.0]);
        assert_eq!(fitted.pixels_from_user.apply([60.0, 70.0]), [250.0, 100.0]);
        let fitted = Size::Cover(400, 100).fit([10.0, 20.0, 50.0, 50.0]).unwrap();
        assert_eq!((fitted.width, fitted.height), (400, 100));
        assert_eq!(fitted.pixels_from_user.apply([10.0, 20.0]), [0.0, -150.0]);
        assert_eq!(fitted.pixels_from_user.apply([60.0, 70.0]), [400.0, 250.0]);
    }

    #[test]
    fn nothing_fits_into_nothing() {
        assert_eq!(Size::Document.fit([0.0, 0.0, 0.0, 5.0]), None);
        assert_eq!(Size::Width(0).fit([0.0, 0.0, 5.0, 5.0]), None);
        assert_eq!(Size::Document.fit([0.0, 0.0, f64::NAN, 5.0]), None);
    }
}
