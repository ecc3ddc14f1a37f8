//! Kinematics, mass matrix, bias and gradients against differences and first principles.

use super::rigs::{self, Passage, built, cases, moved, seeds};
use gantline_core::constraint::{Constraint, Law, Placed};
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System;
use gantline_core::tree::bias::NewtonEuler;
use gantline_core::tree::drift;
use gantline_core::tree::kinematics::Twist;
use gantline_core::tree::tangent::{DynamicsTangent, Paired};
use glam::DVec3;
use proptest::prelude::*;

/// Central differences with d = 1e-5: rounding 1e-16/d ≈ 1e-11 times lengths of about 10, and d² times
/// third derivatives of at most about 100: both below 1e-7.
const STEP: f64 = 1e-5;
const CLOSE: f64 = 1e-7;

fn twists(system: &System, frame: &Frame, v: &[f64]) -> Vec<Twist> {
    let mut twists = vec![Twist::default(); system.tree.bodies.len()];
    frame.kinematics.twists(&system.tree, v, &mut twists);
    twists
}

/// Linear and angular momentum (about the centre of gravity) of every body.
fn momenta(system: &System, frame: &Frame, v: &[f64]) -> Vec<(DVec3, DVec3)> {
    let twists = twists(system, frame, v);
    let each = system.tree.bodies.iter().enumerate().map(|(index, body)| {
        let centre = frame.kinematics.centre_of_gravity[index];
        let velocity = frame.kinematics.point_velocity(&twists, Some(index), centre);
        let turn = frame.kinematics.pose[index].rotation;
        (velocity * body.mass, turn * body.inertia * turn.transpose() * twists[index].angular)
    });
    each.collect()
}

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn gradient_of_every_constraint_equals_differences(seeds in seeds()) {
        let (system, state, frame) = built(&seeds);
        for dof in 0..system.tree.velocities {
            let mut direction = vec![0.0; system.tree.velocities];
            direction[dof] = 1.0;
            let (_, after) = moved(&system, &state, &direction, STEP);
            let (_, before) = moved(&system, &state, &direction, -STEP);
            // The other laws have rows that are rates, and no functions of the place.
            let is_of_place = |row: &usize| matches!(system.rows.laws[*row], Law::Unilateral { .. });
            for row in (0..system.rows.count()).filter(is_of_place) {
                let difference = (after.value[row] - before.value[row]) / (2.0 * STEP);
                let exact = system.rows.rate(&frame.gradient, row, &direction);
                prop_assert!((difference - exact).abs() < CLOSE, "row {row} dof {dof}: {difference} {exact}");
            }
        }
    }

    #[test]
    fn tangential_rows_measure_the_velocity_along_the_plane(seeds in seeds()) {
        let (system, state, frame) = built(&seeds);
        let first = system.rows.first[system.rope_count];
        let gantline_core::constraint::AnyConstraint::Contact(contact) = &system.constraints[system.rope_count] else {
            panic!("contacts stand after ropes")
        };
        let [with_point, with_plane] = contact.facing.bodies;
        let point = frame.kinematics.point(with_point, contact.spot.point);
        let twists = twists(&system, &frame, &state.v);
        let [own, other] = [with_point, with_plane].map(|body| frame.kinematics.point_velocity(&twists, body, point));
        let velocity = own - other;
        for (k, tangent) in contact.tangents(&frame.kinematics).iter().enumerate() {
            let rate = system.rows.rate(&frame.gradient, first + 1 + k, &state.v);
            prop_assert!((rate - tangent.dot(velocity)).abs() < 1e-12 * (1.0 + velocity.length()));
        }
    }

    #[test]
    fn mass_matrix_gives_the_kinetic_energy(seeds in seeds()) {
        let (system, state, frame) = built(&seeds);
        let direct: f64 = momenta(&system, &frame, &state.v).iter().zip(&system.tree.bodies).zip(twists(&system, &frame, &state.v))
            .filter(|((_, body), _)| body.mass > 0.0)
            .map(|((momentum, body), twist)| 0.5 * (momentum.0.length_squared() / body.mass + momentum.1.dot(twist.angular)))
            .sum();
        let turning = system.flows.iter().map(|&dof| 0.5 * system.tree.armature[dof] * state.v[dof] * state.v[dof]);
        let direct = direct + turning.sum::<f64>();
        let by_matrix = 0.5 * frame.mass.quadratic(&state.v);
        prop_assert!((direct - by_matrix).abs() < 1e-12 * direct.max(1.0));
        let mut product = vec![0.0; state.v.len()];
        frame.mass.multiply(&state.v, &mut product);
        let by_product: f64 = 0.5 * product.iter().zip(&state.v).map(|(a, b)| a * b).sum::<f64>();
        prop_assert!((direct - by_product).abs() < 1e-12 * direct.max(1.0));
    }

    /// What drifting bodies do to the kinetic energy, their joints' velocities held, against its differences.
    #[test]
    fn power_of_drift_equals_differences_of_the_kinetic_energy(seeds in seeds()) {
        let (system, state, frame) = built(&seeds);
        let way: Vec<f64> = (0..system.tree.velocities).map(|k| seeds[(5 * k + 2) % seeds.len()]).collect();
        let energy = |scale: f64| 0.5 * moved(&system, &state, &way, scale).1.mass.quadratic(&state.v);
        let expected = (energy(STEP) - energy(-STEP)) / (2.0 * STEP);
        let both = [&state.v, &way].map(|rates| twists(&system, &frame, rates));
        let mut changes = vec![Twist::default(); system.tree.bodies.len()];
        let found = drift::power(&system.tree, &frame.kinematics, (&both[0], &both[1]), &mut changes);
        // Rounding 1e-16/STEP of the energy, and STEP² of its third derivative.
        prop_assert!((found - expected).abs() < 1e-7 * energy(0.0).max(1.0), "{found} {expected}");
    }

    /// Inverse dynamics against Newton and Euler for each body: rates of momentum by differences along a
    /// path with the given velocity and acceleration, projected on the columns.
    #[test]
    fn inverse_dynamics_equals_rates_of_momentum(seeds in seeds()) {
        let (system, state, frame) = built(&seeds);
        let size = system.tree.velocities;
        let rate: Vec<f64> = (0..size).map(|k| seeds[(7 * k + 3) % seeds.len()]).collect();
        let along = |time: f64| {
            let path: Vec<f64> = (0..size).map(|k| state.v[k] * time + 0.5 * rate[k] * time * time).collect();
            let v: Vec<f64> = (0..size).map(|k| state.v[k] + rate[k] * time).collect();
            let (_, frame) = moved(&system, &state, &path, 1.0);
            momenta(&system, &frame, &v)
        };
        let (after, before) = (along(STEP), along(-STEP));
        let mut expected = vec![0.0; size];
        let mut scale = 1.0_f64;
        for (index, body) in system.tree.bodies.iter().enumerate() {
            let force = (after[index].0 - before[index].0) / (2.0 * STEP) - body.mass * system.tree.gravity;
            let couple = (after[index].1 - before[index].1) / (2.0 * STEP);
            scale = scale.max(force.length()).max(couple.length());
            for &dof in &system.tree.support[index] {
                let centre = frame.kinematics.centre_of_gravity[index];
                let linear = frame.kinematics.point_column(&system.tree, dof, centre);
                expected[dof] += linear.dot(force) + frame.kinematics.columns[dof].angular.dot(couple);
            }
        }
        let mut found = vec![0.0; size];
        let mut dynamics = NewtonEuler::new(&system.tree);
        dynamics.update(&system.tree, &frame.kinematics, &state.v, Some(&rate), None, &mut found);
        for dof in 0..size {
            prop_assert!((found[dof] - expected[dof]).abs() < 1e-6 * scale, "dof {dof}: {} {}", found[dof], expected[dof]);
        }
    }

    /// K of a part is Tᐧ∂²ℓ/∂x² seen through the velocities of its ends: for ends that move on straight
    /// lines (a tree of sliders and points) it must equal the second difference of the length.
    #[test]
    fn geometric_stiffness_is_the_curvature_of_the_length(ends in prop::collection::vec(-5.0..5.0_f64, 6), way in prop::collection::vec(-1.0..1.0_f64, 6)) {
        let (a, b) = (DVec3::from_slice(&ends), DVec3::from_slice(&ends[3..]));
        prop_assume!((b - a).length() > 1.0);
        let point = |name: &str, at: DVec3| serde_json::json!({
            "name": name, "parent": null, "mass": 1.0, "centre_of_gravity": [0, 0, 0], "inertia": [0, 0, 0, 0, 0, 0],
            "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
            "joint": {"type": "point", "position": at.to_array(), "velocity": [0, 0, 0]}});
        let spec = serde_json::json!({"gravity": [0, 0, 0], "bodies": [point("a", a), point("b", b)], "ropes": [{
            "name": "r", "length": 1.0, "material": {"type": "elastic", "axial_stiffness": 1.0},
            "route": [{"type": "end", "body": "a", "at": [0, 0, 0]}, {"type": "end", "body": "b", "at": [0, 0, 0]}]}]});
        let spec = serde_json::from_value(spec).unwrap();
        let (system, state) = gantline_core::build::build(&spec).unwrap();
        let mut frame = Frame::new(&system);
        frame.update(&system, &state);
        let mut columns = [DVec3::ZERO; 6];
        let tension = 7.0;
        let rope = system.ropes().next().unwrap();
        let (at, mut turns) = ((&frame.kinematics, state.seats.as_slice()), 0);
        let factor = rope.geometric_stiffness(at, tension, 0, &mut columns, |_, _| turns += 1);
        prop_assert_eq!(turns, 0, "nothing turns here");
        let dofs = &system.constraints[0].curvature_groups()[0].1;
        let across: DVec3 = dofs.iter().zip(&columns).map(|(&dof, column)| *column * way[dof]).sum();
        let length = |scale: f64| moved(&system, &state, &way, scale).1.value[0];
        // d = 1e-4: rounding 1e-15/d² = 1e-7; d² times fourth derivatives, of order 1 for ℓ > 1.
        let d = 1e-4;
        let curvature = tension * (length(d) - 2.0 * length(0.0) + length(-d)) / (d * d);
        prop_assert!((factor * across.length_squared() - curvature).abs() < 1e-5);
    }

    /// With what tension does to joints that turn it is the second difference of the length where ends move on circles too:
    /// of a rope from the world to the end of two arms, one hinged to the other about the same direction.
    #[test]
    fn ends_that_turn_have_the_rest_of_the_curvature(
        angles in prop::collection::vec(-3.0..3.0_f64, 2),
        arms in prop::collection::vec(-2.0..2.0_f64, 6),
        way in prop::collection::vec(-1.0..1.0_f64, 2),
    ) {
        let arm = |name: &str, parent: Option<&str>, at: &[f64], angle: f64| serde_json::json!({
            "name": name, "parent": parent, "mass": 1.0, "centre_of_gravity": [0, 0, 0], "inertia": [1, 1, 1, 0, 0, 0],
            "placement": {"position": at, "orientation": [1, 0, 0, 0]},
            "joint": {"type": "hinge", "axis": [0, 1, 0], "position": angle}});
        let spec = serde_json::json!({"gravity": [0, 0, 0],
            "bodies": [arm("a", None, &[0.0, 0.0, 0.0], angles[0]), arm("b", Some("a"), &arms[..3], angles[1])],
            "ropes": [{"name": "r", "length": 1.0, "material": {"type": "elastic", "axial_stiffness": 1.0},
                "route": [{"type": "end", "at": [0, 9, 0]}, {"type": "end", "body": "b", "at": &arms[3..]}]}]});
        let (system, state) = gantline_core::build::build(&serde_json::from_value(spec).unwrap()).unwrap();
        let mut frame = Frame::new(&system);
        frame.update(&system, &state);
        let (mut columns, tension, rope) = ([DVec3::ZERO; 2], 7.0, system.ropes().next().unwrap());
        let (at, mut found) = ((&frame.kinematics, state.seats.as_slice()), 0.0);
        let factor = rope.geometric_stiffness(at, tension, 0, &mut columns, |body, resistance| {
            // Both joints turn the lower arm.
            let turn: f64 = way[..=body].iter().sum();
            found += turn * turn * (resistance * DVec3::Y).y;
        });
        let dofs = &system.constraints[0].curvature_groups()[0].1;
        found += factor * dofs.iter().zip(&columns).map(|(&dof, column)| *column * way[dof]).sum::<DVec3>().length_squared();
        let length = |scale: f64| moved(&system, &state, &way, scale).1.value[0];
        // Lengths of up to 15 m are rounded by 2e-15 each: 7 N times four of that over d² is 6e-6.
        let d = 1e-4;
        let curvature = tension * (length(d) - 2.0 * length(0.0) + length(-d)) / (d * d);
        prop_assert!((found - curvature).abs() < 2e-5, "{found} for {curvature}");
    }
}

