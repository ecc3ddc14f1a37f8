//! Rows of which most are as the one before: kept where they change.

/// A row per sample. All are of one width.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Rows<T> {
    width: usize,
    /// Rows that differ from the one before, one after the other.
    kept: Vec<T>,
    /// Which of them every sample has.
    which: Vec<usize>,
}

impl<T> Default for Rows<T> {
    fn default() -> Self {
        Self { width: 0, kept: Vec::new(), which: Vec::new() }
    }
}

impl<T: Copy + PartialEq> Rows<T> {
    /// Room for `count` rows of `width`, all of them different.
    pub fn with_room(count: usize, width: usize) -> Self {
        Self { width, kept: Vec::with_capacity(count * width), which: Vec::with_capacity(count) }
    }

    /// Those that were kept, and which of them every sample has; none where that cannot be.
    pub fn from_parts(width: usize, kept: Vec<T>, which: Vec<usize>) -> Option<Self> {
        let fits = which.iter().all(|&row| {
            row.checked_add(1).and_then(|rows| rows.checked_mul(width)).is_some_and(|end| end <= kept.len())
        });
        fits.then_some(Self { width, kept, which })
    }

    /// Adds the row of a sample.
    pub fn push(&mut self, row: &[T]) {
        self.width = row.len();
        let same = self.which.last().copied().filter(|&last| self.row(last) == row);
        self.which.push(same.unwrap_or_else(|| {
            self.kept.extend_from_slice(row);
            self.which.last().map_or(0, |last| last + 1)
        }));
    }

    /// Without any row, with its room.
    pub fn clear(&mut self) {
        self.kept.clear();
        self.which.clear();
    }

    /// The row of a sample.
    pub fn of(&self, sample: usize) -> &[T] {
        self.row(self.which[sample])
    }

    fn row(&self, index: usize) -> &[T] {
        &self.kept[index * self.width..][..self.width]
    }

    /// True where there are so many rows of a width.
    pub fn are(&self, count: usize, width: usize) -> bool {
        self.which.len() == count && (count == 0 || self.width == width)
    }

    /// Entries of a row.
    pub fn width(&self) -> usize {
        self.width
    }

    /// Rows that differ from the one before, one after the other.
    pub fn kept(&self) -> &[T] {
        &self.kept
    }

    /// Which of them every sample has.
    pub fn which(&self) -> &[usize] {
        &self.which
    }
}

#[cfg(test)]
mod tests {
    use super::Rows;

    #[test]
    fn rows_are_kept_where_they_change() {
        let given = [[1, 2], [1, 2], [1, 3], [1, 2], [1, 2]];
        let mut rows = Rows::default();
        given.iter().for_each(|row| rows.push(row));
        assert_eq!(rows.kept(), [1, 2, 1, 3, 1, 2]);
        assert!(given.iter().enumerate().all(|(sample, row)| rows.of(sample) == row));
        let parts = (rows.kept().to_vec(), rows.which().to_vec());
        assert_eq!(Rows::from_parts(2, parts.0.clone(), parts.1), Some(rows));
        assert_eq!(Rows::from_parts(2, parts.0, vec![3]), None);
    }

    #[test]
    fn rows_without_width_are_counted() {
        let mut rows = Rows::<u8>::default();
        (0..3).for_each(|_| rows.push(&[]));
        assert_eq!((rows.of(2), rows.kept().len()), (&[][..], 0));
    }
}
