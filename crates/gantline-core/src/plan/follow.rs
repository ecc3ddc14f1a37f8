//! A trolley, crane or boom that goes along with its hook, so that falls stay plumb while a load turns between hooks.
//!
//! At every look it is seen where the load pulls under the hook, against where it pulls under the others: a load that
//! swings goes aside under all of them alike, and that is not followed. What the drive is behind is counted as the drive
//! counts: by how far it takes the hook along, level, for each metre or radian. It goes on as fast as its place above the
//! load goes away, and makes good half of what it is behind until the next look.

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::condition::Seen;
use super::course::Motion;
use super::step::Move;
use crate::tree::kinematics::Kinematics;

/// How many times its time between looks a drive follows on at most when all that goes on beside it has ended.
pub const SETTLING: f64 = 20.0;
/// It comes to rest then once the hook is taken along no faster than this at two looks [m/s].
pub const CALM: f64 = 1e-3;
/// Share of what it is behind that a drive makes good until the next look.
const SHARE: f64 = 0.5;

/// It comes to rest in no less than this [s]: at the end of its range nothing but rounding is left of room and velocity.
const SHORTEST: f64 = 1e-6;
/// Slings count as no shorter than this [m].
const LEAST_LENGTH: f64 = 1e-9;
/// A drive whose hooks come nearer to plumb by less than this share of the way that it moves them does not follow.
const LEAST: f64 = 0.01;

/// A body, and a point in its frame [m].
pub type Place = (usize, DVec3);

/// A sling as it pulls what hangs below it.
#[derive(Debug, Clone, PartialEq)]
pub struct Strand {
    /// Row of its tension.
    pub row: usize,
    /// Upper end.
    pub upper: Place,
    /// Lower ends: one, or two where it runs over a sheave.
    pub lower: Vec<Place>,
}

/// A hook, with what hangs under it.
#[derive(Debug, Clone, PartialEq)]
pub struct Lead {
    /// From where its falls hang, or itself where nothing lets it go aside.
    pub tip: Place,
    /// The hook.
    pub hook: Place,
    /// Slings under it; then those under what they hold, down to the load.
    pub levels: Vec<Vec<Strand>>,
}

/// How a drive takes its hooks along.
#[derive(Debug, Clone, PartialEq)]
pub struct Way {
    /// The body whose joint moves them, and its degree of freedom.
    pub joint: (usize, usize),
    /// Where they hang from what that joint moves, in the middle of them.
    pub carried: Place,
    /// Top and head of the tackles that turn the joint, where the drive counts by how much these come nearer.
    pub tackles: Option<[Place; 2]>,
}

/// What a drive follows.
#[derive(Debug, Clone, PartialEq)]
pub struct Follow {
    /// How the drive takes its hooks along.
    pub way: Way,
    /// Time between looks [s].
    pub every: f64,
    /// How many glances a look is the mean of.
    pub glances: u32,
    /// Hooks that it moves.
    pub own: Vec<Lead>,
    /// The other hooks of the load.
    pub others: Vec<Lead>,
    /// Downwards.
    pub down: DVec3,
}

/// What is seen at a look.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct View {
    /// How far the drive is behind, as it counts [m or rad].
    pub lag: f64,
    /// How far it takes its hooks along, level, for one unit of that.
    pub rate: f64,
}

/// What a drive keeps of a look.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Look {
    /// When that was, in the mean of its glances [s].
    pub at: f64,
    /// Where the drive should have been, in the mean [m or rad].
    pub place: f64,
}

/// Sums over the glances since the last look.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Glances {
    count: u32,
    at: f64,
    place: f64,
}

impl Glances {
    /// Where the drive should be at a time [s], as it is seen then [m or rad].
    pub fn add(&mut self, at: f64, place: f64) {
        (self.count, self.at, self.place) = (self.count + 1, self.at + at, self.place + place);
    }

    /// Their mean, if there are any.
    pub fn mean(&self) -> Option<Look> {
        let count = f64::from(self.count);
        (self.count > 0).then(|| Look { at: self.at / count, place: self.place / count })
    }
}

impl Lead {
    /// Where the load pulls, and how far that is from plumb below where its falls hang from [m]; none where it does not.
    fn seen(&self, seen: &Seen) -> Option<[DVec3; 2]> {
        let point = |&(body, at): &Place| seen.kinematics.point(Some(body), at);
        let mut aside = point(&self.hook) - point(&self.tip);
        for level in &self.levels {
            let (mut sum, mut weight) = (DVec3::ZERO, 0.0);
            for strand in level {
                let upper = point(&strand.upper);
                for lower in &strand.lower {
                    let along = point(lower) - upper;
                    let pull = (seen.tension)(strand.row).max(0.0) / along.length().max(LEAST_LENGTH);
                    (sum, weight) = (sum + pull * along, weight + pull);
                }
            }
            if weight == 0.0 {
                return None;
            }
            aside += sum / weight;
        }
        Some([point(&self.tip) + aside, aside])
    }
}

