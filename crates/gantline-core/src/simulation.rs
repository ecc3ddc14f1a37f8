//! A run: system, method, recorder and state together.

mod checkpoint;
mod commands;
mod method;
mod waypoints;

use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::build::{BuildError, build};
use crate::clock::{STAGES, Stage};
use crate::event::afloat::Lookout;
use crate::event::standstill;
use crate::event::{Event, EventLog};
use crate::record::columns::{Columns, tensions_of};
use crate::record::named::{Named, named};
use crate::record::names::Names;
use crate::record::pulls::Pulls;
use crate::record::{Recorder, Sample, Samples, Span};
use crate::spec::{SettingsSpec, StartSpec, SystemSpec};
use crate::state::State;
use crate::statics::losses::Losses;
use crate::statics::{NoEquilibrium, Statics};
use crate::stepper::StepError;
use crate::stepper::adaptive::Tolerance;
use crate::stepper::frame::Frame;
use crate::system::System;
use crate::tree::kinematics::Kinematics;
pub(crate) use checkpoint::{fingerprint, saved_state};
pub use commands::Command;
use method::Method;
pub use waypoints::Saved;
use waypoints::Waypoint;

/// Why a run cannot be set up or taken up again.
#[derive(Debug, Error)]
pub enum SetupError {
    /// The document is no valid JSON of the expected form.
    #[error("the document cannot be read: {0}")]
    Document(#[from] serde_json::Error),
    /// Something in it is wrong.
    #[error(transparent)]
    Build(#[from] BuildError),
    /// It shall start at rest and comes to rest nowhere.
    #[error("{}: it cannot start at rest: {}", .0.element, .0.cause)]
    Rest(#[from] NoEquilibrium),
    /// A setting is out of its range.
    #[error("{0}")]
    Setting(String),
    /// A program asks of a drive what cannot be.
    #[error("{0}")]
    Command(String),
    /// A saved state does not belong here.
    #[error("the saved state cannot be used: {0}")]
    State(String),
}

/// What a run counts.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Counters {
    /// Steps made.
    pub steps: u64,
    /// Factorisations made.
    pub factorisations: u64,
    /// Steps whose complementarity iteration was capped.
    pub unconverged: u64,
    /// Steps that were tried again with a shorter length.
    pub rejected: u64,
    /// Steps that were cut at a change of modes.
    pub cut: u64,
}

/// A run of one system.
#[derive(Debug, Clone)]
pub struct Simulation {
    system: System,
    settings: SettingsSpec,
    fingerprint: u64,
    document: u64,
    state: State,
    before: State,
    frame: Frame,
    method: Method,
    recorder: Recorder,
    lookout: Lookout,
    /// Steps and time [s] at which it was last asked whether the run gets on.
    asked: (u64, f64),
    samples: Samples,
    pulls: Pulls,
    events: EventLog,
    commands: Vec<Command>,
    counters: Counters,
    waypoints: Vec<Waypoint>,
}

/// More samples than this are a mistake in the settings.
const MOST_SAMPLES: f64 = 1e7;

fn above_zero(what: &str, value: f64, unit: &str) -> Result<(), SetupError> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    Err(SetupError::Setting(format!("{what} is {value} {unit}; it must be more than zero")))
}

impl Simulation {
    /// Sets up a run from two JSON texts, see [`crate::spec`].
    ///
    /// # Errors
    /// [`SetupError`] says what is wrong.
    pub fn new(document: &str, settings: &str) -> Result<Self, SetupError> {
        let spec: SystemSpec = serde_json::from_str(document)?;
        let parsed: SettingsSpec = serde_json::from_str(settings)?;
        above_zero("the duration", parsed.duration, "s")?;
        above_zero("the sample interval", parsed.sample_interval, "s")?;
        if parsed.duration / parsed.sample_interval > MOST_SAMPLES {
            let problem = "the sample interval is too short for the duration: more than ten million samples";
            return Err(SetupError::Setting(problem.to_owned()));
        }
        let (system, mut state) = build(&spec)?;
        if parsed.start == StartSpec::Rest {
            Statics::new(&system).settle(&system, &mut state, Losses::HELD)?;
        }
        let mut frame = Frame::new(&system);
        frame.update(&system, &state);
        let mut samples = Samples::with_room(&state, (parsed.duration / parsed.sample_interval).ceil());
        samples.make_room_for_peaks(&system);
        Ok(Self {
            method: Method::new(&system, &frame, &parsed.integrator)?,
            recorder: Recorder::new(&system, &state, parsed.sample_interval, parsed.duration),
            lookout: Lookout::new(&system),
            asked: (0, 0.0),
            fingerprint: fingerprint([document, settings]),
            document: fingerprint([document]),
            before: state.clone(),
            samples,
            pulls: Pulls::new(&system, Sample::of(&state)),
            events: EventLog::new(),
            commands: Vec::new(),
            counters: Counters::default(),
            waypoints: Vec::new(),
            settings: parsed,
            system,
            state,
            frame,
        })
    }

