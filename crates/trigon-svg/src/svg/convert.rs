//! The tree of `usvg` as a [`Drawing`]: groups become layers, paths become shapes, text is already paths.

use std::sync::Arc;

use trigon_image::Color;

use super::clip::clip_path;
use super::images::{Images, image_filter};
use super::limits::Limits;
use super::paint::{color, fill_rule, linear, radial, stroke};
use super::path::{path, rect_path, transform};
use super::triangles::Triangles;
use super::warnings::Warnings;
use crate::canvas::{
    BlendMode, ClipPath, Drawing, FillRule, ImageFilter, Layer, Mask, MaskKind, Paint, Path, Pattern, PixelRect,
    Renderer, Transform,
};
use crate::filter::{DrawPicture, Raster};

/// A conversion in progress.
pub(super) struct Converter<'a> {
    pub(super) renderer: &'a Renderer,
    pub(super) limits: &'a Limits,
    /// The pixels that are seen of what is being drawn.
    pub(super) canvas: PixelRect,
    pub(super) warnings: Warnings,
    images: Images,
    triangles: &'a Triangles,
    depth: usize,
}

impl<'a> Converter<'a> {
    pub(super) fn new(renderer: &'a Renderer, limits: &'a Limits, triangles: &'a Triangles, canvas: PixelRect) -> Self {
        let (warnings, images) = (Warnings::default(), Images::default());
        Self { renderer, limits, canvas, warnings, images, triangles, depth: 0 }
    }

    /// Draws a node; `pixels_from_parent` is the space its transform leads to.
    pub(super) fn node(&mut self, out: &mut Drawing, node: &usvg::Node, pixels_from_parent: Transform) {
        match node {
            usvg::Node::Group(group) => self.group(out, group, pixels_from_parent * transform(group.transform())),
            usvg::Node::Path(shape) => self.shape(out, shape, pixels_from_parent),
            usvg::Node::Image(image) => self.image(out, image, pixels_from_parent),
            usvg::Node::Text(text) => {
                let group = text.flattened();
                self.group(out, group, pixels_from_parent * transform(group.transform()));
            }
        }
    }

    /// Draws a group; `pixels_from_group` includes its own transform.
    pub(super) fn group(&mut self, out: &mut Drawing, group: &usvg::Group, pixels_from_group: Transform) {
        if self.depth >= self.limits.max_depth {
            self.warnings.add("groups inside too many others are not drawn");
            return;
        }
        self.depth += 1;
        if !group.should_isolate() {
            self.nodes(out, group, pixels_from_group);
        } else if group.filters().is_empty() {
            let layer = self.layer(group, pixels_from_group);
            out.push_layer(layer);
            self.nodes(out, group, pixels_from_group);
            out.pop_layer();
        } else {
            self.filtered(out, group, pixels_from_group);
        }
        self.depth -= 1;
    }

    /// Draws what is in a group.
    pub(super) fn nodes(&mut self, out: &mut Drawing, group: &usvg::Group, pixels_from_group: Transform) {
        for node in group.children() {
            if self.renderer.deadline.is_over() {
                return;
            }
            self.node(out, node, pixels_from_group);
        }
    }

    /// How the group is treated, but for its filters.
    pub(super) fn layer(&mut self, group: &usvg::Group, pixels_from_group: Transform) -> Layer {
        Layer {
            opacity: group.opacity().get(),
            blend: self.blend_mode(group.blend_mode()),
            isolate: true,
            clip: group.clip_path().map(|clip| Arc::new(clip_path(clip, pixels_from_group))),
            mask: group.mask().map(|mask| Arc::new(self.mask(mask, pixels_from_group))),
            filter: None,
        }
    }

    /// Converts inside another canvas, as a pattern's or a filter's.
    pub(super) fn inside(&mut self, canvas: PixelRect, convert: impl FnOnce(&mut Self)) {
        let outer = std::mem::replace(&mut self.canvas, canvas);
        convert(self);
        self.canvas = outer;
    }

    /// A function that draws a group on its own canvas.
    pub(super) fn picture(
        &mut self,
        group: &usvg::Group,
        pixels_from_parent: Transform,
        canvas: PixelRect,
    ) -> DrawPicture {
        let mut drawing = Drawing::new();
        self.inside(canvas, |converter| {
            converter.group(&mut drawing, group, pixels_from_parent * transform(group.transform()));
        });
        let renderer = self.renderer.clone();
        Arc::new(move |width, height, deadline| {
            let renderer = Renderer { deadline, ..renderer.clone() };
            let sides = (u32::try_from(width), u32::try_from(height));
            let drawn = match sides {
                (Ok(w), Ok(h)) => renderer.draw(&drawing, w, h, Color::TRANSPARENT).ok(),
                _ => None,
            };
            drawn
                .and_then(|picture| Raster::from_pixels(width, height, picture.into_pixels()))
                .unwrap_or_else(|| Raster::new(width, height))
        })
    }

