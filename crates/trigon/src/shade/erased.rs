//! Shaders behind one pointer: the pipeline draws many kinds of shader in one frame.
//!
//! In: batches of work for one shader. Out: positions, coefficients, colours. Each method enters the shader's code at
//! the frame's SIMD level once per batch.

use super::coefficients::{ManyTriangles, OneTriangle, TriangleGroup, compute, interpolate, row_count};
use super::fragments::{ColorGroup, FragmentRange, SurfaceGroup};
use super::shader::{Fragment, Shader};
use super::varying::Varying;
use crate::geometry::ClipPositions;
use crate::lanes::{LANES, Lanes, Vec2, dispatch};
use fearless_simd::Level;

/// A shader whose type is forgotten.
pub trait ErasedShader: Sync {
    /// Clip positions of the vertices `indices`.
    fn positions(&self, level: Level, indices: &[u32], out: &mut ClipPositions);
    /// Coefficient rows per group of triangles.
    fn rows(&self) -> usize;
    /// Coefficients of up to sixteen triangles.
    fn coefficients(&self, level: Level, group: &TriangleGroup, rows: &mut [[f32; LANES]]);
    /// Colours of fragments, one group of sixteen after the other.
    fn shade(&self, level: Level, rows: &[f32], fragments: &FragmentRange<'_>, out: &mut [ColorGroup]);
    /// Which fragments exist, one bit per lane.
    fn keep(&self, level: Level, rows: &[f32], fragments: &FragmentRange<'_>, out: &mut [u16]);
    /// Surfaces of fragments, for the outputs beside colour.
    fn surfaces(&self, level: Level, rows: &[f32], fragments: &FragmentRange<'_>, out: &mut [SurfaceGroup]);
    /// See [`Shader::discards`].
    fn can_discard(&self) -> bool;
}

impl<S: Shader> ErasedShader for S {
    fn positions(&self, level: Level, indices: &[u32], out: &mut ClipPositions) {
        dispatch!(level, l => positions(l, self, indices, out));
    }

    fn rows(&self) -> usize {
        row_count(<S::Varying<fearless_simd::Fallback> as Varying<fearless_simd::Fallback>>::COMPONENTS)
    }

    fn coefficients(&self, level: Level, group: &TriangleGroup, rows: &mut [[f32; LANES]]) {
        dispatch!(level, l => compute(l, self, group, rows));
    }

    fn shade(&self, level: Level, rows: &[f32], fragments: &FragmentRange<'_>, out: &mut [ColorGroup]) {
        dispatch!(level, l => shade(l, self, rows, fragments, out));
    }

    fn keep(&self, level: Level, rows: &[f32], fragments: &FragmentRange<'_>, out: &mut [u16]) {
        dispatch!(level, l => keep(l, self, rows, fragments, out));
    }

    fn surfaces(&self, level: Level, rows: &[f32], fragments: &FragmentRange<'_>, out: &mut [SurfaceGroup]) {
        dispatch!(level, l => surfaces(l, self, rows, fragments, out));
    }

    fn can_discard(&self) -> bool {
        self.discards()
    }
}

#[inline(always)]
fn positions<L: Lanes, S: Shader>(l: L, shader: &S, indices: &[u32], out: &mut ClipPositions) {
    let (groups, rest) = indices.as_chunks::<LANES>();
    for (g, group) in groups.iter().enumerate() {
        place(l, shader, group, out, g);
    }
    if let Some(last) = rest.last() {
        let mut group = [*last; LANES];
        group[..rest.len()].copy_from_slice(rest);
        place(l, shader, &group, out, groups.len());
    }
}

#[inline(always)]
fn place<L: Lanes, S: Shader>(l: L, shader: &S, indices: &[u32; LANES], out: &mut ClipPositions, group: usize) {
    let p = shader.vertex(l, l.u32_array(indices)).position;
    p.x.store(&mut out.x[group]);
    p.y.store(&mut out.y[group]);
    p.z.store(&mut out.z[group]);
    p.w.store(&mut out.w[group]);
}

#[inline(always)]
fn shade<L: Lanes, S: Shader>(l: L, shader: &S, rows: &[f32], f: &FragmentRange<'_>, out: &mut [ColorGroup]) {
    for (g, out) in out.iter_mut().enumerate() {
        let color = match f.single_slot(g) {
            Some(slot) => shader.fragment(l, &one(l, rows, slot, f, g)),
            None => shader.fragment(l, &many(l, rows, f, g)),
        };
        color.r.store(&mut out[0]);
        color.g.store(&mut out[1]);
        color.b.store(&mut out[2]);
        color.a.store(&mut out[3]);
    }
}

#[inline(always)]
fn keep<L: Lanes, S: Shader>(l: L, shader: &S, rows: &[f32], f: &FragmentRange<'_>, out: &mut [u16]) {
    for (g, out) in out.iter_mut().enumerate() {
        let kept = match f.single_slot(g) {
            Some(slot) => shader.keep(l, &one(l, rows, slot, f, g)),
            None => shader.keep(l, &many(l, rows, f, g)),
        };
        *out = kept.bits();
    }
}

#[inline(always)]
fn surfaces<L: Lanes, S: Shader>(l: L, shader: &S, rows: &[f32], f: &FragmentRange<'_>, out: &mut [SurfaceGroup]) {
    for (g, out) in out.iter_mut().enumerate() {
        let s = match f.single_slot(g) {
            Some(slot) => shader.surface(l, &one(l, rows, slot, f, g)),
            None => shader.surface(l, &many(l, rows, f, g)),
        };
        let values = [s.position.x, s.position.y, s.position.z, s.normal.x, s.normal.y, s.normal.z, s.uv.x, s.uv.y];
        for (value, out) in values.into_iter().zip(out) {
            value.store(out);
        }
    }
}

/// Sixteen fragments of one triangle.
#[inline(always)]
fn one<L: Lanes, V: Varying<L>>(l: L, rows: &[f32], slot: u32, f: &FragmentRange<'_>, g: usize) -> Fragment<L, V> {
    let pixel = Vec2 { x: l.f32_array(&f.x[g]), y: l.f32_array(&f.y[g]) };
    interpolate(l, OneTriangle(&rows[slot as usize..]), pixel)
}

/// Sixteen fragments, each of its own triangle.
#[inline(always)]
fn many<L: Lanes, V: Varying<L>>(l: L, rows: &[f32], f: &FragmentRange<'_>, g: usize) -> Fragment<L, V> {
    let pixel = Vec2 { x: l.f32_array(&f.x[g]), y: l.f32_array(&f.y[g]) };
    interpolate(l, ManyTriangles { rows, slots: l.u32_array(&f.slots[g]) }, pixel)
}
