//! Supports that are taken away.

use super::Due;

/// A support that is taken away.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Removal {
    /// Index of its touch.
    pub touch: usize,
    /// When.
    pub due: Due,
}
