//! A hull that lies on the edge or the face of a box along a line pressed at both ends of the line and at a third place
//! anywhere between, with a third of its weight: the nearest point that parry finds first, kept beside those of corners and
//! edges. A pile in a hinge put its weight 0.35 m beside the middle of a cradle 2 m long.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::rigs::cases;
use gantline_core::contact::shape::{Part, Shape};
use gantline_core::tree::pose::Pose;
use glam::{DMat3, DQuat, DVec3};
use proptest::prelude::*;

const RADIUS: f64 = 2.5;

/// A prism along x with one of its corners lowest, on z = 0.
fn prism(sides: u32, length: f64) -> Shape {
    let angle = |side| TAU * f64::from(side) / f64::from(sides) - FRAC_PI_2;
    let place =
        |end, side| DVec3::new(end, RADIUS * f64::cos(angle(side)), RADIUS * (1.0 + f64::sin(angle(side))));
    let ends = [-0.5 * length, 0.5 * length];
    let corners = ends.iter().flat_map(|end| (0..sides).map(|side| place(*end, side))).collect();
    Shape::new(&[Part::Convex(corners)]).expect("it has volume")
}

fn cuboid(size: DVec3) -> Shape {
    let part = Part::Box { size, centre: DVec3::ZERO, orientation: DQuat::IDENTITY };
    Shape::new(&[part]).expect("it has volume")
}

/// Places where two shapes are as near each other as they are anywhere, to a micrometre.
fn nearest(shapes: [&Shape; 2], at: DVec3) -> Vec<DVec3> {
    let level = |position| Pose { position, rotation: DMat3::IDENTITY };
    let (one, other) = (level(DVec3::ZERO), level(at));
    let mut found = Vec::new();
    shapes[0].meet(shapes[1], [&one, &other], 0.05, &mut found);
    let least = found.first().map_or(f64::INFINITY, |meeting| meeting.gap);
    let near = found.iter().filter(|meeting| meeting.gap < least + 1e-6);
    near.map(|meeting| meeting.spot.in_world([&one, &other]).0).collect()
}

proptest! {
    #![proptest_config(cases(500))]

    /// On the upper edge of a box beside its lowest line, `aside` to there: at both ends of that edge.
    #[test]
    fn a_hull_over_an_edge_along_it_presses_at_its_two_ends(
        sides in prop::sample::select(vec![32_u32, 64, 112, 256]),
        x in -16.0..16.0,
        // No nearer to a corner of the prism than what makes two places one.
        share in 0.1..0.9,
        gap in prop::sample::select(vec![-2e-3, -1e-4, 0.0, 1e-3]),
    ) {
        let flat = TAU / f64::from(sides);
        let number = (0.2 / flat).ceil();
        let corner = |number: f64| RADIUS * DVec3::new(0.0, (number * flat).sin(), 1.0 - (number * flat).cos());
        let (low, high) = (corner(number), corner(number + 1.0));
        let edge = low.lerp(high, share);
        let at = edge + DVec3::new(x, 0.5, -0.5 - gap);
        let mut found = nearest([&prism(sides, 40.0), &cuboid(DVec3::new(2.0, 1.0, 1.0))], at);
        found.sort_by(|one, other| one.x.total_cmp(&other.x));
        prop_assert_eq!(found.len(), 2, "{:?}", found);
        for (place, end) in found.iter().zip([-1.0, 1.0]) {
            prop_assert!((place.x - x - end).abs() < 1e-9, "{}", place);
            prop_assert!((place.y - edge.y).abs() < 1e-3, "{}", place);
        }
    }

    /// On the top of a box that is wider than it: at both ends of its own lowest line.
    #[test]
    fn a_hull_on_a_face_presses_at_the_ends_of_its_lowest_line(
        sides in prop::sample::select(vec![32_u32, 64, 112, 256]),
        (x, y) in (-5.0..5.0, -5.0..5.0),
        gap in prop::sample::select(vec![-2e-3, -1e-4, 0.0, 1e-3]),
    ) {
        let found = nearest([&prism(sides, 10.0), &cuboid(DVec3::new(40.0, 30.0, 1.0))], DVec3::new(x, y, -0.5 - gap));
        let mut ends: Vec<f64> = found.iter().map(|place| place.x).collect();
        ends.sort_by(f64::total_cmp);
        prop_assert_eq!(ends.len(), 2, "{:?}", found);
        prop_assert!((ends[0] + 5.0).abs() < 1e-9 && (ends[1] - 5.0).abs() < 1e-9, "{:?}", ends);
    }
}
