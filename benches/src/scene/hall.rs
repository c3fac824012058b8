//! `hall`: an interior, with the camera inside. Walls, two storeys of fluted columns with arches between them, curtains
//! and vases; 24 materials, one draw each.
//!
//! The room is 24 x 8 x 12 metres about the vertical axis, floor at y = 0. It tests clipping at the near plane and the
//! sides, overdraw, and geometry behind the camera.

use super::grid::{Mesh, PatchPoint};
use core::f32::consts::PI;
use trigon::math::host::{cos, sin};

/// How many materials, each with its own texture and draw.
pub(super) const MATERIALS: usize = 24;

/// First material of each kind of thing, and how many materials it cycles through.
const COLUMNS: MaterialCycle = MaterialCycle { first: 6, len: 4 };
const ARCHES: MaterialCycle = MaterialCycle { first: 10, len: 4 };
const CURTAINS: MaterialCycle = MaterialCycle { first: 14, len: 6 };
const VASES: MaterialCycle = MaterialCycle { first: 20, len: 4 };

/// Columns of a row.
const COLUMNS_PER_ROW: u8 = 12;

struct MaterialCycle {
    first: usize,
    len: usize,
}

impl MaterialCycle {
    fn pick(&self, number: u8) -> usize {
        self.first + usize::from(number) % self.len
    }
}

/// One mesh per material.
pub(super) fn build() -> Vec<Mesh> {
    let mut meshes = vec![Mesh::default(); MATERIALS];
    push_walls(&mut meshes);
    for storey in 0..2u8 {
        for row in 0..2u8 {
            for number in 0..COLUMNS_PER_ROW {
                push_bay(&mut meshes, storey, row, number);
            }
        }
    }
    meshes
}

/// Floor, ceiling, and the four walls: materials 0 to 5.
fn push_walls(meshes: &mut [Mesh]) {
    type Corner = fn(f32, f32) -> [f32; 3];
    let floor: Corner = |a, b| [24.0 * a - 12.0, 0.0, 12.0 * b - 6.0];
    let ceiling: Corner = |a, b| [24.0 * a - 12.0, 8.0, 6.0 - 12.0 * b];
    let back: Corner = |a, b| [24.0 * a - 12.0, 8.0 - 8.0 * b, -6.0];
    let front: Corner = |a, b| [12.0 - 24.0 * a, 8.0 - 8.0 * b, 6.0];
    let left: Corner = |a, b| [-12.0, 8.0 - 8.0 * b, 6.0 - 12.0 * a];
    let right: Corner = |a, b| [12.0, 8.0 - 8.0 * b, 12.0 * a - 6.0];
    let sides = [
        (floor, [96, 48], [12.0, 6.0]),
        (ceiling, [96, 48], [12.0, 6.0]),
        (back, [96, 32], [12.0, 4.0]),
        (front, [96, 32], [12.0, 4.0]),
        (left, [48, 32], [6.0, 4.0]),
        (right, [48, 32], [6.0, 4.0]),
    ];
    for (mesh, (corner, quads, repeats)) in meshes.iter_mut().zip(sides) {
        let point = |a, b| PatchPoint { position: corner(a, b), uv: [repeats[0] * a, repeats[1] * b] };
        mesh.push_patch(quads[0], quads[1], point);
    }
}

/// A column, the arch to the next one, and what hangs and stands between them.
fn push_bay(meshes: &mut [Mesh], storey: u8, row: u8, number: u8) {
    let x = -11.0 + 2.0 * f32::from(number);
    let z = if row == 0 { -3.0 } else { 3.0 };
    let base = 4.0 * f32::from(storey);
    push_column(&mut meshes[COLUMNS.pick(number + row + storey)], [x, base, z]);
    if number + 1 == COLUMNS_PER_ROW {
        return;
    }
    push_arch(&mut meshes[ARCHES.pick(number + row)], [x, base, z]);
    if storey == 0 {
        if number.is_multiple_of(2) {
            push_curtain(&mut meshes[CURTAINS.pick(number / 2 + row)], x, z);
        }
        push_vase(&mut meshes[VASES.pick(number + row)], x, z);
    }
}

/// A fluted column, 3 metres high, wider at both ends.
fn push_column(mesh: &mut Mesh, [x, y, z]: [f32; 3]) {
    mesh.push_patch(48, 40, |a, b| {
        let turn = 2.0 * PI * a;
        let from_middle = 2.0 * b - 1.0;
        let squared = from_middle * from_middle;
        let fourth = squared * squared;
        let radius = 0.28 + 0.10 * (fourth * fourth) + 0.015 * cos(12.0 * turn);
        let position = [x + radius * sin(turn), y + 3.0 * (1.0 - b), z + radius * cos(turn)];
        PatchPoint { position, uv: [2.0 * a, 3.0 * b] }
    });
}

/// A half torus from the top of a column to that of the next one.
fn push_arch(mesh: &mut Mesh, [x, y, z]: [f32; 3]) {
    mesh.push_patch(24, 16, |a, b| {
        let (along, around) = (PI * a, 2.0 * PI * b);
        let radius = 1.0 + 0.2 * cos(around);
        let height = 0.9 * radius * sin(along) * 0.7;
        let position = [x + 1.0 - radius * cos(along), y + 3.0 + height, z + 0.2 * sin(around)];
        PatchPoint { position, uv: [4.0 * a, b] }
    });
}

/// A curtain whose folds deepen towards the floor.
fn push_curtain(mesh: &mut Mesh, x: f32, z: f32) {
    mesh.push_patch(40, 40, |a, b| {
        let fold = 0.08 * sin(8.0 * PI * a) * (0.3 + b);
        PatchPoint { position: [x + 0.3 + 1.4 * a, 3.0 - 2.6 * b, z + fold], uv: [2.0 * a, 3.0 * b] }
    });
}

/// A vase on the floor, between two columns and nearer to the middle of the room.
fn push_vase(mesh: &mut Mesh, x: f32, z: f32) {
    mesh.push_patch(32, 24, |a, b| {
        let turn = 2.0 * PI * a;
        let radius = 0.05 + 0.2 * sin(PI * b) + 0.06 * cos(5.0 * b);
        let position = [x + 1.0 + radius * sin(turn), 0.8 * (1.0 - b), z * 0.6 + radius * cos(turn)];
        PatchPoint { position, uv: [2.0 * a, b] }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn has_its_triangles_and_stays_in_the_room() {
        let meshes = build();
        assert_eq!(meshes.iter().map(|mesh| mesh.triangles.len()).sum::<usize>(), 327_168);
        for position in meshes.iter().flat_map(|mesh| &mesh.positions) {
            let [x, y, z] = *position;
            assert!(x.abs() <= 12.0 && (-1e-3..=8.0).contains(&y) && z.abs() <= 6.0, "{position:?}");
        }
    }
}
