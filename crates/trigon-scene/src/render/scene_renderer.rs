//! The renderer of scenes: what lives from frame to frame, and the steps of one.
//!
//! In: a scene, a camera, settings. Out: a picture, counts, warnings. Textures and facts about meshes are made when a
//! frame first needs them; uniforms, surfaces and draws are made anew for each frame.

use super::course::tinyrenderer::Lesson;
use super::draws::{self, Item, Piece};
use super::edges::unique_edges;
use super::error::RenderError;
use super::frame::FrameUniforms;
use super::material::{Needs, Surface, VertexFacts, wanted};
use super::occlusion::OcclusionMap;
use super::outline;
use super::overdraw::color_counts;
use super::settings::RenderSettings;
use super::shader_kind::ShaderKind;
use super::shadow_map::ShadowMemory;
use super::shapes::Shapes;
use super::story::SceneStory;
use super::texture_cache::TextureCache;
use super::working_space::{from_linear, from_linear_premultiplied, pixels_to_linear};
use crate::load::Warning;
use crate::scene::{Camera, Instance, LightKind, Material, Mesh, Scene};
use std::borrow::Cow;
use trigon::pipeline::{Draw, Frame, FrameError, FrameStatistics, Outputs, Picture, Renderer};
use trigon::target::ColorSpace;

/// Draws scenes; keeps textures and edges between frames.
///
/// One renderer belongs to one scene. Lights, materials, instances and vertex attributes may change from frame to
/// frame; after a change of triangles or vertex colours call [`SceneRenderer::clear`].
#[derive(Default)]
pub struct SceneRenderer {
    textures: TextureCache,
    facts: Vec<MeshFacts>,
    neutral: Material,
    shadows: ShadowMemory,
}

/// A frame about to be drawn.
struct Made<'f, 'a> {
    pieces: &'f [Piece<'a>],
    items: &'f [Item<'f>],
    draws: &'f [Draw<'f>],
    uniforms: &'f FrameUniforms,
    /// The visible surfaces, as large as the picture, if a pass needed them.
    shapes: Option<Shapes>,
}

/// What is known of a mesh beyond its data.
#[derive(Default)]
pub(super) struct MeshFacts {
    has_translucent_colors: bool,
    /// Some vertex that a point is drawn at has a normal.
    pub(super) has_point_normals: bool,
    /// Made for wireframes only.
    pub(super) edges: Vec<[u32; 2]>,
    has_edges: bool,
}

impl SceneRenderer {
    /// A renderer that has seen no scene.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Forgets everything that was made from scenes.
    pub fn clear(&mut self) {
        *self = Self::default();
    }

    /// Makes what a frame with these settings will need: decodes textures, finds edges. [`SceneRenderer::render`] does
    /// so too; a call before it serves to time the two apart or to stop at warnings.
    ///
    /// Returns the textures that cannot be used, each once; they are drawn as if they were not there.
    pub fn prepare(&mut self, scene: &Scene, settings: &RenderSettings) -> Vec<Warning> {
        let threads = std::thread::available_parallelism().map_or(1, usize::from);
        let needs = needs(scene, settings);
        let warnings = self.textures.ensure(scene, &wanted(&scene.materials, &needs), threads);
        self.facts.truncate(scene.meshes.len());
        for (i, mesh) in scene.meshes.iter().enumerate() {
            if i >= self.facts.len() {
                self.facts.push(MeshFacts::new(mesh));
            }
            if settings.wireframe.is_some() && !self.facts[i].has_edges {
                self.facts[i].edges = unique_edges(mesh);
                self.facts[i].has_edges = true;
            }
        }
        warnings
    }

    /// Draws `scene` as `camera` sees it into `picture`.
    ///
    /// # Errors
    ///
    /// A picture or shadow map size outside 1..=16 384, more primitives than 32-bit numbers can name, or a deadline of
    /// `renderer` that comes before the end. `picture` then has no images.
    pub fn render(
        &mut self,
        renderer: &mut Renderer,
        scene: &Scene,
        camera: &Camera,
        settings: &RenderSettings,
        picture: &mut Picture,
    ) -> Result<(FrameStatistics, Vec<Warning>), RenderError> {
        let warnings = self.prepare(scene, settings);
        let drawn = self.with_draws(renderer, scene, camera, settings, |renderer, made| {
            let mut statistics = renderer.render(&frame(settings), made.draws, picture)?;
            finish(picture, settings, made.items);
            if settings.has_course_lines() {
                let (shapes, times) = made.shapes(renderer, camera, settings, 1)?;
                let lines = made.uniforms.depth_scale.lines(&shapes, renderer.options());
                outline::lay(picture, &lines, [0.0, 0.0, 0.0, 1.0]);
                add_times(&mut statistics, &times);
            }
            if let Some(outline) = settings.shown_outline() {
                let scale = outline::scale(settings);
                let (shapes, times) = made.shapes(renderer, camera, settings, scale)?;
                outline::draw(picture, &shapes, scale, &outline, renderer.options());
                add_times(&mut statistics, &times);
            }
            if renderer.deadline().is_over() { Err(FrameError::TimeOver.into()) } else { Ok(statistics) }
        });
        let (mut statistics, passes) = drawn.inspect_err(|_| *picture = Picture::default())?;
        add_times(&mut statistics, &passes);
        Ok((statistics, warnings))
    }

