//! What `render` and `turntable` share: options in; a scene, a renderer and a report out, then frame after frame.
//!
//! Everything that can be wrong with the command line and the output is found before a model is read.

use crate::failure::Failure;
use crate::load::Models;
use crate::options::{Preset, RenderOptions};
use crate::output::{Destination, Encoding, Images};
use crate::pictures::{Layers, SvgTextures};
use crate::report::{Report, ReportTarget, Stages};
use crate::terminal::Terminal;
use crate::turn::Turn;
use crate::values::UpDirection;
use crate::{machine, settings, view, warnings};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::{Duration, Instant};
use trigon::pipeline::{Picture, Renderer};
use trigon_scene::load::Warning;
use trigon_scene::render::course::games101;
use trigon_scene::render::{RenderSettings, SceneRenderer, SceneStory};
use trigon_scene::scene::{Camera, Scene};

/// A scene set up to be drawn.
pub(crate) struct Studio {
    pub(crate) terminal: Terminal,
    pub(crate) scene: Scene,
    /// The direction that is up in the scene.
    pub(crate) up: UpDirection,
    renderer: Renderer,
    scene_renderer: SceneRenderer,
    settings: RenderSettings,
    layers: Layers,
    svg_textures: Option<Arc<SvgTextures>>,
    picture: Picture,
    is_strict: bool,
    report: Report,
    report_target: Option<ReportTarget>,
}

impl Studio {
    /// Checks the options, then reads the models.
    pub(crate) fn open(options: &RenderOptions, output: &Destination, encoding: &Encoding) -> Result<Self, Failure> {
        let mut studio = Self::empty(options, output, encoding)?;
        studio.load(options, output)?;
        Ok(studio)
    }

    /// Finds everything that can be wrong before a model is read.
    fn empty(options: &RenderOptions, output: &Destination, encoding: &Encoding) -> Result<Self, Failure> {
        let mut report = Report::start();
        check_inputs(&options.models, options.preset.preset)?;
        view::check(&options.view)?;
        output.check(&options.models)?;
        output.check_not_among(&options.picture.layer_files())?;
        let report_target = ReportTarget::choose(options.output.json.as_ref(), output);
        report_target.as_ref().map_or(Ok(()), |target| target.check(&options.models))?;
        let settings = settings::render_settings(options, encoding.outputs(report_target.is_some()))?;
        let renderer_options = machine::renderer_options(&options.machine)?;
        let renderer = Renderer::new(renderer_options).map_err(|error| Failure::usage(error.to_string()))?;

        report.models = options.models.iter().map(|path| path.display().to_string()).collect();
        report.output = output.name();
        report.format = encoding.format.name();
        report.size = (settings.width, settings.height);
        report.samples = settings.samples.to_string();
        report.shader = settings.shader.name();
        report.simd = renderer_options.simd.name();
        report.threads = renderer_options.threads;
        Ok(Self {
            terminal: Terminal::detect(options.output.quiet),
            scene: Scene::default(),
            up: UpDirection::PLUS_Y,
            renderer,
            scene_renderer: SceneRenderer::new(),
            settings,
            layers: Layers::default(),
            svg_textures: None,
            picture: Picture::default(),
            is_strict: options.input.strict,
            report,
            report_target,
        })
    }

    /// Reads the models, places them and adds the lights.
    fn load(&mut self, options: &RenderOptions, output: &Destination) -> Result<(), Failure> {
        let started = Instant::now();
        let mut models = Models::load(options)?;
        self.layers = Layers::read(options, &mut self.settings)?;
        self.report.stages.load = started.elapsed();
        output.check_not_among(&models.files)?;
        self.warn_all(&models.warnings)?;
        let warnings = std::mem::take(&mut self.layers.warnings);
        self.warn_of_pictures(warnings)?;
        self.svg_textures = Some(models.svg_textures.clone());
        models.place(&options.view);
        self.up = options.view.up.unwrap_or(models.up);
        self.scene = models.scene;
        self.scene.lights.extend(options.shading.lights.iter().map(|light| light.0.clone()));
        self.report.triangles = self.scene.triangle_count();
        Ok(())
    }

