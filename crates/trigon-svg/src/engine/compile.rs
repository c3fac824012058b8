//! From display list to steps: layers that need no surface become plain steps, paints become shaders.
//!
//! In: the items of a drawing and the map from its pixels to those drawn. Out: a [`Program`] and its [`Tables`].

use super::color::{premultiplied, unit};
use super::coverage::Bounds;
use super::draw::picture_of;
use super::geometry::{Geometry, Outlined};
use super::program::{Clip, MaskProgram, Program, Step, Tables};
use super::samples::SampleRows;
use super::shader::{Gradient, ImageShader, Shader, Tile};
use super::stroke::Hairline;
use crate::canvas::{
    BlendMode, ClipPath, Filter, Item, Layer, LayerImage, Mask, Outline, Paint, Pattern, Renderer, Shape, Transform,
};
use std::sync::Arc;

/// What clip shapes take their rule from.
static NON_ZERO: Outline = Outline::Fill(crate::canvas::FillRule::NonZero);

/// Collects what steps refer to.
pub(crate) struct Compiler<'a> {
    renderer: &'a Renderer,
    /// Samples in a pixel.
    samples: usize,
    /// Pixels drawn, from pixels of the drawing.
    base: Transform,
    depth: u32,
    shapes: Vec<Outlined<'a>>,
    shaders: Vec<Shader>,
    images: Vec<Arc<LayerImage>>,
    clips: Vec<Clip>,
    masks: Vec<MaskProgram>,
}

/// Makes a program of `items` for a picture of `size` pixels.
pub(crate) fn compile(
    renderer: &Renderer,
    samples: &SampleRows,
    items: &[Item],
    base: Transform,
    size: [u32; 2],
    depth: u32,
) -> (Program, Tables) {
    let mut compiler = Compiler {
        renderer,
        samples: samples.count(),
        base,
        depth,
        shapes: Vec::new(),
        shaders: Vec::new(),
        images: Vec::new(),
        clips: Vec::new(),
        masks: Vec::new(),
    };
    let mut steps = Vec::new();
    compiler.items(items, &mut steps);
    let geometry = Geometry::new(&compiler.shapes, samples, size, renderer);
    let Compiler { shaders, images, clips, masks, .. } = compiler;
    let mut tables = Tables { geometry, shaders, images, clips, masks };
    let mut program = Program::new(steps);
    tables.lay_out(&mut program, Bounds { columns: [0, size[0]], rows: [0, size[1]] });
    (program, tables)
}

/// The number of items up to the end of the layer that begins before `items`, without its end.
fn layer_len(items: &[Item]) -> usize {
    let mut depth = 0u32;
    for (index, item) in items.iter().enumerate() {
        match item {
            Item::Push(_) => depth += 1,
            Item::Pop if depth == 0 => return index,
            Item::Pop => depth -= 1,
            Item::Shape(_) | Item::Pixels { .. } => {}
        }
    }
    items.len()
}

/// True if anything in `items` looks at what is below it.
fn blends(items: &[Item]) -> bool {
    items.iter().any(|item| match item {
        Item::Shape(shape) => shape.blend != BlendMode::Normal,
        Item::Pixels { blend, .. } => *blend != BlendMode::Normal,
        Item::Push(layer) => layer.blend != BlendMode::Normal,
        Item::Pop => false,
    })
}

/// 0..=1 to 0..=255.
fn to_byte(opacity: f32) -> u32 {
    (unit(opacity) * 255.0 + 0.5) as u32
}

impl<'a> Compiler<'a> {
    fn items(&mut self, items: &'a [Item], steps: &mut Vec<Step>) {
        let mut index = 0;
        while index < items.len() {
            match &items[index] {
                Item::Shape(shape) => self.shape(shape, 1.0, shape.blend, steps),
                Item::Pixels { image, opacity, blend } => {
                    self.pixels(image.clone(), to_byte(*opacity), *blend, steps);
                }
                Item::Push(layer) => {
                    let inside = &items[index + 1..];
                    let inside = &inside[..layer_len(inside)];
                    if self.depth < self.renderer.max_depth {
                        self.depth += 1;
                        self.layer(layer, inside, steps);
                        self.depth -= 1;
                    }
                    index += inside.len() + 1;
                }
                // The end of no layer.
                Item::Pop => {}
            }
            index += 1;
        }
    }

