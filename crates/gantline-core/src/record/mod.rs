//! What a run keeps: samples of its motion and forces at equal intervals, and one where it ends. All else, poses,
//! segments, forces in joints, follows from them and is worked out when it is asked for ([`columns::Columns`]).

use crate::audit::KINDS;
use crate::contact::spot::Spot;
use crate::plan::Compensator;
use crate::rope::seat::Seat;
use crate::state::State;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

mod clearance;
pub mod columns;
pub mod named;
pub mod names;
pub(crate) mod packed;
mod presence;
pub mod pulls;
mod rows;

use rows::Rows;

/// Motion and forces at one moment.
#[derive(Debug, Clone, Default)]
pub struct Sample {
    /// Configuration: joint coordinates.
    pub q: Vec<f64>,
    /// Velocity coordinates.
    pub v: Vec<f64>,
    /// v̇.
    pub acceleration: Vec<f64>,
    /// Force of every row [N].
    pub tension: Vec<f64>,
    /// What forces remember, as [`State::past`].
    pub past: Vec<f64>,
}

impl Sample {
    /// That of a state as it is.
    pub fn of(state: &State) -> Self {
        Self {
            q: state.q.clone(),
            v: state.v.clone(),
            acceleration: state.acceleration.clone(),
            tension: state.tension.clone(),
            past: state.past.clone(),
        }
    }
}

/// Samples taken so far. Shapes are (samples, …) in row-major order.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Samples {
    /// Time [s].
    pub time: Vec<f64>,
    /// (joint coordinate).
    pub q: Vec<f64>,
    /// (velocity coordinate).
    pub v: Vec<f64>,
    /// (velocity coordinate) v̇.
    pub acceleration: Vec<f64>,
    /// (row) force [N].
    pub tension: Vec<f64>,
    /// (number) what forces remember, as [`State::past`].
    pub past: Vec<f64>,
    /// (sheave) how ropes lie on sheaves with true tangents.
    pub(crate) seats: Rows<Seat>,
    /// (spot) where bodies may touch.
    pub(crate) spots: Rows<Spot>,
    /// (row that is adjusted) by how much it is longer than at the start [m].
    pub lengthening: Vec<f64>,
    /// (compensator) by how much heave compensation has raised the hook [m].
    pub compensation: Vec<f64>,
    /// (kind) [J].
    pub energy: Vec<f64>,
    /// Largest distance of a force from its law [N].
    pub complementarity_residual: Vec<f64>,
    /// (rope) largest tension over all steps so far [N].
    pub rope_peak_tension: Vec<f64>,
    /// (rope) when that was [s].
    pub rope_peak_time: Vec<f64>,
    /// (contact) largest normal force over all steps so far [N].
    pub contact_peak_force: Vec<f64>,
    /// (contact) when that was [s].
    pub contact_peak_time: Vec<f64>,
}

/// Tensions that differ by less are alike, as a share: of a rope at rest the first of them is its largest.
const ALIKE: f64 = 1e-9;

/// Room is made for at most so many samples at once [numbers]: a run may end long before its duration.
const MOST_ROOM: usize = 1 << 24;

impl Samples {
    /// Room for `count` samples of `state`, so that a run need not move them as it goes.
    pub fn with_room(state: &State, count: f64) -> Self {
        let State { q, v, tension, past, seats, spots, .. } = state;
        let width = q.len()
            + 2 * v.len()
            + tension.len()
            + past.len()
            + 2 * seats.len()
            + 16 * spots.len()
            + KINDS.len()
            + 2;
        let count = (count as usize).saturating_add(1).min(MOST_ROOM / width);
        let room = |width: usize| Vec::with_capacity(count * width);
        Self {
            seats: Rows::with_room(count, seats.len()),
            spots: Rows::with_room(count, spots.len()),
            time: room(1),
            q: room(q.len()),
            v: room(v.len()),
            acceleration: room(v.len()),
            tension: room(tension.len()),
            past: room(past.len()),
            energy: room(KINDS.len()),
            complementarity_residual: room(1),
            ..Self::default()
        }
    }

    /// True where these may be samples of states like `state`.
    pub fn are_of(&self, state: &State) -> bool {
        let State { q, v, tension, past, seats, spots, .. } = state;
        let count = self.time.len();
        let of = |column: &[f64], width: usize| column.len() == count * width;
        of(&self.q, q.len())
            && of(&self.v, v.len())
            && of(&self.acceleration, v.len())
            && of(&self.tension, tension.len())
            && of(&self.past, past.len())
            && of(&self.energy, KINDS.len())
            && of(&self.complementarity_residual, 1)
            && self.seats.are(count, seats.len())
            && self.spots.are(count, spots.len())
    }

