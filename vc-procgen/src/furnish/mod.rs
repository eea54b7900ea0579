//! Furnishing: the furniture and fixtures of the rooms.
//!
//! Each room is a function of its own seed. Pieces are placed against walls or around others, the
//! required ones first; every placement is checked against the floor, the solids and the zones that
//! must stay free, so that nothing ever overlaps. A piece that does not fit is left out if it is
//! optional; otherwise smaller sizes are tried, and if none fits the plan is given up.

mod bathroom;
mod bedroom;
mod dress;
mod fitted;
mod fixtures;
mod kitchen;
mod kitchen_plan;
mod kitchen_walls;
mod living;
mod other;
mod own;
mod place;
mod space;
mod walk;

use std::ops::ControlFlow;
use std::sync::Arc;

use vc_graph::{Seed, Stream};
use vc_shapes::{Generators, Object, Style};

use crate::area::{Area, Facing};
use crate::draft::Draft;
use crate::dressing::{Household, Rule};
use crate::error::SpecificationError;
use crate::item::{Item, Support, standing};
use crate::plan::{FloorPlan, OpeningKind, RoomKind};
use space::{Solid, Space};

/// The number of attempts to furnish a room before the plan is given up.
const DEALS: u64 = 5;

impl Item {
    /// Replaces the item's box by the generated object. An object smaller than its box keeps its
    /// back, and its top if it hangs from the ceiling, where the box has them.
    fn become_real(&mut self, draft: &Draft, style: &Style) {
        let object = draft.object(style);
        let spare = draft.size() - object.size();
        let hangs = self.support == Support::Ceiling;
        let (facing, (x, y)) = (self.facing(), self.area().centre());
        let back = if hangs { 0.0 } else { spare.x / 2.0 };
        let up = if hangs { spare.z } else { 0.0 };
        let (dx, dy) = facing.step();
        let z = self.corners().0.z + up;
        self.pose = standing(&object, (x - dx * back, y - dy * back), z, facing.yaw());
        self.object = object;
    }

    fn solid(&self) -> Solid {
        let (low, high) = self.corners();
        Solid { area: self.area(), low: low.z, high: high.z }
    }
}

/// The furniture of a whole plan, room by room, as boxes, with the draft of each piece; also what a household's table of
/// dressing has on floors and walls.
///
/// # Errors
/// [`SpecificationError::NoPlace`] with the room and the piece that does not fit.
pub(crate) fn furnish(
    plan: &FloorPlan,
    made_by: (&Style, &Generators),
    (household, fitted_kitchens): (Option<&Household>, bool),
    seed: Seed,
) -> Result<(Vec<Item>, Vec<Draft>), SpecificationError> {
    let open_kitchen = plan.openings.iter().any(|o| {
        o.kind == OpeningKind::Passage
            && [o.low, o.high].into_iter().flatten().any(|r| plan.rooms[r].kind == RoomKind::Kitchen)
    });
    let mut order: Vec<usize> = (0..plan.rooms.len()).collect();
    // Rooms that most often cannot accommodate their required pieces come first, so that failures
    // occur early.
    order.sort_by_key(|&r| strictness(plan.rooms[r].kind));
    let (mut items, mut drafts) = (Vec::new(), Vec::new());
    let mut furnished = Vec::new();
    for index in order {
        let space = Space::new(plan, index);
        let own = seed.child("furnish").nth(index as u64);
        let dealt = (0..DEALS).try_fold(None, |_, deal| {
            let mut furnisher = Furnisher::new(index, made_by, own.nth(deal), space.clone(), items.len());
            furnisher.fitted_kitchens = fitted_kitchens;
            furnisher.rules = household.map_or_else(Vec::new, |h| h.rules(index, plan.rooms[index].kind).collect());
            match furnish_room(&mut furnisher, plan, open_kitchen) {
                Ok(()) => ControlFlow::Break(furnisher),
                Err(error) => ControlFlow::Continue(Some(error)),
            }
        });
        match dealt {
            ControlFlow::Break(mut furnisher) if household.is_none() => {
                items.append(&mut furnisher.items);
                drafts.append(&mut furnisher.drafts);
            }
            // Rooms are dressed when all are furnished, because furnishing fails often.
            ControlFlow::Break(furnisher) => {
                items.extend(furnisher.items.iter().cloned());
                drafts.extend(furnisher.drafts.iter().cloned());
                furnished.push(furnisher);
            }
            ControlFlow::Continue(error) => return Err(error.unwrap_or_else(|| unwalkable(plan, index))),
        }
    }
    for mut furnisher in furnished {
        let before = furnisher.items.len();
        dress::dress(&mut furnisher, plan);
        items.extend(furnisher.items.drain(before..));
        drafts.extend(furnisher.drafts.drain(before..));
    }
    Ok((items, drafts))
}

/// Generates the objects that the boxes stand for.
pub(crate) fn make(items: &mut [Item], drafts: &[Draft], style: &Style) {
    items.iter_mut().zip(drafts).for_each(|(item, draft)| item.become_real(draft, style));
}

