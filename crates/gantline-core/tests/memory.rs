//! Water that remembers, on random trees: its force, its answer to a motion within a step, and the derivatives of the motion
//! that it follows, against differences.

use super::rigs::{Draw, cases, moved, rig, seeds};
use gantline_core::build::build;
use gantline_core::force::memory::{Memory, form, memories, resistance, states};
use gantline_core::force::{self, AnyForce, under};
use gantline_core::spec::{ComponentSpec, ForceSpec, TermSpec, TrainsSpec};
use gantline_core::state::State;
use gantline_core::stepper::frame::Frame;
use gantline_core::system::System;
use gantline_core::tree::bias::NewtonEuler;
use gantline_core::tree::tangent::DynamicsTangent;
use proptest::prelude::*;

const STEP: f64 = 1e-5;
const CLOSE: f64 = 1e-6;

/// Oscillators b s/(s² + 2ζω s + ω²) by what they are made from: ω, ζ and a root of b.
type Oscillators = Vec<(f64, f64, [[f64; 6]; 6])>;

fn drawn(draw: &mut Draw) -> Oscillators {
    let one = |draw: &mut Draw| {
        let (omega, ratio) = (1.0 + 0.8 * draw.number(), 0.5 + 0.45 * draw.number());
        let root: [[f64; 6]; 6] = std::array::from_fn(|_| std::array::from_fn(|_| draw.number()));
        let product = |i: usize, j: usize| (0..6).map(|k| root[i][k] * root[j][k]).sum::<f64>();
        (omega, ratio, std::array::from_fn(|i| std::array::from_fn(|j| 20.0 * product(i, j))))
    };
    (0..3).map(|_| one(draw)).collect()
}

fn terms(oscillators: &Oscillators) -> Vec<TermSpec> {
    let term = |(omega, ratio, strength): &(f64, f64, [[f64; 6]; 6])| {
        let rest = (1.0 - ratio * ratio).sqrt();
        let imaginary = strength.map(|row| row.map(|entry| entry * ratio / rest));
        TermSpec { pole: [-ratio * omega, rest * omega], real: *strength, imaginary }
    };
    oscillators.iter().map(term).collect()
}

/// When all is looked at [s].
const NOW: f64 = 3.0;

/// Some waves on a body, alike from all sides.
fn wave(draw: &mut Draw, k: usize, body: &str) -> ForceSpec {
    let mut all = |size: f64| [(); 6].map(|()| [size * draw.number(), size * draw.number()]);
    ForceSpec::Wave {
        name: format!("wave{k}"),
        body: body.to_owned(),
        at: [0.1, -0.2, 0.3],
        origin: [0.4, 0.2, -0.1],
        directions: vec![0.1],
        phasors: (0..2).map(|_| vec![[all(10.0), all(0.0), all(0.0), all(0.0)]]).collect(),
        drifts: Vec::new(),
    }
}

/// The random rig with memory on two bodies somewhere in its tree, in waves if asked for, and a past.
fn remembering(seeds: &[f64], in_waves: bool) -> (System, State, Frame, Vec<Oscillators>) {
    let mut spec = rig(seeds);
    let mut draw = Draw::new(&seeds[250..]);
    let mut all = Vec::new();
    for k in 0..2 {
        let oscillators = drawn(&mut draw);
        let body = format!("b{}", draw.choice(7));
        if in_waves {
            spec.forces.push(wave(&mut draw, k, &body));
        }
        let (name, terms) = (format!("past{k}"), terms(&oscillators));
        spec.forces.push(ForceSpec::Memory { name, body, at: draw.vector(), terms });
        all.push(oscillators);
    }
    if in_waves {
        let component =
            |frequency| ComponentSpec { frequency, wave_number: [0.3, 0.2], amplitude: 0.5, phase: 0.1 };
        spec.sea = Some(TrainsSpec {
            components: vec![component(0.8), component(1.3)],
            rise_time: 1.0,
            depth: None,
        });
    }
    let (system, mut state) = build(&spec).expect("the generator makes valid rigs");
    state.past.iter_mut().for_each(|number| *number = draw.number());
    state.time = NOW;
    for force in &system.tree.forces {
        if let AnyForce::Wave(wave) = force {
            state.past[wave.slow.states().start] = NOW - 0.5;
        }
    }
    let mut frame = Frame::new(&system);
    frame.update(&system, &state);
    (system, state, frame, all)
}

