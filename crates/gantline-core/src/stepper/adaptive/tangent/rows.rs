//! The rows of the matrix: what the law of each makes of its gradient, with its mode frozen.

use super::TangentMatrix;
use crate::constraint::brake::{At, Brake};
use crate::constraint::{AnyConstraint, Law};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::adaptive::evaluation::Evaluation;
use crate::stepper::adaptive::light::carries;
use crate::system::System;

impl TangentMatrix {
    pub(super) fn place_rows(&mut self, system: &System, here: &Evaluation, state: &State, kappa: f64) {
        let gradient = &here.frame.gradient;
        for (row, law) in system.exerting_laws().iter().enumerate() {
            let tau = law.damping_time();
            let entries = system.rows.start[row]..system.rows.start[row + 1];
            if law.compliance() == 0.0 {
                self.turned[entries.clone()].copy_from_slice(&self.pull_position[entries]);
                continue;
            }
            let terms = gradient[entries.clone()].iter().zip(&self.turning[entries.clone()]);
            for (out, (entry, turning)) in self.turned[entries].iter_mut().zip(terms) {
                *out = entry + tau * turning;
            }
        }
        self.coils.turn_rows(system, &here.frame, (kappa, &mut self.turned));
        for &(entry, joint) in &self.places.row_triples {
            let triple = &mut self.turned[entry..entry + 3];
            let turned = self.spins.turn(joint, [triple[0], triple[1], triple[2]]);
            triple.copy_from_slice(&turned);
        }
        for (row, law) in system.exerting_laws().iter().enumerate() {
            self.place_row(system, here, state, kappa, (row, law));
        }
        for diagonal in &self.places.diagonal[system.first_light_row()..] {
            self.values[*diagonal as usize] = -1.0;
        }
        self.place_light(system, here, &state.modes, kappa);
    }

    /// Flows of light sheaves: in place of forces, what they hold or how they slip.
    fn place_light(&mut self, system: &System, here: &Evaluation, modes: &[Mode], kappa: f64) {
        let mut places = self.places.light.iter();
        for (light, now) in system.light.iter().zip(&here.light) {
            let carries = carries(light, modes);
            for ((sheave, &ratio), places) in light.ratio.iter().enumerate().zip(&mut places) {
                for &place in &places.all {
                    self.values[place as usize] = 0.0;
                }
                let Some(step) = now.moving.step(sheave, ratio).filter(|_| carries) else {
                    self.values[places.diagonal as usize] = 1.0;
                    continue;
                };
                let answer = |span: usize| {
                    let row = light.rows.start + span;
                    let [scale, _, unstretched] = here.answers[row];
                    let tension = scale * here.tension[row];
                    (scale, kappa * kappa * tension / (2.0 * unstretched))
                };
                // δL is x₋ − x of the span before and x − x₊ of the one after.
                let ((before, bend), (after, other_bend)) = (answer(sheave), answer(sheave + 1));
                let [to_before, to_after] = places.sides.map(|place| place as usize);
                (self.values[to_before], self.values[to_after]) = (-step * before, after);
                self.values[places.diagonal as usize] = -step * bend - other_bend;
                for (place, value) in places.beside.iter().zip([step * bend, other_bend]) {
                    if let Some(place) = place {
                        self.values[*place as usize] = value;
                    }
                }
            }
        }
    }

    fn place_row(
        &mut self,
        system: &System,
        here: &Evaluation,
        state: &State,
        kappa: f64,
        (row, law): (usize, &Law),
    ) {
        let range = system.rows.start[row]..system.rows.start[row + 1];
        let (tau, compliance) = (law.damping_time(), law.compliance());
        let gradient = &here.frame.gradient;
        let diagonal = self.places.diagonal[row] as usize;
        self.values[diagonal] = match state.modes[row] {
            Mode::Acting if compliance == 0.0 => 0.0,
            Mode::Acting => -compliance / (kappa * (kappa + tau)),
            Mode::Slack | Mode::Slipping | Mode::Parted | Mode::Off => -1.0,
        };
        if !state.modes[row].carries() {
            return;
        }
        for (place, entry) in self.places.in_column[range.clone()].iter().zip(&gradient[range.clone()]) {
            self.values[*place as usize] = *entry;
        }
        let in_row = self.places.in_row[range.clone()].iter().map(|place| *place as usize);
        let (own, turned) = (&gradient[range.clone()], &self.turned[range.clone()]);
        match state.modes[row] {
            Mode::Slack | Mode::Parted | Mode::Off => {}
            Mode::Slipping if matches!(law, Law::Brake { .. }) => {
                self.place_slipping_brake(system, here, state, kappa, row);
            }
            Mode::Slipping => self.place_sliding(system, here, kappa, (row, law)),
            Mode::Acting if compliance == 0.0 => {
                let pull = self.pull_velocity[range].iter();
                for (((place, entry), pull), turned) in in_row.zip(own).zip(pull).zip(turned) {
                    self.values[place] = entry + kappa * pull + kappa * kappa * turned;
                }
            }
            Mode::Acting => {
                let [share, rest] = [kappa, tau].map(|part| part / (kappa + tau));
                for ((place, entry), turned) in in_row.zip(own).zip(turned) {
                    self.values[place] = share * turned + rest * entry;
                }
            }
        }
        if state.modes[row] == Mode::Slipping {
            self.place_bounds(system, here, state, (row, law));
        }
    }