#[test]
fn steiner_term_of_a_rod_swung_about_its_end() {
    // A rod of mass m and length l about its end: m l²/3.
    let (mass, length) = (3.0, 2.0);
    let about_centre = mass * length * length / 12.0;
    let spec = serde_json::json!({"gravity": [0, 0, -9.81], "bodies": [{
        "name": "rod", "parent": null, "mass": mass, "centre_of_gravity": [0, 0, -length / 2.0],
        "inertia": [about_centre, about_centre, 0, 0, 0, 0],
        "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
        "joint": {"type": "hinge", "axis": [0, 1, 0], "position": 0.4}}]});
    let (system, state) = gantline_core::build::build(&serde_json::from_value(spec).unwrap()).unwrap();
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    assert!((frame.mass.diagonal(0) - mass * length * length / 3.0).abs() < 1e-12);
}

proptest! {
    #![proptest_config(cases(200))]

    /// ∂G/∂q of ropes and contacts against central differences of the gradient.
    #[test]
    fn curvature_equals_differences_of_the_gradient(seeds in seeds()) {
        let (system, state, frame) = built(&seeds);
        for (index, constraint) in system.constraints.iter().enumerate() {
            let mut sums = vec![vec![0.0; system.tree.velocities]; system.rows.dofs.len()];
            for (group, (row, dofs)) in constraint.curvature_groups().into_iter().enumerate() {
                let mut block = vec![0.0; dofs.len() * dofs.len()];
                let mut columns = vec![DVec3::ZERO; dofs.len()];
                let row = system.rows.first[index] + row;
                let at = Placed { tree: &system.tree, kinematics: &frame.kinematics, q: &state.q, seats: &state.seats, spots: &state.spots, feeding: &frame.feeding };
                constraint.curvature(&at, frame.value[row], group, &mut columns, &mut block);
                let range = system.rows.start[row]..system.rows.start[row + 1];
                for (j, &dof) in dofs.iter().enumerate() {
                    let entry = range.start + system.rows.dofs[range.clone()].iter().position(|&d| d == dof).unwrap();
                    for (k, &other) in dofs.iter().enumerate() {
                        sums[entry][other] += block[j * dofs.len() + k];
                    }
                }
            }
            let range = system.rows.start[system.rows.first[index]]..system.rows.start[system.rows.first[index + 1]];
            // Differences of n·J: short parts bend strongly (1/ℓ), so only parts of at least 0.5 m are compared.
            if let gantline_core::constraint::AnyConstraint::Rope(rope) = constraint
                && rope.straights(&frame.kinematics).any(|part| part.length < 0.5)
            {
                continue;
            }
            for dof in 0..system.tree.velocities {
                let mut direction = vec![0.0; system.tree.velocities];
                direction[dof] = 1.0;
                let (_, after) = moved(&system, &state, &direction, STEP);
                let (_, before) = moved(&system, &state, &direction, -STEP);
                for entry in range.clone() {
                    let difference = (after.gradient[entry] - before.gradient[entry]) / (2.0 * STEP);
                    prop_assert!((difference - sums[entry][dof]).abs() < 1e-6, "entry {entry} dof {dof}: {difference} {}", sums[entry][dof]);
                }
            }
        }
    }
}

