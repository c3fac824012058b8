//! Gradients: the place along the gradient of each pixel, and the colour there.
//!
//! In: a gradient in its own space and the map to it from pixels. Out: premultiplied pixels. Sixteen at a time; the
//! colour is found by going through the stops, exactly, without a table: hard stops stay hard at any size.

use crate::canvas::{GradientStop, LinearGradient, RadialGradient, Spread, Transform};
use crate::engine::color::unit;
use trigon::lanes::{F32, LANES, Lanes, U32};

/// A gradient, ready to be evaluated.
pub(crate) struct Gradient {
    kind: Kind,
    /// Gradient space from pixels: x is `[0] * x + [1] * y + [2]` and so on.
    x: [f32; 3],
    y: [f32; 3],
    spread: Spread,
    ramp: Vec<Segment>,
    is_opaque: bool,
}

/// How a point gives a place.
enum Kind {
    /// Its x.
    Linear,
    /// Its distance from the origin.
    Circle,
    /// The larger t of the circle through it, with centre (t, 0) and radius `r0 + t * dr`, not negative.
    Cone { r0: f32, dr: f32 },
    /// As `Cone`, but both circles have the same centre: t is (distance - r0) / dr.
    Rings { r0: f32, dr: f32 },
}

/// The colours from `start` on: `base + t * step`, straight, red, green, blue, alpha in 0..=1.
struct Segment {
    start: f32,
    base: [f32; 4],
    step: [f32; 4],
}

impl Gradient {
    /// `None` if nothing is drawn; the colour alone if it is the same everywhere.
    pub(crate) fn linear(gradient: &LinearGradient, from_path: &Transform, opacity: f32) -> Option<Result<Self, u32>> {
        let last = gradient.stops.last()?;
        let [x0, y0] = gradient.start.map(f64::from);
        let [x1, y1] = gradient.end.map(f64::from);
        let (dx, dy) = (x1 - x0, y1 - y0);
        // Unit space: the start at the origin, the end at (1, 0).
        let from_unit = Transform::new(dx, dy, -dy, dx, x0, y0);
        let Some(to_unit) =
            (*from_path * gradient.transform * from_unit).inverse().filter(|_| gradient.stops.len() > 1)
        else {
            return Some(Err(solid(last, opacity)));
        };
        Some(Ok(Self::new(Kind::Linear, &to_unit, &gradient.stops, gradient.spread, opacity)))
    }

    /// `None` if nothing is drawn; the colour alone if it is the same everywhere.
    pub(crate) fn radial(gradient: &RadialGradient, from_path: &Transform, opacity: f32) -> Option<Result<Self, u32>> {
        let last = gradient.stops.last()?;
        let radius = f64::from(gradient.radius);
        if gradient.stops.len() < 2 || radius.is_nan() || radius <= 0.0 {
            return Some(Err(solid(last, opacity)));
        }
        let [cx, cy] = gradient.center.map(f64::from);
        let [fx, fy] = gradient.focus.map(f64::from);
        let focal_radius = f64::from(gradient.focal_radius).max(0.0);
        let (dx, dy) = (cx - fx, cy - fy);
        let distance = (dx * dx + dy * dy).sqrt();
        // Unit space: the focus at the origin; the centre at (1, 0), or a unit of `radius` if both are one.
        let is_concentric = distance <= radius * 1e-6;
        let (kind, from_unit) = if is_concentric {
            let kind = if focal_radius == 0.0 {
                Kind::Circle
            } else {
                Kind::Rings { r0: (focal_radius / radius) as f32, dr: (1.0 - focal_radius / radius) as f32 }
            };
            (kind, Transform::new(radius, 0.0, 0.0, radius, fx, fy))
        } else {
            let (r0, r1) = (focal_radius / distance, radius / distance);
            (Kind::Cone { r0: r0 as f32, dr: (r1 - r0) as f32 }, Transform::new(dx, dy, -dy, dx, fx, fy))
        };
        let Some(to_unit) = (*from_path * gradient.transform * from_unit).inverse() else {
            return Some(Err(solid(last, opacity)));
        };
        Some(Ok(Self::new(kind, &to_unit, &gradient.stops, gradient.spread, opacity)))
    }

    fn new(kind: Kind, to_unit: &Transform, stops: &[GradientStop], spread: Spread, opacity: f32) -> Self {
        let (ramp, is_solid) = ramp(stops, opacity);
        // Circles that do not hold each other leave pixels without a colour.
        let covers_all = !matches!(kind, Kind::Cone { .. } | Kind::Rings { .. });
        Self {
            kind,
            x: [to_unit.a as f32, to_unit.c as f32, to_unit.e as f32],
            y: [to_unit.b as f32, to_unit.d as f32, to_unit.f as f32],
            spread,
            ramp,
            is_opaque: is_solid && covers_all,
        }
    }

    /// True if every pixel is opaque.
    pub(crate) fn is_opaque(&self) -> bool {
        self.is_opaque
    }

    /// The colours of the pixels of row `y` from column `x` on.
    #[inline(always)]
    pub(crate) fn row<L: Lanes>(&self, l: L, x: u32, y: u32, out: &mut [u32]) {
        let center_y = y as f32 + 0.5;
        let (chunks, rest) = out.as_chunks_mut::<LANES>();
        let mut column = x;
        for chunk in chunks {
            *chunk = self.pixels(l, column, center_y).to_array();
            column += LANES as u32;
        }
        if !rest.is_empty() {
            let last = self.pixels(l, column, center_y).to_array();
            rest.copy_from_slice(&last[..rest.len()]);
        }
    }

