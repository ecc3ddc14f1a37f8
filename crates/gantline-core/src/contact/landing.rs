//! A landing guide: a round post on one body, a wall on another, and where the two are near each other.
//!
//! The post is a cylinder that ends in a cone with a flat tip, the wall an upright face that leans away from the post below
//! its knee, as the flare of a bucket does. Seen in an upright plane both are convex, so they meet where a rim of the post
//! lies on a face of the wall, or an edge of the wall on the side of the post. With the axis a of the post, x the point and
//! h, ρ its height over the base along a and its distance from the axis,
//!
//! ```text
//! rim on a face      x = c − R m/|m|,  m = n − (n·a) a,  gap = n·(x − k)         (LG1)
//! edge on the side   f = max(ρ − R, (ρ − R) cos α + (h − H) sin α, h − H − C, −h)    (LG2)
//! ```
//!
//! c and R are middle and radius of the rim, n and k normal and a point of the face; H is the height of the shoulder, C that of
//! the cone, tan α its narrowing over C. Along an edge e + s t the least of ρ cos α + h sin α is at
//!
//! ```text
//! s = s₀ − M ρ₀/√(1 − M² τ²),   M = tan α (a·t)/τ²,  τ² = 1 − (a·t)²             (LG3)
//! ```
//!
//! s₀ and ρ₀ where the edge is nearest to the axis. Two convex bodies touch at one place, or all along a line. Of the planes
//! through every rim along every face, and through every edge along every side of the post, those count from which rims and
//! edges lie on their own side alone: they part the two, by the gap, and where that is less than nothing so far are they in each
//! other. The one that parts them farthest is where they touch. The other end of a line is where another rim or edge is next
//! nearest, if it lies along the same plane: with the angle θ between its normal and the first it counts
//!
//! ```text
//! 2 m · max(0, 1 − cos θ − 0.0002)  +  f_max − f                                  (LG9)
//! ```
//!
//! farther away, f that of the side of the post along which it would lie: no farther within 1.1°. Without that what has another
//! direction would press at once with all that it is inside, as the tip of a post does on which the lower end of a flare stands,
//! or twice as a rim passes the knee; and the top of a wall that slides down along the cylinder would be stopped by the cone.
//! Either is a point of one body against a plane of the other: exact as the two shift, and but for R dψ²/2 as they turn by dψ,
//! until the spot is found anew ([`crate::stepper::spots`]).

mod places;

use glam::DVec3;

use super::shape::Meeting;
use crate::tree::pose::Pose;
use places::{Place, ROUNDING, edges_on_sides, rims_on_faces};

/// Places at which a post and a wall touch at a time, at most: both ends of a line along which they lie on each other.
pub const PLACES: usize = 2;
/// Sine of the angle between a direction and the axis of a post, at least, where one across it is needed.
const ACROSS: f64 = 1e-6;

/// A round post, in the frame of its body.
#[derive(Debug, Clone, PartialEq)]
pub struct Post {
    /// Where its axis begins [m]: the middle of its foot.
    pub base: DVec3,
    /// Unit vector along its axis, towards its tip.
    pub axis: DVec3,
    /// Its radius [m].
    pub radius: f64,
    /// From the base to its shoulder, where the cone begins [m].
    pub height: f64,
    /// Length of the cone along the axis [m]; 0 without one.
    pub cone: f64,
    /// Radius of its tip [m].
    pub tip_radius: f64,
}

/// A wall that a post runs along, in the frame of its body.
#[derive(Debug, Clone, PartialEq)]
pub struct Wall {
    /// Middle of its knee, from which on it leans away [m].
    pub knee: DVec3,
    /// Unit vector out of its upright face, towards the post.
    pub normal: DVec3,
    /// Unit vector in that face, across the knee and away from the flare.
    pub up: DVec3,
    /// From the knee to its other edge, along `up` [m].
    pub height: f64,
    /// Half its breadth along the knee [m].
    pub half: f64,
    /// Length of the flare [m]; 0 without one.
    pub flare: f64,
    /// By how much the flare leans away from `up` [rad].
    pub angle: f64,
}

