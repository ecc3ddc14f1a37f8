//! Drives and the steps of the plan.

use std::sync::Arc;

use super::coils::build_layers;
use super::compensators::{build_compensations, build_compensators};
use super::conditions::{build_condition, build_follow, build_way};
use super::holes::build_holed;
use super::{BuildError, at_least_zero, error, finite, positive};
use crate::constraint::AnyConstraint;
use crate::plan::{
    Cut, DriveStop, Due, Emergency, EmergencyStop, Leading, Move, Plan, Reel, Series, Step, StopAt,
    Switching, Until,
};
use crate::spec::{
    BodySpec, EmergencySpec, ForceSpec, JointSpec, MoveSpec, ReelSpec, StepSpec, StopAtSpec, SystemSpec,
    UntilSpec,
};
use crate::system::{ContactGroup, DriveJoint, Rows};
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
        let joint = &spec.bodies[body].joint;
        let is_limited = matches!(joint, JointSpec::Flow { capacity: Some(_), .. });
        let keeps_pull = matches!(joint, JointSpec::Flow { capacity: Some(_), keeps_pull: true, .. });
        let dof = tree.bodies[body].first_velocity;
        let (name, by_waves) = (drive.name.clone(), drive.waves.is_some());
        if by_waves && is_limited {
            return error(&name, "waves move it, whatever that takes; it has no motor of limited force");
        }
        let leads = spec.plan.iter().any(|step| {
            matches!(step.until, UntilSpec::Leading { .. }) && step.moves.iter().any(|one| one.drive == name)
        });
        let curved = by_waves || (leads && !is_limited);
        let by_fluid = by_waves || runs_through_holes(spec, &spec.bodies[body].name);
        drives.push(DriveJoint { name, body, dof, is_limited, keeps_pull, by_fluid, curved });
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

/// Whether a body is the content of a tank with holes.
fn runs_through_holes(spec: &SystemSpec, body: &str) -> bool {
    spec.forces.iter().any(|force| {
        matches!(force, ForceSpec::Tank { pumped: Some(pumped), .. }
            if pumped.content == body && !pumped.holes.is_empty())
    })
}

/// The steps, and what stops them.
pub(super) fn build_plan(
    spec: &SystemSpec,
    tree: &Tree,
    drives: &[DriveJoint],
    groups: &[ContactGroup],
    ropes: (&[AnyConstraint], &Rows),
) -> Result<Plan, BuildError> {
    let compensators = build_compensators(spec, tree, drives)?;
    let mut steps = Vec::with_capacity(spec.plan.len());
    for given in &spec.plan {
        let compensates = build_compensations(given, tree, &compensators)?;
        steps.push(Step { compensates, ..build_step(given, tree, drives, groups, ropes)? });
    }
    let stop = match &spec.emergency_stop {
        None => None,
        Some(given) => {
            let name = "the emergency stop";
            let at = match given.at {
                StopAtSpec::Time { time } => StopAt::Time(time),
                StopAtSpec::InStep { step, after } if step < steps.len() => StopAt::InStep(step, after),
                StopAtSpec::InStep { step, .. } => return error(name, format!("there is no step {step}")),
            };
            let (StopAt::Time(time) | StopAt::InStep(_, time)) = at;
            at_least_zero(name, "its time", time)?;
            let mut stopped = Vec::with_capacity(given.drives.len());
            for one in &given.drives {
                let drive = find_drive(name, &one.drive, drives)?;
                let how = build_emergency(name, &one.stop, &drives[drive])?;
                stopped.push(DriveStop { drive, how, step: one.step });
            }
            Some(EmergencyStop { at, drives: stopped })
        }
    };
    Ok(Plan { steps, compensators, holed: build_holed(spec, tree, drives)?, stop })
}

pub(super) fn find_drive(element: &str, wanted: &str, drives: &[DriveJoint]) -> Result<usize, BuildError> {
    match drives.iter().position(|drive| drive.name == wanted) {
        Some(drive) => Ok(drive),
        None => error(element, format!("there is no drive `{wanted}`")),
    }
}

