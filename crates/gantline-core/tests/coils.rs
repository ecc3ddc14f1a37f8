//! What drums remember, and the derivatives of what they let go, by differences.

use super::rigs::{built, cases, moved, seeds};
use gantline_core::rope::coil::{Coil, Layers, MOST_PIECES};
use gantline_core::stepper::coils::CoilTangent;
use gantline_core::stepper::frame::Frame;
use proptest::prelude::*;

const KAPPA: f64 = 0.01;
const STEP: f64 = 1e-6;

proptest! {
    #![proptest_config(cases(200))]

    /// The supplies' increments of a stage fulfil k = κ (∂ż/∂q φ + ∂ż/∂z k), ż = feeding · v, while drums wind up and
    /// climb from layer to layer.
    #[test]
    fn increments_of_supplies_follow_the_derivatives_of_their_rates(seeds in seeds()) {
        let (mut system, mut state, _) = built(&seeds);
        system.coils[0].layers = Some(Layers { radius: 0.5, growth: 0.1, turns: 5.0, start: 5.0 });
        state.coils[0].winds = true;
        let mut frame = Frame::new(&system);
        frame.update(&system, &state);
        let mut tangent = CoilTangent::default();
        tangent.linearise(&system, &frame, &state);
        tangent.turn_rows(&system, &frame, (KAPPA, &mut vec![0.0; system.rows.dofs.len()]));
        let size = system.tree.velocities;
        let mut phi: Vec<f64> = (0..size).map(|k| seeds[(11 * k + 5) % seeds.len()]).collect();
        phi.resize(system.tree.increments(), 0.0);
        let (still, nothing) = (vec![0.0; size], vec![0.0; phi.len()]);
        tangent.increments(&system, &frame, KAPPA, (&mut phi, &still, &nothing));
        let place = system.coils[0];
        let rate = |share: f64| {
            let mut there = state.clone();
            let increment: Vec<f64> = phi.iter().map(|phi| share * STEP * phi).collect();
            system.tree.advance(&mut there.q, &increment);
            let mut frame = Frame::new(&system);
            frame.update(&system, &there);
            (frame.feeding[0] * state.v[place.dof], frame.passing[0].outside)
        };
        let ((ahead, taut), (behind, still_taut)) = (rate(1.0), rate(-1.0));
        // Where the rope goes slack the derivative jumps.
        prop_assume!((taut > 0.0) == (still_taut > 0.0));
        let difference = KAPPA * (ahead - behind) / (2.0 * STEP);
        prop_assert!((difference - phi[size]).abs() < 1e-7 * (1.0 + difference.abs()), "{difference} {}", phi[size]);
    }

    /// Gradients of rows with what drums let go, by layers.
    #[test]
    fn gradient_follows_the_layers(seeds in seeds()) {
        let (mut system, state, _) = built(&seeds);
        system.coils[0].layers = Some(Layers { radius: 0.5, growth: 0.1, turns: 5.0, start: 5.0 });
        let mut frame = Frame::new(&system);
        frame.update(&system, &state);
        let place = system.coils[0];
        let mut direction = vec![0.0; system.tree.velocities];
        direction[place.dof] = 1.0;
        let value = |scale: f64| moved(&system, &state, &direction, scale).1.value[place.row];
        let difference = (value(STEP) - value(-STEP)) / (2.0 * STEP);
        prop_assert!((difference - frame.gradient[place.entry]).abs() < 1e-6);
    }
}

/// The unstretched length of `length` [m] of wound rope of the strain `strain`.
fn unstretched(length: f64, strain: f64) -> f64 {
    length / (1.0 + strain)
}

/// Rope of n turns in layer k is n 2π r (1 + (k − 1) γ); within the half turn x in which it climbs the ratio grows as
/// 2x, so that x² is gained there. 5 turns are on at the start, so turns 20 and 40 are the middles of the climbs.
#[test]
fn wound_rope_is_that_of_each_layer() {
    let layers = Layers { radius: 0.5, growth: 0.08, turns: 20.0, start: 5.0 };
    let turn = std::f64::consts::PI;
    for (turns, more) in [
        (12.0, 0.0),
        (20.0, 0.25_f64.powi(2)),
        (20.1, 0.35_f64.powi(2)),
        (30.0, 10.0),
        (40.0, 20.0 + 0.25_f64.powi(2)),
        (45.0, 25.0 + 5.0),
    ] {
        let (turned, wound) = ((turns - 5.0) * turn, (turns - 5.0 + 0.08 * more) * turn);
        assert!((layers.wound(turned) - wound).abs() < 1e-12, "{turns}: {} {wound}", layers.wound(turned));
        assert!((layers.turned_at(wound) - turned).abs() < 1e-12, "{turns}");
    }
}

