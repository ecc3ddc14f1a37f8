//! Vessels and their marks.

use std::f64::consts::PI;

use glam::DVec3;

use super::{BuildError, error, finite, unique};
use crate::event::afloat::{Mark, Vessel};
use crate::spec::SystemSpec;
use crate::tree::Tree;

pub(super) fn build_vessels(spec: &SystemSpec, tree: &Tree) -> Result<(Vec<Vessel>, Vec<Mark>), BuildError> {
    unique("vessel", spec.vessels.iter().map(|vessel| vessel.name.as_str()))?;
    let marks = spec.vessels.iter().flat_map(|vessel| &vessel.marks);
    unique("mark", marks.map(|mark| mark.name.as_str()))?;
    let (mut vessels, mut marks) = (Vec::new(), Vec::new());
    for given in &spec.vessels {
        let name = &given.name;
        let Some(body) =
            tree.bodies.iter().position(|body| body.name == given.body && body.joint.moves_body())
        else {
            return error(name, format!("there is no body `{}` that floats", given.body));
        };
        finite(name, "the level of its water", &[given.level])?;
        if tree.gravity.length() == 0.0 {
            return error(name, "there is no gravity, so nothing is upright; give it gravity");
        }
        if !(given.capsized_beyond > 0.0 && given.capsized_beyond < PI) {
            let problem =
                format!("it has capsized beyond {} rad; that is between 0 and π", given.capsized_beyond);
            return error(name, problem);
        }
        for mark in &given.marks {
            finite(&mark.name, "a point of it", mark.points.as_flattened())?;
            if mark.points.is_empty() {
                return error(&mark.name, "it has no points");
            }
            let points = mark.points.iter().map(|point| DVec3::from_array(*point)).collect();
            marks.push(Mark { name: mark.name.clone(), vessel: vessels.len(), points });
        }
        finite(name, "a corner of its bottom", given.bottom.as_flattened())?;
        let bottom = given.bottom.iter().map(|point| DVec3::from_array(*point)).collect();
        let (level, capsized_beyond) = (given.level, given.capsized_beyond);
        vessels.push(Vessel { name: name.clone(), body, level, capsized_beyond, bottom });
    }
    Ok((vessels, marks))
}
