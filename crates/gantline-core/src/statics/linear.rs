//! A lift linearised about an equilibrium, for who goes on with its matrices:
//!
//! ```text
//! M ẍ + D ẋ + K x = f      H x = 0      δT = P x + R ẋ
//! ```
//!
//! x are increments of the free degrees of freedom. M is that of [`super::modes`], K too but for what wind and current push
//! with, which is here in full and not by its symmetric half; D is in full what modes take of it one by one. H are the gradients of rows that act without compliance, whose forces are no function of x.

use glam::DVec3;

use super::{Part, Statics};
use crate::force::memory;
use crate::state::State;
use crate::system::System;

/// Matrices, row-major.
#[derive(Debug, Clone, PartialEq)]
pub struct Linear {
    /// The degree of freedom of each x.
    pub free: Vec<usize>,
    /// M, square.
    pub mass: Vec<f64>,
    /// D, square.
    pub damping: Vec<f64>,
    /// K, square.
    pub stiffness: Vec<f64>,
    /// H, a row for each that holds.
    pub held: Vec<f64>,
    /// P, a row for each rope, mooring lines last; not a number where H holds its rope.
    pub tension: Vec<f64>,
    /// R, likewise.
    pub tension_rate: Vec<f64>,
}

impl Statics {
    /// About the equilibrium in which `state` is since the last [`Statics::settle`]. Water that remembers has the added mass
    /// and the damping of the frequency `omega` [rad/s], or of an infinite one.
    pub fn linear(&mut self, system: &System, state: &State, omega: Option<f64>) -> Linear {
        self.search.linearise(system, state);
        self.search.matrix.take_water(system, &self.search.here, omega);
        let matrix = &self.search.matrix;
        let (mass, mut stiffness) = matrix.dense(system, &self.bearings, &self.search.here.follows);
        matrix.add_stream(&mut stiffness);
        let damping = self.dense_damping(system, omega);
        let held = self.held_rows(system).concat();
        let [tension, tension_rate] = self.dense_tension(system);
        let free = matrix.layout.free.clone();
        self.search.matrix.take_water(system, &self.search.here, None);
        Linear { free, mass, damping, stiffness, held, tension, tension_rate }
    }

    /// Gradients over the free degrees of freedom of the rows that act without compliance.
    pub(super) fn held_rows(&self, system: &System) -> Vec<Vec<f64>> {
        let follows = &self.search.here.follows;
        let rigid = (0..follows.len()).filter(|&row| follows[row] && self.bearings[row].is_rigid);
        rigid.map(|row| self.dense_row(system, row)).collect()
    }

    /// The gradient of a row over the free degrees of freedom.
    fn dense_row(&self, system: &System, row: usize) -> Vec<f64> {
        let mut entries = vec![0.0; self.search.matrix.layout.free.len()];
        let given = self.search.matrix.row_entries(system, row);
        given.for_each(|(unknown, entry)| entries[unknown] += entry);
        entries
    }

    /// Whether a row stretches: it has a damper beside its spring.
    pub(super) fn stretches(&self, row: usize) -> bool {
        let bearing = &self.bearings[row];
        self.search.here.follows[row]
            && matches!(bearing.part, Part::Pull | Part::Spring)
            && !bearing.is_rigid
    }

    fn dense_damping(&self, system: &System, omega: Option<f64>) -> Vec<f64> {
        let (matrix, tree) = (&self.search.matrix, &system.tree);
        let size = matrix.layout.free.len();
        let mut damping = vec![0.0; size * size];
        let mut add = |(one, other): (usize, usize), value: f64| {
            // Driven degrees of freedom have no place.
            if one < size && other < size {
                damping[one * size + other] += value;
            }
        };
        for (place, &dof) in matrix.layout.free.iter().enumerate() {
            add((place, place), tree.damping[dof]);
        }
        let mut of_dofs = |[one, other]: [usize; 2], value| {
            add((matrix.layout.unknown[one], matrix.layout.unknown[other]), value)
        };
        matrix.resistances(system, &mut of_dofs);
        if let Some(omega) = omega {
            memory::resistances(tree, &self.search.here.frame.kinematics, omega, &mut of_dofs);
        }
        for row in (0..system.rows.count()).filter(|&row| self.stretches(row)) {
            let factor = system.rows.laws[row].damping_time() / self.bearings[row].compliance;
            let entries: Vec<(usize, f64)> = matrix.row_entries(system, row).collect();
            for &(one, left) in &entries {
                for &(other, right) in &entries {
                    damping[one * size + other] += factor * left * right;
                }
            }
        }
        damping
    }

    fn dense_tension(&self, system: &System) -> [Vec<f64>; 2] {
        let free = &self.search.matrix.layout.free;
        let gradients: Vec<Vec<f64>> =
            (0..system.rope_rows()).map(|row| self.dense_row(system, row)).collect();
        let share = |row: usize| match (self.search.here.follows[row], self.bearings[row].is_rigid) {
            (false, _) => 0.0,
            (true, true) => f64::NAN,
            (true, false) => 1.0 / self.bearings[row].compliance,
        };
        let kinematics = &self.search.here.frame.kinematics;
        let mut unit = vec![0.0; system.tree.velocities];
        let mut columns = [Vec::new(), Vec::new()];
        for (place, &dof) in free.iter().enumerate() {
            unit[dof] = 1.0;
            let change: Vec<f64> =
                gradients.iter().enumerate().map(|(row, gradient)| share(row) * gradient[place]).collect();
            let damped = |(row, change): (usize, &f64)| system.rows.laws[row].damping_time() * change;
            let rate: Vec<f64> = change.iter().enumerate().map(damped).collect();
            let mut by_place = self.rope_changes(system, &unit, &change);
            let mut by_rate = self.rope_rates(system, &rate);
            for mooring in system.moorings() {
                let [place, rate] = mooring.tension_rates(&system.tree, kinematics, &unit, DVec3::ZERO);
                by_place.push(place);
                by_rate.push(rate);
            }
            unit[dof] = 0.0;
            columns[0].push(by_place);
            columns[1].push(by_rate);
        }
        let ropes = 0..system.all_ropes();
        columns.map(|columns| {
            ropes.clone().flat_map(|rope| columns.iter().map(move |column| column[rope])).collect()
        })
    }
}
