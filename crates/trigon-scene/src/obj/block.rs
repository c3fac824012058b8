//! Parsing one block of lines: text in, attribute values, encoded indices and state changes out.
//!
//! Nothing here depends on other blocks. Numbers and indices are read in place; names stay slices of the text. What is
//! wrong is noted with its line and left out, so that parsing never fails.

use super::element::encode;
use crate::geometry::{ABSENT, Corner};
use crate::load::{Findings, WarningKind};
use crate::text::{Cursor, decode_name};

/// What a block of lines says.
#[derive(Default)]
pub(super) struct Block<'a> {
    pub(super) positions: Vec<[f32; 3]>,
    /// Colours as written; empty, or from the first to the last position of the block. NaN where not given.
    pub(super) colors: Vec<[f32; 4]>,
    /// Inside convention: v down.
    pub(super) uvs: Vec<[f32; 2]>,
    pub(super) normals: Vec<[f32; 3]>,
    pub(super) faces: Polylines,
    pub(super) lines: Polylines,
    /// Position codes of points.
    pub(super) points: Vec<u32>,
    pub(super) point_lines: LineMap,
    pub(super) events: Vec<Event<'a>>,
    /// Statements of the format that are not read, and the line of the first of each.
    pub(super) ignored: Vec<(&'a [u8], u32)>,
    /// The first word that begins no statement, and its line.
    pub(super) first_unknown: Option<(&'a [u8], u32)>,
    /// Lines that begin with such words.
    pub(super) unknown_lines: usize,
    pub(super) notes: Vec<Note>,
    /// Findings beyond those noted.
    pub(super) suppressed_notes: usize,
    /// Line ends in the block.
    pub(super) n_lines: u32,
}

/// Corner lists of varying length, as runs of equal length: mostly one run of triangles.
#[derive(Default)]
pub(super) struct Polylines {
    pub(super) corners: Vec<Corner>,
    /// (corners of each, how many) in order.
    pub(super) runs: Vec<(u32, u32)>,
    /// The number of lists.
    pub(super) count: u32,
    lines: LineMap,
}

impl Polylines {
    /// Ends the list whose corners were pushed since there were `start`.
    #[inline(always)]
    fn close(&mut self, start: usize, line: u32) {
        let len = u32::try_from(self.corners.len() - start).unwrap_or(u32::MAX);
        self.lines.insert(self.count, line);
        self.count += 1;
        match self.runs.last_mut() {
            Some((run_len, times)) if *run_len == len => *times += 1,
            _ => self.runs.push((len, 1)),
        }
    }

    /// The number of triangles that the lists make as polygons.
    pub(super) fn triangle_count(&self) -> u64 {
        self.runs.iter().map(|&(len, times)| u64::from(len.saturating_sub(2)) * u64::from(times)).sum()
    }

    /// The zero-based line in the block of a list.
    pub(super) fn line(&self, list: u32) -> u32 {
        self.lines.get(list)
    }

    /// The length of each list, in order.
    pub(super) fn lengths(&self) -> impl Iterator<Item = usize> + '_ {
        self.runs.iter().flat_map(|&(len, times)| {
            std::iter::repeat_n(usize::try_from(len).unwrap_or(usize::MAX), usize::try_from(times).unwrap_or(0))
        })
    }
}

/// The line of each element, stored where it is not the line after the previous element's.
#[derive(Default)]
pub(super) struct LineMap {
    /// (element, line), both ascending.
    jumps: Vec<(u32, u32)>,
    expected: u32,
}

impl LineMap {
    /// Notes the line of the next element.
    #[inline(always)]
    fn insert(&mut self, element: u32, line: u32) {
        if line != self.expected || element == 0 {
            self.jumps.push((element, line));
        }
        self.expected = line + 1;
    }

    pub(super) fn get(&self, element: u32) -> u32 {
        let after = self.jumps.partition_point(|&(first, _)| first <= element);
        let jump = after.checked_sub(1).and_then(|i| self.jumps.get(i));
        jump.map_or(0, |&(first, line)| line + (element - first))
    }
}

