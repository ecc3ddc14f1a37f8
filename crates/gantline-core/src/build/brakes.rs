//! What holds flows and joints: brakes, motors of limited force, dry friction, bearings and grooves of sheaves.

use std::f64::consts::PI;

use super::light::{check_inertia, is_light};
use super::rows::flow_named;
use super::{BuildError, at_least_zero, error, positive};
use crate::constraint::AnyConstraint;
use crate::constraint::brake::{Brake, Grip, share_of_ratio};
use crate::constraint::rope::span::Span;
use crate::force::{Force, moorings};
use crate::spec::{GrooveSpec, GuideSpec, JointSpec, SystemSpec};
use crate::tree::Tree;

/// A joint with dry friction that turns back as slowly as this [m/s or rad/s] is as good as held.
const SLOW: f64 = 1e-4;

/// Friction of all flows and joints that no drive prescribes: of joints, of the sheave that rope passes, and of brakes;
/// that of light sheaves last.
pub(super) fn build_brakes(
    spec: &SystemSpec,
    tree: &Tree,
    ropes: &[AnyConstraint],
) -> Result<Vec<AnyConstraint>, BuildError> {
    let mut brakes = Vec::new();
    for index in 0..spec.bodies.len() {
        brakes.extend(friction_of_joint(spec, tree, index)?);
    }
    for index in 0..spec.bodies.len() {
        brakes.extend(brake_of_flow(spec, tree, ropes, index)?);
    }
    brakes.sort_by_key(|brake| is_light(tree, brake));
    Ok(brakes.into_iter().map(AnyConstraint::Brake).collect())
}

/// Dry friction of the joint of a body, if it has any.
fn friction_of_joint(spec: &SystemSpec, tree: &Tree, index: usize) -> Result<Option<Brake>, BuildError> {
    let given = &spec.bodies[index];
    let Some(joint) = given.joint.axis() else { return Ok(None) };
    at_least_zero(&given.name, "the joint's friction", joint.friction)?;
    if joint.friction <= 0.0 || joint.drive.is_some() {
        return Ok(None);
    }
    let dof = tree.bodies[index].first_velocity;
    let limits = [joint.friction, joint.friction / SLOW, f64::INFINITY];
    Ok(Some(Brake::new(given.name.clone(), (dof, None), limits, Grip::Share(0.0), Vec::new())))
}

/// What holds the flow of a body: a brake, a motor, the losses of its sheave; none where nothing does.
fn brake_of_flow(
    spec: &SystemSpec,
    tree: &Tree,
    ropes: &[AnyConstraint],
    index: usize,
) -> Result<Option<Brake>, BuildError> {
    let given = &spec.bodies[index];
    let JointSpec::Flow { brake, capacity, power, drive, .. } = &given.joint else { return Ok(None) };
    let limit = limit_of_force(&given.name, *brake, *capacity, drive.is_some())?;
    let power = power.unwrap_or(f64::INFINITY);
    if power <= 0.0 || power.is_nan() || power.is_finite() && capacity.is_none() {
        return error(&given.name, "the power of a drive is more than zero and stands beside its capacity");
    }
    let dof = tree.bodies[index].first_velocity;
    let passing = Passing::of(spec, &given.name);
    check_inertia(spec, index, passing.as_ref())?;
    if moorings(tree).any(|line| line.flow() == Some(dof)) {
        if *brake > 0.0 || capacity.is_some() {
            return error(
                &given.name,
                "it pays out a mooring line, which no brake and no capacity can hold; leave them out",
            );
        }
        return Ok(None);
    }
    // What spins moves no rope by itself: the tensions on its bearing are those of the flow over it.
    let passes = match &passing {
        Some(passing) => flow_named(&given.name, tree, passing.flow)?.first_velocity,
        None => dof,
    };
    let (spans, impedance) = spans_fed_by(passes, ropes, tree.armature[dof]);
    if spans.is_empty() {
        return error(&given.name, "no rope passes this flow");
    }
    let grip = passing.as_ref().map_or(Grip::Share(0.0), |passing| passing.grip(&given.name, ropes));
    let is_lossy = !grip.is_none();
    if is_lossy && spans.len() != 2 {
        let problem = format!("a flow with losses passes one sheave of one rope, not {} spans", spans.len());
        return error(&given.name, problem);
    }
    let is_held = capacity.is_some() || (is_lossy || limit > 0.0) && drive.is_none();
    if !is_held {
        return Ok(None);
    }
    let spin = passing.and_then(|passing| passing.groove?.spin.as_ref());
    let spin = match spin.filter(|spin| **spin != given.name) {
        Some(spin) => Some(flow_named(&given.name, tree, spin)?.first_velocity),
        None => None,
    };
    Ok(Some(Brake::new(given.name.clone(), (dof, spin), [limit, impedance, power], grip, spans)))
}

