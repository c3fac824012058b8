//! `usvg`'s filter primitives, in user space, as those of [`filter`](crate::filter), in pixels of the filter region.

use usvg::filter::{self as source, Kind};

use super::bounds::{numbers, pixel_rect, to_i32};
use super::convert::Converter;
use crate::canvas::{PixelRect, Transform};
use crate::filter::{
    ColorSpace, Convolution, Edge, Graph, Grid, Input, LUMINANCE_TO_ALPHA, Lamp, Morphology, Operator, Primitive,
    Region, Step, Surface, Transfer, Turbulence, cos_degrees, distant, hue_rotate, saturate,
};

/// Where a filter works: its region in pixels, and how user space lies in it (scaled and moved, never turned).
#[derive(Debug, Clone, Copy)]
pub(super) struct Space {
    pub(super) region: PixelRect,
    pub(super) pixels_from_user: Transform,
}

/// The filter as a graph over pictures of `space.region`.
pub(super) fn graph(converter: &mut Converter<'_>, filter: &source::Filter, space: Space) -> Graph {
    let mut steps: Vec<Step> = Vec::new();
    let mut names: Vec<&str> = Vec::new();
    for primitive in filter.primitives() {
        let planner = Planner { names: &names, space };
        let mut region = planner.region(primitive);
        if let Kind::Offset(offset) = primitive.kind()
            && let Input::Step(read) = planner.input(offset.input())
        {
            // feOffset takes its region from what it reads.
            region = steps[read].region;
        }
        steps.push(Step {
            primitive: planner.primitive(converter, primitive, region),
            space: color_space(primitive.color_interpolation()),
            region,
            is_clipped: !matches!(primitive.kind(), Kind::Offset(_)),
        });
        names.push(primitive.result());
    }
    Graph { steps }
}

/// How far, along x and y in pixels, a pixel of the result can depend on pixels of the source; `None` for any distance.
pub(super) fn reach(filter: &source::Filter, pixels_from_user: &Transform) -> Option<[f64; 2]> {
    let [scale_x, scale_y] = pixels_from_user.axis_scales();
    let mut total = [0.0, 0.0];
    for primitive in filter.primitives() {
        let [x, y] = match primitive.kind() {
            // Three box blurs reach at most 3 sqrt(2 pi) 3/8 deviations each way, and a pixel each.
            Kind::GaussianBlur(fe) => [fe.std_dev_x().get() * 3.0, fe.std_dev_y().get() * 3.0],
            Kind::DropShadow(fe) => {
                [fe.std_dev_x().get() * 3.0 + fe.dx().abs(), fe.std_dev_y().get() * 3.0 + fe.dy().abs()]
            }
            Kind::Offset(fe) => [fe.dx().abs(), fe.dy().abs()],
            Kind::Morphology(fe) => [fe.radius_x().get(), fe.radius_y().get()],
            Kind::DisplacementMap(fe) => [fe.scale().abs() / 2.0; 2],
            Kind::ConvolveMatrix(fe) if fe.edge_mode() != source::EdgeMode::Wrap => {
                // In pixels, not in user space.
                total = [total[0] + f64::from(fe.matrix().columns()), total[1] + f64::from(fe.matrix().rows())];
                [0.0; 2]
            }
            Kind::ConvolveMatrix(_) | Kind::Tile(_) | Kind::Image(_) => return None,
            Kind::Blend(_)
            | Kind::ColorMatrix(_)
            | Kind::ComponentTransfer(_)
            | Kind::Composite(_)
            | Kind::DiffuseLighting(_)
            | Kind::Flood(_)
            | Kind::Merge(_)
            | Kind::SpecularLighting(_)
            | Kind::Turbulence(_) => [0.0; 2],
        };
        // Rounding, and the neighbors that lighting reads.
        total = [total[0] + f64::from(x) * scale_x + 4.0, total[1] + f64::from(y) * scale_y + 4.0];
    }
    Some(total)
}

