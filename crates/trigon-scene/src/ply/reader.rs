//! Walking the elements of a PLY file: vertices, faces, strips and edges are kept, all others stepped over.

use super::header::{Element, Header, Scalar};
use super::layout::{Layout, ListSlot, Slot, Step};
use super::values::{Values, read_binary};
use crate::color::linear_from_srgb;
use crate::geometry::{ABSENT, Cut, Extra, Facets, Triangulator};
use crate::load::{Findings, Limits, LoadError, LoadOptions, Place, SideFiles, WarningKind};
use crate::math::Mat4;
use crate::scene::{Instance, Material, MaterialId, MeshId, Scene, TextureRef};
use std::collections::HashMap;

/// Reads a PLY file: one mesh, one instance, a neutral material or one with the texture the header names.
pub(crate) fn read(
    bytes: &[u8],
    file: &str,
    options: &LoadOptions,
    side_files: &mut SideFiles<'_>,
    findings: &mut Findings,
) -> Result<Scene, LoadError> {
    let header = Header::parse(bytes, file)?;
    let values = Values::new(bytes.get(header.body..).unwrap_or_default(), header.encoding);
    let mut reader = Reader {
        file,
        header: &header,
        limits: &options.limits,
        findings,
        values,
        facets: Facets::default(),
        extra_ids: HashMap::new(),
        triangulator: Triangulator::default(),
        cut: Vec::new(),
        has_surface: false,
    };
    for element in &header.elements {
        reader.element(element)?;
    }
    let facets = reader.finish();

    let mut material = Material::default();
    if let Some(texture_file) = header.texture_file.as_deref().filter(|_| !options.skip_textures) {
        match side_files.texture(texture_file, "") {
            Ok(texture) => material.maps.diffuse = Some(TextureRef::new(texture)),
            Err(problem) => findings.warn(file, Place::File, problem.kind, problem.message)?,
        }
        if material.maps.diffuse.is_some() {
            material.diffuse = [1.0; 3];
        }
    }
    let mesh = facets.into_mesh(MaterialId(0), options);
    let instance = Instance { mesh: MeshId(0), world_from_model: Mat4::IDENTITY, name: file.to_owned() };
    Ok(Scene { meshes: vec![mesh], instances: vec![instance], materials: vec![material], ..Scene::default() })
}

struct Reader<'a> {
    file: &'a str,
    header: &'a Header,
    limits: &'a Limits,
    findings: &'a mut Findings,
    values: Values<'a>,
    facets: Facets,
    /// Extras by the bits of their values.
    extra_ids: HashMap<[u32; 6], u32>,
    triangulator: Triangulator,
    /// The triangles of the last face, by corners of the face.
    cut: Vec<[usize; 3]>,
    /// Whether there are faces, strips or edges: else the vertices are drawn as points.
    has_surface: bool,
}

/// The lists of one face.
#[derive(Default)]
struct Face {
    corners: Vec<f64>,
    uvs: Vec<f64>,
    slots: [f64; Slot::COUNT],
}

