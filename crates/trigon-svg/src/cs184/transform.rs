//! The `transform` attribute as the course's program reads it.
//!
//! Unlike SVG's, `scale(2)` leaves y alone, and only `matrix` takes commas: elsewhere a comma ends the arguments.

use super::number;
use crate::canvas::Transform;

/// The product of all transforms in the list, the first one outermost.
pub(super) fn parse(text: &str) -> Transform {
    let mut product = Transform::IDENTITY;
    let mut rest = text;
    while let Some((name, after)) = rest.split_once('(') {
        let (arguments, next) = after.split_once(')').unwrap_or((after, ""));
        let name = name.trim_matches(|c: char| c.is_whitespace() || c == ',');
        product = product * one(name, arguments);
        rest = next;
    }
    product
}

fn one(name: &str, arguments: &str) -> Transform {
    let before_comma = arguments.split(',').next().unwrap_or_default();
    let numbers = number::list(if name == "matrix" { arguments } else { before_comma });
    let argument = |index: usize, default: f64| numbers.get(index).copied().unwrap_or(default);
    match name {
        "matrix" if numbers.len() >= 6 => {
            Transform::new(numbers[0], numbers[1], numbers[2], numbers[3], numbers[4], numbers[5])
        }
        "translate" => Transform::translate(argument(0, 0.0), argument(1, 0.0)),
        "scale" => Transform::scale(argument(0, 1.0), argument(1, 1.0)),
        "rotate" => {
            let centre = [argument(1, 0.0), argument(2, 0.0)];
            let turn = Transform::rotate(argument(0, 0.0) * std::f64::consts::PI / 180.0);
            Transform::translate(centre[0], centre[1]) * turn * Transform::translate(-centre[0], -centre[1])
        }
        "skewX" => Transform::new(1.0, 0.0, tangent(argument(0, 0.0)), 1.0, 0.0, 0.0),
        "skewY" => Transform::new(1.0, tangent(argument(0, 0.0)), 0.0, 1.0, 0.0, 0.0),
        _ => Transform::IDENTITY,
    }
}

fn tangent(degrees: f64) -> f64 {
    trigon::math::host::tan_f64(degrees * std::f64::consts::PI / 180.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn transforms_multiply_from_the_left() {
        assert_eq!(parse("translate(10 20) scale(2 3)").apply([1.0, 1.0]), [12.0, 23.0]);
        assert_eq!(parse("scale(2)").apply([1.0, 1.0]), [2.0, 1.0]);
        assert_eq!(parse("translate(10,20)").apply([0.0, 0.0]), [10.0, 0.0]);
        assert_eq!(parse("matrix(1,2,3,4,5,6)"), Transform::new(1.0, 2.0, 3.0, 4.0, 5.0, 6.0));
        let [x, y] = parse("rotate(90 1 1)").apply([2.0, 1.0]);
        assert!((x - 1.0).abs() < 1e-12 && (y - 2.0).abs() < 1e-12);
        assert_eq!(parse("nonsense(1"), Transform::IDENTITY);
    }
}
