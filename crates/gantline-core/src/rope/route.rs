//! The way of a rope: straight parts between guides, arcs on guides.
//!
//! g = Σ straight parts + Σ arcs − L  (paper eq. 19). The gradient of a part and of the arcs that it ends needs
//! only its end points, the vector e by which the length answers to their motion as if they were fixed in their
//! bodies, and a couple on each end: e is the direction and the couples are zero between fixed points and in
//! plane reeving; with a fleet angle both have a small share more ([`super::tangency`]). A new kind of guide
//! therefore only has to say where its parts start and end.

use std::f64::consts::PI;
use std::ops::Range;

use glam::DVec3;

use super::seat::{Seat, Winding, fleet_angle, wrap_angle};
use super::tangency::{Circle, NoTangent, common_tangent};
use crate::tree::kinematics::Kinematics;

/// A point of a body, or of the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attachment {
    /// Index of the body; none is the world.
    pub body: Option<usize>,
    /// Point [m] in the body frame.
    pub at: DVec3,
}

/// What a rope passes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Guide {
    /// A dead end.
    End(Attachment),
    /// The paper's sheave: rope arrives and leaves at points fixed in the body, half a turn apart.
    HalfTurn {
        /// Where the rope arrives.
        enter: Attachment,
        /// Where the rope goes on.
        leave: Attachment,
        /// Unit vector in the body frame to the side of the arc.
        bulge: DVec3,
    },
    /// An eye or shackle that the rope slides through: a sheave of radius zero, with a point for a circle.
    Eye(Attachment),
    /// A sheave as it is: the rope touches its circle along true common tangents, with the wrap that results.
    Sheave {
        /// Its centre.
        centre: Attachment,
        /// Unit axis in the body frame; the rope runs about it.
        axis: DVec3,
        /// Radius of the rope's centre line [m].
        radius: f64,
        /// Its number among the sheaves of the system, whose [`Seat`] it has.
        seat: usize,
        /// True where the rope runs straight past once it is off; else it is followed as if the arc were negative.
        may_lift_off: bool,
        /// Unit radius in the body frame at which one span of the rope ends and the next begins: with losses or
        /// inertia, the middle of the arc at the start.
        mark: Option<DVec3>,
    },
}

/// What a straight part ends at: a point, or a sheave that it touches.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Anchor {
    /// The point, or the sheave's centre.
    pub at: Attachment,
    /// Axis in the body frame and radius [m] of a sheave.
    pub sheave: Option<(DVec3, f64)>,
}

impl Anchor {
    /// The circle in the world, radius 0 for a point.
    fn circle(&self, kinematics: &Kinematics) -> Circle {
        let centre = kinematics.point(self.at.body, self.at.at);
        match self.sheave {
            None => Circle::point(centre),
            Some((axis, radius)) => Circle { centre, axis: kinematics.turn(self.at.body, axis), radius },
        }
    }
}

impl Guide {
    /// Where the part before this guide ends.
    pub fn arrival(&self) -> Anchor {
        match *self {
            Self::End(at) | Self::Eye(at) | Self::HalfTurn { enter: at, .. } => Anchor { at, sheave: None },
            Self::Sheave { centre: at, axis, radius, .. } => Anchor { at, sheave: Some((axis, radius)) },
        }
    }

    /// Where the part after this guide starts.
    pub fn departure(&self) -> Anchor {
        match *self {
            Self::HalfTurn { leave: at, .. } => Anchor { at, sheave: None },
            _ => self.arrival(),
        }
    }

    /// Length of rope on the guide [m] where it does not change: π D/2 for half a turn (paper eq. 19).
    pub fn fixed_arc(&self) -> f64 {
        match self {
            Self::End(_) | Self::Eye(_) | Self::Sheave { .. } => 0.0,
            Self::HalfTurn { enter, leave, .. } => PI * (leave.at - enter.at).length() / 2.0,
        }
    }

    /// True for a sheave with true tangents.
    pub fn is_sheave(&self) -> bool {
        matches!(self, Self::Sheave { .. })
    }

    /// True for a sheave that the rope has left and runs straight past.
    pub fn is_lifted(&self, seats: &[Seat]) -> bool {
        matches!(*self, Self::Sheave { may_lift_off: true, seat, .. } if seats[seat].is_off)
    }

