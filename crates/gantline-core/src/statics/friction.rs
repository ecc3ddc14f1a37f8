//! Friction at rest: what sheaves and contacts hold follows from the forces that press, which follow from what they hold.
//! After each search it is set anew, until it no longer changes.

use glam::DMat3;

use super::bearing::{Bearing, Part, weight};
use super::losses::{Contacts, Losses, Sheaves};
use super::{LOSS_LEFT, Statics};
use crate::constraint::brake::{At, Brake};
use crate::constraint::{AnyConstraint, Law};
use crate::state::State;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// What holds less than this share of its bound holds whatever the bound's last digits are.
pub(super) const WELL_WITHIN: f64 = 1.0 - 1e-9;

/// What is left of the error of what contacts hold, as a share of the largest bound; where no search can tell, as a share of the
/// largest force: ten times what a search leaves.
const LEFT: f64 = 1e-8;
/// What a sheave holds is next to nothing, as a share of all weight.
const LITTLE: f64 = 1e-6;
/// Smallest and largest share of a change that is followed, and that of one which makes itself larger.
const SHARES: [f64; 2] = [1.0 / 4096.0, 3.0];
const RUNAWAY: f64 = 1.0 / 16.0;

/// A contact that is farther from pressing as a search begins [m], of a body that then turns by more [cosine], is not held in
/// it: the friction of a load that has toppled from a platform onto the ground would pull it back, along the ground, to below
/// where it stood. One that is let down holds as if it had slid from below where it hung.
const ALOFT: f64 = 0.2;
const TOPPLED: f64 = 0.866;

/// A pull that has changed by more of itself is another one, and no strain's doing.
const SAME_PULL: f64 = 0.02;

/// What a tangential row was taken to hold while its contact pressed [N].
#[derive(Debug, Clone, Copy)]
struct Asked {
    /// That.
    held: f64,
    /// The change that it asked for then.
    change: f64,
    /// How far it goes back if the contact comes off.
    back: f64,
}

/// How fast what contacts hold follows what presses. Corners answer to each other and may take turns: of the changes that
/// they ask for the share is followed that would have settled all since they pressed last (Aitken's relaxation).
#[derive(Debug, Clone, Default)]
pub(super) struct Pace {
    share: f64,
    /// Of what is asked for, what is taken to be wrong: the share too, where that is known.
    doubt: f64,
    /// In this round, by tangential row; none where nothing presses, which tells nothing.
    now: Vec<Option<Asked>>,
    /// When its contact pressed last.
    pressed: Vec<Option<Asked>>,
    /// By contact, whether it is aloft as the search begins.
    aloft: Vec<bool>,
    /// How bodies are turned then, where any contact is.
    turned: Vec<DMat3>,
}

impl Pace {
    /// Begins anew, with so many tangential rows.
    pub(super) fn begin(&mut self, rows: usize) {
        (self.share, self.doubt) = (1.0, 1.0);
        for asked in [&mut self.now, &mut self.pressed] {
            asked.clear();
            asked.resize(rows, None);
        }
    }

    /// The tangential row, among all, that asks for the largest change.
    pub(super) fn worst(&self) -> usize {
        let change = |row: usize| self.now[row].map_or(0.0, |asked| asked.change.abs());
        (0..self.now.len()).max_by(|&a, &b| change(a).total_cmp(&change(b))).unwrap_or(0)
    }

    /// Notes what a row was taken to hold and the change that it asks for.
    fn note(&mut self, row: usize, held: f64, change: f64) {
        self.now[row] = Some(Asked { held, change, back: held });
    }

    /// Finds the share of what is asked for in this round that is followed.
    fn set_share(&mut self) {
        let (mut along, mut size) = (0.0, 0.0);
        for (now, before) in self.now.iter().zip(&self.pressed) {
            if let (Some(now), Some(before)) = (now, before)
                && before.change != 0.0
            {
                let less = before.change - now.change;
                along += (now.held - before.held) * less;
                size += less * less;
            }
        }
        if size > 0.0 {
            let share = along / size;
            self.share = if share > 0.0 { share.clamp(SHARES[0], SHARES[1]) } else { RUNAWAY };
            self.doubt = if share > 0.0 { self.share.min(1.0) } else { 1.0 };
        }
    }

    /// What a row that was taken to hold `known` is taken to hold in the next round [N]. One whose contact has come off
    /// under it goes half way back to where it pressed and asked for more, again and again less far; else it holds
    /// nothing.
    fn next(&mut self, row: usize, known: f64) -> f64 {
        match (self.now[row], &mut self.pressed[row]) {
            (Some(now), pressed) => {
                *pressed = Some(now);
                known + self.share * now.change
            }
            (None, Some(before)) if before.change * (known - before.held) > 0.0 => {
                let half = 0.5 * (known + before.back);
                before.back *= 0.5;
                half
            }
            _ => 0.0,
        }
    }
}

