//! What does not change during a run: the tree, the constraints and their rows, drives, plan.

use std::ops::Range;
use std::sync::Arc;

use crate::clock::Clock;
use crate::constraint::brake::Brake;
use crate::constraint::rope::Rope;
use crate::constraint::{AnyConstraint, Law};
use crate::contact::landing::Landing;
use crate::contact::pad::Pad;
use crate::contact::plane::Plane;
use crate::contact::shape::Shape;
use crate::contact::spot::Spot;
use crate::event::afloat::{Mark, Vessel};
use crate::force;
use crate::force::mooring::Mooring;
use crate::force::trains::Trains;
use crate::plan::drive::Timeline;
use crate::plan::{Cut, Plan, Removal, Switching};
use crate::rope::coil::Layers;
use crate::tree::Tree;
use crate::tree::joint::Joint;
use crate::tree::kinematics::Kinematics;

/// What lines pull with that hold what floats, of its weight.
const HELD_AFLOAT: f64 = 1e-2;

/// Rows of all constraints, one after another, with a static sparsity pattern.
#[derive(Debug, Clone, Default)]
pub struct Rows {
    /// First row of every constraint, and the number of rows at the end.
    pub first: Vec<usize>,
    /// Start of every row's entries in `dofs` and in gradients.
    pub start: Vec<usize>,
    /// First line of force of every constraint, and the number of lines at the end.
    pub lines: Vec<usize>,
    /// Degree of freedom of every entry.
    pub dofs: Vec<usize>,
    /// Law of every row.
    pub laws: Vec<Law>,
}

impl Rows {
    /// Rows of `constraints`.
    pub fn new(constraints: &[AnyConstraint]) -> Self {
        let mut rows = Self { first: vec![0], start: vec![0], lines: vec![0], ..Self::default() };
        for constraint in constraints {
            rows.laws.extend(constraint.laws(rows.laws.len()));
            for dofs in constraint.row_dofs() {
                rows.dofs.extend(dofs);
                rows.start.push(rows.dofs.len());
            }
            rows.first.push(rows.laws.len());
            rows.lines.push(rows.lines[rows.lines.len() - 1] + constraint.lines());
        }
        rows
    }

    /// Number of rows.
    pub fn count(&self) -> usize {
        self.laws.len()
    }

    /// Degrees of freedom and gradient entries of a row.
    pub fn entries<'a>(&'a self, gradient: &'a [f64], row: usize) -> impl Iterator<Item = (usize, f64)> + 'a {
        let range = self.start[row]..self.start[row + 1];
        self.dofs[range.clone()].iter().copied().zip(gradient[range].iter().copied())
    }

    /// ġ of a row under the velocities `v`.
    pub fn rate(&self, gradient: &[f64], row: usize, v: &[f64]) -> f64 {
        self.entries(gradient, row).map(|(dof, entry)| entry * v[dof]).sum()
    }
}

/// The prescribed motion of a joint.
#[derive(Debug, Clone)]
pub struct DriveJoint {
    /// Name of the drive.
    pub name: String,
    /// Index of the body whose joint it drives.
    pub body: usize,
    /// Degree of freedom.
    pub dof: usize,
    /// True for a motor of limited force, which a brake between it and its flow stands for.
    pub is_limited: bool,
    /// True for one of these that hauls as long as its rope pulls less.
    pub keeps_pull: bool,
    /// True where waves move it, or liquid that runs through holes of a tank by itself.
    pub by_fluid: bool,
    /// Whether it may move otherwise than by polynomials in time: waves do, and so does a way that several go together.
    pub curved: bool,
}

/// Contacts that carry one load together.
#[derive(Debug, Clone)]
pub struct ContactGroup {
    /// Name, usually the load's.
    pub name: String,
    /// The body of that name; of another name there is none, and contacts bear their first bodies.
    pub body: Option<usize>,
    /// Indices of the constraints.
    pub contacts: Vec<usize>,
}

impl ContactGroup {
    /// Number of the group of that name, which is added where it is not there yet.
    pub fn named(groups: &mut Vec<Self>, name: &str, tree: &Tree) -> usize {
        groups.iter().position(|group| group.name == name).unwrap_or_else(|| {
            let body = tree.bodies.iter().position(|body| body.name == name);
            groups.push(Self { name: name.to_owned(), body, contacts: Vec::new() });
            groups.len() - 1
        })
    }
}

/// A shape on a body.
#[derive(Debug, Clone)]
pub struct BodyShape {
    /// Name.
    pub name: String,
    /// Index of its body; none is the world.
    pub body: Option<usize>,
    /// The shape, in the body's frame.
    pub shape: Shape,
}

