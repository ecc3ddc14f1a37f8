//! Where two bodies may touch: a point of one against a plane of the other, or an edge across an edge.
//!
//! Within a step a spot stays as it is in the frames of its two bodies; between steps it is found anew from their
//! shapes ([`crate::stepper::spots`]). A corner over a face is a point against a plane however the bodies slide. Where two
//! edges cross, their crossing moves along both, and within a step too:
//!
//! ```text
//! x = p + s A,  y = o + t B,  (x − y)·A = (x − y)·B = 0      the crossing on either edge
//! n = ± A×B/|A×B|                                            normal, turns with both edges
//! ```
//!
//! p and o are where the edges crossed as the step began, A and B their directions. Along the plane of B and n×B the first
//! body has since slid by t B − s (A + A′)/2 + g (n − n′) against the second, g being the mean of the gaps then and now, A′ and n′
//! A and n as they lay in the second body then: its rate is the velocity of slip at x, but for terms of second order in how far they have
//! turned.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::plane::Plane;
use crate::tree::pose::Pose;

/// Two edges that cross.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Crossing {
    /// Direction of the edge of the body with the point, in its frame.
    pub own: DVec3,
    /// The same in the frame of the body with the plane, as the spot was found.
    pub own_before: DVec3,
    /// Direction of the edge of the body with the plane, in its frame.
    pub other: DVec3,
    /// How far the edges were apart as the spot was found [m].
    pub gap_before: f64,
}

/// A place at which two bodies may touch. Either of them may be the world.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spot {
    /// False where nothing of the other body is near: there is no force.
    pub is_near: bool,
    /// True where the point belongs to the second body and the plane to the first.
    pub is_swapped: bool,
    /// The point [m], in the frame of its body.
    pub point: DVec3,
    /// The plane, in the frame of the other body; its free side is that of the point.
    pub plane: Plane,
    /// Where edges cross; point and plane are then where they did as the spot was found.
    pub crossing: Option<Crossing>,
    /// Which features of the two shapes meet: the same number later is the same place.
    pub feature: u64,
}

/// A spot where its bodies are, in the world.
#[derive(Debug, Clone, Copy)]
pub struct Located {
    /// x [m].
    pub point: DVec3,
    /// How far the body with the point has moved against the other, across the plane and along it [m].
    pub offset: DVec3,
    /// Normal of the plane, towards the point.
    pub normal: DVec3,
    /// Tangents of the plane.
    pub tangents: [DVec3; 2],
    /// Where edges cross.
    pub crossed: Option<Crossed>,
}

/// Two edges that cross, where their bodies are.
#[derive(Debug, Clone, Copy)]
pub struct Crossed {
    /// A and B.
    edges: [DVec3; 2],
    /// 1 where n looks as A×B, −1 where it looks the other way.
    sense: f64,
    /// How far apart they are along n [m].
    gap: f64,
}

impl Spot {
    /// Nothing near.
    pub fn none() -> Self {
        let plane = Plane::new(DVec3::ZERO, DVec3::Z);
        Self { is_near: false, is_swapped: false, point: DVec3::ZERO, plane, crossing: None, feature: 0 }
    }

    /// Edges that cross as if they had been found where they do now; any other spot as it is.
    pub fn anew(&self, poses: [&Pose; 2]) -> Self {
        let Some(Crossing { own, other, .. }) = self.crossing else { return *self };
        let [with_point, with_plane] = if self.is_swapped { [poses[1], poses[0]] } else { poses };
        let Located { point, offset, normal, .. } = self.located(with_point, with_plane);
        let [to_point, to_plane] = [with_point, with_plane].map(|pose| pose.rotation.transpose());
        let gap_before = normal.dot(offset);
        let origin = to_plane * (point - normal * gap_before - with_plane.position);
        let (own_before, normal) = (to_plane * (with_point.rotation * own), to_plane * normal);
        Self {
            point: to_point * (point - with_point.position),
            plane: Plane { point: origin, normal, tangents: [other, normal.cross(other)] },
            crossing: Some(Crossing { own, own_before, other, gap_before }),
            ..*self
        }
    }

