//! Dressing with pieces that stand, lie or hang: rugs, bins, rails, pictures, by the lines of a table.

use std::sync::Arc;

use nalgebra::Point3;
use vc_graph::{Aabb, Property, Seed, Stream};

use super::Furnisher;
use super::kitchen::side_behind;
use super::place::Need;
use super::space::Solid;
use crate::area::{Area, Facing};
use crate::check::shares_space;
use crate::draft::Draft;
use crate::dressing::{Place, Rule, WallAt};
use crate::item::{Item, Support};
use crate::plan::{FloorPlan, OpeningKind, PlanOpening};
use crate::reach::is_in_the_way;

/// Pieces lower than this lie flat: they may be where space is kept free for other pieces, metres.
const FLAT: f32 = 0.05;
/// The places tried for a piece.
const TRIES: usize = 24;
/// Pieces on walls no deeper than this may hang over floor that must stay free, metres.
const SHALLOW: f32 = 0.2;
/// A zone no farther than this from a piece is its own, metres.
const BESIDE: f32 = 0.01;
/// The space below a piece that things hang from, metres.
const DROP: f32 = 0.46;
/// The floor in front of a piece against a wall that stays free, metres.
const FRONT: f32 = 0.45;

/// Places the pieces of all rules of a furnished room.
pub(super) fn dress(s: &mut Furnisher<'_>, plan: &FloorPlan) {
    s.leaves = leaves(plan, s.room);
    let used = s.items.iter().filter_map(|item| in_use(s, item)).collect::<Vec<_>>();
    s.space.solids.extend(used);
    for (rule, seed) in s.rules.clone() {
        let mut rng = seed.stream();
        let stands = rule.place.is_furniture() && !matches!(rule.place, Place::Instead(_));
        if !stands || !rng.chance(rule.chance) {
            continue;
        }
        let count = rng.count(rule.things.count.0, rule.things.count.1);
        let mut first = None;
        for number in 0..count {
            let class = first.filter(|_| rule.things.alike).or_else(|| rng.pick(&rule.things.classes));
            first = class;
            let own = if rule.things.alike { seed } else { seed.nth(number as u64) };
            let placed =
                class.and_then(|class| sizes(s, class, own).find_map(|draft| put(s, plan, rule, &draft, &mut rng)));
            if placed.is_none() {
                break;
            }
        }
    }
}

/// The space over a piece that its tap takes, or before a wall cabinet that its doors do.
fn in_use(s: &Furnisher<'_>, item: &Item) -> Option<Solid> {
    /// The width and the height of a tap, and the way of a door, metres.
    const TAP: (f32, f32) = (0.12, 0.32);
    const DOOR: f32 = 0.3;
    let (low, high) = item.corners();
    match item.object.class {
        "washbasin" | "kitchen_sink" => {
            let (x, y) = item.area().centre();
            let (hx, hy) = (item.area().size().0 / 2.0, item.area().size().1 / 2.0);
            let (hx, hy) = if item.facing().is_along_x() { (hx, TAP.0 / 2.0) } else { (TAP.0 / 2.0, hy) };
            Some(Solid { area: Area::around(x, y, hx, hy), low: high.z, high: high.z + TAP.1 })
        }
        class if item.support == Support::Wall => {
            let opens = s.generators.get(class).is_some_and(|generator| generator.affords(Property::Openable));
            let area = item.facing().before(&item.area(), DOOR);
            opens.then_some(Solid { area, low: low.z, high: high.z })
        }
        _ => None,
    }
}

/// The floor under the leaves that open into a room.
fn leaves(plan: &FloorPlan, room: usize) -> Vec<Area> {
    let doors = plan.doors_of(room).filter(|door| door.opens_high == (door.high == Some(room)));
    doors.filter_map(PlanOpening::swing).map(|swing| Area::from_rect(&swing).grown(0.03)).collect()
}

/// The class that a rule puts in place of another, the same for all such pieces of the room.
pub(super) fn exchanged<'c>(rules: &[(&'c Rule, Seed)], class: &'c str) -> Option<&'c str> {
    rules.iter().find_map(|(rule, seed)| {
        let Place::Instead(classes) = &rule.place else { return None };
        if classes.iter().all(|old| **old != *class) {
            return None;
        }
        let mut rng = seed.stream();
        rng.chance(rule.chance).then(|| rng.pick(&rule.things.classes).map(|new| &**new)).flatten()
    })
}

