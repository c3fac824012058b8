//! Every format that is written, by extension and by option.

use crate::support::{Folder, difference, picture_of, read_picture};
use std::fs;
use trigon_image::{DecodedImage, Format, Limits, decode};

#[test]
fn each_extension_gives_its_format() {
    let folder = Folder::with_cube();
    let reference = folder.picture("cube.obj -s 40x30");
    for (name, format) in [
        ("a.png", Format::Png),
        ("a.tga", Format::Tga),
        ("a.qoi", Format::Qoi),
        ("a.jpg", Format::Jpeg),
        ("a.JPEG", Format::Jpeg),
        ("a.gif", Format::Gif),
        ("a.exr", Format::Exr),
    ] {
        folder.run(&format!("cube.obj -s 40x30 -o {name}")).succeeds_quietly();
        let bytes = fs::read(folder.path(name)).unwrap();
        assert_eq!(Format::sniff(&bytes), Some(format), "{name}");
        let picture = picture_of(&bytes);
        let allowed = match format {
            Format::Jpeg => 0.3,
            Format::Gif => 0.05,
            _ => 0.0,
        };
        assert!(difference(&picture, &reference) <= allowed, "{name} shows something else");
    }
}

#[test]
fn the_format_option_overrides_the_extension() {
    let folder = Folder::with_cube();
    folder.run("cube.obj -s 16 -o picture.dat --format qoi").succeeds_quietly();
    assert_eq!(Format::sniff(&fs::read(folder.path("picture.dat")).unwrap()), Some(Format::Qoi));
    folder.run("cube.obj -s 16 -o picture.png --format TGA").succeeds_quietly();
    assert_eq!(Format::sniff(&fs::read(folder.path("picture.png")).unwrap()), Some(Format::Tga));
}

#[test]
fn bit_depths() {
    let folder = Folder::with_cube();
    folder.run("cube.obj -s 40x30 -o deep.png --bit-depth 16").succeeds_quietly();
    let deep = decode(&fs::read(folder.path("deep.png")).unwrap(), None, &Limits::default()).unwrap();
    let DecodedImage::Rgba16(deep) = deep else { panic!("16 bits per channel, not {deep:?}") };
    // Not 8-bit codes repeated: shades in between occur.
    assert!(deep.pixels().iter().any(|pixel| pixel.iter().any(|code| code % 257 != 0)));
    let shallow = folder.picture("cube.obj -s 40x30 --bit-depth 8");
    assert!(difference(&deep.to_rgba8(), &shallow) < 1e-9);

    folder.run("cube.obj -s 40x30 -o half.exr").succeeds_quietly();
    folder.run("cube.obj -s 40x30 -o full.exr --bit-depth 32").succeeds_quietly();
    let size = |name: &str| fs::metadata(folder.path(name)).unwrap().len();
    assert!(size("full.exr") > size("half.exr"));
    folder.run("cube.obj -o a.jpg --bit-depth 16").misuses_with(&["JPEG has 8 bits", "PNG and EXR"]);
    folder.run("cube.obj -o a.png --bit-depth 32").misuses_with(&["PNG has no 32-bit"]);
    folder.run("cube.obj -o a.exr --bit-depth 8").misuses_with(&["EXR has no 8-bit"]);
}

#[test]
fn transparency_is_kept_or_shown_as_white() {
    let folder = Folder::with_cube();
    let clear = folder.picture("cube.obj -s 40x30 --background none");
    assert_eq!(clear.pixel(0, 0), [0; 4]);
    assert_eq!(clear.pixel(20, 15)[3], 255);
    folder.run("cube.obj -s 40x30 --background none -o a.jpg").succeeds_quietly();
    let white = read_picture(&folder.path("a.jpg")).pixel(0, 0);
    assert!(white.iter().all(|code| *code > 250), "{white:?}");
    let teal = folder.picture("cube.obj -s 40x30 --background teal");
    assert_eq!(teal.pixel(0, 0), [0, 128, 128, 255]);
}

#[test]
fn quality_and_compression_change_the_size() {
    let folder = Folder::with_cube();
    for (name, options) in [
        ("low.jpg", "--quality 10"),
        ("high.jpg", "--quality 100"),
        ("fast.png", ""),
        ("best.png", "--compression best"),
    ] {
        folder.run(&format!("cube.obj -s 200 -o {name} {options}")).succeeds_quietly();
    }
    let size = |name: &str| fs::metadata(folder.path(name)).unwrap().len();
    assert!(size("low.jpg") < size("high.jpg"));
    assert!(size("best.png") < size("fast.png"));
    assert_eq!(read_picture(&folder.path("best.png")), read_picture(&folder.path("fast.png")));
}
