//! The way of a rope: straight parts between guides, arcs on guides.
//!
//! g = Σ straight parts + Σ arcs − L  (paper eq. 19). The gradient of a part and of the arcs that it ends needs
//! only its end points, the vector e by which the length answers to their motion as if they were fixed in their
//! bodies, and a couple on each end: e is the direction and the couples are zero between fixed points and in
//! plane reeving; with a fleet angle both have a small share more ([`super::tangency`]). A new kind of guide
//! therefore only has to say where its parts start and end.

use std::ops::Range;

use glam::DVec3;

use super::guide::{ArcSide, Guide};
use super::part::{Part, Straight};
use super::seat::{Seat, Winding};
use super::tangency::NoTangent;
use crate::tree::kinematics::Kinematics;

/// Ordered guides from end to end.
#[derive(Debug, Clone)]
pub struct Route {
    /// The guides.
    pub guides: Vec<Guide>,
    /// The straight parts between them.
    pub parts: Vec<Part>,
    /// Σ arcs of half turns [m].
    pub arcs: f64,
    /// True where no part ends on a sheave with true tangents.
    pub is_plain: bool,
    /// True where the rope may leave some sheave.
    may_lift_off: bool,
}

impl Route {
    /// A route over `guides`, the first and the last of which are ends.
    pub fn new(guides: Vec<Guide>) -> Self {
        let between = |pair: &[Guide]| Part { from: pair[0].departure(), to: pair[1].arrival() };
        let parts: Vec<Part> = guides.windows(2).map(between).collect();
        let arcs = guides.iter().map(Guide::fixed_arc).sum();
        let is_plain = parts.iter().all(Part::is_plain);
        let may_lift_off =
            guides.iter().any(|guide| matches!(guide, Guide::Sheave { may_lift_off: true, .. }));
        Self { guides, parts, arcs, is_plain, may_lift_off }
    }

    /// Length along the route [m], parts and arcs, with the parts as they lie; `each` sees every part.
    pub fn length(&self, kinematics: &Kinematics, seats: &[Seat], each: impl FnMut(usize, &Straight)) -> f64 {
        self.arcs + self.length_of(0..self.parts.len(), kinematics, seats, each)
    }

    /// Length of some parts [m] and of the wraps between them, to the marks of the sheaves at their ends, without half
    /// turns.
    pub fn length_of(
        &self,
        parts: Range<usize>,
        kinematics: &Kinematics,
        seats: &[Seat],
        mut each: impl FnMut(usize, &Straight),
    ) -> f64 {
        let mut length = 0.0;
        let mut before: Option<Straight> = None;
        let mut index = parts.start;
        while index < parts.end {
            let next = self.next_seated(index, parts.end, seats);
            let straight = self.between(index, next).locate(kinematics);
            length += match (&before, &self.guides[index]) {
                (Some(before), Guide::Sheave { radius, .. }) => {
                    radius * self.guides[index].wrap(kinematics, seats, before, &straight)
                }
                (None, guide) => guide.arc_to_mark(kinematics, seats, ArcSide::After(&straight)),
                _ => 0.0,
            };
            length += straight.length;
            if next == parts.end {
                length += self.guides[next].arc_to_mark(kinematics, seats, ArcSide::Before(&straight));
            }
            if next == index + 1 {
                each(index, &straight);
            } else {
                self.past(index..next, kinematics, &straight, &mut each);
            }
            before = Some(straight);
            index = next;
        }
        length
    }

    /// The first guide after `index`, but not after `last`, that the rope touches.
    fn next_seated(&self, index: usize, last: usize, seats: &[Seat]) -> usize {
        if !self.may_lift_off {
            return index + 1;
        }
        (index + 1..last).find(|&next| !self.guides[next].is_lifted(seats)).unwrap_or(last)
    }

    /// The straight part between two guides, those between them passed by.
    pub fn between(&self, from: usize, to: usize) -> Part {
        if to == from + 1 {
            return self.parts[from];
        }
        Part { from: self.guides[from].departure(), to: self.guides[to].arrival() }
    }

    /// Shows `each` a straight part that runs past sheaves as the parts that it takes the place of: they meet where
    /// it is closest to each centre, as if it were held there by the sheave's body. What both parts do to that body
    /// cancels, and each is in balance by itself, so that whoever treats parts one by one need not know.
    fn past(
        &self,
        parts: Range<usize>,
        kinematics: &Kinematics,
        whole: &Straight,
        each: &mut impl FnMut(usize, &Straight),
    ) {
        let mut piece = Straight { radial: [whole.radial[0], DVec3::ZERO], ..*whole };
        for index in parts.clone() {
            let is_last = index + 1 == parts.end;
            if is_last {
                (piece.to, piece.couple[1], piece.radial[1]) = (whole.to, whole.couple[1], whole.radial[1]);
            } else {
                let at = self.guides[index + 1].arrival().at;
                let along = (kinematics.point(at.body, at.at) - piece.from).dot(whole.direction);
                let rest = (whole.to - piece.from).dot(whole.direction);
                piece.to = piece.from + whole.direction * along.clamp(0.0, rest.max(0.0));
                piece.couple[1] = -piece.couple[0] - (piece.to - piece.from).cross(whole.pull);
            }
            piece.length = (piece.to - piece.from).length();
            each(index, &piece);
            (piece.from, piece.couple[0], piece.radial[0]) = (piece.to, -piece.couple[1], DVec3::ZERO);
        }
    }

    /// What is wound on the sheaves as the parts lie, or would be if a sheave that has been left were touched; `each`
    /// sees every seat with it. A sheave that a tangent cannot reach keeps its wrap.
    pub fn wraps(&self, kinematics: &Kinematics, seats: &[Seat], mut each: impl FnMut(usize, Winding)) {
        for (index, guide) in self.guides.iter().enumerate() {
            if let Guide::Sheave { seat, .. } = *guide
                && let Some(wound) = self.wound(index, kinematics, seats)
            {
                each(seat, wound);
            }
        }
    }

    /// What is wound on the sheave at `index` of the guides, as [`Route::wraps`] says; none where a tangent cannot
    /// reach it.
    pub fn wound(&self, index: usize, kinematics: &Kinematics, seats: &[Seat]) -> Option<Winding> {
        let last = self.guides.len() - 1;
        let touched = (1..index).rev().find(|&before| !self.guides[before].is_lifted(seats)).unwrap_or(0);
        let next = self.next_seated(index, last, seats);
        let tangent = |from, to| self.between(from, to).tangent(kinematics, |_, circle| circle).ok();
        let (before, after) = (tangent(touched, index)?, tangent(index, next)?);
        Some(self.guides[index].wound(kinematics, seats, &before, &after))
    }

    /// The first part without a tangent as the rope lies, and why.
    pub fn refusal(&self, kinematics: &Kinematics, seats: &[Seat]) -> Option<(usize, NoTangent)> {
        let mut index = 0;
        while index < self.parts.len() {
            let next = self.next_seated(index, self.parts.len(), seats);
            let part = self.between(index, next);
            if let (false, Err(reason)) = (part.is_plain(), part.tangent(kinematics, |_, circle| circle)) {
                return Some((index, reason));
            }
            index = next;
        }
        None
    }
}
