//! From a document to a checked [`System`] and its first [`State`].

mod adjusters;
mod brakes;
mod coils;
mod compensators;
mod conditions;
mod forces;
mod holes;
mod light;
mod memory;
mod moorings;
pub(crate) mod plan;
mod ropes;
mod rows;
mod start;
mod submerged;
mod touches;
mod trains;
mod tree;
mod vessels;

use glam::DVec3;
use thiserror::Error;

use crate::clock::Clock;
use crate::constraint::rope::Rope;
use crate::constraint::{AnyConstraint, Law};
use crate::rope::guide::Guide;
use crate::spec::{PullSpec, SystemSpec};
use crate::state::State;
use crate::stepper::spots::find;
use crate::system::{DriveJoint, LightSheaves, Rows, SheavePlace, System};
use crate::tree::Tree;
use crate::tree::joint::Joint;
use crate::tree::kinematics::Kinematics;
use adjusters::build_adjusters;
use coils::places_of_coils;
use forces::build_forces;
use light::rows_of_light;
use moorings::place_moorings;
use plan::{build_cuts, build_drives, build_fragile, build_pinnings, build_plan, build_slings};
use rows::{Built, build_constraints};
use start::first_state;
use touches::{Touches, build_shapes, build_watches};
use trains::build_trains;
use tree::{build_tree, start_of_joint};
use vessels::build_vessels;

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
    check_names(spec)?;
    let mut tree = build_tree(spec)?;
    let sea = build_trains("sea", spec.sea.as_ref())?;
    let gusts = build_trains("gusts", spec.gusts.as_ref())?;
    tree.forces = build_forces(spec, &tree, [&sea, &gusts])?;
    let drives = build_drives(spec, &tree)?;
    let driven = driven_by(&drives, &tree);
    let (mut q, v) = start_of_joints(spec, &tree, &driven);
    let mut start = Kinematics::new(&tree);
    start.update(&tree, &q, 0.0);
    let shapes = build_shapes(spec, &tree)?;
    let Built { constraints, groups, seats, touches } = build_constraints(spec, &tree, &start, &shapes)?;
    let Touches { finders, removals, mut spots } = touches;
    let watches = build_watches(spec, &shapes)?;
    let pulls = build_pulls(spec, &constraints)?;
    let (vessels, marks) = build_vessels(spec, &tree)?;
    let rows = Rows::new(&constraints);
    let coils = places_of_coils(spec, &tree, &constraints, &rows);
    let light = rows_of_light(&tree, &constraints, &rows);
    // What drums have let go and marks of mooring lines stand at the end of q.
    tree.supplies = coils.len();
    tree.positions += coils.len();
    place_moorings(spec, &mut tree, &start)?;
    q.resize(tree.positions, 0.0);
    let adjusters = build_adjusters(spec, &constraints, &rows)?;
    let plan = build_plan(spec, &tree, &drives, &groups, (&constraints, &rows))?;
    let (fragile, cuts) = (build_fragile(spec)?, build_cuts(spec)?);
    let slings = build_slings(spec, &constraints)?;
    let pins = build_pinnings(spec, &constraints)?;
    let is_brake = |constraint: &AnyConstraint| matches!(constraint, AnyConstraint::Brake(_));
    let first_brake = constraints.iter().position(is_brake).unwrap_or(constraints.len());
    let light_brakes = light.iter().map(|light| light.brakes.len()).sum::<usize>();
    let rigid = rigid_rows(&rows, &light);
    let is_rope_row = |row: &usize| matches!(rows.laws[*row], Law::Unilateral { .. });
    let mut system = System {
        rope_count: spec.ropes.len(),
        sheaves: places_of_sheaves(&constraints),
        inextensible: rigid.iter().copied().filter(is_rope_row).collect(),
        rigid,
        friction: rows_with(&rows, |law| matches!(law, Law::Friction { .. })),
        fed: (0..constraints.len()).filter(|&index| is_fed(&constraints[index])).collect(),
        first_brake,
        first_light: constraints.len() - light_brakes,
        motors: motors_of(&constraints[first_brake..], rows.first[first_brake], &drives),
        flows: flows_of(&tree),
        is_light: dofs_of_light(&light, &tree),
        tree,
        constraints,
        rows,
        fragile,
        cuts,
        slings,
        pins,
        coils,
        light,
        adjusters,
        drives,
        driven,
        groups,
        shapes,
        finders,
        removals,
        watches,
        pulls,
        sea,
        gusts,
        vessels,
        marks,
        plan,
        clock: Clock::default(),
    };
    find(&system, &start, &mut spots, 0.0, |_| false, |_, _, _| {});
    let state = first_state(spec, &mut system, (q, v), (seats, spots))?;
    Ok((system, state))
}

/// Of every pull the numbers of its ropes, which are the first constraints, or of its pins.
fn build_pulls(spec: &SystemSpec, constraints: &[AnyConstraint]) -> Result<Vec<Vec<usize>>, BuildError> {
    let number = |pull: &PullSpec, (kind, wanted): (&str, &String)| {
        let found = constraints.iter().position(|one| match one {
            AnyConstraint::Rope(rope) => kind == "rope" && rope.name == *wanted,
            AnyConstraint::Pin(pin) => kind == "pin" && pin.name == *wanted,
            _ => false,
        });
        found.map_or_else(|| error(&pull.name, format!("there is no {kind} `{wanted}`")), Ok)
    };
    let members = |pull: &PullSpec| {
        let ropes = pull.ropes.iter().map(|rope| ("rope", rope));
        ropes.chain(pull.pins.iter().map(|pin| ("pin", pin))).map(|one| number(pull, one)).collect()
    };
    spec.pulls.iter().map(members).collect()
}

