//! An SVG file that was read, and what can be asked of it: its size, a drawing, a picture.

use std::borrow::Cow;
use std::sync::Arc;

use trigon_image::Color;
use usvg::roxmltree;

use super::convert::Converter;
use super::fonts::watched_fonts;
use super::path::transform;
use super::pictures::watched_pictures;
use super::triangles::{Triangles, rewrite};
use super::view::Fitted;
use super::warnings::{SharedWarnings, Warnings};
use super::{Area, Limits, Options, SvgError, View, Warning};
use crate::canvas::{Drawing, Picture, PixelRect, Renderer};

/// An SVG file that was read: all references, styles and fonts are resolved.
pub struct Document {
    tree: usvg::Tree,
    limits: Limits,
    warnings: Warnings,
    triangles: Triangles,
}

/// A document, or a part of it, ready to be drawn.
#[derive(Debug, Clone)]
pub struct Prepared {
    /// What is drawn, in pixels.
    pub drawing: Drawing,
    /// The picture's width.
    pub width: u32,
    /// The picture's height.
    pub height: u32,
    /// What is not drawn, or not as the file says.
    pub warnings: Vec<Warning>,
}

impl Document {
    /// Reads an SVG file, plain or compressed with gzip.
    ///
    /// # Errors
    /// If it is not SVG, over a limit, or the deadline comes before the end.
    pub fn parse(bytes: &[u8], options: &Options) -> Result<Self, SvgError> {
        let text = text_of(bytes, &options.limits)?;
        // The tree's reader panics on numbers whose sums leave the range of f32.
        on_a_large_stack(READER_THREAD, || parse_text(&text, options))
            .unwrap_or_else(|_| Err(SvgError::Malformed("its numbers are too large or too small".to_owned())))
    }

    /// Width and height of the page in user space (pixels at the size the document asks for).
    #[must_use]
    pub fn size(&self) -> [f32; 2] {
        [self.tree.size().width(), self.tree.size().height()]
    }

    /// Turns a part of the document into a drawing for a picture of the view's size.
    ///
    /// `renderer` draws what cannot wait: groups whose filter works in turned coordinates, and `feImage`.
    ///
    /// # Errors
    /// If the view's id is not in the document, its area has no extent, or the renderer's deadline comes before the end.
    pub fn prepare(&self, view: &View, renderer: &Renderer) -> Result<Prepared, SvgError> {
        on_a_large_stack("trigon-svg", || self.convert(view, renderer))
            .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    }

    /// Draws a part of the document, over `background`.
    ///
    /// # Errors
    /// As [`prepare`](Self::prepare), and if the renderer refuses the size.
    pub fn draw(
        &self,
        view: &View,
        renderer: &Renderer,
        background: Color,
    ) -> Result<(Picture, Vec<Warning>), SvgError> {
        let prepared = self.prepare(view, renderer)?;
        let picture = renderer.draw(&prepared.drawing, prepared.width, prepared.height, background)?;
        Ok((picture, prepared.warnings))
    }

    fn convert(&self, view: &View, renderer: &Renderer) -> Result<Prepared, SvgError> {
        let node = match &view.id {
            Some(id) => Some(self.tree.node_by_id(id).ok_or_else(|| SvgError::UnknownId(id.clone()))?),
            None => None,
        };
        let area = self.area(view, node)?;
        let fitted = view.size.fit(area).ok_or(SvgError::Empty)?;
        let Fitted { width, height, pixels_from_user } = fitted;
        let canvas = PixelRect { x: 0, y: 0, width, height };
        let mut converter = Converter::new(renderer, &self.limits, &self.triangles, canvas);
        let mut drawing = Drawing::new();
        match node {
            None => {
                let root = self.tree.root();
                converter.group(&mut drawing, root, pixels_from_user * transform(root.transform()));
            }
            Some(usvg::Node::Group(group)) => {
                converter.group(&mut drawing, group, pixels_from_user * transform(group.abs_transform()));
            }
            Some(node) => converter.node(&mut drawing, node, pixels_from_user * transform(node.abs_transform())),
        }
        renderer.in_time()?;
        let mut warnings = self.warnings.clone();
        warnings.extend(&converter.warnings);
        Ok(Prepared { drawing, width, height, warnings: warnings.into_list() })
    }

    /// The rectangle of user space that is drawn.
    fn area(&self, view: &View, node: Option<&usvg::Node>) -> Result<[f64; 4], SvgError> {
        let numbers = |rect: usvg::NonZeroRect| super::bounds::numbers(rect);
        match view.area {
            Area::Page => Ok([0.0, 0.0, f64::from(self.size()[0]), f64::from(self.size()[1])]),
            Area::Rect(rect) => Ok(rect.map(f64::from)),
            Area::Drawing => match node {
                Some(node) => node.abs_layer_bounding_box().map(numbers).ok_or(SvgError::Empty),
                None if self.tree.root().has_children() => Ok(numbers(self.tree.root().abs_layer_bounding_box())),
                None => Err(SvgError::Empty),
            },
        }
    }
}

