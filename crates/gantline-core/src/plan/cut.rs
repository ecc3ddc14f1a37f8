//! Ropes that are cut.

/// When a rope is cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Due {
    /// At this time [s].
    At(f64),
    /// As this step of the plan begins.
    Step(usize),
}

/// A cut through a rope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// Index of the rope.
    pub rope: usize,
    /// When.
    pub due: Due,
}
