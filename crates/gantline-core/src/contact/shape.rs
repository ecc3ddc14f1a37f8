//! Shapes of bodies, their distances and where they meet: boxes, convex parts and triangle meshes, by parry.
//!
//! parry has its own version of the vector types: what goes in and out of it is converted here and nowhere else.

use std::fmt;

use glam::{DQuat, DVec3};
use parry3d_f64::bounding_volume::BoundingVolume;
use parry3d_f64::math::{Pose as ParryPose, Rotation, Vector};
use parry3d_f64::query::{
    self, ContactManifold, DefaultQueryDispatcher, PersistentQueryDispatcher, TrackedContact,
};
use parry3d_f64::shape::{PackedFeatureId, SharedShape};

use super::parted::parted;
use super::plane::Plane;
use super::polygon::{self, Polygon};
use super::spare;
use super::spot::{Crossing, Spot};
use crate::tree::pose::Pose;

/// Points of two parts that are closer than this are one [m].
pub(super) const SAME: f64 = 1e-3;
/// Parts whose distance is less touch to rounding [m].
const NOTHING: f64 = 1e-10;
/// Cosine of the angle between a face and the direction in which shapes part, at most, for them to part along the face:
/// 1.8°.
const ALIGNED: f64 = 0.9995;
/// Sine of the angle between edges that cross, at least: 6°. Where edges are more parallel their crossing runs away.
const CROSSES: f64 = 0.1;

/// A part of a shape, in the frame of its body.
#[derive(Debug, Clone, PartialEq)]
pub enum Part {
    /// A box along the axes of `orientation` about its middle.
    Box {
        /// Its three sides [m].
        size: DVec3,
        /// Its middle [m].
        centre: DVec3,
        /// How it is turned.
        orientation: DQuat,
    },
    /// The convex hull of points [m].
    Convex(Vec<DVec3>),
    /// Triangles by the numbers of their corners [m].
    Mesh(Vec<DVec3>, Vec<[u32; 3]>),
}

/// Parts that belong together on one body.
#[derive(Clone)]
pub struct Shape {
    parts: Vec<(ParryPose, SharedShape)>,
    /// Distance of its farthest point from the origin of the body [m].
    pub radius: f64,
}

impl fmt::Debug for Shape {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(out, "Shape of {} parts within {} m", self.parts.len(), self.radius)
    }
}

/// A place where two shapes are near, and how far apart they are there [m], negative where they overlap.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Meeting {
    /// The place, in the frames of the two bodies.
    pub spot: Spot,
    /// Distance [m].
    pub gap: f64,
}

/// How far apart two shapes are, and where they are nearest to each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Apart {
    /// Distance [m], as [`Shape::distance`] has it.
    pub distance: f64,
    /// A point of each in the world; where they overlap one of each at the place where they do so most.
    pub points: [DVec3; 2],
}

/// A part of a shape, and where it is in the world.
type Placed<'a> = (ParryPose, &'a SharedShape);

fn given(vector: DVec3) -> Vector {
    Vector::new(vector.x, vector.y, vector.z)
}

fn taken(vector: Vector) -> DVec3 {
    DVec3::new(vector.x, vector.y, vector.z)
}

fn turned(turn: DQuat) -> Rotation {
    Rotation::from_xyzw(turn.x, turn.y, turn.z, turn.w)
}

fn placed(pose: &Pose) -> ParryPose {
    ParryPose::from_parts(given(pose.position), turned(DQuat::from_mat3(&pose.rotation)))
}

impl Shape {
    /// A shape of these parts.
    ///
    /// # Errors
    /// A sentence that says what is wrong with a part.
    pub fn new(parts: &[Part]) -> Result<Self, String> {
        let mut made = Vec::with_capacity(parts.len());
        let mut radius = 0.0_f64;
        for part in parts {
            made.push(match part {
                Part::Box { size, centre, orientation } => {
                    let half = *size / 2.0;
                    radius = radius.max(centre.length() + half.length());
                    let pose = ParryPose::from_parts(given(*centre), turned(*orientation));
                    (pose, SharedShape::cuboid(half.x, half.y, half.z))
                }
                Part::Convex(vertices) => {
                    radius = vertices.iter().fold(radius, |most, vertex| most.max(vertex.length()));
                    let vertices: Vec<Vector> = vertices.iter().copied().map(given).collect();
                    let hull = SharedShape::convex_hull(&vertices);
                    let hull = hull.ok_or(
                        "a convex part has no volume; it needs four corners that are not in one plane",
                    )?;
                    (ParryPose::identity(), hull)
                }
                Part::Mesh(vertices, triangles) => {
                    radius = vertices.iter().fold(radius, |most, vertex| most.max(vertex.length()));
                    let vertices: Vec<Vector> = vertices.iter().copied().map(given).collect();
                    let mesh = SharedShape::trimesh(vertices, triangles.clone());
                    (ParryPose::identity(), mesh.map_err(|error| format!("a mesh cannot be used: {error}"))?)
                }
            });
        }
        if made.is_empty() {
            return Err("a shape needs at least one part".to_owned());
        }
        Ok(Self { parts: made, radius })
    }

