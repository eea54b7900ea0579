//! Conversion of an apartment to a scene graph.

use std::collections::HashMap;
use std::sync::Arc;

use nalgebra::Vector3;
use vc_graph::asset::Hold;
use vc_graph::space::NumberBlock;
use vc_graph::{
    AssetId, Bounds, BoundsFrame, ClassTable, Draft, Edge, EditError, NodeId, ObjectRole, Pose, Property, Relation,
    SceneBuilder, SceneGraph, State,
};
use vc_shapes::object::Object;

use crate::apartment::Apartment;
use crate::item::{Item, Support};
use crate::plan::{Rect, metres};

impl Apartment {
    /// The apartment as a scene graph: rooms first, then the items in their order, with poses,
    /// bounding boxes, assets, states, and the relations in room, on, inside and between. A reference that
    /// [`check`](Self::check) finds broken gives no relation.
    ///
    /// Costs some hundred microseconds.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Apartment;
    /// let home = Apartment::from_seed(Seed(7))?;
    /// let scene = home.scene();
    /// assert!(scene.validate().is_empty());
    /// assert_eq!(scene.rooms().len(), home.plan.rooms.len());
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn scene(&self) -> SceneGraph {
        self.scene_with_classes(ClassTable::builtin())
    }

    /// As [`scene`](Self::scene), with the class table of a program's own classes.
    pub fn scene_with_classes(&self, classes: Arc<ClassTable>) -> SceneGraph {
        self.contents(0).scene(SceneBuilder::with_classes(self.scene_name(), classes))
    }

    /// As [`scene`](Self::scene), with the numbers of a region's block: whatever has number `n` there has the `n`th of
    /// the block, counted from 0.
    ///
    /// ```
    /// use vc_graph::space::NumberBlock;
    /// use vc_graph::{NodeId, Seed};
    /// use vc_procgen::Apartment;
    /// let home = Apartment::from_seed(Seed(7))?;
    /// let scene = home.scene_numbered(NumberBlock { first: 5000, count: 4096 });
    /// assert_eq!(scene.label(NodeId(5000)).class, home.scene().label(NodeId(0)).class);
    /// # Ok::<(), vc_procgen::SpecificationError>(())
    /// ```
    pub fn scene_numbered(&self, numbers: NumberBlock) -> SceneGraph {
        let mut builder = SceneBuilder::new(self.scene_name());
        builder.numbers(numbers);
        self.contents(numbers.first).scene(builder)
    }

    fn scene_name(&self) -> String {
        format!("apartment_{}", self.seed.0)
    }

    fn contents(&self, first: u32) -> Contents<'_> {
        let rooms = self.plan.rooms.iter().map(|room| self.room(room.kind.class(), &room.hull())).collect();
        Contents { first, rooms, items: &self.items, names: &[] }
    }

    fn room(&self, class: &'static str, hull: &Rect) -> Draft {
        let inner = hull.grown(-1);
        let centre = Vector3::new(metres(inner.x0 + inner.x1) / 2.0, metres(inner.y0 + inner.y1) / 2.0, 0.0);
        let size = Vector3::new(metres(inner.width()), metres(inner.depth()), self.plan.ceiling);
        room_draft(class, centre, size)
    }
}

/// A room of a size around the centre of its floor.
pub(crate) fn room_draft(class: &'static str, centre: Vector3<f32>, size: Vector3<f32>) -> Draft {
    Draft::new(class)
        .at(Pose::from_parts(centre.into(), nalgebra::UnitQuaternion::identity()))
        .bounds(Bounds { frame: BoundsFrame::World, ..Bounds::standing(size) })
}

/// Rooms and items that become a scene with consecutive numbers, the rooms first.
pub(crate) struct Contents<'a> {
    /// The number of the first room.
    pub(crate) first: u32,
    pub(crate) rooms: Vec<Draft>,
    pub(crate) items: &'a [Item],
    /// The names of some items, by their index.
    pub(crate) names: &'a [(usize, Arc<str>)],
}

