//! Meshes of simple bodies.

use std::f64::consts::PI;

use gantline_core::hull::Mesh;
use glam::DVec3;

/// A prism along x from `from` to `to` [m] over a convex section, points (y, z) counter-clockwise seen from +x.
pub fn prism(section: &[[f64; 2]], from: f64, to: f64) -> Mesh {
    let size = section.len();
    let ring = |x: f64| section.iter().map(move |[y, z]| DVec3::new(x, *y, *z));
    let vertices = ring(from).chain(ring(to)).collect();
    let mut triangles = Vec::new();
    for k in 0..size {
        let next = (k + 1) % size;
        triangles.extend([[k, size + next, next], [k, size + k, size + next]].map(|[a, b, c]| [a, c, b]));
    }
    for k in 1..size - 1 {
        triangles.extend([[0, k + 1, k], [size, size + k, size + k + 1]]);
    }
    Mesh { vertices, triangles }
}

/// A box of length, breadth and depth [m], x from the middle of its length, z from the keel.
pub fn cuboid([length, breadth, depth]: [f64; 3]) -> Mesh {
    let (b, l) = (breadth / 2.0, length / 2.0);
    prism(&[[-b, 0.0], [b, 0.0], [b, depth], [-b, depth]], -l, l)
}

/// A sphere about the origin with `rings` bands of latitude and twice as many sectors.
pub fn sphere(radius: f64, rings: usize) -> Mesh {
    let sectors = 2 * rings;
    let mut vertices = vec![DVec3::NEG_Z * radius];
    for ring in 1..rings {
        let latitude = PI * ring as f64 / rings as f64;
        for sector in 0..sectors {
            let angle = 2.0 * PI * sector as f64 / sectors as f64;
            let flat = latitude.sin();
            let place = DVec3::new(flat * angle.cos(), flat * angle.sin(), -latitude.cos());
            vertices.push(place * radius);
        }
    }
    vertices.push(DVec3::Z * radius);
    let at = |ring: usize, sector: usize| 1 + (ring - 1) * sectors + sector % sectors;
    let top = vertices.len() - 1;
    let mut triangles = Vec::new();
    for sector in 0..sectors {
        triangles.push([0, at(1, sector + 1), at(1, sector)]);
        for ring in 1..rings - 1 {
            let [a, b] = [at(ring, sector), at(ring, sector + 1)];
            let [c, d] = [at(ring + 1, sector), at(ring + 1, sector + 1)];
            triangles.extend([[a, b, d], [a, d, c]]);
        }
        triangles.push([top, at(rings - 1, sector), at(rings - 1, sector + 1)]);
    }
    Mesh { vertices, triangles }
}
