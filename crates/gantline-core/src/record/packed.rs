//! Samples in few bytes, with every bit of their numbers.
//!
//! Numbers of a run change little from sample to sample: the bits of one and those of the sample before, by exclusive
//! or, begin with zeros. Of every such word only the bytes after these are kept, and how many that are: half a byte each,
//! two of them before the bytes of two words. What stands still takes half a byte, and what swings six bytes or seven.

use glam::DVec3;

use super::Samples;
use super::rows::Rows;
use crate::contact::plane::Plane;
use crate::contact::spot::{Crossing, Spot};
use crate::rope::seat::{Seat, Winding};

/// What can be told by `N` words.
trait Words<const N: usize>: Copy {
    fn words(&self) -> [u64; N];
    fn told_by(words: [u64; N]) -> Self;
}

impl Words<1> for f64 {
    fn words(&self) -> [u64; 1] {
        [self.to_bits()]
    }

    fn told_by([bits]: [u64; 1]) -> Self {
        Self::from_bits(bits)
    }
}

impl Words<1> for usize {
    fn words(&self) -> [u64; 1] {
        [*self as u64]
    }

    fn told_by([word]: [u64; 1]) -> Self {
        word as Self
    }
}

impl Words<3> for Seat {
    fn words(&self) -> [u64; 3] {
        let Self { wound: Winding { wrap, arrived }, is_off } = *self;
        [wrap.to_bits(), arrived.to_bits(), u64::from(is_off)]
    }

    fn told_by([wrap, arrived, is_off]: [u64; 3]) -> Self {
        let [wrap, arrived] = [wrap, arrived].map(f64::from_bits);
        Self { wound: Winding { wrap, arrived }, is_off: is_off != 0 }
    }
}

/// Words of a spot: its feature, what it is, its point and plane, its crossing.
const OF_SPOT: usize = 2 + 3 * 5 + 10;

impl Words<OF_SPOT> for Spot {
    fn words(&self) -> [u64; OF_SPOT] {
        let Self { is_near, is_swapped, point, plane, crossing, feature } = *self;
        let Plane { point: origin, normal, tangents: [first, second] } = plane;
        let crossed = crossing
            .map(|Crossing { own, own_before, other, gap_before }| ([own, own_before, other], gap_before));
        let (edges, gap) = crossed.unwrap_or_default();
        let is = [is_near, is_swapped, crossing.is_some()];
        let mut words = [0; OF_SPOT];
        words[0] = feature;
        words[1] = is.iter().fold(0, |bits, &one| 2 * bits + u64::from(one));
        let vectors = [point, origin, normal, first, second].into_iter().chain(edges);
        let numbers = vectors.flat_map(|vector| vector.to_array()).chain([gap]);
        words[2..].iter_mut().zip(numbers).for_each(|(word, number)| *word = number.to_bits());
        words
    }

    fn told_by(words: [u64; OF_SPOT]) -> Self {
        let is = |bit: u32| words[1] >> bit & 1 == 1;
        let vector = |index: usize| {
            DVec3::from_array([0, 1, 2].map(|axis| f64::from_bits(words[2 + 3 * index + axis])))
        };
        let crossing = Crossing {
            own: vector(5),
            own_before: vector(6),
            other: vector(7),
            gap_before: f64::from_bits(words[OF_SPOT - 1]),
        };
        Self {
            is_near: is(2),
            is_swapped: is(1),
            point: vector(0),
            plane: Plane { point: vector(1), normal: vector(2), tangents: [vector(3), vector(4)] },
            crossing: is(0).then_some(crossing),
            feature: words[0],
        }
    }
}

/// Writes tables one after the other.
#[derive(Default)]
struct Packer {
    bytes: Vec<u8>,
}

impl Packer {
    /// A table with rows of `width` entries; how many it has, and its width, come first.
    fn table<const N: usize, T: Words<N>>(&mut self, entries: &[T], width: usize) {
        self.bytes.extend_from_slice(&(entries.len() as u64).to_le_bytes());
        self.bytes.extend_from_slice(&(width as u64).to_le_bytes());
        self.bytes.reserve(8 * N * entries.len());
        let mut before = vec![0; width * N];
        let (mut place, mut head, mut is_second) = (0, 0, false);
        for word in entries.iter().flat_map(Words::words) {
            let bits = word ^ std::mem::replace(&mut before[place], word);
            place = if place + 1 == before.len() { 0 } else { place + 1 };
            let count = 8 - bits.leading_zeros() as usize / 8;
            if is_second {
                self.bytes[head] |= (count as u8) << 4;
            } else {
                head = self.bytes.len();
                self.bytes.push(count as u8);
            }
            is_second = !is_second;
            self.bytes.extend_from_slice(&bits.to_le_bytes()[..count]);
        }
    }

