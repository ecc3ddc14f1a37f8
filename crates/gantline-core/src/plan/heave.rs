//! Heave compensation: a hoist lets its hook down by what the vessel heaves up at the boom head, so that the hook stays.
//!
//! A sensor knows how the vessel moves, and where the boom head is: at every glance it is seen how far that place of the
//! vessel has gone up since the last one, over the ground or over the level of a deck below it. That the boom bends or its
//! tackles stretch is not seen. The height z that adds up passes a high-pass filter of first order, as in a sensor of
//! motion, which knows no height but only what changes: the slow height s follows z within the filter time τ,
//! ds/dt = (z - s)/τ, and the hoist is to be at s - z. So long as it keeps to its limits waves of the angular frequency ω
//! leave s of their heave at the hook, 1/(1 + iωτ).

use glam::DVec3;
use serde::{Deserialize, Serialize};

use super::course::Motion;
use super::follow::{Place, View, within};
use super::step::Move;
use crate::tree::kinematics::Kinematics;

/// Time between glances [s].
pub const EVERY: f64 = 0.1;
/// Within this heave compensation begins, and comes to rest where it ends [s]: in the middle of a wave neither is sudden.
pub const EASE: f64 = 4.0;
/// What it may be asked for beyond its limits by rounding.
const ROUNDING: f64 = 1e-9;

/// What compensates heave.
#[derive(Debug, Clone, PartialEq)]
pub struct Compensator {
    /// Its hook.
    pub name: String,
    /// The vessel whose motion it senses.
    pub vessel: usize,
    /// From where the falls of the hook hang.
    pub head: Place,
    /// Downwards.
    pub down: DVec3,
    /// Its hoist. Velocity, acceleration and range are what compensation may add to the motion of the hook.
    pub hoist: Move,
    /// Within this its slow height follows [s].
    pub filter: f64,
}

/// What a compensator does.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub enum Compensating {
    /// Nothing.
    Off,
    /// It compensates.
    On(Watch),
    /// It comes to rest at this time [s].
    Stopping(f64),
}

/// What keeps a compensator from following.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum HeaveLimit {
    /// Its speed.
    Speed,
    /// Its acceleration.
    Acceleration,
    /// Its stroke: it is at an end of that, or has to brake before it.
    Stroke,
}

/// How far a compensator has got. One that begins again before it has come to rest has to catch up first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
enum Reach {
    Catching,
    Following,
    AtLimit(HeaveLimit),
    Told,
}

/// What a compensator knows of what it watches.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Watch {
    /// Time of the next glance [s].
    pub next: f64,
    /// The body above whose deck heights are; none is the ground.
    pub against: Option<usize>,
    /// When it began [s].
    begin: f64,
    /// Above which deck, or the ground, they were before, and since when they are above another [s].
    former: Option<usize>,
    turned: f64,
    /// The levels of both decks below the head at the last glance, where they were seen [m].
    levels: [Option<f64>; 2],
    /// How fast the hook was moved as it began, by what had not come to rest [m/s].
    carried: f64,
    /// The place of the vessel at the boom head at the last glance.
    mark: Mark,
    /// How far that has gone up over the deck, of which it counts more and more as it begins, at the last glance [m].
    up: f64,
    /// The slow height [m].
    slow: f64,
    /// When it saw the last heights, and these, the latest first [s, m].
    heights: [(f64, f64); 2],
    /// How many of them there are.
    known: usize,
    /// How far it has got.
    course: Reach,
}

