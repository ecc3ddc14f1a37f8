//! Parts that end on sheaves with true tangents, where the points of tangency wander.

use glam::DVec3;

use super::Rope;
use crate::constraint::Placed;
use crate::rope::tangency::Circle;
use crate::tree::Tree;
use crate::tree::joint::Column;
use crate::tree::kinematics::Kinematics;

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

impl Rope {
    /// Curvature of a part that ends on sheaves, where the points of tangency wander: central differences of the
    /// exact gradient over displaced circles and columns, right to about 1e-9.
    pub(super) fn curvature_on_sheaves(&self, at: &Placed, group: usize, (block, size): (&mut [f64], usize)) {
        let Placed { tree, kinematics, .. } = *at;
        let part = self.part(group);
        let (from, to) = self.ends(self.parts[group]);
        let ends = [from, to];
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
}
