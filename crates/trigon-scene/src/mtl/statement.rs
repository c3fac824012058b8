//! One material while its statements are read, and the rules for what is not stated.
//!
//! Not stated: `Kd` is 0.8, `Ka` equals `Kd`, `Ks` and `Ke` are black, `d` is 1, `Ns` 32, `illum` 2. A colour that is
//! not stated but has a map is white, so that the map shows as it is.

use super::map_statement::Words;
use crate::scene::{Illumination, Material, TextureRef};

/// A material and which of its values were stated.
pub(super) struct Draft {
    material: Material,
    ambient: Option<[f32; 3]>,
    diffuse: Option<[f32; 3]>,
    specular: Option<[f32; 3]>,
    emissive: Option<[f32; 3]>,
    dissolve: Option<f32>,
    transparency: Option<f32>,
}

impl Draft {
    pub(super) fn new(name: String) -> Self {
        let material = Material { name, ..Material::default() };
        Self {
            material,
            ambient: None,
            diffuse: None,
            specular: None,
            emissive: None,
            dissolve: None,
            transparency: None,
        }
    }

    pub(super) fn name(&self) -> &str {
        &self.material.name
    }

    /// Reads a statement that sets a value; `None` if `key` (lower case) is none. An error says what is wrong with it
    /// and what stands in.
    pub(super) fn value(&mut self, key: &[u8], arguments: &[u8]) -> Option<Result<(), String>> {
        let material = &mut self.material;
        Some(match key {
            b"ka" => set_color(&mut self.ambient, arguments),
            b"kd" => set_color(&mut self.diffuse, arguments),
            b"ks" => set_color(&mut self.specular, arguments),
            b"ke" => set_color(&mut self.emissive, arguments),
            b"tf" => color(arguments).map(|color| material.transmission_filter = color),
            b"ns" => set_number(&mut material.specular_exponent, arguments, 0.0, f32::MAX),
            b"ni" => set_number(&mut material.refraction_index, arguments, 0.0, f32::MAX),
            b"sharpness" => set_number(&mut material.sharpness, arguments, 0.0, f32::MAX),
            b"d" => self.dissolve(arguments),
            b"tr" => set_optional(&mut self.transparency, arguments),
            b"illum" => self.illum(arguments),
            b"pr" => set_optional(&mut material.roughness, arguments),
            b"pm" => set_optional(&mut material.metallic, arguments),
            b"ps" => set_optional(&mut material.sheen, arguments),
            b"pc" => set_optional(&mut material.clearcoat, arguments),
            b"pcr" => set_optional(&mut material.clearcoat_roughness, arguments),
            b"aniso" => set_optional(&mut material.anisotropy, arguments),
            b"anisor" => set_optional(&mut material.anisotropy_rotation, arguments),
            b"map_aat" => {
                material.maps.antialias = arguments.eq_ignore_ascii_case(b"on");
                Ok(())
            }
            _ => return None,
        })
    }

    fn dissolve(&mut self, arguments: &[u8]) -> Result<(), String> {
        let mut words = Words::new(arguments);
        let is_halo = words.clone().word() == Some(b"-halo");
        if is_halo {
            words.word();
        }
        set_optional(&mut self.dissolve, words.rest())?;
        self.material.is_halo = is_halo;
        Ok(())
    }