/// By how much a bound that has been taken as `known` is wrong [N], where it holds `force`.
pub(super) fn wrong(known: f64, wanted: f64, force: f64) -> f64 {
    if force.abs() < WELL_WITHIN * known.min(wanted) { 0.0 } else { (wanted - known).abs() }
}

/// Whether this row is a motor that keeps its pull.
fn keeps_pull(system: &System, row: usize) -> bool {
    system.motors.iter().any(|&(motor, drive)| motor == row && system.drives[drive].keeps_pull)
}

impl Statics {
    /// Sheaves begin with what they could hold, or resisted with, at the equilibrium before, if there was one: from there
    /// it takes half the rounds. Under rope that is about slack they hold next to nothing, and begin with all they can: else
    /// it wanders through them. Motors that keep their pull begin with what that was, which depends on strains a little.
    pub(super) fn hold_as(&mut self, system: &System, before: &[Bearing]) {
        let little = LITTLE * weight(system);
        for ((bearing, before), row) in self.bearings.iter_mut().zip(before).zip(0..) {
            let lossy =
                matches!(system.constraint_of_row(row), AnyConstraint::Brake(brake) if !brake.grip.is_none());
            match (&mut bearing.part, before.part) {
                (Part::Resist(known), Part::Resist(then)) if lossy => *known = then,
                (Part::Hold(known), Part::Hold(then)) if lossy && then > little => *known = then,
                (Part::Hold(known), Part::Hold(then))
                    if keeps_pull(system, row) && (then - *known).abs() < SAME_PULL * *known =>
                {
                    *known = then;
                }
                _ => {}
            }
        }
    }

    /// Sets what friction holds by the forces found; true where that was right before. `stays`: no search could better the
    /// balance after it was set last.
    pub(super) fn follow_friction(
        &mut self,
        system: &System,
        state: &State,
        losses: Losses,
        stays: bool,
    ) -> bool {
        let sheaves = match losses.sheaves {
            Sheaves::Ideal => 0.0,
            Sheaves::Slip(sign) => self.follow_sheaves(system, state, Some(sign)),
            Sheaves::Held => self.follow_sheaves(system, state, None),
        };
        let contacts = match losses.contacts {
            Contacts::Free => 0.0,
            contacts => self.follow_contacts(system, contacts, stays),
        };
        sheaves <= LOSS_LEFT && contacts <= LEFT
    }

    /// Sheaves that slip in the direction `sign`, or hold. Of bearing and groove in series the weaker gives way.
    fn follow_sheaves(&mut self, system: &System, state: &State, sign: Option<f64>) -> f64 {
        let mut most = 0.0_f64;
        let here = &self.search.here;
        let at = At { q: &here.q, kinematics: &here.frame.kinematics, seats: &state.seats };
        let bound_of = |brake: &Brake| brake.bound(at, &here.tension, 0.0);
        let weak_grooves: Vec<usize> = system
            .brakes()
            .filter_map(|(_, groove)| {
                let bearing = system.brakes().find(|(_, brake)| groove.spin == Some(brake.dof))?.1;
                (bound_of(groove) < bound_of(bearing)).then_some(bearing.dof)
            })
            .collect();
        for (bearing, row) in self.bearings.iter_mut().zip(0..) {
            let AnyConstraint::Brake(brake) = system.constraint_of_row(row) else { continue };
            if brake.grip.is_none() {
                continue;
            }
            let bound = bound_of(brake);
            let is_in_groove = weak_grooves.contains(&brake.spin.unwrap_or(brake.dof));
            let change = match (bearing.part, sign) {
                (Part::Hold(known), None) => {
                    bearing.part = Part::Hold(bound);
                    wrong(known, bound, here.tension[row])
                }
                (Part::Hold(_) | Part::Resist(_), Some(sign)) => {
                    let slips = brake.spin.is_some() == is_in_groove;
                    let part = if slips { Part::Resist(sign * bound) } else { Part::Hold(bound) };
                    let change = match (bearing.part, part) {
                        (Part::Resist(known), Part::Resist(wanted))
                        | (Part::Hold(known), Part::Hold(wanted)) => (wanted - known).abs(),
                        _ => bound,
                    };
                    bearing.part = part;
                    change
                }
                _ => continue,
            };
            most = most.max(change / bound.max(f64::MIN_POSITIVE));
        }
        most
    }

    /// Notes which contacts are aloft, and how their bodies are turned.
    pub(super) fn note_aloft(&mut self, system: &System, state: &State) {
        let Pace { aloft, turned, .. } = &mut self.pace;
        aloft.clear();
        turned.clear();
        aloft.extend(system.friction.chunks_exact(2).map(|rows| {
            let Law::Friction { normal, .. } = system.rows.laws[rows[0]] else { return false };
            state.trial[normal] * system.rows.laws[normal].compliance() < -ALOFT
        }));
        if aloft.contains(&true) {
            let mut kinematics = Kinematics::new(&system.tree);
            kinematics.update(&system.tree, &state.q, 0.0);
            turned.extend(kinematics.pose.iter().map(|pose| pose.rotation));
        }
    }