    /// Tells how one pixel of the picture that [`render`](Self::render) draws comes about; `pixel` is its column and row.
    ///
    /// The outputs that the settings ask for do not matter.
    ///
    /// # Errors
    ///
    /// As [`render`](Self::render), or a pixel outside of the picture.
    pub fn explain(
        &mut self,
        renderer: &mut Renderer,
        scene: &Scene,
        camera: &Camera,
        settings: &RenderSettings,
        pixel: [u32; 2],
    ) -> Result<(SceneStory, Vec<Warning>), RenderError> {
        let warnings = self.prepare(scene, settings);
        let (mut story, _) = self.with_draws(renderer, scene, camera, settings, |renderer, made| {
            let story = renderer.explain(&frame(settings), made.draws, pixel)?;
            Ok(SceneStory::new(story, scene, made.pieces, made.items))
        })?;
        // Last steps that look at the whole picture.
        let settings = RenderSettings { outputs: Outputs::COLOR, ..*settings };
        let has_lines = settings.shown_outline().is_some() || settings.has_course_lines();
        if settings.shader == ShaderKind::Overdraw || has_lines {
            let mut picture = Picture::default();
            self.render(renderer, scene, camera, &settings, &mut picture)?;
            let color = picture.color.and_then(|color| color.get(pixel[0], pixel[1]));
            story.color = color.unwrap_or(story.color);
        }
        Ok((story, warnings))
    }

    /// Makes the draws of a frame, and the maps that they read, and calls `work` with them; counts the passes before.
    fn with_draws<T>(
        &mut self,
        renderer: &mut Renderer,
        scene: &Scene,
        camera: &Camera,
        settings: &RenderSettings,
        work: impl FnOnce(&mut Renderer, &Made<'_, '_>) -> Result<T, RenderError>,
    ) -> Result<(T, FrameStatistics), RenderError> {
        let mut uniforms = FrameUniforms::new(scene, camera, settings);
        // Taken out, because the draws borrow the rest of the renderer while maps are drawn.
        let mut shadows = std::mem::take(&mut self.shadows);
        let pieces = self.pieces(scene, settings);
        let mut passes = FrameStatistics::default();
        if let Some(settings) = settings.shadows.filter(|_| settings.shows_light()) {
            add_times(&mut passes, &shadows.draw(renderer, scene, &pieces, &settings, &mut uniforms.lighting)?);
        }
        let mut shapes = None;
        if let Some(occlusion) = settings.shown_occlusion() {
            let size = [settings.width, settings.height];
            let (drawn, times) = Shapes::draw(renderer, &pieces, camera, &uniforms, settings, size)?;
            uniforms.occlusion = Some(if settings.shader == ShaderKind::Tinyrenderer(Lesson::Occlusion) {
                let openness = uniforms.depth_scale.openness(&drawn, &occlusion, renderer.options());
                OcclusionMap::of(openness, &drawn, f32::MAX)
            } else {
                OcclusionMap::new(&drawn, &occlusion, scene.bounding_box().radius(), renderer.options())
            });
            shapes = Some(drawn);
            add_times(&mut passes, &times);
        }
        let blended = draws::sort_blended(&pieces, settings, &uniforms);
        let items = draws::list(&pieces, &blended, settings, &uniforms);
        let draws: Vec<Draw<'_>> = (0u32..).zip(&items).map(|(number, item)| draw(item, number)).collect();
        let made = Made { pieces: &pieces, items: &items, draws: &draws, uniforms: &uniforms, shapes };
        let done = work(renderer, &made)?;
        drop(made);
        drop(draws);
        drop(items);
        shadows.take_back(uniforms.lighting);
        self.shadows = shadows;
        Ok((done, passes))
    }

    fn pieces<'a>(&'a self, scene: &'a Scene, settings: &RenderSettings) -> Vec<Piece<'a>> {
        let needs = needs(scene, settings);
        let mut pieces = Vec::new();
        let mut first_object = 0;
        for (model, instance) in scene.instances.iter().enumerate() {
            let index = usize::try_from(instance.mesh.0).unwrap_or(usize::MAX);
            let (Some(mesh), Some(facts)) = (scene.meshes.get(index), self.facts.get(index)) else { continue };
            for submesh in &mesh.submeshes {
                let material = scene.material(submesh.material).unwrap_or(&self.neutral);
                let mut surface = Surface::new(material, &needs, settings, &self.textures, facts.of_vertices(mesh));
                if surface.is_neutral && submesh.triangles.is_empty() && !facts.has_point_normals {
                    surface.diffuse = from_linear(settings.color_space, settings.ink());
                }
                let object = first_object + submesh.part;
                pieces.push(Piece { instance, mesh, facts, submesh, object, model, surface });
            }
            first_object += u32::try_from(mesh.parts.len().max(1)).unwrap_or(1);
        }
        pieces
    }
}

