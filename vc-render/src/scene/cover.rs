//! Blinds and curtains: where they hang, and how far they reach when they are drawn.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::{Body, Instance};
use crate::math::{Affine, Bounds, Narrow, point, three};
use crate::mesh::Mesh;

/// Greatest distance of a cover from its opening, metres: out of the wall, and along the wall or above.
const OFF: [f32; 2] = [0.35, 0.4];
/// A cover at least this share of an opening wide comes down over it from above; a narrower one is drawn from
/// the side.
const WIDE: f32 = 0.8;
/// Overlap of two curtains that meet, and clearance between a cover and what stands out of the opening, metres.
const LAP: f32 = 0.005;
/// Least depth of a cover drawn before something that stands out, metres: its pleats are drawn flat.
const FLAT: f32 = 0.03;
/// Greatest distance from the wall at which a cover passes before a thing, such as a radiator, metres. It ends
/// above things that stand out farther.
const SWEEP: f32 = 0.2;

/// Least share of the smaller of two extents, along each axis, that covers in the same place share.
const TOGETHER: f32 = 0.5;

/// Part of a cover: how it is placed when the cover is drawn over its opening, and otherwise, in the frame of its
/// pose.
#[derive(Debug, Clone)]
pub(super) struct Drawn {
    pub(super) closed: bool,
    /// The map that stretches it over its share of the opening, if it is stretched.
    pub(super) stretch: Option<Arc<Affine>>,
    /// The map into its layer, if several covers hang in the same place.
    pub(super) aside: Option<Arc<Affine>>,
}

impl Drawn {
    /// The map that applies now.
    pub(super) fn map(&self) -> Option<&Affine> {
        let stretch = self.stretch.as_deref().filter(|_| self.closed);
        stretch.or(self.aside.as_deref())
    }
}

/// The layer of a cover among those that hang in the same place: its position from the back, and their number.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Layer {
    at: usize,
    of: usize,
}

impl Layer {
    /// The map that flattens a cover of an extent along X into its layer.
    fn flattened(self, [back, front]: [f32; 2]) -> Affine {
        let end = |layer: usize| back + (front - back) * layer as f32 / self.of as f32;
        spanned(0, [back, front], [end(self.at), end(self.at + 1)])
    }
}

/// The boxes of a cover and of its opening in the cover's frame: X out of the wall, Z upwards.
struct Hung {
    own: Bounds,
    /// The cover without the head that it hangs from.
    loose: Bounds,
    opening: Bounds,
    /// Boxes of the opening's parts, and of things that stand before it.
    parts: Vec<Bounds>,
}

/// Bodies that matter to covers, by number.
#[derive(Default)]
pub(super) struct Around {
    /// Covers, each with whether it is closed.
    pub(super) covers: Vec<(usize, bool)>,
    pub(super) openings: Vec<usize>,
    /// Things that stand in rooms and are not carried about.
    pub(super) standing: Vec<usize>,
}

/// Finds the opening of each cover, sets covers that hang in the same place apart, and draws covers according to
/// their states.
pub(super) fn hang((bodies, instances): (&mut [Body], &mut [Instance]), around: &Around) {
    let stretches = stretches((bodies, instances), around);
    let layers = layers(bodies, around);
    for (((body, closed), stretch), layer) in around.covers.iter().zip(stretches).zip(layers) {
        let body = &mut bodies[*body];
        let depth = ends(&body.bounds, 0);
        let aside = layer.map(|layer| Arc::new(layer.flattened(depth)));
        let wide = stretch.as_ref().is_some_and(|(wide, _)| *wide);
        let stretch = stretch.map(|(_, map)| match layer {
            Some(layer) => layer.flattened(depth.map(|x| along_x(&map, x))).after(&map),
            None => map,
        });
        let stretch = stretch.map(Arc::new);
        let own = &mut instances[body.instances.start as usize..body.instances.end as usize];
        for instance in own.iter_mut() {
            let stretch = stretch.clone().filter(|_| !(wide && instance.link.head));
            if stretch.is_some() || aside.is_some() {
                instance.drawn = Some(Drawn { closed: !*closed, stretch, aside: aside.clone() });
            }
        }
        draw((body, instances), *closed);
    }
}

/// The coordinate along X to which a map of axes takes another.
fn along_x(map: &Affine, x: f32) -> f32 {
    (map.0[0][0] * f64::from(x) + map.0[0][3]) as f32
}