    /// True of edges that cross where they have come farther than `way` [m] or turned more than `angle` [rad] since
    /// `other` was found, which is the same crossing.
    pub fn has_run(&self, other: &Self, way: f64, angle: f64) -> bool {
        let (Some(own), Some(its)) = (self.crossing, other.crossing) else { return false };
        let ways = [self.point - other.point, self.plane.point - other.plane.point];
        let turns = [own.own_before - its.own_before, self.plane.normal - other.plane.normal];
        ways.iter().any(|run| run.length() > way) || turns.iter().any(|turn| turn.length() > angle)
    }

    /// The spot with the two bodies at these poses.
    pub fn between(&self, poses: [&Pose; 2]) -> Located {
        let [first, second] = poses;
        if self.is_swapped { self.located(second, first) } else { self.located(first, second) }
    }

    /// Its point and its normal in the world, the normal towards the first body.
    pub fn in_world(&self, poses: [&Pose; 2]) -> (DVec3, DVec3) {
        let Located { point, normal, .. } = self.between(poses);
        (point, if self.is_swapped { -normal } else { normal })
    }

    /// How far the two bodies are apart there [m].
    pub fn gap(&self, poses: [&Pose; 2]) -> f64 {
        let Located { offset, normal, .. } = self.between(poses);
        normal.dot(offset)
    }

    /// The spot with the bodies of its point and its plane at these poses.
    fn located(&self, with_point: &Pose, with_plane: &Pose) -> Located {
        let (point, origin) = (with_point.point(self.point), with_plane.point(self.plane.point));
        let Some(crossing) = self.crossing else {
            let [normal, one, other] = [self.plane.normal, self.plane.tangents[0], self.plane.tangents[1]]
                .map(|local| with_plane.rotation * local);
            let offset = point - origin;
            return Located { point, offset, normal, tangents: [one, other], crossed: None };
        };
        let own = with_point.rotation * crossing.own;
        let [own_before, other, before] =
            [crossing.own_before, crossing.other, self.plane.normal].map(|local| with_plane.rotation * local);
        let across = own.cross(other);
        let sense = across.dot(before).signum();
        let normal = across.normalize() * sense;
        let (apart, along) = (point - origin, own.dot(other));
        let [first, second] = [own, other].map(|edge| apart.dot(edge));
        let s = (along * second - first) / (1.0 - along * along);
        let t = s * along + second;
        let gap = normal.dot(apart);
        let slid = other * t - (own + own_before) * (0.5 * s)
            + (normal - before) * (0.5 * (gap + crossing.gap_before));
        Located {
            point: point + own * s,
            offset: normal * gap + slid.reject_from_normalized(normal),
            normal,
            tangents: [other, normal.cross(other)],
            crossed: Some(Crossed { edges: [own, other], sense, gap }),
        }
    }
}

impl Located {
    /// n, t₁ and t₂ one after the other, with −1 before n: along these the rows measure.
    pub fn directions(&self) -> [DVec3; 3] {
        let [one, other] = self.tangents;
        [-self.normal, one, other]
    }
}

impl Crossed {
    /// How the crossing moves along the edge of the body with the point, and how direction `index` of
    /// [`Located::directions`] turns, as the bodies move so that their points there part by `apart` and turn by `turns`,
    /// the body with the point first.
    pub fn change(&self, at: &Located, apart: DVec3, turns: [DVec3; 2], index: usize) -> (DVec3, DVec3) {
        let [own, other] = self.edges;
        let [own_turns, other_turns] = [turns[0].cross(own), turns[1].cross(other)];
        // Of the points nearest to each other, and what turning the edges does to how they are seen along n.
        let gap = at.normal * self.gap;
        let apart = apart + turns[1].cross(gap);
        let first = apart.dot(own) + gap.dot(own_turns);
        let second = apart.dot(other) + gap.dot(other_turns);
        let along = own.dot(other);
        let moves = own * ((along * second - first) / (1.0 - along * along));
        if index == 1 {
            return (moves, other_turns);
        }
        let across = own_turns.cross(other) + own.cross(other_turns);
        let size = own.cross(other).length();
        let normal_turns = across.reject_from_normalized(at.normal) * (self.sense / size);
        let turned =
            if index == 0 { -normal_turns } else { normal_turns.cross(other) + at.normal.cross(other_turns) };
        (moves, turned)
    }
}
