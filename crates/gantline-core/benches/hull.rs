//! Time of cutting a hull by the water: `cargo bench -p gantline-core --bench hull`. Least of many runs, since others
//! may use the machine.

#[path = "../tests/rigs/hulls.rs"]
#[allow(dead_code)]
mod hulls;

use std::hint::black_box;
use std::time::Instant;

use gantline_core::hull::{Hull, Plane};
use glam::{DQuat, DVec3};

fn main() {
    println!("panels   even keel   heeled 20°   [µs]");
    for rings in [9, 28, 56, 170] {
        let mut mesh = hulls::sphere(1.0, rings);
        mesh.vertices.iter_mut().for_each(|vertex| *vertex *= DVec3::new(60.0, 15.0, 8.0));
        let hull = Hull::new(&mesh);
        let least = |heel: f64| {
            let normal = DQuat::from_rotation_x(heel.to_radians()) * DVec3::Z;
            let one = |height: f64| {
                let start = Instant::now();
                black_box(hull.below(black_box(&Plane { normal, height })));
                start.elapsed().as_secs_f64() * 1e6
            };
            (0..2000).map(|k| one(0.5 + 1e-4 * f64::from(k))).fold(f64::INFINITY, f64::min)
        };
        println!("{:6}   {:9.1}   {:10.1}", hull.panels(), least(0.0), least(20.0));
    }
}
