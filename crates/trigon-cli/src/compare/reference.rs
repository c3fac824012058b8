//! What pictures are measured against: the same view with 64 samples a pixel.
//!
//! Models are drawn at twice the width and height (lines, points and outlines twice as wide, as far as lines go) with 16
//! samples a pixel on a grid, shaded at every sample, with trilinear anisotropic textures (16 points); then the mean of
//! each 2 x 2 pixels is taken in linear light and encoded. So each pixel is the mean of 64 shaded samples in an 8 x 8
//! grid. SVG files are drawn at twice the size with 16 samples on a grid; their mean is taken of encoded, premultiplied
//! colours, as SVG blends. Lines of CS184, one pixel wide by definition, are those of the picture.

use super::cell::{Drawer, Subject};
use super::variant::Variant;
use crate::failure::Failure;
use crate::options::Preset;
use crate::values::Positive;
use std::ffi::OsString;
use trigon::target::MAX_SIZE;
use trigon_image::{Rgba8Image, RgbaF32Image, compare};
use trigon_scene::render::Outline;

/// References by the values of what changes the view.
#[derive(Default)]
pub(crate) struct Reference {
    made: Vec<(Vec<(String, String)>, Rgba8Image)>,
}

/// What a reference does not follow: how exactly the same view is sampled, and what changes no pixel.
const SAMPLING: [&str; 8] =
    ["samples", "pattern", "shading", "pixel-filter", "level-filter", "anisotropy", "threads", "simd"];

impl Reference {
    /// The reference of a combination whose picture has this size.
    pub(crate) fn of(
        &mut self,
        arguments: &[OsString],
        drawer: &mut Drawer,
        variant: &Variant,
        size: (u32, u32),
    ) -> Result<&Rgba8Image, Failure> {
        let is_view = |value: &&(String, String)| !SAMPLING.contains(&value.0.as_str());
        let key: Vec<(String, String)> = variant.values.iter().filter(is_view).cloned().collect();
        let found = self.made.iter().position(|(other, _)| *other == key);
        let at = match found {
            Some(at) => at,
            None => {
                self.made.push((key, make(arguments, drawer, variant, size)?));
                self.made.len() - 1
            }
        };
        Ok(&self.made[at].1)
    }

    /// The reference, if there is one only.
    pub(crate) fn only(&self) -> Option<&Rgba8Image> {
        match self.made.as_slice() {
            [(_, image)] => Some(image),
            _ => None,
        }
    }
}

/// Root of the mean square difference over all channels, in codes of 0 to 255; `None` where sizes differ. Colours count
/// as much as they are seen, times their alpha.
pub(crate) fn rmse(picture: &Rgba8Image, reference: &Rgba8Image) -> Option<f64> {
    compare(&premultiplied(picture), &premultiplied(reference)).map(|comparison| comparison.rmse)
}

fn premultiplied(picture: &Rgba8Image) -> Rgba8Image {
    let mut picture = picture.clone();
    for pixel in picture.pixels_mut() {
        let [r, g, b, a] = pixel.map(u32::from);
        let seen = |code: u32| u8::try_from((code * a + 127) / 255).unwrap_or(u8::MAX);
        *pixel = [seen(r), seen(g), seen(b), pixel[3]];
    }
    picture
}

/// Refuses pictures of which there can be no reference.
pub(crate) fn check_size((width, height): (u32, u32)) -> Result<(), Failure> {
    let limit = MAX_SIZE / 2;
    if width.max(height) <= limit {
        return Ok(());
    }
    let message = format!(
        "pictures to compare have at most {limit} pixels a side, not {width}x{height}; choose a smaller --size"
    );
    Err(Failure::usage(message))
}

