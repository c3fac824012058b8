//! What a caller can choose about loading, and the bounds that keep hostile files harmless.

use super::{Format, PictureDecoder, Resolver};
use std::num::NonZeroUsize;
use std::sync::Arc;

/// How to load a model. [`LoadOptions::default`] suits trusted and untrusted files alike.
#[derive(Clone, Default)]
#[non_exhaustive]
pub struct LoadOptions {
    /// The format, instead of recognizing it by content and name.
    pub format: Option<Format>,
    /// Turns missing files, unusable elements and unreadable values into errors instead of warnings.
    pub strict: bool,
    /// Worker threads; `None` takes one per CPU. The result does not depend on it.
    pub threads: Option<NonZeroUsize>,
    /// Bounds on sizes.
    pub limits: Limits,
    /// Which way is up in the file; the scene's up is +y.
    pub up: UpAxis,
    /// The angle in radians between faces up to which a generated normal is shared (smooth); larger angles make a
    /// crease. `None` is 45 degrees. OBJ smoothing groups take precedence.
    pub crease_angle: Option<f64>,
    /// Leaves texture files unread; materials then have no maps.
    pub skip_textures: bool,
    /// Where material libraries and textures come from; `None` is the folder of the model's path, or nowhere for
    /// models from memory.
    pub resolver: Option<Arc<dyn Resolver>>,
    /// Decodes textures of formats beyond those of `trigon-image`, SVG for example; `None` leaves these undrawn, with a
    /// warning.
    pub picture_decoder: Option<Arc<dyn PictureDecoder>>,
}

impl LoadOptions {
    /// The default crease angle, 45 degrees.
    pub const DEFAULT_CREASE_ANGLE: f64 = std::f64::consts::FRAC_PI_4;

    /// The number of threads to work with.
    pub(crate) fn thread_count(&self) -> usize {
        if cfg!(target_family = "wasm") {
            return 1;
        }
        let all = || std::thread::available_parallelism();
        self.threads.or_else(|| all().ok()).map_or(1, NonZeroUsize::get)
    }

    /// The cosine of the crease angle.
    pub(crate) fn crease_cosine(&self) -> f64 {
        libm::cos(self.crease_angle.unwrap_or(Self::DEFAULT_CREASE_ANGLE).clamp(0.0, std::f64::consts::PI))
    }
}

/// Bounds on what is read; beyond them loading fails with [`LoadError::LimitExceeded`](super::LoadError).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Limits {
    /// Bytes of one model or material file, after decompression.
    pub file_bytes: u64,
    /// Vertices of one model, as stored in the file.
    pub vertices: u64,
    /// Triangles of one model, after polygons are cut up.
    pub triangles: u64,
    /// Materials of one model.
    pub materials: u64,
    /// Textures of one model.
    pub textures: u64,
    /// Encoded bytes of one texture file.
    pub texture_bytes: u64,
    /// Width times height of one texture; those beyond are not drawn, with a warning.
    pub texture_pixels: u64,
}

impl Default for Limits {
    /// 4 GiB files, 200 million vertices, 400 million triangles, 65 536 materials, 4096 textures of 256 MiB and
    /// 2^27 pixels (134 million).
    fn default() -> Self {
        Self {
            file_bytes: 4 << 30,
            vertices: 200_000_000,
            triangles: 400_000_000,
            materials: 65_536,
            textures: 4096,
            texture_bytes: 256 << 20,
            texture_pixels: 1 << 27,
        }
    }
}

/// The axis that points up in a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UpAxis {
    /// The usual one of the format: +z for STL, +y for OBJ and PLY.
    #[default]
    Format,
    /// +y: used as it is.
    PlusY,
    /// +z: turned so that z becomes y and y becomes -z.
    PlusZ,
}
