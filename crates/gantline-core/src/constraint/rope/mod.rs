//! Length of a rope: g = Σ parts + Σ arcs − L (paper eqs. 16, 19, 20); where rope is fed, see [`span`].
//!
//! With n the unit direction of a part from A to B, ġ = Σ n·(v_B − v_A): each part adds n·(J_B − J_A), the
//! sum of eqs. (18) and (22). A degree of freedom that moves A and B as one rigid whole cannot change
//! |B − A| and is left out of the pattern: so the sheaves of an equalizer do not couple to what carries
//! the whole of it.

mod chords;
mod levers;
mod sheaves;
pub mod span;
mod turning;

use glam::{DMat3, DVec3};

use super::{Constraint, Law, Line, Moving, Placed};
use crate::rope::guide::Attachment;
use crate::rope::material::Material;
use crate::rope::part::{Part, Straight, unit};
use crate::rope::route::Route;
use crate::rope::seat::Seat;
use crate::tree::Tree;
use crate::tree::bias::Wrench;
use crate::tree::kinematics::{Kinematics, Twist};
use chords::{Chord, chords_of};
use levers::{Ends, Lever, PartLevers, add_levers, bend, pull, pulls, transversal, without};
use span::{Span, Stretch};

/// A rope as a constraint: one row per [`Span`].
#[derive(Debug, Clone)]
pub struct Rope {
    /// Unique name.
    pub name: String,
    /// Its way.
    pub route: Route,
    /// Unstretched length L where no flow has fed it [m].
    pub length: f64,
    /// What it is made of.
    pub material: Material,
    /// Stretches of one tension, from end to end.
    pub spans: Vec<Span>,
    /// Number of the span of every group: of the straight parts, then of the chords.
    pub span_of: Vec<usize>,
    /// Straight parts that may take the place of several.
    chords: Vec<Chord>,
    /// Degrees of freedom of every row.
    dofs: Vec<Vec<usize>>,
    levers: Vec<Lever>,
    parts: Vec<PartLevers>,
}

/// Arm [m], place [m] and velocity [m/s] of an end of a straight part.
// In the innermost loop of every method: a call would cost as much as the work.
#[inline(always)]
fn held((kinematics, twists): (&Kinematics, &[Twist]), attachment: &Attachment) -> (DVec3, DVec3, DVec3) {
    let Some(body) = attachment.body else { return (attachment.at, attachment.at, DVec3::ZERO) };
    let pose = &kinematics.pose[body];
    let arm = pose.rotation * attachment.at;
    (arm, pose.position + arm, twists[body].at(arm))
}

impl Rope {
    /// A rope in `tree`; the entries of the spans' feeds are set here.
    pub fn new(name: String, route: Route, mut spans: Vec<Span>, material: Material, tree: &Tree) -> Self {
        let chords = chords_of(&route);
        let ends_of = |part: &Part| -> Ends {
            let (from, to) = (tree.support_of(part.from.at.body), tree.support_of(part.to.at.body));
            (without(from, to), without(to, from))
        };
        let (mut levers, mut parts) = (Vec::new(), Vec::with_capacity(route.parts.len()));
        let (mut rows, mut span_of, mut base) = (Vec::new(), Vec::new(), 0);
        let mut bases = Vec::new();
        for (index, span) in spans.iter_mut().enumerate() {
            let ends: Vec<Ends> = route.parts[span.parts.clone()].iter().map(ends_of).collect();
            let moved = ends.iter().flat_map(|(from, to)| from.iter().chain(to)).copied();
            let mut dofs: Vec<usize> = moved.chain(span.feeds.iter().map(|feed| feed.dof)).collect();
            dofs.sort_unstable();
            dofs.dedup();
            add_levers(&ends, (&dofs, base), tree, (&mut levers, &mut parts));
            for feed in &mut span.feeds {
                feed.entry = base + dofs.partition_point(|&dof| dof < feed.dof);
            }
            bases.push(base);
            base += dofs.len();
            rows.push(dofs);
            span_of.resize(span.parts.end, index);
        }
        for chord in &chords {
            // What moves one end of a chord and not the other moves one end of some part of it: the row has it.
            let span = span_of[chord.guides.start];
            let ends = [ends_of(&chord.part)];
            let row: &[usize] = &rows[span];
            add_levers(&ends, (row, bases[span]), tree, (&mut levers, &mut parts));
            span_of.push(span);
        }
        let length = spans.iter().map(|span| span.length).sum();
        Self { name, route, length, material, spans, span_of, chords, dofs: rows, levers, parts }
    }

