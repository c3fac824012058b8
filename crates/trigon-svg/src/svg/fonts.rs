//! Which fonts text is set in.

use std::path::PathBuf;

use usvg::FontResolver;
use usvg::fontdb::Database;

use super::warnings::SharedWarnings;

/// Where fonts come from, and which family stands for which generic one.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FontOptions {
    /// Whether the fonts installed on this machine are used. Text then differs from machine to machine.
    pub use_system_fonts: bool,
    /// Folders whose font files are used, with their subfolders.
    pub folders: Vec<PathBuf>,
    /// Font files.
    pub files: Vec<PathBuf>,
    /// The family of text that names none.
    pub default_family: Option<String>,
    /// The family for `serif`.
    pub serif: Option<String>,
    /// The family for `sans-serif`.
    pub sans_serif: Option<String>,
    /// The family for `cursive`.
    pub cursive: Option<String>,
    /// The family for `fantasy`.
    pub fantasy: Option<String>,
    /// The family for `monospace`.
    pub monospace: Option<String>,
}

impl Default for FontOptions {
    fn default() -> Self {
        Self {
            use_system_fonts: true,
            folders: Vec::new(),
            files: Vec::new(),
            default_family: None,
            serif: None,
            sans_serif: None,
            cursive: None,
            fantasy: None,
            monospace: None,
        }
    }
}

impl FontOptions {
    /// Reads all fonts; what cannot be read is left out and named.
    pub(super) fn load(&self) -> (Database, Vec<String>) {
        let mut database = Database::new();
        let mut unreadable = Vec::new();
        for folder in &self.folders {
            if folder.is_dir() {
                database.load_fonts_dir(folder);
            } else {
                unreadable.push(format!("the font folder '{}' cannot be read", folder.display()));
            }
        }
        for file in &self.files {
            if database.load_font_file(file).is_err() {
                unreadable.push(format!("the font file '{}' cannot be read", file.display()));
            }
        }
        // System fonts come last, so that a family that was given wins over an installed one of the same name.
        if self.use_system_fonts {
            database.load_system_fonts();
        }
        self.name_families(&mut database);
        (database, unreadable)
    }

    fn name_families(&self, database: &mut Database) {
        if let Some(family) = self.serif.as_ref().or(self.default_family.as_ref()) {
            database.set_serif_family(family);
        }
        if let Some(family) = &self.sans_serif {
            database.set_sans_serif_family(family);
        }
        if let Some(family) = &self.cursive {
            database.set_cursive_family(family);
        }
        if let Some(family) = &self.fantasy {
            database.set_fantasy_family(family);
        }
        if let Some(family) = &self.monospace {
            database.set_monospace_family(family);
        }
    }
}

/// The usual choice of fonts; what text asks for and no font has is added to `missing`.
pub(super) fn watched_fonts(missing: &SharedWarnings) -> FontResolver<'_> {
    let FontResolver { select_font, select_fallback } = FontResolver::default();
    FontResolver {
        select_font: Box::new(move |font, database| {
            let found = select_font(font, database);
            if found.is_none() {
                let families: Vec<String> = font.families().iter().map(ToString::to_string).collect();
                let families = families.join(", ");
                missing.add(format!("text in {families} is not drawn: no such font, nor one for serif, was found"));
            }
            found
        }),
        select_fallback: Box::new(move |character, used, database| {
            let found = select_fallback(character, used, database);
            if found.is_none() && !character.is_control() && !character.is_whitespace() {
                missing.add(format!("no font has the character U+{:04X} {character}", u32::from(character)));
            }
            found
        }),
    }
}
