//! The integrator of a run, and what a run asks of any of them.

use super::{SetupError, above_zero};
use crate::record::pulls::Bearers;
use crate::record::{Sample, Span};
use crate::spec::IntegratorSpec;
use crate::state::State;
use crate::stepper::adaptive::{Adaptive, Tolerance};
use crate::stepper::del::Del;
use crate::stepper::explicit::Explicit;
use crate::stepper::frame::Frame;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// The integrator of a run.
#[derive(Debug, Clone)]
pub enum Method {
    /// `del`.
    Del(Box<Del>),
    /// `explicit`.
    Explicit(Box<Explicit>),
    /// `adaptive`.
    Adaptive(Box<Adaptive>),
}

impl Method {
    /// The one that settings ask for.
    ///
    /// # Errors
    /// [`SetupError::Setting`] where it cannot simulate this system, or not with these settings.
    pub fn new(system: &System, frame: &Frame, spec: &IntegratorSpec) -> Result<Self, SetupError> {
        match *spec {
            IntegratorSpec::Del { step, paper, geometric_stiffness } => {
                above_zero("the step", step, "s")?;
                Ok(Self::Del(Box::new(Del::new(system, step, geometric_stiffness && !paper))))
            }
            IntegratorSpec::Explicit { step } => {
                if let Some(problem) = Explicit::refusal(system) {
                    return Err(SetupError::Setting(problem));
                }
                above_zero("the step", step, "s")?;
                Ok(Self::Explicit(Box::new(Explicit::new(system, step))))
            }
            IntegratorSpec::Adaptive { tension_tolerance, position_tolerance } => {
                if let Some(adjuster) = system.adjusters.first() {
                    let problem = format!(
                        "the integrator adaptive chooses its steps, but {} adjusts lengths once per step, which has a \
                         meaning for a fixed step only; use del or explicit",
                        adjuster.name
                    );
                    return Err(SetupError::Setting(problem));
                }
                let default = Tolerance::default_of(system);
                let tolerance = Tolerance {
                    tension: tension_tolerance.unwrap_or(default.tension),
                    position: position_tolerance.unwrap_or(default.position),
                };
                above_zero("the tension tolerance", tolerance.tension, "N")?;
                above_zero("the position tolerance", tolerance.position, "m")?;
                Ok(Self::Adaptive(Box::new(Adaptive::new(system, frame, tolerance))))
            }
        }
    }

    /// Forgets what belongs to the state of the last step, which something else has changed since.
    pub fn forget(&mut self) {
        match self {
            Self::Del(_) | Self::Explicit(_) => {}
            Self::Adaptive(adaptive) => adaptive.forget(),
        }
    }

    /// Motion and forces at a share of the step that has been made.
    pub fn course(&mut self, system: &System, span: &Span, share: f64, sample: &mut Sample) {
        match self {
            Self::Del(del) => del.interpolate(system, (span.before, span.after), share, sample),
            Self::Explicit(explicit) => {
                explicit.interpolate(system, (span.before, span.after), share, sample)
            }
            Self::Adaptive(adaptive) => adaptive.interpolate(system, span.before, share, sample),
        }
    }

    /// The largest force of a row in the step that has been made [N], of a rope with a curve its tension, and when [s],
    /// where it is more than `known`. `kinematics` are those after it.
    pub fn peak(
        &self,
        (system, kinematics): (&System, &Kinematics),
        (before, after): (&State, &State),
        row: usize,
        known: f64,
    ) -> Option<(f64, f64)> {
        match self {
            Self::Del(_) | Self::Explicit(_) => {
                let now = system.curved_tension(row, after.tension[row], kinematics);
                (now > known).then_some((now, after.time))
            }
            Self::Adaptive(adaptive) => {
                let (force, share) = adaptive.peak(row, known)?;
                Some((force, before.time + share * (after.time - before.time)))
            }
        }
    }

    /// The largest that rows have borne together in the step that has been made, and the share of the step at which it
    /// was, where it is more than `known`. `kinematics` are those after it.
    pub fn pull(
        &self,
        (system, kinematics): (&System, &Kinematics),
        after: &State,
        bearers: &Bearers,
        known: f64,
    ) -> Option<(f64, f64)> {
        match self {
            Self::Del(_) | Self::Explicit(_) => {
                let of = |row: usize| system.curved_tension(row, after.tension[row], kinematics);
                let now = bearers.together(of);
                (now > known).then_some((now, 1.0))
            }
            Self::Adaptive(adaptive) => adaptive.pull(bearers, known),
        }
    }

    /// Entries of the factor of the step's matrix.
    pub fn fill(&self) -> usize {
        match self {
            Self::Del(del) => del.fill(),
            Self::Explicit(explicit) => explicit.fill(),
            Self::Adaptive(adaptive) => adaptive.fill(),
        }
    }
}