    /// A brake that slips: no row of its gradient, but how its bound follows speed and places.
    fn place_slipping_brake(
        &mut self,
        system: &System,
        here: &Evaluation,
        state: &State,
        kappa: f64,
        row: usize,
    ) {
        let range = system.rows.start[row]..system.rows.start[row + 1];
        let in_row = &self.places.in_row[range];
        for place in in_row {
            self.values[*place as usize] = 0.0;
        }
        let Some(brake) = brake_of(system, row) else { return };
        let driven = -state.memory[row] * state.v[brake.dof];
        // d(bound · direction)/dv, the direction's square being 1.
        if here.held[row].is_none() {
            self.values[in_row[brake.own] as usize] -= kappa * brake.slope(driven);
        }
        let square = kappa * kappa * state.memory[row];
        brake.add_slopes(at(here, state), &here.frame.feeding, &here.tension, |entry, slope| {
            self.values[in_row[entry] as usize] += square * slope;
        });
    }

    /// A contact that slides: its own spring and that of its partner, which turn the force together.
    fn place_sliding(&mut self, system: &System, here: &Evaluation, kappa: f64, (row, law): (usize, &Law)) {
        let gradient = &here.frame.gradient;
        let [first, second] = slip_weights(law, here, kappa, row);
        let deflection = |entry: usize| kappa * self.turned[entry] + law.damping_time() * gradient[entry];
        let range = system.rows.start[row]..system.rows.start[row + 1];
        for (entry, other) in range.zip(partner_of(system, law, row)) {
            self.values[self.places.in_row[entry] as usize] =
                first * deflection(entry) + second * deflection(other);
        }
    }

    /// How the bound of a row that slips follows the forces that press.
    fn place_bounds(&mut self, system: &System, here: &Evaluation, state: &State, (row, law): (usize, &Law)) {
        let brake = brake_of(system, row);
        let friction = &self.places.friction;
        let first = friction.partition_point(|&(other, ..)| other < row);
        for &(_, to, place) in friction[first..].iter().take_while(|&&(other, ..)| other == row) {
            self.values[place as usize] = match *law {
                Law::Friction { coefficient, normal, .. } => {
                    coefficient * here.slip_direction(normal)[row - normal - 1]
                }
                _ => brake.map_or(0.0, |brake| brake.weight(at(here, state), to) * state.memory[row]),
            };
        }
    }
}

/// Where brakes find what presses on them.
fn at<'a>(here: &'a Evaluation, state: &'a State) -> At<'a> {
    At { q: &state.q, kinematics: &here.frame.kinematics, seats: &state.seats }
}

/// The brake whose row it is.
pub fn brake_of(system: &System, row: usize) -> Option<&Brake> {
    let index = row.checked_sub(system.first_brake_row())?;
    match &system.constraints[system.first_brake + index] {
        AnyConstraint::Brake(brake) => Some(brake),
        _ => None,
    }
}

/// How κT of a sliding row follows the deflection, with its damper's part, of its own spring and of its partner's
/// [N s/m]: what is across the force turns it, (μN/|T*|)/ε (1 − d dᵀ), as far as the anchor does not come after.
pub fn slip_weights(law: &Law, here: &Evaluation, kappa: f64, row: usize) -> [f64; 2] {
    let Law::Friction { compliance, damping_time: tau, normal, .. } = *law else { return [0.0; 2] };
    let direction = here.slip_direction(normal);
    let (own, other) = (direction[row - normal - 1], direction[normal + 2 - row]);
    // Below its bound it sticks; up to the switching tolerance the course of sliding is followed.
    let share = here.slip_share(law).min(1.0);
    let turning = kappa * tau * share / (compliance * (kappa + tau - kappa * share));
    [turning * (1.0 - own * own), -turning * own * other]
}

/// Entries of the other tangential row of the same contact.
fn partner_of(system: &System, law: &Law, row: usize) -> std::ops::Range<usize> {
    let partner = if let Law::Friction { normal, .. } = *law { 2 * normal + 3 - row } else { row };
    system.rows.start[partner]..system.rows.start[partner + 1]
}
