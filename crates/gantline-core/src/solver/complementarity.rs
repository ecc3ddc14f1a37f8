//! The mixed complementarity problem of a step: ropes only pull, contacts only push, friction has a cone.
//!
//! Block principal pivoting (Júdice and Pires 1994): all rows that violate their law change side at once,
//! while that lowers their number; where it does not, one at a time by Murty's least-index rule, which
//! ends for the positive definite problems that ropes and normal forces pose. Warm-started from the last
//! step, so a step without change costs one factorisation. Friction rows stick until their bound is
//! reached; then their force is μN against the slip, found by fixed point. Light bodies on stiff springs, k h²/m well
//! above one, turn too far in that: where it has not settled after [`PLAIN_ROUNDS`] rounds, the direction is that of the pull
//! without what the force itself does to it, as far as the row's own inertia tells (projected Gauss–Seidel). Friction that
//! takes more from its normal force than it has lets that go slack and act again for ever: after [`WHOLE_ROUNDS`] rounds
//! friction goes a share of its way alone, and begins from nothing.
//! Brakes hold or slip ([`super::brakes`]); with light sheaves those and what is elastic are found together
//! ([`super::balance`]).

use super::balance::{Balance, Guess};
use super::brakes::Holding;
use super::kkt::Kkt;
use super::symbolic::ZeroPivot;
use crate::clock::Stage;
use crate::constraint::Law;
use crate::system::System;
use serde::{Deserialize, Serialize};

/// How a row takes part.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Mode {
    /// No force.
    Slack,
    /// Force by its law.
    Acting,
    /// Friction at its bound.
    Slipping,
    /// No force for good: of a rope that has parted.
    Parted,
    /// No force as long as the rope is not on: not yet put on, or taken off.
    Off,
}

impl Mode {
    /// True where there may be a force.
    pub fn carries(self) -> bool {
        matches!(self, Self::Acting | Self::Slipping)
    }

    /// True where what the row is of is not there: it has parted, or is not on.
    pub fn is_absent(self) -> bool {
        matches!(self, Self::Parted | Self::Off)
    }
}

/// Block changes without progress before one row at a time is changed.
const PATIENCE: usize = 3;
/// Rounds of the plain fixed point of friction.
const PLAIN_ROUNDS: usize = 30;
/// Rounds in which friction goes its whole way; half of it in as many more, then a quarter, down to a sixteenth.
const WHOLE_ROUNDS: usize = 60;
/// Rounding in a law's value, relative to the terms it is the sum of.
const ROUNDING: f64 = 1e-12;
/// The same of what a span is stretched by, as a share of the whole rope, which is of the size of the coordinates that its
/// parts are differences of.
const LENGTH_ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Fixed point of friction forces, relative to the bound μN.
const FRICTION_TOLERANCE: f64 = 1e-10;

/// One step's problem.
pub struct Problem<'a> {
    /// Step [s].
    pub h: f64,
    /// g of every row at the start of the step.
    pub value: &'a [f64],
    /// ∂g/∂q.
    pub gradient: &'a [f64],
    /// Right side of every degree of freedom.
    pub force: &'a [f64],
}

/// What was found.
#[derive(Debug, Clone, Copy, Default)]
pub struct Outcome {
    /// Factorisations made.
    pub factorisations: u64,
    /// False where the iteration was capped.
    pub converged: bool,
}

/// Modes, forces and work arrays. Reused from step to step.
#[derive(Debug, Clone)]
pub struct Complementarity {
    /// Mode of every row; the warm start of the next step.
    pub modes: Vec<Mode>,
    /// Force of every row [N].
    pub tension: Vec<f64>,
    /// What the law asks of every row without its bound [N]; negative where slack.
    pub trial: Vec<f64>,
    impulse: Vec<f64>,
    row_right: Vec<f64>,
    force: Vec<f64>,
    slip: Vec<f64>,
    /// Brakes, with the direction in which they slip or slipped last.
    pub brakes: Vec<Holding>,
    /// With light sheaves, rows that are found together.
    balance: Balance,
    noise: Vec<f64>,
    /// To how much the value of a row is known that is the difference of two lengths [m].
    rounding: Vec<f64>,
    wrong: Vec<usize>,
    factored: bool,
}

