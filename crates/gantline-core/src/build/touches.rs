//! Shapes, supports, pairs of shapes that may touch, and distances that are recorded.

use glam::{DQuat, DVec3};

use super::rows::body_index;
use super::{BuildError, at_least_zero, error, finite, positive, unit};
use crate::constraint::AnyConstraint;
use crate::constraint::facing::Facing;
use crate::constraint::touch::Touch;
use crate::contact::landing::{Landing, PLACES, Post, Wall};
use crate::contact::pad::{Pad, Side, top};
use crate::contact::plane::Plane;
use crate::contact::rim::{DOME, Rim};
use crate::contact::shape::{Part, Shape};
use crate::contact::spot::Spot;
use crate::plan::{Due, Removal};
use crate::spec::{
    LandingSpec, PairSpec, PartSpec, PostSpec, RimSpec, ShapeSpec, SupportSpec, SystemSpec, WallSpec,
    WatchedSpec,
};
use crate::system::{BodyShape, ContactGroup, Finder, Watch, Watched, WatchedRope};
use crate::tree::Tree;

/// Corners of an underside may be off its plane by this share of its size.
const FLAT: f64 = 1e-6;
/// Most places of a pair.
const MOST_PLACES: usize = 64;

fn vector(given: [f64; 3]) -> DVec3 {
    DVec3::from_array(given)
}

/// All shapes of the document.
pub(super) fn build_shapes(spec: &SystemSpec, tree: &Tree) -> Result<Vec<BodyShape>, BuildError> {
    spec.shapes.iter().map(|given| build_shape(given, tree)).collect()
}

fn build_shape(given: &ShapeSpec, tree: &Tree) -> Result<BodyShape, BuildError> {
    let name = &given.name;
    let body = body_index(name, tree, given.body.as_ref())?;
    let mut parts = Vec::with_capacity(given.parts.len());
    for part in &given.parts {
        parts.push(match part {
            PartSpec::Box { size, centre, orientation } => {
                for side in size {
                    positive(name, "a side of its box", *side)?;
                }
                finite(name, "the middle of its box", centre)?;
                let [w, x, y, z] = *orientation;
                let turn = DQuat::from_xyzw(x, y, z, w);
                if (turn.length() - 1.0).abs() > 1e-6 || !turn.is_finite() {
                    return error(name, "the orientation of its box must be a unit quaternion");
                }
                Part::Box { size: vector(*size), centre: vector(*centre), orientation: turn.normalize() }
            }
            PartSpec::Convex { vertices } => {
                finite(name, "a corner of its shape", vertices.as_flattened())?;
                Part::Convex(vertices.iter().copied().map(vector).collect())
            }
            PartSpec::Mesh { vertices, triangles } => {
                finite(name, "a corner of its shape", vertices.as_flattened())?;
                let corners = triangles.as_flattened();
                if corners.iter().any(|corner| *corner as usize >= vertices.len()) {
                    return error(name, "a triangle of its mesh names a corner that is not there");
                }
                Part::Mesh(vertices.iter().copied().map(vector).collect(), triangles.clone())
            }
        });
    }
    match Shape::new(&parts) {
        Ok(shape) => Ok(BodyShape { name: name.clone(), body, shape }),
        Err(problem) => error(name, problem),
    }
}

fn shape_named(element: &str, shapes: &[BodyShape], name: &str) -> Result<usize, BuildError> {
    match shapes.iter().position(|shape| shape.name == name) {
        Some(index) => Ok(index),
        None => error(element, format!("there is no shape `{name}`")),
    }
}

/// Constraints of touches, what finds their spots, and what takes supports away.
#[derive(Default)]
pub(super) struct Touches {
    pub finders: Vec<Finder>,
    pub removals: Vec<Removal>,
    pub spots: Vec<Spot>,
}

