//! Helpers of the whole-frame tests: a corpus of named frames, golden pictures, seeded random numbers, hashes.

pub mod corpus;
pub mod frames;
#[cfg(not(target_family = "wasm"))]
pub mod golden;
pub mod random;
pub mod shaders;
