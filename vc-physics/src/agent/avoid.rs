//! Mutual avoidance of walkers: optimal reciprocal collision avoidance.
//!
//! Each walker takes half of the change that two walkers need to avoid each other, and chooses the velocity
//! nearest to its wish that keeps clear of all others (van den Berg, Guy, Lin and Manocha, "Reciprocal n-body
//! collision avoidance", 2011): a linear program in two dimensions, solved line by line.

use nalgebra::{Point2, Vector2};

/// Time horizon, seconds.
const AHEAD: f32 = 1.5;
/// Distance beyond which other walkers are ignored, metres.
const SIGHT: f32 = 4.0;
/// Deviation to the right of the wish while others are near.
const RIGHT: f32 = 0.12;
/// Cross products below this count as zero.
const TINY: f32 = 1e-5;

/// A walker on the floor.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Walker {
    pub(crate) at: Point2<f32>,
    pub(crate) velocity: Vector2<f32>,
    pub(crate) wish: Vector2<f32>,
    pub(crate) radius: f32,
    pub(crate) fastest: f32,
}

/// A half-plane: velocities on the left of the line are allowed.
#[derive(Clone, Copy)]
struct Line {
    point: Vector2<f32>,
    direction: Vector2<f32>,
}

/// The velocity for each walker.
pub(crate) fn velocities(walkers: &[Walker], dt: f32) -> Vec<Vector2<f32>> {
    (0..walkers.len()).map(|i| velocity(walkers, i, dt)).collect()
}

fn velocity(walkers: &[Walker], own: usize, dt: f32) -> Vector2<f32> {
    let me = &walkers[own];
    let near = |o: &&Walker| (o.at - me.at).norm() < SIGHT;
    let others = walkers.iter().enumerate().filter(|(i, _)| *i != own).map(|(_, w)| w).filter(near);
    let lines: Vec<Line> = others.map(|other| half_plane(me, other, dt)).collect();
    if lines.is_empty() || me.wish == Vector2::zeros() {
        // A walker without a wish lets the others walk around it.
        return me.wish;
    }
    // Everybody keeps a little to the right; otherwise walkers that meet head on would stop.
    let wish = Vector2::new(me.wish.x + RIGHT * me.wish.y, me.wish.y - RIGHT * me.wish.x);
    let (best, failed) = program(&lines, me.fastest, wish, false);
    failed.map_or(best, |from| least_bad(&lines, from, me.fastest, best))
}

/// The half-plane that another walker imposes on `me`: half of the avoiding change, or all of it if the other
/// stands.
fn half_plane(me: &Walker, other: &Walker, dt: f32) -> Line {
    let (apart, closing) = (other.at - me.at, me.velocity - other.velocity);
    let (distance, radius) = (apart.norm_squared(), me.radius + other.radius);
    let share = if other.wish == Vector2::zeros() { 1.0 } else { 0.5 };
    let (direction, change) = if distance > radius * radius {
        let from_cap = closing - apart / AHEAD;
        let (length, along) = (from_cap.norm_squared(), from_cap.dot(&apart));
        if along < 0.0 && along * along > radius * radius * length {
            cap(from_cap, radius / AHEAD)
        } else {
            leg(apart, closing, from_cap, (distance - radius * radius).sqrt(), radius, distance)
        }
    } else {
        cap(closing - apart / dt, radius / dt)
    };
    Line { point: me.velocity + change * share, direction }
}

/// Projection onto the round end of the velocity obstacle.
fn cap(from: Vector2<f32>, radius: f32) -> (Vector2<f32>, Vector2<f32>) {
    let length = from.norm();
    // Two walkers at the same position separate along the fixed direction X.
    let unit = if length > TINY { from / length } else { Vector2::x() };
    (Vector2::new(unit.y, -unit.x), unit * (radius - length))
}

