//! Methods: one file per integrator.

pub mod adaptive;
pub mod adjust;
pub mod coils;
pub mod del;
pub mod explicit;
pub(crate) mod flows;
pub mod frame;
mod loosening;
mod parting;
mod pinning;
mod removing;
pub mod seats;
pub mod slinging;
pub mod spots;

use thiserror::Error;

/// An inextensible rope whose ends come closer by more than this [m/s] loosens; less is rounding.
pub(crate) const STANDSTILL: f64 = 1e-9;

/// What one step says of itself.
#[derive(Debug, Clone, Copy, Default)]
pub struct StepReport {
    /// Largest distance of a force from its law [N].
    pub complementarity_residual: f64,
    /// Factorisations made.
    pub factorisations: u64,
    /// Attempts whose error was too large.
    pub rejected: u64,
    /// True where the step was cut at a change of modes.
    pub cut: bool,
    /// False where the complementarity iteration was capped.
    pub converged: bool,
}

/// Why a step could not be made.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("at t = {time:.6} s the simulation cannot go on: {cause} ({element})")]
pub struct StepError {
    /// Start of the step that failed [s].
    pub time: f64,
    /// Body, rope or contact concerned.
    pub element: String,
    /// Likely cause.
    pub cause: String,
}

/// The matrix of a step has a zero pivot at `element`.
fn singular(time: f64, element: String) -> StepError {
    let cause = "the equations are singular here: a body without inertia in a direction that it can move, or an \
                 inextensible rope that repeats another";
    StepError { time, element, cause: cause.to_owned() }
}