    /// The camera that the options ask for, after what depends on it: displaced geometry, and lights that a preset
    /// attaches to it. `turn`, if there is one, is all of what it has to show.
    pub(crate) fn look(&mut self, options: &RenderOptions, turn: Option<&Turn>) -> Result<Camera, Failure> {
        let mut camera = self.camera(options, turn)?;
        if self.displace(options, &camera)? {
            camera = self.camera(options, turn)?;
        }
        if options.preset.preset == Some(Preset::Games101Hw3) && options.shading.lights.is_empty() {
            self.scene.lights.extend(games101::lights(&camera));
        }
        Ok(camera)
    }

    fn camera(&self, options: &RenderOptions, turn: Option<&Turn>) -> Result<Camera, Failure> {
        match turn {
            Some(turn) => view::camera(&options.view, &turn.swept(&self.scene), self.up, self.aspect()),
            None => view::camera(&options.view, &self.scene, self.up, self.aspect()),
        }
    }

    /// Makes geometry of height maps, if the options ask for it: fine enough for what `camera` sees. True if it has.
    fn displace(&mut self, options: &RenderOptions, camera: &Camera) -> Result<bool, Failure> {
        let Some(settings) = options.displacement.displacement() else { return Ok(false) };
        let started = Instant::now();
        let displaced = self.scene.displace(camera, [self.settings.width, self.settings.height], &settings);
        self.report.stages.upload += started.elapsed();
        self.report.triangles = self.scene.triangle_count();
        self.warn_all(&displaced.warnings)?;
        if displaced.meshes == 0 {
            let message = "--displace: no surface has texture coordinates and a height map (disp or map_Disp); name a map \
                           with --height-map";
            return Err(Failure::work(message));
        }
        if !displaced.is_fine {
            let message = format!(
                "{} triangles do not suffice for edges of {} pixels; raise --displace-limit or --displace-edge",
                settings.max_triangles, settings.max_edge_px
            );
            self.report.warn(self.terminal, message);
        }
        Ok(true)
    }

    /// Width / height.
    fn aspect(&self) -> f64 {
        f64::from(self.settings.width) / f64::from(self.settings.height)
    }

    /// Width and height in pixels.
    pub(crate) fn size(&self) -> (u32, u32) {
        (self.settings.width, self.settings.height)
    }

    /// Draws the scene as it is now.
    pub(crate) fn draw(&mut self, camera: &Camera) -> Result<Images, Failure> {
        let started = Instant::now();
        self.prepare()?;
        let prepared = started.elapsed();
        let (statistics, _) = self
            .scene_renderer
            .render(&mut self.renderer, &self.scene, camera, &self.settings, &mut self.picture)
            .map_err(|error| Failure::work(error.to_string()))?;
        let elapsed = started.elapsed();

        let report = &mut self.report;
        let stages = &mut report.stages;
        stages.upload += prepared;
        stages.geometry += statistics.geometry_time;
        // Effects on the whole picture take time of their own.
        stages.tiles += elapsed.saturating_sub(prepared + statistics.geometry_time);
        if report.frames == 0 {
            (report.eye, report.target) = (camera.eye, camera.target);
        }
        report.frames += 1;
        report.geometry += statistics.geometry;
        let images = self.layers.compose(Images::take(&mut self.picture));
        if let (Some(_), Some(bytes)) = (&self.report_target, &images.bytes) {
            report.hash.add(bytes);
        }
        Ok(images)
    }

    /// Makes ready what the scene needs to be drawn, its textures above all.
    fn prepare(&mut self) -> Result<(), Failure> {
        let warnings = self.scene_renderer.prepare(&self.scene, &self.settings);
        self.warn_all(&warnings)?;
        let of_pictures = self.svg_textures.as_ref().map(|textures| textures.take_warnings());
        self.warn_of_pictures(of_pictures.unwrap_or_default())
    }