/// How a drive is stopped in an emergency.
///
/// # Errors
/// Where its numbers are not positive, or a brake has no motor in whose place it could hold.
pub fn build_emergency(
    element: &str,
    given: &EmergencySpec,
    drive: &DriveJoint,
) -> Result<Emergency, BuildError> {
    let EmergencySpec { acceleration, brake } = *given;
    positive(element, "the acceleration of an emergency stop", acceleration)?;
    if let Some(brake) = brake {
        positive(element, "the capacity of a brake", brake)?;
        if !drive.is_limited {
            return error(element, "a brake takes the place of a motor with a capacity");
        }
    }
    Ok(Emergency { acceleration, brake })
}

pub(super) fn build_reel(element: &str, given: &ReelSpec) -> Result<Reel, BuildError> {
    positive(element, "the rope that a drive winds up", given.rate)?;
    Ok(Reel { rate: given.rate, layers: build_layers(element, &given.layers)? })
}

fn build_step(
    given: &StepSpec,
    tree: &Tree,
    drives: &[DriveJoint],
    groups: &[ContactGroup],
    ropes: (&[AnyConstraint], &Rows),
) -> Result<Step, BuildError> {
    let build_each = given.moves.iter().map(|motion| build_move(&given.name, motion, tree, drives));
    let moves = build_each.collect::<Result<Vec<_>, _>>()?;
    let until = build_until(given, &moves, tree, drives, groups, ropes)?;
    let (start_at, with_previous) = (given.start_at, given.with_previous);
    Ok(Step { name: given.name.clone(), moves, start_at, with_previous, until, compensates: Vec::new() })
}

/// What the step `name` does with one drive.
fn build_move(name: &str, motion: &MoveSpec, tree: &Tree, drives: &[DriveJoint]) -> Result<Move, BuildError> {
    let drive = find_drive(name, &motion.drive, drives)?;
    positive(name, "the acceleration", motion.acceleration)?;
    positive(name, "the speed", motion.velocity.abs())?;
    let moved = &drives[drive];
    let emergency = match &motion.emergency {
        Some(stop) => Some(build_emergency(name, stop, moved)?),
        None => None,
    };
    if let Some(range) = motion.range {
        finite(name, "the range of a drive", &range)?;
    }
    let reel = match &motion.reel {
        Some(reel) => Some(build_reel(name, reel)?),
        None => None,
    };
    let slips = moved.is_limited.then(|| tree.bodies[moved.body].first_position);
    let MoveSpec { velocity, acceleration, shape, range, .. } = *motion;
    Ok(Move { drive, velocity, acceleration, shape, range, emergency, reel, slips })
}

