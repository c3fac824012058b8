//! Surface descriptions: everything an MTL material says, under the field's names.
//!
//! Colours are linear RGB as written (MTL names no colour space; exporters write linear values). Maps multiply or
//! replace the factors as the MTL specification says for each.

use super::TextureRef;

/// A surface.
///
/// [`Material::default`] is the neutral material: light grey, diffuse with a faint highlight, opaque; what is drawn
/// where a file names no material or one that cannot be found.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name; may be empty.
    pub name: String,
    /// `Ka`: reflectance of ambient light.
    pub ambient: [f32; 3],
    /// `Kd`: diffuse reflectance.
    pub diffuse: [f32; 3],
    /// `Ks`: specular reflectance.
    pub specular: [f32; 3],
    /// `Ke`: light given off.
    pub emissive: [f32; 3],
    /// `Tf`: transmission filter.
    pub transmission_filter: [f32; 3],
    /// `Ns`: specular exponent of Blinn-Phong, 0 to about 1000.
    pub specular_exponent: f32,
    /// `Ni`: index of refraction.
    pub refraction_index: f32,
    /// `d`: opacity, 1 opaque, 0 invisible (`Tr` is 1 - d).
    pub opacity: f32,
    /// `d -halo`: opacity grows from the middle of an object to its silhouette: 1 - (n . v) * (1 - d).
    pub is_halo: bool,
    /// `sharpness`: of reflections, 0 to 1000.
    pub sharpness: f32,
    /// `illum`: the lighting model that is drawn.
    pub illumination: Illumination,
    /// The number of the `illum` statement as written, 0 to 10, where there is one.
    pub illum_written: Option<u8>,
    /// `Pr`: roughness of the physically based extension, 0 to 1.
    pub roughness: Option<f32>,
    /// `Pm`: metallic factor, 0 to 1.
    pub metallic: Option<f32>,
    /// `Ps`: sheen, 0 to 1.
    pub sheen: Option<f32>,
    /// `Pc`: clear coat thickness, 0 to 1.
    pub clearcoat: Option<f32>,
    /// `Pcr`: clear coat roughness, 0 to 1.
    pub clearcoat_roughness: Option<f32>,
    /// `aniso`: anisotropy of the highlight, 0 to 1.
    pub anisotropy: Option<f32>,
    /// `anisor`: rotation of the anisotropy, 0 to 1.
    pub anisotropy_rotation: Option<f32>,
    /// Texture maps.
    pub maps: Maps,
}

impl Material {
    /// Whether this is the neutral material, whatever its name.
    #[must_use]
    pub fn is_neutral(&self) -> bool {
        *self == Self { name: self.name.clone(), ..Self::default() }
    }
}

impl Default for Material {
    fn default() -> Self {
        Self {
            name: String::new(),
            ambient: [0.8; 3],
            diffuse: [0.8; 3],
            specular: [0.1; 3],
            emissive: [0.0; 3],
            transmission_filter: [1.0; 3],
            specular_exponent: 32.0,
            refraction_index: 1.0,
            opacity: 1.0,
            is_halo: false,
            sharpness: 60.0,
            illumination: Illumination::Specular,
            illum_written: None,
            roughness: None,
            metallic: None,
            sheen: None,
            clearcoat: None,
            clearcoat_roughness: None,
            anisotropy: None,
            anisotropy_rotation: None,
            maps: Maps::default(),
        }
    }
}

/// The lighting model (MTL specification, `illum`).
///
/// 0, 1 and 2 are drawn as specified. The ray-traced models 3 to 10 add reflection, refraction or shadows to model 2
/// and are drawn as 2.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Illumination {
    /// 0: the diffuse colour, unlit.
    Color,
    /// 1: ambient and diffuse.
    Diffuse,
    /// 2: ambient, diffuse and specular.
    Specular,
}

/// The texture maps of a material.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Maps {
    /// `map_Ka`: multiplies `ambient`.
    pub ambient: Option<TextureRef>,
    /// `map_Kd`: multiplies `diffuse`; its alpha channel, if any, multiplies the opacity.
    pub diffuse: Option<TextureRef>,
    /// `map_Ks`: multiplies `specular`.
    pub specular: Option<TextureRef>,
    /// `map_Ke`: multiplies `emissive`.
    pub emissive: Option<TextureRef>,
    /// `map_Ns`: multiplies `specular_exponent`; a scalar map.
    pub specular_exponent: Option<TextureRef>,
    /// `map_d` (also `map_opacity`): multiplies `opacity`; a scalar map.
    pub opacity: Option<TextureRef>,
    /// `map_Tr`: a scalar map of transparency; multiplies `opacity` by 1 - value.
    pub transparency: Option<TextureRef>,
    /// `bump`, `map_bump`: height above the surface; a scalar map. A picture of normals is drawn as `normal`.
    pub bump: Option<TextureRef>,
    /// `norm`, `map_Kn`: tangent-space normals, (r, g, b) = (n + 1) / 2, green up.
    pub normal: Option<TextureRef>,
    /// `disp`: displacement along the normal; a scalar map. Drawn as `bump` where there is none, unless
    /// [`Scene::displace`](super::Scene::displace) makes geometry of it.
    pub displacement: Option<TextureRef>,
    /// `decal`: a scalar map that mixes the texture over the material's colour; kept, not drawn.
    pub decal: Option<TextureRef>,
    /// `refl`: one map for a sphere or up to six for a cube; kept, not drawn.
    pub reflection: Vec<TextureRef>,
    /// `map_Pr`: a scalar map.
    pub roughness: Option<TextureRef>,
    /// `map_Pm`: a scalar map.
    pub metallic: Option<TextureRef>,
    /// `map_Ps`: a scalar map.
    pub sheen: Option<TextureRef>,
    /// `map_Pc`: a scalar map.
    pub clearcoat: Option<TextureRef>,
    /// `map_Pcr`: a scalar map.
    pub clearcoat_roughness: Option<TextureRef>,
    /// `map_aat on`: anti-aliasing of textures asked for.
    pub antialias: bool,
}

impl Maps {
    /// Calls `visit` with every texture use.
    pub fn for_each_mut(&mut self, visit: impl FnMut(&mut TextureRef)) {
        let single = [
            &mut self.ambient,
            &mut self.diffuse,
            &mut self.specular,
            &mut self.emissive,
            &mut self.specular_exponent,
            &mut self.opacity,
            &mut self.transparency,
            &mut self.bump,
            &mut self.normal,
            &mut self.displacement,
            &mut self.decal,
            &mut self.roughness,
            &mut self.metallic,
            &mut self.sheen,
            &mut self.clearcoat,
            &mut self.clearcoat_roughness,
        ];
        single.into_iter().flatten().chain(&mut self.reflection).for_each(visit);
    }
}
