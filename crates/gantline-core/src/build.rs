//! From a document to a checked [`System`] and its first [`State`].

use glam::{DMat3, DQuat, DVec3};
use thiserror::Error;

use crate::audit::{Ledger, elastic_energy, gravity_energy};
use crate::constraint::contact::Contact;
use crate::constraint::rope::Rope;
use crate::constraint::{AnyConstraint, Law};
use crate::contact::plane::Plane;
use crate::plan::drive::Timeline;
use crate::plan::{Move, PlanState, Step, Until};
use crate::rope::material::Material;
use crate::rope::route::{Attachment, Guide, Route};
use crate::solver::complementarity::Mode;
use crate::spec::{
    AxisJointSpec, BodySpec, ContactSpec, GuideSpec, JointSpec, MaterialSpec, RopeSpec, StepSpec, SystemSpec,
    UntilSpec,
};
use crate::state::State;
use crate::stepper::frame::Frame;
use crate::system::{ContactGroup, DriveJoint, Rows, System};
use crate::tree::ball::Ball;
use crate::tree::fixed::Fixed;
use crate::tree::free::Free;
use crate::tree::hinge::Hinge;
use crate::tree::joint::Joint;
use crate::tree::point::Point;
use crate::tree::pose::Pose;
use crate::tree::slider::Slider;
use crate::tree::{Body, Tree};

/// What is wrong with a document.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("{element}: {problem}")]
pub struct BuildError {
    /// Name of the body, rope, contact, drive or step.
    pub element: String,
    /// What was found and what would be right.
    pub problem: String,
}

fn error<T>(element: &str, problem: impl Into<String>) -> Result<T, BuildError> {
    Err(BuildError { element: element.to_owned(), problem: problem.into() })
}

/// Builds and checks the system and the state that it starts in.
///
/// # Errors
/// [`BuildError`] names the element and says what would be right.
pub fn build(spec: &SystemSpec) -> Result<(System, State), BuildError> {
    unique("body", spec.bodies.iter().map(|body| body.name.as_str()))?;
    unique("rope", spec.ropes.iter().map(|rope| rope.name.as_str()))?;
    unique("contact", spec.contacts.iter().map(|contact| contact.name.as_str()))?;
    unique("drive", spec.drives.iter().map(|drive| drive.name.as_str()))?;
    let tree = build_tree(spec)?;
    let mut q = vec![0.0; tree.positions];
    let mut v = vec![0.0; tree.velocities];
    for (body, given) in tree.bodies.iter().zip(&spec.bodies) {
        start_of_joint(&given.joint, &mut q[body.first_position..], &mut v[body.first_velocity..]);
    }
    let drives = build_drives(spec, &tree)?;
    let mut driven = vec![None; tree.velocities];
    for (index, drive) in drives.iter().enumerate() {
        driven[drive.dof] = Some(index);
        v[drive.dof] = 0.0;
    }
    let (constraints, groups) = build_constraints(spec, &tree)?;
    let rows = Rows::new(&constraints);
    let rigid = (0..rows.count()).filter(|&row| rows.laws[row].compliance() == 0.0).collect();
    let plan = spec.plan.iter().map(|step| build_step(step, &drives, &groups)).collect::<Result<_, _>>()?;
    let rope_count = spec.ropes.len();
    let mut system = System { tree, constraints, rope_count, rows, rigid, drives, driven, groups, plan };
    let state = first_state(spec, &mut system, q, v)?;
    Ok((system, state))
}

fn unique<'a>(kind: &str, names: impl Iterator<Item = &'a str>) -> Result<(), BuildError> {
    let mut seen = std::collections::BTreeSet::new();
    for name in names {
        if !seen.insert(name) {
            return error(name, format!("there are two of this name; every {kind} needs its own"));
        }
    }
    Ok(())
}

fn finite(element: &str, what: &str, values: &[f64]) -> Result<(), BuildError> {
    match values.iter().find(|value| !value.is_finite()) {
        Some(value) => error(element, format!("{what} is {value}; it must be a finite number")),
        None => Ok(()),
    }
}

