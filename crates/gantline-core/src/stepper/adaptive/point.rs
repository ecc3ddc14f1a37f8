//! Where in a step the equations are evaluated.

use super::Adaptive;
use super::course::Increment;
use super::light::Laying;
use crate::contact::spot::Spot;
use crate::plan::drive::Timeline;
use crate::rope::coil::Coil;
use crate::rope::seat::Seat;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::stepper::frame::Remembered;
use crate::system::System;

/// What drives ask for, and when: at `time` in a step that started at `from` [s].
#[derive(Clone, Copy)]
pub struct Schedule<'a> {
    /// Of all drives.
    pub timelines: &'a [Timeline],
    /// Start of the step [s].
    pub from: f64,
    /// Now [s].
    pub time: f64,
}

impl<'a> Schedule<'a> {
    /// At `elapsed` [s] after `state`, where a step starts.
    pub fn after(state: &'a State, elapsed: f64) -> Self {
        Self { timelines: &state.plan.timelines, from: state.time, time: state.time + elapsed }
    }
}

/// Where to evaluate.
pub struct Point<'a> {
    /// When.
    pub schedule: Schedule<'a>,
    /// q₀.
    pub base: &'a [f64],
    /// What rows remember.
    pub memory: &'a [f64],
    /// How ropes lie on their sheaves.
    pub seats: &'a [Seat],
    /// Where bodies may touch.
    pub spots: &'a [Spot],
    /// What drums have wound.
    pub coils: &'a [Coil],
    /// φ, with the supplies of drums.
    pub phi: &'a [f64],
    /// v.
    pub v: &'a [f64],
    /// v̇.
    pub a: &'a [f64],
    /// Tensions of inextensible ropes [N], by [`System::rigid`].
    pub rigid: &'a [f64],
    /// α, how far anchors have slid [m], by [`System::friction`].
    pub anchor: &'a [f64],
    /// What forces remember of the motion so far.
    pub past: &'a [f64],
    /// How rope is divided over light sheaves.
    pub laying: Laying<'a>,
}

impl<'a> Point<'a> {
    /// At an increment from `state`, where a step starts, `elapsed` [s] later.
    pub fn of(state: &'a State, by: &'a Increment, elapsed: f64) -> Self {
        let Increment { phi, v, a, rigid, anchor, past } = by;
        let State { q: base, memory, seats, spots, coils, .. } = state;
        Self {
            schedule: Schedule::after(state, elapsed),
            base,
            memory,
            seats,
            spots,
            coils,
            phi,
            v,
            a,
            rigid,
            anchor,
            past,
            laying: Laying::Anew,
        }
    }

    pub(super) fn remembered(&self, modes: &'a [Mode]) -> Remembered<'a> {
        let Self { memory, seats, spots, coils, .. } = *self;
        Remembered { memory, seats, spots, coils, modes }
    }
}

impl Adaptive {
    /// Evaluates the course at one share of the step, rows only, whatever was looked at.
    pub(super) fn probe_rows(&mut self, system: &System, state: &State, theta: f64) {
        self.rodas.course.at(theta, &mut self.point);
        let laying = Laying::Watched(&self.rodas.here.light, &self.laid_before);
        let point = Point { laying, ..Point::of(state, &self.point, theta * self.rodas.course.h) };
        self.probe.rows(system, &point, &state.modes);
    }

    /// The same as a look at the course after others.
    pub(super) fn look_at_rows(&mut self, system: &System, state: &State, theta: f64) {
        self.rodas.course.at(theta, &mut self.point);
        let laying = Laying::Watched(&self.rodas.here.light, &self.laid);
        let point = Point { laying, ..Point::of(state, &self.point, theta * self.rodas.course.h) };
        self.probe.rows(system, &point, &state.modes);
    }

    /// The same with light sheaves going on as they do, whatever was looked at.
    pub(super) fn probe_frozen(&mut self, system: &System, state: &State, theta: f64) {
        self.rodas.course.at(theta, &mut self.point);
        let laying = Laying::Frozen(&self.rodas.here.light);
        let point = Point { laying, ..Point::of(state, &self.point, theta * self.rodas.course.h) };
        self.probe.rows(system, &point, &state.modes);
    }
}
