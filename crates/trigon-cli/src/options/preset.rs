//! Presets: other programs, as other defaults of the options.
//!
//! In: the name of a program. Out: the table of options with its values as defaults, so that whatever is written still
//! comes first, and the help of an option stays true.

use super::command_line;
use clap::{ArgMatches, Args, ValueEnum};

#[derive(Debug, Args)]
#[command(next_help_heading = "Presets")]
pub(crate) struct PresetOptions {
    /// Draw as another program does
    ///
    /// Sets camera, light, shader, background and textures; options that are written come first.
    #[arg(long, value_enum, value_name = "PROGRAM")]
    pub(crate) preset: Option<Preset>,
}

/// Another program whose pictures are drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Preset {
    /// The rasterizer of Berkeley's CS184, project 1: its elements, lines of one pixel, 1, 4, 9 or 16 samples
    Cs184,
    /// tinyrenderer: its camera, light, textures by the model's name; --shader tinyrenderer-flat and others are lessons
    Tinyrenderer,
    /// LearningTinyrenderer: its camera and its point light, on black; for turntable, too
    LearningTinyrenderer,
}

/// An option and its default.
type Default = (&'static str, &'static str);

/// The focal length of tinyrenderer is 7/8 of the distance of the eye: 2 atan(8 / (7 sqrt(5))).
const TINYRENDERER: &[Default] = &[
    ("size", "800x800"),
    ("samples", "1"),
    ("background", "#d1c3b1"),
    ("eye", "-1,0,2"),
    ("target", "0,0,0"),
    ("fov", "54.14326470650621"),
    ("lights", "directional:-1,-1,-1:1"),
    ("shader", "tinyrenderer"),
    ("cull", "back"),
    ("pixel_filter", "nearest"),
    ("level_filter", "zero"),
    ("anisotropy", "1"),
    ("wrap", "border"),
];

const LEARNING_TINYRENDERER: &[Default] = &[
    ("size", "700x700"),
    ("samples", "1"),
    ("background", "#000"),
    ("eye", "0,0,2.5"),
    ("target", "0,0,0"),
    ("fov", "45"),
    ("near", "0.1"),
    ("far", "50"),
    ("lights", "point:20,20,20:1400"),
    ("anisotropy", "1"),
];

impl Preset {
    /// The preset that was written.
    pub(crate) fn of(matches: &ArgMatches) -> Option<Self> {
        let (_, options) = matches.subcommand()?;
        options.try_get_one::<Self>("preset").ok().flatten().copied()
    }

    /// Whether it is about SVG pictures; the others are about models.
    pub(crate) fn is_for_drawings(self) -> bool {
        self == Self::Cs184
    }

    /// The option as it is written.
    pub(crate) fn written(self) -> &'static str {
        match self {
            Self::Cs184 => "--preset cs184",
            Self::Tinyrenderer => "--preset tinyrenderer",
            Self::LearningTinyrenderer => "--preset learning-tinyrenderer",
        }
    }

    /// The table of options with the defaults of the preset, for what `matches` holds. Whoever writes an angle of the
    /// framing wants no other eye.
    pub(crate) fn command_line(self, matches: &ArgMatches) -> clap::Command {
        let Some((name, options)) = matches.subcommand() else { return command_line() };
        let is_framed = options.contains_id("azimuth") || options.contains_id("elevation");
        let defaults = match self {
            Self::Cs184 => &[],
            Self::Tinyrenderer => TINYRENDERER,
            Self::LearningTinyrenderer => LEARNING_TINYRENDERER,
        };
        let is_kept = |(id, _): &&Default| !is_framed || !["eye", "target", "near", "far"].contains(id);
        command_line().mut_subcommand(name, |mut command| {
            for &(id, value) in defaults.iter().filter(is_kept) {
                command = command.mut_arg(id, |option| option.default_value(value));
            }
            command
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use trigon_scene::render::course::tinyrenderer;
    use trigon_scene::scene::{Projection, Scene};

    #[test]
    fn defaults_are_values_of_options_and_give_way() {
        for (preset, count) in
            [("tinyrenderer", TINYRENDERER.len()), ("learning-tinyrenderer", LEARNING_TINYRENDERER.len())]
        {
            for command in ["render", "turntable"] {
                let line = format!("trigon {command} a.obj -o b.png --preset {preset} --samples 4");
                let first = command_line().try_get_matches_from(line.split(' ')).unwrap();
                let preset = Preset::of(&first).unwrap();
                let second = preset.command_line(&first).try_get_matches_from(line.split(' ')).unwrap();
                let (_, options) = second.subcommand().unwrap();
                assert_eq!(options.get_one::<u32>("samples"), Some(&4));
                assert!(options.contains_id("eye") && count > 0);
            }
        }
    }

    #[test]
    fn the_field_of_view_of_tinyrenderer_is_that_of_its_camera() {
        let camera = tinyrenderer::camera(tinyrenderer::EYE, &Scene::default());
        let Projection::Perspective { fov_y } = camera.projection else { panic!("{camera:?}") };
        let written: f64 = TINYRENDERER.iter().find(|(id, _)| *id == "fov").unwrap().1.parse().unwrap();
        assert!((written.to_radians() - fov_y).abs() < 1e-12, "{}", fov_y.to_degrees());
    }

    #[test]
    fn an_angle_of_the_framing_replaces_the_eye() {
        let line = "trigon render a.obj -o b.png --preset tinyrenderer --azimuth 10";
        let first = command_line().try_get_matches_from(line.split(' ')).unwrap();
        let second = Preset::Tinyrenderer.command_line(&first).try_get_matches_from(line.split(' ')).unwrap();
        assert!(!second.subcommand().unwrap().1.contains_id("eye"));
    }
}
