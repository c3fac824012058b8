//! Black-box tests of the command: it is run as a person or a script runs it, and judged by its files, its output, its
//! messages and its exit code.

mod compare;
mod effects;
mod explain;
mod failures;
mod formats;
mod goldens;
mod help;
mod layers;
mod pipes;
mod presets;
mod report;
#[path = "../../../../tests/shared_data.rs"]
mod shared_data;
mod support;
mod svg;
mod turntable;
mod usage;
mod views;
