//! Small files of every format and many of their variants, made by this crate's encoders, by the libraries' encoders, or
//! byte by byte.

use std::io::Cursor;

use crate::encode::{BitDepth, ExrChannel, ExrSample, ExrSamples, encode_exr};
use crate::{EncodeOptions, Format, Rgba8Image, encode};

/// A picture of smooth, flat and noisy parts; translucent in one corner if asked.
pub(crate) fn picture(width: u32, height: u32, is_opaque: bool) -> Rgba8Image {
    let mut image = Rgba8Image::new(width, height);
    let mut noise = 1_u32;
    for y in 0..height {
        for x in 0..width {
            noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let [_, _, jitter, speck] = noise.to_le_bytes();
            let ramp = |i: u32, n: u32| u8::try_from(i * 255 / n.max(1)).unwrap();
            let pixel = match (x * 3 / width, y * 2 / height) {
                (0, _) => [ramp(x, width), ramp(y, height), 128, 255],
                (1, 0) => [250, 128, 10, 255],
                (1, _) => [jitter, speck, jitter ^ speck, 255],
                (_, 0) => [ramp(y, height); 4].map(|v| v / 2),
                _ => [0, 0, 0, ramp(x, width)],
            };
            let [r, g, b, a] = pixel;
            image.set_pixel(x, y, if is_opaque { [r, g, b, 255] } else { [r, g, b, a] });
        }
    }
    image
}

/// A valid file to be broken, and what it is.
pub(crate) struct Sample {
    pub(crate) name: &'static str,
    pub(crate) format: Format,
    pub(crate) bytes: Vec<u8>,
}

/// One or more files of every format that is read.
pub(crate) fn all() -> Vec<Sample> {
    let translucent = picture(21, 13, false);
    let opaque = picture(21, 13, true);
    let options = EncodeOptions::default();
    let sixteen = EncodeOptions { depth: BitDepth::Sixteen, ..options.clone() };
    let raw = EncodeOptions { tga_run_length: false, ..options.clone() };
    let mut samples = Vec::new();
    let mut add = |name, format, bytes| samples.push(Sample { name, format, bytes });
    let written = |image, format, options| encode(image, format, options).unwrap();

    add("png rgba", Format::Png, written(&translucent, Format::Png, &options));
    add("png rgb", Format::Png, written(&opaque, Format::Png, &options));
    add("png 16 bit", Format::Png, written(&translucent, Format::Png, &sixteen));
    add("png palette", Format::Png, png_palette());
    add("tga packed", Format::Tga, written(&translucent, Format::Tga, &options));
    add("tga raw", Format::Tga, written(&opaque, Format::Tga, &raw));
    add("qoi", Format::Qoi, written(&translucent, Format::Qoi, &options));
    add("gif", Format::Gif, written(&translucent, Format::Gif, &options));
    add("exr zip", Format::Exr, written(&translucent, Format::Exr, &options));
    add("exr layers", Format::Exr, exr_layers(&translucent));
    add("jpeg", Format::Jpeg, written(&opaque, Format::Jpeg, &options));
    add("jpeg progressive", Format::Jpeg, jpeg(jpeg_encoder::ColorType::Rgba, &opaque, true));
    add("jpeg gray", Format::Jpeg, jpeg(jpeg_encoder::ColorType::Luma, &opaque, false));
    add("jpeg cmyk", Format::Jpeg, jpeg(jpeg_encoder::ColorType::Cmyk, &opaque, false));
    add("jpeg ycck", Format::Jpeg, jpeg(jpeg_encoder::ColorType::CmykAsYcck, &opaque, false));
    add("webp rgba", Format::WebP, webp(&translucent, true));
    add("webp rgb", Format::WebP, webp(&opaque, false));
    add("tiff rgb lzw", Format::Tiff, tiff_rgb(&opaque, tiff::encoder::Compression::Lzw));
    add("tiff rgb deflate", Format::Tiff, tiff_rgb(&opaque, tiff::encoder::Compression::Deflate(Default::default())));
    add("tiff rgb packbits", Format::Tiff, tiff_rgb(&opaque, tiff::encoder::Compression::Packbits));
    add("tiff gray 16", Format::Tiff, tiff_gray16());
    add("tiff float", Format::Tiff, tiff_float());
    add("hdr", Format::Hdr, hdr());
    add("hdr old runs", Format::Hdr, hdr_old());
    add("bmp 24", Format::Bmp, bmp_24(&opaque));
    add("bmp rle 8", Format::Bmp, bmp_rle_8());
    samples
}

fn png_palette() -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, 9, 3);
    encoder.set_color(png::ColorType::Indexed);
    encoder.set_depth(png::BitDepth::Two);
    encoder.set_palette(vec![10, 20, 30, 40, 50, 60, 70, 80, 90]);
    encoder.set_trns(vec![255, 128]);
    let mut writer = encoder.write_header().unwrap();
    // Indices 0 1 2 0 1 2 0 1 2, two bits each, in every row.
    writer.write_image_data(&[0b0001_1000, 0b0110_0001, 0b1000_0000].repeat(3)).unwrap();
    writer.finish().unwrap();
    file
}

fn exr_layers(image: &Rgba8Image) -> Vec<u8> {
    let linear = image.to_linear();
    let count = linear.pixels().len();
    let ids: Vec<u32> = (0..u32::try_from(count).unwrap()).collect();
    let mut channels = ExrChannel::rgba("", &linear, ExrSample::F32);
    channels.extend(ExrChannel::rgba("normal", &linear, ExrSample::F16));
    channels.push(ExrChannel { name: "id".into(), samples: ExrSamples::U32(ids.into()) });
    encode_exr(image.width(), image.height(), &channels, Default::default()).unwrap()
}

