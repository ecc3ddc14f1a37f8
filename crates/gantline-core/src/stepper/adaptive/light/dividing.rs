//! How rope over light sheaves is divided at a point: lengths of its spans are measured, tensions divided as the sheaves
//! hold or slip, and what passes every sheave, and how fast, follows from them.

use std::ops::Range;

use super::{Laid, Laying, Light, way_of};
use crate::constraint::rope::Rope;
use crate::constraint::rope::span::Stretch;
use crate::constraint::{AnyConstraint, Moving};
use crate::rope::coil::Coil;
use crate::rope::light::{Division, Spans};
use crate::solver::complementarity::Mode;
use crate::stepper::adaptive::evaluation::Evaluation;
use crate::stepper::adaptive::point::Point;
use crate::stepper::coils::feeding;
use crate::system::{LightSheaves, System};

/// The rope that runs over a row of light sheaves, if it is one, and where its first span stands among its spans.
fn rope_of<'a>(system: &'a System, light: &LightSheaves) -> Option<(&'a Rope, usize)> {
    match &system.constraints[light.rope] {
        AnyConstraint::Rope(rope) => Some((rope, light.rows.start - system.rows.first[light.rope])),
        _ => None,
    }
}

impl Evaluation {
    /// Measures the ropes over light sheaves and divides them; coordinates and velocities of their flows follow. The
    /// velocities of the bodies are known.
    pub fn divide(&mut self, system: &System, at: &Point, modes: &[Mode]) {
        let (mut first, mut measured) = (0, usize::MAX);
        for (index, light) in system.light.iter().enumerate() {
            let Some((rope, place)) = rope_of(system, light) else { continue };
            if measured != light.rope {
                measured = light.rope;
                self.measure(system, at, (light.rope, rope));
            }
            let spans = place..place + light.rows.len();
            let own = first..first + light.dofs.len();
            first = own.end;
            let mut both = std::mem::take(&mut self.light[index]);
            let on = (light, rope, spans);
            let drums = (at.coils, modes);
            place_all(light, &mut self.q, |sheave| at.base[light.positions[sheave]]);
            match at.laying {
                Laying::Anew => {
                    for (way, &row) in both.lies.slips.way.iter_mut().zip(&light.brakes) {
                        *way = way_of(modes, at.memory, row);
                    }
                    self.lay(on.clone(), &mut both.lies, false);
                    self.run(system, on, drums, (&mut both, false));
                }
                Laying::Frozen(frozen) => self.freeze(system, on, drums, (&mut both, &frozen[index])),
                Laying::Watched(frozen, laid) => {
                    self.freeze(system, on.clone(), drums, (&mut both, &frozen[index]));
                    self.judge(on, &mut both, (laid, own), at.schedule.time);
                    let passed = &both.lies.passed;
                    place_all(light, &mut self.q, |sheave| at.base[light.positions[sheave]] + passed[sheave]);
                }
                Laying::Laid(frozen, laid) => {
                    self.freeze(system, on.clone(), drums, (&mut both, &frozen[index]));
                    self.note_arriving(system, on.clone(), &mut both.arriving);
                    self.judge(on.clone(), &mut both, (laid, own), at.schedule.time);
                    // What begins here is divided from what the state will keep, as after a restore: the same bytes.
                    let Light { lies, other, .. } = &mut both;
                    std::mem::swap(lies, other);
                    self.lay(on.clone(), &mut both.lies, false);
                    self.run(system, on, drums, (&mut both, false));
                }
            }
            self.light[index] = both;
        }
    }

    /// Lengths of the spans of a rope and their rates, in place of values and rates of its rows.
    fn measure(&mut self, system: &System, at: &Point, (index, rope): (usize, &Rope)) {
        let own = system.rows.first[index]..system.rows.first[index + 1];
        let lines = system.rows.lines[index]..system.rows.lines[index + 1];
        let (kinematics, twists) = (&self.frame.kinematics, self.dynamics.twists.as_slice());
        let moving = Moving { kinematics, twists, q: &self.q, v: &self.v, seats: at.seats, spots: at.spots };
        let (length, rate) = (&mut self.frame.value[own.clone()], &mut self.rate[own]);
        rope.measure(&moving, length, rate, &mut self.lines[lines]);
    }

    /// Divides a rope with its sheaves going on as they do at another point.
    fn freeze(
        &mut self,
        system: &System,
        on: (&LightSheaves, &Rope, Range<usize>),
        drums: (&[Coil], &[Mode]),
        (both, frozen): (&mut Light, &Light),
    ) {
        both.lies.slips.copy_from(&frozen.moving);
        self.lay(on.clone(), &mut both.lies, true);
        self.run(system, on, drums, (both, true));
    }

