//! The stages of reading an OBJ file, led from the text to the scene.

use super::block::{Block, EventKind, NO_COLOR, shorten, why_ignored};
use super::element::MAX_ELEMENTS;
use super::library::Library;
use super::resolve::{Counts, Primitives, Usage, resolve_block};
use super::runs::Runs;
use super::split::{BLOCK_BYTES, split};
use crate::geometry::{ABSENT, Corner, Smoothing, Unifier, gather, generate_normals, unit_normal};
use crate::load::{Findings, LoadError, LoadOptions, Place, SideFiles, WarningKind, parallel_map};
use crate::math::Mat4;
use crate::mtl;
use crate::scene::{Instance, MaterialId, Mesh, MeshId, Scene};
use crate::text::to_single_byte_text;

/// Reads an OBJ file: one mesh, one instance, and the materials in use.
pub(crate) fn read(
    bytes: &[u8],
    file: &str,
    options: &LoadOptions,
    side_files: &mut SideFiles<'_>,
    findings: &mut Findings,
) -> Result<Scene, LoadError> {
    let text = to_single_byte_text(bytes);
    let threads = options.thread_count();
    let blocks = parallel_map(threads, split(&text, BLOCK_BYTES), |_, text| Block::parse(text));
    let mut attributes = Attributes::collect(&blocks, file, options)?;
    let mut blocks = resolve(blocks, &attributes, threads, file, options)?;

    let lines_before = lines_before(&blocks);
    report(&blocks, &lines_before, file, findings)?;
    show_bare_points(&mut blocks, attributes.positions.len());
    let runs = runs(&blocks, &lines_before);
    let mut library = Library::new(file, &runs);
    let mut context = mtl::Context {
        side_files,
        findings,
        skip_textures: options.skip_textures,
        max_materials: options.limits.materials,
        max_bytes: options.limits.file_bytes,
    };
    for (block, &lines) in blocks.iter().map(|(block, _)| block).zip(&lines_before) {
        for event in block.events.iter().filter(|event| event.kind == EventKind::Library) {
            library.load(event.name, lines + u64::from(event.line) + 1, &mut context)?;
        }
    }
    let (materials, ids) = library.pick(&runs, options.limits.materials, findings)?;

    let mut primitives: Vec<Primitives> = blocks.into_iter().map(|(_, primitives)| primitives).collect();
    add_normals(&mut primitives, &mut attributes, &runs, options);
    let mesh = assemble(primitives, attributes, &runs, &ids, threads);
    let instance = Instance { mesh: MeshId(0), world_from_model: Mat4::IDENTITY, name: file.to_owned() };
    Ok(Scene { meshes: vec![mesh], instances: vec![instance], materials, ..Scene::default() })
}

/// The attribute values of the whole file.
struct Attributes {
    positions: Vec<[f32; 3]>,
    /// As written; empty or one per position.
    colors: Vec<[f32; 4]>,
    uvs: Vec<[f32; 2]>,
    normals: Vec<[f32; 3]>,
}

