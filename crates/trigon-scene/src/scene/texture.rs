//! Textures as files hold them, and how a material map uses one.
//!
//! A texture stays encoded until it is needed: depth or normal pictures never pay for decoding. One file is one
//! [`Texture`], however many materials name it; what differs per use are the [`TextureOptions`].

use super::TextureId;
use crate::load::{PictureDecoder, parallel_map};
use std::fmt;
use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::Arc;
use trigon_image::{DecodeError, DecodedImage, Format, Limits};

/// An encoded picture and its name.
#[derive(Clone)]
pub struct Texture {
    /// The path it was found under, as in messages; its extension is a hint for decoding (TGA has no magic number).
    pub name: String,
    /// The file's bytes.
    pub encoded: Arc<[u8]>,
    /// The largest width times height that is decoded.
    pub max_pixels: u64,
    /// Asked first; what it does not know, `trigon-image` decodes.
    pub decoder: Option<Arc<dyn PictureDecoder>>,
}

impl Texture {
    /// A texture from the bytes of an image file, of at most 2^27 pixels (134 million).
    #[must_use]
    pub fn new(name: impl Into<String>, encoded: impl Into<Arc<[u8]>>) -> Self {
        Self { name: name.into(), encoded: encoded.into(), max_pixels: 1 << 27, decoder: None }
    }

    /// The picture.
    ///
    /// # Errors
    ///
    /// The file is damaged, of no known format, or larger than `limits` or `max_pixels` allow.
    pub fn decode(&self, limits: &Limits) -> Result<DecodedImage, DecodeError> {
        let limits = limits.with_max_pixels(limits.max_pixels.min(self.max_pixels));
        let by_decoder = self.decoder.as_ref().and_then(|decoder| decoder.decode(&self.name, &self.encoded, &limits));
        if let Some(outcome) = by_decoder {
            return outcome;
        }
        trigon_image::decode(&self.encoded, Format::from_path(Path::new(&self.name)), &limits)
    }

    /// All pictures, decoded on up to `threads` threads; results in order.
    #[must_use]
    pub fn decode_all(
        textures: &[Self],
        limits: &Limits,
        threads: NonZeroUsize,
    ) -> Vec<Result<DecodedImage, DecodeError>> {
        parallel_map(threads.get(), textures.iter().collect(), |_, texture| texture.decode(limits))
    }
}

impl fmt::Debug for Texture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Texture").field("name", &self.name).field("encoded_bytes", &self.encoded.len()).finish()
    }
}

/// One use of a texture by a material map.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureRef {
    /// The picture.
    pub texture: TextureId,
    /// How it is looked up and scaled.
    pub options: TextureOptions,
}

impl TextureRef {
    /// A use with default options.
    #[must_use]
    pub fn new(texture: TextureId) -> Self {
        Self { texture, options: TextureOptions::default() }
    }
}

/// The options of a texture map statement, as written in the MTL file (MTL specification, "Options for texture map
/// statements"). Values are in the file's convention: v up from the bottom row; [`TextureOptions::uv_transform`]
/// gives the transform for texture coordinates as meshes hold them, v down.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureOptions {
    /// `-o u v w`: added to the coordinates, after the scale.
    pub offset: [f32; 3],
    /// `-s u v w`: multiplies the coordinates.
    pub scale: [f32; 3],
    /// `-t u v w`: turbulence; kept, not drawn.
    pub turbulence: [f32; 3],
    /// `-mm base gain`, first value: added to each texel, after the gain.
    pub base: f32,
    /// `-mm base gain`, second value: multiplies each texel.
    pub gain: f32,
    /// `-bm`: strength of a bump map.
    pub bump_multiplier: f32,
    /// `-clamp on`: outside 0..=1 the map does not apply (instead of repeating).
    pub clamp: bool,
    /// `-imfchan`: the channel that a scalar map reads; `None` leaves it to the map's default.
    pub channel: Option<Channel>,
    /// `-blendu on|off`: filtering in u; on by default.
    pub blend_u: bool,
    /// `-blendv on|off`: filtering in v; on by default.
    pub blend_v: bool,
    /// `-boost`: sharpening of mip levels, 0 for none; kept, not drawn.
    pub boost: f32,
    /// `-texres`: resolution the file asks to resample to; kept, not drawn.
    pub resolution: Option<f32>,
    /// `-cc on`: colour correction; kept, not drawn.
    pub color_correction: bool,
    /// `-colorspace linear|sRGB`, an extension: whether the texels are linear; `None` leaves it to the map's default.
    pub is_linear: Option<bool>,
    /// `-type`: for reflection maps, how directions map to the picture.
    pub projection: Option<MapProjection>,
}