    /// Distance of two shapes on bodies at `poses` [m]; where they overlap minus how deep, as far as that has a
    /// meaning: triangle meshes are skins without an inside, whose distance is then 0.
    pub fn distance(&self, other: &Self, poses: [&Pose; 2]) -> f64 {
        nearest_parts(self.placed(poses[0]), || other.placed(poses[1])).0
    }

    /// The same with the points that are nearest.
    pub fn apart(&self, other: &Self, poses: [&Pose; 2]) -> Apart {
        apart(nearest_parts(self.placed(poses[0]), || other.placed(poses[1])))
    }

    /// The same of this shape and the straight line between two world points.
    pub fn apart_from_line(&self, pose: &Pose, [from, to]: [DVec3; 2]) -> Apart {
        let line = SharedShape::segment(given(from), given(to));
        apart(nearest_parts(self.placed(pose), || std::iter::once((ParryPose::identity(), &line))))
    }

    /// The parts where they are when the body is at a pose.
    fn placed(&self, pose: &Pose) -> impl Iterator<Item = Placed<'_>> {
        let body = placed(pose);
        self.parts.iter().map(move |(local, part)| (body * *local, part))
    }

    /// True where a world point is in the shape or within a millimetre of it.
    pub fn holds(&self, pose: &Pose, point: DVec3) -> bool {
        let (own, point) = (placed(pose), given(point));
        self.parts.iter().any(|(local, part)| part.distance_to_point(&(own * *local), point, true) < SAME)
    }

    /// Finds where two shapes on bodies at `poses` are not farther apart than `reach` [m], nearest first.
    pub fn meet(&self, other: &Self, poses: [&Pose; 2], reach: f64, found: &mut Vec<Meeting>) {
        found.clear();
        let [own, its] = poses.map(placed);
        let mut manifolds: Vec<ContactManifold<(), ()>> = Vec::new();
        for (index, (local, part)) in self.parts.iter().enumerate() {
            let pose = own * *local;
            let bounds = part.compute_aabb(&pose);
            for (other_index, (other_local, other_part)) in other.parts.iter().enumerate() {
                let other_pose = its * *other_local;
                if !bounds.loosened(reach).intersects(&other_part.compute_aabb(&other_pose)) {
                    continue;
                }
                let mut between = pose.inv_mul(&other_pose);
                fill(&mut manifolds, &between, [part, other_part], reach);
                if is_doubtful(&manifolds)
                    && let Some(shift) = parted(&between, part, other_part)
                {
                    between.translation += shift;
                    fill(&mut manifolds, &between, [part, other_part], reach);
                }
                let parts = ((index as u64) << 20) ^ other_index as u64;
                for manifold in &manifolds {
                    let near = manifold.points.iter();
                    let near = near.filter(|point| point.dist <= reach && !spare::is_spare(manifold, point));
                    let one = Located { local, body: &own, part };
                    let located = [one, Located { local: other_local, body: &its, part: other_part }];
                    found.extend(near.map(|point| {
                        let spot = spot_of(manifold, point, located, parts).anew(poses);
                        Meeting { spot, gap: spot.gap(poses) }
                    }));
                }
            }
        }
        found.sort_by(|a, b| a.gap.total_cmp(&b.gap).then(a.spot.feature.cmp(&b.spot.feature)));
        drop_repeated(found, poses);
    }
}

/// Where two parts are not farther apart than `reach` [m], the second at a pose in the frame of the first; nothing of
/// kinds that parry has no answer for.
fn fill(
    manifolds: &mut Vec<ContactManifold<(), ()>>,
    between: &ParryPose,
    parts: [&SharedShape; 2],
    reach: f64,
) {
    manifolds.clear();
    let [one, other] = parts.map(|part| part.as_ref());
    let made = DefaultQueryDispatcher.contact_manifolds(between, one, other, reach, manifolds, &mut None);
    if made.is_err() {
        manifolds.clear();
    }
    for manifold in manifolds.iter_mut() {
        polygon::fill_whole(manifold, between, parts);
    }
}

