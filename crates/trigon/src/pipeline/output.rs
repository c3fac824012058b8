//! Images of a frame, and how finished tiles get into them.
//!
//! In: a tile's pixels. Out: rows of the caller's images. The images are split into bands of 64 rows, each behind a
//! lock that a tile holds only while it copies its own rows; no two tiles share a pixel.

use super::draw::{Frame, Outputs};
use crate::target::{Plane, TILE_SIZE};
use std::sync::{Mutex, PoisonError};

/// The images of a frame: those that [`Outputs`] asked for. Reused from frame to frame where sizes agree.
#[derive(Default, Debug)]
pub struct Picture {
    /// 8-bit sRGB, straight alpha.
    pub color: Option<Plane<[u8; 4]>>,
    /// Linear, premultiplied.
    pub color_f32: Option<Plane<[f32; 4]>>,
    /// NDC depth, 1 near, 0 far or nothing.
    pub depth: Option<Plane<f32>>,
    /// Primitive numbers.
    pub primitive: Option<Plane<u32>>,
    /// Object numbers.
    pub object: Option<Plane<u32>>,
    /// World-space normals.
    pub normal: Option<Plane<[f32; 3]>>,
    /// World-space positions.
    pub position: Option<Plane<[f32; 3]>>,
    /// Texture coordinates.
    pub uv: Option<Plane<[f32; 2]>>,
}

impl Picture {
    /// Makes the images that the frame asks for and drops the others.
    pub(crate) fn prepare(&mut self, frame: &Frame) {
        let planes = if frame.outputs.per_sample { frame.samples.count() } else { 1 };
        let o = frame.outputs;
        prepare(&mut self.color, o.color, frame, 1, [0; 4]);
        prepare(&mut self.color_f32, o.color_f32, frame, 1, [0.0; 4]);
        prepare(&mut self.depth, o.depth, frame, planes, 0.0);
        prepare(&mut self.primitive, o.primitive, frame, planes, 0);
        prepare(&mut self.object, o.object, frame, planes, 0);
        prepare(&mut self.normal, o.normal, frame, planes, [0.0; 3]);
        prepare(&mut self.position, o.position, frame, planes, [0.0; 3]);
        prepare(&mut self.uv, o.uv, frame, planes, [0.0; 2]);
    }
}

fn prepare<T: Copy>(plane: &mut Option<Plane<T>>, wanted: bool, frame: &Frame, planes: usize, zero: T) {
    let values = frame.width as usize * frame.height as usize * planes;
    let fits = |p: &Plane<T>| p.width() == frame.width && p.values().len() == values;
    if !wanted {
        *plane = None;
    } else if !plane.as_ref().is_some_and(fits) {
        *plane = Some(Plane::new(frame.width, frame.height, planes, zero));
    }
}

/// Pixels of one tile in one image, `[plane][y][x]`.
pub(crate) struct TilePlane<T> {
    pub(crate) values: Vec<T>,
}

impl<T: Copy> TilePlane<T> {
    fn new(wanted: bool, planes: usize, zero: T) -> Self {
        let size = if wanted { TILE_SIZE * TILE_SIZE * planes } else { 0 };
        Self { values: vec![zero; size] }
    }

    /// Sets the pixel at (`x`, `y`) of the tile.
    #[inline(always)]
    pub(crate) fn set(&mut self, plane: usize, x: usize, y: usize, value: T) {
        let at = (plane * TILE_SIZE + y) * TILE_SIZE + x;
        if let Some(pixel) = self.values.get_mut(at) {
            *pixel = value;
        }
    }
}

/// Pixels of one tile in every image of the frame; empty where an image is not wanted.
pub(crate) struct TileImages {
    pub(crate) color: TilePlane<[u8; 4]>,
    pub(crate) color_f32: TilePlane<[f32; 4]>,
    pub(crate) depth: TilePlane<f32>,
    pub(crate) primitive: TilePlane<u32>,
    pub(crate) object: TilePlane<u32>,
    pub(crate) normal: TilePlane<[f32; 3]>,
    pub(crate) position: TilePlane<[f32; 3]>,
    pub(crate) uv: TilePlane<[f32; 2]>,
}