    /// Levers of the start and of the end of a straight part.
    fn ends(&self, part: PartLevers) -> (&[Lever], &[Lever]) {
        self.levers[part.start..part.end].split_at(part.split - part.start)
    }

    /// Where the straight parts lie now.
    pub fn straights<'a>(&'a self, kinematics: &'a Kinematics) -> impl Iterator<Item = Straight> + 'a {
        self.route.parts.iter().map(move |part| part.locate(kinematics))
    }

    /// Locates the parts of a span; returns its length [m] and the rate of that, both without what feeds it.
    fn locate_span(&self, span: &Span, at: &Moving, lines: &mut [Line]) -> (f64, f64) {
        let mut length = span.arcs;
        if !self.route.is_plain {
            let origin =
                |body: Option<usize>| body.map_or(DVec3::ZERO, |body| at.kinematics.pose[body].position);
            let parts = span.parts.clone();
            length += self.route.length_of(parts, at.kinematics, at.seats, |part, straight| {
                let Part { from, to } = &self.route.parts[part];
                let (from, to) = (straight.from - origin(from.at.body), straight.to - origin(to.at.body));
                let (direction, couple) = (straight.pull, straight.couple);
                lines[part - span.parts.start] = Line { from, to, direction, couple, supply: 0.0 };
            });
            return (length, self.rate_of(span, at.twists, lines));
        }
        let mut speed = 0.0;
        for (part, line) in self.route.parts[span.parts.clone()].iter().zip(lines) {
            let (from, start, start_velocity) = held((at.kinematics, at.twists), &part.from.at);
            let (to, stop, stop_velocity) = held((at.kinematics, at.twists), &part.to.at);
            let (direction, part_length) = unit(stop - start);
            length += part_length;
            speed += direction.dot(stop_velocity - start_velocity);
            *line = Line { from, to, direction, couple: [DVec3::ZERO; 2], supply: 0.0 };
        }
        (length, speed)
    }

    /// Mean over the straight parts of what its spans have each.
    pub fn mean(&self, of: impl Fn(usize) -> f64) -> f64 {
        if let [_] = self.spans[..] {
            return of(0);
        }
        let parts = self.spans.iter().enumerate();
        let sum: f64 = parts.map(|(span, one)| one.parts.len() as f64 * of(span)).sum();
        sum / self.route.parts.len() as f64
    }

    /// The tension of a span [N] that a force of its row stands for. Of a rope with a curve that takes where its ends are:
    /// what damps it is in the force and not in w.
    pub fn tension(&self, span: usize, kinematics: &Kinematics, q: &[f64], force: f64) -> f64 {
        let span = &self.spans[span];
        let Some(curve) = &span.curve else { return span.scale(q) * force };
        let length = self.route.parts[span.parts.start].locate(kinematics).length;
        curve.at(length / span.length - 1.0).scale * force
    }

    /// True where a curve has its tension by its strain.
    pub fn has_curve(&self) -> bool {
        // Such a rope has one span.
        self.spans[0].curve.is_some()
    }

    /// Lengths of the spans [m] and their rates [m/s], with unit vectors for lines.
    pub fn measure(&self, at: &Moving, length: &mut [f64], rate: &mut [f64], lines: &mut [Line]) {
        for (row, span) in self.spans.iter().enumerate() {
            (length[row], rate[row]) = self.locate_span(span, at, &mut lines[span.parts.clone()]);
        }
    }

