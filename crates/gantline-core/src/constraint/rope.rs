//! Length of a rope: g = Σ parts + Σ arcs − L (paper eqs. 16, 19, 20).
//!
//! With n the unit direction of a part from A to B, ġ = Σ n·(v_B − v_A): each part adds n·(J_B − J_A), the
//! sum of eqs. (18) and (22). A degree of freedom that moves A and B as one rigid whole cannot change
//! |B − A| and is left out of the pattern: so the sheaves of an equalizer do not couple to what carries
//! the whole of it.

use glam::DVec3;

use super::{Constraint, Law, Line};
use crate::rope::material::Material;
use crate::rope::route::{Attachment, Part, Route, Straight, unit};
use crate::rope::tangency::Circle;
use crate::tree::Tree;
use crate::tree::bias::Wrench;
use crate::tree::joint::{Column, Motion};
use crate::tree::kinematics::{Kinematics, Twist};

/// A degree of freedom that moves one end of a straight part and not the other: both together would cancel.
#[derive(Debug, Clone)]
struct Lever {
    /// Degree of freedom.
    dof: u32,
    /// Its entry of the row.
    entry: u32,
    /// The joint's body.
    body: u32,
    motion: Motion,
    /// True for the first rotation of its joint: there the moment is formed.
    opens: bool,
    /// True for the first lever of the rope with this entry: it sets it, later ones add.
    is_first: bool,
}

/// Levers of one straight part: those of its start, then those of its end.
#[derive(Debug, Clone, Copy)]
struct PartLevers {
    start: usize,
    split: usize,
    end: usize,
}

/// A rope as a constraint.
#[derive(Debug, Clone)]
pub struct Rope {
    /// Unique name.
    pub name: String,
    /// Its way.
    pub route: Route,
    /// Unstretched length L [m].
    pub length: f64,
    /// What it is made of.
    pub material: Material,
    dofs: Vec<usize>,
    levers: Vec<Lever>,
    parts: Vec<PartLevers>,
}

/// Step of central differences [m or rad].
const STEP: f64 = 1e-6;

/// A small motion of one degree of freedom.
struct Shift<'a> {
    tree: &'a Tree,
    kinematics: &'a Kinematics,
    dof: usize,
    step: f64,
}

impl Shift<'_> {
    /// A column and the origin of its joint's body as they are.
    fn still(tree: &Tree, kinematics: &Kinematics, dof: usize) -> (Column, DVec3) {
        (kinematics.columns[dof], kinematics.pose[tree.owner[dof]].position)
    }

    /// A circle on a body that the motion moves.
    fn circle(&self, circle: Circle) -> Circle {
        let column = self.kinematics.point_column(self.tree, self.dof, circle.centre);
        let turned = circle.axis + self.kinematics.columns[self.dof].angular.cross(circle.axis) * self.step;
        Circle { centre: circle.centre + column * self.step, axis: turned.normalize(), ..circle }
    }

    /// A column of the same chain, and the origin of its joint's body, after the motion: a degree of freedom above
    /// turns and shifts both, one of the same joint turns what is fixed in the body.
    fn column(&self, dof: usize) -> (Column, DVec3) {
        let (mut column, origin) = Self::still(self.tree, self.kinematics, dof);
        let (own, moved) = (self.tree.owner[dof], self.tree.owner[self.dof]);
        if moved > own {
            return (column, origin);
        }
        let turn = self.kinematics.columns[self.dof].angular * self.step;
        column.angular += turn.cross(column.angular);
        if moved < own {
            column.linear += turn.cross(column.linear);
        }
        let shift = self.kinematics.point_column(self.tree, self.dof, origin);
        (column, origin + shift * self.step)
    }
}

/// Members of `a` that `b` has not; both ascending.
fn without(a: &[usize], b: &[usize]) -> Vec<usize> {
    a.iter().copied().filter(|dof| b.binary_search(dof).is_err()).collect()
}

/// `direction`·J of a world point [m], and a couple [m], into the row's entries: l·n, a·((x − o)×n + c).
#[inline]
fn pull(
    kinematics: &Kinematics,
    levers: &[Lever],
    (point, direction, couple): (DVec3, DVec3, DVec3),
    gradient: &mut [f64],
) {
    let mut moment = DVec3::ZERO;
    for lever in levers {
        let column = &kinematics.columns[lever.dof as usize];
        let value = match lever.motion {
            Motion::Shift => column.linear.dot(direction),
            Motion::Turn => {
                if lever.opens {
                    let arm = point - kinematics.pose[lever.body as usize].position;
                    moment = arm.cross(direction) + couple;
                }
                column.angular.dot(moment)
            }
        };
        let entry = &mut gradient[lever.entry as usize];
        *entry = if lever.is_first { value } else { *entry + value };
    }
}

