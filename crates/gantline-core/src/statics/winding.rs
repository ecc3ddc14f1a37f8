//! Drums that turn from one equilibrium to the next.
//!
//! What a drum has let go depends on the strain ε of what it wound, so on the way there. A lift that is followed from
//! rest to rest in parts winds in each
//!
//! ```text
//! ΔL = −ΔW (1/(1 + ε₀) + 1/(1 + ε₁))/2
//! ```
//!
//! of unstretched rope, W what is wound, ε₀ and ε₁ the strains of the rope outside at both ends of the part, of which the
//! second is found together with the equilibrium there. Rope that is slack at one end goes taut where a straight line
//! between both strains does, the slack one being negative. Where it pays out, what comes off is known. The error is of
//! second order in the change of the strain; |ΔW (1/(1 + ε₁) − 1/(1 + ε₀))| says how short a part has to be.

use super::bearing::{Part, capacity};
use super::friction::wrong;
use super::losses::Losses;
use super::search::{BALANCED, Stuck};
use super::{NoEquilibrium, Rest, Statics};
use crate::constraint::AnyConstraint;
use crate::rope::coil::Coil;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::coils::span_of;
use crate::stepper::flows;
use crate::stepper::frame::{Frame, Remembered};
use crate::system::{CoilPlace, DriveJoint, System};

/// Equilibria that one part may take.
const ROUNDS: usize = 30;
/// What is left in the end of the error of unstretched rope [m].
const LEFT: f64 = 1e-9;
/// Less wound rope than this is none [m].
const LEAST: f64 = 1e-12;
/// How much more than it has let go a motor that keeps its pull asks for [m].
const MORE: f64 = 1e3;
/// So far from where a drum gets stuck lies the piece to which it gives way [m].
const JOINT: f64 = 1e-6;
/// Rope that came on last is not told from what lies below where it is no longer than this [m]: a brake that holds lets
/// through some rounding, and where a drum is held at the joint of two pieces its torque has no one value there.
const THIN: f64 = 1e-9;

/// Where every drive is at the time of `state`, if nothing has slipped.
pub fn asked(system: &System, state: &State) -> Vec<f64> {
    let timelines = state.plan.timelines.iter().take(system.drives.len());
    timelines.map(|timeline| timeline.asked(state.time)).collect()
}

/// The rope on drums was wound with the strain that it has now, or under what was given. What a motor or brake that gave
/// way has let go on the way there stays outside.
pub fn lay(system: &System, state: &mut State, frame: &Frame) {
    for ((coil, place), passing) in state.coils.iter_mut().zip(&system.coils).zip(&frame.passing) {
        coil.laid = place.laid_under.map_or(passing.outside, |tension| tension / place.stiffness);
        coil.bring_to(place.wound(&state.q), coil.laid);
        coil.let_go = state.q[place.supply];
    }
}

/// What drums had wound at the last equilibrium, and the strains of the rope outside.
struct Before {
    coils: Vec<Coil>,
    strains: Vec<f64>,
}

impl Statics {
    /// `state` is where a lift has got to by other means: drives stand where it has them.
    pub fn resume(&mut self, system: &System, state: &State) {
        self.begin(system, state);
        self.bearings.clear();
        self.is_found = false;
        let positions = system.drives.iter().map(|drive| system.tree.bodies[drive.body].first_position);
        self.places = positions.map(|position| state.q[position]).collect();
    }

    /// Motors hold where their drives are, or where they have been dragged to. Those that keep their pull ask for far more,
    /// so that they pull all they can, unless their rope has parted.
    pub(super) fn hold_motors(&mut self, system: &System, state: &State) {
        for &(row, drive) in &system.motors {
            if let Some(held) = &mut self.bearings[row].held {
                held.place = self.places[drive];
                let DriveJoint { dof, keeps_pull, .. } = system.drives[drive];
                let mut drums = system.coils.iter().filter(|place| place.dof == dof);
                let velocity = state.plan.timelines[drive].final_velocity();
                if keeps_pull && velocity != 0.0 && drums.any(|place| !state.modes[place.row].is_absent()) {
                    held.place += MORE.copysign(velocity);
                }
            }
        }
    }