#[test]
fn what_went_on_last_comes_off_first() {
    let mut coil = Coil::new(1e-3);
    coil.winds = true;
    let gained: f64 =
        [(2.0, 2e-3), (5.0, 4e-3), (6.0, 1e-3)].map(|(to, strain)| coil.bring_to(to, strain)).iter().sum();
    let held = |length: f64, strain: f64| 0.5 * strain * strain * unstretched(length, strain);
    assert!((gained - held(2.0, 2e-3) - held(3.0, 4e-3) - held(1.0, 1e-3)).abs() < 1e-18);
    coil.winds = false;
    assert_eq!([5.5, 4.0, 1.0, -1.0].map(|wound| coil.passing(wound, 9.0)), [1e-3, 4e-3, 2e-3, 1e-3]);
    let expected =
        unstretched(1.0, 1e-3) + unstretched(3.0, 4e-3) + unstretched(2.0, 2e-3) + unstretched(1.0, 1e-3);
    assert!((coil.let_go_at(-1.0) - expected).abs() < 1e-15);
    // Half of the middle piece, and rope of another strain in its place.
    coil.bring_to(3.5, 0.0);
    coil.winds = true;
    coil.bring_to(4.0, 3e-3);
    coil.winds = false;
    assert_eq!([3.8, 3.2].map(|wound| coil.passing(wound, 9.0)), [3e-3, 4e-3]);
}

#[test]
fn what_is_too_short_to_be_told_from_what_lies_below_is_forgotten() {
    let mut coil = Coil::new(1e-3);
    coil.bring_to(2.0, 2e-3);
    for (more, strain) in [(4e-10, 3e-3), (8e-10, 4e-3)] {
        coil.bring_to(2.0 + more, strain);
    }
    let before = (coil.wound, coil.let_go);
    coil.forget_last(1e-9);
    assert_eq!([2.1, 1.9, -0.1].map(|wound| coil.passing(wound, 9.0)), [2e-3, 2e-3, 1e-3]);
    assert_eq!((coil.wound, coil.let_go), before);
}

#[test]
fn a_drum_that_rings_leaves_few_pieces() {
    let mut coil = Coil::new(1e-3);
    let mut gained = coil.bring_to(2.0, 2e-3);
    for index in 0..500 {
        let strain = 2e-3 * (1.0 + 0.5 * f64::from(index).sin());
        gained += coil.bring_to(2.0 + 1e-12 * f64::from(index + 1), strain);
    }
    // The long piece, and one of half a nanometre with the mean strain.
    assert_eq!(coil.pieces.len(), 2);
    coil.winds = false;
    assert!((coil.passing(2.0 + 1e-10, 9.0) - 2e-3).abs() < 1e-4);
    assert!((gained + coil.bring_to(0.0, 0.0)).abs() < 1e-18);
}

#[test]
fn a_coil_keeps_its_length_where_it_takes_pieces_together() {
    let (mut coil, mut wound, mut taken, mut gained) = (Coil::new(0.0), 0.0, 0.0, 0.0);
    coil.winds = true;
    for index in 0..5 * MOST_PIECES {
        let strain = 1e-3 * (1.0 + 0.5 * (index as f64).sin());
        wound += 0.1;
        taken += unstretched(0.1, strain);
        gained += coil.bring_to(wound, strain);
    }
    assert!(coil.pieces.len() <= MOST_PIECES);
    coil.winds = false;
    // Rounding of 5000 sums.
    assert!((coil.let_go_at(0.0) - taken).abs() < 1e-9);
    // What it holds is what was told of it, to the last piece.
    assert!((gained + coil.bring_to(0.0, 0.0)).abs() < 1e-12);
    assert!(coil.pieces.is_empty());
}

/// Rope wound slack and then under a load that bounces, in many more pieces than a coil remembers: however many come on
/// later, what came on first is told from it. Of n pieces of a length W and a strain that changes by r the best are
/// wrong by about W r/4n, here 2 µm.
#[test]
fn what_was_wound_first_is_not_forgotten_first() {
    let (mut coil, mut wound) = (Coil::new(0.0), 0.0);
    coil.winds = true;
    coil.bring_to(5.0, 0.0);
    let (mut marks, mut taken) = (vec![(5.0, 5.0)], 5.0);
    for index in 0..200 * MOST_PIECES {
        let strain = 2e-3 * (1.0 + (2e-3 * index as f64).sin());
        wound += 5e-5;
        taken += unstretched(5e-5, strain);
        coil.bring_to(5.0 + wound, strain);
        if index % 1000 == 0 {
            marks.push((5.0 + wound, taken));
        }
    }
    coil.let_go = -taken;
    coil.winds = false;
    for (at, expected) in marks {
        let error = coil.let_go_at(at) + expected;
        assert!(error.abs() < 1e-5, "{error:e} where {at} m lie on the drum");
    }
}

#[test]
fn rope_of_whole_layers() {
    // n turns in layer k: n 2π (r + (k − 1) δ); ends inside a layer, half a climb on either side.
    let layers = Layers { radius: 0.4, growth: 0.1, turns: 10.0, start: 3.0 };
    let turn = std::f64::consts::TAU * 0.4;
    let expected = turn * (7.0 + 10.0 * 1.1 + 4.0 * 1.2);
    assert!((layers.wound(21.0 * turn) - expected).abs() < 1e-12);
    assert!((layers.ratio(21.0 * turn) - 1.2).abs() < 1e-15);
    assert!((layers.wound(-3.0 * turn) + 3.0 * turn).abs() < 1e-12);
    // The way back, also within climbs and below the first.
    for turns in [-3.0, 0.0, 6.9, 7.1, 16.8, 21.0, 200.0] {
        let turned = turns * turn;
        assert!((layers.turned_at(layers.wound(turned)) - turned).abs() <= 1e-14 * turned.abs());
    }
}
