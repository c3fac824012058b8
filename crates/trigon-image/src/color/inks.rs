//! Printing inks: amounts in, the light that they leave out. No profile: what programs show that have none.

/// The light that an ink and black leave of a channel: (1 - ink) (1 - black), rounded to the nearest code.
#[expect(clippy::cast_possible_truncation, reason = "a product of two numbers in 0..=255 over 255")]
pub(crate) fn without_inks(ink: u8, black: u8) -> u8 {
    ((u32::from(!ink) * u32::from(!black) + 127) / 255) as u8
}
