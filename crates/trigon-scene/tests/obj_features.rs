//! One test per feature of OBJ files, through the public entry.

use trigon_scene::load::{LoadError, LoadOptions, Loaded, MemoryResolver, WarningKind, load_bytes};
use trigon_scene::scene::{Mesh, Scene};

fn load(text: &str) -> Loaded {
    let loaded = load_bytes("a.obj", text.as_bytes(), &LoadOptions::default()).unwrap();
    loaded.scene.meshes[0].validate().unwrap();
    loaded
}

/// The mesh of a file that must load without warnings.
fn mesh(text: &str) -> Mesh {
    let loaded = load(text);
    assert_eq!(loaded.warnings, []);
    loaded.scene.meshes[0].clone()
}

fn shown_warnings(text: &str) -> Vec<String> {
    load(text).warnings.iter().map(ToString::to_string).collect()
}

fn with_files(text: &str, files: &[(&str, &str)], change: impl FnOnce(&mut LoadOptions)) -> Result<Loaded, LoadError> {
    let resolver = files.iter().fold(MemoryResolver::new(), |all, &(path, content)| all.with(path, content));
    let mut options = LoadOptions::default();
    options.resolver = Some(std::sync::Arc::new(resolver));
    change(&mut options);
    load_bytes("a.obj", text.as_bytes(), &options)
}

fn material_names(scene: &Scene) -> Vec<&str> {
    scene.materials.iter().map(|material| material.name.as_str()).collect()
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn all_four_index_forms_and_negative_indices() {
    let attributes = "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n";
    let forms = [
        "f 1 2 3 4",
        "f 1/1 2/2 3/3 4/4",
        "f 1//1 2//2 3//3 4//4",
        "f 1/1/1 2/2/2 3/3/3 4/4/4",
        "f -4 -3 -2 -1",
        "f -4/-4/-4 -3/-3/-3 -2/-2/-2 -1/-1/-1",
        "f 1/ 2/ 3/ 4/",
        "f 1// 2// 3// 4//",
    ];
    for form in forms {
        let mesh = mesh(&format!("{SQUARE}{attributes}{form}\n"));
        assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3]], "{form}");
        assert_eq!(mesh.positions[2], [1.0, 1.0, 0.0]);
        assert_eq!(mesh.normals, [[0.0, 0.0, 1.0]; 4]);
        let has_uvs = form.contains("1/1") || form.contains("-4/-4");
        // v is down inside.
        let expected = if has_uvs { vec![[0.0, 1.0], [1.0, 1.0], [1.0, 0.0], [0.0, 0.0]] } else { vec![] };
        assert_eq!(mesh.uvs, expected, "{form}");
    }
}

#[test]
fn vertices_are_shared_only_where_all_indices_agree() {
    let text =
        format!("{SQUARE}vt 0 0\nvt 1 1\nvn 0 0 1\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/1/1 4/1/1\nf 1/2/1 3/1/1 4/1/1\n");
    let mesh = mesh(&text);
    assert_eq!(mesh.triangles, [[0, 1, 2], [0, 2, 3], [4, 2, 3]]);
}

#[test]
fn layout_of_lines_does_not_matter() {
    let plain = mesh(&format!("{SQUARE}f 1 2 3 4\n"));
    let variants = [
        format!("{SQUARE}f 1 2 3 4").replace('\n', "\r\n"),
        format!("{SQUARE}f 1 2 3 4").replace('\n', "\r"),
        format!("{SQUARE}f 1 2 3 4").replace(' ', "\t"),
        format!("{SQUARE}f 1 2 3 4  # square\n"),
        format!("\u{feff}# comment \\\n\n   \n{SQUARE}f 1 2\\\n 3 \\\r\n4"),
        format!("  {}\tf  1   2 3   4   ", SQUARE.replace("\nv", "  \n\t v")),
    ];
    for text in variants {
        assert_eq!(mesh(&text), plain, "{text:?}");
    }
    let wide: Vec<u8> = format!("{SQUARE}f 1 2 3 4\n").encode_utf16().flat_map(u16::to_be_bytes).collect();
    let loaded = load_bytes("a.obj", &[&[0xfe, 0xff], wide.as_slice()].concat(), &LoadOptions::default()).unwrap();
    assert_eq!(loaded.scene.meshes[0], plain);
}

