//! Radiance HDR files (RGBE) to linear pixels: old and new run-length coding, all eight orientations.
//!
//! A pixel is three mantissas and one exponent: value = mantissa / 256 * 2^(exponent - 128), exact in `f32`.
//!
//! Source: Greg Ward, "Real Pixels", Graphics Gems II (1991), and the file `color.c` format notes of Radiance
//! ("Radiance File Formats", section "Picture File Format (.hdr suffix)").

use super::DecodedImage;
use super::reader::Reader;
use crate::{DecodeError, Format, Limits, RgbaF32Image};

type Rgbe = [u8; 4];

pub(super) fn decode(bytes: &[u8], limits: &Limits) -> Result<DecodedImage, DecodeError> {
    let mut reader = Reader::new(Format::Hdr, bytes);
    let scale = read_header(&mut reader)?;
    let layout = Layout::read(&mut reader)?;
    let (width, height) = layout.size();
    let count = limits.check(width, height, 16)?;
    // No line takes less than one pixel: a short file cannot claim many lines.
    if reader.rest().len() / 4 < layout.lines as usize {
        return Err(reader.malformed(format!("the file is too short for {count} pixels")));
    }

    let mut image = RgbaF32Image::new(width, height);
    let mut line = vec![[0; 4]; layout.line_length as usize];
    for i in 0..layout.lines {
        read_line(&mut reader, &mut line)?;
        for (j, &rgbe) in (0..).zip(&line) {
            let (x, y) = layout.place(i, j);
            image.set_pixel(x, y, linear(rgbe, scale));
        }
    }
    Ok(DecodedImage::RgbaF32(image))
}

/// Reads the lines before the size; gives the factor that undoes all EXPOSURE lines.
fn read_header(reader: &mut Reader<'_>) -> Result<f32, DecodeError> {
    if !reader.line("header")?.starts_with(b"#?") {
        return Err(DecodeError::malformed(Format::Hdr, 0, "the file begins with \"#?\""));
    }
    let mut exposure = 1.0_f32;
    loop {
        let line = reader.line("header")?;
        if line.is_empty() {
            let scale = 1.0 / exposure;
            return if scale.is_normal() {
                Ok(scale)
            } else {
                Err(reader.malformed("the product of exposures is in range"))
            };
        }
        let line = String::from_utf8_lossy(line);
        match line.split_once('=').map(|(name, value)| (name.trim(), value.trim())) {
            Some(("FORMAT", "32-bit_rle_rgbe")) => {}
            Some(("FORMAT", other)) => {
                return Err(DecodeError::unsupported(Format::Hdr, format!("pixels of format \"{other}\"")));
            }
            // Some writers put 0 where they know no exposure.
            Some(("EXPOSURE", value)) => {
                exposure *= value.parse().ok().filter(|&value: &f32| value > 0.0 && value.is_finite()).unwrap_or(1.0);
            }
            // Comments and other variables.
            _ => {}
        }
    }
}

/// The size line: which axis the lines of the file run along, and which way.
struct Layout {
    lines: u32,
    line_length: u32,
    /// Whether a line of the file is a row of the picture, not a column.
    is_row_major: bool,
    is_x_reversed: bool,
    is_y_reversed: bool,
}

impl Layout {
    /// Reads `-Y height +X width` and its variants.
    fn read(reader: &mut Reader<'_>) -> Result<Self, DecodeError> {
        let offset = reader.offset();
        let malformed = || DecodeError::malformed(Format::Hdr, offset, "the size line is like \"-Y 512 +X 768\"");
        let line = std::str::from_utf8(reader.line("size line")?).map_err(|_| malformed())?;
        let words: Vec<&str> = line.split_ascii_whitespace().collect();
        let [first_axis, first, second_axis, second] = words[..] else { return Err(malformed()) };
        let (Ok(lines), Ok(line_length)) = (first.parse::<u32>(), second.parse::<u32>()) else {
            return Err(malformed());
        };
        if lines == 0 || line_length == 0 {
            return Err(malformed());
        }
        let is_row_major = match (first_axis, second_axis) {
            ("-Y" | "+Y", "-X" | "+X") => true,
            ("-X" | "+X", "-Y" | "+Y") => false,
            _ => return Err(malformed()),
        };
        let has = |axis| first_axis == axis || second_axis == axis;
        // Y points up, so rows from the top are -Y.
        Ok(Self { lines, line_length, is_row_major, is_x_reversed: has("-X"), is_y_reversed: has("+Y") })
    }

