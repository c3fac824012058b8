//! `usvg`'s paints and strokes in the canvas's types, but for patterns, which hold drawings.

use trigon_image::Color;

use super::path::transform;
use crate::canvas::{Cap, FillRule, GradientStop, Join, LinearGradient, Paint, RadialGradient, Spread, Stroke};

pub(super) fn color(source: usvg::Color) -> Color {
    Color::rgb(source.red, source.green, source.blue)
}

pub(super) fn fill_rule(source: usvg::FillRule) -> FillRule {
    match source {
        usvg::FillRule::NonZero => FillRule::NonZero,
        usvg::FillRule::EvenOdd => FillRule::EvenOdd,
    }
}

pub(super) fn linear(source: &usvg::LinearGradient) -> Paint {
    LinearGradient {
        start: [source.x1(), source.y1()],
        end: [source.x2(), source.y2()],
        stops: stops(source.stops()),
        spread: spread(source.spread_method()),
        transform: transform(source.transform()),
    }
    .into()
}

pub(super) fn radial(source: &usvg::RadialGradient) -> Paint {
    RadialGradient {
        center: [source.cx(), source.cy()],
        radius: source.r().get(),
        focus: [source.fx(), source.fy()],
        focal_radius: source.fr().get(),
        stops: stops(source.stops()),
        spread: spread(source.spread_method()),
        transform: transform(source.transform()),
    }
    .into()
}

fn stops(source: &[usvg::Stop]) -> Vec<GradientStop> {
    let stop = |stop: &usvg::Stop| GradientStop {
        offset: stop.offset().get(),
        color: color(stop.color()),
        opacity: stop.opacity().get(),
    };
    source.iter().map(stop).collect()
}

fn spread(source: usvg::SpreadMethod) -> Spread {
    match source {
        usvg::SpreadMethod::Pad => Spread::Pad,
        usvg::SpreadMethod::Reflect => Spread::Reflect,
        usvg::SpreadMethod::Repeat => Spread::Repeat,
    }
}

pub(super) fn stroke(source: &usvg::Stroke) -> Stroke {
    let limit = source.miterlimit().get();
    Stroke {
        width: source.width().get(),
        cap: match source.linecap() {
            usvg::LineCap::Butt => Cap::Butt,
            usvg::LineCap::Round => Cap::Round,
            usvg::LineCap::Square => Cap::Square,
        },
        join: match source.linejoin() {
            usvg::LineJoin::Miter => Join::Miter { limit },
            usvg::LineJoin::MiterClip => Join::MiterClip { limit },
            usvg::LineJoin::Round => Join::Round,
            usvg::LineJoin::Bevel => Join::Bevel,
        },
        dashes: source.dasharray().unwrap_or_default().to_vec(),
        dash_offset: source.dashoffset(),
    }
}
