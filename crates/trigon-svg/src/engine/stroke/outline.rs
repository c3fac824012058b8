//! One polyline to polygons: strips along it, wedges at corners, caps at ends.
//!
//! A strip is the outline of quads side by side, one per segment. At slight turns neighbours share the edge across the
//! line, which cancels, so the strip goes on; at others it ends and a wedge fills the outer side. Strips and wedges meet
//! at edges with the same ends, the point on the line included: after snapping they still leave no gap.

use super::polyline::{Polyline, Vertex};
use crate::canvas::{Cap, Join, Stroke, Transform};
use crate::engine::flatten::LineSink;

/// How often an arc is halved at most: a quarter of a circle of 16,000 px is then off by 0.02 px.
const MAX_HALVINGS: u32 = 9;

/// Most points that the arcs of one stroke have together; those after them are straight.
const MAX_ARC_POINTS: u32 = 1 << 22;

/// Draws strokes of one style.
pub(super) struct Outliner<'a, S> {
    cap: Cap,
    join: Join,
    radius: f64,
    /// How far caps reach beyond the ends of lines; the radius but for hairlines.
    reach: f64,
    /// Largest deviation, in path space.
    tolerance: f64,
    transform: &'a Transform,
    sink: &'a mut S,
    /// The strip at hand: its left side, and its right side, both from its start on.
    left: &'a mut Vec<[f64; 2]>,
    right: &'a mut Vec<[f64; 2]>,
    /// The point on the line where the strip starts.
    start: [f64; 2],
    /// Points that arcs may still have.
    arc_points_left: u32,
}

/// A segment with its direction, of length 1.
#[derive(Clone, Copy)]
struct Segment {
    from: Vertex,
    to: Vertex,
    direction: [f64; 2],
    length: f64,
}

impl Segment {
    fn new((from, to): (Vertex, Vertex)) -> Self {
        let delta = [to.point[0] - from.point[0], to.point[1] - from.point[1]];
        let length = dot(delta, delta).sqrt();
        Self { from, to, direction: scaled(delta, 1.0 / length), length }
    }

    /// To the left of the direction, y down: a quarter turn from x towards -y.
    fn normal(&self) -> [f64; 2] {
        [self.direction[1], -self.direction[0]]
    }
}

impl<'a, S: LineSink> Outliner<'a, S> {
    /// The two sides are memory to work in.
    pub(super) fn new(
        style: &Stroke,
        tolerance: f64,
        transform: &'a Transform,
        [left, right]: &'a mut [Vec<[f64; 2]>; 2],
        sink: &'a mut S,
    ) -> Self {
        let radius = f64::from(style.width) * 0.5;
        Self {
            cap: style.cap,
            join: style.join,
            radius,
            reach: radius,
            tolerance,
            transform,
            sink,
            left,
            right,
            start: [0.0; 2],
            arc_points_left: MAX_ARC_POINTS,
        }
    }

    /// Lets caps reach less far than the line is wide: square ones are cut, round ones become square ones of their area.
    pub(super) fn shorten_caps(&mut self, reach: f64) {
        self.reach = if self.cap == Cap::Round { reach * core::f64::consts::FRAC_PI_4 } else { reach };
        self.cap = if self.cap == Cap::Round { Cap::Square } else { self.cap };
    }

    /// Draws one polyline.
    pub(super) fn draw(&mut self, line: &Polyline) {
        let mut segments = line.segments().map(Segment::new).filter(|segment| segment.length > 0.0);
        let Some(first) = segments.next() else {
            if let Some(vertex) = line.vertices.first() {
                self.dot(vertex.point);
            }
            return;
        };
        if !line.is_closed {
            self.draw_cap(first.from.point, scaled(first.direction, -1.0));
        }
        self.begin_strip(&first);
        let mut last = first;
        for segment in segments {
            self.join(&last, &segment);
            last = segment;
        }
        self.end_strip(&last);
        if line.is_closed {
            self.draw_join(&last, &first);
        } else {
            self.draw_cap(last.to.point, last.direction);
        }
    }

    /// A line of no length: its two caps. Square ones lie along x.
    fn dot(&mut self, point: [f64; 2]) {
        if self.cap != Cap::Butt {
            self.draw_cap(point, [1.0, 0.0]);
            self.draw_cap(point, [-1.0, 0.0]);
        }
    }

    fn begin_strip(&mut self, segment: &Segment) {
        let offset = scaled(segment.normal(), self.radius);
        self.start = segment.from.point;
        self.left.clear();
        self.right.clear();
        self.left.push(sum(segment.from.point, offset));
        self.right.push(difference(segment.from.point, offset));
    }

    /// Adds the end of `segment` and draws the strip.
    fn end_strip(&mut self, segment: &Segment) {
        let offset = scaled(segment.normal(), self.radius);
        let end = segment.to.point;
        self.send_first(self.start);
        for i in 0..self.left.len() {
            self.send(self.left[i]);
        }
        self.send(sum(end, offset));
        self.send(end);
        self.send(difference(end, offset));
        for i in (0..self.right.len()).rev() {
            self.send(self.right[i]);
        }
        self.sink.close();
    }

