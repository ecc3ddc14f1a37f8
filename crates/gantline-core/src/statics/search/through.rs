//! What a step runs into, or through.
//!
//! The model of a step knows where bodies are near each other before it, and of nothing else that they may come upon. A load
//! that falls over goes metres in one step, into the middle of a structure or past it. What is found there pushes it out the
//! shortest way, which may be the far side: so a column that fell from a platform came to rest between its underside and the
//! ground, jammed with thousands of times its weight. Such a step is none. A shorter one ends where bodies meet, and the next
//! model knows of that.

use super::Search;
use crate::constraint::AnyConstraint;
use crate::state::State;
use crate::system::{BodyShape, Finder, System};
use crate::tree::kinematics::Kinematics;

/// How much deeper than it was, or than the model had it, what a step may run into can become [m]: a quarter of the reach
/// within which models know of it.
const DEEPER: f64 = 0.05;
/// How far bodies move from one look to the next, on the way of a step [m].
const APART: f64 = 0.2;
/// Looks, at most.
const LOOKS: f64 = 64.0;

impl Search {
    /// True where bodies that may touch come into one another on the step, or through one another, so that the model of it
    /// did not know.
    pub(super) fn runs_into(&mut self, system: &System, state: &State) -> bool {
        system.finders.iter().any(|finder| self.comes_deeper(system, state, finder))
    }

    fn comes_deeper(&mut self, system: &System, state: &State, finder: &Finder) -> bool {
        let Finder::Pair { shapes, first, count } = finder else { return false };
        let AnyConstraint::Touch(touch) = &system.constraints[*first] else { return false };
        let shapes = shapes.map(|shape| &system.shapes[shape]);
        let [here, there] = [&self.here, &self.there].map(|place| &place.frame.kinematics);
        let way: f64 = shapes.iter().map(|shape| farthest(shape, here, there)).sum();
        if way <= DEEPER {
            return false;
        }
        let apart = apart(shapes, here);
        if way <= apart {
            return false;
        }
        let spots = &state.spots[touch.spot..touch.spot + count];
        // How deep those places are that the model knew of, beyond which it is told from how the shapes lie.
        let is_unknown = |there: &Kinematics| {
            let depth = -self::apart(shapes, there);
            let poses = shapes.map(|shape| there.pose_of(shape.body));
            let known = spots.iter().filter(|spot| spot.is_near).map(|spot| -spot.gap(poses));
            depth > DEEPER && depth > DEEPER + known.fold(-apart, f64::max)
        };
        if is_unknown(there) {
            return true;
        }
        let looks = (way / APART).ceil().min(LOOKS);
        (1..looks as usize).any(|look| {
            let share = look as f64 / looks;
            self.way.copy_from_slice(&self.here.q);
            self.part.iter_mut().zip(&self.step).for_each(|(part, step)| *part = share * step);
            system.tree.advance(&mut self.way, &self.part);
            self.between.update(&system.tree, &self.way, 0.0);
            is_unknown(&self.between)
        })
    }
}

/// How far two shapes are apart [m], less than nothing where they are in one another.
fn apart([one, other]: [&BodyShape; 2], kinematics: &Kinematics) -> f64 {
    let poses = [one.body, other.body].map(|body| kinematics.pose_of(body));
    one.shape.distance(&other.shape, poses)
}

/// How far any point of a shape moves from here to there, at most [m]: by its chord, which a turn by θ makes 2 sin θ/2.
fn farthest(shape: &BodyShape, here: &Kinematics, there: &Kinematics) -> f64 {
    let Some(body) = shape.body else { return 0.0 };
    let [here, there] = [&here.pose[body], &there.pose[body]];
    let turned = here.rotation.transpose() * there.rotation;
    let cosine = (0.5 * (turned.col(0).x + turned.col(1).y + turned.col(2).z - 1.0)).clamp(-1.0, 1.0);
    (there.position - here.position).length() + (2.0 - 2.0 * cosine).sqrt() * shape.shape.radius
}