/// True where parts may in truth touch to rounding: deeper than [`SAME`], by [`NOTHING`], so that the direction between them
/// is rounding too, along no direction, or nothing with the normal that parry gives where it has failed.
fn is_doubtful(manifolds: &[ContactManifold<(), ()>]) -> bool {
    manifolds.iter().any(|manifold| {
        if manifold.points.is_empty() {
            return manifold.local_n1 == Vector::X;
        }
        let has_direction = (manifold.local_n1.length_squared() - 1.0).abs() < SAME;
        !has_direction || manifold.points.iter().any(|point| point.dist < -SAME || point.dist.abs() < NOTHING)
    })
}

/// The smallest distance of parts of two shapes [m], and which two have it.
fn nearest_parts<'a, Others: Iterator<Item = Placed<'a>>>(
    own: impl Iterator<Item = Placed<'a>>,
    others: impl Fn() -> Others,
) -> (f64, Option<[Placed<'a>; 2]>) {
    let mut least = (f64::INFINITY, None);
    for one in own {
        for other in others() {
            let apart = distance(one, other);
            if apart < least.0 {
                least = (apart, Some([one, other]));
            }
        }
    }
    least
}

fn distance(one: Placed, other: Placed) -> f64 {
    let apart = match (one.1.as_cuboid(), other.1.as_cuboid()) {
        // Of two boxes parry's distance goes by the axis that parts them best, from a corner that lies farthest that
        // way. Where several do, as of boxes with parallel edges, it may take one that is not near.
        (Some(first), Some(second)) => {
            query::details::distance_support_map_support_map(&one.0.inv_mul(&other.0), first, second)
        }
        _ => query::distance(&one.0, one.1.as_ref(), &other.0, other.1.as_ref())
            .map_or(f64::NAN, |found| found.distance),
    };
    if apart > 0.0 && apart < at_most(one, other) {
        return apart;
    }
    deepest(one, other).map_or(apart, |contact| contact.dist.min(0.0))
}

/// More than two parts are apart [m]: the distance of the second from a point of the first, and [`SAME`]. Of some that touch
/// to rounding parry says metres.
fn at_most(one: Placed, other: Placed) -> f64 {
    let Some(map) = one.1.as_support_map() else { return f64::INFINITY };
    let [own, its] = [one, other].map(|(pose, part)| part.compute_aabb(&pose).center());
    other.1.distance_to_point(&other.0, map.support_point(&one.0, its - own), true) + SAME
}

/// Where two parts that meet do so most.
fn deepest(one: Placed, other: Placed) -> Option<query::Contact> {
    let contact = |other: Placed, reach| {
        query::contact(&one.0, one.1.as_ref(), &other.0, other.1.as_ref(), reach).ok().flatten()
    };
    let found = contact(other, 0.0);
    if found.is_some_and(|found| found.dist >= -SAME) {
        return found;
    }
    let Some(shift) = parted(&one.0.inv_mul(&other.0), one.1, other.1) else { return found };
    let shift = one.0.transform_vector(shift);
    let mut moved = other.0;
    moved.translation += shift;
    let anew = contact((moved, other.1), SAME)?;
    let dist = anew.dist - shift.dot(anew.normal1);
    Some(query::Contact { dist, point2: anew.point2 - shift, ..anew })
}

fn apart((distance, parts): (f64, Option<[Placed; 2]>)) -> Apart {
    let found = parts.and_then(|[one, other]| {
        match query::closest_points(&one.0, one.1.as_ref(), &other.0, other.1.as_ref(), f64::MAX) {
            Ok(query::ClosestPoints::WithinMargin(first, second)) => Some([first, second]),
            _ => deepest(one, other).map(|contact| [contact.point1, contact.point2]),
        }
    });
    Apart { distance, points: found.map_or([DVec3::ZERO; 2], |points| points.map(taken)) }
}

/// A part of a shape where it is: its frame in the body, the body in the world, and itself.
#[derive(Clone, Copy)]
struct Located<'a> {
    local: &'a ParryPose,
    body: &'a ParryPose,
    part: &'a SharedShape,
}

impl Located<'_> {
    /// Frame in the body of the piece of the part that a manifold speaks of.
    fn frame(&self, inner: Option<ParryPose>) -> ParryPose {
        inner.map_or(*self.local, |pose| *self.local * pose)
    }

    /// What of the part looks most along `direction`, with the sides that meet, in the frame of the part; nothing of a
    /// mesh.
    fn feature(&self, direction: Vector) -> Option<Polygon> {
        Some(Polygon::towards(self.part, direction)?.thinned())
    }
}

