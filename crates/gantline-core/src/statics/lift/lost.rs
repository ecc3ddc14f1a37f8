//! A load that is lost at once, or weighs more than it was said to: the equilibrium of what it hung on.

use super::{StaticLift, way};
use crate::constraint::AnyConstraint;
use crate::force::AnyForce;
use crate::solver::complementarity::Mode;
use crate::state::State;
use crate::statics::losses::Losses;
use crate::statics::{NoEquilibrium, Rest};
use crate::system::System;
use crate::tree::Tree;

impl StaticLift {
    /// Loses the body `body`, with all that is fixed to it, where the equilibrium found last has it, and finds the
    /// equilibrium of everything else, with drives where they are. What follows is asked of that, until an equilibrium
    /// of the lift itself is asked for. The sample is it alone.
    ///
    /// # Errors
    /// [`NoEquilibrium`] where there is none without it.
    pub fn lose(&mut self, body: usize, losses: Losses) -> Result<Rest, NoEquilibrium> {
        let whole = self.kept();
        let lost = self.system.tree.subtree[carrier_of(&self.system.tree, body)].clone();
        let_go(&self.system, &mut self.state, &lost);
        take_off(&mut self.system, &lost);
        self.go_on_without(whole, losses)
    }

    /// Puts more mass into bodies, at their centres of gravity, so much by name [kg], and finds the equilibrium downhill of
    /// that found last; the same is true of it as of that of [`StaticLift::lose`].
    ///
    /// # Errors
    /// [`NoEquilibrium`] where there is none with it, or no such body.
    pub fn weigh(&mut self, more: &[(String, f64)], losses: Losses) -> Result<Rest, NoEquilibrium> {
        let whole = self.kept();
        for (name, mass) in more {
            let missing =
                || NoEquilibrium { element: name.clone(), cause: "there is no such body".to_owned() };
            let index = self.body(name).ok_or_else(missing)?;
            self.system.tree.bodies[index].mass += mass;
        }
        self.go_on_without(whole, losses)
    }

    /// The lift as it is given, aside from where it is changed.
    fn kept(&mut self) -> System {
        self.whole.take().unwrap_or_else(|| self.system.clone())
    }

    /// The equilibrium of the lift as it has been changed, with `whole` as it is given.
    fn go_on_without(&mut self, whole: System, losses: Losses) -> Result<Rest, NoEquilibrium> {
        let Self { system, state, statics, .. } = self;
        let found = statics.go_on(system, state, losses);
        self.whole = Some(whole);
        self.slides.clear();
        way::note(&mut self.slides, &mut self.statics, self.state.time);
        let rest = found?;
        self.sample(false);
        Ok(rest)
    }

    /// The lift with all its loads again.
    pub(super) fn find_again(&mut self) {
        if let Some(whole) = self.whole.take() {
            self.system = whole;
        }
    }
}

/// The body whose joint a load moves by: itself, or the first of those without mass that carry it and nothing else of
/// mass, as the joints of a hinge do that it has left. It is fixed to the last of these and has no joint of its own,
/// so that what reaches it, and all that could move it, is theirs.
fn carrier_of(tree: &Tree, body: usize) -> usize {
    let mut top = body;
    while let Some(parent) = tree.bodies[top].parent {
        let carries_else = |&one: &usize| tree.bodies[one].mass > 0.0 && !tree.subtree[top].contains(&one);
        if tree.subtree[parent].iter().any(carries_else) {
            break;
        }
        top = parent;
    }
    top
}

/// Nothing holds the bodies, or leans on them: ropes, contacts and lines that reach them are gone.
fn let_go(system: &System, state: &mut State, lost: &[usize]) {
    let is_lost = |dof: &usize| lost.contains(&system.tree.owner[*dof]);
    for (index, constraint) in system.constraints.iter().enumerate() {
        let holds = match constraint {
            AnyConstraint::Rope(_) | AnyConstraint::Contact(_) | AnyConstraint::Touch(_) => true,
            AnyConstraint::Stop(_) | AnyConstraint::Pin(_) | AnyConstraint::Brake(_) => false,
        };
        let rows = system.rows.first[index]..system.rows.first[index + 1];
        let entries = system.rows.start[rows.start]..system.rows.start[rows.end];
        if holds && system.rows.dofs[entries].iter().any(is_lost) {
            state.modes[rows.clone()].fill(Mode::Parted);
            state.tension[rows].fill(0.0);
        }
    }
    for mooring in system.moorings().filter(|mooring| lost.contains(&mooring.body)) {
        state.q[mooring.mark] = 1.0;
    }
}

/// They weigh nothing and nothing pushes them, so that they stay where they are. Their inertia stays with their joints:
/// a motion without any would have no frequency.
fn take_off(system: &mut System, lost: &[usize]) {
    let tree = &mut system.tree;
    for &index in lost {
        let dofs = tree.bodies[index].dofs();
        for dof in dofs {
            tree.armature[dof] += tree.inertia_scale[dof];
        }
        let body = &mut tree.bodies[index];
        (body.mass, body.inertia) = (0.0, glam::DMat3::ZERO);
    }
    tree.forces.retain(|force| matches!(force, AnyForce::Mooring(_)) || !lost.contains(&force.body()));
}