impl Way {
    /// How the place from which the hooks hang moves for one unit of the drive.
    fn column(&self, kinematics: &Kinematics) -> DVec3 {
        let (body, dof) = self.joint;
        let column = &kinematics.columns[dof];
        let point = |&(body, at): &Place| kinematics.point(Some(body), at);
        let moved = |at: DVec3| column.linear + column.angular.cross(at - kinematics.pose[body].position);
        let carried = moved(point(&self.carried));
        match &self.tackles {
            None => carried,
            Some([top, head]) => {
                let between = point(head) - point(top);
                -carried / moved(point(head)).dot(between.normalize_or_zero())
            }
        }
    }
}

impl Follow {
    /// What there is to see; none where the load does not pull at both ends, or the drive brings its hooks no nearer to
    /// plumb.
    ///
    /// A drive that lifts its hooks by z' for each unit turns the load as well: the line r between where it pulls at both
    /// ends keeps its length, and its level part h gets longer by -r_z z'/h.
    pub fn view(&self, seen: &Seen) -> Option<View> {
        let mean = |leads: &[Lead]| {
            let carrying = leads.iter().filter_map(|lead| lead.seen(seen));
            let (sum, count) = carrying.fold(([DVec3::ZERO; 2], 0), |([pulled, aside], count), one| {
                ([pulled + one[0], aside + one[1]], count + 1)
            });
            (count > 0).then(|| sum.map(|value| value / f64::from(count)))
        };
        let ([own, own_aside], [others, others_aside]) = (mean(&self.own)?, mean(&self.others)?);
        let level = |vector: DVec3| vector - vector.dot(self.down) * self.down;
        let (column, line) = (self.way.column(seen.kinematics), own - others);
        let along = level(column);
        let rate = along.length();
        let way = along / rate;
        let span = level(line).length_squared().max(LEAST_LENGTH);
        let nearer = rate + line.dot(self.down) * column.dot(self.down) * line.dot(way) / span;
        let is_led = rate.min(nearer) > LEAST * column.length();
        is_led.then(|| View { lag: (own_aside - others_aside).dot(way) / nearer, rate })
    }
}

impl View {
    /// Velocity with which a drive catches up, whatever its speed and range are [m/s or rad/s].
    ///
    /// # Arguments
    /// - `along`: how fast its place goes on, as far as that is known.
    /// - `now`: velocity of the drive at this look.
    /// - `acceleration`: its acceleration, per s².
    /// - `every`: time between looks [s].
    pub fn velocity(&self, along: f64, now: f64, acceleration: f64, every: f64) -> f64 {
        // By how much it will be behind at the next look if it only comes to that velocity.
        let behind = self.lag + 0.5 * every * (along - now);
        // No faster past that than half of its acceleration brakes.
        let most = (acceleration * behind.abs()).sqrt();
        along + (SHARE * behind / every).clamp(-most, most)
    }
}

/// To which velocity a drive goes, and within which time, where `wanted` [m/s] is asked for: as far as its speed,
/// acceleration and range allow it until the next look, `every` [s] from now [m/s, s].
pub fn within(wanted: f64, now: Motion, limits: &Move, every: f64) -> (f64, f64) {
    let (a, fastest) = (limits.acceleration, limits.velocity.abs());
    let [low, high] = limits.range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
    let [ahead, behind] = [high - now.position, now.position - low];
    let (u, room) = if now.velocity < 0.0 { (-now.velocity, behind) } else { (now.velocity, ahead) };
    if u * every > 2.0 * room {
        // It has to be at rest before the next look.
        return (0.0, (2.0 * room / u).max(SHORTEST));
    }
    let up = ending_within(now.velocity, ahead, a, every).min(fastest);
    let down = -ending_within(-now.velocity, behind, a, every).min(fastest);
    (wanted.min(up).max(down).clamp(now.velocity - a * every, now.velocity + a * every), every)
}

