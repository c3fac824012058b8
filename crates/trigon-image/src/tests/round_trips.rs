//! What is written is read back: exactly where the format is lossless, nearly where it is not.

use super::samples::{self, picture};
use crate::encode::{BitDepth, Effort, ExrChannel, ExrSample, ExrSamples, encode_exr};
use crate::{
    Color, DecodedImage, EncodeOptions, Format, GrayF32Image, ImageRef, Limits, Rgba8Image, RgbaF32Image, compare,
    decode, encode,
};

fn round_trip<'a>(image: impl Into<ImageRef<'a>>, format: Format, options: &EncodeOptions) -> DecodedImage {
    let bytes = encode(image, format, options).unwrap();
    decode(&bytes, Some(format), &Limits::default()).unwrap()
}

/// Pictures whose sides are odd, and one that is a single pixel.
fn pictures() -> Vec<Rgba8Image> {
    let sizes = [(1, 1), (1, 7), (300, 1), (17, 33), (130, 67)];
    let gray = Rgba8Image::filled(40, 3, [9, 9, 9, 255]);
    let both = sizes.iter().flat_map(|&(w, h)| [true, false].map(|is_opaque| picture(w, h, is_opaque)));
    both.chain([gray]).collect()
}

#[test]
fn lossless_formats_keep_every_byte() {
    let plain = EncodeOptions::default();
    let mut others = vec![plain.clone()];
    others.push(EncodeOptions { tga_run_length: false, effort: Effort::Balanced, ..plain.clone() });
    others.push(EncodeOptions { effort: Effort::Best, ..plain });
    for image in pictures() {
        for format in [Format::Png, Format::Tga, Format::Qoi] {
            for options in &others {
                assert_eq!(round_trip(&image, format, options), DecodedImage::Rgba8(image.clone()), "{format}");
            }
        }
    }
}

#[test]
fn sixteen_bits_are_kept() {
    for image in pictures() {
        let mut wide = image.to_rgba16();
        wide.pixels_mut().iter_mut().for_each(|p| p[0] ^= 0x55);
        assert_eq!(round_trip(&wide, Format::Png, &EncodeOptions::default()), DecodedImage::Rgba16(wide.clone()));
        let eight = EncodeOptions { depth: BitDepth::Eight, ..EncodeOptions::default() };
        assert_eq!(round_trip(&wide, Format::Png, &eight), DecodedImage::Rgba8(wide.to_rgba8()));
        let sixteen = EncodeOptions { depth: BitDepth::Sixteen, ..EncodeOptions::default() };
        assert_eq!(round_trip(&image.to_linear(), Format::Png, &sixteen).into_rgba8(), image.to_linear().to_srgb8());
    }
}

#[test]
fn jpeg_is_near_and_better_with_quality() {
    let image = picture(64, 64, true);
    let psnr = |jpeg_quality| {
        let options = EncodeOptions { jpeg_quality, ..EncodeOptions::default() };
        compare(&round_trip(&image, Format::Jpeg, &options).into_rgba8(), &image).unwrap().psnr()
    };
    let (low, high) = (psnr(30), psnr(98));
    assert!(high > low + 5.0 && high > 30.0, "{low} {high}");
}

#[test]
fn jpeg_shows_the_background_through() {
    let options = EncodeOptions { background: Color::rgb(0, 0, 255), ..EncodeOptions::default() };
    let image = round_trip(&Rgba8Image::new(8, 8), Format::Jpeg, &options).into_rgba8();
    let [r, g, b, a] = image.pixel(4, 4);
    assert!(r < 4 && g < 4 && b > 250 && a == 255, "{:?}", image.pixel(4, 4));
}

#[test]
fn float_images_survive_exr() {
    let mut image = picture(37, 40, false).to_linear();
    image.set_pixel(3, 3, [1e6, -2.5, f32::MIN_POSITIVE, 0.25]);
    let exact = EncodeOptions { exr_sample: ExrSample::F32, ..EncodeOptions::default() };
    for effort in [Effort::Fast, Effort::Balanced, Effort::Best] {
        let options = EncodeOptions { effort, ..exact.clone() };
        assert_eq!(round_trip(&image, Format::Exr, &options), DecodedImage::RgbaF32(image.clone()));
    }
    let DecodedImage::RgbaF32(half) = round_trip(&image, Format::Exr, &EncodeOptions::default()) else {
        panic!("EXR is float")
    };
    for (&rounded, &exact) in half.pixels().as_flattened().iter().zip(image.pixels().as_flattened()) {
        let is_near = (rounded - exact).abs() <= exact.abs() / 2048.0 + 3e-8;
        assert!(is_near || exact > 65504.0, "{exact} became {rounded}");
    }
}

