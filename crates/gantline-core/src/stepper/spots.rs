//! Where bodies may touch, from step to step.
//!
//! Within a step a spot is a point of one body against a plane of the other, so that its rows are smooth and their
//! derivatives exact. At the end of the step spots are found anew: those that are where they were stay as they are to the
//! last bit, others move with the deflection of their tangential springs, those that have gone carry no more.

use glam::DVec3;

use crate::constraint::AnyConstraint;
use crate::constraint::touch::Touch;
use crate::contact::landing::{Landing, Near, PLACES};
use crate::contact::pad::Pad;
use crate::contact::plane::Plane;
use crate::contact::shape::Meeting;
use crate::contact::spot::Spot;
use crate::event::{EventKind, EventLog};
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::system::{Finder, System};
use crate::tree::kinematics::{Kinematics, Twist};
use crate::tree::pose::Pose;

/// Shapes that are closer than this have spots [m].
pub const REACH: f64 = 0.2;
/// Spots that have moved less, apart [m] and in the direction of their normals [rad], stay where they are.
const STAYS: (f64, f64) = (1e-4, 1e-3);
/// Edges that cross and have turned less since they were found stay [rad].
const TURNED: f64 = 1e-4;
/// Spots whose depth changes by less than this stay where they are [m].
const SAME_DEPTH: f64 = 1e-7;
/// A point of a body on a support stays the same within this [m].
const STAYS_ON_PAD: f64 = 2e-4;
/// A body slides over the top of a support by no more than so many tolerances of position in a step, or by the second [m]. The
/// place that carries is fixed in the body meanwhile and so goes along with it, as far as that: forces of supports that are
/// s apart are off by that over s, of which no error estimate knows.
const SLIDES: (f64, f64) = (50.0, 5e-4);
/// How far beyond the edge of a support a place that carries is seen to have left it [m].
const EDGE: f64 = 1e-3;
/// How far beyond the end of a side a place at which a post and a wall press is followed [m]. On a cone or a flare it is
/// deeper there than the next side by this times the sine of their angle: 1 mm would be 4 kN of 20 MN/m at 11°.
const END: f64 = 1e-4;
/// A body that lies on a rim turns by no more than this in a step [rad]: the point of the rim that holds along the plane
/// lags behind by its cube over six, times the radius.
const ROLLS: f64 = 0.02;
/// Cosine of the angle between normals that are the same.
const ALIKE: f64 = 0.99;
/// A spot between other features is still the same place within this [m].
const SAME_PLACE: f64 = 0.1;

/// What has become of the spots.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Followed {
    /// Any has changed.
    pub any: bool,
    /// One that carries has changed, so that forces have jumped.
    pub carrying: bool,
}

/// Finds all spots anew at the poses, but those on tops of supports and of rims whose row is `held`; `changed` hears of every one that
/// is not where it was, with the index of its touch and what it was and is. On the top of a support a place that is `deeper` or less
/// deep by that [m] is another, however near it is.
pub fn find(
    system: &System,
    kinematics: &Kinematics,
    spots: &mut [Spot],
    deeper: f64,
    held: impl Fn(usize) -> bool,
    mut changed: impl FnMut(&Touch, &Spot, &Spot),
) {
    let (mut meetings, mut nears) = (Vec::new(), Vec::new());
    for finder in &system.finders {
        match finder {
            Finder::Pad(index, pad) => {
                let AnyConstraint::Touch(touch) = &system.constraints[*index] else { continue };
                let pose = kinematics.pose_of(touch.facing.bodies[0]);
                let found = pad.spot(pose);
                let spot = &mut spots[touch.spot];
                let depths = [spot.point, found.point].map(|point| pad.top.depth(pose.point(point)));
                let near = (spot.point - found.point).length() < STAYS_ON_PAD
                    && (depths[0] - depths[1]).abs() < deeper;
                let stays = spot.is_near && (held(system.rows.first[*index]) || found.is_near && near);
                if !stays && found != *spot {
                    changed(touch, spot, &found);
                    *spot = found;
                }
            }
            Finder::Rim(index, plane) => {
                let AnyConstraint::Touch(touch) = &system.constraints[*index] else { continue };
                let found = on_rim(touch, kinematics, plane);
                let spot = &mut spots[touch.spot];
                let near = (spot.point - found.point).length() < STAYS.0;
                if !(spot.is_near && (near || held(system.rows.first[*index]))) {
                    changed(touch, spot, &found);
                    *spot = found;
                }
            }
            Finder::Pair { shapes, first, count } => {
                let [one, other] = shapes.map(|shape| &system.shapes[shape]);
                let poses = [one.body, other.body].map(|body| kinematics.pose_of(body));
                one.shape.meet(&other.shape, poses, REACH, &mut meetings);
                let AnyConstraint::Touch(touch) = &system.constraints[*first] else { continue };
                let own = &mut spots[touch.spot..touch.spot + count];
                let holds = |is_first: bool, foot| {
                    let (shape, pose) = if is_first { (one, poses[0]) } else { (other, poses[1]) };
                    shape.shape.holds(pose, foot)
                };
                assign(poses, own, &meetings, holds, |place, found| {
                    if let AnyConstraint::Touch(touch) = &system.constraints[first + place] {
                        changed(touch, &found.0, &found.1);
                    }
                });
            }
            Finder::Landing(first, landing) => {
                let AnyConstraint::Touch(touch) = &system.constraints[*first] else { continue };
                let poses = touch.facing.bodies.map(|body| kinematics.pose_of(body));
                landing.near(poses, REACH, &mut nears);
                meetings.clear();
                meetings.extend(nears.iter().map(|near| near.meeting));
                let own = &mut spots[touch.spot..touch.spot + PLACES];
                assign(
                    poses,
                    own,
                    &meetings,
                    |_, _| false,
                    |place, found| {
                        if let AnyConstraint::Touch(touch) = &system.constraints[first + place] {
                            changed(touch, &found.0, &found.1);
                        }
                    },
                );
            }
        }
    }
}

