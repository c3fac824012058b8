//! How an SVG file is read.

use std::path::PathBuf;

use trigon::schedule::Deadline;

use super::{FontOptions, Limits};
use crate::canvas::ImageFilter;

/// How an SVG file is read.
#[derive(Debug, Clone, PartialEq)]
pub struct Options {
    /// The folder that relative links to images start from; without it, linked files are not read.
    pub folder: Option<PathBuf>,
    /// Pixels per inch, for lengths in `mm`, `in`, `pt` and so on.
    pub dpi: f32,
    /// Languages for `systemLanguage`, as `en` or `en-US`.
    pub languages: Vec<String>,
    /// Where fonts come from and which one stands for which generic family.
    pub fonts: FontOptions,
    /// How the textures of `textri` are sampled.
    pub triangle_filter: ImageFilter,
    /// What a file may cost.
    pub limits: Limits,
    /// When to give up reading: looked at between its steps, so that a step is finished first. The limits
    /// bound most steps; a file made to harm can still make one long. [`Renderer::deadline`](crate::canvas::Renderer::deadline) is for drawing.
    pub deadline: Deadline,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            folder: None,
            dpi: 96.0,
            languages: vec!["en".to_owned()],
            fonts: FontOptions::default(),
            triangle_filter: ImageFilter::SMOOTH,
            limits: Limits::default(),
            deadline: Deadline::NEVER,
        }
    }
}
