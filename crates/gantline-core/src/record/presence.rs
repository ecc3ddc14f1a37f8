//! When ropes and mooring lines are there: not before they are put on, nor once they have parted or been taken off.

use crate::event::{EventKind, EventLog};
use crate::system::System;

/// When each of them is there, mooring lines after the ropes.
pub struct Presence {
    ropes: Vec<Course>,
}

/// What happens to one of them.
#[derive(Clone)]
struct Course {
    starts_on: bool,
    /// Times at which it came (true) or went [s], ascending.
    changes: Vec<(f64, bool)>,
}

impl Presence {
    /// What the events of a run say.
    pub fn of(system: &System, log: &EventLog) -> Self {
        let mut ropes = vec![Course { starts_on: true, changes: Vec::new() }; system.all_ropes()];
        for sling in &system.slings {
            ropes[sling.constraint].starts_on = sling.starts_on;
        }
        for event in &log.events {
            let comes = event.kind == EventKind::Attached;
            if comes || event.kind.parts_a_rope() {
                ropes[event.subject].changes.push((event.time, comes));
            }
        }
        Self { ropes }
    }

    /// Whether a rope is there at a time [s]; at the moment at which it comes or goes it is.
    pub fn is_there(&self, rope: usize, time: f64) -> bool {
        let Course { starts_on, changes } = &self.ropes[rope];
        let done = changes.iter().rev().find(|&&(at, comes)| at < time || (comes && at == time));
        done.map_or(*starts_on, |&(_, comes)| comes)
    }
}
