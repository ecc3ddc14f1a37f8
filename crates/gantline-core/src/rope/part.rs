//! Straight parts of a rope, between the points or circles that two guides offer.

use glam::DVec3;

use super::guide::Anchor;
use super::tangency::{Circle, NoTangent, common_tangent};
use crate::tree::kinematics::Kinematics;

/// A straight part of a rope between two guides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Where it starts.
    pub from: Anchor,
    /// Where it ends.
    pub to: Anchor,
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

/// Direction and length of a vector; the direction of none is zero.
#[inline]
pub fn unit(span: DVec3) -> (DVec3, f64) {
    let length = span.length();
    (if length > 0.0 { span * (1.0 / length) } else { DVec3::ZERO }, length)
}