    /// Turns what [`Rope::measure`] found into values and rates of the rows, by what feeds the spans at the configuration
    /// and with the velocities given. Of spans over light sheaves w, −∂g/∂L and L are `known`, where they are not zero.
    pub fn answer(
        &self,
        [q, v]: [&[f64]; 2],
        known: Option<&[[f64; 3]]>,
        (value, rate, lines): (&mut [f64], &mut [f64], &mut [Line]),
    ) {
        for (row, span) in self.spans.iter().enumerate() {
            if !span.is_scaled() {
                value[row] = span.stretch(q, value[row]).value;
                continue;
            }
            let known = known.map(|known| known[row]).filter(|[scale, ..]| *scale > 0.0);
            let [scale, supply, _] = match known {
                Some(answer) => {
                    [value[row], rate[row]] = span.answer(answer, [value[row], rate[row]], v);
                    [answer[0], -answer[1], answer[2]]
                }
                None => {
                    let Stretch { value: g, scale, supply, unstretched } = span.stretch(q, value[row]);
                    value[row] = g;
                    rate[row] = scale * rate[row] + supply * span.speed(v);
                    [scale, supply, unstretched]
                }
            };
            let lines = &mut lines[span.parts.clone()];
            for line in &mut *lines {
                line.direction *= scale;
                if !self.route.is_plain {
                    line.couple = line.couple.map(|couple| couple * scale);
                }
            }
            lines[0].supply = supply;
        }
    }

    /// Rate of a span along its lines, without what feeds it.
    fn rate_of(&self, span: &Span, twists: &[Twist], lines: &[Line]) -> f64 {
        let velocity = |body: Option<usize>, arm| body.map_or(DVec3::ZERO, |body| twists[body].at(arm));
        let turn = |body: Option<usize>| body.map_or(DVec3::ZERO, |body| twists[body].angular);
        let mut sum = 0.0;
        for (part, line) in self.route.parts[span.parts.clone()].iter().zip(lines) {
            let (from, to) = (part.from.at.body, part.to.at.body);
            sum += line.direction.dot(velocity(to, line.to) - velocity(from, line.from));
            if !self.route.is_plain {
                sum += line.couple[0].dot(turn(from)) + line.couple[1].dot(turn(to));
            }
        }
        sum
    }

    /// The part of the geometric stiffness of one straight part that is positive semidefinite by construction:
    /// fills `columns` with the transversal relative velocity c per degree of freedom of the group and returns
    /// the factor f of K = f Σ cᵢ·cⱼ, f = T/ℓ [N/m]; both zero for a part that is not there now. What its tension
    /// does to turning joints is told to `turns`, see [`turning`].
    pub fn geometric_stiffness(
        &self,
        (kinematics, seats): (&Kinematics, &[Seat]),
        tension: f64,
        group: usize,
        columns: &mut [DVec3],
        turns: impl FnMut(usize, DMat3),
    ) -> f64 {
        columns.fill(DVec3::ZERO);
        if !self.is_there(group, seats) {
            return 0.0;
        }
        let straight = self.part(group).locate(kinematics);
        self.transversals(kinematics, &straight, group, columns);
        self.turn(kinematics, (&straight, tension), group, turns);
        let factor = if straight.length > 0.0 { tension / straight.length } else { 0.0 };
        if let Some(curve) = &self.spans[self.span_of[group]].curve {
            // What a rope that gets stiffer adds along itself, λ f″/L.
            let bent = curve.at(straight.length / self.length - 1.0);
            let bend = bent.bend * tension / (bent.scale * self.length);
            if bend > 0.0 && factor > 0.0 {
                let along = straight.direction * (bend / factor).sqrt();
                let mut columns = columns.iter_mut();
                self.entries(kinematics, &straight, group, |entry| {
                    columns.next().into_iter().for_each(|column| *column += along * entry);
                });
            }
        }
        factor
    }

    /// How every degree of freedom of a group lengthens its straight part, in their order.
    fn entries(
        &self,
        kinematics: &Kinematics,
        straight: &Straight,
        group: usize,
        mut entry: impl FnMut(f64),
    ) {
        let (from, to) = self.ends(self.parts[group]);
        let [start, end] = straight.couple;
        pulls(kinematics, from, (straight.from, -straight.pull, start), |_, value| entry(value));
        pulls(kinematics, to, (straight.to, straight.pull, end), |_, value| entry(value));
    }

