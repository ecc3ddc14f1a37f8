//! Energy that flowed in a step, by Gauss quadrature along its course.
//!
//! The course satisfies the equations of motion but for a defect: its velocity is not quite the rate of its
//! position, its acceleration not quite what the forces give. The work of that defect is what the method itself
//! adds or takes; it is computed like any other flow.

use super::evaluation::turn_of_rate;
use super::light::Laying;
use super::point::Point;
use super::winding::Paid;
use super::{Adaptive, LOOKS};
use crate::audit::{Flows, elastic_energy, spring_energy};
use crate::constraint::Law;
use crate::force::{AnyForce, At};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::coils;
use crate::system::System;
use crate::tree::drift;
use glam::DVec3;

/// Weights of the Gauss points among [`LOOKS`].
pub(super) const WEIGHTS: [f64; 4] =
    [0.173_927_422_568_726_93, 0.326_072_577_431_273_07, 0.326_072_577_431_273_07, 0.173_927_422_568_726_93];

/// What a step may leave unexplained before its flows are looked at more closely, as a share of the largest energy: hundreds
/// of steps that just stay below leave less than the 1e-5 beyond which a run is reported.
const GAP: f64 = 3e-8;
/// Parts in which a step is looked at then, at most.
const PARTS: u32 = 64;
/// A gap that changes by less than this share of it, as parts are halved so often in a row, has other causes. Once is not
/// enough: of a kink near the end of a step, as at a knee of a rope's curve, two parts may see no more than one.
const UNCHANGED: f64 = 0.1;
const HALVINGS: u32 = 2;

/// Where the loss of a row is booked.
fn loss_kind<'a>(system: &System, ledger: &'a mut Flows, row: usize) -> &'a mut f64 {
    if row < system.rope_rows() { &mut ledger.rope_damping } else { &mut ledger.contact_damping }
}

impl Adaptive {
    /// Looks at the flows of the step that was made from `before` in two parts, four and so on, while they leave a gap that
    /// this changes: where forces rise and fall within a step, as of a rope that snaps taut, four looks do not tell what
    /// flowed.
    pub fn close_books(&mut self, system: &System, before: &State, state: &mut State) {
        let Some(start) = self.start.take() else { return };
        let mut gap = state.ledger.gap_since(&before.ledger);
        let (mut parts, mut unchanged) = (1, 0);
        while gap > GAP && unchanged < HALVINGS && parts < PARTS {
            parts *= 2;
            let known = self.looked;
            self.look_closely(system, &start, parts);
            state.ledger.correct(&before.ledger, (known, self.looked));
            let left = state.ledger.gap_since(&before.ledger);
            unchanged = if (left - gap).abs() > UNCHANGED * gap { 0 } else { unchanged + 1 };
            gap = left;
        }
        self.start = Some(start);
    }

    /// Looks at the course from `start`, where the plan has already acted: ropes are cut, drives on their way.
    fn look_closely(&mut self, system: &System, start: &State, parts: u32) {
        // The evaluation of its start, see [`Adaptive::advance`].
        std::mem::swap(&mut self.next, &mut self.rodas.here);
        self.begin_looks(system, start);
        let length = self.made * self.rodas.course.h;
        let share = 1.0 / f64::from(parts);
        for part in 0..parts {
            for (theta, weight) in LOOKS.into_iter().zip(WEIGHTS) {
                let at = share * (f64::from(part) + theta);
                self.book_look(system, start, at * self.made, weight * share * length);
                self.laid.follow(system, &self.probe, start.time + at * length);
            }
        }
        std::mem::swap(&mut self.next, &mut self.rodas.here);
        self.book_pieces(system, start);
        self.looked = std::mem::take(&mut self.flows);
    }

    /// Nothing has been seen of the step from `state`.
    pub(super) fn begin_looks(&mut self, system: &System, state: &State) {
        self.flows = Flows::default();
        self.laid.start(system, state);
        self.paid.fill(Paid::default());
    }

    /// Looks at the course at the share `theta` of the step, and adds what flows around it in `duration` [s] to
    /// the flows of the step.
    pub(super) fn book_look(&mut self, system: &System, state: &State, theta: f64, duration: f64) {
        self.rodas.course.at(theta, &mut self.point);
        self.rodas.course.rate_at(theta, &mut self.rate);
        let elapsed = theta * self.rodas.course.h;
        let laying = Laying::Watched(&self.rodas.here.light, &self.laid);
        let point = Point { a: &self.rate.v, laying, ..Point::of(state, &self.point, elapsed) };
        self.probe.forces(system, &point, &state.modes);
        self.book_point(system, state, duration);
    }