/// The layer of each cover that hangs where others do: the first of them is in front.
fn layers(bodies: &[Body], around: &Around) -> Vec<Option<Layer>> {
    let covers = || around.covers.iter().map(|(body, _)| &bodies[*body]);
    let layer = |cover: &Body| {
        let together: Vec<&Body> = covers().filter(|other| hang_together(cover, other)).collect();
        let (first, of) = (*together.first()?, together.len());
        let rank = together.iter().position(|other| other.node == cover.node)?;
        let axis = |body: &Body| body.pose.rotation * nalgebra::Vector3::x();
        let faces = axis(first).dot(&axis(cover)) >= 0.0;
        (of > 1).then_some(Layer { at: if faces { of - 1 - rank } else { rank }, of })
    };
    covers().map(layer).collect()
}

/// Whether two covers hang in the same place: a cover does with itself.
fn hang_together(cover: &Body, other: &Body) -> bool {
    let Some(back) = Affine::from_pose(&cover.pose).inverse() else { return false };
    let (own, other) = (cover.bounds, other.bounds.mapped(&back.after(&Affine::from_pose(&other.pose)).narrow()));
    (0..3).all(|axis| {
        let ([a, b], [c, d]) = (ends(&own, axis), ends(&other, axis));
        b.min(d) - a.max(c) >= TOGETHER * (b - a).min(d - c)
    })
}

/// Draws a cover over its opening, or aside.
pub(super) fn draw((body, instances): (&mut Body, &mut [Instance]), closed: bool) {
    let own = &mut instances[body.instances.start as usize..body.instances.end as usize];
    for instance in own.iter_mut() {
        let Some(drawn) = instance.drawn.as_mut().filter(|drawn| drawn.closed != closed) else { continue };
        drawn.closed = closed;
        instance.put(&body.pose, &body.scale);
    }
    body.bounds = body.measured(own);
}

