//! Touches between bodies: their derivatives against differences on trees with every joint type, where shapes meet
//! against geometry worked out by hand, and blocks that come to rest, slide and tip against closed forms.

use super::rigs::{Draw, cases, moved, rig, seeds};
use gantline_core::Simulation;
use gantline_core::build::build;
use gantline_core::constraint::{AnyConstraint, Line, Moving, Placed};
use gantline_core::contact::plane::Plane;
use gantline_core::contact::shape::{Meeting, Part, Shape};
use gantline_core::contact::spot::{Crossing, Spot};
use gantline_core::spec::{PairSpec, PartSpec, RimSpec, ShapeSpec, SystemSpec};
use gantline_core::state::State;
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System;
use gantline_core::tree::bias::Wrench;
use gantline_core::tree::kinematics::Twist;
use gantline_core::tree::pose::Pose;
use glam::{DMat3, DQuat, DVec3};
use proptest::prelude::*;

/// Central differences as in `mechanics.rs`.
const STEP: f64 = 1e-5;
const CLOSE: f64 = 1e-7;

/// The random tree of `mechanics.rs` with touches between any two of its bodies, and of one with the world, at spots that
/// are drawn: which of the two has the plane too.
fn touching(seeds: &[f64]) -> (System, State, Frame) {
    let mut spec: SystemSpec = rig(seeds);
    let mut draw = Draw::new(&seeds[100..]);
    let bodies: Vec<String> = spec.bodies.iter().map(|body| body.name.clone()).collect();
    let part = || PartSpec::Box { size: [1.0; 3], centre: [0.0; 3], orientation: [1.0, 0.0, 0.0, 0.0] };
    for body in &bodies {
        spec.shapes.push(ShapeSpec { name: body.clone(), body: Some(body.clone()), parts: vec![part()] });
    }
    spec.shapes.push(ShapeSpec { name: "world".to_owned(), body: None, parts: vec![part()] });
    for number in 0..4 {
        let one = draw.choice(bodies.len());
        let other =
            if number == 0 { bodies.len() } else { (one + 1 + draw.choice(bodies.len() - 1)) % bodies.len() };
        let shapes = [one, other].map(|index| spec.shapes[index].name.clone());
        let (name, group) = (format!("pair{number}"), "load".to_owned());
        spec.pairs.push(PairSpec {
            name,
            group,
            shapes,
            stiffness: 1e6,
            damping_time: 0.01,
            friction: 0.3,
            places: 1,
        });
    }
    for number in 0..2 {
        spec.rims.push(RimSpec {
            name: format!("rim{number}"),
            group: "load".to_owned(),
            body: bodies[draw.choice(bodies.len())].clone(),
            at: draw.vector(),
            axis: draw.direction(),
            radius: 1.0 + 0.5 * draw.number(),
            plane_point: draw.vector(),
            plane_normal: draw.direction(),
            stiffness: 1e6,
            damping_time: 0.01,
            friction: 0.3,
        });
    }
    let (mut system, mut state) = build(&spec).expect("the generator makes valid rigs");
    for spot in &mut state.spots[..4] {
        let normal = DVec3::from_array(draw.direction()).normalize();
        let plane = Plane::new(DVec3::from_array(draw.vector()), normal);
        let point = DVec3::from_array(draw.vector());
        *spot =
            Spot { is_near: true, is_swapped: draw.number() > 0.0, point, plane, crossing: None, feature: 1 };
    }
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    for (_, constraint) in touches(&system).take(4).step_by(2) {
        let AnyConstraint::Touch(touch) = constraint else { continue };
        let poses = touch.facing.bodies.map(|body| frame.kinematics.pose_of(body));
        cross(&mut state.spots[touch.spot], poses, &mut draw);
    }
    // One rim is a circle, the other all within its dome, which is so wide that differences of 1e-5 tell its curvature.
    for constraint in &mut system.constraints {
        let AnyConstraint::Touch(touch) = constraint else { continue };
        if let Some(rim) = touch.facing.rim.as_mut().filter(|_| touch.name == "rim1") {
            rim.dome = 1.5;
        }
    }
    assert!(state.spots[4..].iter().all(|spot| spot.is_near));
    frame.update(&system, &state);
    (system, state, frame)
}