/// What finds the spots of touches anew as bodies move. A touch is named by the index of its constraint.
#[derive(Debug, Clone)]
pub enum Finder {
    /// The top of a support, and its touch.
    Pad(usize, Box<Pad>),
    /// A rim's touch, and the plane of the world that it may lie on.
    Rim(usize, Plane),
    /// Two shapes, by their numbers, and the first of so many touches that are reserved for where they meet.
    Pair {
        /// Numbers of the shapes; the first may be near the second.
        shapes: [usize; 2],
        /// The first touch.
        first: usize,
        /// How many there are.
        count: usize,
    },
    /// A landing guide, and the first of the touches that are reserved for it.
    Landing(usize, Box<Landing>),
}

impl Finder {
    /// Its touch, or the first.
    pub fn touch(&self) -> usize {
        match self {
            Self::Pad(touch, _) | Self::Rim(touch, _) | Self::Landing(touch, _) => *touch,
            Self::Pair { first, .. } => *first,
        }
    }
}

/// What distances are measured from: shapes and straight parts of ropes.
#[derive(Debug, Clone, Default)]
pub struct Watched {
    /// Numbers of the shapes.
    pub shapes: Vec<usize>,
    /// Ropes.
    pub ropes: Vec<WatchedRope>,
}

/// A rope whose distance is watched.
#[derive(Debug, Clone, Copy)]
pub struct WatchedRope {
    /// Its index.
    pub rope: usize,
    /// Half its diameter [m].
    pub radius: f64,
    /// What is left out at its two ends [m].
    pub without: [f64; 2],
}

/// A pair whose smallest distance is recorded.
#[derive(Debug, Clone)]
pub struct Watch {
    /// Name.
    pub name: String,
    /// Between what.
    pub between: [Watched; 2],
}

/// Where a sheave with true tangents is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SheavePlace {
    /// Index of the rope.
    pub rope: usize,
    /// Index of the guide in its route.
    pub guide: usize,
    /// True where the rope may leave it.
    pub may_lift_off: bool,
}

/// A drum's end of a rope.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoilPlace {
    /// Index of the rope.
    pub rope: usize,
    /// Index of its span there.
    pub span: usize,
    /// Row of the span.
    pub row: usize,
    /// Degree of freedom of the drum's flow.
    pub dof: usize,
    /// Its coordinate in q.
    pub position: usize,
    /// Where q has the unstretched rope that the drum has let go [m].
    pub supply: usize,
    /// Entry of the flow in the gradients of all rows.
    pub entry: usize,
    /// Rope let go per unit of the flow in the first layer.
    pub rate: f64,
    /// EA of the rope [N].
    pub stiffness: f64,
    /// Tension with which the rope on it was wound before the start [N]; none is that of the start.
    pub laid_under: Option<f64>,
    /// Layers, where it has them.
    pub layers: Option<Layers>,
}

impl CoilPlace {
    fn turned(&self, q: &[f64]) -> f64 {
        -self.rate * q[self.position]
    }

    /// Rope wound up since the start, as long as it lies there [m].
    pub fn wound(&self, q: &[f64]) -> f64 {
        let turned = self.turned(q);
        self.layers.map_or(turned, |layers| layers.wound(turned))
    }

    /// Wound rope let go per unit of the flow.
    pub fn rate_at(&self, q: &[f64]) -> f64 {
        self.rate * self.layers.map_or(1.0, |layers| layers.ratio(self.turned(q)))
    }

    /// How that changes with the coordinate of the flow [1/m].
    pub fn rate_slope(&self, q: &[f64]) -> f64 {
        self.layers.map_or(0.0, |layers| -self.rate * self.rate * layers.slope(self.turned(q)))
    }
}

/// Light sheaves next to each other on one rope: what passes them follows from lengths, see [`crate::rope::light`].
#[derive(Debug, Clone, Default, PartialEq)]
pub struct LightSheaves {
    /// Index of the rope.
    pub rope: usize,
    /// Rows of the spans before, between and after them.
    pub rows: Range<usize>,
    /// ρ of every sheave.
    pub ratio: Vec<f64>,
    /// Degree of freedom of every sheave's flow.
    pub dofs: Vec<usize>,
    /// Its coordinate in q.
    pub positions: Vec<usize>,
    /// The row of its losses: only its mode counts.
    pub brakes: Vec<usize>,
}

/// Ropes that take over length from each other after every step.
#[derive(Debug, Clone, PartialEq)]
pub struct Adjuster {
    /// Name.
    pub name: String,
    /// Rows of the ropes.
    pub rows: Vec<usize>,
    /// Share of a tension's distance from the mean that one step lets go.
    pub factor: f64,
}

