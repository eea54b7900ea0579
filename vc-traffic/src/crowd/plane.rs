//! Half-planes of velocities, and the best velocity within them: a linear programme in two dimensions, solved one half-plane after
//! the other (Seidel 1991; de Berg et al., Computational Geometry, chapter 4).

use nalgebra::Vector2;

/// Lines with a smaller sine between them are parallel.
const PARALLEL: f32 = 1e-5;

/// The velocities whose part along a unit vector is at least some metres per second.
#[derive(Debug, Clone, Copy)]
pub(super) struct HalfPlane {
    pub(super) normal: Vector2<f32>,
    pub(super) least: f32,
}

impl HalfPlane {
    /// By how much a velocity is outside, metres per second.
    fn lacks(&self, velocity: &Vector2<f32>) -> f32 {
        self.least - velocity.dot(&self.normal)
    }
}

/// The best of some velocities.
#[derive(Clone, Copy)]
enum Aim {
    /// The nearest to one.
    Near(Vector2<f32>),
    /// The farthest in a direction.
    Far(Vector2<f32>),
}

/// The velocity nearest to a wish, at most of a speed, within all half-planes. Where there is none, the `soft` ones are left by as little
/// as possible, the most by which one is left being least; the `hard` ones never are: zero is within them.
pub(super) fn best(
    hard: &[HalfPlane],
    soft: &[HalfPlane],
    wish: Vector2<f32>,
    speed: f32,
    scratch: &mut Vec<HalfPlane>,
) -> Vector2<f32> {
    scratch.clear();
    scratch.extend_from_slice(hard);
    scratch.extend_from_slice(soft);
    let start = if wish.norm_squared() > speed * speed { wish * (speed / wish.norm()) } else { wish };
    match within(scratch, Aim::Near(wish), start, speed) {
        Ok(found) => found,
        Err((failed, found)) if failed >= hard.len() => {
            least_outside(hard, soft, failed - hard.len(), found, speed, scratch)
        }
        // Only rounding leads here: standing still is always allowed.
        Err(_) => Vector2::zeros(),
    }
}

/// The best velocity within half-planes; else the first that leaves none, and the best within those before it.
fn within(
    planes: &[HalfPlane],
    aim: Aim,
    start: Vector2<f32>,
    speed: f32,
) -> Result<Vector2<f32>, (usize, Vector2<f32>)> {
    let mut best = start;
    for (number, plane) in planes.iter().enumerate() {
        if plane.lacks(&best) > 0.0 {
            best = on_line(&planes[..number], plane, aim, speed).ok_or((number, best))?;
        }
    }
    Ok(best)
}

/// The best velocity on the edge of a half-plane, within others.
fn on_line(others: &[HalfPlane], plane: &HalfPlane, aim: Aim, speed: f32) -> Option<Vector2<f32>> {
    let at = plane.normal * plane.least;
    let along = Vector2::new(-plane.normal.y, plane.normal.x);
    let reach = speed * speed - plane.least * plane.least;
    if reach < 0.0 {
        return None;
    }
    let (mut low, mut high) = (-reach.sqrt(), reach.sqrt());
    for other in others {
        let (rises, lacks) = (along.dot(&other.normal), other.lacks(&at));
        if rises.abs() < PARALLEL {
            if lacks > PARALLEL {
                return None;
            }
        } else if rises > 0.0 {
            low = low.max(lacks / rises);
        } else {
            high = high.min(lacks / rises);
        }
        if low > high {
            return None;
        }
    }
    let wanted = match aim {
        Aim::Near(wish) => along.dot(&(wish - at)).clamp(low, high),
        Aim::Far(direction) if along.dot(&direction) > 0.0 => high,
        Aim::Far(_) => low,
    };
    Some(at + along * wanted)
}

/// The velocity within the hard half-planes that is outside of the soft ones by least, from the first that could not be kept on.
fn least_outside(
    hard: &[HalfPlane],
    soft: &[HalfPlane],
    failed: usize,
    found: Vector2<f32>,
    speed: f32,
    scratch: &mut Vec<HalfPlane>,
) -> Vector2<f32> {
    let (mut best, mut outside) = (found, 0.0);
    for (number, plane) in soft.iter().enumerate().skip(failed) {
        if plane.lacks(&best) <= outside {
            continue;
        }
        scratch.clear();
        scratch.extend_from_slice(hard);
        // Where those before are left by no more than this one.
        scratch.extend(soft[..number].iter().filter_map(|other| {
            let between = other.normal - plane.normal;
            let length = between.norm();
            (length > PARALLEL)
                .then(|| HalfPlane { normal: between / length, least: (other.least - plane.least) / length })
        }));
        let start = plane.normal * speed;
        if let Ok(better) = within(scratch, Aim::Far(plane.normal), start, speed) {
            best = better;
        }
        outside = plane.lacks(&best);
    }
    best
}