/// The order of furnishing: small values come first.
fn strictness(kind: RoomKind) -> u8 {
    match kind {
        RoomKind::Bathroom | RoomKind::Wc => 0,
        RoomKind::Bedroom | RoomKind::Kids => 1,
        RoomKind::Kitchen | RoomKind::Living => 2,
        _ => 3,
    }
}

fn unwalkable(plan: &FloorPlan, room: usize) -> SpecificationError {
    SpecificationError::NoPlace { kind: plan.rooms[room].kind, room, piece: "way to walk" }
}

fn furnish_room(s: &mut Furnisher<'_>, plan: &FloorPlan, open_kitchen: bool) -> Result<(), SpecificationError> {
    if !s.space.walk.stays_open(&[]) {
        return Err(unwalkable(plan, s.room));
    }
    match s.kind() {
        RoomKind::Bedroom | RoomKind::Kids => bedroom::furnish(s),
        RoomKind::Living if plan.scheme == crate::plan::Scheme::Studio => living::furnish_studio(s),
        RoomKind::Living => living::furnish(s, open_kitchen),
        RoomKind::Kitchen => kitchen::furnish(s),
        RoomKind::Bathroom | RoomKind::Wc => bathroom::furnish(s),
        _ => other::furnish(s),
    }?;
    fixtures::fix(s, plan);
    own::furnish(s);
    Ok(())
}

/// Places objects in one room.
struct Furnisher<'a> {
    room: usize,
    style: &'a Style,
    generators: &'a Generators,
    seed: Seed,
    rng: Stream,
    space: Space,
    /// The number of items in the rooms before.
    base: usize,
    /// The placed items, as boxes: objects are generated once all rooms are furnished.
    items: Vec<Item>,
    /// The draft of each item.
    drafts: Vec<Draft>,
    /// The number of drafts made so far: each has a sub-seed of its own.
    made: u64,
    /// The rules of dressing of this room, each with its seed.
    rules: Vec<(&'a Rule, Seed)>,
    fitted_kitchens: bool,
    /// The floor under door leaves, for what lies flat.
    leaves: Vec<Area>,
}

impl<'a> Furnisher<'a> {
    fn new(
        room: usize,
        (style, generators): (&'a Style, &'a Generators),
        seed: Seed,
        space: Space,
        base: usize,
    ) -> Self {
        let (rng, items, drafts) = (seed.stream(), Vec::new(), Vec::new());
        Self {
            room,
            style,
            generators,
            seed,
            rng,
            space,
            base,
            items,
            drafts,
            made: 0,
            rules: Vec::new(),
            fitted_kitchens: false,
            leaves: Vec::new(),
        }
    }
}

impl Furnisher<'_> {
    fn kind(&self) -> RoomKind {
        self.space.kind
    }

    /// Drafts an object of a class, no larger than `size`; `None` if the class has no generator.
    fn make(&mut self, class: &str, size: [f32; 3]) -> Option<Draft> {
        self.made += 1;
        let seed = self.seed.child("object").nth(self.made);
        let Some(other) = dress::exchanged(&self.rules, class) else {
            return Some(Draft::sized(self.generators.get(class)?, size.into(), seed));
        };
        // A piece of another class has that one's height.
        let generator = self.generators.get(other)?;
        let [deep, wide, high] = size;
        let high = generator.usual_ranges().map_or(high, |[.., usual]| high.clamp(usual.low, usual.high));
        Some(Draft::sized(generator, [deep, wide, high].into(), seed))
    }

    /// An error that names the missing piece.
    fn missing(&self, piece: &'static str) -> SpecificationError {
        SpecificationError::NoPlace { kind: self.space.kind, room: self.room, piece }
    }

    /// Adds an item whose footprint is centred on a point, its base at `z`; returns its index in
    /// the list of all items.
    fn add(&mut self, draft: &Draft, centre: (f32, f32), z: f32, facing: Facing, support: Support) -> usize {
        let object = Arc::new(draft.outline());
        let pose = standing(&object, centre, z, facing.yaw());
        let item = Item { object, pose, support, room: self.room, states: Vec::new(), between: None, required: false };
        let solid = item.solid();
        self.space.walk.put(&solid.area, (solid.low, solid.high), support != Support::Ceiling);
        self.space.solids.push(solid);
        self.items.push(item);
        self.drafts.push(draft.clone());
        self.base + self.items.len() - 1
    }

    /// Generates the object of an item at once, because another is to be placed on it.
    fn real(&mut self, index: usize) -> Arc<Object> {
        let at = index - self.base;
        let item = &mut self.items[at];
        item.become_real(&self.drafts[at], self.style);
        self.drafts[at] = Draft::from_object(item.object.clone());
        item.object.clone()
    }

    fn item(&mut self, index: usize) -> &mut Item {
        let base = self.base;
        &mut self.items[index - base]
    }
}