fn at_least_zero(element: &str, what: &str, value: f64) -> Result<(), BuildError> {
    if value >= 0.0 && value.is_finite() {
        return Ok(());
    }
    error(element, format!("{what} is {value}; it must be zero or more"))
}

fn positive(element: &str, what: &str, value: f64) -> Result<(), BuildError> {
    if value > 0.0 && value.is_finite() {
        return Ok(());
    }
    error(element, format!("{what} is {value}; it must be more than zero"))
}

fn unit(element: &str, what: &str, given: [f64; 3]) -> Result<DVec3, BuildError> {
    match DVec3::from_array(given).try_normalize() {
        Some(unit) => Ok(unit),
        None => error(element, format!("{what} is {given:?}; it must have a direction")),
    }
}

fn unit_quaternion(element: &str, given: [f64; 4]) -> Result<DQuat, BuildError> {
    let quaternion = DQuat::from_xyzw(given[1], given[2], given[3], given[0]);
    if (quaternion.length() - 1.0).abs() < 1e-6 {
        return Ok(quaternion.normalize());
    }
    error(element, format!("orientation {given:?} is no unit quaternion"))
}

fn build_tree(spec: &SystemSpec) -> Result<Tree, BuildError> {
    finite("gravity", "the acceleration", &spec.gravity)?;
    let mut bodies: Vec<Body> = Vec::with_capacity(spec.bodies.len());
    for given in &spec.bodies {
        let parent = match &given.parent {
            None => None,
            Some(name) => match bodies.iter().position(|body| &body.name == name) {
                Some(parent) => Some(parent),
                None => return error(&given.name, format!("no body `{name}` stands before it to hang on")),
            },
        };
        bodies.push(build_body(given, parent)?);
    }
    let mut tree = Tree::new(bodies, DVec3::from_array(spec.gravity));
    for (index, given) in spec.bodies.iter().enumerate() {
        if let JointSpec::Hinge(joint) | JointSpec::Slider(joint) = &given.joint {
            at_least_zero(&given.name, "the joint's damping", joint.damping)?;
            let dof = tree.bodies[index].first_velocity;
            tree.damping[dof] = joint.damping;
        }
    }
    Ok(tree)
}

fn build_body(given: &BodySpec, parent: Option<usize>) -> Result<Body, BuildError> {
    let name = &given.name;
    at_least_zero(name, "its mass", given.mass)?;
    finite(name, "its inertia", &given.inertia)?;
    finite(name, "its centre of gravity", &given.centre_of_gravity)?;
    finite(name, "its place", &given.placement.position)?;
    let [xx, yy, zz, xy, xz, yz] = given.inertia;
    let inertia = DMat3::from_cols_array(&[xx, xy, xz, xy, yy, yz, xz, yz, zz]);
    let minor = xx * yy - xy * xy;
    let slack = -1e-9 * (xx + yy + zz).abs().powi(3);
    if xx < 0.0 || yy < 0.0 || zz < 0.0 || minor < -1e-9 * (xx + yy).powi(2) || inertia.determinant() < slack
    {
        return error(name, "its inertia is no inertia of a body: the matrix must not be negative");
    }
    let orientation = unit_quaternion(name, given.placement.orientation)?;
    Ok(Body {
        name: name.clone(),
        parent,
        placement: Pose::new(orientation, DVec3::from_array(given.placement.position)),
        is_turned: orientation != DQuat::IDENTITY,
        joint: build_joint(name, &given.joint)?,
        mass: given.mass,
        centre_of_gravity: DVec3::from_array(given.centre_of_gravity),
        inertia,
        first_position: 0,
        first_velocity: 0,
    })
}

