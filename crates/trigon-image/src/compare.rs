//! Two pictures compared: how far apart, where first, how many pixels, and a picture of the difference.
//!
//! Codes are compared as stored, without a transfer function; this is for golden tests, where the expected difference is
//! none.

use crate::Rgba8Image;

/// The difference of two pictures of one size.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Comparison {
    /// The largest difference of each channel, in codes.
    pub max_difference: [u8; 4],
    /// Entry `d` counts the pixels whose largest channel difference is exactly `d` codes; the 256 entries sum to all pixels.
    pub histogram: Vec<u64>,
    /// Root of the mean square difference over all four channels, in codes.
    pub rmse: f64,
    /// The first pixel that differs in row order: column and row.
    pub first_difference: Option<(u32, u32)>,
}

/// Compares two pictures; `None` if their sizes differ.
#[must_use]
pub fn compare(a: &Rgba8Image, b: &Rgba8Image) -> Option<Comparison> {
    if (a.width(), a.height()) != (b.width(), b.height()) {
        return None;
    }
    let mut max_difference = [0; 4];
    let mut histogram = vec![0; 256];
    let mut sum_of_squares = 0_u64;
    let mut first_difference = None;
    for (y, (row_a, row_b)) in (0..).zip(a.rows().zip(b.rows())) {
        for (x, (&pixel_a, &pixel_b)) in (0..).zip(row_a.iter().zip(row_b)) {
            let difference = pixel_difference(pixel_a, pixel_b);
            let largest = difference.into_iter().max().unwrap_or(0);
            histogram[usize::from(largest)] += 1;
            if largest == 0 {
                continue;
            }
            first_difference = first_difference.or(Some((x, y)));
            for (max, channel) in max_difference.iter_mut().zip(difference) {
                *max = channel.max(*max);
                sum_of_squares += u64::from(channel) * u64::from(channel);
            }
        }
    }
    let channels = (a.pixels().len() * 4).max(1);
    let rmse = (sum_of_squares as f64 / channels as f64).sqrt();
    Some(Comparison { max_difference, histogram, rmse, first_difference })
}

impl Comparison {
    /// Whether every byte is equal.
    #[must_use]
    pub fn is_equal(&self) -> bool {
        self.first_difference.is_none()
    }

    /// The largest difference of any channel, in codes.
    #[must_use]
    pub fn max(&self) -> u8 {
        self.max_difference.into_iter().max().unwrap_or(0)
    }

    /// The number of pixels with a channel that differs by more than `threshold` codes.
    #[must_use]
    pub fn pixels_over(&self, threshold: u8) -> u64 {
        self.histogram[usize::from(threshold) + 1..].iter().sum()
    }

    /// The number of pixels compared.
    #[must_use]
    pub fn pixels(&self) -> u64 {
        self.histogram.iter().sum()
    }

    /// Peak signal-to-noise ratio in decibels, `20 log10(255 / rmse)`; infinite for equal pictures.
    #[must_use]
    pub fn psnr(&self) -> f64 {
        if self.rmse == 0.0 { f64::INFINITY } else { 20.0 * libm::log10(255.0 / self.rmse) }
    }
}

/// An opaque picture of the difference: each color channel times `gain`, clamped; a difference of alpha alone shows
/// as grey. Equal pixels are black. `None` if the sizes differ.
#[must_use]
pub fn difference_picture(a: &Rgba8Image, b: &Rgba8Image, gain: u8) -> Option<Rgba8Image> {
    if (a.width(), a.height()) != (b.width(), b.height()) {
        return None;
    }
    let amplify = |difference: u8| difference.saturating_mul(gain);
    let pixels =
        a.pixels().iter().zip(b.pixels()).map(|(&pixel_a, &pixel_b)| match pixel_difference(pixel_a, pixel_b) {
            [0, 0, 0, alpha] => [amplify(alpha), amplify(alpha), amplify(alpha), u8::MAX],
            [r, g, b, _] => [amplify(r), amplify(g), amplify(b), u8::MAX],
        });
    Rgba8Image::from_pixels(a.width(), a.height(), pixels.collect()).ok()
}

fn pixel_difference(a: [u8; 4], b: [u8; 4]) -> [u8; 4] {
    std::array::from_fn(|i| a[i].abs_diff(b[i]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_pictures_have_no_difference() {
        let image = Rgba8Image::filled(3, 2, [1, 2, 3, 4]);
        let comparison = compare(&image, &image).unwrap();
        assert!(comparison.is_equal());
        assert_eq!((comparison.max(), comparison.pixels(), comparison.pixels_over(0)), (0, 6, 0));
        assert_eq!((comparison.rmse, comparison.psnr()), (0.0, f64::INFINITY));
        assert_eq!(difference_picture(&image, &image, 9).unwrap(), Rgba8Image::filled(3, 2, [0, 0, 0, 255]));
    }

    #[test]
    fn differences_are_found_counted_and_drawn() {
        let a = Rgba8Image::filled(4, 4, [100; 4]);
        let mut b = a.clone();
        b.set_pixel(2, 1, [100, 110, 100, 100]);
        b.set_pixel(3, 3, [100, 100, 100, 97]);
        let comparison = compare(&a, &b).unwrap();
        assert_eq!(comparison.first_difference, Some((2, 1)));
        assert_eq!(comparison.max_difference, [0, 10, 0, 3]);
        assert_eq!([0, 3, 9, 10].map(|t| comparison.pixels_over(t)), [2, 1, 1, 0]);
        // 10^2 + 3^2 over 64 channels.
        assert_eq!(comparison.rmse, (109.0_f64 / 64.0).sqrt());
        assert!((comparison.psnr() - 45.8183).abs() < 0.001);
        let picture = difference_picture(&a, &b, 20).unwrap();
        assert_eq!(picture.pixel(2, 1), [0, 200, 0, 255]);
        assert_eq!(picture.pixel(3, 3), [60, 60, 60, 255]);
    }

    #[test]
    fn other_sizes_are_not_compared() {
        assert_eq!(compare(&Rgba8Image::new(2, 3), &Rgba8Image::new(3, 2)), None);
        assert!(difference_picture(&Rgba8Image::new(2, 3), &Rgba8Image::new(3, 2), 1).is_none());
        assert!(compare(&Rgba8Image::new(0, 3), &Rgba8Image::new(0, 3)).unwrap().is_equal());
    }
}
