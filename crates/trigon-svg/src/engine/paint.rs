//! Painting: the runs of a shape and its colours onto a surface.
//!
//! In: coverage, a shader, a blend mode. The common cases are short: an opaque colour overwrites; a pixel that is all one
//! colour stays so where it is covered whole; only pixels on edges are blended sample by sample.

use super::blend::blend;
use super::coverage::Bounds;
use super::over::{over, over_lanes, over_row, over_solid};
use super::runs::{Run, RunRows};
use super::shader::Shader;
use super::surface::{Line, Row, Surface};
use crate::canvas::BlendMode;
use trigon::lanes::{LANES, Lanes};

/// What stays the same over one shape.
pub(crate) struct Brush<'a> {
    pub(crate) shader: &'a Shader,
    pub(crate) blend: BlendMode,
    /// One bit per sample of the pattern.
    pub(crate) full_mask: u16,
}

/// The part of a run that is inside a row, relative to it.
struct Span {
    start: usize,
    end: usize,
    mask: u16,
}

impl Brush<'_> {
    /// Paints what `runs` cover inside `bounds`; `colors` is memory to work in.
    #[inline(always)]
    pub(crate) fn paint<L: Lanes>(
        &self,
        l: L,
        runs: &RunRows,
        bounds: &Bounds,
        surface: &mut Surface,
        colors: &mut Vec<u32>,
    ) {
        let bounds = bounds.intersect(&surface.bounds());
        let rows = runs.rows();
        for y in rows.start.max(bounds.rows[0])..rows.end.min(bounds.rows[1]) {
            let runs = runs.row(y);
            if runs.is_empty() {
                continue;
            }
            let mut row = surface.row_mut(y);
            let left = u32::from(runs[0].x).max(bounds.columns[0]);
            let right = u32::from(runs[runs.len() - 1].end()).min(bounds.columns[1]);
            if left >= right {
                continue;
            }
            row.mark_drawn((left - row.left) as usize, (right - row.left) as usize);
            match self.shader {
                Shader::Solid(color) if self.blend == BlendMode::Normal => {
                    self.solid_row(l, *color, runs, &bounds, &mut row);
                }
                _ => self.shaded_row(l, y, runs, &bounds, &mut row, colors),
            }
        }
    }

    /// One colour, source over.
    #[inline(always)]
    fn solid_row<L: Lanes>(&self, l: L, color: u32, runs: &[Run], bounds: &Bounds, row: &mut Row<'_>) {
        let is_opaque = color >> 24 == 255;
        for run in runs {
            let Some(span) = clipped(*run, bounds, row) else { continue };
            if span.mask != self.full_mask {
                for x in span.start..span.end {
                    // A colour over itself changes nothing: the pixel stays one colour.
                    if is_opaque && (row.is_expanded(x) || row.words[x] != color) {
                        replace_samples(l, row.expand(l, x), span.mask, color);
                    } else if !is_opaque {
                        over_samples(l, row.expand(l, x), span.mask, color);
                    }
                }
            } else if is_opaque {
                row.collapse(span.start, span.end);
                row.words[span.start..span.end].fill(color);
            } else {
                over_span(l, row, &span, color);
            }
        }
    }

    /// A colour per pixel, or another blend mode.
    #[inline(always)]
    fn shaded_row<L: Lanes>(
        &self,
        l: L,
        y: u32,
        runs: &[Run],
        bounds: &Bounds,
        row: &mut Row<'_>,
        colors: &mut Vec<u32>,
    ) {
        // Runs side by side are shaded together, so that edges do not waste lanes.
        // tidy: allow(lane-closure): no lanes in it
        for group in runs.chunk_by(|a, b| a.end() == b.x) {
            let (first, last) = (group[0], group[group.len() - 1]);
            let left = u32::from(first.x).max(bounds.columns[0]);
            let right = u32::from(last.end()).min(bounds.columns[1]);
            if left >= right {
                continue;
            }
            colors.clear();
            colors.resize((right - left) as usize, 0);
            shade(l, self.shader, left, y, colors);
            for run in group {
                let Some(span) = clipped(*run, bounds, row) else { continue };
                let offset = (left - row.left) as usize;
                self.colored_span(l, &colors[span.start - offset..span.end - offset], &span, row);
            }
        }
    }

    /// Paints the samples of `mask` of one pixel for each of `colors`, the first at column `start` of the row.
    #[inline(always)]
    pub(crate) fn colored_span_at<L: Lanes>(&self, l: L, start: usize, mask: u16, colors: &[u32], row: &mut Row<'_>) {
        row.mark_drawn(start, start + colors.len());
        let span = Span { start, end: start + colors.len(), mask };
        self.colored_span(l, colors, &span, row);
    }

    #[inline(always)]
    fn colored_span<L: Lanes>(&self, l: L, colors: &[u32], span: &Span, row: &mut Row<'_>) {
        if self.blend != BlendMode::Normal {
            self.blended_span(l, colors, span, row);
        } else if span.mask != self.full_mask {
            for (x, color) in (span.start..span.end).zip(colors) {
                over_samples(l, row.expand(l, x), span.mask, *color);
            }
        } else if self.shader.is_opaque() {
            row.collapse(span.start, span.end);
            row.words[span.start..span.end].copy_from_slice(colors);
        } else {
            over_colors(l, row, span, colors);
        }
    }

    /// Any blend mode.
    fn blended_span<L: Lanes>(&self, l: L, colors: &[u32], span: &Span, row: &mut Row<'_>) {
        for (x, color) in (span.start..span.end).zip(colors) {
            if span.mask == self.full_mask && !row.is_expanded(x) {
                row.words[x] = blend(self.blend, *color, row.words[x]);
                continue;
            }
            for (sample, below) in row.expand(l, x).0.iter_mut().enumerate() {
                if span.mask >> sample & 1 == 1 {
                    *below = blend(self.blend, *color, *below);
                }
            }
        }
    }
}