impl Contents<'_> {
    pub(crate) fn scene(self, mut builder: SceneBuilder) -> SceneGraph {
        // New identifiers, existing endpoints and supports without cycles leave no reason for an error.
        let _ = self.fill(&mut builder);
        builder.build()
    }

    fn room_id(&self, room: usize) -> NodeId {
        NodeId(self.first + room as u32)
    }

    fn item_id(&self, item: usize) -> NodeId {
        NodeId(self.first + (self.rooms.len() + item) as u32)
    }

    fn fill(&self, builder: &mut SceneBuilder) -> Result<(), EditError> {
        let mut library = vc_shapes::material::library();
        let mut known: HashMap<*const Object, AssetId> = HashMap::new();
        let mut assets = Vec::with_capacity(self.items.len());
        for item in self.items {
            let share = || library.share(Arc::new(item.object.asset.clone())).unwrap_or(AssetId(0));
            assets.push(*known.entry(Arc::as_ptr(&item.object)).or_insert_with(share));
        }
        builder.assets(Arc::new(library));
        for (index, room) in self.rooms.iter().enumerate() {
            builder.add_with_id(self.room_id(index), room.clone())?;
        }
        for (index, (item, asset)) in self.items.iter().zip(assets).enumerate() {
            let name = self.names.iter().find(|(named, _)| *named == index).map(|(_, name)| name.clone());
            let draft = draft(item, asset, builder.graph().classes());
            builder.add_with_id(self.item_id(index), Draft { name, ..draft })?;
        }
        builder.link_all(&self.edges())
    }

    fn edges(&self) -> Vec<Edge> {
        let mut floors = vec![None; self.rooms.len()];
        for (index, item) in self.items.iter().enumerate().filter(|(_, i)| i.object.role == ObjectRole::Floor) {
            floors.get_mut(item.room).into_iter().for_each(|floor| *floor = Some(self.item_id(index)));
        }
        let mut edges = Vec::with_capacity(2 * self.items.len());
        for (index, item) in self.items.iter().enumerate() {
            let (id, is_room) = (self.item_id(index), |room: &usize| *room < floors.len());
            let below = |at: usize| (at < index).then(|| self.item_id(at));
            let room = Some(item.room).filter(is_room).map(|room| (Relation::InRoom, self.room_id(room)));
            let support = match item.support {
                Support::Floor => floors.get(item.room).copied().flatten().map(|floor| (Relation::On, floor)),
                Support::On(at, _) => below(at).map(|at| (Relation::On, at)),
                Support::Inside(at, _) => below(at).map(|at| (Relation::Inside, at)),
                Support::Wall | Support::Ceiling | Support::Built => None,
            };
            edges.extend(room.into_iter().chain(support).map(|(relation, to)| Edge::new(id, relation, to)));
            if item.object.role == ObjectRole::Door {
                let rooms = std::iter::once(item.room).chain(item.between).filter(is_room);
                edges.extend(rooms.map(|room| Edge::new(id, Relation::Between, self.room_id(room))));
            }
        }
        edges
    }
}

fn draft(item: &Item, asset: AssetId, classes: &ClassTable) -> Draft {
    let mut draft = Draft::new(item.object.class).at(item.pose).bounds(item.object.bounds);
    draft.asset = Some(asset);
    // Storage with doors or a lid starts closed, because an open one would collide with objects above it.
    let opens = classes.get(item.object.class).is_some_and(|class| class.affordances.contains(Property::Openable));
    let doors = item.object.asset.parts.iter().any(|p| p.joint.is_some());
    let holds = item.object.asset.surfaces.iter().any(|s| s.hold == Hold::Inside);
    let state = (opens && holds && doors).then_some(State::Closed);
    draft.entering.extend(state.into_iter().chain(item.states.iter().copied()));
    draft
}
