//! Where a body is and where it heads without its motion in single waves: a point of it, and its heading, behind a filter
//! that lets slow motion through and leaves out what is fast.
//!
//! ```text
//! ẏ₁ = ω (u − y₁)    ẏ₂ = ω (y₁ − y₂)    …    ẏ₅ = ω (y₄ − y₅)        s = 5 y₄ − 4 y₅
//! ```
//!
//! Of u = Re(û e^{iνt}) that leaves H û, with p = iν/ω:
//!
//! ```text
//! H = (1 + 5p)/(1 + p)⁵        H = 1 − 10p² + … for slow        H = 5p⁻⁴ + … for fast
//! ```
//!
//! A body that goes on as it does, straight or turning, is followed without a lag, as 1 − H has no term in p.
//!
//! Known is y at the end of the last step, and how fast u was there. Within a step u goes on like that, so s depends on
//! time alone; as y₄ is four integrals behind u, what that leaves out is of the sixth order in the length of the step. At
//! its end y is taken on by the u that there was, a cubic by places and rates at both ends.

use std::f64::consts::TAU;
use std::ops::Range;

use glam::{DVec2, DVec3};

use crate::tree::kinematics::Twist;
use crate::tree::pose::Pose;

/// Numbers of a state: the time, and for x, y and heading u, its rate, and y₁ to y₅.
const WIDTH: usize = 1 + 3 * EACH;
const EACH: usize = 2 + STAGES;
const STAGES: usize = 5;
/// A place and its rates: as many as leave the last two stages behind another one.
const RATES: usize = STAGES - 1;
/// Degree of the polynomial in time as which y goes on within a part, and the length of a part in 1/ω: wrong by 0.25⁷/7! in
/// it, 1e-8, and its rate by 0.25⁶/6!, 3e-7; by less in a shorter one.
const DEGREE: usize = 6;
const PART: f64 = 0.25;
/// A step that is no longer moves nothing [s]: the cubic between its ends would be rounding over rounding, or, where the cube
/// of its length is no number any more, none.
const MOMENT: f64 = 1e-12;

/// The filter behind a body.
#[derive(Debug, Clone, PartialEq)]
pub struct Slow {
    /// Its point [m], body frame.
    pub point: DVec3,
    /// ω [rad/s].
    pub cut_off: f64,
    /// First number of its state among those of all forces.
    pub first: usize,
}

/// Slow place and heading, each with its first, second and third rate.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Slowly {
    /// World x and y [m].
    pub place: [DVec2; RATES],
    /// From world x towards y [rad].
    pub heading: [f64; RATES],
}

impl Slow {
    /// Where its state is among those of all forces.
    pub fn states(&self) -> Range<usize> {
        self.first..self.first + WIDTH
    }

    /// Starts where the body is at `time` [s], as if it had always moved as it does: yⱼ = u − j u̇/ω.
    pub fn start(&self, (pose, twist): (&Pose, &Twist), time: f64, past: &mut [f64]) {
        let past = &mut past[self.states()];
        past[0] = time;
        for (state, [now, rate]) in past[1..].chunks_exact_mut(EACH).zip(self.seen(pose, twist)) {
            (state[0], state[1]) = (now, rate);
            for (stage, y) in state[2..].iter_mut().enumerate() {
                *y = now - (stage + 1) as f64 * rate / self.cut_off;
            }
        }
    }

    /// Takes the state on to `time` [s], where the body is at `pose` and moves with `twist`.
    pub fn follow(&self, (pose, twist): (&Pose, &Twist), time: f64, past: &mut [f64]) {
        let past = &mut past[self.states()];
        let h = time - past[0];
        past[0] = time;
        let mut seen = self.seen(pose, twist);
        // The heading goes on from what it was, whole turns included.
        let before = past[1 + 2 * EACH];
        seen[2][0] -= TAU * ((seen[2][0] - before) / TAU).round();
        for (state, [now, rate]) in past[1..].chunks_exact_mut(EACH).zip(seen) {
            let (u, y) = state.split_at_mut(2);
            if h > 0.0 {
                let way = now - u[0];
                let [square, cube] = if h > MOMENT {
                    let square = (3.0 * way - h * (2.0 * u[1] + rate)) / (h * h);
                    [square, (h * (u[1] + rate) - 2.0 * way) / (h * h * h)]
                } else {
                    [0.0; 2]
                };
                self.go_on([u[0], u[1], square, cube], h, y);
            }
            (u[0], u[1]) = (now, rate);
        }
    }

    /// Slow place and heading at `time` [s], in the step that the state is the start of; none where nothing has moved yet and
    /// nothing is remembered, as in statics.
    pub fn at(&self, past: &[f64], time: f64) -> Option<Slowly> {
        let past = past.get(self.states())?;
        let mut found = [[0.0; RATES]; 3];
        for (state, found) in past[1..].chunks_exact(EACH).zip(&mut found) {
            let mut y: [f64; STAGES] = std::array::from_fn(|k| state[2 + k]);
            self.go_on([state[0], state[1], 0.0, 0.0], time - past[0], &mut y);
            for rate in found {
                *rate = 5.0 * y[STAGES - 2] - 4.0 * y[STAGES - 1];
                // Each takes one stage away: of rates of the first stages nothing is asked.
                for k in (1..STAGES).rev() {
                    y[k] = self.cut_off * (y[k - 1] - y[k]);
                }
            }
        }
        let [x, y, heading] = found;
        Some(Slowly { place: std::array::from_fn(|k| DVec2::new(x[k], y[k])), heading })
    }

    /// y after `length` [s] of u = Σ cₖ tᵏ.
    fn go_on(&self, c: [f64; 4], length: f64, y: &mut [f64]) {
        let parts = (self.cut_off * length / PART).ceil().max(1.0);
        let h = length / parts;
        for part in 0..parts as u32 {
            let t = h * f64::from(part);
            // Terms of the Taylor series of u, then of each y behind it: (k + 1) yₖ₊₁/h = ω (uₖ − yₖ).
            let mut before = [0.0; DEGREE + 1];
            before[0] = c[0] + t * (c[1] + t * (c[2] + t * c[3]));
            before[1] = h * (c[1] + t * (2.0 * c[2] + t * 3.0 * c[3]));
            before[2] = h * h * (c[2] + t * 3.0 * c[3]);
            before[3] = h * h * h * c[3];
            for y in y.iter_mut() {
                let mut own = [*y; DEGREE + 1];
                for k in 0..DEGREE {
                    own[k + 1] = self.cut_off * h * (before[k] - own[k]) / (k + 1) as f64;
                }
                *y = own.iter().sum();
                before = own;
            }
        }
    }

    /// Place and heading, each with its rate, of the body itself.
    fn seen(&self, pose: &Pose, twist: &Twist) -> [[f64; 2]; 3] {
        let arm = pose.rotation * self.point;
        let (place, velocity) = (pose.position + arm, twist.at(arm));
        let (heading, turns) = heading_of(pose);
        [[place.x, velocity.x], [place.y, velocity.y], [heading, turns.dot(twist.angular)]]
    }
}

/// Where a body heads, from world x towards y [rad], and what that changes by with each turn of it.
pub fn heading_of(pose: &Pose) -> (f64, DVec3) {
    let ahead = pose.rotation.x_axis;
    let level = (ahead.x * ahead.x + ahead.y * ahead.y).max(f64::MIN_POSITIVE);
    let lean = -ahead.z / level;
    (ahead.y.atan2(ahead.x), DVec3::new(lean * ahead.x, lean * ahead.y, 1.0))
}