impl Reader<'_> {
    fn element(&mut self, element: &Element) -> Result<(), LoadError> {
        let layout = Layout::of(element);
        if element.count == 0 || layout.steps.is_empty() {
            return Ok(());
        }
        let values = element.count.saturating_mul(layout.least_values());
        if values > self.values.most_left() {
            let message = format!("file ends early: it announces {} of element {}", element.count, element.name);
            return Err(self.malformed(message));
        }
        match element.name.as_str() {
            "vertex" => self.vertices(element.count, &layout),
            "face" | "tristrips" if layout.has_list(ListSlot::Corners) => {
                self.has_surface = true;
                self.faces(element, &layout)
            }
            "edge" if layout.has(&[Slot::EdgeStart, Slot::EdgeEnd]) => {
                self.has_surface = true;
                self.edges(element, &layout)
            }
            _ => self.skip(element, &layout),
        }
    }

    fn vertices(&mut self, count: u64, layout: &Layout) -> Result<(), LoadError> {
        if !layout.has(&[Slot::X, Slot::Y, Slot::Z]) {
            return Err(self.malformed("vertices need the properties x, y and z".to_owned()));
        }
        if !self.facets.positions.is_empty() {
            return Err(self.malformed("a second list of vertices".to_owned()));
        }
        if count > self.limits.vertices.min(u64::from(u32::MAX - 1)) {
            return Err(LoadError::limit(self.file, "vertices", self.limits.vertices));
        }
        let has_normals = layout.has(&[Slot::NormalX, Slot::NormalY, Slot::NormalZ]);
        let has_uvs = layout.has(&[Slot::U, Slot::V]);
        let palette = Palette::of(layout);
        let count = usize::try_from(count).unwrap_or(usize::MAX);
        self.facets.positions.reserve_exact(count);
        let mut record = Face::default();
        let plan = Plan::of(layout);
        for _ in 0..count {
            self.record(layout, &plan, &mut record)?;
            let value = |slot: Slot| to_f32(record.slots[slot as usize]);
            self.facets.positions.push([value(Slot::X), value(Slot::Y), value(Slot::Z)]);
            if has_normals {
                let normal = [value(Slot::NormalX), value(Slot::NormalY), value(Slot::NormalZ)];
                self.facets.normals.push(crate::geometry::unit_normal(normal));
            }
            if has_uvs {
                self.facets.uvs.push([value(Slot::U), 1.0 - value(Slot::V)]);
            }
            if let Some(palette) = &palette {
                self.facets.colors.push(palette.linear(&record.slots));
            }
        }
        Ok(())
    }

    fn faces(&mut self, element: &Element, layout: &Layout) -> Result<(), LoadError> {
        let is_strip = element.name == "tristrips";
        let palette = Palette::of(layout).filter(|_| self.facets.colors.is_empty());
        let announced = usize::try_from(element.count).unwrap_or(usize::MAX);
        let allowed = usize::try_from(self.limits.triangles).unwrap_or(usize::MAX);
        self.facets.triangles.reserve(announced.min(allowed));
        let mut face = Face::default();
        let mut corners = Vec::new();
        let plan = Plan::of(layout);
        for _ in 0..element.count {
            if !self.quick_triangle(&plan) {
                self.record(layout, &plan, &mut face)?;
                self.cut.clear();
                let n_before = self.facets.triangles.len();
                match is_strip {
                    true => self.strip(&face.corners)?,
                    false => self.face(&face, &mut corners)?,
                }
                self.extras(&face, n_before, palette.as_ref());
            }
            if self.facets.triangles.len() > allowed.min(u32::MAX as usize / 3) {
                return Err(LoadError::limit(self.file, "triangles", self.limits.triangles));
            }
        }
        Ok(())
    }

    /// The usual binary face, three indices and nothing else, without detours. `false`, and no step, for any other.
    #[inline]
    fn quick_triangle(&mut self, plan: &Plan) -> bool {
        let (Plan::Triangles(item), Values::Binary { bytes, at, is_big_endian }) = (plan, &mut self.values) else {
            return false;
        };
        let width = item.bytes();
        let Some((3, indices)) =
            bytes.get(*at..*at + 1 + 3 * width).and_then(|b| b.split_first()).map(|(n, i)| (*n, i))
        else {
            return false;
        };
        let n_vertices = self.facets.positions.len();
        let index = |corner: usize| read_binary(&indices[corner * width..], *item, *is_big_endian).and_then(to_index);
        let (Some(a), Some(b), Some(c)) = (index(0), index(1), index(2)) else { return false };
        let is_good = |i: u32| (i as usize) < n_vertices;
        if !(is_good(a) && is_good(b) && is_good(c)) {
            return false;
        }
        *at += 1 + 3 * width;
        self.facets.triangles.push([a, b, c]);
        true
    }

    fn face(&mut self, face: &Face, corners: &mut Vec<u32>) -> Result<(), LoadError> {
        let n_vertices = self.facets.positions.len();
        corners.clear();
        corners.extend(face.corners.iter().map_while(|&i| to_index(i).filter(|&i| (i as usize) < n_vertices)));
        if corners.len() < face.corners.len() || corners.len() < 3 {
            let message = match corners.len() < face.corners.len() {
                true => format!("face left out: it refers to a vertex that does not exist (there are {n_vertices})"),
                false => format!("face with {} corners left out", corners.len()),
            };
            return self.warn(message);
        }
        let positions = &self.facets.positions;
        let cut = self.triangulator.cut(corners.len(), |i| positions[corners[i] as usize], &mut self.cut);
        self.facets.triangles.extend(self.cut.iter().map(|triangle| triangle.map(|i| corners[i])));
        if cut == Cut::BestEffort && corners.len() > 4 {
            let message = format!("face with {} corners crosses itself or has no area", corners.len());
            return self.findings.warn(self.file, self.place(), WarningKind::Approximated, message);
        }
        Ok(())
    }

    /// A strip: each index makes a triangle with the two before it, turning alternately; -1 begins anew.
    fn strip(&mut self, indices: &[f64]) -> Result<(), LoadError> {
        let n_vertices = self.facets.positions.len();
        for run in indices.split(|&index| index < 0.0) {
            let corners: Option<Vec<u32>> =
                run.iter().map(|&i| to_index(i).filter(|&i| (i as usize) < n_vertices)).collect();
            let Some(corners) = corners else {
                self.warn("strip left out: it refers to a vertex that does not exist".to_owned())?;
                continue;
            };
            for (i, triple) in corners.windows(3).enumerate() {
                let [a, b, c] = [triple[0], triple[1], triple[2]];
                let triangle = if i % 2 == 0 { [a, b, c] } else { [b, a, c] };
                if a != b && b != c && c != a {
                    self.facets.triangles.push(triangle);
                }
            }
        }
        Ok(())
    }

    /// Gives the triangles from `first` on the texture coordinates and colour of their face.
    fn extras(&mut self, face: &Face, first: usize, palette: Option<&Palette>) {
        let color = palette.map(|palette| palette.linear(&face.slots));
        if color.is_none() && face.uvs.is_empty() {
            return;
        }
        self.facets.triangle_extras.resize(first, [ABSENT; 3]);
        for triangle in first..self.facets.triangles.len() {
            let corners = self.cut.get(triangle - first).copied().unwrap_or_default();
            let extras = corners.map(|corner| {
                let uv = match face.uvs.get(2 * corner..2 * corner + 2) {
                    Some(&[u, v]) => Some([to_f32(u), 1.0 - to_f32(v)]),
                    _ => None,
                };
                self.extra(Extra { uv, color })
            });
            self.facets.triangle_extras.push(extras);
        }
    }

    fn extra(&mut self, extra: Extra) -> u32 {
        let uv = extra.uv.map_or([ABSENT; 2], |uv| uv.map(f32::to_bits));
        let color = extra.color.map_or([ABSENT; 4], |color| color.map(f32::to_bits));
        let extras = &mut self.facets.extras;
        *self.extra_ids.entry([uv[0], uv[1], color[0], color[1], color[2], color[3]]).or_insert_with(|| {
            extras.push(extra);
            u32::try_from(extras.len() - 1).unwrap_or(ABSENT)
        })
    }

    fn edges(&mut self, element: &Element, layout: &Layout) -> Result<(), LoadError> {
        let n_vertices = self.facets.positions.len();
        let mut record = Face::default();
        let plan = Plan::of(layout);
        for _ in 0..element.count {
            self.record(layout, &plan, &mut record)?;
            let end = |slot: Slot| to_index(record.slots[slot as usize]).filter(|&i| (i as usize) < n_vertices);
            match (end(Slot::EdgeStart), end(Slot::EdgeEnd)) {
                (Some(start), Some(end)) => self.facets.segments.push([start, end]),
                _ => self.warn("edge left out: it refers to a vertex that does not exist".to_owned())?,
            }
        }
        Ok(())
    }

    fn skip(&mut self, element: &Element, layout: &Layout) -> Result<(), LoadError> {
        let message = format!("element {} ignored", element.name.chars().take(40).collect::<String>());
        self.findings.warn(self.file, Place::File, WarningKind::Ignored, message)?;
        if let (Some(bytes), Values::Binary { .. }) = (layout.fixed_bytes(), &self.values) {
            let all = element.count.saturating_mul(u64::try_from(bytes).unwrap_or(u64::MAX));
            return self.values.skip(Scalar::U8, all).ok_or_else(|| self.ended());
        }
        let mut record = Face::default();
        let plan = Plan::of(layout);
        (0..element.count).try_for_each(|_| self.record(layout, &plan, &mut record))
    }

    /// Reads one record.
    #[inline]
    fn record(&mut self, layout: &Layout, plan: &Plan, record: &mut Face) -> Result<(), LoadError> {
        if let (Plan::Fixed(bytes), Values::Binary { is_big_endian, .. }) = (plan, &self.values) {
            let is_big_endian = *is_big_endian;
            let Some(mut rest) = self.values.take_binary(*bytes) else { return Err(self.ended()) };
            for step in &layout.steps {
                let Step::Scalar(scalar, slot) = step else { continue };
                if let (Some(slot), Some(value)) = (slot, read_binary(rest, *scalar, is_big_endian)) {
                    record.slots[*slot as usize] = value;
                }
                rest = rest.get(scalar.bytes()..).unwrap_or_default();
            }
            return Ok(());
        }
        self.any_record(layout, record).ok_or_else(|| self.ended())
    }

    fn any_record(&mut self, layout: &Layout, record: &mut Face) -> Option<()> {
        for step in &layout.steps {
            match *step {
                Step::Scalar(scalar, slot) => {
                    let value = self.values.next(scalar)?;
                    if let Some(slot) = slot {
                        record.slots[slot as usize] = value;
                    }
                }
                Step::List(count, item, slot) => {
                    let count = self.values.next(count).and_then(to_count).filter(|&n| n <= self.values.most_left())?;
                    let list = match slot {
                        Some(ListSlot::Corners) => &mut record.corners,
                        Some(ListSlot::Uvs) => &mut record.uvs,
                        None => {
                            self.values.skip(item, count)?;
                            continue;
                        }
                    };
                    list.clear();
                    for _ in 0..count {
                        list.push(self.values.next(item)?);
                    }
                }
            }
        }
        self.values.end_record();
        Some(())
    }

    /// Vertices that nothing connects are points.
    fn finish(mut self) -> Facets {
        if !self.has_surface {
            self.facets.points = (0..u32::try_from(self.facets.positions.len()).unwrap_or(0)).collect();
        }
        if !self.facets.triangle_extras.is_empty() {
            self.facets.triangle_extras.resize(self.facets.triangles.len(), [ABSENT; 3]);
        }
        self.facets
    }

    fn place(&self) -> Place {
        let wide = |n: usize| u64::try_from(n).unwrap_or(u64::MAX);
        match self.values.place() {
            (Some(lines), _) => Place::Line(self.header.lines + u64::from(lines) + 1),
            (None, offset) => Place::Byte(wide(self.header.body + offset)),
        }
    }

    fn warn(&mut self, message: String) -> Result<(), LoadError> {
        let place = self.place();
        self.findings.warn(self.file, place, WarningKind::InvalidElement, message)
    }

    fn malformed(&self, message: String) -> LoadError {
        LoadError::malformed(self.file, self.place(), message)
    }

    fn ended(&self) -> LoadError {
        self.malformed("file ends early, or a value is not a number".to_owned())
    }
}