/// Spans that a flow feeds, with their numbers among all, and their impedance beside its inertia [N s/m].
fn spans_fed_by(flow: usize, ropes: &[AnyConstraint], inertia: f64) -> (Vec<(usize, Span)>, f64) {
    let built = ropes.iter().filter_map(|constraint| match constraint {
        AnyConstraint::Rope(rope) => Some(rope),
        _ => None,
    });
    let rows = built.flat_map(|rope| rope.spans.iter().map(|span| (span, rope.material))).enumerate();
    let (mut spans, mut stiffness, mut damping) = (Vec::new(), 0.0, 0.0);
    for (row, (span, material)) in rows {
        if span.feeds.iter().any(|feed| feed.dof == flow) {
            let own = 1.0 / material.compliance(span.length);
            stiffness += own;
            damping += own * material.damping_time;
            spans.push((row, span.clone()));
        }
    }
    (spans, damping + (stiffness * inertia).sqrt())
}

/// The most that the brake of a flow, or the motor in its place, can hold [N].
fn limit_of_force(name: &str, brake: f64, capacity: Option<f64>, has_drive: bool) -> Result<f64, BuildError> {
    at_least_zero(name, "its brake", brake)?;
    let Some(capacity) = capacity else { return Ok(brake) };
    positive(name, "the capacity of its drive", capacity)?;
    if !has_drive || brake > 0.0 {
        return error(name, "a capacity is that of a drive, which takes the place of a brake");
    }
    Ok(capacity)
}

/// A sheave that rope passes with a flow.
pub(super) struct Passing<'a> {
    /// Number of the rope, and of the guide on its route.
    rope: usize,
    place: usize,
    flow: &'a String,
    /// ρ of its bearing.
    pub ratio: f64,
    /// Its groove, where rope may slip in it.
    pub groove: Option<&'a GrooveSpec>,
}

impl<'a> Passing<'a> {
    /// The sheave of which `name` is the flow or the spin.
    fn of(spec: &'a SystemSpec, name: &str) -> Option<Self> {
        let guides = spec.ropes.iter().enumerate().flat_map(|(rope, given)| {
            given.route.iter().enumerate().map(move |(place, guide)| (rope, place, guide))
        });
        let mut passings = guides.filter_map(|(rope, place, guide)| match guide {
            GuideSpec::HalfTurn { flow: Some(flow), ratio, groove, .. }
            | GuideSpec::Sheave { flow: Some(flow), ratio, groove, .. } => {
                Some(Self { rope, place, flow, ratio: *ratio, groove: groove.as_ref() })
            }
            _ => None,
        });
        let spins =
            |groove: Option<&GrooveSpec>| groove.is_some_and(|groove| groove.spin.as_deref() == Some(name));
        passings.find(|passing| passing.flow == name || spins(passing.groove))
    }

    /// What holds the flow or the spin `name`: the groove the flow, the bearing the spin; where nothing slips in the
    /// groove there is only the flow.
    fn grip(&self, name: &str, ropes: &[AnyConstraint]) -> Grip {
        match (self.groove, &ropes[self.rope]) {
            (Some(groove), AnyConstraint::Rope(rope)) if self.flow == name => {
                let friction = groove.friction;
                if rope.route.guides[self.place].is_sheave() {
                    return Grip::Groove { friction, route: rope.route.clone(), place: self.place };
                }
                Grip::Share((0.5 * friction * PI).tanh())
            }
            _ => Grip::Share(share_of_ratio(self.ratio)),
        }
    }
}
