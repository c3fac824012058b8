//! `--preset cs184`: a file drawn as the program of Berkeley's course does.

use super::drawing::{Drawn, failure, folder_of, read};
use crate::failure::Failure;
use crate::options::{Given, LevelFilterChoice, NearestTexel, PixelFilterChoice, RenderCommandOptions};
use crate::{machine, warnings};
use std::time::Instant;
use trigon_svg::cs184::{LevelSampling, NearestRule, Options, PixelSampling, draw as draw_picture};

/// The size of the course's window.
const WINDOW: (u32, u32) = (960, 640);

/// Reads and draws the file.
pub(super) fn draw(options: &RenderCommandOptions, given: Given, max_bytes: u64) -> Result<Drawn, Failure> {
    let (path, picture) = (&options.render.models[0], &options.render.picture);
    if picture.backdrop.is_some() || picture.overlay.is_some() {
        return Err(Failure::usage("--preset cs184 draws on a white page: leave out --backdrop and --overlay"));
    }
    if given.anisotropy || given.wrap {
        return Err(Failure::usage(
            "--preset cs184 reads textures as the course does: leave out --anisotropy and --wrap",
        ));
    }
    let machine = machine::renderer_options(&options.render.machine)?;
    let mut course = course_options(options, given)?;
    course.folder = Some(folder_of(path));
    course.threads = machine.threads;
    let started = Instant::now();
    let bytes = read(path, max_bytes)?;
    let load = started.elapsed();
    let (image, warnings) = draw_picture(&bytes, &course).map_err(|error| failure(path, &error))?;
    Ok(Drawn {
        image,
        warnings: warnings::about(path, warnings).collect(),
        samples: format!("grid {}", course.samples_per_axis * course.samples_per_axis),
        simd: machine.simd.name(),
        threads: machine.threads,
        load,
        draw: started.elapsed().saturating_sub(load),
    })
}

/// What was not chosen is as in the course: its window, one sample, nearest texel, level zero.
fn course_options(options: &RenderCommandOptions, given: Given) -> Result<Options, Failure> {
    let (picture, textures) = (&options.render.picture, &options.render.textures);
    let (width, height) = if given.size { (picture.size.width, picture.size.height) } else { WINDOW };
    let view = options.svg.view.map(|view| view.0);
    if view.is_some_and(|[_, _, span]| span <= 0.0) {
        return Err(Failure::usage("--view: SPAN must be above zero"));
    }
    Ok(Options {
        samples_per_axis: match picture.samples {
            _ if !given.samples => 1,
            1 => 1,
            4 => 2,
            9 => 3,
            16 => 4,
            other => return Err(Failure::usage(format!("--samples {other}: the course has 1, 4, 9 or 16"))),
        },
        pixel: match textures.pixel_filter {
            PixelFilterChoice::Bilinear if given.pixel_filter => PixelSampling::Bilinear,
            _ => PixelSampling::Nearest,
        },
        level: match textures.level_filter {
            LevelFilterChoice::Linear if given.level_filter => LevelSampling::Linear,
            LevelFilterChoice::Nearest => LevelSampling::Nearest,
            _ => LevelSampling::Zero,
        },
        nearest: match options.svg.nearest_texel {
            NearestTexel::Holding => NearestRule::Holding,
            NearestTexel::Course => NearestRule::Course,
        },
        view,
        enlargement: picture.enlargement.into(),
        ..Options::new(width, height)
    })
}
