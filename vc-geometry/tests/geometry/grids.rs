//! Bit grids against sets of cells.

use std::collections::BTreeSet;

use nalgebra::Point2;
use proptest::prelude::*;
use vc_geometry::grid::{BitGrid, Disc, Raster, ceiling, floor};
use vc_geometry::outline::hull;
use vc_graph::{Seed, Stream};

type Cells = BTreeSet<(usize, usize)>;

/// A grid of any size up to three words wide, and as a set; some are nearly empty, some nearly full.
fn grid(seed: u64) -> (BitGrid, Cells) {
    let mut stream = Seed(seed).stream();
    let (width, height) = (stream.count(1, 150), stream.count(1, 40));
    let mut grid = BitGrid::new(width, height);
    let share = stream.between(0.02, 0.98);
    for y in 0..height {
        (0..width).filter(|_| stream.between(0.0, 1.0) < share).for_each(|x| grid.set(x, y));
    }
    let cells = grid.cells().collect();
    (grid, cells)
}

/// A rectangle that may reach over the grid or be empty.
fn span(stream: &mut Stream, grid: &BitGrid) -> ((i32, i32), (i32, i32)) {
    let mut along = |most: usize| {
        let from = stream.count(0, most + 20) as i32 - 10;
        (from, from + stream.count(0, most) as i32)
    };
    (along(grid.width()), along(grid.height()))
}

fn is_in((x, y): (usize, usize), (columns, rows): ((i32, i32), (i32, i32))) -> bool {
    (columns.0..columns.1).contains(&(x as i32)) && (rows.0..rows.1).contains(&(y as i32))
}

/// The part of a set that is connected to a cell.
fn part(cells: &Cells, from: (usize, usize)) -> Cells {
    let mut met = Cells::new();
    let mut open: Vec<_> = cells.get(&from).copied().into_iter().collect();
    while let Some((x, y)) = open.pop() {
        if met.insert((x, y)) {
            let around = [(x.wrapping_sub(1), y), (x + 1, y), (x, y.wrapping_sub(1)), (x, y + 1)];
            open.extend(around.into_iter().filter(|cell| cells.contains(cell)));
        }
    }
    met
}

fn set(grid: &BitGrid) -> Cells {
    grid.cells().collect()
}