/// The bytes of the picture in the color type asked for, as they are.
fn jpeg(color: jpeg_encoder::ColorType, image: &Rgba8Image, is_progressive: bool) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = jpeg_encoder::Encoder::new(&mut file, 80);
    encoder.set_progressive(is_progressive);
    let (width, height) = (u16::try_from(image.width()).unwrap(), u16::try_from(image.height()).unwrap());
    let samples: Vec<u8> = match color {
        jpeg_encoder::ColorType::Luma => image.pixels().iter().map(|p| p[0]).collect(),
        _ => image.as_bytes().to_vec(),
    };
    encoder.encode(&samples, width, height, color).unwrap();
    file
}

fn webp(image: &Rgba8Image, has_alpha: bool) -> Vec<u8> {
    let mut file = Vec::new();
    let (color, samples) = if has_alpha {
        (image_webp::ColorType::Rgba8, image.as_bytes().to_vec())
    } else {
        (image_webp::ColorType::Rgb8, rgb(image))
    };
    image_webp::WebPEncoder::new(&mut file).encode(&samples, image.width(), image.height(), color).unwrap();
    file
}

fn rgb(image: &Rgba8Image) -> Vec<u8> {
    image.pixels().iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect()
}

fn tiff_rgb(image: &Rgba8Image, compression: tiff::encoder::Compression) -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let mut encoder = tiff::encoder::TiffEncoder::new(&mut file).unwrap().with_compression(compression);
    encoder.write_image::<tiff::encoder::colortype::RGB8>(image.width(), image.height(), &rgb(image)).unwrap();
    file.into_inner()
}

fn tiff_gray16() -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let samples: Vec<u16> = (0..35).map(|i| i * 1800).collect();
    let mut encoder = tiff::encoder::TiffEncoder::new(&mut file).unwrap();
    encoder.write_image::<tiff::encoder::colortype::Gray16>(7, 5, &samples).unwrap();
    file.into_inner()
}

fn tiff_float() -> Vec<u8> {
    let mut file = Cursor::new(Vec::new());
    let samples: Vec<f32> = (0_u8..36).map(|i| f32::from(i) / 8.0).collect();
    let mut encoder = tiff::encoder::TiffEncoder::new(&mut file).unwrap();
    encoder.write_image::<tiff::encoder::colortype::RGB32Float>(4, 3, &samples).unwrap();
    file.into_inner()
}

/// Two lines of eight pixels in the new coding: runs in one channel, raw values in the others.
pub(crate) fn hdr() -> Vec<u8> {
    let mut file = b"#?RADIANCE\n# by hand\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n-Y 2 +X 8\n".to_vec();
    for _ in 0..2 {
        file.extend([2, 2, 0, 8]);
        file.extend([128 + 8, 128]);
        file.extend([8, 0, 10, 20, 30, 40, 50, 60, 70]);
        file.extend([3, 1, 2, 3, 128 + 5, 4]);
        file.extend([128 + 8, 130]);
    }
    file
}

/// A column of whole pixels, stored from the bottom, with an old run: 1, 1, 1, n repeats n times.
pub(crate) fn hdr_old() -> Vec<u8> {
    let mut file = b"#?RGBE\n\n+Y 2 +X 5\n".to_vec();
    file.extend([128, 64, 32, 129, 1, 1, 1, 4]);
    file.extend([1, 2, 3, 128].repeat(5));
    file
}

pub(crate) fn bmp_header(header_size: u32, size: (i32, i32), bits: u16, compression: u32, rest: &[u8]) -> Vec<u8> {
    let mut file = b"BM\0\0\0\0\0\0\0\0\0\0\0\0".to_vec();
    file.extend(header_size.to_le_bytes());
    file.extend(size.0.to_le_bytes().into_iter().chain(size.1.to_le_bytes()));
    file.extend([1, 0].into_iter().chain(bits.to_le_bytes()).chain(compression.to_le_bytes()));
    // Size of the pixels, resolution, number of colors: none given.
    file.extend([0; 20]);
    file.extend(rest);
    let offset = u32::try_from(file.len()).unwrap();
    file[10..14].copy_from_slice(&offset.to_le_bytes());
    file
}

pub(crate) fn bmp_24(image: &Rgba8Image) -> Vec<u8> {
    let size = (i32::try_from(image.width()).unwrap(), i32::try_from(image.height()).unwrap());
    let mut file = bmp_header(40, size, 24, 0, &[]);
    for row in image.rows().rev() {
        let bytes: Vec<u8> = row.iter().flat_map(|&[r, g, b, _]| [b, g, r]).collect();
        file.extend(&bytes);
        file.extend(vec![0; bytes.len().next_multiple_of(4) - bytes.len()]);
    }
    file
}

/// Five by three: a run, literals, a move over one pixel and up one row, a run.
pub(crate) fn bmp_rle_8() -> Vec<u8> {
    let palette: Vec<u8> = (0..4).flat_map(|i| [i, i * 2, i * 3, 0]).collect();
    let mut file = bmp_header(40, (5, 3), 8, 1, &palette);
    file.extend([2, 1, 0, 3, 3, 2, 1, 0, 0, 0, 0, 2, 1, 1, 4, 3, 0, 1]);
    file
}