/// Makes a spot one where edges that are drawn cross: its points are those that are nearest to each other.
fn cross(spot: &mut Spot, poses: [&Pose; 2], draw: &mut Draw) {
    let [with_point, with_plane] = if spot.is_swapped { [poses[1], poses[0]] } else { poses };
    let [own, mut other] = [(); 2].map(|()| DVec3::from_array(draw.direction()).normalize());
    let own_before = with_plane.rotation.transpose() * (with_point.rotation * own);
    if own_before.cross(other).length() < 0.3 {
        other = own_before.any_orthonormal_vector();
    }
    let normal = own_before.cross(other).normalize() * draw.number().signum();
    let local = with_plane.rotation.transpose() * (with_point.point(spot.point) - with_plane.position);
    let gap_before = draw.number();
    let point = local - normal * gap_before;
    spot.plane = Plane { point, normal, tangents: [other, normal.cross(other)] };
    spot.crossing = Some(Crossing { own, own_before, other, gap_before });
}

fn touches(system: &System) -> impl Iterator<Item = (usize, &AnyConstraint)> {
    let all = system.constraints.iter().enumerate();
    all.filter(|(_, constraint)| matches!(constraint, AnyConstraint::Touch(_)))
}

/// Derivative by central differences over one and two steps, each after and before, without what grows as the step
/// squared: a rim that lies nearly flat on its plane bends within millimetres.
fn extrapolated(values: [[f64; 2]; 2]) -> f64 {
    let [once, twice] = values.map(|[after, before]| after - before);
    (8.0 * once - twice) / (12.0 * STEP)
}

fn unit(size: usize, dof: usize) -> Vec<f64> {
    (0..size).map(|other| if other == dof { 1.0 } else { 0.0 }).collect()
}

