//! From a parsed block to final indices: invalid references out, polygons cut into triangles.
//!
//! Runs per block, in parallel, once the number of elements in all blocks is known.

use super::block::{Block, Note, Polylines};
use super::element::resolve;
use crate::geometry::{ABSENT, Corner, Cut, Triangulator};
use crate::load::{Findings, WarningKind};

/// Numbers of positions, texture coordinates and normals.
pub(super) type Counts = [usize; 3];

/// A block's primitives, with indices of the whole file.
#[derive(Default)]
pub(super) struct Primitives {
    /// Three corners per triangle.
    pub(super) triangles: Vec<Corner>,
    /// Two corners per segment.
    pub(super) segments: Vec<Corner>,
    pub(super) points: Vec<Corner>,
    /// For each event of the block, the numbers of triangles, segments and points before it.
    pub(super) before_events: Vec<[usize; 3]>,
    pub(super) notes: Vec<Note>,
    pub(super) suppressed_notes: usize,
    pub(super) usage: Usage,
}

/// What all corners have in common, for uv and normal indices in turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Usage {
    /// A corner of a triangle, or of a line with a uv, has the index.
    pub(super) some: [bool; 2],
    /// A corner of a triangle lacks it.
    pub(super) lacking: [bool; 2],
    /// Every index that is there equals the one of the position.
    pub(super) equal: [bool; 2],
}

impl Default for Usage {
    fn default() -> Self {
        Self { some: [false; 2], lacking: [false; 2], equal: [true; 2] }
    }
}

impl Usage {
    /// What holds for both.
    pub(super) fn and(self, other: Self) -> Self {
        let either = |a: [bool; 2], b: [bool; 2]| [a[0] || b[0], a[1] || b[1]];
        Self {
            some: either(self.some, other.some),
            lacking: either(self.lacking, other.lacking),
            equal: [self.equal[0] && other.equal[0], self.equal[1] && other.equal[1]],
        }
    }

    #[inline(always)]
    fn insert(&mut self, [position, uv, normal]: Corner) {
        for (i, index) in [uv, normal].into_iter().enumerate() {
            self.some[i] |= index != ABSENT;
            self.lacking[i] |= index == ABSENT;
            self.equal[i] &= index == ABSENT || index == position;
        }
    }
}

/// Resolves a block that comes after `before` elements in a file with `totals`; `positions` are those of the file.
pub(super) fn resolve_block<'a>(
    mut block: Block<'a>,
    before: Counts,
    totals: Counts,
    positions: &[[f32; 3]],
) -> (Block<'a>, Primitives) {
    let mut resolver =
        Resolver { before, totals, positions, triangulator: Triangulator::default(), out: Primitives::default() };
    let clean = resolver.resolve_faces(&mut block.faces);
    if clean && block.faces.runs.iter().all(|&(len, _)| len == 3) {
        // The usual block: nothing but triangles, which are already in their final form.
        resolver.out.triangles = std::mem::take(&mut block.faces.corners);
        resolver.out.before_events = block.events.iter().map(|event| [event.before.faces as usize, 0, 0]).collect();
    } else {
        resolver.cut_faces(&block);
    }
    resolver.lines(&block);
    resolver.points(&block);
    (block, resolver.out)
}

struct Resolver<'a> {
    before: Counts,
    totals: Counts,
    positions: &'a [[f32; 3]],
    triangulator: Triangulator,
    out: Primitives,
}

/// Marks the position of a corner whose face must go.
const BAD: u32 = ABSENT;

