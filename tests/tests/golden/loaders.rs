//! What files say is what is drawn.

use trigon_tests::golden::{Shot, square};

/// Concave polygons: an arrow, a comb and a star, cut up without holes or overlaps.
#[test]
fn concave_polygons() {
    Shot::model("loaders/concave-polygons.obj").face_on().check("loaders/concave-polygons");
}

/// Vertex colours, and negative indices over several objects.
#[test]
fn vertex_colors() {
    Shot::model("loaders/vertex-colors.obj").face_on().check("loaders/vertex-colors");
}

/// The same hexagonal drum three times: one smoothing group, none, and one for the mantle and none for the lids.
#[test]
fn smoothing_groups() {
    Shot::model("loaders/smoothing-groups.obj").from(0.0, 35.0).size(160, 64).check("loaders/smoothing-groups");
}

/// A text STL file: z is up, facets are flat.
#[test]
fn stl_facets() {
    Shot::model("loaders/stl-facets.stl").check("loaders/stl-facets");
}

/// A PLY file with colours of vertices; two triangles and a quad.
#[test]
fn ply_colors() {
    Shot::model("loaders/ply-colors.ply").face_on().check("loaders/ply-colors");
}

/// A texture that is not there is a warning and leaves the colour.
#[test]
fn missing_texture() {
    let material = "newmtl m\nillum 0\nKd 0.2 0.6 0.4\nmap_Kd no-such-file.png\n";
    let shot = Shot::obj(&format!("usemtl m\n{}", square()), material).face_on();
    shot.warned("no-such-file.png").check("loaders/missing-texture");
}
