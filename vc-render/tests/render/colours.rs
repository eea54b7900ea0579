//! Colours of the palette distinguish numbers.

use std::collections::BTreeMap;

use vc_render::picture::Palette;

/// Number of consecutive numbers with distinct colours, from any start.
const MANY: u32 = 100_000;

#[test]
fn a_hundred_thousand_numbers_in_a_row_have_as_many_colours_and_none_is_black() {
    for first in [0, u32::MAX - MANY] {
        let mut known = BTreeMap::new();
        for number in first..first + MANY {
            let colour = Palette.colour(number);
            // Black is reserved for empty pixels.
            assert_ne!(colour, [0; 3], "{number}");
            if let Some(other) = known.insert(colour, number) {
                panic!("{number} has the colour of {other}: {colour:?}");
            }
        }
    }
}

#[test]
fn neighbours_are_told_apart_by_eye() {
    for number in 0..2000 {
        let [a, b] = [number, number + 1].map(|n| Palette.colour(n).map(i32::from));
        let off: i32 = (0..3).map(|i| (a[i] - b[i]).abs()).sum();
        assert!(off > 60, "{number} is {a:?}, the next {b:?}");
    }
}
