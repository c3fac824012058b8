//! The elements that are drawn, each as primitives in the file's units.

use usvg::roxmltree::Node;

use super::ears::triangulate;
use super::number;
use super::primitive::{Color, Position, Primitive, TrianglePaint};
use super::reader::Reader;
use crate::canvas::Transform;

/// Adds what an element draws; unknown elements, and all in them, draw nothing.
pub(super) fn read(reader: &mut Reader, name: &str, node: Node<'_, '_>, map: Transform) {
    match name {
        "line" => line(reader, node, map),
        "polyline" => polyline(reader, node, map),
        "polygon" => polygon(reader, node, map),
        "rect" => rect(reader, node, map),
        "image" => image(reader, node, map),
        "colortri" => color_triangle(reader, node, map),
        "textri" => textured_triangle(reader, node, map),
        _ => {}
    }
}

fn attribute(node: Node<'_, '_>, name: &str) -> f64 {
    node.attribute(name).and_then(number::leading).unwrap_or(0.0)
}

fn opacity(node: Node<'_, '_>, name: &str) -> f32 {
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
    node.attribute(name).and_then(number::leading).map_or(1.0, |opacity| opacity.clamp(0.0, 1.0) as f32)
}

/// The fill color; black where none is given.
fn fill(node: Node<'_, '_>) -> Color {
    let [r, g, b] = node.attribute("fill").map_or([0.0; 3], number::color);
    [r, g, b, opacity(node, "fill-opacity")]
}

/// The stroke color, if one is given.
fn stroke(node: Node<'_, '_>) -> Option<Color> {
    let [r, g, b] = number::color(node.attribute("stroke")?);
    Some([r, g, b, opacity(node, "stroke-opacity")])
}

fn points(node: Node<'_, '_>) -> Vec<Position> {
    let numbers = number::list(node.attribute("points").unwrap_or_default());
    numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}

fn line(reader: &mut Reader, node: Node<'_, '_>, map: Transform) {
    if let Some(color) = stroke(node) {
        let from = map.apply([attribute(node, "x1"), attribute(node, "y1")]);
        let to = map.apply([attribute(node, "x2"), attribute(node, "y2")]);
        reader.primitives.push(Primitive::Line { from, to, color });
    }
}

/// Lines between points; black where no stroke is given.
fn polyline(reader: &mut Reader, node: Node<'_, '_>, map: Transform) {
    let color = stroke(node).unwrap_or([0.0, 0.0, 0.0, opacity(node, "stroke-opacity")]);
    let points: Vec<_> = points(node).into_iter().map(|point| map.apply(point)).collect();
    let lines = points.windows(2).map(|ends| Primitive::Line { from: ends[0], to: ends[1], color });
    reader.primitives.extend(lines);
}

fn polygon(reader: &mut Reader, node: Node<'_, '_>, map: Transform) {
    let points = points(node);
    let paint = TrianglePaint::Flat(fill(node));
    for triangle in triangulate(&points) {
        let corners = triangle.map(|corner| map.apply(corner));
        reader.primitives.push(Primitive::Triangle { corners, paint: paint.clone() });
    }
    if let Some(color) = stroke(node) {
        outline(reader, &points, map, color);
    }
}

fn outline(reader: &mut Reader, points: &[Position], map: Transform, color: Color) {
    for (index, from) in points.iter().enumerate() {
        let to = points[(index + 1) % points.len()];
        reader.primitives.push(Primitive::Line { from: map.apply(*from), to: map.apply(to), color });
    }
}

/// A rectangle; one of no width and no height is a point.
fn rect(reader: &mut Reader, node: Node<'_, '_>, map: Transform) {
    let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| attribute(node, name));
    if width == 0.0 && height == 0.0 {
        reader.primitives.push(Primitive::Point { at: map.apply([x, y]), color: fill(node) });
        return;
    }
    let corners = [[x, y], [x + width, y], [x, y + height], [x + width, y + height]];
    let [p0, p1, p2, p3] = corners.map(|corner| map.apply(corner));
    let paint = TrianglePaint::Flat(fill(node));
    reader.primitives.push(Primitive::Triangle { corners: [p0, p1, p2], paint: paint.clone() });
    reader.primitives.push(Primitive::Triangle { corners: [p2, p1, p3], paint });
    if let Some(color) = stroke(node) {
        for (from, to) in [(p0, p1), (p1, p3), (p3, p2), (p2, p0)] {
            reader.primitives.push(Primitive::Line { from, to, color });
        }
    }
}

fn image(reader: &mut Reader, node: Node<'_, '_>, map: Transform) {
    let link = node.attributes().find(|attribute| attribute.name() == "href").map(|attribute| attribute.value());
    if let Some(texture) = link.and_then(|link| reader.embedded(link)) {
        let [x, y, width, height] = ["x", "y", "width", "height"].map(|name| attribute(node, name));
        let (from, to) = (map.apply([x, y]), map.apply([x + width, y + height]));
        reader.primitives.push(Primitive::Picture { from, to, texture });
    }
}

/// The three points of a triangle.
fn triangle(node: Node<'_, '_>, map: Transform) -> Option<[Position; 3]> {
    let points = points(node);
    let corners = <[Position; 3]>::try_from(points.get(..3)?).ok()?;
    Some(corners.map(|corner| map.apply(corner)))
}

fn color_triangle(reader: &mut Reader, node: Node<'_, '_>, map: Transform) {
    let numbers = number::list(node.attribute("colors").unwrap_or_default());
    let Some(corners) = triangle(node, map).filter(|_| numbers.len() >= 12) else { return };
    #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
    let color = |corner: usize| [0, 1, 2].map(|channel| numbers[corner * 4 + channel] as f32);
    reader.primitives.push(Primitive::Triangle { corners, paint: TrianglePaint::Mixed([0, 1, 2].map(color)) });
}

fn textured_triangle(reader: &mut Reader, node: Node<'_, '_>, map: Transform) {
    let numbers = number::list(node.attribute("uvs").unwrap_or_default());
    let Some(corners) = triangle(node, map).filter(|_| numbers.len() >= 6) else { return };
    if let Some(texture) = reader.texture_of(node.attribute("texid").unwrap_or_default()) {
        let uv = [0, 1, 2].map(|corner| [numbers[corner * 2], numbers[corner * 2 + 1]]);
        reader.primitives.push(Primitive::Triangle { corners, paint: TrianglePaint::Textured { uv, texture } });
    }
}
