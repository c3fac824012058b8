//! Animations: whatever a writer leaves out of a frame, a player sees the frames that were put in.

use std::io::Cursor;
use std::time::Duration;

use crate::encode::GifPalette;
use crate::{AnimationEncoder, EncodeOptions, Format, Limits, Rgba8Image, decode};

/// A square of 3 x 3 that moves over a background; every frame twice, and then one frame quite different.
fn frames(background: [u8; 4]) -> Vec<Rgba8Image> {
    let mut frames = Vec::new();
    for step in 0..4 {
        let mut frame = Rgba8Image::filled(16, 12, background);
        for y in 0..3 {
            for x in 0..3 {
                frame.set_pixel(2 + step * 3 + x, 4 + step + y, [250, 200, 10, 255]);
            }
        }
        frames.extend([frame.clone(), frame]);
    }
    frames.push(Rgba8Image::filled(16, 12, [1, 2, 3, 255]));
    frames
}

fn write(format: Format, frames: &[Rgba8Image], options: &EncodeOptions) -> Vec<u8> {
    let mut animation = AnimationEncoder::new(format, 16, 12, options).unwrap();
    for frame in frames {
        animation.push_frame(frame, Duration::from_millis(125)).unwrap();
    }
    animation.finish().unwrap()
}

/// Plays a GIF as programs do: frames over what the one before left.
fn play_gif(bytes: &[u8]) -> Vec<(Rgba8Image, u16)> {
    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(Cursor::new(bytes)).unwrap();
    let mut canvas = Rgba8Image::new(decoder.width().into(), decoder.height().into());
    let mut played = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        let place = |i: usize| {
            let width = usize::from(frame.width);
            let (x, y) = (usize::from(frame.left) + i % width, usize::from(frame.top) + i / width);
            (u32::try_from(x).unwrap(), u32::try_from(y).unwrap())
        };
        for (i, &pixel) in frame.buffer.as_chunks::<4>().0.iter().enumerate() {
            let (x, y) = place(i);
            if pixel[3] != 0 {
                canvas.set_pixel(x, y, pixel);
            }
        }
        played.push((canvas.clone(), frame.delay));
        if frame.dispose == gif::DisposalMethod::Background {
            for i in 0..frame.buffer.len() / 4 {
                let (x, y) = place(i);
                canvas.set_pixel(x, y, [0; 4]);
            }
        }
    }
    played
}

/// Plays an APNG of frames that replace what was there.
fn play_apng(bytes: &[u8]) -> Vec<(Rgba8Image, u16)> {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let control = *reader.info().animation_control().expect("the file is animated");
    let mut canvas = Rgba8Image::new(reader.info().width, reader.info().height);
    let mut played = Vec::new();
    for _ in 0..control.num_frames {
        let mut samples = vec![0; reader.output_buffer_size().unwrap()];
        let output = reader.next_frame(&mut samples).unwrap();
        let frame = *reader.info().frame_control().unwrap();
        assert_eq!((frame.blend_op, frame.dispose_op), (png::BlendOp::Source, png::DisposeOp::None));
        let rows = samples.as_chunks::<4>().0.chunks_exact(output.width as usize).take(output.height as usize);
        for (y, row) in (frame.y_offset..).zip(rows) {
            let start = frame.x_offset as usize;
            canvas.row_mut(y)[start..start + row.len()].copy_from_slice(row);
        }
        played.push((canvas.clone(), frame.delay_num));
        assert_eq!(frame.delay_den, 1000);
    }
    assert!(reader.next_frame(&mut vec![0; 16 * 12 * 4]).is_err(), "there are as many frames as the head says");
    played
}

#[test]
fn gif_players_see_the_frames() {
    for background in [[0, 90, 0, 255], [0; 4]] {
        for gif_palette in [GifPalette::PerFrame, GifPalette::Global] {
            let options = EncodeOptions { gif_palette, ..EncodeOptions::default() };
            let frames = frames(background);
            let played = play_gif(&write(Format::Gif, &frames, &options));
            assert_eq!(played.len(), frames.len());
            for (i, ((shown, _), frame)) in played.iter().zip(&frames).enumerate() {
                assert_eq!(shown, frame, "frame {i} on {background:?}, {gif_palette:?}");
            }
            let total: u16 = played.iter().map(|(_, delay)| delay).sum();
            assert!((112..=113).contains(&total), "9 times 125 ms are {total} hundredths");
        }
    }
}

#[test]
fn apng_players_see_the_frames() {
    for background in [[0, 90, 0, 255], [0; 4], [9, 8, 7, 100]] {
        let frames = frames(background);
        let bytes = write(Format::Png, &frames, &EncodeOptions::default());
        let played = play_apng(&bytes);
        assert_eq!(played.len(), frames.len());
        for ((shown, delay), frame) in played.iter().zip(&frames) {
            assert_eq!(shown, frame);
            assert_eq!(*delay, 125);
        }
        // Programs without animation see the first frame.
        assert_eq!(decode(&bytes, None, &Limits::default()).unwrap().into_rgba8(), frames[0]);
    }
}

#[test]
fn unchanged_pixels_cost_next_to_nothing() {
    let still = super::samples::picture(16, 12, true);
    for format in [Format::Gif, Format::Png] {
        let one = write(format, &vec![still.clone(); 2], &EncodeOptions::default()).len();
        let many = write(format, &vec![still.clone(); 12], &EncodeOptions::default()).len();
        assert!(many - one < 10 * 150, "{format}: {one} and {many} bytes");
    }
}

#[test]
fn the_number_of_plays_is_told() {
    let frames = frames([0; 4]);
    for (plays, repeat) in [(0, gif::Repeat::Infinite), (1, gif::Repeat::Finite(0)), (5, gif::Repeat::Finite(4))] {
        let options = EncodeOptions { plays, ..EncodeOptions::default() };
        let bytes = write(Format::Gif, &frames, &options);
        let mut decoder = gif::DecodeOptions::new().read_info(Cursor::new(&bytes)).unwrap();
        while decoder.next_frame_info().unwrap().is_some() {}
        assert_eq!(decoder.repeat(), repeat);
        let bytes = write(Format::Png, &frames, &options);
        let reader = png::Decoder::new(Cursor::new(&bytes)).read_info().unwrap();
        assert_eq!(reader.info().animation_control().unwrap().num_plays, u32::from(plays));
    }
}

#[test]
fn the_same_frames_give_the_same_bytes() {
    let frames: Vec<Rgba8Image> = (0..3)
        .map(|i| {
            let mut f = super::samples::picture(16, 12, false);
            f.set_pixel(i, 1, [7; 4]);
            f
        })
        .collect();
    for format in [Format::Gif, Format::Png] {
        let options = EncodeOptions::default();
        assert_eq!(write(format, &frames, &options), write(format, &frames, &options));
    }
}