    /// What was more than a motor could hold at the last equilibrium has dragged it along. Until it is asked for more it
    /// goes on pulling all it can: a winch of constant tension does not hold, it slips.
    fn drag_motors(&mut self, system: &System, state: &State) {
        for &(row, drive) in system.motors.iter().filter(|_| self.is_found) {
            if !self.search.here.follows[row] {
                self.places[drive] = state.q[system.tree.bodies[system.drives[drive].body].first_position];
            }
        }
    }

    /// Drums give way where their rims see what motors and brakes can hold: ρ T, of which the gradients of rows have
    /// T (1 + ε/2) ρ/(1 + ε_d). The largest change, relative to what they hold, of those that do not hold well within it, behind its row.
    /// That jumps at the joint of two pieces of rope, where a search gets no further if it began with what belongs to
    /// neither: the piece counts to which it gives way.
    pub(super) fn follow_drums(&mut self, system: &System, state: &State) -> (usize, f64) {
        let here = &self.search.here;
        let mut most = (0, 0.0_f64);
        for (row, bearing) in self.bearings.iter_mut().enumerate() {
            let (AnyConstraint::Brake(brake), Part::Hold(known)) =
                (system.constraint_of_row(row), &mut bearing.part)
            else {
                continue;
            };
            if !brake.grip.is_none() || brake.capacity.is_infinite() {
                continue;
            }
            let coils = || system.coils.iter().enumerate().filter(|(_, place)| place.dof == brake.dof);
            let arm = |place: &CoilPlace| {
                span_of(system, place).map_or(1.0, |span| span.scale(&here.q)) * place.rate_at(&here.q)
            };
            let rim: f64 = coils().map(|(_, place)| here.tension[place.row] * arm(place)).sum();
            let whole = capacity(system, state, row, brake);
            // Where it pays out, in units of its flow, or hauls in.
            let gives = (rim.abs() - whole) * rim;
            let pulls = coils().map(|(index, place)| {
                let passing = &here.frame.passing[index];
                let strain = if here.imbalance(brake.dof) > BALANCED {
                    let beyond = place.wound(&here.q) + JOINT.copysign(-place.rate * gives);
                    state.coils[index].passing(beyond, passing.outside)
                } else {
                    passing.strain
                };
                -here.tension[place.row] * passing.supply * place.rate_at(&here.q) / (1.0 + strain)
            });
            let rows: f64 = pulls.sum();
            let wanted = if rim == 0.0 { whole } else { whole * rows / rim };
            let off = wrong(*known, wanted, here.tension[row]) / whole.max(f64::MIN_POSITIVE);
            if off > most.1 {
                most = (row, off);
            }
            *known = wanted;
        }
        most
    }

    /// Whether a search got stuck with a drum out of balance that stands at the joint of two pieces of its rope. Of one that
    /// lies within a piece the search is stuck by something else, and no other bound brings it further.
    pub(super) fn is_at_a_joint(&self, system: &System, state: &State, stuck: Stuck) -> bool {
        let here = &self.search.here;
        let is_out = |(index, place): (usize, &CoilPlace)| {
            let (wound, outside) = (place.wound(&here.q), here.frame.passing[index].outside);
            let [below, above] = [-JOINT, JOINT].map(|by| state.coils[index].passing(wound + by, outside));
            here.imbalance(place.dof) > BALANCED && below != above
        };
        matches!(stuck, Stuck::NoStep(_)) && system.coils.iter().enumerate().any(is_out)
    }

    /// From an equilibrium, or from where [`Statics::resume`] has been told, to the next one downhill of it, with drives
    /// as much further as their timelines say at the time of `state`; drums remember what they wind.
    ///
    /// # Errors
    /// [`NoEquilibrium`] as [`Statics::settle`].
    pub fn go_on(
        &mut self,
        system: &System,
        state: &mut State,
        losses: Losses,
    ) -> Result<Rest, NoEquilibrium> {
        self.follow(system, state, losses)?;
        self.rest(system, state)
    }