fn inverse(system: &System, frame: &Frame, v: &[f64]) -> (NewtonEuler, Vec<f64>) {
    let mut dynamics = NewtonEuler::new(&system.tree);
    let mut out = vec![0.0; v.len()];
    dynamics.update(&system.tree, &frame.kinematics, v, Some(v), None, &mut out);
    (dynamics, out)
}

/// ν of a body under the velocity coordinates `v`.
fn motion(system: &System, memory: &Memory, frame: &Frame, v: &[f64]) -> [f64; 6] {
    memory.motion(&under(&system.tree, &frame.kinematics, memory.body, v))
}

proptest! {
    #![proptest_config(cases(60))]

    /// ∂ν/∂q and ∂ν/∂v, in motion, against differences.
    #[test]
    fn changes_of_its_motion_equal_differences(seeds in seeds(), in_waves: bool) {
        let (system, state, frame, _) = remembering(&seeds, in_waves);
        let (dynamics, _) = inverse(&system, &frame, &state.v);
        let mut tangent = DynamicsTangent::new(&system.tree, &frame.mass);
        for memory in memories(&system.tree) {
            let columns = memory.columns(&system.tree, &frame.kinematics);
            for (index, &dof) in system.tree.support[memory.body].iter().enumerate() {
                let at = (&frame.kinematics, &frame.mass, &dynamics);
                let changes = tangent.of_motion(&system.tree, at, &state.v, (dof, memory.body));
                let here = under(&system.tree, &frame.kinematics, memory.body, &state.v);
                let over = frame.kinematics.columns[dof].angular;
                let [place, velocity] = memory.changes_of_motion(&here, changes, over);
                let mut direction = vec![0.0; state.v.len()];
                direction[dof] = 1.0;
                let unit = motion(&system, memory, &frame, &direction);
                let at = |step: f64| {
                    let (_, frame) = moved(&system, &state, &direction, step);
                    motion(&system, memory, &frame, &state.v)
                };
                let (after, before) = (at(STEP), at(-STEP));
                let scale = after.iter().fold(1.0_f64, |most, x| most.max(x.abs()));
                for k in 0..6 {
                    let difference = (after[k] - before[k]) / (2.0 * STEP);
                    prop_assert!((difference - place[k]).abs() < CLOSE * scale, "{dof} {k}: {difference} {}", place[k]);
                    prop_assert!((unit[k] - velocity[k]).abs() < 1e-12 * scale);
                    prop_assert!((unit[k] - columns[index][k]).abs() < 1e-12 * scale);
                }
            }
        }
    }

    /// What the axes of a body in waves do by themselves, turning with its slow heading: ∂ν/∂t and ∂τ/∂t against differences
    /// over time; without waves nothing.
    #[test]
    fn what_time_does_equals_differences(seeds in seeds(), in_waves: bool) {
        let (system, state, frame, _) = remembering(&seeds, in_waves);
        let at = |step: f64| {
            let mut frame = frame.clone();
            frame.kinematics.update(&system.tree, &state.q, NOW + step);
            frame
        };
        let (after, before) = (at(STEP), at(-STEP));
        for memory in memories(&system.tree) {
            prop_assert!(memory.slow.is_some() == in_waves);
            let here = under(&system.tree, &frame.kinematics, memory.body, &state.v);
            let found = memory.motion_over_time(&here);
            let ends = [&after, &before].map(|frame| motion(&system, memory, frame, &state.v));
            let scale = ends[0].iter().fold(1.0_f64, |most, x| most.max(x.abs()));
            for k in 0..6 {
                let difference = (ends[0][k] - ends[1][k]) / (2.0 * STEP);
                prop_assert!((difference - found[k]).abs() < CLOSE * scale, "{k}: {difference} {}", found[k]);
            }
        }
        let mut drift = vec![0.0; state.v.len()];
        let (dynamics, _) = inverse(&system, &frame, &state.v);
        force::over_time(&system.tree, &frame.kinematics, &dynamics, &mut drift);
        let [up, down] = [&after, &before].map(|frame| inverse(&system, frame, &state.v).1);
        let scale = up.iter().fold(100.0_f64, |most, x| most.max(x.abs()));
        for dof in (0..state.v.len()).filter(|&dof| system.driven[dof].is_none()) {
            let difference = (up[dof] - down[dof]) / (2.0 * STEP);
            prop_assert!((difference - drift[dof]).abs() < CLOSE * scale, "{dof}: {difference} {}", drift[dof]);
        }
    }

    /// ∂τ/∂q with a past that pushes: its force does not know how the body moves. It turns along with it where no waves push.
    #[test]
    fn tangents_equal_differences(seeds in seeds(), in_waves: bool) {
        let (system, state, frame, _) = remembering(&seeds, in_waves);
        let (dynamics, here) = inverse(&system, &frame, &state.v);
        let mut tangent = DynamicsTangent::new(&system.tree, &frame.mass);
        tangent.update(&system.tree, &frame.kinematics, &frame.mass, &dynamics, &state.v);
        let scale = here.iter().fold(100.0_f64, |most, x| most.max(x.abs()));
        for column in 0..state.v.len() {
            let mut direction = vec![0.0; state.v.len()];
            direction[column] = 1.0;
            let at = |step: f64| {
                let (_, frame) = moved(&system, &state, &direction, step);
                inverse(&system, &frame, &state.v).1
            };
            let (up, down) = (at(STEP), at(-STEP));
            for row in (0..state.v.len()).filter(|&row| system.driven[row].is_none()) {
                let (low, high) = (row.min(column), row.max(column));
                let range = frame.mass.row_start[high]..frame.mass.row_start[high + 1];
                let slot = range.into_iter().find(|&slot| frame.mass.columns[slot] == low);
                let values = if row >= column { &tangent.position.lower } else { &tangent.position.upper };
                let found = slot.map_or(0.0, |slot| values[slot]);
                let place = (up[row] - down[row]) / (2.0 * STEP);
                prop_assert!((place - found).abs() < 1e-6 * scale, "{row} {column}: {place} {found}");
            }
        }
    }

    /// A force −Re Σ R z after a step κ from nothing is that of a damping κ K̂(1/κ), and B(ω) + iω (A − A(∞)) of its terms
    /// is that of the oscillators b s/(s² + 2ζω s + ω²) at s = iω, which takes power from any motion.
    #[test]
    fn terms_answer_like_oscillators(seeds in seeds(), omega in 0.0..4.0_f64, kappa in 0.01..3.0_f64) {
        let (system, state, frame, all) = remembering(&seeds, false);
        for (memory, oscillators) in memories(&system.tree).zip(&all) {
            let motion = motion(&system, memory, &frame, &state.v);
            let mut past = vec![0.0; states(&system.tree)];
            memory.answer(kappa, &motion, &mut past);
            let (held, damping) = (memory.along(&past, &motion), memory.damping(kappa).rows());
            let wanted = form(&damping, &motion, &motion);
            prop_assert!((held - wanted).abs() < 1e-11 * (1.0 + wanted.abs()), "{held} {wanted}");
            let [found, mass] = memory.at_frequency(omega).map(|square| square.rows());
            for i in 0..6 {
                for j in 0..6 {
                    let (mut damped, mut moved, mut real) = (0.0, 0.0, 0.0);
                    for (own, ratio, strength) in oscillators {
                        let (a, b) = (own * own - omega * omega, 2.0 * ratio * own * omega);
                        damped += strength[i][j] * omega * b / (a * a + b * b);
                        moved += strength[i][j] * a / (a * a + b * b);
                        real += strength[i][j] / kappa / (1.0 / kappa / kappa + 2.0 * ratio * own / kappa + own * own);
                    }
                    prop_assert!((found[i][j] - damped).abs() < 1e-9 * (1.0 + damped.abs()));
                    prop_assert!((mass[i][j] - moved).abs() < 1e-9 * (1.0 + moved.abs()));
                    prop_assert!((damping[i][j] - real).abs() < 1e-9 * (1.0 + real.abs()));
                }
            }
        }
        prop_assert!(resistance(&system.tree, &frame.kinematics, omega, &state.v) >= 0.0);
    }
}