    /// Divides a rope that has been frozen as it should be, from where it was laid.
    fn judge(
        &mut self,
        on: (&LightSheaves, &Rope, Range<usize>),
        both: &mut Light,
        (laid, own): (&Laid, Range<usize>),
        time: f64,
    ) {
        let light = on.0;
        both.other.slips.way.copy_from_slice(&laid.way[own.clone()]);
        for (sheave, (&position, &dof)) in light.positions.iter().zip(&light.dofs).enumerate() {
            self.q[position] = laid.farthest(own.start + sheave, time, [self.q[position], self.v[dof]]);
        }
        self.lay(on, &mut both.other, false);
        for (judged, &position) in both.judged.iter_mut().zip(&light.positions) {
            *judged = self.q[position];
        }
        both.judged_way.copy_from_slice(&both.other.slips.way);
    }

    /// Forces of the rows of a rope that has been frozen.
    fn note_arriving(
        &self,
        system: &System,
        (light, rope, spans): (&LightSheaves, &Rope, Range<usize>),
        arriving: &mut [f64],
    ) {
        for ((row, span), force) in light.rows.clone().zip(&rope.spans[spans]).zip(arriving) {
            let [value, rate] =
                span.answer(self.answers[row], [self.frame.value[row], self.rate[row]], &self.v);
            let law = &system.rows.laws[row];
            *force = (value + law.damping_time() * rate) / law.compliance();
        }
    }

    /// Divides a rope from where the flows of `q` have it, and lets them follow.
    fn lay(
        &mut self,
        (light, rope, spans): (&LightSheaves, &Rope, Range<usize>),
        lies: &mut Division,
        is_frozen: bool,
    ) {
        // ℓ T/(EA + T) = x + s_j − s_{j−1}, x = ℓ − L̂.
        let (rows, stiffness) = (light.rows.clone(), rope.material.axial_stiffness);
        let (stretch, compliance) = (&mut self.stretch[rows.clone()], &mut self.compliance[rows.clone()]);
        let mut excess = 0.0;
        let measured = self.frame.value[rows].iter().zip(&rope.spans[spans]);
        for ((stretch, compliance), (length, span)) in stretch.iter_mut().zip(&mut *compliance).zip(measured)
        {
            *stretch = length - span.unstretched(&self.q);
            *compliance = length / stiffness;
            excess += *stretch;
        }
        let given = Spans { ratio: &light.ratio, stretch, compliance, softening: 1.0 / stiffness };
        if is_frozen {
            lies.share(given);
        } else {
            lies.slips.is_loose = excess <= 0.0;
            lies.divide(given);
            lies.mark(&light.ratio);
        }
        for (&position, passed) in light.positions.iter().zip(&lies.passed) {
            self.q[position] += passed;
        }
    }

    /// Speeds over the sheaves: those that let dampers pull in the ratios of the springs.
    fn run(
        &mut self,
        system: &System,
        (light, rope, spans): (&LightSheaves, &Rope, Range<usize>),
        (wound, modes): (&[Coil], &[Mode]),
        (both, is_frozen): (&mut Light, bool),
    ) {
        let rows = light.rows.clone();
        for &dof in &light.dofs {
            self.v[dof] = 0.0;
        }
        let spans = &rope.spans[spans];
        for (span, row) in spans.iter().zip(rows.clone()) {
            let Stretch { unstretched, scale, supply, .. } = span.stretch(&self.q, self.frame.value[row]);
            self.answers[row] = [scale, -supply, unstretched];
            self.stretch[row] = -scale * self.rate[row] / supply;
            self.compliance[row] = -system.rows.laws[row].compliance() / (scale * supply);
        }
        // What else feeds the rope does so at its ends.
        for place in [0, spans.len() - 1] {
            let (span, row) = (&spans[place], rows.start + place);
            let strain = self.frame.value[row] / self.answers[row][2] - 1.0;
            let outside = if modes[row].carries() { strain.max(0.0) } else { 0.0 };
            let coils = span.feeds.iter().filter_map(|feed| Some((feed.coil?, feed.dof)));
            let let_go = coils.map(|(coil, dof)| {
                feeding(&system.coils[coil], &wound[coil], &self.q, outside).1 * self.v[dof]
            });
            self.stretch[row] -= span.speed(&self.v) + let_go.sum::<f64>();
        }
        let Light { lies, runs, moving, .. } = both;
        let given = Spans {
            ratio: &light.ratio,
            stretch: &self.stretch[rows.clone()],
            compliance: &self.compliance[rows],
            softening: 0.0,
        };
        if is_frozen {
            runs.slips.copy_from(&lies.slips);
            runs.share(given);
        } else {
            runs.turn(given, &lies.slips);
        }
        moving.copy_from(&runs.slips);
        for (&dof, speed) in light.dofs.iter().zip(&runs.passed) {
            self.v[dof] = *speed;
        }
    }
}

/// Puts the flows of light sheaves where they are to be divided from.
fn place_all(light: &LightSheaves, q: &mut [f64], place: impl Fn(usize) -> f64) {
    for (sheave, &position) in light.positions.iter().enumerate() {
        q[position] = place(sheave);
    }
}
