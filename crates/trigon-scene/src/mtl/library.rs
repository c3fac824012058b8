//! A whole material library: lines in, materials out in order of definition.

use super::map_statement::MapStatement;
use super::statement::Draft;
use crate::load::{Findings, LoadError, Place, SideFiles, WarningKind};
use crate::scene::{Material, TextureRef};
use crate::text::{Cursor, decode_name, to_single_byte_text};
use std::collections::HashSet;

/// What reading a library needs from the load it is part of.
pub(crate) struct Context<'a, 'r> {
    pub(crate) side_files: &'a mut SideFiles<'r>,
    pub(crate) findings: &'a mut Findings,
    pub(crate) skip_textures: bool,
    pub(crate) max_materials: u64,
    /// The largest library file.
    pub(crate) max_bytes: u64,
}

/// Reads the library `bytes` found at path `file`. Textures are read only for materials whose name is `used`. A name
/// that is defined twice keeps its place and takes the later definition.
///
/// # Errors
///
/// Too many materials; with strict loading, any finding.
pub(crate) fn read_library(
    bytes: &[u8],
    file: &str,
    used: &HashSet<String>,
    context: &mut Context<'_, '_>,
) -> Result<Vec<Material>, LoadError> {
    let text = to_single_byte_text(bytes);
    let mut cursor = Cursor::new(&text);
    let mut reader = Reader { file, used, context, materials: Vec::new(), draft: None, ignored: Vec::new() };
    while !cursor.is_at_end() {
        cursor.skip_blanks();
        if cursor.peek() == b'#' {
            cursor.finish_comment();
            continue;
        }
        if !cursor.is_at_line_end() {
            let line = u64::from(cursor.lines()) + 1;
            let keyword = cursor.word();
            reader.statement(keyword, cursor.rest_of_line(), line)?;
        }
        cursor.finish_line();
    }
    reader.finish_material()?;
    Ok(reader.materials)
}

struct Reader<'t, 'a, 'r> {
    file: &'t str,
    used: &'t HashSet<String>,
    context: &'t mut Context<'a, 'r>,
    materials: Vec<Material>,
    draft: Option<Draft>,
    /// Unknown keywords seen.
    ignored: Vec<Vec<u8>>,
}

