//! Shadow maps: what the lights of a frame see.
//!
//! In: a light, the scene, its pieces. Out: a [`ShadowMap`]: depth pictures, and the matrices that find a point in
//! them. A directional light has one in parallel projection, a narrow spot light one in perspective, all others six, the
//! faces of a cube. They are drawn by the core like any frame, without colour, so that nothing is shaded.
//!
//! A map reaches a little beyond what it has to show, so that the filter never leaves it: no seam between the faces of a
//! cube, no shadow at the border. `shaders::shadow` reads it.

use super::draws::Piece;
use super::effects::Shadows;
use super::error::RenderError;
use super::lights::{Lighting, Source};
use super::shaders::Shape;
use crate::math::{Mat4, vec3};
use crate::scene::{Camera, Framing, Projection, Scene};
use trigon::geometry::Primitives;
use trigon::lanes;
use trigon::pipeline::{Draw, Frame, FrameStatistics, Outputs, Picture, Renderer};
use trigon::target::Plane;

/// What one light sees, ready to be compared with.
pub(super) struct ShadowMap {
    /// One, or the six of a cube: +x, -x, +y, -y, +z, -z.
    pub(super) faces: Vec<ShadowFace>,
    /// Texels along a side.
    pub(super) size: u32,
    /// In texels.
    pub(super) softness: f32,
    /// How many texels in a row the filter's square can meet.
    pub(super) taps: usize,
    /// What a surface is moved by before it is compared, towards the light: in world units, and in texels.
    pub(super) bias: f32,
    pub(super) bias_texels: f32,
    /// The same along the surface's normal, in texels: where a curved surface turns away from the light, its facets
    /// would else shade each other.
    pub(super) normal_offset_texels: f32,
    /// Width of a texel in world units at clip w = 1: it grows with w.
    pub(super) texel: f32,
    /// NDC depth lost over the width of a texel at clip w = 1: it shrinks with w.
    pub(super) depth_of_texel: f32,
}

/// One depth picture.
pub(super) struct ShadowFace {
    pub(super) clip_from_world: lanes::Mat4,
    /// NDC depth, row by row: 1 near the light, 0 far or nothing.
    pub(super) depth: Plane<f32>,
}

/// Memory of the maps, kept from frame to frame.
#[derive(Default)]
pub(super) struct ShadowMemory {
    planes: Vec<Plane<f32>>,
}

/// Half-angles up to this are seen by a single map: beyond, its middle would be too coarse.
const WIDEST_CONE: f64 = 1.1;
/// What [`Shadows::bias`] of `None` stands for.
const FITTED_BIAS_TEXELS: f32 = 1.0;
const FITTED_NORMAL_OFFSET_TEXELS: f32 = 1.5;

