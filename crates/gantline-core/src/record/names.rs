//! Names that go with the columns.

use super::columns::ARC_SAMPLES;
use crate::audit::{KINDS, kinds_of};
use crate::constraint::AnyConstraint;
use crate::force;
use crate::force::mooring::CHORDS;
use crate::system::System;

/// Names that go with the columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Names {
    /// Ropes.
    pub rope: Vec<String>,
    /// Straight segments, `rope/number`.
    pub segment: Vec<String>,
    /// Rope of every drawn point.
    pub rope_point: Vec<String>,
    /// Sheaves with true tangents, `rope/sheave_number`.
    pub wrapped_sheave: Vec<String>,
    /// Bodies.
    pub body: Vec<String>,
    /// Bodies with a hinge or slider.
    pub joint: Vec<String>,
    /// Contacts.
    pub contact: Vec<String>,
    /// Bodies whose joints have locking pins.
    pub pin: Vec<String>,
    /// Pairs whose distance is recorded.
    pub pair: Vec<String>,
    /// Hulls in water.
    pub hull: Vec<String>,
    /// Hooks whose hoists can compensate heave.
    pub compensator: Vec<String>,
    /// Kinds of energy that it has.
    pub energy_kind: Vec<&'static str>,
}

impl Names {
    /// Names of `system`.
    pub fn new(system: &System) -> Self {
        let bodies = &system.tree.bodies;
        let hulls = system.tree.hulls().map(|hull| hull.name.clone());
        let submerged = force::submerged(&system.tree).map(|load| load.name.clone());
        let mut names = Self {
            rope: Vec::new(),
            segment: Vec::new(),
            rope_point: Vec::new(),
            wrapped_sheave: (0..system.sheaves.len()).map(|seat| system.sheave_name(seat)).collect(),
            body: bodies
                .iter()
                .filter(|body| body.joint.moves_body())
                .map(|body| body.name.clone())
                .collect(),
            joint: bodies.iter().filter(|body| body.joint.has_axis()).map(|body| body.name.clone()).collect(),
            contact: Vec::new(),
            pin: Vec::new(),
            pair: system.watches.iter().map(|watch| watch.name.clone()).collect(),
            hull: hulls.chain(submerged).collect(),
            compensator: system.plan.compensators.iter().map(|one| one.name.clone()).collect(),
            energy_kind: kinds_of(system).into_iter().map(|kind| KINDS[kind]).collect(),
        };
        for constraint in &system.constraints {
            match constraint {
                AnyConstraint::Rope(rope) => {
                    let segments = (0..rope.route.parts.len()).map(|part| format!("{}/{part}", rope.name));
                    let points = rope.route.guides.iter().map(|guide| guide.drawn_points(ARC_SAMPLES)).sum();
                    names.segment.extend(segments);
                    names.rope_point.extend(std::iter::repeat_n(rope.name.clone(), points));
                    names.rope.push(rope.name.clone());
                }
                AnyConstraint::Stop(_) | AnyConstraint::Brake(_) => {}
                AnyConstraint::Pin(pin) => names.pin.push(pin.name.clone()),
                AnyConstraint::Contact(_) | AnyConstraint::Touch(_) => {
                    names.contact.push(constraint.name().to_owned());
                }
            }
        }
        for mooring in system.moorings() {
            names.segment.push(format!("{}/0", mooring.name));
            names.rope_point.extend(std::iter::repeat_n(mooring.name.clone(), CHORDS + 1));
            names.rope.push(mooring.name.clone());
        }
        names
    }

    /// Each list with the dimension that it has in recordings.
    pub fn lists(self) -> [(&'static str, Vec<String>); 12] {
        [
            ("rope", self.rope),
            ("segment", self.segment),
            ("rope_point", self.rope_point),
            ("wrapped_sheave", self.wrapped_sheave),
            ("body", self.body),
            ("joint", self.joint),
            ("contact", self.contact),
            ("pin", self.pin),
            ("pair", self.pair),
            ("hull", self.hull),
            ("compensated_hook", self.compensator),
            ("energy_kind", self.energy_kind.into_iter().map(str::to_owned).collect()),
        ]
    }
}
