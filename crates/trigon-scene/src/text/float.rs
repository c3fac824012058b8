//! Decimal text to the nearest `f32`: decimal digits and an exponent in, correctly rounded bits out.
//!
//! Nearly every number in a mesh file has at most 15 significant digits and a small exponent. Then digits and power of
//! ten are both exact in `f64` and one division or product gives the correctly rounded `f64` (Clinger, "How to Read
//! Floating Point Numbers Accurately", 1990). Rounding that to `f32` is correct too, unless it falls exactly half-way
//! between two `f32`, where the first rounding may hide the side: those, and all other numbers, go to `str::parse`.

/// Powers of ten that are exact in `f64`.
const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// The `f32` nearest to `digits * 10^exponent`, or `None` if the quick way cannot prove it.
#[inline]
pub(super) fn nearest_f32(digits: u64, exponent: i32) -> Option<f32> {
    if digits > 1 << 53 {
        return None;
    }
    let power = *POWERS_OF_TEN.get(usize::try_from(exponent.unsigned_abs()).ok()?)?;
    #[expect(clippy::cast_precision_loss, reason = "at most 2^53, so exact")]
    let digits = digits as f64;
    let value = if exponent < 0 { digits / power } else { digits * power };
    // The bits of an f64 that f32 drops; exactly half a unit in the last place is the doubtful case. The result is
    // zero or within 1e-22..=1e38, so neither side is subnormal or overflows.
    const DROPPED: u64 = (1 << 29) - 1;
    const HALF: u64 = 1 << 28;
    if value.to_bits() & DROPPED == HALF {
        return None;
    }
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    Some(value as f32)
}

/// The value of one whole token by the standard library, for what the quick way leaves.
///
/// Beyond Rust's syntax this reads the names that C runtimes print: `1.#INF`, `-1.#IND`, `1.#QNAN`, `nan(ind)`.
#[cold]
pub(super) fn parse_token(token: &[u8]) -> Option<f32> {
    let text = std::str::from_utf8(token).ok()?;
    if let Ok(value) = text.parse::<f32>() {
        return Some(value);
    }
    let lower = text.to_ascii_lowercase();
    let (negative, name) = match lower.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, lower.strip_prefix('+').unwrap_or(&lower)),
    };
    let value = match name {
        _ if name.starts_with("1.#inf") => f32::INFINITY,
        _ if name.starts_with("1.#") || name.starts_with("nan(") => f32::NAN,
        _ => return None,
    };
    Some(if negative { -value } else { value })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A 64-bit generator (SplitMix64) for property tests.
    fn next(state: &mut u64) -> u64 {
        *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = *state;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    #[test]
    fn agrees_with_the_standard_library_wherever_it_answers() {
        let mut state = 1;
        let mut answered = 0;
        for _ in 0..300_000 {
            let digits = next(&mut state) >> (next(&mut state) % 64);
            let exponent = i32::try_from(next(&mut state) % 50).unwrap() - 25;
            if let Some(value) = nearest_f32(digits, exponent) {
                let expected: f32 = format!("{digits}e{exponent}").parse().unwrap();
                assert_eq!(value.to_bits(), expected.to_bits(), "{digits}e{exponent}");
                answered += 1;
            }
        }
        assert!(answered > 200_000, "the quick way answered only {answered} times");
    }

    #[test]
    fn leaves_half_way_cases_alone() {
        // 2^24 + 1 lies exactly between two f32.
        assert_eq!(nearest_f32(16_777_217, 0), None);
        assert_eq!(nearest_f32(16_777_216, 0), Some(16_777_216.0));
        // Just above half-way in decimal, on the half-way point after rounding to f64.
        let text = "1.000000059604644775390625000000001";
        assert_eq!(parse_token(text.as_bytes()), Some(1.000_000_1));
    }

    #[test]
    fn reads_the_names_of_c_runtimes() {
        assert_eq!(parse_token(b"-1.#INF"), Some(f32::NEG_INFINITY));
        assert!(parse_token(b"1.#IND").is_some_and(f32::is_nan));
        assert!(parse_token(b"nan").is_some_and(f32::is_nan));
        assert_eq!(parse_token(b"+inf"), Some(f32::INFINITY));
        assert_eq!(parse_token(b"3.1+e2"), None);
    }
}
