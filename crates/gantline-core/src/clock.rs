//! Where the time of a run goes, by stage. Off by default: the clock is then never read.

use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed};
use std::time::Instant;

/// What is being done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    /// All that is no other stage: increments, error estimates, the plan, the books.
    Other,
    /// Poses and velocities of bodies.
    Kinematics,
    /// Forces, rows, and their tangents.
    Assembly,
    /// Factors of the matrix of a step.
    Factorisation,
    /// Solutions with them.
    Solution,
    /// Looks for changes of modes, and changes.
    Events,
    /// Samples and what follows from them.
    Recording,
}

/// Names of the stages, in their order.
pub const STAGES: [&str; 7] =
    ["other", "kinematics", "assembly", "factorisation", "solution", "events", "recording"];

/// A clock that goes on in one stage at a time. Times do not overlap: a stage within another stops that one's.
#[derive(Debug, Default)]
pub struct Clock {
    start: Option<Instant>,
    /// Stage under way.
    stage: AtomicUsize,
    /// When it was entered, from the start [ns].
    entered: AtomicU64,
    /// Time by stage [ns].
    passed: [AtomicU64; STAGES.len()],
}

impl Clone for Clock {
    /// A clock of its own that has counted nothing.
    fn clone(&self) -> Self {
        let mut clock = Self::default();
        if self.start.is_some() {
            clock.switch_on();
        }
        clock
    }
}

impl Clock {
    /// Counts from now on.
    pub fn switch_on(&mut self) {
        self.start = Some(Instant::now());
    }

    /// Does `work`, which belongs to `stage`.
    #[inline]
    pub fn time<T>(&self, stage: Stage, work: impl FnOnce() -> T) -> T {
        let Some(start) = self.start else { return work() };
        let outer = self.enter(start, stage as usize);
        let done = work();
        self.enter(start, outer);
        done
    }

    fn enter(&self, start: Instant, stage: usize) -> usize {
        let now = start.elapsed().as_nanos() as u64;
        let outer = self.stage.swap(stage, Relaxed);
        let passed = now - self.entered.swap(now, Relaxed);
        self.passed[outer].fetch_add(passed, Relaxed);
        outer
    }

    /// The run goes on: what happened since it paused is not counted.
    pub fn resume(&self) {
        if let Some(start) = self.start {
            self.entered.store(start.elapsed().as_nanos() as u64, Relaxed);
        }
    }

    /// The run pauses.
    pub fn pause(&self) {
        if let Some(start) = self.start {
            self.enter(start, Stage::Other as usize);
        }
    }

    /// Time of every stage so far [s], none where the clock is off.
    pub fn seconds(&self) -> Option<[f64; STAGES.len()]> {
        self.start?;
        Some(std::array::from_fn(|stage| self.passed[stage].load(Relaxed) as f64 * 1e-9))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::thread::sleep;
    use std::time::Duration;

    #[test]
    fn stages_do_not_overlap_and_leave_nothing_out() {
        let mut clock = Clock::default();
        clock.switch_on();
        let whole = Instant::now();
        clock.resume();
        clock.time(Stage::Events, || {
            sleep(Duration::from_millis(4));
            clock.time(Stage::Kinematics, || sleep(Duration::from_millis(8)));
        });
        clock.pause();
        let whole = whole.elapsed().as_secs_f64();
        let passed = clock.seconds().unwrap();
        let [events, kinematics] = [Stage::Events, Stage::Kinematics].map(|stage| passed[stage as usize]);
        assert!(events >= 0.004 && kinematics >= 0.008);
        assert!(passed.iter().sum::<f64>() <= whole);
    }

    #[test]
    fn a_clock_that_is_off_counts_nothing() {
        let clock = Clock::default();
        assert_eq!(clock.time(Stage::Solution, || 7), 7);
        assert_eq!(clock.seconds(), None);
    }
}
