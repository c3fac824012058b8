//! An SVG file drawn as SVG says.

use super::drawing::{Drawn, failure, folder_of, read};
use crate::failure::Failure;
use crate::options::{Given, PatternChoice, RenderCommandOptions, SvgOptions};
use crate::values::PageArea;
use crate::{machine, settings};
use std::path::Path;
use std::time::Instant;
use trigon_image::Color;
use trigon_svg::canvas::Renderer;
use trigon_svg::svg::{Area, Document, FontOptions, Options, Size, View};

/// Reads and draws the file.
pub(super) fn draw(options: &RenderCommandOptions, given: Given, max_bytes: u64) -> Result<Drawn, Failure> {
    let path = &options.render.models[0];
    let view = view(options, given);
    let renderer = renderer(options, given)?;
    let started = Instant::now();
    let read_options = read_options(&options.svg, path, max_bytes);
    let document = Document::parse(&read(path, max_bytes)?, &read_options).map_err(|error| failure(path, &error))?;
    let load = started.elapsed();
    let background = options.render.picture.background.unwrap_or(Color::TRANSPARENT);
    let (picture, warnings) = document.draw(&view, &renderer, background).map_err(|error| failure(path, &error))?;
    let image = picture.to_image();
    Ok(Drawn {
        image,
        warnings: warnings.iter().map(ToString::to_string).collect(),
        samples: renderer.pattern.to_string(),
        simd: renderer.simd.name(),
        threads: renderer.threads,
        load,
        draw: started.elapsed().saturating_sub(load),
    })
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

fn read_options(svg: &SvgOptions, path: &Path, max_bytes: u64) -> Options {
    let mut options = Options { folder: Some(folder_of(path)), dpi: svg.dpi.to_f32(), ..Options::default() };
    if !svg.languages.is_empty() {
        options.languages.clone_from(&svg.languages);
    }
    options.fonts = FontOptions {
        use_system_fonts: !svg.no_system_fonts,
        folders: svg.font_folders.clone(),
        files: svg.font_files.clone(),
        default_family: svg.font_family.clone(),
        serif: svg.serif_family.clone(),
        sans_serif: svg.sans_serif_family.clone(),
        cursive: svg.cursive_family.clone(),
        fantasy: svg.fantasy_family.clone(),
        monospace: svg.monospace_family.clone(),
    };
    options.limits.max_bytes = options.limits.max_bytes.min(usize::try_from(max_bytes).unwrap_or(usize::MAX));
    options
}
