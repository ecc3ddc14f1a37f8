//! Mooring lines: checks, and lengths from what they pull at the start.

use glam::DVec3;

use super::{BuildError, at_least_zero, error, finite, positive};
use crate::force::AnyForce;
use crate::force::mooring::catenary::{Catenary, Hanging};
use crate::force::mooring::{Mooring, Winch};
use crate::spec::{ForceSpec, MooringSpec, SystemSpec};
use crate::tree::joint::Joint;
use crate::tree::kinematics::Kinematics;
use crate::tree::{Body, Tree};

/// How far the lower end may be from the bed that it lies on [m].
const ON_BED: f64 = 1e-3;
/// Largest mean strain at the start.
const STRAIN: f64 = 0.1;
/// Halvings down to the last bit of a length.
const HALVINGS: usize = 200;

/// A line whose length is set by [`place_moorings`].
pub(super) fn build_mooring(given: &MooringSpec, body: usize, tree: &Tree) -> Result<Mooring, BuildError> {
    check_line(given, tree)?;
    let winch = match &given.winch {
        Some(wanted) => Some(find_winch(&given.name, wanted, body, tree)?),
        None => None,
    };
    Ok(Mooring {
        name: given.name.clone(),
        body,
        at: DVec3::from_array(given.at),
        to: DVec3::from_array(given.to),
        line: Catenary {
            weight: given.weight,
            stiffness: given.axial_stiffness,
            on_bed: given.sea_bed.is_some(),
        },
        length: given.length.unwrap_or(0.0),
        damping_time: given.damping_time,
        winch,
        breaking_force: given.breaking_force,
        lowest: 0.0,
        mark: 0,
    })
}

/// Whether a line can be as the document has it, wherever what it holds is.
fn check_line(given: &MooringSpec, tree: &Tree) -> Result<(), BuildError> {
    let name = &given.name;
    finite(name, "a place", &[given.at, given.to].concat())?;
    positive(name, "its weight", given.weight)?;
    positive(name, "its axial stiffness", given.axial_stiffness)?;
    at_least_zero(name, "its damping time", given.damping_time)?;
    if tree.gravity.length() == 0.0 {
        return error(name, "there is no gravity, so it does not hang; give it gravity");
    }
    match (given.length, given.pretension) {
        (Some(length), None) => positive(name, "its length", length)?,
        (None, Some(pretension)) => positive(name, "its pretension", pretension)?,
        (Some(_), Some(_)) => {
            return error(name, "it has a length and a pretension; one follows from the other");
        }
        (None, None) => return error(name, "it needs a length or a pretension"),
    }
    if let Some(force) = given.breaking_force {
        positive(name, "its breaking force", force)?;
    }
    if let Some(time) = given.cut_at {
        at_least_zero(name, "the time at which it is cut", time)?;
    }
    let up = -tree.gravity / tree.gravity.length();
    if let Some(bed) = given.sea_bed {
        finite(name, "the sea bed", &[bed])?;
        let above = DVec3::from_array(given.to).dot(up) - bed;
        if above.abs() > ON_BED {
            let side = if above > 0.0 { "below" } else { "above" };
            let apart = above.abs();
            return error(
                name,
                format!(
                    "the sea bed is {apart} m {side} its lower end; a line rests on the bed on which it is made fast"
                ),
            );
        }
    }
    Ok(())
}

/// The winch of the line `name`: the flow of the name `wanted` on the body that the line holds.
fn find_winch(name: &str, wanted: &str, body: usize, tree: &Tree) -> Result<Winch, BuildError> {
    let is_its = |other: &&Body| {
        other.name == wanted && other.parent == Some(body) && matches!(other.joint, Joint::Flow(_))
    };
    let Some(flow) = tree.bodies.iter().find(is_its) else {
        return error(name, format!("`{wanted}` is no flow on the body that it holds"));
    };
    let (dof, position) = (flow.first_velocity, flow.first_position);
    Ok(Winch { dof, position, unstretched: 1.0, held: 0.0 })
}