    /// Simulated time [s].
    pub fn time(&self) -> f64 {
        self.state.time
    }

    /// Duration of the run [s].
    pub fn duration(&self) -> f64 {
        self.settings.duration
    }

    /// True when the run has reached `until` [s] (or its duration), within rounding.
    pub fn reached(&self, until: f64) -> bool {
        self.state.time >= until.min(self.settings.duration) * (1.0 - 1e-12) - 1e-12
    }

    /// Makes one step and records what is due.
    ///
    /// # Errors
    /// [`StepError`]; the state is then the last good one, or that in which a vessel has capsized or sheaves have met.
    pub fn step(&mut self) -> Result<(), StepError> {
        self.step_to(f64::INFINITY)
    }

    /// The same, with `adaptive` not beyond `until` [s]: there it ends to the last bit.
    ///
    /// # Errors
    /// As [`Simulation::step`].
    pub fn step_to(&mut self, until: f64) -> Result<(), StepError> {
        self.system.clock.resume();
        let made = self.make_step(until.min(self.settings.duration));
        if made.is_err() {
            self.recorder.close(&self.system, &self.state, &mut self.samples);
        }
        self.system.clock.pause();
        made
    }

    fn make_step(&mut self, until: f64) -> Result<(), StepError> {
        self.before.copy_from(&self.state);
        let Self { system, state, frame, events, .. } = self;
        let made = match &mut self.method {
            Method::Del(del) => del.step(system, state, frame, events),
            Method::Explicit(explicit) => explicit.step(system, state, frame, events),
            Method::Adaptive(adaptive) => adaptive.step(system, state, frame, events, until),
        };
        let report = made.inspect_err(|_| {
            self.state.copy_from(&self.before);
            self.frame.update(&self.system, &self.state);
        })?;
        if let Method::Adaptive(adaptive) = &mut self.method {
            adaptive.close_books(&self.system, &self.before, &mut self.state);
        }
        self.counters.rejected += report.rejected;
        self.counters.cut += u64::from(report.cut);
        self.counters.steps += 1;
        self.counters.factorisations += report.factorisations;
        self.counters.unconverged += u64::from(!report.converged);
        self.record(report.complementarity_residual);
        self.note_waypoints();
        if self.reached(f64::INFINITY) {
            self.state.plan.close(self.settings.duration, &mut self.events);
        }
        let (steps, since) = self.asked;
        if self.counters.steps - steps >= standstill::STEPS {
            self.asked = (self.counters.steps, self.state.time);
            standstill::look(&self.system, &self.frame.kinematics, [since, self.state.time])?;
        }
        let Self { system, method, lookout, events, before, state: after, .. } = self;
        let span = Span { before, after, residual: 0.0 };
        lookout.look(system, &span, events, &mut |span, share, sample| {
            method.course(system, span, share, sample)
        })
    }

    /// Records what is due of the step that has been made.
    fn record(&mut self, residual: f64) {
        let Self { system, method, recorder, samples, pulls, before, state: after, frame, .. } = self;
        let span = Span { before, after, residual };
        system.clock.time(Stage::Recording, || {
            let motion =
                &mut |span: &Span, share, sample: &mut Sample| method.course(system, span, share, sample);
            recorder.record(&span, samples, motion);
            if recorder.is_past(after.time) {
                // Of a step that leads over the end counts what has been sampled there.
                let Sample { q, tension, .. } = recorder.last();
                let mut kinematics = Kinematics::new(&system.tree);
                kinematics.update(&system.tree, q, 0.0);
                let now = |row: usize| system.curved_tension(row, tension[row], &kinematics);
                let peak = |row: usize, known| Some((now(row), recorder.end)).filter(|now| now.0 > known);
                samples.note_peaks(system, q, peak);
                return;
            }
            samples.note_lines(system, &frame.kinematics, after);
            let peak =
                |row, known| method.peak((system, &frame.kinematics), (span.before, after), row, known);
            samples.note_peaks(system, &after.q, peak);
            for group in 0..system.pulls.len() {
                let pull =
                    |bearers: &_, known| method.pull((system, &frame.kinematics), after, bearers, known);
                if let Some(found) = pulls.found(system, group, &after.q, pull) {
                    let motion =
                        |span: &Span, share, sample: &mut Sample| method.course(system, span, share, sample);
                    pulls.keep(system, group, found, &span, motion);
                }
            }
        });
    }

