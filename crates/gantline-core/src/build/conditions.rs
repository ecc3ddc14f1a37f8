//! Conditions on which steps of the plan end, and what drives follow.

use glam::DVec3;

use super::{BuildError, at_least_zero, error, finite, positive};
use crate::constraint::AnyConstraint;
use crate::force::moorings;
use crate::plan::{Condition, Falls, Follow, Lead, Strand, Way};
use crate::spec::{LeadSpec, PlaceSpec, StrandSpec, TacklesSpec, UntilSpec, WaySpec};
use crate::system::{ContactGroup, DriveJoint, Rows};
use crate::tree::Tree;
use crate::tree::joint::Joint;

/// A condition of the step `name`; an end that is none is an error of the caller.
pub(super) fn build_condition(
    name: &str,
    given: &UntilSpec,
    tree: &Tree,
    groups: &[ContactGroup],
    ropes: (&[AnyConstraint], &Rows),
) -> Result<Condition, BuildError> {
    let group_index = |wanted: &str| match groups.iter().position(|group| group.name == wanted) {
        Some(index) => Ok(index),
        None => error(name, format!("there are no contacts of `{wanted}`")),
    };
    let rows_of = |segments: &[(String, usize)]| -> Result<Vec<usize>, BuildError> {
        segments.iter().map(|(rope, segment)| row_of(name, rope, *segment, ropes, tree)).collect()
    };
    match given {
        UntilSpec::LoadTransferred { group, weight, at_least } => {
            positive(name, "the weight", *weight)?;
            let group = group_index(group)?;
            Ok(Condition::LoadTransferred { group, weight: *weight, at_least: *at_least })
        }
        UntilSpec::LoadReturned { group, weight, at_most } => {
            positive(name, "the weight", *weight)?;
            Ok(Condition::LoadReturned { group: group_index(group)?, weight: *weight, at_most: *at_most })
        }
        UntilSpec::Clear { group } => Ok(Condition::Clear(group_index(group)?)),
        UntilSpec::Touched { group } => Ok(Condition::Touched(group_index(group)?)),
        UntilSpec::TensionAbove { segments, bound } => {
            positive(name, "the bound of a tension", *bound)?;
            Ok(Condition::TensionAbove { rows: rows_of(segments)?, bound: *bound })
        }
        UntilSpec::TensionBelow { segments, bound } => {
            at_least_zero(name, "the bound of a tension", *bound)?;
            Ok(Condition::TensionBelow { rows: rows_of(segments)?, bound: *bound })
        }
        UntilSpec::Spread { groups, at_most } => {
            at_least_zero(name, "the spread", *at_most)?;
            let rows_of_group =
                |group: &Vec<String>| group.iter().map(|rope| row_of(name, rope, 0, ropes, tree)).collect();
            let groups = groups.iter().map(rows_of_group).collect::<Result<_, _>>()?;
            Ok(Condition::Spread { groups, at_most: *at_most })
        }
        UntilSpec::Attitude { body, angle, above, bound } => {
            finite(name, "the bound of an angle", &[*bound])?;
            let Some(body) = tree.bodies.iter().position(|other| &other.name == body) else {
                return error(name, format!("there is no body `{body}`"));
            };
            Ok(Condition::Attitude { body, angle: *angle, above: *above, bound: *bound })
        }
        UntilSpec::Plumb { falls, at_most } => {
            at_least_zero(name, "the angle", *at_most)?;
            let down = plumb(name, tree)?;
            let place = |given| place(name, given, tree);
            let falls = falls
                .iter()
                .map(|[upper, lower]| Ok(Falls { upper: place(upper)?, lower: place(lower)?, down }));
            Ok(Condition::Plumb { falls: falls.collect::<Result<_, _>>()?, cosine: at_most.cos() })
        }
        other => error(name, format!("{other:?} is no condition")),
    }
}

