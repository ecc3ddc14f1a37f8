//! A point of one body against a plane of another: three rows, across the plane and along its two tangents. Either body may
//! be the world, and which of them has the plane is said by a [`Spot`].
//!
//! With the point x of body P, the plane through o with normal n and tangents t₁, t₂ in body Q, each row is
//!
//! ```text
//! g = d·(x − o)        d = −n for the depth, t₁ and t₂ along the plane, fixed in Q
//! ġ = d·(ẋ_P − ẋ_Q)    the velocities that both bodies have at x: d turns with Q, and (ω×d)·(x − o) is what the
//!                      velocity of Q at x has beyond that at o
//! ∂G_j/∂q_k = d·(∂_k C_j^P − ∂_k C_j^Q) + (a_k^Q × d)·(C_j^P − C_j^Q)
//! ∂_k C_j^Q = change of the column of a point of Q at x + a_j × (C_k^P − C_k^Q), since x moves with P
//! ```
//!
//! C_j is the column of degree of freedom j at x, a_j its angular part. Where edges cross, x also moves along the edge of P
//! and d turns with both edges ([`crate::contact::spot`]): with u_k the way of x along P and d_k the turn of d,
//!
//! ```text
//! ∂G_j/∂q_k = d·(∂_k C_j^P + a_j^P × u_k − ∂_k C_j^Q − a_j^Q × (C_k^P − C_k^Q + u_k)) + d_k·(C_j^P − C_j^Q)
//! ```
//!
//! The depth of a [`Rim`] is that of its lowest point of the moment, which runs round it as the body rolls: that row acts at an x of its
//! own, with the way u_k of that. Along the plane x is a point of the body, found anew between steps.

use glam::DVec3;

use super::{Line, Moving, Placed};
use crate::contact::rim::{Lowest, Rim};
use crate::contact::spot::{Located, Spot};
use crate::tree::Tree;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};

/// Two bodies that may touch at a spot.
#[derive(Debug, Clone)]
pub struct Facing {
    /// The two bodies; none is the world.
    pub bodies: [Option<usize>; 2],
    /// Degrees of freedom that move either body, ascending.
    pub dofs: Vec<usize>,
    /// For each of them whether it moves the first and the second body.
    moves: Vec<[bool; 2]>,
    /// Of a round first body the rim that lies on the plane of the second.
    pub rim: Option<Rim>,
}

/// The rows of a spot where its bodies are.
struct Pointed {
    /// The spot.
    at: Located,
    /// d of the three rows.
    directions: [DVec3; 3],
    /// 1 where the first body has the point, −1 where it has the plane.
    sign: f64,
    /// Where the rim is lowest.
    lowest: Option<Lowest>,
}

impl Pointed {
    /// x of a row.
    fn point(&self, row: usize) -> DVec3 {
        match self.lowest {
            Some(lowest) if row == 0 => lowest.point,
            _ => self.at.point,
        }
    }

    /// g of a row, without what the state remembers of it.
    fn value(&self, row: usize) -> f64 {
        match self.lowest {
            Some(lowest) if row == 0 => -lowest.gap,
            _ => self.directions[row].dot(self.at.offset),
        }
    }
}

impl Facing {
    /// Two bodies of `tree`.
    pub fn new(bodies: [Option<usize>; 2], tree: &Tree) -> Self {
        let support = |body: Option<usize>| body.map_or(&[][..], |body| &tree.support[body]);
        let [first, second] = bodies.map(support);
        let mut dofs = [first, second].concat();
        dofs.sort_unstable();
        dofs.dedup();
        let moves = dofs.iter().map(|dof| [first.contains(dof), second.contains(dof)]).collect();
        Self { bodies, dofs, moves, rim: None }
    }

    /// The same with a rim of the first body.
    pub fn on_rim(self, rim: Rim) -> Self {
        Self { rim: Some(rim), ..self }
    }

