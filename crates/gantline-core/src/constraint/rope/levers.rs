//! How degrees of freedom move the ends of a rope's straight parts.

use glam::DVec3;

use crate::tree::Tree;
use crate::tree::joint::Motion;
use crate::tree::kinematics::Kinematics;

/// A degree of freedom that moves one end of a straight part and not the other: both together would cancel.
#[derive(Debug, Clone)]
pub struct Lever {
    /// Degree of freedom.
    pub dof: u32,
    /// Its entry of the row.
    pub entry: u32,
    /// The joint's body.
    pub body: u32,
    pub motion: Motion,
    /// True for the first rotation of its joint: there the moment is formed.
    pub opens: bool,
    /// True for the first lever of the row with this entry: it sets it, later ones add.
    pub is_first: bool,
}

/// Levers of one straight part: those of its start, then those of its end.
#[derive(Debug, Clone, Copy)]
pub struct PartLevers {
    pub start: usize,
    pub split: usize,
    pub end: usize,
}

/// Degrees of freedom that move one end of a part and not the other.
pub type Ends = (Vec<usize>, Vec<usize>);

/// Members of `a` that `b` has not; both ascending.
pub fn without(a: &[usize], b: &[usize]) -> Vec<usize> {
    a.iter().copied().filter(|dof| b.binary_search(dof).is_err()).collect()
}

/// Adds the levers of both ends of the parts of one row, whose degrees of freedom are `dofs` and whose entries start
/// at `base`.
pub fn add_levers(
    ends: &[Ends],
    (dofs, base): (&[usize], usize),
    tree: &Tree,
    (levers, parts): (&mut Vec<Lever>, &mut Vec<PartLevers>),
) {
    let mut seen = vec![false; dofs.len()];
    let mut add = |list: &[usize], levers: &mut Vec<Lever>| {
        let mut opened = None;
        for &dof in list {
            let entry = dofs.partition_point(|&other| other < dof);
            let (owner, motion) = (tree.owner[dof], tree.motions[dof]);
            let opens = motion == Motion::Turn && opened.replace(owner) != Some(owner);
            let is_first = !std::mem::replace(&mut seen[entry], true);
            let [dof, entry, body] = [dof, base + entry, owner].map(|index| index as u32);
            levers.push(Lever { dof, entry, body, motion, opens, is_first });
        }
    };
    for (from, to) in ends {
        let start = levers.len();
        add(from, levers);
        let split = levers.len();
        add(to, levers);
        parts.push(PartLevers { start, split, end: levers.len() });
    }
}

/// `direction`·J of a world point [m], and a couple [m], per lever: l·n, a·((x − o)×n + c).
#[inline]
pub fn pulls(
    kinematics: &Kinematics,
    levers: &[Lever],
    (point, direction, couple): (DVec3, DVec3, DVec3),
    mut each: impl FnMut(&Lever, f64),
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
        each(lever, value);
    }
}

/// The same into the row's entries.
#[inline]
pub fn pull(kinematics: &Kinematics, levers: &[Lever], end: (DVec3, DVec3, DVec3), gradient: &mut [f64]) {
    pulls(kinematics, levers, end, |lever, value| {
        let entry = &mut gradient[lever.entry as usize];
        *entry = if lever.is_first { value } else { *entry + value };
    });
}

/// `sign` times the velocity of a world point [m] per lever, of which only the part across `direction` counts.
pub fn transversal(
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
/// with n does not tell from the whole ones; the end's levers start at `first` in the block of `size` columns.
pub fn bend(
    kinematics: &Kinematics,
    levers: &[Lever],
    point: DVec3,
    (direction, sign): (DVec3, f64),
    (columns, first): (&[DVec3], usize),
    (block, size): (&mut [f64], usize),
) {
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
