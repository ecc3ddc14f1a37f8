//! Straight parts that run past sheaves which the rope has left.
//!
//! Values, gradients and forces see such a part as the parts that it takes the place of ([`Route::length_of`]), so
//! their patterns do not change. Its curvature couples its two ends, which no part does: every chord that may come
//! about has a group of its own, empty while it is not there.

use std::ops::Range;

use super::Rope;
use crate::rope::guide::Guide;
use crate::rope::part::Part;
use crate::rope::route::Route;
use crate::rope::seat::Seat;

/// A straight part past one sheave or more.
#[derive(Debug, Clone)]
pub struct Chord {
    /// Guides from its start to its end, without the last.
    pub guides: Range<usize>,
    /// The part.
    pub part: Part,
}

/// All chords of a route: between any two guides with none but sheaves that the rope may leave between them.
pub fn chords_of(route: &Route) -> Vec<Chord> {
    let may_lift_off = |guide: &Guide| matches!(guide, Guide::Sheave { may_lift_off: true, .. });
    let mut chords = Vec::new();
    for from in 0..route.parts.len() {
        let mut to = from + 1;
        while to < route.parts.len() && may_lift_off(&route.guides[to]) {
            to += 1;
            chords.push(Chord { guides: from..to, part: route.between(from, to) });
        }
    }
    chords
}

impl Rope {
    /// How many groups there are: one for every straight part and every chord.
    pub fn groups(&self) -> usize {
        self.parts.len()
    }

    /// The straight part or chord of a group.
    pub(super) fn part(&self, group: usize) -> &Part {
        let parts = &self.route.parts;
        if group < parts.len() { &parts[group] } else { &self.chords[group - parts.len()].part }
    }

    /// True where the rope runs along the part or chord of a group now.
    pub(super) fn is_there(&self, group: usize, seats: &[Seat]) -> bool {
        if self.chords.is_empty() {
            return true;
        }
        let parts = self.route.parts.len();
        let (from, to) = match group.checked_sub(parts) {
            None => (group, group + 1),
            Some(chord) => (self.chords[chord].guides.start, self.chords[chord].guides.end),
        };
        let is_lifted = |guide: usize| self.route.guides[guide].is_lifted(seats);
        !is_lifted(from) && !is_lifted(to) && (from + 1..to).all(is_lifted)
    }
}
