//! Rope over light sheaves: the division is a solution of its complementarity problem, and the only one.

use super::rigs::cases;
use gantline_core::rope::light::{Division, Spans};
use proptest::collection::vec;
use proptest::prelude::*;

/// Stretch [m], compliance [m/N] and ρ of a rope over up to forty sheaves; three of four are taut as a whole.
fn ropes() -> impl Strategy<Value = (Vec<f64>, Vec<f64>, Vec<f64>)> {
    (1..40_usize).prop_flat_map(|sheaves| {
        let stretch = vec(-0.005..0.015, sheaves + 1);
        let compliance = vec((-8.0..-5.0).prop_map(|power: f64| 10_f64.powf(power)), sheaves + 1);
        (stretch, compliance, vec(1.001..1.4, sheaves))
    })
}

/// k [1/N] at which no span is stretched by more than this share of its length.
fn softening(share: f64, stretch: &[f64], compliance: &[f64]) -> f64 {
    let softest = compliance.iter().zip(stretch).filter(|(_, stretch)| **stretch > 0.0);
    softest.fold(1.0_f64, |least, (compliance, stretch)| least.min(share * compliance / stretch))
}

fn divided(given: Spans, way: &[i8]) -> Division {
    let mut division = Division::new(way.len());
    division.slips.way.copy_from_slice(way);
    division.slips.is_loose = given.stretch.iter().sum::<f64>() <= 0.0;
    division.divide(given);
    division
}

proptest! {
    #![proptest_config(cases(4000))]

    /// c T/(1 + k T) = x + s₊ − s₋; every ratio of tensions within its bounds; rope passes only at one, and that way.
    #[test]
    fn every_sheave_holds_or_slips((stretch, compliance, ratio) in ropes(), start in vec(-1..=1_i8, 40), strain in 0.0..0.5) {
        let softening = softening(strain, &stretch, &compliance);
        let given = Spans { ratio: &ratio, stretch: &stretch, compliance: &compliance, softening };
        let sheaves = ratio.len();
        let found = divided(given, &start[..sheaves]);
        let largest = found.tension.iter().fold(0.0_f64, |most, tension| most.max(tension.abs()));
        // Sums of up to forty stretches of centimetres, and rounding of the length of the rope, each span c/k.
        let length = if softening > 0.0 { compliance.iter().sum::<f64>() / softening } else { 0.0 };
        for span in 0..=sheaves {
            let before = if span > 0 { found.passed[span - 1] } else { 0.0 };
            let after = if span < sheaves { found.passed[span] } else { 0.0 };
            let tension = found.tension[span];
            let long = compliance[span] * tension / (1.0 + softening * tension.max(0.0));
            let left = long - stretch[span] - after + before;
            prop_assert!(left.abs() < 1e-14 + f64::EPSILON * length, "span {span}: {left:e}");
        }
        if found.slips.is_loose {
            prop_assert!(found.tension.iter().all(|tension| (tension - found.tension[0]).abs() <= 1e-12 * largest));
            return Ok(());
        }
        for (sheave, ratio) in ratio.iter().enumerate() {
            let (before, after) = (found.tension[sheave], found.tension[sheave + 1]);
            let rounding = 1e-11 * largest;
            prop_assert!(before > 0.0 && after <= ratio * before + rounding && before <= ratio * after + rounding);
            let passed = found.passed[sheave];
            if passed > 1e-11 {
                prop_assert!((after - ratio * before).abs() < rounding, "sheave {sheave} slips forward");
            } else if passed < -1e-11 {
                prop_assert!((before - ratio * after).abs() < rounding, "sheave {sheave} slips back");
            }
        }
    }

    /// Wherever the search starts, it ends at the same tensions.
    #[test]
    fn there_is_one_division((stretch, compliance, ratio) in ropes(), start in vec(-1..=1_i8, 40), strain in 0.0..0.5) {
        let softening = softening(strain, &stretch, &compliance);
        let given = Spans { ratio: &ratio, stretch: &stretch, compliance: &compliance, softening };
        let one = divided(given, &start[..ratio.len()]);
        let other = divided(given, &vec![0; ratio.len()]);
        for (one, other) in one.tension.iter().zip(&other.tension) {
            prop_assert!((one - other).abs() <= 1e-9 * (1.0 + one.abs()), "{one} {other}");
        }
    }

    /// Of sheaves at their bound those hold that can: rates T and s with 0 ≤ s ⟂ what is left of the ratio's bound.
    #[test]
    fn rates_hold_or_slip(
        (stretch, compliance, ratio) in ropes(),
        start in vec(-1..=1_i8, 40),
    ) {
        let softening = 0.0;
        let given = Spans { ratio: &ratio, stretch: &stretch, compliance: &compliance, softening };
        let mut lies = Division::new(ratio.len());
        lies.slips.way.copy_from_slice(&start[..ratio.len()]);
        let mut found = Division::new(ratio.len());
        found.turn(given, &lies.slips);
        let largest = found.tension.iter().fold(0.0_f64, |most, tension| most.max(tension.abs()));
        for (sheave, ratio) in ratio.iter().enumerate() {
            let (before, after) = (found.tension[sheave], found.tension[sheave + 1]);
            let (bound, passed) = (start[sheave], found.passed[sheave]);
            let beyond = match bound {
                0 => {
                    prop_assert!(passed == 0.0);
                    continue;
                }
                bound if bound > 0 => after - ratio * before,
                _ => before - ratio * after,
            };
            prop_assert!(f64::from(bound) * passed > -1e-11 && beyond < 1e-10 * largest);
            prop_assert!(passed.abs() < 1e-11 || beyond.abs() < 1e-10 * largest);
        }
    }
}
