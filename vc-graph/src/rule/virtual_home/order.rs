//! The iteration order of a Python set of numbers: if VirtualHome's simulator takes the first of several, it is
//! the first in this order.

/// The number of slots after its own that a number is tried at before the next probe.
const BESIDE: usize = 9;

/// CPython's hash table of a set of numbers.
struct Table {
    places: Vec<Option<u32>>,
    used: usize,
}

/// The iteration order of a set into which numbers are inserted in the given order.
pub(super) fn walked(numbers: impl IntoIterator<Item = u32>) -> impl Iterator<Item = u32> {
    let mut table = Table { places: vec![None; 8], used: 0 };
    numbers.into_iter().for_each(|number| table.add(number));
    table.places.into_iter().flatten()
}

impl Table {
    fn add(&mut self, number: u32) {
        let place = self.place(number);
        if self.places[place].replace(number).is_some() {
            return;
        }
        self.used += 1;
        // At three fifths full, it grows to the power of two above four times its number of elements.
        if self.used * 5 >= (self.places.len() - 1) * 3 {
            let size = (self.used * 4 + 1).next_power_of_two().max(8);
            let old = std::mem::replace(&mut self.places, vec![None; size]);
            for number in old.into_iter().flatten() {
                let place = self.place(number);
                self.places[place] = Some(number);
            }
        }
    }

    /// The slot in which a number is, or would be inserted.
    fn place(&self, number: u32) -> usize {
        let mask = self.places.len() - 1;
        let mut rest = number as usize;
        let mut place = rest & mask;
        loop {
            let beside = if place + BESIDE <= mask { BESIDE } else { 0 };
            let free = |at: &usize| self.places[*at].is_none_or(|there| there == number);
            if let Some(found) = (place..=place + beside).find(free) {
                return found;
            }
            rest >>= 5;
            place = (place * 5 + 1 + rest) & mask;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::walked;

    /// The order in which CPython 3.11 prints these sets.
    #[test]
    fn numbers_come_in_pythons_order() {
        let cases: [(&[u32], &[u32]); 4] = [
            (&[1, 201, 67, 319], &[1, 67, 201, 319]),
            (&[201, 1, 319, 9], &[201, 9, 1, 319]),
            (
                &[1414, 1930, 1723, 1515, 1335, 1888, 1085, 59, 1721, 953, 1589, 1931],
                &[1888, 1414, 953, 59, 1930, 1515, 1931, 1589, 1335, 1721, 1723, 1085],
            ),
            (
                &[
                    510, 1329, 106, 1845, 321, 231, 761, 960, 1778, 504, 779, 1113, 208, 1175, 510, 26, 1497, 443, 835,
                    572,
                ],
                &[779, 1175, 26, 1329, 1845, 443, 572, 960, 321, 835, 208, 1113, 1497, 231, 106, 1778, 504, 761, 510],
            ),
        ];
        for (numbers, order) in cases {
            assert_eq!(walked(numbers.iter().copied()).collect::<Vec<_>>(), order);
        }
    }
}