    /// How every degree of freedom of a group moves the end of the straight part against its start, across it.
    fn transversals(
        &self,
        kinematics: &Kinematics,
        straight: &Straight,
        group: usize,
        columns: &mut [DVec3],
    ) {
        let (from, to) = self.ends(self.parts[group]);
        transversal(kinematics, from, straight.from, (straight.direction, -1.0), columns);
        transversal(kinematics, to, straight.to, (straight.direction, 1.0), &mut columns[from.len()..]);
    }
}

impl Constraint for Rope {
    fn name(&self) -> &str {
        &self.name
    }

    fn row_dofs(&self) -> Vec<Vec<usize>> {
        self.dofs.clone()
    }

    fn laws(&self, _first_row: usize) -> Vec<Law> {
        let damping_time = self.material.damping_time;
        let compliances = self.spans.iter().map(|span| self.material.compliance(span.length));
        compliances.map(|compliance| Law::Unilateral { compliance, damping_time }).collect()
    }

    fn lines(&self) -> usize {
        self.route.parts.len()
    }

    fn locate(&self, at: &Moving, value: &mut [f64], rate: &mut [f64], lines: &mut [Line]) {
        self.measure(at, value, rate, lines);
        self.answer([at.q, at.v], None, (value, rate, lines));
    }

    fn rates(&self, twists: &[Twist], v: &[f64], lines: &[Line], rate: &mut [f64]) {
        for (span, rate) in self.spans.iter().zip(rate) {
            let lines = &lines[span.parts.clone()];
            *rate = self.rate_of(span, twists, lines) + lines[0].supply * span.supply_of(v);
        }
    }

    fn apply(&self, tension: &[f64], lines: &[Line], wrenches: &mut [Wrench]) {
        for (span, &tension) in self.spans.iter().zip(tension) {
            for (part, line) in self.route.parts[span.parts.clone()].iter().zip(&lines[span.parts.clone()]) {
                let pull = line.direction * tension;
                if let Some(body) = part.from.at.body {
                    wrenches[body].add(-pull, line.from);
                    wrenches[body].moment += line.couple[0] * tension;
                }
                if let Some(body) = part.to.at.body {
                    wrenches[body].add(pull, line.to);
                    wrenches[body].moment += line.couple[1] * tension;
                }
            }
        }
    }

    fn feed(&self, tension: &[f64], lines: &[Line], force: &mut [f64]) {
        for (span, tension) in self.spans.iter().zip(tension) {
            let pull = tension * lines[span.parts.start].supply;
            for feed in span.feeds.iter().filter(|feed| feed.coil.is_none()) {
                force[feed.dof] += pull * feed.rate;
            }
        }
    }

    fn evaluate(&self, at: &Placed, value: &mut [f64], gradient: &mut [f64]) {
        let mut first = 0;
        for (row, (span, dofs)) in self.spans.iter().zip(&self.dofs).enumerate() {
            let parts = span.parts.clone();
            let length = self.route.length_of(parts, at.kinematics, at.seats, |part, straight| {
                let (from, to) = self.ends(self.parts[part]);
                let [start, end] = straight.couple;
                pull(at.kinematics, from, (straight.from, -straight.pull, start), gradient);
                pull(at.kinematics, to, (straight.to, straight.pull, end), gradient);
            });
            let stretch = span.stretch(at.q, span.arcs + length);
            value[row] = stretch.value;
            if span.is_scaled() {
                for entry in &mut gradient[first..first + dofs.len()] {
                    *entry *= stretch.scale;
                }
                for feed in &span.feeds {
                    // What a drum does depends on what it has wound: see [`crate::stepper::coils`].
                    gradient[feed.entry] = if feed.coil.is_some() { 0.0 } else { stretch.supply * feed.rate };
                }
            }
            first += dofs.len();
        }
    }

    fn curvature_groups(&self) -> Vec<(usize, Vec<usize>)> {
        let groups = self.parts.iter().zip(&self.span_of).map(|(part, &span)| {
            let moved = self.levers[part.start..part.end].iter().map(|lever| lever.dof as usize);
            (span, moved.chain(self.spans[span].feeds.iter().map(|feed| feed.dof)).collect())
        });
        groups.collect()
    }