proptest! {
    #![proptest_config(crate::cases(200))]
    #[test]
    fn cells_runs_and_counts_agree(seed: u64) {
        let (grid, cells) = grid(seed);
        let every = (0..grid.height() + 2).flat_map(|y| (0..grid.width() + 70).map(move |x| (x, y)));
        prop_assert_eq!(every.filter(|(x, y)| grid.get(*x, *y)).collect::<Cells>(), cells.clone());
        prop_assert_eq!(grid.count(), cells.len());
        prop_assert_eq!(grid.inverted().count(), grid.width() * grid.height() - cells.len());
        for (from, to) in grid.runs(0) {
            prop_assert!((from..to).all(|x| cells.contains(&(x as usize, 0))));
            prop_assert!(!cells.contains(&(to as usize, 0)) && (from == 0 || !cells.contains(&(from as usize - 1, 0))));
        }
    }

    #[test]
    fn rectangles_are_filled_cleared_and_searched(seed: u64) {
        let (grid, cells) = grid(seed);
        let mut stream = Seed(seed).child("span").stream();
        let at = span(&mut stream, &grid);
        let (mut filled, mut cleared, mut row) = (grid.clone(), grid.clone(), grid.clone());
        filled.fill(at.0, at.1, true);
        cleared.fill(at.0, at.1, false);
        prop_assert_eq!(set(&cleared), cells.iter().copied().filter(|c| !is_in(*c, at)).collect::<Cells>());
        let every = (0..grid.height()).flat_map(|y| (0..grid.width()).map(move |x| (x, y)));
        prop_assert_eq!(set(&filled), every.filter(|c| is_in(*c, at) || cells.contains(c)).collect::<Cells>());
        let inside = cells.iter().copied().filter(|c| is_in(*c, at));
        prop_assert_eq!(grid.first(at.0, at.1), inside.min_by_key(|(x, y)| (*y, *x)));
        prop_assert_eq!(grid.any(at.0, at.1), grid.first(at.0, at.1).is_some());
        let columns = (at.0.0.max(0) as usize, at.0.1.max(0) as usize);
        row.fill_row(3, columns.0, columns.1, true);
        let mut same = grid.clone();
        same.fill((columns.0 as i32, columns.1 as i32), (3, 4), true);
        prop_assert_eq!(row, same);
    }

    #[test]
    fn floods_meet_the_connected_part_and_the_largest_is_the_largest(seed: u64) {
        let (grid, cells) = grid(seed);
        let from = (grid.width() / 2, grid.height() / 2);
        prop_assert_eq!(set(&grid.flood(from.0, from.1)), part(&cells, from));
        let mut left = cells.clone();
        let mut largest = Cells::new();
        // Row by row, as the first of equal parts counts.
        for cell in grid.cells() {
            if left.contains(&cell) {
                let found = part(&cells, cell);
                left.retain(|c| !found.contains(c));
                if found.len() > largest.len() {
                    largest = found;
                }
            }
        }
        prop_assert_eq!(set(&grid.largest()), largest);
    }

    #[test]
    fn bits_around_a_rectangle_are_whole_if_one_flood_meets_them(seed: u64) {
        let (grid, cells) = grid(seed);
        let mut stream = Seed(seed).child("span").stream();
        let ((x0, x1), (y0, y1)) = span(&mut stream, &grid);
        let far = stream.count(0, 6);
        let by = far as i32;
        let near: Cells =
            cells.into_iter().filter(|c| is_in(*c, ((x0 - by, x1 + by), (y0 - by, y1 + by)))).collect();
        let whole = near.first().is_none_or(|first| part(&near, *first) == near);
        prop_assert_eq!(grid.is_whole_around((x0, x1), (y0, y1), far), whole);
    }

    #[test]
    fn discs_grow_clear_and_find_as_their_cells_say(seed: u64, radius in 0_usize..7, by_centres: bool) {
        let (grid, cells) = grid(seed);
        let size = radius as f32 + 0.3;
        // The nearest points of two cells at an offset, or their centres.
        let meets = |dx: usize, dy: usize| {
            let near = |offset: usize| (2 * offset).saturating_sub(1);
            if by_centres {
                (dx * dx + dy * dy) as f32 <= size * size
            } else {
                near(dx).pow(2) + near(dy).pow(2) < (2 * radius).pow(2) || (dx, dy) == (0, 0)
            }
        };
        let disc = if by_centres { Disc::within(size) } else { Disc::touching(radius) };
        let near = |(x, y): (usize, usize), (u, v): (usize, usize)| meets(x.abs_diff(u), y.abs_diff(v));
        let every = || (0..grid.height()).flat_map(|y| (0..grid.width()).map(move |x| (x, y)));
        // A few obstacles keep the slow version quick.
        let few: Cells = cells.iter().copied().step_by(cells.len() / 20 + 1).collect();
        let mut some = grid.empty();
        few.iter().for_each(|(x, y)| some.set(*x, *y));
        let grown: Cells = every().filter(|c| few.iter().any(|o| near(*c, *o))).collect();
        prop_assert_eq!(set(&some.dilated(&disc)), grown);
        let mut stream = Seed(seed).child("span").stream();
        let at = (stream.below(grid.width()), stream.below(grid.height()));
        let rectangle = ((at.0 as i32, at.0 as i32 + 1), (at.1 as i32, at.1 as i32 + 1));
        let (mut cleared, inside) = (some.clone(), |c: &(usize, usize)| near(*c, at));
        cleared.clear_near(rectangle.0, rectangle.1, &disc);
        prop_assert_eq!(set(&cleared), few.iter().copied().filter(|c| !inside(c)).collect::<Cells>());
        let found = some.first_near(rectangle.0, rectangle.1, &disc);
        prop_assert_eq!(found.is_some(), few.iter().any(inside));
        let rows = |c: (usize, usize)| c.1.abs_diff(at.1);
        prop_assert_eq!(found.map(rows), few.iter().copied().filter(inside).map(rows).min());
    }

    #[test]
    fn squares_are_where_all_their_cells_are(seed: u64, side in 1_usize..5) {
        let (grid, cells) = grid(seed);
        let square = |(x, y): (usize, usize)| (0..side).flat_map(move |v| (0..side).map(move |u| (x + u, y + v)));
        let corners: Cells = cells.iter().copied().filter(|c| square(*c).all(|c| cells.contains(&c))).collect();
        prop_assert_eq!(set(&grid.squares(side)), corners.clone());
        let covered: Cells = corners.into_iter().flat_map(square).collect();
        prop_assert_eq!(set(&grid.squares(side).covered(side)), covered.clone());
        prop_assert!(grid.squares(side).covered(side).is_within(&grid));
        prop_assert_eq!(grid.is_within(&grid.squares(side).covered(side)), covered == cells);
        prop_assert_eq!(set(&grid.and(&grid.squares(side))), set(&grid.squares(side)));
    }

    #[test]
    fn painted_cells_are_those_whose_centres_are_near_the_outline(seed: u64, radius in 0.0_f32..0.4) {
        let mut stream = Seed(seed).stream();
        let mut point = || Point2::new(stream.between(-0.5, 2.5), stream.between(-0.5, 2.5));
        let outline = hull((0..7).map(|_| point()));
        let mut raster = Raster::over(Point2::origin(), Point2::new(2.0, 2.0), 0.05).unwrap();
        raster.paint(&outline, radius, true);
        for (x, y) in (0..40).flat_map(|y| (0..40).map(move |x| (x, y))) {
            let centre = raster.point((x as f64 + 0.5, y as f64 + 0.5));
            let apart = distance(&outline, &centre) - radius;
            // A centre on the border may count either way.
            prop_assert!(apart.abs() < 1e-4 || raster.cells().get(x, y) == (apart < 0.0), "{} {} {}", x, y, apart);
        }
    }

    #[test]
    fn the_nearest_set_cell_is_the_nearest(seed: u64, within in 0.0_f32..1.0) {
        let mut stream = Seed(seed).stream();
        let mut raster = Raster::over(Point2::origin(), Point2::new(2.0, 2.0), 0.1).unwrap();
        for _ in 0..3 {
            let low = Point2::new(stream.between(0.0, 1.8), stream.between(0.0, 1.8));
            raster.paint(&vc_geometry::outline::rectangle(&low, &(low.map(|v| v + 0.25))), 0.0, true);
        }
        let from = Point2::new(stream.between(-0.5, 2.5), stream.between(-0.5, 2.5));
        let centres = raster.cells().cells().map(|(x, y)| raster.point((x as f64 + 0.5, y as f64 + 0.5)));
        let least = centres.map(|c| (c - from).norm()).filter(|d| *d <= within).reduce(f32::min);
        let found = raster.nearest(&from, within);
        if raster.holds(&from) {
            prop_assert_eq!(found, Some(from));
        } else {
            prop_assert_eq!(found.map(|c| (c - from).norm()), least);
        }
    }
}

