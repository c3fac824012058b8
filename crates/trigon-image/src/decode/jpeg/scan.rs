//! A scan: its bits in, coefficients or samples of the components out.
//!
//! The blocks of a scan of one component are its own, row by row; those of several are interleaved in units. Blocks of a
//! sequential picture are transformed at once; those of a progressive one gather bits until the last scan (T.81, F.2
//! and G.1).

use super::header::{Component, Frame, Scan, ScanComponent, ZIGZAG};
use super::huffman::{BitReader, HuffmanTable};
use super::idct::{Block, inverse_transform};
use crate::DecodeError;

/// Reads the bits of `scan` from `bits`, with restart markers every `restart_interval` units unless that is 0.
pub(super) fn read_scan(
    bits: &mut BitReader<'_>,
    scan: &Scan<'_>,
    frame: &mut Frame,
    restart_interval: usize,
) -> Result<(), DecodeError> {
    let (columns, rows) = match scan.components.as_slice() {
        [alone] => frame.components[alone.index].blocks,
        _ => frame.units,
    };
    let mut state = State::default();
    let mut restarts = 0_u8;
    for unit in 0..columns * rows {
        if restart_interval != 0 && unit != 0 && unit.is_multiple_of(restart_interval) {
            bits.restart(restarts)?;
            restarts = restarts.wrapping_add(1);
            state = State::default();
        }
        let (x, y) = (unit % columns, unit / columns);
        for part in &scan.components {
            let component = &mut frame.components[part.index];
            let (across, down) = if scan.components.len() == 1 { (1, 1) } else { component.sampling };
            for block in 0..across * down {
                let at = (x * across + block % across, y * down + block / across);
                if frame.is_progressive {
                    let index = at.1 * component.blocks_stored + at.0;
                    state.read_part(bits, scan, part, &mut component.coefficients[index])?;
                } else {
                    let block = state.read_block(bits, part)?;
                    draw_block(component, at, &block);
                }
            }
        }
    }
    Ok(())
}

/// Transforms the coefficients that the scans of a progressive picture have left, and drops them.
pub(super) fn draw_coefficients(component: &mut Component) {
    let coefficients = std::mem::take(&mut component.coefficients);
    for (index, block) in coefficients.iter().enumerate() {
        draw_block(component, (index % component.blocks_stored, index / component.blocks_stored), block);
    }
}

fn draw_block(component: &mut Component, (column, row): (usize, usize), block: &Block) {
    let Some(quantizers) = &component.quantizers else { return };
    let first = row * 8 * component.plane.stride + column * 8;
    inverse_transform(block, quantizers, &mut component.plane.samples[first..], component.plane.stride);
}

/// What one block leaves to the next.
#[derive(Default)]
struct State {
    /// Mean of the block before (the DC prediction), for each component of the frame.
    means: [i16; 4],
    /// Blocks to come that have nothing more in this band (EOBRUN).
    empty_blocks: u32,
}

impl State {
    /// All coefficients of a block (T.81, F.2.2).
    fn read_block(&mut self, bits: &mut BitReader<'_>, part: &ScanComponent<'_>) -> Result<Block, DecodeError> {
        let mut block = [0; 64];
        block[0] = self.read_mean(bits, part)?;
        let codes = required(bits, part.ac)?;
        let mut index = 1;
        while index < 64 {
            let symbol = bits.symbol(codes)?;
            let (zeros, size) = (usize::from(symbol >> 4), u32::from(symbol & 15));
            if size == 0 {
                if zeros != 15 {
                    break;
                }
                index += 16;
                continue;
            }
            index += zeros;
            *coefficient(bits, &mut block, index, 63)? = bits.difference(size)?;
            index += 1;
        }
        Ok(block)
    }

    /// What a scan of a progressive picture says of a block (T.81, G.1.2).
    fn read_part(
        &mut self,
        bits: &mut BitReader<'_>,
        scan: &Scan<'_>,
        part: &ScanComponent<'_>,
        block: &mut Block,
    ) -> Result<(), DecodeError> {
        match (*scan.band.start(), scan.is_refinement) {
            (0, false) => block[0] = self.read_mean(bits, part)? << scan.low_bits,
            (0, true) => block[0] |= i16::from(bits.take(1)? != 0) << scan.low_bits,
            (_, false) => self.read_band(bits, scan, required(bits, part.ac)?, block)?,
            (_, true) => self.refine_band(bits, scan, required(bits, part.ac)?, block)?,
        }
        Ok(())
    }

