//! The sites where an object of a class could be in a scene.

use vc_graph::asset::Hold;
use vc_graph::class::Class;
use vc_graph::{AssetLibrary, ClassTable, Node, NodeId, ObjectRole, Property, Relation, SceneGraph};

use crate::library::PlacementSpec;

/// One surface, hook, interior or floor of the scene.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Site {
    /// `On`, `Inside` or `InRoom`.
    pub(super) relation: Relation,
    /// The support or container; the room itself where it has no floor.
    pub(super) at: NodeId,
    /// The index of the surface in its asset; `None` for a plain box without surfaces.
    pub(super) surface: Option<usize>,
    /// The sampling weight.
    pub(super) weight: f32,
}

/// Substitutes for a class of support or container: the habits name finer classes than those found
/// in homes.
const STAND_INS: &[(&str, &[(&str, Relation)])] = &[
    ("bathroom_counter", &[("bathroom_vanity", Relation::On)]),
    ("bookshelf", &[("shelf", Relation::On)]),
    ("closet", &[("wardrobe", Relation::Inside), ("wardrobe", Relation::On)]),
    ("closet_drawer", &[("dresser", Relation::Inside)]),
    ("dining_table", &[("kitchen_table", Relation::On)]),
    ("garage_shelf", &[("storage_shelf", Relation::Inside)]),
    ("hall_stand", &[("wall_hook_rack", Relation::On), ("coat_rack", Relation::On)]),
    ("kids_bed", &[("single_bed", Relation::On)]),
    ("kitchen_counter", &[("kitchen_cabinet", Relation::On), ("kitchen_island", Relation::On)]),
    ("kitchen_drawer", &[("kitchen_cabinet", Relation::Inside)]),
    ("kitchen_table", &[("dining_table", Relation::On)]),
    ("linen_cabinet", &[("wardrobe", Relation::Inside), ("dresser", Relation::Inside)]),
    ("pantry_cabinet", &[("kitchen_cabinet", Relation::Inside)]),
    ("shoe_rack", &[("shoe_cabinet", Relation::Inside)]),
    ("storage_shelf", &[("storage_shelf", Relation::Inside)]),
    ("towel_cabinet", &[("bathroom_cabinet", Relation::Inside)]),
    ("utility_cabinet", &[("storage_shelf", Relation::Inside)]),
    ("wardrobe", &[("wardrobe", Relation::On)]),
    ("workbench", &[("desk", Relation::On), ("storage_shelf", Relation::Inside)]),
];

/// Substitutes for rooms that a home does not have.
const SIMILAR: &[(&str, &str)] = &[
    ("dining_room", "living_room"),
    ("game_room", "living_room"),
    ("kitchen_living", "living_room"),
    ("garage", "storage_room"),
    ("laundry_room", "bathroom"),
    ("storage_room", "hallway"),
    ("home_office", "bedroom"),
    ("garden", "balcony"),
];

/// The scene as a set of sites.
pub(super) struct Places<'a> {
    pub(super) graph: &'a SceneGraph,
    pub(super) assets: &'a AssetLibrary,
}