    /// The same where the rows have been looked at and nothing else.
    pub(super) fn book_seen(&mut self, system: &System, state: &State, theta: f64, duration: f64) {
        self.rodas.course.at(theta, &mut self.point);
        self.rodas.course.rate_at(theta, &mut self.rate);
        let point = Point { a: &self.rate.v, ..Point::of(state, &self.point, theta * self.rodas.course.h) };
        self.probe.follow_rows(system, &point);
        self.book_point(system, state, duration);
    }

    /// What the flow integrals do not hold: energy that a row's law takes or gives at once with its value, by its
    /// difference over the step (`sign` −1 at the start, +1 at the end).
    ///
    /// Of a rope or contact that acts, T ė = k e ė + k τ ė², and k e ė is the spring's but where e < 0. One that is
    /// slack loses what its spring still held.
    pub(super) fn book_springs(&mut self, system: &System, state: &State, sign: f64) {
        let here = &self.rodas.here;
        for (row, law) in system.exerting_laws().iter().enumerate() {
            let (mode, value) = (state.modes[row], here.frame.value[row]);
            let lost = match (law, mode) {
                (_, Mode::Parted | Mode::Off) => 0.0,
                (Law::Unilateral { .. }, Mode::Acting) => spring_energy(law, -value),
                (Law::Unilateral { .. }, _) => -spring_energy(law, value),
                (Law::Spring { .. } | Law::Friction { .. } | Law::Brake { .. } | Law::Pin, _) => 0.0,
            };
            *loss_kind(system, &mut self.flows, row) += sign * lost;
        }
        for light in &system.light {
            for row in light.rows.clone().filter(|&row| state.modes[row] == Mode::Acting) {
                let (e, compliance) = (here.frame.value[row], system.rows.laws[row].compliance());
                self.flows.friction -= sign * 0.5 * e * e / compliance;
            }
        }
    }

    /// What springs hold [J]. A contact that opens lets go what its tangential springs still hold, and its damper
    /// takes it.
    pub(super) fn held(&self, system: &System, state: &State) -> f64 {
        elastic_energy(system, &self.rodas.here.frame.value, &state.modes)
    }

    fn book_point(&mut self, system: &System, state: &State, duration: f64) {
        // What follows is light: its velocity is that of the point, not of the course.
        self.point.v.copy_from_slice(&self.probe.v);
        self.book_motions(system, duration);
        self.book_rows(system, state, duration);
        self.book_slides(system, state, duration);
        self.take_defect(system, state);
        self.book_defect(system, state, duration);
        self.look_at_coils(system, duration);
    }

    /// What drives, joints and forces on bodies give and take, and what the velocity's defect works.
    fn book_motions(&mut self, system: &System, duration: f64) {
        let (probe, ledger) = (&self.probe, &mut self.flows);
        for (dof, velocity) in self.point.v.iter().enumerate() {
            let work = duration * probe.imbalance[dof] * velocity;
            if let Some(drive) = system.driven[dof] {
                *ledger.work_of(&system.drives[drive]) += work;
            } else if system.is_light[dof] {
                ledger.friction -= work;
            } else {
                ledger.method -= work;
            }
            ledger.joint_damping += duration * system.tree.damping[dof] * velocity * velocity;
        }
        for force in &system.tree.forces {
            let at = probe.dynamics.at(&system.tree, &probe.frame.kinematics, force.body());
            let [lost, given] = force.powers(&at).map(|power| duration * power);
            if matches!(force, AnyForce::Mooring(_)) {
                ledger.rope_damping += lost;
            } else {
                ledger.drag += lost;
            }
            ledger.fluid_work += given;
        }
    }

    /// What the dampers of rows take, what slips over brakes, and what the coils of drums hold and lose.
    fn book_rows(&mut self, system: &System, state: &State, duration: f64) {
        let (probe, ledger) = (&self.probe, &mut self.flows);
        for (row, law) in system.exerting_laws().iter().enumerate() {
            let compliance = law.compliance();
            let (rate, tension) = (probe.rate[row], probe.tension[row]);
            if state.modes[row].is_absent() {
                continue;
            }
            if compliance == 0.0 {
                // A brake that slips; else a velocity along the rope is a defect of the method.
                let slips = state.modes[row] == Mode::Slipping;
                *(if slips { &mut ledger.friction } else { &mut ledger.method }) += duration * tension * rate;
                ledger.drive_work -= duration * tension * probe.asked[row];
                continue;
            }
            if state.modes[row] == Mode::Acting {
                *loss_kind(system, ledger, row) += duration * law.damping_time() / compliance * rate * rate;
            }
        }
        for (index, place) in system.coils.iter().enumerate() {
            let flow = probe.frame.coil_flow(system, index, self.point.v[place.dof]);
            ledger.friction += duration * flow.friction;
            // What the coils then come to hold is taken off again: see [`crate::stepper::coils::remember`].
            ledger.method += duration * flow.held;
        }
    }