/// When a step ends.
fn build_until(
    given: &StepSpec,
    moves: &[Move],
    tree: &Tree,
    drives: &[DriveJoint],
    groups: &[ContactGroup],
    ropes: (&[AnyConstraint], &Rows),
) -> Result<Until, BuildError> {
    let name = &given.name;
    Ok(match &given.until {
        UntilSpec::BrakeFrom { time } => Until::BrakeFrom(*time),
        UntilSpec::Distance { distance } => {
            positive(name, "the distance", distance.abs())?;
            Until::Distance(*distance)
        }
        UntilSpec::Along { distance } => {
            positive(name, "how much", *distance)?;
            Until::Along(*distance)
        }
        UntilSpec::Position { positions } if positions.len() == moves.len() => {
            finite(name, "a position", positions)?;
            Until::Positions(positions.clone())
        }
        UntilSpec::Position { .. } => return error(name, "each drive that moves needs one position"),
        UntilSpec::Duration { duration } => {
            at_least_zero(name, "the duration", *duration)?;
            Until::Duration(*duration)
        }
        UntilSpec::EndOfRun {} => Until::EndOfRun,
        UntilSpec::Follow { way, every, glances, own, others } => match *moves {
            [Move { drive, .. }, ..] => {
                positive(name, "the time between looks", *every)?;
                positive(name, "the number of glances", f64::from(*glances))?;
                let way = build_way(name, &drives[drive], way, tree)?;
                Until::Follow(build_follow(name, (way, *every, *glances), (own, others), tree, ropes)?)
            }
            [] => return error(name, "a drive follows"),
        },
        UntilSpec::Leading { rate, acceleration, series } if series.len() == moves.len() => {
            positive(name, "the rate", *rate)?;
            positive(name, "the acceleration", *acceleration)?;
            let mut each = Vec::with_capacity(series.len());
            for coefficients in series {
                finite(name, "a coefficient", coefficients)?;
                each.push(Arc::new(Series::new(coefficients.clone())));
            }
            Until::Leading(Leading { rate: *rate, acceleration: *acceleration, series: each })
        }
        UntilSpec::Leading { .. } => return error(name, "each drive that moves needs one series"),
        condition => Until::Condition(build_condition(name, condition, tree, groups, ropes)?),
    })
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
    for (line, given) in spec.moorings().enumerate() {
        let rope = spec.ropes.len() + line;
        cuts.extend(given.cut_at.map(|time| Cut { rope, due: Due::At(time) }));
    }
    for (index, step) in spec.plan.iter().enumerate() {
        for name in &step.cuts {
            let ropes = spec.ropes.iter().map(|rope| &rope.name);
            let mut all = ropes.chain(spec.moorings().map(|line| &line.name));
            let Some(rope) = all.position(|rope| rope == name) else {
                return error(&step.name, format!("there is no rope `{name}`"));
            };
            cuts.push(Cut { rope, due: Due::Step(index) });
        }
    }
    Ok(cuts)
}

/// Ropes that steps of the plan put on or take off, with these steps. One whose first change is that it is put on is not
/// on at the start.
pub(super) fn build_slings(
    spec: &SystemSpec,
    constraints: &[AnyConstraint],
) -> Result<Vec<Switching>, BuildError> {
    let mut slings: Vec<Switching> = Vec::new();
    for (index, step) in spec.plan.iter().enumerate() {
        for (names, is_on) in [(&step.detaches, false), (&step.attaches, true)] {
            for name in names {
                let Some(rope) = spec.ropes.iter().position(|rope| &rope.name == name) else {
                    return error(&step.name, format!("there is no rope `{name}`"));
                };
                if let (true, AnyConstraint::Rope(given)) = (is_on, &constraints[rope])
                    && !(given.route.is_plain && given.spans.len() == 1)
                {
                    return error(
                        name,
                        "a rope that a step puts on runs over no sheaves and ends on no drum",
                    );
                }
                let at = slings.iter().position(|sling| sling.constraint == rope).unwrap_or_else(|| {
                    slings.push(Switching { constraint: rope, starts_on: !is_on, changes: Vec::new() });
                    slings.len() - 1
                });
                if slings[at].changes.last().map_or(slings[at].starts_on, |&(_, was_on)| was_on) == is_on {
                    let said = if is_on { "puts on" } else { "takes off" };
                    return error(&step.name, format!("it {said} `{name}` once more; once is right"));
                }
                slings[at].changes.push((index, is_on));
            }
        }
    }
    Ok(slings)
}

/// Locking pins, with the steps of the plan that pull them and put them in.
pub(super) fn build_pinnings(
    spec: &SystemSpec,
    constraints: &[AnyConstraint],
) -> Result<Vec<Switching>, BuildError> {
    let starts_in = |name: &str| spec.bodies.iter().find(|body| body.name == name)?.joint.axis()?.pin;
    let mut pinnings: Vec<Switching> = Vec::new();
    for (index, constraint) in constraints.iter().enumerate() {
        if let AnyConstraint::Pin(pin) = constraint {
            let starts_on = starts_in(&pin.name) == Some(true);
            pinnings.push(Switching { constraint: index, starts_on, changes: Vec::new() });
        }
    }
    for (index, step) in spec.plan.iter().enumerate() {
        for (names, is_in) in [(&step.pulls, false), (&step.pins, true)] {
            for name in names {
                let own = |pinning: &&mut Switching| constraints[pinning.constraint].name() == name;
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
