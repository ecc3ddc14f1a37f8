//! Faces of convex parts, whole. Of a face with more than four corners parry takes the first four, which lie on one side
//! of it, and one more place that is anywhere: what stands on such a face would rock on them. Here all of its corners are
//! held against the other face.
//!
//! Both are seen along the normal n of the manifold: corners of one within the other are points against its plane, and
//! where sides cross they meet.

use parry3d_f64::math::{Pose as ParryPose, Vector};
use parry3d_f64::query::{ContactManifold, TrackedContact};
use parry3d_f64::shape::{PackedFeatureId, PolygonalFeature, SharedShape};

use super::spare;

/// Corners that parry takes of a face.
const WHOLE: usize = 4;
/// Of a face with more corners than this those bear that lie farthest in as many directions, and where it leans the deepest.
const MOST: usize = 16;
/// Cosine of the angle between n and a face that is seen from its side.
const ASIDE: f64 = 1e-9;

/// A corner of a face, and the side from it to the next.
#[derive(Debug, Clone, Copy)]
struct Corner {
    at: Vector,
    vertex: PackedFeatureId,
    edge: PackedFeatureId,
}

/// A face of a convex part, in a frame of its own.
#[derive(Debug, Clone)]
pub struct Polygon {
    corners: Vec<Corner>,
    face: PackedFeatureId,
}

impl Polygon {
    /// What of a part looks most along `direction`, both in its frame; nothing of a mesh.
    pub fn towards(part: &SharedShape, direction: Vector) -> Option<Self> {
        let (map, _) = part.as_polygonal_feature_map()?;
        let mut seen = PolygonalFeature::default();
        map.local_support_feature(direction, &mut seen);
        let face = seen.fid;
        if let Some(hull) = part.as_convex_polyhedron().filter(|_| face.is_face()) {
            let own = hull.faces()[face.unpack().unwrap_face() as usize];
            let first = own.first_vertex_or_edge as usize;
            let all = first..first + own.num_vertices_or_edges as usize;
            let pairs = hull.vertices_adj_to_face()[all.clone()].iter().zip(&hull.edges_adj_to_face()[all]);
            let corners = pairs.map(|(&vertex, &edge)| Corner {
                at: hull.points()[vertex as usize],
                vertex: PackedFeatureId::vertex(vertex),
                edge: PackedFeatureId::edge(edge),
            });
            return Some(Self { corners: corners.collect(), face });
        }
        let corner = |k: usize| Corner { at: seen.vertices[k], vertex: seen.vids[k], edge: seen.eids[k] };
        Some(Self { corners: (0..seen.num_vertices).map(corner).collect(), face })
    }

    /// True where parry does not take all of it.
    fn is_cut_short(&self) -> bool {
        self.corners.len() > WHOLE
    }

    /// Its normal, either way; none of an edge, nor of corners in one line.
    pub fn normal(&self) -> Option<Vector> {
        let origin = self.corners.first()?.at;
        let sides = self.sides().map(|(from, to)| (from.at - origin).cross(to.at - origin));
        sides.sum::<Vector>().try_normalize().filter(|_| self.corners.len() > 2)
    }

    /// Direction of one of its sides.
    pub fn side(&self, edge: PackedFeatureId) -> Option<Vector> {
        let (from, to) = self.sides().find(|(from, _)| from.edge == edge)?;
        (to.at - from.at).try_normalize()
    }

    fn sides(&self) -> impl Iterator<Item = (&Corner, &Corner)> {
        self.corners.iter().zip(self.corners.iter().cycle().skip(1))
    }

    /// With no more than [`MOST`] corners, the same ones wherever it is.
    pub fn thinned(&self) -> Self {
        let Some(normal) = self.normal().filter(|_| self.corners.len() > MOST) else { return self.clone() };
        let (one, other) = normal.any_orthonormal_pair();
        let mut kept: Vec<usize> = (0..MOST)
            .filter_map(|k| {
                let (sin, cos) = (std::f64::consts::TAU * k as f64 / MOST as f64).sin_cos();
                let out = |index: usize| self.corners[index].at.dot(one * cos + other * sin);
                (0..self.corners.len()).max_by(|&a, &b| out(a).total_cmp(&out(b)))
            })
            .collect();
        kept.sort_unstable();
        kept.dedup();
        Self { corners: kept.into_iter().map(|index| self.corners[index]).collect(), face: self.face }
    }

    fn moved(mut self, pose: &ParryPose) -> Self {
        for corner in &mut self.corners {
            corner.at = pose.transform_point(corner.at);
        }
        self
    }

