//! Forces of water, wind and waves and of mooring lines on random trees: against energies, rates of momentum, and differences.

use super::rigs::wet::{CLOSE, GROWN, NOW, STEP, inverse, rates, wet};
use super::rigs::{self, cases, moved, seeds};
use gantline_core::audit::gravity_energy;
use gantline_core::build::build;
use gantline_core::force::drag::Drag;
use gantline_core::force::slow::{Slow, Slowly};
use gantline_core::force::{self, AnyForce, At, Energies, Force, twist_of};
use gantline_core::state::State;
use gantline_core::stepper::frame::Frame;
use gantline_core::tree::kinematics::Twist;
use gantline_core::tree::pose::Pose;
use gantline_core::tree::tangent::{DynamicsTangent, Paired};
use glam::{DMat3, DVec2, DVec3};
use proptest::prelude::*;

fn entry(paired: &Paired, frame: &Frame, row: usize, column: usize) -> f64 {
    let (low, high, values) =
        if row >= column { (column, row, &paired.lower) } else { (row, column, &paired.upper) };
    let range = frame.mass.row_start[high]..frame.mass.row_start[high + 1];
    let found = range.into_iter().find(|&slot| frame.mass.columns[slot] == low);
    found.map_or(0.0, |slot| values[slot])
}

/// Steps of differences. Slopes have kinks: |ν| ν of a rotation at rest, a section where a corner meets the water, cells where
/// they begin to get wet; none lies within all of these.
const STEPS: [f64; 3] = [STEP, 0.1 * STEP, 0.01 * STEP];

/// Central differences of several steps.
#[derive(Default)]
struct Closest(Vec<Vec<f64>>);

impl Closest {
    fn add(&mut self, after: &[f64], before: &[f64], step: f64) {
        self.0
            .push(after.iter().zip(before).map(|(after, before)| (after - before) / (2.0 * step)).collect());
    }

    /// The one of an entry that is closest to a number.
    fn to(&self, entry: usize, found: f64) -> f64 {
        let off = |difference: &f64| (difference - found).abs();
        let all = self.0.iter().map(|differences| differences[entry]);
        all.min_by(|one, other| off(one).total_cmp(&off(other))).expect("there are differences")
    }
}