/// The point of a rim that is lowest over its plane.
fn on_rim(touch: &Touch, kinematics: &Kinematics, plane: &Plane) -> Spot {
    let Some(rim) = touch.facing.rim else { return Spot::none() };
    let pose = kinematics.pose_of(touch.facing.bodies[0]);
    let lowest = rim.lowest(pose, plane.point, plane.normal).point;
    let point = pose.rotation.transpose() * (lowest - pose.position);
    Spot { is_near: true, point, plane: *plane, feature: 1, ..Spot::none() }
}

/// Gives each meeting of two shapes a spot: its own, that of its place, a free one, or that of one that is farther and
/// does not press, the nearest first; meetings beyond the number of spots, the farthest, have none. A spot that the
/// shapes no longer name, since their edges coincide and rounding decides, stays as long as its point is over the face:
/// `holds` says whether a world point belongs to the first shape, or the second.
fn assign(
    poses: [&Pose; 2],
    spots: &mut [Spot],
    meetings: &[Meeting],
    holds: impl Fn(bool, DVec3) -> bool,
    mut changed: impl FnMut(usize, (Spot, Spot)),
) {
    let mut owner: Vec<Option<usize>> = vec![None; spots.len()];
    let mut taken = vec![false; meetings.len()];
    for (slot, spot) in spots.iter().enumerate().filter(|(_, spot)| spot.is_near) {
        let is_same = |index: &usize| !taken[*index] && meetings[*index].spot.feature == spot.feature;
        if let Some(index) = (0..meetings.len()).find(is_same) {
            (owner[slot], taken[index]) = (Some(index), true);
        }
    }
    for (slot, spot) in spots.iter().enumerate().filter(|(_, spot)| spot.is_near) {
        if owner[slot].is_some() {
            continue;
        }
        let (place, normal) = spot.in_world(poses);
        let distance = |index: usize| {
            let (there, other) = meetings[index].spot.in_world(poses);
            let is_alike = !taken[index] && normal.dot(other) > 0.5;
            if is_alike { (there - place).length() } else { f64::INFINITY }
        };
        let nearest = (0..meetings.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        if let Some(index) = nearest.filter(|&index| distance(index) < SAME_PLACE) {
            (owner[slot], taken[index]) = (Some(index), true);
        }
    }
    let mut kept = vec![false; spots.len()];
    for (slot, spot) in spots.iter().enumerate().filter(|(slot, spot)| spot.is_near && owner[*slot].is_none())
    {
        let (place, normal) = spot.in_world(poses);
        let is_alike = |meeting: &Meeting| normal.dot(meeting.spot.in_world(poses).1) > ALIKE;
        let apart = spot.gap(poses);
        let foot = if spot.is_swapped { place + normal * apart } else { place - normal * apart };
        kept[slot] = meetings.iter().any(is_alike) && apart < REACH && holds(spot.is_swapped, foot);
    }
    for index in (0..meetings.len()).filter(|&index| !taken[index]) {
        let is_free = |slot: &usize| owner[*slot].is_none() && !kept[*slot];
        let free = (0..spots.len()).filter(is_free).min_by_key(|&slot| spots[slot].is_near);
        // Else that of the farthest: a load in a narrow hole has walls on all sides, and comes upon any of them.
        let gap = |slot: usize| owner[slot].map_or_else(|| spots[slot].gap(poses), |own| meetings[own].gap);
        let farthest = || (0..spots.len()).max_by(|&a, &b| gap(a).total_cmp(&gap(b)));
        let gives_way = |slot: &usize| gap(*slot) > meetings[index].gap.max(0.0) + SAME_DEPTH;
        let Some(slot) = free.or_else(|| farthest().filter(gives_way)) else { break };
        (owner[slot], kept[slot]) = (Some(index), false);
    }
    for (slot, spot) in spots.iter_mut().enumerate() {
        let gone = if kept[slot] { spot.anew(poses) } else { Spot::none() };
        let found = owner[slot].map_or(gone, |index| meetings[index].spot);
        if (!spot.is_near && !found.is_near) || stays(spot, &found, poses) {
            spot.feature = found.feature;
            continue;
        }
        changed(slot, (*spot, found));
        *spot = found;
    }
}

/// True where a spot that is found anew is where it was.
fn stays(old: &Spot, new: &Spot, poses: [&Pose; 2]) -> bool {
    if !old.is_near || !new.is_near || (old.gap(poses) - new.gap(poses)).abs() > SAME_DEPTH {
        return false;
    }
    let [(place, normal), (there, other)] = [old, new].map(|spot| spot.in_world(poses));
    let apart = (there - place) - normal * normal.dot(there - place);
    // A crossing goes along with its edges: where it was found tells how far it has come.
    !old.has_run(new, STAYS.0, TURNED) && apart.length() < STAYS.0 && (normal - other).length() < STAYS.1
}

/// Lets the spots follow to the end of a step, where rows have the values `value`, at the state's time.
pub fn follow(
    system: &System,
    kinematics: &Kinematics,
    value: &[f64],
    state: &mut State,
    log: &mut EventLog,
) -> Followed {
    let mut followed = Followed::default();
    let mut spots = std::mem::take(&mut state.spots);
    find(
        system,
        kinematics,
        &mut spots,
        SAME_DEPTH,
        |_| false,
        |touch, old, new| {
            let row = first_row(system, touch);
            followed.any = true;
            let carries = state.modes[row].carries();
            followed.carrying |= carries;
            if carries && !new.is_near {
                for row in row..row + 3 {
                    state.modes[row] = Mode::Slack;
                    (state.tension[row], state.trial[row]) = (0.0, 0.0);
                }
                if touch.is_support {
                    log.push(state.time, EventKind::OffSupport, system.constraint_index(row));
                }
                note_lift_off(system, state, touch.group, state.time, log);
            } else if !state.modes[row].is_absent() {
                stand_elsewhere(system, kinematics, (touch, old, new), carries.then_some(value), state);
            }
        },
    );
    state.spots = spots;
    followed
}

/// A touch whose spot has changed holds there what it held, by the values of rows; nothing where it did not carry.
pub fn stand_elsewhere(
    system: &System,
    kinematics: &Kinematics,
    (touch, old, new): (&Touch, &Spot, &Spot),
    value: Option<&[f64]>,
    state: &mut State,
) {
    if new.is_near {
        let row = first_row(system, touch);
        let values = value.map_or([0.0; 2], |value| [value[row + 1], value[row + 2]]);
        let displaced = touch.facing.displaced(kinematics, old, values);
        let remembered = touch.facing.remembered(kinematics, new, displaced);
        state.memory[row + 1..row + 3].copy_from_slice(&remembered);
    }
}

/// First row of a touch.
fn first_row(system: &System, touch: &Touch) -> usize {
    system.rows.first[touch.index]
}

/// Logs that a load has lifted off where no contact of its group is left that carries.
pub fn note_lift_off(system: &System, state: &State, group: usize, time: f64, log: &mut EventLog) {
    let mut rows = system.groups[group].contacts.iter().map(|&contact| system.rows.first[contact]);
    if !rows.any(|row| state.modes[row].carries()) {
        log.push(time, EventKind::LiftOff, group);
    }
}

/// The longest step in which no two shapes come closer than half of what their spots reach, no place that carries
/// slides farther than [`SLIDES`] or passes the edge of its support by more than [`EDGE`], or the end of a side of its post
/// by more than [`END`], and no rim that carries rolls farther than [`ROLLS`] [s], by how fast they move; `tolerance` is that
/// of positions [m].
pub fn limit(
    system: &System,
    kinematics: &Kinematics,
    twists: &[Twist],
    state: &State,
    tolerance: f64,
) -> f64 {
    let (mut most, mut nears) = (f64::INFINITY, Vec::new());
    for finder in &system.finders {
        let shapes = match finder {
            Finder::Pair { shapes, .. } => shapes,
            Finder::Pad(index, pad) => {
                let slides = f64::max(SLIDES.0 * tolerance, SLIDES.1);
                most = most.min(on_top(system, kinematics, twists, state, (*index, pad), slides));
                continue;
            }
            Finder::Rim(index, plane) => {
                let AnyConstraint::Touch(touch) = &system.constraints[*index] else { continue };
                if let Some(body) =
                    touch.facing.bodies[0].filter(|_| state.modes[system.rows.first[*index]].carries())
                {
                    most =
                        most.min(ROLLS / twists[body].angular.reject_from_normalized(plane.normal).length());
                }
                continue;
            }
            Finder::Landing(first, landing) => {
                most =
                    most.min(along_landing(system, kinematics, twists, state, (*first, landing), &mut nears));
                continue;
            }
        };
        let [one, other] = shapes.map(|shape| &system.shapes[shape]);
        let speeds = [one, other].map(|shape| {
            let speed = |body: usize| {
                twists[body].linear.length() + twists[body].angular.length() * shape.shape.radius
            };
            shape.body.map_or(0.0, speed)
        });
        let speed = speeds[0] + speeds[1];
        if speed == 0.0 {
            continue;
        }
        let near = 0.5 * REACH / speed;
        if near > most {
            continue;
        }
        let poses = [one.body, other.body].map(|body| kinematics.pose_of(body));
        let apart = one.shape.distance(&other.shape, poses);
        most = most.min((apart - 0.5 * REACH).max(0.5 * REACH) / speed);
    }
    most
}

/// How long the place at which a body carries on a support stays on its top, and slides by no more than `slides` [m] [s].
fn on_top(
    system: &System,
    kinematics: &Kinematics,
    twists: &[Twist],
    state: &State,
    (index, pad): (usize, &Pad),
    slides: f64,
) -> f64 {
    let AnyConstraint::Touch(touch) = &system.constraints[index] else { return f64::INFINITY };
    if !state.modes[system.rows.first[index]].carries() {
        return f64::INFINITY;
    }
    let place = kinematics.point(touch.facing.bodies[0], state.spots[touch.spot].point);
    let velocity = kinematics.point_velocity(twists, touch.facing.bodies[0], place);
    let sides = pad.top.along(place).into_iter().zip(pad.top.tangents).zip(pad.half);
    let times = sides.map(|((along, tangent), half)| {
        (half - along.abs()).max(EDGE).min(slides) / tangent.dot(velocity).abs()
    });
    times.fold(f64::INFINITY, f64::min)
}

/// How long a post and a wall meet where they do: until a place that carries comes to the end of what meets there, or another
/// is closed [s].
fn along_landing(
    system: &System,
    kinematics: &Kinematics,
    twists: &[Twist],
    state: &State,
    (first, landing): (usize, &Landing),
    nears: &mut Vec<Near>,
) -> f64 {
    let AnyConstraint::Touch(touch) = &system.constraints[first] else { return f64::INFINITY };
    let bodies = touch.facing.bodies;
    let poses = bodies.map(|body| kinematics.pose_of(body));
    landing.near(poses, REACH, nears);
    if nears.is_empty() {
        let speed = |side: usize| {
            bodies[side].map_or(0.0, |body| {
                twists[body].linear.length() + twists[body].angular.length() * landing.radius(side)
            })
        };
        return (landing.apart(poses) - 0.5 * REACH).max(0.5 * REACH) / (speed(0) + speed(1));
    }
    let row = system.rows.first[first];
    let carries = |feature: u64| {
        (0..PLACES).any(|place| {
            let spot = &state.spots[touch.spot + place];
            spot.is_near && spot.feature == feature && state.modes[row + 3 * place].carries()
        })
    };
    let times = nears.iter().map(|near| {
        let velocities = bodies.map(|body| kinematics.point_velocity(twists, body, near.point));
        let is_carrying = carries(near.meeting.spot.feature);
        let way = if is_carrying { near.left.max(END) } else { near.meeting.gap.max(EDGE) };
        way / (velocities[0] - velocities[1]).length()
    });
    times.fold(f64::INFINITY, f64::min)
}
