//! One frame of a scene: a scene, a frame number and a renderer in, a picture out.

use crate::scene::{BenchScene, Orbit, Surface};
use crate::shading::{Lighting, Lit, Placement, Textured, TexturedLit};
use trigon::geometry::{Indices, Primitives};
use trigon::lanes::Mat4;
use trigon::pipeline::{Draw, Frame, FrameError, FrameStatistics, Picture, Renderer};
use trigon::shade::ErasedShader;
use trigon::target::SamplePattern;

/// Linear colour of the background.
const BACKGROUND: [f32; 4] = [0.02, 0.02, 0.03, 1.0];

/// The frame of a benchmark: `samples` at the standard positions, shaded per pixel; 8-bit colour. `None` if there is no
/// such pattern.
#[must_use]
pub fn frame(size: [u32; 2], samples: u32) -> Option<Frame> {
    let mut frame = Frame::new(size[0], size[1]);
    frame.samples = SamplePattern::standard(samples)?;
    frame.clear = BACKGROUND;
    Some(frame)
}

/// Draws frame number `number` of the scene's orbit.
///
/// # Errors
/// The frame is too large.
pub fn draw(
    renderer: &mut Renderer,
    scene: &BenchScene,
    frame: &Frame,
    number: u32,
    picture: &mut Picture,
) -> Result<FrameStatistics, FrameError> {
    let view = scene.orbit.view(number, [frame.width, frame.height]);
    let clip_from_world = Mat4 { columns: view.clip_from_world.columns };
    let placement = Placement { mesh: &scene.mesh, clip_from_world };
    let lighting = lighting(scene.orbit, view.eye);
    let shader = |texture: usize| -> Box<dyn ErasedShader + '_> {
        match scene.surface {
            Surface::TexturedLit => Box::new(TexturedLit { placement, lighting, texture: &scene.textures[texture] }),
            Surface::Lit => Box::new(Lit { placement, lighting }),
            Surface::Textured => Box::new(Textured { placement, texture: &scene.textures[texture] }),
        }
    };
    let shaders: Vec<_> = scene.runs.iter().map(|run| shader(run.texture)).collect();
    let primitives = |run: usize| {
        let triangles = &scene.mesh.triangles[scene.runs[run].triangles.clone()];
        Primitives::Triangles(Indices::List(triangles.as_flattened()))
    };
    let draws: Vec<_> = shaders.iter().enumerate().map(|(run, s)| Draw::new(s.as_ref(), primitives(run))).collect();
    renderer.render(frame, &draws, picture)
}

/// The lights of a scene: the hall's lamp hangs under its ceiling.
fn lighting(orbit: Orbit, eye: [f32; 3]) -> Lighting {
    let (point, point_color, falloff) = match orbit {
        Orbit::Walk => ([0.0, 5.0, 0.0], [4.0, 3.6, 3.2], 0.05),
        _ => ([2.0, 2.5, 2.0], [2.0, 1.8, 1.6], 0.25),
    };
    let towards_sun = [-0.4f32, 0.7, 0.6];
    let length = towards_sun.iter().map(|c| c * c).sum::<f32>().sqrt();
    Lighting { eye, point, point_color, falloff, sun: towards_sun.map(|c| c / length), sun_color: [0.35, 0.40, 0.50] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::picture_hash;
    use crate::scene::{ModelFiles, SceneKind};
    use trigon::lanes::SimdLevel;
    use trigon::pipeline::RendererOptions;
    use trigon::schedule::TileOrder;

    fn hash(kind: SceneKind, samples: u32, threads: usize, simd: SimdLevel) -> u64 {
        let size = [160, 100];
        let scene = kind.build(size, &ModelFiles::default()).unwrap();
        let options = RendererOptions { threads, simd, tile_order: TileOrder::MostWorkFirst };
        let mut picture = Picture::default();
        let mut renderer = Renderer::new(options).unwrap();
        draw(&mut renderer, &scene, &frame(size, samples).unwrap(), 3, &mut picture).unwrap();
        picture_hash(&picture)
    }

    #[test]
    fn pictures_do_not_depend_on_simd_level_or_threads() {
        for kind in SceneKind::ALL.into_iter().filter(|kind| !kind.needs_model()) {
            for samples in [1, 4] {
                let expected = hash(kind, samples, 1, SimdLevel::Scalar);
                for simd in SimdLevel::ALL.into_iter().filter(|level| level.is_available()) {
                    assert_eq!(hash(kind, samples, 2, simd), expected, "{kind:?} {samples} {simd}");
                }
            }
        }
    }
}
