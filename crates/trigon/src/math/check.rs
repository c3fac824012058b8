//! For the tests: a lane function applied to many inputs, at every SIMD level, and its largest error.

use crate::lanes::LANES;

/// `evaluate!(f, xs)` or `evaluate!(f, xs, ys)`: the results of lane function `f`, asserted to be the same bits at every
/// available level.
macro_rules! evaluate {
    ($f:path, $($inputs:expr),+) => {{
        let mut results: Option<Vec<f32>> = None;
        for level in $crate::lanes::SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
            let token = level.to_level().expect("the level is available");
            let inputs = [$($crate::math::check::padded(&$inputs)),+];
            let count = [$($inputs.len()),+][0];
            let mut out = vec![0.0; inputs[0].len() * $crate::lanes::LANES];
            $crate::lanes::dispatch!(token, l => $crate::math::check::apply!(l, $f, inputs, out, $($inputs),+));
            out.truncate(count);
            let same = results.get_or_insert_with(|| out.clone());
            let differs = same.iter().zip(&out).position(|(a, b)| a.to_bits() != b.to_bits());
            assert_eq!(differs, None, "first difference at {level}");
        }
        results.expect("there is a level")
    }};
}

macro_rules! apply {
    ($l:ident, $f:path, $inputs:ident, $out:ident, $x:expr) => {
        for (group, out) in $out.as_chunks_mut::<{ $crate::lanes::LANES }>().0.iter_mut().enumerate() {
            $f($crate::lanes::Lanes::f32_array($l, &$inputs[0][group])).store(out);
        }
    };
    ($l:ident, $f:path, $inputs:ident, $out:ident, $x:expr, $y:expr) => {
        for (group, out) in $out.as_chunks_mut::<{ $crate::lanes::LANES }>().0.iter_mut().enumerate() {
            let [x, y] = [&$inputs[0][group], &$inputs[1][group]];
            $f($crate::lanes::Lanes::f32_array($l, x), $crate::lanes::Lanes::f32_array($l, y)).store(out);
        }
    };
}

pub(super) use {apply, evaluate};

/// Groups of lanes, the last one filled up with 1.
pub(super) fn padded(values: &[f32]) -> Vec<[f32; LANES]> {
    values
        .chunks(LANES)
        .map(|chunk| {
            let mut group = [1.0; LANES];
            group[..chunk.len()].copy_from_slice(chunk);
            group
        })
        .collect()
}

/// Floats from `low` to `high`, `stride` bit patterns apart. Both of one sign.
pub(super) fn floats(low: f32, high: f32, stride: usize) -> Vec<f32> {
    (low.to_bits()..=high.to_bits()).step_by(stride).map(f32::from_bits).collect()
}

/// `count` evenly spaced values, both ends included.
pub(super) fn evenly(low: f32, high: f32, count: u16) -> Vec<f32> {
    (0..count).map(|i| low + (high - low) * (f32::from(i) / f32::from(count - 1))).collect()
}

/// The largest relative error.
pub(super) fn relative_error(results: &[f32], exact: impl Iterator<Item = f64>) -> f64 {
    results.iter().zip(exact).map(|(r, e)| ((f64::from(*r) - e) / e).abs()).fold(0.0, f64::max)
}

/// The largest absolute error.
pub(super) fn absolute_error(results: &[f32], exact: impl Iterator<Item = f64>) -> f64 {
    results.iter().zip(exact).map(|(r, e)| (f64::from(*r) - e).abs()).fold(0.0, f64::max)
}