    /// The spot where the bodies are.
    fn pointed(&self, kinematics: &Kinematics, spot: &Spot) -> Pointed {
        let at = spot.between(self.bodies.map(|body| kinematics.pose_of(body)));
        let sign = if spot.is_swapped { -1.0 } else { 1.0 };
        let pose = kinematics.pose_of(self.bodies[0]);
        let lowest = self.rim.map(|rim| rim.lowest(pose, at.point - at.offset, at.normal));
        Pointed { at, directions: at.directions(), sign, lowest }
    }

    /// World direction of the normal, from the body with the plane to that with the point.
    pub fn normal(&self, kinematics: &Kinematics, spot: &Spot) -> DVec3 {
        self.pointed(kinematics, spot).at.normal
    }

    /// How the first body is displaced along the plane against the second where a spot's tangential rows have these
    /// values [m], world axes.
    pub fn displaced(&self, kinematics: &Kinematics, spot: &Spot, values: [f64; 2]) -> DVec3 {
        let Pointed { at: Located { tangents: [one, other], .. }, sign, .. } = self.pointed(kinematics, spot);
        (one * values[0] + other * values[1]) * sign
    }

    /// What the tangential rows of a spot have to remember so that the first body is displaced by that [m].
    pub fn remembered(&self, kinematics: &Kinematics, spot: &Spot, displaced: DVec3) -> [f64; 2] {
        let Pointed { at, sign, .. } = self.pointed(kinematics, spot);
        at.tangents.map(|tangent| tangent.dot(at.offset - displaced * sign))
    }

    /// The point at which it presses [m] and the force on the first body with these forces of its rows [N].
    pub fn force(&self, kinematics: &Kinematics, spot: &Spot, tension: [f64; 3]) -> (DVec3, DVec3) {
        let Pointed { at, directions, sign, .. } = self.pointed(kinematics, spot);
        let sum: DVec3 =
            directions.into_iter().zip(tension).map(|(direction, force)| direction * force).sum();
        (at.point, -sum * sign)
    }

    /// C_j^0 − C_j^1 at a world point of the entry of a degree of freedom.
    fn column(&self, tree: &Tree, kinematics: &Kinematics, entry: usize, point: DVec3) -> DVec3 {
        self.apart(entry, kinematics.point_column(tree, self.dofs[entry], point))
    }

    /// The same from C_j.
    fn apart(&self, entry: usize, column: DVec3) -> DVec3 {
        match self.moves[entry] {
            [true, false] => column,
            [false, true] => -column,
            // What moves both moves neither against the other.
            _ => DVec3::ZERO,
        }
    }

    /// Values and rates of the three rows, and where their forces act, as [`super::Constraint::locate`].
    pub fn locate(&self, at: &Moving, spot: &Spot, value: &mut [f64], rate: &mut [f64], lines: &mut [Line]) {
        let pointed = self.pointed(at.kinematics, spot);
        let Pointed { directions, sign, .. } = pointed;
        for (row, direction) in directions.into_iter().enumerate() {
            let remembered = if row == 0 { 0.0 } else { value[row] };
            value[row] = pointed.value(row) - remembered;
            let point = pointed.point(row);
            let [from, to] =
                self.bodies.map(|body| body.map_or(point, |body| point - at.kinematics.pose[body].position));
            lines[row] = Line { from, to, direction: direction * sign, ..Line::default() };
        }
        self.rates(at.twists, lines, rate);
    }

    /// Rates of the three rows under these velocities of the bodies.
    pub fn rates(&self, twists: &[Twist], lines: &[Line], rate: &mut [f64]) {
        let at = |body: Option<usize>, arm| body.map_or(DVec3::ZERO, |body| twists[body].at(arm));
        for (rate, line) in rate.iter_mut().zip(lines) {
            *rate = line.direction.dot(at(self.bodies[0], line.from) - at(self.bodies[1], line.to));
        }
    }