    /// Adds a state as it is, as a sample at `time` [s].
    pub fn push_state(&mut self, system: &System, time: f64, state: &State) {
        self.push(time, &Sample::of(state), state, 0.0);
        let adjusted = system.adjusters.iter().flat_map(|adjuster| &adjuster.rows);
        self.lengthening.extend(adjusted.map(|&row| state.memory[row]));
        self.compensation.extend(state.plan.compensated(&system.plan.compensators, time));
        self.energy.extend(state.ledger.values());
    }

    /// Adds the moment at `time` [s], a share of a step.
    fn push_within(
        &mut self,
        (adjusted, compensators): (&[usize], &[Compensator]),
        span: &Span,
        (time, share): (f64, f64),
        sample: &Sample,
    ) {
        self.push(time, sample, span.before, span.residual);
        // Lengths are adjusted when a step has been made, at once.
        let memory = if share < 1.0 { &span.before.memory } else { &span.after.memory };
        self.lengthening.extend(adjusted.iter().map(|&row| memory[row]));
        self.compensation.extend(span.after.plan.compensated(compensators, time));
        let energies = span.before.ledger.values().into_iter().zip(span.after.ledger.values());
        self.energy.extend(energies.map(|(before, after)| before + share * (after - before)));
    }

    /// Without any sample, as after [`Samples::default`], but with its room.
    fn clear(&mut self) {
        for column in self.columns() {
            column.clear();
        }
        self.seats.clear();
        self.spots.clear();
    }

    /// Adds those of another, all of the same system.
    fn append(&mut self, other: &Self) {
        for sample in 0..other.time.len() {
            self.seats.push(other.seats.of(sample));
            self.spots.push(other.spots.of(sample));
        }
        for (column, more) in self.columns().into_iter().zip(other.clone().columns()) {
            column.append(more);
        }
    }

    /// All columns of numbers that have one row per sample.
    fn columns(&mut self) -> [&mut Vec<f64>; 10] {
        [
            &mut self.time,
            &mut self.q,
            &mut self.v,
            &mut self.acceleration,
            &mut self.tension,
            &mut self.past,
            &mut self.lengthening,
            &mut self.compensation,
            &mut self.energy,
            &mut self.complementarity_residual,
        ]
    }

    fn push(&mut self, time: f64, sample: &Sample, by: &State, residual: f64) {
        self.time.push(time);
        self.q.extend_from_slice(&sample.q);
        self.v.extend_from_slice(&sample.v);
        self.acceleration.extend_from_slice(&sample.acceleration);
        self.tension.extend_from_slice(&sample.tension);
        self.past.extend_from_slice(&sample.past);
        self.seats.push(&by.seats);
        self.spots.push(&by.spots);
        self.complementarity_residual.push(residual);
    }

    /// Keeps the largest tension of every mooring line at the ends of steps; `kinematics` belongs to the state.
    pub fn note_lines(&mut self, system: &System, kinematics: &Kinematics, state: &State) {
        self.make_room_for_peaks(system);
        for (line, mooring) in system.moorings().enumerate() {
            let tension = mooring.tension_of(&system.tree, kinematics, &state.v);
            let rope = system.rope_count + line;
            if tension > self.rope_peak_tension[rope] * (1.0 + ALIKE) {
                (self.rope_peak_tension[rope], self.rope_peak_time[rope]) = (tension, state.time);
            }
        }
    }

    /// Every rope has a largest tension and every contact a largest force, also before there is any.
    pub fn make_room_for_peaks(&mut self, system: &System) {
        for peaks in [&mut self.rope_peak_tension, &mut self.rope_peak_time] {
            peaks.resize(system.all_ropes(), 0.0);
        }
        for peaks in [&mut self.contact_peak_force, &mut self.contact_peak_time] {
            peaks.resize(system.normal_rows().count(), 0.0);
        }
    }

