//! Locking pins that steps of the plan pull and put in.

/// A pin, and what the plan does to it.
#[derive(Debug, Clone, PartialEq)]
pub struct Pinning {
    /// Index of its constraint.
    pub pin: usize,
    /// True where it is in at the start.
    pub starts_in: bool,
    /// Steps of the plan that put it in (true) or pull it (false) as they begin, ascending.
    pub changes: Vec<(usize, bool)>,
}

impl Pinning {
    /// Whether it is to be in when so many steps have begun, and the step that said so, if one did.
    pub fn wanted(&self, begun: usize) -> (bool, Option<usize>) {
        let last = self.changes.iter().rev().find(|(step, _)| *step < begun);
        last.map_or((self.starts_in, None), |&(step, is_in)| (is_in, Some(step)))
    }
}
