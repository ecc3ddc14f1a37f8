//! Distances of boxes with parallel edges, against plane geometry.
//!
//! The load of `scenarios/floating_crane` and the boom above it are symmetric about one plane. At 7 of 1376 samples,
//! where rounding tilted one of them by 1e-17 the wrong way, their distance was 41.1 m or 33.5 m; the points that were
//! recorded beside it were 27.7 m apart.

use gantline_core::contact::shape::{Part, Shape};
use gantline_core::tree::pose::Pose;
use glam::{DMat3, DQuat, DVec3};

const ROUNDING: f64 = 1e-6; // m, what the iteration for a distance of 27 m may leave

fn a_box(size: DVec3, centre: DVec3) -> Shape {
    Shape::new(&[Part::Box { size, centre, orientation: DQuat::IDENTITY }]).unwrap()
}

/// The nearest points are a lower edge of the boom's box, which has the normal n, and the upper edge of the load's box
/// that looks at it: (edge - centre) . n - half of its height.
#[test]
fn the_distance_is_that_of_the_nearest_edges() {
    let boom = a_box(DVec3::new(110.0, 14.0, 3.3), DVec3::ZERO);
    let load = a_box(DVec3::new(27.0, 34.0, 11.0), DVec3::ZERO);
    let edge = DVec3::new(33.9, 0.0, 16.0);
    let middle = edge + DVec3::new(13.5, 0.0, -5.5);
    for step in 0..400 {
        let luff = 1.05 + 1e-4 * f64::from(step);
        let along = DVec3::new(luff.cos(), 0.0, luff.sin());
        let normal = DVec3::new(luff.sin(), 0.0, -luff.cos());
        let foot = DVec3::new(-4.3, 0.0, 4.9);
        let centre = foot + 55.0 * along;
        let rotation = DMat3::from_cols(along, DVec3::Y, -normal);
        // Turned as rounding does, and as a load does that sways by nothing one would see.
        for tilt in [0.0, 1e-17, -1e-17, 1e-12, -1e-12, 1e-9, -1e-9] {
            let held = Pose { position: centre, rotation: rotation * DMat3::from_rotation_z(tilt) };
            let hung = Pose { position: middle, rotation: DMat3::from_rotation_x(-tilt) };
            let wanted = (edge - centre).dot(normal) - 1.65;
            for found in [boom.apart(&load, [&held, &hung]), load.apart(&boom, [&hung, &held])] {
                assert!((found.distance - wanted).abs() < ROUNDING, "{} for {wanted}", found.distance);
                let between = (found.points[0] - found.points[1]).length();
                assert!((between - wanted).abs() < ROUNDING, "{between} between points for {wanted}");
            }
        }
    }
}