proptest! {
    #![proptest_config(cases(200))]

    /// ∂g/∂q and ∂G/∂q of all three rows against central differences of values and gradients.
    #[test]
    fn derivatives_of_touches_equal_differences(seeds in seeds()) {
        let (system, state, frame) = touching(&seeds);
        prop_assert_eq!(touches(&system).count(), 6);
        for (index, constraint) in touches(&system) {
            let first = system.rows.first[index];
            let entries = system.rows.start[first]..system.rows.start[first + 3];
            let Frame { kinematics, feeding, .. } = &frame;
            let State { q, seats, spots, .. } = &state;
            let at = Placed { tree: &system.tree, kinematics, q, seats, spots, feeding };
            let mut curved = vec![vec![0.0; system.tree.velocities]; system.rows.dofs.len()];
            for (group, (row, dofs)) in constraint.curvature_groups().into_iter().enumerate() {
                let mut block = vec![0.0; dofs.len() * dofs.len()];
                let mut columns = vec![DVec3::ZERO; dofs.len()];
                constraint.curvature(&at, frame.value[first + row], group, &mut columns, &mut block);
                for j in 0..dofs.len() {
                    for (k, &other) in dofs.iter().enumerate() {
                        curved[system.rows.start[first + row] + j][other] += block[j * dofs.len() + k];
                    }
                }
            }
            for dof in 0..system.tree.velocities {
                let direction = unit(system.tree.velocities, dof);
                let [once, twice] = [STEP, 2.0 * STEP].map(|step| {
                    [step, -step].map(|step| moved(&system, &state, &direction, step).1)
                });
                for row in first..first + 3 {
                    let difference = extrapolated([&once, &twice].map(|frames| frames.each_ref().map(|frame| frame.value[row])));
                    let exact = system.rows.rate(&frame.gradient, row, &direction);
                    prop_assert!((difference - exact).abs() < CLOSE, "row {row} dof {dof}: {difference} {exact}");
                }
                for entry in entries.clone() {
                    let difference = extrapolated([&once, &twice].map(|frames| frames.each_ref().map(|frame| frame.gradient[entry])));
                    prop_assert!((difference - curved[entry][dof]).abs() < 1e-6, "entry {entry} dof {dof}: {difference} {}", curved[entry][dof]);
                }
            }
        }
    }

    /// The same rows by the motion of the bodies: values, rates ė = G v, and forces on the bodies, whose power is T ė.
    #[test]
    fn rates_and_forces_belong_to_the_gradient(seeds in seeds()) {
        let (system, state, frame) = touching(&seeds);
        let mut twists = vec![Twist::default(); system.tree.bodies.len()];
        frame.kinematics.twists(&system.tree, &state.v, &mut twists);
        for (index, constraint) in touches(&system) {
            let first = system.rows.first[index];
            let State { q, v, seats, spots, .. } = &state;
            let moving = Moving { kinematics: &frame.kinematics, twists: &twists, q, v, seats, spots };
            let mut value = state.memory[first..first + 3].to_vec();
            let (mut rate, mut lines) = ([0.0; 3], [Line::default(); 3]);
            constraint.locate(&moving, &mut value, &mut rate, &mut lines);
            let tension = [7.0, -2.0, 3.0];
            let mut wrenches = vec![Wrench::default(); system.tree.bodies.len()];
            constraint.apply(&tension, &lines, &mut wrenches);
            let power: f64 = wrenches.iter().zip(&twists).map(|(w, t)| w.force.dot(t.linear) + w.moment.dot(t.angular)).sum();
            let scale = 1.0 + rate.iter().map(|rate| rate.abs()).sum::<f64>();
            for row in 0..3 {
                prop_assert!((value[row] - frame.value[first + row]).abs() < 1e-12);
                let exact = system.rows.rate(&frame.gradient, first + row, v);
                prop_assert!((rate[row] - exact).abs() < 1e-11 * scale, "{} {exact}", rate[row]);
            }
            let through_rows: f64 = tension.iter().zip(rate).map(|(tension, rate)| tension * rate).sum();
            prop_assert!((power - through_rows).abs() < 1e-10 * scale);
        }
    }

    /// A spot that changes keeps the deflection of its springs: what is remembered gives it back.
    #[test]
    fn a_deflection_is_kept_across_a_change_of_spot(seeds in seeds()) {
        let (system, mut state, frame) = touching(&seeds);
        for (index, constraint) in touches(&system) {
            let AnyConstraint::Touch(touch) = constraint else { continue };
            if touch.facing.rim.is_some() {
                continue; // its plane is always that of the second body
            }
            let first = system.rows.first[index];
            let old = state.spots[touch.spot];
            let new = Spot { is_swapped: !old.is_swapped, ..old };
            // Along the new plane: what is across it is lost, as it must be.
            let normal = touch.facing.normal(&frame.kinematics, &new);
            let wished = DVec3::new(0.3, -0.2, 0.5).reject_from_normalized(normal);
            state.spots[touch.spot] = new;
            let remembered = touch.facing.remembered(&frame.kinematics, &new, wished);
            state.memory[first + 1..first + 3].copy_from_slice(&remembered);
            let mut after = Frame::new(&system);
            after.update(&system, &state);
            let found = touch.facing.displaced(&after.kinematics, &new, [after.value[first + 1], after.value[first + 2]]);
            prop_assert!((found - wished).length() < 1e-12, "{found} {wished}");
        }
    }

    /// Distances of boxes in any attitude, apart: their gradient over a shift is the unit vector of the shortest way,
    /// so a shift along it changes the distance by as much, and one across it by nothing to first order.
    #[test]
    fn distances_change_along_the_shortest_way_only(turn in prop::collection::vec(-1.0..1.0_f64, 8), way in prop::collection::vec(-1.0..1.0_f64, 3)) {
        let turned = |at: usize| DQuat::from_xyzw(turn[at], turn[at + 1], turn[at + 2], turn[at + 3] + 1.5).normalize();
        let shape = |size: [f64; 3]| Shape::new(&[Part::Box { size: DVec3::from_array(size), centre: DVec3::ZERO, orientation: DQuat::IDENTITY }]).unwrap();
        let (one, other) = (shape([1.0, 2.0, 3.0]), shape([2.0, 1.0, 1.5]));
        let way = DVec3::from_slice(&way) + DVec3::new(0.0, 0.0, 1.5);
        let own = Pose::new(turned(0), DVec3::ZERO);
        let apart = |shift: DVec3| one.distance(&other, [&own, &Pose::new(turned(4), way.normalize() * 5.0 + shift)]);
        let here = apart(DVec3::ZERO);
        // Differences of 1e-5: rounding of GJK, about 1e-9, over the step, and the step times a curvature of 1/here.
        let gradient = DVec3::from_array([DVec3::X, DVec3::Y, DVec3::Z].map(|axis| (apart(axis * 1e-5) - apart(-axis * 1e-5)) / 2e-5));
        prop_assert!((gradient.length() - 1.0).abs() < 2e-3, "{gradient} at {here}");
        prop_assert!((apart(-gradient * 0.5 * here) - 0.5 * here).abs() < 2e-3 * here);
    }
}

