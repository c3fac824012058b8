//! Models: paths and input options in, one scene and its warnings out.
//!
//! Coordinates stay those of the files; which way is up is told beside the scene, so that positions on the command
//! line mean what they mean in the file.

use crate::failure::Failure;
use crate::options::{InputFormat, InputOptions, Preset, RenderOptions, ViewOptions};
use crate::pictures::SvgTextures;
use crate::stdin;
use crate::values::{LimitName, UpDirection};
use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use trigon_scene::load::{
    DirectoryResolver, Format, Limits, LoadOptions, Loaded, UpAxis, Warning, load_bytes, load_path,
};
use trigon_scene::math::Mat4;
use trigon_scene::render::ShaderKind;
use trigon_scene::render::course::learning_tinyrenderer;
use trigon_scene::render::course::tinyrenderer::{self, Lesson};
use trigon_scene::scene::{Scene, Texture, TextureId, TextureRef};

/// Models ready to be looked at.
pub(crate) struct Models {
    pub(crate) scene: Scene,
    pub(crate) warnings: Vec<Warning>,
    /// The direction that is up in the scene, unless the options say otherwise.
    pub(crate) up: UpDirection,
    /// Every file that was read and can be told.
    pub(crate) files: Vec<PathBuf>,
}

impl Models {
    /// Loads all models into one scene.
    pub(crate) fn load(render: &RenderOptions) -> Result<Self, Failure> {
        let (paths, options) = (&render.models, &render.input);
        let mut load_options = load_options(options, render.machine.threads);
        let textures = SvgTextures::new(&render.svg_input, load_options.limits.texture_bytes);
        load_options.picture_decoder = Some(Arc::new(textures));
        let (mut scene, mut warnings, mut up) = (Scene::default(), Vec::new(), None);
        let mut files = paths.to_vec();
        files.extend(options.texture.clone());
        files.extend(options.height_map.clone());
        for path in paths {
            let mut loaded = load_one(path, &load_options)?;
            dress(&mut loaded, path, render, &load_options);
            let folder = path.parent().unwrap_or(Path::new(""));
            files.extend(loaded.scene.textures.iter().map(|texture| folder.join(&texture.name)));
            up.get_or_insert(usual_up(loaded.format));
            scene.merge(loaded.scene);
            warnings.extend(loaded.warnings);
        }
        if let Some(path) = &options.texture {
            add_texture(&mut scene, path, &load_options)?;
        }
        if let Some(path) = &options.height_map {
            add_height_map(&mut scene, path, &load_options)?;
        }
        Ok(Self { scene, warnings, up: up.unwrap_or(UpDirection::PLUS_Y), files })
    }

    /// Scales and turns the models as the options ask, about the origin.
    pub(crate) fn place(&mut self, view: &ViewOptions) {
        let steps = [
            view.scale.map(|scale| Mat4::scaling(scale.0)),
            view.rotate_x.map(|angle| Mat4::rotation_x(angle.0)),
            view.rotate_y.map(|angle| Mat4::rotation_y(angle.0)),
            view.rotate_z.map(|angle| Mat4::rotation_z(angle.0)),
        ];
        for step in steps.into_iter().flatten() {
            self.scene.transform(step);
        }
    }
}

/// Gives a model the pictures that the program of the preset finds by its name.
fn dress(loaded: &mut Loaded, path: &Path, render: &RenderOptions, options: &LoadOptions) {
    let beside = DirectoryResolver::new(path.parent().unwrap_or(Path::new("")));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (scene, max_bytes) = (&mut loaded.scene, options.limits.texture_bytes);
    let warnings = match (render.preset.preset, render.shading.shader) {
        (Some(Preset::Tinyrenderer), ShaderKind::Tinyrenderer(lesson)) => {
            tinyrenderer::dress(scene, &name, lesson, &beside, max_bytes)
        }
        (Some(Preset::Tinyrenderer), _) => tinyrenderer::dress(scene, &name, Lesson::Final, &beside, max_bytes),
        (Some(Preset::LearningTinyrenderer), _) => learning_tinyrenderer::dress(scene, &name, &beside, max_bytes),
        (Some(Preset::Cs184) | None, _) => return,
    };
    for texture in &mut scene.textures {
        texture.max_pixels = options.limits.texture_pixels;
        texture.decoder.clone_from(&options.picture_decoder);
    }
    loaded.warnings.extend(warnings);
}

