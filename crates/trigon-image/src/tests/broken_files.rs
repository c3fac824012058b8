//! Broken files: cut off anywhere, or with any byte changed. No decoder panics, takes more than the limits allow, or gives
//! a wrong picture for a file that was cut off.

use super::samples;
use crate::{DecodeError, Format, Limits, decode};

/// Small enough that a picture which gets past it by mistake is noticed.
fn limits() -> Limits {
    Limits::default().with_max_side(300).with_max_pixels(20_000).with_max_bytes(320_000)
}

#[test]
fn samples_are_valid() {
    for sample in samples::all() {
        let by_content = decode(&sample.bytes, None, &limits());
        let by_hint = decode(&sample.bytes, Some(sample.format), &limits());
        let image = by_hint.unwrap_or_else(|error| panic!("{}: {error}", sample.name));
        assert!(image.width() > 1 && image.height() > 1);
        if sample.format != Format::Tga {
            assert_eq!(by_content.unwrap(), image, "{}", sample.name);
        }
    }
}

#[test]
fn a_file_that_was_cut_off_is_an_error() {
    for sample in samples::all() {
        let whole = decode(&sample.bytes, Some(sample.format), &limits()).unwrap();
        for length in 0..sample.bytes.len() {
            match decode(&sample.bytes[..length], Some(sample.format), &limits()) {
                Err(DecodeError::Malformed { .. } | DecodeError::Unsupported { .. }) => {}
                // What is missing was not part of the picture: a checksum, an end mark, padding.
                Ok(image) if image == whole => {}
                other => panic!("{} cut to {length} of {}: {other:?}", sample.name, sample.bytes.len()),
            }
        }
    }
}

#[test]
fn changed_bytes_never_panic_or_exceed_the_limits() {
    for sample in samples::all() {
        for place in 0..sample.bytes.len() {
            for change in [0x01, 0x80, 0xff, 0x10] {
                let mut bytes = sample.bytes.clone();
                bytes[place] ^= change;
                check(&bytes, sample.format);
            }
        }
    }
}

#[test]
fn several_changed_bytes_never_panic_or_exceed_the_limits() {
    let mut seed = 12345_u64;
    let mut random = |below: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        usize::try_from(seed >> 33).unwrap() % below
    };
    for sample in samples::all() {
        for _ in 0..2000 {
            let mut bytes = sample.bytes.clone();
            for _ in 0..1 + random(6) {
                // Half of the changes hit the head of the file, where the sizes are.
                let range = if random(2) == 0 { bytes.len().min(64) } else { bytes.len() };
                let place = random(range);
                bytes[place] = [0, 1, 0x7f, 0x80, 0xff, u8::try_from(random(256)).unwrap()][random(6)];
            }
            if random(4) == 0 {
                let length = random(bytes.len());
                bytes.truncate(length);
            }
            check(&bytes, sample.format);
        }
    }
}

#[test]
fn a_wrong_hint_is_harmless() {
    for sample in samples::all() {
        for format in Format::all() {
            check(&sample.bytes, format);
            // Without its magic number the content is taken for what the hint says.
            check(&sample.bytes[1..], format);
        }
    }
}

#[test]
fn noise_is_never_a_picture_by_accident_of_a_panic() {
    let mut seed = 7_u32;
    for length in 0..600 {
        let noise: Vec<u8> = (0..length)
            .map(|_| {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                seed.to_be_bytes()[0]
            })
            .collect();
        Format::all().for_each(|format| check(&noise, format));
    }
}

#[test]
fn each_format_honors_the_limits() {
    for sample in samples::all() {
        let refused = decode(&sample.bytes, Some(sample.format), &Limits::default().with_max_pixels(5));
        assert!(matches!(refused, Err(DecodeError::LimitExceeded { .. })), "{}: {refused:?}", sample.name);
    }
}

#[test]
fn unknown_content_is_explained() {
    for (bytes, part) in [(&b""[..], "empty"), (b"<svg/>", "a TGA file needs its extension")] {
        let error = decode(bytes, None, &limits()).unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
}

fn check(bytes: &[u8], format: Format) {
    if let Ok(image) = decode(bytes, Some(format), &limits()) {
        limits().check(image.width(), image.height(), 4).unwrap();
    }
}
