//! A lift at rest, from its document: where it hangs at any time of its plan, how it moves about that, and what it
//! answers to what is uncertain. What the border hands on.

mod lost;
mod pace;
mod way;

use glam::DVec3;

use super::losses::{Contacts, Losses, Sheaves};
use super::modes::Mode;
use super::sensitivity::{Parameter, Sensitivity};
use super::standing::Friction;
use super::{NoEquilibrium, Rest, Statics};
use crate::build::build;
use crate::constraint::rope::span::Span;
use crate::constraint::{AnyConstraint, Law};
use crate::event::{Event, EventKind, EventLog};
use crate::force;
use crate::plan::Switching;
use crate::record::Samples;
use crate::record::columns::Columns;
use crate::record::named::Named;
use crate::record::names::Names;
use crate::simulation::{SetupError, fingerprint, saved_state};
use crate::solver::complementarity::Mode as RowMode;
use crate::spec::SystemSpec;
use crate::state::State;
use crate::stepper::frame::Frame;
use crate::system::System;
use crate::tree::joint::Motion;
use crate::tree::kinematics::{Kinematics, Twist};

/// What is asked whether a search shall go on.
pub type GoesOn<'a> = &'a mut dyn FnMut() -> bool;

/// A lift at rest.
#[derive(Debug, Clone)]
pub struct StaticLift {
    system: System,
    first: State,
    state: State,
    statics: Statics,
    samples: Samples,
    /// Steps of the plan that began and ended on the way to the equilibrium found last.
    log: EventLog,
    /// Groups of contacts that slid on that way since their friction found no balance, and when [s].
    slides: Vec<(f64, usize)>,
    /// Where it was followed to.
    trail: way::Trail,
    /// The system as it is given, while a load of it is lost or weighs more.
    whole: Option<System>,
    fingerprint: u64,
}

impl StaticLift {
    /// From a document, see [`crate::spec`].
    ///
    /// # Errors
    /// [`SetupError`] says what is wrong with it.
    pub fn new(document: &str) -> Result<Self, SetupError> {
        let spec: SystemSpec = serde_json::from_str(document)?;
        let (mut system, first) = build(&spec)?;
        // Where water is still nothing heaves.
        force::calm(&mut system.tree);
        system.plan.steps.iter_mut().for_each(|step| step.compensates.clear());
        // A plan that is followed from rest to rest looks at the lift as a run does, and would drain its tanks by the way.
        system.plan.holed.clear();
        if let Some(adjuster) = system.adjusters.first() {
            let name = &adjuster.name;
            let problem = format!("{name} adjusts lengths step by step, which statics does not know");
            return Err(SetupError::Setting(problem));
        }
        let statics = Statics::new(&system);
        let fingerprint = fingerprint([document]);
        let (state, samples, log) = (first.clone(), Samples::default(), EventLog::new());
        let (slides, trail, whole) = (Vec::new(), way::Trail::default(), None);
        Ok(Self { state, samples, log, slides, trail, first, statics, system, whole, fingerprint })
    }

    /// Finds the equilibrium at `time` [s] of the plan, downhill of the start of the lift after `increment` of its
    /// free degrees of freedom (none: the start itself).
    ///
    /// The samples are then the start of the lift, as it is given, and the equilibrium; at time 0 that alone.
    /// A plan that waits for a condition, in which a drive follows, or that has put in a pin or put on a sling is followed from rest to rest,
    /// contacts holding; so is a lift whose drums remember what they wind, or whose friction holds. What slides does so from
    /// there. Before every part `goes_on` is asked. The same way is gone once: who asks again goes on from the nearest place
    /// that it has come by, with the same answer.
    ///
    /// # Errors
    /// [`NoEquilibrium`] says why there is none, or that the search was stopped.
    pub fn settle(
        &mut self,
        time: f64,
        increment: Option<&[f64]>,
        losses: Losses,
        goes_on: GoesOn,
    ) -> Result<Rest, NoEquilibrium> {
        self.set_back(increment);
        let rest = if self.has_history(time, losses) {
            let on_the_way = losses.on_the_way();
            let is_same = losses.sheaves == on_the_way.sheaves
                && (losses.contacts == on_the_way.contacts || self.system.friction.is_empty());
            let rest = self.follow(time, increment, on_the_way, None, goes_on)?;
            if is_same { rest } else { self.statics.settle_again(&self.system, &mut self.state, losses)? }
        } else {
            self.jump(time, losses)?
        };
        way::note(&mut self.slides, &mut self.statics, self.state.time);
        self.sample(time > 0.0);
        Ok(rest)
    }