fn load_one(path: &Path, options: &LoadOptions) -> Result<Loaded, Failure> {
    let loaded = if path.as_os_str() == "-" {
        let bytes = read_stdin(options.limits.file_bytes)?;
        // The files that a model from standard input names are looked for in the current folder.
        let mut options = options.clone();
        options.resolver = Some(Arc::new(DirectoryResolver::new("")));
        load_bytes("standard input", bytes, &options)
    } else {
        load_path(path, options)
    };
    loaded.map_err(|error| Failure::work(error.to_string()))
}

fn read_stdin(max_bytes: u64) -> Result<&'static [u8], Failure> {
    match stdin::bytes(max_bytes) {
        Ok([]) => Err(Failure::work("standard input is empty; pipe a model into it")),
        Ok(bytes) => Ok(bytes),
        Err(error) => Err(Failure::work(format!("cannot read standard input: {error}"))),
    }
}

/// The limit on the size of a file.
pub(crate) fn max_file_bytes(options: &InputOptions) -> u64 {
    load_options(options, None).limits.file_bytes
}

fn load_options(options: &InputOptions, threads: Option<NonZeroUsize>) -> LoadOptions {
    let mut load_options = LoadOptions::default();
    load_options.format = options.input_format.map(|format| match format {
        InputFormat::Obj => Format::Obj,
        InputFormat::Stl => Format::Stl,
        InputFormat::Ply => Format::Ply,
    });
    load_options.strict = options.strict;
    load_options.threads = threads;
    load_options.up = UpAxis::PlusY;
    load_options.crease_angle = options.crease_angle.map(|angle| angle.0);
    for limit in &options.limits {
        *bound(&mut load_options.limits, limit.name) = limit.value;
    }
    load_options
}

fn bound(limits: &mut Limits, name: LimitName) -> &mut u64 {
    match name {
        LimitName::FileSize => &mut limits.file_bytes,
        LimitName::Vertices => &mut limits.vertices,
        LimitName::Triangles => &mut limits.triangles,
        LimitName::Materials => &mut limits.materials,
        LimitName::Textures => &mut limits.textures,
        LimitName::TextureSize => &mut limits.texture_bytes,
        LimitName::TexturePixels => &mut limits.texture_pixels,
    }
}

/// STL comes from machines and building plates, where z is up; so does nothing else.
fn usual_up(format: Format) -> UpDirection {
    match format {
        Format::Stl => UpDirection::PLUS_Z,
        _ => UpDirection::PLUS_Y,
    }
}

/// Puts a picture on every material without a diffuse map.
fn add_texture(scene: &mut Scene, path: &Path, options: &LoadOptions) -> Result<(), Failure> {
    let id = read_texture(scene, path, options)?;
    for material in &mut scene.materials {
        if material.is_neutral() {
            // The picture shows as it is.
            (material.ambient, material.diffuse) = ([1.0; 3], [1.0; 3]);
        }
        material.maps.diffuse.get_or_insert_with(|| TextureRef::new(id));
    }
    Ok(())
}

/// Puts a picture of heights on every material, in place of the one that it may have.
fn add_height_map(scene: &mut Scene, path: &Path, options: &LoadOptions) -> Result<(), Failure> {
    let id = read_texture(scene, path, options)?;
    for material in &mut scene.materials {
        material.maps.displacement = Some(TextureRef::new(id));
    }
    Ok(())
}

/// Adds a picture to those of the scene.
fn read_texture(scene: &mut Scene, path: &Path, options: &LoadOptions) -> Result<TextureId, Failure> {
    let limits = &options.limits;
    let failure = |problem: &str| Failure::work(format!("cannot read the texture {}: {problem}", path.display()));
    let metadata = fs::metadata(path).map_err(|error| failure(&error.to_string()))?;
    if metadata.len() > limits.texture_bytes {
        return Err(failure(&format!("larger than the limit texture-size = {}", limits.texture_bytes)));
    }
    let bytes = fs::read(path).map_err(|error| failure(&error.to_string()))?;
    let id = TextureId(u32::try_from(scene.textures.len()).map_err(|_| failure("there are too many textures"))?);
    let texture = Texture::new(path.display().to_string(), bytes);
    scene.textures.push(Texture {
        max_pixels: limits.texture_pixels,
        decoder: options.picture_decoder.clone(),
        ..texture
    });
    Ok(id)
}
