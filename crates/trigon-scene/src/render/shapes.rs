//! What the eye sees, as shapes without colour: the picture that occlusion and outlines are made from.
//!
//! In: the pieces of a frame and its view. Out: position, normal and object of the surface in the middle of each pixel.
//! Drawn by the core like any frame, without colour. Blended surfaces count where they are at least half opaque; lines
//! and points are left out.

use super::draws::Piece;
use super::error::RenderError;
use super::frame::FrameUniforms;
use super::settings::RenderSettings;
use super::shaders::Shape;
use crate::math::vec3;
use crate::scene::Camera;
use trigon::lanes::{F32, Kernel, LANES, Lanes, U32};
use trigon::pipeline::{Draw, Frame, FrameStatistics, Outputs, Picture, Renderer, RendererOptions};
use trigon::schedule::share;

/// The visible surfaces of a picture, row by row.
#[derive(Clone)]
pub(super) struct Shapes {
    pub(super) width: u32,
    pub(super) height: u32,
    /// In world space; [`NOWHERE`] where there is nothing.
    pub(super) positions: Vec<[f32; 3]>,
    /// In world space, towards the eye; zero where there is nothing.
    pub(super) normals: Vec<[f32; 3]>,
    /// Numbers of parts; `u32::MAX` where there is nothing.
    pub(super) objects: Vec<u32>,
    /// `dot(axis, position) + offset` is the distance along the view.
    pub(super) view_axis: [f32; 4],
    /// The size of a pixel in world units at distance d is `pixel[0] + pixel[1] * d`.
    pub(super) pixel: [f32; 2],
}

/// A coordinate farther away than any surface.
pub(super) const NOWHERE: f32 = 1e18;

/// Rows that a thread takes at a time.
const BAND: usize = 16;

impl Shapes {
    /// Draws what `camera` sees of `pieces`, one sample in the middle of each pixel, without what the settings leave out.
    pub(super) fn draw(
        renderer: &mut Renderer,
        pieces: &[Piece<'_>],
        camera: &Camera,
        frame: &FrameUniforms,
        settings: &RenderSettings,
        [width, height]: [u32; 2],
    ) -> Result<(Self, FrameStatistics), RenderError> {
        let shapes: Vec<Shape<'_>> =
            pieces.iter().map(|piece| piece.shape(&frame.clip_from_world, frame.eye)).collect();
        let draw = |(piece, shape)| -> Option<Draw<'_>> {
            let (piece, shape): (&Piece<'_>, &Shape<'_>) = (piece, shape);
            let cull = piece.cull(settings.cull);
            Some(Draw { object: piece.object, cull, ..Draw::new(shape, piece.surfaces()?) })
        };
        let shown = if settings.draws_surfaces() { pieces } else { &[] };
        let draws: Vec<Draw<'_>> = shown.iter().zip(&shapes).filter_map(draw).collect();
        let outputs = Outputs { position: true, normal: true, object: true, ..Outputs::NONE };
        let mut picture = Picture::default();
        let statistics = renderer.render(&Frame { outputs, ..Frame::new(width, height) }, &draws, &mut picture)?;
        let mut shapes = Self {
            width,
            height,
            positions: picture.position.map_or_else(Vec::new, trigon::target::Plane::into_values),
            normals: picture.normal.map_or_else(Vec::new, trigon::target::Plane::into_values),
            objects: picture.object.map_or_else(Vec::new, trigon::target::Plane::into_values),
            view_axis: view_axis(camera),
            pixel: camera.pixel_size(height).map(narrow),
        };
        for (position, object) in shapes.positions.iter_mut().zip(&shapes.objects) {
            if *object == u32::MAX {
                *position = [NOWHERE; 3];
            }
        }
        Ok((shapes, statistics))
    }

    /// The distance of each pixel's surface along the view.
    pub(super) fn distances(&self) -> Vec<f32> {
        self.along(self.view_axis, NOWHERE)
    }

    /// `dot(axis, position) + offset` of each pixel's surface, `nothing` where there is none.
    pub(super) fn along(&self, [x, y, z, offset]: [f32; 4], nothing: f32) -> Vec<f32> {
        let place = |p: &[f32; 3]| if p[0] == NOWHERE { nothing } else { ((p[0] * x + p[1] * y) + p[2] * z) + offset };
        self.positions.iter().map(place).collect()
    }

    /// Indices of sixteen pixels; those outside of the picture are the nearest ones in it.
    #[inline(always)]
    pub(super) fn index<L: Lanes>(&self, l: L, x: F32<L>, y: F32<L>) -> U32<L> {
        let column = x.to_i32_within(0.0, (self.width - 1) as f32).as_u32();
        let row = y.to_i32_within(0.0, (self.height - 1) as f32).as_u32();
        row * l.u32(self.width) + column
    }
}

/// Shares the rows of an image among threads: `work` gets the number of the first row, and some rows.
pub(super) fn each_band<T: Send>(
    options: RendererOptions,
    width: u32,
    values: &mut [T],
    work: impl Fn(usize, &mut [T]) + Sync,
) {
    let mut workers = vec![(); options.threads.max(1)];
    let bands = values.chunks_mut(width as usize * BAND).enumerate();
    share(&mut workers, bands, |(), (band, rows)| work(band * BAND, rows));
}

/// A number for each pixel of an image, sixteen at a time.
pub(super) trait PerPixel {
    /// The numbers of the pixels in columns `x` and rows `y`.
    fn at<L: Lanes>(&self, l: L, x: F32<L>, y: F32<L>) -> F32<L>;
}

/// Fills some rows of an image.
pub(super) struct EachPixel<'a, F> {
    pub(super) of: F,
    /// Pixels in a row.
    pub(super) width: u32,
    /// The first row.
    pub(super) y: usize,
    pub(super) rows: &'a mut [f32],
}

impl<F: PerPixel> Kernel for EachPixel<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self, l: L) {
        for (row, values) in self.rows.chunks_mut(self.width as usize).enumerate() {
            let y = l.f32((self.y + row) as f32);
            for (group, out) in values.chunks_mut(LANES).enumerate() {
                let x = l.lane_numbers() + (group * LANES) as f32;
                out.copy_from_slice(&self.of.at(l, x, y).to_array()[..out.len()]);
            }
        }
    }
}

/// Distance along the view as a function of position.
fn view_axis(camera: &Camera) -> [f32; 4] {
    let forward = camera.forward();
    let [x, y, z] = vec3::narrow(forward);
    [x, y, z, narrow(-vec3::dot(forward, camera.eye))]
}

#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
pub(super) fn narrow(v: f64) -> f32 {
    v as f32
}
