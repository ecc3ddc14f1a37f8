//! Ropes and contacts.

use glam::DVec3;

use super::{BuildError, at_least_zero, error, finite, positive, unit};
use crate::constraint::AnyConstraint;
use crate::constraint::contact::Contact;
use crate::constraint::rope::Rope;
use crate::contact::plane::Plane;
use crate::rope::material::Material;
use crate::rope::route::{Attachment, Guide, Route};
use crate::spec::{ContactSpec, GuideSpec, MaterialSpec, RopeSpec, SystemSpec};
use crate::system::ContactGroup;
use crate::tree::Tree;
use crate::tree::kinematics::Kinematics;

/// Largest stretch of a rope over sheaves at the start: more is a mistake in its length.
const MOST_STRAIN: f64 = 0.02;

fn body_index(element: &str, tree: &Tree, name: Option<&String>) -> Result<Option<usize>, BuildError> {
    let Some(name) = name else { return Ok(None) };
    match tree.bodies.iter().position(|body| &body.name == name) {
        Some(index) => Ok(Some(index)),
        None => error(element, format!("there is no body `{name}`")),
    }
}

pub(super) fn build_constraints(
    spec: &SystemSpec,
    tree: &Tree,
    start: &Kinematics,
) -> Result<(Vec<AnyConstraint>, Vec<ContactGroup>), BuildError> {
    let mut constraints = Vec::with_capacity(spec.ropes.len() + spec.contacts.len());
    for given in &spec.ropes {
        constraints.push(AnyConstraint::Rope(build_rope(given, tree, start)?));
    }
    let mut groups: Vec<ContactGroup> = Vec::new();
    for given in &spec.contacts {
        let group = groups.iter().position(|group| group.name == given.group).unwrap_or_else(|| {
            groups.push(ContactGroup { name: given.group.clone(), contacts: Vec::new() });
            groups.len() - 1
        });
        groups[group].contacts.push(constraints.len());
        constraints.push(AnyConstraint::Contact(build_contact(given, group, tree)?));
    }
    Ok((constraints, groups))
}

fn build_rope(given: &RopeSpec, tree: &Tree, start: &Kinematics) -> Result<Rope, BuildError> {
    let name = &given.name;
    let mut guides = Vec::with_capacity(given.route.len());
    for guide in &given.route {
        guides.push(match guide {
            GuideSpec::End { body, at } => {
                finite(name, "a point of its route", at)?;
                let body = body_index(name, tree, body.as_ref())?;
                Guide::End(Attachment { body, at: DVec3::from_array(*at) })
            }
            GuideSpec::HalfTurn { body, enter, leave, bulge } => {
                finite(name, "a point of its route", &[*enter, *leave].concat())?;
                let body = body_index(name, tree, body.as_ref())?;
                Guide::HalfTurn {
                    enter: Attachment { body, at: DVec3::from_array(*enter) },
                    leave: Attachment { body, at: DVec3::from_array(*leave) },
                    bulge: unit(name, "the bulge of a sheave", *bulge)?,
                }
            }
            GuideSpec::Sheave { body, at, axis, radius } => {
                finite(name, "a point of its route", at)?;
                positive(name, "the radius of a sheave", *radius)?;
                let body = body_index(name, tree, body.as_ref())?;
                let centre = Attachment { body, at: DVec3::from_array(*at) };
                Guide::Sheave { centre, axis: unit(name, "the axis of a sheave", *axis)?, radius: *radius }
            }
        });
    }
    let ends = [guides.first(), guides.last()];
    if guides.len() < 2 || !ends.iter().all(|guide| matches!(guide, Some(Guide::End(_)))) {
        return error(name, "its route must start and finish with an end");
    }
    let route = Route::new(guides);
    for (index, part) in route.parts.iter().enumerate().filter(|(_, part)| !part.is_plain()) {
        if let Err(reason) = part.tangent(start, |_, circle| circle) {
            return error(name, format!("its part {} at the start: {reason}", index + 1));
        }
    }
    let routed = route.length(start, |_, _| {});
    let length = given.length.unwrap_or(routed);
    positive(name, "its length", length)?;
    // Where a rope touches its sheaves only the core knows, so that the check of its length is here.
    if !route.is_plain && routed > length * (1.0 + MOST_STRAIN) {
        return error(
            name,
            format!("its length is {length} m, but its route has {routed:.6} m at the start"),
        );
    }
    let material = match given.material {
        MaterialSpec::Inextensible {} if route.parts.iter().any(|part| !part.is_plain()) => {
            return error(name, "an inextensible rope runs over half turns only; give it an axial stiffness");
        }
        MaterialSpec::Inextensible {} => Material::INEXTENSIBLE,
        MaterialSpec::Elastic { axial_stiffness, damping_time } => {
            positive(name, "its axial stiffness", axial_stiffness)?;
            at_least_zero(name, "its damping time", damping_time)?;
            Material::elastic(axial_stiffness, length, damping_time)
        }
    };
    Ok(Rope::new(name.clone(), route, length, material, tree))
}

fn build_contact(given: &ContactSpec, group: usize, tree: &Tree) -> Result<Contact, BuildError> {
    let name = &given.name;
    finite(name, "its point", &[given.at, given.plane_point].concat())?;
    positive(name, "its stiffness", given.stiffness)?;
    at_least_zero(name, "its damping time", given.damping_time)?;
    at_least_zero(name, "its friction", given.friction)?;
    let Some(body) = body_index(name, tree, Some(&given.body))? else {
        return error(name, "it has no body");
    };
    let normal = unit(name, "the plane's normal", given.plane_normal)?;
    Ok(Contact {
        name: name.clone(),
        group,
        body,
        at: DVec3::from_array(given.at),
        plane: Plane::new(DVec3::from_array(given.plane_point), normal),
        compliance: 1.0 / given.stiffness,
        damping_time: given.damping_time,
        friction: given.friction,
        dofs: tree.support[body].clone(),
    })
}