/// A post and a wall.
#[derive(Debug, Clone, PartialEq)]
pub struct Landing {
    /// The post; its body is the first of the two.
    pub post: Post,
    /// The wall.
    pub wall: Wall,
}

/// A place at which a post and a wall are near each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Near {
    /// The place, and how far apart they are there.
    pub meeting: Meeting,
    /// Where it is in the world [m].
    pub point: DVec3,
    /// How far it is from the end of what meets there, along the surface [m].
    pub left: f64,
}

/// A side, the tip or the foot of a post at a point beside it.
#[derive(Clone, Copy)]
struct Beside {
    /// Its own part of f in (LG2) [m].
    gap: f64,
    /// Normal out of the post.
    normal: DVec3,
    /// From the end of that side [m].
    left: f64,
}

impl Post {
    /// The same where its body is.
    fn placed(&self, pose: &Pose) -> Self {
        Self { base: pose.point(self.base), axis: pose.rotation * self.axis, ..self.clone() }
    }

    /// Cosine and sine of the angle of the cone to the axis, nothing without one.
    fn slope(&self) -> Option<[f64; 2]> {
        let narrows = self.radius - self.tip_radius;
        let length = self.cone.hypot(narrows);
        (self.cone > 0.0).then(|| [self.cone / length, narrows / length])
    }

    /// Middle and radius of the ends of its sides: foot, shoulder and tip.
    fn rims(&self) -> impl Iterator<Item = (DVec3, f64)> {
        let at = |height: f64| self.base + self.axis * height;
        let tip = (self.cone > 0.0).then(|| (at(self.height + self.cone), self.tip_radius));
        [(self.base, self.radius), (at(self.height), self.radius)].into_iter().chain(tip)
    }

    /// Its cylinder, tip and foot and its cone at a point, by (LG2).
    fn beside(&self, point: DVec3) -> [Option<Beside>; 4] {
        let apart = point - self.base;
        let height = apart.dot(self.axis);
        let across = apart - self.axis * height;
        // On the axis the tip is nearest, or all ways out are as good.
        let outwards = across.try_normalize().unwrap_or_else(|| self.axis.any_orthonormal_vector());
        let distance = across.length();
        let over = height - self.height;
        let side =
            Beside { gap: distance - self.radius, normal: outwards, left: over.abs().min(height.abs()) };
        let foot = Beside { gap: -height, normal: -self.axis, left: (self.radius - distance).abs() };
        let tip = Beside {
            gap: over - self.cone,
            normal: self.axis,
            left: (self.slope().map_or(self.radius, |_| self.tip_radius) - distance).abs(),
        };
        let cone = self.slope().map(|[cos, sin]| Beside {
            gap: (distance - self.radius) * cos + over * sin,
            normal: outwards * cos + self.axis * sin,
            left: over.abs().min((over - self.cone).abs()) / cos,
        });
        [Some(side), Some(tip), Some(foot), cone]
    }

    /// Where an edge e + s t, |s| ≤ `half`, comes nearest to a side of it, by (LG3): s [m] for the cylinder and the cone.
    fn nearest(&self, edge: DVec3, along: DVec3, half: f64) -> [f64; 2] {
        let apart = edge - self.base;
        let lean = self.axis.dot(along);
        let across = 1.0 - lean * lean;
        if across < ACROSS {
            return [0.0; 2];
        }
        let level = |vector: DVec3| vector - self.axis * self.axis.dot(vector);
        let (from, way) = (level(apart), level(along));
        let middle = -from.dot(way) / across;
        let least = (from + way * middle).length();
        let share = self.slope().map_or(0.0, |[cos, sin]| sin / cos * lean / across);
        let root = (1.0 - share * share * across).max(ACROSS).sqrt();
        [middle, middle - share * least / root].map(|s| s.clamp(-half, half))
    }
}

impl Wall {
    /// The same where its body is.
    fn placed(&self, pose: &Pose) -> Self {
        let [normal, up] = [self.normal, self.up].map(|vector| pose.rotation * vector);
        Self { knee: pose.point(self.knee), normal, up, ..self.clone() }
    }

    /// Along its knee.
    fn along(&self) -> DVec3 {
        self.up.cross(self.normal)
    }

