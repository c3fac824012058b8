//! The material of LearningTinyrenderer for models that come without one.
//!
//! In: a model as loaded. Out: the same with the pictures that tinyrenderer finds by its name, and the constants of the
//! program's material file. chiuhoukazusa, "LearningTinyrenderer", <https://github.com/chiuhoukazusa/LearningTinyrenderer>.

use super::tinyrenderer::{self, Lesson};
use crate::load::{Resolver, Warning};
use crate::scene::{Illumination, Scene};

/// Dresses `scene`, unless it has a material of its own; see [`tinyrenderer::dress`] for names and warnings.
pub fn dress(scene: &mut Scene, model: &str, resolver: &dyn Resolver, max_bytes: u64) -> Vec<Warning> {
    if scene.materials.iter().any(|material| !material.is_neutral()) {
        return Vec::new();
    }
    let warnings = tinyrenderer::dress(scene, model, Lesson::Final, resolver, max_bytes);
    for material in &mut scene.materials {
        (material.ambient, material.emissive) = ([0.0; 3], [0.0; 3]);
        (material.diffuse, material.specular) = ([1.0; 3], [1.0; 3]);
        material.specular_exponent = 30.0;
        material.illumination = Illumination::Specular;
    }
    scene.generate_tangents();
    warnings
}
