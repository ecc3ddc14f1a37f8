//! Friction at rest: what sheaves and contacts hold follows from the forces that press, which follow from what they hold.
//! After each search it is set anew, until it no longer changes.

use super::potential::{Bearing, Contacts, Losses, Part, Sheaves};
use super::{LOSS_LEFT, Statics};
use crate::constraint::brake::At;
use crate::constraint::{AnyConstraint, Law};
use crate::state::State;
use crate::system::System;

/// What holds less than this share of its bound holds whatever the bound's last digits are.
const WELL_WITHIN: f64 = 1.0 - 1e-9;

/// What is left of the error of what contacts hold, as a share of the largest bound: ten times what a search leaves.
const LEFT: f64 = 1e-8;
/// Smallest and largest share of a change that is followed.
const SHARES: [f64; 2] = [1.0 / 16.0, 3.0];

/// How fast what contacts hold follows what presses. Corners answer to each other and may take turns: of a change that
/// they ask for again and again the share is followed that would have settled the last one (Aitken's relaxation).
#[derive(Debug, Clone, Default)]
pub(super) struct Pace {
    share: f64,
    /// Changes asked for in this round and in the one before, by tangential row [N].
    asked: [Vec<f64>; 2],
}

impl Pace {
    /// Begins anew, with so many tangential rows.
    pub(super) fn begin(&mut self, rows: usize) {
        self.share = 1.0;
        for asked in &mut self.asked {
            asked.clear();
            asked.resize(rows, 0.0);
        }
    }

    /// The tangential row, among all, that asks for the largest change.
    pub(super) fn worst(&self) -> usize {
        let [now, _] = &self.asked;
        (0..now.len()).max_by(|&a, &b| now[a].abs().total_cmp(&now[b].abs())).unwrap_or(0)
    }

    /// What is asked for in the round under way.
    fn asked(&mut self) -> &mut [f64] {
        &mut self.asked[0]
    }

    /// Ends a round: the share of what it asked for that is followed.
    fn share(&mut self) -> f64 {
        let [now, before] = &self.asked;
        let (mut along, mut size) = (0.0, 0.0);
        for (now, before) in now.iter().zip(before) {
            along += before * (before - now);
            size += (before - now).powi(2);
        }
        if size > 0.0 && before.iter().any(|change| *change != 0.0) {
            self.share = (self.share * along / size).clamp(SHARES[0], SHARES[1]);
        }
        let [now, before] = &mut self.asked;
        before.copy_from_slice(now);
        self.share
    }
}

/// By how much a bound that has been taken as `known` is wrong [N], where it holds `force`.
fn wrong(known: f64, wanted: f64, force: f64) -> f64 {
    if force.abs() < WELL_WITHIN * known.min(wanted) { 0.0 } else { (wanted - known).abs() }
}

impl Statics {
    /// Sheaves that all slip one way begin with what they resisted at the equilibrium before, if there was one: from
    /// there it takes fewer rounds.
    pub(super) fn slip_as(&mut self, before: &[Bearing], sheaves: Sheaves) {
        if !matches!(sheaves, Sheaves::Slip(_)) {
            return;
        }
        for (bearing, before) in self.bearings.iter_mut().zip(before) {
            if let (Part::Resist(known), Part::Resist(then)) = (&mut bearing.part, before.part) {
                *known = then;
            }
        }
    }

    /// Sets what friction holds by the forces found; true where that was right before.
    pub(super) fn follow_friction(&mut self, system: &System, state: &State, losses: Losses) -> bool {
        let sheaves = match losses.sheaves {
            Sheaves::Ideal => 0.0,
            Sheaves::Slip(sign) => self.follow_sheaves(system, state, Some(sign)),
            Sheaves::Held => self.follow_sheaves(system, state, None),
        };
        let contacts = match losses.contacts {
            Contacts::Free => 0.0,
            contacts => self.follow_contacts(system, contacts),
        };
        sheaves <= LOSS_LEFT && contacts <= LEFT
    }

    /// Sheaves that slip in the direction `sign`, or hold.
    fn follow_sheaves(&mut self, system: &System, state: &State, sign: Option<f64>) -> f64 {
        let mut most = 0.0_f64;
        let here = &self.search.here;
        for (bearing, row) in self.bearings.iter_mut().zip(0..) {
            let AnyConstraint::Brake(brake) = system.constraint_of_row(row) else { continue };
            if brake.grip.is_none() {
                continue;
            }
            let at = At { q: &here.q, kinematics: &here.frame.kinematics, seats: &state.seats };
            let bound = brake.bound(at, &here.tension, 0.0);
            match &mut bearing.part {
                Part::Hold(known) if sign.is_none() => {
                    let change = wrong(*known, bound, here.tension[row]);
                    most = most.max(change / bound.max(f64::MIN_POSITIVE));
                    *known = bound;
                }
                Part::Resist(known) | Part::Hold(known) => {
                    let wanted = if brake.spin.is_some() { bound } else { sign.unwrap_or(0.0) * bound };
                    most = most.max((wanted - *known).abs() / bound.max(f64::MIN_POSITIVE));
                    *known = wanted;
                }
                _ => {}
            }
        }
        most
    }

    /// Contacts that have slid, or hold; by how much the largest was wrong, as a share of the largest bound.
    fn follow_contacts(&mut self, system: &System, contacts: Contacts) -> f64 {
        let (mut most, mut largest) = (0.0_f64, f64::MIN_POSITIVE);
        for (rows, index) in system.friction.chunks_exact(2).zip((0..).step_by(2)) {
            let asked = &mut self.pace.asked()[index..index + 2];
            asked.fill(0.0);
            let Law::Friction { coefficient, normal, .. } = system.rows.laws[rows[0]] else { continue };
            let tension = &self.search.here.tension;
            let bound = coefficient * tension[normal].max(0.0);
            largest = largest.max(bound);
            if let Contacts::Slid(direction) = contacts {
                let AnyConstraint::Contact(contact) = system.constraint_of_row(rows[0]) else { continue };
                let way = contact.plane.tangents.map(|tangent| tangent.dot(direction));
                let size = way[0].hypot(way[1]);
                for ((&row, part), asked) in rows.iter().zip(way).zip(asked) {
                    let wanted = if size > 0.0 { bound * part / size } else { 0.0 };
                    if let Part::Resist(known) = self.bearings[row].part {
                        *asked = wanted - known;
                        most = most.max(asked.abs());
                    }
                }
            } else {
                let known = if let Part::Stick(known) = self.bearings[rows[0]].part { known } else { 0.0 };
                most = most.max(wrong(known, bound, tension[rows[0]].hypot(tension[rows[1]])));
                if known.is_finite() {
                    asked[0] = bound - known;
                } else {
                    self.bearings[rows[0]].part = Part::Stick(bound);
                }
            }
        }
        let share = self.pace.share();
        for (rows, asked) in system.friction.chunks_exact(2).zip(self.pace.asked().chunks_exact(2)) {
            for (&row, asked) in rows.iter().zip(asked) {
                if let Part::Resist(known) = &mut self.bearings[row].part {
                    *known += share * asked;
                }
            }
            if contacts == Contacts::Held {
                let known = if let Part::Stick(known) = self.bearings[rows[0]].part { known } else { 0.0 };
                let bound = known + share * asked[0];
                let parts = if bound > 0.0 { [Part::Stick(bound), Part::Across] } else { [Part::Off; 2] };
                (self.bearings[rows[0]].part, self.bearings[rows[1]].part) = (parts[0], parts[1]);
            }
        }
        most / largest
    }
}
