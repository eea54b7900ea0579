//! People on foot on ways of their own: speed against density, doors, meetings, bodies that do not overlap.

use std::sync::Arc;

use vc_graph::Seed;
use vc_graph::portable::Portable;
use vc_map::Polyline;
use vc_traffic::{Crowd, PersonId, Walker, Way};

use crate::people::overlap;

/// The length of a ring, metres, its width, and the pieces of one time around.
const RING: f32 = 100.0;
const WIDTH: f32 = 3.0;
const PIECES: u32 = 72;

fn line(points: &[[f64; 2]]) -> Polyline {
    Polyline::new(points.iter().copied()).unwrap()
}

/// A way four times around a ring.
fn ring() -> Arc<Way> {
    let radius = f64::from(RING) / std::f64::consts::TAU;
    let point = |number: u32| {
        let (sine, cosine) = (f64::from(number) * std::f64::consts::TAU / f64::from(PIECES)).sine_cosine();
        [radius * cosine, radius * sine]
    };
    Arc::new(Way::new([(Polyline::new((0..=4 * PIECES).map(point)).unwrap(), WIDTH)]).unwrap())
}

/// The speed with nobody around: normal, as measured of people in streets (Weidmann, 1993).
fn speed(id: u32) -> f32 {
    Seed(5).nth(u64::from(id)).stream().normal(1.34, 0.26).clamp(0.6, 2.0)
}

/// The mean speed of a crowd of a density on the ring, metres per second, after half a minute.
fn ring_speed(density: f32) -> f32 {
    let way = ring();
    let rows = ((WIDTH - 0.4) * density.sqrt() * 1.15).round().max(1.0) as u32;
    let columns = (density * RING * WIDTH / rows as f32).round() as u32;
    let mut numbers = Seed(3).stream();
    let mut crowd = Crowd::new(0.1);
    for column in 0..columns {
        for row in 0..rows {
            let station = (column as f32 + 0.5 + numbers.between(-0.05, 0.05)) * RING / columns as f32;
            let left = ((row as f32 + 0.5) / rows as f32 - 0.5) * (WIDTH - 0.4) + numbers.between(-0.02, 0.02);
            let id = column * rows + row;
            assert!(crowd.add(Walker::new(PersonId(id), way.clone(), station, left, speed(id))));
        }
    }
    let mut run = |steps: usize| {
        for step in 0..steps {
            crowd.step();
            assert_eq!(overlap(crowd.people().map(|walker| walker.at)), None, "density {density}, step {step}");
        }
        crowd.people().map(|walker| walker.station()).sum::<f32>() / crowd.len() as f32
    };
    let from = run(300);
    (run(300) - from) / 30.0
}

#[test]
fn speed_falls_with_density_as_weidmann_measured() {
    let mut table = String::new();
    let mut worst = 0.0_f32;
    for density in [0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0] {
        let measured = 1.34 * (1.0 - (-1.913_f32 * (1.0 / density - 1.0 / 5.4)).exponential());
        let found = ring_speed(density);
        worst = worst.max((found / measured - 1.0).abs());
        table += &format!(
            "{density} a square metre: {found:.2} m/s, Weidmann {measured:.2}, {:+.1} %\n",
            (found / measured - 1.0) * 100.0
        );
    }
    eprint!("{table}");
    assert!(worst < 0.15, "{table}");
}

#[test]
fn those_with_nobody_around_walk_at_the_speed_of_people_in_streets() {
    // A thousand ways beside each other.
    let mut crowd = Crowd::new(0.1);
    for id in 0..1000 {
        let y = f64::from(id) * 10.0;
        let way = Arc::new(Way::new([(line(&[[0.0, y], [100.0, y]]), 2.0)]).unwrap());
        assert!(crowd.add(Walker::new(PersonId(id), way, 0.0, 0.0, speed(id))));
    }
    let station = |crowd: &Crowd| crowd.people().map(|walker| walker.station()).sum::<f32>() / 1000.0;
    (0..50).for_each(|_| crowd.step());
    let from = station(&crowd);
    (0..200).for_each(|_| crowd.step());
    let mean = (station(&crowd) - from) / 20.0;
    assert!((mean - 1.34).abs() < 0.03, "{mean}");
}

