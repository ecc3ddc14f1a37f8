//! Common tangents of sheaves in space: closed forms in a plane, tangency and gradients at random in space.

use std::f64::consts::PI;

use super::rigs::cases;
use gantline_core::rope::seat::{FIRST_WRAP, fleet_angle, wrap_angle};
use gantline_core::rope::tangency::{Circle, NoTangent, common_tangent};
use glam::{DQuat, DVec3};
use proptest::prelude::*;

fn circle(x: f64, y: f64, axis: f64, radius: f64) -> Circle {
    Circle { centre: DVec3::new(x, y, 0.0), axis: DVec3::Z * axis, radius }
}

#[test]
fn open_and_crossed_belt() {
    // Both turn the same way: outer tangent, ℓ² = D² − (r₁ − r₂)²; opposite ways: inner, ℓ² = D² − (r₁ + r₂)².
    let (distance, first, second) = (5.0_f64, 1.0, 0.4);
    let start = circle(0.0, 0.0, 1.0, first);
    for (sense, difference) in [(1.0, first - second), (-1.0, first + second)] {
        let tangent = common_tangent(&start, &circle(distance, 0.0, sense, second)).unwrap();
        let exact = (distance * distance - difference * difference).sqrt();
        assert!((tangent.length - exact).abs() < 1e-14 * distance);
        // The rope runs about +z on the start: it leaves below for a run to +x.
        assert!(tangent.from.y < 0.0);
        assert!((tangent.to.y < 0.0) == (sense > 0.0));
        // In a plane nothing but the direction pulls.
        assert!((tangent.pull - tangent.direction).length() < 1e-14);
    }
}

#[test]
fn half_a_turn_between_vertical_parts() {
    let sheave = Circle { centre: DVec3::ZERO, axis: DVec3::Y, radius: 0.4 };
    let (down, up) = (DVec3::new(0.4, 0.0, 7.0), DVec3::new(-0.4, 0.0, 9.0));
    let arrives = common_tangent(&Circle::point(down), &sheave).unwrap();
    let leaves = common_tangent(&sheave, &Circle::point(up)).unwrap();
    assert!((arrives.length - 7.0).abs() < 1e-14 && (leaves.length - 9.0).abs() < 1e-14);
    assert!((wrap_angle(sheave.axis, arrives.radial[1], leaves.radial[0], FIRST_WRAP) - PI).abs() < 1e-14);
}

#[test]
fn degenerate_cases_are_named() {
    let sheave = circle(0.0, 0.0, 1.0, 1.0);
    let inside = Circle::point(DVec3::new(0.3, 0.0, 2.0));
    assert_eq!(common_tangent(&sheave, &inside), Err(NoTangent::InsideStart));
    assert_eq!(common_tangent(&inside, &sheave), Err(NoTangent::InsideEnd));
    // On the rim itself a point leaves no direction to go.
    let rim = Circle::point(DVec3::X);
    assert_eq!(common_tangent(&sheave, &rim), Err(NoTangent::InsideStart));
    let on_axis = Circle::point(DVec3::new(0.0, 0.0, 3.0));
    assert_eq!(common_tangent(&sheave, &on_axis), Err(NoTangent::AlongStart));
    assert_eq!(common_tangent(&on_axis, &sheave), Err(NoTangent::AlongEnd));
    let point = Circle::point(DVec3::ONE);
    assert_eq!(common_tangent(&point, &point), Err(NoTangent::Coincident));
    assert_eq!(common_tangent(&sheave, &circle(0.0, 0.0, 1.0, 0.5)), Err(NoTangent::Coincident));
    let lost = Circle::point(DVec3::new(0.0, f64::NAN, 0.0));
    assert_eq!(common_tangent(&sheave, &lost), Err(NoTangent::NotFinite));
    assert_eq!(common_tangent(&Circle::point(DVec3::ZERO), &lost), Err(NoTangent::NotFinite));
}

#[test]
fn circles_that_touch_or_overlap() {
    let (first, second) = (1.0_f64, 0.9);
    let start = circle(0.0, 0.0, 1.0, first);
    for distance in [0.5, 1.0, 1.5, first + second] {
        // No rope passes between them.
        let crossing = common_tangent(&start, &circle(distance, 0.0, -1.0, second));
        assert_eq!(crossing, Err(NoTangent::Overlapping), "{distance}");
        // An open belt lies around both all the same, though each may hold the other's centre.
        let open = common_tangent(&start, &circle(distance, 0.0, 1.0, second)).unwrap();
        let exact = (distance * distance - (first - second).powi(2)).sqrt();
        assert!((open.length - exact).abs() < 1e-14);
    }
    // One within the other: no tangent of any kind.
    let within = circle(0.05, 0.0, 1.0, second);
    assert_eq!(common_tangent(&start, &within), Err(NoTangent::InsideStart));
}