fn color_space(interpolation: source::ColorInterpolation) -> ColorSpace {
    match interpolation {
        source::ColorInterpolation::SRGB => ColorSpace::Srgb,
        source::ColorInterpolation::LinearRGB => ColorSpace::LinearRgb,
    }
}

struct Planner<'a> {
    /// Result names of the steps so far.
    names: &'a [&'a str],
    space: Space,
}

impl Planner<'_> {
    /// The primitive's own region, in pixels of the filter region.
    fn region(&self, primitive: &source::Primitive) -> Region {
        let rect = pixel_rect(numbers(primitive.rect()), &self.space.pixels_from_user);
        let left = rect.x.saturating_sub(self.space.region.x);
        let top = rect.y.saturating_sub(self.space.region.y);
        Region {
            left,
            top,
            right: left.saturating_add_unsigned(rect.width),
            bottom: top.saturating_add_unsigned(rect.height),
        }
    }

    fn input(&self, input: &source::Input) -> Input {
        match input {
            source::Input::SourceGraphic => Input::Source,
            source::Input::SourceAlpha => Input::SourceAlpha,
            source::Input::Reference(name) => {
                self.names.iter().rposition(|known| known == name).map_or(Input::Source, Input::Step)
            }
        }
    }

    /// Lengths along x and y in pixels.
    fn scaled(&self, x: f32, y: f32) -> (f32, f32) {
        let [scale_x, scale_y] = self.space.pixels_from_user.axis_scales();
        (to_f32(f64::from(x) * scale_x), to_f32(f64::from(y) * scale_y))
    }

    /// A whole number of pixels along x and y, rounded toward zero as the reference pictures have it.
    fn offset(&self, x: f32, y: f32) -> (i32, i32) {
        let (x, y) = self.scaled(x, y);
        (to_i32(f64::from(x)), to_i32(f64::from(y)))
    }

    fn primitive(&self, converter: &mut Converter<'_>, primitive: &source::Primitive, region: Region) -> Primitive {
        match primitive.kind() {
            Kind::Blend(fe) => Primitive::Blend {
                source: self.input(fe.input1()),
                backdrop: self.input(fe.input2()),
                mode: converter.blend_mode(fe.mode()),
            },
            Kind::ColorMatrix(fe) => {
                Primitive::ColorMatrix { input: self.input(fe.input()), matrix: color_matrix(fe.kind()) }
            }
            Kind::ComponentTransfer(fe) => Primitive::ComponentTransfer {
                input: self.input(fe.input()),
                curves: [fe.func_r(), fe.func_g(), fe.func_b(), fe.func_a()].map(transfer),
            },
            Kind::Composite(fe) => Primitive::Composite {
                source: self.input(fe.input1()),
                backdrop: self.input(fe.input2()),
                operator: operator(fe.operator()),
            },
            Kind::ConvolveMatrix(fe) => self.convolve(converter, fe),
            Kind::DiffuseLighting(fe) => {
                let surface = Surface::Diffuse { constant: fe.diffuse_constant() };
                self.lighting(fe.input(), surface, fe.surface_scale(), fe.lighting_color(), fe.light_source())
            }
            Kind::SpecularLighting(fe) => {
                let surface = Surface::Specular { constant: fe.specular_constant(), exponent: fe.specular_exponent() };
                self.lighting(fe.input(), surface, fe.surface_scale(), fe.lighting_color(), fe.light_source())
            }
            Kind::DisplacementMap(fe) => Primitive::Displace {
                source: self.input(fe.input1()),
                map: self.input(fe.input2()),
                scale: self.scaled(fe.scale(), fe.scale()),
                channels: (channel(fe.x_channel_selector()), channel(fe.y_channel_selector())),
            },
            Kind::DropShadow(fe) => Primitive::DropShadow {
                input: self.input(fe.input()),
                offset: self.offset(fe.dx(), fe.dy()),
                deviation: self.scaled(fe.std_dev_x().get(), fe.std_dev_y().get()),
                color: pixel(fe.color(), fe.opacity()),
            },
            Kind::Flood(fe) => Primitive::Flood { color: pixel(fe.color(), fe.opacity()) },
            Kind::GaussianBlur(fe) => Primitive::Blur {
                input: self.input(fe.input()),
                deviation: self.scaled(fe.std_dev_x().get(), fe.std_dev_y().get()),
            },
            Kind::Image(fe) => self.picture(converter, fe, region),
            Kind::Merge(fe) => Primitive::Merge { inputs: fe.inputs().iter().map(|input| self.input(input)).collect() },
            Kind::Morphology(fe) => self.morphology(fe),
            Kind::Offset(fe) => {
                Primitive::Offset { input: self.input(fe.input()), offset: self.offset(fe.dx(), fe.dy()) }
            }
            Kind::Tile(fe) => Primitive::Tile { input: self.input(fe.input()) },
            Kind::Turbulence(fe) => self.turbulence(fe, primitive.rect()),
        }
    }

    fn convolve(&self, converter: &mut Converter<'_>, fe: &source::ConvolveMatrix) -> Primitive {
        let input = self.input(fe.input());
        let (matrix, region) = (fe.matrix(), self.space.region);
        let weights = matrix.data().to_vec();
        let steps =
            u64::from(region.width).saturating_mul(u64::from(region.height)).saturating_mul(weights.len() as u64);
        if steps > converter.limits.max_convolution_steps {
            converter.warnings.add("a feConvolveMatrix over the limit of work is left out");
            return Primitive::Offset { input, offset: (0, 0) };
        }
        let convolution = Convolution {
            columns: matrix.columns() as usize,
            rows: matrix.rows() as usize,
            weights,
            target_x: matrix.target_x() as usize,
            target_y: matrix.target_y() as usize,
            divisor: fe.divisor().get(),
            bias: fe.bias(),
            edge: match fe.edge_mode() {
                source::EdgeMode::None => Edge::Transparent,
                source::EdgeMode::Duplicate => Edge::Duplicate,
                source::EdgeMode::Wrap => Edge::Wrap,
            },
            preserve_alpha: fe.preserve_alpha(),
        };
        Primitive::Convolve { input, convolution }
    }

    fn lighting(
        &self,
        input: &source::Input,
        surface: Surface,
        surface_scale: f32,
        color: usvg::Color,
        light: source::LightSource,
    ) -> Primitive {
        let lamp = match light {
            source::LightSource::DistantLight(lamp) => distant(lamp.azimuth, lamp.elevation),
            source::LightSource::PointLight(lamp) => Lamp::Point(self.point([lamp.x, lamp.y, lamp.z])),
            source::LightSource::SpotLight(lamp) => Lamp::Spot {
                position: self.point([lamp.x, lamp.y, lamp.z]),
                target: self.point([lamp.points_at_x, lamp.points_at_y, lamp.points_at_z]),
                exponent: lamp.specular_exponent.get(),
                cone_cos: lamp.limiting_cone_angle.map(cos_degrees),
            },
        };
        let color = [color.red, color.green, color.blue];
        Primitive::Lighting { input: self.input(input), surface, surface_scale, color, lamp }
    }

    /// A point of user space in pixels of the filter region; z is scaled by the mean of both axes.
    fn point(&self, [x, y, z]: [f32; 3]) -> [f32; 3] {
        let at = self.space.pixels_from_user.apply([f64::from(x), f64::from(y)]);
        let [scale_x, scale_y] = self.space.pixels_from_user.axis_scales();
        let scale = ((scale_x * scale_x + scale_y * scale_y) / 2.0).sqrt();
        let origin = [self.space.region.x, self.space.region.y].map(f64::from);
        [to_f32(at[0] - origin[0]), to_f32(at[1] - origin[1]), to_f32(f64::from(z) * scale)]
    }

    fn picture(&self, converter: &mut Converter<'_>, fe: &source::Image, region: Region) -> Primitive {
        let [scale_x, scale_y] = self.space.pixels_from_user.axis_scales();
        let to_region = Transform::translate(f64::from(region.left), f64::from(region.top));
        let canvas = PixelRect { x: 0, y: 0, ..self.space.region };
        Primitive::Picture {
            draw: converter.picture(fe.root(), to_region * Transform::scale(scale_x, scale_y), canvas),
        }
    }

    fn morphology(&self, fe: &source::Morphology) -> Primitive {
        let (x, y) = self.scaled(fe.radius_x().get(), fe.radius_y().get());
        if !(x > 0.0 && y > 0.0) {
            return Primitive::Transparent;
        }
        let whole = |radius: f32| usize::try_from(to_i32((f64::from(radius) + 0.5).floor())).unwrap_or(0);
        Primitive::Morphology {
            input: self.input(fe.input()),
            operator: match fe.operator() {
                source::MorphologyOperator::Erode => Morphology::Erode,
                source::MorphologyOperator::Dilate => Morphology::Dilate,
            },
            radius: (whole(x), whole(y)),
        }
    }

    fn turbulence(&self, fe: &source::Turbulence, rect: usvg::NonZeroRect) -> Primitive {
        let [scale_x, scale_y] = self.space.pixels_from_user.axis_scales();
        let Some(user_from_pixels) = self.space.pixels_from_user.inverse() else { return Primitive::Transparent };
        let [x, y] = user_from_pixels.apply([self.space.region.x, self.space.region.y].map(f64::from));
        let noise = Turbulence {
            base_frequency: (f64::from(fe.base_frequency_x().get()), f64::from(fe.base_frequency_y().get())),
            octaves: fe.num_octaves(),
            seed: fe.seed(),
            stitch: fe.stitch_tiles().then(|| numbers(rect)),
            fractal: fe.kind() == source::TurbulenceKind::FractalNoise,
        };
        Primitive::Turbulence { grid: Grid { origin: (x, y), step: (1.0 / scale_x, 1.0 / scale_y) }, noise }
    }
}