impl Compensator {
    /// Within which time what it adds comes to rest where it ends [s]: as [`EASE`], but no more suddenly than its
    /// acceleration allows, and before the end of its stroke.
    pub fn ease(&self, added: Motion) -> f64 {
        let Move { acceleration, range, .. } = self.hoist;
        let speed = added.velocity.abs();
        let [low, high] = range.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]);
        let room = if added.velocity < 0.0 { added.position - low } else { high - added.position };
        if speed > 0.0 { EASE.max(speed / acceleration).min(2.0 * room / speed) } else { EASE }
    }

    /// Which of its limits gives it a velocity, and the time to get to that, in place of the velocity that it wants.
    fn held_by(&self, wanted: f64, added: Motion, given: (f64, f64)) -> Option<HeaveLimit> {
        if given.1 == EVERY && (wanted - given.0).abs() <= ROUNDING * self.hoist.velocity {
            return None;
        }
        let endless = Move { range: None, ..self.hoist.clone() };
        if within(wanted, added, &endless, EVERY) != given {
            return Some(HeaveLimit::Stroke);
        }
        let is_fastest = given.0.abs() >= (1.0 - ROUNDING) * self.hoist.velocity;
        Some(if is_fastest { HeaveLimit::Speed } else { HeaveLimit::Acceleration })
    }
}

/// A place of a vessel that is watched.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
struct Mark {
    /// In the frame of the vessel [m].
    place: [f64; 3],
    /// How high it was when it was marked [m].
    height: f64,
}

impl Mark {
    /// Its place at a point of the world.
    fn at(point: DVec3, of: &Compensator, kinematics: &Kinematics) -> Self {
        let pose = &kinematics.pose[of.vessel];
        let place = pose.rotation.transpose() * (point - pose.position);
        Self { place: place.to_array(), height: -of.down.dot(point) }
    }

    /// By how much it has gone up since [m].
    fn rise(&self, of: &Compensator, kinematics: &Kinematics) -> f64 {
        -of.down.dot(kinematics.point(Some(of.vessel), DVec3::from_array(self.place))) - self.height
    }
}

impl Watch {
    /// From a time [s] on.
    pub fn from(begin: f64, against: Option<usize>) -> Self {
        Self {
            next: begin,
            against,
            begin,
            former: against,
            turned: begin,
            levels: [None; 2],
            carried: 0.0,
            mark: Mark::default(),
            up: 0.0,
            slow: 0.0,
            heights: [(0.0, 0.0); 2],
            known: 0,
            course: Reach::Catching,
        }
    }

    /// From a time [s] on heights are above another deck, or the ground: of how that goes up more and more counts, and less
    /// and less of the former.
    pub fn turned_to(self, at: f64, against: Option<usize>) -> Self {
        Self { against, former: self.against, turned: at, levels: [None, self.levels[0]], ..self }
    }

    /// Glances; to which velocity what it adds goes, and within which time [m/s, s]. `added` is how the hook moves by what
    /// it has added.
    pub fn glance(&mut self, of: &Compensator, added: Motion, kinematics: &Kinematics) -> (f64, f64) {
        let at = self.next;
        self.next += EVERY;
        // Steps of fixed length do not end where it glances, and what it sees is a little older.
        let [last, before] = self.heights;
        if self.known > 0 && kinematics.time <= last.0 {
            return (added.velocity, EVERY);
        }
        if self.known == 0 {
            self.carried = added.velocity;
        }
        let seen = (kinematics.time, self.height(of, kinematics));
        // By the heights so far, as a parabola; where it does not go on like that the next glance shows it.
        let slope = |late: (f64, f64), early: (f64, f64)| (late.1 - early.1) / (late.0 - early.0);
        let eases = self.carried / EASE;
        let (speed, bend) = match self.known {
            0 => (-self.carried, eases),
            1 => (slope(seen, last) + 0.5 * eases * (seen.0 - last.0), eases),
            _ => {
                let bend = (slope(seen, last) - slope(last, before)) / (0.5 * (seen.0 - before.0));
                (slope(seen, last) + 0.5 * bend * (seen.0 - last.0), bend)
            }
        };
        let height = seen.1 + speed * (at - seen.0);
        if self.known == 0 {
            // It begins where it is.
            self.slow = height + added.position;
        } else {
            let share = -(-(seen.0 - last.0) / of.filter).exp_m1();
            self.slow += share * (0.5 * (seen.1 + last.1) - self.slow);
        }
        self.heights = [seen, last];
        self.known = (self.known + 1).min(2);
        let rising = (height - self.slow) / of.filter;
        let [now, then] = [at, self.next].map(|time| rising - (speed + bend * (time - seen.0)));
        let lag = self.slow - height - added.position + 0.5 * EVERY * (now - then);
        let view = View { lag, rate: 1.0 };
        let wanted = view.velocity(then, added.velocity, of.hoist.acceleration, EVERY);
        let given = within(wanted, added, &of.hoist, EVERY);
        self.course = match (self.course, of.held_by(wanted, added, given)) {
            (Reach::Catching, None) => Reach::Following,
            (Reach::Following, Some(limit)) => Reach::AtLimit(limit),
            (Reach::AtLimit(_), _) => Reach::Told,
            (course, _) => course,
        };
        given
    }

