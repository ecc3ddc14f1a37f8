//! Common tangents of sheaves in space: closed forms in a plane, tangency and gradients at random in space.

use std::f64::consts::PI;

use gantline_core::rope::tangency::{Circle, NoTangent, common_tangent, wrap_angle};
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
    assert!((wrap_angle(sheave.axis, arrives.radial[1], leaves.radial[0]) - PI).abs() < 1e-14);
}

#[test]
fn degenerate_cases_are_named() {
    let sheave = circle(0.0, 0.0, 1.0, 1.0);
    let inside = Circle::point(DVec3::new(0.3, 0.0, 2.0));
    assert_eq!(common_tangent(&sheave, &inside), Err(NoTangent::InsideStart));
    assert_eq!(common_tangent(&inside, &sheave), Err(NoTangent::InsideEnd));
    let on_axis = Circle::point(DVec3::new(0.0, 0.0, 3.0));
    assert_eq!(common_tangent(&sheave, &on_axis), Err(NoTangent::InsideStart));
    let point = Circle::point(DVec3::ONE);
    assert_eq!(common_tangent(&point, &point), Err(NoTangent::Coincident));
}

#[test]
fn wrap_goes_through_zero_smoothly() {
    for degrees in [-80.0_f64, -1.0, 0.0, 1.0, 179.0, 181.0, 269.0] {
        let turn = DQuat::from_axis_angle(DVec3::Z, degrees.to_radians());
        assert!((wrap_angle(DVec3::Z, DVec3::X, turn * DVec3::X) - degrees.to_radians()).abs() < 1e-14);
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
    #![proptest_config(ProptestConfig::with_cases(10_000))]

    #[test]
    fn tangents_in_space((start, end) in pair(), way in prop::array::uniform4(prop::array::uniform3(-1.0..1.0_f64))) {
        let tangent = match common_tangent(&start, &end) {
            Ok(tangent) => tangent,
            // Only where the other end lies close to the axis, seen along it.
            Err(NoTangent::InsideStart) => {
                let flat = start.axis.cross(end.centre - start.centre).length();
                prop_assert!(flat <= start.radius + end.radius);
                return Ok(());
            }
            Err(NoTangent::InsideEnd) => {
                let flat = end.axis.cross(end.centre - start.centre).length();
                prop_assert!(flat <= start.radius + end.radius);
                return Ok(());
            }
            Err(NoTangent::Coincident) => return Err(TestCaseError::fail("they are 2.5 m apart")),
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
        let d = 1e-6;
        let moved = |step: f64| {
            let one = |v: DVec3, w: DVec3| (DQuat::from_scaled_axis(w * step), v * step);
            reach(&start, &end, tangent.radial, [one(v1, w1), one(v2, w2)])
        };
        let (Some(after), Some(before)) = (moved(d), moved(-d)) else { return Ok(()) };
        let difference = (after - before) / (2.0 * d);
        let shift = (v2 + w2.cross(tangent.to)) - (v1 + w1.cross(tangent.from));
        let exact = tangent.pull.dot(shift) + tangent.couple[0].dot(w1) + tangent.couple[1].dot(w2);
        // Rounding 1e-16 · 40 m/d = 4e-9; d² times the third derivative.
        prop_assert!((difference - exact).abs() < 1e-7, "{difference} {exact}");
    }
}