    /// Its faces: the direction away from the knee, the normal, and how long it is [m].
    fn faces(&self) -> impl Iterator<Item = (DVec3, DVec3, f64)> {
        let (sin, cos) = self.angle.sin_cos();
        let flare = (-self.up * cos - self.normal * sin, self.normal * cos - self.up * sin, self.flare);
        let upright = (self.up, self.normal, self.height);
        [upright, flare].into_iter().filter(|(_, _, length)| *length > 0.0)
    }

    /// Its edges, the knee and the other ends of its faces: the middle of each [m].
    fn edges(&self) -> impl Iterator<Item = DVec3> {
        [self.knee].into_iter().chain(self.faces().map(|(away, _, length)| self.knee + away * length))
    }
}

impl Landing {
    /// Balls around the post and the wall in the world: middle and radius [m].
    fn balls(&self, poses: [&Pose; 2]) -> [(DVec3, f64); 2] {
        let Self { post, wall } = self;
        let half = 0.5 * (post.height + post.cone);
        let middle = poses[0].point(post.base + post.axis * half);
        let reach = wall.half.hypot(wall.height.max(wall.flare));
        [(middle, half.hypot(post.radius)), (poses[1].point(wall.knee), reach)]
    }

    /// How far the post and the wall are apart, at least [m].
    pub fn apart(&self, poses: [&Pose; 2]) -> f64 {
        let [(one, own), (other, its)] = self.balls(poses);
        (other - one).length() - own - its
    }

    /// Distance of the farthest point of the post or the wall from the origin of its body [m].
    pub fn radius(&self, body: usize) -> f64 {
        let (middle, radius) = self.balls([&Pose::IDENTITY; 2])[body];
        middle.length() + radius
    }

    /// Where the post and the wall are closer than `reach` [m] with their bodies at these poses: where they touch first, then the
    /// other end of a line along which they do.
    pub fn near(&self, poses: [&Pose; 2], reach: f64, found: &mut Vec<Near>) {
        found.clear();
        if self.apart(poses) > reach {
            return;
        }
        let (post, wall) = (self.post.placed(poses[0]), self.wall.placed(poses[1]));
        let mut places = Vec::with_capacity(2 * 3 + 3 * 4);
        rims_on_faces(&post, &wall, &mut places);
        edges_on_sides(&post, &wall, &mut places);
        let by_gap = |one: &(f64, &Place), other: &(f64, &Place)| one.0.total_cmp(&other.0);
        // A wall that has come over the axis of the post is parted from it by planes alone that stand far off.
        let parting = places.iter().filter(|place| place.parts && place.gap > -post.radius);
        let farthest = parting.clone().map(|place| place.gap).fold(f64::NEG_INFINITY, f64::max);
        // Of what lies in one plane what can be the end of a line: the foot of a post may lie in that of a wall above it.
        let ends = parting.filter(|place| place.gap >= farthest - ROUNDING);
        let touching = ends.map(|place| (place.beside.unwrap_or(f64::INFINITY), place)).min_by(by_gap);
        let deepest = || places.iter().filter_map(|place| Some((place.beside?, place))).min_by(by_gap);
        let Some((gap, first)) = touching.map(|(_, place)| (place.gap, place)).or_else(deepest) else {
            return;
        };
        let others = places.iter().filter_map(|place| Some((place.after(first)?, place)));
        let next = others.min_by(by_gap);
        let tangent = |place: &Place| {
            let around = place.is_edge.then(|| post.axis.cross(place.normal).try_normalize()).flatten();
            around.unwrap_or_else(|| wall.along())
        };
        let both = [(gap, first)].into_iter().chain(next).filter(|(gap, _)| *gap < reach);
        found.extend(both.map(|(gap, place)| place.near(poses, tangent(place), gap)));
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_2, PI};

    use super::*;
    use crate::contact::shape::{Part, Shape};
    use glam::DQuat;
    use proptest::prelude::*;

    /// Reach of the tests [m]: whatever is within the length of the guide.
    const FAR: f64 = 2.0;