impl Default for TextureOptions {
    fn default() -> Self {
        Self {
            offset: [0.0; 3],
            scale: [1.0; 3],
            turbulence: [0.0; 3],
            base: 0.0,
            gain: 1.0,
            bump_multiplier: 1.0,
            clamp: false,
            channel: None,
            blend_u: true,
            blend_v: true,
            boost: 0.0,
            resolution: None,
            color_correction: false,
            is_linear: None,
            projection: None,
        }
    }
}

impl TextureOptions {
    /// Scale and offset for (u, v) with v down, as meshes hold them: `uv' = uv * scale + offset`.
    ///
    /// From v_up = 1 - v and v_up' = s * v_up + o follows v' = s * v + (1 - s - o).
    #[must_use]
    pub fn uv_transform(&self) -> ([f32; 2], [f32; 2]) {
        let [scale_u, scale_v, _] = self.scale;
        ([scale_u, scale_v], [self.offset[0], (1.0 - scale_v) - self.offset[1]])
    }

    /// Whether texture coordinates are used as they are.
    #[must_use]
    pub fn has_identity_transform(&self) -> bool {
        self.scale[..2] == [1.0; 2] && self.offset[..2] == [0.0; 2]
    }
}

/// The channel of a texture that a scalar map reads (`-imfchan`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Channel {
    /// `r`
    Red,
    /// `g`
    Green,
    /// `b`
    Blue,
    /// `m`: the matte (alpha) channel.
    Matte,
    /// `l`: luminance.
    Luminance,
    /// `z`: depth.
    Depth,
}

/// How a reflection map surrounds the scene (`-type`).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MapProjection {
    /// `sphere`: one picture around everything.
    Sphere,
    /// `cube_top`
    CubeTop,
    /// `cube_bottom`
    CubeBottom,
    /// `cube_front`
    CubeFront,
    /// `cube_back`
    CubeBack,
    /// `cube_left`
    CubeLeft,
    /// `cube_right`
    CubeRight,
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon_image::Rgba8Image;

    /// Knows files that begin with a question mark, and is afraid of long ones.
    struct Guesses;

    impl PictureDecoder for Guesses {
        fn decode(&self, _: &str, bytes: &[u8], limits: &Limits) -> Option<Result<DecodedImage, DecodeError>> {
            let known = bytes.starts_with(b"?");
            let outcome = limits.check(8, 8, 4).map(|_| DecodedImage::Rgba8(Rgba8Image::filled(8, 8, [1, 2, 3, 255])));
            known.then_some(outcome)
        }
    }

    #[test]
    fn a_decoder_is_asked_first_and_bound_by_the_limits() {
        let texture = |bytes: &[u8], max_pixels| Texture {
            max_pixels,
            decoder: Some(Arc::new(Guesses)),
            ..Texture::new("a.what", bytes.to_vec())
        };
        let decoded = texture(b"?", 64).decode(&Limits::default()).unwrap().into_rgba8();
        assert_eq!(decoded.pixel(7, 7), [1, 2, 3, 255]);
        assert!(matches!(texture(b"?", 63).decode(&Limits::default()), Err(DecodeError::LimitExceeded { .. })));
        assert!(matches!(texture(b"!", 64).decode(&Limits::default()), Err(DecodeError::Unsupported { .. })));
    }

    #[test]
    fn uv_transform_agrees_with_the_file_convention() {
        let options = TextureOptions { scale: [2.0, 4.0, 1.0], offset: [0.25, 0.5, 0.0], ..TextureOptions::default() };
        let ([scale_u, scale_v], [offset_u, offset_v]) = options.uv_transform();
        for (u, v_up) in [(0.0, 0.0), (0.5, 0.25), (1.0, 1.0), (-3.0, 2.0)] {
            let v_up_moved = 4.0 * v_up + 0.5;
            assert_eq!(u * scale_u + offset_u, 2.0 * u + 0.25);
            assert_eq!((1.0 - v_up) * scale_v + offset_v, 1.0 - v_up_moved);
        }
        assert!(TextureOptions::default().has_identity_transform());
        assert!(!options.has_identity_transform());
    }
}