    /// Width and height.
    fn size(&self) -> (u32, u32) {
        if self.is_row_major { (self.line_length, self.lines) } else { (self.lines, self.line_length) }
    }

    /// Column and row of pixel `j` of line `i`.
    fn place(&self, i: u32, j: u32) -> (u32, u32) {
        let (width, height) = self.size();
        let (x, y) = if self.is_row_major { (j, i) } else { (i, j) };
        (if self.is_x_reversed { width - 1 - x } else { x }, if self.is_y_reversed { height - 1 - y } else { y })
    }
}

fn read_line(reader: &mut Reader<'_>, line: &mut [Rgbe]) -> Result<(), DecodeError> {
    // The new coding announces itself by a pixel that no old file has: 2, 2, and the length of the line.
    if let [2, 2, high @ 0..=127, low, ..] = *reader.rest()
        && usize::from(u16::from_be_bytes([high, low])) == line.len()
    {
        reader.take(4, "pixels")?;
        return (0..4).try_for_each(|channel| read_channel(reader, line, channel));
    }
    read_old_line(reader, line)
}

/// One channel of a line: a count up to 128 and that many values, or a count over 128 and one value to repeat.
fn read_channel(reader: &mut Reader<'_>, line: &mut [Rgbe], channel: usize) -> Result<(), DecodeError> {
    let mut start = 0;
    while start < line.len() {
        let head = usize::from(reader.u8("pixels")?);
        let (length, is_run) = if head > 128 { (head - 128, true) } else { (head, false) };
        if length == 0 || length > line.len() - start {
            return Err(reader.malformed("a run-length packet stays within its line"));
        }
        let pixels = &mut line[start..start + length];
        if is_run {
            let value = reader.u8("pixels")?;
            pixels.iter_mut().for_each(|pixel| pixel[channel] = value);
        } else {
            let values = reader.take(length, "pixels")?;
            pixels.iter_mut().zip(values).for_each(|(pixel, &value)| pixel[channel] = value);
        }
        start += length;
    }
    Ok(())
}

/// A line of whole pixels, in which 1, 1, 1, n repeats the last pixel n times, and each directly following such pixel
/// counts 256 times more than the one before.
fn read_old_line(reader: &mut Reader<'_>, line: &mut [Rgbe]) -> Result<(), DecodeError> {
    let mut start = 0;
    let mut shift = 0;
    while start < line.len() {
        let pixel: Rgbe = reader.array("pixels")?;
        if let [1, 1, 1, count] = pixel {
            let length = usize::from(count).checked_shl(shift).unwrap_or(usize::MAX);
            if start == 0 || shift > 16 || length > line.len() - start {
                return Err(reader.malformed("a run repeats a pixel of its line and stays within it"));
            }
            let previous = line[start - 1];
            line[start..start + length].fill(previous);
            start += length;
            shift += 8;
        } else {
            line[start] = pixel;
            start += 1;
            shift = 0;
        }
    }
    Ok(())
}

