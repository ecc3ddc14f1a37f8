//! Convex hulls that touch a box to rounding, as a load does that starts to the letter on a deck: parry took some of them
//! for metres deep in each other, with 61 GN at the start, since it missed the face with which they touch.

use std::f64::consts::{FRAC_PI_2, PI};

use super::rigs::cases;
use gantline_core::contact::shape::{Part, Shape};
use gantline_core::tree::pose::Pose;
use glam::{DMat3, DQuat, DVec3};
use proptest::prelude::*;

/// Corners of a prism with as many sides about the x axis, one of them lowest and level.
fn prism(sides: u32, radius: f64, length: f64) -> Vec<DVec3> {
    let angle = |side| PI * (2.0 * f64::from(side) + 1.0) / f64::from(sides) - FRAC_PI_2;
    let ends = [-0.5 * length, 0.5 * length];
    let around = (0..sides).map(|side| radius * DVec3::new(0.0, angle(side).cos(), angle(side).sin()));
    around.flat_map(|place| ends.map(|end| place + end * DVec3::X)).collect()
}

proptest! {
    // Of such places seven in a thousand were wrong.
    #![proptest_config(cases(4000))]

    /// A prism over the top of a box, on its end, on a side or on an edge, is as far from it as it was put: the lowest
    /// of its corners less the top. They are round numbers half of the time.
    #[test]
    fn hulls_that_touch_a_box_to_rounding_are_not_deep_in_it(
        sides in 3_u32..64,
        (radius, length) in (0.5..5.0, 1.0..30.0),
        stands in prop::sample::select(vec![Some(0.0), None, Some(0.1)]),
        (is_round, x, y, top, yaw) in (any::<bool>(), -2.0..2.0, -2.0..2.0, 0.0..5.0, 0.0..6.0),
        thick in 0.1..8.0,
        gap in prop::sample::select(vec![0.0, 1e-15, -1e-15, 1e-12, -1e-12, 1e-9, -1e-9, -1e-6, 1e-6]),
    ) {
        let [x, y, top, yaw] = if is_round { [0.0, 0.0, f64::round(top), 0.0] } else { [x, y, top, yaw] };
        let corners = prism(sides, radius, length);
        let [hull, deck] = prism_and_deck(sides, [radius, length], [top, thick]);
        let upright = stands.map_or(DMat3::IDENTITY, |leans| DMat3::from_rotation_y(FRAC_PI_2 - leans));
        let rotation = DMat3::from_rotation_z(yaw) * upright;
        let lowest = corners.iter().map(|corner| (rotation * *corner).z).fold(f64::INFINITY, f64::min);
        let poses = [
            &Pose { position: DVec3::new(x, y, top + gap - lowest), rotation },
            &Pose { position: DVec3::ZERO, rotation: DMat3::IDENTITY },
        ];
        let mut found = Vec::new();
        hull.meet(&deck, poses, 0.05, &mut found);
        prop_assert!(!found.is_empty());
        // Gaps are those of corners: rounding of numbers of up to 45 m.
        prop_assert!((found[0].gap - gap).abs() < 1e-9, "{:e} of {gap:e}", found[0].gap);
        // Distances are found as squares: to the square root of rounding, 1.5e-8 of 45 m. With other seeds than that of the
        // tests one of some hundred thousand was 19 m.
        for distance in [hull.distance(&deck, poses), hull.apart(&deck, poses).distance] {
            prop_assert!((distance - gap).abs() < 1e-6, "{distance:e} of {gap:e}");
        }
        let normal = found[0].spot.in_world(poses).1;
        prop_assert!(normal.z > 0.999, "{normal}");
    }
}

/// A prism, and a deck so large that all of it is over that, its top at `top` [m].
fn prism_and_deck(sides: u32, [radius, length]: [f64; 2], [top, thick]: [f64; 2]) -> [Shape; 2] {
    let (size, centre) = (DVec3::new(45.0, 45.0, thick), DVec3::Z * (top - 0.5 * thick));
    let deck = Part::Box { size, centre, orientation: DQuat::IDENTITY };
    [Part::Convex(prism(sides, radius, length)), deck].map(|part| Shape::new(&[part]).expect("it has volume"))
}

/// A prism of four sides on its end, with nothing between it and the deck: its normal leaned by 5.6°, since the direction
/// between two points with no distance between them is rounding.
#[test]
fn what_touches_to_the_letter_has_the_normal_of_the_deck() {
    let length = 3.185_561_532_940_96;
    let [hull, deck] = prism_and_deck(4, [0.5, length], [2.0, 3.834_741_997_237_791]);
    let poses = [
        &Pose { position: DVec3::Z * (2.0 + 0.5 * length), rotation: DMat3::from_rotation_y(FRAC_PI_2) },
        &Pose { position: DVec3::ZERO, rotation: DMat3::IDENTITY },
    ];
    let mut found = Vec::new();
    hull.meet(&deck, poses, 0.05, &mut found);
    assert_eq!(found.len(), 4);
    for meeting in found {
        let normal = meeting.spot.in_world(poses).1;
        assert!(normal.distance(DVec3::Z) < 1e-9, "{normal}");
        assert!(meeting.gap.abs() < 1e-9, "{:e}", meeting.gap);
    }
}
