//! Which primitive belongs to which part, material and smoothing group: state changes in, submeshes out.
//!
//! Files may change the material with every face. Primitives are therefore grouped by (part, material), in order of
//! first use and stable within a group, so that there are never more submeshes than distinct pairs.

use super::block::EventKind;
use crate::scene::{MaterialId, Part, Submesh};
use crate::text::decode_name;
use std::collections::HashMap;
use std::hash::Hash;

/// Runs of primitives between state changes, in file order.
#[derive(Default)]
pub(super) struct Runs<'a> {
    state: State<'a>,
    /// State index and the numbers of triangles, segments and points where it begins to hold.
    starts: Vec<([u32; 2], [usize; 3])>,
    parts: Interner<(&'a [u8], &'a [u8])>,
    materials: Interner<Option<&'a [u8]>>,
    /// Line of the first use of each material, zero-based.
    material_lines: Vec<u64>,
    /// Smoothing group and the triangle where it begins to hold.
    groups: Vec<(u32, usize)>,
}

#[derive(Clone, Copy, Default)]
struct State<'a> {
    object: &'a [u8],
    group: &'a [u8],
    material: Option<&'a [u8]>,
    material_line: u64,
}

/// Numbers distinct values in order of appearance.
struct Interner<T> {
    ids: HashMap<T, u32>,
    values: Vec<T>,
}

impl<T> Default for Interner<T> {
    fn default() -> Self {
        Self { ids: HashMap::new(), values: Vec::new() }
    }
}

impl<T: Copy + Eq + Hash> Interner<T> {
    fn id(&mut self, value: T) -> u32 {
        *self.ids.entry(value).or_insert_with(|| {
            self.values.push(value);
            u32::try_from(self.values.len() - 1).unwrap_or(u32::MAX)
        })
    }
}

impl<'a> Runs<'a> {
    /// A state change on zero-based `line`, before which there are `before` triangles, segments and points.
    pub(super) fn event(&mut self, kind: EventKind, name: &'a [u8], line: u64, before: [usize; 3]) {
        match kind {
            EventKind::Smoothing => return self.groups.push((smoothing_group(name), before[0])),
            EventKind::Library => return,
            _ => self.primitives_until(before),
        }
        match kind {
            EventKind::Object => self.state.object = name,
            EventKind::Group => self.state.group = name,
            _ => {
                self.state.material = Some(name);
                self.state.material_line = line;
            }
        }
    }

    /// Ends the current run at these numbers of primitives.
    pub(super) fn primitives_until(&mut self, end: [usize; 3]) {
        let start = self.starts.last().map_or([0; 3], |&(_, end)| end);
        if start != end {
            let part = self.parts.id((self.state.object, self.state.group));
            let material = self.materials.id(self.state.material);
            if self.material_lines.len() <= material as usize {
                self.material_lines.push(self.state.material_line);
            }
            match self.starts.last_mut() {
                Some((key, run_end)) if *key == [part, material] => *run_end = end,
                _ => self.starts.push(([part, material], end)),
            }
        }
    }

    /// The names of the parts.
    pub(super) fn parts(&self) -> Vec<Part> {
        let part = |&(object, group): &(&[u8], &[u8])| {
            let group = decode_name(group);
            let group = group.split_ascii_whitespace().collect::<Vec<_>>().join(" ");
            Part { object: decode_name(object).into_owned(), group }
        };
        self.parts.values.iter().map(part).collect()
    }

