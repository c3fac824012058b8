//! Conversions between numbers, where rounding and saturation are meant.

/// Exact up to 2^53.
#[expect(clippy::cast_precision_loss, reason = "pixels, samples and texels are far below 2^53")]
pub(super) fn to_f64(n: usize) -> f64 {
    n as f64
}

/// Toward zero; 0 for NaN and below.
#[expect(clippy::cast_possible_truncation, reason = "casts from float saturate")]
#[expect(clippy::cast_sign_loss, reason = "casts from float saturate")]
pub(super) fn to_usize(x: f64) -> usize {
    x as usize
}

/// Toward zero; 0 for NaN and below, 255 above.
#[expect(clippy::cast_possible_truncation, reason = "casts from float saturate")]
#[expect(clippy::cast_sign_loss, reason = "casts from float saturate")]
pub(super) fn to_u8(x: f64) -> u8 {
    x as u8
}

/// To the nearest.
#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
pub(super) fn to_f32(x: f64) -> f32 {
    x as f32
}