/// Adds the touches of supports, pairs, rims and landing guides to the constraints and groups.
pub(super) fn build_touches(
    spec: &SystemSpec,
    tree: &Tree,
    shapes: &[BodyShape],
    constraints: &mut Vec<AnyConstraint>,
    groups: &mut Vec<ContactGroup>,
) -> Result<Touches, BuildError> {
    let mut adding = Adding { tree, shapes, constraints, groups, made: Touches::default() };
    spec.supports.iter().try_for_each(|given| adding.support(given))?;
    spec.pairs.iter().try_for_each(|given| adding.pair(given))?;
    spec.rims.iter().try_for_each(|given| adding.rim(given))?;
    spec.landings.iter().try_for_each(|given| adding.landing(given))?;
    for (index, step) in spec.plan.iter().enumerate() {
        step.removes.iter().try_for_each(|name| adding.removal(index, &step.name, name))?;
    }
    Ok(adding.made)
}

/// Where touches are added, and what they are made from.
struct Adding<'a> {
    tree: &'a Tree,
    shapes: &'a [BodyShape],
    constraints: &'a mut Vec<AnyConstraint>,
    groups: &'a mut Vec<ContactGroup>,
    made: Touches,
}

impl Adding<'_> {
    fn support(&mut self, given: &SupportSpec) -> Result<(), BuildError> {
        let law = law(&given.name, [given.stiffness, given.damping_time, given.friction])?;
        let Some(body) = body_index(&given.name, self.tree, Some(&given.body))? else {
            return error(&given.name, "it has no body");
        };
        let pad = build_pad(given)?;
        let facing = Facing::new([Some(body), None], self.tree);
        let touch = self.add(given.name.clone(), &given.group, facing, law, true);
        self.made.finders.push(Finder::Pad(touch, Box::new(pad)));
        if let Some(time) = given.removed_at {
            at_least_zero(&given.name, "the time at which it is taken away", time)?;
            self.made.removals.push(Removal { touch, due: Due::At(time) });
        }
        Ok(())
    }

    fn pair(&mut self, given: &PairSpec) -> Result<(), BuildError> {
        let PairSpec { name, places, .. } = given;
        let law = law(name, [given.stiffness, given.damping_time, given.friction])?;
        let [one, other] = &given.shapes;
        let pair = [shape_named(name, self.shapes, one)?, shape_named(name, self.shapes, other)?];
        let bodies = pair.map(|shape| self.shapes[shape].body);
        if bodies[0] == bodies[1] {
            return error(name, "both shapes are on one body; a body does not touch itself");
        }
        if *places == 0 || *places > MOST_PLACES {
            return error(name, format!("it has {places} places; 1 to {MOST_PLACES} are right"));
        }
        let first = self.add_places(name, &given.group, &Facing::new(bodies, self.tree), law, *places);
        self.made.finders.push(Finder::Pair { shapes: pair, first, count: *places });
        Ok(())
    }

    fn rim(&mut self, given: &RimSpec) -> Result<(), BuildError> {
        let law = law(&given.name, [given.stiffness, given.damping_time, given.friction])?;
        let Some(body) = body_index(&given.name, self.tree, Some(&given.body))? else {
            return error(&given.name, "it has no body");
        };
        let (rim, plane) = build_rim(given)?;
        let facing = Facing::new([Some(body), None], self.tree).on_rim(rim);
        let touch = self.add(given.name.clone(), &given.group, facing, law, false);
        self.made.finders.push(Finder::Rim(touch, plane));
        Ok(())
    }

    fn landing(&mut self, given: &LandingSpec) -> Result<(), BuildError> {
        let LandingSpec { name, post, wall, .. } = given;
        let law = law(name, [given.stiffness, given.damping_time, given.friction])?;
        let bodies = [
            body_index(name, self.tree, post.body.as_ref())?,
            body_index(name, self.tree, wall.body.as_ref())?,
        ];
        if bodies[0] == bodies[1] {
            return error(name, "its post and its wall are on one body; a body does not guide itself");
        }
        let landing = Landing { post: build_post(name, post)?, wall: build_wall(name, wall)? };
        let first = self.add_places(name, &given.group, &Facing::new(bodies, self.tree), law, PLACES);
        self.made.finders.push(Finder::Landing(first, Box::new(landing)));
        Ok(())
    }

    /// A support that a step of the plan takes away.
    fn removal(&mut self, index: usize, step: &str, name: &str) -> Result<(), BuildError> {
        let own = |finder: &&Finder| matches!(finder, Finder::Pad(touch, _) if self.constraints[*touch].name() == name);
        let Some(&Finder::Pad(touch, _)) = self.made.finders.iter().find(own) else {
            return error(step, format!("there is no support `{name}` to take away"));
        };
        if self.made.removals.iter().any(|removal| removal.touch == touch) {
            return error(step, format!("`{name}` is taken away already; once is right"));
        }
        self.made.removals.push(Removal { touch, due: Due::Step(index) });
        Ok(())
    }

    /// Adds touches for the places of a pair, numbered from 1; which constraint the first of them is.
    fn add_places(&mut self, name: &str, group: &str, facing: &Facing, law: [f64; 3], count: usize) -> usize {
        let first = self.constraints.len();
        for place in 1..=count {
            self.add(format!("{name}/{place}"), group, facing.clone(), law, false);
        }
        first
    }

    /// Adds a touch; which constraint it is.
    fn add(&mut self, name: String, group: &str, facing: Facing, law: [f64; 3], is_support: bool) -> usize {
        let index = self.constraints.len();
        let group = ContactGroup::named(self.groups, group, self.tree);
        self.groups[group].contacts.push(index);
        let [stiffness, damping_time, friction] = law;
        self.constraints.push(AnyConstraint::Touch(Touch {
            name,
            index,
            group,
            is_support,
            facing,
            spot: self.made.spots.len(),
            compliance: 1.0 / stiffness,
            damping_time,
            friction,
        }));
        self.made.spots.push(Spot::none());
        index
    }
}

