//! Functions of (u, v) to PNG files: anti-aliased by averaging, in linear light for colours.
//!
//! Row 0 of a PNG is its top, v = 1. Pixel centres are at +0.5, as a sampler sees them.

use std::sync::LazyLock;

/// A colour in linear light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Linear(pub(crate) [f64; 3]);

/// The colour of an sRGB hex code, `0xrrggbb`.
pub(crate) fn srgb(hex: u32) -> Linear {
    Linear([16, 8, 0].map(|shift| DECODED[((hex >> shift) & 0xff) as usize]))
}

impl Linear {
    pub(crate) fn mixed(self, other: Self, share: f64) -> Self {
        Self(std::array::from_fn(|channel| self.0[channel] + (other.0[channel] - self.0[channel]) * share))
    }

    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|channel| channel * factor))
    }
}

/// The sRGB transfer function (IEC 61966-2-1), for each of the 256 codes.
static DECODED: LazyLock<[f64; 256]> = LazyLock::new(|| {
    let mut decoded = [0.0; 256];
    for (code, linear) in decoded.iter_mut().enumerate() {
        let x = code as f64 / 255.0;
        *linear = if x <= 0.04045 { x / 12.92 } else { libm::pow((x + 0.055) / 1.055, 2.4) };
    }
    decoded
});

fn encoded(linear: f64) -> u8 {
    let x = linear.clamp(0.0, 1.0);
    let curve = if x <= 0.003_130_8 { x * 12.92 } else { 1.055 * libm::pow(x, 1.0 / 2.4) - 0.055 };
    byte(curve)
}

/// 0..=1 to the nearest of 256 codes.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the range of a byte")]
pub(crate) fn byte(x: f64) -> u8 {
    (x.clamp(0.0, 1.0) * 255.0).round() as u8
}

/// Width and height in pixels, and the square root of the number of samples in a pixel.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Grid {
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) samples: u32,
}

impl Grid {
    pub(crate) const fn new(width: u32, height: u32, samples: u32) -> Self {
        Self { width, height, samples }
    }

    /// `at(u, v)` averaged over each pixel, row by row from the top.
    fn averages<const N: usize>(self, at: impl Fn(f64, f64) -> [f64; N]) -> Vec<[f64; N]> {
        let mut pixels = Vec::new();
        for y in 0..self.height {
            for x in 0..self.width {
                pixels.push(self.average(x, y, &at));
            }
        }
        pixels
    }

    fn average<const N: usize>(self, x: u32, y: u32, at: &impl Fn(f64, f64) -> [f64; N]) -> [f64; N] {
        let mut sum = [0.0; N];
        let place = |pixel: u32, sample: u32| f64::from(pixel) + (f64::from(sample) + 0.5) / f64::from(self.samples);
        for j in 0..self.samples {
            for i in 0..self.samples {
                let u = place(x, i) / f64::from(self.width);
                let v = 1.0 - place(y, j) / f64::from(self.height);
                for (total, value) in sum.iter_mut().zip(at(u, v)) {
                    *total += value;
                }
            }
        }
        sum.map(|total| total / f64::from(self.samples * self.samples))
    }

    /// A colour picture.
    pub(crate) fn colour(self, at: impl Fn(f64, f64) -> Linear) -> Vec<u8> {
        let pixels = self.averages(|u, v| at(u, v).0);
        let bytes: Vec<u8> = pixels.into_iter().flatten().map(encoded).collect();
        self.png(&bytes, png::ColorType::Rgb, None)
    }

    /// One number per pixel, 0..=1, stored as it is.
    pub(crate) fn grey(self, at: impl Fn(f64, f64) -> f64) -> Vec<u8> {
        let bytes: Vec<u8> = self.averages(|u, v| [at(u, v)]).into_iter().map(|[x]| byte(x)).collect();
        self.png(&bytes, png::ColorType::Grayscale, None)
    }

    /// A tone per pixel, 0..=1, looked up in a palette from dark to light: a third of the size of three channels.
    pub(crate) fn toned(self, tones: u8, palette: impl Fn(f64) -> Linear, at: impl Fn(f64, f64) -> f64) -> Vec<u8> {
        let last = f64::from(tones - 1);
        let entries: Vec<u8> = (0..tones).flat_map(|tone| palette(f64::from(tone) / last).0).map(encoded).collect();
        let bytes: Vec<u8> =
            self.averages(|u, v| [at(u, v)]).into_iter().map(|[x]| byte(x.clamp(0.0, 1.0) * last / 255.0)).collect();
        self.png(&bytes, png::ColorType::Indexed, Some(&entries))
    }

