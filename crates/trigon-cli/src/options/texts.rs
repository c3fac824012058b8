//! Texts of the help that are longer than a line: examples first, exit codes last.

/// The arrangement of every help page: what it does, examples, usage, options, the rest.
pub(super) const TEMPLATE: &str = "\
{about-with-newline}
{before-help}{usage-heading} {usage}

{all-args}{after-help}";

pub(super) const MAIN_EXAMPLES: &str = "\
Examples:
  trigon model.obj -o picture.png
  trigon render model.obj -o picture.png --size hd1080 --samples 16
  trigon render drawing.svg -o picture.png --width 1200
  trigon turntable model.obj -o spin.gif";

pub(super) const RENDER_EXAMPLES: &str = "\
Examples:
  trigon render model.obj -o picture.png
  trigon render teapot.obj -o a.png --size 1920x1080 --azimuth -30 --zoom 1.2
  trigon render part.stl -o part.png --wireframe --background none
  trigon render drawing.svg -o drawing.png --width 1000
  trigon render scene.obj -o a.exr --eye 0,2,6 --light point:3,4,2:20
  cat model.obj | trigon render - -o - > picture.png";

pub(super) const TURNTABLE_EXAMPLES: &str = "\
Examples:
  trigon turntable model.obj -o spin.gif
  trigon turntable model.obj -o spin.png --frames 120 --fps 30     (APNG)
  trigon turntable model.obj -o frame-{frame:3}.png --size hd720";

pub(super) const COMPLETIONS_EXAMPLES: &str = "\
Examples:
  trigon completions bash > ~/.local/share/bash-completion/completions/trigon
  trigon completions zsh > ~/.zfunc/_trigon
  trigon completions fish > ~/.config/fish/completions/trigon.fish";

pub(super) const MAN_EXAMPLES: &str = "\
Examples:
  trigon man | man -l -
  trigon man render > trigon-render.1";

pub(super) const EXIT_CODES: &str = "\
Exit codes:
  0  the picture was written (or the reader of standard output went away)
  1  a file could not be read, drawn or written; no output is left behind
  2  the command line is wrong

Environment:
  TRIGON_SIMD  the instruction set to use, as --simd
  NO_COLOR     if set, messages are not coloured

The same version, input and options give the same bytes on every machine,
whatever its instruction set and number of threads.";

pub(super) const RENDER_NOTES: &str = "\
With none of the view options, the whole model is shown from the front right
and above, as large as fits. Coordinates are those of the model's file; angles
are degrees unless they end in rad or turn; colours are #rgb, #rgba, #rrggbb,
#rrggbbaa, a CSS name, or none.

Exit codes: 0 done, 1 a file could not be read, drawn or written, 2 the
command line is wrong. A failure leaves no output behind.";

pub(super) const TURNTABLE_NOTES: &str = "\
The model turns once about its up axis, counterclockwise seen from above,
before a camera and lights that stand still. An animation is GIF or PNG
(APNG). {frame} in the output's name gives one file per frame instead, counted
from 0; {frame:3} pads the number with zeros to three digits, {{ and }} are
plain braces.

Exit codes: 0 done, 1 a file could not be read, drawn or written, 2 the
command line is wrong. A failure leaves no half-written file behind.";
