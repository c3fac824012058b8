//! Animations: frames in, one at a time; the bytes of an animated GIF or APNG out.
//!
//! Both formats store of a frame only the rectangle that differs from the frame before. Times are rounded to the unit of
//! the format, but the sum of all times is not: what one frame loses the next gains.

use std::time::Duration;

use super::EncodeOptions;
use super::apng::ApngWriter;
use super::gif::GifWriter;
use crate::{EncodeError, Format, Rgba8Image};

/// Writes an animation frame by frame. Memory holds the file so far and two frames (all frames for
/// [`GifPalette::Global`](super::GifPalette::Global)).
///
/// ```
/// use std::time::Duration;
/// use trigon_image::{AnimationEncoder, EncodeOptions, Format, Rgba8Image};
///
/// let mut animation = AnimationEncoder::new(Format::Gif, 8, 8, &EncodeOptions::default()).unwrap();
/// for gray in [0, 128, 255] {
///     let frame = Rgba8Image::filled(8, 8, [gray, gray, gray, 255]);
///     animation.push_frame(&frame, Duration::from_millis(40)).unwrap();
/// }
/// let file = animation.finish().unwrap();
/// assert!(file.starts_with(b"GIF89a"));
/// ```
#[derive(Debug)]
pub struct AnimationEncoder {
    format: Format,
    width: u32,
    height: u32,
    frame_count: u64,
    writer: Writer,
}

#[derive(Debug)]
enum Writer {
    Gif(Box<GifWriter>),
    Apng(Box<ApngWriter>),
}

impl AnimationEncoder {
    /// Starts an animation of `width * height` pixels as [`Format::Gif`] or [`Format::Png`] (APNG).
    ///
    /// # Errors
    /// If the format has no animations, or the size is zero or too large for it.
    pub fn new(format: Format, width: u32, height: u32, options: &EncodeOptions) -> Result<Self, EncodeError> {
        if width == 0 || height == 0 {
            return Err(EncodeError::invalid(format, "the picture has no pixels"));
        }
        let writer = match format {
            Format::Gif => Writer::Gif(Box::new(GifWriter::new(width, height, options)?)),
            Format::Png => Writer::Apng(Box::new(ApngWriter::new(width, height, options)?)),
            _ => return Err(EncodeError::unsupported(format, "animations; write GIF or PNG")),
        };
        Ok(Self { format, width, height, frame_count: 0, writer })
    }

    /// Adds a frame that stays for `delay`, rounded to 10 ms in a GIF and to 1 ms in an APNG.
    ///
    /// Most programs play a GIF frame of less than 20 ms for 100 ms.
    ///
    /// # Errors
    /// If the frame has another size than the animation.
    pub fn push_frame(&mut self, frame: &Rgba8Image, delay: Duration) -> Result<(), EncodeError> {
        if (frame.width(), frame.height()) != (self.width, self.height) {
            let rule = format!(
                "all frames have one size: {}x{}, not {}x{}",
                self.width,
                self.height,
                frame.width(),
                frame.height()
            );
            return Err(EncodeError::invalid(self.format, rule));
        }
        self.frame_count += 1;
        match &mut self.writer {
            Writer::Gif(writer) => writer.push_frame(frame, delay),
            Writer::Apng(writer) => writer.push_frame(frame, delay),
        }
    }

    /// Ends the animation and gives the file.
    ///
    /// # Errors
    /// If it has no frame.
    pub fn finish(self) -> Result<Vec<u8>, EncodeError> {
        if self.frame_count == 0 {
            return Err(EncodeError::invalid(self.format, "an animation has at least one frame"));
        }
        match self.writer {
            Writer::Gif(writer) => writer.finish(),
            Writer::Apng(writer) => writer.finish(),
        }
    }
}

/// Rounds delays to a format's unit so that their sum is never off by more than half a unit.
#[derive(Debug)]
pub(super) struct FrameClock {
    unit: Duration,
    shown: Duration,
    units_told: u128,
}

impl FrameClock {
    pub(super) fn new(unit: Duration) -> Self {
        Self { unit, shown: Duration::ZERO, units_told: 0 }
    }

