//! Outlines: contours of lines and Bézier curves, and the rule that says what is inside.

/// Which winding numbers are inside.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum FillRule {
    /// All but zero.
    #[default]
    NonZero,
    /// Odd ones.
    EvenOdd,
}

/// One step along a contour; points are absolute.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum PathElement {
    /// Starts a contour.
    MoveTo([f32; 2]),
    /// A straight line to a point.
    LineTo([f32; 2]),
    /// A quadratic curve: control point, end.
    QuadTo([f32; 2], [f32; 2]),
    /// A cubic curve: two control points, end.
    CubicTo([f32; 2], [f32; 2], [f32; 2]),
    /// A line back to the start of the contour, joined there.
    Close,
}

/// A sequence of contours. To fill, open contours are closed by a line.
///
/// A contour that holds a coordinate which is not finite is not drawn.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Path {
    elements: Vec<PathElement>,
}

/// How far the control points of a quarter circle lie from its ends, of a radius of 1.
const QUARTER: f32 = 0.552_284_8;

impl Path {
    /// A path without contours.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The steps in order.
    #[must_use]
    pub fn elements(&self) -> &[PathElement] {
        &self.elements
    }

    /// Adds one step. A contour that does not begin with a move begins at the last contour's start, or at (0, 0).
    pub fn push(&mut self, element: PathElement) {
        self.elements.push(element);
    }

    /// Starts a contour.
    pub fn move_to(&mut self, x: f32, y: f32) -> &mut Self {
        self.elements.push(PathElement::MoveTo([x, y]));
        self
    }

    /// Adds a line.
    pub fn line_to(&mut self, x: f32, y: f32) -> &mut Self {
        self.elements.push(PathElement::LineTo([x, y]));
        self
    }

    /// Adds a quadratic curve with control point (x1, y1).
    pub fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) -> &mut Self {
        self.elements.push(PathElement::QuadTo([x1, y1], [x, y]));
        self
    }

    /// Adds a cubic curve with control points (x1, y1) and (x2, y2).
    pub fn cubic_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) -> &mut Self {
        self.elements.push(PathElement::CubicTo([x1, y1], [x2, y2], [x, y]));
        self
    }

    /// Closes the contour.
    pub fn close(&mut self) -> &mut Self {
        self.elements.push(PathElement::Close);
        self
    }

    /// A rectangle with its corner of least coordinates at (x, y).
    #[must_use]
    pub fn rect(x: f32, y: f32, width: f32, height: f32) -> Self {
        let (right, bottom) = (x + width, y + height);
        let mut path = Self::new();
        path.move_to(x, y).line_to(right, y).line_to(right, bottom).line_to(x, bottom).close();
        path
    }

    /// A circle, of four cubic curves.
    #[must_use]
    pub fn circle(x: f32, y: f32, radius: f32) -> Self {
        Self::ellipse(x, y, radius, radius)
    }

    /// An ellipse with its axes along x and y, of four cubic curves (off by 0.03 % of the radius at most).
    #[must_use]
    pub fn ellipse(x: f32, y: f32, radius_x: f32, radius_y: f32) -> Self {
        let (kx, ky) = (radius_x * QUARTER, radius_y * QUARTER);
        let (left, right, top, bottom) = (x - radius_x, x + radius_x, y - radius_y, y + radius_y);
        let mut path = Self::new();
        path.move_to(right, y)
            .cubic_to(right, y + ky, x + kx, bottom, x, bottom)
            .cubic_to(x - kx, bottom, left, y + ky, left, y)
            .cubic_to(left, y - ky, x - kx, top, x, top)
            .cubic_to(x + kx, top, right, y - ky, right, y)
            .close();
        path
    }

    /// A rectangle whose corners are quarters of circles of `radius`, at most half of the shorter side.
    #[must_use]
    pub fn round_rect(x: f32, y: f32, width: f32, height: f32, radius: f32) -> Self {
        let limit = if width < height { width * 0.5 } else { height * 0.5 };
        let r = if radius < limit { radius } else { limit };
        let (k, right, bottom) = (r * (1.0 - QUARTER), x + width, y + height);
        let mut path = Self::new();
        path.move_to(x + r, y)
            .line_to(right - r, y)
            .cubic_to(right - k, y, right, y + k, right, y + r)
            .line_to(right, bottom - r)
            .cubic_to(right, bottom - k, right - k, bottom, right - r, bottom)
            .line_to(x + r, bottom)
            .cubic_to(x + k, bottom, x, bottom - k, x, bottom - r)
            .line_to(x, y + r)
            .cubic_to(x, y + k, x + k, y, x + r, y)
            .close();
        path
    }
}

impl Extend<PathElement> for Path {
    fn extend<T: IntoIterator<Item = PathElement>>(&mut self, elements: T) {
        self.elements.extend(elements);
    }
}

impl FromIterator<PathElement> for Path {
    fn from_iter<T: IntoIterator<Item = PathElement>>(elements: T) -> Self {
        Self { elements: elements.into_iter().collect() }
    }
}