/// Arm [m], place [m] and velocity [m/s] of an end of a straight part.
// In the innermost loop of every method: a call would cost as much as the work.
#[inline(always)]
fn held((kinematics, twists): (&Kinematics, &[Twist]), attachment: &Attachment) -> (DVec3, DVec3, DVec3) {
    let Some(body) = attachment.body else { return (attachment.at, attachment.at, DVec3::ZERO) };
    let pose = &kinematics.pose[body];
    let arm = pose.rotation * attachment.at;
    (arm, pose.position + arm, twists[body].at(arm))
}

/// `sign` times the velocity of a world point [m] per lever, of which only the part across `direction` counts.
fn transversal(
    kinematics: &Kinematics,
    levers: &[Lever],
    point: DVec3,
    (direction, sign): (DVec3, f64),
    columns: &mut [DVec3],
) {
    for (out, lever) in columns.iter_mut().zip(levers) {
        let column = &kinematics.columns[lever.dof as usize];
        let velocity = match lever.motion {
            Motion::Shift => column.linear,
            Motion::Turn => column.angular.cross(point - kinematics.pose[lever.body as usize].position),
        };
        *out = (velocity - direction * direction.dot(velocity)) * sign;
    }
}

/// Adds the bending of the paths of one end, n·∂J_j/∂q_k: a rotation turns the columns of the joints below it
/// and, within its own joint, those of the other rotations. `columns` are the [`transversal`] ones, which a product
/// with n does not tell from the whole ones; the end's levers start at `first` in the block.
fn bend(
    kinematics: &Kinematics,
    levers: &[Lever],
    point: DVec3,
    (direction, sign): (DVec3, f64),
    (columns, first): (&[DVec3], usize),
    block: &mut [f64],
) {
    let size = columns.len();
    for (k, turn) in levers.iter().enumerate().filter(|(_, lever)| lever.motion == Motion::Turn) {
        let axis = kinematics.columns[turn.dof as usize].angular;
        let arm = point - kinematics.pose[turn.body as usize].position;
        for (j, lever) in levers.iter().enumerate() {
            let (j, k) = (first + j, first + k);
            if lever.body > turn.body {
                let value = axis.dot(columns[j].cross(direction));
                block[j * size + k] += value;
                block[k * size + j] += value;
            } else if lever.body == turn.body && lever.motion == Motion::Turn {
                let other = kinematics.columns[lever.dof as usize].angular;
                block[j * size + k] += sign * direction.dot(axis.cross(other.cross(arm)));
            }
        }
    }
}

/// Levers of both ends of every part; `dofs` are those of the row.
fn levers_of(
    ends: &[(Vec<usize>, Vec<usize>)],
    dofs: &[usize],
    tree: &Tree,
) -> (Vec<Lever>, Vec<PartLevers>) {
    let (mut levers, mut parts) = (Vec::new(), Vec::with_capacity(ends.len()));
    let mut seen = vec![false; dofs.len()];
    let mut add = |list: &[usize], levers: &mut Vec<Lever>| {
        let mut opened = None;
        for &dof in list {
            let entry = dofs.partition_point(|&other| other < dof);
            let (owner, motion) = (tree.owner[dof], tree.motions[dof]);
            let opens = motion == Motion::Turn && opened.replace(owner) != Some(owner);
            let is_first = !std::mem::replace(&mut seen[entry], true);
            let [dof, entry, body] = [dof, entry, owner].map(|index| index as u32);
            levers.push(Lever { dof, entry, body, motion, opens, is_first });
        }
    };
    for (from, to) in ends {
        let start = levers.len();
        add(from, &mut levers);
        let split = levers.len();
        add(to, &mut levers);
        parts.push(PartLevers { start, split, end: levers.len() });
    }
    (levers, parts)
}

