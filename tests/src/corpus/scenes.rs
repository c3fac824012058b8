//! Frames of whole scenes, from files in memory: readers, materials, maps, lights, cameras, overlays, strokes.

use super::NamedFrame;
use super::clip_space::ALL_OUTPUTS;
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::Arc;
use trigon::pipeline::{Picture, Renderer, RendererOptions};
use trigon::shade::Interpolation;
use trigon::target::{ColorSpace, ShadingRate};
use trigon_scene::load::{LoadOptions, MemoryResolver, load_bytes};
use trigon_scene::render::course::games101::Homework3;
use trigon_scene::render::course::tinyrenderer::Lesson;
use trigon_scene::render::{AmbientOcclusion, Outline, RenderSettings, SceneRenderer, ShaderKind, Shadows, Wireframe};
use trigon_scene::scene::{
    Camera, Displacement, Framing, Light, LightKind, Projection, Scene, Texture, TextureId, TextureRef,
};

/// A file of `assets/`, with the path that models know it by.
macro_rules! asset {
    ($path:literal) => {
        ($path, include_bytes!(concat!("../../../assets/", $path)).as_slice())
    };
}

const SIDE_FILES: [(&str, &[u8]); 16] = [
    asset!("still-life.mtl"),
    asset!("teapot.mtl"),
    asset!("cube.mtl"),
    asset!("textures/glaze.png"),
    asset!("textures/glaze-exponent.png"),
    asset!("textures/glaze-specular.png"),
    asset!("textures/glow.png"),
    asset!("textures/hammered-normal.png"),
    asset!("textures/lattice-alpha.png"),
    asset!("textures/leaf.png"),
    asset!("textures/leaf-alpha.png"),
    asset!("textures/peel-height.png"),
    asset!("textures/uv-grid.png"),
    asset!("textures/wood.png"),
    asset!("textures/zellige.png"),
    asset!("textures/zellige-normal.png"),
];

const STILL_LIFE: (&str, &[u8]) = asset!("still-life.obj");
const TEAPOT: (&str, &[u8]) = asset!("teapot.obj");
const CUBE: (&str, &[u8]) = asset!("cube.obj");

/// Lines, points and a triangle with vertex colours, one of them translucent.
const STROKES: (&str, &[u8]) = (
    "strokes.ply",
    b"ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n\
      property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n\
      element face 2\nproperty list uchar int vertex_indices\nelement edge 3\nproperty int vertex1\n\
      property int vertex2\nend_header\n0 0 0 255 0 0 255\n1 0 .1 0 255 0 128\n.9 1 0 0 0 255 255\n\
      0 1.1 -.2 255 255 255 200\n.4 .5 .7 10 200 100 255\n3 0 1 4\n4 0 1 2 3\n0 4\n1 4\n2 4\n",
);

const TETRAHEDRON: (&str, &[u8]) = (
    "tetrahedron.stl",
    b"solid t\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n\
      facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n\
      facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n\
      facet normal 0 0 0\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid t\n",
);

pub(super) fn frames() -> Vec<NamedFrame> {
    let still_life = load(STILL_LIFE);
    let teapot = load(TEAPOT);
    let cube = load(CUBE);
    let mut lit = load(TEAPOT);
    lit.lights = lights();
    let mut tangents = load(STILL_LIFE);
    tangents.generate_tangents();

    let small = RenderSettings { outputs: ALL_OUTPUTS, ..RenderSettings::new(97, 83) };
    let mut by_sample = small;
    by_sample.shading = ShadingRate::Sample;
    let mut anisotropic = small;
    anisotropic.sampling.max_anisotropy = 8;
    let mut wireframe = small;
    wireframe.wireframe = Some(Wireframe::default());

    let encoded = RenderSettings { color_space: ColorSpace::Encoded, ..small };
    let affine = RenderSettings { interpolation: Interpolation::Affine, ..small };

    let mut shadows = small;
    // Large enough for several threads.
    shadows.shadows = Some(Shadows { map_size: 256, ..Shadows::default() });
    let mut hard_shadows = small;
    hard_shadows.shadows = Some(Shadows { map_size: 150, bias: Some(0.01), softness: 0.0 });

    let mut occluded = RenderSettings { width: 240, height: 180, ..small };
    occluded.ambient_occlusion = Some(AmbientOcclusion { samples: 9, ..AmbientOcclusion::default() });
    let mut outlined = RenderSettings { width: 240, height: 180, ..small };
    outlined.outline = Some(Outline { width_px: 3.0, color: [0.2, 0.1, 0.0, 0.5], ..Outline::default() });

    let lit = Rc::new(lit);
    let mut frames = vec![
        frame("still-life", &Rc::new(still_life), &RenderSettings { width: 240, height: 180, ..small }).large(),
        frame("still-life-with-tangents", &Rc::new(tangents), &small),
        frame("every-kind-of-light", &lit, &small),
        frame("shadows-of-every-kind-of-light", &lit, &shadows).large(),
        frame("hard-shadows", &lit, &hard_shadows),
        frame("ambient-occlusion", &Rc::new(load(STILL_LIFE)), &occluded).large(),
        frame("displaced", &Rc::new(displaced_cube()), &small),
        frame("outlines", &Rc::new(load(STILL_LIFE)), &outlined).large(),
        frame("shadows-of-cut-outs", &Rc::new(load(STILL_LIFE)), &shadows).large(),
        frame("shaded-by-sample", &Rc::new(load(TEAPOT)), &by_sample),
        frame("anisotropic", &Rc::new(load(CUBE)), &anisotropic),
        frame("wireframe", &Rc::new(load(CUBE)), &wireframe),
        frame("encoded-colours", &Rc::new(load(STROKES)), &encoded),
        frame("affine-interpolation", &Rc::new(load(CUBE)), &affine),
        frame("ply-strokes", &Rc::new(load(STROKES)), &small),
        frame("stl-facets", &Rc::new(load(TETRAHEDRON)), &small),
    ];
    let (cube, teapot) = (Rc::new(cube), Rc::new(teapot));
    let (maps, heights) = (Rc::new(glowing(load(STILL_LIFE))), Rc::new(with_heights(load(CUBE))));
    let is_relief = |shading| matches!(shading, Homework3::Bump | Homework3::Displacement);
    for shader in ShaderKind::ALL {
        let scene = match shader {
            ShaderKind::MipLevel | ShaderKind::Uv => &cube,
            ShaderKind::Tinyrenderer(_) => &maps,
            ShaderKind::Games101(shading) if is_relief(shading) => &heights,
            _ => &teapot,
        };
        frames.push(frame(&format!("shader-{shader}"), scene, &RenderSettings { shader, ..small }));
    }
    // Where some lanes are in shadow and some are on the far side of the light.
    for shader in [ShaderKind::Tinyrenderer(Lesson::Final), ShaderKind::Games101(Homework3::Phong), ShaderKind::Toon] {
        let settings = RenderSettings { shader, ..shadows };
        frames.push(frame(&format!("shadows-{shader}"), &lit, &settings).large());
    }
    frames
}

