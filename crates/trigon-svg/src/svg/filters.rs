//! Groups with a filter: drawn apart, resolved to pixels, sent through the filter, and drawn back.
//!
//! A filter works along the axes of its element's user space. Where that is turned or skewed in the picture, the group is
//! drawn upright and the result is sampled back; else it is a layer of the drawing, pixel by pixel.

use std::sync::Arc;

use trigon::schedule::Deadline;
use trigon::shade::texture::{LevelFilter, PixelFilter};
use trigon_image::{Color, Rgba8Image};

use super::bounds::{grown, intersect, numbers, pixel_rect, to_u32};
use super::convert::Converter;
use super::primitives::{Space, graph, reach};
use crate::canvas::{BlendMode, Drawing, Filter, Image, ImageFilter, Layer, LayerImage, PixelRect, Transform};
use crate::filter::{Graph, Raster, Region, divide};

/// Filters in order, each with its region, for a layer of pixels.
#[derive(Clone)]
struct Chain {
    /// The layer's pixels.
    layer: PixelRect,
    filters: Vec<(PixelRect, Graph)>,
}

impl Converter<'_> {
    /// Draws a group that has filters; `pixels_from_group` includes its own transform.
    pub(super) fn filtered(&mut self, out: &mut Drawing, group: &usvg::Group, pixels_from_group: Transform) {
        let Some((pixels_from_upright, upright_from_group)) = upright(pixels_from_group) else { return };
        let Some(region) = self.filter_region(group, &pixels_from_upright, &upright_from_group) else { return };
        let chain = self.chain(group, region, upright_from_group);
        let layer = self.layer(group, pixels_from_group);
        if pixels_from_upright == Transform::IDENTITY {
            let filter = Filter { region, apply: Arc::new(move |image, deadline| chain.apply(&image, deadline)) };
            out.push_layer(Layer { filter: Some(filter), ..layer });
            self.nodes(out, group, pixels_from_group);
            out.pop_layer();
        } else if let Some(image) = self.filtered_image(group, &chain, upright_from_group) {
            out.push_layer(layer);
            let filter = ImageFilter::new(PixelFilter::Bilinear, LevelFilter::Zero);
            let place = pixels_from_upright * Transform::translate(f64::from(region.x), f64::from(region.y));
            out.image(&image, filter, place, 1.0, BlendMode::Normal);
            out.pop_layer();
        }
    }

    /// The pixels of the upright space that the filters work on.
    fn filter_region(
        &mut self,
        group: &usvg::Group,
        pixels_from_upright: &Transform,
        upright_from_group: &Transform,
    ) -> Option<PixelRect> {
        let region = pixel_rect(numbers(group.layer_bounding_box()), upright_from_group);
        let canvas = numbers_of(self.canvas);
        let seen = pixel_rect(canvas, &pixels_from_upright.inverse()?);
        let [reach_x, reach_y] = group
            .filters()
            .iter()
            .map(|filter| reach(filter, upright_from_group))
            .try_fold([0.0, 0.0], |sum, next| next.map(|next| [sum[0] + next[0], sum[1] + next[1]]))
            .map_or([u32::MAX; 2], |reach| reach.map(to_u32));
        let margin = |reach: u32, side: u32| reach.min(side.saturating_mul(2));
        let near = intersect(region, grown(seen, margin(reach_x, seen.width), margin(reach_y, seen.height)))?;
        let area = |rect: PixelRect| u64::from(rect.width) * u64::from(rect.height);
        if area(near) <= self.limits.max_filter_pixels {
            return Some(near);
        }
        self.warnings.add("a filter region over the limit of pixels is cut to the picture");
        let cut = intersect(region, grown(seen, 64, 64))?;
        (area(cut) <= self.limits.max_filter_pixels.max(area(seen))).then_some(cut)
    }

    fn chain(&mut self, group: &usvg::Group, layer: PixelRect, upright_from_group: Transform) -> Chain {
        let mut filters = Vec::new();
        for filter in group.filters() {
            let rect = pixel_rect(numbers(filter.rect()), &upright_from_group);
            let region = intersect(rect, layer).unwrap_or_default();
            let space = Space { region, pixels_from_user: upright_from_group };
            filters.push((region, graph(self, filter, space)));
        }
        Chain { layer, filters }
    }

    /// The group drawn upright and filtered; `None` where it cannot be drawn.
    fn filtered_image(&mut self, group: &usvg::Group, chain: &Chain, upright_from_group: Transform) -> Option<Image> {
        let layer = chain.layer;
        let to_origin = Transform::translate(-f64::from(layer.x), -f64::from(layer.y));
        let mut content = Drawing::new();
        let canvas = PixelRect { x: 0, y: 0, ..layer };
        self.inside(canvas, |converter| converter.nodes(&mut content, group, to_origin * upright_from_group));
        let picture = self.renderer.draw(&content, layer.width, layer.height, Color::TRANSPARENT).ok()?;
        let image = LayerImage { rect: layer, pixels: picture.into_pixels() };
        let filtered = chain.apply(&image, self.renderer.deadline);
        let pixels = filtered.pixels.into_iter().map(divide).collect();
        let straight = Rgba8Image::from_pixels(filtered.rect.width, filtered.rect.height, pixels).ok()?;
        Image::new(&straight).ok()
    }
}

