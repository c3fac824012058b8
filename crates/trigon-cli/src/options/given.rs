//! Which options with a default were written by the user: the defaults of SVG pictures differ from those of models.

use clap::ArgMatches;
use clap::parser::ValueSource;

/// What the user wrote, beside the values.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Given {
    pub(crate) size: bool,
    pub(crate) samples: bool,
    pub(crate) pattern: bool,
    pub(crate) pixel_filter: bool,
    pub(crate) level_filter: bool,
    pub(crate) anisotropy: bool,
    pub(crate) wrap: bool,
}

impl Given {
    /// What was written after the subcommand.
    pub(crate) fn of(matches: &ArgMatches) -> Self {
        let Some((_, options)) = matches.subcommand() else { return Self::default() };
        let is_given = |id: &str| {
            options.try_contains_id(id).is_ok() && options.value_source(id) == Some(ValueSource::CommandLine)
        };
        Self {
            size: is_given("size"),
            samples: is_given("samples"),
            pattern: is_given("pattern"),
            pixel_filter: is_given("pixel_filter"),
            level_filter: is_given("level_filter"),
            anisotropy: is_given("anisotropy"),
            wrap: is_given("wrap"),
        }
    }
}