/// A system, built and checked.
#[derive(Debug, Clone)]
pub struct System {
    /// Bodies and joints.
    pub tree: Tree,
    /// Ropes first, contacts and touches after them, then stops, then pins, then brakes.
    pub constraints: Vec<AnyConstraint>,
    /// How many of the constraints are ropes.
    pub rope_count: usize,
    /// Rows of the constraints.
    pub rows: Rows,
    /// Sheaves with true tangents, in the order of ropes and routes.
    pub sheaves: Vec<SheavePlace>,
    /// Ropes that break, and the tension at which they do [N]. Mooring lines know it themselves.
    pub fragile: Vec<(usize, f64)>,
    /// Ropes that are cut.
    pub cuts: Vec<Cut>,
    /// Ropes that steps of the plan put on or take off.
    pub slings: Vec<Switching>,
    /// Locking pins.
    pub pins: Vec<Switching>,
    /// Rows of inextensible ropes.
    pub inextensible: Vec<usize>,
    /// Those and the rows of pins and brakes: rows without compliance, whose force is an unknown of its own.
    pub rigid: Vec<usize>,
    /// Tangential rows of contacts.
    pub friction: Vec<usize>,
    /// Constraints that act on degrees of freedom by themselves: with flows, stops, pins and brakes.
    pub fed: Vec<usize>,
    /// First constraint that is a brake; brakes come last, and each has one row.
    pub first_brake: usize,
    /// First brake of a light sheave; these come last among brakes. Of them only the modes count: they exert no force.
    pub first_light: usize,
    /// Rows of the brakes of motors, and their drives.
    pub motors: Vec<(usize, usize)>,
    /// Degrees of freedom of flows.
    pub flows: Vec<usize>,
    /// Drums' ends of ropes.
    pub coils: Vec<CoilPlace>,
    /// Light sheaves.
    pub light: Vec<LightSheaves>,
    /// For every degree of freedom whether it is the flow of one of them.
    pub is_light: Vec<bool>,
    /// Groups of ropes whose lengths are adjusted.
    pub adjusters: Vec<Adjuster>,
    /// Prescribed joints.
    pub drives: Vec<DriveJoint>,
    /// For every degree of freedom the drive that prescribes it.
    pub driven: Vec<Option<usize>>,
    /// Groups of contacts.
    pub groups: Vec<ContactGroup>,
    /// Shapes of bodies and of the world.
    pub shapes: Vec<BodyShape>,
    /// What finds where bodies may touch.
    pub finders: Vec<Finder>,
    /// Supports that are taken away.
    pub removals: Vec<Removal>,
    /// Distances that are recorded.
    pub watches: Vec<Watch>,
    /// For every group of ropes that pull together, or of pins, the indices of their constraints.
    pub pulls: Vec<Vec<usize>>,
    /// Waves on the water.
    pub sea: Arc<Trains>,
    /// What comes on top of the mean speed of the wind.
    pub gusts: Arc<Trains>,
    /// Bodies that should stay upright.
    pub vessels: Vec<Vessel>,
    /// Points of them that should stay above the water.
    pub marks: Vec<Mark>,
    /// Operations.
    pub plan: Plan,
    /// Where the time goes: the one thing here that changes, since all that takes time sees the system.
    pub clock: Clock,
}

impl System {
    /// The ropes, in the order of their rows: rope i is constraint i.
    pub fn ropes(&self) -> impl Iterator<Item = &Rope> {
        self.constraints.iter().filter_map(|constraint| match constraint {
            AnyConstraint::Rope(rope) => Some(rope),
            _ => None,
        })
    }

    /// What a contact bears of the weight of the body of its group, with these forces of its rows: their part upwards [N].
    pub fn lift_of(&self, contact: usize, kinematics: &Kinematics, spots: &[Spot], force: [f64; 3]) -> f64 {
        let (group, facing, spot) = match &self.constraints[contact] {
            AnyConstraint::Contact(contact) => (contact.group, &contact.facing, &contact.spot),
            AnyConstraint::Touch(touch) => (touch.group, &touch.facing, &spots[touch.spot]),
            _ => return 0.0,
        };
        let body = self.groups[group].body;
        let upwards = facing.force(kinematics, spot, force).1.z;
        if body.is_some() && facing.bodies[1] == body { -upwards } else { upwards }
    }

    /// Mooring lines. In recordings, cuts and events they count on from the ropes.
    pub fn moorings(&self) -> impl Iterator<Item = &Mooring> {
        force::moorings(&self.tree)
    }

    /// Ropes and mooring lines.
    pub fn all_ropes(&self) -> usize {
        self.rope_count + self.tree.marks
    }

    /// Name of a rope or mooring line.
    pub fn rope_name(&self, index: usize) -> &str {
        match index.checked_sub(self.rope_count) {
            None => self.constraints[index].name(),
            Some(line) => self.moorings().nth(line).map_or("", |line| &line.name),
        }
    }

    /// Name of a sheave with true tangents: its rope, and its number along the route.
    pub fn sheave_name(&self, seat: usize) -> String {
        let SheavePlace { rope, guide, .. } = self.sheaves[seat];
        format!("{}/sheave_{guide}", self.constraints[rope].name())
    }

