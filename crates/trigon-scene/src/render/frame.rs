//! What all shaders of a frame share: the camera and the light.

use super::course::depth_buffer::DepthScale;
use super::course::games101::Relief;
use super::lights::{Lighting, Source};
use super::occlusion::OcclusionMap;
use super::settings::RenderSettings;
use super::shader_kind::ShaderKind;
use crate::math::{Mat4, vec3};
use crate::scene::{Camera, Projection, Scene};
use trigon::lanes;
use trigon::target::ColorSpace;

/// Camera and light.
pub(super) struct FrameUniforms {
    pub(super) clip_from_world: Mat4,
    /// The eye and 1, or the unit vector towards an infinitely distant eye and 0.
    pub(super) eye: [f32; 4],
    /// The unit vector from what is looked at to the eye.
    pub(super) against_view: [f32; 3],
    /// The world as the camera sees it: x right, y up, z towards the viewer.
    pub(super) view_from_world: lanes::Mat4,
    pub(super) lighting: Lighting,
    /// What colours are.
    pub(super) color_space: ColorSpace,
    pub(super) relief: Relief,
    /// What the colours show.
    pub(super) shader: ShaderKind,
    /// Steps of light in toon shading.
    pub(super) toon_levels: u32,
    /// How open surfaces are, if light from all around is dimmed.
    pub(super) occlusion: Option<OcclusionMap>,
    /// Clip z gained by moving towards the eye: multiplied by the share of the way.
    pub(super) clip_z_towards_eye: f32,
    /// Size of a pixel over its distance (perspective), or over the depth range (orthographic).
    pub(super) pixel_slope: f32,
    /// `dot(axis, position) + offset` is 0 at the near end of what is shown and 1 at the far end.
    pub(super) depth_axis: [f32; 4],
    /// Depths as tinyrenderer counts them.
    pub(super) depth_scale: DepthScale,
}

impl FrameUniforms {
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    pub(super) fn new(scene: &Scene, camera: &Camera, settings: &RenderSettings) -> Self {
        let size = [settings.width, settings.height];
        let aspect = f64::from(size[0].max(1)) / f64::from(size[1].max(1));
        let clip_from_world = shifted(camera.clip_from_world(aspect), settings);
        let forward = camera.forward();
        let [pixel, pixel_per_distance] = camera.pixel_size(size[1]);
        let [x, y, z] = vec3::narrow(camera.eye);
        let (eye, towards_eye, pixel_slope) = match camera.projection {
            Projection::Perspective { .. } => {
                // Clip space is homogeneous: the eye is (0, 0, z, 0), and moving towards it adds a part of that.
                let z_of_eye = f64::from(camera.clip_from_view(aspect).columns[3][2]);
                ([x, y, z, 1.0], z_of_eye, pixel_per_distance)
            }
            Projection::Orthographic { .. } => {
                let [x, y, z] = vec3::narrow(vec3::scale(forward, -1.0));
                let range = (camera.far - camera.near).max(f64::MIN_POSITIVE);
                ([x, y, z, 0.0], 1.0, pixel / range)
            }
        };
        Self {
            clip_from_world,
            eye,
            against_view: vec3::narrow(vec3::scale(forward, -1.0)),
            view_from_world: lanes::Mat4 { columns: camera.view_from_world().columns },
            lighting: Lighting::new(&scene.lights, camera),
            color_space: settings.color_space,
            relief: settings.relief,
            shader: settings.shader,
            toon_levels: settings.toon_levels.clamp(1, RenderSettings::MAX_TOON_LEVELS),
            occlusion: None,
            clip_z_towards_eye: towards_eye as f32,
            pixel_slope: pixel_slope as f32,
            depth_scale: DepthScale::new(camera),
            depth_axis: if settings.shader == ShaderKind::Depth { depth_axis(scene, camera) } else { [0.0; 4] },
        }
    }
}

impl FrameUniforms {
    /// Whether lit surfaces need more than the lights and their materials.
    pub(super) fn has_effects(&self) -> bool {
        let has_shadow = |source: &Source| source.shadow.is_some();
        self.shader == ShaderKind::Toon || self.occlusion.is_some() || self.lighting.sources.iter().any(has_shadow)
    }
}

/// The same with the picture moved by `shift_px`: a pixel is 2 / width wide in NDC, and clip space is w times that.
fn shifted(mut clip: Mat4, settings: &RenderSettings) -> Mat4 {
    let [x, y] = settings.shift_px;
    if [x, y] != [0.0; 2] {
        #[expect(clippy::cast_precision_loss, reason = "sizes are at most 16 384")]
        let [width, height] = [settings.width.max(1) as f32, settings.height.max(1) as f32];
        for column in &mut clip.columns {
            column[0] += column[3] * (2.0 * x / width);
            column[1] += column[3] * (2.0 * y / height);
        }
    }
    clip
}

/// Maps world positions to 0 at the nearest and 1 at the farthest visible vertex.
fn depth_axis(scene: &Scene, camera: &Camera) -> [f32; 4] {
    let forward = camera.forward();
    let (mut near, mut far) = (f64::INFINITY, f64::NEG_INFINITY);
    for instance in &scene.instances {
        let Some(mesh) = scene.mesh(instance.mesh) else { continue };
        for (position, _) in mesh.positions.iter().zip(mesh.used_vertices()).filter(|(_, is_used)| *is_used) {
            let [x, y, z, _] = instance.world_from_model.transform_point(vec3::widen(*position));
            let depth = vec3::dot(forward, vec3::sub([x, y, z], camera.eye));
            // Comparisons that NaN fails.
            near = if depth < near { depth } else { near };
            far = if depth > far { depth } else { far };
        }
    }
    let (near, far) = (near.max(camera.near), far.min(camera.far));
    let scale = if far > near { 1.0 / (far - near) } else { 0.0 };
    let [x, y, z] = vec3::narrow(vec3::scale(forward, scale));
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
    let offset = (-(vec3::dot(forward, camera.eye) + near) * scale) as f32;
    [x, y, z, if offset.is_finite() { offset } else { 0.0 }]
}