    /// When a step of the plan begins or ends [s], of a lift that is followed as [`StaticLift::settle`] does, with sheaves
    /// ideal; none where that is not before `time` [s]. It is followed no farther than to that moment, and not at all where
    /// the plan alone says when that is.
    ///
    /// # Errors
    /// As there.
    pub fn when(
        &mut self,
        step: &str,
        ends: bool,
        time: f64,
        goes_on: GoesOn,
    ) -> Result<Option<f64>, NoEquilibrium> {
        let kind = if ends { EventKind::StepEnd } else { EventKind::StepBegin };
        let Some(until) = self.step_event(step, kind) else { return Ok(None) };
        self.set_back(None);
        if self.has_history(time, Losses::NONE) {
            self.follow(time, None, Losses::NONE.on_the_way(), Some(until), goes_on)?;
        } else {
            self.advance(time);
        }
        Ok(until.time(&self.log))
    }

    /// To the start of the lift after `increment` of its free degrees of freedom, with all its loads.
    fn set_back(&mut self, increment: Option<&[f64]>) {
        self.find_again();
        let Self { system, first, state, .. } = self;
        state.copy_from(first);
        self.slides.clear();
        if let Some(increment) = increment {
            let free = increment.iter().zip(&system.driven);
            let free: Vec<f64> =
                free.map(|(step, driven)| if driven.is_none() { *step } else { 0.0 }).collect();
            system.tree.advance(&mut state.q, &free);
        }
    }

    /// Whether what the lift comes to at `time` [s] depends on what has been.
    fn has_history(&self, time: f64, losses: Losses) -> bool {
        !self.system.coils.is_empty()
            || losses.sheaves == Sheaves::Held
            || losses.contacts != Contacts::Free
            || self.has_way(time)
    }

    /// Finds the equilibrium to which a run of the same document would come if everything stopped where it has got to,
    /// from what [`crate::simulation::Simulation::save`] gave: drums and drives stay where they are.
    ///
    /// # Errors
    /// Text where that is not of this document, else [`NoEquilibrium`].
    pub fn settle_saved(
        &mut self,
        saved: &[u8],
        losses: Losses,
    ) -> Result<Result<Rest, NoEquilibrium>, SetupError> {
        self.find_again();
        self.state = saved_state(self.fingerprint, saved)?;
        let Self { system, state, statics, .. } = self;
        statics.resume(system, state);
        let found = statics.go_on(system, state, losses);
        self.slides.clear();
        way::note(&mut self.slides, &mut self.statics, self.state.time);
        Ok(found.inspect(|_| self.sample(true)))
    }

    /// The samples are the start of the lift, where `from_start`, and the equilibrium.
    fn sample(&mut self, from_start: bool) {
        self.samples = Samples::default();
        if from_start {
            // What has moved is told from here.
            self.samples.push_state(&self.system, 0.0, &self.first);
        }
        self.samples.push_state(&self.system, self.state.time, &self.state);
        self.note_tensions(&self.state.clone());
    }

    /// The `count` slowest modes about the equilibrium that was found last, slowest first; all without a count. Motions that
    /// others have `found`, see [`Statics::modes_of`], stand in their place.
    pub fn modes(&mut self, count: Option<usize>, found: Option<Vec<(f64, Vec<f64>)>>) -> Vec<Mode> {
        match found {
            Some(found) => self.statics.modes_of(&self.system, &self.state, found),
            None => self.statics.modes(&self.system, &self.state, count),
        }
    }

    /// Moves off an unstable equilibrium, the one that was found last, to the stable one downhill of it; false where it
    /// is not unstable. The samples are then as those of [`StaticLift::settle`].
    ///
    /// # Errors
    /// [`NoEquilibrium`] where there is none.
    pub fn step_off(&mut self, losses: Losses) -> Result<Option<Rest>, NoEquilibrium> {
        let Self { system, state, statics, .. } = self;
        let rest = statics.step_off(system, state, losses)?;
        if rest.is_some() {
            way::note(&mut self.slides, &mut self.statics, self.state.time);
            self.sample(self.state.time > 0.0);
        }
        Ok(rest)
    }

    /// How a shape moves every body: velocity of the centre of gravity and angular velocity, world axes.
    pub fn body_motion(&self, shape: &[f64]) -> Vec<f64> {
        let mut kinematics = Kinematics::new(&self.system.tree);
        kinematics.update(&self.system.tree, &self.state.q, 0.0);
        let mut twists = vec![Twist::default(); self.system.tree.bodies.len()];
        kinematics.twists(&self.system.tree, shape, &mut twists);
        let bodies = self.system.tree.bodies.iter().zip(twists.iter().zip(&kinematics.lever));
        let moving = bodies.filter(|(body, _)| body.joint.moves_body());
        let motion = moving.flat_map(|(_, (twist, &lever))| {
            twist.at(lever).to_array().into_iter().chain(twist.angular.to_array())
        });
        motion.collect()
    }

