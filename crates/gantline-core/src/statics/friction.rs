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
/// Rounds after which what contacts hold follows half as fast, a third as fast after as many again, and so on.
const PATIENCE: usize = 8;

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

    /// Sets what friction holds by the forces found, after so many rounds; true where that was right before.
    pub(super) fn follow_friction(
        &mut self,
        system: &System,
        state: &State,
        (losses, round): (Losses, usize),
    ) -> bool {
        let sheaves = match losses.sheaves {
            Sheaves::Ideal => 0.0,
            Sheaves::Slip(sign) => self.follow_sheaves(system, state, Some(sign)),
            Sheaves::Held => self.follow_sheaves(system, state, None),
        };
        let contacts = match losses.contacts {
            Contacts::Free => 0.0,
            contacts => self.follow_contacts(system, (contacts, round)),
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
    fn follow_contacts(&mut self, system: &System, (contacts, round): (Contacts, usize)) -> f64 {
        let (mut most, mut largest) = (0.0_f64, f64::MIN_POSITIVE);
        // Corners answer to each other, and may take turns.
        let follow = 1.0 / (1 + round / PATIENCE) as f64;
        let tension = &self.search.here.tension;
        for rows in system.friction.chunks_exact(2) {
            let Law::Friction { coefficient, normal, .. } = system.rows.laws[rows[0]] else { continue };
            let bound = coefficient * tension[normal].max(0.0);
            largest = largest.max(bound);
            if let Contacts::Slid(direction) = contacts {
                let AnyConstraint::Contact(contact) = system.constraint_of_row(rows[0]) else { continue };
                let way = contact.plane.tangents.map(|tangent| tangent.dot(direction));
                let size = way[0].hypot(way[1]);
                for (&row, part) in rows.iter().zip(way) {
                    let wanted = if size > 0.0 { bound * part / size } else { 0.0 };
                    if let Part::Resist(known) = &mut self.bearings[row].part {
                        most = most.max((wanted - *known).abs());
                        *known += follow * (wanted - *known);
                    }
                }
            } else {
                let known = if let Part::Stick(known) = self.bearings[rows[0]].part { known } else { 0.0 };
                most = most.max(wrong(known, bound, tension[rows[0]].hypot(tension[rows[1]])));
                let bound = if known.is_finite() { known + follow * (bound - known) } else { bound };
                let parts = if bound > 0.0 { [Part::Stick(bound), Part::Across] } else { [Part::Off; 2] };
                (self.bearings[rows[0]].part, self.bearings[rows[1]].part) = (parts[0], parts[1]);
            }
        }
        most / largest
    }
}