/// For each cover, the map that stretches it over the nearest opening, and whether it comes down from above;
/// `None` if no opening is near.
fn stretches((bodies, instances): (&[Body], &[Instance]), around: &Around) -> Vec<Option<(bool, Affine)>> {
    let hung = |(cover, _): &(usize, bool)| {
        let cover = &bodies[*cover];
        let all = around.openings.iter().filter_map(|o| Some((*o, Hung::new(cover, &bodies[*o], instances)?)));
        let (opening, hung) = all.min_by(|a, b| a.1.apart().total_cmp(&b.1.apart()))?;
        let standing = around.standing.iter().map(|body| &bodies[*body]);
        Some((opening, hung.among(cover, standing, instances)))
    };
    let places: Vec<Option<(usize, Hung)>> = around.covers.iter().map(hung).collect();
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
    /// None if the cover does not hang at the opening.
    fn new(cover: &Body, opening: &Body, instances: &[Instance]) -> Option<Self> {
        let back = Affine::from_pose(&cover.pose).inverse()?;
        let of = |body: &Body| &instances[body.instances.start as usize..body.instances.end as usize];
        let own = |i: &Instance| back.after(&i.world).narrow();
        let around = |i: &Instance| i.link.levels[0].bounds.mapped(&own(i));
        // Swinging parts of the opening are left out.
        let fixed = || of(opening).iter().filter(|i| i.link.joint.is_none());
        let made = Self {
            own: cover.bounds,
            loose: of(cover).iter().filter(|i| !i.link.head).map(around).reduce(|a, b| a.joined(&b))?,
            opening: fixed().map(around).reduce(|a, b| a.joined(&b))?,
            parts: Vec::new(),
        };
        let near = (0..3).all(|i| made.gap(i) <= OFF[usize::from(i > 0)]);
        // The cover must hang along the wall, not across it.
        let along = near && made.opening.half[1] > made.opening.half[0];
        along.then(|| Self { parts: fixed().flat_map(|i| parts(&own(i), &i.link.levels[0])).collect(), ..made })
    }

    /// Adds the parts of things that stand where the cover may come down or pass.
    fn among<'a>(self, cover: &Body, standing: impl Iterator<Item = &'a Body>, instances: &[Instance]) -> Self {
        let Some(back) = Affine::from_pose(&cover.pose).inverse() else { return self };
        let (all, [wall, front]) = (self.own.joined(&self.opening), ends(&self.own, 0));
        let reach = [[wall, front.max(wall + SWEEP + FLAT)], ends(&all, 1), ends(&all, 2)];
        let near =
            |body: &&Body| meets(&body.bounds.mapped(&back.after(&Affine::from_pose(&body.pose)).narrow()), &reach);
        let own = |body: &Body| &instances[body.instances.start as usize..body.instances.end as usize];
        let found = standing.filter(near).flat_map(own);
        let found = found.flat_map(|i| parts(&back.after(&i.world).narrow(), &i.link.levels[0]));
        let found: Vec<Bounds> = found.filter(|part| meets(part, &reach)).collect();
        Self { parts: [self.parts, found].concat(), ..self }
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

    /// The side of the opening at which the cover hangs: one or minus one.
    fn side(&self) -> f32 {
        if self.own.centre[1] < self.opening.centre[1] { -1.0 } else { 1.0 }
    }

    /// Stretches the cover down to the opening's lower edge, or to a thing that stands out or stands there.
    fn lowered(&self) -> Affine {
        let [low, high] = ends(&self.loose, 2);
        let way = [ends(&self.own, 0), ends(&self.own, 1), [f32::NEG_INFINITY, low]];
        let tops = self.parts.iter().filter(|part| meets(part, &way)).map(|part| ends(part, 2)[1]);
        let end = tops.filter(|top| *top < low).map(|top| top + LAP).fold(ends(&self.opening, 2)[0], f32::max);
        spanned(2, [low, high], [end.min(low), high])
    }

    /// Stretches the cover from its side to the opening's other side, or to the middle if `other` comes from
    /// there. It passes before things that stand out there or are flat, such as radiators, and ends above deep
    /// ones.
    fn drawn(&self, other: bool) -> Affine {
        let (side, [low, high]) = (self.side(), ends(&self.own, 1));
        let end = if other { self.opening.centre[1] } else { ends(&self.opening, 1)[usize::from(side < 0.0)] };
        let to = end - side * LAP;
        // The cover may already reach farther.
        let across = if side < 0.0 { [low, to.max(high)] } else { [to.min(low), high] };
        let ([back, front], [bottom, top]) = (ends(&self.own, 0), ends(&self.own, 2));
        let depth = |foot: f32| match self.clear(across, [foot, top]) {
            clear if clear > back => [clear, front.max(clear + FLAT)],
            _ => [back, front],
        };
        let foot = self.foot([depth(bottom), across, [bottom, top]]);
        let along = spanned(1, [low, high], across).after(&spanned(2, [bottom, top], [foot, top]));
        along.after(&spanned(0, [back, front], depth(foot)))
    }

    /// Distance from the wall at which a cover clears all things that are not deep, given its extent across and
    /// upwards.
    fn clear(&self, across: [f32; 2], upwards: [f32; 2]) -> f32 {
        let back = ends(&self.own, 0)[0];
        let way = self.parts.iter().filter(|part| meets(part, &[[back, back + SWEEP], across, upwards]));
        way.map(|part| ends(part, 0)[1]).filter(|out| *out <= back + SWEEP).map(|out| out + LAP).fold(back, f32::max)
    }

    /// The height at which a cover ends, given the space it occupies: above the things that reach into that
    /// space from below.
    fn foot(&self, room: [[f32; 2]; 3]) -> f32 {
        let (most, [bottom, _]) = (self.opening.centre[2], room[2]);
        let tops = self.parts.iter().filter(|part| meets(part, &room)).map(|part| ends(part, 2)[1] + LAP);
        // Things higher than half of the opening are ignored, as the cover above them would leave little to
        // close.
        tops.filter(|top| *top < most).fold(bottom, f32::max)
    }
}

fn ends(bounds: &Bounds, axis: usize) -> [f32; 2] {
    [bounds.centre[axis] - bounds.half[axis], bounds.centre[axis] + bounds.half[axis]]
}

/// Whether a box overlaps another, given as the range along each axis.
fn meets(bounds: &Bounds, other: &[[f32; 2]; 3]) -> bool {
    (0..3).all(|axis| ends(bounds, axis)[1] > other[axis][0] && ends(bounds, axis)[0] < other[axis][1])
}

/// The bounding boxes of the parts of a mapped mesh.
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

/// The map that stretches along an axis so that two coordinates go to two others.
fn spanned(axis: usize, [a, b]: [f32; 2], [low, high]: [f32; 2]) -> Affine {
    let by = if a == b { 1.0 } else { f64::from(high - low) / f64::from(b - a) };
    Affine(three(|r| {
        let mut row = [0.0; 4];
        row[r] = if r == axis { by } else { 1.0 };
        row[3] = if r == axis { f64::from(low) - f64::from(a) * by } else { 0.0 };
        row
    }))
}
