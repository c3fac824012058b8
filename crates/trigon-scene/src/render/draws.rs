//! From a scene to draws: which primitives, with which shader and state, in which order.
//!
//! In: a scene, the frame's uniforms, settings. Out: [`Item`]s. Opaque and cut-out surfaces come first, in scene order;
//! then points, lines and wireframes; then blended primitives from back to front.

use super::frame::FrameUniforms;
use super::material::{Coverage, Surface};
use super::scene_renderer::MeshFacts;
use super::settings::{RenderSettings, Wireframe};
use super::shader_kind::ShaderKind;
use super::shaders::{BlinnPhong, Full, Games101, MeshView, Overlay, Plain, Shape, Stroke, Tinyrenderer};
use super::sorting::{SortedPrimitives, back_to_front};
use super::working_space::{from_linear, from_linear_premultiplied};
use crate::math::Mat4;
use crate::scene::{Instance, Mesh, Submesh};
use trigon::geometry::{Cull, Indices, Primitives};
use trigon::raster::DepthTest;
use trigon::resolve::Blend;
use trigon::shade::ErasedShader;

/// One submesh of one instance, and its surface.
pub(super) struct Piece<'a> {
    pub(super) instance: &'a Instance,
    pub(super) mesh: &'a Mesh,
    pub(super) facts: &'a MeshFacts,
    pub(super) submesh: &'a Submesh,
    /// Number of the part among all parts of all instances.
    pub(super) object: u32,
    /// Number of the instance.
    pub(super) model: usize,
    pub(super) surface: Surface<'a>,
}

/// Sorted primitives of a blended piece.
pub(super) struct Blended<'p, 'a> {
    piece: &'p Piece<'a>,
    is_points: bool,
    sorted: SortedPrimitives,
}

/// A draw, and what its primitives are called in the outputs.
pub(super) struct Item<'f> {
    pub(super) shader: Box<dyn ErasedShader + 'f>,
    pub(super) primitives: Primitives<'f>,
    pub(super) cull: Cull,
    pub(super) depth: DepthTest,
    pub(super) blend: Blend,
    pub(super) object: u32,
    /// Index in the mesh of the first primitive.
    pub(super) first_primitive: u32,
}

/// Sorts the primitives of blended pieces, the farthest piece first.
pub(super) fn sort_blended<'p, 'a>(
    pieces: &'p [Piece<'a>],
    settings: &RenderSettings,
    frame: &FrameUniforms,
) -> Vec<Blended<'p, 'a>> {
    let mut blended = Vec::new();
    let is_blended = |piece: &&Piece<'_>| piece.is_blended(settings);
    for piece in pieces.iter().filter(is_blended) {
        let world = &piece.instance.world_from_model;
        if let Some(triangles) = piece.mesh.triangles.get(piece.submesh.triangles.clone()).filter(|t| !t.is_empty()) {
            let sorted = back_to_front(&piece.mesh.positions, triangles, world, frame);
            blended.push(Blended { piece, is_points: false, sorted });
        }
        if let Some(points) = piece.mesh.points.get(piece.submesh.points.clone()).filter(|p| !p.is_empty()) {
            let sorted = back_to_front(&piece.mesh.positions, points.as_chunks::<1>().0, world, frame);
            blended.push(Blended { piece, is_points: true, sorted });
        }
    }
    blended.sort_by(|a, b| b.sorted.distance.total_cmp(&a.sorted.distance));
    blended
}

/// The draws of a frame.
pub(super) fn list<'f>(
    pieces: &'f [Piece<'_>],
    blended: &'f [Blended<'_, '_>],
    settings: &RenderSettings,
    frame: &'f FrameUniforms,
) -> Vec<Item<'f>> {
    let mut items = Vec::with_capacity(pieces.len() + blended.len());
    for piece in pieces.iter().filter(|piece| settings.draws_surfaces() && !piece.is_blended(settings)) {
        items.extend(piece.triangles(settings, frame));
    }
    for piece in pieces.iter().filter(|piece| !piece.is_blended(settings)) {
        items.extend(piece.points(settings, frame));
    }
    for piece in pieces {
        items.extend(piece.lines(settings, frame));
    }
    if let Some(wireframe) = &settings.wireframe {
        items.extend(wireframes(pieces, wireframe, frame));
    }
    let shows_blended = settings.wireframe.is_none_or(|w| w.surface);
    items.extend(blended.iter().filter(|b| shows_blended || b.is_points).map(|b| b.item(settings, frame)));
    items
}

