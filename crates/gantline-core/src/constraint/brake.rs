//! Friction that holds a flow, a hinge or a slider: of a sheave's bearing and groove, of a drum's brake, of a pin.
//!
//! A motor of limited force holds its flow at the speed that its drive asks for, and where the force is not enough the
//! flow slips against it: the same law, in the frame of the drive.
//!
//! The force on the flow is at most `capacity` + `share` (T₁ + T₂), T₁ and T₂ the tensions on both sides of a sheave. While
//! that is enough the flow is held: no creep, and the force is what it takes. Where it is not, the flow slips against
//! the whole of it. With share = (ρ − 1)/(ρ + 1) tensions that slip steadily are as T₁/T₂ = ρ, in either direction.
//! A groove holds ρ = e^{μθ}, share = tanh(μθ/2), as the wrap θ is now, and it holds the rope to the sheave: where that
//! turns, against its spin.

use glam::DVec3;

use super::rope::span::Span;
use super::{Constraint, Law, Line, Moving, Placed};
use crate::rope::route::Route;
use crate::rope::seat::Seat;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};

/// Friction on a flow.
#[derive(Debug, Clone)]
pub struct Brake {
    /// Name of the flow or of the joint's body.
    pub name: String,
    /// Its degree of freedom.
    pub dof: usize,
    /// The spin of the sheave to which a groove holds the flow; none is held to what does not turn.
    pub spin: Option<usize>,
    /// Largest force without any tension [N].
    pub capacity: f64,
    /// What the tensions on both sides add to it.
    pub grip: Grip,
    /// Spans that a flow feeds, one or two, with their rows. The entries of their feeds are those of this row.
    pub spans: Vec<(usize, Span)>,
    /// What a velocity of the flow does to the tensions on both sides [N s/m].
    pub impedance: f64,
    /// Largest power of a motor [W].
    pub power: f64,
    dofs: Vec<usize>,
    /// Entry of its own flow.
    pub own: usize,
    /// Entry of the spin.
    other: Option<usize>,
}

/// Share of the sum of both tensions that holds a flow.
#[derive(Debug, Clone)]
pub enum Grip {
    /// The same always: of a bearing, or of half a turn in a groove.
    Share(f64),
    /// Of a groove with the wrap as it is.
    Groove {
        /// Coefficient of friction.
        friction: f64,
        /// Way of the rope.
        route: Route,
        /// The sheave among its guides.
        place: usize,
    },
}

impl Grip {
    /// The share with the poses as they are; that of a groove without a tangent is no number.
    fn share(&self, kinematics: &Kinematics, seats: &[Seat]) -> f64 {
        match self {
            Self::Share(share) => *share,
            Self::Groove { friction, route, place } => {
                let wound = route.wound(*place, kinematics, seats);
                (0.5 * friction * wound.map_or(f64::NAN, |wound| wound.wrap.max(0.0))).tanh()
            }
        }
    }

    /// True where no tension holds anything.
    pub fn is_none(&self) -> bool {
        matches!(self, Self::Share(0.0)) || matches!(self, Self::Groove { friction: 0.0, .. })
    }
}

/// Where a brake is evaluated.
#[derive(Clone, Copy)]
pub struct At<'a> {
    /// Configuration.
    pub q: &'a [f64],
    /// Poses there.
    pub kinematics: &'a Kinematics,
    /// How ropes lie on their sheaves.
    pub seats: &'a [Seat],
}

/// (ρ − 1)/(ρ + 1) of the ratio ρ ≥ 1 of the tensions on both sides of a slipping sheave.
pub fn share_of_ratio(ratio: f64) -> f64 {
    (ratio - 1.0) / (ratio + 1.0)
}

impl Brake {
    /// A brake on the flow `dof`, against a `spin` where there is one, of a given `capacity` [N], `impedance` [N s/m]
    /// and, of a motor, `power` [W].
    pub fn new(
        name: String,
        (dof, spin): (usize, Option<usize>),
        [capacity, impedance, power]: [f64; 3],
        grip: Grip,
        mut spans: Vec<(usize, Span)>,
    ) -> Self {
        let fed = spans.iter().flat_map(|(_, span)| span.feeds.iter().map(|feed| feed.dof));
        let mut dofs: Vec<usize> = fed.chain([dof]).chain(spin).collect();
        dofs.sort_unstable();
        dofs.dedup();
        let entry = |dof: usize| dofs.partition_point(|&other| other < dof);
        for feed in spans.iter_mut().flat_map(|(_, span)| &mut span.feeds) {
            feed.entry = entry(feed.dof);
        }
        let (own, other) = (entry(dof), spin.map(entry));
        Self { name, dof, spin, capacity, grip, spans, impedance, power, own, other, dofs }
    }