/// A change of state between primitives.
pub(super) struct Event<'a> {
    pub(super) kind: EventKind,
    /// The argument as written.
    pub(super) name: &'a [u8],
    /// Primitives of the block that come before.
    pub(super) before: Before,
    /// Zero-based line in the block.
    pub(super) line: u32,
}

/// Numbers of faces, lines and points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Before {
    pub(super) faces: u32,
    pub(super) lines: u32,
    pub(super) points: u32,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum EventKind {
    Object,
    Group,
    Smoothing,
    Material,
    Library,
}

/// A finding in the block.
pub(super) struct Note {
    /// Zero-based line in the block.
    pub(super) line: u32,
    pub(super) kind: WarningKind,
    pub(super) message: String,
}

impl<'a> Block<'a> {
    pub(super) fn parse(text: &'a [u8]) -> Self {
        let mut block = Self::with_capacity(text);
        let mut cursor = Cursor::new(text);
        while !cursor.is_at_end() {
            block.line(&mut cursor);
        }
        block.n_lines = cursor.lines();
        if !block.colors.is_empty() {
            block.colors.resize(block.positions.len(), NO_COLOR);
        }
        block
    }

    /// Guesses sizes from the first statement, so that the usual block of one kind grows without copies.
    fn with_capacity(text: &[u8]) -> Self {
        let mut block = Self::default();
        let lines = text.len() / 32;
        match text {
            [b'v', b'n', ..] => block.normals.reserve(lines),
            [b'v', b't', ..] => block.uvs.reserve(lines),
            [b'v', ..] => block.positions.reserve(lines),
            [b'f', ..] => block.faces.corners.reserve(lines * 3),
            _ => {}
        }
        block
    }

    /// One line, the statements of meshes first.
    #[inline(always)]
    fn line(&mut self, cursor: &mut Cursor<'a>) {
        cursor.skip_blanks();
        match [cursor.peek(), cursor.peek_ahead(1), cursor.peek_ahead(2)] {
            [b'v', b' ' | b'\t', _] => {
                cursor.skip(1);
                self.position(cursor);
            }
            [b'f', b' ' | b'\t', _] => {
                cursor.skip(1);
                self.face(cursor);
            }
            [b'v', b't', b' ' | b'\t'] => {
                cursor.skip(2);
                self.uv(cursor);
            }
            [b'v', b'n', b' ' | b'\t'] => {
                cursor.skip(2);
                self.normal(cursor);
            }
            [b'#', ..] => return cursor.finish_comment(),
            [b'\n' | b'\r', ..] => {}
            _ => self.statement(cursor),
        }
        cursor.finish_line();
    }

    #[inline(always)]
    fn position(&mut self, cursor: &mut Cursor<'a>) {
        let position = [self.number(cursor), self.number(cursor), self.number(cursor)];
        self.positions.push(position);
        cursor.skip_blanks();
        if !cursor.is_at_line_end() {
            self.position_extras(cursor);
        } else if !self.colors.is_empty() {
            self.colors.push(NO_COLOR);
        }
    }

    /// What follows x y z: one value is the weight of rational curves, which meshes do not use; three are red green
    /// blue; four are red green blue alpha.
    fn position_extras(&mut self, cursor: &mut Cursor<'a>) {
        let mut extras = NO_COLOR;
        let mut count = 0;
        while let Some(value) = self.optional_number(cursor) {
            if let Some(extra) = extras.get_mut(count) {
                *extra = value;
            }
            count += 1;
        }
        if count >= 3 {
            if self.colors.is_empty() {
                self.colors.resize(self.positions.len() - 1, NO_COLOR);
            }
            self.colors.push(extras);
        } else if !self.colors.is_empty() {
            self.colors.push(NO_COLOR);
        }
    }

    #[inline(always)]
    fn uv(&mut self, cursor: &mut Cursor<'a>) {
        let u = self.number(cursor);
        let v_up = self.optional_number(cursor).unwrap_or(0.0);
        self.uvs.push([u, 1.0 - v_up]);
    }

    #[inline(always)]
    fn normal(&mut self, cursor: &mut Cursor<'a>) {
        let normal = [self.number(cursor), self.number(cursor), self.number(cursor)];
        self.normals.push(normal);
    }