    fn read_mean(&mut self, bits: &mut BitReader<'_>, part: &ScanComponent<'_>) -> Result<i16, DecodeError> {
        let size = bits.symbol(required(bits, part.dc)?)?;
        if size > 15 {
            return Err(bits.malformed("the difference of two means has more than 15 bits"));
        }
        let mean = &mut self.means[part.index];
        *mean = mean.wrapping_add(bits.difference(u32::from(size))?);
        Ok(*mean)
    }

    /// The higher bits of a band of coefficients.
    fn read_band(
        &mut self,
        bits: &mut BitReader<'_>,
        scan: &Scan<'_>,
        codes: &HuffmanTable,
        block: &mut Block,
    ) -> Result<(), DecodeError> {
        if self.empty_blocks > 0 {
            self.empty_blocks -= 1;
            return Ok(());
        }
        let (mut index, last) = (*scan.band.start(), *scan.band.end());
        while index <= last {
            let symbol = bits.symbol(codes)?;
            let (zeros, size) = (symbol >> 4, u32::from(symbol & 15));
            if size != 0 {
                index += usize::from(zeros);
                *coefficient(bits, block, index, last)? = bits.difference(size)? << scan.low_bits;
                index += 1;
            } else if zeros == 15 {
                index += 16;
            } else {
                self.empty_blocks = read_run(bits, zeros)? - 1;
                break;
            }
        }
        Ok(())
    }

    /// One more bit of a band: for each coefficient that is not zero, and for those that no longer are.
    fn refine_band(
        &mut self,
        bits: &mut BitReader<'_>,
        scan: &Scan<'_>,
        codes: &HuffmanTable,
        block: &mut Block,
    ) -> Result<(), DecodeError> {
        let (mut index, last) = (*scan.band.start(), *scan.band.end());
        let bit = 1_i16 << scan.low_bits;
        while index <= last && self.empty_blocks == 0 {
            let symbol = bits.symbol(codes)?;
            let (zeros, size) = (symbol >> 4, symbol & 15);
            if size == 0 && zeros != 15 {
                self.empty_blocks = read_run(bits, zeros)?;
                break;
            }
            let value = match size {
                0 => 0,
                _ if bits.take(1)? != 0 => bit,
                _ => -bit,
            };
            index = refine(bits, block, index..last + 1, usize::from(zeros), bit)?;
            if value != 0 {
                *coefficient(bits, block, index, last)? = value;
            }
            index += 1;
        }
        if self.empty_blocks > 0 {
            // Most blocks of a run hold nothing to refine: that is seen faster than walked.
            if block[1..].iter().any(|value| *value != 0) {
                refine(bits, block, index..last + 1, usize::MAX, bit)?;
            }
            self.empty_blocks -= 1;
        }
        Ok(())
    }
}

/// Adds `bit` to the coefficients of `band` that are not zero where the file says so, past `zeros` that are.
///
/// Gives the place of the next zero, or the end of the band.
fn refine(
    bits: &mut BitReader<'_>,
    block: &mut Block,
    band: std::ops::Range<usize>,
    mut zeros: usize,
    bit: i16,
) -> Result<usize, DecodeError> {
    for index in band.clone() {
        let value = &mut block[usize::from(ZIGZAG[index])];
        if *value != 0 {
            if bits.take(1)? != 0 && *value & bit == 0 {
                *value = value.wrapping_add(if *value > 0 { bit } else { -bit });
            }
        } else if zeros == 0 {
            return Ok(index);
        } else {
            zeros -= 1;
        }
    }
    Ok(band.end)
}

/// How many blocks from this one on have nothing more (T.81, G.1.2.2, EOBn).
fn read_run(bits: &mut BitReader<'_>, size: u8) -> Result<u32, DecodeError> {
    Ok((1 << size) + u32::from(bits.take(u32::from(size))?))
}

/// The coefficient at `index` of a band that ends with `last`.
#[inline(always)]
fn coefficient<'a>(
    bits: &BitReader<'_>,
    block: &'a mut Block,
    index: usize,
    last: usize,
) -> Result<&'a mut i16, DecodeError> {
    match ZIGZAG.get(index) {
        Some(&place) if index <= last => Ok(&mut block[usize::from(place)]),
        _ => Err(bits.malformed("a run of zeros goes past the end of its block")),
    }
}

fn required<'a>(bits: &BitReader<'_>, codes: Option<&'a HuffmanTable>) -> Result<&'a HuffmanTable, DecodeError> {
    codes.ok_or_else(|| bits.malformed("a scan uses a Huffman table that the file does not have"))
}
