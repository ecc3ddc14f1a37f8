//! Groups of ropes whose lengths are adjusted.

use super::{BuildError, error, positive};
use crate::constraint::AnyConstraint;
use crate::constraint::rope::span::Span;
use crate::spec::{AdjusterSpec, SystemSpec};
use crate::system::{Adjuster, Rows};

pub(super) fn build_adjusters(
    spec: &SystemSpec,
    constraints: &[AnyConstraint],
    rows: &Rows,
) -> Result<Vec<Adjuster>, BuildError> {
    let mut built: Vec<Adjuster> = Vec::with_capacity(spec.adjusters.len());
    for given in &spec.adjusters {
        let adjuster = build_adjuster(given, constraints, rows)?;
        for (index, row) in adjuster.rows.iter().enumerate() {
            let taken = built.iter().any(|other| other.rows.contains(row));
            if taken || adjuster.rows[..index].contains(row) {
                let rope = &given.ropes[index];
                return error(&given.name, format!("its rope `{rope}` is adjusted twice; once is right"));
            }
        }
        built.push(adjuster);
    }
    Ok(built)
}

fn build_adjuster(
    given: &AdjusterSpec,
    constraints: &[AnyConstraint],
    rows: &Rows,
) -> Result<Adjuster, BuildError> {
    let AdjusterSpec { name, ropes, factor } = given;
    positive(name, "its factor", *factor)?;
    if ropes.len() < 2 {
        return error(
            name,
            format!("it has {} ropes; to take over length from each other takes two", ropes.len()),
        );
    }
    let row = |wanted: &String| {
        let found = constraints.iter().enumerate().find_map(|(index, constraint)| match constraint {
            AnyConstraint::Rope(rope) if rope.name == *wanted => Some((index, rope)),
            _ => None,
        });
        let Some((index, rope)) = found else { return error(name, format!("there is no rope `{wanted}`")) };
        if rope.material.is_inextensible() {
            let problem =
                format!("its rope `{wanted}` is inextensible, so that no length goes with its tension");
            return error(name, problem);
        }
        if rope.spans.iter().any(Span::is_scaled) {
            let problem = format!(
                "its rope `{wanted}` is fed by drums or sheaves, or has a curve; its length cannot be adjusted"
            );
            return error(name, problem);
        }
        Ok(rows.first[index])
    };
    Ok(Adjuster {
        name: name.clone(),
        rows: ropes.iter().map(row).collect::<Result<_, _>>()?,
        factor: *factor,
    })
}