fn passages() -> impl Strategy<Value = Passage> {
    prop_oneof![Just(Passage::Seated), Just(Passage::LiftsOff), Just(Passage::Feeds)]
}

fn inverse_dynamics(system: &System, frame: &Frame, v: &[f64], rate: &[f64]) -> (NewtonEuler, Vec<f64>) {
    let mut dynamics = NewtonEuler::new(&system.tree);
    let mut out = vec![0.0; v.len()];
    dynamics.update(&system.tree, &frame.kinematics, v, Some(rate), None, &mut out);
    (dynamics, out)
}

proptest! {
    #![proptest_config(cases(200))]

    /// ∂τ/∂q and ∂τ/∂v against central differences, on trees with every joint type.
    #[test]
    fn tangent_of_inverse_dynamics_equals_differences(seeds in seeds()) {
        let (system, state, frame) = built(&seeds);
        let size = system.tree.velocities;
        let rate: Vec<f64> = (0..size).map(|k| seeds[(7 * k + 3) % seeds.len()]).collect();
        let (dynamics, value) = inverse_dynamics(&system, &frame, &state.v, &rate);
        let mut tangent = DynamicsTangent::new(&system.tree, &frame.mass);
        tangent.update(&system.tree, &frame.kinematics, &frame.mass, &dynamics, &state.v);
        let scale = value.iter().fold(100.0_f64, |most, x| most.max(x.abs()));
        let entry = |paired: &Paired, row: usize, column: usize| {
            let (low, high) = (row.min(column), row.max(column));
            let slot = frame.mass.slot(high, low);
            let related = frame.mass.columns[frame.mass.row_start[high]..frame.mass.row_start[high + 1]].contains(&low);
            match (related, row >= column) {
                (false, _) => 0.0,
                (true, true) => paired.lower[slot],
                (true, false) => paired.upper[slot],
            }
        };
        for column in 0..size {
            let mut direction = vec![0.0; size];
            direction[column] = 1.0;
            let at = |scale: f64| inverse_dynamics(&system, &moved(&system, &state, &direction, scale).1, &state.v, &rate).1;
            let (after, before) = (at(STEP), at(-STEP));
            let with = |scale: f64| {
                let v: Vec<f64> = state.v.iter().zip(&direction).map(|(v, d)| v + scale * d).collect();
                inverse_dynamics(&system, &frame, &v, &rate).1
            };
            let (faster, slower) = (with(STEP), with(-STEP));
            for row in 0..size {
                let difference = (after[row] - before[row]) / (2.0 * STEP);
                let exact = entry(&tangent.position, row, column);
                prop_assert!((difference - exact).abs() < 1e-7 * scale, "q: row {row} column {column}: {difference} {exact}");
                let difference = (faster[row] - slower[row]) / (2.0 * STEP);
                let exact = entry(&tangent.velocity, row, column);
                prop_assert!((difference - exact).abs() < 1e-7 * scale, "v: row {row} column {column}: {difference} {exact}");
            }
        }
    }
}

