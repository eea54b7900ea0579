//! Spatial relations read from geometry: on, in, under and near; the room of a thing; the rooms that a door
//! connects; and where agents sit, lie and look.
//!
//! The input is a [`SceneGraph`](vc_graph::SceneGraph) whose nodes have poses and shapes: assets, or boxes
//! only. The output is the relations of `vc-graph`, with figures (gaps, distances, sides, shares). It does not
//! matter whether physics or an edit moved the things. More exact knowledge of a physics engine can be passed
//! as plain data ([`Evidence`]).
//!
//! ```
//! use vc_graph::{Bounds, Draft, Edge, Pose, Relation, SceneBuilder};
//! use vc_relations::{Evidence, Relations, RelationRule};
//!
//! let size = |x, y, z| Bounds::standing(nalgebra::Vector3::new(x, y, z));
//! let mut scene = SceneBuilder::new("kitchen");
//! let fridge = scene.add(Draft::new("fridge").bounds(size(0.6, 0.6, 1.8)).at(Pose::identity()))?;
//! let milk = Draft::new("milk").bounds(size(0.08, 0.08, 0.2)).at(Pose::translation(0.1, 0.0, 0.9));
//! let milk = scene.add(milk)?;
//! let graph = scene.build();
//!
//! let relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default())?;
//! assert_eq!(relations.between(milk, fridge), [Relation::Inside, Relation::Touching, Relation::Near]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The rule
//!
//! [`RelationRule::BoxTrace`] is the thesis's rule to the letter: six swept boxes for each object; it is on the object
//! that the trace down hits, inside it if the traces up and down hit the same object, otherwise under the
//! object that the trace up hits. This rule fails for containers (their content overlaps their box), for things
//! that overlap by a millimetre, and for stacks. [`RelationRule::VirtualHome`] uses VirtualHome's definitions on
//! world-aligned boxes. [`RelationRule::Contacts`], the default, keeps the idea of traces:
//!
//! | relation | holds if |
//! |---|---|
//! | on | a joint attaches it; else contacts push it up, each with at least a tenth of the total impulse; else the trace down from one of its parts hits the other at most [`SUPPORT_GAP`](threshold::SUPPORT_GAP) below, not steeper than 60 degrees, and at most [`SUPPORT_TIE`](threshold::SUPPORT_TIE) deeper than the nearest hit; else it hangs: on a hook, a wall, a ceiling, or something it touches |
//! | inside | its centre and four of its eight corners are in a hollow of the other: a space that the asset declares, from [`COMPARTMENT_SINK`](threshold::COMPARTMENT_SINK) below its floor upwards, or one that its parts leave free with a floor and four walls, or three walls and a roof, or a roof and two walls from one side through to the other (a bookcase without a back); a rim of three centimetres is a wall. It is then not also on the other. In a graph a thing leaves what it was inside of once its centre is more than [`OUTSIDE_GAP`](threshold::OUTSIDE_GAP) beyond the other's box |
//! | under | the other is the first thing above the centre of its box that does not rest on it or in it; not the building, nor its own container or support |
//! | sitting, lying on | an agent sits (by its state, or because its box has a seat at hip height) or lies on a thing that affords it. It is then not on anything |
//! | near, near at a side | the boxes are at most [`NEAR_REACH`](threshold::NEAR_REACH) apart, and they are in one room or no part of the building is between their centres. The side is determined along the thing's own axes; there is none above and below |
//! | touching | parts are at most [`TOUCH_GAP`](threshold::TOUCH_GAP) apart |
//! | facing | a lookable thing is within 75 degrees of the front of an agent or a seat, within 5 m, and no wall is in between |
//! | in room | its centre (for an agent the point above its feet) is above the room's floors, or, if there are none, in the room's shape or its box; in a doorway, the nearest room |
//! | between | these rooms are on the two sides of a door: across its thickness, or, if its box does not tell (around a leaf that stands open), along the axis that leads from room to room. A door frame has them beside its leaf; an outer door has one room |
//! | held, worn | the graph or the evidence says so; it then rests on nothing |
//!
//! A trace starts at a part's middle plane and is a little narrower than the part, so that a few millimetres of
//! overlap or gap do not matter, neither below nor at the sides. The thresholds of the rules are in [`threshold`],
//! with their units and reasons. At most one of on, inside, sitting and lying holds between two nodes; a thing is inside all
//! containers around it; and nothing rests on itself through others.
//!
//! # Main types
//!
//! | type | purpose |
//! |---|---|
//! | [`Relations`] | the relations of a scene: [`edges`](Relations::edges), [`edges_of`](Relations::edges_of), [`has`](Relations::has); [`update`](Relations::update) after moves |
//! | [`Evidence`], [`NodeEvidence`] | contacts, joints, positions of drawers and doors, held things; what has changed about one node |
//! | [`Support`], [`Near`], [`NearSide`] | the figures behind on and near |
//! | [`Proximity`] | named degrees of nearness: touching distance, arm's reach, near, behind a wall, far |
//! | [`Explanation`] | why a relation holds or does not: which trace hit which thing, and where; depth in rooms, angle off the front, distances from seat and hook |
//! | [`RelationRule`] | the rule that decides |
//!
//! # Cost and upkeep
//!
//! All facts about two things are measured for that pair alone, and relations are derived from these facts.
//! After a move, therefore, only the pairs of the moved thing are measured again, and the result is that of a
//! full rebuild, to the last bit. The pairs of a scene are found by sorting boxes and sweeping over them, those
//! of a moved thing in a tree; eight boxes are compared at a time. Traces are sweeps of boxes by separating
//! axes, exact for boxes. Pieces and hollows are computed once for each asset and shared by all its instances.
//! Everything runs on one thread; results do not depend on any ordering, and are bit-identical on every
//! machine. `benches/README.md` has figures: about two microseconds an object for all relations, about ten for
//! a move.
//!
//! # Input
//!
//! Poses, boxes, scales and evidence with numbers that are not finite, coordinates and sizes beyond
//! [`WORLD_REACH`](threshold::WORLD_REACH), negative sizes, and invalid rotations are rejected: [`InputError`]
//! lists every one, with its node, and nothing is changed. A node without a pose or without a shape has no
//! relations.
//!
//! # Approximations
//!
//! Shapes are traced as boxes, cylinders and ellipsoids: a hull as its box, a cone as its cylinder, a lathe
//! shape as discs and rings of sixteen boxes, an extruded outline as at most six slices (exact for right angles,
//! and so are rooms above such floors), a mesh as 8 by 8 columns. A scaled part that is turned against its
//! asset's axes keeps its right angles. If only the box of a thing is known, things on it may be in the upper
//! half of that box.

#![warn(clippy::disallowed_methods)]

mod body;
mod box_trace;
mod carve;
mod containment;
mod distance;
mod edges;
mod error;
mod evidence;
mod explain;
mod explanation;
mod facts;
mod form;
mod hollow;
mod near;
mod pair;
mod proximity;
mod relations;
mod room;
mod rule;
mod sight;
mod solid;
mod support;
mod targets;
pub mod threshold;
mod update;
mod virtual_home;
mod walls;
mod world;
mod write;

pub use box_trace::BoxTrace;
pub use error::{InputError, InputFlaw, check_sizes};
pub use evidence::{Attachment, ContactEvidence, Evidence, NodeEvidence};
pub use explanation::{BoxTraceHit, Containment, Explanation, Hit, Hook, Seat, Sight, TraceOutcome};
pub use near::NearSide;
pub use proximity::Proximity;
pub use relations::{Near, Relations, relations};
pub use rule::RelationRule;
pub use support::{Support, SupportKind};