fn law(name: &str, [stiffness, damping_time, friction]: [f64; 3]) -> Result<[f64; 3], BuildError> {
    positive(name, "its stiffness", stiffness)?;
    at_least_zero(name, "its damping time", damping_time)?;
    at_least_zero(name, "its friction", friction)?;
    Ok([stiffness, damping_time, friction])
}

/// A rim, and the plane that it may touch.
fn build_rim(given: &RimSpec) -> Result<(Rim, Plane), BuildError> {
    let name = &given.name;
    finite(name, "its place", &[given.at, given.plane_point].concat())?;
    positive(name, "its radius", given.radius)?;
    let axis = unit(name, "its axis", given.axis)?;
    let normal = unit(name, "the plane's normal", given.plane_normal)?;
    let rim = Rim { centre: vector(given.at), axis, radius: given.radius, dome: DOME };
    Ok((rim, Plane::new(vector(given.plane_point), normal)))
}

fn build_post(name: &str, given: &PostSpec) -> Result<Post, BuildError> {
    let PostSpec { base, radius, height, cone, tip_radius, .. } = *given;
    finite(name, "the place of its post", &base)?;
    positive(name, "the radius of its post", radius)?;
    positive(name, "the height of its post", height)?;
    at_least_zero(name, "the length of its cone", cone)?;
    at_least_zero(name, "the radius of its tip", tip_radius)?;
    if tip_radius > radius {
        return error(name, format!("its tip has a radius of {tip_radius} m, more than that of its post"));
    }
    let axis = unit(name, "the axis of its post", given.axis)?;
    Ok(Post { base: vector(base), axis, radius, height, cone, tip_radius })
}

fn build_wall(name: &str, given: &WallSpec) -> Result<Wall, BuildError> {
    let WallSpec { knee, height, breadth, flare, angle, .. } = *given;
    finite(name, "the place of its wall", &knee)?;
    positive(name, "the height of its wall", height)?;
    positive(name, "the breadth of its wall", breadth)?;
    at_least_zero(name, "the length of its flare", flare)?;
    if !(0.0..std::f64::consts::FRAC_PI_2).contains(&angle) {
        return error(
            name,
            format!("its flare leans by {angle} rad; from 0 to less than a right angle is right"),
        );
    }
    let normal = unit(name, "the normal of its wall", given.normal)?;
    let up = unit(name, "the upward direction of its wall", given.up)?;
    if normal.dot(up).abs() > FLAT {
        return error(name, "the normal and the upward direction of its wall are not at right angles");
    }
    Ok(Wall { knee: vector(knee), normal, up, height, half: 0.5 * breadth, flare, angle })
}

