//! The part of an SVG file that is shown: `page`, `drawing` or `X,Y,WIDTH,HEIGHT`.

use super::number::parse_finite_f32;
use std::str::FromStr;

/// A part of an SVG file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum PageArea {
    /// What the svg element asks for.
    Page,
    /// All that is visible.
    Drawing,
    /// Left, top, width and height in user space.
    Rect([f32; 4]),
}

impl FromStr for PageArea {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.trim() {
            "page" => return Ok(Self::Page),
            "drawing" => return Ok(Self::Drawing),
            _ => {}
        }
        let numbers = text.split(',').map(parse_finite_f32).collect::<Result<Vec<_>, _>>();
        match numbers.ok().and_then(|numbers| <[f32; 4]>::try_from(numbers).ok()) {
            Some(rect) if rect[2] > 0.0 && rect[3] > 0.0 => Ok(Self::Rect(rect)),
            Some(_) => Err("width and height must be above zero".to_owned()),
            None => Err("write page, drawing, or X,Y,WIDTH,HEIGHT such as 0,0,100,50".to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_forms_are_read() {
        assert_eq!("page".parse(), Ok(PageArea::Page));
        assert_eq!("drawing".parse(), Ok(PageArea::Drawing));
        assert_eq!("-1, 2,3.5,4".parse(), Ok(PageArea::Rect([-1.0, 2.0, 3.5, 4.0])));
        assert!("1,2,3".parse::<PageArea>().unwrap_err().contains("X,Y,WIDTH,HEIGHT"));
        assert!("1,2,0,4".parse::<PageArea>().unwrap_err().contains("above zero"));
    }
}