impl Attributes {
    fn collect(blocks: &[Block<'_>], file: &str, options: &LoadOptions) -> Result<Self, LoadError> {
        let [positions, uvs, normals] = blocks.iter().fold([0; 3], |sum, block| add(sum, counts(block)));
        let allowed = options.limits.vertices.min(u64::try_from(MAX_ELEMENTS).unwrap_or(u64::MAX));
        let most = positions.max(uvs).max(normals);
        if u64::try_from(most).unwrap_or(u64::MAX) > allowed {
            return Err(LoadError::limit(file, "vertices", allowed));
        }
        let mut all = Self {
            positions: Vec::with_capacity(positions),
            colors: Vec::new(),
            uvs: Vec::with_capacity(uvs),
            normals: Vec::with_capacity(normals),
        };
        let has_colors = blocks.iter().any(|block| !block.colors.is_empty());
        for block in blocks {
            all.positions.extend_from_slice(&block.positions);
            all.uvs.extend_from_slice(&block.uvs);
            all.normals.extend_from_slice(&block.normals);
            if has_colors {
                all.colors.extend_from_slice(&block.colors);
                all.colors.resize(all.positions.len(), NO_COLOR);
            }
        }
        Ok(all)
    }

    fn counts(&self) -> Counts {
        [self.positions.len(), self.uvs.len(), self.normals.len()]
    }
}

fn counts(block: &Block<'_>) -> Counts {
    [block.positions.len(), block.uvs.len(), block.normals.len()]
}

fn add(a: Counts, b: Counts) -> Counts {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// Final indices for every block, in parallel.
fn resolve<'a>(
    blocks: Vec<Block<'a>>,
    attributes: &Attributes,
    threads: usize,
    file: &str,
    options: &LoadOptions,
) -> Result<Vec<(Block<'a>, Primitives)>, LoadError> {
    let triangles: u64 = blocks.iter().map(|block| block.faces.triangle_count()).sum();
    let allowed = options.limits.triangles.min(u64::from(u32::MAX / 3));
    if triangles > allowed {
        return Err(LoadError::limit(file, "triangles", allowed));
    }
    let mut before = [0; 3];
    let mut items = Vec::with_capacity(blocks.len());
    for block in blocks {
        let count = counts(&block);
        items.push((block, before));
        before = add(before, count);
    }
    let totals = attributes.counts();
    let positions = &attributes.positions;
    Ok(parallel_map(threads, items, |_, (block, before)| resolve_block(block, before, totals, positions)))
}

/// For each block the number of lines before it.
fn lines_before(blocks: &[(Block<'_>, Primitives)]) -> Vec<u64> {
    let mut before = 0;
    let count = |(block, _): &(Block<'_>, Primitives)| {
        let lines = before;
        before += u64::from(block.n_lines);
        lines
    };
    blocks.iter().map(count).collect()
}

/// Passes on what the blocks found, in order of lines.
fn report(
    blocks: &[(Block<'_>, Primitives)],
    lines_before: &[u64],
    file: &str,
    findings: &mut Findings,
) -> Result<(), LoadError> {
    report_ignored(blocks, lines_before, file, findings)?;
    for ((block, primitives), &lines) in blocks.iter().zip(lines_before) {
        let mut notes: Vec<_> = block.notes.iter().chain(&primitives.notes).collect();
        notes.sort_by_key(|note| note.line);
        for note in notes {
            let place = Place::Line(lines + u64::from(note.line) + 1);
            findings.warn(file, place, note.kind, note.message.as_str())?;
        }
        findings.suppress(block.suppressed_notes + primitives.suppressed_notes);
    }
    Ok(())
}

/// Lists each statement of the format that is not read once, and all lines that are none together: exporters leave text
/// without a comment sign at the head of a file, a word each a line.
fn report_ignored(
    blocks: &[(Block<'_>, Primitives)],
    lines_before: &[u64],
    file: &str,
    findings: &mut Findings,
) -> Result<(), LoadError> {
    let mut listed: Vec<&[u8]> = Vec::new();
    let (mut first_unknown, mut unknown) = (None, 0);
    for ((block, _), &lines) in blocks.iter().zip(lines_before) {
        let place = |line: u32| Place::Line(lines + u64::from(line) + 1);
        for &(word, line) in &block.ignored {
            if !listed.contains(&word) {
                listed.push(word);
                let message = format!("statement {} ignored{}", shorten(word), why_ignored(word));
                findings.warn(file, place(line), WarningKind::Ignored, message)?;
            }
        }
        unknown += block.unknown_lines;
        first_unknown = first_unknown.or(block.first_unknown.map(|(word, line)| (word, place(line))));
    }
    if let Some((word, place)) = first_unknown {
        let message = match unknown {
            1 => format!("statement {} ignored", shorten(word)),
            _ => format!("{unknown} lines that are no statements ignored, the first is {} ...", shorten(word)),
        };
        findings.warn(file, place, WarningKind::Ignored, message)?;
    }
    Ok(())
}

/// A file of positions alone is a point cloud: all of them are drawn as points.
fn show_bare_points(blocks: &mut [(Block<'_>, Primitives)], positions: usize) {
    let has_elements = |block: &Block<'_>| {
        block.faces.count > 0 || block.lines.count > 0 || !block.points.is_empty() || !block.notes.is_empty()
    };
    if blocks.iter().any(|(block, _)| has_elements(block)) {
        return;
    }
    if let Some((_, last)) = blocks.last_mut() {
        let positions = 0..u32::try_from(positions).unwrap_or(0);
        last.points = positions.map(|position| [position, ABSENT, ABSENT]).collect();
    }
}

/// Follows the state changes through all blocks.
fn runs<'a>(blocks: &[(Block<'a>, Primitives)], lines_before: &[u64]) -> Runs<'a> {
    let mut runs = Runs::default();
    let mut base = [0; 3];
    for ((block, primitives), &lines) in blocks.iter().zip(lines_before) {
        for (event, &before) in block.events.iter().zip(&primitives.before_events) {
            runs.event(event.kind, event.name, lines + u64::from(event.line), add(base, before));
        }
        base = add(base, [primitives.triangles.len() / 3, primitives.segments.len() / 2, primitives.points.len()]);
    }
    runs.primitives_until(base);
    runs
}

/// Generates normals for corners that have none.
fn add_normals(primitives: &mut [Primitives], attributes: &mut Attributes, runs: &Runs<'_>, options: &LoadOptions) {
    let usage = usage(primitives);
    if !usage.lacking[1] {
        return;
    }
    let corners = primitives.iter().flat_map(|block| block.triangles.as_chunks::<3>().0);
    let triangles: Vec<[u32; 3]> = corners.map(|[a, b, c]| [a[0], b[0], c[0]]).collect();
    let groups = runs.smoothing_groups(triangles.len());
    let smoothing = match &groups {
        Some(groups) => Smoothing::Groups(groups),
        None => Smoothing::Angle(options.crease_cosine()),
    };
    let made = generate_normals(options.thread_count(), &attributes.positions, &triangles, smoothing);
    let base = u32::try_from(attributes.normals.len()).unwrap_or(u32::MAX);
    attributes.normals.extend_from_slice(&made.normals);
    let corners = primitives.iter_mut().flat_map(|block| &mut block.triangles);
    for (corner, &normal) in corners.zip(made.corners.as_flattened()) {
        if corner[2] == ABSENT {
            corner[2] = base + normal;
        }
    }
}

fn usage(primitives: &[Primitives]) -> Usage {
    primitives.iter().fold(Usage::default(), |usage, block| usage.and(block.usage))
}

/// Makes single-index vertices and puts the mesh together.
fn assemble(
    primitives: Vec<Primitives>,
    attributes: Attributes,
    runs: &Runs<'_>,
    ids: &[MaterialId],
    threads: usize,
) -> Mesh {
    let has_uvs = primitives.iter().any(|block| block.usage.some[0]);
    let mut unifier = Unifier::new(attributes.positions.len());
    let n_triangles = primitives.iter().map(|block| block.triangles.len() / 3).sum();
    let mut triangles = Vec::with_capacity(n_triangles);
    let (mut segments, mut points) = (Vec::new(), Vec::new());
    for block in primitives {
        let mut index = |corner: &Corner| unifier.vertex(*corner);
        triangles.extend(block.triangles.as_chunks::<3>().0.iter().map(|corners| corners.each_ref().map(&mut index)));
        segments.extend(block.segments.as_chunks::<2>().0.iter().map(|corners| corners.each_ref().map(&mut index)));
        points.extend(block.points.iter().map(&mut index));
    }
    let has_normals = !triangles.is_empty();
    let submeshes = runs.submeshes(ids, &mut triangles, &mut segments, &mut points);
    let vertices = unifier.into_vertices();
    let Attributes { positions, colors, uvs, normals } = attributes;
    let is_byte = |c: &f32| c.is_finite() && *c > 1.0 + 1e-3;
    let color_scale = if colors.iter().flatten().any(is_byte) { 1.0 / 255.0 } else { 1.0 };
    Mesh {
        positions: gather(threads, &vertices, 0, &positions, [0.0; 3], |p| p),
        normals: if_some(has_normals, || gather(threads, &vertices, 2, &normals, [0.0; 3], unit_normal)),
        uvs: if_some(has_uvs, || gather(threads, &vertices, 1, &uvs, [0.0; 2], |uv| uv)),
        colors: if_some(!colors.is_empty(), || {
            gather(threads, &vertices, 0, &colors, [1.0; 4], |c| crate::color::linear_from_srgb(c, color_scale))
        }),
        tangents: Vec::new(),
        triangles,
        segments,
        points,
        parts: runs.parts(),
        submeshes,
    }
}

fn if_some<T>(condition: bool, make: impl FnOnce() -> Vec<T>) -> Vec<T> {
    if condition { make() } else { Vec::new() }
}