impl std::fmt::Debug for Document {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "Document({}x{})", self.size()[0], self.size()[1])
    }
}

/// The text of a file, plain or compressed with gzip.
fn text_of<'a>(bytes: &'a [u8], limits: &Limits) -> Result<Cow<'a, str>, SvgError> {
    let bytes = match bytes {
        [0x1f, 0x8b, ..] => Cow::Owned(unpack(bytes, limits.max_bytes)?),
        _ => Cow::Borrowed(bytes),
    };
    if bytes.len() > limits.max_bytes {
        return Err(SvgError::LimitExceeded(format!("the file has over {} bytes", limits.max_bytes)));
    }
    let text = match bytes {
        Cow::Borrowed(bytes) => std::str::from_utf8(bytes).map(Cow::Borrowed).ok(),
        Cow::Owned(bytes) => String::from_utf8(bytes).map(Cow::Owned).ok(),
    };
    text.ok_or_else(|| SvgError::Malformed("it is not UTF-8 text".to_owned()))
}

/// An error for a file that is over the limits, as far as can be told before it is read.
pub(super) fn check_size(bytes: &[u8], limits: &Limits) -> Result<(), SvgError> {
    let text = text_of(bytes, limits)?;
    let xml = parse_xml(&text, limits)?;
    check_depth(&xml, limits)?;
    check_style(&xml, limits)
}

fn unpack(bytes: &[u8], max_bytes: usize) -> Result<Vec<u8>, SvgError> {
    use std::io::Read;
    let mut unpacked = Vec::new();
    let limit = u64::try_from(max_bytes).unwrap_or(u64::MAX).saturating_add(1);
    flate2::read::MultiGzDecoder::new(bytes)
        .take(limit)
        .read_to_end(&mut unpacked)
        .map_err(|error| SvgError::Malformed(format!("its gzip compression is broken: {error}")))?;
    Ok(unpacked)
}

fn parse_text(text: &str, options: &Options) -> Result<Document, SvgError> {
    let limits = &options.limits;
    let in_time = || if options.deadline.is_over() { Err(SvgError::TimeOver) } else { Ok(()) };
    in_time()?;
    let original = parse_xml(text, limits)?;
    in_time()?;
    check_depth(&original, limits)?;
    check_style(&original, limits)?;
    let mut warnings = Warnings::default();
    let rewritten = rewrite(&original, text, options, &mut warnings);
    let changed;
    let (xml, triangles) = match &rewritten {
        Some((text, triangles)) => {
            changed = parse_xml(text, limits)?;
            (&changed, triangles.clone())
        }
        None => (&original, Triangles::default()),
    };
    warn_of_elements(xml, &mut warnings);
    in_time()?;

    let missing = SharedWarnings::default();
    let mut usvg_options = usvg::Options {
        resources_dir: options.folder.clone(),
        dpi: options.dpi.clamp(10.0, 4000.0),
        languages: options.languages.clone(),
        font_family: options.fonts.default_family.clone().unwrap_or_else(|| "Times New Roman".to_owned()),
        font_resolver: watched_fonts(&missing),
        image_href_resolver: watched_pictures(options, &missing),
        ..usvg::Options::default()
    };
    if may_hold_text(xml) {
        let (fonts, unreadable) = options.fonts.load();
        usvg_options.fontdb = Arc::new(fonts);
        unreadable.into_iter().for_each(|message| warnings.add(message));
    }
    in_time()?;
    let tree = usvg::Tree::from_xmltree(xml, &usvg_options).map_err(|error| match error {
        usvg::Error::ElementsLimitReached | usvg::Error::ParsingFailed(roxmltree::Error::NodesLimitReached) => {
            too_many_elements(limits)
        }
        error => SvgError::Malformed(error.to_string()),
    })?;
    drop(usvg_options);
    warnings.extend(&missing.into_inner());
    in_time()?;
    Ok(Document { tree, limits: limits.clone(), warnings, triangles })
}

fn parse_xml<'a>(text: &'a str, limits: &Limits) -> Result<roxmltree::Document<'a>, SvgError> {
    let nodes_limit = u32::try_from(limits.max_elements.saturating_mul(4)).unwrap_or(u32::MAX);
    let options = roxmltree::ParsingOptions { allow_dtd: true, nodes_limit, ..Default::default() };
    roxmltree::Document::parse_with_options(text, options).map_err(|error| match error {
        roxmltree::Error::NodesLimitReached => too_many_elements(limits),
        error => SvgError::Malformed(error.to_string()),
    })
}

