//! Contours as polylines without repeated points, ready to be stroked.

use crate::engine::flatten::LineSink;

/// One point of a polyline.
#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) struct Vertex {
    pub(super) point: [f64; 2],
    /// False within a curve, whose turns are always rounded off.
    pub(super) is_corner: bool,
}

/// A contour of straight lines; consecutive points differ. A single point stands for a line of no length.
#[derive(Clone, PartialEq, Debug, Default)]
pub(super) struct Polyline {
    pub(super) vertices: Vec<Vertex>,
    /// A segment leads from the last vertex to the first.
    pub(super) is_closed: bool,
}

impl Polyline {
    /// Empties it, keeping the memory.
    pub(super) fn clear(&mut self) {
        self.vertices.clear();
        self.is_closed = false;
    }

    /// Adds a vertex, unless it repeats the last one: then a corner stays a corner.
    pub(super) fn push(&mut self, vertex: Vertex) {
        match self.vertices.last_mut() {
            Some(last) if last.point == vertex.point => last.is_corner |= vertex.is_corner,
            _ => self.vertices.push(vertex),
        }
    }

    /// The segments' ends, the closing one included.
    pub(super) fn segments(&self) -> impl Iterator<Item = (Vertex, Vertex)> + '_ {
        let closing = self.vertices.last().copied().zip(self.vertices.first().copied());
        let closing = closing.filter(|_| self.is_closed && self.vertices.len() > 1);
        self.vertices.windows(2).map(|pair| (pair[0], pair[1])).chain(closing)
    }
}

/// Collects the lines of a path. Reused from path to path, for its memory.
#[derive(Default)]
pub(super) struct PolylineSink {
    /// The first `count` of them are done; the next one is open.
    lines: Vec<Polyline>,
    count: usize,
    is_in_curve: bool,
    /// A segment was drawn since the last move, even if of no length.
    has_segment: bool,
}

impl PolylineSink {
    /// Forgets the last path.
    pub(super) fn restart(&mut self) {
        self.count = 0;
        self.is_in_curve = false;
        self.has_segment = false;
        self.open().clear();
    }

    /// The contours that have at least one segment.
    pub(super) fn finish(&mut self) -> &[Polyline] {
        self.end_contour(false);
        &self.lines[..self.count]
    }

    fn open(&mut self) -> &mut Polyline {
        if self.lines.len() == self.count {
            self.lines.push(Polyline::default());
        }
        &mut self.lines[self.count]
    }

    fn end_contour(&mut self, is_closed: bool) {
        let has_segment = core::mem::take(&mut self.has_segment);
        let line = self.open();
        if has_segment && !line.vertices.is_empty() {
            line.is_closed = is_closed;
            if is_closed
                && line.vertices.len() > 1
                && line.vertices.first().map(|v| v.point) == line.vertices.last().map(|v| v.point)
            {
                line.vertices.pop();
            }
            self.count += 1;
        }
        self.open().clear();
    }
}

impl LineSink for PolylineSink {
    fn move_to(&mut self, point: [f64; 2]) {
        self.end_contour(false);
        self.open().push(Vertex { point, is_corner: true });
    }

    fn line_to(&mut self, point: [f64; 2]) {
        self.has_segment = true;
        let is_corner = !self.is_in_curve;
        self.open().push(Vertex { point, is_corner });
    }

    fn close(&mut self) {
        self.has_segment = true;
        self.end_contour(true);
    }

    fn curve(&mut self, begins: bool) {
        self.is_in_curve = begins;
    }
}
