//! What stands on a vessel goes along with it.
//!
//! Where a vessel is inclined by next to nothing, friction holds all that stands on its deck: a load slides by no
//! share of an angle however small. An equilibrium in which contacts slide freely has it slide downhill as far as slings
//! and tag lines let it, and its weight takes away from what rights the vessel. Friction between a vessel and what lies
//! beside it, such as that of fenders, is another matter: it holds until it slips, and rights nobody for good.

use super::Statics;
use crate::constraint::{AnyConstraint, Law};
use crate::system::System;

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
    pub(super) fn taking_part(&self, system: &System, friction: Friction) -> Vec<bool> {
        let mut follows = self.search.here.follows.clone();
        if friction == Friction::OnVessels {
            for (row, law) in system.rows.laws.iter().enumerate() {
                if let Law::Friction { normal, .. } = law {
                    follows[row] = follows[*normal] && stands_on_vessel(system, row);
                }
            }
        }
        follows
    }
}

/// Whether one side of the contact of this row belongs to a vessel, and the other to what floats nowhere and is free.
fn stands_on_vessel(system: &System, row: usize) -> bool {
    let bodies = match system.constraint_of_row(row) {
        AnyConstraint::Contact(contact) => contact.facing.bodies,
        AnyConstraint::Touch(touch) => touch.facing.bodies,
        _ => return false,
    };
    let [Some(one), Some(other)] = bodies.map(|body| body.map(|body| root(system, body))) else {
        return false;
    };
    let floats = |root: usize| system.vessels.iter().any(|vessel| vessel.body == root);
    let is_free = |root: usize| !system.tree.support_of(Some(root)).is_empty();
    is_free(one) && is_free(other) && floats(one) != floats(other)
}

/// The body at the root of the tree that bears this one.
fn root(system: &System, body: usize) -> usize {
    std::iter::successors(Some(body), |&body| system.tree.bodies[body].parent).last().unwrap_or(body)
}