    fn shape(&mut self, shape: &'a Shape, opacity: f32, blend: BlendMode, steps: &mut Vec<Step>) {
        let transform = self.base * shape.transform;
        let hairline = match &shape.outline {
            Outline::Fill(_) => None,
            Outline::Stroke(style) => {
                let samples = if shape.has_crisp_edges { 1 } else { self.samples };
                Hairline::of(style, &transform, samples)
            }
        };
        let faintness = hairline.as_ref().map_or(1.0, |hairline| hairline.opacity as f32);
        let opacity = unit(shape.opacity) * opacity * faintness;
        let Some(shader) = self.shader(&shape.paint, &transform, opacity) else { return };
        if shader.is_nothing() {
            return;
        }
        let (path, outline, is_crisp) = (&shape.path, &shape.outline, shape.has_crisp_edges);
        self.shapes.push(Outlined { path, outline, hairline, transform, is_crisp });
        self.shaders.push(shader);
        let (shape_number, shader) = (self.shapes.len() - 1, self.shaders.len() - 1);
        steps.push(Step::Fill { shape: shape_number, rule: shape.outline.rule(), shader, blend });
    }

    fn pixels(&mut self, image: Arc<LayerImage>, opacity: u32, blend: BlendMode, steps: &mut Vec<Step>) {
        let rect = image.rect;
        if image.pixels.len() as u64 != u64::from(rect.width) * u64::from(rect.height) {
            return;
        }
        // Pixels are not resampled: of the base, only its move by whole pixels counts.
        let whole = |value: f64| libm::rint(value) as i64;
        let at = [i64::from(rect.x) + whole(self.base.e), i64::from(rect.y) + whole(self.base.f)];
        self.images.push(image);
        steps.push(Step::Pixels { image: self.images.len() - 1, at, opacity, blend });
    }

    fn layer(&mut self, layer: &'a Layer, inside: &'a [Item], steps: &mut Vec<Step>) {
        let opacity = to_byte(layer.opacity);
        if opacity == 0 {
            return;
        }
        let clip = layer.clip.as_deref().map(|clip| self.clip(clip, 0));
        let mask = layer.mask.as_deref().map(|mask| self.mask(mask));
        steps.extend(clip.map(|clip| Step::PushClip { clip }));
        match (&layer.filter, inside) {
            (Some(filter), _) => {
                let image = Arc::new(self.filtered(filter, inside));
                steps.extend(mask.map(|_| Step::PushLayer));
                let blend = if mask.is_some() { BlendMode::Normal } else { layer.blend };
                self.pixels(image, opacity, blend, steps);
                steps.extend(mask.map(|_| Step::PopLayer { opacity: 255, blend: layer.blend, mask }));
            }
            // A single shape takes the layer's opacity upon itself.
            (None, [Item::Shape(shape)]) if mask.is_none() && shape.blend == BlendMode::Normal => {
                self.shape(shape, unit(layer.opacity), layer.blend, steps);
            }
            _ => {
                let is_plain = opacity == 255 && layer.blend == BlendMode::Normal && mask.is_none();
                let is_apart = !is_plain || layer.isolate && blends(inside);
                steps.extend(is_apart.then_some(Step::PushLayer));
                self.items(inside, steps);
                steps.extend(is_apart.then_some(Step::PopLayer { opacity, blend: layer.blend, mask }));
            }
        }
        steps.extend(clip.map(|_| Step::PopClip));
    }

    /// The number of a clip path; those inside it come before it. Too deep ones let nothing through.
    fn clip(&mut self, clip: &'a ClipPath, depth: u32) -> usize {
        let mut shapes = Vec::new();
        let mut intersect = None;
        if depth < self.renderer.max_depth {
            for shape in &clip.shapes {
                let own = shape.clip.as_deref().map(|clip| self.clip(clip, depth + 1));
                let transform = self.base * shape.transform;
                self.shapes.push(Outlined {
                    path: &shape.path,
                    outline: &NON_ZERO,
                    hairline: None,
                    transform,
                    is_crisp: false,
                });
                shapes.push((self.shapes.len() - 1, shape.rule, own));
            }
            intersect = clip.intersect.as_deref().map(|clip| self.clip(clip, depth + 1));
        }
        self.clips.push(Clip { shapes, intersect, bounds: Bounds::default() });
        self.clips.len() - 1
    }

