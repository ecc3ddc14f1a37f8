//! The places at which a post and a wall may touch: every rim on every face, every edge on every side.

use glam::DVec3;

use super::{Beside, Near, Post, Wall};
use crate::contact::plane::Plane;
use crate::contact::shape::Meeting;
use crate::contact::spot::Spot;
use crate::tree::pose::Pose;

/// By how much what has another direction than where they touch counts farther away [m], and from which share on, (LG9).
const TURNED: f64 = 2.0;
const ALONG: f64 = 2e-4;
/// Rounding of a place [m].
pub const ROUNDING: f64 = 1e-12;

/// Where a rim lies along a face, or an edge along a side.
#[derive(Clone, Copy)]
pub struct Place {
    /// The rim's or the edge's point in the world [m].
    pub point: DVec3,
    /// Normal of the plane along which it lies, out of the post or the wall that has it, and how far apart they are [m].
    pub normal: DVec3,
    pub gap: f64,
    /// How far apart they are if this is one end of a line [m]; none where no such end can be.
    pub beside: Option<f64>,
    /// Whether the plane parts them: no rim or edge lies farther on.
    pub parts: bool,
    /// As [`Near::left`].
    left: f64,
    /// Whether it is a point of the wall.
    pub is_edge: bool,
    /// Which rim on which face, or which edge.
    feature: u64,
}

impl Place {
    /// Normal towards the post, whichever has it.
    fn facing(&self) -> DVec3 {
        if self.is_edge { -self.normal } else { self.normal }
    }

    /// How far apart they are there if they touch at another place, (LG9) [m].
    pub fn after(&self, first: &Self) -> Option<f64> {
        let turned = (1.0 - self.facing().dot(first.facing()) - ALONG).max(0.0);
        Some(self.beside? + TURNED * turned).filter(|_| self.feature != first.feature)
    }

    /// The same with the bodies at these poses, and so far apart [m].
    pub fn near(&self, poses: [&Pose; 2], along: DVec3, gap: f64) -> Near {
        let Self { point, normal, is_edge, feature, left, .. } = *self;
        let plane = Plane { point: point - normal * gap, normal, tangents: [along, normal.cross(along)] };
        Near { meeting: Meeting { spot: spot(poses, point, plane, is_edge, feature), gap }, point, left }
    }
}

/// Rims of the post on faces of the wall, (LG1).
pub fn rims_on_faces(post: &Post, wall: &Wall, places: &mut Vec<Place>) {
    let along = wall.along();
    for (face, (away, normal, length)) in (0..).zip(wall.faces()) {
        let Some(outwards) = (normal - post.axis * post.axis.dot(normal)).try_normalize() else {
            continue;
        };
        let point_of = |(centre, radius): (DVec3, f64)| centre - outwards * radius;
        for (rim, (centre, radius)) in (0..).zip(post.rims()) {
            let point = point_of((centre, radius));
            let from = point - wall.knee;
            let (down, aside) = (from.dot(away), from.dot(along));
            let (left, end) = (down.min(length - down), wall.half - aside.abs());
            // A post whose axis is beyond the wall is beside it.
            if end < 0.0 || (centre - wall.knee).dot(normal) < 0.0 {
                continue;
            }
            let gap = from.dot(normal);
            places.push(Place {
                point,
                normal,
                gap,
                beside: (left >= 0.0).then_some(gap),
                parts: post.rims().all(|other| normal.dot(point_of(other) - point) >= -ROUNDING),
                left: left.abs().min(end),
                is_edge: false,
                feature: 1 + 3 * face + rim,
            });
        }
    }
}

/// Edges of the wall on cylinder, tip, foot and cone of the post, (LG2) and (LG3).
pub fn edges_on_sides(post: &Post, wall: &Wall, places: &mut Vec<Place>) {
    let along = wall.along();
    // Where each is nearest to the cylinder and to the cone.
    let points = |edge: DVec3| post.nearest(edge, along, wall.half).map(|s| (edge + along * s, s));
    let edges: Vec<_> = wall.edges().map(points).collect();
    for (feature, edge) in (7..).zip(&edges) {
        let [by_cylinder, by_cone] = edge.map(|(point, _)| post.beside(point));
        let farthest = |sides: &[Option<Beside>; 4]| {
            sides.iter().flatten().map(|side| side.gap).fold(f64::NEG_INFINITY, f64::max)
        };
        let least = farthest(&by_cylinder).min(farthest(&by_cone));
        let sides = by_cylinder[..3].iter().map(|side| (0, side)).chain([(1, &by_cone[3])]);
        for (which, side) in sides {
            let Some(Beside { gap, normal, left }) = *side else { continue };
            let (point, s) = edge[which];
            let end = wall.half - s.abs();
            places.push(Place {
                point,
                normal,
                gap,
                beside: Some(least + (least - gap).max(0.0)),
                parts: edges.iter().all(|other| normal.dot(other[which].0 - point) >= -ROUNDING),
                // An edge that lies against the post by its end leaves it there.
                left: if end > 0.0 { left.min(end) } else { left },
                is_edge: true,
                feature,
            });
        }
    }
}

/// A point and a plane of the world as a spot of bodies at these poses; the point is of the second where `is_swapped`.
fn spot(poses: [&Pose; 2], point: DVec3, plane: Plane, is_swapped: bool, feature: u64) -> Spot {
    let [with_point, with_plane] = if is_swapped { [poses[1], poses[0]] } else { poses };
    let [to_point, to_plane] = [with_point, with_plane].map(|pose| pose.rotation.transpose());
    Spot {
        is_near: true,
        is_swapped,
        point: to_point * (point - with_point.position),
        plane: Plane {
            point: to_plane * (plane.point - with_plane.position),
            normal: to_plane * plane.normal,
            tangents: plane.tangents.map(|tangent| to_plane * tangent),
        },
        crossing: None,
        feature,
    }
}
