//! What stands on a vessel goes along with it.
//!
//! Where a vessel is inclined by next to nothing, friction holds all that stands on its deck: a load slides by no
//! share of an angle however small. An equilibrium in which contacts slide freely has it slide downhill as far as slings
//! and tag lines let it, and its weight takes away from what rights the vessel. Friction between a vessel and what lies
//! beside it, such as that of fenders, is another matter: it holds until it slips, and rights nobody for good. So is that of
//! a side: a load that hangs from a crane ashore and leans on a landing guide of the deck would hold the vessel by its slings.

use super::Statics;
use crate::constraint::{AnyConstraint, Law};
use crate::state::State;
use crate::system::System;

/// Share of what presses that is upright at least where something stands: the cosine of 50°, so that a cradle at 45° counts,
/// and no slope or flare of a guide.
const UPRIGHT: f64 = 0.6428;

/// What friction of contacts does to derivatives of an equilibrium.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Friction {
    /// What it does in the equilibrium.
    #[default]
    AsFound,
    /// It holds what stands on vessels, and nothing else.
    OnVessels,
}

impl From<bool> for Friction {
    /// Whether it holds what stands on vessels alone.
    fn from(standing: bool) -> Self {
        if standing { Self::OnVessels } else { Self::AsFound }
    }
}

impl Statics {
    /// Which rows take part in derivatives of the equilibrium found last.
    pub(super) fn taking_part(&self, system: &System, state: &State, friction: Friction) -> Vec<bool> {
        let mut follows = self.search.here.follows.clone();
        if friction == Friction::OnVessels {
            for (row, law) in system.rows.laws.iter().enumerate() {
                if let Law::Friction { normal, .. } = law {
                    follows[row] = follows[*normal] && self.stands_on_vessel(system, state, row);
                }
            }
        }
        follows
    }

    /// Whether one side of the contact of this row belongs to a vessel, and the other to what floats nowhere, is free, and
    /// stands on it or bears it.
    fn stands_on_vessel(&self, system: &System, state: &State, row: usize) -> bool {
        let (facing, spot) = match system.constraint_of_row(row) {
            AnyConstraint::Contact(contact) => (&contact.facing, &contact.spot),
            AnyConstraint::Touch(touch) => (&touch.facing, &state.spots[touch.spot]),
            _ => return false,
        };
        let [Some(one), Some(other)] = facing.bodies.map(|body| body.map(|body| root(system, body))) else {
            return false;
        };
        let floats = |root: usize| system.vessels.iter().any(|vessel| vessel.body == root);
        let is_free = |root: usize| !system.tree.support_of(Some(root)).is_empty();
        let (_, normal) = facing.force(&self.search.here.frame.kinematics, spot, [1.0, 0.0, 0.0]);
        is_free(one) && is_free(other) && floats(one) != floats(other) && normal.z.abs() >= UPRIGHT
    }
}

/// The body at the root of the tree that bears this one.
fn root(system: &System, body: usize) -> usize {
    std::iter::successors(Some(body), |&body| system.tree.bodies[body].parent).last().unwrap_or(body)
}
