//! Smallest distances between pairs that are watched, at a sample.

use glam::DVec3;

use crate::constraint::AnyConstraint;
use crate::rope::seat::Seat;
use crate::system::{System, Watch, Watched, WatchedRope};
use crate::tree::kinematics::Kinematics;
use crate::tree::pose::Pose;

/// Distance of a pair [m], not positive where they touch; `is_whole` says whether a rope has not parted. Infinite where all
/// ropes of a side have.
pub fn clearance(
    system: &System,
    kinematics: &Kinematics,
    seats: &[Seat],
    watch: &Watch,
    is_whole: impl Fn(usize) -> bool,
) -> f64 {
    let pose = |body: Option<usize>| body.map_or(Pose::IDENTITY, |body| kinematics.pose[body]);
    let [one, other] = &watch.between;
    let mut least = f64::INFINITY;
    for own in one.shapes.iter().map(|&shape| &system.shapes[shape]) {
        for its in other.shapes.iter().map(|&shape| &system.shapes[shape]) {
            least = least.min(own.shape.distance(&its.shape, [&pose(own.body), &pose(its.body)]));
        }
    }
    let mut ropes = |with: &Watched, against: &Watched| {
        for rope in with.ropes.iter().filter(|rope| is_whole(rope.rope)) {
            for line in lines(system, kinematics, seats, rope) {
                for shape in against.shapes.iter().map(|&shape| &system.shapes[shape]) {
                    let apart = shape.shape.distance_to_line(&pose(shape.body), line);
                    least = least.min(apart - rope.radius);
                }
            }
        }
    };
    ropes(one, other);
    ropes(other, one);
    least
}

/// Straight parts of a rope without what is left out at its ends.
fn lines(system: &System, kinematics: &Kinematics, seats: &[Seat], watched: &WatchedRope) -> Vec<[DVec3; 2]> {
    let AnyConstraint::Rope(rope) = &system.constraints[watched.rope] else { return Vec::new() };
    let mut lines = Vec::with_capacity(rope.route.parts.len());
    rope.route.length(kinematics, seats, |_, straight| lines.push([straight.from, straight.to]));
    let [start, end] = watched.without;
    let mut left = start;
    lines.retain_mut(|[from, to]| shorten(from, *to, &mut left));
    left = end;
    lines.reverse();
    lines.retain_mut(|[from, to]| shorten(to, *from, &mut left));
    lines
}

/// Moves an end of a line by what is `left` towards the other; false where nothing of the line remains.
fn shorten(end: &mut DVec3, other: DVec3, left: &mut f64) -> bool {
    let length = (other - *end).length();
    if *left >= length {
        *left -= length;
        return false;
    }
    if length > 0.0 {
        *end += (other - *end) * (*left / length);
    }
    *left = 0.0;
    true
}
