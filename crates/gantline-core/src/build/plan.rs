//! Drives and the steps of the plan.

use super::{BuildError, at_least_zero, error, finite, positive};
use crate::constraint::AnyConstraint;
use crate::plan::{Cut, Due, Emergency, Move, Pinning, Step, Until};
use crate::spec::{AxisJointSpec, BodySpec, EmergencySpec, JointSpec, StepSpec, SystemSpec, UntilSpec};
use crate::system::{ContactGroup, DriveJoint};
use crate::tree::Tree;

pub(super) fn build_drives(spec: &SystemSpec, tree: &Tree) -> Result<Vec<DriveJoint>, BuildError> {
    let mut drives = Vec::with_capacity(spec.drives.len());
    for drive in &spec.drives {
        let wanted = |given: &BodySpec| given.joint.drive() == Some(&drive.name);
        let Some(body) = spec.bodies.iter().position(wanted) else {
            return error(&drive.name, "no hinge, slider or flow names this drive");
        };
        if spec.bodies.iter().filter(|given| wanted(given)).count() > 1 {
            return error(&drive.name, "two joints name this drive; each needs its own");
        }
        for pair in drive.ramps.windows(2) {
            if pair[1].at < pair[0].at + pair[0].duration {
                return error(
                    &drive.name,
                    "its ramps overlap; each must start after the one before has ended",
                );
            }
        }
        for ramp in &drive.ramps {
            finite(&drive.name, "a ramp", &[ramp.at, ramp.velocity])?;
            positive(&drive.name, "the duration of a ramp", ramp.duration)?;
        }
        let is_limited = matches!(spec.bodies[body].joint, JointSpec::Flow { capacity: Some(_), .. });
        let dof = tree.bodies[body].first_velocity;
        drives.push(DriveJoint { name: drive.name.clone(), body, dof, is_limited });
    }
    for given in &spec.bodies {
        if let Some(name) = given.joint.drive()
            && !drives.iter().any(|drive| &drive.name == name)
        {
            return error(&given.name, format!("there is no drive `{name}`"));
        }
    }
    Ok(drives)
}

pub(super) fn build_step(
    given: &StepSpec,
    drives: &[DriveJoint],
    groups: &[ContactGroup],
) -> Result<Step, BuildError> {
    let name = &given.name;
    let group_index = |wanted: &str| match groups.iter().position(|group| group.name == wanted) {
        Some(index) => Ok(index),
        None => error(name, format!("there are no contacts of `{wanted}`")),
    };
    let mut moves = Vec::with_capacity(given.moves.len());
    for motion in &given.moves {
        let Some(drive) = drives.iter().position(|drive| drive.name == motion.drive) else {
            return error(name, format!("there is no drive `{}`", motion.drive));
        };
        positive(name, "the acceleration", motion.acceleration)?;
        positive(name, "the speed", motion.velocity.abs())?;
        let (velocity, acceleration, shape) = (motion.velocity, motion.acceleration, motion.shape);
        let emergency = match &motion.emergency {
            Some(EmergencySpec { acceleration, brake }) => {
                positive(name, "the acceleration of an emergency stop", *acceleration)?;
                if let Some(brake) = brake {
                    positive(name, "the capacity of a brake", *brake)?;
                    if !drives[drive].is_limited {
                        return error(name, "a brake takes the place of a motor with a capacity");
                    }
                }
                Some(Emergency { acceleration: *acceleration, brake: *brake })
            }
            None => None,
        };
        moves.push(Move { drive, velocity, acceleration, shape, emergency });
    }
    let until = match &given.until {
        UntilSpec::BrakeFrom { time } => Until::BrakeFrom(*time),
        UntilSpec::Distance { distance } => {
            positive(name, "the distance", distance.abs())?;
            Until::Distance(*distance)
        }
        UntilSpec::Duration { duration } => {
            at_least_zero(name, "the duration", *duration)?;
            Until::Duration(*duration)
        }
        UntilSpec::LoadTransferred { group, weight, at_least } => {
            positive(name, "the weight", *weight)?;
            Until::LoadTransferred { group: group_index(group)?, weight: *weight, at_least: *at_least }
        }
        UntilSpec::Clear { group } => Until::Clear(group_index(group)?),
        UntilSpec::EndOfRun {} => Until::EndOfRun,
    };
    Ok(Step { name: name.clone(), moves, start_at: given.start_at, until })
}

/// Ropes that break, with the tension at which they do [N].
pub(super) fn build_fragile(spec: &SystemSpec) -> Result<Vec<(usize, f64)>, BuildError> {
    let mut fragile = Vec::new();
    for (rope, given) in spec.ropes.iter().enumerate() {
        if let Some(force) = given.breaking_force {
            positive(&given.name, "its breaking force", force)?;
            fragile.push((rope, force));
        }
    }
    Ok(fragile)
}

/// Ropes that are cut, at times and as steps of the plan begin.
pub(super) fn build_cuts(spec: &SystemSpec) -> Result<Vec<Cut>, BuildError> {
    let mut cuts = Vec::new();
    for (rope, given) in spec.ropes.iter().enumerate() {
        if let Some(time) = given.cut_at {
            at_least_zero(&given.name, "the time at which it is cut", time)?;
            cuts.push(Cut { rope, due: Due::At(time) });
        }
    }
    for (index, step) in spec.plan.iter().enumerate() {
        for name in &step.cuts {
            let Some(rope) = spec.ropes.iter().position(|rope| &rope.name == name) else {
                return error(&step.name, format!("there is no rope `{name}`"));
            };
            cuts.push(Cut { rope, due: Due::Step(index) });
        }
    }
    Ok(cuts)
}

/// Locking pins, with the steps of the plan that pull them and put them in.
pub(super) fn build_pinnings(
    spec: &SystemSpec,
    constraints: &[AnyConstraint],
) -> Result<Vec<Pinning>, BuildError> {
    let starts_in = |name: &str| {
        let body = spec.bodies.iter().find(|body| body.name == name)?;
        let (JointSpec::Hinge(AxisJointSpec { pin, .. }) | JointSpec::Slider(AxisJointSpec { pin, .. })) =
            &body.joint
        else {
            return None;
        };
        *pin
    };
    let mut pinnings: Vec<Pinning> = Vec::new();
    for (index, constraint) in constraints.iter().enumerate() {
        if let AnyConstraint::Pin(pin) = constraint {
            let starts_in = starts_in(&pin.name) == Some(true);
            pinnings.push(Pinning { pin: index, starts_in, changes: Vec::new() });
        }
    }
    for (index, step) in spec.plan.iter().enumerate() {
        for (names, is_in) in [(&step.pulls, false), (&step.pins, true)] {
            for name in names {
                let own = |pinning: &&mut Pinning| constraints[pinning.pin].name() == name;
                let Some(pinning) = pinnings.iter_mut().find(own) else {
                    return error(&step.name, format!("there is no pin of `{name}`"));
                };
                if pinning.changes.last().is_some_and(|&(last, _)| last == index) {
                    return error(&step.name, format!("it moves the pin of `{name}` twice; once is right"));
                }
                pinning.changes.push((index, is_in));
            }
        }
    }
    Ok(pinnings)
}