    fn mask(&mut self, source: &usvg::Mask, pixels_from_group: Transform) -> Mask {
        let mut drawing = Drawing::new();
        let clip = ClipPath::new(rect_path(source.rect()), FillRule::NonZero, pixels_from_group);
        drawing.push_layer(Layer { clip: Some(Arc::new(clip)), ..Layer::default() });
        self.nodes(&mut drawing, source.root(), pixels_from_group * transform(source.root().transform()));
        drawing.pop_layer();
        Mask {
            drawing,
            kind: match source.kind() {
                usvg::MaskType::Luminance => MaskKind::Luminance,
                usvg::MaskType::Alpha => MaskKind::Alpha,
            },
            mask: source.mask().map(|outer| Arc::new(self.mask(outer, pixels_from_group))),
        }
    }

    fn shape(&mut self, out: &mut Drawing, shape: &usvg::Path, pixels_from_path: Transform) {
        if !shape.is_visible() {
            return;
        }
        let outline = Arc::new(path(shape.data()));
        out.set_crisp_edges(!shape.rendering_mode().use_shape_antialiasing());
        match shape.paint_order() {
            usvg::PaintOrder::FillAndStroke => {
                self.fill(out, shape, &outline, pixels_from_path);
                self.stroke(out, shape, &outline, pixels_from_path);
            }
            usvg::PaintOrder::StrokeAndFill => {
                self.stroke(out, shape, &outline, pixels_from_path);
                self.fill(out, shape, &outline, pixels_from_path);
            }
        }
        out.set_crisp_edges(false);
    }

    fn fill(&mut self, out: &mut Drawing, shape: &usvg::Path, outline: &Arc<Path>, pixels_from_path: Transform) {
        let Some(fill) = shape.fill() else { return };
        if let Some(paint) = self.paint(fill.paint(), pixels_from_path) {
            let opacity = fill.opacity().get();
            out.fill(Arc::clone(outline), fill_rule(fill.rule()), pixels_from_path, paint, opacity, BlendMode::Normal);
        }
    }

    fn stroke(&mut self, out: &mut Drawing, shape: &usvg::Path, outline: &Arc<Path>, pixels_from_path: Transform) {
        let Some(source) = shape.stroke() else { return };
        if let Some(paint) = self.paint(source.paint(), pixels_from_path) {
            let opacity = source.opacity().get();
            out.stroke(Arc::clone(outline), &stroke(source), pixels_from_path, paint, opacity, BlendMode::Normal);
        }
    }

    fn paint(&mut self, source: &usvg::Paint, pixels_from_path: Transform) -> Option<Paint> {
        Some(match source {
            usvg::Paint::Color(source) => color(*source).into(),
            usvg::Paint::LinearGradient(source) => {
                self.triangles.paint(source.id()).cloned().unwrap_or_else(|| linear(source))
            }
            usvg::Paint::RadialGradient(source) => radial(source),
            usvg::Paint::Pattern(source) => self.pattern(source, pixels_from_path)?.into(),
        })
    }

    /// The pattern, drawn at the size it has in the picture so that filters inside it work on such pixels. Its tile is
    /// rounded to whole pixels, as the reference pictures have it: all repetitions look the same.
    fn pattern(&mut self, source: &usvg::Pattern, pixels_from_path: Transform) -> Option<Pattern> {
        if self.depth >= self.limits.max_depth {
            self.warnings.add("patterns inside too many others are not drawn");
            return None;
        }
        let path_from_pattern = transform(source.transform());
        let rect = source.rect();
        let [scale_x, scale_y] = self.tile_scale(rect, pixels_from_path * path_from_pattern);
        let side = |length: f32, scale: f64| {
            let side = (f64::from(length) * scale + 0.5).clamp(1.0, f64::from(trigon::target::MAX_SIZE));
            super::bounds::to_u32(side)
        };
        let (width, height) = (side(rect.width(), scale_x), side(rect.height(), scale_y));
        let mut drawing = Drawing::new();
        self.depth += 1;
        self.inside(PixelRect { x: 0, y: 0, width, height }, |converter| {
            let root = source.root();
            converter.nodes(&mut drawing, root, Transform::scale(scale_x, scale_y) * transform(root.transform()));
        });
        self.depth -= 1;
        let to_corner = Transform::translate(f64::from(rect.x()), f64::from(rect.y()));
        let path_from_tile = path_from_pattern * to_corner * Transform::scale(1.0 / scale_x, 1.0 / scale_y);
        let path_from_tile = on_whole_pixels(path_from_tile, pixels_from_path);
        #[expect(clippy::cast_precision_loss, reason = "tiles have fewer than 2^24 pixels a side")]
        let tile = [0.0, 0.0, width as f32, height as f32];
        let pattern = Pattern { drawing, tile, transform: path_from_tile, pixels: Some([width, height]), opacity: 1.0 };
        path_from_tile.is_finite().then_some(pattern)
    }

