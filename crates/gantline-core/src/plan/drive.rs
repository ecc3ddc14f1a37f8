//! What a drive does over time: what plan or program ask of it, by itself or along a way that several drives go
//! together, and on top of that what compensates heave, or what waves do to a vessel whose motion is known beforehand.

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use super::course::{Course, Motion, soon};
use super::series::{self, Series};
use super::step::Emergency;
use crate::force::trains::Trains;
use crate::spec::RampShape;

/// What a program asks of a drive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Order {
    /// Velocity to go to [m/s or rad/s].
    pub velocity: f64,
    /// Acceleration with which [m/s² or rad/s²].
    pub acceleration: f64,
    /// The most that the drive can do, with which it comes to rest at an end of its range [m/s² or rad/s²].
    pub braking: f64,
    /// Least and largest position, infinite where there is no limit [m or rad].
    pub range: [f64; 2],
    /// How it stops in an emergency.
    pub emergency: Emergency,
}

/// A change of velocity that is asked for takes no less than this [s]: a controller that hardly changes anything
/// makes no steps of time that are next to nothing.
const SHORTEST: f64 = 1e-3;

/// The course of one drive over time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Timeline {
    /// What plan or program ask for.
    course: Course,
    /// What heave compensation adds, from 0.
    added: Course,
    /// How far along a way several drives have gone that go together, 0 to 1.
    along: Course,
    /// What this one does on it.
    #[serde(serialize_with = "series::save", deserialize_with = "series::restore")]
    series: Option<Arc<Series>>,
    /// What waves add. It is the lift's and not the state's: whoever takes up a saved state gives it back.
    #[serde(skip)]
    waves: Option<Arc<Trains>>,
    /// From when on a brake of which capacity holds in place of a motor [s, N].
    #[serde(default)]
    braked: Option<(f64, f64)>,
    /// What of that the last step knew [N].
    #[serde(default)]
    noticed: Option<f64>,
    /// How it stops in an emergency, once a program moves it and no longer the plan.
    #[serde(default)]
    commanded: Option<Emergency>,
    /// By how much its positions have been put right since the start [m or rad].
    #[serde(default)]
    put_right: f64,
}

impl Timeline {
    /// Takes over the course of `other`; does not allocate once there has been room.
    pub fn copy_from(&mut self, other: &Self) {
        self.course.copy_from(&other.course);
        self.added.copy_from(&other.added);
        self.along.copy_from(&other.along);
        self.series.clone_from(&other.series);
        self.waves.clone_from(&other.waves);
        (self.braked, self.noticed, self.commanded) = (other.braked, other.noticed, other.commanded);
        self.put_right = other.put_right;
    }

    /// A drive at rest at `start` [m or rad]. Room for ramps is made here, not while stepping.
    pub fn new(start: f64, ramps: usize) -> Self {
        Self {
            course: Course::new(start, ramps),
            added: Course::new(0.0, 3),
            along: Course::new(0.0, 2),
            series: None,
            waves: None,
            braked: None,
            noticed: None,
            commanded: None,
            put_right: 0.0,
        }
    }

    /// Waves move it as well.
    pub fn follow_waves(&mut self, waves: Arc<Trains>) {
        self.waves = Some(waves);
    }

    /// Gives back what a saved state does not hold, from `other`, the same drive of the same lift.
    pub fn reattach(&mut self, other: &Self) {
        self.waves.clone_from(&other.waves);
    }

    /// What waves add, if they move it.
    pub fn waves(&self) -> Option<&Trains> {
        self.waves.as_deref()
    }

    /// All its positions are `by` [m or rad] further: what it moves has slipped meanwhile, and is there.
    pub fn put_right(&mut self, by: f64) {
        self.course.shift(by);
        self.put_right += by;
    }

    /// Where it would be at `time` [s] if nothing had ever slipped: what it has been asked for [m or rad].
    pub fn asked(&self, time: f64) -> f64 {
        self.calm(time).position - self.put_right
    }

    /// Stops in an emergency from `at` [s] on.
    pub fn stop(&mut self, at: f64, how: &Emergency) {
        self.leave(at);
        self.change(at, 0.0, how.acceleration, RampShape::Linear);
        self.stop_adding(at, how.acceleration);
        if let Some(brake) = how.brake {
            self.brake(at, brake);
        }
    }