impl Piece<'_> {
    /// Pictures of attributes show blended surfaces as if they were opaque.
    fn is_blended(&self, settings: &RenderSettings) -> bool {
        settings.shader.shows_materials() && self.surface.coverage == Coverage::Blend
    }

    /// The mesh as the eye sees it.
    fn view(&self, frame: &FrameUniforms) -> MeshView<'_> {
        MeshView::new(self.mesh, self.instance, &frame.clip_from_world).with_colors_in(frame.color_space)
    }

    /// The surface without its colour, as the eye or a light sees it.
    pub(super) fn shape(&self, clip_from_world: &Mat4, eye: [f32; 4]) -> Shape<'_> {
        let mesh = MeshView::new(self.mesh, self.instance, clip_from_world);
        Shape::new(mesh, &self.surface, eye)
    }

    /// The triangles, if there are any.
    pub(super) fn surfaces(&self) -> Option<Primitives<'_>> {
        let triangles = self.mesh.triangles.get(self.submesh.triangles.clone()).filter(|t| !t.is_empty())?;
        Some(Primitives::Triangles(Indices::List(triangles.as_flattened())))
    }

    fn triangles<'f>(&'f self, settings: &RenderSettings, frame: &'f FrameUniforms) -> Option<Item<'f>> {
        let primitives = self.surfaces()?;
        let is_hidden = settings.wireframe.is_some_and(|w| !w.surface);
        let shader = if is_hidden {
            // Surfaces in the colour of the background hide the lines behind them.
            let color = from_linear_premultiplied(frame.color_space, settings.background);
            Box::new(Stroke { mesh: self.view(frame), color, uses_vertex_colors: false, clip_z_offset: 0.0 })
        } else {
            self.shader(settings, frame, false)
        };
        let mut item = Item::opaque(shader, primitives, self.object, self.submesh.triangles.start);
        item.cull = self.cull(settings.cull);
        if settings.shader == ShaderKind::Overdraw && !is_hidden {
            (item.depth, item.blend) = (DepthTest::OFF, Blend::Add);
        }
        Some(item)
    }

    fn points<'f>(&'f self, settings: &RenderSettings, frame: &'f FrameUniforms) -> Option<Item<'f>> {
        let points = self.mesh.points.get(self.submesh.points.clone()).filter(|p| !p.is_empty())?;
        let primitives = Primitives::Points { indices: Indices::List(points), size_px: settings.point_size_px };
        let mut item =
            Item::opaque(self.shader(settings, frame, true), primitives, self.object, self.submesh.points.start);
        if settings.shader == ShaderKind::Overdraw {
            (item.depth, item.blend) = (DepthTest::OFF, Blend::Add);
        }
        Some(item)
    }

    /// Line elements are never lit. Those that nothing gives a colour stand out before the background.
    fn lines<'f>(&'f self, settings: &RenderSettings, frame: &'f FrameUniforms) -> Option<Item<'f>> {
        let segments = self.mesh.segments.get(self.submesh.segments.clone()).filter(|s| !s.is_empty())?;
        let width_px = settings.line_width_px;
        let primitives = Primitives::Lines { indices: Indices::List(segments.as_flattened()), width_px };
        let first = self.submesh.segments.start;
        if settings.shader == ShaderKind::Overdraw {
            let mut item = Item::opaque(self.shader(settings, frame, true), primitives, self.object, first);
            (item.depth, item.blend) = (DepthTest::OFF, Blend::Add);
            return Some(item);
        }
        if !settings.shader.shows_materials() {
            return Some(Item::opaque(self.shader(settings, frame, true), primitives, self.object, first));
        }
        let alpha = if self.surface.coverage == Coverage::Blend { self.surface.opacity } else { 1.0 };
        let color =
            if self.surface.is_neutral { from_linear(frame.color_space, settings.ink()) } else { self.surface.diffuse };
        let [r, g, b] = color.map(|c| c * alpha);
        let shader = Box::new(Stroke {
            mesh: self.view(frame),
            color: [r, g, b, alpha],
            uses_vertex_colors: !self.mesh.colors.is_empty(),
            clip_z_offset: towards_eye(frame, width_px),
        });
        let mut item = Item::opaque(shader, primitives, self.object, first);
        if self.surface.coverage == Coverage::Blend {
            (item.depth, item.blend) = (DepthTest::NEARER, Blend::Over);
        }
        Some(item)
    }

    fn shader<'f>(
        &'f self,
        settings: &RenderSettings,
        frame: &'f FrameUniforms,
        is_point: bool,
    ) -> Box<dyn ErasedShader + 'f> {
        let mesh = self.view(frame);
        match (settings.shader, is_point) {
            (ShaderKind::Tinyrenderer(lesson), false) => {
                return Box::new(Tinyrenderer::new(frame, mesh, &self.surface, lesson, self.model));
            }
            (ShaderKind::Games101(shading), false) => {
                return Box::new(Games101::new(frame, mesh, &self.surface, shading));
            }
            _ => {}
        }
        let is_flat = settings.shader == ShaderKind::Flat;
        let is_lit = !is_point || self.facts.has_point_normals;
        macro_rules! shader {
            ($layout:ty) => {{
                let base = BlinnPhong::<$layout>::new(frame, mesh, &self.surface, is_flat, is_point, is_lit);
                if settings.shader.shows_materials() {
                    Box::new(base)
                } else {
                    Box::new(Overlay { base, kind: settings.shader, object: self.object })
                }
            }};
        }
        if mesh.needs_full_layout() { shader!(Full) } else { shader!(Plain) }
    }

    /// A mirroring transform turns the winding around.
    pub(super) fn cull(&self, cull: Cull) -> Cull {
        match cull {
            Cull::Back if self.facts.is_mirrored(self.instance) => Cull::Front,
            Cull::Front if self.facts.is_mirrored(self.instance) => Cull::Back,
            cull => cull,
        }
    }
}

