//! Blinds and curtains: where they hang, and how far they reach when they are drawn.

use std::sync::Arc;

use super::{Body, Instance, turned};
use crate::affine::{Affine, three};
use crate::mesh::Bounds;

/// How far off an opening in the wall what covers it hangs at most: out of the wall, and to its side or above.
const OFF: [f32; 2] = [0.35, 0.4];
/// What is as wide as this share of an opening comes down over it; what is not is drawn over it from the side.
const WIDE: f32 = 0.8;
/// How far two that meet reach over each other, metres.
const LAP: f32 = 0.005;

/// A cover that can be drawn over an opening.
#[derive(Debug, Clone)]
pub(super) struct Drawn {
    pub(super) closed: bool,
    /// What stretches it over its share of the opening, in the frame of its pose.
    pub(super) stretch: Arc<Affine>,
}

/// The boxes of a cover and of an opening in the cover's frame: X out of the wall, Z upwards.
struct Hung {
    own: Bounds,
    opening: Bounds,
}

/// Finds for covers, each with whether it is closed, where they hang, and draws them as they are.
pub(super) fn hang((bodies, instances): (&mut [Body], &mut [Instance]), covers: &[(usize, bool)], openings: &[usize]) {
    let numbers: Vec<usize> = covers.iter().map(|(body, _)| *body).collect();
    for ((body, closed), stretch) in covers.iter().zip(stretches((bodies, instances), &numbers, openings)) {
        let Some(stretch) = stretch.map(Arc::new) else { continue };
        let body = &mut bodies[*body];
        for instance in &mut instances[body.instances.start as usize..body.instances.end as usize] {
            instance.drawn = Some(Drawn { closed: false, stretch: stretch.clone() });
        }
        draw((body, instances), *closed);
    }
}

/// Draws the cover that is a body, or draws it aside.
pub(super) fn draw((body, instances): (&mut Body, &mut [Instance]), closed: bool) {
    let own = &mut instances[body.instances.start as usize..body.instances.end as usize];
    for instance in own.iter_mut() {
        let Some(drawn) = instance.drawn.as_mut().filter(|drawn| drawn.closed != closed) else { continue };
        drawn.closed = closed;
        instance.put(&body.pose, &body.scale);
    }
    body.bounds = body.measured(own);
}

/// For each cover what draws it over the opening nearest to it; none where none is near.
///
/// Covers and openings are numbers of bodies.
fn stretches((bodies, instances): (&[Body], &[Instance]), covers: &[usize], openings: &[usize]) -> Vec<Option<Affine>> {
    let hung = |cover: &usize| {
        let all = openings.iter().filter_map(|o| Some((*o, Hung::of(&bodies[*cover], &bodies[*o], instances)?)));
        all.min_by(|a, b| a.1.apart().total_cmp(&b.1.apart()))
    };
    let places: Vec<Option<(usize, Hung)>> = covers.iter().map(hung).collect();
    let other = |opening: usize, side: f32| {
        let there = |(at, hung): &(usize, Hung)| *at == opening && !hung.is_wide() && hung.side() == -side;
        places.iter().flatten().any(there)
    };
    let stretch = |(opening, hung): &(usize, Hung)| hung.stretch(other(*opening, hung.side()));
    places.iter().map(|place| place.as_ref().map(stretch)).collect()
}

impl Hung {
    /// None where the cover does not hang at the opening.
    fn of(cover: &Body, opening: &Body, instances: &[Instance]) -> Option<Self> {
        let back = Affine::of(&cover.pose).inverse()?;
        // Without what swings in it.
        let fixed = |i: &&Instance| i.link.joint.is_none();
        let frames = instances[opening.instances.start as usize..opening.instances.end as usize].iter().filter(fixed);
        let boxes = frames.map(|i| turned(&back.after(&i.world).narrow(), &i.link.levels[0].bounds));
        let made = Self { own: cover.bounds, opening: boxes.reduce(|a, b| a.joined(&b))? };
        let near = (0..3).all(|i| made.gap(i) <= OFF[usize::from(i > 0)]);
        // Along the wall and not across it.
        (near && made.opening.half[1] > made.opening.half[0]).then_some(made)
    }

    fn ends(bounds: &Bounds, axis: usize) -> [f32; 2] {
        [bounds.centre[axis] - bounds.half[axis], bounds.centre[axis] + bounds.half[axis]]
    }

    fn gap(&self, axis: usize) -> f32 {
        (self.own.centre[axis] - self.opening.centre[axis]).abs() - self.own.half[axis] - self.opening.half[axis]
    }

    fn apart(&self) -> f32 {
        (0..3).map(|i| self.gap(i).max(0.0)).sum()
    }

    fn is_wide(&self) -> bool {
        self.own.half[1] >= WIDE * self.opening.half[1]
    }

    /// At which side of the opening it is: one or minus one.
    fn side(&self) -> f32 {
        if self.own.centre[1] < self.opening.centre[1] { -1.0 } else { 1.0 }
    }

    /// Down to the opening's lower edge, or from the side to its other one: to its middle, if `other` comes from there.
    fn stretch(&self, other: bool) -> Affine {
        if self.is_wide() {
            let [low, high] = Self::ends(&self.own, 2);
            return stretched(2, high, low, Self::ends(&self.opening, 2)[0].min(low));
        }
        let (side, [low, high]) = (self.side(), Self::ends(&self.own, 1));
        let (fixed, free) = if side < 0.0 { (low, high) } else { (high, low) };
        let end = if other { self.opening.centre[1] } else { Self::ends(&self.opening, 1)[usize::from(side < 0.0)] };
        let to = end - side * LAP;
        // It may already reach farther.
        stretched(1, fixed, free, if side < 0.0 { to.max(free) } else { to.min(free) })
    }
}

/// Along an axis, so that one place stays and another comes to a third.
fn stretched(axis: usize, fixed: f32, from: f32, to: f32) -> Affine {
    let by = if from == fixed { 1.0 } else { f64::from(to - fixed) / f64::from(from - fixed) };
    Affine(three(|r| {
        let mut row = [0.0; 4];
        row[r] = if r == axis { by } else { 1.0 };
        row[3] = if r == axis { f64::from(fixed) * (1.0 - by) } else { 0.0 };
        row
    }))
}