    /// Throws in a brake of the given capacity [N] at the time `at` [s]; it holds until the drive moves again.
    pub fn brake(&mut self, at: f64, capacity: f64) {
        self.braked = Some((at, capacity));
    }

    /// Capacity of the brake that is in at `time` [s], to rounding [N]; none where the motor drives.
    pub fn braked(&self, time: f64) -> Option<f64> {
        self.braked.filter(|(from, _)| *from <= soon(time)).map(|(_, capacity)| capacity)
    }

    /// True where another brake is in at `time` [s] than when this was last asked, or none any more.
    pub fn notice(&mut self, time: f64) -> bool {
        let now = self.braked(time);
        std::mem::replace(&mut self.noticed, now) != now
    }

    /// Where the drive is at `time` [s].
    pub fn motion(&self, time: f64) -> Motion {
        let calm = self.calm(time);
        let Some(waves) = &self.waves else { return calm };
        let [position, velocity, acceleration, _] = waves.at_origin(time);
        calm + Motion { position, velocity, acceleration }
    }

    /// Where it would be in still water.
    pub fn calm(&self, time: f64) -> Motion {
        self.planned(time) + self.added.motion(time)
    }

    /// Where plan or program have it: without what heave compensation and waves add.
    pub fn planned(&self, time: f64) -> Motion {
        let alone = self.course.motion(time);
        let Some(series) = &self.series else { return alone };
        alone + series.motion(self.along.motion(time))
    }

    /// Goes `series` from `at` [s] on, at most `rate` [1/s] of it in a second; returns the end [s].
    pub fn lead(&mut self, at: f64, series: &Arc<Series>, (rate, acceleration): (f64, f64)) -> f64 {
        self.leave(at);
        self.braked = None;
        self.series = Some(Arc::clone(series));
        self.along.travel(at, 1.0, rate, acceleration, RampShape::Linear)
    }

    /// Goes on by itself from `at` [s] on, from where it is and with the velocity that it has.
    fn leave(&mut self, at: f64) {
        if let Some(series) = self.series.take() {
            let Motion { position, velocity, .. } = series.motion(self.along.motion(at));
            self.course.carry(at, position, velocity);
            self.along.clear();
        }
    }

    /// What heave compensation adds, or runs through holes.
    pub fn added(&self, time: f64) -> Motion {
        self.added.motion(time)
    }

    /// What is added goes to `velocity` [m/s or kg/s] from `at` [s] on, within `duration` [s]. It is `now` [s], and until `at` what
    /// was asked for before counts: several changes may follow within one step.
    pub fn add(&mut self, now: f64, (at, duration): (f64, f64), velocity: f64) {
        self.added.forget(now);
        self.added.ramp(at, duration, velocity, RampShape::Linear);
    }

    /// What heave compensation adds comes to rest within `duration` [s].
    pub fn ease_adding(&mut self, at: f64, duration: f64) {
        self.added.ramp(at, duration, 0.0, RampShape::Linear);
    }

    /// What heave compensation adds comes to rest at once.
    pub fn stop_adding(&mut self, at: f64, acceleration: f64) {
        if self.added.motion(at).velocity != 0.0 {
            self.added.change(at, 0.0, acceleration, RampShape::Linear);
        }
    }

    /// What heave compensation has added by `at` [s], where that rests, counts as asked for from now on.
    pub fn keep_added(&mut self, at: f64) {
        self.course.shift(self.added.motion(at).position);
        self.added.clear();
    }

    /// Velocity with which it goes on after everything that is known to come.
    pub fn final_velocity(&self) -> f64 {
        self.course.final_velocity()
    }

    /// Acceleration at `time` [s] and its derivative, of the piece of motion that is under way at `from`.
    pub fn acceleration(&self, from: f64, time: f64) -> (f64, f64) {
        let [course, added] = [&self.course, &self.added].map(|one| one.acceleration(from, time));
        let led = self.series.as_ref().map_or((0.0, 0.0), |series| {
            series.acceleration(self.along.motion(time), self.along.acceleration(from, time))
        });
        let [.., by_waves, jerk] = self.waves.as_ref().map_or([0.0; 4], |waves| waves.at_origin(time));
        (course.0 + added.0 + led.0 + by_waves, course.1 + added.1 + led.1 + jerk)
    }

