//! Drums: how much rope they let go, and what they remember of the rope that they wind.
//!
//! A drum turns by v, so that wound rope goes over its rim at r v, r with the layer. What has the strain ε_d there is
//! shorter unstretched, and the span gets
//!
//! ```text
//! L̇ = r v/(1 + ε_d)        ε_d = ε of the span while it winds, the strain that was wound while it pays out
//! ```
//!
//! L is no function of how far the drum has turned, but of what the rope bore while it was wound: it is a coordinate of
//! its own, at the end of q, whose rate follows from the velocity of the flow ("feeding" is ∂L̇/∂v). Wound rope keeps
//! its energy EA ε_d²/2 per unstretched length. The rim sees the tension T and no more. The row gives T (1 + ε/2) r/(1 +
//! ε_d) of it, and the rest is
//!
//! ```text
//! X = EA (ε ε_d − ε²/2) r/(1 + ε_d)
//! ```
//!
//! Where rope comes off with another strain than the span has it slips on the drum until it fits, and loses
//! EA (ε − ε_d)²/2 per unstretched length to friction.

use super::frame::{Frame, Remembered};
use crate::constraint::AnyConstraint;
use crate::constraint::rope::span::Span;
use crate::rope::coil::Coil;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::{CoilPlace, System};

/// Less wound rope than this [m] has the strain of the rope outside.
const LEAST: f64 = 1e-12;

/// Where a drum will go is seen so much ahead [s].
const AHEAD: f64 = 1e-3;

/// What passes a drum.
#[derive(Debug, Clone, Copy, Default)]
pub struct Passing {
    /// Strain of the rope outside.
    pub outside: f64,
    /// Strain of what passes, ε_d.
    pub strain: f64,
    /// ∂g/∂L of the span.
    pub supply: f64,
}

/// What flows at a drum per time [W].
#[derive(Debug, Clone, Copy, Default)]
pub struct CoilFlow {
    /// Into what the wound rope holds.
    pub held: f64,
    /// Lost by slipping on the drum.
    pub friction: f64,
}

/// Strain of what passes a drum, and unstretched rope that it lets go per way of its flow, where the rope outside is
/// strained by `outside`.
pub fn feeding(place: &CoilPlace, coil: &Coil, q: &[f64], outside: f64) -> (f64, f64) {
    let passing = coil.passing(place.wound(q), outside);
    (passing, place.rate_at(q) / (1.0 + passing))
}

/// The span that a drum feeds.
pub fn span_of<'a>(system: &'a System, place: &CoilPlace) -> Option<&'a Span> {
    match &system.constraints[place.rope] {
        AnyConstraint::Rope(rope) => rope.spans.get(place.span),
        _ => None,
    }
}

impl Frame {
    /// What passes the drums at the configuration `q`, where the rows have their values.
    pub fn pass(&mut self, system: &System, q: &[f64], by: &Remembered) {
        for (index, (place, coil)) in system.coils.iter().zip(by.coils).enumerate() {
            let Some(span) = span_of(system, place) else { continue };
            let (unstretched, scale) = (span.unstretched(q), span.scale(q));
            let strain = self.value[place.row] / (scale * unstretched);
            let mode = by.modes[place.row];
            let strained = mode.carries() || (coil.is_stretched && mode == Mode::Slack);
            let outside = if strained { strain.max(0.0) } else { 0.0 };
            let (passing, feeding) = feeding(place, coil, q, outside);
            self.passing[index] = Passing { outside, strain: passing, supply: -scale * (1.0 + 0.5 * strain) };
            // A drum on which a parted rope ends goes on, and takes nothing from what is left between guides. A sling that
            // is not on gets longer and shorter by its chain hoist as one that is slack.
            self.feeding[index] = if mode == Mode::Parted { 0.0 } else { feeding };
        }
    }

    /// Adds to the gradients of the rows what drums feed, after [`Frame::pass`].
    pub fn add_feeding(&mut self, system: &System) {
        for ((place, passing), feeding) in system.coils.iter().zip(&self.passing).zip(&self.feeding) {
            self.gradient[place.entry] += passing.supply * feeding;
        }
    }

    /// X of the coil `index` [N].
    pub fn coil_force(&self, system: &System, index: usize) -> f64 {
        let Passing { outside, strain, .. } = self.passing[index];
        system.coils[index].stiffness * outside * (strain - 0.5 * outside) * self.feeding[index]
    }

    /// What flows at the coil `index` with the velocity `v` of its drum.
    pub fn coil_flow(&self, system: &System, index: usize, v: f64) -> CoilFlow {
        let Passing { outside, strain, .. } = self.passing[index];
        let let_go = system.coils[index].stiffness * self.feeding[index] * v;
        let apart = outside - strain;
        CoilFlow { held: -0.5 * let_go * strain * strain, friction: 0.5 * let_go * apart * apart }
    }
}