/// The top of a support with what may lie on it.
fn build_pad(given: &SupportSpec) -> Result<Pad, BuildError> {
    let name = &given.name;
    finite(name, "its place", &given.at)?;
    for half in given.half {
        positive(name, "half a side of its top", half)?;
    }
    let along = unit(name, "the direction of its first side", given.along)?;
    let Some(top) = top(vector(given.at), DVec3::Z, along) else {
        return error(name, "the direction of its first side is upright; it must be level");
    };
    if given.sides.is_empty() {
        return error(name, "no side of the body may lie on it; one at least is right");
    }
    let sides = given.sides.iter().map(|corners| build_side(name, corners)).collect::<Result<_, _>>()?;
    Ok(Pad { top, half: given.half, sides })
}

/// A side with these corners, anticlockwise from outside.
fn build_side(name: &str, given: &[[f64; 3]]) -> Result<Side, BuildError> {
    finite(name, "a corner of a side", given.as_flattened())?;
    let corners: Vec<DVec3> = given.iter().copied().map(vector).collect();
    if corners.len() < 3 {
        return error(name, "a side needs three corners at least");
    }
    let area: DVec3 = corners.windows(2).map(|pair| (pair[0] - corners[0]).cross(pair[1] - corners[0])).sum();
    let size = corners.iter().map(|corner| (*corner - corners[0]).length()).fold(0.0, f64::max);
    let Some(normal) = area.try_normalize().filter(|_| area.length() > 1e-9 * size * size) else {
        return error(name, "the corners of a side are in one line");
    };
    let face = Plane::new(corners[0], normal);
    if corners.iter().any(|corner| face.depth(*corner).abs() > FLAT * size) {
        return error(name, "the corners of a side are not in one plane");
    }
    let outline: Vec<[f64; 2]> = corners.iter().map(|corner| face.along(*corner)).collect();
    let turn = |at: usize| {
        let [from, to, next] = [0, 1, 2].map(|ahead| outline[(at + ahead) % outline.len()]);
        (to[0] - from[0]) * (next[1] - to[1]) - (to[1] - from[1]) * (next[0] - to[0])
    };
    let turns: Vec<f64> = (0..outline.len()).map(turn).collect();
    if turns.iter().any(|turn| *turn <= 0.0) {
        return error(name, "a side is not convex, or has a corner in a straight edge");
    }
    Ok(Side::new(face, outline))
}

/// Distances that are recorded.
pub(super) fn build_watches(spec: &SystemSpec, shapes: &[BodyShape]) -> Result<Vec<Watch>, BuildError> {
    let watched = |name: &str, given: &WatchedSpec| {
        let mut watched = Watched::default();
        for shape in &given.shapes {
            watched.shapes.push(shape_named(name, shapes, shape)?);
        }
        for rope in &given.ropes {
            let Some(index) = spec.ropes.iter().position(|one| one.name == rope.rope) else {
                return error(name, format!("there is no rope `{}`", rope.rope));
            };
            at_least_zero(name, "the radius of a rope", rope.radius)?;
            for part in rope.without {
                at_least_zero(name, "what is left out of a rope", part)?;
            }
            watched.ropes.push(WatchedRope { rope: index, radius: rope.radius, without: rope.without });
        }
        if watched.shapes.is_empty() && watched.ropes.is_empty() {
            return error(name, "one side of it names no shape and no rope");
        }
        Ok(watched)
    };
    let watch = |given: &crate::spec::WatchSpec| {
        let [one, other] = &given.between;
        let between = [watched(&given.name, one)?, watched(&given.name, other)?];
        if between.iter().all(|side| !side.ropes.is_empty()) {
            return error(&given.name, "both sides of it name ropes; one side has shapes only");
        }
        Ok(Watch { name: given.name.clone(), between })
    };
    spec.watches.iter().map(watch).collect()
}