/// Surfaces that give off light where they are light.
fn glowing(mut scene: Scene) -> Scene {
    for material in &mut scene.materials {
        material.maps.emissive = material.maps.diffuse.clone();
    }
    scene
}

fn load((name, bytes): (&str, &[u8])) -> Scene {
    let mut files = MemoryResolver::new();
    for (path, bytes) in SIDE_FILES {
        files = files.with(path, bytes);
    }
    let mut options = LoadOptions::default();
    options.strict = true;
    options.resolver = Some(Arc::new(files));
    load_bytes(name, bytes, &options).expect("a model without fault").scene
}

/// A cube with the relief of an orange, as geometry.
fn displaced_cube() -> Scene {
    let mut scene = with_heights(load(CUBE));
    let camera = Framing::default().camera(&scene);
    let settings = Displacement { scale: Some(0.2), max_edge_px: 4.0, ..Displacement::default() };
    let displaced = scene.displace(&camera, [97, 83], &settings);
    assert!(displaced.is_fine && displaced.warnings.is_empty(), "{displaced:?}");
    scene
}

/// The same with the height map of an orange on all materials.
fn with_heights(mut scene: Scene) -> Scene {
    let (path, bytes) = asset!("textures/peel-height.png");
    let map = TextureId(u32::try_from(scene.textures.len()).expect("few textures"));
    scene.textures.push(Texture::new(path, bytes));
    for material in &mut scene.materials {
        material.maps.displacement = Some(TextureRef::new(map));
    }
    scene
}

fn lights() -> Vec<Light> {
    let spot = LightKind::Spot {
        position: [4.0, 5.0, 3.0],
        direction: [-4.0, -4.0, -3.0],
        inner_angle: 0.15,
        outer_angle: 0.4,
    };
    vec![
        Light::new(LightKind::Ambient, 0.1),
        Light::new(LightKind::Directional { direction: [-1.0, -2.0, -0.5] }, 0.4).with_color([1.0, 0.9, 0.7]),
        Light::new(LightKind::Point { position: [-3.0, 2.0, 4.0] }, 9.0).with_color([0.3, 0.5, 1.0]),
        Light::new(spot, 40.0),
    ]
}

/// The scene in the default view; overlays in parallel projection, so that both are drawn.
fn frame(name: &str, scene: &Rc<Scene>, settings: &RenderSettings) -> NamedFrame {
    let (scene, settings) = (Rc::clone(scene), *settings);
    let projection = match settings.shader {
        ShaderKind::BlinnPhong => Projection::default(),
        _ => Projection::Orthographic { height: 1.0 },
    };
    let aspect = f64::from(settings.width) / f64::from(settings.height);
    let camera = Framing { aspect, projection, ..Framing::default() }.camera(&scene);
    let scene_renderer = RefCell::new(SceneRenderer::new());
    NamedFrame::new(format!("scene/{name}"), move |options| {
        draw(&mut scene_renderer.borrow_mut(), options, &scene, &camera, &settings)
    })
}

fn draw(
    scene_renderer: &mut SceneRenderer,
    options: RendererOptions,
    scene: &Scene,
    camera: &Camera,
    settings: &RenderSettings,
) -> Picture {
    let mut renderer = Renderer::new(options).expect("the level is available");
    let mut picture = Picture::default();
    let (_, warnings) =
        scene_renderer.render(&mut renderer, scene, camera, settings, &mut picture).expect("the frame is valid");
    assert!(warnings.is_empty(), "{warnings:?}");
    picture
}