    /// The system.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The state now.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Samples so far.
    pub fn samples(&self) -> &Samples {
        &self.samples
    }

    /// Everything that follows from the samples so far.
    pub fn columns(&self) -> Columns {
        self.system.clock.resume();
        self.system.clock.time(Stage::Recording, || Columns::of(&self.system, &self.samples, &self.events))
    }

    /// The same by name, with the times of events, and with what programs have asked for.
    pub fn named_columns(&self) -> Vec<Named> {
        let events = self.events().iter().map(|event| event.0).collect();
        let mut all = named(&self.samples, self.columns(), &self.names(), events);
        let of = |value: fn(&Command) -> f64| self.commands.iter().map(value).collect();
        let count = self.commands.len();
        all.push(("command_time", of(|command| command.time), vec![count]));
        all.push(("command_speed", of(|command| command.speed), vec![count]));
        all.push(("command_acceleration", of(|command| command.acceleration), vec![count]));
        all
    }

    /// The same by name of the moments at which groups of ropes pulled most together, or of pins bore most, one for each;
    /// fewer before the first step.
    pub fn columns_of_pulls(&self) -> Vec<Named> {
        let events = self.events().iter().map(|event| event.0).collect();
        let samples = self.pulls.samples();
        named(&samples, Columns::of(&self.system, &samples, &self.events), &self.names(), events)
    }

    /// The present as columns of one sample, by name, without events.
    pub fn present(&self) -> Vec<Named> {
        let mut samples = Samples::default();
        samples.push_state(&self.system, self.state.time, &self.state);
        let columns = Columns::of(&self.system, &samples, &self.events);
        named(&samples, columns, &self.names(), Vec::new())
    }

    /// Measures from now on where the time goes. Costs a few per cent.
    pub fn measure(&mut self) {
        self.system.clock.switch_on();
    }

    /// Name and time [s] of every stage of what has been measured.
    pub fn stages(&self) -> Vec<(&'static str, f64)> {
        let seconds = self.system.clock.seconds().into_iter().flatten();
        STAGES.into_iter().zip(seconds).collect()
    }

    /// Names that go with the columns.
    pub fn names(&self) -> Names {
        Names::new(&self.system)
    }

    /// Events so far, none of them after the end of the run, in order of time, with the names of what they concern.
    pub fn events(&self) -> Vec<(f64, &'static str, String)> {
        let is_within = |event: &&Event| !self.recorder.is_past(event.time);
        let mut events: Vec<&Event> = self.events.events.iter().filter(is_within).collect();
        events.sort_by(|a, b| a.time.total_cmp(&b.time));
        events
            .into_iter()
            .map(|event| (event.time, event.kind.name(), event.subject_name(&self.system)))
            .collect()
    }

    /// Name of the step of the plan that is under way, if any.
    pub fn current_step(&self) -> Option<&str> {
        self.state.plan.current(&self.system.plan)
    }

    /// Tension of every rope now [N].
    pub fn rope_tension(&self) -> Vec<f64> {
        let State { tension, q, .. } = &self.state;
        tensions_of(&self.system, tension, q, &self.frame.kinematics).collect()
    }

    /// What the run counted, by name, with the entries of its factor.
    pub fn counted(&self) -> [(&'static str, u64); 6] {
        let Counters { steps, factorisations, unconverged, rejected, cut } = self.counters;
        [
            ("steps", steps),
            ("factorisations", factorisations),
            ("unconverged", unconverged),
            ("rejected", rejected),
            ("cut", cut),
            ("fill", self.method.fill() as u64),
        ]
    }

    /// What the error of a step may be, by name [N, m]; empty where steps are fixed.
    pub fn tolerances(&self) -> Vec<(&'static str, f64)> {
        match &self.method {
            Method::Del(_) | Method::Explicit(_) => Vec::new(),
            Method::Adaptive(adaptive) => {
                let Tolerance { tension, position } = adaptive.tolerance();
                vec![("tension", tension), ("position", position)]
            }
        }
    }
}
