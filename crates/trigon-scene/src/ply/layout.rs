//! Which properties of an element are used, and for what.

use super::header::{Element, Property, Scalar, Shape};

/// What a scalar property means for a vertex or face; the value is its place in a record of slots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Slot {
    X,
    Y,
    Z,
    NormalX,
    NormalY,
    NormalZ,
    U,
    V,
    Red,
    Green,
    Blue,
    Alpha,
    EdgeStart,
    EdgeEnd,
}

impl Slot {
    pub(super) const COUNT: usize = 14;

    fn of(name: &str) -> Option<Self> {
        Some(match name {
            "x" => Self::X,
            "y" => Self::Y,
            "z" => Self::Z,
            "nx" | "normal_x" => Self::NormalX,
            "ny" | "normal_y" => Self::NormalY,
            "nz" | "normal_z" => Self::NormalZ,
            "s" | "u" | "texture_u" | "tex_u" | "tu" => Self::U,
            "t" | "v" | "texture_v" | "tex_v" | "tv" => Self::V,
            "red" | "r" | "diffuse_red" => Self::Red,
            "green" | "g" | "diffuse_green" => Self::Green,
            "blue" | "b" | "diffuse_blue" => Self::Blue,
            "alpha" | "a" | "diffuse_alpha" => Self::Alpha,
            "vertex1" => Self::EdgeStart,
            "vertex2" => Self::EdgeEnd,
            _ => return None,
        })
    }
}

/// What a list property means for a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ListSlot {
    /// Vertex indices.
    Corners,
    /// Texture coordinates u v u v ... of the corners.
    Uvs,
}

impl ListSlot {
    fn of(name: &str) -> Option<Self> {
        match name {
            "vertex_indices" | "vertex_index" => Some(Self::Corners),
            "texcoord" => Some(Self::Uvs),
            _ => None,
        }
    }
}

/// One property in reading order.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    Scalar(Scalar, Option<Slot>),
    List(Scalar, Scalar, Option<ListSlot>),
}

/// The properties of an element, resolved.
pub(super) struct Layout {
    pub(super) steps: Vec<Step>,
    /// Type of each slot that the element has.
    types: [Option<Scalar>; Slot::COUNT],
}

impl Layout {
    pub(super) fn of(element: &Element) -> Self {
        let mut types = [None; Slot::COUNT];
        let step = |property: &Property| match property.shape {
            Shape::Scalar(scalar) => {
                // Of two properties with one meaning the first counts.
                let slot = Slot::of(&property.name).filter(|&slot| types[slot as usize].is_none());
                if let Some(slot) = slot {
                    types[slot as usize] = Some(scalar);
                }
                Step::Scalar(scalar, slot)
            }
            Shape::List(count, item) => Step::List(count, item, ListSlot::of(&property.name)),
        };
        Self { steps: element.properties.iter().map(step).collect(), types }
    }

    pub(super) fn has(&self, slots: &[Slot]) -> bool {
        slots.iter().all(|&slot| self.types[slot as usize].is_some())
    }

    pub(super) fn scalar(&self, slot: Slot) -> Option<Scalar> {
        self.types[slot as usize]
    }

    pub(super) fn has_list(&self, wanted: ListSlot) -> bool {
        self.steps.iter().any(|step| matches!(step, Step::List(_, _, Some(slot)) if *slot == wanted))
    }

    /// The bytes of a binary record, if all have the same size.
    pub(super) fn fixed_bytes(&self) -> Option<usize> {
        self.steps.iter().try_fold(0_usize, |sum, step| match step {
            Step::Scalar(scalar, _) => Some(sum + scalar.bytes()),
            Step::List(..) => None,
        })
    }

    /// The fewest values a record has.
    pub(super) fn least_values(&self) -> u64 {
        u64::try_from(self.steps.len()).unwrap_or(u64::MAX)
    }
}
