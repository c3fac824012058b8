//! The ways a scene can be drawn, by name: as it looks, or as the stages of the pipeline see it.

use super::course::games101::Homework3;
use super::course::tinyrenderer::Lesson;
use std::fmt;
use std::str::FromStr;

/// What the colours of a picture show.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ShaderKind {
    /// Materials under the lights, as the MTL specification's `illum` defines it.
    #[default]
    BlinnPhong,
    /// The same with one normal per triangle: its own.
    Flat,
    /// Light in a few flat steps, as in cartoons; see [`RenderSettings::toon_levels`](super::RenderSettings).
    Toon,
    /// Diffuse colour, map and vertex colour without any light.
    Unlit,
    /// The world-space normal that shading uses: `n * 0.5 + 0.5` as red, green, blue.
    Normal,
    /// Distance along the view, from near (bright) to far (dark) over the range of the model.
    Depth,
    /// How much of its surroundings a surface can see: white where nothing is near, black in a crack.
    Occlusion,
    /// Texture coordinates: u as red, v (up) as green, each repeating from 0 to 1.
    Uv,
    /// The weights of a triangle's corners as red, green, blue.
    Barycentric,
    /// The mip level that the diffuse map is read at, by colour: red is the full image, then the rainbow.
    MipLevel,
    /// How many surfaces cover a pixel, hidden ones too, from dark blue (one) over green and red to white (many).
    Overdraw,
    /// The share of a pixel's samples that is covered, from black to white.
    Coverage,
    /// A colour of its own for each primitive.
    Ids,
    /// A colour of its own for each object.
    Objects,
    /// A lesson of tinyrenderer; see [`tinyrenderer`](super::course::tinyrenderer).
    Tinyrenderer(Lesson),
    /// A shader of GAMES101's homework 3; see [`games101`](super::course::games101).
    Games101(Homework3),
}

/// A name that no shader has.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownShader(pub String);

impl ShaderKind {
    /// All kinds, the default first.
    pub const ALL: [Self; 28] = [
        Self::BlinnPhong,
        Self::Flat,
        Self::Toon,
        Self::Unlit,
        Self::Normal,
        Self::Depth,
        Self::Occlusion,
        Self::Uv,
        Self::Barycentric,
        Self::MipLevel,
        Self::Overdraw,
        Self::Coverage,
        Self::Ids,
        Self::Objects,
        Self::Tinyrenderer(Lesson::Final),
        Self::Tinyrenderer(Lesson::Flat),
        Self::Tinyrenderer(Lesson::Phong),
        Self::Tinyrenderer(Lesson::ObjectNormals),
        Self::Tinyrenderer(Lesson::TangentNormals),
        Self::Tinyrenderer(Lesson::Glow),
        Self::Tinyrenderer(Lesson::Occlusion),
        Self::Tinyrenderer(Lesson::Toon),
        Self::Tinyrenderer(Lesson::Depth),
        Self::Games101(Homework3::Normal),
        Self::Games101(Homework3::Texture),
        Self::Games101(Homework3::Phong),
        Self::Games101(Homework3::Bump),
        Self::Games101(Homework3::Displacement),
    ];

    /// The name that [`FromStr`] reads.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::BlinnPhong => "blinn-phong",
            Self::Flat => "flat",
            Self::Toon => "toon",
            Self::Unlit => "unlit",
            Self::Normal => "normal",
            Self::Depth => "depth",
            Self::Occlusion => "occlusion",
            Self::Uv => "uv",
            Self::Barycentric => "barycentric",
            Self::MipLevel => "mip-level",
            Self::Overdraw => "overdraw",
            Self::Coverage => "coverage",
            Self::Ids => "ids",
            Self::Objects => "objects",
            Self::Tinyrenderer(lesson) => lesson.name(),
            Self::Games101(shading) => shading.name(),
        }
    }

    /// What it shows, in a few words, for lists of options.
    #[must_use]
    pub fn description(self) -> &'static str {
        match self {
            Self::BlinnPhong => "materials under the lights",
            Self::Flat => "the same, one normal per triangle",
            Self::Toon => "light in a few flat steps",
            Self::Unlit => "diffuse colours without light",
            Self::Normal => "world-space normals as colours",
            Self::Depth => "near is bright, far is dark",
            Self::Occlusion => "cracks and corners are dark",
            Self::Uv => "texture coordinates as red and green",
            Self::Barycentric => "weights of the corners as red, green, blue",
            Self::MipLevel => "mip level of the diffuse map by colour",
            Self::Overdraw => "how many surfaces cover a pixel",
            Self::Coverage => "share of covered samples",
            Self::Ids => "a colour for each primitive",
            Self::Objects => "a colour for each object",
            Self::Tinyrenderer(lesson) => lesson.description(),
            Self::Games101(shading) => shading.description(),
        }
    }

    /// Whether it draws materials under the lights.
    pub(super) fn is_lit(self) -> bool {
        matches!(self, Self::BlinnPhong | Self::Flat | Self::Toon | Self::Tinyrenderer(_) | Self::Games101(_))
    }

    /// Whether it draws materials with their colours.
    pub(super) fn shows_materials(self) -> bool {
        self.is_lit() || self == Self::Unlit
    }
}

impl fmt::Display for ShaderKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for ShaderKind {
    type Err = UnknownShader;

    fn from_str(name: &str) -> Result<Self, UnknownShader> {
        Self::ALL.into_iter().find(|kind| kind.name() == name).ok_or_else(|| UnknownShader(name.to_owned()))
    }
}

impl fmt::Display for UnknownShader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unknown shader '{}'; the shaders are ", self.0)?;
        ShaderKind::ALL
            .iter()
            .enumerate()
            .try_for_each(|(i, kind)| write!(f, "{}{kind}", if i == 0 { "" } else { ", " }))
    }
}

impl std::error::Error for UnknownShader {}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_round_trip_and_errors_list_them() {
        for kind in ShaderKind::ALL {
            assert_eq!(kind.name().parse(), Ok(kind));
        }
        let message = "phong".parse::<ShaderKind>().unwrap_err().to_string();
        assert!(message.contains("'phong'") && message.contains("blinn-phong, flat"), "{message}");
    }
}
