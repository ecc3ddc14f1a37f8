//! Motion and forces at the moments at which groups of ropes pull most together, or pins bear most, which samples may miss.

use super::{ALIKE, Sample, Samples, Span, adjusted_rows};
use crate::constraint::AnyConstraint;
use crate::system::System;

/// Rows that bear one thing together: of ropes that pull at it, or of pins that hold it square to each other.
#[derive(Debug, Clone, Default)]
pub struct Bearers {
    /// How many times the force of each row counts.
    rows: Vec<(usize, f64)>,
    are_pins: bool,
}

impl Bearers {
    /// What they bear together [N, or N m of pins that keep it from turning] where `of` is the force of a row: ropes what they
    /// pull, pins the length of the force.
    pub fn together(&self, of: impl Fn(usize) -> f64) -> f64 {
        let forces = self.rows.iter().map(|&(row, times)| times * of(row));
        if self.are_pins {
            forces.map(|force| force * force).sum::<f64>().sqrt()
        } else {
            forces.map(|force| force.max(0.0)).sum()
        }
    }
}

/// The moment at which a group has borne most so far.
#[derive(Debug, Clone)]
struct Moment {
    /// What that was [N or N m]; less than nothing before the first step.
    most: f64,
    /// One sample of that moment; none before the first step.
    sample: Samples,
}

/// The moments of all groups. Reused from step to step.
#[derive(Debug, Clone)]
pub struct Pulls {
    moments: Vec<Moment>,
    /// Those of a group.
    bearers: Bearers,
    sample: Sample,
    /// Rows that are adjusted.
    adjusted: Vec<usize>,
}

impl Pulls {
    /// Those of a run that has not begun, through samples like `sample`.
    pub fn new(system: &System, sample: Sample) -> Self {
        let none = Moment { most: -1.0, sample: Samples::default() };
        let moments = vec![none; system.pulls.len()];
        Self { moments, bearers: Bearers::default(), sample, adjusted: adjusted_rows(system) }
    }

    /// What a group has borne most in a step that ended at `q`, and the share of the step at which it was, where it is
    /// more than ever, by more than rounding: `pull` gives the largest of what rows bear together, where it is more than
    /// what is known.
    pub fn found(
        &mut self,
        system: &System,
        group: usize,
        q: &[f64],
        pull: impl FnOnce(&Bearers, f64) -> Option<(f64, f64)>,
    ) -> Option<(f64, f64)> {
        let Bearers { rows, are_pins } = &mut self.bearers;
        rows.clear();
        *are_pins = false;
        for &index in &system.pulls[group] {
            let first = system.rows.first[index];
            match &system.constraints[index] {
                AnyConstraint::Rope(of) => {
                    rows.extend((first..).zip(of.spans.iter().map(|span| span.scale(q))));
                }
                _ => {
                    rows.push((first, 1.0));
                    *are_pins = true;
                }
            }
        }
        pull(&self.bearers, self.moments[group].most * (1.0 + ALIKE))
    }

    /// Keeps the moment that was found for a group; `motion` gives the sample at a share of the step.
    pub fn keep(
        &mut self,
        system: &System,
        group: usize,
        (most, share): (f64, f64),
        span: &Span,
        motion: impl FnOnce(&Span, f64, &mut Sample),
    ) {
        motion(span, share, &mut self.sample);
        let time = span.before.time + share * (span.after.time - span.before.time);
        let moment = &mut self.moments[group];
        moment.most = most;
        moment.sample.clear();
        let of = (self.adjusted.as_slice(), system.plan.compensators.as_slice());
        moment.sample.push_within(of, span, (time, share), &self.sample);
    }

    /// One sample for each group, in their order; fewer before the first step.
    pub fn samples(&self) -> Samples {
        let mut all = Samples::default();
        self.moments.iter().for_each(|moment| all.append(&moment.sample));
        all
    }

    /// What is written of them.
    pub(crate) fn packed(&self) -> Vec<(f64, Vec<u8>)> {
        self.moments.iter().map(|moment| (moment.most, moment.sample.packed())).collect()
    }

    /// Takes up what was written of so many groups; false where it is something else.
    pub(crate) fn unpack(&mut self, written: &[(f64, Vec<u8>)]) -> bool {
        let moment = |(most, bytes): &(f64, Vec<u8>)| {
            Samples::unpacked(bytes).map(|sample| Moment { most: *most, sample })
        };
        let Some(moments) = written.iter().map(moment).collect::<Option<Vec<_>>>() else { return false };
        let fits = moments.len() == self.moments.len();
        self.moments = moments;
        fits
    }
}
