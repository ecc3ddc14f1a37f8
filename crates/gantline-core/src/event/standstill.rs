//! Runs that do not get on.
//!
//! The length of a rope knows nothing of sheaves that meet: beyond, the part between them would only point the other way,
//! and where it is nothing it has no direction. A method under error control may stand still there, step after step of
//! microseconds, or find no step that is short enough; then the run ends, with the name of what is there. So does one that
//! stands still for any other reason.

use crate::stepper::StepError;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// After so many steps it is asked how far they have led.
pub const STEPS: u64 = 1000;
/// No farther than this [s] they lead nowhere where a part of a rope has come to nothing.
const SLOW: f64 = 0.1;
/// A part of this length is none any more [m].
const NOTHING: f64 = 1e-3;
/// No farther than this [s], beside the time, they lead nowhere at all.
const NOWHERE: f64 = 1e-9;

/// Whether the last [`STEPS`] steps, made between two times [s], lead on.
///
/// # Errors
/// [`StepError`] where they do not.
pub fn look(system: &System, kinematics: &Kinematics, [since, time]: [f64; 2]) -> Result<(), StepError> {
    if time - since > SLOW {
        return Ok(());
    }
    if let Some((element, cause)) = has_met(system, kinematics) {
        return Err(StepError { time, element, cause });
    }
    if time - since > NOWHERE * (1.0 + time.abs()) {
        return Ok(());
    }
    let cause = format!("{STEPS} steps on end have led nowhere: something changes to and fro at this moment");
    Err(StepError { time, element: String::new(), cause })
}

/// A body that has met the next place of its rope, where a straight part of that, one end of which moves against the other,
/// has come to nothing; and the cause in words.
pub fn has_met(system: &System, kinematics: &Kinematics) -> Option<(String, String)> {
    for rope in system.ropes().filter(|rope| rope.route.parts.len() > 1) {
        for part in &rope.route.parts {
            let ends = [part.from.at.body, part.to.at.body];
            let [from, to] = ends.map(|body| system.tree.support_of(body));
            let moves = |these: &[usize], others: &[usize]| these.iter().any(|dof| !others.contains(dof));
            let moving = if moves(to, from) { ends[1] } else { ends[0].filter(|_| moves(from, to)) };
            let [start, end] = part.ends(kinematics);
            if let (Some(body), true) = (moving, start.distance(end) < NOTHING) {
                let cause = format!(
                    "it has come to the next place that {} passes, and nothing stops it there: hoist a hook less \
                     far, or give an equalizer 'stops: true'",
                    rope.name
                );
                return Some((system.tree.bodies[body].name.clone(), cause));
            }
        }
    }
    None
}
