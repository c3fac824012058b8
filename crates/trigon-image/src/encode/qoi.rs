//! QOI files: three channels for opaque pictures, else four.
//!
//! Source: The Quite OK Image Format, version 1.0 (2022), qoiformat.org.

use crate::Rgba8Image;
use crate::decode::qoi_hash;

/// The longest run of one byte; the two lengths after it would be the heads of literal colors.
const LONGEST_RUN: u8 = 62;

pub(super) fn encode(image: &Rgba8Image) -> Vec<u8> {
    let mut file = b"qoif".to_vec();
    file.extend(image.width().to_be_bytes());
    file.extend(image.height().to_be_bytes());
    let channels = if image.is_opaque() { 3 } else { 4 };
    // The last 0: sRGB with linear alpha.
    file.extend([channels, 0]);

    let mut seen = [[0_u8; 4]; 64];
    let mut previous = [0, 0, 0, u8::MAX];
    let mut run = 0;
    for &pixel in image.pixels() {
        if pixel == previous {
            run += 1;
            if run == LONGEST_RUN {
                flush_run(&mut run, &mut file);
            }
            continue;
        }
        flush_run(&mut run, &mut file);
        let place = qoi_hash(pixel);
        match u8::try_from(place) {
            Ok(index) if seen[place] == pixel => file.push(index),
            _ => append_color(previous, pixel, &mut file),
        }
        seen[place] = pixel;
        previous = pixel;
    }
    flush_run(&mut run, &mut file);
    file.extend([0, 0, 0, 0, 0, 0, 0, 1]);
    file
}

fn flush_run(run: &mut u8, file: &mut Vec<u8>) {
    if *run > 0 {
        file.push(0xc0 | (*run - 1));
        *run = 0;
    }
}

/// The shortest form: a small difference, a difference about that of green, or the color itself.
fn append_color(previous: [u8; 4], pixel: [u8; 4], file: &mut Vec<u8>) {
    let [r, g, b, a] = pixel;
    if a != previous[3] {
        return file.extend([0xff, r, g, b, a]);
    }
    let [dr, dg, db] = [0, 1, 2].map(|i| pixel[i].wrapping_sub(previous[i]));
    // Biased, so that one comparison finds whether a difference fits.
    let small = [dr, dg, db].map(|d| d.wrapping_add(2));
    let green = dg.wrapping_add(32);
    let [red, blue] = [dr, db].map(|d| d.wrapping_sub(dg).wrapping_add(8));
    if small.iter().all(|&d| d < 4) {
        file.push(0x40 | small[0] << 4 | small[1] << 2 | small[2]);
    } else if green < 64 && red < 16 && blue < 16 {
        file.extend([0x80 | green, red << 4 | blue]);
    } else {
        file.extend([0xfe, r, g, b]);
    }
}