#[test]
fn exr_layers_do_not_disturb_the_picture() {
    let image = picture(21, 13, false).to_linear();
    let sample = samples::all().into_iter().find(|sample| sample.name == "exr layers").unwrap();
    assert_eq!(decode(&sample.bytes, None, &Limits::default()).unwrap(), DecodedImage::RgbaF32(image));
}

#[test]
fn the_first_layer_is_read_where_no_picture_is() {
    let image = RgbaF32Image::filled(3, 2, [0.5, 0.25, 2.0, 1.0]);
    let mut channels = ExrChannel::rgba("beauty", &image, ExrSample::F16);
    channels.push(ExrChannel { name: "Z".into(), samples: ExrSamples::F32(vec![7.0; 6].into()) });
    let bytes = encode_exr(3, 2, &channels, Effort::Fast).unwrap();
    assert_eq!(decode(&bytes, None, &Limits::default()).unwrap(), DecodedImage::RgbaF32(image));
    let depth_only = encode_exr(3, 2, &channels[4..], Effort::Fast).unwrap();
    let error = decode(&depth_only, None, &Limits::default()).unwrap_err().to_string();
    assert!(error.contains("without R, G, B or Y channels; it has Z"), "{error}");
}

#[test]
fn exr_channels_are_checked() {
    let channel =
        |name: &str, count| ExrChannel { name: name.into(), samples: ExrSamples::F32(vec![0.0; count].into()) };
    for (channels, part) in [
        (vec![], "one channel"),
        (vec![channel("Z", 3)], "has 3 samples for 2x2"),
        (vec![channel("Z", 4), channel("Z", 4)], "twice"),
        (vec![channel("", 4)], "1 to 31 bytes"),
        (vec![channel("a\0b", 4)], "a\\0b"),
    ] {
        let error = encode_exr(2, 2, &channels, Effort::Fast).unwrap_err().to_string();
        assert!(error.contains(part), "{error}");
    }
}

#[test]
fn depth_is_written_as_it_is() {
    let depth = GrayF32Image::from_pixels(3, 1, vec![0.0, 0.5, 1.0]).unwrap();
    let options = EncodeOptions::default();
    let DecodedImage::Rgba16(image) = round_trip(&depth, Format::Png, &options) else { panic!("depth has 16 bits") };
    assert_eq!(image.row(0).iter().map(|p| p[1]).collect::<Vec<_>>(), [0, 32768, 65535]);
    let DecodedImage::RgbaF32(image) = round_trip(&depth, Format::Exr, &options) else { panic!("EXR is float") };
    assert_eq!(image.row(0).iter().map(|p| p[1]).collect::<Vec<_>>(), [0.0, 0.5, 1.0]);
}

#[test]
fn gif_keeps_few_colors_and_one_bit_of_alpha() {
    let colors = [[1, 2, 3, 255], [250, 250, 250, 255], [0, 128, 255, 128]];
    let pixels: Vec<[u8; 4]> = (0..99).map(|i| colors[i % 3]).collect();
    let mut expected = Rgba8Image::from_pixels(9, 11, pixels).unwrap();
    let options = EncodeOptions::default();
    let image = round_trip(&expected, Format::Gif, &options).into_rgba8();
    expected.pixels_mut().iter_mut().for_each(|p| p[3] = 255);
    assert_eq!(image, expected);
    let clear = round_trip(&Rgba8Image::filled(4, 4, [9, 9, 9, 127]), Format::Gif, &options).into_rgba8();
    assert!(clear.pixels().iter().all(|p| p[3] == 0));
}

#[test]
fn gif_of_many_colors_is_near() {
    let image = picture(128, 128, true);
    for (gif_dither, least) in [(false, 30.0), (true, 27.0)] {
        let options = EncodeOptions { gif_dither, ..EncodeOptions::default() };
        let psnr = compare(&round_trip(&image, Format::Gif, &options).into_rgba8(), &image).unwrap().psnr();
        assert!(psnr > least, "{psnr}");
    }
}

#[test]
fn pictures_without_pixels_and_read_only_formats_are_refused() {
    for format in Format::all() {
        let result = encode(&Rgba8Image::new(0, 3), format, &EncodeOptions::default());
        assert!(result.unwrap_err().to_string().contains("no pixels"));
        let result = encode(&Rgba8Image::new(2, 2), format, &EncodeOptions::default());
        assert_eq!(result.is_ok(), format.is_writable(), "{format}");
    }
    let wide = Rgba8Image::new(65536, 1);
    for format in [Format::Tga, Format::Jpeg, Format::Gif] {
        let error = encode(&wide, format, &EncodeOptions::default()).unwrap_err().to_string();
        assert!(error.contains("65535"), "{error}");
    }
}

#[test]
fn encoded_files_are_recognized_by_content() {
    for format in Format::all().filter(|format| format.is_writable()) {
        let bytes = encode(&picture(5, 4, true), format, &EncodeOptions::default()).unwrap();
        assert_eq!(Format::sniff(&bytes), Some(format));
    }
}