fn make(
    arguments: &[OsString],
    drawer: &mut Drawer,
    variant: &Variant,
    (width, height): (u32, u32),
) -> Result<Rgba8Image, Failure> {
    let shading = &variant.options.render.shading;
    let [line, point] = [shading.line_width.0 * 2.0, shading.point_size.0 * 2.0].map(|pixels| pixels.to_string());
    let fixed = [
        ("samples", "16"),
        ("pattern", "grid"),
        ("shading", "sample"),
        ("pixel-filter", "bilinear"),
        ("level-filter", "linear"),
        ("anisotropy", "16"),
        ("line-width", &line),
        ("point-size", &point),
    ];
    // The program of CS184 has no anisotropic filter, and its preset refuses it.
    let is_cs184 = variant.options.render.preset.preset == Some(Preset::Cs184);
    let understood = fixed.iter().filter(|(name, _)| !(is_cs184 && *name == "anisotropy"));
    let values: Vec<(String, String)> =
        understood.map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
    let mut large = variant.with(arguments, &values)?;
    large.options.render.output.quiet = true;
    (large.options.render.picture.size.width, large.options.render.picture.size.height) = (2 * width, 2 * height);
    large.options.render.picture.enlargement = 2;
    large.given.size = true;
    let effects = &mut large.options.render.effects;
    if let Some(outline) = effects.outline() {
        effects.outline_width = Some(Positive(f64::from((2.0 * outline.width_px).min(Outline::MAX_WIDTH))));
    }
    // Where a size was written it is the frame of both; else the document's own is doubled.
    if drawer.subject == Subject::Drawing && large.options.render.preset.preset.is_none() && !variant.given.size {
        (large.options.svg.width, large.options.svg.height) = (Some(2 * width), None);
    }
    let images = drawer.draw(&large, true, false)?.images;
    let mean = match (images.floats, images.bytes) {
        (Some(floats), _) => halved_linear(&floats, (width, height)),
        (None, Some(bytes)) => halved_encoded(&bytes, (width, height)),
        (None, None) => return Err(Failure::work("the reference was not drawn")),
    };
    Ok(mean)
}

/// The mean of each 2 x 2 pixels, encoded; colours are linear and premultiplied.
fn halved_linear(picture: &RgbaF32Image, (width, height): (u32, u32)) -> Rgba8Image {
    let mut mean = RgbaF32Image::new(width, height);
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let four = four(picture.width(), picture.height(), x, y).map(|[x, y]| picture.pixel(x, y));
        let sum = |c: usize| (four[0][c] + four[1][c]) + (four[2][c] + four[3][c]);
        mean.set_pixel(x, y, [0, 1, 2, 3].map(|c| sum(c) * 0.25));
    }
    mean.to_srgb8()
}

/// The mean of each 2 x 2 pixels; colours are encoded, with straight alpha, and weighed by it.
fn halved_encoded(picture: &Rgba8Image, (width, height): (u32, u32)) -> Rgba8Image {
    let mut mean = Rgba8Image::new(width, height);
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let four = four(picture.width(), picture.height(), x, y).map(|[x, y]| picture.pixel(x, y).map(u32::from));
        let alpha: u32 = four.iter().map(|pixel| pixel[3]).sum();
        let weighed = |c: usize| four.iter().map(|pixel| pixel[c] * pixel[3]).sum::<u32>();
        let color = |c: usize| (weighed(c) + alpha / 2).checked_div(alpha).unwrap_or(0);
        let narrow = |value: u32| u8::try_from(value).unwrap_or(u8::MAX);
        mean.set_pixel(x, y, [narrow(color(0)), narrow(color(1)), narrow(color(2)), narrow((alpha + 2) / 4)]);
    }
    mean
}

/// The four pixels of the large picture; at an edge that rounding left out the last ones again.
fn four(width: u32, height: u32, x: u32, y: u32) -> [[u32; 2]; 4] {
    [[0, 0], [1, 0], [0, 1], [1, 1]].map(|[dx, dy]| [(2 * x + dx).min(width - 1), (2 * y + dy).min(height - 1)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_hardly_seen_hardly_counts() {
        let [clear, faint] = [[0, 0, 0, 0], [255, 255, 255, 2]].map(|pixel| Rgba8Image::filled(3, 3, pixel));
        assert!(rmse(&clear, &faint).is_some_and(|difference| difference == 2.0));
        assert_eq!(rmse(&clear, &Rgba8Image::filled(2, 3, [0; 4])), None);
    }

    #[test]
    fn means_of_models_are_linear_those_of_svg_encoded() {
        let mut floats = RgbaF32Image::filled(2, 2, [0.0, 0.0, 0.0, 1.0]);
        floats.set_pixel(0, 0, [1.0; 4]);
        floats.set_pixel(1, 1, [1.0; 4]);
        assert_eq!(halved_linear(&floats, (1, 1)).pixel(0, 0), [188, 188, 188, 255]);
        let mut bytes = Rgba8Image::filled(2, 2, [0, 0, 0, 255]);
        bytes.set_pixel(0, 0, [255; 4]);
        bytes.set_pixel(1, 1, [255; 4]);
        assert_eq!(halved_encoded(&bytes, (1, 1)).pixel(0, 0), [128, 128, 128, 255]);
        // What is transparent has no colour of its own.
        let mut bytes = Rgba8Image::filled(2, 1, [9, 200, 9, 0]);
        bytes.set_pixel(0, 0, [40, 50, 60, 255]);
        assert_eq!(halved_encoded(&bytes, (1, 1)).pixel(0, 0), [40, 50, 60, 128]);
    }
}
