//! Dashes: one polyline in, the pieces of it that are drawn out.
//!
//! Lengths are measured along the polyline. Each contour begins anew at the offset. A dash that reaches the end of a closed
//! contour whose start is in a dash, too, is one with that, joined at the start as at other corners.

use super::polyline::{Polyline, Vertex};
use crate::canvas::Stroke;

/// Most pieces that the contours of one path are cut into; one that would have more is drawn solid.
const MAX_PIECES: f64 = 1_000_000.0;

/// A valid dash pattern.
pub(super) struct Dashes {
    /// Dash and gap in turn, an even number of them.
    lengths: Vec<f64>,
    /// The sum of them.
    period: f64,
    /// Which of them a contour begins in, and how much of that is left.
    first: usize,
    first_left: f64,
}

impl Dashes {
    /// The pattern of a stroke along `lines`; `None` if it is solid.
    pub(super) fn along(lines: &[Polyline], style: &Stroke) -> Option<Self> {
        let dashes = Self::new(style)?;
        let lengths = lines.iter().flat_map(Polyline::segments).map(|(a, b)| distance(a.point, b.point));
        let periods = lengths.sum::<f64>() / dashes.period;
        (periods * dashes.lengths.len() as f64 <= MAX_PIECES).then_some(dashes)
    }

    fn new(style: &Stroke) -> Option<Self> {
        let mut lengths: Vec<f64> = style.dashes.iter().map(|length| f64::from(*length)).collect();
        if lengths.len() % 2 == 1 {
            lengths.extend_from_within(..);
        }
        let period: f64 = lengths.iter().sum();
        let is_valid = lengths.iter().all(|length| *length >= 0.0) && period > 0.0 && period.is_finite();
        if !is_valid {
            return None;
        }
        let offset = f64::from(style.dash_offset);
        let mut offset = if offset.is_finite() { offset % period } else { 0.0 };
        if offset < 0.0 {
            offset += period;
        }
        let mut first = 0;
        // A dash of no length at the very start is a dot.
        while first + 1 < lengths.len() && offset >= lengths[first] && offset > 0.0 {
            offset -= lengths[first];
            first += 1;
        }
        let first_left = lengths[first] - offset;
        Some(Self { lengths, period, first, first_left: if first_left > 0.0 { first_left } else { 0.0 } })
    }

    /// Calls `draw` with each piece; `piece` is memory to work in.
    pub(super) fn cut(&self, line: &Polyline, piece: &mut Polyline, draw: &mut impl FnMut(&Polyline)) {
        if line.vertices.len() < 2 {
            draw(line);
            return;
        }
        let (mut index, mut left) = (self.first, self.first_left);
        // The first piece of a closed contour waits for the last one.
        let mut waits = line.is_closed && index % 2 == 0 && left > 0.0;
        let mut head = None;
        piece.clear();
        if index % 2 == 0 {
            piece.push(line.vertices[0]);
        }
        let mut segments_left = line.segments().count();
        'segments: for (from, to) in line.segments() {
            segments_left -= 1;
            let length = distance(from.point, to.point);
            let mut done = 0.0;
            // Each end of a dash or gap within this segment.
            while left <= length - done {
                done += left;
                let t = done / length;
                let at = |axis: usize| from.point[axis] + (to.point[axis] - from.point[axis]) * t;
                let vertex = Vertex { point: [at(0), at(1)], is_corner: true };
                if index % 2 == 1 {
                    piece.clear();
                    piece.push(vertex);
                } else if core::mem::take(&mut waits) {
                    piece.push(vertex);
                    head = Some(core::mem::take(piece));
                } else if head.is_some() && segments_left == 0 && done >= length {
                    // It ends where the contour does.
                    break 'segments;
                } else {
                    piece.push(vertex);
                    draw(piece);
                    piece.clear();
                }
                index = (index + 1) % self.lengths.len();
                left = self.lengths[index];
            }
            left -= length - done;
            if index % 2 == 0 {
                piece.push(to);
            }
        }
        match head {
            Some(head) if piece.vertices.is_empty() => draw(&head),
            Some(head) => {
                piece.push(line.vertices[0]);
                head.vertices.iter().for_each(|vertex| piece.push(*vertex));
                draw(piece);
            }
            None if piece.vertices.len() > 1 => draw(piece),
            None => {}
        }
    }
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    (dx * dx + dy * dy).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pieces(dashes: &[f32], offset: f32) -> Vec<[f64; 2]> {
        let vertices = [[0.0, 0.0], [10.0, 0.0]].map(|point| Vertex { point, is_corner: true }).to_vec();
        let line = Polyline { vertices, is_closed: false };
        let style = Stroke::new(1.0).with_dashes(dashes, offset);
        let mut found = Vec::new();
        Dashes::new(&style).unwrap().cut(&line, &mut Polyline::default(), &mut |piece| {
            found.push([piece.vertices[0].point[0], piece.vertices.last().unwrap().point[0]]);
        });
        found
    }

    #[test]
    fn dashes_and_gaps_alternate() {
        assert_eq!(pieces(&[3.0, 2.0], 0.0), [[0.0, 3.0], [5.0, 8.0]]);
        assert_eq!(pieces(&[3.0, 2.0], 1.0), [[0.0, 2.0], [4.0, 7.0], [9.0, 10.0]]);
        assert_eq!(pieces(&[3.0, 2.0], -1.0), [[1.0, 4.0], [6.0, 9.0]]);
        assert_eq!(pieces(&[4.0], 2.0), [[0.0, 2.0], [6.0, 10.0]]);
        assert_eq!(pieces(&[0.0, 5.0], 0.0), [[0.0, 0.0], [5.0, 5.0], [10.0, 10.0]]);
    }

    /// The corners of the pieces of a square of side 10.
    fn square_pieces(dashes: &[f32]) -> Vec<Vec<[f64; 2]>> {
        let corners = [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]];
        let vertices = corners.map(|point| Vertex { point, is_corner: true }).to_vec();
        let line = Polyline { vertices, is_closed: true };
        let mut found = Vec::new();
        Dashes::new(&Stroke::new(1.0).with_dashes(dashes, 0.0)).unwrap().cut(
            &line,
            &mut Polyline::default(),
            &mut |piece| {
                found.push(piece.vertices.iter().map(|vertex| vertex.point).collect());
            },
        );
        found
    }

    #[test]
    fn the_last_dash_of_a_closed_contour_is_one_with_the_first() {
        // Ends within a dash.
        let last = square_pieces(&[12.0, 6.0]).pop().unwrap();
        assert_eq!(last, [[0.0, 4.0], [0.0, 0.0], [10.0, 0.0], [10.0, 2.0]]);
        // Ends with a dash.
        let pieces = square_pieces(&[20.0, 0.0]);
        assert_eq!(pieces, [vec![[10.0, 10.0], [0.0, 10.0], [0.0, 0.0], [10.0, 0.0], [10.0, 10.0]]]);
        // Ends in a gap.
        assert_eq!(square_pieces(&[30.0, 20.0]), [vec![[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]]]);
        // One dash is longer than the contour.
        assert_eq!(square_pieces(&[50.0, 20.0]).len(), 1);
    }

    #[test]
    fn invalid_patterns_are_solid() {
        for dashes in [&[][..], &[0.0, 0.0], &[-1.0, 2.0], &[f32::NAN, 1.0], &[f32::INFINITY, 1.0]] {
            assert!(Dashes::new(&Stroke::new(1.0).with_dashes(dashes, 0.0)).is_none(), "{dashes:?}");
        }
    }
}