    /// A post 0.4 m thick and 1 m high with a cone of 0.3 m, and a wall with a flare of 30°.
    fn landing() -> Landing {
        let post = Post {
            base: DVec3::new(0.1, -0.2, -1.0),
            axis: DVec3::Z,
            radius: 0.2,
            height: 1.0,
            cone: 0.3,
            tip_radius: 0.08,
        };
        let (normal, up) = (DVec3::X, DVec3::Z);
        let angle = 30.0_f64.to_radians();
        let wall = Wall { knee: DVec3::ZERO, normal, up, height: 0.5, half: 0.3, flare: 0.4, angle };
        Landing { post, wall }
    }

    /// The same as solids: the post by rims of 360 corners, each face of the wall with a thickness behind it.
    fn solids(landing: &Landing) -> [Shape; 2] {
        let Landing { post, wall } = landing;
        let (across, around) = post.axis.any_orthonormal_pair();
        let rim = |(centre, radius): (DVec3, f64)| {
            (0..360).map(move |degree| {
                let (sin, cos) = f64::from(degree).to_radians().sin_cos();
                centre + (across * cos + around * sin) * radius
            })
        };
        let points = post.rims().flat_map(rim).collect();
        let behind = -wall.normal * 0.05;
        let plate = |(away, _, length): (DVec3, DVec3, f64)| {
            let corners = [-1.0, 1.0].map(|side| wall.knee + wall.along() * (side * wall.half));
            let face = corners.into_iter().flat_map(|corner| [corner, corner + away * length]);
            Part::Convex(face.flat_map(|corner| [corner, corner + behind]).collect())
        };
        let faces: Vec<Part> = wall.faces().map(plate).collect();
        [Shape::new(&[Part::Convex(points)]).unwrap(), Shape::new(&faces).unwrap()]
    }

    /// The wall leant by some degrees and turned about the post, with its knee at a height over the post's base and so far from
    /// its axis.
    fn pose(landing: &Landing, [lean, roll, yaw, height, distance, aside]: [f64; 6]) -> Pose {
        let turn = DQuat::from_rotation_z(yaw) * DQuat::from_rotation_y(lean) * DQuat::from_rotation_x(roll);
        let place = landing.post.base + DVec3::new(-distance, aside, height);
        let place = DQuat::from_rotation_z(yaw) * (place - landing.post.base) + landing.post.base;
        Pose::new(turn, place)
    }

    fn least(landing: &Landing, poses: [&Pose; 2]) -> Near {
        let mut found = Vec::new();
        landing.near(poses, FAR, &mut found);
        found[0]
    }

    /// Leans within 6°, headings all round, heights from below the shoulder to over the tip, middles beside the post.
    fn places() -> impl Strategy<Value = [f64; 6]> {
        (-0.1..0.1, -0.1..0.1, -3.0..3.0, 0.3..1.5, -0.1..0.1)
            .prop_map(|(lean, roll, yaw, height, aside)| [lean, roll, yaw, height, 0.5, aside])
    }

