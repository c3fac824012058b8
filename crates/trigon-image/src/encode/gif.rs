//! GIF files, still and animated, of 256 colors a frame.
//!
//! A frame is written when the next one is known, because it tells what becomes of its pixels: if both are opaque they
//! stay, and the next frame stores only what changes, with the transparent index for equal pixels; else they are cleared
//! and the next frame is stored whole. Alpha below one half is transparent, the rest opaque.

use std::borrow::Cow;
use std::time::Duration;

use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};

use super::animation::{FrameClock, Rectangle};
use super::dither::PaletteMapper;
use super::quantize::ColorCounts;
use super::{EncodeOptions, GifPalette};
use crate::{EncodeError, Format, Rgba8Image};

/// Alpha codes below this one are transparent.
const OPAQUE_FROM: u8 = 128;

/// Colors of a palette that also has a transparent index, which is the last.
const COLORS_BESIDE_TRANSPARENT: usize = 255;

pub(super) fn encode(image: &Rgba8Image, options: &EncodeOptions) -> Result<Vec<u8>, EncodeError> {
    let mut writer = GifWriter::new(image.width(), image.height(), options)?;
    writer.push_frame(image, Duration::ZERO)?;
    writer.finish()
}

/// Writes frames to a GIF file in memory.
pub(super) struct GifWriter {
    width: u16,
    height: u16,
    options: EncodeOptions,
    clock: FrameClock,
    /// Made with the first frame that is written.
    encoder: Option<Encoder<Vec<u8>>>,
    /// The frame whose follower is not known yet.
    pending: Option<TimedFrame>,
    /// The frame before it, if that is still on the screen.
    shown: Option<Rgba8Image>,
    /// Frames that wait for the palette of all.
    waiting: Vec<TimedFrame>,
    /// The palette of all frames; empty if each has its own.
    global_palette: Vec<[u8; 3]>,
}

struct TimedFrame {
    image: Rgba8Image,
    /// In hundredths of a second.
    delay: u16,
}

impl std::fmt::Debug for GifWriter {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("GifWriter").field("width", &self.width).field("height", &self.height).finish_non_exhaustive()
    }
}

impl GifWriter {
    pub(super) fn new(width: u32, height: u32, options: &EncodeOptions) -> Result<Self, EncodeError> {
        let (Ok(width), Ok(height)) = (u16::try_from(width), u16::try_from(height)) else {
            return Err(EncodeError::unsupported(Format::Gif, "pictures are at most 65535 pixels wide and high"));
        };
        Ok(Self {
            width,
            height,
            options: options.clone(),
            clock: FrameClock::new(Duration::from_millis(10)),
            encoder: None,
            pending: None,
            shown: None,
            waiting: Vec::new(),
            global_palette: Vec::new(),
        })
    }

    pub(super) fn push_frame(&mut self, frame: &Rgba8Image, delay: Duration) -> Result<(), EncodeError> {
        let frame = TimedFrame { image: frame.clone(), delay: self.clock.units(delay) };
        match self.options.gif_palette {
            GifPalette::Global => self.waiting.push(frame),
            GifPalette::PerFrame => self.advance(Some(frame))?,
        }
        Ok(())
    }

    pub(super) fn finish(mut self) -> Result<Vec<u8>, EncodeError> {
        let waiting = std::mem::take(&mut self.waiting);
        if !waiting.is_empty() {
            let mut counts = ColorCounts::new();
            waiting.iter().for_each(|frame| counts.add(opaque_colors(frame.image.pixels().iter())));
            self.global_palette = not_empty(counts.palette(COLORS_BESIDE_TRANSPARENT));
        }
        for frame in waiting {
            self.advance(Some(frame))?;
        }
        self.advance(None)?;
        let encoder = self.encoder.ok_or_else(|| EncodeError::invalid(Format::Gif, "there is at least one frame"))?;
        encoder.into_inner().map_err(convert_error)
    }

    /// Writes the pending frame, knowing what follows it.
    fn advance(&mut self, next: Option<TimedFrame>) -> Result<(), EncodeError> {
        let Some(frame) = std::mem::replace(&mut self.pending, next) else { return Ok(()) };
        let stays = match &self.pending {
            Some(next) => is_opaque(&frame.image) && is_opaque(&next.image),
            None => true,
        };
        let before = self.shown.take().filter(|_| is_opaque(&frame.image) && stays);
        let encoded = encode_frame(&frame, before.as_ref(), stays, &self.global_palette, self.options.gif_dither);
        let mut encoder = match self.encoder.take() {
            Some(encoder) => encoder,
            None => self.start()?,
        };
        encoder.write_frame(&encoded).map_err(convert_error)?;
        self.encoder = Some(encoder);
        self.shown = stays.then_some(frame.image);
        Ok(())
    }

