//! Where texels lie: tiles of 4x4 texels, row by row, level after level, in one allocation.
//!
//! A tile of 4-byte texels is one 64-byte cache line, so a bilinear footprint touches one to four lines whatever its
//! direction. Levels are padded to whole tiles; the padding is never read.

use super::desc::{MAX_TEXELS, MAX_TEXTURE_SIZE, MipChain, TextureError};

/// Texels along the side of a tile.
const TILE: u32 = 4;

/// Texels in a tile.
pub(super) const TILE_TEXELS: u32 = TILE * TILE;

/// A texture of the largest size has this many levels.
pub(super) const MAX_LEVELS: usize = 16;

/// Place and size of one level.
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Level {
    /// Texels before its first one.
    pub(super) offset: u32,
    pub(super) width: u32,
    pub(super) height: u32,
    /// Texels (with padding) in a row of tiles.
    pub(super) row_texels: u32,
}

impl Level {
    /// The index of the texel in column `x` and row `y`.
    pub(super) fn texel_index(&self, x: u32, y: u32) -> u32 {
        let tile = (y / TILE) * self.row_texels + (x / TILE) * TILE_TEXELS;
        self.offset + tile + (y % TILE) * TILE + x % TILE
    }
}

/// All levels of a texture of this size, and the texels they take.
pub(super) fn lay_out(size: [u32; 2], mips: MipChain) -> Result<(Vec<Level>, u32), TextureError> {
    let [mut width, mut height] = size;
    if width == 0 || height == 0 {
        return Err(TextureError::Empty { size });
    }
    if width > MAX_TEXTURE_SIZE || height > MAX_TEXTURE_SIZE {
        return Err(TextureError::TooLarge { size });
    }
    let mut levels = Vec::with_capacity(MAX_LEVELS);
    let mut offset = 0_u64;
    loop {
        let row_texels = width.div_ceil(TILE) * TILE_TEXELS;
        let start = u32::try_from(offset).map_err(|_| TextureError::TooLarge { size })?;
        levels.push(Level { offset: start, width, height, row_texels });
        offset += u64::from(row_texels) * u64::from(height.div_ceil(TILE));
        if mips == MipChain::None || (width == 1 && height == 1) {
            break;
        }
        width = (width / 2).max(1);
        height = (height / 2).max(1);
    }
    if offset >= MAX_TEXELS {
        return Err(TextureError::TooLarge { size });
    }
    let texels = u32::try_from(offset).map_err(|_| TextureError::TooLarge { size })?;
    Ok((levels, texels))
}