    /// True where it stands still from `time` [s] to the next break.
    pub fn rests(&self, time: f64) -> bool {
        let stands = |course: &Course| {
            course.motion(time).velocity == 0.0 && course.acceleration(time, time) == (0.0, 0.0)
        };
        self.waves.is_none() && [&self.course, &self.added, &self.along].into_iter().all(stands)
    }

    /// The next time after `time` [s] at which a ramp starts or ends, or waves have grown.
    pub fn next_break(&self, time: f64) -> f64 {
        let grown = self.waves.as_ref().map(|waves| waves.rise_time).filter(|&at| at > time);
        let courses = [&self.course, &self.added, &self.along].map(|one| one.next_break(time));
        courses.into_iter().chain(grown).fold(f64::INFINITY, f64::min)
    }

    /// From `at` [s] on, within `duration` [s], the velocity goes to `velocity`. Later ramps are dropped.
    /// Returns the end of the ramp [s].
    pub fn ramp(&mut self, at: f64, duration: f64, velocity: f64, shape: RampShape) -> f64 {
        self.braked = None;
        self.course.ramp(at, duration, velocity, shape)
    }

    /// As [`Timeline::ramp`], as fast as `acceleration` allows.
    pub fn change(&mut self, at: f64, velocity: f64, acceleration: f64, shape: RampShape) -> f64 {
        self.braked = None;
        self.course.change(at, velocity, acceleration, shape)
    }

    /// Moves by `distance` from rest and stops; returns the end [s].
    pub fn travel(&mut self, at: f64, distance: f64, speed: f64, acceleration: f64, shape: RampShape) -> f64 {
        if distance == 0.0 {
            return at;
        }
        self.braked = None;
        self.course.travel(at, distance, speed, acceleration, shape)
    }

    /// How it stops in an emergency, where a program moves it and not the plan.
    pub fn commanded(&self) -> Option<Emergency> {
        self.commanded
    }

    /// From `at` [s] on it does what a program asks for, whatever was said of later times. It comes to rest at the end
    /// of its range.
    ///
    /// The fastest that it may become, from a velocity u with acceleration a, so that braking with b ends within a
    /// room r is v with `(v² − u²)/2a + v²/2b = r`.
    pub fn command(&mut self, at: f64, order: &Order) {
        self.commanded = Some(order.emergency);
        self.leave(at);
        self.forget(at);
        let Order { velocity, acceleration: a, braking: b, range, .. } = *order;
        let Motion { position, velocity: now, .. } = self.planned(at);
        let side = if velocity == 0.0 { now.signum() } else { velocity.signum() };
        let rooms = [position - range[0], range[1] - position];
        let [behind, room] = if side > 0.0 { rooms } else { [rooms[1], rooms[0]] };
        let (u, speed) = (side * now, velocity.abs());
        if u < 0.0 && u * u > 2.0 * a * behind {
            let rest = self.stop_within(at, behind);
            return self.command(rest, order);
        }
        let fastest = (2.0 * (room + 0.5 * u * u / a).max(0.0) / (1.0 / a + 1.0 / b)).sqrt();
        let v = speed.min(fastest);
        let way = 0.5 * (u * u - v * v) / a + 0.5 * v * v / b;
        if u > 0.0 && u >= v && way >= room * (1.0 - 1e-9) {
            self.stop_within(at, room);
            return;
        }
        let change = (v - u).abs();
        let duration = if change == 0.0 { 0.0 } else { (change / a).max(SHORTEST) };
        let end = self.ramp(at, duration, side * v, RampShape::Linear);
        if v == 0.0 || room.is_infinite() {
            return;
        }
        let left = room - 0.5 * (u + v) * duration;
        let cruise = left / v - 0.5 * v / b;
        if cruise > 0.0 {
            self.ramp(end + cruise, v / b, 0.0, RampShape::Linear);
        } else {
            self.stop_within(end, left);
        }
    }