impl ShadowMemory {
    /// Draws the map of every source of `lighting` that casts shadows, and gives it to it. Returns the times that this took.
    pub(super) fn draw(
        &mut self,
        renderer: &mut Renderer,
        scene: &Scene,
        pieces: &[Piece<'_>],
        settings: &Shadows,
        lighting: &mut Lighting,
    ) -> Result<FrameStatistics, RenderError> {
        let mut times = FrameStatistics::default();
        let bounds = scene.bounding_box();
        for source in lighting.sources.iter_mut().filter(|source| source.casts_shadows) {
            let views = views(source, scene, &bounds, settings);
            let mut map = ShadowMap::new(&views[0], settings);
            for view in &views {
                let clip_from_world = view.clip_from_world(1.0);
                let depth = self.draw_face(renderer, pieces, &clip_from_world, settings.map_size, &mut times)?;
                let clip_from_world = lanes::Mat4 { columns: clip_from_world.columns };
                map.faces.push(ShadowFace { clip_from_world, depth });
            }
            source.shadow = Some(map);
        }
        Ok(times)
    }

    /// Takes the maps back, for their memory.
    pub(super) fn take_back(&mut self, lighting: Lighting) {
        let maps = lighting.sources.into_iter().filter_map(|source| source.shadow);
        self.planes.extend(maps.flat_map(|map| map.faces).map(|face| face.depth));
    }

    fn draw_face(
        &mut self,
        renderer: &mut Renderer,
        pieces: &[Piece<'_>],
        clip_from_world: &Mat4,
        size: u32,
        times: &mut FrameStatistics,
    ) -> Result<Plane<f32>, RenderError> {
        let casters: Vec<(Shape<'_>, Primitives<'_>)> = pieces
            .iter()
            .filter_map(|piece| Some((piece.shape(clip_from_world, [0.0; 4]), piece.surfaces()?)))
            .collect();
        let draws: Vec<Draw<'_>> = casters.iter().map(|(shader, primitives)| Draw::new(shader, *primitives)).collect();
        let frame = Frame { outputs: Outputs::DEPTH, ..Frame::new(size, size) };
        let mut picture = Picture { depth: self.planes.pop(), ..Picture::default() };
        let statistics = renderer.render(&frame, &draws, &mut picture).map_err(|error| match error {
            trigon::pipeline::FrameError::Size { .. } => RenderError::ShadowMapSize(size),
            error => RenderError::Frame(error),
        })?;
        times.geometry_time += statistics.geometry_time;
        times.tile_time += statistics.tile_time;
        picture.depth.ok_or(RenderError::ShadowMapSize(size))
    }
}

impl ShadowMap {
    /// A map without faces yet; all look like `view`, but for their direction.
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    fn new(view: &Camera, settings: &Shadows) -> Self {
        let side = f64::from(settings.map_size.max(1));
        let range = view.far - view.near;
        let (texel, depth_of_texel) = match view.projection {
            Projection::Orthographic { height } => (height / side, height / side / range),
            Projection::Perspective { fov_y } => {
                // Depth at distance d is near far / (far - near) / d and a constant: the slope of that over w squared.
                let texel = 2.0 * libm::tan(fov_y * 0.5) / side;
                (texel, texel * view.near * (view.far / range))
            }
        };
        let softness = radius(settings);
        let is_fitted = settings.bias.is_none();
        Self {
            faces: Vec::new(),
            size: settings.map_size,
            softness,
            taps: (2.0 * softness).ceil() as usize + 1,
            bias: settings.bias.unwrap_or(0.0),
            bias_texels: if is_fitted { FITTED_BIAS_TEXELS } else { 0.0 },
            normal_offset_texels: if is_fitted { FITTED_NORMAL_OFFSET_TEXELS } else { 0.0 },
            texel: texel as f32,
            depth_of_texel: depth_of_texel as f32,
        }
    }
}

/// Softness within its range; NaN is hard. So is a radius that would be lost when it is added to a place on the map.
fn radius(settings: &Shadows) -> f32 {
    const LEAST: f32 = 1.0 / 16.0;
    if settings.softness >= LEAST { settings.softness.min(Shadows::MAX_SOFTNESS) } else { 0.0 }
}

/// The cameras that see what the light reaches.
fn views(source: &Source, scene: &Scene, bounds: &crate::math::Aabb, settings: &Shadows) -> Vec<Camera> {
    // How far the filter reaches beyond a point, and the offset of that point, as a part of the map.
    let border = (f64::from(radius(settings)) + 3.0) / f64::from(settings.map_size.max(1));
    let place = vec3::widen(source.place);
    if source.is_directional {
        let projection = Projection::Orthographic { height: 1.0 };
        let framing = Framing { margin: border.min(0.4), projection, ..Framing::default() };
        return vec![framing.camera_along(scene, vec3::scale(place, -1.0), up_across(place))];
    }
    let looking = |direction: vec3::Vec3, tan: f64| {
        let projection = Projection::Perspective { fov_y: 2.0 * libm::atan(tan * (1.0 + 2.0 * border)) };
        let target = vec3::add(place, direction);
        let far = farthest_corner(place, bounds);
        Camera { eye: place, target, up: up_across(direction), projection, near: far * 1e-4, far }
    };
    match &source.cone {
        Some(cone) if cone.outer_angle <= WIDEST_CONE => {
            vec![looking(vec3::widen(cone.axis), libm::tan(cone.outer_angle.max(1e-3)))]
        }
        _ => [[1., 0., 0.], [-1., 0., 0.], [0., 1., 0.], [0., -1., 0.], [0., 0., 1.], [0., 0., -1.]]
            .map(|direction| looking(direction, 1.0))
            .into(),
    }
}

/// A direction that is not parallel to `direction`.
fn up_across([x, y, z]: vec3::Vec3) -> vec3::Vec3 {
    if y.abs() > x.abs().max(z.abs()) { [0.0, 0.0, -1.0] } else { [0.0, 1.0, 0.0] }
}

/// A little more than the distance to the farthest point of the box; 1 for an empty one.
fn farthest_corner(place: vec3::Vec3, bounds: &crate::math::Aabb) -> f64 {
    if bounds.is_empty() {
        return 1.0;
    }
    let reach: vec3::Vec3 = std::array::from_fn(|i| {
        (place[i] - f64::from(bounds.min[i])).abs().max((f64::from(bounds.max[i]) - place[i]).abs())
    });
    vec3::length(reach).max(f64::from(f32::MIN_POSITIVE) * 1e8) * 1.001
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Light, LightKind};

    fn views_of(kind: LightKind) -> Vec<Camera> {
        let camera = Framing::default().camera(&Scene::default());
        let lighting = Lighting::new(&[Light::new(kind, 1.0)], &camera);
        let bounds = crate::math::Aabb { min: [-1.0; 3], max: [1.0, 2.0, 3.0] };
        views(&lighting.sources[0], &Scene::default(), &bounds, &Shadows::default())
    }

    /// NDC of a world point, and its clip w.
    fn project(camera: &Camera, point: vec3::Vec3) -> ([f64; 3], f64) {
        let [x, y, z, w] = camera.clip_from_world(1.0).transform_point(point);
        ([x / w, y / w, z / w], w)
    }

    #[test]
    fn a_cube_sees_every_direction() {
        let position = [0.3, -0.2, 5.0];
        let faces = views_of(LightKind::Point { position });
        assert_eq!(faces.len(), 6);
        for point in [[-1.0, -1.0, -1.0], [1.0, 2.0, 3.0], [0.3, 2.0, 5.0], [1.0, -0.2, 4.3], [9.0, -0.2, 5.0]] {
            let is_inside = |face: &&Camera| {
                let ([x, y, _], w) = project(face, point);
                w > 0.0 && x.abs() <= 1.0 && y.abs() <= 1.0
            };
            assert!((1..=3).contains(&faces.iter().filter(is_inside).count()), "{point:?}");
        }
    }

    #[test]
    fn narrow_cones_have_one_map_and_wide_ones_a_cube() {
        let spot = |outer_angle| LightKind::Spot {
            position: [0.0, 4.0, 0.0],
            direction: [0.0, -1.0, 0.0],
            inner_angle: 0.1,
            outer_angle,
        };
        assert_eq!(views_of(spot(0.5)).len(), 1);
        assert_eq!(views_of(spot(1.5)).len(), 6);
        let ([x, y, _], _) = project(&views_of(spot(0.5))[0], [4.0 * libm::tan(0.5), 0.0, 0.0]);
        assert!(x.abs().max(y.abs()) < 1.0, "the edge of the cone is on the map");
    }

    #[test]
    fn parallel_light_sees_the_scene_whole_and_degenerate_light_something() {
        for direction in [[0.0, -1.0, 0.0], [1.0, -2.0, 0.5], [0.0; 3]] {
            let view = views_of(LightKind::Directional { direction })[0];
            let ([x, y, z], _) = project(&view, [0.5, 0.5, -0.5]);
            assert!(x.abs() < 1.0 && y.abs() < 1.0 && (0.0..=1.0).contains(&z), "{direction:?}");
        }
        let inside = views_of(LightKind::Point { position: [0.0; 3] });
        assert!(inside.iter().all(|view| view.near > 0.0 && view.far > view.near));
    }
}
