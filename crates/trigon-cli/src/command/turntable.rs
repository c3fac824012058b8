//! `trigon turntable`: a model in; an animation of it turning, or one picture per frame, out.
//!
//! While a frame is drawn the one before is encoded, on a thread of its own; no more than these are held.

use super::render::check_kind;
use super::studio::Studio;
use crate::failure::Failure;
use crate::options::{TurntableOptions, Written};
use crate::output::{Destination, Encoding, FrameTemplate, Images};
use crate::progress::Progress;
use crate::turn::Turn;
use std::f64::consts::TAU;
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread;
use std::time::{Duration, Instant};
use trigon_image::{AnimationEncoder, EncodeError, Format};

pub(crate) fn turntable(options: &TurntableOptions) -> Result<(), Failure> {
    let render = &options.render;
    check_kind(false, render, &Written::default())?;
    let sink = Sink::choose(options)?;
    let mut studio = Studio::open(render, sink.first_destination(), sink.encoding())?;
    let sink = sink.start(studio.size())?;

    let frames = options.animation.frames;
    let turn = Turn::new(&studio.scene, studio.up.0);
    let first_camera = studio.look(render, Some(&turn))?;
    let lights = std::mem::take(&mut studio.scene.lights);
    let progress = Progress::new(studio.terminal, frames);
    let encode_time = thread::scope(|scope| {
        let (sender, receiver) = sync_channel(1);
        let writer = scope.spawn(move || sink.write_all(&receiver));
        for frame in 0..frames {
            let angle = TAU * f64::from(frame) / f64::from(frames);
            studio.scene.lights = turn.lights(&lights, angle);
            let images = studio.draw(&turn.camera(&first_camera, angle))?;
            // A writer that failed no longer listens; its failure is told below.
            if sender.send(Message::Frame(images)).is_err() {
                break;
            }
            progress.show(frame + 1);
        }
        // Fails only if the writer failed.
        let _ = sender.send(Message::End);
        writer.join().unwrap_or_else(|_| Err(Failure::work("the encoder stopped unexpectedly")))
    })?;
    drop(progress);
    studio.close(encode_time)
}

/// What the writer is sent. Hanging up without an end means that drawing failed, and nothing is to be finished.
enum Message {
    Frame(Images),
    End,
}

/// Where frames go, before anything is drawn.
enum Sink {
    Numbered { template: FrameTemplate, first: Destination, encoding: Encoding },
    Animation { destination: Destination, encoding: Encoding, delay: Duration },
}

/// Where frames go, ready to take them.
enum OpenSink {
    Numbered { template: FrameTemplate, encoding: Encoding },
    Animation { destination: Destination, encoder: Box<AnimationEncoder>, delay: Duration },
}

impl Sink {
    fn choose(options: &TurntableOptions) -> Result<Self, Failure> {
        let output = &options.render.output;
        let destination = Destination::new(&output.output);
        if let Some(template) = FrameTemplate::parse(&output.output)? {
            let encoding = Encoding::choose(output, &destination)?;
            let first = Destination::File(template.path(0));
            return Ok(Self::Numbered { template, first, encoding });
        }
        let mut encoding = Encoding::choose(output, &destination)?;
        encoding.options.plays = options.animation.plays;
        if !matches!(encoding.format, Format::Gif | Format::Png) {
            return Err(Failure::usage(format!(
                "{} has no animations; write GIF or PNG, or one file per frame, as in -o frame-{{frame:3}}.{}",
                encoding.format,
                encoding.format.extension()
            )));
        }
        if encoding.outputs(false).color_f32 {
            return Err(Failure::usage("animations have 8 bits per channel; leave out --bit-depth"));
        }
        let delay = Duration::try_from_secs_f64(1.0 / options.animation.fps.0)
            .map_err(|_| Failure::usage("--fps is too small; frames would never end"))?;
        Ok(Self::Animation { destination, encoding, delay })
    }

    fn encoding(&self) -> &Encoding {
        match self {
            Self::Numbered { encoding, .. } | Self::Animation { encoding, .. } => encoding,
        }
    }

    /// The file to check before drawing.
    fn first_destination(&self) -> &Destination {
        match self {
            Self::Numbered { first, .. } => first,
            Self::Animation { destination, .. } => destination,
        }
    }

    fn start(self, (width, height): (u32, u32)) -> Result<OpenSink, Failure> {
        match self {
            Self::Numbered { template, encoding, .. } => Ok(OpenSink::Numbered { template, encoding }),
            Self::Animation { destination, encoding, delay } => {
                let encoder = AnimationEncoder::new(encoding.format, width, height, &encoding.options);
                let encoder = Box::new(encoder.map_err(|error| encode_failure(&error))?);
                Ok(OpenSink::Animation { destination, encoder, delay })
            }
        }
    }
}

impl OpenSink {
    /// Takes frames until the end; gives the time that this took, without waiting for them.
    fn write_all(mut self, messages: &Receiver<Message>) -> Result<Duration, Failure> {
        let mut busy = Duration::ZERO;
        for frame in 0.. {
            let Ok(message) = messages.recv() else { break };
            let started = Instant::now();
            match message {
                Message::Frame(images) => self.push(frame, images)?,
                Message::End => {
                    self.finish()?;
                    return Ok(busy + started.elapsed());
                }
            }
            busy += started.elapsed();
        }
        Ok(busy)
    }

    fn push(&mut self, frame: u32, images: Images) -> Result<(), Failure> {
        match self {
            Self::Numbered { template, encoding } => {
                Destination::File(template.path(frame)).write(&encoding.encode(&images)?)
            }
            Self::Animation { encoder, delay, .. } => {
                let bytes = images.bytes.ok_or_else(|| Failure::work("the frame was not drawn"))?;
                encoder.push_frame(&bytes, *delay).map_err(|error| encode_failure(&error))
            }
        }
    }

    fn finish(self) -> Result<(), Failure> {
        match self {
            Self::Numbered { .. } => Ok(()),
            Self::Animation { destination, encoder, .. } => {
                destination.write(&encoder.finish().map_err(|error| encode_failure(&error))?)
            }
        }
    }
}

fn encode_failure(error: &EncodeError) -> Failure {
    Failure::work(error.to_string())
}
