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
use crate::state::State;
use crate::system::{CoilPlace, System};

/// Less wound rope than this [m] has the strain of the rope outside.
const LEAST: f64 = 1e-12;

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

fn span_of<'a>(system: &'a System, place: &CoilPlace) -> Option<&'a Span> {
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
            let outside = if by.modes[place.row].carries() { strain.max(0.0) } else { 0.0 };
            let passing = coil.passing(place.wound(q), outside);
            self.passing[index] =
                Passing { outside, strain: passing, supply: -scale * (1.0 + 0.5 * strain) };
            self.feeding[index] = place.rate_at(q) / (1.0 + passing);
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

/// Lets drums wind that haul in, and pay out that let go; true where any has turned round. Those that stand go where
/// they are accelerated to.
pub fn turn(system: &System, state: &mut State) -> bool {
    let mut any = false;
    for (place, coil) in system.coils.iter().zip(&mut state.coils) {
        let (v, a) = (state.v[place.dof], state.acceleration[place.dof]);
        let goes = place.rate * if v == 0.0 { a } else { v };
        let winds = if goes == 0.0 { coil.winds } else { goes < 0.0 };
        any |= winds != coil.winds;
        coil.winds = winds;
    }
    any
}

/// Lets all coils remember what they have wound since they last did. The energy of wound rope grows by that, and what
/// has flowed into it and is not there is the method's loss: strains that were averaged.
pub fn remember(system: &System, state: &mut State, frame: &Frame) {
    let mut gained = 0.0;
    for (index, (place, coil)) in system.coils.iter().zip(&mut state.coils).enumerate() {
        let wound = place.wound(&state.q);
        let taken = coil.let_go - state.q[place.supply];
        let more = wound - coil.wound;
        let strain = if more > LEAST && taken > 0.0 {
            (more / taken - 1.0).max(0.0)
        } else {
            frame.passing[index].strain
        };
        coil.let_go = state.q[place.supply];
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
