//! What a rope passes: dead ends, eyes, half turns, sheaves with true tangents; where its straight parts end on them,
//! and the arcs between.

use std::f64::consts::PI;

use glam::DVec3;

use super::part::Straight;
use super::seat::{Seat, Winding, fleet_angle, wrap_angle};
use super::tangency::Circle;
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
    pub(super) fn circle(&self, kinematics: &Kinematics) -> Circle {
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
    pub(super) fn arc_to_mark(&self, kinematics: &Kinematics, seats: &[Seat], side: ArcSide) -> f64 {
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
    pub(super) fn wound(
        &self,
        kinematics: &Kinematics,
        seats: &[Seat],
        before: &Straight,
        after: &Straight,
    ) -> Winding {
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
pub(super) enum ArcSide<'a> {
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