/// How records can be read quickly.
enum Plan {
    /// Binary records of this many bytes.
    Fixed(usize),
    /// A list of indices of this type with a one-byte count, and nothing else.
    Triangles(Scalar),
    General,
}

impl Plan {
    fn of(layout: &Layout) -> Self {
        match (layout.fixed_bytes(), layout.steps.as_slice()) {
            (Some(bytes), _) => Self::Fixed(bytes),
            (None, &[Step::List(Scalar::U8 | Scalar::I8, item, Some(ListSlot::Corners))]) => Self::Triangles(item),
            _ => Self::General,
        }
    }
}

/// How the colours of an element are scaled.
struct Palette {
    scale: [f64; 4],
    has_alpha: bool,
}

impl Palette {
    /// `None` if the element has no colours.
    fn of(layout: &Layout) -> Option<Self> {
        let full = |slot: Slot| layout.scalar(slot).map(|scalar| 1.0 / scalar.full_scale());
        let alpha = full(Slot::Alpha);
        let scale = [full(Slot::Red)?, full(Slot::Green)?, full(Slot::Blue)?, alpha.unwrap_or(1.0)];
        Some(Self { scale, has_alpha: alpha.is_some() })
    }

    fn linear(&self, slots: &[f64; Slot::COUNT]) -> [f32; 4] {
        let value = |slot: Slot, i: usize| to_f32(slots[slot as usize] * self.scale[i]);
        let alpha = if self.has_alpha { value(Slot::Alpha, 3) } else { 1.0 };
        linear_from_srgb([value(Slot::Red, 0), value(Slot::Green, 1), value(Slot::Blue, 2), alpha], 1.0)
    }
}

#[expect(clippy::cast_possible_truncation, reason = "rounding to f32 is the purpose")]
fn to_f32(value: f64) -> f32 {
    value as f32
}

/// A vertex index, if the value is one.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in range by the test")]
fn to_index(value: f64) -> Option<u32> {
    (value >= 0.0 && value < f64::from(u32::MAX)).then_some(value as u32)
}

/// A list length, if the value is one.
fn to_count(value: f64) -> Option<u64> {
    to_index(value).map(u64::from)
}
