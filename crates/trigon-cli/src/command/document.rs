//! An SVG file drawn as SVG says: read once, drawn as often as one likes.

use super::drawing::{Drawn, failure, folder_of, read};
use crate::failure::Failure;
use crate::options::{Given, PatternChoice, RenderCommandOptions, RenderOptions};
use crate::pictures::cover;
use crate::values::PageArea;
use crate::{machine, settings, warnings};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};
use trigon_image::Color;
use trigon_svg::canvas::{Picture, Renderer};
use trigon_svg::svg::{Area, Document, Options, Prepared, Size, SvgError, View};

/// A file that was read.
struct Source {
    path: PathBuf,
    options: Options,
    document: Document,
    /// How long it took to read.
    load: Duration,
}

/// The file that was read last; none at first. It is read again only where the options of reading differ.
#[derive(Default)]
pub(crate) struct Reader {
    source: Option<Source>,
}

impl Reader {
    fn open(&mut self, path: &Path, options: Options, max_bytes: u64) -> Result<&Source, Failure> {
        let kept = self.source.take().filter(|source| source.path == path && source.options == options);
        let source = match kept {
            Some(source) => source,
            None => {
                let started = Instant::now();
                let document =
                    Document::parse(&read(path, max_bytes)?, &options).map_err(|error| failure(path, &error))?;
                Source { path: path.to_owned(), options, document, load: started.elapsed() }
            }
        };
        Ok(self.source.insert(source))
    }
}

/// Reads the file, unless `reader` has it, and draws it.
pub(super) fn draw(
    reader: &mut Reader,
    options: &RenderCommandOptions,
    given: Given,
    max_bytes: u64,
) -> Result<Drawn, Failure> {
    let path = &options.render.models[0];
    let view = view(options, given);
    let renderer = renderer(options, given)?;
    let mut read_options = options.render.svg_input.to_options(Some(folder_of(path)), max_bytes);
    read_options.triangle_filter = settings::triangle_filter(&options.render, given);
    let source = reader.open(path, read_options, max_bytes)?;
    let started = Instant::now();
    let prepared = source.document.prepare(&view, &renderer).map_err(|error| failure(path, &error))?;
    let mut warnings: Vec<String> = warnings::about(path, &prepared.warnings).collect();
    let picture = draw_layers(&options.render, &prepared, &renderer, &mut warnings)?;
    let image = picture.to_image();
    Ok(Drawn {
        image,
        warnings,
        samples: renderer.pattern.to_string(),
        simd: renderer.simd.name(),
        threads: renderer.threads,
        load: source.load,
        draw: started.elapsed(),
    })
}

/// The document between the pictures behind and before it, whose warnings are added.
fn draw_layers(
    options: &RenderOptions,
    prepared: &Prepared,
    renderer: &Renderer,
    warnings: &mut Vec<String>,
) -> Result<Picture, Failure> {
    let refused = |error| failure(&options.models[0], &SvgError::Draw(error));
    let background = options.picture.background.unwrap_or(Color::TRANSPARENT);
    let size = (prepared.width, prepared.height);
    let mut picture = match &options.picture.backdrop {
        None => renderer.draw(&prepared.drawing, size.0, size.1, background).map_err(refused)?,
        Some(path) => {
            let backdrop = cover(path, size, options, renderer, warnings)?;
            let mut picture = renderer.draw(&backdrop, size.0, size.1, background).map_err(refused)?;
            renderer.draw_over(&prepared.drawing, &mut picture).map_err(refused)?;
            picture
        }
    };
    if let Some(path) = &options.picture.overlay {
        let overlay = cover(path, size, options, renderer, warnings)?;
        renderer.draw_over(&overlay, &mut picture).map_err(refused)?;
    }
    Ok(picture)
}

/// 16 samples on a grid unless the user chose.
fn renderer(options: &RenderCommandOptions, given: Given) -> Result<Renderer, Failure> {
    let picture = &options.render.picture;
    let samples = if given.samples { picture.samples } else { 16 };
    let pattern = if given.pattern { picture.pattern } else { PatternChoice::Grid };
    let machine = machine::renderer_options(&options.render.machine)?;
    Ok(Renderer {
        pattern: settings::sample_pattern(pattern, samples)?,
        threads: machine.threads,
        simd: machine.simd,
        ..Renderer::new()
    })
}

fn view(options: &RenderCommandOptions, given: Given) -> View {
    let (svg, picture) = (&options.svg, &options.render.picture);
    let size = match (svg.width, svg.height) {
        (Some(width), _) => Size::Width(width),
        (None, Some(height)) => Size::Height(height),
        _ if given.size => Size::Inside(picture.size.width, picture.size.height),
        _ => Size::Zoom(options.render.view.zoom.to_f32()),
    };
    let area = match svg.export_area {
        Some(PageArea::Page) => Area::Page,
        Some(PageArea::Drawing) => Area::Drawing,
        Some(PageArea::Rect(rect)) => Area::Rect(rect),
        None if svg.export_id.is_some() => Area::Drawing,
        None => Area::Page,
    };
    View { size, area, id: svg.export_id.clone() }
}