impl Complementarity {
    /// All rows slack.
    pub fn new(system: &System) -> Self {
        let rows = system.rows.count();
        let mut rounding = vec![0.0; rows];
        let lengths = system.ropes().flat_map(|rope| {
            let whole: f64 = rope.spans.iter().map(|span| span.length).sum();
            rope.spans.iter().map(move |_| whole)
        });
        rounding.iter_mut().zip(lengths).for_each(|(known, length)| *known = LENGTH_ROUNDING * length);
        // Of spans between light sheaves, which are found with these, no more is asked.
        let compliances = system.rows.laws.iter().map(Law::compliance);
        let noise = rounding
            .iter()
            .zip(compliances)
            .map(|(known, compliance)| known / compliance.max(f64::MIN_POSITIVE));
        let noise = noise.collect();
        Self {
            balance: Balance::new(system),
            noise,
            rounding,
            modes: vec![Mode::Slack; rows],
            tension: vec![0.0; rows],
            trial: vec![0.0; rows],
            impulse: vec![0.0; rows],
            row_right: vec![0.0; rows],
            force: vec![0.0; system.tree.velocities],
            slip: vec![0.0; rows],
            brakes: Vec::new(),
            wrong: Vec::with_capacity(rows),
            factored: false,
        }
    }

    /// Begins a step, of another matrix and with its own [`Complementarity::brakes`], with the modes and forces of the one
    /// before [N]: what slid begins with its force.
    pub fn begin(&mut self, system: &System, gradient: &[f64], modes: &[Mode], force: &[f64]) {
        self.modes.copy_from_slice(modes);
        for brake in &self.brakes {
            if self.modes[brake.row] != Mode::Slipping {
                self.modes[brake.row] = Mode::Acting;
            }
        }
        self.balance.begin(system, gradient, &mut self.modes, &mut self.brakes);
        self.slip.copy_from_slice(force);
        self.factored = false;
    }

    /// Solves for the velocities `v` (driven entries given) and the forces.
    ///
    /// # Errors
    /// [`ZeroPivot`] where the matrix is singular.
    pub fn solve(
        &mut self,
        system: &System,
        kkt: &mut Kkt,
        problem: &Problem,
        v: &mut [f64],
    ) -> Result<Outcome, ZeroPivot> {
        let rows = system.rows.count();
        let mut outcome = Outcome::default();
        let (mut least, mut patience) = (usize::MAX, PATIENCE);
        self.balance.forget();
        for round in 0..100 + 4 * rows {
            if !self.factored {
                let (modes, brakes, h) = (&self.modes, &self.brakes, problem.h);
                system.clock.time(Stage::Factorisation, || kkt.factorise(system, modes, brakes, h))?;
                outcome.factorisations += 1;
                self.factored = true;
            }
            self.right_sides(system, problem, v);
            system
                .clock
                .time(Stage::Solution, || kkt.solve(&self.force, &self.row_right, v, &mut self.impulse));
            self.read_forces(system, problem, v);
            let settled = self.friction(system, (round > PLAIN_ROUNDS).then_some(problem), share_of(round));
            self.find_wrong(system, problem, v);
            let balanced = self.balance(system, problem, v, settled);
            if self.wrong.is_empty() && settled && balanced {
                outcome.converged = true;
                break;
            }
            if !balanced {
                // All other rows have their turn once these agree.
                continue;
            }
            if self.wrong.len() < least {
                (least, patience) = (self.wrong.len(), PATIENCE);
            } else {
                patience = patience.saturating_sub(1);
            }
            if patience == 0 {
                let last = self.wrong.pop();
                self.wrong.clear();
                self.wrong.extend(last);
            }
            for index in 0..self.wrong.len() {
                self.turn_over(system, self.wrong[index]);
            }
        }
        for (tension, law) in self.tension.iter_mut().zip(&system.rows.laws) {
            if matches!(law, Law::Unilateral { .. }) {
                *tension = tension.max(0.0);
            }
        }
        for brake in self.brakes.iter().filter(|brake| brake.rests(&self.modes)) {
            v[brake.dof] = 0.0;
        }
        Ok(outcome)
    }

    /// What the drive of a motor asks for, by the row of its brake; 0 for other rows.
    pub fn asked(&self, system: &System, row: usize) -> f64 {
        let brake = row.checked_sub(system.first_brake_row());
        brake.map_or(0.0, |brake| self.brakes[brake].asked)
    }