fn boxed(size: [f64; 3]) -> Shape {
    let part = Part::Box { size: DVec3::from_array(size), centre: DVec3::ZERO, orientation: DQuat::IDENTITY };
    Shape::new(&[part]).unwrap()
}

fn placed(x: f64, y: f64, z: f64) -> Pose {
    Pose { rotation: DMat3::IDENTITY, position: DVec3::new(x, y, z) }
}

fn meet(one: &Shape, other: &Shape, poses: [&Pose; 2], reach: f64) -> Vec<Meeting> {
    let mut found = Vec::new();
    one.meet(other, poses, reach, &mut found);
    found
}

#[test]
fn a_box_over_a_slab_meets_it_at_its_four_lower_corners() {
    let (load, slab) = (boxed([2.0, 1.0, 1.0]), boxed([1000.0, 1000.0, 20.0]));
    let found = meet(&load, &slab, [&placed(30.0, -7.0, 0.6), &placed(0.0, 0.0, -10.0)], 0.2);
    assert_eq!(found.len(), 4);
    for meeting in &found {
        let Spot { is_swapped, point, plane, .. } = meeting.spot;
        // The plane is the slab's top, the point a corner of the load: 0.1 m apart.
        assert!(!is_swapped && (meeting.gap - 0.1).abs() < 1e-12);
        assert!((plane.normal - DVec3::Z).length() < 1e-12);
        assert!((point.abs() - DVec3::new(1.0, 0.5, 0.5)).length() < 1e-9, "{point}");
    }
    assert!(meet(&load, &slab, [&placed(0.0, 0.0, 0.71), &placed(0.0, 0.0, -10.0)], 0.2).is_empty());
}

#[test]
fn convex_parts_and_a_mesh_of_a_box_meet_a_slab_like_the_box() {
    let corners = [0, 1, 2, 3, 4, 5, 6, 7].map(|corner| {
        let side = |bit: i32| if corner >> bit & 1 == 1 { 0.5 } else { -0.5 };
        DVec3::new(2.0 * side(0), side(1), side(2))
    });
    let triangles = vec![
        [0, 2, 1],
        [1, 2, 3],
        [4, 5, 6],
        [5, 7, 6],
        [0, 1, 4],
        [1, 5, 4],
        [2, 6, 3],
        [3, 6, 7],
        [0, 4, 2],
        [2, 4, 6],
        [1, 3, 5],
        [3, 7, 5],
    ];
    let slab = boxed([1000.0, 1000.0, 20.0]);
    let halves = [0.0, 1.0].map(|end: f64| {
        let shifted = corners.map(|corner| DVec3::new(0.5 * corner.x + end - 0.5, corner.y, corner.z));
        Part::Convex(shifted.to_vec())
    });
    let shapes = [
        Shape::new(&[Part::Convex(corners.to_vec())]).unwrap(),
        Shape::new(&halves).unwrap(),
        Shape::new(&[Part::Mesh(corners.to_vec(), triangles)]).unwrap(),
    ];
    let poses = [&placed(30.0, -7.0, 0.6), &placed(0.0, 0.0, -10.0)];
    for (which, shape) in shapes.iter().enumerate() {
        assert!((shape.distance(&slab, poses) - 0.1).abs() < 1e-9);
        let found = meet(shape, &slab, poses, 0.2);
        for corner in corners.iter().filter(|corner| corner.z < 0.0) {
            // Which of the two has the plane is left open: the places are in the world.
            let is_there = |meeting: &&Meeting| {
                let spot = &meeting.spot;
                let place =
                    if spot.is_swapped { spot.point + DVec3::new(-30.0, 7.0, -10.6) } else { spot.point };
                (place - *corner).truncate().length() < 1e-6 && (meeting.gap - 0.1).abs() < 1e-9
            };
            assert!(
                found.iter().any(|meeting| is_there(&meeting)),
                "shape {which}: no meeting at {corner}: {found:?}"
            );
        }
    }
}

