//! Conditions on which a step of the plan ends, by forces in supports and ropes, by how what floats lies, and how falls
//! hang.

use glam::DVec3;

use crate::spec::AttitudeSpec;
use crate::tree::kinematics::Kinematics;

/// What the contacts of a group do to the body that they bear.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Support {
    /// Sum of their normal forces, whichever way they press [N].
    pub pressed: f64,
    /// What they bear of its weight: their force upwards, with that of friction [N].
    pub borne: f64,
}

/// What conditions look at.
#[derive(Clone, Copy)]
pub struct Seen<'a> {
    /// What each contact group does.
    pub support: &'a [Support],
    /// Tension that a row of a rope stands for [N]; mooring lines count on from the rows.
    pub tension: &'a dyn Fn(usize) -> f64,
    /// Where everything is.
    pub kinematics: &'a Kinematics,
}

/// Falls between two bodies: where they hang from, what hangs on them, and the way down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Falls {
    /// Upper body, and the point in its frame [m].
    pub upper: (usize, DVec3),
    /// Lower body, and the point in its frame [m].
    pub lower: (usize, DVec3),
    /// Downwards.
    pub down: DVec3,
}

impl Falls {
    /// Cosine of their angle to plumb.
    fn cosine(&self, kinematics: &Kinematics) -> f64 {
        let [upper, lower] = [self.upper, self.lower].map(|(body, at)| kinematics.point(Some(body), at));
        let along = lower - upper;
        self.down.dot(along) / along.length()
    }
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
    /// All falls hang within this of plumb.
    Plumb {
        /// The falls.
        falls: Vec<Falls>,
        /// Cosine of the largest angle.
        cosine: f64,
    },
    /// In every group of rows (max - min)/mean of the tensions is no more than a share, and all carry.
    Spread {
        /// The groups.
        groups: Vec<Vec<usize>>,
        /// Share.
        at_most: f64,
    },
    /// The heel, trim or tilt of a body has come to a bound.
    Attitude {
        /// The body.
        body: usize,
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
        self.lacks(seen) <= 0.0
    }

    /// What it lacks to hold, in its own unit: nothing, or less, where it does; infinite where nothing tells how much.
    pub fn lacks(&self, seen: &Seen) -> f64 {
        let tension = |row: &usize| (seen.tension)(*row).max(0.0);
        let transferred = |group: &usize, weight: &f64| 1.0 - seen.support[*group].borne / weight;
        match self {
            Self::LoadTransferred { group, weight, at_least } => at_least - transferred(group, weight),
            Self::LoadReturned { group, weight, at_most } => transferred(group, weight) - at_most,
            Self::Clear(group) => seen.support[*group].pressed,
            Self::Touched(group) => match seen.support[*group].pressed {
                pressed if pressed > 0.0 => -pressed,
                _ => f64::INFINITY,
            },
            Self::TensionAbove { rows, bound } => bound - rows.iter().map(tension).sum::<f64>(),
            Self::TensionBelow { rows, bound } => rows.iter().map(tension).sum::<f64>() - bound,
            Self::Plumb { falls, cosine } => {
                most(falls.iter().map(|one| cosine - one.cosine(seen.kinematics)))
            }
            Self::Spread { groups, at_most } => most(groups.iter().map(|rows| {
                let (mut low, mut high, mut sum) = (f64::INFINITY, 0.0_f64, 0.0);
                for value in rows.iter().map(tension) {
                    (low, high, sum) = (low.min(value), high.max(value), sum + value);
                }
                if low > 0.0 { (high - low) * rows.len() as f64 - at_most * sum } else { f64::INFINITY }
            })),
            Self::Attitude { body, angle, above, bound } => {
                let turned = seen.kinematics.pose[*body].rotation;
                let found = match angle {
                    AttitudeSpec::Heel => turned.y_axis.z.atan2(turned.z_axis.z),
                    AttitudeSpec::Trim => turned.x_axis.z.asin(),
                    AttitudeSpec::Tilt => turned.z_axis.truncate().length().atan2(turned.z_axis.z),
                };
                if *above { bound - found } else { found - bound }
            }
        }
    }
}

