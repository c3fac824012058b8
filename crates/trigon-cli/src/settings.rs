//! Options about samples, surfaces and textures, as the settings of the scene renderer.

use crate::failure::Failure;
use crate::options::{
    ColorSpaceChoice, CullChoice, Given, InterpolationChoice, LevelFilterChoice, PatternChoice, PixelFilterChoice,
    PlaceChoice, RateChoice, RenderOptions, ShadingOptions, WireframeChoice, WrapChoice,
};
use crate::values::Real;
use trigon::geometry::Cull;
use trigon::pipeline::Outputs;
use trigon::shade::Interpolation;
use trigon::shade::texture::{LevelFilter, PixelFilter, Wrap};
use trigon::target::{ColorSpace, SamplePattern, ShadingRate};
use trigon_scene::render::course::games101::{Homework3, Relief};
use trigon_scene::render::{RenderSettings, ShaderKind, TextureSampling, Wireframe};
use trigon_svg::canvas::ImageFilter;

/// The settings that the options ask for.
pub(crate) fn render_settings(options: &RenderOptions, outputs: Outputs) -> Result<RenderSettings, Failure> {
    let (picture, shading) = (&options.picture, &options.shading);
    let mut settings = RenderSettings {
        samples: sample_pattern(picture.pattern, picture.samples)?,
        shading: match picture.shading {
            RateChoice::Pixel => ShadingRate::Pixel,
            RateChoice::Sample => ShadingRate::Sample,
        },
        shift_px: match shading.sample_at {
            PlaceChoice::Middle => [0.0; 2],
            PlaceChoice::LowerLeft => [0.5; 2],
            PlaceChoice::UpperLeft => [0.5, -0.5],
        }
        .map(|shift: f32| shift * f32::from(picture.enlargement)),
        interpolation: match shading.interpolation {
            InterpolationChoice::Perspective => Interpolation::Perspective,
            InterpolationChoice::Affine => Interpolation::Affine,
        },
        color_space: match shading.color_space {
            ColorSpaceChoice::Linear => ColorSpace::Linear,
            ColorSpaceChoice::Encoded => ColorSpace::Encoded,
        },
        outputs,
        shader: shading.shader,
        background: match picture.background {
            Some(color) => color.to_linear_premultiplied(),
            None => default_background(shading.shader),
        },
        cull: match shading.cull {
            CullChoice::None => Cull::None,
            CullChoice::Back => Cull::Back,
            CullChoice::Front => Cull::Front,
        },
        sampling: texture_sampling(options),
        line_width_px: shading.line_width.to_f32(),
        point_size_px: shading.point_size.to_f32(),
        shadows: options.effects.shadows(),
        ambient_occlusion: options.effects.ambient_occlusion(),
        toon_levels: options.effects.toon_levels,
        relief: relief(shading)?,
        outline: options.effects.outline(),
        ..RenderSettings::new(picture.size.width, picture.size.height)
    };
    settings.wireframe = shading.wireframe.map(|mode| wireframe(mode, &settings));
    Ok(settings)
}

/// The relief of the shaders that have one; the others would not show what is asked for.
fn relief(options: &ShadingOptions) -> Result<Relief, Failure> {
    let has_relief = matches!(options.shader, ShaderKind::Games101(shading) if shading.has_relief());
    for (name, value) in [("--bump-height", options.bump_height), ("--bump-scale", options.bump_scale)] {
        if value.is_some() && !has_relief {
            let message = format!(
                "{name} is about the shaders games101-bump and games101-displacement; the shader is {}",
                options.shader
            );
            return Err(Failure::usage(message));
        }
    }
    let default = Relief::default();
    Ok(Relief {
        height: options.bump_height.map_or(default.height, Real::to_f32),
        scale: options.bump_scale.map_or(default.scale, Real::to_f32),
    })
}