/// Terms that would drive a body, or do not decay, are refused by name.
#[test]
fn what_gives_energy_is_refused() {
    let mut seeds = vec![0.1; 400];
    seeds.iter_mut().enumerate().for_each(|(k, seed)| *seed = ((k * 37) % 101) as f64 / 101.0 - 0.5);
    let refused = |change: fn(&mut TermSpec)| {
        let mut spec = rig(&seeds);
        let mut given = terms(&drawn(&mut Draw::new(&seeds[250..])));
        change(&mut given[0]);
        let (name, body) = ("past".to_owned(), "b0".to_owned());
        spec.forces.push(ForceSpec::Memory { name, body, at: [0.0; 3], terms: given });
        build(&spec).map(|_| ()).unwrap_err().to_string()
    };
    let grows = refused(|term| term.pole[0] = 0.1);
    assert!(grows.contains("past") && grows.contains("does not decay"), "{grows}");
    let drives = refused(|term| term.real[2][2] -= 1e4);
    assert!(drives.contains("past") && drives.contains("negative eigenvalues"), "{drives}");
    let endless = refused(|term| term.imaginary[0][0] = f64::INFINITY);
    assert!(endless.contains("past"), "{endless}");
}

/// Of two wave forces on a body, with points of their own, the first says along which axes memory, damping and added mass act:
/// all along the same, and the heading of both is one.
#[test]
fn of_two_wave_forces_the_first_says_the_axes() {
    let mut seeds = vec![0.1; 400];
    seeds.iter_mut().enumerate().for_each(|(k, seed)| *seed = ((k * 37) % 101) as f64 / 101.0 - 0.5);
    let mut spec = rig(&seeds);
    let mut draw = Draw::new(&seeds[250..]);
    let (name, body, terms) = ("past".to_owned(), "b0".to_owned(), terms(&drawn(&mut draw)));
    let matrix = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 }));
    let (at, quadratic, stream) = ([0.0; 3], [0.0; 6], [0.0; 3]);
    spec.forces.push(ForceSpec::Memory { name, body: body.clone(), at, terms });
    let (name, added) = ("viscous".to_owned(), "added".to_owned());
    spec.forces.push(ForceSpec::AddedMass { name: added, body: body.clone(), at, matrix });
    spec.forces.push(ForceSpec::Drag {
        name,
        body,
        at,
        damping: matrix,
        quadratic,
        stream,
        profile: None,
        gusty: false,
    });
    for k in 0..2 {
        let ForceSpec::Wave { name, body, at, directions, phasors, .. } = wave(&mut draw, k, "b0") else {
            unreachable!()
        };
        let origin = [k as f64, 0.0, 0.0];
        spec.forces.push(ForceSpec::Wave { name, body, at, origin, directions, phasors, drifts: Vec::new() });
    }
    let component =
        |frequency| ComponentSpec { frequency, wave_number: [0.3, 0.2], amplitude: 0.5, phase: 0.1 };
    spec.sea =
        Some(TrainsSpec { components: vec![component(0.8), component(1.3)], rise_time: 1.0, depth: None });
    let (system, _) = build(&spec).expect("two wave forces may act on a body");
    let waves: Vec<_> = system
        .tree
        .forces
        .iter()
        .filter_map(|force| if let AnyForce::Wave(wave) = force { Some(&wave.slow) } else { None })
        .collect();
    let mut seen = 0;
    for force in &system.tree.forces {
        let slow = match force {
            AnyForce::Memory(memory) => memory.slow.as_ref().expect("waves push its body"),
            AnyForce::Damping(damping) => &damping.slow,
            AnyForce::LevelMass(level) => &level.slow,
            _ => continue,
        };
        assert!(slow == waves[0] && slow != waves[1]);
        seen += 1;
    }
    assert_eq!((seen, waves.len()), (3, 2));
}
