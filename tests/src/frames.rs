//! Drawing with given options, and hashing what comes out.

use trigon::lanes::SimdLevel;
use trigon::pipeline::{Draw, Frame, FrameStatistics, Picture, Renderer, RendererOptions};
use trigon::schedule::TileOrder;

/// Options for one thread at the best level.
#[must_use]
pub fn plain_options() -> RendererOptions {
    RendererOptions { threads: 1, simd: SimdLevel::detect(), tile_order: TileOrder::Rows }
}

/// Draws one frame in a fresh renderer.
///
/// # Panics
/// If the frame cannot be drawn.
#[must_use]
pub fn draw_with(options: RendererOptions, frame: &Frame, draws: &[Draw<'_>]) -> (Picture, FrameStatistics) {
    let mut picture = Picture::default();
    let mut renderer = Renderer::new(options).expect("the level is available");
    let statistics = renderer.render(frame, draws, &mut picture).expect("the frame is valid");
    (picture, statistics)
}

/// Every available SIMD level.
#[must_use]
#[expect(clippy::print_stdout, reason = "a level that is not tested must be seen")]
pub fn levels() -> Vec<SimdLevel> {
    let (have, lack): (Vec<_>, Vec<_>) = SimdLevel::ALL.into_iter().partition(|level| level.is_available());
    println!("SIMD levels tested: {have:?}; SKIPPED, as this CPU lacks them: {lack:?}");
    have
}

/// 64-bit FNV-1a over all images of a picture.
#[must_use]
pub fn hash(picture: &Picture) -> u64 {
    let mut hash = Hasher::default();
    if let Some(p) = &picture.color {
        p.values().iter().for_each(|c| hash.add(u32::from_le_bytes(*c)));
    }
    if let Some(p) = &picture.color_f32 {
        p.values().as_flattened().iter().for_each(|v| hash.add(v.to_bits()));
    }
    if let Some(p) = &picture.depth {
        p.values().iter().for_each(|v| hash.add(v.to_bits()));
    }
    for p in [&picture.primitive, &picture.object].into_iter().flatten() {
        p.values().iter().for_each(|v| hash.add(*v));
    }
    for p in [&picture.normal, &picture.position].into_iter().flatten() {
        p.values().as_flattened().iter().for_each(|v| hash.add(v.to_bits()));
    }
    if let Some(p) = &picture.uv {
        p.values().as_flattened().iter().for_each(|v| hash.add(v.to_bits()));
    }
    hash.0
}

/// 64-bit FNV-1a over words, each as four bytes.
#[must_use]
pub fn hash_words(words: impl Iterator<Item = u32>) -> u64 {
    let mut hash = Hasher::default();
    words.for_each(|word| hash.add(word));
    hash.0
}

/// FNV-1a (Fowler, Noll, Vo) of 64 bits.
struct Hasher(u64);

impl Default for Hasher {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hasher {
    fn add(&mut self, word: u32) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}