    /// Pixels of the tile for a unit of its space along x and y: as in the picture, or less where that is over the limit.
    fn tile_scale(&mut self, rect: usvg::NonZeroRect, pixels_from_tile: Transform) -> [f64; 2] {
        // The scales of the picture's axes, not of the tile's, as the reference pictures have it; for skewed patterns alone
        // that makes a difference.
        let Transform { a, b, c, d, .. } = pixels_from_tile;
        let [scale_x, scale_y] = Transform::new(a, c, b, d, 0.0, 0.0).axis_scales();
        let area = f64::from(rect.width()) * scale_x * (f64::from(rect.height()) * scale_y);
        #[expect(clippy::cast_precision_loss, reason = "a limit need not be exact")]
        let most = self.limits.max_tile_pixels as f64;
        if area <= most {
            return [scale_x, scale_y];
        }
        self.warnings.add("a pattern's tile over the limit of pixels is drawn coarser");
        let reduction = (most / area).sqrt();
        [scale_x * reduction, scale_y * reduction]
    }

    fn image(&mut self, out: &mut Drawing, image: &usvg::Image, pixels_from_image: Transform) {
        if !image.is_visible() {
            return;
        }
        if let usvg::ImageKind::SVG(tree) = image.kind() {
            let root = tree.root();
            return self.group(out, root, pixels_from_image * transform(root.transform()));
        }
        let filter = image_filter(image.rendering_mode());
        let scales = if filter == ImageFilter::SMOOTH { pixels_from_image.axis_scales() } else { [1.0, 1.0] };
        if let Some((pixels, [x, y])) = self.images.get(image.kind(), scales, self.limits, &mut self.warnings) {
            let place = pixels_from_image * Transform::scale(1.0 / f64::from(x), 1.0 / f64::from(y));
            let place = on_whole_pixels(place, Transform::IDENTITY);
            out.image(&pixels, filter, place, 1.0, BlendMode::Normal);
        }
    }

    pub(super) fn blend_mode(&mut self, mode: usvg::BlendMode) -> BlendMode {
        match mode {
            usvg::BlendMode::Normal => BlendMode::Normal,
            usvg::BlendMode::Multiply => BlendMode::Multiply,
            usvg::BlendMode::Screen => BlendMode::Screen,
            usvg::BlendMode::Overlay => BlendMode::Overlay,
            usvg::BlendMode::Darken => BlendMode::Darken,
            usvg::BlendMode::Lighten => BlendMode::Lighten,
            usvg::BlendMode::ColorDodge => BlendMode::ColorDodge,
            usvg::BlendMode::ColorBurn => BlendMode::ColorBurn,
            usvg::BlendMode::HardLight => BlendMode::HardLight,
            usvg::BlendMode::SoftLight => BlendMode::SoftLight,
            usvg::BlendMode::Difference => BlendMode::Difference,
            usvg::BlendMode::Exclusion => BlendMode::Exclusion,
            usvg::BlendMode::Hue => BlendMode::Hue,
            usvg::BlendMode::Saturation => BlendMode::Saturation,
            usvg::BlendMode::Color => BlendMode::Color,
            usvg::BlendMode::Luminosity => BlendMode::Luminosity,
            usvg::BlendMode::PlusLighter => BlendMode::PlusLighter,
        }
    }
}

/// `outer_from_inner`, moved by less than a pixel where pixels of the inner space are as large as those of the picture,
/// so that none is mixed from several.
fn on_whole_pixels(outer_from_inner: Transform, pixels_from_outer: Transform) -> Transform {
    let map = pixels_from_outer * outer_from_inner;
    let near = |value: f64, whole: f64| (value - whole).abs() < 1e-9;
    let is_translation = near(map.a, 1.0) && near(map.b, 0.0) && near(map.c, 0.0) && near(map.d, 1.0);
    match pixels_from_outer.inverse().filter(|_| is_translation) {
        // Halves go down; arithmetic in f32 upstream may leave them a little above.
        Some(outer_from_pixels) => {
            let whole = |offset: f64| (offset - 0.5 - 1e-3).ceil();
            outer_from_pixels * Transform::translate(whole(map.e), whole(map.f))
        }
        None => outer_from_inner,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn translations_become_whole_and_nothing_else_changes() {
        let pixels_from_outer = Transform::scale(1.5, 1.5);
        let outer_from_inner = Transform::new(2.0 / 3.0, 0.0, 0.0, 2.0 / 3.0, 5.0, 10.2);
        let snapped = pixels_from_outer * on_whole_pixels(outer_from_inner, pixels_from_outer);
        assert!((snapped.e - 7.0).abs() < 1e-9 && (snapped.f - 15.0).abs() < 1e-9);
        let turned = Transform::rotate(0.1);
        assert_eq!(on_whole_pixels(turned, Transform::IDENTITY), turned);
    }
}