    /// The turn from one segment to the next.
    fn join(&mut self, a: &Segment, b: &Segment) {
        let cos = dot(a.direction, b.direction);
        // The mean of the normals, so long that it meets both sides' lines; it overshoots a rounded turn by about
        // radius * (1 - cos) / 4, and on the inner side takes radius * tan(angle / 2) from both segments.
        let is_slight = (1.0 - cos) * self.radius <= 4.0 * self.tolerance && cos > 0.5;
        if is_slight {
            let shortest = if a.length < b.length { a.length } else { b.length };
            let taken = self.radius * cross(a.direction, b.direction).abs() / (1.0 + cos);
            if taken <= 0.5 * shortest {
                let offset = scaled(sum(a.normal(), b.normal()), self.radius / (1.0 + cos));
                self.left.push(sum(b.from.point, offset));
                self.right.push(difference(b.from.point, offset));
                return;
            }
        }
        self.end_strip(a);
        self.draw_join(a, b);
        self.begin_strip(b);
    }

    /// The wedge on the outer side of a turn.
    fn draw_join(&mut self, a: &Segment, b: &Segment) {
        let pivot = b.from.point;
        let turn = cross(a.direction, b.direction);
        let cos = dot(a.direction, b.direction);
        if turn == 0.0 && cos > 0.0 {
            return;
        }
        // Left of a turn to the right is outside; from the one side to the other, always the same way round.
        let (from, to) =
            if turn >= 0.0 { (a.normal(), b.normal()) } else { (scaled(b.normal(), -1.0), scaled(a.normal(), -1.0)) };
        let join = if b.from.is_corner { self.join } else { Join::Round };
        self.send_first(pivot);
        self.send_offset(pivot, from, self.radius);
        match join {
            Join::Round => {
                let middle = if cos > -0.999_999 { normalized(sum(from, to)) } else { [-from[1], from[0]] };
                self.arc(pivot, from, middle, 0);
                self.send_offset(pivot, middle, self.radius);
                self.arc(pivot, middle, to, 0);
            }
            Join::Bevel => {}
            Join::Miter { limit } => self.miter(pivot, from, to, cos, f64::from(limit), false),
            Join::MiterClip { limit } => self.miter(pivot, from, to, cos, f64::from(limit), true),
        }
        self.send_offset(pivot, to, self.radius);
        self.sink.close();
    }

    /// The point of a mitered corner: where the two sides' lines meet, or its cut.
    fn miter(&mut self, pivot: [f64; 2], from: [f64; 2], to: [f64; 2], cos: f64, limit: f64, is_clipped: bool) {
        // The tip is radius / cos(angle / 2) from the pivot, and cos^2(angle / 2) = (1 + cos) / 2.
        let cos_half_squared = (1.0 + cos) * 0.5;
        let limit = if limit > 1.0 { limit } else { 1.0 };
        if limit * limit * cos_half_squared >= 1.0 {
            self.send(sum(pivot, scaled(sum(from, to), self.radius / (1.0 + cos))));
        } else if is_clipped {
            let middle = if cos > -0.999_999 { normalized(sum(from, to)) } else { [-from[1], from[0]] };
            let reach = self.radius * limit;
            for (normal, sign) in [(from, 1.0), (to, -1.0)] {
                // From the side's corner along the side, up to the line that lies `reach` from the pivot.
                let along = scaled([-normal[1], normal[0]], sign);
                let advance = (reach - self.radius * dot(normal, middle)) / dot(along, middle);
                if advance > 0.0 && advance.is_finite() {
                    self.send(sum(pivot, sum(scaled(normal, self.radius), scaled(along, advance))));
                }
            }
        }
    }

    /// The cap at `end`, where the line leaves along `direction`.
    fn draw_cap(&mut self, end: [f64; 2], direction: [f64; 2]) {
        let normal = [direction[1], -direction[0]];
        let other = scaled(normal, -1.0);
        if self.cap == Cap::Butt {
            return;
        }
        self.send_first(end);
        self.send_offset(end, normal, self.radius);
        if self.cap == Cap::Round {
            self.arc(end, normal, direction, 0);
            self.send_offset(end, direction, self.radius);
            self.arc(end, direction, other, 0);
        } else {
            let tip = sum(end, scaled(direction, self.reach));
            self.send_offset(tip, normal, self.radius);
            self.send_offset(tip, other, self.radius);
        }
        self.send_offset(end, other, self.radius);
        self.sink.close();
    }

    /// The points between two directions on a circle, less than half of one apart; halved until flat enough.
    fn arc(&mut self, center: [f64; 2], from: [f64; 2], to: [f64; 2], halvings: u32) {
        // The sagitta of an arc of angle a is radius * (1 - cos(a / 2)), about radius * (1 - cos a) / 4.
        let is_flat = (1.0 - dot(from, to)) * self.radius <= 4.0 * self.tolerance;
        if is_flat || halvings == MAX_HALVINGS || self.arc_points_left == 0 {
            return;
        }
        self.arc_points_left -= 1;
        let middle = normalized(sum(from, to));
        self.arc(center, from, middle, halvings + 1);
        self.send_offset(center, middle, self.radius);
        self.arc(center, middle, to, halvings + 1);
    }

    fn send_first(&mut self, point: [f64; 2]) {
        self.sink.move_to(self.transform.apply(point));
    }

    fn send(&mut self, point: [f64; 2]) {
        self.sink.line_to(self.transform.apply(point));
    }

    fn send_offset(&mut self, point: [f64; 2], direction: [f64; 2], distance: f64) {
        self.send(sum(point, scaled(direction, distance)));
    }
}

fn sum(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

fn difference(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

fn scaled(a: [f64; 2], factor: f64) -> [f64; 2] {
    [a[0] * factor, a[1] * factor]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn normalized(a: [f64; 2]) -> [f64; 2] {
    scaled(a, 1.0 / dot(a, a).sqrt())
}
