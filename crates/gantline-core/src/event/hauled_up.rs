//! Sheaves that are hauled up to the next place that their rope passes.
//!
//! The length of a rope knows nothing of sheaves that meet: beyond, the part between them would only point the other way,
//! and where it is nothing it has no direction. A method under error control may stand still there, step after step of
//! nanoseconds; then the run ends.

use crate::stepper::StepError;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// So many steps on end, each as short as this [s], lead nowhere.
pub const STANDING: (u32, f64) = (1000, 1e-6);
/// A part of this length is none any more [m].
const NOTHING: f64 = 1e-3;

/// What has met the next place of its rope at a moment [s] at which a run stands still.
///
/// # Errors
/// [`StepError`] where a straight part of a rope over sheaves, one end of which moves against the other, has come to
/// nothing.
pub fn look(system: &System, kinematics: &Kinematics, time: f64) -> Result<(), StepError> {
    for rope in system.ropes().filter(|rope| rope.route.parts.len() > 1) {
        for part in &rope.route.parts {
            let ends = [part.from.at.body, part.to.at.body];
            let [from, to] = ends.map(|body| system.tree.support_of(body));
            let moves = |these: &[usize], others: &[usize]| these.iter().any(|dof| !others.contains(dof));
            let moving = if moves(to, from) { ends[1] } else { ends[0].filter(|_| moves(from, to)) };
            let [start, end] = part.ends(kinematics);
            if let (Some(body), true) = (moving, start.distance(end) < NOTHING) {
                let cause = format!(
                    "it has been hauled up to the next place that {} passes, and nothing stops it there; 'stops: true' \
                     of an equalizer does",
                    rope.name
                );
                return Err(StepError { time, element: system.tree.bodies[body].name.clone(), cause });
            }
        }
    }
    Ok(())
}
