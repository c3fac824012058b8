//! The material libraries of an OBJ file: `mtllib` statements in, the materials in use out.

use super::runs::Runs;
use crate::load::{Findings, LoadError, Place, SideFiles, WarningKind};
use crate::mtl;
use crate::scene::{Material, MaterialId};
use crate::text::decode_name;
use std::collections::{HashMap, HashSet};

/// The materials of all libraries of a file.
pub(super) struct Library<'f> {
    /// The OBJ file, for messages.
    file: &'f str,
    materials: Vec<Material>,
    ids: HashMap<String, usize>,
    /// The names in use; textures of others are not read.
    used: HashSet<String>,
    /// Paths read, so that each is read once.
    loaded: Vec<String>,
    /// Whether a library is missing, which explains missing materials.
    is_incomplete: bool,
}

/// The most libraries of one file.
const MAX_FILES: usize = 256;

impl<'f> Library<'f> {
    pub(super) fn new(file: &'f str, runs: &Runs<'_>) -> Self {
        let used = runs.materials().filter_map(|(name, _)| Some(decode_name(name?).into_owned())).collect();
        Self { file, materials: Vec::new(), ids: HashMap::new(), used, loaded: Vec::new(), is_incomplete: false }
    }

    /// Loads what a `mtllib` statement on `line` names: one file whose name may hold blanks, or several.
    pub(super) fn load(
        &mut self,
        names: &[u8],
        line: u64,
        context: &mut mtl::Context<'_, '_>,
    ) -> Result<(), LoadError> {
        for name in library_names(names, context.side_files) {
            let Some(found) = context.side_files.find(name, "") else {
                self.is_incomplete = true;
                let message = format!("material library {} not found; neutral materials used", decode_name(name));
                context.findings.warn(self.file, Place::Line(line), WarningKind::MissingFile, message)?;
                continue;
            };
            if self.loaded.contains(&found) || self.loaded.len() >= MAX_FILES {
                continue;
            }
            match context.side_files.read(&found, context.max_bytes) {
                Ok(bytes) => self.add(&bytes, &found, context)?,
                Err(problem) => {
                    self.is_incomplete = true;
                    context.findings.warn(self.file, Place::Line(line), problem.kind, problem.message)?;
                }
            }
            self.loaded.push(found);
        }
        Ok(())
    }

    /// Adds the materials of a library; the first library that defines a name wins.
    fn add(&mut self, bytes: &[u8], found: &str, context: &mut mtl::Context<'_, '_>) -> Result<(), LoadError> {
        for material in mtl::read_library(bytes, found, &self.used, context)? {
            if !self.ids.contains_key(&material.name) {
                self.ids.insert(material.name.clone(), self.materials.len());
                self.materials.push(material);
            }
        }
        if u64::try_from(self.materials.len()).unwrap_or(u64::MAX) > context.max_materials {
            return Err(LoadError::limit(found, "materials", context.max_materials));
        }
        Ok(())
    }

    /// The materials in use and their ids, in order of first use; neutral ones for those that are not defined. An error if
    /// they are more than `max_materials`.
    pub(super) fn pick(
        &self,
        runs: &Runs<'_>,
        max_materials: u64,
        findings: &mut Findings,
    ) -> Result<(Vec<Material>, Vec<MaterialId>), LoadError> {
        let mut materials = Vec::new();
        let mut ids = Vec::new();
        for (name, line) in runs.materials() {
            if u64::try_from(materials.len()).unwrap_or(u64::MAX) >= max_materials {
                return Err(LoadError::limit(self.file, "materials", max_materials));
            }
            ids.push(MaterialId(u32::try_from(materials.len()).unwrap_or(u32::MAX)));
            let Some(name) = name else {
                materials.push(Material::default());
                continue;
            };
            let name = decode_name(name).into_owned();
            if let Some(&id) = self.ids.get(&name) {
                materials.push(self.materials[id].clone());
                continue;
            }
            if !self.is_incomplete && !name.is_empty() {
                let message = format!("material {name} is not defined; a neutral one used");
                findings.warn(self.file, Place::Line(line + 1), WarningKind::MissingMaterial, message)?;
            }
            materials.push(Material { name, ..Material::default() });
        }
        Ok((materials, ids))
    }
}

/// The files a `mtllib` statement names. The statement separates files by blanks, and names hold blanks too: the whole
/// is one name if there is just such a file; else words are joined up to the next `.mtl`.
fn library_names<'a>(names: &'a [u8], side_files: &SideFiles<'_>) -> Vec<&'a [u8]> {
    let is_blank = |b: &u8| b.is_ascii_whitespace();
    if !names.iter().any(is_blank) || side_files.has_beside_model(names) {
        return vec![names];
    }
    let mut split = Vec::new();
    let mut start = 0;
    for end in (1..=names.len()).filter(|&end| end == names.len() || is_blank(&names[end])) {
        let name = names[start..end].trim_ascii();
        let has_extension = name.len() > 4 && name[name.len() - 4..].eq_ignore_ascii_case(b".mtl");
        if !name.is_empty() && (has_extension || end == names.len()) {
            split.push(name);
            start = end;
        }
        if split.len() >= MAX_FILES {
            break;
        }
    }
    split
}