/// Found by `tangents_in_space`: seen along the axis of the second sheave the first is in its way, and all that is left is a
/// part that would leave the first backwards. It was said to graze, since only the first one's axis was looked along.
#[test]
fn a_part_that_would_leave_backwards_is_in_the_way() {
    let start = Circle {
        centre: DVec3::ZERO,
        axis: DVec3::new(0.45365038131269975, 0.06094506485280976, -0.8890933756388746),
        radius: 0.6169359981581043,
    };
    let end = Circle {
        centre: DVec3::new(-1.8783844934737703, 2.052135085091574, 0.2215435745532174),
        axis: DVec3::new(0.42315668837248094, -0.8169313857771701, -0.3918692741435944),
        radius: 0.5777920989065167,
    };
    assert_eq!(common_tangent(&start, &end), Err(NoTangent::Overlapping));
}

/// Found by `tangents_in_space`: going back and forth ended with the part that leaves backwards, though the two circles are just
/// clear of each other, by 2 cm along the second axis.
#[test]
fn circles_just_clear_of_each_other_have_their_tangent() {
    let start = Circle {
        centre: DVec3::ZERO,
        axis: DVec3::new(0.8123046128992487, -0.3581209375200448, 0.46033749572717414),
        radius: 0.8096475139321052,
    };
    let end = Circle {
        centre: DVec3::new(0.597260886377561, -2.316813438888728, 2.100608952404421),
        axis: DVec3::new(0.6113636291846842, -0.7488923575633982, 0.2557239716828813),
        radius: 0.954267385626333,
    };
    let tangent = common_tangent(&start, &end).unwrap();
    // By bisection of u₁·D over the angle at the start, in a program of its own.
    assert!((tangent.length - 2.6974940512927215).abs() < 1e-12);
    for (circle, radial) in [(&start, tangent.radial[0]), (&end, tangent.radial[1])] {
        assert!(radial.dot(tangent.direction).abs() < 1e-12);
        assert!(tangent.direction.dot(circle.axis.cross(radial)) > 0.1);
    }
}

#[test]
fn degenerate_cases_say_what_is_in_the_way() {
    let messages = [
        (NoTangent::InsideStart, "where it starts holds the other end within its circle"),
        (NoTangent::InsideEnd, "where it ends holds the other end within its circle"),
        (NoTangent::AlongStart, "axis of the sheave where it starts points at the other end"),
        (NoTangent::AlongEnd, "axis of the sheave where it ends points at the other end"),
        (NoTangent::Overlapping, "touch or overlap"),
        (NoTangent::Coincident, "ends coincide"),
        (NoTangent::Grazing, "grazes a sheave"),
        (NoTangent::NotFinite, "not a number"),
    ];
    for (case, words) in messages {
        assert!(case.to_string().contains(words), "{case}");
    }
}

#[test]
fn wrap_goes_on_through_any_angle() {
    let mut wrap = FIRST_WRAP;
    // There and back over a turn and a half, in steps below half a turn.
    for degrees in (-80..540).step_by(7).chain((-80..540).step_by(7).rev()) {
        let angle = f64::from(degrees).to_radians();
        let turn = DQuat::from_axis_angle(DVec3::Z, angle);
        wrap = wrap_angle(DVec3::Z, DVec3::X, turn * DVec3::X, wrap);
        assert!((wrap - angle).abs() < 1e-13);
    }
}

#[test]
fn fleet_angle_has_the_side_of_the_axis() {
    for degrees in [-90.0_f64, -4.0, 0.0, 1e-6, 89.0] {
        let angle = degrees.to_radians();
        let outwards = DVec3::new(angle.cos(), 0.0, angle.sin());
        assert!((fleet_angle(DVec3::Z, outwards) - angle).abs() < 1e-15);
    }
}

/// Two sheaves in space with axes in any direction, radii over a decade, one of them a point at times.
fn pair() -> impl Strategy<Value = (Circle, Circle)> {
    let vector = || prop::array::uniform3(-1.0..1.0_f64).prop_map(DVec3::from_array);
    let radius = || prop_oneof![4 => 0.1..1.0_f64, 1 => Just(0.0)];
    let parts = (vector(), vector(), vector(), vector(), radius(), radius(), 2.5..40.0_f64);
    parts.prop_filter_map("axes need a direction", |(centre, way, first, second, r1, r2, distance)| {
        let way = way.try_normalize()?;
        let start = Circle { centre, axis: first.try_normalize()?, radius: r1 };
        let end = Circle { centre: centre + way * distance, axis: second.try_normalize()?, radius: r2 };
        Some((start, end))
    })
}

/// Length of the part and of the rope beyond fixed marks on the sheaves: what the gradient is the derivative of.
/// `turn` and `shift` move the two bodies; the marks move with them.
fn reach(start: &Circle, end: &Circle, marks: [DVec3; 2], moves: [(DQuat, DVec3); 2]) -> Option<f64> {
    let moved = |circle: &Circle, (turn, shift): (DQuat, DVec3)| Circle {
        centre: turn * circle.centre + shift,
        axis: turn * circle.axis,
        radius: circle.radius,
    };
    let (start, end) = (moved(start, moves[0]), moved(end, moves[1]));
    let tangent = common_tangent(&start, &end).ok()?;
    let arc = |circle: &Circle, mark: DVec3, radial: DVec3| {
        let angle = circle.axis.dot(mark.cross(radial)).atan2(mark.dot(radial));
        circle.radius * angle
    };
    let leaving = arc(&start, moves[0].0 * marks[0], tangent.radial[0]);
    let arriving = arc(&end, moves[1].0 * marks[1], tangent.radial[1]);
    Some(tangent.length + leaving - arriving)
}