#[test]
fn any_number_format_is_read() {
    let mesh = mesh("v +1. -.5 1e2\nv 1E-2 0x1 3\nv 1 2 3\nf 1 2 3\n".replace("0x1", "07").as_str());
    assert_eq!(mesh.positions[0], [1.0, -0.5, 100.0]);
    assert_eq!(mesh.positions[1], [0.01, 7.0, 3.0]);
    let warnings = shown_warnings("v 1 2\nv 1 x 3\nv 1 2.5foo 3\nf 1 2 3\n");
    assert_eq!(warnings[0], "a.obj:1: fewer numbers than expected; 0 taken for the others");
    assert_eq!(warnings[1], "a.obj:2: x is not a number; 0 taken for it");
    assert_eq!(warnings[2], "a.obj:3: 2.5foo is not a number; 2.5 taken for it");
}

#[test]
fn weights_and_vertex_colours_are_told_apart() {
    assert!(mesh("v 0 0 0 1\nv 1 0 0 1\nv 0 1 0 1\nf 1 2 3\n").colors.is_empty());
    let mesh1 = mesh("v 0 0 0\nv 1 0 0 1 0 0\nv 0 1 0 0 0 1 0.5\nf 1 2 3\n");
    assert_eq!(mesh1.colors, [[1.0; 4], [1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 0.5]]);
    // sRGB to linear, and values up to 255.
    let half = mesh("v 0 0 0 0.5 0.5 0.5\nv 1 0 0 0 0 0\nv 0 1 0 0 0 0\nf 1 2 3\n").colors[0][0];
    assert!((half - 0.214_041).abs() < 1e-5, "{half}");
    assert_eq!(mesh("v 0 0 0 255 0 0\nv 1 0 0 0 255 0\nv 0 1 0 0 0 0\nf 1 2 3\n").colors[0], [1.0, 0.0, 0.0, 1.0]);
    // A vertex without a colour is white beside such values, too.
    assert_eq!(mesh("v 0 0 0\nv 1 0 0 0 255 0\nv 0 1 0 0 0 0 255\nf 1 2 3\n").colors[0], [1.0; 4]);
}

#[test]
fn concave_polygons_are_cut_inside() {
    let mesh = mesh("v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 1 0\nv 0 4 0\nf 1 2 3 4 5\n");
    let area: f32 = mesh
        .triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
            ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0
        })
        .inspect(|area| assert!(*area > 0.0))
        .sum();
    assert_eq!(area, 10.0);
}

#[test]
fn lines_and_points() {
    let text = format!("{SQUARE}vt 0 0\nl 1 2 3\nl 3/1 4/1\np 1 -1\np 2\n");
    let mesh = mesh(&text);
    assert_eq!((mesh.segments.len(), mesh.points.len(), mesh.triangles.len()), (3, 3, 0));
    assert_eq!(mesh.submeshes.len(), 1);
    let warnings = shown_warnings(&format!("{SQUARE}l 1\nl 1 9\np 9\np 1\n"));
    assert_eq!(warnings.len(), 3, "{warnings:?}");
    // Positions alone are a point cloud.
    assert_eq!(self::mesh(SQUARE).points, [0, 1, 2, 3]);
}