impl Rope {
    /// A rope in `tree`.
    pub fn new(name: String, route: Route, length: f64, material: Material, tree: &Tree) -> Self {
        let ends: Vec<(Vec<usize>, Vec<usize>)> = route
            .parts
            .iter()
            .map(|part| {
                let (from, to) = (tree.support_of(part.from.at.body), tree.support_of(part.to.at.body));
                (without(from, to), without(to, from))
            })
            .collect();
        let mut dofs: Vec<usize> =
            ends.iter().flat_map(|(from, to)| from.iter().chain(to)).copied().collect();
        dofs.sort_unstable();
        dofs.dedup();
        let (levers, parts) = levers_of(&ends, &dofs, tree);
        Self { name, route, length, material, dofs, levers, parts }
    }

    /// Levers of the start and of the end of a straight part.
    fn ends(&self, part: PartLevers) -> (&[Lever], &[Lever]) {
        self.levers[part.start..part.end].split_at(part.split - part.start)
    }

    /// Where the straight parts lie now.
    pub fn straights<'a>(&'a self, kinematics: &'a Kinematics) -> impl Iterator<Item = Straight> + 'a {
        self.route.parts.iter().map(move |part| part.locate(kinematics))
    }

    /// Curvature of a part that ends on sheaves, where the points of tangency wander: central differences of the
    /// exact gradient over displaced circles and columns, right to about 1e-9.
    fn curvature_on_sheaves(&self, tree: &Tree, kinematics: &Kinematics, group: usize, block: &mut [f64]) {
        let part = &self.route.parts[group];
        let (from, to) = self.ends(self.parts[group]);
        let ends = [from, to];
        let size = ends[0].len() + ends[1].len();
        let moved = (0..2).flat_map(|end| ends[end].iter().map(move |lever| (end, lever.dof as usize)));
        for (k, (end, dof)) in moved.enumerate() {
            for (step, weight) in [(STEP, 0.5 / STEP), (-STEP, -0.5 / STEP)] {
                let shift = Shift { tree, kinematics, dof, step };
                let displaced =
                    part.tangent(
                        kinematics,
                        |index, circle| {
                            if index == end { shift.circle(circle) } else { circle }
                        },
                    );
                let Ok(straight) = displaced else { continue };
                let mut row = 0;
                for (index, point, pull) in
                    [(0, straight.from, -straight.pull), (1, straight.to, straight.pull)]
                {
                    for lever in ends[index] {
                        let own = lever.dof as usize;
                        let (column, origin) = if index == end {
                            shift.column(own)
                        } else {
                            Shift::still(tree, kinematics, own)
                        };
                        let moment = (point - origin).cross(pull) + straight.couple[index];
                        let entry = column.linear.dot(pull) + column.angular.dot(moment);
                        let value = &mut block[row * size + k];
                        *value = if step > 0.0 { weight * entry } else { *value + weight * entry };
                        row += 1;
                    }
                }
            }
        }
    }

    /// The part of the geometric stiffness of one straight part that is positive semidefinite by construction:
    /// fills `columns` with the transversal relative velocity c per degree of freedom of the group and returns
    /// the factor f of K = f Σ cᵢ·cⱼ, f = T/ℓ [N/m].
    pub fn geometric_stiffness(
        &self,
        kinematics: &Kinematics,
        tension: f64,
        group: usize,
        columns: &mut [DVec3],
    ) -> f64 {
        let straight = self.route.parts[group].locate(kinematics);
        self.transversals(kinematics, &straight, group, columns);
        if straight.length > 0.0 { tension / straight.length } else { 0.0 }
    }

    /// How every degree of freedom of a group moves the end of the straight part against its start, across it.
    fn transversals(
        &self,
        kinematics: &Kinematics,
        straight: &Straight,
        group: usize,
        columns: &mut [DVec3],
    ) {
        let (from, to) = self.ends(self.parts[group]);
        transversal(kinematics, from, straight.from, (straight.direction, -1.0), columns);
        transversal(kinematics, to, straight.to, (straight.direction, 1.0), &mut columns[from.len()..]);
    }
}