/// How the rows of spans on drums, and their supplies, follow the motion in a stage of [`super::adaptive`].
///
/// With κ = γh, x the rate of the increments, d what is known of the supply's rate beside that of the flow, and Z the
/// supplies' increment at a span,
///
/// ```text
/// Z/κ = (Σ (feeding + κ turn) x_f + d + (B/κ) (n·φ − (1 + ε) S)/L)/(1 + B (1 + ε)/L)        B = κ Σ ∂L̇/∂ε
/// ```
///
/// `turn` being ∂L̇/∂s where the layer changes, n·φ what moves the ends of the span, S what sheaves feed.
#[derive(Debug, Clone, Default)]
pub struct CoilTangent {
    /// ∂L̇/∂ε and ∂L̇/∂s of every coil.
    slopes: Vec<[f64; 2]>,
    /// L, w and 1 + ε of its span.
    spans: Vec<[f64; 3]>,
    /// B of its span, and 1 + B (1 + ε)/L.
    feedback: Vec<[f64; 2]>,
}

impl CoilTangent {
    /// At the start of a step.
    pub fn linearise(&mut self, system: &System, frame: &Frame, state: &State) {
        let (slopes, spans) = (&mut self.slopes, &mut self.spans);
        slopes.clear();
        spans.clear();
        for (index, (place, coil)) in system.coils.iter().zip(&state.coils).enumerate() {
            let Passing { outside, strain, .. } = frame.passing[index];
            // What a rope has that has parted does not change with what its drum turns.
            let v = if state.modes[place.row] == Mode::Parted { 0.0 } else { state.v[place.dof] };
            let by_strain =
                if coil.winds && outside > 0.0 { -frame.feeding[index] * v / (1.0 + strain) } else { 0.0 };
            slopes.push([by_strain, place.rate_slope(&state.q) * v / (1.0 + strain)]);
            let span = span_of(system, place);
            let [unstretched, scale] =
                span.map_or([1.0; 2], |span| [span.unstretched(&state.q), span.scale(&state.q)]);
            spans.push([unstretched, scale, 1.0 + frame.value[place.row] / (scale * unstretched)]);
        }
        self.feedback.resize(slopes.len(), [0.0, 1.0]);
    }

    /// For a step of κ = `kappa` [s]: what it does to the rows, of which `turned` holds what κP applies to.
    pub fn turn_rows(&mut self, system: &System, frame: &Frame, (kappa, turned): (f64, &mut [f64])) {
        for (index, place) in system.coils.iter().enumerate() {
            let others = system.coils.iter().zip(&self.slopes).filter(|(other, _)| other.row == place.row);
            let b = kappa * others.map(|(_, slopes)| slopes[0]).sum::<f64>();
            let [unstretched, _, stretched] = self.spans[index];
            self.feedback[index] = [b, 1.0 + b * stretched / unstretched];
        }
        for (index, place) in system.coils.iter().enumerate() {
            let tau = system.rows.laws[place.row].damping_time();
            let whole = (kappa + tau) / kappa;
            let [b, rest] = self.feedback[index];
            let [unstretched, scale, stretched] = self.spans[index];
            let supply = frame.passing[index].supply;
            let own = supply * frame.feeding[index];
            turned[place.entry] +=
                whole * (own * (1.0 / rest - 1.0) + kappa * supply * self.slopes[index][1] / rest);
            let is_first = system.coils[..index].iter().all(|other| other.row != place.row);
            if b == 0.0 || !is_first {
                continue;
            }
            let feedback = whole * b / (unstretched * rest);
            for entry in system.rows.start[place.row]..system.rows.start[place.row + 1] {
                let dof = system.rows.dofs[entry];
                if system.coils.iter().any(|coil| coil.entry == entry) {
                    continue;
                }
                let is_flow = system.flows.binary_search(&dof).is_ok();
                let share = if is_flow { -stretched } else { supply / scale };
                turned[entry] += feedback * share * frame.gradient[entry];
            }
        }
    }

    /// What is known of the supplies' rates, `beside` for every coil that of their flows, on the right side of a row that
    /// acts.
    pub fn known(&self, system: &System, frame: &Frame, index: usize, (kappa, beside): (f64, f64)) -> f64 {
        let tau = system.rows.laws[system.coils[index].row].damping_time();
        frame.passing[index].supply * beside * (1.0 / self.feedback[index][1] - tau / (kappa + tau))
    }

