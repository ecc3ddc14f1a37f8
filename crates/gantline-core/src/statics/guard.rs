//! No straight part of a rope over sheaves runs through its end in one step.
//!
//! A moving sheave that is hauled up to the fixed ones cannot pass them, but the length of the rope knows nothing of
//! that: beyond, the part would only point the other way. What shortens such a part too much in a step is braked by
//! itself, by a number on its diagonal, so that the rest of the rig moves on. Here it is found how far it may go.

use super::potential::Potential;
use crate::constraint::AnyConstraint;
use crate::rope::guide::Attachment;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// Share of its length that a part keeps in a step.
const KEPT: f64 = 0.3;
/// The same where what shortens it is braked, and what is left at least of the way of that.
const BRAKED: f64 = 0.5;
const LEFT: f64 = 0.1;
/// A part of this length is none any more [m].
const NOTHING: f64 = 1e-3;

/// A straight part of a rope.
#[derive(Debug, Clone)]
struct Straight {
    rope: usize,
    /// Its number along the route.
    number: usize,
    /// Degrees of freedom that move one end and not the other, with 1 for its end and −1 for its start.
    dofs: Vec<(usize, f64)>,
}

/// Parts that are looked at.
#[derive(Debug, Clone)]
pub struct Guard {
    parts: Vec<Straight>,
}

impl Guard {
    /// Parts of all ropes that have more than one.
    pub fn new(system: &System) -> Self {
        let mut parts = Vec::new();
        for (index, rope) in system.ropes().enumerate().filter(|(_, rope)| rope.route.parts.len() > 1) {
            for (number, part) in rope.route.parts.iter().enumerate() {
                let support = |end: &Attachment| system.tree.support_of(end.body);
                let (from, to) = (support(&part.from.at), support(&part.to.at));
                let only = |these: &[usize], others: &[usize], sign: f64| -> Vec<(usize, f64)> {
                    let alone = these.iter().filter(|dof| !others.contains(dof));
                    alone.map(|&dof| (dof, sign)).collect()
                };
                let mut dofs = only(from, to, -1.0);
                dofs.extend(only(to, from, 1.0));
                parts.push(Straight { rope: index, number, dofs });
            }
        }
        Self { parts }
    }

    /// Writes into `brakes` the degrees of freedom that shorten parts too much on a step, each with the share of its way
    /// that leaves enough.
    pub fn look(
        &self,
        system: &System,
        (here, there): (&Potential, &Kinematics),
        step: &[f64],
        brakes: &mut Vec<(usize, f64)>,
    ) {
        brakes.clear();
        let kinematics = &here.frame.kinematics;
        for Straight { rope, number, dofs } in &self.parts {
            let AnyConstraint::Rope(rope) = &system.constraints[*rope] else { continue };
            let part = &rope.route.parts[*number];
            let ([from, to], then) = (part.ends(kinematics), part.ends(there));
            let now = to - from;
            let kept = now.dot(then[1] - then[0]);
            // Times its length; where that is nothing, nothing can be kept.
            if kept >= KEPT * now.length_squared() {
                continue;
            }
            let most = dofs.iter().map(|&(dof, sign)| {
                let point = if sign > 0.0 { to } else { from };
                let column = kinematics.point_column(&system.tree, dof, point);
                (dof, sign * now.dot(column) * step[dof])
            });
            // NaN, where there is nothing to locate, is left to the energy.
            let Some((dof, shortens)) = most.min_by(|a, b| a.1.total_cmp(&b.1)) else { continue };
            if shortens < 0.0 {
                let share = (1.0 - (BRAKED * now.length_squared() - kept) / -shortens).max(LEFT);
                match brakes.iter_mut().find(|(other, _)| *other == dof) {
                    Some((_, least)) => *least = least.min(share),
                    None => brakes.push((dof, share)),
                }
            }
        }
    }

    /// A rope of which a part has come to nothing [m].
    pub fn used_up(&self, system: &System, here: &Potential) -> Option<usize> {
        let is_nothing = |part: &&Straight| {
            let AnyConstraint::Rope(rope) = &system.constraints[part.rope] else { return false };
            rope.route.parts[part.number].locate(&here.frame.kinematics).length < NOTHING
        };
        self.parts.iter().find(is_nothing).map(|part| part.rope)
    }
}