    fn illum(&mut self, arguments: &[u8]) -> Result<(), String> {
        let written = Words::new(arguments).number();
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "the guard leaves 0 to 10")]
        let number = written.filter(|n| (0.0..=10.0).contains(n)).map(|n| n as u8);
        self.material.illumination = match number {
            Some(0) => Illumination::Color,
            Some(1) => Illumination::Diffuse,
            _ => Illumination::Specular,
        };
        self.material.illum_written = number;
        match number {
            Some(_) => Ok(()),
            None => Err("illum is not a number from 0 to 10; 2 taken for it".to_owned()),
        }
    }

    /// Whether `key` (lower case) is a texture statement.
    pub(super) fn is_map(key: &[u8]) -> bool {
        let mut scratch = Self::new(String::new());
        matches!(key, b"refl" | b"map_refl") || scratch.map_slot(key).is_some()
    }

    /// Whether the map of `key` (lower case) is kept for programs that use it, but changes no picture.
    pub(super) fn is_kept_only(key: &[u8]) -> bool {
        matches!(key, b"refl" | b"map_refl" | b"decal" | b"map_decal")
    }

    /// Sets the map of a texture statement.
    pub(super) fn set_map(&mut self, key: &[u8], map: TextureRef) {
        if let b"refl" | b"map_refl" = key {
            let maps = &mut self.material.maps.reflection;
            maps.retain(|known| known.options.projection != map.options.projection);
            maps.push(map);
        } else if let Some(slot) = self.map_slot(key) {
            *slot = Some(map);
        }
    }

    fn map_slot(&mut self, key: &[u8]) -> Option<&mut Option<TextureRef>> {
        let maps = &mut self.material.maps;
        Some(match key {
            b"map_ka" => &mut maps.ambient,
            b"map_kd" => &mut maps.diffuse,
            b"map_ks" => &mut maps.specular,
            b"map_ke" => &mut maps.emissive,
            b"map_ns" => &mut maps.specular_exponent,
            b"map_d" | b"map_opacity" => &mut maps.opacity,
            b"map_tr" => &mut maps.transparency,
            b"bump" | b"map_bump" => &mut maps.bump,
            b"norm" | b"map_norm" | b"map_kn" => &mut maps.normal,
            b"disp" | b"map_disp" => &mut maps.displacement,
            b"decal" | b"map_decal" => &mut maps.decal,
            b"map_pr" => &mut maps.roughness,
            b"map_pm" => &mut maps.metallic,
            b"map_ps" => &mut maps.sheen,
            b"map_pc" => &mut maps.clearcoat,
            b"map_pcr" => &mut maps.clearcoat_roughness,
            _ => return None,
        })
    }

    /// The material, and what is odd about its opacity.
    pub(super) fn finish(self) -> (Material, Option<&'static str>) {
        let mut material = self.material;
        let white_if = |has_map: bool, otherwise: [f32; 3]| if has_map { [1.0; 3] } else { otherwise };
        let maps = &material.maps;
        let neutral = Material::default().diffuse;
        material.diffuse = self.diffuse.unwrap_or(white_if(maps.diffuse.is_some(), neutral));
        material.ambient = self.ambient.unwrap_or(white_if(maps.ambient.is_some(), material.diffuse));
        material.specular = self.specular.unwrap_or(white_if(maps.specular.is_some(), [0.0; 3]));
        material.emissive = self.emissive.unwrap_or(white_if(maps.emissive.is_some(), [0.0; 3]));
        if self.ambient.is_none() && maps.ambient.is_none() {
            material.maps.ambient.clone_from(&material.maps.diffuse);
        }
        let (opacity, remark) = opacity(self.dissolve, self.transparency);
        material.opacity = opacity;
        (material, remark)
    }
}

/// The opacity that `d` and `Tr` = 1 - d mean together, and what is odd about them.
fn opacity(dissolve: Option<f32>, transparency: Option<f32>) -> (f32, Option<&'static str>) {
    match (dissolve, transparency.map(|transparency| 1.0 - transparency)) {
        (Some(d), Some(other)) if (d - other).abs() > 1e-3 => {
            (d.clamp(0.0, 1.0), Some("d and Tr contradict each other; d taken"))
        }
        // Some programs write the opacity here, and nobody writes materials that cannot be seen.
        (None, Some(opacity)) if opacity <= 0.0 => {
            (1.0, Some("Tr 1 would make it invisible; drawn opaque, as it is meant by programs that write Tr for d"))
        }
        (d, other) => (d.or(other).unwrap_or(1.0).clamp(0.0, 1.0), None),
    }
}

fn set_color(target: &mut Option<[f32; 3]>, arguments: &[u8]) -> Result<(), String> {
    *target = Some(color(arguments)?);
    Ok(())
}

/// `r g b`, `r` alone for grey, or `xyz x y z`.
fn color(arguments: &[u8]) -> Result<[f32; 3], String> {
    let mut words = Words::new(arguments);
    match words.clone().word().map(<[u8]>::to_ascii_lowercase).as_deref() {
        Some(b"spectral") => return Err("spectral curves are not read; the default colour taken".to_owned()),
        Some(b"xyz") => {
            words.word();
            let x = words.number().ok_or("colour is not a number; the default taken")?;
            return Ok(rgb_from_xyz([x, words.number().unwrap_or(x), words.number().unwrap_or(x)]));
        }
        _ => {}
    }
    let red = words.number().ok_or("colour is not a number; the default taken")?;
    Ok(match (words.number(), words.number()) {
        (Some(green), Some(blue)) => [red, green, blue],
        _ => [red; 3],
    })
}

/// Linear sRGB of CIE XYZ (IEC 61966-2-1).
fn rgb_from_xyz([x, y, z]: [f32; 3]) -> [f32; 3] {
    [
        (3.240_97 * x - 1.537_383_2 * y) - 0.498_610_76 * z,
        (-0.969_243_65 * x + 1.875_967_5 * y) + 0.041_555_06 * z,
        (0.055_630_08 * x - 0.203_976_96 * y) + 1.056_971_5 * z,
    ]
}

fn set_number(target: &mut f32, arguments: &[u8], min: f32, max: f32) -> Result<(), String> {
    let value = Words::new(arguments).number().ok_or("value is not a number; the default taken")?;
    *target = value.clamp(min, max);
    Ok(())
}

fn set_optional(target: &mut Option<f32>, arguments: &[u8]) -> Result<(), String> {
    *target = Some(Words::new(arguments).number().ok_or("value is not a number; the default taken")?);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn white_in_xyz_is_white_in_rgb() {
        let white = rgb_from_xyz([0.950_455_9, 1.0, 1.089_057_8]);
        assert!(white.iter().all(|c| (c - 1.0).abs() < 1e-4), "{white:?}");
    }
}