/// An object of a class in its usual size, then in its least.
fn sizes(s: &Furnisher<'_>, class: &Arc<str>, seed: Seed) -> impl Iterator<Item = Draft> + use<> {
    let drafts = s.generators.get(class).map(|generator| {
        let least = generator.usual_ranges().map(|ranges| ranges.map(|range| range.low).into());
        let usual = generator.usual_size(seed);
        [Some(usual), least.filter(|least| *least != usual)].map(|size| Some(Draft::sized(generator, size?, seed)))
    });
    drafts.into_iter().flatten().flatten()
}

fn put(s: &mut Furnisher<'_>, plan: &FloorPlan, rule: &Rule, draft: &Draft, rng: &mut Stream) -> Option<usize> {
    match &rule.place {
        Place::Against => s.against(draft, Need::front(FRONT), |_, _| 0.0),
        Place::Corner => {
            let need = if opens(s, draft) { Need::front(FRONT) } else { Need::default() };
            s.against(draft, need, |_, spot| (0.6 - spot.corner).max(0.0))
        }
        Place::Floor => anywhere(s, draft, rng),
        Place::Before(classes) => each(s, classes).find_map(|(area, facing)| before(s, draft, &area, facing)),
        Place::BeforeEntrance => entrance(s, plan).and_then(|(area, facing)| before(s, draft, &area, facing)),
        Place::Next(classes) => each(s, classes).find_map(|(area, facing)| next(s, draft, &area, facing)),
        Place::Wall { height, at } => on_wall(s, draft, (*height, drop(rule)), at, rng),
        Place::Ceiling => on_ceiling(s, draft, rng),
        Place::CeilingBefore(classes) => each(s, classes).find_map(|(area, facing)| curtain(s, draft, &area, facing)),
        _ => None,
    }
}

/// The pieces of some classes in the room: area and facing.
fn each(s: &Furnisher<'_>, classes: &[Arc<str>]) -> impl Iterator<Item = (Area, Facing)> + use<> {
    let found = s.items.iter().filter(|item| classes.iter().any(|class| **class == *item.object.class));
    found.map(|item| (item.area(), item.facing())).collect::<Vec<_>>().into_iter()
}

/// The front door as a piece that faces into the room.
fn entrance(s: &Furnisher<'_>, plan: &FloorPlan) -> Option<(Area, Facing)> {
    let door = plan.openings.iter().find(|o| o.kind == OpeningKind::Entrance && o.touches(s.room))?;
    let high = door.high == Some(s.room);
    let facing = match (door.vertical, high) {
        (true, true) => Facing(0),
        (false, true) => Facing(1),
        (true, false) => Facing(2),
        (false, false) => Facing(3),
    };
    Some((Area::from_rect(&door.across(door.at - 1, door.at + 1)), facing))
}

/// Puts a piece on a free spot of the floor; a flat one also where people walk, but under no leaf, and another one in
/// zones of the piece it is for.
fn lay(
    s: &mut Furnisher<'_>,
    draft: &Draft,
    centre: (f32, f32),
    facing: Facing,
    for_piece: Option<&Area>,
) -> Option<usize> {
    let size = draft.size();
    let solid = Solid { area: Furnisher::around(centre, size, facing), low: 0.0, high: size.z };
    let free = match size.z < FLAT {
        true => {
            let under_leaf = s.leaves.iter().any(|way| way.overlaps(&solid.area));
            let free = !under_leaf && s.space.is_floor(&solid.area) && s.space.is_empty(&solid);
            let on_way = || s.space.ways.iter().any(|way| way.overlaps(&solid.area));
            free && (!is_in_the_way((0.0, size.z)) || (!on_way() && s.space.stays_open(&solid)))
        }
        false => {
            let own = |zone: &Area| for_piece.is_some_and(|piece| zone.distance(piece) < BESIDE);
            let shut = opens(s, draft) && !s.space.is_clear(&facing.before(&solid.area, FRONT));
            let zoned = shut || s.space.zones.iter().any(|zone| zone.overlaps(&solid.area) && !own(zone));
            !zoned && s.space.is_off_ways(&solid) && s.space.stays_open(&solid)
        }
    };
    if free && opens(s, draft) {
        s.space.zones.push(facing.before(&solid.area, FRONT));
    }
    free.then(|| s.add(draft, centre, 0.0, facing, Support::Floor))
}