    /// The tangent-space normals of a height field that repeats: red is u, green is v (up), blue away from the surface.
    ///
    /// `height` is in the unit of u and v.
    pub(crate) fn normals(self, height: impl Fn(f64, f64) -> f64) -> Vec<u8> {
        let (du, dv) = (0.5 / f64::from(self.width), 0.5 / f64::from(self.height));
        let mut bytes = Vec::new();
        for [u, v] in self.centres() {
            let slope_u = (height(u + du, v) - height(u - du, v)) / (2.0 * du);
            let slope_v = (height(u, v + dv) - height(u, v - dv)) / (2.0 * dv);
            let normal = super::super::vector::normalize([-slope_u, -slope_v, 1.0]);
            bytes.extend(normal.map(|axis| byte(axis * 0.5 + 0.5)));
        }
        self.png(&bytes, png::ColorType::Rgb, None)
    }

    /// (u, v) of the centre of each pixel, row by row from the top.
    fn centres(self) -> impl Iterator<Item = [f64; 2]> {
        let (width, height) = (f64::from(self.width), f64::from(self.height));
        (0..self.height).flat_map(move |y| {
            (0..self.width).map(move |x| [(f64::from(x) + 0.5) / width, 1.0 - (f64::from(y) + 0.5) / height])
        })
    }

    /// The smallest file that one of the row filters gives.
    fn png(self, bytes: &[u8], kind: png::ColorType, palette: Option<&[u8]>) -> Vec<u8> {
        let filters = [png::Filter::NoFilter, png::Filter::Up, png::Filter::Paeth, png::Filter::Adaptive];
        let files = filters.map(|filter| self.png_with(bytes, kind, palette, filter));
        files.into_iter().min_by_key(Vec::len).unwrap_or_default()
    }

    #[expect(clippy::expect_used, reason = "writing to memory, with the size that the pixels were made for")]
    fn png_with(self, bytes: &[u8], kind: png::ColorType, palette: Option<&[u8]>, filter: png::Filter) -> Vec<u8> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, self.width, self.height);
        encoder.set_color(kind);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        encoder.set_filter(filter);
        if let Some(palette) = palette {
            encoder.set_palette(palette.to_vec());
        }
        let mut writer = encoder.write_header().expect("a header fits into memory");
        writer.write_image_data(bytes).expect("the pixels are as many as the header says");
        writer.finish().expect("the end fits into memory");
        file
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn decode(file: &[u8]) -> Vec<u8> {
        let mut decoder = png::Decoder::new(std::io::Cursor::new(file));
        decoder.set_transformations(png::Transformations::EXPAND);
        let mut reader = decoder.read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut pixels).unwrap();
        pixels
    }

    #[test]
    fn v_runs_up_and_u_to_the_right() {
        let grid = Grid::new(2, 2, 1);
        assert_eq!(decode(&grid.grey(|u, v| if u < 0.5 && v > 0.5 { 1.0 } else { 0.0 })), [255, 0, 0, 0]);
    }

    #[test]
    fn colours_survive_and_averages_are_linear() {
        let grid = Grid::new(1, 1, 2);
        assert_eq!(decode(&grid.colour(|_, _| srgb(0x12_80_fe))), [0x12, 0x80, 0xfe]);
        // Half white, half black is 188 in sRGB, not 128.
        assert_eq!(decode(&grid.colour(|u, _| srgb(if u < 0.5 { 0 } else { 0xff_ff_ff }))), [188, 188, 188]);
    }

    #[test]
    fn a_slope_leans_the_normal_against_its_rise() {
        let pixels = decode(&Grid::new(1, 1, 1).normals(|u, v| u - v));
        assert!(pixels[0] < 100 && pixels[1] > 155 && pixels[2] > 155, "{pixels:?}");
        assert_eq!(decode(&Grid::new(1, 1, 1).normals(|_, _| 3.0)), [128, 128, 255]);
    }

    #[test]
    fn tones_go_through_the_palette() {
        let pixels = decode(&Grid::new(2, 1, 1).toned(3, |tone| Linear([tone; 3]), |u, _| u.round()));
        assert_eq!(pixels, [0, 0, 0, 255, 255, 255]);
    }
}