    /// The material names in use, each with the zero-based line of its first use; `None` is no material statement.
    pub(super) fn materials(&self) -> impl Iterator<Item = (Option<&'a [u8]>, u64)> + '_ {
        self.materials.values.iter().copied().zip(self.material_lines.iter().copied())
    }

    /// The smoothing group of each of `triangles` triangles, if the file has any smoothing statement.
    pub(super) fn smoothing_groups(&self, triangles: usize) -> Option<Vec<u32>> {
        let mut groups = vec![0; triangles];
        for (i, &(group, start)) in self.groups.iter().enumerate() {
            let end = self.groups.get(i + 1).map_or(triangles, |&(_, end)| end);
            groups.get_mut(start..end)?.fill(group);
        }
        (!self.groups.is_empty()).then_some(groups)
    }

    /// Sorts the primitives by submesh and describes the submeshes; `ids` are the scene's ids of [`Runs::materials`].
    pub(super) fn submeshes(
        &self,
        ids: &[MaterialId],
        triangles: &mut Vec<[u32; 3]>,
        segments: &mut Vec<[u32; 2]>,
        points: &mut Vec<u32>,
    ) -> Vec<Submesh> {
        let mut keys = Interner::default();
        let order: Vec<u32> = self.starts.iter().map(|&(key, _)| keys.id(key)).collect();
        let mut submeshes: Vec<Submesh> = keys
            .values
            .iter()
            .map(|&[part, material]| Submesh::new(part, ids.get(material as usize).copied().unwrap_or(MaterialId(0))))
            .collect();
        let run_ends = |list: usize| self.starts.iter().map(move |(_, end)| end[list]);
        let ranges = group(triangles, &order, keys.values.len(), run_ends(0));
        submeshes.iter_mut().zip(ranges).for_each(|(submesh, range)| submesh.triangles = range);
        let ranges = group(segments, &order, keys.values.len(), run_ends(1));
        submeshes.iter_mut().zip(ranges).for_each(|(submesh, range)| submesh.segments = range);
        let ranges = group(points, &order, keys.values.len(), run_ends(2));
        submeshes.iter_mut().zip(ranges).for_each(|(submesh, range)| submesh.points = range);
        submeshes
    }
}

/// Moves the runs of each key together, keys in order, runs of a key in order; the range of each key. `order` is the
/// key of each run, `ends` where each run ends.
fn group<T: Copy>(
    list: &mut Vec<T>,
    order: &[u32],
    keys: usize,
    ends: impl Iterator<Item = usize> + Clone,
) -> Vec<std::ops::Range<usize>> {
    let starts = std::iter::once(0).chain(ends.clone());
    let mut runs: Vec<_> =
        order.iter().copied().zip(starts.zip(ends)).map(|(key, (start, end))| (key, start..end)).collect();
    let is_sorted = runs.is_sorted_by_key(|(key, _)| *key);
    runs.sort_by_key(|(key, _)| *key);
    if !is_sorted {
        let sorted: Vec<T> = runs.iter().flat_map(|(_, run)| list[run.clone()].iter().copied()).collect();
        *list = sorted;
    }
    let mut ranges = vec![0..0; keys];
    let mut at = 0;
    for (key, run) in runs {
        let range = &mut ranges[key as usize];
        if range.start == range.end {
            *range = at..at;
        }
        at += run.len();
        range.end = at;
    }
    ranges
}

/// The number of a smoothing statement; `off` and what is not a number are 0.
fn smoothing_group(name: &[u8]) -> u32 {
    std::str::from_utf8(name).ok().and_then(|text| text.trim().parse().ok()).unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn alternating_materials_are_grouped_in_order_of_first_use() {
        let mut runs = Runs::default();
        for i in 0..10 {
            runs.event(EventKind::Material, if i % 2 == 0 { b"a" } else { b"b" }, 0, [i, 0, 0]);
        }
        runs.primitives_until([10, 0, 0]);
        let mut triangles: Vec<[u32; 3]> = (0..10).map(|i| [i; 3]).collect();
        let ids = [MaterialId(4), MaterialId(5)];
        let submeshes = runs.submeshes(&ids, &mut triangles, &mut Vec::new(), &mut Vec::new());
        let order: Vec<u32> = triangles.iter().map(|t| t[0]).collect();
        assert_eq!(order, [0, 2, 4, 6, 8, 1, 3, 5, 7, 9]);
        assert_eq!(submeshes.len(), 2);
        assert_eq!((submeshes[0].triangles.clone(), submeshes[0].material), (0..5, MaterialId(4)));
        assert_eq!((submeshes[1].triangles.clone(), submeshes[1].material), (5..10, MaterialId(5)));
    }

    #[test]
    fn smoothing_groups_hold_until_the_next_statement() {
        let mut runs = Runs::default();
        assert_eq!(runs.smoothing_groups(2), None);
        runs.event(EventKind::Smoothing, b"3", 0, [1, 0, 0]);
        runs.event(EventKind::Smoothing, b"off", 0, [3, 0, 0]);
        assert_eq!(runs.smoothing_groups(4), Some(vec![0, 3, 3, 0]));
    }
}
