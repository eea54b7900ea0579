//! Trees and sweeps against a test of every box.

use nalgebra::Point3;
use proptest::prelude::*;
use vc_geometry::order::sorted;
use vc_geometry::tree::{BoxTree, OverlappingPairs};
use vc_graph::Aabb;

/// A box on a coarse raster, so that many touch; some are empty.
fn cuboid() -> impl Strategy<Value = Aabb> {
    let corner = prop::array::uniform3(-9_i8..9);
    let size = prop::array::uniform3(0_i8..5);
    let whole = (corner, size).prop_map(|(low, size)| {
        let min = Point3::from(low.map(f32::from));
        Aabb { min, max: min + nalgebra::Vector3::from(size.map(f32::from)) }
    });
    prop_oneof![9 => whole, 1 => Just(Aabb::EMPTY)]
}

proptest! {
    #![proptest_config(crate::cases(200))]
    #[test]
    fn a_tree_finds_every_box_that_meets_another(
        mut boxes in prop::collection::vec(cuboid(), 0..90),
        moves in prop::collection::vec((0_usize..90, cuboid()), 0..20),
        probe in cuboid(),
    ) {
        let mut tree = BoxTree::new(&boxes);
        for (item, to) in moves {
            tree.set(item, to);
            if let Some(own) = boxes.get_mut(item) {
                *own = to;
            }
        }
        let mut met = Vec::new();
        tree.for_each(&probe, |item| met.push(item));
        met.sort_unstable();
        let obvious: Vec<usize> = (0..boxes.len()).filter(|i| boxes[*i].meets(&probe)).collect();
        prop_assert_eq!(met, obvious);
    }

    #[test]
    fn a_sweep_finds_every_pair(boxes in prop::collection::vec(cuboid(), 0..60)) {
        let pairs = OverlappingPairs::new(&boxes);
        for one in 0..boxes.len() {
            let later = (one + 1..boxes.len()).filter(|other| boxes[one].meets(&boxes[*other]));
            prop_assert_eq!(pairs.partners(one), &later.map(|other| other as u32).collect::<Vec<_>>()[..]);
        }
    }

    #[test]
    fn boxes_that_meet_are_at_no_distance(a in cuboid(), b in cuboid(), by in 0_u8..4) {
        prop_assert_eq!(a.meets(&b), a.distance_squared(&b) == 0.0);
        prop_assert_eq!(a.joined(&b).meets(&b), b != Aabb::EMPTY);
        let by = f32::from(by);
        // Boxes grown by a distance meet if no axis separates them by more.
        prop_assert_eq!(a.grown(by, by).meets(&b), a.gap(&b) <= by);
    }

    #[test]
    fn numbers_are_sorted_as_by_comparison(keys in prop::collection::vec(-4.0_f32..4.0, 0..40)) {
        let numbers: Vec<(f32, u32)> = keys.into_iter().map(|key| (key * 2.0).round() / 2.0 + 0.0).zip(0..).collect();
        let mut slow = numbers.clone();
        slow.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        prop_assert_eq!(sorted(numbers.into_iter()), slow.into_iter().map(|(_, item)| item).collect::<Vec<_>>());
    }
}