/// Whether a piece has a lid or a front that opens.
fn opens(s: &Furnisher<'_>, draft: &Draft) -> bool {
    s.generators.get(draft.class()).is_some_and(|generator| generator.affords(Property::Openable))
}

fn anywhere(s: &mut Furnisher<'_>, draft: &Draft, rng: &mut Stream) -> Option<usize> {
    let rect = *rng.pick(&s.space.net)?;
    let area = Area::from_rect(&rect);
    let flat = draft.size().z < FLAT;
    // A rug lies in the middle of what is free; other things lie about.
    let share = |step: usize| if flat { step as f32 / TRIES as f32 } else { 1.0 };
    (0..TRIES).find_map(|step| {
        let ((x, y), (wide, deep)) = (area.centre(), area.size());
        let off = |length: f32, unit: f32| (unit - 0.5) * length * share(step);
        let centre = (x + off(wide, rng.unit()), y + off(deep, rng.unit()));
        let facing = Facing(rng.below(4) as u8);
        lay(s, draft, centre, facing, None)
    })
}

/// In front of an area, in its middle or to a side, near it or a little off.
fn before(s: &mut Furnisher<'_>, draft: &Draft, area: &Area, facing: Facing) -> Option<usize> {
    let (size, (dx, dy)) = (draft.size(), facing.step());
    let width = if facing.is_along_x() { area.size().1 } else { area.size().0 };
    let aside = ((width - size.y) / 2.0).max(0.0);
    for off in [0.03, 0.3, 0.7, 1.1] {
        for along in [0.0, aside * 0.6, -aside * 0.6] {
            let (cx, cy) = facing.before(area, 2.0 * off + size.x).centre();
            let centre = (cx - dy * along, cy + dx * along);
            if let Some(index) = lay(s, draft, centre, facing, Some(area)) {
                return Some(index);
            }
        }
    }
    None
}

/// Beside an area, its back in line with the area's.
fn next(s: &mut Furnisher<'_>, draft: &Draft, area: &Area, facing: Facing) -> Option<usize> {
    let (size, (dx, dy)) = (draft.size(), facing.step());
    let (x, y) = area.centre();
    let (deep, wide) = if facing.is_along_x() { area.size() } else { (area.size().1, area.size().0) };
    let back = (size.x - deep) / 2.0;
    [(0.04, 0.0), (0.04, 0.15), (0.14, 0.05), (0.14, 0.25)].into_iter().find_map(|(gap, forth)| {
        [1.0_f32, -1.0].into_iter().find_map(|side| {
            let (along, ahead) = (side * (wide / 2.0 + gap + size.y / 2.0), back + forth);
            lay(s, draft, (x + dx * ahead - dy * along, y + dy * ahead + dx * along), facing, Some(area))
        })
    })
}

/// The space below a piece that things will hang into, metres.
fn drop(rule: &Rule) -> f32 {
    let hangs = |below: &Rule| matches!(below.place, Place::Hang(_));
    if rule.then.iter().any(hangs) { DROP } else { 0.0 }
}

/// A height on a wall, and the free space below it, metres.
type Height = (f32, f32);

fn on_wall(s: &mut Furnisher<'_>, draft: &Draft, z: Height, at: &WallAt, rng: &mut Stream) -> Option<usize> {
    match at {
        WallAt::Anywhere => (0..TRIES).find_map(|_| {
            let side = rng.below(s.space.sides.len().max(1));
            let wall = s.space.sides.get(side)?;
            let along = rng.between(wall.from, wall.to);
            hang(s, draft, (side, along), z, None)
        }),
        WallAt::Over(classes) => each(s, classes).find_map(|(area, facing)| {
            let side = side_behind(s, &area, facing)?;
            let (x, y) = area.centre();
            let middle = if facing.is_along_x() { y } else { x };
            [0.0, 0.25, -0.25, 0.5, -0.5].into_iter().find_map(|off| hang(s, draft, (side, middle + off), z, None))
        }),
        WallAt::Near(classes) => each(s, classes).find_map(|(area, _)| near(s, draft, z, &area, None)),
        WallAt::Within(classes) => {
            let named = |item: &Item| classes.iter().any(|class| **class == *item.object.class);
            let pieces: Vec<usize> = (0..s.items.len()).filter(|&at| named(&s.items[at])).collect();
            pieces.into_iter().find_map(|at| {
                let area = s.items[at].area();
                // Its fittings are known when it is made.
                s.real(s.base + at);
                near(s, draft, z, &area, Some((area, at)))
            })
        }
    }
}

