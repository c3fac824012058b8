//! JPEG files of each kind against libjpeg-turbo: the same pixels, bit for bit.

use crate::{DecodeError, DecodedImage, Format, Limits, decode};

/// Files of the fuzz corpus, and the hash (FNV-1a, 64 bits) of the red, green and blue that libjpeg-turbo 3.2 makes of
/// them with its defaults, row by row.
const FILES: [(&str, u32, u32, u64); 9] = [
    ("411.jpg", 37, 29, 0xe560_d41d_4085_bbc7),
    ("420_progressive.jpg", 37, 29, 0x4cd9_f983_1464_6faa),
    ("420_restarts.jpg", 37, 29, 0x00f7_8d48_0303_0f00),
    ("422.jpg", 37, 29, 0x56ee_1855_8877_2a83),
    ("440.jpg", 32, 32, 0xf9da_63cb_0dbc_cdb2),
    ("444.jpg", 37, 29, 0x8c03_217f_5ead_b839),
    ("grey_progressive.jpg", 37, 29, 0x7c5d_f5fa_0ca6_e0bb),
    ("rgb.jpg", 37, 29, 0x8ca4_911d_9762_99a9),
    ("two_by_two.jpg", 2, 2, 0x8530_abdf_5c6f_00bd),
];

fn bytes(name: &str) -> Vec<u8> {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/jpeg");
    std::fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn decoded(bytes: &[u8]) -> Result<DecodedImage, DecodeError> {
    decode(bytes, Some(Format::Jpeg), &Limits::default())
}

#[test]
fn each_kind_has_the_pixels_of_libjpeg() {
    for (name, width, height, wanted) in FILES {
        let image = decoded(&bytes(name)).unwrap_or_else(|error| panic!("{name}: {error}")).into_rgba8();
        assert_eq!((image.width(), image.height()), (width, height), "{name}");
        let values = image.pixels().iter().flat_map(|pixel| &pixel[..3]);
        let hash = values
            .fold(0xcbf2_9ce4_8422_2325_u64, |hash, &value| (hash ^ u64::from(value)).wrapping_mul(0x0100_0000_01b3));
        assert_eq!(hash, wanted, "{name}: {hash:#x}");
    }
}

#[test]
fn other_codings_and_missing_parts_are_named() {
    let file = bytes("422.jpg");
    let place = |marker: u8| file.windows(2).position(|pair| pair == [0xff, marker]).unwrap();
    let with = |offset: usize, value: u8| {
        let mut changed = file.clone();
        changed[offset] = value;
        decoded(&changed).unwrap_err().to_string()
    };
    let (frame, scan) = (place(0xc0), place(0xda));
    assert!(with(frame + 1, 0xc9).contains("arithmetic"));
    assert!(with(frame + 4, 12).contains("12 bits"));
    assert!(with(frame + 11, 0x51).contains("sampling factors"));
    assert!(with(frame + 14, 0x31).contains("do not divide"));
    assert!(with(frame + 12, 3).contains("quantization table"));
    assert!(with(scan + 5, 9).contains("names components"));
    assert!(with(scan + 6, 0x33).contains("Huffman table"));
    assert!(with(place(0xdb) + 4, 7).contains("0 to 3"));
    // Without the scan no component has any data.
    let without_scan = [&file[..scan], &[0xff, 0xd9]].concat();
    assert!(decoded(&without_scan).unwrap_err().to_string().contains("no scan"));
    let cut = &file[..file.len() - 20];
    assert!(decoded(cut).unwrap_err().to_string().contains("end"));
}

/// The scans of a progressive file; the last of them is the last of its refinements.
fn scans(file: &[u8]) -> Vec<std::ops::Range<usize>> {
    let starts: Vec<usize> =
        (0..file.len() - 1).filter(|&at| file[at..].starts_with(&[0xff, 0xda])).chain([file.len() - 2]).collect();
    starts.windows(2).map(|pair| pair[0]..pair[1]).collect()
}

#[test]
fn scans_that_bring_nothing_new_are_refused() {
    let file = bytes("grey_progressive.jpg");
    let scans = scans(&file);
    let end = &[0xff, 0xd9][..];
    let start = &file[..file.len() - 2];
    // Those that refine, once more.
    let last = &file[scans.last().unwrap().clone()];
    let refined_again = [start, last, end].concat();
    assert!(decoded(&refined_again).unwrap_err().to_string().contains("next bit that is missing"));
    // The first, again and again.
    let first = &file[scans[0].clone()];
    assert!(decoded(&[start, first, end].concat()).is_ok());
    let endless = [start, &first.repeat(100), end].concat();
    assert!(decoded(&endless).unwrap_err().to_string().contains("100 scans"));
}

#[test]
fn what_is_no_jpeg_file_is_told_so() {
    let error = decoded(b"<html>\xff\xd9").unwrap_err().to_string();
    assert!(error.contains("start-of-image"), "{error}");
}

#[test]
fn a_restart_that_is_missing_is_an_error() {
    let mut file = bytes("420_restarts.jpg");
    let place = file.windows(2).rposition(|pair| pair[0] == 0xff && matches!(pair[1], 0xd0..=0xd7)).unwrap();
    file[place + 1] ^= 1;
    assert!(decoded(&file).unwrap_err().to_string().contains("restart marker"));
}
