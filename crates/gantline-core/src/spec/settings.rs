//! How a run is made: start, method, sampling.

use serde::Deserialize;

/// How a system is run.
#[derive(Debug, Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SettingsSpec {
    /// The method.
    pub integrator: IntegratorSpec,
    /// Simulated time [s].
    pub duration: f64,
    /// Time between samples of the recording [s].
    pub sample_interval: f64,
    /// Where it starts from.
    #[serde(default)]
    pub start: StartSpec,
}

/// Where a run starts from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StartSpec {
    /// The positions and velocities of the document.
    #[default]
    AsGiven,
    /// The equilibrium downhill of its positions.
    Rest,
}

/// Integrators.
#[derive(Debug, Clone, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum IntegratorSpec {
    /// Error-controlled steps of high order.
    Adaptive {
        /// Error of rope tensions allowed in a step [N]; none is a share of the weight per rope.
        #[serde(default)]
        tension_tolerance: Option<f64>,
        /// Error of positions allowed in a step [m]; none is the default.
        #[serde(default)]
        position_tolerance: Option<f64>,
    },
    /// Discrete Euler–Lagrange, fixed step.
    Del {
        /// Step h [s].
        step: f64,
        /// Bare eq. (15): no geometric stiffness.
        #[serde(default)]
        paper: bool,
        /// Geometric stiffness of taut ropes in the tangent.
        #[serde(default = "yes")]
        geometric_stiffness: bool,
    },
    /// Semi-implicit Euler, fixed step: a baseline.
    Explicit {
        /// Step h [s].
        step: f64,
    },
}

fn yes() -> bool {
    true
}