    /// The same of the derivative `motion` over a parameter, with what moves since the joint of a body is elsewhere. A
    /// centre of gravity that is itself the parameter counts where it was.
    pub fn body_change(&self, parameter: Parameter, motion: &[f64]) -> Vec<f64> {
        let mut change = self.body_motion(motion);
        if let Parameter::Place(body, axis) = parameter {
            let bodies = self.system.tree.bodies.iter().enumerate();
            let moving = bodies.filter(|(_, one)| one.joint.moves_body()).map(|(index, _)| index);
            for (place, index) in moving.enumerate() {
                if self.system.tree.subtree[body].contains(&index) {
                    change[6 * place + axis] += 1.0;
                }
            }
        }
        change
    }

    /// The derivative over a parameter of what each rope pulls with, mooring lines last [N].
    pub fn tension_change(&self, parameter: Parameter, change: &Sensitivity) -> Vec<f64> {
        let Self { system, state, .. } = self;
        let mut ropes = self.statics.rope_changes(system, &change.motion, &change.tension);
        if let Some((rope, own)) = self.statics.own_change(system, parameter) {
            ropes[rope] += own;
        }
        let kinematics = &placed(system, state).kinematics;
        let moorings = system.moorings().map(|mooring| {
            let carried = match parameter {
                Parameter::Place(body, axis) if system.tree.subtree[body].contains(&mooring.body) => {
                    DVec3::AXES[axis]
                }
                _ => DVec3::ZERO,
            };
            mooring.tension_rates(&system.tree, kinematics, &change.motion, carried)[0]
        });
        ropes.into_iter().chain(moorings).collect()
    }

    /// The lift linearised about the equilibrium that was found last, see [`Statics::linear`]: matrices by name with their
    /// shapes, and `body_motion`, what a unit of each x does, see [`StaticLift::body_motion`].
    pub fn linear(&mut self, omega: Option<f64>) -> Vec<Named> {
        let found = self.statics.linear(&self.system, &self.state, omega);
        let (size, ropes) = (found.free.len(), self.system.all_ropes());
        let mut unit = vec![0.0; self.system.tree.velocities];
        let mut motion = Vec::new();
        for &dof in &found.free {
            unit[dof] = 1.0;
            motion.extend(self.body_motion(&unit));
            unit[dof] = 0.0;
        }
        let holding = found.held.len() / size.max(1);
        let bodies = motion.len() / (6 * size.max(1));
        vec![
            ("mass", found.mass, vec![size, size]),
            ("damping", found.damping, vec![size, size]),
            ("stiffness", found.stiffness, vec![size, size]),
            ("held", found.held, vec![holding, size]),
            ("rope_tension", found.tension, vec![ropes, size]),
            ("rope_tension_rate", found.tension_rate, vec![ropes, size]),
            ("body_motion", motion, vec![size, bodies, 6]),
        ]
    }

    /// Names of the degrees of freedom that no drive moves: that of the body, or of the flow, and which of several it is.
    pub fn coordinates(&self) -> Vec<String> {
        let name = |dof: &usize| {
            let bodies = &self.system.tree.bodies;
            let body = bodies.iter().find(|body| body.dofs().contains(dof))?;
            let motions = body.joint.motions();
            let place = dof - body.first_velocity;
            let turns = motions[place] == Motion::Turn;
            let along = motions[..place].iter().filter(|&&one| one == motions[place]).count();
            let axis = ["x", "y", "z"][along];
            Some(match (motions.len(), turns) {
                (1, _) => body.name.clone(),
                (_, false) => format!("{}.{axis}", body.name),
                (_, true) => format!("{}.r{axis}", body.name),
            })
        };
        self.statics.search.matrix.layout.free.iter().filter_map(name).collect()
    }

    /// Ropes that run over sheaves and off drums that no drive moves: their names, and their degrees of freedom.
    pub fn flows(&self) -> impl Iterator<Item = (&str, usize)> {
        let free = &self.statics.search.matrix.layout.free;
        let flows = self.system.tree.bodies.iter().filter(|body| !body.joint.moves_body());
        flows.map(|body| (body.name.as_str(), body.first_velocity)).filter(|(_, dof)| free.contains(dof))
    }

