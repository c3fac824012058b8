//! Presets: other programs, as other defaults of the options.
//!
//! In: the name of a program. Out: the table of options with its values as defaults, so that whatever is written still
//! comes first, and the help of an option stays true.

use super::{command_line, shading};
use clap::{Args, Command, ValueEnum};
use std::ffi::OsString;

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
    /// GAMES101, homework 2: its two triangles, without a model; --samples 4 for its bonus
    #[value(name = "games101-hw2")]
    Games101Hw2,
    /// GAMES101, homework 3: its lights and material; --shader normal, texture, phong, bump or displacement
    #[value(name = "games101-hw3")]
    Games101Hw3,
    /// tinyrenderer: its camera, light, textures by the model's name; --shader tinyrenderer-flat and others are lessons
    Tinyrenderer,
    /// LearningTinyrenderer: its camera and its point light, on black; for turntable, too
    LearningTinyrenderer,
}

/// An option and its default.
type Default = (&'static str, &'static str);

const GAMES101_HW2: &[Default] = &[
    ("size", "700x700"),
    ("samples", "1"),
    ("pattern", "grid"),
    ("color_space", "encoded"),
    ("background", "#000"),
    ("eye", "0,0,5"),
    ("target", "0,0,0"),
    ("fov", "45"),
    ("near", "0.1"),
    ("far", "50"),
    ("shader", "unlit"),
];

/// Its lights are attached to the camera, and added when there is one.
const GAMES101_HW3: &[Default] = &[
    ("size", "700x700"),
    ("samples", "1"),
    ("pattern", "grid"),
    ("color_space", "encoded"),
    ("background", "#000"),
    ("eye", "0,0,10"),
    ("target", "0,0,0"),
    ("fov", "45"),
    ("near", "0.1"),
    ("far", "50"),
    ("scale", "2.5"),
    ("rotate_y", "140"),
    ("shader", "phong"),
    ("pixel_filter", "nearest"),
    ("level_filter", "zero"),
    ("anisotropy", "1"),
    ("wrap", "clamp"),
];

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
    ("sample_at", "lower-left"),
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
    /// Whether it is about SVG pictures; the others are about models.
    pub(crate) fn is_for_drawings(self) -> bool {
        self == Self::Cs184
    }

    /// Whether it has a scene of its own, and takes no models.
    pub(crate) fn has_scene(self) -> bool {
        self == Self::Games101Hw2
    }

    /// The option as it is written.
    pub(crate) fn written(self) -> &'static str {
        match self {
            Self::Cs184 => "--preset cs184",
            Self::Games101Hw2 => "--preset games101-hw2",
            Self::Games101Hw3 => "--preset games101-hw3",
            Self::Tinyrenderer => "--preset tinyrenderer",
            Self::LearningTinyrenderer => "--preset learning-tinyrenderer",
        }
    }

    fn defaults(self) -> &'static [Default] {
        match self {
            Self::Cs184 => &[],
            Self::Games101Hw2 => GAMES101_HW2,
            Self::Games101Hw3 => GAMES101_HW3,
            Self::Tinyrenderer => TINYRENDERER,
            Self::LearningTinyrenderer => LEARNING_TINYRENDERER,
        }
    }

    /// The preset that is named among `arguments`, if there is one.
    fn named(arguments: &[OsString]) -> Option<Self> {
        let mut words = arguments.iter().filter_map(|argument| argument.to_str()).take_while(|word| *word != "--");
        let name = words.find_map(|word| word.strip_prefix("--preset").map(str::to_owned))?;
        match name.strip_prefix('=') {
            Some(name) => Self::from_str(name, false).ok(),
            None => Self::from_str(words.next()?, false).ok(),
        }
    }

    /// A subcommand with the defaults of the preset.
    fn applied(self, mut command: Command, is_framed: bool) -> Command {
        let is_kept = |(id, _): &&Default| !is_framed || !["eye", "target", "near", "far"].contains(id);
        for &(id, value) in self.defaults().iter().filter(is_kept) {
            command = command.mut_arg(id, |option| option.default_value(value));
        }
        match self {
            Self::Games101Hw2 => command.mut_arg("models", |models| models.required(false)),
            Self::Games101Hw3 => command.mut_arg("shader", |shader| shader.value_parser(shading::homework_3_parser())),
            _ => command,
        }
    }
}

/// The table of options that `arguments` are read with: with the defaults of the preset that they name. Whoever writes
/// an angle of the framing wants no other eye.
pub(crate) fn command_line_for(arguments: &[OsString]) -> Command {
    let Some(preset) = Preset::named(arguments) else { return command_line() };
    let is_angle = |word: &str| word.starts_with("--azimuth") || word.starts_with("--elevation");
    let is_framed = arguments.iter().any(|argument| argument.to_str().is_some_and(is_angle));
    let has_preset = |command: &Command| command.get_arguments().any(|argument| argument.get_id() == "preset");
    command_line()
        .mut_subcommands(|command| if has_preset(&command) { preset.applied(command, is_framed) } else { command })
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::ArgMatches;
    use trigon_scene::render::ShaderKind;
    use trigon_scene::render::course::games101::Homework3;
    use trigon_scene::render::course::tinyrenderer;
    use trigon_scene::scene::{Projection, Scene};

    fn read(line: &str) -> ArgMatches {
        let arguments: Vec<OsString> = line.split(' ').map(OsString::from).collect();
        let matches = command_line_for(&arguments).try_get_matches_from(&arguments).unwrap();
        matches.subcommand().unwrap().1.clone()
    }

    #[test]
    fn defaults_are_values_of_options_and_give_way() {
        for preset in Preset::value_variants().iter().filter(|preset| !preset.is_for_drawings()) {
            for command in ["render", "turntable", "compare --vary wrap=clamp", "explain -p 1,1"] {
                let options = read(&format!("trigon {command} a.obj -o b.png {} --samples 4", preset.written()));
                assert_eq!(options.get_one::<u32>("samples"), Some(&4));
                assert_eq!(options.get_one::<Preset>("preset"), Some(preset));
                assert!(options.contains_id("eye"), "{preset:?}");
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
        assert!(!read("trigon render a.obj -o b.png --preset=tinyrenderer --azimuth 10").contains_id("eye"));
    }

    #[test]
    fn shaders_of_homework_3_have_short_names_there() {
        let shader = |line: &str| *read(line).get_one::<ShaderKind>("shader").unwrap();
        let line = "trigon render a.obj -o b.png --preset games101-hw3";
        assert_eq!(shader(line), ShaderKind::Games101(Homework3::Phong));
        assert_eq!(shader(&format!("{line} --shader normal")), ShaderKind::Games101(Homework3::Normal));
        assert_eq!(shader(&format!("{line} --shader games101-bump")), ShaderKind::Games101(Homework3::Bump));
        assert_eq!(shader(&format!("{line} --shader unlit")), ShaderKind::Unlit);
        assert_eq!(shader("trigon render a.obj -o b.png --shader normal"), ShaderKind::Normal);
    }

    #[test]
    fn models_are_left_out_where_the_preset_has_a_scene() {
        assert!(!read("trigon render -o b.png --preset games101-hw2").contains_id("models"));
    }
}
