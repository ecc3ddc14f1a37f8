//! Methods: one file per integrator.

pub mod del;
mod flows;
pub mod frame;

use thiserror::Error;

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