proptest! {
    #![proptest_config(cases(500))]

    /// A rope over real sheaves in space and through an eye: gradient against differences of its length, curvature
    /// against differences of its gradient, on trees with every joint type, whichever way it passes the sheaves.
    #[test]
    fn ropes_over_sheaves_have_exact_derivatives(seeds in seeds(), passage in passages()) {
        let Some((system, state, frame)) = rigs::sheave_rig(&seeds, passage) else { return Ok(()) };
        let rope = system.ropes().next().unwrap();
        // Grazing tangents and short parts turn too fast for differences.
        let is_lifted = |guide: usize| rope.route.guides[guide].is_lifted(&state.seats);
        let touched: Vec<usize> = (0..rope.route.guides.len()).filter(|&guide| !is_lifted(guide)).collect();
        for pair in touched.windows(2) {
            let part = rope.route.between(pair[0], pair[1]);
            let straight = part.locate(&frame.kinematics);
            prop_assume!(straight.length > 1.0);
            for (k, anchor) in [part.from, part.to].into_iter().enumerate() {
                if let Some((axis, _)) = anchor.sheave {
                    let axis = frame.kinematics.turn(anchor.at.body, axis);
                    prop_assume!(straight.direction.dot(axis.cross(straight.radial[k])) > 0.3);
                }
            }
        }
        let mut blocks = vec![vec![0.0; system.tree.velocities]; system.rows.dofs.len()];
        let rows = rope.spans.len();
        for (group, (row, dofs)) in rope.curvature_groups().into_iter().enumerate() {
            let mut block = vec![0.0; dofs.len() * dofs.len()];
            let mut columns = vec![DVec3::ZERO; dofs.len()];
            let at = Placed { tree: &system.tree, kinematics: &frame.kinematics, q: &state.q, seats: &state.seats, spots: &state.spots, feeding: &frame.feeding };
            rope.curvature(&at, frame.value[row], group, &mut columns, &mut block);
            let range = system.rows.start[row]..system.rows.start[row + 1];
            for (j, dof) in dofs.iter().enumerate() {
                let entry = range.start + system.rows.dofs[range.clone()].iter().position(|d| d == dof).unwrap();
                for (k, &other) in dofs.iter().enumerate() {
                    blocks[entry][other] += block[j * dofs.len() + k];
                }
            }
        }
        for dof in 0..system.tree.velocities {
            let mut direction = vec![0.0; system.tree.velocities];
            direction[dof] = 1.0;
            // Tangents that nearly graze have third derivatives of 1e4 and more, so differences of fourth order.
            let [far, near, ahead, away] =
                [-2.0, -1.0, 1.0, 2.0].map(|share| moved(&system, &state, &direction, share * STEP).1);
            let derivative = |of: &dyn Fn(&Frame) -> f64| {
                (8.0 * (of(&ahead) - of(&near)) - (of(&away) - of(&far))) / (12.0 * STEP)
            };
            for row in 0..rows {
                let difference = derivative(&|frame| frame.value[row]);
                let exact = system.rows.rate(&frame.gradient, row, &direction);
                prop_assert!((difference - exact).abs() < CLOSE, "row {row} dof {dof}: {difference} {exact}");
            }
            for entry in 0..system.rows.start[rows] {
                let difference = derivative(&|frame| frame.gradient[entry]);
                let exact = blocks[entry][dof];
                prop_assert!((difference - exact).abs() < 1e-5, "entry {entry} dof {dof}: {difference} {exact}");
            }
        }
    }
}
