//! `textri` and `colortri`, the triangles of CS184's files, in ordinary SVG.
//!
//! The reader of the tree does not know them. So the text is rewritten before: each becomes a `path` filled with a gradient
//! whose id says which triangle it is, and keeps its other attributes, so that groups, transforms, clips and `use` treat it
//! like any shape. When the tree is drawn, such a gradient stands for the triangle's own paint.

use std::collections::HashMap;
use std::fmt::Write;
use std::sync::Arc;

use trigon::shade::texture::{Alpha, LevelFilter, PixelFilter, TexelFormat, Texture, TextureDesc};
use usvg::roxmltree::{Document, Node};

use super::Options;
use super::warnings::Warnings;
use crate::canvas::{Image, ImageFilter, Paint, Transform};
use crate::cs184::number_list;
use crate::linked;

/// The paints of a document's triangles, by the id of the gradient that stands for each.
#[derive(Debug, Clone, Default)]
pub(super) struct Triangles {
    paints: HashMap<String, Paint>,
}

/// Ids that no file uses by chance.
const ID_PREFIX: &str = "trigon-triangle-";

impl Triangles {
    /// The paint that the gradient of this id stands for.
    pub(super) fn paint(&self, id: &str) -> Option<&Paint> {
        self.paints.get(id)
    }
}

/// The text with paths in place of triangles, and their paints; `None` where there are no triangles.
pub(super) fn rewrite(
    xml: &Document<'_>,
    text: &str,
    options: &Options,
    warnings: &mut Warnings,
) -> Option<(String, Triangles)> {
    let is_triangle = |node: &Node<'_, '_>| matches!(node.tag_name().name(), "textri" | "colortri");
    xml.descendants().find(is_triangle)?;
    let mut textures = Textures { options, images: HashMap::new(), pixels: 0 };
    let mut triangles = Triangles::default();
    let (mut rewritten, mut copied) = (String::with_capacity(text.len()), 0);
    for node in xml.descendants().filter(Node::is_element) {
        match node.tag_name().name() {
            "texture" => textures.read(node, warnings),
            "textri" | "colortri" => {
                let id = format!("{ID_PREFIX}{}", triangles.paints.len());
                // A triangle in a triangle, or in an entity's text, has no place of its own here.
                let Some(before) = text.get(copied..node.range().start) else { continue };
                rewritten.push_str(before);
                copied = node.range().end;
                match paint(node, &textures) {
                    Some(paint) => {
                        write_path(&mut rewritten, node, text, &id);
                        triangles.paints.insert(id, paint);
                    }
                    None => {
                        warnings.add(format!("a {} without corners or texture is not drawn", node.tag_name().name()));
                    }
                }
            }
            _ => {}
        }
    }
    rewritten.push_str(text.get(copied..)?);
    Some((rewritten, triangles))
}

/// Writes the gradient and the path, in the namespace that the element is written in.
fn write_path(out: &mut String, node: Node<'_, '_>, text: &str, id: &str) {
    let name = text.get(node.range()).unwrap_or_default().trim_start_matches('<');
    let prefix = name
        .split_once(':')
        .map(|(prefix, _)| prefix)
        .filter(|prefix| prefix.chars().all(|c| c.is_alphanumeric() || matches!(c, '-' | '_' | '.')));
    let prefix = prefix.map_or_else(String::new, |prefix| format!("{prefix}:"));
    let kept: String = node
        .attributes()
        .filter(|attribute| !matches!(attribute.name(), "points" | "uvs" | "colors" | "texid" | "fill" | "d"))
        .map(|attribute| format!(" {}", text.get(attribute.range()).unwrap_or_default()))
        .collect();
    let points = number_list(node.attribute("points").unwrap_or_default());
    let [x0, y0, x1, y1, x2, y2] = std::array::from_fn(|i| points.get(i).copied().unwrap_or(0.0));
    // Writing into a string cannot fail.
    let _ = write!(
        out,
        "<{prefix}linearGradient id=\"{id}\" gradientUnits=\"userSpaceOnUse\" x2=\"1\"><{prefix}stop/><{prefix}stop offset=\"1\" \
         stop-color=\"#fff\"/></{prefix}linearGradient><{prefix}path d=\"M{x0} {y0}L{x1} {y1}L{x2} {y2}Z\" fill=\"url(#{id})\"{kept}/>"
    );
}

