//! Smallest distances between pairs that are watched, at a sample.

use glam::DVec3;

use crate::constraint::AnyConstraint;
use crate::contact::shape::Apart;
use crate::rope::seat::Seat;
use crate::system::{System, Watch, Watched, WatchedRope};
use crate::tree::kinematics::Kinematics;
use crate::tree::pose::Pose;

/// Distance of a pair, not positive where they touch, and a point of each side where they are nearest, of a rope on its
/// centre line; `is_whole` says whether a rope has not parted. Infinite, between points at 0, where all ropes of a side
/// have.
pub fn clearance(
    system: &System,
    kinematics: &Kinematics,
    seats: &[Seat],
    watch: &Watch,
    is_whole: impl Fn(usize) -> bool,
) -> Apart {
    let pose = |body: Option<usize>| body.map_or(Pose::IDENTITY, |body| kinematics.pose[body]);
    let [one, other] = &watch.between;
    let mut least = Apart { distance: f64::INFINITY, points: [DVec3::ZERO; 2] };
    let mut hold = |found: Apart| {
        if found.distance < least.distance {
            least = found;
        }
    };
    for own in one.shapes.iter().map(|&shape| &system.shapes[shape]) {
        for its in other.shapes.iter().map(|&shape| &system.shapes[shape]) {
            hold(own.shape.apart(&its.shape, [&pose(own.body), &pose(its.body)]));
        }
    }
    let mut ropes = |with: &Watched, against: &Watched, is_first: bool| {
        for rope in with.ropes.iter().filter(|rope| is_whole(rope.rope)) {
            for line in lines(system, kinematics, seats, rope) {
                for shape in against.shapes.iter().map(|&shape| &system.shapes[shape]) {
                    let Apart { distance, points: [on_shape, on_rope] } =
                        shape.shape.apart_from_line(&pose(shape.body), line);
                    let points = if is_first { [on_rope, on_shape] } else { [on_shape, on_rope] };
                    hold(Apart { distance: distance - rope.radius, points });
                }
            }
        }
    };
    ropes(one, other, true);
    ropes(other, one, false);
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
