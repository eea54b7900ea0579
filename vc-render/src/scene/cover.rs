//! Blinds and curtains: where they hang, and how far they reach when they are drawn.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Body, Instance, turned};
use crate::affine::{Affine, Narrow, point, three};
use crate::mesh::{Bounds, Mesh};

/// How far off an opening in the wall what covers it hangs at most: out of the wall, and to its side or above.
const OFF: [f32; 2] = [0.35, 0.4];
/// What is as wide as this share of an opening comes down over it; what is not is drawn over it from the side.
const WIDE: f32 = 0.8;
/// How far two that meet reach over each other, and how far off what stands out of an opening a cover stays, metres.
const LAP: f32 = 0.005;
/// Depth of a cover that sweeps before what stands out, at least, metres: its pleats are drawn flat.
const FLAT: f32 = 0.03;

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
    /// Without the head that it hangs from.
    loose: Bounds,
    opening: Bounds,
    /// Of the opening's parts.
    parts: Vec<Bounds>,
}

/// Finds for covers, each with whether it is closed, where they hang, and draws them as they are.
pub(super) fn hang((bodies, instances): (&mut [Body], &mut [Instance]), covers: &[(usize, bool)], openings: &[usize]) {
    let numbers: Vec<usize> = covers.iter().map(|(body, _)| *body).collect();
    for ((body, closed), stretch) in covers.iter().zip(stretches((bodies, instances), &numbers, openings)) {
        let Some((wide, stretch)) = stretch.map(|(wide, stretch)| (wide, Arc::new(stretch))) else { continue };
        let body = &mut bodies[*body];
        let own = &mut instances[body.instances.start as usize..body.instances.end as usize];
        for instance in own.iter_mut().filter(|i| !(wide && i.link.head)) {
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

/// For each cover what draws it over the opening nearest to it, and whether it comes down; none where none is near.
///
/// Covers and openings are numbers of bodies.
fn stretches(
    (bodies, instances): (&[Body], &[Instance]),
    covers: &[usize],
    openings: &[usize],
) -> Vec<Option<(bool, Affine)>> {
    let hung = |cover: &usize| {
        let all = openings.iter().filter_map(|o| Some((*o, Hung::of(&bodies[*cover], &bodies[*o], instances)?)));
        all.min_by(|a, b| a.1.apart().total_cmp(&b.1.apart()))
    };
    let places: Vec<Option<(usize, Hung)>> = covers.iter().map(hung).collect();
    let other = |opening: usize, side: f32| {
        let there = |(at, hung): &(usize, Hung)| *at == opening && !hung.is_wide() && hung.side() == -side;
        places.iter().flatten().any(there)
    };
    let stretch = |(opening, hung): &(usize, Hung)| match hung.is_wide() {
        true => (true, hung.lowered()),
        false => (false, hung.drawn(other(*opening, hung.side()))),
    };
    places.iter().map(|place| place.as_ref().map(stretch)).collect()
}

impl Hung {
    /// None where the cover does not hang at the opening.
    fn of(cover: &Body, opening: &Body, instances: &[Instance]) -> Option<Self> {
        let back = Affine::of(&cover.pose).inverse()?;
        let of = |body: &Body| &instances[body.instances.start as usize..body.instances.end as usize];
        let own = |i: &Instance| back.after(&i.world).narrow();
        let around = |i: &Instance| turned(&own(i), &i.link.levels[0].bounds);
        // Without what swings in it.
        let fixed = || of(opening).iter().filter(|i| i.link.joint.is_none());
        let made = Self {
            own: cover.bounds,
            loose: of(cover).iter().filter(|i| !i.link.head).map(around).reduce(|a, b| a.joined(&b))?,
            opening: fixed().map(around).reduce(|a, b| a.joined(&b))?,
            parts: Vec::new(),
        };
        let near = (0..3).all(|i| made.gap(i) <= OFF[usize::from(i > 0)]);
        // Along the wall and not across it.
        let along = near && made.opening.half[1] > made.opening.half[0];
        along.then(|| Self { parts: fixed().flat_map(|i| parts(&own(i), &i.link.levels[0])).collect(), ..made })
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

    /// Parts of the opening that stand out of the wall as far as the cover hangs before it.
    fn in_the_way(&self) -> impl Iterator<Item = &Bounds> {
        let back = Self::ends(&self.own, 0)[0];
        self.parts.iter().filter(move |part| Self::ends(part, 0)[1] > back)
    }

    /// Down to the opening's lower edge, or to what stands out there.
    fn lowered(&self) -> Affine {
        let [low, high] = Self::ends(&self.loose, 2);
        let below = self.in_the_way().map(|part| Self::ends(part, 2)[1]).filter(|top| *top < low);
        let end = below.map(|top| top + LAP).fold(Self::ends(&self.opening, 2)[0], f32::max);
        spanned(2, [low, high], [end.min(low), high])
    }

    /// From its side to the opening's other one: to the middle, if `other` comes from there. And before what stands
    /// out there.
    fn drawn(&self, other: bool) -> Affine {
        let (side, [low, high]) = (self.side(), Self::ends(&self.own, 1));
        let end = if other { self.opening.centre[1] } else { Self::ends(&self.opening, 1)[usize::from(side < 0.0)] };
        let to = end - side * LAP;
        // It may already reach farther.
        let along = spanned(1, [low, high], if side < 0.0 { [low, to.max(high)] } else { [to.min(low), high] });
        let [bottom, top] = Self::ends(&self.own, 2);
        let beside = |part: &&Bounds| Self::ends(part, 2)[1] > bottom && Self::ends(part, 2)[0] < top;
        let way = self.in_the_way().filter(beside).map(|part| Self::ends(part, 0)[1] + LAP);
        let [back, front] = Self::ends(&self.own, 0);
        let clear = way.fold(back, f32::max);
        if clear == back {
            return along;
        }
        along.after(&spanned(0, [back, front], [clear, front.max(clear + FLAT)]))
    }
}

/// The boxes around the parts of a mesh that is mapped.
fn parts(map: &Narrow, mesh: &Mesh) -> Vec<Bounds> {
    let mut boxes: BTreeMap<u16, Bounds> = BTreeMap::new();
    for cluster in &mesh.clusters {
        for triangle in cluster.triangles.clone().map(|t| t as usize) {
            let own = Bounds::around(mesh.triangle(cluster, triangle).map(|p| point(map, p)).into_iter());
            boxes.entry(mesh.faces[triangle].part).and_modify(|all| *all = all.joined(&own)).or_insert(own);
        }
    }
    boxes.into_values().collect()
}

/// Along an axis, so that two places come to two others.
fn spanned(axis: usize, [a, b]: [f32; 2], [low, high]: [f32; 2]) -> Affine {
    let by = if a == b { 1.0 } else { f64::from(high - low) / f64::from(b - a) };
    Affine(three(|r| {
        let mut row = [0.0; 4];
        row[r] = if r == axis { by } else { 1.0 };
        row[3] = if r == axis { f64::from(low) - f64::from(a) * by } else { 0.0 };
        row
    }))
}