#[test]
fn objects_groups_and_materials_make_submeshes() {
    let text = format!(
        "{SQUARE}o body\ng left  side\nusemtl a\nf 1 2 3\ng right\nf 1 3 4\nusemtl b\nf 1 2 4\nusemtl a\nf 2 3 4\no tail\nf 1 2 3\n"
    );
    let loaded =
        with_files(&format!("mtllib m.mtl\n{text}"), &[("m.mtl", "newmtl a\nnewmtl b\nnewmtl c\n")], |_| {}).unwrap();
    let mesh = &loaded.scene.meshes[0];
    mesh.validate().unwrap();
    assert_eq!(material_names(&loaded.scene), ["a", "b"]);
    let parts: Vec<_> = mesh.parts.iter().map(|part| (part.object.as_str(), part.group.as_str())).collect();
    assert_eq!(parts, [("body", "left side"), ("body", "right"), ("tail", "right")]);
    let runs: Vec<_> = mesh.submeshes.iter().map(|s| (s.part, s.material.0, s.triangles.clone())).collect();
    assert_eq!(runs, [(0, 0, 0..1), (1, 0, 1..3), (1, 1, 3..4), (2, 0, 4..5)]);
}

#[test]
fn smoothing_groups_are_honoured_and_else_the_angle() {
    // Two squares that meet at 90 degrees.
    let roof = "v 0 0 0\nv 0 0 1\nv 1 1 1\nv 1 1 0\nv 2 0 1\nv 2 0 0\n";
    assert_eq!(mesh(&format!("{roof}f 1 2 3 4\nf 4 3 5 6\n")).positions.len(), 8);
    assert_eq!(mesh(&format!("{roof}s 1\nf 1 2 3 4\nf 4 3 5 6\n")).positions.len(), 6);
    assert_eq!(mesh(&format!("{roof}s 1\nf 1 2 3 4\ns 2\nf 4 3 5 6\n")).positions.len(), 8);
    let mut options = LoadOptions::default();
    options.crease_angle = Some(1.6);
    let loaded = load_bytes("a.obj", format!("{roof}f 1 2 3 4\nf 4 3 5 6\n").as_bytes(), &options).unwrap();
    assert_eq!(loaded.scene.meshes[0].positions.len(), 6);
    // A flat face under `s off` keeps its own normal even where it is smooth by angle.
    assert_eq!(mesh(&format!("{SQUARE}s off\nf 1 2 3\nf 1 3 4\n")).positions.len(), 6);
}

#[test]
fn faults_are_reported_and_left_out() {
    let warnings = shown_warnings(&format!("{SQUARE}f 1 2 3\nf 1 2 9\nf 0 1 2\nf 1 2\nf 1 a 2\nf 1/7 2/7 3/7\n"));
    let expected = [
        "a.obj:6: face left out: it refers to a position that the file does not have (it has 4)",
        "a.obj:7: face left out: it refers to a position that the file does not have (it has 4)",
        "a.obj:8: face with 2 corners left out; it needs 3 or more",
        "a.obj:9: face left out: a is not an index like 1, 1/2, 1//3 or 1/2/3",
        "a.obj:10: texture coordinate index ignored: the file has 0 of them",
    ];
    assert_eq!(warnings, expected);
    assert_eq!(load(&format!("{SQUARE}f 1 2 3\nf 1 2 9\n")).scene.triangle_count(), 1);
    let mut options = LoadOptions::default();
    options.strict = true;
    let error = load_bytes("a.obj", format!("{SQUARE}f 1 2 9\n").as_bytes(), &options).unwrap_err();
    assert!(error.to_string().starts_with("a.obj:5: face left out"), "{error}");
    // Statements that are not drawn are no faults.
    let curves = format!("{SQUARE}f 1 2 3\ncstype bezier\nvp 1\nvp 2\ncall x\n");
    assert_eq!(load_bytes("a.obj", curves.as_bytes(), &options).unwrap().warnings.len(), 3);
}

