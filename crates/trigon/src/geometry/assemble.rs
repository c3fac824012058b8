//! Primitive assembly: which vertices make which triangle, line or point, and chunks' unique vertices.
//!
//! In: a draw's index list. Out: for one chunk, each vertex number once, in order of first use, and every corner as a
//! number among those.

/// Vertex numbers, a primitive after the other.
#[derive(Clone, Copy, Debug)]
pub enum Indices<'a> {
    /// 0, 1, 2, .. up to this count.
    Sequence(u32),
    /// Listed.
    List(&'a [u32]),
}

impl Indices<'_> {
    fn len(&self) -> usize {
        match self {
            Self::Sequence(count) => *count as usize,
            Self::List(list) => list.len(),
        }
    }

    #[inline(always)]
    fn get(&self, i: usize) -> u32 {
        match self {
            Self::Sequence(_) => i as u32,
            Self::List(list) => list[i],
        }
    }
}

/// What a draw is made of. Incomplete primitives at the end of the list are ignored.
#[derive(Clone, Copy, Debug)]
pub enum Primitives<'a> {
    /// Three indices each.
    Triangles(Indices<'a>),
    /// Two indices each.
    Lines {
        /// The ends.
        indices: Indices<'a>,
        /// In pixels, up to 4096.
        width_px: f32,
    },
    /// One index each.
    Points {
        /// The centres.
        indices: Indices<'a>,
        /// Side of the square, in pixels, up to 4096.
        size_px: f32,
    },
}

impl<'a> Primitives<'a> {
    /// Indices per primitive.
    #[must_use]
    pub fn arity(&self) -> usize {
        match self {
            Self::Triangles(_) => 3,
            Self::Lines { .. } => 2,
            Self::Points { .. } => 1,
        }
    }

    /// The index list.
    #[must_use]
    pub fn indices(&self) -> Indices<'a> {
        match *self {
            Self::Triangles(indices) | Self::Lines { indices, .. } | Self::Points { indices, .. } => indices,
        }
    }

    /// How many primitives.
    #[must_use]
    pub fn count(&self) -> usize {
        self.indices().len() / self.arity()
    }

    /// The vertices of primitive `i`, as three: lines and points repeat theirs.
    #[inline(always)]
    pub(crate) fn vertices(&self, i: usize) -> [u32; 3] {
        let (indices, at) = (self.indices(), i * self.arity());
        match self {
            Self::Triangles(_) => [indices.get(at), indices.get(at + 1), indices.get(at + 2)],
            Self::Lines { .. } => [indices.get(at), indices.get(at + 1), indices.get(at)],
            Self::Points { .. } => [indices.get(at); 3],
        }
    }
}

/// Which triangles are not drawn for the side they show.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Cull {
    /// Draw both sides.
    #[default]
    None,
    /// Drop triangles whose vertices appear clockwise.
    Back,
    /// Drop triangles whose vertices appear counter-clockwise.
    Front,
}

impl Cull {
    /// Whether a triangle that shows its front (or not) is dropped.
    #[inline(always)]
    pub(crate) fn drops(self, is_front: bool) -> bool {
        match self {
            Self::None => false,
            Self::Back => !is_front,
            Self::Front => is_front,
        }
    }
}

/// Numbers each vertex of a chunk once.
#[derive(Default)]
pub(crate) struct VertexNumbering {
    /// By vertex: the chunk that last used it, and its number there.
    stamps: Vec<(u32, u32)>,
    serial: u32,
    /// The chunk's vertices, in order of first use.
    pub(crate) unique: Vec<u32>,
    /// Three numbers per primitive.
    pub(crate) corners: Vec<[u32; 3]>,
}

impl VertexNumbering {
    /// Numbers the vertices of primitives `first .. first + count`.
    pub(crate) fn run(&mut self, primitives: &Primitives<'_>, first: usize, count: usize) {
        self.unique.clear();
        self.corners.clear();
        self.begin_chunk();
        for i in first..first + count {
            let vertices = primitives.vertices(i);
            let mut corners = [0; 3];
            for k in 0..3 {
                corners[k] = self.number(vertices[k]);
            }
            self.corners.push(corners);
        }
    }

    /// Makes every stamp stale without touching it.
    fn begin_chunk(&mut self) {
        if self.serial == u32::MAX {
            self.stamps.clear();
            self.serial = 0;
        }
        self.serial += 1;
    }

    #[inline(always)]
    fn number(&mut self, vertex: u32) -> u32 {
        // Beyond this, a vertex number is given again for every use: slower, but bounded in memory.
        const MAX_STAMPS: usize = 1 << 26;
        let slot = vertex as usize;
        if slot >= self.stamps.len() {
            if slot >= MAX_STAMPS {
                self.unique.push(vertex);
                return (self.unique.len() - 1) as u32;
            }
            self.stamps.resize((slot + 1).next_power_of_two(), (0, 0));
        }
        let (serial, number) = self.stamps[slot];
        if serial == self.serial {
            return number;
        }
        let number = self.unique.len() as u32;
        self.stamps[slot] = (self.serial, number);
        self.unique.push(vertex);
        number
    }
}
