//! Added mass of bodies in waves on random trees: against rates of momenta and of energy along paths, and against that of still
//! water. Its derivatives stand with those of all forces in `water.rs`.

use super::rigs::wet::{CLOSE, NOW, STEP, inverse, rates, wet};
use super::rigs::{cases, moved, seeds};
use gantline_core::force::slow::Slowly;
use gantline_core::force::{AnyForce, At, Force, twist_of};
use gantline_core::tree::bias::Wrench;
use gantline_core::tree::kinematics::Twist;
use gantline_core::tree::pose::Pose;
use glam::{DMat3, DVec3};
use proptest::prelude::*;

proptest! {
    #![proptest_config(cases(100))]

    /// The wrench of added mass in waves against rates of the water's momenta along a path and as its axes turn, by differences:
    /// ṗ, and about P L̇ + v × P + U × (p − P), U the velocity of the slow place there and P the momentum of what is slow; and
    /// what it gives and takes against the rate of its energy, beside what waves put in.
    #[test]
    fn added_mass_in_waves_takes_the_rate_of_both_momenta(seeds in seeds()) {
        let (system, state, frame) = wet(&seeds);
        let size = system.tree.velocities;
        let a = rates(&system, &seeds);
        let (dynamics, _) = inverse(&system, &frame, &state.v, &a);
        for force in &system.tree.forces {
            let AnyForce::LevelMass(level) = force else { continue };
            let own = &level.own;
            let moving = |time: f64| {
                let path: Vec<f64> = (0..size).map(|k| state.v[k] * time + 0.5 * a[k] * time * time).collect();
                let v: Vec<f64> = (0..size).map(|k| state.v[k] + a[k] * time).collect();
                let (_, frame) = moved(&system, &state, &path, 1.0);
                let (pose, twist) = (&frame.kinematics.pose[own.body], twist_of(&system.tree, &frame.kinematics, own.body, &v));
                let Slowly { place, heading } = level.slow.at(&state.past, NOW + time).unwrap();
                let turn = DMat3::from_rotation_z(heading[0]);
                let motion = Twist { linear: twist.at(pose.rotation * own.at), ..twist };
                let spin = DVec3::Z * heading[1];
                let away = turn * (own.at - level.slow.point).with_z(0.0);
                let slow = Twist { linear: place[1].extend(0.0) + spin.cross(away), angular: spin };
                let fast = Twist { linear: motion.linear - slow.linear, angular: motion.angular - slow.angular };
                let held = own.matrix.turned(&pose.rotation).times(&slow);
                let along = own.matrix.turned(&turn);
                (held, along.times(&fast), along.times(&motion), motion, slow)
            };
            let (after, before, (held, fast, whole, motion, slow)) = (moving(STEP), moving(-STEP), moving(0.0));
            let sum = |of: &(Wrench, Wrench, Wrench, Twist, Twist)| [of.0.force + of.1.force, of.0.moment + of.1.moment];
            let [rate, moment] = [0, 1].map(|k| (sum(&after)[k] - sum(&before)[k]) / (2.0 * STEP));
            let moment = moment + motion.linear.cross(held.force) + slow.linear.cross(fast.force);
            let at = dynamics.at(&system.tree, &frame.kinematics, own.body);
            let arm = frame.kinematics.pose[own.body].rotation * own.at;
            let found = level.wrench(&at);
            let scale = 1.0 + rate.length() + moment.length() + held.force.length() + whole.moment.length();
            prop_assert!((found.force + rate).length() < CLOSE * scale, "{} {rate}", found.force);
            prop_assert!((found.moment + moment + arm.cross(rate)).length() < CLOSE * scale * 2.0);
            let energy = |(_, _, whole, motion, _): (Wrench, Wrench, Wrench, Twist, Twist)| {
                0.5 * (whole.force.dot(motion.linear) + whole.moment.dot(motion.angular))
            };
            let inertia = level.inertia(&frame.kinematics).unwrap().times(&at.twist);
            let kinetic = 0.5 * (inertia.force.dot(at.twist.linear) + inertia.moment.dot(at.twist.angular));
            prop_assert!((kinetic - energy((held, fast, whole, motion, slow))).abs() < 1e-12 * (1.0 + kinetic));
            let stored = (energy(after) - energy(before)) / (2.0 * STEP);
            let given = -found.force.dot(at.twist.linear) - found.moment.dot(at.twist.angular);
            prop_assert!((stored - given - level.work(&at)).abs() < CLOSE * (scale + stored.abs() + given.abs()) * 2.0);
        }
    }

    /// Where a body in waves moves as its slow place and heading do, level, its added mass is that of still water.
    #[test]
    fn added_mass_in_waves_is_that_of_still_water_where_all_is_slow(seeds in seeds()) {
        let (system, state, frame) = wet(&seeds);
        for force in &system.tree.forces {
            let AnyForce::LevelMass(level) = force else { continue };
            let slowly = level.slow.at(&state.past, NOW).unwrap();
            let rotation = DMat3::from_rotation_z(slowly.heading[0]);
            let [spin, spinning] = [1, 2].map(|k| DVec3::Z * slowly.heading[k]);
            let arm = rotation * -level.slow.point.with_z(0.0);
            let swing = spin.cross(arm);
            let twist = Twist { linear: slowly.place[1].extend(0.0) + swing, angular: spin };
            let linear = slowly.place[2].extend(0.0) + spinning.cross(arm) + spin.cross(swing);
            let pose = Pose { rotation, position: DVec3::ZERO };
            let rate = Twist { linear, angular: spinning };
            let at = At { pose: &pose, twist, rate, gravity: DVec3::ZERO, time: NOW, q: &state.q, v: &state.v, past: &state.past };
            let (still, found) = (level.own.wrench(&at), level.wrench(&at));
            let scale = 1.0 + still.force.length() + still.moment.length();
            prop_assert!((found.force - still.force).length() < 1e-12 * scale);
            prop_assert!((found.moment - still.moment).length() < 1e-12 * scale);
            prop_assert!(level.work(&at).abs() < 1e-12 * scale);
        }
        // And before anything has moved its axes are those of the body.
        let mut kinematics = frame.kinematics.clone();
        kinematics.past.clear();
        for force in &system.tree.forces {
            let AnyForce::LevelMass(level) = force else { continue };
            prop_assert_eq!(level.inertia(&kinematics), level.own.inertia(&kinematics));
        }
    }
}
