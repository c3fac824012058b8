//! Marker segments: what they say of the picture, of the tables and of a scan.
//!
//! Tables are replaced as the file goes on, so each scan sees those before it. Which component a scan's data belong to,
//! and with which tables, is looked up here once.

use std::ops::RangeInclusive;

use super::huffman::HuffmanTable;
use super::idct::Block;
use super::upsample::Plane;
use crate::decode::reader::Reader;
use crate::{DecodeError, Format, Limits};

/// Order in which coefficients are stored: from low to high frequencies, as places in rows of 8.
pub(super) const ZIGZAG: [u8; 64] = [
    0, 1, 8, 16, 9, 2, 3, 10, 17, 24, 32, 25, 18, 11, 4, 5, 12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6, 7, 14, 21,
    28, 35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51, 58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54,
    47, 55, 62, 63,
];

/// The picture: its size and its components.
pub(super) struct Frame {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) is_progressive: bool,
    pub(super) components: Vec<Component>,
    /// Columns and rows of the smallest units that have whole blocks of every component.
    pub(super) units: (usize, usize),
}

pub(super) struct Component {
    pub(super) id: u8,
    /// Blocks of this component in a unit, across and down.
    pub(super) sampling: (usize, usize),
    /// How many pixels of the picture a sample is wide and high.
    pub(super) expansion: (usize, usize),
    quantization: usize,
    /// Its quantization table, as it was when its first scan began.
    pub(super) quantizers: Option<[u16; 64]>,
    /// Columns and rows of blocks with samples that count.
    pub(super) blocks: (usize, usize),
    /// Blocks from one row to the next: those of whole units.
    pub(super) blocks_stored: usize,
    /// For each coefficient, in the order of [`ZIGZAG`]: the bits that its scans so far have left to later ones.
    bits_left: [Option<u8>; 64],
    /// The coefficients of a progressive picture, block by block; else empty.
    pub(super) coefficients: Vec<Block>,
    pub(super) plane: Plane,
}

/// What is kept from one segment to the next.
#[derive(Default)]
pub(super) struct Tables {
    quantizers: [Option<[u16; 64]>; 4],
    dc: [Option<HuffmanTable>; 4],
    ac: [Option<HuffmanTable>; 4],
    /// Units between restart markers; 0 for none.
    pub(super) restart_interval: usize,
}

/// One component of a scan.
pub(super) struct ScanComponent<'a> {
    /// Index into the frame's components.
    pub(super) index: usize,
    pub(super) dc: Option<&'a HuffmanTable>,
    pub(super) ac: Option<&'a HuffmanTable>,
}

/// Which part of which coefficients a scan brings.
pub(super) struct Scan<'a> {
    pub(super) components: Vec<ScanComponent<'a>>,
    /// First and last coefficient, in the order of [`ZIGZAG`].
    pub(super) band: RangeInclusive<usize>,
    /// Whether earlier scans brought the higher bits.
    pub(super) is_refinement: bool,
    /// Bits that are left to later scans.
    pub(super) low_bits: u32,
}

impl Frame {
    /// Reads a frame header (T.81, B.2.2) and checks the size before anything is allocated.
    pub(super) fn read(segment: &mut Reader<'_>, is_progressive: bool, limits: &Limits) -> Result<Self, DecodeError> {
        let [bits, h1, h0, w1, w0, count] = segment.array("frame header")?;
        if bits != 8 {
            return Err(DecodeError::unsupported(Format::Jpeg, format!("{bits} bits per component; write it with 8")));
        }
        let (width, height) = (u16::from_be_bytes([w1, w0]), u16::from_be_bytes([h1, h0]));
        if height == 0 {
            return Err(DecodeError::unsupported(Format::Jpeg, "a height that is said after the picture"));
        }
        if width == 0 {
            return Err(segment.malformed("the width is at least 1"));
        }
        if !matches!(count, 1 | 3 | 4) {
            return Err(DecodeError::unsupported(Format::Jpeg, format!("{count} components")));
        }
        let headers = (0..count).map(|_| segment.array::<3>("frame header")).collect::<Result<Vec<_>, _>>()?;
        // A progressive picture works with three bytes for each sample: with three components, more than as much again.
        limits.check(u32::from(width), u32::from(height), if is_progressive && count > 2 { 8 } else { 4 })?;
        let (width, height) = (usize::from(width), usize::from(height));
        let factors = |&[_, factors, _]: &[u8; 3]| (usize::from(factors >> 4), usize::from(factors & 15));
        let largest = headers.iter().map(factors).fold((1, 1), |a, b| (a.0.max(b.0), a.1.max(b.1)));
        let units = (width.div_ceil(8 * largest.0), height.div_ceil(8 * largest.1));
        let mut components = Vec::with_capacity(headers.len());
        for header in &headers {
            let (h, v) = factors(header);
            if !(1..=4).contains(&h) || !(1..=4).contains(&v) || header[2] > 3 {
                return Err(segment.malformed("sampling factors are 1 to 4, and table numbers 0 to 3"));
            }
            if largest.0 % h != 0 || largest.1 % v != 0 {
                return Err(DecodeError::unsupported(Format::Jpeg, "sampling factors that do not divide the largest"));
            }
            components.push(Component::new(header, (width, height), largest, units, is_progressive));
        }
        Ok(Self { width, height, is_progressive, components, units })
    }
}

