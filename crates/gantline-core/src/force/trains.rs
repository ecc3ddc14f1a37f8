//! What comes by as a sum of regular waves that travel: the surface of the water (Airy 1845), and gusts, which wind carries
//! along as they are (Taylor 1938).
//!
//! ```text
//! η(x, t) = g(t) Σ a cos(k·x − ω t + ε)
//! ```
//!
//! g grows from 0 to 1 at the start, with two derivatives that are zero at both ends, so that what rests begins to move
//! without a jerk.

use std::f64::consts::PI;

use glam::DVec2;

/// Looks in the shortest period of a wave.
const LOOKS_IN_WAVE: f64 = 8.0;

/// A regular wave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Component {
    /// ω [rad/s].
    pub frequency: f64,
    /// k [rad/m], world axes.
    pub wave_number: DVec2,
    /// |k| [rad/m].
    pub number: f64,
    /// a [m, of gusts m/s].
    pub amplitude: f64,
    /// ε [rad].
    pub phase: f64,
}

/// Waves that come by.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Trains {
    /// What they are made of.
    pub components: Vec<Component>,
    /// Time in which they grow [s].
    pub rise_time: f64,
    /// Depth of the water that they run over [m]; none is deep.
    pub depth: Option<f64>,
}

/// What comes by at a place and a time.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Passing {
    /// η [m, of gusts m/s].
    pub value: f64,
    /// Its derivative over the place, world axes.
    pub gradient: DVec2,
    /// Its derivative over time.
    pub rate: f64,
}

impl Component {
    /// Sine and cosine of its phase at a place [m] and `time` [s].
    pub fn turned(&self, place: DVec2, time: f64) -> (f64, f64) {
        (self.wave_number.dot(place) - self.frequency * time + self.phase).sin_cos()
    }
}

impl Trains {
    /// g and its derivative over time at `time` [s].
    pub fn growth(&self, time: f64) -> (f64, f64) {
        if time >= self.rise_time {
            return (1.0, 0.0);
        }
        let s = (time / self.rise_time).max(0.0);
        let share = s * s * s * (10.0 - s * (15.0 - 6.0 * s));
        let slope = 30.0 * s * s * (1.0 - s) * (1.0 - s);
        (share, slope / self.rise_time)
    }

    /// The second derivative of g over time at `time` [s].
    pub fn growth_bend(&self, time: f64) -> f64 {
        if time >= self.rise_time {
            return 0.0;
        }
        let s = (time / self.rise_time).max(0.0);
        60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (self.rise_time * self.rise_time)
    }

    /// The third derivative of g over time at `time` [s]; it jumps where growth begins and ends.
    fn growth_twist(&self, time: f64) -> f64 {
        if time >= self.rise_time {
            return 0.0;
        }
        let s = (time / self.rise_time).max(0.0);
        60.0 * (1.0 - 6.0 * s * (1.0 - s)) / self.rise_time.powi(3)
    }

    /// What comes by at the origin at `time` [s], and its first three derivatives over time.
    pub fn at_origin(&self, time: f64) -> [f64; 4] {
        let mut sum = [0.0; 4];
        for wave in &self.components {
            let (sin, cos) = wave.turned(DVec2::ZERO, time);
            let (a, omega) = (wave.amplitude, wave.frequency);
            let turns = [cos, omega * sin, -omega.powi(2) * cos, -omega.powi(3) * sin];
            sum.iter_mut().zip(turns).for_each(|(sum, turn)| *sum += a * turn);
        }
        let ((g, rate), bend, twist) = (self.growth(time), self.growth_bend(time), self.growth_twist(time));
        let [x, v, a, j] = sum;
        [
            g * x,
            g * v + rate * x,
            g * a + 2.0 * rate * v + bend * x,
            g * j + 3.0 * (rate * a + bend * v) + twist * x,
        ]
    }

    /// What comes by at a place [m] and `time` [s], of the water undisturbed by anything in it.
    pub fn passing(&self, place: DVec2, time: f64) -> Passing {
        let mut sum = Passing::default();
        for wave in &self.components {
            let (sin, cos) = wave.turned(place, time);
            sum.value += wave.amplitude * cos;
            sum.gradient -= wave.wave_number * (wave.amplitude * sin);
            sum.rate += wave.frequency * wave.amplitude * sin;
        }
        let (growth, slope) = self.growth(time);
        let rate = growth * sum.rate + slope * sum.value;
        Passing { value: growth * sum.value, gradient: sum.gradient * growth, rate }
    }

    /// Looks that a time of `length` [s] needs so that no wave comes and goes between two; 0 where there are none.
    pub fn looks(&self, length: f64) -> usize {
        let fastest = self.components.iter().map(|wave| wave.frequency).fold(0.0, f64::max);
        (LOOKS_IN_WAVE * length * fastest / (2.0 * PI)).ceil() as usize
    }

    /// Mean period of the rate of the surface, 2π √(Σ a²ω²/Σ a²ω⁴) [s]; infinite where nothing comes by.
    pub fn mean_period(&self) -> f64 {
        let moment = |power: i32| -> f64 {
            self.components.iter().map(|wave| wave.amplitude.powi(2) * wave.frequency.powi(power)).sum()
        };
        let fast = moment(4);
        if fast > 0.0 { 2.0 * PI * (moment(2) / fast).sqrt() } else { f64::INFINITY }
    }

    /// No wave is higher [m].
    pub fn highest(&self) -> f64 {
        self.components.iter().map(|wave| wave.amplitude.abs()).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each derivative at the origin against the difference of the one before it, while waves grow and after: what is
    /// left is d² times the third derivative of that, ω³/6 for 1 m, and rounding over d.
    #[test]
    fn derivatives_at_the_origin() {
        let wave = |frequency: f64, amplitude: f64, phase: f64| {
            let (wave_number, number) = (DVec2::new(0.1, 0.0), 0.1);
            Component { frequency, wave_number, number, amplitude, phase }
        };
        let components = vec![wave(0.7, 1.0, 0.3), wave(1.1, -0.4, 2.0)];
        let waves = Trains { components, rise_time: 20.0, depth: None };
        let d = 1e-4;
        for time in [0.01, 3.0, 11.0, 19.0, 20.5, 47.0] {
            let [before, here, after] = [time - d, time, time + d].map(|time| waves.at_origin(time));
            for k in 0..3 {
                let slope = (after[k] - before[k]) / (2.0 * d);
                assert!((slope - here[k + 1]).abs() < 1e-8, "{k} at {time}: {slope} {}", here[k + 1]);
            }
            let passing = waves.passing(DVec2::ZERO, time);
            assert!((here[0] - passing.value).abs() < 1e-15 && (here[1] - passing.rate).abs() < 1e-15);
        }
    }
}
