//! The recorder: one per thread, idle unless the pipeline watches lanes.
//!
//! In: values of sixteen lanes, from shading code. Out: the notes of the watched lanes. The code that notes does not
//! know which lanes are watched, nor for what.

use super::note::{LevelRead, Note, Tap, TexelRead, TextureRead};
use crate::lanes::LANES;
use std::cell::{Cell, RefCell};

thread_local! {
    static IS_WATCHING: Cell<bool> = const { Cell::new(false) };
    static RECORDER: RefCell<Recorder> = const { RefCell::new(Recorder { lanes: Vec::new(), group: 0 }) };
}

struct Recorder {
    lanes: Vec<WatchedLane>,
    /// Number of the sixteen fragments that are being shaded.
    group: usize,
}

/// A lane of a group of fragments, and what was said about it.
struct WatchedLane {
    group: usize,
    lane: usize,
    notes: Vec<Note>,
    /// The sampler is at a point that other lanes alone need.
    skips_tap: bool,
}

/// Values of sixteen lanes.
type Lane = [f32; LANES];

/// Watches these lanes, given as numbers of group and lane, until [`take`].
pub(crate) fn watch(lanes: &[(usize, usize)]) {
    let watched = |&(group, lane): &(usize, usize)| WatchedLane { group, lane, notes: Vec::new(), skips_tap: false };
    RECORDER.with_borrow_mut(|recorder| {
        recorder.lanes = lanes.iter().map(watched).collect();
        recorder.group = 0;
    });
    IS_WATCHING.set(!lanes.is_empty());
}

/// Watches no longer; the notes of each lane, in the order in which they were given to [`watch`].
pub(crate) fn take() -> Vec<Vec<Note>> {
    IS_WATCHING.set(false);
    RECORDER.with_borrow_mut(|recorder| recorder.lanes.drain(..).map(|lane| lane.notes).collect())
}

/// True between [`watch`] and [`take`].
pub(crate) fn is_watching() -> bool {
    IS_WATCHING.get()
}

/// The fragments of group `group` are about to be shaded.
pub(crate) fn enter_group(group: usize) {
    RECORDER.with_borrow_mut(|recorder| recorder.group = group);
}

/// A heading.
pub(crate) fn note_topic(name: &'static str, number: Option<u32>) {
    each_lane(|watched| watched.notes.push(Note::Topic { name, number }));
}

/// A named value: its components, each of sixteen lanes.
pub(crate) fn note(name: &'static str, components: &[Lane]) {
    each_lane(|watched| {
        let values = components.iter().map(|values| values[watched.lane]).collect();
        watched.notes.push(Note::Value { name, values });
    });
}

/// A texture is about to be read at `uv`.
pub(crate) fn note_texture(
    size: [u32; 2],
    levels: u32,
    uv: &[Lane; 2],
    footprint: Option<(&[Lane; 2], &[Lane; 2])>,
    lod: &Lane,
) {
    each_lane(|watched| {
        let at = |pair: &[Lane; 2]| pair.map(|values| values[watched.lane]);
        let footprint = footprint.map(|(dx, dy)| [at(dx), at(dy)]);
        let (uv, lod) = (at(uv), lod[watched.lane]);
        let read = TextureRead { size, levels, uv, footprint, lod, taps: Vec::new(), color: [0.0; 4] };
        watched.notes.push(Note::Texture(read));
        watched.skips_tap = false;
    });
}

/// The next point of the read; one bit of `wanted` for each lane that takes it.
pub(crate) fn note_tap(wanted: u16, uv: &[Lane; 2]) {
    each_lane(|watched| {
        watched.skips_tap = wanted >> watched.lane & 1 == 0;
        let tap = Tap { uv: uv.map(|values| values[watched.lane]), levels: Vec::new() };
        if let Some(read) = watched.texture() {
            read.taps.push(tap);
        }
    });
}

/// The next level of the point; `size` by level. One that gives nothing is left out.
pub(crate) fn note_level(level: &[i32; LANES], size: impl Fn(u32) -> [u32; 2], weight: &Lane) {
    each_lane(|watched| {
        let (level, weight) = (level[watched.lane].cast_unsigned(), weight[watched.lane]);
        let size = size(level);
        if let Some(tap) = watched.texture().and_then(|read| read.taps.last_mut()) {
            tap.levels.push(LevelRead { level, size, weight, texels: Vec::new() });
        }
    });
}

/// The next texel of the level. `place` is its column and row; `color` takes the level and these, `border` a lane.
pub(crate) fn note_texel(
    place: [&[i32; LANES]; 2],
    weight: &Lane,
    color: impl Fn(u32, u32, u32) -> [f32; 4],
    border: impl Fn(usize) -> Option<[f32; 4]>,
) {
    each_lane(|watched| {
        let lane = watched.lane;
        let [column, row] = place.map(|values| values[lane].cast_unsigned());
        if let Some(level) = watched.texture().and_then(|read| read.taps.last_mut()?.levels.last_mut()) {
            let border = border(lane);
            let color = border.unwrap_or_else(|| color(level.level, column, row));
            level.texels.push(TexelRead { column, row, weight: weight[lane], color, is_border: border.is_some() });
        }
    });
}

/// The result of the read.
pub(crate) fn note_texture_color(color: &[Lane; 4]) {
    each_lane(|watched| {
        watched.skips_tap = false;
        let color = color.map(|values| values[watched.lane]);
        if let Some(read) = watched.texture() {
            read.color = color;
            for tap in &mut read.taps {
                tap.levels.retain(|level| level.weight != 0.0);
            }
        }
    });
}

impl WatchedLane {
    /// The read that is going on, unless its present point is for other lanes.
    fn texture(&mut self) -> Option<&mut TextureRead> {
        match self.notes.last_mut() {
            Some(Note::Texture(read)) if !self.skips_tap => Some(read),
            _ => None,
        }
    }
}

/// Calls `add` for every watched lane of the present group.
fn each_lane(mut add: impl FnMut(&mut WatchedLane)) {
    RECORDER.with_borrow_mut(|recorder| {
        let group = recorder.group;
        recorder.lanes.iter_mut().filter(|watched| watched.group == group).for_each(&mut add);
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn watched_lanes_get_their_own_values_and_no_others() {
        let numbers: Lane = core::array::from_fn(|lane| lane as f32);
        watch(&[(0, 3), (1, 5)]);
        assert!(is_watching());
        enter_group(0);
        note("a", &[numbers]);
        enter_group(1);
        note_topic("t", Some(2));
        note("b", &[numbers, numbers.map(|n| n * 10.0)]);
        enter_group(2);
        note("c", &[numbers]);
        let notes = take();
        assert_eq!(notes[0], [Note::Value { name: "a", values: vec![3.0] }]);
        let topic = Note::Topic { name: "t", number: Some(2) };
        assert_eq!(notes[1], [topic, Note::Value { name: "b", values: vec![5.0, 50.0] }]);
        assert!(!is_watching() && take().is_empty());
    }
}