/// Light grey behind surfaces as they look, black behind colours that stand for numbers.
fn default_background(shader: ShaderKind) -> [f32; 4] {
    match shader {
        ShaderKind::BlinnPhong
        | ShaderKind::Flat
        | ShaderKind::Toon
        | ShaderKind::Unlit
        | ShaderKind::Tinyrenderer(_)
        | ShaderKind::Games101(Homework3::Texture | Homework3::Phong | Homework3::Displacement) => {
            RenderSettings::DEFAULT_BACKGROUND
        }
        _ => [0.0, 0.0, 0.0, 1.0],
    }
}

/// The pattern of that many samples.
pub(crate) fn sample_pattern(pattern: PatternChoice, samples: u32) -> Result<SamplePattern, Failure> {
    let (found, other) = match pattern {
        PatternChoice::Standard => (SamplePattern::standard(samples), SamplePattern::grid(samples).map(|_| "grid")),
        PatternChoice::Grid => (SamplePattern::grid(samples), SamplePattern::standard(samples).map(|_| "standard")),
    };
    found.ok_or_else(|| {
        let (name, counts) = match pattern {
            PatternChoice::Standard => ("standard", "1, 2, 4, 8 or 16"),
            PatternChoice::Grid => ("grid", "1, 4, 9 or 16"),
        };
        let instead = other.map_or(String::new(), |other| format!(", or add --pattern {other}"));
        Failure::usage(format!("--samples {samples}: the {name} pattern has {counts}; write one of these{instead}"))
    })
}

/// How textures of triangles in SVG pictures are read: smoothly, but for what the user wrote.
pub(crate) fn triangle_filter(options: &RenderOptions, given: Given) -> ImageFilter {
    let (written, usual) = (texture_sampling(options), ImageFilter::SMOOTH);
    ImageFilter {
        pixel: if given.pixel_filter { written.pixel } else { usual.pixel },
        level: if given.level_filter { written.level } else { usual.level },
        max_anisotropy: if given.anisotropy { written.max_anisotropy } else { usual.max_anisotropy },
        wrap: if given.wrap { written.wrap.unwrap_or(Wrap::Repeat) } else { usual.wrap },
    }
}

fn texture_sampling(options: &RenderOptions) -> TextureSampling {
    let textures = &options.textures;
    TextureSampling {
        pixel: match textures.pixel_filter {
            PixelFilterChoice::Nearest => PixelFilter::Nearest,
            PixelFilterChoice::Bilinear => PixelFilter::Bilinear,
        },
        level: match textures.level_filter {
            LevelFilterChoice::Zero => LevelFilter::Zero,
            LevelFilterChoice::Nearest => LevelFilter::Nearest,
            LevelFilterChoice::Linear => LevelFilter::Linear,
        },
        max_anisotropy: textures.anisotropy,
        wrap: match textures.wrap {
            WrapChoice::Repeat => None,
            WrapChoice::Mirror => Some(Wrap::Mirror),
            WrapChoice::Clamp => Some(Wrap::ClampToEdge),
            WrapChoice::Border => Some(Wrap::Border([0.0; 4])),
        },
        ..TextureSampling::default()
    }
}

/// Edges over surfaces are dark; alone, they stand out before the background.
fn wireframe(mode: WireframeChoice, settings: &RenderSettings) -> Wireframe {
    let surface = mode == WireframeChoice::Over;
    let [r, g, b] = settings.ink();
    Wireframe {
        color: if surface { Wireframe::default().color } else { [r, g, b, 1.0] },
        width_px: settings.line_width_px,
        surface,
        hidden_lines: mode == WireframeChoice::Only,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sample_counts_are_those_of_the_pattern() {
        assert_eq!(sample_pattern(PatternChoice::Standard, 8).unwrap().count(), 8);
        assert_eq!(sample_pattern(PatternChoice::Grid, 9).unwrap().count(), 9);
        let message = |pattern, samples| match sample_pattern(pattern, samples) {
            Err(Failure::Usage(message)) => message,
            other => panic!("{other:?}"),
        };
        assert!(message(PatternChoice::Standard, 9).contains("add --pattern grid"));
        assert!(message(PatternChoice::Grid, 8).contains("1, 4, 9 or 16"));
        assert!(!message(PatternChoice::Grid, 3).contains("add"));
    }
}
