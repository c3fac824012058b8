//! Textures: images as the sampler wants them, and the sampler.
