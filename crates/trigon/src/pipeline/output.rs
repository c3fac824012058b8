//! Images of a frame, and how tiles get into them.
//!
//! In: a tile's pixels, which one thread has gathered in memory of its own. Out: pieces of rows of the caller's images.
//! No two tiles share a pixel, so the pieces are handed out as `&mut` and threads need no lock.

use super::draw::{Frame, Outputs};
use crate::lanes::{Plain, finish_lines, store_lines};
use crate::target::{Plane, TILE_SIZE};

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
pub(crate) struct TilePixels {
    pub(crate) color: TilePlane<[u8; 4]>,
    pub(crate) color_f32: TilePlane<[f32; 4]>,
    pub(crate) depth: TilePlane<f32>,
    pub(crate) primitive: TilePlane<u32>,
    pub(crate) object: TilePlane<u32>,
    pub(crate) normal: TilePlane<[f32; 3]>,
    pub(crate) position: TilePlane<[f32; 3]>,
    pub(crate) uv: TilePlane<[f32; 2]>,
}

impl TilePixels {
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

/// One tile's part of an image: its pieces of rows, plane after plane. None where the image is not wanted.
struct TileRows<'a, T>(Vec<&'a mut [T]>);

impl<T: Plain> TileRows<'_, T> {
    /// Copies a tile's pixels to where they belong. `height` is the number of rows that the picture has of it.
    fn store(mut self, height: usize, tile: &TilePlane<T>) {
        let planes = self.0.chunks_mut(height).zip(tile.values.chunks(TILE_SIZE * TILE_SIZE));
        for (to, from) in planes.flat_map(|(to, from)| to.iter_mut().zip(from.chunks(TILE_SIZE))) {
            store_lines(to, from);
        }
    }
}

/// One tile's part of every image of the frame.
pub(crate) struct TileOfPicture<'a> {
    color: TileRows<'a, [u8; 4]>,
    color_f32: TileRows<'a, [f32; 4]>,
    depth: TileRows<'a, f32>,
    primitive: TileRows<'a, u32>,
    object: TileRows<'a, u32>,
    normal: TileRows<'a, [f32; 3]>,
    position: TileRows<'a, [f32; 3]>,
    uv: TileRows<'a, [f32; 2]>,
    height: usize,
}

impl<'a> TileOfPicture<'a> {
    /// The parts of every tile, row of tiles by row of tiles.
    pub(crate) fn of_picture(picture: &'a mut Picture, frame: &Frame) -> impl Iterator<Item = Self> {
        let size = [frame.width as usize, frame.height as usize];
        let [columns, bands] = size.map(|side| side.div_ceil(TILE_SIZE));
        let Picture { color, color_f32, depth, primitive, object, normal, position, uv } = picture;
        let mut colors = tile_rows(color.as_mut(), size).zip(tile_rows(color_f32.as_mut(), size));
        let mut ids = tile_rows(primitive.as_mut(), size).zip(tile_rows(object.as_mut(), size));
        let mut depths = tile_rows(depth.as_mut(), size).zip(tile_rows(uv.as_mut(), size));
        let mut vectors = tile_rows(normal.as_mut(), size).zip(tile_rows(position.as_mut(), size));
        (0..bands * columns).map_while(move |tile| {
            let height = (size[1] - tile / columns * TILE_SIZE).min(TILE_SIZE);
            let ((color, color_f32), (primitive, object)) = (colors.next()?, ids.next()?);
            let ((depth, uv), (normal, position)) = (depths.next()?, vectors.next()?);
            Some(Self { color, color_f32, depth, primitive, object, normal, position, uv, height })
        })
    }

    /// Copies the tile into every image.
    pub(crate) fn store(self, tile: &TilePixels) {
        let height = self.height;
        self.color.store(height, &tile.color);
        self.color_f32.store(height, &tile.color_f32);
        self.depth.store(height, &tile.depth);
        self.primitive.store(height, &tile.primitive);
        self.object.store(height, &tile.object);
        self.normal.store(height, &tile.normal);
        self.position.store(height, &tile.position);
        self.uv.store(height, &tile.uv);
        finish_lines();
    }
}

/// Every tile's rows of an image, row of tiles by row of tiles.
fn tile_rows<T: Copy>(
    image: Option<&mut Plane<T>>,
    [width, height]: [usize; 2],
) -> std::vec::IntoIter<TileRows<'_, T>> {
    let [columns, bands] = [width, height].map(|side| side.div_ceil(TILE_SIZE));
    let Some(image) = image else {
        let none: Vec<_> = (0..bands * columns).map(|_| TileRows(Vec::new())).collect();
        return none.into_iter();
    };
    let planes = image.values().len() / (width * height);
    let mut tiles: Vec<TileRows<'_, T>> =
        (0..bands * columns).map(|_| TileRows(Vec::with_capacity(planes * TILE_SIZE))).collect();
    for (y, row) in image.values_mut().chunks_mut(width).enumerate() {
        let first = y % height / TILE_SIZE * columns;
        for (tile, piece) in tiles[first..].iter_mut().zip(row.chunks_mut(TILE_SIZE)) {
            tile.0.push(piece);
        }
    }
    tiles.into_iter()
}