fn build_joint(name: &str, given: &JointSpec) -> Result<Joint, BuildError> {
    Ok(match given {
        JointSpec::Fixed {} => Joint::Fixed(Fixed),
        JointSpec::Hinge(joint) => {
            finite(name, "its start", &[joint.position, joint.velocity])?;
            Joint::Hinge(Hinge { axis: unit(name, "the hinge axis", joint.axis)? })
        }
        JointSpec::Slider(joint) => {
            finite(name, "its start", &[joint.position, joint.velocity])?;
            Joint::Slider(Slider { axis: unit(name, "the slider axis", joint.axis)? })
        }
        JointSpec::Ball { orientation, angular_velocity } => {
            unit_quaternion(name, *orientation)?;
            finite(name, "its angular velocity", angular_velocity)?;
            Joint::Ball(Ball)
        }
        JointSpec::Point { position, velocity } => {
            finite(name, "its start", &[*position, *velocity].concat())?;
            Joint::Point(Point)
        }
        JointSpec::Free { position, orientation, velocity, angular_velocity } => {
            unit_quaternion(name, *orientation)?;
            finite(name, "its start", &[*position, *velocity, *angular_velocity].concat())?;
            Joint::Free(Free)
        }
    })
}

fn start_of_joint(given: &JointSpec, q: &mut [f64], v: &mut [f64]) {
    match given {
        JointSpec::Fixed {} => {}
        JointSpec::Hinge(AxisJointSpec { position, velocity, .. })
        | JointSpec::Slider(AxisJointSpec { position, velocity, .. }) => {
            (q[0], v[0]) = (*position, *velocity)
        }
        JointSpec::Ball { orientation, angular_velocity } => {
            q[..4].copy_from_slice(orientation);
            v[..3].copy_from_slice(angular_velocity);
        }
        JointSpec::Point { position, velocity } => {
            q[..3].copy_from_slice(position);
            v[..3].copy_from_slice(velocity);
        }
        JointSpec::Free { position, orientation, velocity, angular_velocity } => {
            q[..3].copy_from_slice(position);
            q[3..7].copy_from_slice(orientation);
            v[..3].copy_from_slice(velocity);
            v[3..6].copy_from_slice(angular_velocity);
        }
    }
}