    /// Keeps the largest tension of every rope and force of every contact: `peak` gives the largest force of a row in a
    /// step that ended at `q`, of a rope with a curve its largest tension, and its time [s], where it is more than what is
    /// known, by more than rounding.
    pub fn note_peaks(
        &mut self,
        system: &System,
        q: &[f64],
        mut peak: impl FnMut(usize, f64) -> Option<(f64, f64)>,
    ) {
        self.make_room_for_peaks(system);
        let peaks = self.rope_peak_tension.iter_mut().zip(&mut self.rope_peak_time);
        for ((rope, &first), (known, when)) in system.ropes().zip(&system.rows.first).zip(peaks) {
            for (index, span) in rope.spans.iter().enumerate() {
                let scale = span.scale(q);
                if let Some((force, time)) = peak(first + index, *known * (1.0 + ALIKE) / scale) {
                    (*known, *when) = (scale * force, time);
                }
            }
        }
        let peaks = self.contact_peak_force.iter_mut().zip(&mut self.contact_peak_time);
        for (row, (known, when)) in system.normal_rows().zip(peaks) {
            if let Some(largest) = peak(row, *known * (1.0 + ALIKE)) {
                (*known, *when) = largest;
            }
        }
    }
}

/// What a step leaves for samples within it.
#[derive(Debug, Clone, Copy)]
pub struct Span<'a> {
    /// State at its start.
    pub before: &'a State,
    /// State at its end.
    pub after: &'a State,
    /// Complementarity residual of the step [N].
    pub residual: f64,
}

/// Share of an interval within which two samples are one: much more than the rounding of ten million intervals.
const NEAR: f64 = 1e-6;

/// Rows of ropes whose lengths are adjusted.
fn adjusted_rows(system: &System) -> Vec<usize> {
    system.adjusters.iter().flat_map(|adjuster| adjuster.rows.iter().copied()).collect()
}

/// Takes samples. Reused from sample to sample.
#[derive(Debug, Clone)]
pub struct Recorder {
    /// Time between samples [s].
    pub interval: f64,
    /// When the run ends [s], which need not be a multiple of the interval.
    pub end: f64,
    sample: Sample,
    /// Rows that are adjusted.
    adjusted: Vec<usize>,
    compensators: Vec<Compensator>,
}

impl Recorder {
    /// A recorder for runs of `system` that pass through states like `state`.
    pub fn new(system: &System, state: &State, interval: f64, end: f64) -> Self {
        let adjusted = adjusted_rows(system);
        let compensators = system.plan.compensators.clone();
        Self { interval, end, sample: Sample::of(state), adjusted, compensators }
    }

    /// When the sample after one at `last` [s] is due, the first one for none: at the next multiple of the interval, or
    /// at the end where that comes first. None after that.
    fn due(&self, last: Option<f64>) -> Option<f64> {
        let Some(last) = last else { return Some(0.0) };
        let next = ((last / self.interval + NEAR).floor() + 1.0) * self.interval;
        let is_within = next < self.end - NEAR * self.interval;
        let is_open = last < self.end;
        is_open.then_some(if is_within { next } else { self.end })
    }

    /// True where a step ends after the run does, as fixed steps may.
    pub fn is_past(&self, time: f64) -> bool {
        time > self.end + NEAR * self.interval
    }

    /// The last sample that was taken.
    pub fn last(&self) -> &Sample {
        &self.sample
    }

    /// Takes one of a state that the run does not go on from, where there is none of it yet: in a first step that of the
    /// start, without which nobody could see where it failed.
    pub fn close(&self, system: &System, state: &State, samples: &mut Samples) {
        let is_later = |last: &f64| state.time > last + NEAR * self.interval;
        if samples.time.last().is_none_or(is_later) && !self.is_past(state.time) {
            samples.push_state(system, state.time, state);
        }
    }

    /// Takes all samples that are due up to the end of the step. `motion` gives the sample at a share of the step.
    pub fn record(
        &mut self,
        span: &Span,
        samples: &mut Samples,
        motion: &mut dyn FnMut(&Span, f64, &mut Sample),
    ) {
        let (from, to) = (span.before.time, span.after.time);
        while let Some(time) = self.due(samples.time.last().copied()) {
            // A sample at the end of the step by intention must not miss it by rounding.
            if time > to + 1e-9 * (to - from) {
                break;
            }
            let share = ((time - from) / (to - from)).clamp(0.0, 1.0);
            motion(span, share, &mut self.sample);
            let of = (self.adjusted.as_slice(), self.compensators.as_slice());
            samples.push_within(of, span, (time, share), &self.sample);
        }
    }
}