#[test]
fn a_door_lets_through_what_doors_do() {
    // A hall of 8 m, a door of 1.2 m, and the street.
    let parts =
        [([[0.0, 0.0], [14.0, 0.0]], 8.0), ([[14.0, 0.0], [15.0, 0.0]], 1.2), ([[15.0, 0.0], [40.0, 0.0]], 8.0)];
    let way = Arc::new(Way::new(parts.map(|(points, width)| (line(&points), width))).unwrap());
    let mut crowd = Crowd::new(0.1);
    for id in 0..160 {
        let (station, left) = ((id / 10) as f32 * 0.7 + 0.5, (id % 10) as f32 * 0.7 - 3.15);
        assert!(crowd.add(Walker::new(PersonId(id), way.clone(), station, left, speed(id))));
    }
    let mut times = Vec::new();
    for step in 0..2000 {
        let before: Vec<f32> = crowd.people().map(|walker| walker.station()).collect();
        crowd.step();
        assert_eq!(overlap(crowd.people().map(|walker| walker.at)), None, "step {step}");
        let through = crowd.people().zip(before).filter(|(walker, before)| *before < 14.5 && walker.station() >= 14.5);
        times.extend(through.map(|_| step as f32 * 0.1));
        let gone: Vec<PersonId> =
            crowd.people().filter(|walker| walker.station() > 38.0).map(|walker| walker.id).collect();
        gone.into_iter().for_each(|id| _ = crowd.remove(id));
    }
    assert_eq!((times.len(), crowd.len()), (160, 0));
    let flow = 100.0 / (times[120] - times[20]);
    eprintln!("door of 1.2 m: {flow:.2} people a second");
    // From the capacity by Weidmann's relation to what students in a laboratory do (Seyfried et al., 2009).
    assert!((1.4..2.6).contains(&flow), "{flow}");
}

/// Two crowds that meet on a way of 3 m, added in some order.
fn meeting(order: impl Iterator<Item = u32>) -> Crowd {
    let along = line(&[[0.0, 0.0], [40.0, 0.0], [40.0, 20.0]]);
    let ways = [along.clone(), along.reversed()].map(|line| Arc::new(Way::new([(line, 3.0)]).unwrap()));
    let mut crowd = Crowd::new(0.1);
    for id in order {
        let (way, place) = (ways[id as usize % 2].clone(), id / 2);
        let walker =
            Walker::new(PersonId(id), way, 2.0 + (place / 4) as f32, (place % 4) as f32 * 0.6 - 0.9, speed(id));
        assert!(crowd.add(walker));
    }
    crowd
}

#[test]
fn crowds_that_meet_pass_each_other_in_any_order_and_after_any_absence() {
    let mut crowd = meeting(0..80);
    let mut other = meeting((0..80).rev());
    for step in 0..900 {
        crowd.step();
        other.step();
        assert_eq!(overlap(crowd.people().map(|walker| walker.at)), None, "step {step}");
        if step % 50 == 0 {
            let out = PersonId(step / 50 * 3);
            let walker = other.remove(out).unwrap();
            assert!(other.person(out).is_none() && other.add(walker));
        }
        // Nobody leaves the way.
        let off = |walker: &Walker| {
            walker.at[1] < -1.31 || walker.at[0] > 41.31 || (walker.at[0] < 38.69 && walker.at[1] > 1.31)
        };
        assert_eq!(crowd.people().find(off).map(|walker| walker.at), None, "step {step}");
    }
    assert_eq!(crowd.digest(), other.digest());
    let arrived = crowd.people().filter(|walker| walker.station() > 57.0).count();
    assert!(arrived > 70, "{arrived} of 80");
}
