//! The texture itself: made once from pixels, then only read.

use super::desc::{Alpha, TexelFormat, TextureDesc, TextureError};
use super::layout::{self, Level, MAX_LEVELS};
use super::mips::MipCascade;
use super::texel::{self, Texels};
use core::fmt;

/// An image with its mip levels, ready to be sampled; immutable.
///
/// `u` grows right and `v` down: (0, 0) is the outer corner of the first texel of the first row, (1, 1) that of the last
/// texel of the last row; texel centres lie at half texels. Samples are in linear light; premultiplied where the
/// description says that alpha is coverage.
///
/// Memory: the bytes per texel of the format (8 for [`TexelFormat::Rgba8Srgb`], whose texels are held in a form that is
/// quick to decode), times 4/3 with a mip chain; each level is padded to multiples of 4.
pub struct Texture {
    pub(super) desc: TextureDesc,
    pub(super) levels: Vec<Level>,
    pub(super) tables: LevelTables,
    pub(super) texels: Texels,
}

/// The levels by field, for lanes that each read another level. Past the last level: the last one.
pub(super) struct LevelTables {
    pub(super) offset: [i32; MAX_LEVELS],
    pub(super) width: [i32; MAX_LEVELS],
    pub(super) height: [i32; MAX_LEVELS],
    pub(super) row_texels: [i32; MAX_LEVELS],
}

impl Texture {
    /// A texture of 8-bit texels. `bytes` holds the rows from the top, without padding, channels interleaved.
    ///
    /// # Errors
    /// A size of zero or beyond the limits, a float format, or an input of the wrong length.
    pub fn from_bytes(desc: &TextureDesc, bytes: &[u8]) -> Result<Self, TextureError> {
        if desc.format.is_float() {
            return Err(TextureError::WrongType { format: desc.format });
        }
        // Without a transparent texel there is nothing to premultiply.
        let transparent = desc.format.channels() == 4 && bytes.chunks_exact(4).any(|texel| texel[3] != u8::MAX);
        let premultiplied = desc.alpha == Alpha::Coverage && transparent;
        Self::build(desc, premultiplied, bytes, |texel| match *texel {
            [r, g, b, a] => texel::decode_bytes([r, g, b, a], desc.format),
            _ => [texel::byte_to_unit(texel[0]), 0.0, 0.0, 1.0],
        })
    }

    /// A texture of float texels. `values` holds the rows from the top, without padding, channels interleaved.
    ///
    /// NaN is read as 0 and magnitudes are limited to 2^64, so that no filter can overflow.
    ///
    /// # Errors
    /// A size of zero or beyond the limits, an 8-bit format, or an input of the wrong length.
    pub fn from_floats(desc: &TextureDesc, values: &[f32]) -> Result<Self, TextureError> {
        if !desc.format.is_float() {
            return Err(TextureError::WrongType { format: desc.format });
        }
        let premultiplied = desc.alpha == Alpha::Coverage && desc.format.channels() == 4;
        Self::build(desc, premultiplied, values, |texel| match *texel {
            [r, g, b, a] => [r, g, b, a].map(texel::sanitize),
            _ => [texel::sanitize(texel[0]), 0.0, 0.0, 1.0],
        })
    }

    /// Decodes level 0, makes the other levels from it, stores all.
    fn build<T>(
        desc: &TextureDesc,
        premultiplied: bool,
        values: &[T],
        decode: impl Fn(&[T]) -> [f32; 4],
    ) -> Result<Self, TextureError> {
        let (levels, texel_count) = layout::lay_out(desc.size, desc.mips)?;
        if desc.values() != values.len() as u64 {
            return Err(TextureError::WrongLength { expected: desc.values(), actual: values.len() as u64 });
        }
        let mut texels = Texels::zeroed(desc.format, premultiplied, texel_count as usize);
        let mut cascade = MipCascade::new(&levels);
        let channels = desc.format.channels();
        let mut linear = Vec::new();
        for (y, row) in (0..).zip(values.chunks_exact(channels * levels[0].width as usize)) {
            linear.clear();
            linear.extend(row.chunks_exact(channels).map(|texel| {
                let value = decode(texel);
                if premultiplied { texel::premultiply(value) } else { value }
            }));
            for (x, value) in (0..).zip(&linear) {
                texels.store(levels[0].texel_index(x, y) as usize, *value);
            }
            cascade.push_row(&linear, &mut |level, y, row: &[[f32; 4]]| {
                for (x, value) in (0..).zip(row) {
                    let value = round_to_format(*value, premultiplied, desc.format);
                    texels.store(levels[level].texel_index(x, y) as usize, value);
                }
            });
        }
        Ok(Self { desc: *desc, tables: LevelTables::new(&levels), levels, texels })
    }