    /// Wrap angle [rad] of a sheave between two parts, negative where the rope is off but followed as if it were
    /// not; π for half a turn.
    pub fn wrap(&self, kinematics: &Kinematics, seats: &[Seat], before: &Straight, after: &Straight) -> f64 {
        match self {
            Self::End(_) | Self::Eye(_) => 0.0,
            Self::HalfTurn { .. } => PI,
            Self::Sheave { centre, axis, seat, .. } => {
                let axis = kinematics.turn(centre.body, *axis);
                wrap_angle(axis, before.radial[1], after.radial[0], seats[*seat].wound.wrap)
            }
        }
    }

    /// Rope on a sheave before its mark, where the part `before` arrives, or after it, where `after` leaves [m]; 0
    /// where no span begins. The mark does not move on its body, so with the point of tangency these arcs change as
    /// those of whole wraps do.
    fn arc_to_mark(&self, kinematics: &Kinematics, seats: &[Seat], side: ArcSide) -> f64 {
        let Self::Sheave { centre, axis, radius, seat, mark: Some(mark), .. } = self else { return 0.0 };
        let [axis, mark] = [*axis, *mark].map(|arm| kinematics.turn(centre.body, arm));
        let Winding { wrap, arrived } = seats[*seat].wound;
        radius
            * match side {
                ArcSide::Before(part) => wrap_angle(axis, part.radial[1], mark, arrived),
                ArcSide::After(part) => wrap_angle(axis, mark, part.radial[0], wrap - arrived),
            }
    }

    /// What is wound on a sheave between two parts.
    fn wound(&self, kinematics: &Kinematics, seats: &[Seat], before: &Straight, after: &Straight) -> Winding {
        let wrap = self.wrap(kinematics, seats, before, after);
        match self {
            Self::Sheave { radius, mark: Some(_), .. } => {
                let arrived = self.arc_to_mark(kinematics, seats, ArcSide::Before(before)) / radius;
                Winding { wrap, arrived }
            }
            _ => Winding { wrap, arrived: 0.5 * wrap },
        }
    }

    /// Angles [rad] of the parts before and after a sheave to its plane, by [`fleet_angle`].
    pub fn fleet(&self, kinematics: &Kinematics, before: &Straight, after: &Straight) -> [f64; 2] {
        let Self::Sheave { centre, axis, .. } = self else { return [0.0; 2] };
        let axis = kinematics.turn(centre.body, *axis);
        [-before.direction, after.direction].map(|outwards| fleet_angle(axis, outwards))
    }

    /// World points along the guide between two parts, for drawing: `samples` + 1 points on an arc, one on an end.
    pub fn draw(
        &self,
        (kinematics, seats): (&Kinematics, &[Seat]),
        parts: [Option<&Straight>; 2],
        samples: usize,
        mut emit: impl FnMut(DVec3),
    ) {
        match (self, parts) {
            (Self::HalfTurn { enter, leave, bulge }, _) => {
                let along = (enter.at - leave.at) / 2.0;
                let across = *bulge * along.length();
                let centre = kinematics.point(enter.body, enter.at - along);
                let [along, across] = [along, across].map(|arm| kinematics.turn(enter.body, arm));
                draw_arc(centre, [along, across], PI, samples, emit);
            }
            (Self::Sheave { .. }, [Some(before), Some(_)]) if self.is_lifted(seats) => {
                (0..=samples).for_each(|_| emit(before.to));
            }
            (Self::Sheave { centre, axis, radius, .. }, [Some(before), Some(after)]) => {
                let wrap = self.wrap(kinematics, seats, before, after);
                let middle = kinematics.point(centre.body, centre.at);
                let axis = kinematics.turn(centre.body, *axis);
                let radial = before.radial[1] * *radius;
                draw_arc(middle, [radial, axis.cross(radial)], wrap, samples, emit);
            }
            (Self::End(at) | Self::Eye(at) | Self::Sheave { centre: at, .. }, _) => {
                emit(kinematics.point(at.body, at.at))
            }
        }
    }

    /// How many points [`Guide::draw`] emits.
    pub fn drawn_points(&self, samples: usize) -> usize {
        match self {
            Self::End(_) | Self::Eye(_) => 1,
            Self::HalfTurn { .. } | Self::Sheave { .. } => samples + 1,
        }
    }
}