/// Linear light; opaque. Exact but for `scale`.
fn linear([r, g, b, exponent]: Rgbe, scale: f32) -> [f32; 4] {
    if exponent == 0 {
        return [0.0, 0.0, 0.0, 1.0];
    }
    // 2^(exponent - 136): a double has room for all of them.
    let unit = f64::from_bits((u64::from(exponent) + (1023 - 136)) << 52);
    #[expect(clippy::cast_possible_truncation, reason = "8 bits of mantissa and an exponent in the range of f32")]
    let value = |mantissa: u8| ((f64::from(mantissa) * unit) as f32 * scale).min(f32::MAX);
    [value(r), value(g), value(b), 1.0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::samples;

    fn image(bytes: &[u8]) -> RgbaF32Image {
        decode(bytes, &Limits::default()).unwrap().into_linear()
    }

    fn error(text: &str) -> String {
        decode(text.as_bytes(), &Limits::default()).unwrap_err().to_string()
    }

    #[test]
    fn new_runs_and_exposure_are_undone() {
        let image = image(&samples::hdr());
        assert_eq!((image.width(), image.height()), (8, 2));
        // Exponent 130: units of 2^-6, halved by the exposure of 2.
        assert_eq!(image.pixel(0, 0), [1.0, 0.0, 1.0 / 128.0, 1.0]);
        assert_eq!(image.pixel(2, 1), [1.0, 20.0 / 128.0, 3.0 / 128.0, 1.0]);
        assert_eq!(image.pixel(7, 1), [1.0, 70.0 / 128.0, 4.0 / 128.0, 1.0]);
    }

    #[test]
    fn old_runs_and_rows_from_the_bottom_are_undone() {
        let image = image(&samples::hdr_old());
        assert_eq!((image.width(), image.height()), (5, 2));
        assert!(image.row(1).iter().all(|&pixel| pixel == [1.0, 0.5, 0.25, 1.0]));
        assert!(image.row(0).iter().all(|&pixel| pixel == [1.0 / 256.0, 2.0 / 256.0, 3.0 / 256.0, 1.0]));
    }

    #[test]
    fn chained_old_runs_count_in_higher_digits() {
        let mut file = b"#?RADIANCE\n\n-Y 1 +X 600\n".to_vec();
        // One pixel, 87 more, and 2 * 256 more.
        file.extend([128, 0, 0, 129, 1, 1, 1, 87, 1, 1, 1, 2]);
        assert!(image(&file).row(0).iter().all(|&pixel| pixel == [1.0, 0.0, 0.0, 1.0]));
    }

    #[test]
    fn all_eight_orientations_are_honored() {
        // The pixels are numbered in file order; the first line of the file is 0, 1, 2.
        let body: Vec<u8> = (0..6).flat_map(|i| [i, 0, 0, 136]).collect();
        for (size_line, rows) in [
            ("-Y 2 +X 3", vec![[0, 1, 2], [3, 4, 5]]),
            ("-Y 2 -X 3", vec![[2, 1, 0], [5, 4, 3]]),
            ("+Y 2 +X 3", vec![[3, 4, 5], [0, 1, 2]]),
            ("+Y 2 -X 3", vec![[5, 4, 3], [2, 1, 0]]),
        ] {
            let file = [b"#?RADIANCE\n\n", size_line.as_bytes(), b"\n", &body].concat();
            check_numbers(&file, &rows.concat());
        }
        for (size_line, rows) in [
            ("+X 2 -Y 3", vec![[0, 3], [1, 4], [2, 5]]),
            ("+X 2 +Y 3", vec![[2, 5], [1, 4], [0, 3]]),
            ("-X 2 -Y 3", vec![[3, 0], [4, 1], [5, 2]]),
            ("-X 2 +Y 3", vec![[5, 2], [4, 1], [3, 0]]),
        ] {
            let file = [b"#?RADIANCE\n\n", size_line.as_bytes(), b"\n", &body].concat();
            check_numbers(&file, &rows.concat());
        }
    }

    fn check_numbers(file: &[u8], expected: &[u8]) {
        let found: Vec<f32> = image(file).pixels().iter().map(|pixel| pixel[0]).collect();
        assert_eq!(found, expected.iter().map(|&i| f32::from(i)).collect::<Vec<_>>());
    }

    #[test]
    fn bad_headers_say_which_rule_they_break() {
        for (text, part) in [
            (
                "#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n",
                "unsupported HDR: pixels of format \"32-bit_rle_xyze\"",
            ),
            ("#?RADIANCE\n\n-Y 1 +Y 1\n....", "malformed HDR at byte 12: the size line"),
            ("#?RADIANCE\n\n-Y 0 +X 1\n....", "the size line"),
            ("#?RADIANCE\n\n-Y 1 +X\n....", "the size line"),
            ("#?RADIANCE\n\n-Y 9 +X 1\n....", "too short for 9 pixels"),
            ("#?RADIANCE\n\n-Y 1 +X 2\n\x01\x01\x01\x02", "repeats a pixel of its line"),
            ("#?RADIANCE\nEXPOSURE=1e38\nEXPOSURE=1e38\n\n-Y 1 +X 1\n....", "exposures"),
        ] {
            let error = error(text);
            assert!(error.contains(part), "{error}");
        }
    }

    #[test]
    fn meaningless_exposures_are_ignored() {
        for exposure in ["0", "-1", "nan", "inf", "much"] {
            let file = format!("#?RADIANCE\nEXPOSURE={exposure}\n\n-Y 1 +X 1\n\x40\x20\x10\x7f");
            assert_eq!(image(file.as_bytes()).pixel(0, 0), [0.125, 0.0625, 0.03125, 1.0]);
        }
    }
}