impl Places<'_> {
    /// The sites for a class: the given spots, or the habitual places of the class, or, if the
    /// scene has none of those, any table (for graspable objects) or floor.
    pub(super) fn sites(&self, class: &Class, spots: &[PlacementSpec]) -> Vec<Site> {
        let mut sites = Vec::new();
        if spots.is_empty() {
            for (spot, weight) in kept(self.graph.classes(), class) {
                self.expand(class, &spot, weight, true, &mut sites);
            }
            if sites.is_empty() {
                self.expand(class, &anywhere(class), 1.0, false, &mut sites);
            }
        } else {
            spots.iter().for_each(|spot| self.expand(class, spot, 1.0, false, &mut sites));
        }
        sites
    }

    fn expand(&self, class: &Class, spot: &PlacementSpec, weight: f32, loosely: bool, sites: &mut Vec<Site>) {
        let mut found = Vec::new();
        match &spot.at {
            None => {
                let rooms = self.graph.rooms().iter().filter(|&&room| self.in_room(room, spot, loosely));
                rooms.for_each(|&room| self.floor(room, &mut found));
            }
            Some((relation, at)) => {
                // A room may be written like a container: `in kitchen`.
                let rooms = self.graph.of_class(at).into_iter().filter(|id| self.graph.rooms().contains(id));
                rooms.for_each(|room| self.floor(room, &mut found));
                self.carriers(class, *relation, at, spot, loosely, &mut found);
                let stand_ins = STAND_INS.iter().filter(|(name, _)| name == at).flat_map(|(_, other)| *other);
                stand_ins
                    .for_each(|(other, relation)| self.carriers(class, *relation, other, spot, loosely, &mut found));
            }
        }
        let mut once: Vec<Site> = Vec::new();
        found.into_iter().for_each(|site| {
            if !once.contains(&site) {
                once.push(site);
            }
        });
        let share = weight / once.len().max(1) as f32;
        sites.extend(once.into_iter().map(|site| Site { weight: share, ..site }));
    }

    /// Whether a spot may be in a room. Habits are read loosely: other rooms serve where the home
    /// has none of the class.
    fn in_room(&self, room: NodeId, spot: &PlacementSpec, loosely: bool) -> bool {
        let Some(wanted) = &spot.room else { return true };
        let is = |room: NodeId, class: &str| {
            self.graph.node(room).is_some_and(|n| self.graph.classes().is_a(n.class(), class))
        };
        let similar = SIMILAR.iter().filter(|(name, _)| name == wanted).any(|(_, other)| is(room, other));
        let none = || !self.graph.rooms().iter().any(|&r| is(r, wanted));
        is(room, wanted) || (loosely && similar && none())
    }

    fn floor(&self, room: NodeId, sites: &mut Vec<Site>) {
        let floors = self.graph.in_room(room).filter_map(|id| self.graph.node(id));
        let floors: Vec<&Node> = floors.filter(|n| n.role() == ObjectRole::Floor).collect();
        if floors.is_empty() {
            sites.push(Site { relation: Relation::InRoom, at: room, surface: None, weight: 1.0 });
        }
        floors.into_iter().for_each(|floor| self.surfaces(floor, Relation::On, false, sites));
    }

    fn carriers(
        &self,
        class: &Class,
        relation: Relation,
        at: &str,
        spot: &PlacementSpec,
        loosely: bool,
        sites: &mut Vec<Site>,
    ) {
        let hangs = class.affordances.contains(Property::Hangable);
        let in_room = |id: NodeId| self.graph.room_of(id).is_some_and(|r| r != id && self.in_room(r, spot, loosely));
        let carriers = self.graph.of_class(at).into_iter().filter(|&id| in_room(id));
        for node in carriers.filter_map(|id| self.graph.node(id)) {
            self.surfaces(node, relation, hangs, sites);
        }
    }

    fn surfaces(&self, node: &Node, relation: Relation, hangs: bool, sites: &mut Vec<Site>) {
        let site = |surface| Site { relation, at: node.id(), surface, weight: 1.0 };
        let Some(asset) = node.spec().asset.and_then(|id| self.assets.get(id)) else {
            let takes = match relation {
                Relation::Inside => node.encloses(self.graph.classes()),
                _ => node.role() == ObjectRole::Floor || node.carries(),
            };
            return sites.extend(takes.then(|| site(None)));
        };
        for (index, surface) in asset.surfaces.iter().enumerate() {
            let serves = match (surface.hold, relation) {
                (Hold::On, Relation::On) | (Hold::Inside, Relation::Inside) => true,
                (Hold::Hook, Relation::On) => hangs,
                _ => false,
            };
            if serves {
                sites.push(site(Some(index)));
            }
        }
    }
}

/// The habitual places of a class, or of its parent classes, with weights.
fn kept(classes: &ClassTable, class: &Class) -> Vec<(PlacementSpec, f32)> {
    let own = class.kept.iter().map(|k| {
        let at = k.at.as_ref().map(|(relation, class)| (*relation, class.to_string()));
        (PlacementSpec { at, room: k.room.as_ref().map(ToString::to_string) }, k.weight as f32)
    });
    let own: Vec<_> = own.collect();
    if !own.is_empty() {
        return own;
    }
    class.parents.iter().filter_map(|parent| classes.get(parent)).flat_map(|parent| kept(classes, parent)).collect()
}

fn anywhere(class: &Class) -> PlacementSpec {
    let table = class.affordances.contains(Property::Graspable).then(|| (Relation::On, "table".to_owned()));
    PlacementSpec { at: table, room: None }
}