    /// Drives that prescribe the motion of their joints, with their timelines.
    pub fn prescribed<'a>(
        &'a self,
        timelines: &'a [Timeline],
    ) -> impl Iterator<Item = (&'a DriveJoint, &'a Timeline)> {
        self.drives.iter().zip(timelines).filter(|(drive, _)| !drive.is_limited)
    }

    /// How many ropes there are where two that meet in a point without size count as one: pieces of a heavy rope.
    pub fn whole_ropes(&self) -> usize {
        let mut ends = vec![0; self.tree.bodies.len()];
        for rope in self.ropes() {
            let route = &rope.route.parts;
            let both = [route[0].from.at.body, route[route.len() - 1].to.at.body];
            both.into_iter().flatten().for_each(|body| ends[body] += 1);
        }
        let is_node =
            |body: &usize| matches!(self.tree.bodies[*body].joint, Joint::Point(_)) && ends[*body] == 2;
        self.rope_count - (0..ends.len()).filter(is_node).count()
    }

    /// What ropes bear, all together [N]: the weight of all that water does not bear. Where it bears all, lines hold vessels
    /// against wind, current and waves, by about a hundredth of what they weigh.
    pub fn weight_on_ropes(&self) -> f64 {
        let tree = &self.tree;
        let mut floats = vec![false; tree.bodies.len()];
        for buoyancy in tree.hulls() {
            tree.subtree[buoyancy.body].iter().for_each(|&body| floats[body] = true);
        }
        let mass = |all: bool| -> f64 {
            let bodies = tree.bodies.iter().zip(&floats).filter(|(_, floats)| all || !**floats);
            bodies.map(|(body, _)| body.mass).sum()
        };
        let hanging = mass(false);
        (if hanging > 0.0 { hanging } else { HELD_AFLOAT * mass(true) }) * tree.gravity.length()
    }

    /// How many rows the ropes have; they stand before those of contacts.
    pub fn rope_rows(&self) -> usize {
        self.rows.first[self.rope_count]
    }

    /// First row of the brakes; each has one, and they come last.
    pub fn first_brake_row(&self) -> usize {
        self.rows.first[self.first_brake]
    }

    /// First row of the brakes of light sheaves, which come last.
    pub fn first_light_row(&self) -> usize {
        self.rows.first[self.first_light]
    }

    /// The constraints that exert forces: all but the brakes of light sheaves.
    pub fn exerting(&self) -> &[AnyConstraint] {
        &self.constraints[..self.first_light]
    }

    /// Laws of their rows.
    pub fn exerting_laws(&self) -> &[Law] {
        &self.rows.laws[..self.first_light_row()]
    }

    /// The row of the normal force of every contact.
    pub fn normal_rows(&self) -> impl Iterator<Item = usize> {
        let rows = self.constraints.iter().zip(&self.rows.first);
        rows.filter_map(|(constraint, &row)| match constraint {
            AnyConstraint::Contact(_) | AnyConstraint::Touch(_) => Some(row),
            _ => None,
        })
    }

    /// Brakes with their rows.
    pub fn brakes(&self) -> impl Iterator<Item = (usize, &Brake)> {
        let rows = self.first_brake_row()..;
        rows.zip(&self.constraints[self.first_brake..]).filter_map(|(row, constraint)| match constraint {
            AnyConstraint::Brake(brake) => Some((row, brake)),
            _ => None,
        })
    }

    /// Those of them that exert forces.
    pub fn exerting_brakes(&self) -> impl Iterator<Item = (usize, &Brake)> {
        self.brakes().take_while(|(row, _)| *row < self.first_light_row())
    }

    /// The tension that the force of a row stands for [N]; those of rows of ropes differ where rope is fed or has a curve.
    pub fn rope_tension(&self, row: usize, force: f64, q: &[f64], kinematics: &Kinematics) -> f64 {
        let index = self.constraint_index(row);
        let AnyConstraint::Rope(rope) = &self.constraints[index] else { return force };
        rope.tension(row - self.rows.first[index], kinematics, q, force)
    }

    /// The force of a row [N], or where its rope has a curve the tension that it stands for.
    pub fn curved_tension(&self, row: usize, force: f64, kinematics: &Kinematics) -> f64 {
        match self.constraint_of_row(row) {
            AnyConstraint::Rope(rope) if rope.has_curve() => rope.tension(0, kinematics, &[], force),
            _ => force,
        }
    }

    /// Constraint that a row belongs to.
    pub fn constraint_of_row(&self, row: usize) -> &AnyConstraint {
        &self.constraints[self.constraint_index(row)]
    }

    /// Its index.
    pub fn constraint_index(&self, row: usize) -> usize {
        self.rows.first.partition_point(|&first| first <= row) - 1
    }
}