    /// Lets the rows that are found together take part as they should; true where they did.
    fn balance(&mut self, system: &System, problem: &Problem, v: &[f64], settled: bool) -> bool {
        if system.light.is_empty() {
            return true;
        }
        let Self { trial, noise, tension, modes, brakes, .. } = self;
        let guess = Guess { trial, noise, tension, v, modes, brakes };
        let balanced = self.balance.settle(system, problem, guess);
        self.factored &= balanced;
        if !settled || (balanced && !self.wrong.is_empty()) {
            self.balance.forget();
        }
        balanced
    }

    /// Lets a row that breaks its law change side.
    fn turn_over(&mut self, system: &System, row: usize) {
        self.factored = false;
        let brake = row.checked_sub(system.first_brake_row());
        self.modes[row] = match (self.modes[row], brake) {
            (Mode::Acting, Some(brake)) => {
                self.brakes[brake].way = self.tension[row].signum();
                Mode::Slipping
            }
            (Mode::Slack | Mode::Slipping, _) => Mode::Acting,
            _ => Mode::Slack,
        };
    }

    /// Largest distance of a force from its law [N].
    pub fn residual(&self, system: &System) -> f64 {
        let rows = system.rows.laws.iter().zip(self.tension.iter().zip(&self.trial));
        rows.filter(|(law, _)| matches!(law, Law::Unilateral { .. }))
            .map(|(_, (tension, trial))| (tension - trial.max(0.0)).abs())
            .fold(0.0, f64::max)
    }

    fn right_sides(&mut self, system: &System, problem: &Problem, v: &[f64]) {
        self.force.copy_from_slice(problem.force);
        let brakes = system.first_brake_row();
        for (row, law) in system.rows.laws.iter().enumerate() {
            match self.modes[row] {
                Mode::Slack | Mode::Parted | Mode::Off => self.row_right[row] = 0.0,
                Mode::Slipping if row >= brakes => {
                    self.row_right[row] = -problem.h * self.brakes[row - brakes].force_at_rest();
                }
                Mode::Slipping => {
                    self.row_right[row] = 0.0;
                    for (dof, entry) in system.rows.entries(problem.gradient, row) {
                        self.force[dof] -= problem.h * entry * self.slip[row];
                    }
                }
                Mode::Acting => {
                    let driven: f64 = system
                        .rows
                        .entries(problem.gradient, row)
                        .filter(|&(dof, _)| system.driven[dof].is_some())
                        .map(|(dof, entry)| entry * v[dof])
                        .sum();
                    let asked = self.asked(system, row);
                    self.row_right[row] =
                        asked - problem.value[row] / (problem.h + law.damping_time()) - driven;
                }
            }
        }
    }

    fn read_forces(&mut self, system: &System, problem: &Problem, v: &[f64]) {
        let brakes = system.first_brake_row();
        for (row, law) in system.rows.laws.iter().enumerate() {
            self.tension[row] = match self.modes[row] {
                Mode::Slack => 0.0,
                Mode::Parted | Mode::Off => {
                    (self.tension[row], self.trial[row]) = (0.0, 0.0);
                    continue;
                }
                Mode::Slipping if row < brakes => self.slip[row],
                Mode::Acting | Mode::Slipping => self.impulse[row] / problem.h,
            };
            if row >= brakes {
                self.trial[row] = self.tension[row];
                continue;
            }
            let reach = problem.h + law.damping_time();
            let stretch = problem.value[row] + reach * system.rows.rate(problem.gradient, row, v);
            self.trial[row] = if law.compliance() > 0.0 {
                stretch / law.compliance()
            } else {
                self.tension[row] + stretch * self.inertia_over_time(system, problem, row)
            };
        }
    }

    /// Force that changes the row's velocity by a unit in a step, over the step: turns the error of an
    /// inextensible row into newtons.
    fn inertia_over_time(&self, system: &System, problem: &Problem, row: usize) -> f64 {
        let entries = system.rows.entries(problem.gradient, row);
        let mobility: f64 = entries.map(|(dof, entry)| entry * entry / system.tree.inertia_scale[dof]).sum();
        1.0 / (problem.h * problem.h * mobility.max(f64::MIN_POSITIVE))
    }

