//! Shaders behind one pointer: the pipeline draws many kinds of shader in one frame.
//!
//! In: batches of work for one shader. Out: positions, coefficients, colours. Each method enters the shader's code at
//! the frame's SIMD level once per batch.

use super::coefficients::{
    FragmentRows, MAX_COMPONENTS, Rows, TriangleGroup, compute, interpolate, inverse_w, record_quads,
};
use super::fragments::{ColorGroup, FragmentRange, SurfaceGroup};
use super::shader::{Fragment, Shader};
use super::varying::{CornerSink, Varying};
use crate::explain::{self, FragmentFacts, VaryingFacts};
use crate::geometry::ClipPositions;
use crate::lanes::{F32, LANES, Lanes, Quad, Vec2, dispatch};
use fearless_simd::{Fallback, Level};

/// Fragments of one draw, and the coefficients of its triangles.
pub struct FragmentBatch<'a> {
    pub(crate) records: &'a [Quad],
    pub(crate) fragments: FragmentRange<'a>,
    pub(crate) fetched: &'a mut FragmentRows,
}

/// A shader whose type is forgotten.
pub trait ErasedShader: Sync {
    /// Clip positions of the vertices `indices`.
    fn positions(&self, level: Level, indices: &[u32], out: &mut ClipPositions);
    /// Quads in the record of a triangle's coefficients.
    fn quads(&self) -> usize;
    /// Coefficients of up to sixteen triangles.
    fn coefficients(&self, level: Level, group: &TriangleGroup, rows: &mut Rows);
    /// Colours of fragments, one group of sixteen after the other.
    fn shade(&self, level: Level, batch: &mut FragmentBatch<'_>, out: &mut [ColorGroup]);
    /// Which fragments exist, one bit per lane.
    fn keep(&self, level: Level, batch: &mut FragmentBatch<'_>, out: &mut [u16]);
    /// Surfaces of fragments, for the outputs beside colour.
    fn surfaces(&self, level: Level, batch: &mut FragmentBatch<'_>, out: &mut [SurfaceGroup]);
    /// What the fragment in lane `lane` of group `group` is given.
    fn facts(&self, batch: &mut FragmentBatch<'_>, group: usize, lane: usize) -> FragmentFacts;
    /// See [`Shader::discards`].
    fn can_discard(&self) -> bool;
}

impl<S: Shader> ErasedShader for S {
    fn positions(&self, level: Level, indices: &[u32], out: &mut ClipPositions) {
        dispatch!(level, l => positions(l, self, indices, out));
    }

    fn quads(&self) -> usize {
        record_quads(<S::Varying<Fallback> as Varying<Fallback>>::COMPONENTS)
    }

    fn coefficients(&self, level: Level, group: &TriangleGroup, rows: &mut Rows) {
        dispatch!(level, l => compute(l, self, group, rows));
    }

    fn shade(&self, level: Level, batch: &mut FragmentBatch<'_>, out: &mut [ColorGroup]) {
        dispatch!(level, l => shade(l, self, batch.records, &batch.fragments, batch.fetched, out));
    }

    fn keep(&self, level: Level, batch: &mut FragmentBatch<'_>, out: &mut [u16]) {
        dispatch!(level, l => keep(l, self, batch.records, &batch.fragments, batch.fetched, out));
    }

    fn surfaces(&self, level: Level, batch: &mut FragmentBatch<'_>, out: &mut [SurfaceGroup]) {
        dispatch!(level, l => surfaces(l, self, batch.records, &batch.fragments, batch.fetched, out));
    }

    fn facts(&self, batch: &mut FragmentBatch<'_>, group: usize, lane: usize) -> FragmentFacts {
        // For people to read, so once for all levels: each gives the same bits.
        facts::<S>(Fallback::new(), batch, group, lane)
    }

    fn can_discard(&self) -> bool {
        self.discards()
    }
}

fn facts<S: Shader>(l: Fallback, batch: &mut FragmentBatch<'_>, group: usize, lane: usize) -> FragmentFacts {
    batch.fetched.forget();
    let f = fragment::<Fallback, S>(l, batch.fetched, batch.records, &batch.fragments, group);
    let mut names = Vec::new();
    <S::Varying<Fallback> as Varying<Fallback>>::names("", &mut names);
    let mut sink = FactSink { lane, values: Vec::with_capacity(names.len()) };
    Varying::write([f.varying, f.dx, f.dy], &mut sink);
    let at = |value: F32<Fallback>| value.to_array()[lane];
    FragmentFacts {
        point: [at(f.pixel.x), at(f.pixel.y)],
        barycentric: [at(f.barycentric.x), at(f.barycentric.y), at(f.barycentric.z)],
        inverse_w: at(inverse_w(l, batch.fetched, f.pixel)),
        depth: at(f.depth),
        is_front: f.front_facing.to_array()[lane],
        varyings: names
            .into_iter()
            .zip(sink.values)
            .map(|(name, [value, dx, dy])| VaryingFacts { name, value, dx, dy })
            .collect(),
    }
}

/// Takes one lane of a varying's components: values and both derivatives in place of three corners.
struct FactSink {
    lane: usize,
    values: Vec<[f32; 3]>,
}

impl CornerSink<Fallback> for FactSink {
    fn push(&mut self, components: [F32<Fallback>; 3]) {
        self.values.push(components.map(|component| component.to_array()[self.lane]));
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
fn shade<L: Lanes, S: Shader>(
    l: L,
    shader: &S,
    records: &[Quad],
    f: &FragmentRange<'_>,
    fetched: &mut FragmentRows,
    out: &mut [ColorGroup],
) {
    fetched.forget();
    for (g, out) in out.iter_mut().enumerate() {
        enter_group(l, g);
        let color = shader.fragment(l, &fragment::<L, S>(l, fetched, records, f, g));
        color.r.store(&mut out[0]);
        color.g.store(&mut out[1]);
        color.b.store(&mut out[2]);
        color.a.store(&mut out[3]);
    }
}

#[inline(always)]
fn keep<L: Lanes, S: Shader>(
    l: L,
    shader: &S,
    records: &[Quad],
    f: &FragmentRange<'_>,
    fetched: &mut FragmentRows,
    out: &mut [u16],
) {
    fetched.forget();
    for (g, out) in out.iter_mut().enumerate() {
        enter_group(l, g);
        *out = shader.keep(l, &fragment::<L, S>(l, fetched, records, f, g)).bits();
    }
}

#[inline(always)]
fn surfaces<L: Lanes, S: Shader>(
    l: L,
    shader: &S,
    records: &[Quad],
    f: &FragmentRange<'_>,
    fetched: &mut FragmentRows,
    out: &mut [SurfaceGroup],
) {
    fetched.forget();
    for (g, out) in out.iter_mut().enumerate() {
        let s = shader.surface(l, &fragment::<L, S>(l, fetched, records, f, g));
        let values = [s.position.x, s.position.y, s.position.z, s.normal.x, s.normal.y, s.normal.z, s.uv.x, s.uv.y];
        for (value, out) in values.into_iter().zip(out) {
            value.store(out);
        }
    }
}

/// Notes from here on are about this group.
#[inline(always)]
fn enter_group<L: Lanes>(l: L, group: usize) {
    if l.is_explaining() {
        explain::enter_group(group);
    }
}

/// Sixteen interpolated fragments.
#[inline(always)]
fn fragment<L: Lanes, S: Shader>(
    l: L,
    fetched: &mut FragmentRows,
    records: &[Quad],
    f: &FragmentRange<'_>,
    g: usize,
) -> Fragment<L, S::Varying<L>> {
    const { assert!(<S::Varying<L> as Varying<L>>::COMPONENTS <= MAX_COMPONENTS, "at most 32 varying components") };
    fetched.fetch(l, records, &f.slots[g], record_quads(<S::Varying<L> as Varying<L>>::COMPONENTS));
    let pixel = Vec2 { x: l.f32_array(&f.x[g]), y: l.f32_array(&f.y[g]) };
    interpolate(l, fetched, pixel)
}