    /// The next frame's delay in units, at most what 16 bits hold.
    pub(super) fn units(&mut self, delay: Duration) -> u16 {
        self.shown = self.shown.saturating_add(delay);
        let unit = self.unit.as_nanos();
        let units = (self.shown.as_nanos() + unit / 2) / unit;
        let told = u16::try_from(units.saturating_sub(self.units_told)).unwrap_or(u16::MAX);
        self.units_told = units;
        told
    }
}

/// A part of a frame, in pixels from the top left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Rectangle {
    pub(super) x: u32,
    pub(super) y: u32,
    pub(super) width: u32,
    pub(super) height: u32,
}

impl Rectangle {
    pub(super) fn all_of(image: &Rgba8Image) -> Self {
        Self { x: 0, y: 0, width: image.width(), height: image.height() }
    }

    /// The smallest rectangle outside which two images of one size are equal; one pixel if they are equal everywhere,
    /// because no format has empty frames.
    pub(super) fn of_changes(before: &Rgba8Image, after: &Rgba8Image) -> Self {
        let differs = |y: &u32| before.row(*y) != after.row(*y);
        let Some(top) = (0..after.height()).find(differs) else {
            return Self { x: 0, y: 0, width: 1, height: 1 };
        };
        let bottom = (top..after.height()).rev().find(differs).unwrap_or(top);
        let (mut left, mut right) = (after.width() - 1, 0);
        for y in top..=bottom {
            let changed = |x: &u32| before.pixel(*x, y) != after.pixel(*x, y);
            if let Some(first) = (0..after.width()).find(changed) {
                left = left.min(first);
                right = (right.max(first)..after.width()).rev().find(changed).unwrap_or(right.max(first)).max(right);
            }
        }
        Self { x: left, y: top, width: right - left + 1, height: bottom - top + 1 }
    }

    /// The rows of the rectangle in an image, with their numbers.
    pub(super) fn rows(self, image: &Rgba8Image) -> impl Iterator<Item = (u32, &[[u8; 4]])> {
        let columns = self.x as usize..(self.x + self.width) as usize;
        (self.y..self.y + self.height).map(move |y| (y, &image.row(y)[columns.clone()]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounded_delays_keep_the_total() {
        let mut clock = FrameClock::new(Duration::from_millis(10));
        // 24 frames a second: 41.67 ms.
        let units: Vec<u16> = (0..24).map(|_| clock.units(Duration::from_secs(1) / 24)).collect();
        assert_eq!(units.iter().sum::<u16>(), 100);
        assert!(units.iter().all(|unit| (4..=5).contains(unit)));
        assert_eq!(clock.units(Duration::MAX), u16::MAX);
    }

    #[test]
    fn changes_are_enclosed_exactly() {
        let before = Rgba8Image::new(9, 7);
        assert_eq!(Rectangle::of_changes(&before, &before), Rectangle { x: 0, y: 0, width: 1, height: 1 });
        for (corners, expected) in [
            ([(2, 1), (5, 4)], (2, 1, 4, 4)),
            ([(5, 1), (2, 4)], (2, 1, 4, 4)),
            ([(8, 6), (0, 0)], (0, 0, 9, 7)),
            ([(8, 0), (0, 6)], (0, 0, 9, 7)),
            ([(3, 3), (3, 3)], (3, 3, 1, 1)),
        ] {
            let mut after = before.clone();
            corners.into_iter().for_each(|(x, y)| after.set_pixel(x, y, [1; 4]));
            let Rectangle { x, y, width, height } = Rectangle::of_changes(&before, &after);
            assert_eq!((x, y, width, height), expected);
        }
    }

    #[test]
    fn misuse_is_an_error() {
        let options = EncodeOptions::default();
        assert!(AnimationEncoder::new(Format::Jpeg, 1, 1, &options).is_err());
        assert!(AnimationEncoder::new(Format::Gif, 0, 1, &options).is_err());
        assert!(AnimationEncoder::new(Format::Gif, 65536, 1, &options).is_err());
        for format in [Format::Gif, Format::Png] {
            assert!(AnimationEncoder::new(format, 2, 2, &options).unwrap().finish().is_err());
            let mut animation = AnimationEncoder::new(format, 2, 2, &options).unwrap();
            let error = animation.push_frame(&Rgba8Image::new(2, 3), Duration::ZERO).unwrap_err().to_string();
            assert!(error.contains("2x2, not 2x3"), "{error}");
        }
    }
}