    /// Motion of the flow, against the spin where there is one, of velocities or accelerations.
    pub fn along(&self, motion: &[f64]) -> f64 {
        motion[self.dof] - self.spin.map_or(0.0, |spin| motion[spin])
    }

    /// Largest force [N], with the forces `force` of all rows; `driven` is the speed [m/s] at which a motor drives the
    /// flow, negative where the flow drives it.
    pub fn bound(&self, at: At, force: &[f64], driven: f64) -> f64 {
        let tensions = self.spans.iter().map(|(row, span)| span.scale(at.q) * force[*row].max(0.0));
        self.motor(driven) + self.grip.share(at.kinematics, at.seats) * tensions.sum::<f64>()
    }

    /// ρ of a bearing: (1 + share)/(1 − share).
    pub fn ratio(&self) -> f64 {
        match self.grip {
            Grip::Share(share) => (1.0 + share) / (1.0 - share),
            Grip::Groove { .. } => f64::NAN,
        }
    }

    /// Capacity, or what the power of a motor is enough for.
    pub fn motor(&self, driven: f64) -> f64 {
        if self.is_short_of_power(driven) { self.power / driven } else { self.capacity }
    }

    fn is_short_of_power(&self, driven: f64) -> bool {
        driven * self.capacity > self.power
    }

    /// How the bound answers to the speed at which a motor drives [N s/m].
    pub fn slope(&self, driven: f64) -> f64 {
        if self.is_short_of_power(driven) { -self.power / (driven * driven) } else { 0.0 }
    }

    /// How the bound answers to the force of a row.
    pub fn weight(&self, at: At, row: usize) -> f64 {
        let span = self.spans.iter().find(|(other, _)| *other == row);
        span.map_or(0.0, |(_, span)| self.grip.share(at.kinematics, at.seats) * span.scale(at.q))
    }

    /// How the bound answers to the flows, by entry of the row: they change the lengths of the spans, ∂w/∂L = −w/2L.
    /// What a change of the wrap does to that of a groove is left to the stages of a step, which evaluate it.
    pub fn add_slopes(&self, at: At, feeding: &[f64], force: &[f64], mut add: impl FnMut(usize, f64)) {
        let share = self.grip.share(at.kinematics, at.seats);
        for (row, span) in &self.spans {
            let slope = -0.5 * share * force[*row].max(0.0) * span.scale(at.q) / span.unstretched(at.q);
            for feed in &span.feeds {
                add(feed.entry, slope * feed.speed_rate(feeding));
            }
        }
    }
}

impl Constraint for Brake {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        vec![self.dofs.clone()]
    }

    fn laws(&self, _first_row: usize) -> Vec<Law> {
        let row = |side: Option<&(usize, Span)>| side.map(|side| side.0);
        let rows = [row(self.spans.first()), row(self.spans.get(1))];
        vec![Law::Brake { rows, impedance: self.impedance }]
    }

    fn lines(&self) -> usize {
        0
    }

    fn locate(&self, at: &Moving, value: &mut [f64], rate: &mut [f64], _lines: &mut [Line]) {
        value[0] = 0.0;
        rate[0] = self.along(at.v);
    }

    fn rates(&self, _twists: &[Twist], v: &[f64], _lines: &[Line], rate: &mut [f64]) {
        rate[0] = self.along(v);
    }

    fn apply(&self, _tension: &[f64], _lines: &[Line], _wrenches: &mut [Wrench]) {}

    fn feed(&self, tension: &[f64], _lines: &[Line], force: &mut [f64]) {
        force[self.dof] += tension[0];
        if let Some(spin) = self.spin {
            force[spin] -= tension[0];
        }
    }

    fn evaluate(&self, _at: &Placed, value: &mut [f64], gradient: &mut [f64]) {
        value[0] = 0.0;
        gradient.fill(0.0);
        gradient[self.own] = 1.0;
        if let Some(other) = self.other {
            gradient[other] = -1.0;
        }
    }

    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)> {
        Vec::new()
    }

    fn curvature(&self, _: &Placed, _: f64, _: usize, _: &mut [DVec3], _: &mut [f64]) {}
}