/// Tangents of inverse dynamics under some accelerations against differences, in frames made as they have to be.
fn follow_differences(seeds: &[f64], make: impl Fn(&mut Frame)) -> Result<(), TestCaseError> {
    let (system, state, mut frame) = wet(seeds);
    make(&mut frame);
    let size = system.tree.velocities;
    let a = rates(&system, seeds);
    let (dynamics, here) = inverse(&system, &frame, &state.v, &a);
    let mut tangent = DynamicsTangent::new(&system.tree, &frame.mass);
    tangent.update(&system.tree, &frame.kinematics, &frame.mass, &dynamics, &state.v);
    let scale = here.iter().fold(100.0_f64, |most, x| most.max(x.abs()));
    for column in 0..size {
        let mut direction = vec![0.0; size];
        direction[column] = 1.0;
        let at = |step: f64| {
            let (_, mut frame) = moved(&system, &state, &direction, step);
            make(&mut frame);
            inverse(&system, &frame, &state.v, &a).1
        };
        let with = |step: f64| {
            let v: Vec<f64> = state.v.iter().zip(&direction).map(|(v, d)| v + step * d).collect();
            inverse(&system, &frame, &v, &a).1
        };
        let (mut places, mut speeds) = (Closest::default(), Closest::default());
        for step in STEPS {
            places.add(&at(step), &at(-step), step);
            speeds.add(&with(step), &with(-step), step);
        }
        // The row of what a drive prescribes is no equation.
        for row in (0..size).filter(|&row| system.driven[row].is_none()) {
            let found = entry(&tangent.position, &frame, row, column);
            let place = places.to(row, found);
            prop_assert!((place - found).abs() < 1e-6 * scale, "q {row} {column}: {place} {found}");
            let found = entry(&tangent.velocity, &frame, row, column);
            let speed = speeds.to(row, found);
            prop_assert!((speed - found).abs() < 1e-6 * scale, "v {row} {column}: {speed} {found}");
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(cases(100))]

    /// M v̇ holds what is accelerated along: inverse dynamics is linear in the acceleration with the slope M.
    #[test]
    fn added_mass_is_in_the_mass_matrix(seeds in seeds()) {
        let (system, state, frame) = wet(&seeds);
        let a = rates(&system, &seeds);
        let still = vec![0.0; a.len()];
        let (with, without) = (inverse(&system, &frame, &state.v, &a).1, inverse(&system, &frame, &state.v, &still).1);
        let mut product = vec![0.0; a.len()];
        frame.mass.multiply(&a, &mut product);
        for dof in 0..a.len() {
            let turning = system.tree.armature[dof] * a[dof];
            let found = with[dof] - without[dof] + turning;
            prop_assert!((found - product[dof]).abs() < 1e-10 * (1.0 + product[dof].abs() + with[dof].abs()));
        }
    }

    /// The wrench of added mass against rates of the water's momenta along a path, by differences: ṗ, and L̇ + v × p about P.
    #[test]
    fn added_mass_takes_the_rate_of_the_momentum_of_water(seeds in seeds()) {
        let (system, state, frame) = wet(&seeds);
        let size = system.tree.velocities;
        let a = rates(&system, &seeds);
        let (dynamics, _) = inverse(&system, &frame, &state.v, &a);
        let mut energy = 0.0;
        for force in &system.tree.forces {
            let AnyForce::AddedMass(added) = force else { continue };
            let momenta = |time: f64| {
                let path: Vec<f64> = (0..size).map(|k| state.v[k] * time + 0.5 * a[k] * time * time).collect();
                let v: Vec<f64> = (0..size).map(|k| state.v[k] + a[k] * time).collect();
                let (_, frame) = moved(&system, &state, &path, 1.0);
                let twist = twist_of(&system.tree, &frame.kinematics, added.body, &v);
                let turn = frame.kinematics.pose[added.body].rotation;
                let motion = Twist { linear: twist.at(turn * added.at), ..twist };
                (added.matrix.turned(&turn).times(&motion), motion)
            };
            let (after, before, (here, motion)) = (momenta(STEP).0, momenta(-STEP).0, momenta(0.0));
            let rate = (after.force - before.force) / (2.0 * STEP);
            let moment = (after.moment - before.moment) / (2.0 * STEP) + motion.linear.cross(here.force);
            let arm = frame.kinematics.pose[added.body].rotation * added.at;
            let found = added.wrench(&dynamics.at(&system.tree, &frame.kinematics, added.body));
            let scale = 1.0 + rate.length() + moment.length() + here.force.length() + here.moment.length();
            prop_assert!((found.force + rate).length() < CLOSE * scale, "{} {rate}", found.force);
            prop_assert!((found.moment + moment + arm.cross(rate)).length() < CLOSE * scale * 2.0);
            energy += 0.5 * (here.force.dot(motion.linear) + here.moment.dot(motion.angular));
        }
        // And it is what the mass matrix has more than that of the bodies alone.
        let kinetic = |keep: fn(&AnyForce) -> bool| {
            let mut kept = system.clone();
            kept.tree.forces.retain(keep);
            let mut frame = Frame::new(&kept);
            frame.update(&kept, &State { past: Vec::new(), ..state.clone() });
            0.5 * frame.mass.quadratic(&state.v)
        };
        let dry = kinetic(|_| false);
        let added = kinetic(|force| matches!(force, AnyForce::AddedMass(_))) - dry;
        prop_assert!((added - energy).abs() < 1e-9 * (1.0 + dry));
    }

    /// At rest inverse dynamics is the slope of the energy of gravity, displaced water and mooring lines, less what a stream
    /// pushes with, where nothing has moved yet.
    #[test]
    fn buoyancy_is_the_slope_of_its_energy(seeds in seeds()) {
        let (system, state, mut frame) = wet(&seeds);
        frame.kinematics.past.clear();
        let still = vec![0.0; system.tree.velocities];
        let (_, slope) = inverse(&system, &frame, &still, &still);
        let mut pushed = still.clone();
        force::resistance(&system.tree, &frame.kinematics, &still, &mut pushed);
        let energy = |direction: &[f64], step: f64| {
            let (_, frame) = moved(&system, &state, direction, step);
            let Energies { fluid, lines } = force::energy(&system.tree, &frame.kinematics);
            gravity_energy(&system, &frame.kinematics) + fluid + lines
        };
        for dof in 0..still.len() {
            let mut direction = still.clone();
            direction[dof] = 1.0;
            let difference = (energy(&direction, STEP) - energy(&direction, -STEP)) / (2.0 * STEP);
            let held = slope[dof] - pushed[dof];
            prop_assert!((difference - held).abs() < 1e-5 * (10.0 + held.abs()), "{dof}: {difference} {held}");
        }
    }

    /// What a pump gives to a kilogram is how all energy, that of motion too, grows with the content.
    #[test]
    fn pumps_give_lift_and_motion(seeds in seeds()) {
        let (system, state, frame) = wet(&seeds);
        let a = rates(&system, &seeds);
        let (_, found) = inverse(&system, &frame, &state.v, &a);
        let content = system.tree.bodies.iter().find(|body| body.name == "content").unwrap().first_velocity;
        let mut direction = vec![0.0; a.len()];
        direction[content] = 1.0;
        let energy = |step: f64| {
            let (system, frame) = (&system, moved(&system, &state, &direction, step).1);
            let Energies { fluid, lines } = force::energy(&system.tree, &frame.kinematics);
            fluid + lines + 0.5 * frame.mass.quadratic(&state.v)
        };
        // Energies are some 1e4 J, and quadratic in the content but for the tank's dents.
        let step = 1e-3;
        let difference = (energy(step) - energy(-step)) / (2.0 * step);
        prop_assert!((difference - found[content]).abs() < 1e-6 * (10.0 + difference.abs()), "{difference} {}", found[content]);
    }

    /// ∂τ/∂q and ∂τ/∂v with all forces, in motion, against differences.
    #[test]
    fn tangents_equal_differences(seeds in seeds()) {
        follow_differences(&seeds, |_| ())?;
    }

    /// The same where nothing has moved yet, as statics has it: of waves what is settled pushes, by the heading of its body.
    #[test]
    fn tangents_equal_differences_before_anything_moves(seeds in seeds()) {
        follow_differences(&seeds, |frame| frame.kinematics.past.clear())?;
    }

    /// ∂τ/∂t, where waves and gusts alone know time, and how they grow, against differences.
    #[test]
    fn waves_and_gusts_change_with_time(seeds in seeds()) {
        let (system, mut state, frame) = wet(&seeds);
        let a = rates(&system, &seeds);
        let mut drift = vec![0.0; a.len()];
        let (dynamics, _) = inverse(&system, &frame, &state.v, &a);
        force::over_time(&system.tree, &frame.kinematics, &dynamics, &mut drift);
        let mut at = |time: f64| {
            state.time = time;
            let mut frame = Frame::new(&system);
            frame.update(&system, &state);
            inverse(&system, &frame, &state.v, &a).1
        };
        let mut closest = Closest::default();
        for step in STEPS {
            closest.add(&at(NOW + step), &at(NOW - step), step);
        }
        let scale = at(NOW).iter().fold(100.0_f64, |most, x| most.max(x.abs()));
        for (dof, &found) in drift.iter().enumerate() {
            let difference = closest.to(dof, found);
            prop_assert!((difference - found).abs() < CLOSE * scale, "{dof}: {difference} {found}");
        }
        let growth = |time: f64| system.sea.growth(time);
        for time in [0.3, NOW, GROWN - 0.1, GROWN + 1.0] {
            let difference = (growth(time + STEP).0 - growth(time - STEP).0) / (2.0 * STEP);
            prop_assert!((difference - growth(time).1).abs() < CLOSE);
        }
    }

    /// Drag and dampers of lines take power and never give it but what a fluid that streams puts in; it is their force times
    /// the velocity.
    #[test]
    fn drag_takes_power(seeds in seeds()) {
        let (system, state, frame) = wet(&seeds);
        let [mut fluid, mut lines] = [(), ()].map(|()| vec![0.0; state.v.len()]);
        force::resistance(&system.tree, &frame.kinematics, &state.v, &mut fluid);
        force::line_damping(&system.tree, &frame.kinematics, &state.v, &mut lines);
        let power: f64 = fluid.iter().zip(&lines).zip(&state.v).map(|((one, other), v)| (one + other) * v).sum();
        let (dynamics, _) = inverse(&system, &frame, &state.v, &rates(&system, &seeds));
        let at = |force: &AnyForce| dynamics.at(&system.tree, &frame.kinematics, force.body());
        let losses: Vec<f64> = system.tree.forces.iter().map(|force| force.loss(&at(force))).collect();
        let work = force::stream_work(&system.tree, &frame.kinematics, &state.v)
            + force::wave_work(&system.tree, &frame.kinematics, [&state.v, &state.v])
            + force::submerged_work(&system.tree, &frame.kinematics, &state.v);
        let lost: f64 = losses.iter().sum();
        prop_assert!(losses.iter().all(|lost| *lost >= 0.0));
        prop_assert!((lost - work - power).abs() < 1e-10 * (1.0 + power.abs() + work.abs()), "{lost} {work} {power}");
    }

    /// A fluid that streams is the same as one that stands and a world that goes the other way.
    #[test]
    fn only_the_motion_against_the_fluid_counts(seeds in seeds()) {
        let (system, state, frame) = wet(&seeds);
        for force in &system.tree.forces {
            let AnyForce::Drag(drag) = force else { continue };
            let twist = twist_of(&system.tree, &frame.kinematics, drag.body, &state.v);
            let at = |twist| At {
                pose: &frame.kinematics.pose[drag.body],
                twist,
                rate: Twist::default(),
                gravity: DVec3::ZERO,
                time: NOW,
                q: &state.q,
                v: &state.v,
                past: &[],
            };
            let steady = Drag { gusts: None, profile: None, ..drag.clone() };
            let still = Drag { stream: DVec3::ZERO, ..steady.clone() };
            let (one, other) = (steady.wrench(&at(twist)), still.wrench(&at(Twist { linear: twist.linear - drag.stream, ..twist })));
            let scale = 1.0 + one.force.length() + one.moment.length();
            prop_assert!((one.force - other.force).length() < 1e-12 * scale);
            prop_assert!((one.moment - other.moment).length() < 1e-12 * scale);
        }
    }
}

/// A body's weight and buoyancy, force by force, where the numbers are plain: a cube of 2 m half in water.
#[test]
fn a_cube_half_in_water() {
    let cube = rigs::hulls::cuboid([2.0, 2.0, 2.0]);
    let spec = serde_json::json!({"gravity": [0, 0, -10.0], "bodies": [{
        "name": "cube", "parent": null, "mass": 4000.0, "centre_of_gravity": [0, 0, 1.0],
        "inertia": [1000, 1000, 1000, 0, 0, 0], "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
        "joint": {"type": "free", "position": [0, 0, 4.0], "orientation": [1, 0, 0, 0], "velocity": [0, 0, 0],
                  "angular_velocity": [0, 0, 0]}}],
        "forces": [{"type": "buoyancy", "name": "hull", "body": "cube", "density": 1000.0, "level": 5.0,
            "vertices": cube.vertices.iter().map(|v| v.to_array()).collect::<Vec<_>>(), "triangles": cube.triangles}]});
    let (system, state) = build(&serde_json::from_value(spec).unwrap()).unwrap();
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    let still = [0.0; 6];
    let (_, out) = inverse(&system, &frame, &still, &still);
    assert!(out.iter().all(|force| force.abs() < 1e-9), "4 t float half way down: {out:?}");
    let force = &system.tree.forces[0];
    let pose = &frame.kinematics.pose[0];
    let at = At {
        pose,
        twist: Twist::default(),
        rate: Twist::default(),
        gravity: system.tree.gravity,
        time: 0.0,
        q: &state.q,
        v: &still,
        past: &[],
    };
    assert!((force.wrench(&at).force - DVec3::Z * 4e4).length() < 1e-9);
    // ρ g V times the depth of its centre, half a metre.
    assert!((force.energy(pose, system.tree.gravity, &state.q) - 2e4).abs() < 1e-9);
    // ρ g A, and ρ g (I_T + V (z_B − z_o)) about the keel: 4/3 + 4 · 1/2.
    let AnyForce::Buoyancy(buoyancy) = force else { panic!("it is a hull") };
    let derivative = buoyancy.afloat(pose, system.tree.gravity).derivative();
    assert!((derivative.linear.z_axis.z + 4e4).abs() < 1e-9);
    assert!(
        (derivative.angular.x_axis.x + 1e4 * (4.0 / 3.0 + 4.0 * 0.5)).abs() < 1e-6,
        "{}",
        derivative.angular
    );
}

/// The filter of slow places, in steps of any length, against its transfer function: a body that swings about a point that goes
/// along straight, and turns evenly. Its slow place keeps H of the swing, and what goes evenly without a lag.
#[test]
fn slow_places_follow_and_leave_out_waves() {
    let (cut_off, swing, speed, turning) = (0.1, 0.5, 0.7, 0.05);
    let slow = Slow { point: DVec3::new(3.0, 0.0, 1.0), cut_off, first: 2 };
    let mut past = vec![0.0; slow.states().end];
    let motion = |time: f64| {
        let (sin, cos) = (swing * time).sin_cos();
        let rotation = DMat3::from_rotation_z(turning * time);
        // The point, not the origin, goes along.
        let arm = rotation * slow.point;
        let velocity = DVec3::new(speed - swing * sin, swing * cos, 0.0);
        let angular = DVec3::Z * turning;
        let pose = Pose { rotation, position: DVec3::new(speed * time + cos, sin, 0.0) - arm };
        (pose, Twist { angular, linear: velocity - angular.cross(arm) })
    };
    let (pose, twist) = motion(0.0);
    slow.start((&pose, &twist), 0.0, &mut past);
    let mut time = 0.0;
    for step in 0..4000 {
        time += [0.02, 0.3, 0.1, 0.001][step % 4];
        let (pose, twist) = motion(time);
        slow.follow((&pose, &twist), time, &mut past);
    }
    // (1 + 5p)/(1 + p)⁵ with p = 5i: (1 + 25i)/(2876 + 1900i) = (50376 + 70000i)/26⁵. What it began with has gone: 421 s.
    let (real, imaginary) = [50_376.0, 70_000.0].map(|part| part / 11_881_376.0).into();
    let late = time + 0.4;
    let Slowly { place, heading } = slow.at(&past, late).unwrap();
    let (sin, cos) = (swing * late).sin_cos();
    let swung = DVec2::new(real * cos - imaginary * sin, real * sin + imaginary * cos);
    let expected = DVec2::new(speed * late, 0.0) + swung;
    // Steps of 0.3 s: (0.15)⁴/384 = 1e-6 of the swing, of which H leaves 0.7 %; that the swing goes on straight for 0.4 s,
    // 5 · 0.1⁴ · 0.25 · 0.4⁶/720 = 7e-10 m.
    let across = |way: DVec2| swing * DVec2::new(-way.y, way.x);
    let expected = [
        expected,
        DVec2::new(speed, 0.0) + across(swung),
        across(across(swung)),
        across(across(across(swung))),
    ];
    // That of its second rate is 5 · 0.1⁴ · 0.25 · 0.4⁴/24 = 1.3e-7 m/s², and 0.4³/6 of its third 1.3e-6 m/s³.
    let off: [f64; 4] = std::array::from_fn(|k| (place[k] - expected[k]).length());
    assert!(off[0] < 2e-8 && off[1] < 2e-8 && off[2] < 2e-7 && off[3] < 2e-6, "{off:?}");
    // Past whole turns: 21 rad.
    let turned = [turning * late, turning, 0.0, 0.0];
    assert!((0..4).all(|k| (heading[k] - turned[k]).abs() < 1e-9), "{heading:?}");
}

/// Why a cube under these forces is refused, in a sea of so many waves; nothing if it is not.
fn refused_in_waves(waves: usize, forces: &[serde_json::Value]) -> String {
    let component =
        serde_json::json!({"frequency": 0.7, "wave_number": [0.05, 0], "amplitude": 1.0, "phase": 0.0});
    let spec = serde_json::json!({"gravity": [0, 0, -10.0], "bodies": [{
        "name": "cube", "parent": null, "mass": 4000.0, "centre_of_gravity": [0, 0, 1.0],
        "inertia": [1000, 1000, 1000, 0, 0, 0], "placement": {"position": [0, 0, 0], "orientation": [1, 0, 0, 0]},
        "joint": {"type": "free", "position": [0, 0, 4.0], "orientation": [1, 0, 0, 0], "velocity": [0, 0, 0],
                  "angular_velocity": [0, 0, 0]}}],
        "sea": {"components": vec![component; waves], "rise_time": 5.0},
        "forces": forces});
    build(&serde_json::from_value(spec).unwrap()).err().map(|error| error.to_string()).unwrap_or_default()
}

/// A mean drift force needs a force of waves, whose slow heading it has, and to be known at a heading.
#[test]
fn mean_drift_belongs_to_a_force_of_waves() {
    let phasors = vec![vec![[[[1.0, 0.0]; 6]; 4]]];
    let swell = serde_json::json!({"type": "wave", "name": "swell", "body": "cube", "at": [0, 0, 0],
        "origin": [0, 0, 0], "directions": [0.5], "phasors": phasors});
    let drift = |around: &[[[[f64; 4]; 3]; 4]]| serde_json::json!({"type": "mean_drift", "name": "drift", "body": "cube", "at": [0, 0, 0], "around": around});
    let known = [[[[1.0; 4]; 3]; 4]];
    assert_eq!(refused_in_waves(1, &[drift(&known), swell.clone()]), "");
    assert!(refused_in_waves(1, &[drift(&known)]).contains("no waves push `cube`"));
    assert!(refused_in_waves(1, &[swell, drift(&[])]).contains("at no heading"));
}

/// Wave forces that do not belong to their sea, or to no direction, are refused by name.
#[test]
fn wave_forces_belong_to_a_sea_and_to_directions() {
    let phasor = [[[1.0, 0.0]; 6]; 4];
    let drifting = |waves: usize,
                    directions: &[f64],
                    phasors: Vec<Vec<[[[f64; 2]; 6]; 4]>>,
                    drifts: Vec<Vec<[[f64; 3]; 4]>>| {
        let force = serde_json::json!({"type": "wave", "name": "swell", "body": "cube", "at": [0, 0, 0],
            "origin": [0, 0, 0], "directions": directions, "phasors": phasors, "drifts": drifts});
        refused_in_waves(waves, &[force])
    };
    let refused = |waves: usize, directions: &[f64], phasors| drifting(waves, directions, phasors, vec![]);
    assert_eq!(refused(1, &[0.5], vec![vec![phasor]]), "");
    assert!(refused(0, &[0.5], vec![]).contains("there is no sea"));
    assert!(refused(1, &[], vec![vec![]]).contains("waves in no direction"));
    assert!(refused(1, &[0.5, 0.5], vec![vec![phasor; 2]]).contains("do not rise within a turn"));
    assert!(refused(1, &[0.0, 6.4], vec![vec![phasor; 2]]).contains("do not rise within a turn"));
    assert!(refused(2, &[0.5], vec![vec![phasor]]).contains("forces of 1 waves; the sea has 2"));
    assert!(refused(1, &[0.5, 1.0], vec![vec![phasor]]).contains("forces in 1 directions of a wave, and 2"));
    let drift = [[1.0; 3]; 4];
    assert_eq!(drifting(1, &[0.5], vec![vec![phasor]], vec![vec![drift]]), "");
    let twice = drifting(1, &[0.5], vec![vec![phasor]], vec![vec![drift]; 2]);
    assert!(twice.contains("drift forces of 2 waves; the sea has 1"), "{twice}");
    let doubled = drifting(1, &[0.5], vec![vec![phasor]], vec![vec![drift; 2]]);
    assert!(doubled.contains("drift forces in 2 directions of a wave, and 1"), "{doubled}");
}
