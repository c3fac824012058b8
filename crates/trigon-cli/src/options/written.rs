//! Options that the user wrote though they say nothing about the input: those of models with an SVG picture, and the other
//! way round.

use super::command_line;
use clap::ArgMatches;
use clap::parser::ValueSource;

/// Headings of the help whose options concern SVG pictures too.
const HEADINGS_FOR_BOTH: [&str; 3] = ["Output", "Picture", "Machine"];

/// Further options that concern both.
const OPTIONS_FOR_BOTH: [&str; 8] =
    ["preset", "zoom", "strict", "limits", "pixel_filter", "level_filter", "anisotropy", "wrap"];

/// Options under the headings above that concern models alone.
const OPTIONS_FOR_MODELS: [&str; 1] = ["shading"];

/// Options under the heading of SVG that concern pictures alone: models have textures and layers that are SVG.
const OPTIONS_FOR_DRAWINGS: [&str; 6] = ["width", "height", "export_id", "export_area", "view", "nearest_texel"];

/// What was written that concerns only one kind of input, as `--name`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Written {
    /// The first option that concerns models alone.
    pub(crate) for_models: Option<String>,
    /// The first option that concerns SVG pictures alone.
    pub(crate) for_drawings: Option<String>,
}

impl Written {
    /// What was written after the subcommand.
    pub(crate) fn of(matches: &ArgMatches) -> Self {
        let mut written = Self::default();
        let Some((name, options)) = matches.subcommand() else { return written };
        let table = command_line();
        for option in table.find_subcommand(name).into_iter().flat_map(clap::Command::get_opts) {
            let (id, Some(long)) = (option.get_id().as_str(), option.get_long()) else { continue };
            if options.value_source(id) != Some(ValueSource::CommandLine) {
                continue;
            }
            // What has no heading is the subcommand's own.
            let Some(heading) = option.get_help_heading() else { continue };
            let is_for_both = HEADINGS_FOR_BOTH.contains(&heading) || OPTIONS_FOR_BOTH.contains(&id);
            if OPTIONS_FOR_DRAWINGS.contains(&id) {
                written.for_drawings.get_or_insert_with(|| format!("--{long}"));
            } else if OPTIONS_FOR_MODELS.contains(&id) || !is_for_both && heading != "SVG" {
                written.for_models.get_or_insert_with(|| format!("--{long}"));
            }
        }
        written
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn written(arguments: &str) -> (Option<String>, Option<String>) {
        let matches = command_line().try_get_matches_from(arguments.split(' ')).unwrap();
        let written = Written::of(&matches);
        (written.for_models, written.for_drawings)
    }

    #[test]
    fn options_are_told_apart() {
        let of = |options: &str| written(&format!("trigon render a -o b.png {options}"));
        assert_eq!(of("--size 9x9 --samples 4 --zoom 2 --font-family x --dpi 9 -j 1 --strict"), (None, None));
        assert_eq!(of("--samples 1 --shader flat --cull back"), (Some("--shader".to_owned()), None));
        assert_eq!(of("--azimuth 3 --width 7"), (Some("--azimuth".to_owned()), Some("--width".to_owned())));
        assert_eq!(of("--texture a.png").0.as_deref(), Some("--texture"));
        assert_eq!(of("--shading sample").0.as_deref(), Some("--shading"));
    }

    #[test]
    fn lists_name_options_that_exist() {
        let table = command_line();
        let render = table.find_subcommand("render").unwrap();
        let exists = |id: &str| render.get_opts().any(|option| option.get_id() == id);
        let lists = OPTIONS_FOR_BOTH.iter().chain(&OPTIONS_FOR_MODELS).chain(&OPTIONS_FOR_DRAWINGS);
        assert!(lists.clone().all(|id| exists(id)), "{:?}", lists.filter(|id| !exists(id)).collect::<Vec<_>>());
        let heading_exists = |heading: &str| render.get_opts().any(|o| o.get_help_heading() == Some(heading));
        assert!(HEADINGS_FOR_BOTH.iter().all(|heading| heading_exists(heading)));
    }
}