    /// The same, without asking what the equilibrium is like.
    ///
    /// # Errors
    /// [`NoEquilibrium`] as [`Statics::settle`].
    pub(super) fn follow(
        &mut self,
        system: &System,
        state: &mut State,
        losses: Losses,
    ) -> Result<(), NoEquilibrium> {
        self.drag_motors(system, state);
        let (last, stood) = (std::mem::take(&mut self.asked), std::mem::take(&mut self.places));
        self.begin(system, state);
        let before = self.before(system, state);
        for (index, drive) in system.drives.iter().enumerate().filter(|(_, drive)| drive.is_limited) {
            // A motor that was too weak goes on from where it is.
            let further = if drive.keeps_pull { 0.0 } else { self.asked[index] - last[index] };
            self.places[index] = stood[index] + further;
            state.q[system.tree.bodies[drive.body].first_position] = self.places[index];
        }
        flows::set_driven_calm(system, state);
        self.balance_and_wind(system, state, losses, &before)
    }

    /// From the equilibrium found last to that with other losses: drives ask for nothing more.
    ///
    /// # Errors
    /// [`NoEquilibrium`] as [`Statics::settle`].
    pub fn settle_again(
        &mut self,
        system: &System,
        state: &mut State,
        losses: Losses,
    ) -> Result<Rest, NoEquilibrium> {
        let before = self.before(system, state);
        self.balance_and_wind(system, state, losses, &before)?;
        self.rest(system, state)
    }

    fn balance_and_wind(
        &mut self,
        system: &System,
        state: &mut State,
        losses: Losses,
        before: &Before,
    ) -> Result<(), NoEquilibrium> {
        self.wind(system, state, before);
        self.balance(system, state, losses)?;
        for _ in 1..ROUNDS {
            if self.wind(system, state, before) <= LEFT {
                break;
            }
            self.balance(system, state, losses)?;
        }
        Ok(())
    }

    fn before(&mut self, system: &System, state: &mut State) -> Before {
        let frame = &mut self.search.here.frame;
        frame.kinematics.update(&system.tree, &state.q, 0.0);
        frame.rows(system, &state.q, &Remembered::of(state));
        for coil in &mut state.coils {
            coil.winds = false;
            coil.forget_last(THIN);
        }
        let strains = system.coils.iter().map(|place| strain(system, place, frame, state)).collect();
        Before { coils: state.coils.clone(), strains }
    }

    /// Lets drums remember what they have wound since `before`, the strains outside being those found last, and puts
    /// their supplies there; by how much the largest changes [m].
    fn wind(&mut self, system: &System, state: &mut State, before: &Before) -> f64 {
        let mut most = 0.0_f64;
        self.doubt = 0.0;
        let parted = |place: &CoilPlace| state.modes[place.row] == Mode::Parted;
        for (index, place) in system.coils.iter().enumerate().filter(|(_, place)| !parted(place)) {
            let old = &before.coils[index];
            let strains = [before.strains[index], strain(system, place, &self.search.here.frame, state)];
            let share = share(strains);
            let wound = place.wound(&state.q);
            let more = wound - old.wound;
            let let_go = if more > LEAST { old.let_go - more * share } else { old.let_go_at(wound) };
            let coil = &mut state.coils[index];
            coil.copy_from(old);
            coil.bring_to(wound, 1.0 / share - 1.0);
            coil.forget_last(THIN);
            coil.let_go = let_go;
            if more > LEAST {
                self.doubt = self.doubt.max(more * (strains[1].max(0.0) - strains[0].max(0.0)).abs());
            }
            let supply = &mut state.q[place.supply];
            most = most.max((let_go - *supply).abs());
            *supply = let_go;
        }
        most
    }
}

/// Strain of the rope outside a drum; negative where it is slack, by what it lacks.
fn strain(system: &System, place: &CoilPlace, frame: &Frame, state: &State) -> f64 {
    match span_of(system, place) {
        Some(span) if !state.modes[place.row].is_absent() => {
            frame.value[place.row] / (span.scale(&state.q) * span.unstretched(&state.q))
        }
        _ => 0.0,
    }
}

/// Unstretched length of wound rope whose strain goes from one to the other, where it is not negative.
fn share(strains: [f64; 2]) -> f64 {
    let taut = strains.map(|strain| strain.max(0.0));
    let ends = taut.map(|strain| 1.0 / (1.0 + strain));
    let slack = (taut[0] - strains[0]).max(taut[1] - strains[1]);
    let part = taut[0].max(taut[1]);
    let mean = 0.5 * (ends[0] + ends[1]);
    if slack > 0.0 { 1.0 - (1.0 - mean) * part / (part + slack) } else { mean }
}