    /// Draws the scene, several times where the time counts; the shortest time that a frame took, without the making of
    /// textures and draws.
    pub(crate) fn draw_timed(&mut self, camera: &Camera, is_timed: bool) -> Result<(Images, Duration), Failure> {
        const FRAMES: std::ops::RangeInclusive<u32> = 3..=20;
        const ENOUGH: Duration = Duration::from_millis(150);
        let started = Instant::now();
        let mut shortest = Duration::MAX;
        for frame in 1.. {
            let before = self.report.stages;
            let images = self.draw(camera)?;
            let Stages { geometry, tiles, .. } = self.report.stages;
            shortest = shortest.min((geometry - before.geometry) + (tiles - before.tiles));
            if !is_timed || frame >= *FRAMES.end() || (frame >= *FRAMES.start() && started.elapsed() > ENOUGH) {
                return Ok((images, shortest));
            }
        }
        Err(Failure::work("the scene was not drawn"))
    }

    /// Tells how a pixel of the picture that [`draw`](Self::draw) would make comes about; its colour is that of the
    /// picture, with what lies behind and before the scene.
    pub(crate) fn explain(&mut self, camera: &Camera, pixel: [u32; 2]) -> Result<SceneStory, Failure> {
        self.prepare()?;
        let (mut story, _) = self
            .scene_renderer
            .explain(&mut self.renderer, &self.scene, camera, &self.settings, pixel)
            .map_err(|error| Failure::work(error.to_string()))?;
        if !self.layers.is_empty()
            && let Some(picture) = self.draw(camera)?.bytes
        {
            story.color = picture.pixel(pixel[0], pixel[1]);
        }
        Ok(story)
    }

    /// Says what is odd about what was drawn, and writes the report.
    pub(crate) fn close(mut self, encode_time: Duration) -> Result<(), Failure> {
        self.report.stages.encode = encode_time;
        let geometry = self.report.geometry;
        if geometry.dropped > 0 {
            let frames = if self.report.frames > 1 { " over all frames" } else { "" };
            let message = format!("{} primitives with infinite or undefined corners were left out", geometry.dropped);
            self.report.warn(self.terminal, message + frames);
        }
        if geometry.submitted > 0 && geometry.drawn == 0 {
            let message = "nothing of the model is in the picture; check --eye, --target, --near and --far";
            self.report.warn(self.terminal, message.to_owned());
        }
        match &self.report_target {
            Some(target) => self.report.write(target, self.terminal),
            None => Ok(()),
        }
    }

    fn warn_all(&mut self, warnings: &[Warning]) -> Result<(), Failure> {
        for warning in warnings {
            if self.is_strict && warning.kind.is_error_if_strict() {
                return Err(warnings::strict(&warning));
            }
            self.report.warn(self.terminal, warning.to_string());
        }
        Ok(())
    }

    /// Says what is odd about pictures beside the models: what is not drawn of an SVG file.
    fn warn_of_pictures(&mut self, warnings: Vec<String>) -> Result<(), Failure> {
        for warning in warnings {
            if self.is_strict {
                return Err(warnings::strict(&warning));
            }
            self.report.warn(self.terminal, warning);
        }
        Ok(())
    }
}

fn check_inputs(models: &[PathBuf], preset: Option<Preset>) -> Result<(), Failure> {
    if let (Some(preset), Some(model)) = (preset.filter(|preset| preset.has_scene()), models.first()) {
        let message = format!("{} draws a scene of its own; leave out {}", preset.written(), model.display());
        return Err(Failure::usage(message));
    }
    if models.iter().filter(|path| path.as_os_str() == "-").count() > 1 {
        return Err(Failure::usage("standard input (-) can be read only once"));
    }
    Ok(())
}
