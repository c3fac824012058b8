//! The story of a pixel as JSON, for programs. Floats are the shortest decimals that read back as the same numbers.

use super::triangle::{blend, compare, label, linear_weights, number_in_mesh, outcome, samples_of};
use crate::json::Json;
use trigon::explain::{FragmentFacts, Note, TextureRead};
use trigon::pipeline::{FragmentStory, SampleTest, TriangleStory};
use trigon::shade::Interpolation;
use trigon::target::{ColorSpace, ShadingRate};
use trigon_scene::render::SceneStory;

/// The whole story; `size` is that of the picture.
pub(crate) fn to_json(story: &SceneStory, (width, height): (u32, u32)) -> Json {
    let pixel = &story.pixel;
    let end = &pixel.resolve;
    let rate = match pixel.shading {
        ShadingRate::Pixel => "pixel",
        ShadingRate::Sample => "sample",
    };
    let interpolation = match pixel.interpolation {
        Interpolation::Perspective => "perspective",
        Interpolation::Affine => "affine",
    };
    let color_space = match pixel.color_space {
        ColorSpace::Linear => "linear",
        ColorSpace::Encoded => "encoded",
    };
    let samples = pixel.samples.iter().map(|[x, y]| floats(&[f32::from(*x) / 256.0, f32::from(*y) / 256.0])).collect();
    let fragments = pixel.fragments.iter().map(|f| fragment(f, pixel.triangles.get(f.triangle))).collect();
    let resolve = Json::Object(vec![
        ("samples", Json::List(end.samples.iter().map(|color| floats(color)).collect())),
        ("mean", floats(&end.mean)),
        ("srgb8", integers(end.bytes)),
    ]);
    Json::Object(vec![
        ("version", env!("CARGO_PKG_VERSION").into()),
        ("pixel", integers(pixel.pixel)),
        ("width", width.into()),
        ("height", height.into()),
        ("color", integers(story.color)),
        ("shading", rate.into()),
        ("interpolation", interpolation.into()),
        ("color_space", color_space.into()),
        ("samples", Json::List(samples)),
        ("clear", floats(&pixel.clear)),
        ("triangles", Json::List(pixel.triangles.iter().map(|t| triangle(story, t)).collect())),
        ("fragments", Json::List(fragments)),
        ("resolve", resolve),
    ])
}

fn triangle(story: &SceneStory, triangle: &TriangleStory) -> Json {
    let names = label(story, triangle);
    let text = |name: Option<&str>| name.unwrap_or("").into();
    let corners = triangle.corners.iter().zip(triangle.inverse_w).zip(triangle.vertex_of_corner);
    #[expect(clippy::cast_precision_loss, reason = "at most 23 bits")]
    let corner = |(([x, y], inverse_w), vertex): ((&[i32; 2], f32), usize)| {
        Json::Object(vec![
            ("x", Json::Float(*x as f32 / 256.0)),
            ("y", Json::Float(*y as f32 / 256.0)),
            ("inverse_w", Json::Float(inverse_w)),
            ("vertex", triangle.vertices[vertex].into()),
        ])
    };
    Json::Object(vec![
        ("draw", triangle.draw.into()),
        ("object", text(names.map(|names| names.object.as_str()))),
        ("group", text(names.map(|names| names.group.as_str()))),
        ("material", text(names.and_then(|names| names.material.as_deref()))),
        ("number", number_in_mesh(story, triangle).into()),
        ("vertices", integers(triangle.vertices)),
        ("clip_space", Json::List(triangle.clip.iter().map(|clip| floats(clip)).collect())),
        ("corners", Json::List(corners.map(corner).collect())),
        ("depth_plane", floats(&triangle.depth)),
        ("is_front", Json::Bool(triangle.is_front)),
        ("is_clipped", Json::Bool(triangle.is_clipped)),
        ("is_micro", Json::Bool(triangle.is_micro)),
        ("is_whole_block", Json::Bool(triangle.is_whole_block)),
        ("depth_compare", compare(triangle.depth_test).into()),
        ("writes_depth", Json::Bool(triangle.depth_test.write)),
        ("blend", blend(triangle.blend).into()),
        ("tests", Json::List(triangle.tests.iter().map(test).collect())),
    ])
}

fn test(test: &SampleTest) -> Json {
    Json::Object(vec![
        ("edges", Json::Row(test.edges.iter().map(|edge| Json::Signed((*edge).into())).collect())),
        ("is_covered", Json::Bool(test.is_covered)),
        ("depth", Json::Float(test.depth)),
        ("depth_there", Json::Float(test.stored)),
        ("outcome", outcome(test.outcome).into()),
    ])
}

