//! Sheaves that are hauled up to the next place that their rope passes.
//!
//! The length of a rope knows nothing of sheaves that meet: beyond, the part between them would only point the other way,
//! and where it is nothing it has no direction. So a run ends where that happens, whatever the method.

use glam::DVec3;

use crate::constraint::AnyConstraint;
use crate::stepper::StepError;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// A part of this length is none any more [m].
const NOTHING: f64 = 1e-3;
/// Length of a part that has run through its end since the last look, and has not just turned round, at most [m].
const BEYOND: f64 = 0.3;

/// A straight part of a rope over sheaves, one end of which moves against the other.
#[derive(Debug, Clone)]
struct Straight {
    /// Constraint, and number of the part along its route.
    rope: usize,
    number: usize,
    /// The body that moves against the other.
    body: usize,
    /// From its start to its end at the last look [m]; none before the first.
    way: Option<DVec3>,
}

/// Looks at these parts. Reused.
#[derive(Debug, Clone)]
pub struct Straights {
    parts: Vec<Straight>,
}

impl Straights {
    /// Of all ropes that have more than one part.
    pub fn new(system: &System) -> Self {
        let mut parts = Vec::new();
        for (index, rope) in system.ropes().enumerate().filter(|(_, rope)| rope.route.parts.len() > 1) {
            for (number, part) in rope.route.parts.iter().enumerate() {
                let ends = [part.from.at.body, part.to.at.body];
                let [from, to] = ends.map(|body| system.tree.support_of(body));
                let moves = |these: &[usize], others: &[usize]| these.iter().any(|dof| !others.contains(dof));
                let body = if moves(to, from) { ends[1] } else { ends[0].filter(|_| moves(from, to)) };
                parts.extend(body.map(|body| Straight { rope: index, number, body, way: None }));
            }
        }
        Self { parts }
    }

    /// Looks at a moment [s].
    ///
    /// # Errors
    /// [`StepError`] where a part has come to nothing since the last look.
    pub fn look(&mut self, system: &System, kinematics: &Kinematics, time: f64) -> Result<(), StepError> {
        let way = |part: &Straight| {
            let AnyConstraint::Rope(rope) = &system.constraints[part.rope] else { return DVec3::ZERO };
            let [from, to] = rope.route.parts[part.number].ends(kinematics);
            to - from
        };
        for part in &mut self.parts {
            let now = way(part);
            let Some(before) = part.way.replace(now) else { continue };
            let is_beyond = before.dot(now) < 0.0 && now.length() < BEYOND;
            if before.length() > NOTHING && (now.length() < NOTHING || is_beyond) {
                let element = system.tree.bodies[part.body].name.clone();
                let rope = system.constraints[part.rope].name();
                let cause = format!(
                    "it has been hauled up to the next place that {rope} passes, and nothing stops it there; \
                     'stops: true' of an equalizer does"
                );
                return Err(StepError { time, element, cause });
            }
        }
        self.parts.retain(|part| part.way.is_none_or(|way| way.length() > NOTHING));
        Ok(())
    }
}
