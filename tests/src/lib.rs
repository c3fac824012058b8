//! Helpers of the whole-frame tests: seeded random numbers, a shader of plain clip positions, hashes.

pub mod frames;
pub mod random;
pub mod shaders;
