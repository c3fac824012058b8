//! A picture file, of pixels or SVG, in; a drawing of it that fills a frame, and what is odd about the file, out.

use crate::failure::Failure;
use crate::load;
use crate::options::RenderOptions;
use crate::warnings;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use trigon_image::{Format, Limits, decode};
use trigon_svg::canvas::{BlendMode, Drawing, Image, ImageFilter, Renderer, Transform};
use trigon_svg::svg::{Document, Size, View, is_svg};

/// Reads a picture and makes it fill a frame of this size; it keeps its proportions, and what sticks out is cut off.
/// What is odd about it is added to `warnings`, with the file's name.
pub(crate) fn cover(
    path: &Path,
    (width, height): (u32, u32),
    options: &RenderOptions,
    renderer: &Renderer,
    warnings: &mut Vec<String>,
) -> Result<Drawing, Failure> {
    let limits = load::limits(&options.input);
    let max_bytes = limits.file_bytes;
    let failure = |problem: String| Failure::work(format!("cannot read the picture {}: {problem}", path.display()));
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(max_bytes.saturating_add(1)).read_to_end(&mut bytes))
        .map_err(|error| failure(error.to_string()))?;
    if u64::try_from(bytes.len()).unwrap_or(u64::MAX) > max_bytes {
        return Err(failure(format!("larger than the limit file-size = {max_bytes}")));
    }
    if is_svg(&bytes) {
        let options = options.svg_input.to_options(path.parent().map(Path::to_owned), max_bytes);
        let view = View { size: Size::Cover(width, height), ..View::default() };
        let prepared = Document::parse(&bytes, &options).and_then(|document| document.prepare(&view, renderer));
        let prepared = prepared.map_err(|error| failure(error.to_string()))?;
        warnings.extend(warnings::about(path, &prepared.warnings));
        return Ok(prepared.drawing);
    }
    let limits = Limits::default().with_max_pixels(limits.texture_pixels);
    let decoded = decode(&bytes, Format::from_path(path), &limits).map_err(|error| failure(error.to_string()))?;
    let image = Image::new(&decoded.into_rgba8()).map_err(|error| failure(error.to_string()))?;
    let mut drawing = Drawing::new();
    let filling = filling(image.size(), [width, height]);
    // Pixels that stay pixels are not mixed.
    let filter = if image.size() == [width, height] { ImageFilter::NEAREST } else { ImageFilter::SMOOTH };
    drawing.image(&image, filter, filling, 1.0, BlendMode::Normal);
    Ok(drawing)
}

/// The map from an image's pixels to those of the frame that it fills.
fn filling(image: [u32; 2], frame: [u32; 2]) -> Transform {
    let [[width, height], [frame_width, frame_height]] = [image, frame].map(|size| size.map(f64::from));
    let (by_width, by_height) = (frame_width / width, frame_height / height);
    let scale = if by_width > by_height { by_width } else { by_height };
    let margin = |frame: f64, length: f64| (frame - length * scale) * 0.5;
    Transform::translate(margin(frame_width, width), margin(frame_height, height)) * Transform::scale(scale, scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longer_side_is_cut_evenly() {
        let map = filling([100, 50], [40, 40]);
        assert_eq!(map.apply([0.0, 0.0]), [-20.0, 0.0]);
        assert_eq!(map.apply([100.0, 50.0]), [60.0, 40.0]);
        assert_eq!(filling([7, 9], [7, 9]), Transform::IDENTITY);
    }
}
