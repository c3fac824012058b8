//! Pictures of formats that `trigon-image` does not read: a hook for programs that can.

use trigon_image::{DecodeError, DecodedImage, Limits};

/// Turns texture files of further formats, such as SVG, into pictures. See
/// [`LoadOptions::picture_decoder`](super::LoadOptions::picture_decoder).
pub trait PictureDecoder: Send + Sync {
    /// The picture in `bytes`; `None` if they are of no format that this decoder knows, which leaves them to
    /// `trigon-image`.
    ///
    /// `name` is the path that the texture was found under. No more pixels than `limits` allow should be made. Textures
    /// are decoded on several threads at once.
    fn decode(&self, name: &str, bytes: &[u8], limits: &Limits) -> Option<Result<DecodedImage, DecodeError>>;
}