fn build_drives(spec: &SystemSpec, tree: &Tree) -> Result<Vec<DriveJoint>, BuildError> {
    let mut drives = Vec::with_capacity(spec.drives.len());
    for drive in &spec.drives {
        let wanted = |given: &BodySpec| match &given.joint {
            JointSpec::Hinge(joint) | JointSpec::Slider(joint) => joint.drive.as_ref() == Some(&drive.name),
            _ => false,
        };
        let Some(body) = spec.bodies.iter().position(wanted) else {
            return error(&drive.name, "no hinge or slider names this drive");
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
        drives.push(DriveJoint { name: drive.name.clone(), body, dof: tree.bodies[body].first_velocity });
    }
    for given in &spec.bodies {
        if let JointSpec::Hinge(AxisJointSpec { drive: Some(name), .. })
        | JointSpec::Slider(AxisJointSpec { drive: Some(name), .. }) = &given.joint
            && !drives.iter().any(|drive| &drive.name == name)
        {
            return error(&given.name, format!("there is no drive `{name}`"));
        }
    }
    Ok(drives)
}

fn body_index(element: &str, tree: &Tree, name: Option<&String>) -> Result<Option<usize>, BuildError> {
    let Some(name) = name else { return Ok(None) };
    match tree.bodies.iter().position(|body| &body.name == name) {
        Some(index) => Ok(Some(index)),
        None => error(element, format!("there is no body `{name}`")),
    }
}

fn build_constraints(
    spec: &SystemSpec,
    tree: &Tree,
) -> Result<(Vec<AnyConstraint>, Vec<ContactGroup>), BuildError> {
    let mut constraints = Vec::with_capacity(spec.ropes.len() + spec.contacts.len());
    for given in &spec.ropes {
        constraints.push(AnyConstraint::Rope(build_rope(given, tree)?));
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

fn build_rope(given: &RopeSpec, tree: &Tree) -> Result<Rope, BuildError> {
    let name = &given.name;
    positive(name, "its length", given.length)?;
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
        });
    }
    let ends = [guides.first(), guides.last()];
    if guides.len() < 2 || !ends.iter().all(|guide| matches!(guide, Some(Guide::End(_)))) {
        return error(name, "its route must start and finish with an end");
    }
    let material = match given.material {
        MaterialSpec::Inextensible {} => Material::INEXTENSIBLE,
        MaterialSpec::Elastic { axial_stiffness, damping_time } => {
            positive(name, "its axial stiffness", axial_stiffness)?;
            at_least_zero(name, "its damping time", damping_time)?;
            Material::elastic(axial_stiffness, given.length, damping_time)
        }
    };
    Ok(Rope::new(name.clone(), Route::new(guides), given.length, material, tree))
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

fn build_step(given: &StepSpec, drives: &[DriveJoint], groups: &[ContactGroup]) -> Result<Step, BuildError> {
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
        moves.push(Move { drive, velocity, acceleration, shape });
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

/// The state at t = 0: forces by their laws, ledger opened, inertia scales set.
fn first_state(
    spec: &SystemSpec,
    system: &mut System,
    q: Vec<f64>,
    v: Vec<f64>,
) -> Result<State, BuildError> {
    let rows = system.rows.count();
    let timelines = system.drives.iter().zip(&spec.drives).map(|(drive, given)| {
        let start = q[system.tree.bodies[drive.body].first_position];
        let mut timeline = Timeline::new(start, given.ramps.len() + 2 * spec.plan.len());
        for ramp in &given.ramps {
            timeline.ramp(ramp.at, ramp.duration, ramp.velocity, ramp.shape);
        }
        timeline
    });
    let plan = PlanState::new(timelines.collect());
    let mut state = State {
        time: 0.0,
        steps: 0,
        acceleration: vec![0.0; v.len()],
        bias: vec![0.0; v.len()],
        q,
        v,
        tension: vec![0.0; rows],
        trial: vec![0.0; rows],
        modes: vec![Mode::Slack; rows],
        memory: vec![0.0; rows],
        slip: vec![0.0; rows],
        next_step: 0.0,
        restart: true,
        engaged: false,
        engaged_step: f64::MAX,
        plan,
        ledger: Ledger::default(),
    };
    let mut frame = Frame::new(system);
    frame.update(system, &state);
    // Contacts start with their anchors below them: without deflection.
    for (row, law) in system.rows.laws.iter().enumerate() {
        if matches!(law, Law::Friction { .. }) {
            state.memory[row] = frame.value[row];
        }
    }
    frame.update(system, &state);
    for dof in 0..system.tree.velocities {
        let inertia = frame.mass.diagonal(dof);
        if system.driven[dof].is_none() && inertia <= 0.0 {
            let name = system.tree.bodies[system.tree.owner[dof]].name.clone();
            return error(
                &name,
                "it has no inertia in a direction that it can move: give it mass or inertia",
            );
        }
        system.tree.inertia_scale[dof] = if inertia > 0.0 { inertia } else { 1.0 };
    }
    for (row, law) in system.rows.laws.iter().enumerate() {
        let (compliance, damping_time) = match *law {
            Law::Unilateral { compliance, damping_time } => (compliance, damping_time),
            Law::Friction { normal, .. } => {
                state.modes[row] = state.modes[normal];
                continue;
            }
        };
        let e = frame.value[row];
        if compliance > 0.0 {
            let rate = system.rows.rate(&frame.gradient, row, &state.v);
            state.trial[row] = (e + damping_time * rate) / compliance;
            state.tension[row] = state.trial[row].max(0.0);
        } else if e > 1e-9 * (1.0 + e.abs()) {
            let name = system.constraint_of_row(row).name().to_owned();
            return error(&name, format!("it is inextensible and {e} m shorter than its route at the start"));
        }
        // A row at its bound starts as acting, so that a lift that starts taut logs no event for it.
        if state.trial[row] > 0.0 || (compliance == 0.0 && e >= -1e-9) {
            state.modes[row] = Mode::Acting;
        }
    }
    let kinetic = 0.5 * frame.mass.quadratic(&state.v);
    let gravity = gravity_energy(system, &frame.kinematics);
    state.ledger =
        Ledger::open(kinetic, gravity, elastic_energy(system, &frame.value, &state.modes, &state.tension));
    Ok(state)
}
