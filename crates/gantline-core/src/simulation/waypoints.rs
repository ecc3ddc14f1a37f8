//! Where vessels are asked for what rights them once the run is over: as steps of its plan ended, and as the surface in a tank
//! came, went, or was half way up.

use serde::{Deserialize, Serialize};

use super::Simulation;
use crate::force::AnyForce;
use crate::force::tank::Tank;
use crate::state::State;
use crate::system::System;

/// Shares of a tank at which its surface counts. A free surface is least welcome as soon as it is there, and just before the
/// tank is pressed up with its liquid at its highest; stability booklets take a tank as full from 98 % on (IMO, Intact
/// Stability Code 2008, part B, chapter 3). A tank lying on its side is widest half way.
const MARKS: [f64; 3] = [0.02, 0.5, 0.98];

/// The state of a lift as a step of its plan ended, before what begins then has changed anything, but for what that does within
/// a step of fixed length, or as tanks passed marks.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Waypoint {
    /// The step that ended, by its number, of several that ended at once the last; of tanks that which began last. None
    /// before any has begun.
    pub step: Option<usize>,
    /// Time since that began [s]; None where it ended.
    pub since: Option<f64>,
    /// The tanks.
    passed: Vec<Passed>,
    /// The state.
    pub state: State,
}

/// One as it is written: name of its step, time since that began [s] unless it ended, time [s], and what [`Simulation::save`]
/// would have given there but for the past, for [`crate::statics::lift::StaticLift::settle_saved`].
pub type Saved = (Option<String>, Option<f64>, f64, Vec<u8>);

/// A tank that has passed a mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
struct Passed {
    /// The tank, by its number among the forces of the tree.
    tank: usize,
    /// The mark, by its number.
    mark: usize,
    /// True where it fills.
    fills: bool,
}

impl Simulation {
    /// Keeps where a step of the plan has ended in the step that has been made: where that began, if it ended then, else where
    /// it led; and where tanks have passed marks. Only what floats is asked for later, so that other lifts keep nothing.
    pub(super) fn note_waypoints(&mut self) {
        if self.system.vessels.is_empty() {
            return;
        }
        self.note_surfaces();
        let (before, after) = (&self.before, &self.state);
        if after.plan.ended().count() == before.plan.ended().count() {
            return;
        }
        let is_new = |index: usize| before.plan.ended().all(|(one, _)| one != index);
        if let Some((step, at)) = after.plan.ended().filter(|(index, _)| is_new(*index)).last() {
            let state = if at > before.time { after } else { before }.clone();
            self.waypoints.push(Waypoint { step: Some(step), since: None, passed: Vec::new(), state });
        }
    }

    /// Keeps a state with the surfaces of tanks that have passed marks; each tank, mark and way once while no further step of
    /// the plan begins, since waves move liquid to and fro through a hole.
    fn note_surfaces(&mut self) {
        let (before, after) = (&self.before, &self.state);
        let (step, begin) = after.plan.begun_last().unzip();
        let noted: Vec<&Passed> = self
            .waypoints
            .iter()
            .filter(|one| one.since.is_some() && one.step == step)
            .flat_map(|one| &one.passed)
            .collect();
        let mut passed = passed(&self.system, before, after);
        passed.retain(|one| !noted.contains(&one));
        if passed.is_empty() {
            return;
        }
        let fill = |one: &Passed| {
            pumped(&self.system).find(|(tank, _)| *tank == one.tank).map(|(_, tank)| tank.fill(&after.q))
        };
        let has_surfaces = passed.iter().filter_map(fill).all(Tank::has_surface);
        let state = if has_surfaces { after } else { before }.clone();
        let since = state.time - begin.unwrap_or_default();
        self.waypoints.push(Waypoint { step, since: Some(since), passed, state });
    }
}

/// The tanks whose content changes, by their numbers.
fn pumped(system: &System) -> impl Iterator<Item = (usize, &Tank)> {
    system.tree.forces.iter().enumerate().filter_map(|(index, force)| match force {
        AnyForce::Tank(tank) if tank.pumped.is_some() => Some((index, &**tank)),
        _ => None,
    })
}

/// What tanks have passed between two states.
fn passed(system: &System, before: &State, after: &State) -> Vec<Passed> {
    let marks = MARKS.iter().enumerate();
    pumped(system)
        .flat_map(|(tank, of)| {
            let (was, is) = (of.fill(&before.q), of.fill(&after.q));
            marks.clone().filter(move |(_, at)| (was < **at) != (is < **at)).map(move |(mark, _)| Passed {
                tank,
                mark,
                fills: is > was,
            })
        })
        .collect()
}
