//! Ropes that are cut.

use super::PlanState;

/// When a rope is cut, or a support taken away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Due {
    /// At this time [s].
    At(f64),
    /// As this step of the plan begins.
    Step(usize),
}

impl Due {
    /// True where that is before `to` [s], or its step has begun.
    pub fn is_before(self, to: f64, plan: &PlanState) -> bool {
        match self {
            Self::At(time) => time < to,
            Self::Step(step) => step < plan.begun(),
        }
    }

    /// The time, where it is one and not before `from` [s]; else infinity.
    pub fn time_from(self, from: f64) -> f64 {
        match self {
            Self::At(time) if time >= from => time,
            _ => f64::INFINITY,
        }
    }
}

/// A cut through a rope or mooring line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Index of the rope; mooring lines count on from there.
    pub rope: usize,
    /// When.
    pub due: Due,
}