    fn find_wrong(&mut self, system: &System, problem: &Problem, v: &[f64]) {
        self.wrong.clear();
        for (row, law) in system.rows.laws.iter().enumerate() {
            let is_single = matches!(law, Law::Unilateral { .. }) && !self.balance.is_divided[row];
            if !is_single || self.modes[row].is_absent() {
                continue;
            }
            let reach = problem.h + law.damping_time();
            let terms: f64 = system
                .rows
                .entries(problem.gradient, row)
                .map(|(dof, entry)| (entry * v[dof]).abs())
                .sum::<f64>()
                * reach
                + problem.value[row].abs();
            let noise = if law.compliance() > 0.0 {
                (ROUNDING * terms + self.rounding[row]) / law.compliance()
            } else {
                ROUNDING * (self.tension[row].abs() + terms * self.inertia_over_time(system, problem, row))
            };
            self.noise[row] = noise;
            let wrong = match self.modes[row] {
                _ if self.balance.has[row] => false,
                Mode::Slack => self.trial[row] > noise,
                Mode::Acting | Mode::Slipping | Mode::Parted | Mode::Off => self.trial[row] < -noise,
            };
            if wrong {
                self.wrong.push(row);
            }
        }
        for brake in &self.brakes {
            if self.balance.has[brake.row] {
                continue;
            }
            let rate = system.rows.rate(problem.gradient, brake.row, v);
            if brake.is_wrong(self.modes[brake.row], (&self.tension, &self.noise), v, rate) {
                self.wrong.push(brake.row);
            }
        }
    }

    /// What a unit of force in a friction row takes from what spring and damper ask of it at the end of the step.
    fn yielding(&self, system: &System, problem: &Problem, row: usize) -> f64 {
        let law = &system.rows.laws[row];
        let entries = system.rows.entries(problem.gradient, row);
        let mobility: f64 = entries.map(|(dof, entry)| entry * entry / system.tree.inertia_scale[dof]).sum();
        (problem.h + law.damping_time()) * problem.h * mobility / law.compliance()
    }

    /// Sets modes and forces of friction rows after the normal forces; true when nothing changed. With a `problem` the
    /// direction of slip is that without the force's own part. Forces at their bound go a `share` of their way.
    fn friction(&mut self, system: &System, problem: Option<&Problem>, share: f64) -> bool {
        let mut settled = true;
        let mut row = 0;
        while row < system.rows.count() {
            let Law::Friction { coefficient, normal, .. } = system.rows.laws[row] else {
                row += 1;
                continue;
            };
            if self.modes[normal].is_absent() {
                row += 2;
                continue;
            }
            let bound = coefficient * self.tension[normal].max(0.0);
            let trial = [self.trial[row], self.trial[row + 1]];
            let size = trial[0].hypot(trial[1]);
            let mode = if self.modes[normal] == Mode::Slack {
                Mode::Slack
            } else if size <= bound {
                Mode::Acting
            } else {
                Mode::Slipping
            };
            let mut free = trial;
            if let (Some(problem), Mode::Slipping) = (problem, self.modes[row]) {
                let rows = [row, row + 1];
                let most =
                    rows.map(|row| self.yielding(system, problem, row)).into_iter().fold(0.0, f64::max);
                free = [0, 1].map(|k| trial[k] + most * self.slip[row + k]);
            }
            let free_size = free[0].hypot(free[1]);
            for (k, pull) in free.into_iter().enumerate() {
                if self.modes[row + k] != mode {
                    let was_fixed = self.modes[row + k] != Mode::Acting;
                    let is_fixed = mode != Mode::Acting;
                    self.modes[row + k] = mode;
                    self.factored &= was_fixed == is_fixed;
                    settled = false;
                }
                if mode == Mode::Slipping {
                    let force = bound * pull / free_size;
                    settled &= (force - self.slip[row + k]).abs() <= FRICTION_TOLERANCE * bound;
                    self.slip[row + k] = share * force + (1.0 - share) * self.slip[row + k];
                } else if mode == Mode::Slack && share < 1.0 {
                    self.slip[row + k] = 0.0;
                }
            }
            row += 2;
        }
        settled
    }
}

/// The share of its way that friction goes in a round.
fn share_of(round: usize) -> f64 {
    [1.0, 0.5, 0.25, 0.125].get(round / WHOLE_ROUNDS).copied().unwrap_or(0.0625)
}