    /// How far a place is from its plane along n; nothing where the place is beside it as seen along n, or it is seen from its
    /// side.
    fn over(&self, place: Vector, n: Vector) -> Option<f64> {
        let normal = self.normal().filter(|normal| normal.dot(n).abs() > ASIDE)?;
        let turns = || self.sides().map(|(from, to)| (to.at - from.at).cross(place - from.at).dot(n));
        let is_within = turns().all(|turn| turn >= 0.0) || turns().all(|turn| turn <= 0.0);
        is_within.then(|| (self.corners[0].at - place).dot(normal) / n.dot(normal))
    }
}

/// Puts the places into a manifold of two parts, the second at a pose in the frame of the first, at which whole faces meet, where
/// parry has looked at some of their corners alone.
pub fn fill_whole(
    manifold: &mut ContactManifold<(), ()>,
    between: &ParryPose,
    [one, other]: [&SharedShape; 2],
) {
    let n = manifold.local_n1;
    let faces = (Polygon::towards(one, n), Polygon::towards(other, manifold.local_n2));
    let (Some(own), Some(its)) = faces else { return };
    if manifold.points.is_empty() || !(own.is_cut_short() || its.is_cut_short()) {
        return;
    }
    manifold.points.retain(spare::is_added);
    let few = [own.thinned(), its.thinned().moved(between)];
    let its = its.moved(between);
    let is_thinned = few[0].corners.len() < own.corners.len() || few[1].corners.len() < its.corners.len();
    manifold.points.extend(corners([&few[0], &few[1]], [&own, &its], between, n));
    manifold.points.extend(crossings([&own, &its], between, n));
    if !is_thinned {
        return;
    }
    // What parry has added may lie at corners that do not bear, and in another place in the next step.
    let added = spare::is_added;
    if manifold.points.iter().filter(|point| !added(point)).count() > 2 {
        manifold.points.retain(|point| !added(point));
    }
    // A part that leans stands on the corner that is deepest, whichever that is.
    let all = corners([&own, &its], [&own, &its], between, n);
    let deepest = all.into_iter().min_by(|a, b| a.dist.total_cmp(&b.dist));
    let points = &manifold.points;
    let is_beyond =
        |one: &TrackedContact<()>| points.iter().all(|other| other.dist > one.dist + spare::ROUNDING);
    let deepest = deepest.filter(is_beyond);
    manifold.points.extend(deepest);
}

/// A place of two parts, of either in the frame of the first, the second at a pose in it.
fn place(
    [first, second]: [Vector; 2],
    between: &ParryPose,
    n: Vector,
    [one, other]: [PackedFeatureId; 2],
) -> TrackedContact<()> {
    let apart = (second - first).dot(n);
    TrackedContact::new(first, between.inverse_transform_point(second), one, other, apart)
}

/// Those corners that bear of two faces that are over the other face, as seen along n; the second part is at a pose in the frame
/// of the first, its face in that.
fn corners(
    [bears, its_bears]: [&Polygon; 2],
    [own, its]: [&Polygon; 2],
    between: &ParryPose,
    n: Vector,
) -> Vec<TrackedContact<()>> {
    let of_own = bears.corners.iter().filter_map(|corner| {
        let apart = its.over(corner.at, n)?;
        Some(place([corner.at, corner.at + n * apart], between, n, [corner.vertex, its.face]))
    });
    let of_its = its_bears.corners.iter().filter_map(|corner| {
        let back = own.over(corner.at, n)?;
        Some(place([corner.at + n * back, corner.at], between, n, [own.face, corner.vertex]))
    });
    of_own.chain(of_its).collect()
}

/// Where sides of two faces cross, as those.
fn crossings([own, its]: [&Polygon; 2], between: &ParryPose, n: Vector) -> Vec<TrackedContact<()>> {
    let both = own.sides().flat_map(|side| its.sides().map(move |other| (side, other)));
    let found = both.filter_map(|((from, to), (its_from, its_to))| {
        let sides = [to.at - from.at, its_to.at - its_from.at];
        let [s, t] = crossing(its_from.at - from.at, sides, n)?;
        let ends = [from.at + sides[0] * s, its_from.at + sides[1] * t];
        Some(place(ends, between, n, [from.edge, its_from.edge]))
    });
    found.collect()
}

/// Where two sides cross as seen along n, as shares of each; the second begins at `apart` from the beginning of the first.
fn crossing(apart: Vector, [one, other]: [Vector; 2], n: Vector) -> Option<[f64; 2]> {
    let turn = one.cross(other).dot(n);
    if turn == 0.0 {
        return None;
    }
    let shares = [apart.cross(other).dot(n) / turn, apart.cross(one).dot(n) / turn];
    shares.iter().all(|share| (0.0..1.0).contains(share) && *share > 0.0).then_some(shares)
}