    /// What the texture was made from.
    #[must_use]
    pub fn desc(&self) -> &TextureDesc {
        &self.desc
    }

    /// The number of levels, at least 1.
    #[must_use]
    pub fn levels(&self) -> usize {
        self.levels.len()
    }

    /// Width and height of a level; `None` past the last.
    #[must_use]
    pub fn level_size(&self, level: usize) -> Option<[u32; 2]> {
        self.levels.get(level).map(|level| [level.width, level.height])
    }

    /// One texel as filters see it: linear light, premultiplied if alpha is coverage; `None` outside the level.
    ///
    /// Column `x` from the left, row `y` from the top.
    #[must_use]
    pub fn texel(&self, level: usize, x: u32, y: u32) -> Option<[f32; 4]> {
        let level = self.levels.get(level).filter(|level| x < level.width && y < level.height)?;
        Some(self.texels.load(level.texel_index(x, y) as usize))
    }
}

/// A mean of texels as an image file of this format would hold it (with straight alpha).
fn round_to_format(value: [f32; 4], premultiplied: bool, format: TexelFormat) -> [f32; 4] {
    match format.is_float() {
        true => value,
        false if premultiplied => texel::premultiply(texel::quantize(texel::unpremultiply(value), format)),
        false => texel::quantize(value, format),
    }
}

impl LevelTables {
    #[expect(clippy::cast_possible_wrap, reason = "texel indices are below 2^31")]
    fn new(levels: &[Level]) -> Self {
        let last = levels.len() - 1;
        let level = |i: usize| levels[i.min(last)];
        Self {
            offset: core::array::from_fn(|i| level(i).offset as i32),
            width: core::array::from_fn(|i| level(i).width as i32),
            height: core::array::from_fn(|i| level(i).height as i32),
            row_texels: core::array::from_fn(|i| level(i).row_texels as i32),
        }
    }
}

impl fmt::Debug for Texture {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Texture").field("desc", &self.desc).field("levels", &self.levels.len()).finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use super::super::MipChain;
    use super::*;

    #[test]
    fn misuse_is_explained() {
        let desc = TextureDesc::new([4, 2], TexelFormat::Rgba8);
        let length = Texture::from_bytes(&desc, &[0; 31]).unwrap_err();
        assert_eq!(length, TextureError::WrongLength { expected: 32, actual: 31 });
        assert!(length.to_string().contains("31") && length.to_string().contains("32"));
        assert!(Texture::from_floats(&desc, &[0.0; 32]).unwrap_err().to_string().contains("from_bytes"));
        let float = TextureDesc::new([1, 1], TexelFormat::R32Float);
        assert!(Texture::from_bytes(&float, &[0; 4]).unwrap_err().to_string().contains("from_floats"));
        for size in [[0, 1], [1, 0]] {
            let empty = Texture::from_bytes(&TextureDesc::new(size, TexelFormat::R8), &[]).unwrap_err();
            assert_eq!(empty, TextureError::Empty { size });
        }
        for size in [[32_769, 1], [1, u32::MAX]] {
            let large = Texture::from_bytes(&TextureDesc::new(size, TexelFormat::R8), &[]).unwrap_err();
            assert_eq!(large, TextureError::TooLarge { size });
        }
    }

    #[test]
    fn level_zero_keeps_what_came() {
        let bytes: Vec<u8> = (0..=255).cycle().take(9 * 7 * 4).collect();
        let desc = TextureDesc { mips: MipChain::None, ..TextureDesc::new([9, 7], TexelFormat::Rgba8) };
        let texture = Texture::from_bytes(&desc, &bytes).unwrap();
        assert_eq!((texture.levels(), texture.level_size(0), texture.level_size(1)), (1, Some([9, 7]), None));
        for (i, texel) in (0..).zip(bytes.chunks_exact(4)) {
            let expected: Vec<f32> = texel.iter().map(|byte| texel::byte_to_unit(*byte)).collect();
            assert_eq!(texture.texel(0, i % 9, i / 9).unwrap().to_vec(), expected);
        }
        assert_eq!((texture.texel(0, 9, 0), texture.texel(0, 0, 7), texture.texel(1, 0, 0)), (None, None, None));
    }

    #[test]
    fn small_levels_of_colours_are_rounded_in_srgb() {
        // The mean of black and white is 1/2 in linear light: code 188, not 128.
        let desc = TextureDesc::new([2, 1], TexelFormat::Rgba8Srgb);
        let texture = Texture::from_bytes(&desc, &[0, 0, 0, 255, 255, 255, 255, 255]).unwrap();
        let [r, _, _, a] = texture.texel(1, 0, 0).unwrap();
        assert!((r - trigon_image::color::srgb_to_linear(188)).abs() < 1e-5, "{r}");
        assert_eq!(a, 1.0);
    }
}