#[test]
fn distances_of_boxes_apart_and_into_one_another() {
    let (one, other) = (boxed([2.0, 2.0, 2.0]), boxed([1.0, 1.0, 1.0]));
    let here = placed(0.0, 0.0, 0.0);
    assert!((one.distance(&other, [&here, &placed(5.0, 0.0, 0.0)]) - 3.5).abs() < 1e-12);
    // Corner to corner: 1 m apart along each axis.
    assert!((one.distance(&other, [&here, &placed(2.5, 2.5, 2.5)]) - 3.0_f64.sqrt()).abs() < 1e-12);
    assert!((one.distance(&other, [&here, &placed(1.4, 0.2, 0.0)]) + 0.1).abs() < 1e-9);
    // A line 0.5 m over the top and one past an edge, √2 · 1 m away.
    let line = |x: f64, z: f64| [DVec3::new(x, -9.0, z), DVec3::new(x, 9.0, z)];
    assert!((one.apart_from_line(&here, line(0.3, 1.5)).distance - 0.5).abs() < 1e-12);
    assert!((one.apart_from_line(&here, line(2.0, 2.0)).distance - 2.0_f64.sqrt()).abs() < 1e-12);

    // The points that are nearest: of each shape one, as far apart as the distance says.
    let near = one.apart(&other, [&here, &placed(2.5, 2.5, 2.5)]);
    let corners = [DVec3::ONE, DVec3::splat(2.0)];
    assert!(
        near.points.iter().zip(corners).all(|(point, corner)| (*point - corner).length() < 1e-9),
        "{near:?}"
    );
    let near = one.apart_from_line(&here, line(0.3, 1.5));
    assert!((near.points[1] - near.points[0] - DVec3::new(0.0, 0.0, 0.5)).length() < 1e-9, "{near:?}");
    // Into one another along x: both points on the two skins there, a tenth of a metre apart.
    let near = one.apart(&other, [&here, &placed(1.4, 0.2, 0.0)]);
    let depth = (near.points[0] - near.points[1]).dot(DVec3::X);
    assert!((depth - 0.1).abs() < 1e-6 && (near.distance + 0.1).abs() < 1e-9, "{near:?}");
}

/// A box of `size` and 1000 kg at `position` on a slab whose top is level 0, with velocity `velocity`.
fn on_a_slab(size: [f64; 3], position: [f64; 3], velocity: [f64; 3], friction: f64) -> String {
    let [x, y, z] = size.map(|side| side * side * 1000.0 / 12.0);
    serde_json::json!({
        "gravity": [0.0, 0.0, -9.81],
        "bodies": [{"name": "box", "parent": null, "mass": 1000.0, "centre_of_gravity": [0, 0, 0],
            "inertia": [y + z, x + z, x + y, 0, 0, 0],
            "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
            "joint": {"type": "free", "position": position, "orientation": [1, 0, 0, 0],
                "velocity": velocity, "angular_velocity": [0, 0, 0]}}],
        "shapes": [
            {"name": "box", "body": "box", "parts": [{"type": "box", "size": size}]},
            {"name": "slab", "body": null, "parts": [{"type": "box", "size": [400, 400, 20], "centre": [0, 0, -10]}]}],
        "pairs": [{"name": "slab", "group": "box", "shapes": ["box", "slab"],
            "stiffness": 1e8, "damping_time": 0.01, "friction": friction}]})
    .to_string()
}

fn run(document: &str, integrator: serde_json::Value, duration: f64) -> Simulation {
    let settings = serde_json::json!({"integrator": integrator, "duration": duration, "sample_interval": duration / 50.0});
    let mut simulation = Simulation::new(document, &settings.to_string()).unwrap();
    while !simulation.reached(duration) {
        simulation.step().unwrap();
    }
    simulation
}

fn methods() -> [serde_json::Value; 2] {
    [serde_json::json!({"type": "adaptive"}), serde_json::json!({"type": "del", "step": 1e-3})]
}