/// For each degree of freedom the drive that says its motion; motors of some capacity leave theirs free.
fn driven_by(drives: &[DriveJoint], tree: &Tree) -> Vec<Option<usize>> {
    let mut driven = vec![None; tree.velocities];
    for (index, drive) in drives.iter().enumerate().filter(|(_, drive)| !drive.is_limited) {
        driven[drive.dof] = Some(index);
    }
    driven
}

/// Coordinates and velocities as the document has them; what is driven starts at rest.
fn start_of_joints(spec: &SystemSpec, tree: &Tree, driven: &[Option<usize>]) -> (Vec<f64>, Vec<f64>) {
    let (mut q, mut v) = (vec![0.0; tree.positions], vec![0.0; tree.velocities]);
    for (body, given) in tree.bodies.iter().zip(&spec.bodies) {
        start_of_joint(&given.joint, &mut q[body.first_position..], &mut v[body.first_velocity..]);
    }
    for (speed, _) in v.iter_mut().zip(driven).filter(|(_, drive)| drive.is_some()) {
        *speed = 0.0;
    }
    (q, v)
}

/// Rows whose law is of a kind.
fn rows_with(rows: &Rows, is_of_kind: impl Fn(&Law) -> bool) -> Vec<usize> {
    (0..rows.count()).filter(|&row| is_of_kind(&rows.laws[row])).collect()
}

/// Rows without compliance, but those of light sheaves' brakes.
fn rigid_rows(rows: &Rows, light: &[LightSheaves]) -> Vec<usize> {
    let mut rigid = rows_with(rows, |law| law.compliance() == 0.0);
    rigid.retain(|row| !light.iter().any(|light| light.brakes.contains(row)));
    rigid
}

/// Degrees of freedom of flows, in order.
fn flows_of(tree: &Tree) -> Vec<usize> {
    let is_flow = |dof: &usize| matches!(tree.bodies[tree.owner[*dof]].joint, Joint::Flow(_));
    (0..tree.velocities).filter(is_flow).collect()
}

/// For each degree of freedom whether it is the flow of a light sheave.
fn dofs_of_light(light: &[LightSheaves], tree: &Tree) -> Vec<bool> {
    let mut is_light = vec![false; tree.velocities];
    light.iter().flat_map(|light| &light.dofs).for_each(|&dof| is_light[dof] = true);
    is_light
}

/// True where a constraint acts on degrees of freedom by themselves, see [`System::fed`].
fn is_fed(constraint: &AnyConstraint) -> bool {
    match constraint {
        AnyConstraint::Rope(rope) => rope.spans.iter().any(|span| !span.feeds.is_empty()),
        AnyConstraint::Stop(_) | AnyConstraint::Pin(_) | AnyConstraint::Brake(_) => true,
        AnyConstraint::Contact(_) | AnyConstraint::Touch(_) => false,
    }
}

/// Rows of the brakes that are motors, and their drives; each brake has one row.
fn motors_of(brakes: &[AnyConstraint], first_row: usize, drives: &[DriveJoint]) -> Vec<(usize, usize)> {
    let motors = brakes.iter().zip(first_row..).filter_map(|(brake, row)| {
        let AnyConstraint::Brake(brake) = brake else { return None };
        Some((row, drives.iter().position(|drive| drive.dof == brake.dof)?))
    });
    motors.collect()
}

fn places_of_sheaves(constraints: &[AnyConstraint]) -> Vec<SheavePlace> {
    let mut places = Vec::new();
    for (rope, constraint) in constraints.iter().enumerate() {
        let AnyConstraint::Rope(Rope { route, .. }) = constraint else { continue };
        places.extend(route.guides.iter().enumerate().filter_map(|(guide, given)| match *given {
            Guide::Sheave { may_lift_off, .. } => Some(SheavePlace { rope, guide, may_lift_off }),
            _ => None,
        }));
    }
    places
}

/// Every name once among those of its kind.
fn check_names(spec: &SystemSpec) -> Result<(), BuildError> {
    unique("body", spec.bodies.iter().map(|body| body.name.as_str()))?;
    let ropes = spec.ropes.iter().map(|rope| rope.name.as_str());
    unique("adjuster", spec.adjusters.iter().map(|adjuster| adjuster.name.as_str()))?;
    let contacts = spec.contacts.iter().map(|contact| contact.name.as_str());
    let supports = spec.supports.iter().map(|support| support.name.as_str());
    let pairs = spec.pairs.iter().map(|pair| pair.name.as_str());
    let landings = spec.landings.iter().map(|landing| landing.name.as_str());
    unique("contact", contacts.chain(supports).chain(pairs).chain(landings))?;
    unique("shape", spec.shapes.iter().map(|shape| shape.name.as_str()))?;
    unique("watch", spec.watches.iter().map(|watch| watch.name.as_str()))?;
    unique("pull", spec.pulls.iter().map(|pull| pull.name.as_str()))?;
    unique("compensator", spec.compensators.iter().map(|one| one.name.as_str()))?;
    unique("drive", spec.drives.iter().map(|drive| drive.name.as_str()))?;
    unique("force", spec.forces.iter().map(|force| force.name()))?;
    unique("rope or line", ropes.chain(spec.moorings().map(|line| line.name.as_str())))
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