    /// Takes the forces of the rows from what the joints of the bodies have to transmit.
    pub fn apply(&self, tension: &[f64], lines: &[Line], wrenches: &mut [Wrench]) {
        let [first, second] = self.bodies;
        let mut add = |lines: &[Line], tension: &[f64]| {
            let needed: DVec3 =
                lines.iter().zip(tension).map(|(line, tension)| line.direction * *tension).sum();
            if let Some(body) = first {
                wrenches[body].add(needed, lines[0].from);
            }
            if let Some(body) = second {
                wrenches[body].add(-needed, lines[0].to);
            }
        };
        if self.rim.is_none() {
            return add(lines, tension);
        }
        add(&lines[..1], &tension[..1]);
        add(&lines[1..], &tension[1..]);
    }

    /// Values and gradients of the three rows, as [`super::Constraint::evaluate`].
    pub fn evaluate(&self, at: &Placed, spot: &Spot, value: &mut [f64], gradient: &mut [f64]) {
        let Placed { tree, kinematics, .. } = *at;
        let pointed = self.pointed(kinematics, spot);
        let Pointed { directions, sign, lowest, .. } = pointed;
        let count = self.dofs.len();
        for (row, value) in value.iter_mut().enumerate() {
            let remembered = if row == 0 { 0.0 } else { *value };
            *value = pointed.value(row) - remembered;
        }
        for entry in 0..count {
            let column = |point| self.column(tree, kinematics, entry, point) * sign;
            let along = column(pointed.at.point);
            let across = lowest.map_or(along, |lowest| column(lowest.point));
            for (row, (direction, column)) in directions.into_iter().zip([across, along, along]).enumerate() {
                gradient[row * count + entry] = direction.dot(column);
            }
        }
    }

    /// Derivative of the gradient of the row `group`, as [`super::Constraint::curvature`].
    pub fn curvature(
        &self,
        at: &Placed,
        spot: &Spot,
        group: usize,
        columns: &mut [DVec3],
        block: &mut [f64],
    ) {
        let Placed { tree, kinematics, .. } = *at;
        let pointed = self.pointed(kinematics, spot);
        let Pointed { at: located, directions, sign, lowest } = pointed;
        let (point, direction) = (pointed.point(group), directions[group]);
        let (with_point, with_plane) = if spot.is_swapped { (1, 0) } else { (0, 1) };
        for (column, &dof) in columns.iter_mut().zip(&self.dofs) {
            *column = kinematics.point_column(tree, dof, point);
        }
        let size = self.dofs.len();
        let turn = |entry: usize, body: usize| {
            if self.moves[entry][body] { kinematics.columns[self.dofs[entry]].angular } else { DVec3::ZERO }
        };
        for k in 0..size {
            let apart_k = self.apart(k, columns[k]) * sign;
            // How x moves along the body with the point, and how d turns.
            let turns = [with_point, with_plane].map(|body| turn(k, body));
            let (moves, turned) = match (lowest, located.crossed) {
                (Some(lowest), _) if group == 0 => (lowest.moves(turns), turns[1].cross(direction)),
                (None, Some(crossed)) => crossed.change(&located, apart_k, turns, group),
                _ => (DVec3::ZERO, turns[1].cross(direction)),
            };
            for j in 0..size {
                let change = |body: usize| {
                    let [by_j, by_k] = [j, k].map(|entry| self.moves[entry][body]);
                    if !by_j || !by_k {
                        return DVec3::ZERO;
                    }
                    let [row, dof] = [j, k].map(|entry| (self.dofs[entry], columns[entry]));
                    kinematics.column_change(tree, row, dof, point)
                };
                let mut change = (change(0) - change(1)) * sign;
                change += turn(j, with_point).cross(moves) - turn(j, with_plane).cross(apart_k + moves);
                let apart_j = self.apart(j, columns[j]) * sign;
                block[j * size + k] = direction.dot(change) + turned.dot(apart_j);
            }
        }
    }
}