    /// Whether a contact was aloft and its load has toppled onto it.
    fn has_toppled(&self, system: &System, contact: usize, row: usize) -> bool {
        if !self.pace.aloft[contact] {
            return false;
        }
        let bodies = match system.constraint_of_row(row) {
            AnyConstraint::Contact(contact) => contact.facing.bodies,
            AnyConstraint::Touch(touch) => touch.facing.bodies,
            _ => return false,
        };
        bodies.into_iter().flatten().any(|body| {
            let now = &self.search.here.frame.kinematics.pose[body].rotation;
            // The angle θ between them has 1 + 2 cos θ as its trace.
            let by = self.pace.turned[body].transpose() * *now;
            0.5 * (by.col(0).x + by.col(1).y + by.col(2).z - 1.0) < TOPPLED
        })
    }

    /// Lets the contacts of the group that this row is one of slide freely: to where nothing drives them, so that friction
    /// can hold them there. False where they may not, or do.
    pub(super) fn let_slide(&mut self, system: &System, row: usize) -> bool {
        let contact = system.constraint_index(row);
        let group = system.groups.iter().position(|group| group.contacts.contains(&contact));
        let Some(group) = group.filter(|group| self.may_slide && !self.sliding.contains(group)) else {
            return false;
        };
        self.sliding.push(group);
        for &row in &system.friction {
            if self.slides(system, row) {
                self.bearings[row].part = Part::Off;
            }
        }
        self.pace.begin(system.friction.len());
        true
    }

    /// Whether the contact of this row slides freely.
    fn slides(&self, system: &System, row: usize) -> bool {
        let contact = system.constraint_index(row);
        self.sliding.iter().any(|&group| system.groups[group].contacts.contains(&contact))
    }

    /// Contacts that have slid, or hold; by how much the largest was wrong, as a share of the largest bound, or of the
    /// largest force where the search `stays`.
    fn follow_contacts(&mut self, system: &System, contacts: Contacts, stays: bool) -> f64 {
        let tension = &self.search.here.tension;
        let (mut most, mut largest) = (0.0_f64, f64::MIN_POSITIVE);
        self.pace.now.fill(None);
        for (rows, index) in system.friction.chunks_exact(2).zip((0..).step_by(2)) {
            let Law::Friction { coefficient, normal, .. } = system.rows.laws[rows[0]] else { continue };
            let toppled = contacts == Contacts::Held && self.has_toppled(system, index / 2, rows[0]);
            if toppled || self.slides(system, rows[0]) {
                continue;
            }
            let presses = tension[normal] > 0.0;
            let bound = coefficient * tension[normal].max(0.0);
            largest = largest.max(bound);
            if let Contacts::Slid(direction) = contacts {
                let AnyConstraint::Contact(contact) = system.constraint_of_row(rows[0]) else { continue };
                let tangents = contact.tangents(&self.search.here.frame.kinematics);
                let way = tangents.map(|tangent| tangent.dot(direction));
                let size = way[0].hypot(way[1]);
                for ((&row, part), index) in rows.iter().zip(way).zip(index..) {
                    let wanted = if size > 0.0 { bound * part / size } else { 0.0 };
                    if let Part::Resist(known) = self.bearings[row].part {
                        most = most.max((wanted - known).abs());
                        if presses {
                            self.pace.note(index, known, wanted - known);
                        }
                    }
                }
            } else {
                let known = if let Part::Stick(known) = self.bearings[rows[0]].part { known } else { 0.0 };
                let force = tension[rows[0]].hypot(tension[rows[1]]);
                most = most.max(wrong(known, bound, force));
                // What it did not need to hold makes no difference.
                let held = if known > force { force.max(bound.min(known)) } else { known };
                if let Part::Stick(known) = &mut self.bearings[rows[0]].part {
                    *known = held;
                }
                if presses {
                    self.pace.note(index, held, bound - held);
                }
            }
        }
        if stays {
            // That tells nothing of how the changes asked for answer to those made.
            largest = tension.iter().fold(largest, |most, tension| most.max(tension.abs()));
        } else {
            self.pace.set_share();
        }
        self.follow_at_pace(system, contacts);
        self.pace.doubt * most / largest
    }

    /// Lets what contacts hold follow what they ask for.
    fn follow_at_pace(&mut self, system: &System, contacts: Contacts) {
        for (rows, index) in system.friction.chunks_exact(2).zip((0..).step_by(2)) {
            for (&row, index) in rows.iter().zip(index..) {
                if let Part::Resist(known) = &mut self.bearings[row].part {
                    *known = self.pace.next(index, *known);
                }
            }
            if contacts == Contacts::Held && !self.slides(system, rows[0]) {
                let known = if let Part::Stick(known) = self.bearings[rows[0]].part { known } else { 0.0 };
                let bound = self.pace.next(index, known);
                let parts = if bound > 0.0 { [Part::Stick(bound), Part::Across] } else { [Part::Off; 2] };
                (self.bearings[rows[0]].part, self.bearings[rows[1]].part) = (parts[0], parts[1]);
            }
        }
    }
}
