//! From a file to a picture: the view, the frame, bands of rows drawn in parallel.

use std::sync::Mutex;

use trigon::target::MAX_SIZE;
use trigon_image::Rgba8Image;

use super::Options;
use super::primitive::{Position, Primitive};
use super::raster::Band;
use super::reader::{Scene, read};
use crate::canvas::{DrawError, Transform};
use crate::svg::SvgError;

/// Rows drawn at a time: bounds the memory that samples take.
const BAND_ROWS: usize = 32;

/// Draws a file of the course: white, its elements in order, then a black frame round its page.
///
/// Returns the picture, opaque, and what of the file could not be drawn.
///
/// # Errors
/// If the file is no XML, has no `svg` with width and height, or the picture is too large.
pub fn draw(bytes: &[u8], options: &Options) -> Result<(Rgba8Image, Vec<String>), SvgError> {
    let (width, height) = (options.width, options.height);
    if width > MAX_SIZE || height > MAX_SIZE {
        return Err(DrawError::TooLarge { width, height }.into());
    }
    let Scene { size, primitives, warnings } = read(bytes, options.folder.clone())?;
    let screen_from_file = view(options, size);
    let mut primitives: Vec<_> = primitives.into_iter().map(|primitive| moved(primitive, screen_from_file)).collect();
    primitives.extend(frame(screen_from_file, size, f64::from(options.enlargement.max(1))));

    let mut pixels = vec![[255; 4]; width as usize * height as usize];
    let bands = pixels.chunks_mut((BAND_ROWS * width as usize).max(1)).enumerate();
    let queue = Mutex::new(bands);
    std::thread::scope(|scope| {
        for _ in 0..options.threads.clamp(1, 64) {
            scope.spawn(|| {
                loop {
                    // A thread that panicked leaves the queue as it should be.
                    let next = queue.lock().unwrap_or_else(std::sync::PoisonError::into_inner).next();
                    let Some((index, out)) = next else { break };
                    let mut band = Band::new(options, index * BAND_ROWS, out.len() / width as usize);
                    primitives.iter().for_each(|primitive| band.draw(primitive));
                    out.copy_from_slice(&band.resolve());
                }
            });
        }
    });
    let picture = Rgba8Image::from_pixels(width, height, pixels).map_err(|_| SvgError::Empty)?;
    Ok((picture, warnings))
}

/// Pixels from the file's units: the view's square fills the shorter side of the picture.
fn view(options: &Options, [width, height]: [f64; 2]) -> Transform {
    let [x, y, span] = options.view.unwrap_or([width / 2.0, height / 2.0, 0.6 * width.max(height)]);
    let (screen_width, screen_height) = (f64::from(options.width), f64::from(options.height));
    let scale = screen_width.min(screen_height) / (2.0 * span);
    let to_middle = Transform::translate(screen_width / 2.0, screen_height / 2.0);
    to_middle * Transform::scale(scale, scale) * Transform::translate(-x, -y)
}

fn moved(primitive: Primitive, map: Transform) -> Primitive {
    match primitive {
        Primitive::Point { at, color } => Primitive::Point { at: map.apply(at), color },
        Primitive::Line { from, to, color } => Primitive::Line { from: map.apply(from), to: map.apply(to), color },
        Primitive::Triangle { corners, paint } => {
            Primitive::Triangle { corners: corners.map(|corner| map.apply(corner)), paint }
        }
        Primitive::Picture { from, to, texture } => {
            Primitive::Picture { from: map.apply(from), to: map.apply(to), texture }
        }
    }
}

/// The frame, a point outside the page on the left and right; above and below as the course has it.
fn frame(map: Transform, [width, height]: [f64; 2], point_size: f64) -> [Primitive; 4] {
    let corner = |at: Position, dx: f64, dy: f64| {
        let [x, y] = map.apply(at);
        [x + dx * point_size, y + dy * point_size]
    };
    let a = corner([0.0, 0.0], -1.0, 1.0);
    let b = corner([width, 0.0], 1.0, 1.0);
    let c = corner([0.0, height], -1.0, -1.0);
    let d = corner([width, height], 1.0, -1.0);
    let color = [0.0, 0.0, 0.0, 1.0];
    [(a, b), (a, c), (d, b), (d, c)].map(|(from, to)| Primitive::Line { from, to, color })
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "<svg width='100px' height='50px'><rect width='100' height='50' fill='#00ff00'/>
        <colortri points='10 10 90 10 50 40' colors='1 0 0 1 0 1 0 1 0 0 1 1'/><line x1='0' x2='100' y1='0' y2='50' stroke='#0000ff'/></svg>";

    #[test]
    fn the_page_fills_ten_twelfths_of_the_shorter_side() {
        let (picture, warnings) = draw(FILE.as_bytes(), &Options::new(120, 120)).unwrap();
        assert!(warnings.is_empty());
        assert_eq!(picture.pixel(3, 60), [255; 4]);
        assert_eq!(picture.pixel(9, 60), [0, 0, 0, 255]);
        assert_eq!(picture.pixel(12, 80), [0, 255, 0, 255]);
    }

    #[test]
    fn threads_and_bands_change_nothing() {
        let options = Options { samples_per_axis: 2, ..Options::new(90, 131) };
        let one = draw(FILE.as_bytes(), &options).unwrap();
        assert_eq!(one, draw(FILE.as_bytes(), &Options { threads: 3, ..options }).unwrap());
    }

    /// Lines, points and the frame are the same, twice as large; of triangles there is more to see.
    #[test]
    fn an_enlarged_picture_has_the_same_lines() {
        let lines = "<svg width='100px' height='50px'><line x1='3' x2='90' y1='5' y2='41' stroke='#0000ff'/>
            <line x1='20' x2='24' y1='45' y2='3' stroke='#ff0000'/><rect x='50' y='9' width='0' height='0'/></svg>";
        let (small, _) = draw(lines.as_bytes(), &Options::new(61, 47)).unwrap();
        let options = Options { enlargement: 2, ..Options::new(122, 94) };
        let (large, _) = draw(lines.as_bytes(), &options).unwrap();
        for (x, y) in (0..94).flat_map(|y| (0..122).map(move |x| (x, y))) {
            assert_eq!(large.pixel(x, y), small.pixel(x / 2, y / 2), "{x},{y}");
        }
        assert!(small.pixels().iter().filter(|pixel| **pixel != [255; 4]).count() > 150);
    }

    #[test]
    fn a_view_can_be_chosen() {
        let options = Options { view: Some([95.0, 45.0, 5.0]), ..Options::new(20, 20) };
        let (picture, _) = draw(FILE.as_bytes(), &options).unwrap();
        assert_eq!(picture.pixel(3, 3), [0, 255, 0, 255]);
    }
}