/// What a drive follows, of the step `name`.
pub(super) fn build_follow(
    name: &str,
    (way, every, glances): (Way, f64, u32),
    (own, others): (&[LeadSpec], &[LeadSpec]),
    tree: &Tree,
    ropes: (&[AnyConstraint], &Rows),
) -> Result<Follow, BuildError> {
    let down = plumb(name, tree)?;
    let strand = |given: &StrandSpec| {
        let row = row_of(name, &given.rope, 0, ropes, tree)?;
        let lower: Vec<_> = given.lower.iter().map(|end| place(name, end, tree)).collect::<Result<_, _>>()?;
        Ok(Strand { row, upper: place(name, &given.upper, tree)?, lower })
    };
    let lead = |given: &LeadSpec| {
        let level = |level: &Vec<StrandSpec>| level.iter().map(strand).collect::<Result<Vec<_>, _>>();
        let levels = given.levels.iter().map(level).collect::<Result<_, _>>()?;
        Ok(Lead { tip: place(name, &given.tip, tree)?, hook: place(name, &given.hook, tree)?, levels })
    };
    let leads = |given: &[LeadSpec]| given.iter().map(lead).collect::<Result<Vec<_>, _>>();
    if own.is_empty() || others.is_empty() {
        return error(name, "what follows needs a hook of its own, and another");
    }
    Ok(Follow { way, every, glances, own: leads(own)?, others: leads(others)?, down })
}

/// How a drive of the step `name` takes hooks along.
pub(super) fn build_way(
    name: &str,
    drive: &DriveJoint,
    given: &WaySpec,
    tree: &Tree,
) -> Result<Way, BuildError> {
    let carried = place(name, &given.carried, tree)?;
    let mut joint = (drive.body, drive.dof);
    let mut tackles = None;
    if let Some(TacklesSpec { turns, top, head }) = &given.tackles {
        let (body, _) = place(name, &(turns.clone(), [0.0; 3]), tree)?;
        if !matches!(tree.bodies[body].joint, Joint::Hinge(_)) {
            return error(name, format!("`{turns}` has no hinge about which tackles could turn it"));
        }
        joint = (body, tree.bodies[body].first_velocity);
        tackles = Some([place(name, top, tree)?, place(name, head, tree)?]);
    }
    let mut above = Some(carried.0);
    while let Some(body) = above.filter(|&body| body != joint.0) {
        above = tree.bodies[body].parent;
    }
    if above.is_none() {
        return error(name, format!("`{}` does not take `{}` along", drive.name, given.carried.0));
    }
    Ok(Way { joint, carried, tackles })
}

pub(super) fn plumb(name: &str, tree: &Tree) -> Result<DVec3, BuildError> {
    match tree.gravity.try_normalize() {
        Some(down) => Ok(down),
        None => error(name, "there is no gravity, so nothing is plumb; give it gravity"),
    }
}

/// A body, and a point in its frame [m].
pub(super) fn place(name: &str, (body, at): &PlaceSpec, tree: &Tree) -> Result<(usize, DVec3), BuildError> {
    let Some(index) = tree.bodies.iter().position(|other| &other.name == body) else {
        return error(name, format!("there is no body `{body}`"));
    };
    finite(name, "a place", at)?;
    Ok((index, DVec3::from_array(*at)))
}

/// The row that has the tension of a segment of a rope.
fn row_of(
    name: &str,
    wanted: &str,
    segment: usize,
    (constraints, rows): (&[AnyConstraint], &Rows),
    tree: &Tree,
) -> Result<usize, BuildError> {
    for (index, constraint) in constraints.iter().enumerate() {
        let AnyConstraint::Rope(rope) = constraint else { break };
        if rope.name != wanted {
            continue;
        }
        return match rope.span_of[..rope.route.parts.len()].get(segment) {
            Some(span) => Ok(rows.first[index] + span),
            None => error(name, format!("rope `{wanted}` has no segment {segment}")),
        };
    }
    match moorings(tree).position(|line| line.name == wanted) {
        Some(line) if segment == 0 => Ok(rows.count() + line),
        Some(_) => error(name, format!("mooring line `{wanted}` has one segment, 0")),
        None => error(name, format!("there is no rope `{wanted}`")),
    }
}
