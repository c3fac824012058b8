//! The sheet: pictures in rows and columns, each with its enlarged part beside it and its label below.

use crate::failure::Failure;
use crate::figure::{Anchor, Sketch, enlarged, lay_over, line_height, text_width};
use crate::values::Inset;
use trigon::target::MAX_SIZE;
use trigon_image::Rgba8Image;

/// A picture and the lines below it.
pub(crate) struct Entry {
    pub(crate) image: Rgba8Image,
    pub(crate) title: Vec<String>,
    pub(crate) numbers: String,
}

/// How the sheet is arranged.
pub(crate) struct Layout {
    pub(crate) columns: u32,
    pub(crate) inset: Option<Inset>,
    /// Lines at the foot of the sheet.
    pub(crate) notes: Vec<String>,
}

const PAPER: [u8; 4] = [255; 4];
const INK: &str = "#1d2126";
const PALE_INK: &str = "#59616b";
const HAIRLINE: &str = "#c4c9d0";
/// Where the enlarged part comes from.
const MARK: &str = "#e8412c";
/// Height of a capital.
const CAPITAL: f64 = 9.0;
/// Around the sheet, and between cells.
const MARGIN: u32 = 18;
const GAP: u32 = 20;
/// Labels that need more are drawn smaller, if the picture is narrower.
const MAX_LABEL: u32 = 400;
/// Between a picture and its enlarged part.
const SEAM: u32 = 6;

/// Measures of all cells, in pixels.
struct Grid {
    /// Of the largest picture.
    picture: (u32, u32),
    /// Side of an enlarged part, 0 without; and pixels of it for each of the picture.
    inset: (u32, u32),
    cell: (u32, u32),
    columns: u32,
    rows: u32,
    /// The lines at the foot, no longer than the sheet is wide.
    notes: Vec<String>,
    size: (u32, u32),
}

/// Puts the pictures on a sheet.
pub(crate) fn sheet(entries: &[Entry], layout: &Layout) -> Result<Rgba8Image, Failure> {
    let grid = Grid::new(entries, layout);
    let (width, height) = grid.size;
    if width > MAX_SIZE || height > MAX_SIZE {
        return Err(Failure::usage(format!(
            "the sheet would have {width}x{height} pixels, more than {MAX_SIZE} a side; vary less, or choose a smaller --size"
        )));
    }
    let mut sheet = Rgba8Image::filled(width, height, PAPER);
    let mut sketch = Sketch::new(width, height);
    for (number, entry) in (0..).zip(entries) {
        draw_entry(&mut sheet, &mut sketch, &grid, layout, (number, entry));
    }
    let first = f64::from(height - MARGIN) - line_height(CAPITAL) * (grid.notes.len() as f64 - 1.0);
    for (line, note) in grid.notes.iter().enumerate() {
        let y = first + line_height(CAPITAL) * line as f64;
        fitted(&mut sketch, [f64::from(MARGIN), y], f64::from(width - 2 * MARGIN), PALE_INK, note);
    }
    lay_over(&mut sheet, &sketch.draw()?, [0, 0]);
    Ok(sheet)
}

impl Grid {
    fn new(entries: &[Entry], layout: &Layout) -> Self {
        let largest = |side: fn(&Rgba8Image) -> u32| entries.iter().map(|entry| side(&entry.image)).max().unwrap_or(1);
        let picture = (largest(Rgba8Image::width), largest(Rgba8Image::height));
        // The enlarged part is as high as the picture, as far as whole pixels allow.
        let inset = layout.inset.map_or((0, 0), |inset| {
            let scale = (picture.1 / inset.size).max(1);
            (inset.size * scale, scale)
        });
        let beside = if inset.0 > 0 { SEAM + inset.0 } else { 0 };
        let lines = entries.iter().map(|entry| entry.title.len() + 1).max().unwrap_or(1);
        let text = pixels(line_height(CAPITAL) * lines as f64 + 5.0);
        // Small pictures stand further apart, so that their labels can be read.
        let cell = ((picture.0 + beside).max(label_width(entries)), picture.1.max(inset.0) + text);
        let count = u32::try_from(entries.len()).unwrap_or(u32::MAX);
        let columns = layout.columns.clamp(1, count.max(1));
        let rows = count.div_ceil(columns);
        let along = |cells: u32, side: u32| {
            (2 * MARGIN).saturating_add(cells.saturating_mul(side)).saturating_add(GAP * cells.saturating_sub(1))
        };
        let width = along(columns, cell.0);
        let notes: Vec<String> =
            layout.notes.iter().flat_map(|note| wrapped(note, f64::from(width - 2 * MARGIN))).collect();
        let foot = if notes.is_empty() { 0 } else { pixels(line_height(CAPITAL) * notes.len() as f64) + GAP };
        let size = (width, along(rows, cell.1).saturating_add(foot));
        Self { picture, inset, cell, columns, rows, notes, size }
    }

