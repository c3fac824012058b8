//! How a path is stroked: width, ends, corners, dashes.

/// The shape of a stroke, in the units of the path (before its transform).
#[derive(Clone, PartialEq, Debug)]
pub struct Stroke {
    /// Width, centred on the path. A stroke of width 0, negative or not finite draws nothing. One that is thinner
    /// than two columns of samples after the transform (half a pixel with 16 samples, at most a pixel) is drawn so wide,
    /// and fainter by as much: a line without gaps.
    pub width: f32,
    /// The form of open ends.
    pub cap: Cap,
    /// The form of corners.
    pub join: Join,
    /// Lengths of dashes and gaps in turn, beginning with a dash; an odd number of them is taken twice. Empty, or with a
    /// negative length, or of sum 0: a solid line.
    pub dashes: Vec<f32>,
    /// Where in the dashes the path begins.
    pub dash_offset: f32,
}

/// The form of open ends (SVG 2, `stroke-linecap`).
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Cap {
    /// Cut at the end point.
    #[default]
    Butt,
    /// A half circle round the end point.
    Round,
    /// Longer by half of the width.
    Square,
}

/// The form of corners (SVG 2, `stroke-linejoin`).
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Join {
    /// The outer edges prolonged until they meet; a bevel where the length of the point is over `limit` widths.
    Miter {
        /// Longest point, in widths; at least 1.
        limit: f32,
    },
    /// As `Miter`, but a longer point is cut at the limit instead.
    MiterClip {
        /// Longest point, in widths; at least 1.
        limit: f32,
    },
    /// A circle round the corner.
    Round,
    /// A straight cut.
    Bevel,
}

impl Stroke {
    /// A solid stroke with SVG's defaults: butt ends, mitered corners with limit 4.
    #[must_use]
    pub fn new(width: f32) -> Self {
        Self { width, cap: Cap::Butt, join: Join::Miter { limit: 4.0 }, dashes: Vec::new(), dash_offset: 0.0 }
    }

    /// The same with another form of ends.
    #[must_use]
    pub fn with_cap(self, cap: Cap) -> Self {
        Self { cap, ..self }
    }

    /// The same with another form of corners.
    #[must_use]
    pub fn with_join(self, join: Join) -> Self {
        Self { join, ..self }
    }

    /// The same with dashes.
    #[must_use]
    pub fn with_dashes(self, dashes: &[f32], dash_offset: f32) -> Self {
        Self { dashes: dashes.to_vec(), dash_offset, ..self }
    }
}
