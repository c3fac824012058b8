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
  trigon turntable model.obj -o spin.gif
  trigon compare model.obj --vary samples=1,4,16 -o sheet.png
  trigon explain model.obj --pixel 512,384";

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

pub(super) const COMPARE_EXAMPLES: &str = "\
Examples:
  trigon compare model.obj --vary samples=1,4,9,16 -o sheet.png
  trigon compare model.obj -o sheet.png --inset 150,90,24 \\
      --vary samples=1,16 --vary level-filter=zero,nearest,linear
  trigon compare drawing.svg --vary samples=1,4,16 -o sheet.png --json
  trigon compare model.obj --vary \"eye=0,1,5;3,1,4\" -o views.png";

pub(super) const COMPARE_NOTES: &str = "\
All other options are those of trigon render and hold for every picture. With
several --vary the last one goes along the rows. Where samples are varied and
the standard pattern lacks a number, all pictures use the grid.

Below each picture stand the time of a frame (the shortest of several, without
reading and writing files) and the RMSE against a reference of the same view:
for models drawn at twice the size with 16 samples a pixel on a grid, each
shaded, with anisotropic textures, averaged over 2x2 pixels in linear light:
64 samples a pixel; for SVG the same, averaged as SVG blends, encoded. --json
reports these numbers.

Exit codes: 0 done, 1 a file could not be read, drawn or written, 2 the
command line is wrong. A failure leaves no output behind.";

pub(super) const EXPLAIN_EXAMPLES: &str = "\
Examples:
  trigon explain model.obj --pixel 512,384
  trigon explain model.obj --pixel 40,30 --size 80x60 --samples 16
  trigon explain model.obj --pixel 512,384 -o pixel.png
  trigon explain model.obj --pixel 512,384 --json=pixel.json";

pub(super) const EXPLAIN_NOTES: &str = "\
All options of a picture have the meaning that they have for trigon render, so
that the pixel explained is the pixel drawn, bit for bit: the code that draws
the picture tells the story while it draws.

The story names every triangle whose box touches the pixel, in drawing order:
its edge functions at each sample, what is covered, depth tests; then every
fragment: weights, interpolated values, texels read with their weights, the
terms of the light; then blending, the mean of the samples, the bytes.

Exit codes: 0 done, 1 a file could not be read or written, 2 the command line
is wrong.";

pub(super) const EXPLAIN_OUTPUT: &str = "\
Picture to draw of the pixel, in place of text

Shows the pixels around with the edges of the triangles, and the pixel itself
with its samples. The extension says the format.";

pub(super) const EXPLAIN_JSON: &str = "\
The story as JSON, to standard output or to FILE, in place of text

Floats are the shortest decimals that read back as the same numbers.";

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