    /// The top left corner of a cell.
    fn corner(&self, number: u32) -> [u32; 2] {
        let (column, row) = (number % self.columns, number / self.columns);
        debug_assert!(row < self.rows);
        [MARGIN + column * (self.cell.0 + GAP), MARGIN + row * (self.cell.1 + GAP)]
    }
}

fn draw_entry(
    sheet: &mut Rgba8Image,
    sketch: &mut Sketch,
    grid: &Grid,
    layout: &Layout,
    (number, entry): (u32, &Entry),
) {
    let [left, top] = grid.corner(number);
    let (width, height) = (entry.image.width(), entry.image.height());
    lay_over(sheet, &entry.image, [left, top]);
    outline(sketch, [left, top], (width, height), HAIRLINE);
    if let Some(inset) = layout.inset {
        let part = enlarged(&entry.image, [inset.x.into(), inset.y.into()], [inset.size; 2], grid.inset.1);
        let place = [left + grid.picture.0 + SEAM, top];
        lay_over(sheet, &part, place);
        outline(sketch, place, (part.width(), part.height()), MARK);
        outline(sketch, [left + inset.x, top + inset.y], (inset.size, inset.size), MARK);
    }
    let x = f64::from(left);
    let mut y = f64::from(top + grid.picture.1.max(grid.inset.0)) + 5.0 + CAPITAL;
    for (lines, ink) in [(&entry.title[..], INK), (std::slice::from_ref(&entry.numbers), PALE_INK)] {
        for line in lines {
            fitted(sketch, [x, y], f64::from(grid.cell.0), ink, line);
            y += line_height(CAPITAL);
        }
    }
}

/// What the longest label needs.
fn label_width(entries: &[Entry]) -> u32 {
    let labels = entries.iter().flat_map(|entry| entry.title.iter().chain([&entry.numbers]));
    pixels(labels.map(|label| text_width(label, CAPITAL)).fold(0.0, f64::max)).min(MAX_LABEL)
}

/// The text in lines that are not wider than `width`, broken at blanks.
fn wrapped(text: &str, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if text_width(&format!("{line} {word}"), CAPITAL) <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

/// A line just around a rectangle of pixels.
fn outline(sketch: &mut Sketch, [left, top]: [u32; 2], (width, height): (u32, u32), color: &str) {
    let [x, y] = [f64::from(left) - 0.5, f64::from(top) - 0.5];
    sketch.frame([x, y, f64::from(width) + 1.0, f64::from(height) + 1.0], 1.0, color);
}

/// A line of text, smaller where it would not fit.
fn fitted(sketch: &mut Sketch, place: [f64; 2], width: f64, ink: &str, text: &str) {
    let needed = text_width(text, CAPITAL);
    let capital = if needed > width { (CAPITAL * width / needed).max(4.0) } else { CAPITAL };
    sketch.text(place, Anchor::Left, capital, ink, text);
}

/// Rounded up.
fn pixels(length: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates; lengths are not negative")]
    let pixels = length.ceil() as u32;
    pixels
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_are_broken_at_blanks_and_lose_no_word() {
        let note = "RMSE: root of the mean square difference, in codes of 0 to 255.";
        let lines = wrapped(note, 150.0);
        assert!(lines.len() > 2 && lines.iter().all(|line| text_width(line, CAPITAL) <= 150.0), "{lines:?}");
        assert_eq!(lines.join(" "), note);
        assert_eq!(wrapped("unbreakable", 1.0), ["unbreakable"]);
    }

    #[test]
    fn labels_of_small_pictures_have_room() {
        let entry = Entry {
            image: Rgba8Image::new(4, 4),
            title: vec!["level-filter nearest".to_owned()],
            numbers: "RMSE 1.25".to_owned(),
        };
        let layout = Layout { columns: 1, inset: None, notes: Vec::new() };
        let grid = Grid::new(&[entry], &layout);
        assert!(f64::from(grid.cell.0) >= text_width("level-filter nearest", CAPITAL));
    }
}