    proptest! {
        /// Brought together until the gap is nought the solids touch, to what 360 corners leave of a circle and a little more
        /// where an edge that leans lies on the shoulder.
        #[test]
        fn no_gap_is_where_solids_touch(given in places()) {
            let landing = landing();
            let gap = |distance: f64| {
                let mut given = given;
                given[4] = distance;
                least(&landing, [&Pose::IDENTITY, &pose(&landing, given)]).meeting.gap
            };
            let (mut close, mut far) = (0.0, 0.5);
            prop_assume!(gap(close) < 0.0 && gap(far) > 0.0);
            for _ in 0..50 {
                let middle = 0.5 * (close + far);
                if gap(middle) < 0.0 { close = middle } else { far = middle }
            }
            let mut touching = given;
            touching[4] = far;
            let [post, wall] = solids(&landing);
            let apart = post.distance(&wall, [&Pose::IDENTITY, &pose(&landing, touching)]);
            prop_assert!(apart.abs() < 2e-4, "{apart} m apart where the gap is nought");
        }

        /// The spot as it was found gives the gap after a small motion but for terms of second order: so its rows have the
        /// exact gradient, with the direction in which the bodies push each other.
        #[test]
        fn a_spot_has_the_gradient_of_the_gap(given in places(), turn in prop::array::uniform3(-1.0..1.0)) {
            let landing = landing();
            let mut before = pose(&landing, given);
            let mut near = least(&landing, [&Pose::IDENTITY, &before]);
            if near.meeting.spot.is_swapped {
                // An edge that leans and lies across the shoulder has a kink there: edges are level.
                let [lean, _, rest @ ..] = given;
                let [yaw, height, distance, aside] = rest;
                before = pose(&landing, [lean, 0.0, yaw, height, distance, aside]);
                near = least(&landing, [&Pose::IDENTITY, &before]);
            }
            let small = 1e-5;
            let moved = Pose::new(
                DQuat::from_scaled_axis(DVec3::from_array(turn) * small) * DQuat::from_mat3(&before.rotation),
                before.position + DVec3::new(turn[1], turn[2], turn[0]) * small,
            );
            let poses = [&Pose::IDENTITY, &moved];
            let mut found = Vec::new();
            landing.near(poses, FAR, &mut found);
            let same = |one: &&Near| one.meeting.spot.feature == near.meeting.spot.feature;
            let Some(after) = found.iter().find(same) else { return Ok(()) };
            // Other sides of the post may have come to lead where two are equally far.
            prop_assume!((after.point - near.point).length() < 1e-3);
            let is_alike = after.meeting.spot.in_world(poses).1.dot(near.meeting.spot.in_world(poses).1) > 0.9999;
            prop_assume!(is_alike);
            prop_assert!((near.meeting.spot.gap([&Pose::IDENTITY, &before]) - near.meeting.gap).abs() < 1e-14);
            prop_assert!((near.meeting.spot.gap(poses) - after.meeting.gap).abs() < 10.0 * small * small);
        }
    }

    /// How far post and wall are apart along the way on which that is most, in the plane of its axis and the wall's normal and as
    /// seen from the front: by 3600 ways, each with all rims and edges. What is in each other has less than nothing.
    fn parted(landing: &Landing, pose: &Pose) -> f64 {
        let (post, wall) = (&landing.post, landing.wall.placed(pose));
        let outwards = (wall.normal - post.axis * post.axis.dot(wall.normal)).normalize();
        let apart = |angle: f64| {
            let way = outwards * angle.cos() - post.axis * angle.sin();
            let own = post.rims().map(|(centre, radius)| way.dot(centre - outwards * radius));
            let its = wall.edges().map(|edge| way.dot(edge));
            own.fold(f64::INFINITY, f64::min) - its.fold(f64::NEG_INFINITY, f64::max)
        };
        (0..=3600)
            .map(|step| apart(f64::from(step) / 3600.0 * PI - FRAC_PI_2))
            .fold(f64::NEG_INFINITY, f64::max)
    }

    proptest! {
        /// Where they are in each other they are so by the shortest way out, to what ways 0.05° apart miss over half a metre, and
        /// what presses beside it goes nearly the same way: 2 m (1 − cos θ − 0.0002) are more than 30 mm from 10° on.
        #[test]
        fn they_are_in_each_other_by_the_shortest_way_out(
            (lean, height, depth) in (-0.1..0.1_f64, 0.05..1.6_f64, 0.001..0.03_f64),
        ) {
            let landing = landing();
            let at = |distance: f64| pose(&landing, [lean, 0.0, 0.0, height, distance, 0.0]);
            let (mut close, mut far) = (0.0, 0.9);
            prop_assume!(parted(&landing, &at(close)) < -depth);
            for _ in 0..40 {
                let middle = 0.5 * (close + far);
                if parted(&landing, &at(middle)) < -depth { close = middle } else { far = middle }
            }
            let poses = [&Pose::IDENTITY, &at(far)];
            let mut found = Vec::new();
            landing.near(poses, 0.0, &mut found);
            prop_assert!((found[0].meeting.gap + depth).abs() < 5e-4, "{depth}: {found:?}");
            let mut ways = found.iter().map(|near| near.meeting.spot.in_world(poses).1);
            let first = ways.next().unwrap();
            prop_assert!(ways.all(|way| way.dot(first) > 1.0 - 0.5 * 0.03 - 0.0002), "{found:?}");
        }
    }

