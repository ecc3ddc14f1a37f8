//! Steps beside crests that may reach a load, or troughs that may leave it: where all else is at rest nothing else makes them
//! short, and a crest that comes and goes within one would not be felt.

use super::Adaptive;
use crate::force;
use crate::system::System;

/// Steps in the mean period of what the surface does: less than 2 % of its height, 1 − cos(π/16), passes unseen.
const STEPS_IN_WAVE: f64 = 16.0;

impl Adaptive {
    /// No step is longer where the surface of the sea may be about to pass a part of a load [s].
    pub(super) fn crest_limit(&self, system: &System) -> f64 {
        let pose = &self.rodas.here.frame.kinematics.pose;
        let is_passed = force::submerged(&system.tree).any(|load| load.may_be_passed(&pose[load.body]));
        if is_passed { system.sea.mean_period() / STEPS_IN_WAVE } else { f64::INFINITY }
    }
}
