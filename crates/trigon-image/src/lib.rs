//! Pixels, colour, comparison, decoding and encoding of pictures for trigon.