impl TileImages {
    pub(crate) fn new(outputs: Outputs, samples: usize) -> Self {
        let planes = if outputs.per_sample { samples } else { 1 };
        Self {
            color: TilePlane::new(outputs.color, 1, [0; 4]),
            color_f32: TilePlane::new(outputs.color_f32, 1, [0.0; 4]),
            depth: TilePlane::new(outputs.depth, planes, 0.0),
            primitive: TilePlane::new(outputs.primitive, planes, 0),
            object: TilePlane::new(outputs.object, planes, 0),
            normal: TilePlane::new(outputs.normal, planes, [0.0; 3]),
            position: TilePlane::new(outputs.position, planes, [0.0; 3]),
            uv: TilePlane::new(outputs.uv, planes, [0.0; 2]),
        }
    }
}

/// An image as rows of tiles, each behind its lock.
struct Bands<'a, T> {
    /// `[plane][band]`.
    bands: Vec<Mutex<&'a mut [T]>>,
    per_plane: usize,
    width: usize,
}

impl<'a, T: Copy> Bands<'a, T> {
    fn new(plane: Option<&'a mut Plane<T>>) -> Option<Self> {
        let plane = plane?;
        let (width, height) = (plane.width() as usize, plane.height() as usize);
        let picture = width * height;
        let bands = plane
            .values_mut()
            .chunks_mut(picture)
            .flat_map(|rows| rows.chunks_mut(width * TILE_SIZE))
            .map(Mutex::new)
            .collect();
        Some(Self { bands, per_plane: height.div_ceil(TILE_SIZE), width })
    }

    /// Copies a tile's pixels to where they belong.
    fn store(&self, column: usize, row: usize, tile: &TilePlane<T>) {
        let x = column * TILE_SIZE;
        let columns = (self.width - x).min(TILE_SIZE);
        for (plane, pixels) in tile.values.chunks(TILE_SIZE * TILE_SIZE).enumerate() {
            let band = &self.bands[plane * self.per_plane + row];
            let mut rows = band.lock().unwrap_or_else(PoisonError::into_inner);
            for (to, from) in rows.chunks_mut(self.width).zip(pixels.chunks(TILE_SIZE)) {
                to[x..x + columns].copy_from_slice(&from[..columns]);
            }
        }
    }
}

/// Every image of a frame, ready to receive tiles from any thread.
pub(crate) struct PictureBands<'a> {
    color: Option<Bands<'a, [u8; 4]>>,
    color_f32: Option<Bands<'a, [f32; 4]>>,
    depth: Option<Bands<'a, f32>>,
    primitive: Option<Bands<'a, u32>>,
    object: Option<Bands<'a, u32>>,
    normal: Option<Bands<'a, [f32; 3]>>,
    position: Option<Bands<'a, [f32; 3]>>,
    uv: Option<Bands<'a, [f32; 2]>>,
}

impl<'a> PictureBands<'a> {
    pub(crate) fn new(picture: &'a mut Picture) -> Self {
        Self {
            color: Bands::new(picture.color.as_mut()),
            color_f32: Bands::new(picture.color_f32.as_mut()),
            depth: Bands::new(picture.depth.as_mut()),
            primitive: Bands::new(picture.primitive.as_mut()),
            object: Bands::new(picture.object.as_mut()),
            normal: Bands::new(picture.normal.as_mut()),
            position: Bands::new(picture.position.as_mut()),
            uv: Bands::new(picture.uv.as_mut()),
        }
    }

    /// Copies the tile at (`column`, `row`) into every image.
    pub(crate) fn store(&self, column: usize, row: usize, tile: &TileImages) {
        store(self.color.as_ref(), column, row, &tile.color);
        store(self.color_f32.as_ref(), column, row, &tile.color_f32);
        store(self.depth.as_ref(), column, row, &tile.depth);
        store(self.primitive.as_ref(), column, row, &tile.primitive);
        store(self.object.as_ref(), column, row, &tile.object);
        store(self.normal.as_ref(), column, row, &tile.normal);
        store(self.position.as_ref(), column, row, &tile.position);
        store(self.uv.as_ref(), column, row, &tile.uv);
    }
}

fn store<T: Copy>(bands: Option<&Bands<'_, T>>, column: usize, row: usize, tile: &TilePlane<T>) {
    if let Some(bands) = bands {
        bands.store(column, row, tile);
    }
}