/// The distance of a point from a convex outline, zero inside.
fn distance(outline: &[Point2<f32>], point: &Point2<f32>) -> f32 {
    let sides = || outline.iter().zip(outline.iter().cycle().skip(1));
    if sides().all(|(a, b)| (b - a).perp(&(point - a)) >= 0.0) {
        return 0.0;
    }
    let to_side = |(a, b): (&Point2<f32>, &Point2<f32>)| {
        let along = ((point - a).dot(&(b - a)) / (b - a).norm_squared()).clamp(0.0, 1.0);
        (a + (b - a) * along - point).norm()
    };
    sides().map(to_side).fold(f32::INFINITY, f32::min)
}

#[test]
fn rectangles_at_the_ends_of_numbers_are_clipped() {
    let mut grid = BitGrid::new(70, 5);
    let all = (i32::MIN, i32::MAX);
    grid.fill(all, all, true);
    assert_eq!(grid.count(), 350);
    assert!(grid.first_near(all, all, &Disc::touching(9)).is_some() && grid.is_whole_around(all, all, 9));
    grid.clear_near(all, all, &Disc::within(3.0));
    assert_eq!((grid.count(), grid.largest().count()), (0, 0));
    assert_eq!(BitGrid::new(0, 0).inverted().largest().count(), 0);
    assert!(grid.is_whole_around(all, all, usize::MAX));
    assert_eq!((floor(f32::NEG_INFINITY), ceiling(f32::INFINITY)), (i32::MIN, i32::MAX));
    assert!(Raster::over(Point2::origin(), Point2::new(f32::NAN, 1.0), 0.1).is_none());
    let mut raster = Raster::over(Point2::origin(), Point2::new(1.0, 1.0), 0.1).unwrap();
    raster.paint(&vc_geometry::outline::rectangle(&Point2::origin(), &Point2::new(1.0, 1.0)), -5.0, true);
    assert_eq!((raster.cells().count(), raster.nearest(&Point2::new(f32::MAX, 0.0), 1.0)), (0, None));
}