impl Chain {
    /// No pixels if the deadline came first.
    fn apply(&self, image: &LayerImage, deadline: Deadline) -> LayerImage {
        let side = |length: u32| length as usize;
        let (width, height) = (side(self.layer.width), side(self.layer.height));
        let given = Raster::from_pixels(side(image.rect.width), side(image.rect.height), image.pixels.clone());
        let Some(given) = given else { return LayerImage::default() };
        let (dx, dy) = offset(image.rect, self.layer);
        let mut layer = if image.rect == self.layer { given } else { Raster::placed(&given, dx, dy, width, height) };
        for (rect, graph) in &self.filters {
            let (left, top) = offset(*rect, self.layer);
            let region = Region {
                left,
                top,
                right: left.saturating_add_unsigned(rect.width),
                bottom: top.saturating_add_unsigned(rect.height),
            };
            let Some(filtered) = graph.run(layer.cropped(region), deadline) else { return LayerImage::default() };
            layer = Raster::placed(&filtered, left, top, width, height);
        }
        LayerImage { rect: self.layer, pixels: layer.into_pixels() }
    }
}

/// Where `inner` starts, in pixels of `outer`.
fn offset(inner: PixelRect, outer: PixelRect) -> (i32, i32) {
    (inner.x.saturating_sub(outer.x), inner.y.saturating_sub(outer.y))
}

fn numbers_of(rect: PixelRect) -> [f64; 4] {
    [f64::from(rect.x), f64::from(rect.y), f64::from(rect.width), f64::from(rect.height)]
}

/// Splits a map into a scale with a translation (second), and what is left: a turn or skew (first).
fn upright(map: Transform) -> Option<(Transform, Transform)> {
    let [scale_x, scale_y] = map.axis_scales();
    let turn = Transform::new(map.a / scale_x, map.b / scale_x, map.c / scale_y, map.d / scale_y, 0.0, 0.0);
    let near = |value: f64, whole: f64| (value - whole).abs() < 1e-6;
    if near(turn.a, 1.0) && near(turn.b, 0.0) && near(turn.c, 0.0) && near(turn.d, 1.0) {
        return map.is_finite().then_some((Transform::IDENTITY, map));
    }
    Some((turn, turn.inverse()? * map))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_parts_of_a_map_make_it_again() {
        for map in [
            Transform::new(2.0, 0.0, 0.0, 3.0, 7.0, -1.0),
            Transform::rotate(0.4) * Transform::scale(2.0, 5.0) * Transform::translate(3.0, 4.0),
            Transform::new(-1.0, 0.0, 0.0, 1.0, 30.0, 0.0),
        ] {
            let (turn, flat) = upright(map).unwrap();
            assert!(flat.b.abs() < 1e-12 && flat.c.abs() < 1e-12 && flat.a > 0.0 && flat.d > 0.0);
            let both = turn * flat;
            for (a, b) in [(both.a, map.a), (both.b, map.b), (both.c, map.c), (both.d, map.d), (both.e, map.e)] {
                assert!((a - b).abs() < 1e-9);
            }
        }
        assert!(upright(Transform::scale(0.0, 1.0)).is_none());
    }
}