impl Reader<'_, '_, '_> {
    fn statement(&mut self, keyword: &[u8], arguments: &[u8], line: u64) -> Result<(), LoadError> {
        let key = keyword.to_ascii_lowercase();
        if key == b"newmtl" {
            self.finish_material()?;
            let name = decode_name(arguments).into_owned();
            self.draft = Some(Draft::new(name));
            return Ok(());
        }
        let Some(draft) = &mut self.draft else {
            return self.warn(line, WarningKind::Ignored, "statement before the first newmtl ignored".to_owned());
        };
        if let Some(outcome) = draft.value(&key, arguments) {
            return match outcome {
                Ok(()) => Ok(()),
                Err(message) => self.warn(line, WarningKind::InvalidValue, message),
            };
        }
        if Draft::is_map(&key) {
            return self.map(&key, arguments, line);
        }
        if self.ignored.len() < 32 && !self.ignored.contains(&key) {
            let message = format!("statement {} ignored", decode_name(keyword.get(..40).unwrap_or(keyword)));
            self.ignored.push(key);
            return self.warn(line, WarningKind::Ignored, message);
        }
        Ok(())
    }

    fn map(&mut self, key: &[u8], arguments: &[u8], line: u64) -> Result<(), LoadError> {
        let statement = MapStatement::parse(arguments);
        for option in &statement.unknown {
            let message = format!("texture option {} ignored", decode_name(option.get(..40).unwrap_or(option)));
            self.warn(line, WarningKind::Ignored, message)?;
        }
        let is_used = self.draft.as_ref().is_some_and(|draft| self.used.contains(draft.name()));
        if self.context.skip_textures || !is_used {
            return Ok(());
        }
        if Draft::is_kept_only(key) {
            self.warn(line, WarningKind::Ignored, format!("map {} is read but not drawn", decode_name(key)))?;
        }
        if statement.file.is_empty() {
            return self.warn(line, WarningKind::InvalidValue, "texture statement without a file name".to_owned());
        }
        match self.context.side_files.texture(statement.file, self.file) {
            Ok(texture) => {
                let map = TextureRef { texture, options: statement.options };
                if let Some(draft) = &mut self.draft {
                    draft.set_map(key, map);
                }
                Ok(())
            }
            Err(problem) => self.warn(line, problem.kind, problem.message),
        }
    }

    fn finish_material(&mut self) -> Result<(), LoadError> {
        let Some(draft) = self.draft.take() else { return Ok(()) };
        let (material, remark) = draft.finish();
        if let Some(remark) = remark {
            let message = format!("material {}: {remark}", material.name);
            self.context.findings.warn(self.file, Place::File, WarningKind::Ignored, message)?;
        }
        match self.materials.iter_mut().find(|known| known.name == material.name) {
            Some(known) => {
                let message = format!("material {} is defined twice; the later definition is taken", material.name);
                *known = material;
                self.context.findings.warn(self.file, Place::File, WarningKind::Ignored, message)?;
            }
            None => self.materials.push(material),
        }
        if u64::try_from(self.materials.len()).unwrap_or(u64::MAX) > self.context.max_materials {
            return Err(LoadError::limit(self.file, "materials", self.context.max_materials));
        }
        Ok(())
    }

    fn warn(&mut self, line: u64, kind: WarningKind, message: String) -> Result<(), LoadError> {
        self.context.findings.warn(self.file, Place::Line(line), kind, message)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::{Limits, MemoryResolver};
    use crate::scene::{Illumination, Texture};

    fn read(text: &str) -> (Vec<Material>, Vec<Texture>, Vec<String>) {
        let resolver = MemoryResolver::new().with("lib/wood 1.png", "w").with("lib/n.tga", "n");
        let mut side_files = SideFiles::new(&resolver, &Limits::default());
        let mut findings = Findings::new(false);
        let mut context = Context {
            side_files: &mut side_files,
            findings: &mut findings,
            skip_textures: false,
            max_materials: 100,
            max_bytes: 1 << 20,
        };
        let used = HashSet::from(["a", "a b", ""].map(str::to_owned));
        let materials = read_library(text.as_bytes(), "lib/a.mtl", &used, &mut context).unwrap();
        let warnings = findings.into_warnings("a.mtl").iter().map(ToString::to_string).collect();
        (materials, side_files.into_textures(), warnings)
    }

    #[test]
    fn every_value_is_read() {
        let (materials, _, warnings) = read(
            "newmtl a b\nKa .1 .2 .3\nKd 0.5\nKs 1 1 0\nKe 0 0 2\nTf 0.9 0.8 0.7\nNs 250\nNi 1.5\nd 0.25\nsharpness 9\n\
             illum 1\nPr 0.1\nPm 0.2\nPs 0.3\nPc 0.4\nPcr 0.5\naniso 0.6\nanisor 0.7\n",
        );
        let m = &materials[0];
        assert_eq!(warnings, Vec::<String>::new());
        assert_eq!(m.name, "a b");
        assert_eq!((m.ambient, m.diffuse, m.specular), ([0.1, 0.2, 0.3], [0.5; 3], [1.0, 1.0, 0.0]));
        assert_eq!((m.emissive, m.transmission_filter), ([0.0, 0.0, 2.0], [0.9, 0.8, 0.7]));
        assert_eq!((m.specular_exponent, m.refraction_index, m.opacity, m.sharpness), (250.0, 1.5, 0.25, 9.0));
        assert_eq!((m.illumination, m.illum_written), (Illumination::Diffuse, Some(1)));
        assert_eq!((m.roughness, m.metallic, m.sheen), (Some(0.1), Some(0.2), Some(0.3)));
        assert_eq!((m.clearcoat, m.clearcoat_roughness), (Some(0.4), Some(0.5)));
        assert_eq!((m.anisotropy, m.anisotropy_rotation), (Some(0.6), Some(0.7)));
    }

    #[test]
    fn maps_are_found_and_missing_ones_reported_with_their_line() {
        let (materials, textures, warnings) = read(
            "newmtl a\nmap_kd -s 2 2 .\\wood 1.png\nMAP_BUMP -bm 0.5 n.tga\nnorm n.tga\nmap_Ks gone.png\n\
             newmtl unused\nmap_Kd elsewhere.png\n",
        );
        let maps = &materials[0].maps;
        assert_eq!(textures.len(), 2);
        assert_eq!(maps.diffuse.as_ref().unwrap().options.scale, [2.0, 2.0, 1.0]);
        assert_eq!(maps.bump.as_ref().unwrap().options.bump_multiplier, 0.5);
        assert_eq!(maps.bump.as_ref().unwrap().texture, maps.normal.as_ref().unwrap().texture);
        assert_eq!(maps.specular, None);
        assert_eq!(warnings, ["lib/a.mtl:5: texture gone.png not found; drawn without it"]);
        // A factor that is not written does not darken its map; one that cannot be drawn has no effect.
        assert_eq!((materials[0].diffuse, materials[0].specular), ([1.0; 3], [0.0; 3]));
    }

    #[test]
    fn opacity_is_d_before_tr() {
        let opacity = |text: &str| read(&format!("newmtl a\n{text}\n")).0[0].opacity;
        assert_eq!(opacity("Tr 0.25"), 0.75);
        assert_eq!(opacity("d 0.75\nTr 0.5"), 0.75);
        assert_eq!(opacity("Tr 0.5\nd 0.75"), 0.75);
        assert_eq!(opacity("d -halo 0.5"), 0.5);
        assert_eq!(opacity("d 7"), 1.0);
        assert_eq!(opacity("Tr 0.2\nTr 0.4"), 0.6);
    }

    #[test]
    fn odd_libraries_are_survived() {
        let (materials, _, warnings) =
            read("Kd 1 1 1\nnewmtl a\nKd 1 0 0\nKd x\nfoo 1\nfoo 2\nillum 77\nnewmtl a\nKd 0 1 0");
        assert_eq!(materials.len(), 1);
        assert_eq!(materials[0].diffuse, [0.0, 1.0, 0.0]);
        assert_eq!(warnings.len(), 5, "{warnings:?}");
        assert!(warnings[1].starts_with("lib/a.mtl:4:"), "{warnings:?}");
        let (materials, _, _) = read("newmtl \nKd 1 1 1\nnewmtl");
        assert_eq!(materials[0].name, "");
        assert!(read("").0.is_empty());
    }
}