    /// The number of a mask; one on it comes before it. Too deep ones let nothing through.
    fn mask(&mut self, mask: &'a Mask) -> usize {
        let mut steps = Vec::new();
        let mut outer = None;
        if self.depth < self.renderer.max_depth {
            self.depth += 1;
            outer = mask.mask.as_deref().map(|mask| self.mask(mask));
            self.items(mask.drawing.items(), &mut steps);
            self.depth -= 1;
        }
        self.masks.push(MaskProgram { program: Program::new(steps), kind: mask.kind, mask: outer });
        self.masks.len() - 1
    }

    /// What a filter makes of a layer.
    fn filtered(&self, filter: &Filter, inside: &[Item]) -> LayerImage {
        let mut rect = filter.region;
        let limit = self.renderer.max_pixels.min(u64::from(u32::MAX));
        rect.width = rect.width.min(trigon::target::MAX_SIZE);
        rect.height = rect.height.min(trigon::target::MAX_SIZE).min((limit / u64::from(rect.width.max(1))) as u32);
        let base = Transform::translate(-f64::from(rect.x), -f64::from(rect.y));
        let pixels = picture_of(self.renderer, inside, base, [rect.width, rect.height], self.depth + 1);
        let deadline = self.renderer.deadline;
        if deadline.is_over() {
            return LayerImage::default();
        }
        (filter.apply)(LayerImage { rect, pixels }, deadline)
    }

    /// `None` if nothing is drawn.
    fn shader(&self, paint: &Paint, transform: &Transform, opacity: f32) -> Option<Shader> {
        let gradient = |made: Option<Result<Gradient, u32>>| match made? {
            Ok(gradient) => Some(Shader::Gradient(Box::new(gradient))),
            Err(color) => Some(Shader::Solid(color)),
        };
        match paint {
            Paint::Color(color) => Some(Shader::Solid(premultiplied(*color, opacity))),
            Paint::Linear(linear) => gradient(Gradient::linear(linear, transform, opacity)),
            Paint::Radial(radial) => gradient(Gradient::radial(radial, transform, opacity)),
            Paint::Pattern(pattern) => self.tile(pattern, transform, opacity).map(|tile| Shader::Tile(Box::new(tile))),
            Paint::Image { image, filter, transform: own } => {
                ImageShader::new(image, *filter, &(*transform * *own), opacity).map(|i| Shader::Image(Box::new(i)))
            }
        }
    }

    /// Draws the tile of a pattern.
    fn tile(&self, pattern: &Pattern, transform: &Transform, opacity: f32) -> Option<Tile> {
        let [x, y, width, height] = pattern.tile.map(f64::from);
        let has_area = width > 0.0 && height > 0.0 && width.is_finite() && height.is_finite();
        if !has_area || self.depth >= self.renderer.max_depth {
            return None;
        }
        let from_pattern = *transform * pattern.transform;
        let [width_px, height_px] = pattern.pixels.unwrap_or_else(|| {
            let [scale_x, scale_y] = from_pattern.axis_scales();
            [width * scale_x, height * scale_y].map(|side| libm::rint(side).clamp(1.0, 4096.0) as u32)
        });
        let size = [width_px, height_px].map(|side| side.min(trigon::target::MAX_SIZE));
        if u64::from(size[0]) * u64::from(size[1]) > self.renderer.max_pixels {
            return None;
        }
        let (scale_x, scale_y) = (f64::from(size[0]) / width, f64::from(size[1]) / height);
        let base = Transform::scale(scale_x, scale_y) * Transform::translate(-x, -y);
        let pixels = picture_of(self.renderer, pattern.drawing.items(), base, size, self.depth + 1);
        let pixels = pixels.into_iter().map(u32::from_le_bytes).collect();
        let from_tile = from_pattern * Transform::translate(x, y) * Transform::scale(1.0 / scale_x, 1.0 / scale_y);
        Tile::new(size, pixels, &from_tile, to_byte(unit(pattern.opacity) * opacity))
    }
}
