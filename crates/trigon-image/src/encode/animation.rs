//! Animations: frames in, one at a time; the bytes of an animated GIF or APNG out.

use std::time::Duration;

use super::EncodeOptions;
use crate::{EncodeError, Format, Rgba8Image};

/// Writes an animation frame by frame; frames are compressed as they come, so memory holds only the file.
#[derive(Debug)]
pub struct AnimationEncoder {
    width: u32,
    height: u32,
}

impl AnimationEncoder {
    /// Starts an animation of `width * height` pixels as [`Format::Gif`] or [`Format::Png`] (APNG).
    ///
    /// # Errors
    /// If the format has no animations or the size is zero or too large for it.
    pub fn new(format: Format, width: u32, height: u32, options: &EncodeOptions) -> Result<Self, EncodeError> {
        let _ = options;
        Err(EncodeError::unsupported(format, "animations"))
    }

    /// Adds a frame that stays for `delay`.
    ///
    /// # Errors
    /// If the frame has another size than the animation.
    pub fn push_frame(&mut self, frame: &Rgba8Image, delay: Duration) -> Result<(), EncodeError> {
        let _ = (frame, delay, self.width, self.height);
        Err(EncodeError::unsupported(Format::Gif, "animations"))
    }

    /// Ends the animation and gives the file.
    ///
    /// # Errors
    /// If it has no frame.
    pub fn finish(self) -> Result<Vec<u8>, EncodeError> {
        Err(EncodeError::unsupported(Format::Gif, "animations"))
    }
}