    /// How far the boom head has heaved up since it began, over the level of a deck below it if there is one [m]. What moved
    /// the hook before comes to rest within the time in which all of that begins to count.
    fn height(&mut self, of: &Compensator, kinematics: &Kinematics) -> f64 {
        let (body, at) = of.head;
        let head = kinematics.point(Some(body), at);
        let levels = [self.against, self.former].map(|deck| {
            deck.map_or(0.0, |deck| {
                let pose = &kinematics.pose[deck];
                let normal = pose.rotation.z_axis;
                -of.down.dot(head) + normal.dot(head - pose.position) / normal.dot(of.down)
            })
        });
        if self.known > 0 {
            let share = |time: f64, since: f64| ((time - since) / EASE).clamp(0.0, 1.0);
            let (now, last) = (kinematics.time, self.heights[0].0);
            let [deck, former] = [0, 1].map(|k| self.levels[k].map_or(0.0, |before| levels[k] - before));
            let goes = share(now, self.turned);
            let rise = self.mark.rise(of, kinematics) - goes * deck - (1.0 - goes) * former;
            let rest = 1.0 - share(0.5 * (now + last), self.begin);
            self.up += share(now, self.begin) * rise - rest * self.carried * (now - last);
        }
        (self.mark, self.levels) = (Mark::at(head, of, kinematics), levels.map(Some));
        self.up
    }