#[test]
fn a_braked_box_slides_by_its_kinetic_energy_over_friction() {
    let (speed, friction) = (2.0, 0.4);
    // v²/(2μg), where the tangential springs take part with their deflection at the bound, μN/k = 0.01 mm.
    let exact = speed * speed / (2.0 * friction * 9.81);
    let depth = 1000.0 * 9.81 / 4.0 / 1e8;
    for (method, step) in methods().into_iter().zip([0.0, 1e-3]) {
        // A fixed step takes the velocity at its end all along: it comes v h/2 short.
        let expected = exact - 0.5 * speed * step;
        let document = on_a_slab([4.0, 2.0, 0.5], [0.0, 0.0, 0.25 - depth], [speed, 0.0, 0.0], friction);
        let simulation = run(&document, method.clone(), 2.0);
        let travel = simulation.state().q[0];
        assert!((travel - expected).abs() < 1e-4 * expected, "{method}: {travel} {expected}");
        let remainder = simulation.state().ledger.relative_remainder();
        assert!(remainder < 1e-5, "{method}: {remainder}");
        // It stays there.
        assert!(simulation.state().v.iter().all(|v| v.abs() < 1e-6), "{method}: {:?}", simulation.state().v);
    }
}

#[test]
fn a_box_at_rest_neither_sinks_nor_drifts_within_an_hour() {
    let depth = 1000.0 * 9.81 / 4.0 / 1e8;
    let document = on_a_slab([4.0, 2.0, 3.0], [0.0, 0.0, 1.5 - depth], [0.0; 3], 0.4);
    let simulation = run(&document, serde_json::json!({"type": "adaptive"}), 3600.0);
    let q = &simulation.state().q;
    for (found, start) in q.iter().zip([0.0, 0.0, 1.5 - depth]) {
        assert!((found - start).abs() < 1e-12, "{q:?}");
    }
    let total: f64 = simulation.state().tension.iter().step_by(3).sum();
    assert!((total / 9810.0 - 1.0).abs() < 1e-9, "{total}");
}

#[test]
fn a_box_in_a_narrow_pit_does_not_go_through_a_wall() {
    // Eight places: its four lower corners press on the floor, and walls 0.05 m off its ends have eight corners near.
    let depth = 1000.0 * 9.81 / 4.0 / 1e8;
    let (speed, clear) = (0.25, 0.15);
    let wall =
        |size: [f64; 3], centre: [f64; 3]| serde_json::json!({"type": "box", "size": size, "centre": centre});
    let aside = |end: f64| wall([10.0, 1.0, 20.0], [0.0, end * (1.0 + clear + 0.5), 0.0]);
    let ahead = |end: f64| wall([1.0, 10.0, 20.0], [end * (2.0 + 0.05 + 0.5), 0.0, 0.0]);
    for (method, duration) in methods().into_iter().flat_map(|method| [(method.clone(), 0.8), (method, 2.0)])
    {
        let mut document: serde_json::Value = serde_json::from_str(&on_a_slab(
            [4.0, 2.0, 3.0],
            [0.0, 0.0, 1.5 - depth],
            [0.0, speed, 0.0],
            0.0,
        ))
        .unwrap();
        let parts = document["shapes"][1]["parts"].as_array_mut().unwrap();
        parts.extend([aside(1.0), aside(-1.0), ahead(1.0), ahead(-1.0)]);
        let simulation = run(&document.to_string(), method.clone(), duration);
        // m v²/2 = k d²/2, if one corner had to stop it all.
        let farthest = clear + speed * (1000.0_f64 / 1e8).sqrt();
        let y = simulation.state().q[1];
        assert!(y.abs() < farthest, "{method} after {duration} s: {y}");
    }
}

/// A cylinder of 1000 kg, 1 m in radius and 4 m long, whose axis along y is `height` above a plane on which it lies with its two rims; it
/// turns about that axis by `spin` [rad/s], and its centre of gravity is `below` the axis.
fn on_its_rims(gravity: [f64; 3], height: f64, spin: f64, below: f64, friction: f64) -> String {
    // About the axis m r²/2, of which the centre of gravity takes none: the same body with its mass spread otherwise.
    let rim = |end: f64| {
        serde_json::json!({"name": format!("rim{end}"), "group": "log", "body": "log", "at": [0, end, below], "axis": [0, 1, 0],
            "radius": 1.0, "plane_point": [0, 0, 0], "plane_normal": [0, 0, 1], "stiffness": 1e8, "damping_time": 0.01,
            "friction": friction})
    };
    serde_json::json!({
        "gravity": gravity,
        "bodies": [{"name": "log", "parent": null, "mass": 1000.0, "centre_of_gravity": [0, 0, 0],
            "inertia": [1600.0, 500.0, 1600.0, 0, 0, 0],
            "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
            "joint": {"type": "free", "position": [0, 0, height - below], "orientation": [1, 0, 0, 0],
                "velocity": [spin * (1.0 - below), 0, 0], "angular_velocity": [0, spin, 0]}}],
        "rims": [rim(-2.0), rim(2.0)]})
    .to_string()
}

