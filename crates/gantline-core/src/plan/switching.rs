//! What steps of the plan put in or on, and take out or off again: locking pins, slings.

/// A pin, or a rope between two ends, and what the plan does to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Switching {
    /// Index of its constraint.
    pub constraint: usize,
    /// True where it is there at the start.
    pub starts_on: bool,
    /// Steps of the plan that put it there (true) or take it away (false) as they begin, ascending.
    pub changes: Vec<(usize, bool)>,
}

impl Switching {
    /// Whether it is to be there when so many steps have begun, and the step that said so, if one did.
    pub fn wanted(&self, begun: usize) -> (bool, Option<usize>) {
        let last = self.changes.iter().rev().find(|(step, _)| *step < begun);
        last.map_or((self.starts_on, None), |&(step, is_on)| (is_on, Some(step)))
    }
}