fn fragment(fragment: &FragmentStory, of: Option<&TriangleStory>) -> Json {
    let samples = samples_of(fragment.samples);
    let colors = |colors: &[[f32; 4]]| {
        Json::List(samples.iter().filter_map(|s| colors.get(*s)).map(|color| floats(color)).collect())
    };
    let mut members = vec![
        ("triangle", fragment.triangle.into()),
        ("samples", Json::Row(samples.iter().map(|s| (*s).into()).collect())),
        ("kind", if fragment.color.is_some() { "shaded" } else { "alpha test" }.into()),
    ];
    members.extend(facts(&fragment.facts, of));
    members.push(("notes", Json::List(fragment.notes.iter().map(note).collect())));
    if let Some(color) = &fragment.color {
        members.push(("color", floats(color)));
        members.push(("before", colors(&fragment.before)));
        members.push(("after", colors(&fragment.after)));
    }
    Json::Object(members)
}

fn facts(facts: &FragmentFacts, of: Option<&TriangleStory>) -> Vec<(&'static str, Json)> {
    let varying = |varying: &trigon::explain::VaryingFacts| {
        Json::Object(vec![
            ("name", varying.name.clone().into()),
            ("value", Json::Float(varying.value)),
            ("dx", Json::Float(varying.dx)),
            ("dy", Json::Float(varying.dy)),
        ])
    };
    let mut members = vec![("point", floats(&facts.point)), ("weights", floats(&facts.barycentric))];
    #[expect(clippy::cast_possible_truncation, reason = "as exact as the other weights")]
    if let Some(linear) = of.and_then(|triangle| linear_weights(triangle, facts.point)) {
        members.push(("weights_by_area", floats(&linear.map(|weight| weight as f32))));
    }
    members.extend([
        ("inverse_w", Json::Float(facts.inverse_w)),
        ("depth", Json::Float(facts.depth)),
        ("varyings", Json::List(facts.varyings.iter().map(varying).collect())),
    ]);
    members
}

fn note(note: &Note) -> Json {
    match note {
        Note::Topic { name, number } => {
            let mut members = vec![("topic", (*name).into())];
            members.extend(number.map(|number| ("number", number.into())));
            Json::Object(members)
        }
        Note::Value { name, values } => Json::Object(vec![("name", (*name).into()), ("values", floats(values))]),
        Note::Texture(read) => Json::Object(vec![("texture", texture(read))]),
        _ => Json::Object(Vec::new()),
    }
}

fn texture(read: &TextureRead) -> Json {
    let tap = |tap: &trigon::explain::Tap| {
        Json::Object(vec![("uv", floats(&tap.uv)), ("levels", Json::List(tap.levels.iter().map(level).collect()))])
    };
    let mut members = vec![
        ("width", read.size[0].into()),
        ("height", read.size[1].into()),
        ("levels", read.levels.into()),
        ("uv", floats(&read.uv)),
    ];
    if let Some([dx, dy]) = &read.footprint {
        members.extend([("uv_dx", floats(dx)), ("uv_dy", floats(dy))]);
    }
    members.extend([
        ("lod", Json::Float(read.lod)),
        ("taps", Json::List(read.taps.iter().map(tap).collect())),
        ("color", floats(&read.color)),
    ]);
    Json::Object(members)
}

fn level(level: &trigon::explain::LevelRead) -> Json {
    let texel = |texel: &trigon::explain::TexelRead| {
        Json::Object(vec![
            ("column", texel.column.into()),
            ("row", texel.row.into()),
            ("weight", Json::Float(texel.weight)),
            ("color", floats(&texel.color)),
            ("is_border", Json::Bool(texel.is_border)),
        ])
    };
    Json::Object(vec![
        ("level", level.level.into()),
        ("width", level.size[0].into()),
        ("height", level.size[1].into()),
        ("weight", Json::Float(level.weight)),
        ("texels", Json::List(level.texels.iter().map(texel).collect())),
    ])
}

fn floats(values: &[f32]) -> Json {
    Json::Row(values.iter().map(|value| Json::Float(*value)).collect())
}

fn integers<T: Into<u32>, const N: usize>(values: [T; N]) -> Json {
    Json::Row(values.into_iter().map(|value| Json::from(value.into())).collect())
}
