//! Tanks with holes.

use glam::DVec3;

use super::plan::find_drive;
use super::{BuildError, at_least_zero, error, finite, positive};
use crate::force::AnyForce;
use crate::plan::{Hole, Holed};
use crate::spec::{ForceSpec, HoleSpec, JointSpec, PumpedSpec, SystemSpec};
use crate::system::DriveJoint;
use crate::tree::Tree;

pub(super) fn build_holed(
    spec: &SystemSpec,
    tree: &Tree,
    drives: &[DriveJoint],
) -> Result<Vec<Holed>, BuildError> {
    let mut found = Vec::new();
    for given in &spec.forces {
        let ForceSpec::Tank { name, pumped: Some(pumped), .. } = given else { continue };
        if pumped.holes.is_empty() {
            continue;
        }
        let tanks = tree.forces.iter().filter_map(|force| match force {
            AnyForce::Tank(tank) if &tank.name == name => Some(tank),
            _ => None,
        });
        for tank in tanks {
            let PumpedSpec { content, level, outside, holes } = pumped;
            let joint = spec.bodies.iter().find(|body| &body.name == content).map(|body| &body.joint);
            let Some(JointSpec::Content { drive }) = joint else {
                return error(name, "it has holes, but no content that a drive moves");
            };
            at_least_zero(name, "the density of the water outside", *outside)?;
            found.push(Holed {
                tank: tank.clone(),
                drive: find_drive(name, drive, drives)?,
                holes: holes.iter().map(|hole| build_hole(spec, name, hole)).collect::<Result<_, _>>()?,
                outside: *outside,
                level: *level,
                gravity: tree.gravity,
            });
        }
    }
    Ok(found)
}

fn build_hole(spec: &SystemSpec, name: &str, given: &HoleSpec) -> Result<Hole, BuildError> {
    finite(name, "the place of a hole", &given.at)?;
    positive(name, "the area of a hole", given.area)?;
    positive(name, "the share that a hole lets pass", given.discharge)?;
    if let Some((step, _)) = given.turns.iter().find(|turn| turn.0 >= spec.plan.len()) {
        return error(name, format!("there is no step {step} to open or close a hole"));
    }
    let (at, passes) = (DVec3::from_array(given.at), given.discharge * given.area);
    Ok(Hole { at, passes, is_open: !given.closed, turns: given.turns.clone() })
}
