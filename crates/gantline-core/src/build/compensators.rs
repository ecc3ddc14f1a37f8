//! Hoists that can compensate heave.

use super::conditions::{place, plumb};
use super::plan::{build_reel, find_drive};
use super::rows::body_index;
use super::{BuildError, error, positive};
use crate::plan::{Compensator, Move};
use crate::spec::{CompensationSpec, CompensatorSpec, RampShape, StepSpec, SystemSpec};
use crate::system::DriveJoint;
use crate::tree::Tree;

pub(super) fn build_compensators(
    spec: &SystemSpec,
    tree: &Tree,
    drives: &[DriveJoint],
) -> Result<Vec<Compensator>, BuildError> {
    spec.compensators.iter().map(|given| build_compensator(given, tree, drives)).collect()
}

fn build_compensator(
    given: &CompensatorSpec,
    tree: &Tree,
    drives: &[DriveJoint],
) -> Result<Compensator, BuildError> {
    let name = &given.name;
    let drive = find_drive(name, &given.drive, drives)?;
    positive(name, "the speed that it adds", given.velocity)?;
    positive(name, "the acceleration that it adds", given.acceleration)?;
    positive(name, "the time of its filter", given.filter)?;
    let range = match given.stroke {
        Some(stroke) => {
            positive(name, "its stroke", stroke)?;
            Some([-0.5 * stroke, 0.5 * stroke])
        }
        None => None,
    };
    let reel = given.reel.as_ref().map(|reel| build_reel(name, reel)).transpose()?;
    let (velocity, acceleration, shape) = (given.velocity, given.acceleration, RampShape::Linear);
    let hoist = Move { drive, velocity, acceleration, shape, range, emergency: None, reel, slips: None };
    let (head, down) = (place(name, &given.head, tree)?, plumb(name, tree)?);
    let (vessel, _) = place(name, &(given.vessel.clone(), [0.0; 3]), tree)?;
    Ok(Compensator { name: name.clone(), vessel, head, down, hoist, filter: given.filter })
}

/// Compensators that work while a step goes on, and the bodies against whose decks.
pub(super) fn build_compensations(
    given: &StepSpec,
    tree: &Tree,
    compensators: &[Compensator],
) -> Result<Vec<(usize, Option<usize>)>, BuildError> {
    let one = |wanted: &CompensationSpec| {
        let Some(index) = compensators.iter().position(|other| other.name == wanted.compensator) else {
            return error(&given.name, format!("there is no compensator `{}`", wanted.compensator));
        };
        Ok((index, body_index(&given.name, tree, wanted.against.as_ref())?))
    };
    given.compensates.iter().map(one).collect()
}