impl Blended<'_, '_> {
    fn item<'f>(&'f self, settings: &RenderSettings, frame: &'f FrameUniforms) -> Item<'f> {
        let indices = Indices::List(&self.sorted.indices);
        let (primitives, cull) = if self.is_points {
            (Primitives::Points { indices, size_px: settings.point_size_px }, Cull::None)
        } else {
            (Primitives::Triangles(indices), self.piece.cull(settings.cull))
        };
        Item {
            shader: self.piece.shader(settings, frame, self.is_points),
            primitives,
            cull,
            depth: DepthTest::NEARER,
            blend: Blend::Over,
            object: self.piece.object,
            first_primitive: 0,
        }
    }
}

impl<'f> Item<'f> {
    fn opaque(
        shader: Box<dyn ErasedShader + 'f>,
        primitives: Primitives<'f>,
        object: u32,
        first_primitive: usize,
    ) -> Self {
        Self {
            shader,
            primitives,
            cull: Cull::None,
            depth: DepthTest::NEARER_WRITE,
            blend: Blend::Replace,
            object,
            first_primitive: u32::try_from(first_primitive).unwrap_or(u32::MAX),
        }
    }
}

/// The edges of each instance.
fn wireframes<'f>(
    pieces: &'f [Piece<'_>],
    wireframe: &Wireframe,
    frame: &'f FrameUniforms,
) -> impl Iterator<Item = Item<'f>> {
    let is_first = |i: &usize| *i == 0 || !std::ptr::eq(pieces[*i].instance, pieces[*i - 1].instance);
    let (color, width_px) = (from_linear_premultiplied(frame.color_space, wireframe.color), wireframe.width_px);
    let depth = if wireframe.hidden_lines { DepthTest::OFF } else { DepthTest::NEARER };
    (0..pieces.len()).filter(is_first).map(move |i| {
        let piece = &pieces[i];
        let indices = Indices::List(piece.facts.edges.as_flattened());
        Item {
            shader: Box::new(Stroke {
                mesh: piece.view(frame),
                color,
                uses_vertex_colors: false,
                clip_z_offset: towards_eye(frame, width_px),
            }),
            primitives: Primitives::Lines { indices, width_px },
            cull: Cull::None,
            depth,
            blend: Blend::Over,
            object: piece.object,
            first_primitive: 0,
        }
    })
}

/// How much clip z a line gains so that a surface which rises steeply beside its middle does not hide its half.
fn towards_eye(frame: &FrameUniforms, width_px: f32) -> f32 {
    /// The steepest rise, in depth over width.
    const STEEPNESS: f32 = 8.0;
    frame.clip_z_towards_eye * (frame.pixel_slope * (0.5 * width_px.max(1.0)) * STEEPNESS).clamp(1e-5, 0.02)
}