    fn rows<const N: usize, T: Words<N> + PartialEq>(&mut self, rows: &Rows<T>) {
        self.table(rows.which(), 1);
        self.table(rows.kept(), rows.width());
    }
}

/// Reads them again.
struct Unpacker<'a> {
    bytes: &'a [u8],
}

impl Unpacker<'_> {
    fn take<const COUNT: usize>(&mut self) -> Option<[u8; COUNT]> {
        let (first, rest) = self.bytes.split_first_chunk()?;
        self.bytes = rest;
        Some(*first)
    }

    /// The width of a table and its entries; none where there is no whole one.
    fn table<const N: usize, T: Words<N>>(&mut self) -> Option<(usize, Vec<T>)> {
        let [count, width] = [self.take()?, self.take()?].map(|bytes| u64::from_le_bytes(bytes) as usize);
        let words = count.checked_mul(N)?;
        if count == 0 {
            return Some((width, Vec::new()));
        }
        // Two words take a byte at least: no table is larger than what there is.
        if words.div_ceil(2) > self.bytes.len() || !(1..=count).contains(&width) {
            return None;
        }
        let mut before = vec![[0; N]; width];
        let mut entries = Vec::with_capacity(count);
        let (mut head, mut is_second) = (0, false);
        for index in 0..count {
            let entry = &mut before[index % width];
            for word in entry.iter_mut() {
                if !is_second {
                    [head] = self.take()?;
                }
                let kept = usize::from(if is_second { head >> 4 } else { head & 15 });
                is_second = !is_second;
                let mut bits = [0; 8];
                let (own, rest) = self.bytes.split_at_checked(kept)?;
                bits.get_mut(..kept)?.copy_from_slice(own);
                self.bytes = rest;
                *word ^= u64::from_le_bytes(bits);
            }
            entries.push(T::told_by(*entry));
        }
        Some((width, entries))
    }

    fn rows<const N: usize, T: Words<N> + PartialEq>(&mut self) -> Option<Rows<T>> {
        let (_, which) = self.table()?;
        let (width, kept) = self.table()?;
        Rows::from_parts(width, kept, which)
    }
}

impl Samples {
    /// All of them, in few bytes.
    pub(crate) fn packed(&self) -> Vec<u8> {
        // By name, so that a field that is added is not forgotten.
        let Self {
            time,
            q,
            v,
            acceleration,
            tension,
            past,
            seats,
            spots,
            lengthening,
            compensation,
            energy,
            complementarity_residual,
            rope_peak_tension,
            rope_peak_time,
            contact_peak_force,
            contact_peak_time,
        } = self;
        let mut packer = Packer::default();
        for column in [
            time,
            q,
            v,
            acceleration,
            tension,
            past,
            lengthening,
            compensation,
            energy,
            complementarity_residual,
        ] {
            packer.table(column, column.len() / time.len().max(1));
        }
        for peaks in [rope_peak_tension, rope_peak_time, contact_peak_force, contact_peak_time] {
            packer.table(peaks, peaks.len());
        }
        packer.rows(seats);
        packer.rows(spots);
        packer.bytes
    }