/// One of the two arcs that meet at the mark of a sheave, with the straight part that it goes on from.
enum ArcSide<'a> {
    Before(&'a Straight),
    After(&'a Straight),
}

/// Points at equal angles from `first` on towards `second`, both seen from the centre and of the circle's radius.
fn draw_arc(
    centre: DVec3,
    [first, second]: [DVec3; 2],
    angle: f64,
    samples: usize,
    mut emit: impl FnMut(DVec3),
) {
    // Turned on from point to point: a sine and a cosine for each would cost more than all else of a sample.
    let (sin, cos) = (angle / samples as f64).sin_cos();
    let (mut along, mut across) = (first, second);
    for _ in 0..=samples {
        emit(centre + along);
        (along, across) = (along * cos + across * sin, across * cos - along * sin);
    }
}

/// A straight part of a rope between two guides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Where it starts.
    pub from: Anchor,
    /// Where it ends.
    pub to: Anchor,
}

/// A straight part in the world.
#[derive(Debug, Clone, Copy)]
pub struct Straight {
    /// Start [m].
    pub from: DVec3,
    /// End [m].
    pub to: DVec3,
    /// Unit vector from start to end; zero where both coincide.
    pub direction: DVec3,
    /// Length [m].
    pub length: f64,
    /// e: how the length, arcs included, answers to relative motion of the ends.
    pub pull: DVec3,
    /// How it answers to rotation of the two bodies about the end points [m].
    pub couple: [DVec3; 2],
    /// Unit vectors from the centres of sheaves to the ends; zero for points.
    pub radial: [DVec3; 2],
}

impl Straight {
    fn between(start: &Circle, end: &Circle) -> Result<Self, NoTangent> {
        let tangent = common_tangent(start, end)?;
        Ok(Self {
            from: tangent.from,
            to: tangent.to,
            direction: tangent.direction,
            length: tangent.length,
            pull: tangent.pull,
            couple: tangent.couple,
            radial: tangent.radial,
        })
    }

    #[inline]
    fn from_point_to_point(from: DVec3, to: DVec3) -> Self {
        let (direction, length) = unit(to - from);
        let none = [DVec3::ZERO; 2];
        Self { from, to, direction, length, pull: direction, couple: none, radial: none }
    }
}

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

/// Direction and length of a vector; the direction of none is zero.
#[inline]
pub fn unit(span: DVec3) -> (DVec3, f64) {
    let length = span.length();
    (if length > 0.0 { span * (1.0 / length) } else { DVec3::ZERO }, length)
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

impl Part {
    /// True between fixed points: no sheave at either end.
    pub fn is_plain(&self) -> bool {
        self.from.sheave.is_none() && self.to.sheave.is_none()
    }

    /// Where the part lies now. Where sheaves have no common tangent nothing is a number: such a position is refused
    /// at the start, and a step that leads there is not made.
    #[inline]
    pub fn locate(&self, kinematics: &Kinematics) -> Straight {
        if self.is_plain() {
            let [from, to] = self.points(kinematics);
            return Straight::from_point_to_point(from, to);
        }
        let nowhere = Straight::from_point_to_point(DVec3::NAN, DVec3::NAN);
        self.tangent(kinematics, |_, circle| circle).unwrap_or(nowhere)
    }

    /// Where the part starts and ends now, which is all that [`Part::locate`] has to know between fixed points.
    pub fn ends(&self, kinematics: &Kinematics) -> [DVec3; 2] {
        if self.is_plain() {
            return self.points(kinematics);
        }
        let Straight { from, to, .. } = self.locate(kinematics);
        [from, to]
    }

    /// The points, or centres, between which it is.
    #[inline]
    fn points(&self, kinematics: &Kinematics) -> [DVec3; 2] {
        [self.from.at, self.to.at].map(|end| kinematics.point(end.body, end.at))
    }

    /// The part with its circles (0 the start's, 1 the end's) moved by `displace`.
    ///
    /// # Errors
    /// [`NoTangent`] where the circles have no common tangent.
    pub fn tangent(
        &self,
        kinematics: &Kinematics,
        displace: impl Fn(usize, Circle) -> Circle,
    ) -> Result<Straight, NoTangent> {
        let start = displace(0, self.from.circle(kinematics));
        let end = displace(1, self.to.circle(kinematics));
        Straight::between(&start, &end)
    }
}