    /// What it is held by at the first glance at which it cannot follow any more what it has followed.
    pub fn comes_to_a_limit(&self) -> Option<HeaveLimit> {
        match self.course {
            Reach::AtLimit(limit) => Some(limit),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::{DMat3, DQuat};

    use super::*;
    use crate::plan::drive::Timeline;
    use crate::spec::RampShape;
    use crate::tree::Tree;
    use crate::tree::pose::Pose;

    fn compensator(velocity: f64, acceleration: f64, range: Option<[f64; 2]>) -> Compensator {
        let shape = RampShape::Linear;
        let hoist =
            Move { drive: 0, velocity, acceleration, shape, range, emergency: None, reel: None, slips: None };
        Compensator {
            name: String::new(),
            vessel: 0,
            head: (0, DVec3::ZERO),
            down: -DVec3::Z,
            hoist,
            filter: 20.0,
        }
    }

    /// Two bodies, a head and a deck, at given heights; the deck heeled by an angle.
    fn at(head: DVec3, deck: f64, heel: f64) -> Kinematics {
        let mut kinematics = Kinematics::new(&Tree::new(Vec::new(), DVec3::ZERO));
        let level = Pose { position: head, ..Pose::IDENTITY };
        let rotation = DMat3::from_quat(DQuat::from_rotation_x(heel));
        kinematics.pose = vec![level, Pose { position: DVec3::new(0.0, 0.0, deck), rotation }];
        kinematics
    }

    /// What it has added, over time, as a head heaves; sampled four times between glances.
    fn added(of: &Compensator, heave: impl Fn(f64) -> f64, lasts: f64) -> Vec<(f64, Motion)> {
        let (mut timeline, mut watch) = (Timeline::new(0.0, 0), Watch::from(0.0, None));
        let mut found = Vec::new();
        while watch.next < lasts {
            let now = watch.next;
            let mut kinematics = at(DVec3::Z * heave(now), 0.0, 0.0);
            kinematics.time = now;
            let (velocity, duration) = watch.glance(of, timeline.added(now), &kinematics);
            timeline.add(now, (now, duration), velocity);
            let sample = |part: i32| now + 0.25 * f64::from(part) * EVERY;
            found.extend((0..4).map(sample).map(|time| (time, timeline.added(time))));
        }
        found
    }

    /// A complex number.
    #[derive(Clone, Copy)]
    struct Phasor(f64, f64);

    impl Phasor {
        fn turn(angle: f64) -> Self {
            Self(angle.cos(), angle.sin())
        }

        fn scaled(self, by: f64) -> Self {
            Self(by * self.0, by * self.1)
        }

        fn plus(self, other: Self) -> Self {
            Self(self.0 + other.0, self.1 + other.1)
        }

        fn times(self, other: Self) -> Self {
            Self(self.0 * other.0 - self.1 * other.1, self.0 * other.1 + self.1 * other.0)
        }

        fn over(self, other: Self) -> Self {
            self.times(Self(other.0, -other.1)).scaled(1.0 / other.0.hypot(other.1).powi(2))
        }
    }

    /// What a hook keeps of heave of 1 at the glances, which are linear in it as long as no limit is reached: with
    /// x = exp iωT the slow height is s = (1 - e)(1 + 1/x)/2(1 - e/x), e = exp -T/τ, the speed and bend of the parabola
    /// S = (3 - 4/x + 1/x²)/2T and B = (1 - 2/x + 1/x²)/T². The velocity u of what is added c, x c = c + T(u + x u)/2, is
    /// x u = r - S - BT + K((s - 1 - c)/T + (r - S - u)/2) with r = (1 - s)/τ and K = 1/2.
    fn kept(omega: f64, filter: f64) -> f64 {
        let (t, k, one) = (EVERY, 0.5, Phasor(1.0, 0.0));
        let (x, back, twice) =
            (Phasor::turn(omega * t), Phasor::turn(-omega * t), Phasor::turn(-2.0 * omega * t));
        let e = (-t / filter).exp();
        let slow = one.plus(back).scaled(0.5 * (1.0 - e)).over(one.plus(back.scaled(-e)));
        let speed = one.scaled(3.0).plus(back.scaled(-4.0)).plus(twice).scaled(0.5 / t);
        let bend = one.plus(back.scaled(-2.0)).plus(twice).scaled(1.0 / (t * t));
        let off = slow.plus(one.scaled(-1.0));
        let now = off.scaled(-1.0 / filter).plus(speed.scaled(-1.0));
        let then = now.plus(bend.scaled(-t));
        let asked = then.plus(off.scaled(k / t)).plus(now.scaled(0.5 * k));
        let less = x.plus(one.scaled(-1.0));
        let velocity = asked.over(x.plus(x.over(less).scaled(k)));
        let added = velocity.times(x.plus(one)).over(less).scaled(0.5 * t);
        one.plus(added).0.hypot(added.1)
    }

    /// The filter lets by 1/√(1 + ω²τ²); looking ahead along a parabola adds less than 0.6 % of heave to that for periods
    /// of 6 s and more, as the square of the time between glances.
    #[test]
    fn a_hook_keeps_what_the_filter_lets_by() {
        let of = compensator(5.0, 5.0, None);
        for period in [6.0, 9.0, 14.0] {
            let omega = std::f64::consts::TAU / period;
            let heave = |time: f64| 1.5 * (omega * time).sin();
            let found = added(&of, heave, 800.0);
            let last = (period / EVERY).round() as usize;
            let glances = found.iter().step_by(4).rev().take(10 * last);
            let sum = glances.fold(Phasor(0.0, 0.0), |sum, (time, one)| {
                sum.plus(Phasor::turn(-omega * time).scaled(heave(*time) + one.position))
            });
            let amplitude = sum.0.hypot(sum.1) / (5 * last) as f64;
            let expected = kept(omega, of.filter);
            assert!((amplitude / 1.5 - expected).abs() < 1e-9, "{period}: {amplitude} {expected}");
            assert!((expected - 1.0 / (omega * of.filter).hypot(1.0)).abs() < 6e-3, "{period}: {expected}");
        }
    }

    /// Speed, acceleration and stroke hold, whatever the waves ask for.
    #[test]
    fn it_keeps_to_its_limits() {
        for (velocity, acceleration, stroke) in [(0.3, 9.0, 9.0), (9.0, 0.2, 9.0), (9.0, 9.0, 0.4)] {
            let of = compensator(velocity, acceleration, Some([-stroke, stroke]));
            let found = added(&of, |time| 1.5 * (0.8 * time).sin(), 120.0);
            let most =
                |value: fn(&Motion) -> f64| found.iter().map(|(_, one)| value(one).abs()).fold(0.0, f64::max);
            let reached = [most(|one| one.velocity), most(|one| one.acceleration), most(|one| one.position)];
            for (reached, limit) in reached.into_iter().zip([velocity, acceleration, stroke]) {
                assert!(reached <= limit * (1.0 + 1e-9), "{reached} {limit}");
            }
            let at_limit = reached
                .into_iter()
                .zip([velocity, acceleration, stroke])
                .any(|(one, limit)| one > 0.99 * limit);
            assert!(at_limit, "{reached:?}");
        }
    }

    /// 1 m/s is wanted: from 0.2 m/s within 0.1 s that is too fast, or too sudden; with 0.3 m of the stroke left it has to brake,
    /// since 0.2²/2·0.06 m = 0.33 m. What is wanted and can be is held by nothing.
    #[test]
    fn it_tells_what_holds_it() {
        let now = Motion { position: 0.0, velocity: 0.2, acceleration: 0.0 };
        let held = |velocity, acceleration, range, wanted| {
            let of = compensator(velocity, acceleration, range);
            of.held_by(wanted, now, within(wanted, now, &of.hoist, EVERY))
        };
        assert_eq!(held(0.3, 9.0, None, 1.0), Some(HeaveLimit::Speed));
        assert_eq!(held(2.0, 0.06, None, 1.0), Some(HeaveLimit::Acceleration));
        assert_eq!(held(2.0, 0.06, Some([-1.0, 0.3]), 1.0), Some(HeaveLimit::Stroke));
        assert_eq!(held(2.0, 9.0, Some([-1.0, 0.01]), 1.0), Some(HeaveLimit::Stroke));
        assert_eq!(held(2.0, 9.0, Some([-1.0, 1.0]), 0.5), None);
    }

    /// From 0.6 m/s: 4 s, 6 s at 0.1 m/s², 2·0.3/0.6 = 1 s where 0.3 m of the stroke are left.
    #[test]
    fn it_ends_within_its_limits() {
        let eased = |acceleration, range, velocity| {
            compensator(1.0, acceleration, range).ease(Motion { position: 0.2, velocity, acceleration: 0.0 })
        };
        assert_eq!(eased(1.0, None, 0.6), EASE);
        assert!((eased(0.1, None, -0.6) - 6.0).abs() < 1e-12);
        assert!((eased(1.0, Some([-0.5, 0.5]), 0.6) - 1.0).abs() < 1e-12);
        assert!((eased(1.0, Some([-0.1, 9.0]), -0.6) - 1.0).abs() < 1e-12);
        assert_eq!(eased(1.0, Some([-0.5, 0.2]), 0.0), EASE);
    }

    /// A deck goes up by 0.3 m and heels by 0.1 rad to starboard: 2 m to port of its middle it is 2 tan 0.1 higher. The
    /// vessel goes up by 1 m.
    #[test]
    fn a_deck_heaves_below_the_head() {
        let (of, head) = (compensator(1.0, 1.0, None), DVec3::new(7.0, 2.0, 34.0));
        let mut watch = Watch::from(-EASE, Some(1));
        let before = watch.height(&of, &at(head, 4.0, 0.0));
        watch.known = 1;
        let found = watch.height(&of, &at(head + DVec3::Z, 4.3, 0.1)) - before;
        assert!((found - (1.0 - 0.3 - 2.0 * 0.1_f64.tan())).abs() < 1e-12, "{found}");
    }

    /// What luffs, or bends, heaves nothing: the place of the vessel at the head is another then.
    #[test]
    fn a_boom_that_luffs_heaves_nothing() {
        let of = Compensator { vessel: 1, ..compensator(1.0, 1.0, None) };
        for against in [None, Some(2)] {
            let mut watch = Watch::from(-EASE, against);
            let mut height = |head: f64, vessel: f64| {
                let mut kinematics = at(DVec3::Z * head, vessel, 0.0);
                kinematics.pose.push(Pose::IDENTITY);
                let height = watch.height(&of, &kinematics);
                watch.known = 1;
                height
            };
            let begun = height(30.0, 4.0);
            assert_eq!(height(35.0, 4.0), begun);
            assert!((height(35.0, 4.2) - begun - 0.2).abs() < 1e-12);
        }
    }

    /// From one deck to another it goes on smoothly: a velocity that it has comes to rest within 4 s, and what it has added
    /// since is what the former deck heaves less and less, and the other more and more.
    #[test]
    fn it_goes_from_one_deck_to_another_without_haste() {
        let of = compensator(5.0, 5.0, None);
        let (mut timeline, mut watch) = (Timeline::new(0.0, 0), Watch::from(-EASE, Some(1)));
        let deck = |time: f64| 0.5 * (0.9 * time).sin();
        let mut fastest = 0.0_f64;
        while watch.next < 20.0 {
            let now = watch.next;
            if now > 5.0 && watch.against.is_some() {
                watch = watch.turned_to(now, None);
            }
            let mut kinematics = at(DVec3::Z * 30.0, deck(now), 0.0);
            kinematics.time = now;
            let (velocity, duration) = watch.glance(&of, timeline.added(now), &kinematics);
            fastest = fastest.max((velocity - timeline.added(now).velocity).abs() / duration);
            timeline.add(now, (now, duration), velocity);
        }
        // Its deck needs 0.5·0.9² = 0.41 m/s², and its velocity that counts less and less 0.5·0.9/4 = 0.11 m/s² a quarter of a
        // period later; half of that, of what it makes good at once, more where that begins.
        assert!(fastest < 0.41_f64.hypot(0.11) + 0.5 * 0.11, "{fastest}");
        // Over the ground nothing heaves: only the slow height drifts, by less than 1 m in 20 s.
        assert!(timeline.added(20.0).velocity.abs() < 1.0 / 20.0);
    }

    /// One that has not come to rest begins again with its velocity, and comes to rest within 4 s where nothing heaves.
    #[test]
    fn it_begins_again_as_it_moves() {
        let of = compensator(5.0, 5.0, None);
        let (mut timeline, mut watch) = (Timeline::new(0.0, 0), Watch::from(0.0, None));
        timeline.add(-1.0, (-1.0, 1.0), 0.4);
        let mut fastest = 0.0_f64;
        while watch.next < EASE + 1.0 {
            let now = watch.next;
            let mut kinematics = at(DVec3::Z * 30.0, 0.0, 0.0);
            kinematics.time = now;
            let (velocity, duration) = watch.glance(&of, timeline.added(now), &kinematics);
            fastest = fastest.max((velocity - timeline.added(now).velocity).abs() / duration);
            timeline.add(now, (now, duration), velocity);
        }
        // 0.4 m/s within 4 s; what drifts begins as suddenly as the velocity, with 0.2 m/20 s within a glance and half as much again.
        assert!(fastest < 0.4 / EASE + 1.5 * 0.2 / 20.0 / EVERY, "{fastest}");
        assert!(timeline.added(EASE + 1.0).velocity.abs() < 1.0 / 20.0);
    }

    /// Against another deck it goes on from where it is.
    #[test]
    fn what_it_watches_may_change() {
        let of = compensator(5.0, 5.0, None);
        let has = Motion { position: 0.7, velocity: 0.0, acceleration: 0.0 };
        let mut watch = Watch::from(3.0, Some(1));
        let (velocity, _) = watch.glance(&of, has, &at(DVec3::Z * 30.0, 4.0, 0.0));
        // Only the slow height drifts: by 0.7 m in 20 s.
        assert!((velocity + 0.7 / 20.0).abs() < 0.02 * 0.7, "{velocity}");
        assert_eq!(watch.next, 3.0 + EVERY);
    }
}
