//! Ropes: guides, routes, spans and what feeds them.

use std::sync::Arc;

use glam::{DMat3, DQuat, DVec3};

use super::coils::check_drum;
use super::rows::{body_index, flow_named};
use super::{BuildError, at_least_zero, error, finite, positive, unit};
use crate::constraint::rope::Rope;
use crate::constraint::rope::span::{Feed, Span};
use crate::rope::curve::Curve;
use crate::rope::guide::{Attachment, Guide};
use crate::rope::material::Material;
use crate::rope::route::Route;
use crate::rope::seat::Seat;
use crate::spec::{GrooveSpec, GuideSpec, MaterialSpec, RopeSpec};
use crate::tree::Tree;
use crate::tree::kinematics::Kinematics;

/// Largest stretch of a rope over sheaves at the start: more is a mistake in its length.
const MOST_STRAIN: f64 = 0.02;

/// What feeds the spans on both sides of a guide.
#[derive(Clone, Copy)]
struct FeedSpec<'a> {
    /// Name of the flow.
    flow: &'a String,
    /// ∂L/∂s before and after the guide.
    rates: [f64; 2],
    /// Number of its coil, of a drum.
    coil: Option<usize>,
}

fn build_guide<'a>(
    name: &str,
    given: &'a GuideSpec,
    tree: &Tree,
    (seat, coil): (usize, usize),
) -> Result<(Guide, Option<FeedSpec<'a>>), BuildError> {
    Ok(match given {
        GuideSpec::End { body, at, drum } => {
            finite(name, "a point of its route", at)?;
            let body = body_index(name, tree, body.as_ref())?;
            let feed = match drum {
                Some(drum) => {
                    finite(name, "the rate of its drum", &[drum.rate])?;
                    check_drum(name, drum)?;
                    Some(FeedSpec { flow: &drum.flow, rates: [1.0; 2], coil: Some(coil) })
                }
                None => None,
            };
            (Guide::End(Attachment { body, at: DVec3::from_array(*at) }), feed)
        }
        GuideSpec::HalfTurn { body, enter, leave, bulge, flow, ratio, groove } => {
            check_losses(name, flow.is_some(), *ratio, groove.as_ref())?;
            finite(name, "a point of its route", &[*enter, *leave].concat())?;
            let body = body_index(name, tree, body.as_ref())?;
            let guide = Guide::HalfTurn {
                enter: Attachment { body, at: DVec3::from_array(*enter) },
                leave: Attachment { body, at: DVec3::from_array(*leave) },
                bulge: unit(name, "the bulge of a sheave", *bulge)?,
            };
            (guide, flow.as_ref().map(|flow| FeedSpec { flow, rates: [-1.0, 1.0], coil: None }))
        }
        GuideSpec::Eye { body, at } => {
            finite(name, "a point of its route", at)?;
            let body = body_index(name, tree, body.as_ref())?;
            (Guide::Eye(Attachment { body, at: DVec3::from_array(*at) }), None)
        }
        GuideSpec::Sheave { body, at, axis, radius, may_lift_off, flow, ratio, groove } => {
            check_losses(name, flow.is_some(), *ratio, groove.as_ref())?;
            if *may_lift_off && flow.is_some() {
                return error(
                    name,
                    "a rope does not leave a sheave with losses or inertia, over which it flows",
                );
            }
            finite(name, "a point of its route", at)?;
            positive(name, "the radius of a sheave", *radius)?;
            let body = body_index(name, tree, body.as_ref())?;
            let centre = Attachment { body, at: DVec3::from_array(*at) };
            let axis = unit(name, "the axis of a sheave", *axis)?;
            let (radius, may_lift_off) = (*radius, *may_lift_off);
            let guide = Guide::Sheave { centre, axis, radius, seat, may_lift_off, mark: None };
            (guide, flow.as_ref().map(|flow| FeedSpec { flow, rates: [-1.0, 1.0], coil: None }))
        }
    })
}

/// Whether losses of a sheave are any.
fn check_losses(
    name: &str,
    has_flow: bool,
    ratio: f64,
    groove: Option<&GrooveSpec>,
) -> Result<(), BuildError> {
    let is_lossy = ratio > 1.0 || groove.is_some();
    if ratio < 1.0 || ratio.is_nan() || is_lossy && !has_flow {
        let problem = "it must be 1 without a flow, else 1 or more, and a groove needs a flow";
        return error(name, format!("the ratio of tensions at a sheave is {ratio}; {problem}"));
    }
    let Some(groove) = groove else { return Ok(()) };
    at_least_zero(name, "the friction of a groove", groove.friction)?;
    if groove.spin.is_none() && ratio > 1.0 {
        return error(name, "a sheave that does not turn has no bearing to lose anything");
    }
    Ok(())
}