/// Projection onto a side of the velocity obstacle.
fn leg(
    apart: Vector2<f32>,
    closing: Vector2<f32>,
    from_cap: Vector2<f32>,
    side: f32,
    radius: f32,
    distance: f32,
) -> (Vector2<f32>, Vector2<f32>) {
    let left = cross(apart, from_cap) > 0.0;
    let direction = if left {
        Vector2::new(apart.x * side - apart.y * radius, apart.x * radius + apart.y * side) / distance
    } else {
        -Vector2::new(apart.x * side + apart.y * radius, -apart.x * radius + apart.y * side) / distance
    };
    (direction, direction * closing.dot(&direction) - closing)
}

fn cross(a: Vector2<f32>, b: Vector2<f32>) -> f32 {
    a.x * b.y - a.y * b.x
}

/// The best velocity on a line within a circle and the lines before it.
fn on_line(lines: &[Line], at: usize, fastest: f32, wish: Vector2<f32>, far: bool) -> Option<Vector2<f32>> {
    let line = lines[at];
    let dot = line.point.dot(&line.direction);
    let reach = dot * dot + fastest * fastest - line.point.norm_squared();
    if reach < 0.0 {
        return None;
    }
    let (mut low, mut high) = (-dot - reach.sqrt(), -dot + reach.sqrt());
    for other in &lines[..at] {
        let denominator = cross(line.direction, other.direction);
        let numerator = cross(other.direction, line.point - other.point);
        if denominator.abs() <= TINY {
            if numerator < 0.0 {
                return None;
            }
            continue;
        }
        let t = numerator / denominator;
        if denominator > 0.0 {
            high = high.min(t);
        } else {
            low = low.max(t);
        }
        if low > high {
            return None;
        }
    }
    let t = match far {
        true if wish.dot(&line.direction) > 0.0 => high,
        true => low,
        false => line.direction.dot(&(wish - line.point)).clamp(low, high),
    };
    Some(line.point + line.direction * t)
}

/// The velocity within all half-planes that is nearest to a wish (or farthest along it), and the first line
/// that cannot be satisfied, if there is one.
fn program(lines: &[Line], fastest: f32, wish: Vector2<f32>, far: bool) -> (Vector2<f32>, Option<usize>) {
    let mut best = match wish.norm() {
        _ if far => wish * fastest,
        fast if fast > fastest => wish * (fastest / fast),
        _ => wish,
    };
    for (i, line) in lines.iter().enumerate() {
        if cross(line.direction, line.point - best) > 0.0 {
            match on_line(lines, i, fastest, wish, far) {
                Some(better) => best = better,
                None => return (best, Some(i)),
            }
        }
    }
    (best, None)
}

/// The velocity that violates the lines least, if not all can be satisfied.
fn least_bad(lines: &[Line], from: usize, fastest: f32, start: Vector2<f32>) -> Vector2<f32> {
    let (mut best, mut worst) = (start, 0.0);
    for (i, line) in lines.iter().enumerate().skip(from) {
        if cross(line.direction, line.point - best) <= worst {
            continue;
        }
        let between: Vec<Line> = lines[..i].iter().filter_map(|other| bisector(line, other)).collect();
        let upward = Vector2::new(-line.direction.y, line.direction.x);
        let (better, failed) = program(&between, fastest, upward, true);
        if failed.is_none() {
            best = better;
        }
        worst = cross(line.direction, line.point - best);
    }
    best
}

/// The line on which two lines are violated equally.
fn bisector(line: &Line, other: &Line) -> Option<Line> {
    let denominator = cross(line.direction, other.direction);
    let point = if denominator.abs() <= TINY {
        if line.direction.dot(&other.direction) > 0.0 {
            return None;
        }
        (line.point + other.point) * 0.5
    } else {
        line.point + line.direction * (cross(other.direction, line.point - other.point) / denominator)
    };
    let direction = (other.direction - line.direction).try_normalize(TINY)?;
    Some(Line { point, direction })
}
