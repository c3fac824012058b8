//! feBlend: a picture blended with another by one of the blend modes, pixel by pixel.
//!
//! The formulas are the engine's, "Compositing and Blending Level 1" (W3C).

use super::raster::{Pixel, Raster};
use crate::canvas::BlendMode;
use crate::engine;

/// `source` blended with `backdrop`, of the same size.
#[must_use]
pub fn blend(source: &Raster, mut backdrop: Raster, mode: BlendMode) -> Raster {
    for (below, above) in backdrop.pixels_mut().iter_mut().zip(source.pixels()) {
        if above[3] != 0 {
            *below = blended(*above, *below, mode);
        }
    }
    backdrop
}

fn blended(source: Pixel, backdrop: Pixel, mode: BlendMode) -> Pixel {
    engine::blend(mode, u32::from_le_bytes(source), u32::from_le_bytes(backdrop)).to_le_bytes()
}

#[cfg(test)]
mod tests {
    use super::*;

    const COLORS: [Pixel; 5] = [[255, 0, 0, 255], [10, 200, 90, 255], [64, 0, 128, 128], [0; 4], [255; 4]];

    #[test]
    fn transparent_sources_and_backdrops_change_nothing() {
        for mode in BlendMode::ALL {
            for color in COLORS {
                assert_eq!(blended(color, [0; 4], mode), color, "{mode:?}");
                assert_eq!(blended([0; 4], color, mode), color, "{mode:?}");
            }
        }
    }

    #[test]
    fn colors_never_exceed_alpha() {
        for mode in BlendMode::ALL {
            for source in COLORS {
                for backdrop in COLORS {
                    let [r, g, b, a] = blended(source, backdrop, mode);
                    assert!(r <= a && g <= a && b <= a, "{mode:?} {source:?} {backdrop:?}");
                }
            }
        }
    }

    #[test]
    fn known_values() {
        let of = |mode, source, backdrop| blended(source, backdrop, mode);
        assert_eq!(of(BlendMode::Multiply, [128, 128, 128, 255], [255, 128, 0, 255]), [128, 64, 0, 255]);
        assert_eq!(of(BlendMode::Difference, [255; 4], [255, 0, 10, 255]), [0, 255, 245, 255]);
        assert_eq!(of(BlendMode::Luminosity, [255; 4], [255, 0, 0, 255]), [255; 4]);
        assert_eq!(of(BlendMode::Normal, [0, 64, 0, 64], [200, 0, 0, 255]), [150, 64, 0, 255]);
    }
}