    /// What is asked of a rope or body by a kind, such as `length` or `centre_x`, and its name.
    ///
    /// # Errors
    /// A sentence where there is no such kind, rope or body, or the length of the rope is not that of the plan.
    pub fn parameter(&self, kind: &str, name: &str) -> Result<Parameter, String> {
        let missing = || format!("there is no {name} to ask the {kind} of");
        let rope = || {
            let rope = self.rope(name).ok_or_else(missing)?;
            let why = "a drum or a sheave feeds it, so that its length is not that of the plan";
            if self.is_fed(rope) {
                Err(format!("there is no sensitivity to the {kind} of {name}: {why}"))
            } else {
                Ok(rope)
            }
        };
        let body = || self.body(name).ok_or_else(missing);
        let (what, axis) = kind.split_once('_').unwrap_or((kind, ""));
        let axis = ["x", "y", "z"].iter().position(|known| *known == axis);
        Ok(match (what, axis) {
            ("length", None) => Parameter::Length(rope()?),
            ("stiffness", None) => Parameter::Stiffness(rope()?),
            ("mass", None) => Parameter::Mass(body()?),
            ("centre", Some(axis)) => Parameter::Centre(body()?, axis),
            ("place", Some(axis)) => Parameter::Place(body()?, axis),
            _ => return Err(format!("there is no parameter {kind}")),
        })
    }

    /// Whether sheaves with losses or inertia, or drums that no drive moves, change the length of a rope as it comes to
    /// rest. What a drive has fed is a given length.
    fn is_fed(&self, rope: usize) -> bool {
        let AnyConstraint::Rope(rope) = &self.system.constraints[rope] else { return false };
        let free = &self.statics.search.matrix.layout.free;
        let is_given = |span: &Span| span.feeds.iter().all(|feed| !free.contains(&feed.dof));
        rope.spans.len() > 1 || !rope.spans.iter().all(is_given)
    }

    /// Derivatives of the equilibrium that was found last, with contacts that `friction` holds.
    ///
    /// # Errors
    /// As [`Statics::sensitivities`].
    pub fn sensitivities(
        &mut self,
        parameters: &[Parameter],
        friction: Friction,
    ) -> Result<Vec<Sensitivity>, NoEquilibrium> {
        self.statics.sensitivities(&self.system, &self.state, parameters, friction)
    }

    /// The equilibrium that was found last swings in a mode: one period of `frames` samples in which the shape goes
    /// from −`amplitude` to `amplitude`. A motion that leads away, or that nothing holds, is shown alike, in 1 s.
    pub fn swing(&mut self, mode: &Mode, amplitude: f64, frames: usize) {
        let omega = if mode.square > super::NEUTRAL { mode.square.sqrt() } else { std::f64::consts::TAU };
        let period = std::f64::consts::TAU / omega;
        self.samples = Samples::default();
        for frame in 0..frames {
            let time = period * frame as f64 / (frames.max(2) - 1) as f64;
            let (sine, cosine) = (omega * time).sin_cos();
            let mut state = self.state.clone();
            let along = |factor: f64| -> Vec<f64> { mode.shape.iter().map(|x| factor * x).collect() };
            self.system.tree.advance(&mut state.q, &along(amplitude * sine));
            state.v = along(amplitude * omega * cosine);
            state.acceleration = along(-amplitude * omega * omega * sine);
            let changes = state.tension.iter_mut().zip(&mode.tension).filter(|(_, change)| **change != 0.0);
            for (tension, change) in changes {
                *tension = (*tension + amplitude * sine * change).max(0.0);
            }
            state.time = time;
            self.samples.push_state(&self.system, time, &state);
            self.note_tensions(&state);
        }
    }

    fn note_tensions(&mut self, state: &State) {
        let State { tension, q, time, .. } = state;
        let frame = placed(&self.system, state);
        let now = |row: usize| self.system.curved_tension(row, tension[row], &frame.kinematics);
        let peak = |row: usize, known: f64| Some((now(row), *time)).filter(|now| now.0 > known);
        self.samples.note_lines(&self.system, &frame.kinematics, state);
        self.samples.note_peaks(&self.system, q, peak);
    }

    /// The system.
    pub fn system(&self) -> &System {
        &self.system
    }

    /// The state found last.
    pub fn state(&self) -> &State {
        &self.state
    }

    /// Samples of the equilibrium or swing found last.
    pub fn samples(&self) -> &Samples {
        &self.samples
    }

    /// Everything that follows from them.
    pub fn columns(&self) -> Columns {
        let mut log = EventLog::new();
        self.changed().for_each(|event| log.push(event.time, event.kind, event.subject));
        Columns::of(&self.system, &self.samples, &log)
    }

