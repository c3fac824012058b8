//! Lights: `KIND:...:INTENSITY[:COLOUR]` in, a light of the scene out.
//!
//! `ambient:INTENSITY`, `directional:DIRECTION:INTENSITY`, `point:POSITION:INTENSITY` and
//! `spot:POSITION:DIRECTION:ANGLE:INTENSITY`, each with an optional colour at the end.

use super::number::parse_finite_f32;
use super::{Angle, Vector, closest};
use std::str::FromStr;
use trigon_image::Color;
use trigon_scene::scene::{Light, LightKind};

/// A light as written on the command line.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct LightValue(pub(crate) Light);

const KINDS: [(&str, &str); 4] = [
    ("ambient", "ambient:INTENSITY[:COLOUR]"),
    ("directional", "directional:X,Y,Z:INTENSITY[:COLOUR]"),
    ("point", "point:X,Y,Z:INTENSITY[:COLOUR]"),
    ("spot", "spot:X,Y,Z:DX,DY,DZ:ANGLE:INTENSITY[:COLOUR]"),
];

impl FromStr for LightValue {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut fields = text.split(':');
        let word = fields.next().unwrap_or_default().trim();
        let Some(&(kind, form)) = KINDS.iter().find(|entry| entry.0.eq_ignore_ascii_case(word)) else {
            return Err(unknown_kind(word));
        };
        let mut next = |what: &str| fields.next().ok_or_else(|| format!("{what} is missing: write {form}"));
        let kind = match kind {
            "ambient" => LightKind::Ambient,
            "directional" => LightKind::Directional { direction: direction(next("the direction")?)? },
            "point" => LightKind::Point { position: next("the position")?.parse::<Vector>()?.0 },
            _ => {
                let position = next("the position")?.parse::<Vector>()?.0;
                let direction = direction(next("the direction")?)?;
                let (inner_angle, outer_angle) = cone(next("the angle")?)?;
                LightKind::Spot { position, direction, inner_angle, outer_angle }
            }
        };
        let intensity = parse_finite_f32(next("the intensity")?)?;
        if intensity < 0.0 {
            return Err(format!("the intensity {intensity} is negative"));
        }
        let color = fields.next().map_or(Ok(Color::WHITE), Color::parse).map_err(|error| error.to_string())?;
        if let Some(rest) = fields.next() {
            return Err(format!("\":{rest}\" is too much: write {form}"));
        }
        let [r, g, b, _] = color.to_linear();
        Ok(Self(Light::new(kind, intensity).with_color([r, g, b])))
    }
}

fn unknown_kind(word: &str) -> String {
    match closest(word, KINDS.map(|entry| entry.0)) {
        Some(kind) => format!("there is no light \"{word}\"; did you mean {kind}?"),
        None => format!("there is no light \"{word}\"; write {}", KINDS.map(|entry| entry.1).join(", ")),
    }
}

fn direction(text: &str) -> Result<[f64; 3], String> {
    text.parse::<Vector>()?.as_direction()
}

/// Half-angles of a cone: `30`, or inner and outer, `25/30`.
fn cone(text: &str) -> Result<(f64, f64), String> {
    let (inner, outer) = text.split_once('/').unwrap_or((text, text));
    let (Angle(inner), Angle(outer)) = (inner.parse()?, outer.parse()?);
    let fits = inner >= 0.0 && inner <= outer && outer <= std::f64::consts::FRAC_PI_2;
    if fits { Ok((inner, outer)) } else { Err(format!("the angle {text} is not within 0 to 90, inner to outer")) }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn light(text: &str) -> Light {
        text.parse::<LightValue>().unwrap().0
    }

    #[test]
    fn every_kind_is_read() {
        assert_eq!(light("ambient:0.25"), Light::new(LightKind::Ambient, 0.25));
        let red = light("point:1,2,-3:10:red");
        assert_eq!(red.kind, LightKind::Point { position: [1.0, 2.0, -3.0] });
        assert_eq!((red.intensity, red.color), (10.0, [1.0, 0.0, 0.0]));
        assert_eq!(light("Directional:0,-1,0:1").kind, LightKind::Directional { direction: [0.0, -1.0, 0.0] });
        let LightKind::Spot { inner_angle, outer_angle, .. } = light("spot:0,5,0:0,-1,0:20/30:40:#fff").kind else {
            panic!("a spot light")
        };
        assert!((inner_angle - 20.0_f64.to_radians()).abs() < 1e-15);
        assert!((outer_angle - 30.0_f64.to_radians()).abs() < 1e-15);
    }

    #[test]
    fn errors_say_which_part_and_what_to_write() {
        let message = |text: &str| text.parse::<LightValue>().unwrap_err();
        assert!(message("pont:0,0,0:1").contains("did you mean point?"));
        assert!(message("sun").contains("directional:X,Y,Z"));
        assert!(message("point:0,0,0").contains("the intensity is missing"));
        assert!(message("ambient:-1").contains("negative"));
        assert!(message("ambient:1:white:2").contains("too much"));
        assert!(message("ambient:1:whit").contains("is no colour"));
        assert!(message("directional:0,0,0:1").contains("no direction"));
        assert!(message("spot:0,0,0:1,0,0:40/30:1").contains("inner to outer"));
    }
}
