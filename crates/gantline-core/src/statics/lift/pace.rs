//! How far a lift that is followed from rest to rest goes at once, and the hunt for the time at which a condition is met.
//!
//! A part at whose end a step has what it waits for goes too far: the condition was met within it. Where, is told by what it
//! lacked at the last two times that tell something, on a straight line (a secant). What is met is known to
//! [`MET`] once a part no longer than that ends with it; so each try but the last aims at just before.
//! Where lines lead nowhere, as of a support that is touched, of which nothing tells how far it is, the hunt goes by halves.

/// Longest part of a plan that is followed at once, and that beyond which one without equilibrium is tried in halves [s].
pub const LONGEST: f64 = 5.0;
pub const SHORTEST: f64 = 1e-3;
/// When a condition is met is known to this [s].
pub const MET: f64 = 1e-4;
/// How much before the time that a line tells a try ends, and the last one after it [s].
const ASIDE: f64 = 0.25 * MET;
/// The last try [s]: times that are sums leave it no longer than it may be, whatever is rounded.
const LAST: f64 = 0.99 * MET;
/// Tries by lines, at most, until what is left of the hunt is half as long.
const TRIES: u32 = 4;

/// How far it goes at once.
#[derive(Debug, Clone, Copy)]
pub struct Pace {
    /// Longest next part, if nothing is hunted [s].
    pub stride: f64,
    /// Events that were known when it was last asked what a condition lacks: another step waits for another one.
    events: usize,
    /// Time by which the condition holds [s], if that is known.
    late: Option<f64>,
    /// The last two times [s] that told what it lacks, the later look behind.
    told: [(f64, f64); 2],
    /// How long the hunt was when it was last half as long as before [s], and tries since.
    left: f64,
    tries: u32,
}

/// Nothing told.
const UNTOLD: (f64, f64) = (f64::NAN, f64::NAN);

impl Pace {
    /// At the start of a lift.
    pub fn new() -> Self {
        Self {
            stride: LONGEST,
            events: usize::MAX,
            late: None,
            told: [UNTOLD; 2],
            left: f64::INFINITY,
            tries: 0,
        }
    }

    /// The steps under way at `now` [s] are those of as many `events`: where these are others than before nothing is known of
    /// what they wait for but what it `lacks` now.
    pub fn waits(&mut self, events: usize, now: f64, lacks: impl FnOnce() -> f64) {
        if self.events != events {
            *self = Self { stride: self.stride, events, ..Self::new() };
            self.look(now, lacks());
        }
    }

    /// At `time` [s] the condition `lacks` so much.
    pub fn look(&mut self, time: f64, lacks: f64) {
        if lacks.is_finite() && lacks != 0.0 {
            self.told = [self.told[1], (time, lacks)];
        }
    }

    /// By `time` [s] the condition holds.
    pub fn is_late_by(&mut self, time: f64) {
        self.late = Some(time);
    }

    /// What was waited for has come: the hunt is over.
    pub fn is_met(&mut self) {
        *self = Self { stride: self.stride, ..Self::new() };
    }

    /// How far to go from `now` [s].
    pub fn next(&mut self, now: f64) -> f64 {
        let Some(left) = self.late.map(|late| late - now).filter(|&left| left > 0.0) else {
            return self.stride;
        };
        if left <= MET {
            return left;
        }
        if left > 0.5 * self.left {
            self.tries += 1;
        } else {
            // Where lines led nowhere there is one at a time from then on.
            (self.left, self.tries) = (left, if self.tries < TRIES { 0 } else { TRIES - 1 });
        }
        let [(first, before), (last, after)] = self.told;
        let met = last - after * (last - first) / (after - before) - now;
        let is_near = -MET < met && met < left + MET && self.tries < TRIES;
        let next = match met {
            _ if !is_near => 0.5 * left,
            met if met < LAST - ASIDE => LAST,
            met => (met - ASIDE).min(left - LAST),
        };
        next.min(self.stride)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// When it is met of a lift that goes from 0 s in parts of 1.6 s [s], and after how many of them.
    fn hunted(lacks: impl Fn(f64) -> f64) -> (f64, usize) {
        let (mut pace, mut now) = (Pace::new(), 0.0);
        pace.stride = 1.6;
        pace.waits(0, now, || lacks(now));
        for looks in 1..100 {
            let next = now + pace.next(now);
            let lack = lacks(next);
            if lack <= 0.0 && next - now <= MET {
                return (next, looks);
            }
            pace.look(next, lack);
            if lack <= 0.0 { pace.is_late_by(next) } else { now = next }
        }
        panic!("it is hunted without end")
    }

    /// Whatever a condition lacks on the way, it is known to 0.1 ms when it is met; by halves that takes 14, from
    /// 1.6 s; where lines mislead twice as many, and the first tries.
    #[test]
    fn a_condition_is_hunted_along_lines() {
        const MOMENT: f64 = 0.7317;
        let line = |time: f64| 3e5 * (MOMENT - time);
        let within = |most: usize, lacks: &dyn Fn(f64) -> f64| {
            let (met, looks) = hunted(lacks);
            assert!((MOMENT..=MOMENT + MET).contains(&met), "met at {met}");
            assert!(looks <= most, "{looks} looks");
        };
        // One too far, one just before, and the last.
        within(3, &line);
        within(8, &|time| line(time) + 4e5 * (MOMENT - time) * (MOMENT + time));
        // A support that bears less and less, then nothing: told from one side only.
        within(8, &|time| line(time).max(0.0));
        // One that is touched: how far it is, nothing tells; how hard it is pressed, something does.
        within(12, &|time| if line(time) > 0.0 { f64::INFINITY } else { line(time).min(-1.0) });
        within(16, &|time| if line(time) > 0.0 { f64::INFINITY } else { -f64::INFINITY });
        within(32, &|time| if line(time) > 0.0 { 1.0 } else { -1.0 });
        within(32, &|time| line(time).powi(9));
    }

    /// What other steps wait for begins anew; what has been met is not hunted any more.
    #[test]
    fn a_hunt_ends_where_its_steps_do() {
        let mut pace = Pace::new();
        pace.stride = 1.6;
        pace.waits(1, 0.0, || 1.0);
        pace.look(1.6, -1.0);
        pace.is_late_by(1.6);
        assert!(pace.next(0.0) < 0.81);
        let mut other = pace;
        other.waits(2, 0.5, || 1.0);
        assert_eq!(other.next(0.5), 1.6);
        pace.is_met();
        assert_eq!(pace.next(0.8), 1.6);
    }
}