    /// A number that must be there; zero, and a note, where it is not.
    #[inline(always)]
    fn number(&mut self, cursor: &mut Cursor<'a>) -> f32 {
        match cursor.float() {
            Ok(Some(value)) => value,
            Ok(None) => self.missing_number(cursor.lines()),
            Err(token) => self.bad_number(token, cursor.lines()),
        }
    }

    #[inline(always)]
    fn optional_number(&mut self, cursor: &mut Cursor<'a>) -> Option<f32> {
        match cursor.float() {
            Ok(value) => value,
            Err(token) => Some(self.bad_number(token, cursor.lines())),
        }
    }

    #[cold]
    fn missing_number(&mut self, line: u32) -> f32 {
        const MESSAGE: &str = "fewer numbers than expected; 0 taken for the others";
        // Once for all that the line lacks.
        if self.notes.last().is_none_or(|note| note.line != line || note.message != MESSAGE) {
            self.note(line, WarningKind::InvalidValue, || MESSAGE.to_owned());
        }
        0.0
    }

    /// The number that the token begins with, as C's `strtod` would read it; zero if there is none.
    #[cold]
    fn bad_number(&mut self, token: &[u8], line: u32) -> f32 {
        let is_number_byte = |b: &u8| b.is_ascii_digit() || matches!(b, b'+' | b'-' | b'.' | b'e' | b'E');
        let longest = token.iter().take(64).take_while(|b| is_number_byte(b)).count();
        let prefixes = (1..=longest).rev().filter_map(|len| std::str::from_utf8(&token[..len]).ok()?.parse().ok());
        let value: f32 = prefixes.into_iter().next().unwrap_or(0.0);
        let shown = shorten(token);
        self.note(line, WarningKind::InvalidValue, || format!("{shown} is not a number; {value} taken for it"));
        value
    }

    #[inline(always)]
    fn face(&mut self, cursor: &mut Cursor<'a>) {
        let start = self.faces.corners.len();
        loop {
            cursor.skip_blanks();
            if cursor.is_at_line_end() {
                break;
            }
            match self.corner(cursor) {
                Some(corner) => self.faces.corners.push(corner),
                None if cursor.peek() == b'#' => break,
                None => return self.bad_element(cursor, start, "face"),
            }
        }
        if self.faces.corners.len() - start >= 3 {
            self.faces.close(start, cursor.lines());
        } else {
            self.bad_element(cursor, start, "face");
        }
    }

    /// One of `v`, `v/t`, `v//n`, `v/t/n`; also with an empty last index, as some exporters write.
    #[inline(always)]
    fn corner(&mut self, cursor: &mut Cursor<'a>) -> Option<Corner> {
        let position = encode(cursor.integer()?, self.positions.len());
        if cursor.peek() != b'/' {
            return Some([position, ABSENT, ABSENT]);
        }
        cursor.skip(1);
        let uv = cursor.integer().map_or(ABSENT, |index| encode(index, self.uvs.len()));
        if cursor.peek() != b'/' {
            return Some([position, uv, ABSENT]);
        }
        cursor.skip(1);
        let normal = cursor.integer().map_or(ABSENT, |index| encode(index, self.normals.len()));
        Some([position, uv, normal])
    }

    /// Takes back the corners of an element that cannot be used.
    #[cold]
    fn bad_element(&mut self, cursor: &mut Cursor<'a>, start: usize, what: &'static str) {
        let n_corners = self.faces.corners.len() - start;
        self.faces.corners.truncate(start);
        let line = cursor.lines();
        cursor.skip_blanks();
        let shown = shorten(cursor.word());
        self.note(line, WarningKind::InvalidElement, || match shown.is_empty() || n_corners >= 3 {
            true => format!("{what} with {n_corners} corners left out; it needs 3 or more"),
            false => format!("{what} left out: {shown} is not an index like 1, 1/2, 1//3 or 1/2/3"),
        });
    }