/// The part of a run inside `bounds`, relative to the row.
#[inline(always)]
fn clipped(run: Run, bounds: &Bounds, row: &Row<'_>) -> Option<Span> {
    let start = u32::from(run.x).max(bounds.columns[0]);
    let end = u32::from(run.end()).min(bounds.columns[1]);
    if start >= end {
        return None;
    }
    Some(Span { start: (start - row.left) as usize, end: (end - row.left) as usize, mask: run.mask })
}

/// Never inlined: shaders are large, and called from several places.
#[inline(never)]
fn shade<L: Lanes>(l: L, shader: &Shader, x: u32, y: u32, out: &mut [u32]) {
    l.vectorize(
        #[inline(always)]
        || shader.row(l, x, y, out),
    );
}

/// One opaque colour for the samples of `mask`.
#[inline(always)]
fn replace_samples<L: Lanes>(l: L, line: &mut Line, mask: u16, color: u32) {
    line.0 = l.mask_from_bits(mask).select(l.u32(color), l.u32_array(&line.0)).to_array();
}

/// One colour over the samples of `mask`.
#[inline(always)]
fn over_samples<L: Lanes>(l: L, line: &mut Line, mask: u16, color: u32) {
    let below = l.u32_array(&line.0);
    line.0 = l.mask_from_bits(mask).select(over_lanes(l, l.u32(color), below), below).to_array();
}

/// One translucent colour over whole pixels.
#[inline(always)]
fn over_span<L: Lanes>(l: L, row: &mut Row<'_>, span: &Span, color: u32) {
    let mut x = span.start;
    while x < span.end {
        let (end, is_expanded) = row.same_kind(x, span.end);
        if is_expanded {
            for x in x..end {
                let line = row.expand(l, x);
                line.0 = over_lanes(l, l.u32(color), l.u32_array(&line.0)).to_array();
            }
        } else if end - x < LANES {
            for word in &mut row.words[x..end] {
                *word = over(color, *word);
            }
        } else {
            over_solid(l, color, &mut row.words[x..end]);
        }
        x = end;
    }
}

/// A colour per pixel over whole pixels.
#[inline(always)]
fn over_colors<L: Lanes>(l: L, row: &mut Row<'_>, span: &Span, colors: &[u32]) {
    let mut x = span.start;
    while x < span.end {
        let (end, is_expanded) = row.same_kind(x, span.end);
        let sources = &colors[x - span.start..end - span.start];
        if is_expanded {
            for (x, color) in (x..end).zip(sources) {
                let line = row.expand(l, x);
                line.0 = over_lanes(l, l.u32(*color), l.u32_array(&line.0)).to_array();
            }
        } else {
            over_row(l, sources, &mut row.words[x..end]);
        }
        x = end;
    }
}