    /// The head of the file; a picture of one frame does not say how often it plays.
    fn start(&self) -> Result<Encoder<Vec<u8>>, EncodeError> {
        let entries = match self.global_palette.as_slice() {
            [] => Vec::new(),
            palette => with_transparent(palette),
        };
        let mut encoder = Encoder::new(Vec::new(), self.width, self.height, &entries).map_err(convert_error)?;
        if self.pending.is_some() {
            let repeat = match self.options.plays {
                0 => Repeat::Infinite,
                // The file counts the repetitions after the first time.
                plays => Repeat::Finite(plays - 1),
            };
            encoder.set_repeat(repeat).map_err(convert_error)?;
        }
        Ok(encoder)
    }
}

/// The part of a frame that differs from `before`, or all of it, as indices of the global palette if there is one.
fn encode_frame(
    frame: &TimedFrame,
    before: Option<&Rgba8Image>,
    stays: bool,
    global_palette: &[[u8; 3]],
    is_dithered: bool,
) -> Frame<'static> {
    let image = &frame.image;
    let part = before.map_or(Rectangle::all_of(image), |before| Rectangle::of_changes(before, image));
    let needs_transparent = before.is_some() || !is_opaque(image);
    let own_palette;
    let palette = if global_palette.is_empty() {
        let size = if needs_transparent { COLORS_BESIDE_TRANSPARENT } else { 256 };
        own_palette = palette_of(image, before, part, size);
        own_palette.as_slice()
    } else {
        global_palette
    };
    let transparent = u8::try_from(palette.len()).ok().filter(|_| needs_transparent);
    let mut mapper = PaletteMapper::new(palette, is_dithered);
    let mut indices = Vec::with_capacity(part.width as usize * part.height as usize);
    for (y, row) in part.rows(image) {
        for (x, &[r, g, b, a]) in (part.x..).zip(row) {
            let is_unchanged = before.is_some_and(|before| before.pixel(x, y) == [r, g, b, a]);
            indices.push(match transparent {
                Some(index) if is_unchanged || a < OPAQUE_FROM => index,
                _ => mapper.index([r, g, b], x, y),
            });
        }
    }
    Frame {
        delay: frame.delay,
        dispose: if stays { DisposalMethod::Keep } else { DisposalMethod::Background },
        transparent,
        left: to_u16(part.x),
        top: to_u16(part.y),
        width: to_u16(part.width),
        height: to_u16(part.height),
        palette: global_palette.is_empty().then(|| match transparent {
            Some(_) => with_transparent(palette),
            None => palette.as_flattened().to_vec(),
        }),
        buffer: Cow::Owned(indices),
        ..Frame::default()
    }
}

/// At most `size` colors for the pixels to be drawn.
fn palette_of(image: &Rgba8Image, before: Option<&Rgba8Image>, part: Rectangle, size: usize) -> Vec<[u8; 3]> {
    let mut counts = ColorCounts::new();
    for (y, row) in part.rows(image) {
        let drawn = (part.x..).zip(row).filter(|(x, pixel)| before.is_none_or(|before| before.pixel(*x, y) != **pixel));
        counts.add(opaque_colors(drawn.map(|(_, pixel)| pixel)));
    }
    not_empty(counts.palette(size))
}

/// A frame without a visible pixel still has a palette.
fn not_empty(palette: Vec<[u8; 3]>) -> Vec<[u8; 3]> {
    if palette.is_empty() { vec![[0; 3]] } else { palette }
}

/// The entries of the file: the colors, and one for the transparent index behind them.
fn with_transparent(palette: &[[u8; 3]]) -> Vec<u8> {
    let mut entries = palette.as_flattened().to_vec();
    entries.extend([0; 3]);
    entries
}

fn opaque_colors<'a>(pixels: impl Iterator<Item = &'a [u8; 4]>) -> impl Iterator<Item = [u8; 3]> {
    pixels.filter(|pixel| pixel[3] >= OPAQUE_FROM).map(|&[r, g, b, _]| [r, g, b])
}

fn is_opaque(image: &Rgba8Image) -> bool {
    image.pixels().iter().all(|pixel| pixel[3] >= OPAQUE_FROM)
}

fn to_u16(side: u32) -> u16 {
    u16::try_from(side).expect("the constructor admits sides of 16 bits")
}

fn convert_error(error: EncodingError) -> EncodeError {
    match error {
        EncodingError::Io(error) => EncodeError::Io(error),
        other => EncodeError::invalid(Format::Gif, other.to_string()),
    }
}