/// The box of an open piece, and which of the items it is.
type Open = (Area, usize);

/// On a wall, if the place and what is below it are free; within the box of a piece if that is open.
fn hang(
    s: &mut Furnisher<'_>,
    draft: &Draft,
    (side, along): (usize, f32),
    (z, drop): Height,
    open: Option<Open>,
) -> Option<usize> {
    let (wall, size) = (&s.space.sides[side], draft.size());
    let area = wall.facing.area(wall.point(along, 0.001), size.x, size.y);
    let below = Solid { area, low: z - drop, high: z };
    let around = open.map(|(area, _)| area);
    let place = Aabb { min: Point3::new(area.x0, area.y0, z), max: Point3::new(area.x1, area.y1, z + size.z) };
    if s.space.solids.iter().any(|solid| solid.hits(&below) && around != Some(solid.area))
        || open.is_some_and(|(_, at)| shares_space(&place, &s.items[at]))
    {
        return None;
    }
    s.hang_within(draft, side, (along, z), (SHALLOW, around))
}

/// At the free place of a wall nearest to an area; within the box of the piece there if it is open.
fn near(s: &mut Furnisher<'_>, draft: &Draft, z: Height, area: &Area, open: Option<Open>) -> Option<usize> {
    /// The distance between places, and the farthest one, metres.
    const STEP: f32 = 0.1;
    const FAR: f32 = 1.4;
    let mut places = Vec::new();
    for (index, side) in s.space.sides.iter().enumerate() {
        let steps = (side.length() / STEP) as usize;
        let all = (0..=steps).map(|step| side.from + STEP * step as f32);
        places.extend(all.map(|along| {
            let (x, y) = side.point(along, 0.0);
            (area.distance(&Area::around(x, y, 0.0, 0.0)), index, along)
        }));
    }
    places.retain(|place| place.0 < if open.is_some() { STEP } else { FAR });
    places.sort_by(|a, b| a.0.total_cmp(&b.0));
    places.into_iter().find_map(|(_, side, along)| hang(s, draft, (side, along), z, open))
}

fn on_ceiling(s: &mut Furnisher<'_>, draft: &Draft, rng: &mut Stream) -> Option<usize> {
    let (rect, size) = (*rng.pick(&s.space.net)?, draft.size());
    let area = Area::from_rect(&rect);
    let high = s.space.ceiling;
    (0..TRIES).find_map(|_| {
        let centre = (rng.between(area.x0, area.x1), rng.between(area.y0, area.y1));
        let solid = Solid { area: Furnisher::around(centre, size, Facing(0)), low: high - size.z, high };
        let free = s.space.is_floor(&solid.area) && s.space.is_empty(&solid);
        free.then(|| s.add(draft, centre, high - size.z - 0.001, Facing(0), Support::Ceiling))
    })
}

/// From the ceiling down to the front edge of a piece, as wide as it.
fn curtain(s: &mut Furnisher<'_>, draft: &Draft, area: &Area, facing: Facing) -> Option<usize> {
    let top = s.items.iter().find(|item| item.area() == *area).map(|item| item.corners().1.z)?;
    let generator = s.generators.get(draft.class())?;
    let (high, low) = (s.space.ceiling - 0.001, top + 0.015);
    let (width, (dx, dy)) = (if facing.is_along_x() { area.size().1 } else { area.size().0 }, facing.step());
    let depth = draft.size().x;
    let fitted = Draft::sized(generator, [depth, width - 0.02, high - low].into(), s.seed.child("curtain"));
    let (cx, cy) = facing.before(area, 0.0).centre();
    let inset = depth / 2.0 + 0.01;
    let centre = (cx - dx * inset, cy - dy * inset);
    let solid = Solid { area: Furnisher::around(centre, fitted.size(), facing), low, high };
    s.space.is_empty(&solid).then(|| s.add(&fitted, centre, low, facing, Support::Ceiling))
}