fn too_many_elements(limits: &Limits) -> SvgError {
    SvgError::LimitExceeded(format!("the file has over {} elements, copies by 'use' included", limits.max_elements))
}

/// An error where elements are nested deeper than the limit.
fn check_depth(xml: &roxmltree::Document<'_>, limits: &Limits) -> Result<(), SvgError> {
    let mut depth = 0usize;
    let mut open: Vec<roxmltree::NodeId> = Vec::new();
    for node in xml.descendants().filter(roxmltree::Node::is_element) {
        let parent = node.parent().map(|parent| parent.id());
        while open.last().is_some_and(|last| Some(*last) != parent) {
            open.pop();
        }
        open.push(node.id());
        depth = depth.max(open.len());
    }
    if depth > limits.max_element_depth {
        let most = limits.max_element_depth;
        return Err(SvgError::LimitExceeded(format!("{depth} elements are inside each other; {most} are allowed")));
    }
    Ok(())
}

/// An error where so many rules are tried on so many elements that reading would hardly end.
fn check_style(xml: &roxmltree::Document<'_>, limits: &Limits) -> Result<(), SvgError> {
    let (mut elements, mut selectors) = (0u64, 0u64);
    for node in xml.descendants().filter(roxmltree::Node::is_element) {
        elements += 1;
        if node.tag_name().name() == "style" {
            let text = node.descendants().filter_map(|node| node.text().filter(|_| node.is_text()));
            selectors = selectors.saturating_add(text.map(count_selectors).sum());
        }
    }
    if elements.saturating_mul(selectors) > limits.max_style_steps {
        return Err(SvgError::LimitExceeded(format!(
            "the file has {elements} elements and {selectors} selectors; {} pairs are allowed",
            limits.max_style_steps
        )));
    }
    Ok(())
}

/// Each rule has one selector, and one more for each comma before its declarations.
fn count_selectors(style: &str) -> u64 {
    let (mut count, mut is_inside) = (0, false);
    for byte in style.bytes() {
        match byte {
            b'{' => (count, is_inside) = (count + 1, true),
            b'}' => is_inside = false,
            b',' if !is_inside => count += 1,
            _ => {}
        }
    }
    count
}

/// Fonts are loaded only for files that can hold text, themselves or in an embedded file.
fn may_hold_text(xml: &roxmltree::Document<'_>) -> bool {
    xml.descendants().any(|node| matches!(node.tag_name().name(), "text" | "image" | "feImage"))
}

/// Names the elements that are never drawn.
fn warn_of_elements(xml: &roxmltree::Document<'_>, warnings: &mut Warnings) {
    for node in xml.descendants().filter(roxmltree::Node::is_element) {
        let name = node.tag_name().name();
        match name {
            "animate" | "animateColor" | "animateMotion" | "animateTransform" | "set" | "discard" => {
                warnings.add(format!("'{name}' is not run: animations are drawn as if they did not exist"));
            }
            "script" => warnings.add("'script' is not run"),
            "foreignObject" | "audio" | "video" | "canvas" | "iframe" | "mesh" | "meshgradient" | "hatch"
            | "hatchpath" | "solidcolor" | "font" | "font-face" | "altGlyph" | "glyphRef" | "color-profile"
            | "cursor" => warnings.add(format!("'{name}' is not drawn")),
            _ => {}
        }
    }
}

/// The name of the thread that files are read on. A program that shows panics may want to leave out those of this one:
/// they are turned into errors.
pub const READER_THREAD: &str = "trigon-svg-reader";

/// Runs `work` where recursion as deep as the limits allow has room; `Err` holds its panic.
#[cfg(not(target_family = "wasm"))]
fn on_a_large_stack<T: Send>(
    name: &str,
    work: impl FnOnce() -> Result<T, SvgError> + Send,
) -> std::thread::Result<Result<T, SvgError>> {
    /// Reserved, not used, by most files.
    const STACK_BYTES: usize = 256 << 20;
    std::thread::scope(|scope| {
        let builder = std::thread::Builder::new().name(name.to_owned()).stack_size(STACK_BYTES);
        match builder.spawn_scoped(scope, work) {
            Ok(thread) => thread.join(),
            Err(error) => Ok(Err(SvgError::LimitExceeded(format!("a thread cannot be started: {error}")))),
        }
    })
}

#[cfg(target_family = "wasm")]
fn on_a_large_stack<T: Send>(
    _name: &str,
    work: impl FnOnce() -> Result<T, SvgError> + Send,
) -> std::thread::Result<Result<T, SvgError>> {
    Ok(work())
}
