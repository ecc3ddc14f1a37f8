//! All constraints in their order: ropes, contacts, what touches, stops, pins, brakes.

use glam::DVec3;

use super::brakes::build_brakes;
use super::ropes::build_rope;
use super::touches::{Touches, build_touches};
use super::{BuildError, at_least_zero, error, finite, positive, unit};
use crate::constraint::AnyConstraint;
use crate::constraint::contact::Contact;
use crate::constraint::facing::Facing;
use crate::constraint::pin::Pin;
use crate::constraint::stop::Stop;
use crate::contact::plane::Plane;
use crate::contact::spot::Spot;
use crate::rope::seat::Seat;
use crate::spec::{BodySpec, ContactSpec, StopsSpec, SystemSpec};
use crate::system::{BodyShape, ContactGroup};
use crate::tree::joint::Joint;
use crate::tree::kinematics::Kinematics;
use crate::tree::{Body, Tree};

/// Number of the body of that name; none is the world.
pub(super) fn body_index(
    element: &str,
    tree: &Tree,
    name: Option<&String>,
) -> Result<Option<usize>, BuildError> {
    let Some(name) = name else { return Ok(None) };
    match tree.bodies.iter().position(|body| &body.name == name) {
        Some(index) => Ok(Some(index)),
        None => error(element, format!("there is no body `{name}`")),
    }
}

/// Constraints, and what goes with them.
pub(super) struct Built {
    pub constraints: Vec<AnyConstraint>,
    pub groups: Vec<ContactGroup>,
    /// How ropes lie on sheaves with true tangents at the start, in the order of ropes and routes.
    pub seats: Vec<Seat>,
    pub touches: Touches,
}

pub(super) fn build_constraints(
    spec: &SystemSpec,
    tree: &Tree,
    start: &Kinematics,
    shapes: &[BodyShape],
) -> Result<Built, BuildError> {
    let mut constraints = Vec::with_capacity(spec.ropes.len() + spec.contacts.len());
    let mut seats = Vec::new();
    let mut coils = 0;
    for given in &spec.ropes {
        let rope = build_rope(given, tree, start, (&mut seats, &mut coils))?;
        constraints.push(AnyConstraint::Rope(rope));
    }
    let brakes = build_brakes(spec, tree, &constraints)?;
    let mut groups: Vec<ContactGroup> = Vec::new();
    for given in &spec.contacts {
        let group = ContactGroup::named(&mut groups, &given.group, tree);
        groups[group].contacts.push(constraints.len());
        constraints.push(AnyConstraint::Contact(build_contact(given, group, tree)?));
    }
    let touches = build_touches(spec, tree, shapes, &mut constraints, &mut groups)?;
    for (index, given) in spec.bodies.iter().enumerate() {
        constraints.extend(build_stops(given, index, tree)?.into_iter().map(AnyConstraint::Stop));
    }
    constraints.extend(build_pins(spec, tree)?.into_iter().map(AnyConstraint::Pin));
    constraints.extend(brakes);
    Ok(Built { constraints, groups, seats, touches })
}

/// The flow of that name.
pub(super) fn flow_named<'a>(element: &str, tree: &'a Tree, name: &str) -> Result<&'a Body, BuildError> {
    let Some(body) = tree.bodies.iter().find(|body| body.name == name) else {
        return error(element, format!("there is no flow `{name}`"));
    };
    if !matches!(body.joint, Joint::Flow(_)) {
        return error(element, format!("`{name}` is a body; only a flow passes rope"));
    }
    Ok(body)
}

/// The stops of a body's joint; two at one place are one spring.
fn build_stops(given: &BodySpec, index: usize, tree: &Tree) -> Result<Vec<Stop>, BuildError> {
    let Some(joint) = given.joint.axis() else { return Ok(Vec::new()) };
    let Some(StopsSpec { lower, upper, stiffness, damping_time, loaded }) = &joint.stops else {
        return Ok(Vec::new());
    };
    let name = &given.name;
    if joint.drive.is_some() {
        return error(name, "its joint has a drive and stops; what is driven has no stops");
    }
    positive(name, "the stiffness of its stops", *stiffness)?;
    at_least_zero(name, "the damping time of its stops", *damping_time)?;
    let body = &tree.bodies[index];
    let mut stops = Vec::new();
    let is_spring = lower.is_some() && lower == upper;
    for (end, side) in [(lower, -1.0), (upper, 1.0)] {
        let Some(end) = *end else { continue };
        if is_spring && side < 0.0 {
            continue;
        }
        finite(name, "a stop", &[end])?;
        let beyond = if is_spring { (joint.position - end).abs() } else { side * (joint.position - end) };
        if beyond > 0.0 && !loaded {
            return error(name, format!("its joint starts at {}, beyond its stop at {end}", joint.position));
        }
        stops.push(Stop {
            name: name.clone(),
            dof: body.first_velocity,
            position: body.first_position,
            end,
            side,
            compliance: 1.0 / stiffness,
            damping_time: *damping_time,
            is_spring,
        });
    }
    Ok(stops)
}

/// The locking pins of all joints that have one.
fn build_pins(spec: &SystemSpec, tree: &Tree) -> Result<Vec<Pin>, BuildError> {
    let mut pins = Vec::new();
    for (given, body) in spec.bodies.iter().zip(&tree.bodies) {
        let Some(joint) = given.joint.axis() else { continue };
        let Some(starts_in) = joint.pin else { continue };
        if joint.drive.is_some() {
            return error(&given.name, "its joint has a drive and a pin; what is driven has no pin");
        }
        if joint.friction > 0.0 {
            return error(
                &given.name,
                "its joint has friction and a pin, which hold the same; one of them only",
            );
        }
        if starts_in && joint.velocity != 0.0 {
            return error(&given.name, "its pin is in at the start and its joint moves; one of them only");
        }
        pins.push(Pin { name: given.name.clone(), dof: body.first_velocity });
    }
    Ok(pins)
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
    let with_plane = body_index(name, tree, given.plane_body.as_ref())?;
    if with_plane == Some(body) {
        return error(name, "its point and its plane are on one body; a body does not touch itself");
    }
    let normal = unit(name, "the plane's normal", given.plane_normal)?;
    let plane = Plane::new(DVec3::from_array(given.plane_point), normal);
    Ok(Contact {
        name: name.clone(),
        group,
        facing: Facing::new([Some(body), with_plane], tree),
        spot: Spot { is_near: true, point: DVec3::from_array(given.at), plane, ..Spot::none() },
        compliance: 1.0 / given.stiffness,
        damping_time: given.damping_time,
        friction: given.friction,
    })
}