    /// ∂G_j/∂q_k = c_j·c_k/ℓ + n·(∂J_j/∂q_k of the end − of the start): the part turns, and its ends move on
    /// curves. Where rope is fed also what L does to both.
    fn curvature(&self, at: &Placed, value: f64, group: usize, columns: &mut [DVec3], block: &mut [f64]) {
        let span = &self.spans[self.span_of[group]];
        let (from, to) = self.ends(self.parts[group]);
        let moved = from.len() + to.len();
        let size = moved + span.feeds.len();
        let is_there = self.is_there(group, at.seats);
        if !is_there {
            block.fill(0.0);
        } else if self.part(group).is_plain() {
            self.curvature_between_points(at.kinematics, group, columns, (&mut *block, size));
        } else {
            self.curvature_on_sheaves(at, group, (&mut *block, size));
        }
        if let Some(curve) = &span.curve {
            let straight = self.part(group).locate(at.kinematics);
            let bent = curve.at(straight.length / span.length - 1.0);
            block.iter_mut().for_each(|entry| *entry *= bent.scale);
            let mut entries = columns.iter_mut();
            self.entries(at.kinematics, &straight, group, |entry| {
                entries.next().into_iter().for_each(|column| column.x = entry);
            });
            let bend = bent.bend / span.length;
            for (j, row) in block.chunks_exact_mut(size.max(1)).enumerate() {
                row.iter_mut().zip(&*columns).for_each(|(to, other)| *to += bend * columns[j].x * other.x);
            }
        }
        if span.feeds.is_empty() {
            return;
        }
        let (scale, unstretched) = (span.scale(at.q), span.unstretched(at.q));
        for j in 0..moved {
            for k in 0..moved {
                block[j * size + k] *= scale;
            }
        }
        // ∂²g/∂ℓ∂L = −w/2L and, once per span, ∂²g/∂L² = w/L (1 + ¾ ε).
        let straight = self.part(group).locate(at.kinematics);
        let mut j = 0;
        let mut across = |entry: f64| {
            let entry = if is_there { entry } else { 0.0 };
            for (k, feed) in span.feeds.iter().enumerate() {
                let value = -0.5 * scale / unstretched * entry * feed.speed_rate(at.feeding);
                block[j * size + moved + k] = value;
                block[(moved + k) * size + j] = value;
            }
            j += 1;
        };
        self.entries(at.kinematics, &straight, group, &mut across);
        let strain = value / (scale * unstretched);
        let own = if group == span.parts.start { scale / unstretched * (1.0 + 0.75 * strain) } else { 0.0 };
        for (j, one) in span.feeds.iter().enumerate() {
            for (k, other) in span.feeds.iter().enumerate() {
                let rates = one.speed_rate(at.feeding) * other.speed_rate(at.feeding);
                block[(moved + j) * size + moved + k] = own * rates;
            }
        }
    }
}

impl Rope {
    fn curvature_between_points(
        &self,
        kinematics: &Kinematics,
        group: usize,
        columns: &mut [DVec3],
        (block, size): (&mut [f64], usize),
    ) {
        let straight = self.part(group).locate(kinematics);
        let (from, to) = self.ends(self.parts[group]);
        let (split, moved) = (from.len(), from.len() + to.len());
        let columns = &mut columns[..moved];
        self.transversals(kinematics, &straight, group, columns);
        let inverse = if straight.length > 0.0 { 1.0 / straight.length } else { 0.0 };
        for (j, column) in columns.iter().enumerate() {
            let column = *column * inverse;
            for (k, other) in columns[..=j].iter().enumerate() {
                let value = column.dot(*other);
                block[j * size + k] = value;
                block[k * size + j] = value;
            }
        }
        let direction = straight.direction;
        bend(kinematics, from, straight.from, (direction, -1.0), (columns, 0), (&mut *block, size));
        bend(kinematics, to, straight.to, (direction, 1.0), (columns, split), (block, size));
    }
}
