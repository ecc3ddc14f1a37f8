//! The way of a rope: straight parts between guides, arcs on guides.
//!
//! g = Σ straight parts + Σ arcs − L  (paper eq. 19). The gradient needs only the ends of the straight
//! parts and their directions: moving an end along its body changes the length by the direction's
//! projection, whether the end is fixed in the body or is a tangent point (there the length is
//! stationary). A new kind of guide therefore only has to say where its parts start and end.

use std::f64::consts::PI;

use glam::DVec3;

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
}

impl Guide {
    /// Where the part before this guide ends.
    pub fn arrival(&self) -> Attachment {
        match self {
            Self::End(point) => *point,
            Self::HalfTurn { enter, .. } => *enter,
        }
    }

    /// Where the part after this guide starts.
    pub fn departure(&self) -> Attachment {
        match self {
            Self::End(point) => *point,
            Self::HalfTurn { leave, .. } => *leave,
        }
    }

    /// Length of rope on the guide [m]: π D/2 for half a turn (paper eq. 19).
    pub fn arc(&self) -> f64 {
        match self {
            Self::End(_) => 0.0,
            Self::HalfTurn { enter, leave, .. } => PI * (leave.at - enter.at).length() / 2.0,
        }
    }

    /// World points along the guide, for drawing: `samples` + 1 points on an arc, one on an end.
    pub fn draw(&self, kinematics: &Kinematics, samples: usize, mut emit: impl FnMut(DVec3)) {
        match self {
            Self::End(point) => emit(kinematics.point(point.body, point.at)),
            Self::HalfTurn { enter, leave, bulge } => {
                let centre = (enter.at + leave.at) / 2.0;
                let along = enter.at - centre;
                let across = *bulge * along.length();
                for sample in 0..=samples {
                    let (sin, cos) = (PI * sample as f64 / samples as f64).sin_cos();
                    emit(kinematics.point(enter.body, centre + along * cos + across * sin));
                }
            }
        }
    }

    /// How many points [`Guide::draw`] emits.
    pub fn drawn_points(&self, samples: usize) -> usize {
        match self {
            Self::End(_) => 1,
            Self::HalfTurn { .. } => samples + 1,
        }
    }
}

/// A straight part of a rope between two guides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Part {
    /// Where it starts.
    pub from: Attachment,
    /// Where it ends.
    pub to: Attachment,
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
}

/// Ordered guides from end to end.
#[derive(Debug, Clone)]
pub struct Route {
    /// The guides.
    pub guides: Vec<Guide>,
    /// The straight parts between them.
    pub parts: Vec<Part>,
    /// Σ arcs [m].
    pub arcs: f64,
}

impl Route {
    /// A route over `guides`, the first and the last of which are ends.
    pub fn new(guides: Vec<Guide>) -> Self {
        let parts =
            guides.windows(2).map(|pair| Part { from: pair[0].departure(), to: pair[1].arrival() }).collect();
        let arcs = guides.iter().map(Guide::arc).sum();
        Self { guides, parts, arcs }
    }
}

impl Part {
    /// Where the part lies now.
    pub fn locate(&self, kinematics: &Kinematics) -> Straight {
        let from = kinematics.point(self.from.body, self.from.at);
        let to = kinematics.point(self.to.body, self.to.at);
        let span = to - from;
        let length = span.length();
        let direction = if length > 0.0 { span / length } else { DVec3::ZERO };
        Straight { from, to, direction, length }
    }
}