    /// Where a contact slides, its anchor takes T α̇ and what is left of the motion stretches spring and damper, all of it
    /// with the anchor's course: its law, over a damping time of microseconds, makes metres per second of what the
    /// tolerance lets a force be wrong by. What the damper's force then lacks is the method's.
    fn book_slides(&mut self, system: &System, state: &State, duration: f64) {
        let (probe, ledger) = (&self.probe, &mut self.flows);
        let anchors = probe.anchor_rate.iter().zip(&self.rate.anchor);
        for ((asked, course), &row) in anchors.zip(&system.friction) {
            if state.modes[row] == Mode::Slipping {
                let (law, stretch) = (&system.rows.laws[row], probe.rate[row] - course);
                let damping = duration * law.damping_time() / law.compliance();
                ledger.friction += duration * probe.tension[row] * course;
                ledger.contact_damping += damping * stretch * stretch;
                ledger.method += damping * (course - asked) * stretch;
            }
        }
    }

    /// The position's own defect as motions of joints, bodies and rows: as if the bodies moved with it.
    fn take_defect(&mut self, system: &System, state: &State) {
        let probe = &mut self.probe;
        for (defect, phi_rate) in self.rate.phi.iter_mut().zip(&probe.phi_rate) {
            *defect -= phi_rate;
        }
        for &first in &probe.rotations {
            let range = first..first + 3;
            let [phi, rate] =
                [&self.point.phi, &self.rate.phi].map(|all| DVec3::from_slice(&all[range.clone()]));
            self.rate.phi[range].copy_from_slice(&turn_of_rate(phi, rate).to_array());
        }
        for &dof in system.light.iter().flat_map(|light| &light.dofs) {
            self.rate.phi[dof] = 0.0;
        }
        coils::follow(system, &state.coils, &probe.frame.feeding, &mut self.rate.phi);
        probe.frame.kinematics.twists(&system.tree, &self.rate.phi, &mut self.defect);
        probe.rates(system, &self.defect, &self.rate.phi, &mut self.rows);
    }

    /// What that defect works against inertia, gravity and springs.
    fn book_defect(&mut self, system: &System, state: &State, duration: f64) {
        let (probe, ledger) = (&self.probe, &mut self.flows);
        let twists = (probe.dynamics.twists.as_slice(), self.defect.as_slice());
        let mut power = drift::power(&system.tree, &probe.frame.kinematics, twists, &mut self.changes);
        for (row, law) in system.exerting_laws().iter().enumerate() {
            if state.modes[row].is_absent() {
                continue;
            }
            // What a row takes or gives at once with its value counts by differences, see [`Adaptive::book_springs`]:
            // with them one that acts is a spring either way, and one that is slack none.
            let stretch = match (law, state.modes[row]) {
                (Law::Brake { .. } | Law::Pin, _) | (_, Mode::Slack) => 0.0,
                (Law::Unilateral { .. } | Law::Spring { .. } | Law::Friction { .. }, _) => {
                    probe.frame.value[row]
                }
            };
            if law.compliance() > 0.0 {
                power += self.rows[row] * stretch / law.compliance();
            }
        }
        // Springs over light sheaves hold at the end what the way there has left them, not what each rate has
        // added: the rest is friction, see [`Adaptive::book_springs`].
        for light in &system.light {
            for row in light.rows.clone().filter(|&row| state.modes[row] == Mode::Acting) {
                let (e, compliance) = (probe.frame.value[row], system.rows.laws[row].compliance());
                let gained = e * (probe.rate[row] + self.rows[row]);
                ledger.friction += duration * gained / compliance;
            }
        }
        for ((body, twist), lever) in
            system.tree.bodies.iter().zip(&self.defect).zip(&probe.frame.kinematics.lever)
        {
            power -= body.mass * system.tree.gravity.dot(twist.at(*lever));
        }
        for force in &system.tree.forces {
            let body = force.body();
            let at = probe.dynamics.at(&system.tree, &probe.frame.kinematics, body);
            power += force.energy_rate(&At { twist: self.defect[body], v: &self.rate.phi, ..at });
        }
        ledger.method -= duration * power;
    }
}