/// How deep each of two rims of that log is pressed in at rest [m].
const DEPTH: f64 = 1000.0 * 9.81 / 2.0 / 1e8;

#[test]
fn a_cylinder_rolls_down_a_slope_with_two_thirds_of_gravity() {
    // Gravity leans: g sin θ/(1 + I/m r²) with I = m r²/2, where friction holds, tan θ < 3 μ.
    let angle = 5.0_f64.to_radians();
    let gravity = [9.81 * angle.sin(), 0.0, -9.81 * angle.cos()];
    let expected = 0.5 * 9.81 * angle.sin() / 1.5 * 16.0;
    for (method, close) in methods().into_iter().zip([1e-4, 1e-3]) {
        let document = on_its_rims(gravity, 1.0 - DEPTH * angle.cos(), 0.0, 0.0, 0.3);
        let simulation = run(&document, method.clone(), 4.0);
        // Of the order of the rolling creep θ²/6 with 0.02 rad in a step, 7e-5, and half a step of 1 ms in 4 s of `del`.
        let travel = simulation.state().q[0];
        assert!((travel / expected - 1.0).abs() < close, "{method}: {travel} {expected}");
        assert!(simulation.state().q[1].abs() < 1e-9, "{method}: {:?}", simulation.state().q);
        let remainder = simulation.state().ledger.relative_remainder();
        assert!(remainder < 1e-4, "{method}: {remainder}");
    }
}

#[test]
fn a_cylinder_with_its_centre_below_its_axis_swings_as_it_rolls() {
    // About the line it lies on: ω² = m g e/(I + m (r − e)²), small swings.
    let below: f64 = 0.3;
    let period = std::f64::consts::TAU * ((500.0 + 1000.0 * 0.49) / (1000.0 * 9.81 * below)).sqrt();
    let document = on_its_rims([0.0, 0.0, -9.81], 1.0 - DEPTH, 0.02, below, 0.5);
    let simulation = run(&document, serde_json::json!({"type": "adaptive"}), 10.0 * period);
    let State { q, v, .. } = simulation.state();
    // After ten periods it turns as it did; a phase of 0.02 is 3e-4 of ten periods, a hundred times the swing's own (0.02/ω)²/16.
    let (turn, rate) = (2.0 * q[5] * std::f64::consts::TAU / period, v[4]);
    assert!((turn.atan2(rate)).abs() < 0.02, "{q:?} {v:?}");
    assert!((turn.hypot(rate) / 0.02 - 1.0).abs() < 0.01, "{q:?} {v:?}");
}

#[test]
fn a_box_on_a_slope_tips_where_its_centre_of_gravity_leaves_its_base() {
    // Gravity leans instead of the slab: tan θ = b/h, with b = 1 m wide and h = 2 m high, at 26.57°. Stiff springs
    // tilt it by half of 1 mrad beforehand.
    for (share, falls) in [(0.99, false), (1.01, true)] {
        let angle = share * f64::atan(0.5);
        let mut document: serde_json::Value =
            serde_json::from_str(&on_a_slab([1.0, 1.0, 2.0], [0.0, 0.0, 1.0], [0.0; 3], 0.9)).unwrap();
        document["gravity"] = serde_json::json!([9.81 * angle.sin(), 0.0, -9.81 * angle.cos()]);
        document["pairs"][0]["stiffness"] = 1e9.into();
        let simulation = run(&document.to_string(), serde_json::json!({"type": "adaptive"}), 10.0);
        let turn = DQuat::from_slice(&simulation.state().q[3..7]);
        let lean = DMat3::from_quat(DQuat::from_xyzw(turn.y, turn.z, turn.w, turn.x)).z_axis.z.acos();
        assert_eq!(lean > 0.5, falls, "leans {lean} at {share}");
    }
}
