//! Decks that go under water and bottoms that come out, on the course of a step.
//!
//! Where the edge of a deck goes under, or that of a bottom comes out, the section of the hull at the surface begins to shrink
//! at once, and the stiffness of the water jumps. No polynomial across that follows the forces well enough for the balance of
//! energy; so the step ends there.

use super::Adaptive;
use super::seating::halve;
use crate::state::State;
use crate::system::System;
use crate::tree::kinematics::Kinematics;

/// Parts of a step at whose ends is looked.
const PARTS: usize = 4;

impl Adaptive {
    /// The share at which a mark of a vessel or its bottom first goes under water or comes out, or `made`. What comes and goes by
    /// less than positions may be wrong counts for nothing: a deck that is just awash would end every step.
    pub(super) fn wets_up_to(&mut self, system: &System, state: &State, made: f64) -> f64 {
        let slight = self.tolerance.position;
        let mut made = made;
        for edge in 0..system.marks.len() + system.vessels.len() {
            let Some(before) = height(system, &self.rodas.here.frame.kinematics, edge) else { continue };
            let mut there = |theta: f64| {
                self.rodas.course.at(theta, &mut self.point);
                self.probe.q.copy_from_slice(&state.q);
                system.tree.advance(&mut self.probe.q, &self.point.phi);
                self.probe.frame.kinematics.update(&system.tree, &self.probe.q, state.time);
                height(system, &self.probe.frame.kinematics, edge).unwrap_or(before)
            };
            let crosses = |height: f64| (height < 0.0) != (before < 0.0);
            let far = |height: f64| crosses(height) && height.abs() > slight;
            let mut ends = (1..=PARTS).map(|part| made * part as f64 / PARTS as f64);
            if let Some(end) = ends.find(|&end| far(there(end))) {
                made = halve(end, |theta| crosses(there(theta)));
            }
        }
        made
    }
}

/// Height above the water [m] of the lowest point of a mark, or, counted on from these, of the highest corner of a vessel's bottom.
fn height(system: &System, kinematics: &Kinematics, edge: usize) -> Option<f64> {
    let gravity = system.tree.gravity;
    if let Some(mark) = system.marks.get(edge) {
        let vessel = &system.vessels[mark.vessel];
        return Some(mark.height(vessel, &kinematics.pose[vessel.body], gravity));
    }
    let vessel = &system.vessels[edge - system.marks.len()];
    vessel.bottom_height(&kinematics.pose[vessel.body], gravity)
}