/// Marks the sheaves at which a rope's spans meet, in the middle of the arc at the start.
fn mark_sheaves(
    name: &str,
    route: &mut Route,
    feeds: &[Option<FeedSpec>],
    start: &Kinematics,
    seats: &[Seat],
) -> Result<(), BuildError> {
    let mut arrivals = vec![DVec3::ZERO; route.parts.len()];
    route.length(start, seats, |part, straight| arrivals[part] = straight.radial[1]);
    for (index, guide) in route.guides.iter_mut().enumerate() {
        let (Guide::Sheave { centre, axis, seat, mark, .. }, Some(_)) = (guide, &feeds[index]) else {
            continue;
        };
        let wrap = seats[*seat].wound.wrap;
        if wrap <= 0.0 {
            return error(name, "it does not lie on a sheave with losses or inertia at the start");
        }
        let about = start.turn(centre.body, *axis);
        let middle = DQuat::from_axis_angle(about, 0.5 * wrap) * arrivals[index - 1];
        let turned = centre.body.map_or(DMat3::IDENTITY, |body| start.pose[body].rotation.transpose());
        *mark = Some(turned * middle);
    }
    Ok(())
}

/// The spans between the guides that feed rope, with the length of the route shared out by what lies in each.
fn build_spans(
    name: &str,
    route: &Route,
    feeds: &[Option<FeedSpec>],
    share: f64,
    (tree, start, seats): (&Tree, &Kinematics, &[Seat]),
) -> Result<Vec<Span>, BuildError> {
    let feed = |given: &FeedSpec, rate: f64| {
        let body = flow_named(name, tree, given.flow)?;
        let (dof, coil) = (body.first_velocity, given.coil);
        let position = coil.map_or(body.first_position, |coil| tree.positions + coil);
        let increment = coil.map_or(dof, |coil| tree.velocities + coil);
        Ok(Feed { dof, position, increment, coil, entry: 0, rate })
    };
    let mut spans = Vec::new();
    let mut from = 0;
    for (index, given) in feeds.iter().enumerate().skip(1) {
        if given.is_none() && index < route.parts.len() {
            continue;
        }
        let inner: f64 = route.guides[from + 1..index].iter().map(Guide::fixed_arc).sum();
        let outer: f64 = [from, index].map(|guide| route.guides[guide].fixed_arc()).iter().sum();
        let arcs = inner + 0.5 * outer;
        let mut span = Span { parts: from..index, arcs, length: 0.0, feeds: Vec::new(), curve: None };
        if let Some(before) = &feeds[from] {
            span.feeds.push(feed(before, before.rates[1])?);
        }
        if let Some(after) = given {
            span.feeds.push(feed(after, after.rates[0])?);
        }
        if let [one, other] = &mut span.feeds[..]
            && one.dof == other.dof
            && one.coil.is_none()
            && other.coil.is_none()
        {
            one.rate += other.rate;
            span.feeds.pop();
        }
        span.length = share * (arcs + route.length_of(from..index, start, seats, |_, _| {}));
        spans.push(span);
        from = index;
    }
    Ok(spans)
}

/// Whether every part that ends on a sheave or an eye has a direction at the start.
fn check_parts(name: &str, route: &Route, start: &Kinematics) -> Result<(), BuildError> {
    let is_eye = |guide: &Guide| matches!(guide, Guide::Eye(_));
    for (index, (part, guides)) in route.parts.iter().zip(route.guides.windows(2)).enumerate() {
        if part.is_plain() && !guides.iter().any(is_eye) {
            continue;
        }
        if let Err(reason) = part.tangent(start, |_, circle| circle) {
            return error(name, format!("its part {} at the start: {reason}", index + 1));
        }
    }
    Ok(())
}

/// Lets the rope lie on its sheaves as it does at the start, and off those that it may leave and does not touch.
fn take_seats(route: &Route, start: &Kinematics, seats: &mut [Seat]) {
    // Passing one sheave straight changes the wrap of the next: each round settles one more at least.
    for _ in 0..route.guides.len() {
        let before = seats.to_vec();
        route.wraps(start, &before, |seat, wound| seats[seat].wound = wound);
        for guide in &route.guides {
            if let Guide::Sheave { seat, may_lift_off: true, .. } = *guide {
                seats[seat].is_off |= seats[seat].wound.wrap < 0.0;
            }
        }
        if seats.iter().zip(&before).all(|(now, before)| now.is_off == before.is_off) {
            return;
        }
    }
}