    /// What is over at `at` [s] is not carried along: a drive may be asked for thousands of changes.
    pub fn forget(&mut self, at: f64) {
        self.course.forget(at);
    }

    /// Comes to rest after just the way `room` [m or rad]; returns when [s].
    fn stop_within(&mut self, at: f64, room: f64) -> f64 {
        let speed = self.planned(at).velocity.abs();
        self.ramp(at, (2.0 * room / speed).max(SHORTEST), 0.0, RampShape::Linear)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const EMERGENCY: Emergency = Emergency { acceleration: 0.3, brake: Some(7.0) };

    #[test]
    fn position_velocity_acceleration_are_consistent() {
        for shape in [RampShape::Linear, RampShape::Smooth] {
            let mut timeline = Timeline::new(3.0, 4);
            timeline.change(1.0, 0.5, 0.2, shape);
            timeline.change(6.0, -0.25, 0.2, shape);
            let d = 1e-5;
            for time in [0.5, 1.7, 4.9, 7.3, 8.8, 20.0] {
                let (before, here, after) =
                    (timeline.motion(time - d), timeline.motion(time), timeline.motion(time + d));
                let velocity = (after.position - before.position) / (2.0 * d);
                let acceleration = (after.velocity - before.velocity) / (2.0 * d);
                // Central differences: d² times the third derivative, here below 1e-9, plus rounding.
                assert!((velocity - here.velocity).abs() < 1e-9, "{shape:?} {time}");
                assert!((acceleration - here.acceleration).abs() < 1e-9, "{shape:?} {time}");
            }
        }
    }

    #[test]
    fn at_the_end_of_a_ramp_it_is_over() {
        // 72.56 + 0.05 − 72.56 < 0.05 in floating point: the next step would start with the ramp's acceleration.
        for at in [72.56, 82.565, 0.1 + 0.2, 1e5 / 3.0] {
            let mut timeline = Timeline::new(0.0, 2);
            let end = timeline.ramp(at, 0.05, 0.005, RampShape::Linear);
            assert_eq!(timeline.next_break(at), end);
            assert_eq!(timeline.acceleration(end, end + 0.1), (0.0, 0.0));
            assert!(timeline.acceleration(at, end).0 > 0.0);
        }
    }

    #[test]
    fn a_ramp_is_under_way_where_a_step_begins_a_rounding_before_it() {
        // Too short for full speed: braking begins one or two last bits after the end of the first ramp.
        for (distance, acceleration) in [(0.06, 0.01), (0.1, 0.01), (0.5, 0.01), (0.046, 0.2)] {
            let mut timeline = Timeline::new(0.0, 2);
            timeline.travel(0.0, distance, 5.0, acceleration, RampShape::Linear);
            let (first, second) = (timeline.course.ramps[0].end(), timeline.course.ramps[1].at);
            assert!(first < second && second < soon(first));
            assert!((timeline.acceleration(first, second).0 + acceleration).abs() < 1e-12);
            assert!(timeline.acceleration(first.next_down(), second).0 < 0.0);
        }
        let mut timeline = Timeline::new(0.0, 2);
        timeline.brake(6.0, 5.0);
        assert_eq!(
            [5.9, 6.0_f64.next_down(), 6.0].map(|time| timeline.braked(time)),
            [None, Some(5.0), Some(5.0)]
        );
    }

    #[test]
    fn travel_stops_at_its_distance() {
        for (distance, speed) in [(2.0, 0.1), (-2.0, 0.1), (0.01, 5.0)] {
            for shape in [RampShape::Linear, RampShape::Smooth] {
                let mut timeline = Timeline::new(0.0, 4);
                let end = timeline.travel(2.0, distance, speed, 0.05, shape);
                let motion = timeline.motion(end + 1.0);
                assert!((motion.position - distance).abs() < 1e-12);
                assert_eq!(motion.velocity, 0.0);
            }
        }
    }

    #[test]
    fn peak_acceleration_is_the_limit() {
        for shape in [RampShape::Linear, RampShape::Smooth] {
            let mut timeline = Timeline::new(0.0, 2);
            let end = timeline.change(0.0, 0.4, 0.1, shape);
            assert!((timeline.motion(end / 2.0).acceleration - 0.1).abs() < 1e-12);
        }
    }

    /// Ends of ramps and the plan's own words for the rest: half the change of v² over twice the acceleration.
    #[test]
    fn what_is_asked_for_replaces_what_was_said() {
        let free = [f64::NEG_INFINITY, f64::INFINITY];
        let order =
            |velocity| Order { velocity, acceleration: 0.1, braking: 0.2, range: free, emergency: EMERGENCY };
        let mut timeline = Timeline::new(1.0, 8);
        timeline.travel(0.0, 10.0, 0.5, 0.1, RampShape::Linear);
        timeline.brake(40.0, 5.0);
        timeline.command(3.0, &order(-0.2));
        // 0.3 m/s at 3 s, 1 + 0.45 m; five seconds later −0.2 m/s, (0.04 − 0.09)/0.2 = −0.25, so 0.25 m further.
        let motion = timeline.motion(8.0);
        assert!((motion.position - 1.7).abs() < 1e-12 && (motion.velocity + 0.2).abs() < 1e-12);
        assert_eq!(timeline.next_break(8.0), f64::INFINITY);
        assert_eq!((timeline.braked(50.0), timeline.commanded()), (None, Some(EMERGENCY)));
        for k in 0..1000 {
            timeline.command(10.0 + 0.01 * f64::from(k), &order(0.01 * f64::from(k % 7)));
        }
        assert!(timeline.course.ramps.len() <= 2, "what is over is not kept");
        timeline.command(30.0, &order(timeline.motion(30.0).velocity + 1e-13));
        assert!(timeline.next_break(30.0) >= 30.0 + 0.99 * SHORTEST);
    }

    #[test]
    fn what_is_asked_for_ends_at_rest_at_the_end_of_the_range() {
        let range = [-2.0, 5.0];
        let order = |velocity, acceleration| Order {
            velocity,
            acceleration,
            braking: 0.2,
            range,
            emergency: EMERGENCY,
        };
        // How it moves beforehand, for how long [s], and what is then asked for, with an acceleration.
        for (before, lasts, velocity, acceleration) in [
            (0.0, 1.0, 0.5, 0.1),
            (0.0, 1.0, 9.0, 0.2),
            (0.0, 1.0, -0.3, 0.01),
            (0.5, 9.0, 0.5, 0.2),
            (0.5, 9.0, 0.45, 0.01),
            (0.5, 9.0, 0.0, 0.01),
            (0.5, 9.0, -0.5, 0.01),
            (-0.5, 4.0, 0.5, 0.02),
        ] {
            let mut timeline = Timeline::new(0.0, 8);
            timeline.command(0.0, &order(before, 0.2));
            timeline.command(lasts, &order(velocity, acceleration));
            let (mut low, mut high) = (0.0_f64, 0.0_f64);
            for k in 0..200_000 {
                let motion = timeline.motion(lasts + 0.01 * f64::from(k));
                (low, high) = (low.min(motion.position), high.max(motion.position));
                assert!(motion.acceleration.abs() <= 0.2 * (1.0 + 1e-9), "{before} {velocity} {motion:?}");
            }
            assert!(low > range[0] - 1e-9 && high < range[1] + 1e-9, "{before} {velocity}: {low} {high}");
            let last = timeline.motion(lasts + 3000.0);
            assert_eq!(last.velocity, 0.0);
            let wanted = if velocity > 0.0 { 5.0 } else { -2.0 };
            assert!(velocity == 0.0 || (last.position - wanted).abs() < 1e-9, "{velocity}: {last:?}");
        }
    }

    #[test]
    fn at_the_end_of_the_range_it_stays_whatever_is_asked_for() {
        let order =
            Order { velocity: 0.5, acceleration: 0.1, braking: 0.1, range: [0.0, 1.0], emergency: EMERGENCY };
        let mut timeline = Timeline::new(0.0, 8);
        for k in 0..400 {
            timeline.command(0.05 * f64::from(k), &order);
            assert!(timeline.motion(0.05 * f64::from(k + 1)).position <= 1.0 + 1e-9);
        }
        let last = timeline.motion(20.0);
        assert!((last.position - 1.0).abs() < 1e-9 && last.velocity == 0.0, "{last:?}");
    }
}