fn color_matrix(kind: &source::ColorMatrixKind) -> [f32; 20] {
    match kind {
        source::ColorMatrixKind::Matrix(values) => {
            let mut matrix = [0.0; 20];
            for (entry, value) in matrix.iter_mut().zip(values) {
                *entry = *value;
            }
            matrix
        }
        source::ColorMatrixKind::Saturate(amount) => saturate(amount.get()),
        source::ColorMatrixKind::HueRotate(degrees) => hue_rotate(*degrees),
        source::ColorMatrixKind::LuminanceToAlpha => LUMINANCE_TO_ALPHA,
    }
}

fn transfer(function: &source::TransferFunction) -> Transfer {
    match function {
        source::TransferFunction::Identity => Transfer::Identity,
        source::TransferFunction::Table(values) => Transfer::Table(values.clone()),
        source::TransferFunction::Discrete(values) => Transfer::Discrete(values.clone()),
        source::TransferFunction::Linear { slope, intercept } => {
            Transfer::Linear { slope: *slope, intercept: *intercept }
        }
        source::TransferFunction::Gamma { amplitude, exponent, offset } => {
            Transfer::Gamma { amplitude: *amplitude, exponent: *exponent, offset: *offset }
        }
    }
}

fn operator(operator: source::CompositeOperator) -> Operator {
    match operator {
        source::CompositeOperator::Over => Operator::Over,
        source::CompositeOperator::In => Operator::In,
        source::CompositeOperator::Out => Operator::Out,
        source::CompositeOperator::Atop => Operator::Atop,
        source::CompositeOperator::Xor => Operator::Xor,
        source::CompositeOperator::Lighter => Operator::Lighter,
        source::CompositeOperator::Arithmetic { k1, k2, k3, k4 } => Operator::Arithmetic([k1, k2, k3, k4]),
    }
}

fn channel(selector: source::ColorChannel) -> usize {
    match selector {
        source::ColorChannel::R => 0,
        source::ColorChannel::G => 1,
        source::ColorChannel::B => 2,
        source::ColorChannel::A => 3,
    }
}

fn pixel(color: usvg::Color, opacity: usvg::Opacity) -> [u8; 4] {
    [color.red, color.green, color.blue, opacity.to_u8()]
}

#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is meant")]
fn to_f32(x: f64) -> f32 {
    x as f32
}