/// Normal of a face, in the frame of its part, where it looks closely along `direction`.
fn normal_of(feature: &Polygon, direction: Vector) -> Option<Vector> {
    let across = feature.normal()?;
    let normal = if across.dot(direction) < 0.0 { -across } else { across };
    (normal.dot(direction) > ALIGNED).then_some(normal)
}

/// A point of a manifold as a spot. A corner over a face is a point against the plane of that face, so that it stays one
/// however the two slide; edges that cross have a plane of their own. What is neither has the plane of a face of the second body where that looks the right way, else of one of the
/// first; of meshes corners tell.
fn spot_of(
    manifold: &ContactManifold<(), ()>,
    point: &TrackedContact<()>,
    [one, other]: [Located; 2],
    parts: u64,
) -> Spot {
    let inner = manifold.subshape_poses.as_ref();
    let own = one.frame(inner.and_then(|poses| poses.pos1));
    let its = other.frame(inner.and_then(|poses| poses.pos2));
    let [first, second] = [own.transform_point(point.local_p1), its.transform_point(point.local_p2)];
    let directions = [manifold.local_n1, manifold.local_n2];
    let seen = [one.feature(directions[0]), other.feature(directions[1])];
    let face = |side: usize| seen[side].as_ref().and_then(|seen| normal_of(seen, directions[side]));
    let faces = [face(0), face(1)];
    let is_corner = [point.fid1.is_vertex(), point.fid2.is_vertex()];
    let is_face = |side: usize| faces[side].is_some() || faces == [None, None];
    let is_swapped = match is_corner {
        [true, false] if is_face(1) => false,
        [false, true] if is_face(0) => true,
        _ => faces[1].is_none() && faces[0].is_some(),
    };
    let (place, origin, normal, frames) = if is_swapped {
        let normal = own.transform_vector(faces[0].unwrap_or(manifold.local_n1));
        (second, first, normal, [other.body, one.body])
    } else {
        let normal = its.transform_vector(faces[1].unwrap_or(manifold.local_n2));
        (first, second, normal, [one.body, other.body])
    };
    let plane = Plane::new(taken(origin), taken(normal).normalize());
    let subshapes = (u64::from(manifold.subshape1) << 16) ^ u64::from(manifold.subshape2);
    let feature = mixed(parts, mixed(subshapes, features(point.fid1, point.fid2)));
    let spot = Spot { is_near: true, is_swapped, point: taken(place), plane, crossing: None, feature };
    let edge = |side: usize, edge| seen[side].as_ref().and_then(|seen| seen.side(edge));
    if let [Some(first), Some(second)] = [edge(0, point.fid1), edge(1, point.fid2)] {
        let edges = [own.transform_vector(first), its.transform_vector(second)];
        return crossing(spot, edges, frames);
    }
    spot
}

fn features(first: PackedFeatureId, second: PackedFeatureId) -> u64 {
    (u64::from(first.0) << 32) ^ u64::from(second.0)
}

/// FNV-1a over the bytes of both.
fn mixed(first: u64, second: u64) -> u64 {
    let bytes = first.to_le_bytes().into_iter().chain(second.to_le_bytes());
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// The same spot between two edges, of the first and the second body in their frames; as it is where they are nearly
/// parallel. Where exactly they cross [`Spot::anew`] says.
fn crossing(spot: Spot, edges: [Vector; 2], [with_point, with_plane]: [&ParryPose; 2]) -> Spot {
    let [own, other] = if spot.is_swapped { [edges[1], edges[0]] } else { edges };
    let own_before = with_plane.inverse_transform_vector(with_point.transform_vector(own));
    if own_before.cross(other).length() < CROSSES {
        return spot;
    }
    let [own, own_before, other] = [own, own_before, other].map(taken);
    Spot { crossing: Some(Crossing { own, own_before, other, gap_before: 0.0 }), ..spot }
}

/// Keeps the first of those that are at one place and press the same way: parts of one shape share corners.
fn drop_repeated(found: &mut Vec<Meeting>, poses: [&Pose; 2]) {
    let mut kept = 0;
    for index in 0..found.len() {
        let (place, normal) = found[index].spot.in_world(poses);
        let is_new = found[..kept].iter().all(|other| {
            let (there, other_normal) = other.spot.in_world(poses);
            let apart = there - place;
            (apart - normal * normal.dot(apart)).length() > SAME || normal.dot(other_normal) < 0.99
        });
        if is_new {
            found.swap(kept, index);
            kept += 1;
        }
    }
    found.truncate(kept);
}