    /// Everything but the mesh statements.
    #[cold]
    fn statement(&mut self, cursor: &mut Cursor<'a>) {
        let line = cursor.lines();
        match cursor.word() {
            b"l" => self.polyline(cursor),
            b"p" => self.point_list(cursor),
            b"o" => self.event(cursor, EventKind::Object),
            b"g" => self.event(cursor, EventKind::Group),
            b"s" => self.event(cursor, EventKind::Smoothing),
            b"usemtl" => self.event(cursor, EventKind::Material),
            b"mtllib" => self.event(cursor, EventKind::Library),
            // Continued right after the keyword, or without arguments; `fo` is an old spelling.
            b"v" => self.position(cursor),
            b"vt" => self.uv(cursor),
            b"vn" => self.normal(cursor),
            b"f" | b"fo" => self.face(cursor),
            word => self.ignore(word, line),
        }
    }

    /// Notes an unread statement, once per block and keyword, or a line that is none.
    fn ignore(&mut self, word: &'a [u8], line: u32) {
        if why_ignored(word).is_empty() {
            self.first_unknown = self.first_unknown.or(Some((word, line)));
            self.unknown_lines += 1;
        } else if self.ignored.iter().all(|(known, _)| *known != word) {
            self.ignored.push((word, line));
        }
    }

    fn polyline(&mut self, cursor: &mut Cursor<'a>) {
        let start = self.lines.corners.len();
        loop {
            cursor.skip_blanks();
            let Some(corner) = self.corner(cursor) else { break };
            self.lines.corners.push(corner);
        }
        if self.lines.corners.len() - start >= 2 {
            return self.lines.close(start, cursor.lines());
        }
        self.lines.corners.truncate(start);
        self.note(cursor.lines(), WarningKind::InvalidElement, || "line with fewer than 2 points left out".to_owned());
    }

    fn point_list(&mut self, cursor: &mut Cursor<'a>) {
        loop {
            cursor.skip_blanks();
            let Some([position, ..]) = self.corner(cursor) else { return };
            self.point_lines.insert(u32::try_from(self.points.len()).unwrap_or(u32::MAX), cursor.lines());
            self.points.push(position);
        }
    }

    /// Records a state change; one that nothing used replaces its predecessor, so that they cannot pile up.
    fn event(&mut self, cursor: &mut Cursor<'a>, kind: EventKind) {
        let line = cursor.lines();
        let name = cursor.rest_of_line();
        let points = u32::try_from(self.points.len()).unwrap_or(u32::MAX);
        let before = Before { faces: self.faces.count, lines: self.lines.count, points };
        let event = Event { kind, name, before, line };
        let recent = self.events.iter_mut().rev().take_while(|event| event.before == before).take(4);
        match recent.into_iter().find(|event| event.kind == kind && kind != EventKind::Library) {
            Some(unused) => *unused = event,
            None => self.events.push(event),
        }
    }

    fn note(&mut self, line: u32, kind: WarningKind, message: impl FnOnce() -> String) {
        if self.notes.len() < Findings::MAX {
            self.notes.push(Note { line, kind, message: message() });
        } else {
            self.suppressed_notes += 1;
        }
    }
}

/// The colour of a position that the file gives none, whatever the range of the others: becomes white.
pub(super) const NO_COLOR: [f32; 4] = [f32::NAN; 4];

/// A word of the file for a message, not more than 40 bytes of it.
pub(super) fn shorten(word: &[u8]) -> String {
    let shown = decode_name(word.get(..40).unwrap_or(word)).into_owned();
    if word.len() > 40 { format!("{shown}...") } else { shown }
}

/// The reason why a statement of the format is not read.
pub(super) fn why_ignored(word: &[u8]) -> &'static str {
    match word {
        b"vp" | b"cstype" | b"deg" | b"bmat" | b"step" | b"curv" | b"curv2" | b"surf" | b"parm" | b"trim" | b"hole"
        | b"scrv" | b"sp" | b"end" | b"con" | b"bzp" | b"bsp" | b"cdc" | b"cdp" | b"res" | b"ctech" | b"stech" => {
            ": free-form curves and surfaces are not drawn"
        }
        b"call" | b"csh" => ": commands are never run",
        b"mg" | b"bevel" | b"c_interp" | b"d_interp" | b"lod" | b"shadow_obj" | b"trace_obj" | b"maplib"
        | b"usemap" => ": display attributes are not used",
        _ => "",
    }
}