/// Gives all lines their lengths and their marks, with everything where it is at the start.
pub(super) fn place_moorings(
    spec: &SystemSpec,
    tree: &mut Tree,
    start: &Kinematics,
) -> Result<(), BuildError> {
    let gravity = tree.gravity;
    for (force, given) in tree.forces.iter_mut().zip(&spec.forces) {
        let (AnyForce::Mooring(mooring), ForceSpec::Mooring(given)) = (force, given) else { continue };
        let place = start.pose[mooring.body].point(mooring.at) - mooring.to;
        let up = -gravity / gravity.length();
        let height = place.dot(up);
        if mooring.line.on_bed && height <= 0.0 {
            let below = height.abs();
            let problem = format!("its upper end is {below} m below the sea bed; it must be above");
            return error(&given.name, problem);
        }
        let (aside, chord) = ((place - up * height).length(), place.length());
        positive(&given.name, "the distance of its ends", chord)?;
        if let Some(pretension) = given.pretension {
            mooring.length = length_for(&given.name, &mooring.line, [aside, height], pretension)?;
        }
        let (tension, strain) = mooring.start(&start.pose[mooring.body], gravity);
        let breaks = given.breaking_force.is_some_and(|force| tension >= force);
        if breaks || strain > STRAIN {
            let Mooring { length, .. } = **mooring;
            let sentence = match given.pretension {
                Some(pretension) if breaks => {
                    format!("its pretension of {pretension} N is no less than its breaking force")
                }
                Some(pretension) => format!(
                    "its pretension of {pretension} N stretches it by {:.1} %, and a start allows {} %; give it less, or \
                     a rope of more axial stiffness",
                    100.0 * strain,
                    100.0 * STRAIN
                ),
                None => format!(
                    "its length of {length} m is too short for ends that are {chord} m apart: it would pull with \
                     {tension} N"
                ),
            };
            return error(&given.name, sentence);
        }
        mooring.mark = tree.positions;
        tree.positions += 1;
        tree.marks += 1;
    }
    Ok(())
}

/// The shortest length at which the upper end pulls with `wanted` [N]: longer lines first pull less, and then more by their
/// weight.
fn length_for(
    name: &str,
    line: &Catenary,
    [aside, height]: [f64; 2],
    wanted: f64,
) -> Result<f64, BuildError> {
    let chord = aside.hypot(height);
    let reach = aside.max(1e-6 * chord);
    // Tension less what is wanted, and how it grows with the length.
    let pull = |length: f64| {
        let hanging: Hanging = line.hang(reach, height, length);
        let (h, v) = (hanging.horizontal, hanging.vertical);
        let tension = h.hypot(v);
        let [over_h, over_v] = [0, 1].map(|row| hanging.energy.second[row][2]);
        (tension - wanted, (h * over_h + v * over_v) / tension)
    };
    let mut short = chord / (1.0 + 2.0 * wanted / line.stiffness);
    while pull(short).0 <= 0.0 {
        short *= 0.5;
    }
    let (mut long, mut more) = (short, 1e-3 * chord);
    let least = loop {
        long += more;
        more *= 1.5;
        let (over, growth) = pull(long);
        if over <= 0.0 {
            break long;
        }
        if growth >= 0.0 {
            // The least tension lies between: where it grows neither way.
            let lightest = halve([short, long], |length| pull(length).1 < 0.0);
            let (over, _) = pull(lightest);
            if over > 0.0 {
                let least = over + wanted;
                return error(
                    name,
                    format!(
                        "no length gives it a pretension of {wanted:.0} N; its weight alone pulls with {least:.0} N"
                    ),
                );
            }
            break lightest;
        }
    };
    Ok(halve([short, least], |length| pull(length).0 > 0.0))
}

/// Where `is_low` ends, between two lengths.
fn halve([mut low, mut high]: [f64; 2], is_low: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if is_low(middle) { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
