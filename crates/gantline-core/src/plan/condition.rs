//! Conditions on which a step of the plan ends, by forces in supports and ropes, and by how what floats lies.

use glam::{DMat3, DQuat};

use crate::spec::AttitudeSpec;

/// What conditions look at.
#[derive(Clone, Copy)]
pub struct Seen<'a> {
    /// Normal force of each contact group [N].
    pub support: &'a [f64],
    /// Tension that a row of a rope stands for [N].
    pub tension: &'a dyn Fn(usize) -> f64,
    /// Joint coordinates.
    pub q: &'a [f64],
}

/// A condition.
#[derive(Debug, Clone, PartialEq)]
pub enum Condition {
    /// The contacts of a group have lost a share of the weight.
    LoadTransferred {
        /// Index of the group.
        group: usize,
        /// Weight [N].
        weight: f64,
        /// Share.
        at_least: f64,
    },
    /// They bear again what leaves no more than a share transferred.
    LoadReturned {
        /// Index of the group.
        group: usize,
        /// Weight [N].
        weight: f64,
        /// Share.
        at_most: f64,
    },
    /// No contact of the group carries.
    Clear(usize),
    /// A contact of the group carries.
    Touched(usize),
    /// The tensions of some rows together have reached a bound.
    TensionAbove {
        /// The rows; one that counts twice stands twice.
        rows: Vec<usize>,
        /// Bound [N].
        bound: f64,
    },
    /// They have come down to a bound.
    TensionBelow {
        /// The rows.
        rows: Vec<usize>,
        /// Bound [N].
        bound: f64,
    },
    /// In every group of rows (max - min)/mean of the tensions is no more than a share, and all carry.
    Spread {
        /// The groups.
        groups: Vec<Vec<usize>>,
        /// Share.
        at_most: f64,
    },
    /// The heel or the trim of a body that floats freely has come to a bound.
    Attitude {
        /// Where q has its orientation.
        orientation: usize,
        /// Axes of its joint.
        placement: DMat3,
        /// Which angle.
        angle: AttitudeSpec,
        /// True where it has to be above.
        above: bool,
        /// Bound [rad].
        bound: f64,
    },
}

impl Condition {
    /// True where it holds.
    pub fn holds(&self, seen: &Seen) -> bool {
        let tension = |row: &usize| (seen.tension)(*row).max(0.0);
        match self {
            Self::LoadTransferred { group, weight, at_least } => {
                1.0 - seen.support[*group] / weight >= *at_least
            }
            Self::LoadReturned { group, weight, at_most } => 1.0 - seen.support[*group] / weight <= *at_most,
            Self::Clear(group) => seen.support[*group] <= 0.0,
            Self::Touched(group) => seen.support[*group] > 0.0,
            Self::TensionAbove { rows, bound } => rows.iter().map(tension).sum::<f64>() >= *bound,
            Self::TensionBelow { rows, bound } => rows.iter().map(tension).sum::<f64>() <= *bound,
            Self::Spread { groups, at_most } => groups.iter().all(|rows| {
                let (mut low, mut high, mut sum) = (f64::INFINITY, 0.0_f64, 0.0);
                for value in rows.iter().map(tension) {
                    (low, high, sum) = (low.min(value), high.max(value), sum + value);
                }
                low > 0.0 && (high - low) * rows.len() as f64 <= at_most * sum
            }),
            Self::Attitude { orientation, placement, angle, above, bound } => {
                let [w, x, y, z] = [0, 1, 2, 3].map(|k| seen.q[orientation + k]);
                let turned = *placement * DMat3::from_quat(DQuat::from_xyzw(x, y, z, w));
                let found = match angle {
                    AttitudeSpec::Heel => turned.y_axis.z.atan2(turned.z_axis.z),
                    AttitudeSpec::Trim => turned.x_axis.z.asin(),
                };
                if *above { found >= *bound } else { found <= *bound }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::*;

    #[test]
    fn each_holds_on_its_side_of_its_bound() {
        let seen = Seen { support: &[600.0, 0.0], tension: &|row| [10.0, 12.0, -1.0][row], q: &[] };
        let transferred = |at_least| Condition::LoadTransferred { group: 0, weight: 1000.0, at_least };
        assert!(transferred(0.4).holds(&seen) && !transferred(0.41).holds(&seen));
        let returned = |at_most| Condition::LoadReturned { group: 0, weight: 1000.0, at_most };
        assert!(returned(0.4).holds(&seen) && !returned(0.39).holds(&seen));
        assert!(Condition::Clear(1).holds(&seen) && !Condition::Clear(0).holds(&seen));
        assert!(Condition::Touched(0).holds(&seen) && !Condition::Touched(1).holds(&seen));
        // A row that counts twice, and one that is slack and counts nothing: 10 + 10 + 12.
        let above = |bound| Condition::TensionAbove { rows: vec![0, 0, 1, 2], bound };
        assert!(above(32.0).holds(&seen) && !above(32.1).holds(&seen));
        let below = |bound| Condition::TensionBelow { rows: vec![0, 1], bound };
        assert!(below(22.0).holds(&seen) && !below(21.9).holds(&seen));
        // (12 - 10)/11 = 0.1818
        let spread = |groups, at_most| Condition::Spread { groups, at_most };
        assert!(spread(vec![vec![0, 1]], 0.182).holds(&seen));
        assert!(!spread(vec![vec![0, 1]], 0.181).holds(&seen));
        assert!(!spread(vec![vec![0], vec![0, 2]], 10.0).holds(&seen), "a slack sling shares nothing");
    }

    #[test]
    fn heel_and_trim_are_positive_to_starboard_and_by_the_stern() {
        let turned = |axis, angle: f64| {
            let turn = DQuat::from_axis_angle(axis, angle);
            [turn.w, turn.x, turn.y, turn.z]
        };
        let holds = |q: [f64; 4], angle, above| {
            let placement = DMat3::IDENTITY;
            let condition = Condition::Attitude { orientation: 0, placement, angle, above, bound: 0.02 };
            condition.holds(&Seen { support: &[], tension: &|_| 0.0, q: &q })
        };
        // About x forward the port side rises; about y to port the bow sinks.
        let (heeled, trimmed) = (turned(DVec3::X, 0.03), turned(DVec3::Y, -0.03));
        assert!(holds(heeled, AttitudeSpec::Heel, true) && !holds(heeled, AttitudeSpec::Heel, false));
        assert!(holds(trimmed, AttitudeSpec::Trim, true) && !holds(trimmed, AttitudeSpec::Trim, false));
        assert!(holds(heeled, AttitudeSpec::Trim, false) && holds(trimmed, AttitudeSpec::Heel, false));
    }
}
