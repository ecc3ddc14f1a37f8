//! The rim of a round body over a plane: the circle about c with axis a and radius r.
//!
//! With n the normal of the plane and o a point of it,
//!
//! ```text
//! w = n − (n·a) a,  σ = |w|      σ sine of the angle between the axis and the normal
//! g = n·(c − o) − r φ(σ)         how high the lowest point of the rim is over the plane
//! x = c − r φ′(σ) w/σ            where it presses
//! ```
//!
//! φ = σ of a circle, whose lowest point jumps round it as the axis passes upright. Below a small δ it is
//! δ (3/8 + 3/4 y² − 1/8 y⁴) with y = σ/δ, which meets σ with two derivatives: the end of the body is a little domed, and x comes to
//! its middle. ∂g = n·∂x of the point of the body at x, since c + r u is lowest where it does not move along n.

use glam::DVec3;

use crate::tree::pose::Pose;

/// δ of the ends of round bodies [1].
pub const DOME: f64 = 1e-3;

/// A circle of a body, in its frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rim {
    /// c [m].
    pub centre: DVec3,
    /// a, a unit vector.
    pub axis: DVec3,
    /// r [m].
    pub radius: f64,
    /// δ.
    pub dome: f64,
}

/// A rim over a plane, in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lowest {
    /// x [m].
    pub point: DVec3,
    /// g [m].
    pub gap: f64,
    normal: DVec3,
    axis: DVec3,
    /// w.
    along: DVec3,
    /// r φ′/σ and its derivative over σ² [m].
    arm: [f64; 2],
}

impl Rim {
    /// Where the rim of a body at `pose` is lowest over the plane through `origin` [m] with a unit normal.
    pub fn lowest(&self, pose: &Pose, origin: DVec3, normal: DVec3) -> Lowest {
        let (centre, axis) = (pose.point(self.centre), pose.rotation * self.axis);
        let along = normal.reject_from_normalized(axis);
        let (square, dome) = (along.length_squared(), self.dome);
        let (sunk, arm, bend) = if square >= dome * dome {
            let size = square.sqrt();
            (size, 1.0 / size, -0.5 / (square * size))
        } else {
            let share = square / (dome * dome);
            let sunk = dome * (0.375 + share * (0.75 - 0.125 * share));
            (sunk, (1.5 - 0.5 * share) / dome, -0.5 / (dome * dome * dome))
        };
        let [arm, bend] = [self.radius * arm, self.radius * bend];
        Lowest {
            point: centre - along * arm,
            gap: normal.dot(centre - origin) - self.radius * sunk,
            normal,
            axis,
            along,
            arm: [arm, bend],
        }
    }
}

impl Lowest {
    /// How x moves along the body as body and plane turn by these.
    pub fn moves(&self, [body, plane]: [DVec3; 2]) -> DVec3 {
        let change = (plane - body).cross(self.normal).reject_from_normalized(self.axis);
        let [arm, bend] = self.arm;
        -(change * arm + self.along * (2.0 * bend * self.along.dot(change)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DMat3;

    fn lowest(angle: f64) -> Lowest {
        let rim = Rim { centre: DVec3::new(0.0, 0.0, 2.0), axis: DVec3::Z, radius: 3.0, dome: 0.01 };
        let pose = Pose { rotation: DMat3::from_rotation_y(angle), position: DVec3::ZERO };
        rim.lowest(&pose, DVec3::new(7.0, 7.0, -4.0), DVec3::Z)
    }

    /// Turned by an angle about y the middle of the circle is 2 cos over the origin, its lowest point 3 sin below that.
    #[test]
    fn is_lowest_where_a_circle_is() {
        for angle in [0.02_f64, 0.3, 1.2, 1.6, 2.8] {
            let found = lowest(angle);
            let below = 3.0 * angle.sin().abs();
            assert!((found.gap - (4.0 + 2.0 * angle.cos() - below)).abs() < 1e-12, "{angle}: {found:?}");
            let level = 2.0 * angle.sin() + 3.0 * angle.cos();
            let point = DVec3::new(level, 0.0, 2.0 * angle.cos() - below);
            assert!((found.point - point).length() < 1e-12, "{angle}: {found:?}");
        }
    }

    /// Upright it presses in the middle, 3/8 of δ times the radius below; at δ dome and circle meet.
    #[test]
    fn an_upright_end_is_a_little_domed() {
        let found = lowest(0.0);
        assert!((found.point - DVec3::new(0.0, 0.0, 2.0)).length() < 1e-15);
        assert!((found.gap - (6.0 - 3.0 * 0.375 * 0.01)).abs() < 1e-15);
        let edge = 0.01_f64.asin();
        let [inside, outside] = [edge * (1.0 - 1e-9), edge * (1.0 + 1e-9)].map(lowest);
        // Along both sides of δ: as far as 2e-9 of the angle moves them, 3 m times 2e-11.
        assert!((inside.gap - outside.gap).abs() < 1e-10);
        assert!((inside.point - outside.point).length() < 1e-10);
        assert!((inside.arm[1] / outside.arm[1] - 1.0).abs() < 1e-7);
    }
}
