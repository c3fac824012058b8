//! Options about how the machine is used. None of them changes a pixel.

use crate::values::Positive;
use clap::Args;
use std::num::NonZeroUsize;

#[derive(Debug, Args)]
#[command(next_help_heading = "Machine")]
pub(crate) struct MachineOptions {
    /// Threads to use [default: all cores]
    #[arg(short = 'j', long, value_name = "N", value_parser = parse_threads)]
    pub(crate) threads: Option<NonZeroUsize>,

    /// Instruction set: scalar, sse4.2, avx2, avx512, neon, simd128
    ///
    /// The best one that the CPU has unless given here or by the environment variable TRIGON_SIMD. The picture is the
    /// same at every level.
    #[arg(long, value_name = "LEVEL")]
    pub(crate) simd: Option<String>,

    /// Give up, with an error, after so many seconds
    ///
    /// For files of strangers. No unfinished file is left behind; frames of a turntable that were written stay.
    #[arg(long, value_name = "SECONDS")]
    pub(crate) time_limit: Option<Positive>,
}

/// More threads than any machine has would only use up memory.
const MAX_THREADS: usize = 1024;

fn parse_threads(text: &str) -> Result<NonZeroUsize, String> {
    match text.parse::<NonZeroUsize>() {
        Ok(threads) if threads.get() <= MAX_THREADS => Ok(threads),
        _ => Err(format!("write a number from 1 to {MAX_THREADS}")),
    }
}