#[test]
fn findings_are_few_however_much_is_wrong() {
    let prose: String = (0..40).map(|i| format!("word{i} of a text without a comment sign\n")).collect();
    let warnings = shown_warnings(&format!("{prose}v 1\n{SQUARE}f 1 2 3\n"));
    assert_eq!(
        warnings,
        [
            "a.obj:1: 40 lines that are no statements ignored, the first is word0 ...",
            "a.obj:41: fewer numbers than expected; 0 taken for the others",
        ]
    );
    assert_eq!(shown_warnings(&format!("{SQUARE}f 1 2 3\nword\n")), ["a.obj:6: statement word ignored"]);
}

#[test]
fn material_libraries_are_found_in_every_spelling() {
    let files = [("my lib.mtl", "newmtl a\nKd 1 0 0\n"), ("b.mtl", "newmtl a\nKd 0 1 0\nnewmtl b c\nKd 0 0 1\n")];
    let face = format!("{SQUARE}usemtl a\nf 1 2 3\nusemtl   b c  \nf 1 3 4\n");
    for libraries in ["mtllib my lib.mtl b.mtl", "mtllib my lib.mtl\nmtllib B.MTL", "mtllib ./my lib.mtl ./b.mtl"] {
        let loaded = with_files(&format!("{libraries}\n{face}"), &files, |_| {}).unwrap();
        assert_eq!(loaded.warnings, [], "{libraries}");
        let diffuse: Vec<_> = loaded.scene.materials.iter().map(|material| material.diffuse).collect();
        // The first library that defines a material wins.
        assert_eq!(diffuse, [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], "{libraries}");
    }
}

#[test]
fn missing_side_files_are_warnings_or_strict_errors() {
    let text = format!("mtllib gone.mtl\n{SQUARE}usemtl a\nf 1 2 3\n");
    let loaded = with_files(&text, &[], |_| {}).unwrap();
    assert_eq!(loaded.warnings.len(), 1);
    assert_eq!(loaded.warnings[0].kind, WarningKind::MissingFile);
    assert_eq!(loaded.warnings[0].to_string(), "a.obj:1: material library gone.mtl not found; neutral materials used");
    assert!(matches!(with_files(&text, &[], |options| options.strict = true), Err(LoadError::Strict(_))));
    let text = format!("mtllib a.mtl\n{SQUARE}usemtl a\nf 1 2 3\n");
    let library = [("a.mtl", "newmtl a\nmap_Kd gone.png\n")];
    assert_eq!(
        with_files(&text, &library, |_| {}).unwrap().warnings[0].to_string(),
        "a.mtl:2: texture gone.png not found; drawn without it"
    );
    assert!(with_files(&text, &library, |options| options.strict = true).is_err());
    assert!(with_files(&text, &library, |options| options.skip_textures = true).unwrap().warnings.is_empty());
}

#[test]
fn limits_stop_large_files() {
    let text = format!("{SQUARE}f 1 2 3 4\n");
    let limited =
        |change: fn(&mut LoadOptions)| with_files(&text, &[], change).map(|_| ()).map_err(|error| error.to_string());
    assert_eq!(limited(|_| {}), Ok(()));
    assert!(limited(|o| o.limits.vertices = 3).unwrap_err().contains("limit vertices = 3"));
    assert!(limited(|o| o.limits.triangles = 1).unwrap_err().contains("limit triangles = 1"));
    assert!(limited(|o| o.limits.file_bytes = 10).unwrap_err().contains("limit file_bytes = 10"));
    let many = format!("{SQUARE}usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n");
    let error = with_files(&many, &[], |o| o.limits.materials = 1).unwrap_err().to_string();
    assert!(error.contains("limit materials = 1"), "{error}");
}

#[test]
fn values_that_are_not_finite_load() {
    let loaded = load("v nan inf 1.#IND\nv 1e39 -1.#INF 0\nv 0 0 0\nf 1 2 3\nf 1 2 3 1 2\n");
    let mesh = &loaded.scene.meshes[0];
    assert!(mesh.triangles.len() == 4 && mesh.positions.iter().any(|p| p[1] == f32::NEG_INFINITY));
    assert_eq!(loaded.scene.bounding_box().max, [0.0; 3]);
}