impl Made<'_, '_> {
    /// The visible surfaces, drawn `scale` times as large as the picture, and what drawing them took.
    fn shapes(
        &self,
        renderer: &mut Renderer,
        camera: &Camera,
        settings: &RenderSettings,
        scale: u32,
    ) -> Result<(Cow<'_, Shapes>, FrameStatistics), RenderError> {
        match &self.shapes {
            Some(shapes) if scale == 1 => Ok((Cow::Borrowed(shapes), FrameStatistics::default())),
            _ => {
                let size = [settings.width * scale, settings.height * scale];
                let (shapes, times) = Shapes::draw(renderer, self.pieces, camera, self.uniforms, settings, size)?;
                Ok((Cow::Owned(shapes), times))
            }
        }
    }
}

impl MeshFacts {
    fn new(mesh: &Mesh) -> Self {
        let normal = |point: &u32| usize::try_from(*point).ok().and_then(|i| mesh.normals.get(i));
        Self {
            has_translucent_colors: mesh.colors.iter().any(|color| color[3] < 1.0),
            has_point_normals: mesh.points.iter().any(|point| normal(point).is_some_and(|n| *n != [0.0; 3])),
            edges: Vec::new(),
            has_edges: false,
        }
    }

    fn of_vertices(&self, mesh: &Mesh) -> VertexFacts {
        VertexFacts {
            has_uv: !mesh.uvs.is_empty(),
            has_colors: !mesh.colors.is_empty(),
            has_alpha: self.has_translucent_colors,
        }
    }

    /// Whether the instance turns the winding around.
    #[expect(clippy::unused_self, reason = "asked of a piece's facts")]
    pub(super) fn is_mirrored(&self, instance: &Instance) -> bool {
        instance.world_from_model.linear_determinant() < 0.0
    }
}

fn add_times(sum: &mut FrameStatistics, pass: &FrameStatistics) {
    sum.geometry_time += pass.geometry_time;
    sum.tile_time += pass.tile_time;
}

fn needs(scene: &Scene, settings: &RenderSettings) -> Needs {
    let has_ambient_light = scene.lights.iter().any(|light| light.kind == LightKind::Ambient);
    Needs::new(settings, has_ambient_light)
}

fn draw<'a>(item: &'a Item<'_>, number: u32) -> Draw<'a> {
    Draw {
        shader: item.shader.as_ref(),
        primitives: item.primitives,
        cull: item.cull,
        depth: item.depth,
        blend: item.blend,
        object: number,
    }
}

/// The core's frame: the outputs asked for, and those that the last steps need.
fn frame(settings: &RenderSettings) -> Frame {
    let wanted = settings.outputs;
    let is_overdraw = settings.shader == ShaderKind::Overdraw;
    let any_color = wanted.color || wanted.color_f32;
    Frame {
        width: settings.width,
        height: settings.height,
        samples: settings.samples,
        shading: settings.shading,
        interpolation: settings.interpolation,
        // Overdraw is a picture of counts.
        color_space: if is_overdraw { ColorSpace::Linear } else { settings.color_space },
        clear: match settings.shader {
            ShaderKind::Overdraw => [0.0; 4],
            ShaderKind::Coverage | ShaderKind::Tinyrenderer(Lesson::Depth) => [0.0, 0.0, 0.0, 1.0],
            _ => from_linear_premultiplied(settings.color_space, settings.background),
        },
        outputs: Outputs {
            color_f32: wanted.color_f32 || (is_overdraw && any_color),
            object: wanted.object || wanted.primitive,
            ..wanted
        },
    }
}

/// Last steps: counts to colours, display values to linear light, draw numbers to object and primitive numbers.
fn finish(picture: &mut Picture, settings: &RenderSettings, items: &[Item<'_>]) {
    let wanted = settings.outputs;
    if settings.shader == ShaderKind::Overdraw {
        color_counts(picture);
        if !wanted.color_f32 {
            picture.color_f32 = None;
        }
    } else if settings.color_space == ColorSpace::Encoded
        && let Some(floats) = &mut picture.color_f32
    {
        pixels_to_linear(floats.values_mut());
    }
    let Some(objects) = &mut picture.object else { return };
    let item = |number: u32| usize::try_from(number).ok().and_then(|i| items.get(i));
    if let Some(primitives) = &mut picture.primitive {
        for (primitive, object) in primitives.values_mut().iter_mut().zip(objects.values()) {
            if let Some(item) = item(*object) {
                *primitive = primitive.wrapping_add(item.first_primitive);
            }
        }
    }
    for object in objects.values_mut() {
        if let Some(item) = item(*object) {
            *object = item.object;
        }
    }
    if !wanted.object {
        picture.object = None;
    }
}