impl Component {
    fn new(
        &[id, factors, quantization]: &[u8; 3],
        (width, height): (usize, usize),
        largest: (usize, usize),
        units: (usize, usize),
        is_progressive: bool,
    ) -> Self {
        let (h, v) = (usize::from(factors >> 4), usize::from(factors & 15));
        let (width, height) = ((width * h).div_ceil(largest.0), (height * v).div_ceil(largest.1));
        let (columns, rows) = (units.0 * h, units.1 * v);
        Self {
            id,
            sampling: (h, v),
            expansion: (largest.0 / h, largest.1 / v),
            quantization: usize::from(quantization),
            quantizers: None,
            blocks: (width.div_ceil(8), height.div_ceil(8)),
            blocks_stored: columns,
            bits_left: [None; 64],
            coefficients: vec![[0; 64]; if is_progressive { columns * rows } else { 0 }],
            plane: Plane { width, height, stride: columns * 8, samples: vec![0; columns * rows * 64] },
        }
    }
}

impl Tables {
    /// Reads quantization tables (T.81, B.2.4.1).
    pub(super) fn read_quantizers(&mut self, segment: &mut Reader<'_>) -> Result<(), DecodeError> {
        while !segment.rest().is_empty() {
            let head = segment.u8("quantization table")?;
            let Some(table) = self.quantizers.get_mut(usize::from(head & 15)) else {
                return Err(segment.malformed("quantization tables are numbered 0 to 3"));
            };
            let mut values = [0; 64];
            for place in ZIGZAG {
                values[usize::from(place)] = match head >> 4 {
                    0 => u16::from(segment.u8("quantization table")?),
                    _ => u16::from_be_bytes(segment.array("quantization table")?),
                };
            }
            *table = Some(values);
        }
        Ok(())
    }

    /// Reads Huffman tables (T.81, B.2.4.2).
    pub(super) fn read_codes(&mut self, segment: &mut Reader<'_>) -> Result<(), DecodeError> {
        while !segment.rest().is_empty() {
            let head = segment.u8("Huffman table")?;
            let counts: [u8; 16] = segment.array("Huffman table")?;
            let symbols = segment.take(counts.iter().map(|&count| usize::from(count)).sum(), "Huffman table")?;
            let kind = if head >> 4 == 0 { &mut self.dc } else { &mut self.ac };
            let table = kind.get_mut(usize::from(head & 15)).filter(|_| head < 0x20);
            let (Some(table), Some(codes)) = (table, HuffmanTable::new(&counts, symbols)) else {
                return Err(segment.malformed("a Huffman table is one of four of a kind, with codes of its lengths"));
            };
            *table = Some(codes);
        }
        Ok(())
    }

    /// Reads the header of a scan (T.81, B.2.3) and gives its components their quantization tables.
    pub(super) fn read_scan(&self, segment: &mut Reader<'_>, frame: &mut Frame) -> Result<Scan<'_>, DecodeError> {
        let count = segment.u8("scan header")?;
        let mut components = Vec::new();
        for _ in 0..count {
            let [id, tables] = segment.array("scan header")?;
            // Of components with the same name, the first that the scan does not have yet.
            let is_free = |index: usize| components.iter().all(|part: &ScanComponent<'_>| part.index != index);
            let mut named =
                (0..).zip(&frame.components).filter(|(index, component)| component.id == id && is_free(*index));
            let Some((index, _)) = named.next() else {
                return Err(segment.malformed("a scan names components of the frame, each once"));
            };
            let component = &mut frame.components[index];
            component.quantizers = component.quantizers.or(self.quantizers[component.quantization]);
            if component.quantizers.is_none() {
                return Err(segment.malformed("a component has no quantization table"));
            }
            components.push(ScanComponent {
                index,
                dc: self.dc.get(usize::from(tables >> 4)).and_then(Option::as_ref),
                ac: self.ac.get(usize::from(tables & 15)).and_then(Option::as_ref),
            });
        }
        let [first, last, bits] = segment.array("scan header")?;
        // Other pictures have one scan for a component, whatever is written here.
        let [first, last, bits] = if frame.is_progressive { [first, last, bits] } else { [0, 63, 0] };
        let is_sound = if first == 0 { last == 0 || !frame.is_progressive } else { count == 1 && first <= last };
        if components.is_empty() || !is_sound || last > 63 || bits & 15 > 13 {
            return Err(segment.malformed("a scan has components, and brings means or a band of one of them"));
        }
        let (band, high, low) = (usize::from(first)..=usize::from(last), bits >> 4, bits & 15);
        for part in components.iter().filter(|_| frame.is_progressive) {
            for left in &mut frame.components[part.index].bits_left[band.clone()] {
                // One bit at a time, of those that are missing (T.81, G.1.1.1.2): so a file cannot refine without end.
                if high != 0 && (*left != Some(high) || high != low + 1) {
                    return Err(segment.malformed("a scan refines coefficients by the next bit that is missing"));
                }
                *left = Some(low);
            }
        }
        Ok(Scan { components, band, is_refinement: high != 0, low_bits: u32::from(low) })
    }
}