    fn standing(x: f64, height: f64) -> Vec<Near> {
        let landing = landing();
        let mut found = Vec::new();
        let place = landing.post.base + DVec3::new(x, 0.0, height);
        landing.near([&Pose::IDENTITY, &Pose { position: place, ..Pose::IDENTITY }], 0.1, &mut found);
        found
    }

    #[test]
    fn a_wall_beside_the_cylinder_touches_at_both_ends_of_what_they_share() {
        // The knee 0.7 m up, the top 1.2 m up, the shoulder 1 m up: the knee and the shoulder, 30 mm apart.
        let found = standing(-0.23, 0.7);
        let mut heights: Vec<f64> = found.iter().map(|near| near.point.z + 1.0).collect();
        heights.sort_by(f64::total_cmp);
        assert!((heights[0] - 0.7).abs() < 1e-12 && (heights[1] - 1.0).abs() < 1e-12, "{heights:?}");
        assert!(found.iter().all(|near| (near.meeting.gap - 0.03).abs() < 1e-12));
    }

    #[test]
    fn the_top_of_a_wall_along_the_cylinder_is_no_neighbour_of_the_cone() {
        // Leant by 0.01 towards the post the wall lies on the shoulder, 1 m up, and its top is 2 mm to 40 mm over that: closer to
        // the cone than the knee to the cylinder, and yet to go down along the cylinder.
        let landing = landing();
        for over in [0.002, 0.01, 0.04] {
            let (lean, up) = (0.01, 0.5 - over);
            let pose = pose(&landing, [lean, 0.0, 0.0, 1.0 - up * lean.cos(), 0.2 + up * lean.sin(), 0.0]);
            let poses = [&Pose::IDENTITY, &pose];
            let mut found = Vec::new();
            landing.near(poses, 0.1, &mut found);
            assert!(found[0].meeting.gap.abs() < 1e-12 && (found[0].left - over).abs() < 1e-12);
            let slopes = found.iter().map(|near| near.meeting.spot.in_world(poses).1.z.abs());
            assert!(slopes.fold(0.0, f64::max) < 0.011, "{found:?}");
        }
    }

    #[test]
    fn a_knee_over_the_cone_is_pushed_aside_and_up() {
        // 0.15 m over the shoulder the cone has narrowed by half of 0.12 m: its side is 0.14 m from the axis.
        let near = standing(-0.14, 1.15)[0];
        let length = 0.3_f64.hypot(0.12);
        let normal = near.meeting.spot.in_world([&Pose::IDENTITY, &Pose::IDENTITY]).1;
        assert!(near.meeting.gap.abs() < 1e-12);
        // Towards the post, the first body: the way of the wall is the opposite.
        assert!((normal - DVec3::new(0.3, 0.0, -0.12) / length).length() < 1e-12);
    }

    #[test]
    fn a_knee_just_below_the_tip_is_pushed_aside_and_up_all_the_same() {
        // 14 mm past the rim of the tip, 80 mm from the axis, and 8.3 mm below it: out along the normal of the cone by 16.1 mm.
        // Level it would be the 14 mm of the rim, after which the cone is still in it.
        let near = standing(-0.066, 1.3 - 0.0083)[0];
        let length = 0.3_f64.hypot(0.12);
        assert!((near.meeting.gap + (0.014 * 0.3 + 0.0083 * 0.12) / length).abs() < 1e-12, "{near:?}");
        let normal = near.meeting.spot.in_world([&Pose::IDENTITY, &Pose::IDENTITY]).1;
        assert!((normal - DVec3::new(0.3, 0.0, -0.12) / length).length() < 1e-12);
    }

    #[test]
    fn a_lip_over_the_tip_comes_down_on_it() {
        // The flare ends 0.2 m out and 0.3464 m down: with the knee 0.15 m past the axis its lip is 50 mm short of it.
        let near = standing(0.15, 1.3 + 0.4 * 30.0_f64.to_radians().cos() + 0.02)[0];
        assert!((near.meeting.gap - 0.02).abs() < 1e-12);
        let normal = near.meeting.spot.in_world([&Pose::IDENTITY, &Pose::IDENTITY]).1;
        assert!((normal + DVec3::Z).length() < 1e-12);
    }
}