proptest! {
    #![proptest_config(cases(10_000))]

    #[test]
    fn tangents_in_space((start, end) in pair(), way in prop::array::uniform4(prop::array::uniform3(-1.0..1.0_f64))) {
        let tangent = match common_tangent(&start, &end) {
            Ok(tangent) => tangent,
            // Only where the other end lies close to the axis, seen along it.
            Err(NoTangent::InsideStart | NoTangent::InsideEnd | NoTangent::Overlapping) => {
                let way = end.centre - start.centre;
                let flat = start.axis.cross(way).length().min(end.axis.cross(way).length());
                prop_assert!(flat <= start.radius + end.radius);
                return Ok(());
            }
            Err(other) => return Err(TestCaseError::fail(other.to_string())),
        };
        for (circle, radial) in [(&start, tangent.radial[0]), (&end, tangent.radial[1])] {
            prop_assert!(radial.dot(tangent.direction).abs() < 1e-12);
            prop_assert!(radial.dot(circle.axis).abs() < 1e-12);
            if circle.radius > 0.0 {
                prop_assert!((radial.length() - 1.0).abs() < 1e-12);
                prop_assert!(tangent.direction.dot(circle.axis.cross(radial)) > 0.0);
            }
        }
        // Nearly grazing tangents (the other end almost inside) turn infinitely fast: not compared.
        let grazing = [(&start, 0), (&end, 1)].into_iter().any(|(circle, k)| {
            circle.radius > 0.0 && tangent.direction.dot(circle.axis.cross(tangent.radial[k])) < 0.2
        });
        prop_assume!(!grazing);
        let [v1, w1, v2, w2] = way.map(DVec3::from_array);
        let d = 1e-5;
        let moved = |step: f64| {
            let one = |v: DVec3, w: DVec3| (DQuat::from_scaled_axis(w * step), v * step);
            reach(&start, &end, tangent.radial, [one(v1, w1), one(v2, w2)])
        };
        // Nearly grazing tangents have third derivatives of 1e5: differences of sixth order.
        let mut difference = 0.0;
        for (steps, weight) in [(1.0, 0.75), (2.0, -0.15), (3.0, 1.0 / 60.0)] {
            let (Some(after), Some(before)) = (moved(steps * d), moved(-steps * d)) else { return Ok(()) };
            difference += weight * (after - before) / d;
        }
        let shift = (v2 + w2.cross(tangent.to)) - (v1 + w1.cross(tangent.from));
        let exact = tangent.pull.dot(shift) + tangent.couple[0].dot(w1) + tangent.couple[1].dot(w2);
        // Rounding 1e-16 · 40 m/d = 4e-10, a hundred times that where a part nearly grazes.
        prop_assert!((difference - exact).abs() < 1e-7, "{difference} {exact}");
    }
}

/// A rope that leaves for the rim of a sheave that is all but edge on to it: the way from the middle of the first sheave
/// is within the circle of the second, seen along its axis, that from the rim is not. Tangency is what is asked for, to
/// rounding; a millimetre on, the length goes on as the pull says.
#[test]
fn seen_along_the_axis_from_the_middle_and_not_from_the_rim() {
    let at = |share: f64| {
        let start = Circle {
            centre: DVec3::new(36.557_103_9, 36.489_777_1, 23.962_531_6),
            axis: DVec3::new(-0.928_368_445, 0.345_604_835, 0.136_708_918).normalize(),
            radius: 0.140_521_664,
        };
        let end = Circle {
            centre: DVec3::new(37.489_520_6, 34.990_353_7, 21.444_290_0)
                + share * DVec3::new(-1.0, 6.9, 6.4) * 1e-5,
            axis: DVec3::new(-0.567_547_048, 0.404_261_500, 0.717_260_753).normalize(),
            radius: 0.946_971_288,
        };
        (start, end)
    };
    let mut lengths = Vec::new();
    for share in [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0] {
        let (start, end) = at(share);
        let tangent = common_tangent(&start, &end).unwrap();
        let span = tangent.to - tangent.from;
        for radial in tangent.radial {
            assert!(radial.dot(span).abs() < 1e-12 * span.length());
        }
        lengths.push(tangent.length);
    }
    // No jump to another tangent: third differences of a smooth length are nothing beside its steps.
    for four in lengths.windows(4) {
        assert!((four[3] - 3.0 * four[2] + 3.0 * four[1] - four[0]).abs() < 1e-9, "{lengths:?}");
    }
}