/// The velocity v to which a drive may go from u until the next look so that braking with a ends within a room r:
/// `(u + v)T/2 + v²/2a = r`.
fn ending_within(u: f64, room: f64, a: f64, every: f64) -> f64 {
    let half = 0.5 * a * every;
    (half * half - a * u * every + 2.0 * a * room).max(0.0).sqrt() - half
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::drive::Timeline;
    use crate::spec::RampShape;

    const TOLERANCE: f64 = 1e-12;
    const LOOK: f64 = 1.0;

    fn limits(velocity: f64, acceleration: f64, range: Option<[f64; 2]>) -> Move {
        Move {
            drive: 0,
            velocity,
            acceleration,
            shape: RampShape::Linear,
            range,
            emergency: None,
            reel: None,
            slips: None,
        }
    }

    /// A place that goes on by itself, the drive behind it; what it is behind at every look.
    fn chase(place: impl Fn(f64) -> f64, limits: &Move, looks: usize) -> (Timeline, Vec<f64>) {
        let mut timeline = Timeline::new(0.0, 4);
        let (mut before, mut behind) = (None, Vec::new());
        for at in (0..looks).map(|look| look as f64 * LOOK) {
            let now = timeline.motion(at);
            let view = View { lag: place(at) - now.position, rate: 1.0 };
            let along = before.map_or(0.0, |before| (place(at) - before) / LOOK);
            let wanted = view.velocity(along, now.velocity, limits.acceleration, LOOK);
            let (velocity, duration) = within(wanted, now, limits, LOOK);
            timeline.ramp(at, duration, velocity, RampShape::Linear);
            before = Some(place(at));
            behind.push(view.lag);
        }
        (timeline, behind)
    }

    /// Of a place with constant velocity w: with u = v - w the next look has u' = K (e - T u/2), e' = e - T (u + u')/2,
    /// whose matrix has the eigenvalues 0 and 1 - K T = 1/2.
    #[test]
    fn what_it_is_behind_halves_at_every_look() {
        let (_, behind) = chase(|time| 0.3 + 0.02 * time, &limits(9.0, 9.0, None), 24);
        for pair in behind[3..].windows(2) {
            assert!((pair[1] - 0.5 * pair[0]).abs() < TOLERANCE, "{behind:?}");
        }
    }

    /// Of a place P = αt²/2. At the look k it is seen to go with α(k - 1/2)T, as it went half a look before. A drive that
    /// keeps the distance e has v = αkT there, since (v + v')T/2 = P' - P. So v' = α(k + 1)T asks for
    /// e - αT²/4 = 3/2 αT/K with K = 1/2T: e = 13/4 αT².
    #[test]
    fn it_stays_behind_a_place_that_goes_ever_faster() {
        let alpha = 1e-3;
        let (_, behind) = chase(|time| 0.5 * alpha * time * time, &limits(9.0, 9.0, None), 60);
        let last = behind[behind.len() - 1];
        assert!((last - 3.25 * alpha * LOOK * LOOK).abs() < TOLERANCE, "{last}");
    }

    /// Half a metre behind at rest, and slow to speed up: it comes there without going beyond by more than a millimetre.
    #[test]
    fn it_does_not_go_beyond_what_it_can_brake_from() {
        for acceleration in [0.01, 0.02, 0.05, 0.2] {
            let (timeline, behind) = chase(|_| 0.5, &limits(0.3, acceleration, None), 120);
            assert!(behind.iter().all(|lag| *lag > -1e-3), "{acceleration}: {behind:?}");
            assert!(behind[119].abs() < 1e-9);
            for k in 0..12_000 {
                let motion = timeline.motion(0.01 * f64::from(k));
                assert!(motion.acceleration.abs() <= acceleration * (1.0 + 1e-9));
            }
        }
    }

    #[test]
    fn it_keeps_its_speed_acceleration_and_range() {
        let bounds = limits(0.1, 0.03, Some([-0.4, 0.9]));
        for place in [-5.0, 0.85, 5.0] {
            let mut timeline = Timeline::new(0.0, 4);
            for at in (0..60).map(|look| f64::from(look) * LOOK) {
                let now = timeline.motion(at);
                let view = View { lag: place - now.position, rate: 1.0 };
                let wanted = view.velocity(0.0, now.velocity, bounds.acceleration, LOOK);
                let (velocity, duration) = within(wanted, now, &bounds, LOOK);
                timeline.ramp(at, duration, velocity, RampShape::Linear);
                for part in 0..=20 {
                    let motion = timeline.motion(at + f64::from(part) * 0.05 * LOOK);
                    assert!(motion.velocity.abs() <= 0.1 + TOLERANCE, "{motion:?}");
                    assert!(motion.acceleration.abs() <= 0.03 + TOLERANCE, "{motion:?}");
                    assert!(
                        motion.position > -0.4 - TOLERANCE && motion.position < 0.9 + TOLERANCE,
                        "{motion:?}"
                    );
                }
            }
            let end = timeline.motion(60.0).position;
            assert!((end - place.clamp(-0.4, 0.9)).abs() < 1e-6, "{place}: {end}");
        }
    }
}