    /// Sixteen pixels.
    #[inline(always)]
    fn pixels<L: Lanes>(&self, l: L, column: u32, center_y: f32) -> U32<L> {
        let center_x = l.lane_numbers() + (column as f32 + 0.5);
        let x = center_x * self.x[0] + (self.x[1] * center_y + self.x[2]);
        let y = center_x * self.y[0] + (self.y[1] * center_y + self.y[2]);
        let (t, drawn) = match self.kind {
            Kind::Linear => (x, l.mask(true)),
            Kind::Circle => ((x * x + y * y).sqrt(), l.mask(true)),
            Kind::Rings { r0, dr } => (((x * x + y * y).sqrt() - r0) / dr, l.mask(dr != 0.0)),
            Kind::Cone { r0, dr } => cone(l, x, y, r0, dr),
        };
        let t = match self.spread {
            Spread::Pad => t.saturate(),
            Spread::Repeat => t - t.floor(),
            Spread::Reflect => {
                let period = t - (t * 0.5).floor() * 2.0;
                period.min(l.f32(2.0) - period)
            }
        };
        drawn.select(self.color(l, t), l.u32(0))
    }

    /// The premultiplied colours at places in 0..=1.
    #[inline(always)]
    fn color<L: Lanes>(&self, l: L, t: F32<L>) -> U32<L> {
        let first = &self.ramp[0];
        let mut channels = [l.f32(0.0); 4];
        for c in 0..4 {
            channels[c] = t * first.step[c] + first.base[c];
        }
        for segment in &self.ramp[1..] {
            let from_here = t.ge(segment.start);
            if !from_here.any() {
                break;
            }
            for c in 0..4 {
                channels[c] = from_here.select(t * segment.step[c] + segment.base[c], channels[c]);
            }
        }
        let [r, g, b, a] = channels;
        let a = a.saturate();
        let (red, green, blue) = (r.saturate() * a, g.saturate() * a, b.saturate() * a);
        to_byte(red) | (to_byte(green) << 8) | (to_byte(blue) << 16) | (to_byte(a) << 24)
    }
}

/// 0..=1 to 0..=255, halves up.
#[inline(always)]
fn to_byte<L: Lanes>(value: F32<L>) -> U32<L> {
    (value * 255.0 + 0.5).to_i32_within(0.0, 255.0).as_u32()
}

/// The place on a cone of circles, and where there is one.
///
/// |p - (t, 0)| = r0 + t dr gives a t^2 - 2 b t + c = 0 with a = 1 - dr^2, b = x + r0 dr, c = x^2 + y^2 - r0^2; the larger
/// solution whose radius is not negative counts.
#[inline(always)]
fn cone<L: Lanes>(l: L, x: F32<L>, y: F32<L>, r0: f32, dr: f32) -> (F32<L>, trigon::lanes::Mask<L>) {
    let a = 1.0 - dr * dr;
    let b = x + r0 * dr;
    let c = (x * x + y * y) - r0 * r0;
    if a.abs() < 1e-6 {
        let t = c / (b * 2.0);
        let drawn = (t * dr + r0).ge(0.0);
        return (drawn.select(t, l.f32(0.0)), drawn);
    }
    let discriminant = b * b - c * a;
    let root = discriminant.max(0.0).sqrt();
    let (one, other) = ((b + root) / a, (b - root) / a);
    let (larger, smaller) = (one.max(other), one.min(other));
    let larger_counts = (larger * dr + r0).ge(0.0);
    let t = larger_counts.select(larger, smaller);
    let drawn = discriminant.ge(0.0) & (t * dr + r0).ge(0.0);
    (drawn.select(t, l.f32(0.0)), drawn)
}

/// The colour of one stop, premultiplied.
fn solid(stop: &GradientStop, opacity: f32) -> u32 {
    crate::engine::color::premultiplied(stop.color, unit(stop.opacity) * unit(opacity))
}

/// The segments between stops, the first from 0 on, and whether all colours are opaque.
fn ramp(stops: &[GradientStop], opacity: f32) -> (Vec<Segment>, bool) {
    let color = |stop: &GradientStop| {
        let [r, g, b, a] = [stop.color.r, stop.color.g, stop.color.b, stop.color.a].map(|byte| f32::from(byte) / 255.0);
        [r, g, b, a * (unit(stop.opacity) * unit(opacity))]
    };
    let constant = |start: f32, base: [f32; 4]| Segment { start, base, step: [0.0; 4] };
    let mut segments = vec![constant(0.0, color(&stops[0]))];
    let mut last = (unit(stops[0].offset), color(&stops[0]));
    let mut is_opaque = last.1[3] >= 1.0;
    for stop in &stops[1..] {
        let offset = unit(stop.offset);
        let (offset, next) = (if offset > last.0 { offset } else { last.0 }, color(stop));
        if offset > last.0 {
            let step: [f32; 4] = core::array::from_fn(|c| (next[c] - last.1[c]) / (offset - last.0));
            let base: [f32; 4] = core::array::from_fn(|c| last.1[c] - last.0 * step[c]);
            segments.push(Segment { start: last.0, base, step });
        }
        is_opaque &= next[3] >= 1.0;
        last = (offset, next);
    }
    segments.push(constant(last.0, last.1));
    (segments, is_opaque)
}
