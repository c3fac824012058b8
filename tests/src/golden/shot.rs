//! One picture of a model, for a golden test: a model in, a view and settings that can be changed, a comparison out.

use super::check::{check, golden_path};
use crate::frames::plain_options;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use trigon::pipeline::{Picture, Renderer};
use trigon_image::Rgba8Image;
use trigon_scene::load::{DirectoryResolver, LoadOptions, Loaded, MemoryResolver, Resolver, load_bytes, load_path};
use trigon_scene::render::{RenderSettings, SceneRenderer, ShaderKind};
use trigon_scene::scene::{Camera, Framing, Light, Projection, Scene};

/// A model about to be drawn: 96 x 96 pixels in the default view unless changed.
pub struct Shot {
    scene: Scene,
    framing: Framing,
    camera: Option<Camera>,
    settings: RenderSettings,
    warnings: Vec<String>,
}

/// Side files of tests: those in memory before those in `assets/`.
struct TestFiles {
    in_memory: MemoryResolver,
    assets: DirectoryResolver,
}

impl Resolver for TestFiles {
    fn find(&self, path: &str) -> Option<String> {
        self.in_memory.find(path).or_else(|| self.assets.find(path))
    }

    fn read(&self, found: &str, max_bytes: u64) -> std::io::Result<Vec<u8>> {
        self.in_memory.read(found, max_bytes).or_else(|_| self.assets.read(found, max_bytes))
    }
}

impl Shot {
    /// A model of `assets/`.
    ///
    /// # Panics
    /// If it cannot be loaded.
    #[must_use]
    pub fn asset(name: &str) -> Self {
        Self::new(load_path(asset_folder().join(name), &LoadOptions::default()).expect("a shipped model"))
    }

    /// A model beside the golden pictures, `topic/file.obj`.
    ///
    /// # Panics
    /// If it cannot be loaded.
    #[must_use]
    pub fn model(name: &str) -> Self {
        Self::new(load_path(golden_path(name), &LoadOptions::default()).expect("a model that loads"))
    }

    /// OBJ text; materials are those of the MTL text, whose maps come from `assets/`.
    ///
    /// # Panics
    /// If it cannot be loaded.
    #[must_use]
    pub fn obj(text: &str, materials: &str) -> Self {
        let in_memory = MemoryResolver::new().with("test.mtl", materials);
        let mut options = LoadOptions::default();
        options.resolver = Some(Arc::new(TestFiles { in_memory, assets: DirectoryResolver::new(asset_folder()) }));
        let text = format!("mtllib test.mtl\n{text}");
        Self::new(load_bytes("test.obj", text.as_bytes(), &options).expect("a model that loads"))
    }

    fn new(loaded: Loaded) -> Self {
        Self {
            scene: loaded.scene,
            framing: Framing::default(),
            camera: None,
            settings: RenderSettings::new(96, 96),
            warnings: loaded.warnings.iter().map(ToString::to_string).collect(),
        }
    }

    /// Looks from `azimuth` degrees to the right of the front and `elevation` degrees above the horizon.
    #[must_use]
    pub fn from(mut self, azimuth: f64, elevation: f64) -> Self {
        self.framing.azimuth = azimuth.to_radians();
        self.framing.elevation = elevation.to_radians();
        self
    }

    /// Looks straight from the front, in parallel projection.
    #[must_use]
    pub fn face_on(mut self) -> Self {
        self.framing.projection = Projection::Orthographic { height: 1.0 };
        self.from(0.0, 0.0)
    }

    /// Looks from a place to a place, with a vertical field of view of 60 degrees.
    #[must_use]
    pub fn camera(mut self, eye: [f64; 3], target: [f64; 3]) -> Self {
        let projection = Projection::Perspective { fov_y: 60_f64.to_radians() };
        self.camera = Some(Camera { eye, target, up: [0.0, 1.0, 0.0], projection, near: 0.1, far: f64::INFINITY });
        self
    }

    /// Seen by this camera.
    #[must_use]
    pub fn seen_by(mut self, camera: Camera) -> Self {
        self.camera = Some(camera);
        self
    }

    /// Changes settings.
    #[must_use]
    pub fn with(mut self, change: impl FnOnce(&mut RenderSettings)) -> Self {
        change(&mut self.settings);
        self
    }

    /// Shows something else than materials under lights.
    #[must_use]
    pub fn shader(self, shader: ShaderKind) -> Self {
        self.with(|settings| settings.shader = shader)
    }

    /// Another size in pixels.
    #[must_use]
    pub fn size(self, width: u32, height: u32) -> Self {
        self.with(|settings| (settings.width, settings.height) = (width, height))
    }

    /// Lights instead of the rig.
    #[must_use]
    pub fn lights(mut self, lights: impl IntoIterator<Item = Light>) -> Self {
        self.scene.lights = lights.into_iter().collect();
        self
    }

    /// Changes the scene.
    #[must_use]
    pub fn scene(mut self, change: impl FnOnce(&mut Scene)) -> Self {
        change(&mut self.scene);
        self
    }

    /// The loader must have warned, once, with a message that contains `part`.
    ///
    /// # Panics
    /// If it has not.
    #[must_use]
    pub fn warned(mut self, part: &str) -> Self {
        assert!(self.warnings.len() == 1 && self.warnings[0].contains(part), "{:?}", self.warnings);
        self.warnings.clear();
        self
    }

    /// Draws, and compares with the golden picture of the case, `topic/name`.
    ///
    /// # Panics
    /// If loading or drawing gave warnings, or the picture is another.
    pub fn check(self, case: &str) {
        assert!(self.warnings.is_empty(), "{case}: {:?}", self.warnings);
        check(case, &self.draw());
    }

    fn draw(&self) -> Rgba8Image {
        let settings = &self.settings;
        let aspect = f64::from(settings.width) / f64::from(settings.height);
        let fitted = Framing { aspect, ..self.framing }.camera(&self.scene);
        let camera = self.camera.unwrap_or(fitted);
        let mut renderer = Renderer::new(plain_options()).expect("the level is available");
        let mut picture = Picture::default();
        let (_, warnings) = SceneRenderer::new()
            .render(&mut renderer, &self.scene, &camera, settings, &mut picture)
            .expect("the size is valid");
        assert!(warnings.is_empty(), "{warnings:?}");
        let pixels = picture.color.expect("colour was asked for").into_values();
        Rgba8Image::from_pixels(settings.width, settings.height, pixels).expect("as many pixels as asked for")
    }
}

fn asset_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets")
}
