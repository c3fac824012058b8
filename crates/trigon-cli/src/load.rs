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
use trigon_scene::render::course::games101::{self, Homework3};
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
    /// Draws those textures that are SVG.
    pub(crate) svg_textures: Arc<SvgTextures>,
}

impl Models {
    /// Loads all models into one scene.
    pub(crate) fn load(render: &RenderOptions) -> Result<Self, Failure> {
        let (paths, options) = (&render.models, &render.input);
        let mut load_options = load_options(options, render.machine.threads);
        let svg_textures = Arc::new(SvgTextures::new(&render.svg_input, load_options.limits.texture_bytes));
        load_options.picture_decoder = Some(svg_textures.clone());
        let pictures = GivenPictures::read(options, &load_options)?;
        let (mut scene, mut warnings, mut up) = (Scene::default(), Vec::new(), None);
        let mut files = paths.to_vec();
        files.extend(options.texture.clone());
        files.extend(options.height_map.clone());
        let preset = render.preset.preset;
        if preset == Some(Preset::Games101Hw2) {
            scene = games101::triangles();
        }
        for path in paths {
            let mut loaded = load_one(path, &load_options)?;
            if let Some(preset) = preset {
                // What is given comes before what the preset finds.
                pictures.put_on(&mut loaded.scene)?;
                dress(&mut loaded, path, preset, render.shading.shader, &load_options);
            }
            let folder = path.parent().unwrap_or(Path::new(""));
            files.extend(loaded.scene.textures.iter().map(|texture| folder.join(&texture.name)));
            up.get_or_insert(usual_up(loaded.format));
            scene.merge(loaded.scene);
            warnings.extend(loaded.warnings);
        }
        if preset.is_none() {
            pictures.put_on(&mut scene)?;
        }
        Ok(Self { scene, warnings, up: up.unwrap_or(UpDirection::PLUS_Y), files, svg_textures })
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

/// Gives a model what the program of the preset gives it: pictures that it finds by its name, and materials.
fn dress(loaded: &mut Loaded, path: &Path, preset: Preset, shader: ShaderKind, options: &LoadOptions) {
    let beside = DirectoryResolver::new(path.parent().unwrap_or(Path::new("")));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let (scene, max_bytes) = (&mut loaded.scene, options.limits.texture_bytes);
    let warnings = match (preset, shader) {
        (Preset::Tinyrenderer, ShaderKind::Tinyrenderer(lesson)) => {
            tinyrenderer::dress(scene, &name, lesson, &beside, max_bytes)
        }
        (Preset::Tinyrenderer, _) => tinyrenderer::dress(scene, &name, Lesson::Final, &beside, max_bytes),
        (Preset::LearningTinyrenderer, _) => learning_tinyrenderer::dress(scene, &name, &beside, max_bytes),
        (Preset::Games101Hw3, ShaderKind::Games101(shading)) => {
            games101::dress(scene, &name, shading, &beside, max_bytes)
        }
        (Preset::Games101Hw3, _) => games101::dress(scene, &name, Homework3::Phong, &beside, max_bytes),
        (Preset::Cs184 | Preset::Games101Hw2, _) => return,
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

/// The bounds on what is read.
pub(crate) fn limits(options: &InputOptions) -> Limits {
    load_options(options, None).limits
}

/// The limit on the size of a file.
pub(crate) fn max_file_bytes(options: &InputOptions) -> u64 {
    limits(options).file_bytes
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

/// The pictures of --texture and --height-map.
struct GivenPictures {
    diffuse: Option<Texture>,
    heights: Option<Texture>,
}

impl GivenPictures {
    fn read(input: &InputOptions, options: &LoadOptions) -> Result<Self, Failure> {
        let read = |path: &Option<PathBuf>| path.as_ref().map(|path| read_texture(path, options)).transpose();
        Ok(Self { diffuse: read(&input.texture)?, heights: read(&input.height_map)? })
    }

    /// The texture goes on every material without a diffuse map, the heights on all, in place of those they may have.
    fn put_on(&self, scene: &mut Scene) -> Result<(), Failure> {
        if let Some(texture) = &self.diffuse {
            let id = add(scene, texture)?;
            for material in &mut scene.materials {
                if material.is_neutral() {
                    // The picture shows as it is.
                    (material.ambient, material.diffuse) = ([1.0; 3], [1.0; 3]);
                }
                material.maps.diffuse.get_or_insert_with(|| TextureRef::new(id));
            }
        }
        if let Some(texture) = &self.heights {
            let id = add(scene, texture)?;
            for material in &mut scene.materials {
                material.maps.displacement = Some(TextureRef::new(id));
            }
        }
        Ok(())
    }
}

/// Adds a picture to those of the scene.
fn add(scene: &mut Scene, texture: &Texture) -> Result<TextureId, Failure> {
    let id = u32::try_from(scene.textures.len());
    let id = id.map_err(|_| Failure::work(format!("{}: there are too many textures", texture.name)))?;
    scene.textures.push(texture.clone());
    Ok(TextureId(id))
}

fn read_texture(path: &Path, options: &LoadOptions) -> Result<Texture, Failure> {
    let limits = &options.limits;
    let failure = |problem: &str| Failure::work(format!("cannot read the texture {}: {problem}", path.display()));
    let metadata = fs::metadata(path).map_err(|error| failure(&error.to_string()))?;
    if metadata.len() > limits.texture_bytes {
        return Err(failure(&format!("larger than the limit texture-size = {}", limits.texture_bytes)));
    }
    let bytes = fs::read(path).map_err(|error| failure(&error.to_string()))?;
    let texture = Texture::new(path.display().to_string(), bytes);
    Ok(Texture { max_pixels: limits.texture_pixels, decoder: options.picture_decoder.clone(), ..texture })
}
