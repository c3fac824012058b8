//! JPEG files to pixels: baseline, extended and progressive Huffman coding of 8 bits; grey, YCbCr, RGB, CMYK and YCCK.
//!
//! In: the bytes of a file. Out: the pixels that libjpeg makes of them with its defaults, bit for bit, and so what
//! browsers, Python and OpenCV show: a standard leaves decoders the rounding, and two pictures of one texture that
//! differ by one unit differ by more once their slopes are lit. All of it is integer arithmetic. Of inks, which libjpeg leaves
//! as they are, red, green and blue are made as from TIFF files.
//!
//! Sources: ITU-T T.81 for the format ([`header`], [`huffman`], [`scan`]); `jidctint.c`, `jdsample.c` and `jdcolor.c`
//! of the Independent JPEG Group's library, as libjpeg-turbo has them, for the rounding ([`idct`], [`upsample`],
//! [`color`]). Their smoothing of progressive files that are unfinished is left out; such a file is drawn as it is.

mod color;
mod header;
mod huffman;
mod idct;
mod picture;
mod scan;
mod upsample;

pub(super) use picture::decode;