impl Resolver<'_> {
    /// Makes all indices final, in place. Whether all of them were valid.
    fn resolve_faces(&mut self, faces: &mut Polylines) -> bool {
        let mut usage = Usage::default();
        let mut is_clean = true;
        for corner in &mut faces.corners {
            let resolved: Corner = std::array::from_fn(|i| resolve(corner[i], self.before[i]));
            let is_good = (resolved[0] as usize) < self.totals[0]
                && (resolved[1] == ABSENT || (resolved[1] as usize) < self.totals[1])
                && (resolved[2] == ABSENT || (resolved[2] as usize) < self.totals[2]);
            is_clean &= is_good;
            usage.insert(resolved);
            *corner = resolved;
        }
        self.out.usage = usage;
        is_clean
    }

    /// Makes triangles of resolved faces, leaving out what is invalid.
    fn cut_faces(&mut self, block: &Block<'_>) {
        let n_triangles: usize = block.faces.runs.iter().map(|&(len, times)| (len as usize - 2) * times as usize).sum();
        self.out.triangles.reserve(3 * n_triangles);
        self.out.usage = Usage::default();
        let mut events = block.events.iter().peekable();
        let mut corners = Vec::new();
        let mut triangles = Vec::new();
        let mut rest = block.faces.corners.as_slice();
        for (number, len) in (0_u32..).zip(block.faces.lengths()) {
            while events.next_if(|event| event.before.faces <= number).is_some() {
                self.out.before_events.push([self.out.triangles.len() / 3, 0, 0]);
            }
            let (face, after) = rest.split_at(len);
            rest = after;
            corners.clear();
            corners.extend_from_slice(face);
            if self.repair(&mut corners, block, number) {
                triangles.clear();
                self.cut_face(&corners, block.faces.line(number), &mut triangles);
            }
        }
        for _ in events {
            self.out.before_events.push([self.out.triangles.len() / 3, 0, 0]);
        }
    }

    fn cut_face(&mut self, corners: &[Corner], line: u32, triangles: &mut Vec<[usize; 3]>) {
        let positions = self.positions;
        let cut = self.triangulator.cut(corners.len(), |i| positions[corners[i][0] as usize], triangles);
        if cut == Cut::BestEffort && corners.len() > 4 && is_finite(positions, corners) {
            let message =
                format!("face with {} corners crosses itself or has no area; drawn as well as possible", corners.len());
            self.note(line, WarningKind::Approximated, message);
        }
        for triangle in triangles {
            self.out.triangles.extend(triangle.map(|i| corners[i]));
        }
        for &corner in corners {
            self.out.usage.insert(corner);
        }
    }

    /// Drops uv and normal indices that do not exist. Whether the positions exist, so that the face can be drawn.
    fn repair(&mut self, corners: &mut [Corner], block: &Block<'_>, face: u32) -> bool {
        const WHAT: [&str; 3] = ["position", "texture coordinate", "normal"];
        let [positions, uvs, normals] = self.totals;
        if corners.iter().any(|corner| corner[0] as usize >= positions) {
            let message =
                format!("face left out: it refers to a position that the file does not have (it has {positions})");
            self.note(block.faces.line(face), WarningKind::InvalidElement, message);
            return false;
        }
        for (i, total) in [(1, uvs), (2, normals)] {
            let is_bad = |corner: &Corner| corner[i] != ABSENT && corner[i] as usize >= total;
            if corners.iter().any(is_bad) {
                corners.iter_mut().filter(|corner| is_bad(corner)).for_each(|corner| corner[i] = ABSENT);
                let what = WHAT[i];
                let message = format!("{what} index ignored: the file has {total} of them");
                self.note(block.faces.line(face), WarningKind::InvalidElement, message);
            }
        }
        true
    }

    /// Makes segments of polylines.
    fn lines(&mut self, block: &Block<'_>) {
        let mut counts = Vec::with_capacity(block.lines.count as usize + 1);
        let mut rest = block.lines.corners.as_slice();
        for (number, len) in (0_u32..).zip(block.lines.lengths()) {
            counts.push(self.out.segments.len() / 2);
            let (line, after) = rest.split_at(len);
            rest = after;
            let corners: Vec<Corner> = line.iter().map(|&corner| self.resolve_loose(corner)).collect();
            if corners.iter().any(|corner| corner[0] == BAD) {
                let message = "line left out: it refers to a position that the file does not have".to_owned();
                self.note(block.lines.line(number), WarningKind::InvalidElement, message);
                continue;
            }
            self.out.segments.extend(corners.windows(2).flatten());
        }
        counts.push(self.out.segments.len() / 2);
        for (before, event) in self.out.before_events.iter_mut().zip(&block.events) {
            before[1] = counts.get(event.before.lines as usize).copied().unwrap_or(0);
        }
    }

    fn points(&mut self, block: &Block<'_>) {
        let mut counts = Vec::new();
        for (number, &code) in (0_u32..).zip(&block.points) {
            counts.push(self.out.points.len());
            let corner = self.resolve_loose([code, ABSENT, ABSENT]);
            if corner[0] == BAD {
                let message = "point left out: it refers to a position that the file does not have".to_owned();
                self.note(block.point_lines.get(number), WarningKind::InvalidElement, message);
                continue;
            }
            self.out.points.push(corner);
        }
        counts.push(self.out.points.len());
        for (before, event) in self.out.before_events.iter_mut().zip(&block.events) {
            before[2] = counts.get(event.before.points as usize).copied().unwrap_or(0);
        }
    }

    /// A corner of a line or point: no normal, the uv if it exists; the position is [`BAD`] if it does not.
    fn resolve_loose(&mut self, corner: Corner) -> Corner {
        let index = |i: usize| {
            let index = resolve(corner[i], self.before[i]);
            if (index as usize) < self.totals[i] { index } else { ABSENT }
        };
        let (position, uv) = (index(0), index(1));
        if uv != ABSENT {
            self.out.usage.some[0] = true;
            self.out.usage.equal[0] &= uv == position;
        }
        [position, uv, ABSENT]
    }

    fn note(&mut self, line: u32, kind: WarningKind, message: String) {
        if self.out.notes.len() < Findings::MAX {
            self.out.notes.push(Note { line, kind, message });
        } else {
            self.out.suppressed_notes += 1;
        }
    }
}

fn is_finite(positions: &[[f32; 3]], corners: &[Corner]) -> bool {
    corners.iter().all(|corner| positions[corner[0] as usize].iter().all(|c| c.is_finite()))
}
