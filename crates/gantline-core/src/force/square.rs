//! 6 × 6 matrices from motion to force, as 3 × 3 blocks.

use glam::{DMat3, DVec3};

use crate::tree::bias::Wrench;
use crate::tree::kinematics::Twist;

/// Force and moment per linear and angular motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Square {
    /// Force per linear motion.
    pub linear: DMat3,
    /// Force per angular motion.
    pub cross: DMat3,
    /// Moment per linear motion.
    pub back: DMat3,
    /// Moment per angular motion.
    pub angular: DMat3,
}

/// The matrix of a × (·).
pub fn skew(a: DVec3) -> DMat3 {
    DMat3::from_cols(DVec3::new(0.0, a.z, -a.y), DVec3::new(-a.z, 0.0, a.x), DVec3::new(a.y, -a.x, 0.0))
}

/// The matrix of a (b · ·).
pub fn outer(a: DVec3, b: DVec3) -> DMat3 {
    DMat3::from_cols(a * b.x, a * b.y, a * b.z)
}

impl Square {
    /// All zero.
    pub const ZERO: Self =
        Self { linear: DMat3::ZERO, cross: DMat3::ZERO, back: DMat3::ZERO, angular: DMat3::ZERO };

    /// From rows: force x, y, z, moment x, y, z over the same of the motion.
    pub fn from_rows(rows: &[[f64; 6]; 6]) -> Self {
        let part = |row: usize, column: usize| {
            let entry = |i: usize, j: usize| rows[row + i][column + j];
            DMat3::from_cols_array(&std::array::from_fn(|k| entry(k % 3, k / 3)))
        };
        Self { linear: part(0, 0), cross: part(0, 3), back: part(3, 0), angular: part(3, 3) }
    }

    /// The opposite way of [`Square::from_rows`].
    pub fn rows(&self) -> [[f64; 6]; 6] {
        let parts = [[self.linear, self.cross], [self.back, self.angular]];
        std::array::from_fn(|i| std::array::from_fn(|j| parts[i / 3][j / 3].col(j % 3)[i % 3]))
    }

    /// The wrench of a motion.
    #[inline]
    pub fn times(&self, motion: &Twist) -> Wrench {
        Wrench {
            force: self.linear * motion.linear + self.cross * motion.angular,
            moment: self.back * motion.linear + self.angular * motion.angular,
        }
    }

    /// The same in other axes, the columns of `rotation`.
    pub fn turned(&self, rotation: &DMat3) -> Self {
        let turn = |part: DMat3| *rotation * part * rotation.transpose();
        let Self { linear, cross, back, angular } = *self;
        Self { linear: turn(linear), cross: turn(cross), back: turn(back), angular: turn(angular) }
    }

    /// The same for motion of and moments about another point, from which this one is at `arm` [m].
    pub fn about(&self, arm: DVec3) -> Self {
        let arm = skew(arm);
        // v_P = v + ω × r = v − [r] ω; moment about o = moment about P + [r] force.
        let cross = self.cross - self.linear * arm;
        let back = self.back + arm * self.linear;
        let angular = self.angular - self.back * arm + arm * self.cross - arm * self.linear * arm;
        Self { linear: self.linear, cross, back, angular }
    }

    /// Adds `scale` times another.
    pub fn add(&mut self, scale: f64, other: &Self) {
        self.linear += other.linear * scale;
        self.cross += other.cross * scale;
        self.back += other.back * scale;
        self.angular += other.angular * scale;
    }

    /// The opposite.
    pub fn negated(&self) -> Self {
        Self { linear: -self.linear, cross: -self.cross, back: -self.back, angular: -self.angular }
    }

    /// Largest difference from the transpose, and largest size of an entry.
    pub fn asymmetry(&self) -> (f64, f64) {
        let largest = |part: DMat3| part.to_cols_array().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let both = largest(self.linear - self.linear.transpose())
            .max(largest(self.angular - self.angular.transpose()))
            .max(largest(self.cross - self.back.transpose()));
        let size = [self.linear, self.cross, self.back, self.angular].map(largest);
        (both, size.into_iter().fold(0.0, f64::max))
    }
}