    /// Slings and pins that are on by now and were not at the start, those that were and are not, and ropes that have been
    /// cut. Of an equilibrium that is so in all samples.
    fn changed(&self) -> impl Iterator<Item = Event> {
        let Self { system, state, .. } = self;
        let mode = |one: &Switching| state.modes[system.rows.first[one.constraint]];
        let event = |one: &Switching, kind| Event { time: 0.0, kind, subject: one.constraint };
        let slings = system.slings.iter().filter_map(move |sling| {
            let is_on = mode(sling) != RowMode::Off;
            let kind = if is_on { EventKind::Attached } else { EventKind::Detached };
            (is_on != sling.starts_on).then(|| event(sling, kind))
        });
        let pins = system.pins.iter().filter_map(move |pin| {
            let is_in = mode(pin) == RowMode::Acting;
            let kind = if is_in { EventKind::PinPutIn } else { EventKind::PinPulled };
            (is_in != pin.starts_on).then(|| event(pin, kind))
        });
        let cuts = system.cuts.iter().filter(|cut| cut.due.is_before(state.time, &state.plan));
        let cuts = cuts.map(|cut| Event { time: 0.0, kind: EventKind::Cut, subject: cut.rope });
        slings.chain(pins).chain(cuts)
    }

    /// Kind and name of the events that say so.
    pub fn events(&self) -> Vec<(&'static str, String)> {
        self.changed().map(|event| (event.kind.name(), event.subject_name(&self.system))).collect()
    }

    /// Names that go with the columns.
    pub fn names(&self) -> Names {
        Names::new(&self.system)
    }

    /// When a step of the plan began and ended on the way to the equilibrium found last [s]; none where it had not.
    pub fn times_of(&self, step: &str) -> [Option<f64>; 2] {
        [EventKind::StepBegin, EventKind::StepEnd].map(|kind| self.step_event(step, kind)?.time(&self.log))
    }

    fn step_event(&self, step: &str, kind: EventKind) -> Option<way::StepEvent> {
        let number = self.system.plan.steps.iter().position(|one| one.name == step)?;
        Some(way::StepEvent { kind, step: number })
    }

    /// Number of a rope.
    fn rope(&self, name: &str) -> Option<usize> {
        let ropes = &self.system.constraints[..self.system.rope_count];
        ropes.iter().position(|rope| rope.name() == name)
    }

    /// Number of a body.
    pub fn body(&self, name: &str) -> Option<usize> {
        self.system.tree.bodies.iter().position(|body| body.name == name)
    }

    /// What the contacts that carry do in the equilibrium found last: name, support force N [N], force of friction on
    /// the body, world axes [N], and the largest that it can be, μN [N].
    pub fn contact_forces(&self) -> Vec<(&str, f64, [f64; 3], f64)> {
        let Self { system, state, .. } = self;
        let kinematics = placed(system, state).kinematics;
        let contacts = system.friction.chunks_exact(2).filter_map(|rows| {
            let Law::Friction { coefficient, normal, .. } = system.rows.laws[rows[0]] else { return None };
            let AnyConstraint::Contact(contact) = system.constraint_of_row(normal) else { return None };
            let [one, other] = contact.tangents(&kinematics);
            let force = -(one * state.tension[rows[0]] + other * state.tension[rows[1]]);
            let pressed = state.tension[normal];
            Some((contact.name.as_str(), pressed, force.to_array(), coefficient * pressed))
        });
        contacts.filter(|(_, pressed, ..)| *pressed > 0.0).collect()
    }

    /// What slid on the way to the equilibrium found last, since its friction found no balance, and when [s]: names of
    /// loads and body contacts.
    pub fn slides(&self) -> Vec<(f64, &str)> {
        let named = |&(time, group): &(f64, usize)| (time, self.system.groups[group].name.as_str());
        self.slides.iter().map(named).collect()
    }

    /// Names of the sheaves with losses, each once: one in whose groove rope may slip has a bearing, too.
    pub fn lossy_sheaves(&self) -> Vec<&str> {
        let grooves: Vec<usize> = self.system.brakes().filter_map(|(_, brake)| brake.spin).collect();
        let lossy = self.system.brakes().filter(|(_, brake)| !brake.grip.is_none());
        let sheaves = lossy.filter(|(_, brake)| !grooves.contains(&brake.dof));
        sheaves.map(|(_, brake)| brake.name.as_str()).collect()
    }
}

/// Where everything is in a state.
fn placed(system: &System, state: &State) -> Frame {
    let mut frame = Frame::new(system);
    frame.kinematics.update(&system.tree, &state.q, 0.0);
    frame
}
