//! Light sheaves: with losses and without inertia.

use super::brakes::Passing;
use super::{BuildError, error};
use crate::constraint::AnyConstraint;
use crate::constraint::brake::Brake;
use crate::spec::{JointSpec, SystemSpec};
use crate::system::{LightSheaves, Rows};
use crate::tree::Tree;

/// Whether the flow of that number has inertia, or may do without.
pub(super) fn check_inertia(
    spec: &SystemSpec,
    flow: usize,
    passing: Option<&Passing>,
) -> Result<(), BuildError> {
    let given = &spec.bodies[flow];
    let JointSpec::Flow { inertia, brake, capacity, drive, damping, .. } = &given.joint else {
        return Ok(());
    };
    if *inertia > 0.0 {
        return Ok(());
    }
    let is_held = *brake > 0.0 || *damping > 0.0 || capacity.is_some() || drive.is_some();
    let is_plain =
        |passing: &Passing| passing.ratio > 1.0 && passing.ratio.is_finite() && passing.groove.is_none();
    if is_held || !passing.is_some_and(is_plain) {
        return error(
            &given.name,
            "its inertia is 0, which only a sheave that loses in its bearing and in nothing else may have",
        );
    }
    Ok(())
}

/// True of the losses of a sheave without inertia.
pub(super) fn is_light(tree: &Tree, brake: &Brake) -> bool {
    !brake.grip.is_none() && tree.armature[brake.dof] == 0.0
}

/// Rows of light sheaves next to each other on one rope, in the order of ropes and routes.
pub(super) fn rows_of_light(tree: &Tree, constraints: &[AnyConstraint], rows: &Rows) -> Vec<LightSheaves> {
    let brakes = constraints.iter().enumerate().filter_map(|(index, constraint)| match constraint {
        AnyConstraint::Brake(brake) if is_light(tree, brake) => Some((rows.first[index], brake)),
        _ => None,
    });
    let mut sheaves: Vec<_> = brakes.collect();
    // The span before a sheave says where it is.
    sheaves.sort_by_key(|(_, brake)| brake.spans[0].0);
    let mut light: Vec<LightSheaves> = Vec::new();
    for (row, brake) in sheaves {
        let before = brake.spans[0].0;
        let rope = rows.first.partition_point(|&first| first <= before) - 1;
        let goes_on = light.last().is_some_and(|last| last.rope == rope && last.rows.end == before + 1);
        if !goes_on {
            light.push(LightSheaves { rope, rows: before..before + 1, ..LightSheaves::default() });
        }
        let Some(last) = light.last_mut() else { continue };
        last.rows.end += 1;
        last.ratio.push(brake.ratio());
        last.brakes.push(row);
        last.dofs.push(brake.dof);
        last.positions.push(tree.bodies[tree.owner[brake.dof]].first_position);
    }
    light
}