    /// Those that were packed; none where the bytes are something else.
    pub(crate) fn unpacked(bytes: &[u8]) -> Option<Self> {
        let mut unpacker = Unpacker { bytes };
        let mut column = || unpacker.table().map(|(_, entries)| entries);
        let samples = Self {
            time: column()?,
            q: column()?,
            v: column()?,
            acceleration: column()?,
            tension: column()?,
            past: column()?,
            lengthening: column()?,
            compensation: column()?,
            energy: column()?,
            complementarity_residual: column()?,
            rope_peak_tension: column()?,
            rope_peak_time: column()?,
            contact_peak_force: column()?,
            contact_peak_time: column()?,
            seats: unpacker.rows()?,
            spots: unpacker.rows()?,
        };
        unpacker.bytes.is_empty().then_some(samples)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn number() -> impl Strategy<Value = f64> {
        prop_oneof![
            Just(0.0),
            Just(-0.0),
            Just(1.5),
            Just(f64::INFINITY),
            any::<u64>().prop_map(f64::from_bits)
        ]
    }

    fn vector() -> impl Strategy<Value = DVec3> {
        [number(), number(), number()].prop_map(DVec3::from_array)
    }

    fn seat() -> impl Strategy<Value = Seat> {
        (number(), number(), any::<bool>())
            .prop_map(|(wrap, arrived, is_off)| Seat { wound: Winding { wrap, arrived }, is_off })
    }

    fn spot() -> impl Strategy<Value = Spot> {
        let crossing =
            ([vector(), vector(), vector()], number()).prop_map(|([own, own_before, other], gap_before)| {
                Crossing { own, own_before, other, gap_before }
            });
        let planes = [vector(), vector(), vector(), vector()]
            .prop_map(|[point, normal, first, second]| Plane { point, normal, tangents: [first, second] });
        let is = [any::<bool>(), any::<bool>()];
        (is, vector(), planes, prop::option::of(crossing), any::<u64>()).prop_map(
            |([is_near, is_swapped], point, plane, crossing, feature)| Spot {
                is_near,
                is_swapped,
                point,
                plane,
                crossing,
                feature,
            },
        )
    }

    /// Samples of `count` moments with columns of random widths.
    fn samples() -> impl Strategy<Value = Samples> {
        let columns = |count: usize, width: usize| prop::collection::vec(number(), count * width);
        (0_usize..5, 0_usize..4, 0_usize..4).prop_flat_map(move |(count, wide, narrow)| {
            let numbers =
                [1, wide, narrow, narrow, wide, 0, narrow, wide, 3, 1].map(|width| columns(count, width));
            let peaks = [columns(1, wide), columns(1, wide), columns(1, narrow), columns(1, narrow)];
            let seats = prop::collection::vec(prop::collection::vec(seat(), narrow), count);
            let spots = prop::collection::vec(prop::collection::vec(spot(), wide), count);
            (Vec::from(numbers), peaks, seats, spots).prop_map(
                |(mut columns, peaks, seat_rows, spot_rows)| {
                    let mut next = || columns.remove(0);
                    let [rope_peak_tension, rope_peak_time, contact_peak_force, contact_peak_time] = peaks;
                    let mut samples = Samples {
                        time: next(),
                        q: next(),
                        v: next(),
                        acceleration: next(),
                        tension: next(),
                        past: next(),
                        lengthening: next(),
                        compensation: next(),
                        energy: next(),
                        complementarity_residual: next(),
                        rope_peak_tension,
                        rope_peak_time,
                        contact_peak_force,
                        contact_peak_time,
                        ..Samples::default()
                    };
                    seat_rows.iter().for_each(|row| samples.seats.push(row));
                    spot_rows.iter().for_each(|row| samples.spots.push(row));
                    samples
                },
            )
        })
    }

    proptest! {
        #[test]
        fn every_bit_comes_back(samples in samples()) {
            let bytes = samples.packed();
            let again = Samples::unpacked(&bytes);
            // NaN differs from itself, so the bytes are compared.
            prop_assert_eq!(again.map(|samples| samples.packed()), Some(bytes));
            // And the numbers, as they are printed: signs of zeros and all.
            let again = Samples::unpacked(&samples.packed());
            prop_assert_eq!(format!("{again:?}"), format!("{:?}", Some(samples)));
        }

        #[test]
        fn what_is_cut_off_or_too_long_is_nothing(samples in samples(), cut in 1_usize..40) {
            let mut bytes = samples.packed();
            let kept = bytes.len().saturating_sub(cut);
            prop_assert_eq!(Samples::unpacked(&bytes[..kept]), None);
            bytes.push(0);
            prop_assert_eq!(Samples::unpacked(&bytes), None);
        }

        #[test]
        fn any_bytes_are_samples_or_nothing(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
            let _ = Samples::unpacked(&bytes);
        }
    }

    #[test]
    fn what_stands_still_takes_half_a_byte() {
        let count = 1000;
        let time = (0..count).map(f64::from).collect();
        let still = Samples { time, q: vec![0.1; 50 * count as usize], ..Samples::default() };
        let without = Samples { q: Vec::new(), ..still.clone() };
        let taken = still.packed().len() - without.packed().len();
        assert!(taken <= 50 * (count as usize + 1) / 2 + 50 * 8, "{taken} bytes");
    }
}