    /// Increments of the supplies in a stage, at the end of `phi`, with those of the flows' velocities `v` and r.
    pub fn increments(
        &self,
        system: &System,
        frame: &Frame,
        kappa: f64,
        (phi, v, r): (&mut [f64], &[f64], &[f64]),
    ) {
        let first = v.len();
        for (index, place) in system.coils.iter().enumerate() {
            phi[first + index] = kappa
                * (r[first + index]
                    + frame.feeding[index] * v[place.dof]
                    + self.slopes[index][1] * phi[place.dof]);
        }
        for (index, place) in system.coils.iter().enumerate() {
            let [b, rest] = self.feedback[index];
            let is_first = system.coils[..index].iter().all(|other| other.row != place.row);
            if b == 0.0 || !is_first {
                continue;
            }
            let [unstretched, scale, stretched] = self.spans[index];
            let (mut moved, mut fed) = (0.0, 0.0);
            for (entry, dof) in (system.rows.start[place.row]..)
                .zip(&system.rows.dofs[system.rows.start[place.row]..system.rows.start[place.row + 1]])
            {
                let change = frame.gradient[entry] * phi[*dof];
                if system.coils.iter().any(|coil| coil.entry == entry) {
                    continue;
                }
                if system.flows.binary_search(dof).is_ok() { fed += change } else { moved += change }
            }
            let same = || system.coils.iter().enumerate().filter(|(_, other)| other.row == place.row);
            let without: f64 = same().map(|(other, _)| phi[first + other]).sum();
            let fed = fed / frame.passing[index].supply;
            let stretch = moved / scale - stretched * fed;
            let strain = (stretch - stretched * without) / (unstretched * rest);
            for (other, _) in same() {
                phi[first + other] += kappa * self.slopes[other][0] * strain;
            }
        }
    }
}

/// Lets drums wind that haul in, and pay out that let go; true where any has turned round. Those that stand go where
/// they are accelerated to.
pub fn turn(system: &System, state: &mut State) -> bool {
    let mut any = false;
    for (place, coil) in system.coils.iter().zip(&mut state.coils) {
        let (v, a) = (state.v[place.dof], state.acceleration[place.dof]);
        let mut goes = if v == 0.0 { a } else { v };
        if goes == 0.0 {
            // A smooth ramp begins without acceleration.
            let drive = system.drives.iter().position(|drive| drive.dof == place.dof);
            let timeline = drive.map(|drive| &state.plan.timelines[drive]);
            goes = timeline.map_or(0.0, |timeline| timeline.motion(state.time + AHEAD).velocity);
        }
        goes *= place.rate;
        let winds = if goes == 0.0 { coil.winds } else { goes < 0.0 };
        any |= winds != coil.winds;
        coil.winds = winds;
    }
    any
}

/// Puts the supplies of drums that pay out where they belong in the configuration `q`: what comes off is known, and the
/// supply a function of how far the drum has turned. Of a rope that has parted nothing comes.
pub fn place(system: &System, coils: &[Coil], modes: &[Mode], q: &mut [f64]) {
    for (place, coil) in system.coils.iter().zip(coils).filter(|(_, coil)| !coil.winds) {
        if modes[place.row] != Mode::Parted {
            q[place.supply] = coil.let_go_at(place.wound(q));
        }
    }
}

/// The increments of those supplies that belong to increments of the flows.
pub fn follow(system: &System, coils: &[Coil], feeding: &[f64], increments: &mut [f64]) {
    for (index, (place, _)) in system.coils.iter().zip(coils).enumerate().filter(|(_, (_, coil))| !coil.winds)
    {
        increments[system.tree.velocities + index] = feeding[index] * increments[place.dof];
    }
}

/// Lets all coils remember what they have wound since they last did. The energy of wound rope grows by that, and what
/// has flowed into it and is not there is the method's loss: strains that were averaged.
///
/// Where the rope has parted its free end goes on to the drum, without strain, and what was wound before slips as it
/// comes off, until it has none.
pub fn remember(system: &System, state: &mut State, frame: &Frame) {
    place(system, &state.coils, &state.modes, &mut state.q);
    let mut gained = 0.0;
    for (index, (place, coil)) in system.coils.iter().zip(&mut state.coils).enumerate() {
        let wound = place.wound(&state.q);
        if state.modes[place.row] == Mode::Parted {
            let held = place.stiffness * coil.bring_to(wound, 0.0);
            state.ledger.wound += held;
            state.ledger.flows.friction -= held;
            continue;
        }
        let taken = coil.let_go - state.q[place.supply];
        let more = wound - coil.wound;
        let strain = if more > LEAST && taken > 0.0 {
            (more / taken - 1.0).max(0.0)
        } else {
            frame.passing[index].strain
        };
        coil.let_go = state.q[place.supply];
        coil.is_stretched = frame.value[place.row] > 0.0;
        gained += place.stiffness * coil.bring_to(wound, strain);
    }
    state.ledger.wound += gained;
    state.ledger.flows.method -= gained;
}

/// Moves the supplies in a step of fixed length `h` [s] with the velocities `v` from where `frame` is, with the books of
/// what flows at the drums.
pub fn supply(system: &System, state: &mut State, frame: &Frame, v: &[f64], h: f64) {
    for (index, place) in system.coils.iter().enumerate() {
        let flow = frame.coil_flow(system, index, v[place.dof]);
        state.ledger.flows.friction += h * flow.friction;
        state.ledger.flows.method += h * flow.held;
        state.q[place.supply] += h * frame.feeding[index] * v[place.dof];
    }
}
