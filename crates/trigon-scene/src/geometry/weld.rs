//! Welding: equal positions get one index, in order of first use.

/// Numbers distinct positions; a hash table with linear probing.
pub(crate) struct Welder {
    /// Index of a position, or [`EMPTY`]; the length is a power of two, at most half full.
    slots: Vec<u32>,
    positions: Vec<[f32; 3]>,
}

const EMPTY: u32 = u32::MAX;

impl Welder {
    /// For about `expected` positions.
    pub(crate) fn with_capacity(expected: usize) -> Self {
        let slots = (2 * expected).next_power_of_two().max(16);
        Self { slots: vec![EMPTY; slots], positions: Vec::with_capacity(expected) }
    }

    /// The index of the position; positions are equal if their components are, so zero equals minus zero. NaN has one
    /// index per bit pattern.
    pub(crate) fn index(&mut self, position: [f32; 3]) -> u32 {
        // Adding zero makes minus zero plus zero.
        let position = position.map(|c| c + 0.0);
        let bits = position.map(f32::to_bits);
        let mask = self.slots.len() - 1;
        let mut slot = hash(bits) & mask;
        while self.slots[slot] != EMPTY {
            let index = self.slots[slot];
            if self.positions[index as usize].map(f32::to_bits) == bits {
                return index;
            }
            slot = (slot + 1) & mask;
        }
        let index = u32::try_from(self.positions.len()).unwrap_or(EMPTY - 1);
        self.slots[slot] = index;
        self.positions.push(position);
        if self.positions.len() * 2 > self.slots.len() {
            self.grow();
        }
        index
    }

    pub(crate) fn into_positions(self) -> Vec<[f32; 3]> {
        self.positions
    }

    #[cold]
    fn grow(&mut self) {
        self.slots = vec![EMPTY; self.slots.len() * 2];
        let mask = self.slots.len() - 1;
        for (index, position) in (0_u32..).zip(&self.positions) {
            let mut slot = hash(position.map(f32::to_bits)) & mask;
            while self.slots[slot] != EMPTY {
                slot = (slot + 1) & mask;
            }
            self.slots[slot] = index;
        }
    }
}

/// Mixes the bits so that neighbours on a grid spread over the table (multipliers of SplitMix64).
fn hash([x, y, z]: [u32; 3]) -> usize {
    let mut h = u64::from(x) | (u64::from(y) << 32);
    h = (h ^ (h >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9) ^ u64::from(z).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    h = (h ^ (h >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    #[expect(clippy::cast_possible_truncation, reason = "any bits will do")]
    {
        (h ^ (h >> 31)) as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_positions_share_an_index_through_growth() {
        let mut welder = Welder::with_capacity(0);
        let at = |i: u16| [f32::from(i % 50), f32::from(i / 50), -0.0];
        for round in 0..2 {
            for i in 0..2500 {
                assert_eq!(welder.index(at(i)), u32::from(i), "round {round}");
            }
        }
        assert_eq!(welder.index([0.0, -0.0, 0.0]), 0);
        assert_eq!(welder.into_positions().len(), 2500);
    }
}