/// The largest; no number where one of them is none.
fn most(values: impl Iterator<Item = f64>) -> f64 {
    let larger = |most: f64, value: f64| if most.is_nan() || value <= most { most } else { value };
    values.fold(f64::NEG_INFINITY, larger)
}

#[cfg(test)]
mod tests {
    use glam::DQuat;

    use super::*;
    use crate::tree::Tree;
    use crate::tree::pose::Pose;

    /// Falls of 10 m that lean by 17.5 cm, asin 0.0175 = 1.0027°: beyond 1°, within 1.01°.
    #[test]
    fn falls_are_plumb_within_an_angle() {
        let mut kinematics = Kinematics::new(&Tree::new(Vec::new(), DVec3::ZERO));
        let at = |x: f64, y: f64, z: f64| Pose { position: DVec3::new(x, y, z), ..Pose::IDENTITY };
        let down = (100.0_f64 - 0.175 * 0.175).sqrt();
        kinematics.pose = vec![at(3.0, 4.0, 50.0), at(3.0, 4.175, 49.0 - down), at(3.0, 4.0, 20.0)];
        let falls =
            |lower: usize| Falls { upper: (0, -DVec3::Z), lower: (lower, DVec3::ZERO), down: -DVec3::Z };
        let seen = Seen { support: &[], tension: &|_| 0.0, kinematics: &kinematics };
        let within = |lowers: &[usize], degrees: f64| {
            let falls = lowers.iter().map(|&lower| falls(lower)).collect();
            Condition::Plumb { falls, cosine: degrees.to_radians().cos() }.holds(&seen)
        };
        assert!(within(&[1], 1.01) && !within(&[1], 1.0));
        assert!(within(&[2], 1e-6), "plumb falls are plumb");
        assert!(!within(&[2, 1], 1.0), "all have to be");
    }

    #[test]
    fn each_holds_on_its_side_of_its_bound() {
        let tree = Tree::new(Vec::new(), DVec3::ZERO);
        let kinematics = Kinematics::new(&tree);
        // In a cradle contacts press with more than they bear.
        let support = [Support { pressed: 700.0, borne: 600.0 }, Support::default()];
        let tension = |row: usize| [10.0, 12.0, -1.0][row];
        let seen = Seen { support: &support, tension: &tension, kinematics: &kinematics };
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
        let turned = |axis, angle: f64| DQuat::from_axis_angle(axis, angle);
        let holds = |turn: DQuat, angle, above| {
            let condition = Condition::Attitude { body: 0, angle, above, bound: 0.02 };
            let mut kinematics = Kinematics::new(&Tree::new(Vec::new(), DVec3::ZERO));
            kinematics.pose = vec![Pose::new(turn, DVec3::ZERO)];
            condition.holds(&Seen { support: &[], tension: &|_| 0.0, kinematics: &kinematics })
        };
        // About x forward the port side rises; about y to port the bow sinks.
        let (heeled, trimmed) = (turned(DVec3::X, 0.03), turned(DVec3::Y, -0.03));
        assert!(holds(heeled, AttitudeSpec::Heel, true) && !holds(heeled, AttitudeSpec::Heel, false));
        assert!(holds(trimmed, AttitudeSpec::Trim, true) && !holds(trimmed, AttitudeSpec::Trim, false));
        // Heel and trim alone are tilts of as much, whichever way.
        for tilted in [heeled, trimmed] {
            assert!(holds(tilted, AttitudeSpec::Tilt, true) && !holds(tilted, AttitudeSpec::Tilt, false));
        }
        assert!(!holds(turned(DVec3::Z, 1.0), AttitudeSpec::Tilt, true), "a heading is no tilt");
        assert!(holds(turned(DVec3::X, 3.0), AttitudeSpec::Tilt, true), "upside down");
        assert!(holds(heeled, AttitudeSpec::Trim, false) && holds(trimmed, AttitudeSpec::Heel, false));
    }
}