/// Pictures of `texture` elements so far, by their `texid`.
struct Textures<'a> {
    options: &'a Options,
    images: HashMap<String, Image>,
    pixels: u64,
}

impl Textures<'_> {
    fn read(&mut self, node: Node<'_, '_>, warnings: &mut Warnings) {
        let (Some(id), Some(file)) = (node.attribute("texid"), node.attribute("filename")) else { return };
        match self.image(file) {
            Ok(image) => drop(self.images.insert(id.to_owned(), image)),
            Err(error) => warnings.add(format!("the texture '{file}' is not drawn: {error}")),
        }
    }

    fn image(&mut self, file: &str) -> Result<Image, String> {
        let limits = &self.options.limits;
        let left = limits.max_image_pixels.saturating_sub(self.pixels);
        let pixels = linked::picture(self.options.folder.as_deref(), file, limits.max_bytes, left)?;
        self.pixels += u64::from(pixels.width()) * u64::from(pixels.height());
        Image::new(&pixels).map_err(|error| error.to_string())
    }
}

fn paint(node: Node<'_, '_>, textures: &Textures<'_>) -> Option<Paint> {
    let numbers = |name: &str| number_list(node.attribute(name).unwrap_or_default());
    let corners = pairs(&numbers("points"))?;
    if node.tag_name().name() == "colortri" {
        return mixed(corners, &numbers("colors"));
    }
    let image = textures.images.get(node.attribute("texid")?)?;
    let [width, height] = image.size().map(f64::from);
    let texels = pairs(&numbers("uvs"))?.map(|[u, v]| [u * width, v * height]);
    let transform = from_unit(corners) * from_unit(texels).inverse()?;
    Some(Paint::Image { image: image.clone(), filter: textures.options.triangle_filter, transform })
}

/// The first three points of a list.
fn pairs(numbers: &[f64]) -> Option<[[f64; 2]; 3]> {
    let numbers = numbers.get(..6)?;
    Some([0, 1, 2].map(|i| [numbers[2 * i], numbers[2 * i + 1]]))
}

/// Sends (0, 0), (1, 0), (0, 1) to the three points.
fn from_unit([a, b, c]: [[f64; 2]; 3]) -> Transform {
    Transform::new(b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1], a[0], a[1])
}

/// Colors at the corners, mixed: an image of 2x2 floats whose bilinear filter is that mix, far beyond the triangle.
fn mixed(corners: [[f64; 2]; 3], colors: &[f64]) -> Option<Paint> {
    /// The texels' centres lie at -1 and 2 in units of the triangle's sides.
    const PLACES: [[f64; 2]; 4] = [[-1.0, -1.0], [2.0, -1.0], [-1.0, 2.0], [2.0, 2.0]];
    let colors = colors.get(..12)?;
    let mut values = Vec::new();
    for [s, t] in PLACES {
        for channel in 0..3 {
            let [a, b, c] = [0, 4, 8].map(|first| colors[first + channel].clamp(0.0, 1.0));
            #[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
            let value = (a + s * (b - a) + t * (c - a)) as f32;
            values.push(value);
        }
        values.push(1.0);
    }
    let desc = TextureDesc { alpha: Alpha::Independent, ..TextureDesc::new([2, 2], TexelFormat::Rgba32Float) };
    let image = Image::from_texture(Arc::new(Texture::from_floats(&desc, &values).ok()?));
    // Texel centres are at 0.5 and 1.5 of the image.
    let unit_from_image = Transform::new(3.0, 0.0, 0.0, 3.0, -2.5, -2.5);
    let filter = ImageFilter::new(PixelFilter::Bilinear, LevelFilter::Zero);
    Some(Paint::Image { image, filter, transform: from_unit(corners) * unit_from_image })
}