/// What the rope runs over, as it lies at the start, and what each of its guides feeds.
fn build_route<'a>(
    given: &'a RopeSpec,
    tree: &Tree,
    start: &Kinematics,
    (seats, coils): (&mut Vec<Seat>, &mut usize),
) -> Result<(Route, Vec<Option<FeedSpec<'a>>>), BuildError> {
    let name = &given.name;
    let (mut guides, mut feeds) = (Vec::new(), Vec::new());
    for guide in &given.route {
        let (guide, feed) = build_guide(name, guide, tree, (seats.len(), *coils))?;
        *coils += usize::from(feed.is_some_and(|feed| feed.coil.is_some()));
        if let Guide::Sheave { .. } = guide {
            seats.push(Seat::default());
        }
        guides.push(guide);
        feeds.push(feed);
    }
    let ends = [guides.first(), guides.last()];
    if guides.len() < 2 || !ends.iter().all(|guide| matches!(guide, Some(Guide::End(_)))) {
        return error(name, "its route must start and finish with an end");
    }
    let mut route = Route::new(guides);
    check_parts(name, &route, start)?;
    take_seats(&route, start, seats);
    // Past a sheave that the rope has left the sheaves before and after it may be in each other's way.
    if let Some((index, reason)) = route.refusal(start, seats) {
        return error(name, format!("its part {} at the start: {reason}", index + 1));
    }
    mark_sheaves(name, &mut route, &feeds, start, seats)?;
    Ok((route, feeds))
}

/// What the rope is made of, with its curve if it has one.
fn build_material(
    given: &RopeSpec,
    route: &Route,
    is_fed: bool,
) -> Result<(Material, Option<Arc<Curve>>), BuildError> {
    let name = &given.name;
    match &given.material {
        MaterialSpec::Inextensible {} if is_fed || route.parts.iter().any(|part| !part.is_plain()) => error(
            name,
            "an inextensible rope runs over eyes and half turns without losses only; \
             give it an axial stiffness",
        ),
        MaterialSpec::Inextensible {} => Ok((Material::INEXTENSIBLE, None)),
        MaterialSpec::Elastic { axial_stiffness, damping_time } => {
            positive(name, "its axial stiffness", *axial_stiffness)?;
            at_least_zero(name, "its damping time", *damping_time)?;
            Ok((Material::elastic(*axial_stiffness, *damping_time), None))
        }
        MaterialSpec::Curved { points, damping_time } => {
            at_least_zero(name, "its damping time", *damping_time)?;
            if route.guides.len() > 2 || is_fed {
                let problem = "a rope with a curve runs straight from end to end, without sheave or drum";
                return error(name, problem);
            }
            let Some(curve) = Curve::through(points) else {
                let problem = "strains and tensions of its curve rise from nothing, both at every point";
                return error(name, problem);
            };
            let material = Material::elastic(curve.axial_stiffness, *damping_time);
            Ok((material, Some(Arc::new(curve))))
        }
    }
}

/// A rope; `seats` grows by those of its sheaves, as they lie at the start, and `coils` by its ends on drums.
pub(super) fn build_rope(
    given: &RopeSpec,
    tree: &Tree,
    start: &Kinematics,
    (seats, coils): (&mut Vec<Seat>, &mut usize),
) -> Result<Rope, BuildError> {
    let name = &given.name;
    let (route, feeds) = build_route(given, tree, start, (&mut *seats, coils))?;
    let routed = route.length(start, seats, |_, _| {});
    let length = given.length.unwrap_or(routed);
    positive(name, "its length", length)?;
    // Where a rope touches its sheaves only the core knows, so that the check of its length is here.
    if !(route.is_plain || given.is_stretched) && routed > length * (1.0 + MOST_STRAIN) {
        return error(
            name,
            format!("its length is {length} m, but its route has {routed:.6} m at the start"),
        );
    }
    let is_fed = feeds.iter().any(Option::is_some);
    let (material, curve) = build_material(given, &route, is_fed)?;
    let spans = if is_fed {
        build_spans(name, &route, &feeds, length / routed, (tree, start, seats))?
    } else {
        vec![Span { parts: 0..route.parts.len(), arcs: route.arcs, length, feeds: Vec::new(), curve }]
    };
    Ok(Rope::new(name.clone(), route, spans, material, tree))
}
