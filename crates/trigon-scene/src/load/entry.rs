//! The entry: a path or bytes in, a scene and warnings out.

use super::resolver::read_model;
use super::{
    DirectoryResolver, Findings, Format, LoadError, LoadOptions, NoSideFiles, Place, Resolver, SideFiles, UpAxis,
    Warning, WarningKind, gzip,
};
use crate::math::Mat4;
use crate::scene::{Mesh, Scene};
use crate::{obj, ply, stl};
use std::path::Path;

/// A loaded model.
#[derive(Debug)]
#[non_exhaustive]
pub struct Loaded {
    /// What the file describes; one mesh and one instance, y up; with tangents where materials have normal maps.
    pub scene: Scene,
    /// What was wrong or ignored, in order.
    pub warnings: Vec<Warning>,
    /// The format it was read as.
    pub format: Format,
}

/// Loads the model at `path`; side files come from its folder unless the options say otherwise.
///
/// # Errors
///
/// See [`LoadError`].
pub fn load_path(path: impl AsRef<Path>, options: &LoadOptions) -> Result<Loaded, LoadError> {
    let path = path.as_ref();
    let bytes = read_model(path, options.limits.file_bytes)?;
    let beside = DirectoryResolver::new(path.parent().unwrap_or(Path::new("")));
    load(&bytes, &path.display().to_string(), options, &beside)
}

/// Loads a model from memory. `name` appears in messages, and its extension helps where the content does not tell the
/// format; it may be empty or `-`.
///
/// # Errors
///
/// See [`LoadError`].
pub fn load_bytes(name: &str, bytes: &[u8], options: &LoadOptions) -> Result<Loaded, LoadError> {
    load(bytes, name, options, &NoSideFiles)
}

fn load(bytes: &[u8], name: &str, options: &LoadOptions, default: &dyn Resolver) -> Result<Loaded, LoadError> {
    let bytes = gzip::inflate(bytes, name, options.limits.file_bytes)?;
    if u64::try_from(bytes.len()).unwrap_or(u64::MAX) > options.limits.file_bytes {
        return Err(LoadError::limit(name, "file_bytes", options.limits.file_bytes));
    }
    let format = options.format.or_else(|| Format::recognize(&bytes, name)).ok_or_else(|| {
        LoadError::unsupported(name, "not recognized as a model; OBJ, STL and PLY are read, plain or gzipped")
    })?;
    let resolver = options.resolver.as_deref().unwrap_or(default);
    let mut side_files = SideFiles::new(resolver, &options.limits);
    let mut findings = Findings::new(options.strict);
    let mut scene = match format {
        Format::Obj => obj::read(&bytes, name, options, &mut side_files, &mut findings)?,
        Format::Stl => stl::read(&bytes, name, options, &mut findings)?,
        Format::Ply => ply::read(&bytes, name, options, &mut side_files, &mut findings)?,
    };
    let is_empty = |mesh: &Mesh| mesh.triangles.is_empty() && mesh.segments.is_empty() && mesh.points.is_empty();
    if scene.meshes.iter().all(is_empty) {
        findings.warn(name, Place::File, WarningKind::Empty, "the file holds nothing to draw")?;
    }
    scene.textures = side_files.into_textures();
    for texture in &mut scene.textures {
        texture.decoder.clone_from(&options.picture_decoder);
    }
    scene.generate_tangents();
    let is_z_up = match options.up {
        UpAxis::PlusY => false,
        UpAxis::PlusZ => true,
        UpAxis::Format => format == Format::Stl,
    };
    if is_z_up {
        scene.transform(Mat4::rotation_x(-std::f64::consts::FRAC_PI_2));
    }
    Ok(Loaded { scene, warnings: findings.into_warnings(name), format })
}