impl Constraint for Rope {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        vec![self.dofs.clone()]
    }

    fn laws(&self, _first_row: usize) -> Vec<Law> {
        let Material { compliance, damping_time } = self.material;
        vec![Law::Unilateral { compliance, damping_time }]
    }

    fn lines(&self) -> usize {
        self.route.parts.len()
    }

    fn locate(
        &self,
        motion: (&Kinematics, &[Twist]),
        value: &mut [f64],
        rate: &mut [f64],
        lines: &mut [Line],
    ) {
        if !self.route.is_plain {
            let (kinematics, twists) = motion;
            let origin =
                |body: Option<usize>| body.map_or(DVec3::ZERO, |body| kinematics.pose[body].position);
            let length = self.route.length(kinematics, |part, straight| {
                let Part { from, to } = &self.route.parts[part];
                let (from, to) = (straight.from - origin(from.at.body), straight.to - origin(to.at.body));
                lines[part] = Line { from, to, direction: straight.pull, couple: straight.couple };
            });
            value[0] = length - self.length;
            self.rates(twists, lines, rate);
            return;
        }
        let (mut length, mut speed) = (self.route.arcs, 0.0);
        for (part, line) in self.route.parts.iter().zip(lines) {
            let (from, start, start_velocity) = held(motion, &part.from.at);
            let (to, stop, stop_velocity) = held(motion, &part.to.at);
            let (direction, part_length) = unit(stop - start);
            length += part_length;
            speed += direction.dot(stop_velocity - start_velocity);
            *line = Line { from, to, direction, couple: [DVec3::ZERO; 2] };
        }
        value[0] = length - self.length;
        rate[0] = speed;
    }

    fn rates(&self, twists: &[Twist], lines: &[Line], rate: &mut [f64]) {
        let velocity = |body: Option<usize>, arm| body.map_or(DVec3::ZERO, |body| twists[body].at(arm));
        let turn = |body: Option<usize>| body.map_or(DVec3::ZERO, |body| twists[body].angular);
        let mut sum = 0.0;
        for (part, line) in self.route.parts.iter().zip(lines) {
            let (from, to) = (part.from.at.body, part.to.at.body);
            sum += line.direction.dot(velocity(to, line.to) - velocity(from, line.from));
            if !self.route.is_plain {
                sum += line.couple[0].dot(turn(from)) + line.couple[1].dot(turn(to));
            }
        }
        rate[0] = sum;
    }

    fn apply(&self, tension: &[f64], lines: &[Line], wrenches: &mut [Wrench]) {
        for (part, line) in self.route.parts.iter().zip(lines) {
            let pull = line.direction * tension[0];
            if let Some(body) = part.from.at.body {
                wrenches[body].add(-pull, line.from);
                wrenches[body].moment += line.couple[0] * tension[0];
            }
            if let Some(body) = part.to.at.body {
                wrenches[body].add(pull, line.to);
                wrenches[body].moment += line.couple[1] * tension[0];
            }
        }
    }

    fn evaluate(&self, _tree: &Tree, kinematics: &Kinematics, value: &mut [f64], gradient: &mut [f64]) {
        let length = self.route.length(kinematics, |part, straight| {
            let (from, to) = self.ends(self.parts[part]);
            let [start, end] = straight.couple;
            pull(kinematics, from, (straight.from, -straight.pull, start), gradient);
            pull(kinematics, to, (straight.to, straight.pull, end), gradient);
        });
        value[0] = length - self.length;
    }

    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)> {
        let dof = |lever: &Lever| lever.dof as usize;
        self.parts
            .iter()
            .map(|part| (0, self.levers[part.start..part.end].iter().map(dof).collect()))
            .collect()
    }

    /// ∂G_j/∂q_k = c_j·c_k/ℓ + n·(∂J_j/∂q_k of the end − of the start): the part turns, and its ends move on
    /// curves.
    fn curvature(
        &self,
        tree: &Tree,
        kinematics: &Kinematics,
        group: usize,
        columns: &mut [DVec3],
        block: &mut [f64],
    ) {
        if !self.route.parts[group].is_plain() {
            self.curvature_on_sheaves(tree, kinematics, group, block);
            return;
        }
        let straight = self.route.parts[group].locate(kinematics);
        let (from, to) = self.ends(self.parts[group]);
        let (split, size) = (from.len(), from.len() + to.len());
        let columns = &mut columns[..size];
        self.transversals(kinematics, &straight, group, columns);
        let inverse = if straight.length > 0.0 { 1.0 / straight.length } else { 0.0 };
        for (j, column) in columns.iter().enumerate() {
            let column = *column * inverse;
            for (k, other) in columns[..=j].iter().enumerate() {
                let value = column.dot(*other);
                block[j * size + k] = value;
                block[k * size + j] = value;
            }
        }
        bend(kinematics, from, straight.from, (straight.direction, -1.0), (columns, 0), block);
        bend(kinematics, to, straight.to, (straight.direction, 1.0), (columns, split), block);
    }
}
