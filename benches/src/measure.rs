//! Timing of frames: a scene and a configuration in, one line of JSON out.
//!
//! Three frames are drawn first and not timed. The j-th timed frame shows frame 7 j of the orbit: 7 and 36 have no
//! common factor, so that any number of frames samples the whole orbit. Pictures end up in ordinary memory, as
//! `readback: true` says.

use crate::clock::process_cpu_time;
use crate::scene::{BenchScene, FRAMES};
use crate::shot;
use core::fmt::Write;
use std::time::{Duration, Instant};
use trigon::pipeline::{Frame, FrameError, Picture, Renderer};

/// Frames that are drawn but not timed.
const WARM_UP: u32 = 3;

/// Step between timed frames, in frames of the orbit.
const STRIDE: u32 = 7;

/// How long to measure.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Budget {
    /// Timed frames.
    pub frames: u32,
    /// Stop after this long, but not before three frames.
    pub longest: Duration,
}

/// What was measured.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Measurement {
    /// Wall time of each frame, ascending.
    wall: Vec<Duration>,
    /// Processor time of each frame, ascending; empty where the system does not tell.
    cpu: Vec<Duration>,
    geometry: Duration,
    tiles: Duration,
    /// Of the picture of orbit frame 0, the first timed one: see [`picture_hash`].
    hash: u64,
}

/// Draws and times frames.
///
/// # Errors
/// The frame is too large.
pub fn measure(
    renderer: &mut Renderer,
    scene: &BenchScene,
    frame: &Frame,
    budget: Budget,
) -> Result<Measurement, FrameError> {
    let mut picture = Picture::default();
    for i in 0..WARM_UP {
        shot::draw(renderer, scene, frame, 5 * i, &mut picture)?;
    }
    let mut m = Measurement::default();
    let started = Instant::now();
    for j in 0..budget.frames {
        let (cpu, wall) = (process_cpu_time(), Instant::now());
        let statistics = shot::draw(renderer, scene, frame, STRIDE * j % FRAMES, &mut picture)?;
        m.wall.push(wall.elapsed());
        m.cpu.extend(process_cpu_time().zip(cpu).map(|(now, then)| now - then));
        m.geometry += statistics.geometry_time;
        m.tiles += statistics.tile_time;
        if j == 0 {
            m.hash = picture_hash(&picture);
        }
        if j >= 2 && started.elapsed() > budget.longest {
            break;
        }
    }
    m.wall.sort_unstable();
    m.cpu.sort_unstable();
    Ok(m)
}

impl Measurement {
    /// The measured values as members of a JSON object, without braces. Times are milliseconds a frame.
    #[must_use]
    pub fn to_json_members(&self) -> String {
        let mut out = String::new();
        let mut member = |name: &str, value: Option<Duration>| {
            // Writing to a string cannot fail.
            let _ = match value {
                Some(time) => write!(out, "\"{name}\": {:.3}, ", time.as_secs_f64() * 1e3),
                None => write!(out, "\"{name}\": null, "),
            };
        };
        member("min_ms", quantile(&self.wall, 0));
        member("p10_ms", quantile(&self.wall, 10));
        member("median_ms", quantile(&self.wall, 50));
        member("p90_ms", quantile(&self.wall, 90));
        member("cpu_ms", mean(&self.cpu));
        member("cpu_min_ms", quantile(&self.cpu, 0));
        member("cpu_median_ms", quantile(&self.cpu, 50));
        let frames = u32::try_from(self.wall.len()).ok().filter(|frames| *frames > 0);
        member("geometry_ms", frames.map(|frames| self.geometry / frames));
        member("tile_ms", frames.map(|frames| self.tiles / frames));
        let _ = write!(out, "\"readback\": true, \"frames\": {}, \"hash\": \"{:016x}\"", self.wall.len(), self.hash);
        out
    }
}

/// The value below which `percent` of the values lie.
fn quantile(sorted: &[Duration], percent: usize) -> Option<Duration> {
    let last = sorted.len().checked_sub(1)?;
    Some(sorted[(last * percent + 50) / 100])
}

fn mean(values: &[Duration]) -> Option<Duration> {
    let count = u32::try_from(values.len()).ok().filter(|count| *count > 0)?;
    Some(values.iter().sum::<Duration>() / count)
}

/// The 64-bit FNV-1a hash of the 8-bit colours: red, green, blue, alpha, rows from the top. Zero without colours.
#[must_use]
pub fn picture_hash(picture: &Picture) -> u64 {
    let Some(color) = &picture.color else { return 0 };
    color
        .values()
        .as_flattened()
        .iter()
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles() {
        let values: Vec<_> = (0..=10).map(Duration::from_millis).collect();
        for (percent, expected) in [(0, 0), (10, 1), (50, 5), (90, 9), (100, 10)] {
            assert_eq!(quantile(&values, percent), Some(Duration::from_millis(expected)));
        }
        assert_eq!(quantile(&[], 50), None);
        assert_eq!(mean(&values), Some(Duration::from_millis(5)));
    }

    #[test]
    fn members_are_json() {
        let m = Measurement { wall: vec![Duration::from_micros(1500)], hash: 0xab, ..Measurement::default() };
        let text = m.to_json_members();
        assert!(text.contains("\"median_ms\": 1.500, ") && text.contains("\"cpu_ms\": null"), "{text}");
        assert!(text.ends_with("\"frames\": 1, \"hash\": \"00000000000000ab\""), "{text}");
    }
}
