//! Relations read from geometry: what is on, in, under and near what, which room a thing is
//! in, what a door is between, who sits, lies and looks where.
//!
//! In goes a [`SceneGraph`](vc_graph::SceneGraph) whose nodes have poses and shapes: assets,
//! or boxes only. Out come the relations of `vc-graph`, with figures beside them (gaps,
//! distances, sides, shares). Whatever moved the things, physics or an edit, does not
//! matter; what a physics world knows better can be handed in as plain data
//! ([`Evidence`]).
//!
//! ```
//! use vc_graph::{Bounds, Draft, Edge, Pose, Relation, SceneBuilder};
//! use vc_relations::{Evidence, Relations, Rule};
//!
//! let size = |x, y, z| Bounds::standing(nalgebra::Vector3::new(x, y, z));
//! let mut scene = SceneBuilder::new("kitchen");
//! let fridge = scene.add(Draft::new("fridge").bounds(size(0.6, 0.6, 1.8)).at(Pose::identity()))?;
//! let milk = Draft::new("milk").bounds(size(0.08, 0.08, 0.2)).at(Pose::translation(0.1, 0.0, 0.9));
//! let milk = scene.add(milk)?;
//! let graph = scene.build();
//!
//! let relations = Relations::new(&graph, Rule::Repaired, Evidence::default())?;
//! assert_eq!(relations.between(milk, fridge), [Relation::Inside, Relation::Touching, Relation::Near]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # The rule
//!
//! [`Rule::BoxTrace`] is the thesis's rule to the letter: six swept boxes for each object, on
//! what the one down hits, inside where those up and down hit the same, else under what the
//! one up hits. It breaks on containers (their content overlaps their box), on things that
//! overlap by a millimetre, and on stacks. [`Rule::VirtualHome`] has VirtualHome's
//! definitions on world-aligned boxes. [`Rule::Repaired`], the default, keeps the idea of
//! traces:
//!
//! | relation | holds if |
//! |---|---|
//! | on | a joint holds it; else contacts push it up, each by a tenth of all at least; else the trace down from one of its parts meets the other at most [`SUPPORT_GAP`](threshold::SUPPORT_GAP) below, not steeper than 60 degrees, and no deeper than the nearest by more than [`SUPPORT_TIE`](threshold::SUPPORT_TIE); else it hangs: on a hook, a wall, a ceiling, or what it touches |
//! | inside | its centre and four of its eight corners are in a hollow of the other: where the asset says it holds things inside, or where its parts leave room with a floor, and four walls, or three and a roof, or a roof and two walls from one side through to the other (a bookcase without a back); a rim of three centimetres is a wall. Then it is not also on it |
//! | under | the other is the first above the middle of its box that does not rest on it or in it; not the building, not what holds it |
//! | sitting, lying on | an agent that sits (by state, or as its box has a seat at the height of the hips) or lies, on what affords it. Then it is not on anything |
//! | near, near at a side | the boxes are at most [`NEAR_REACH`](threshold::NEAR_REACH) apart, and they are in one room or no part of the building is between their centres. The side is that of the thing's own axes on which the other is; none above and below |
//! | touching | parts at most [`TOUCH_GAP`](threshold::TOUCH_GAP) apart |
//! | facing | an agent or a seat has a thing to look at within 75 degrees of its front, 5 m, and no wall between |
//! | in room | its centre, of an agent the point above its feet, is over the room's floors (its shape, or its box, where it has none); in a doorway, the nearest |
//! | between | a door has these rooms on its two sides: across its thickness, or, where its box has none as around a leaf that stands open, across whichever axis leads from room to room. A frame has them beside its leaf, an outer door has one |
//! | held, worn | the graph or the evidence says so; then it rests on nothing |
//!
//! A trace starts at a part's middle plane and is a little narrower than the part, so that a
//! few millimetres of overlap or of gap change nothing, below or beside. Every threshold is
//! in [`threshold`], with unit and reason. Of two nodes at most one of on, inside, sitting
//! and lying holds, a thing is inside all containers around it, and nothing rests on itself
//! through others.
//!
//! # Main types
//!
//! | type | what |
//! |---|---|
//! | [`Relations`] | the relations of a scene: [`edges`](Relations::edges), [`of`](Relations::of), [`has`](Relations::has); [`update`](Relations::update) after moves |
//! | [`Evidence`] | contacts, joints, positions of drawers and doors, what is held |
//! | [`Support`], [`Near`], [`Side`] | the figures beside on and near |
//! | [`Proximity`] | touching distance, arm's reach, near, behind a wall, far: told apart by name |
//! | [`Explanation`] | why a relation holds or does not: which trace met what, where; how far within rooms, off the front, from seat and hook |
//! | [`Rule`] | which rule decides |
//!
//! # Cost and upkeep
//!
//! All that depends on two things is measured for the pair alone, and relations are read off
//! these facts. So after a move only the moved thing's pairs are measured again, and the
//! result is that of a full rebuild, to the last bit. The pairs of a scene are found by sorting
//! boxes and sweeping over them, those of a moved thing in a tree; eight boxes are compared at
//! once. Traces are sweeps of boxes by separating axes, exact for boxes. Pieces and hollows are
//! found once for each asset and shared by all that have it. One thread; results do not depend
//! on the order of anything, and are the same bits on every machine. `benches/README.md` has
//! figures: about two microseconds an object for all relations, about ten for a move.
//!
//! # Input
//!
//! Poses, boxes, scales and evidence with numbers that are not finite, coordinates and sizes
//! beyond [`WORLD_REACH`](threshold::WORLD_REACH), negative sizes and rotations that are none
//! are refused: [`InputError`] lists every one, with its node. Nothing is changed then. A node
//! without a pose or without a shape has no relations.
//!
//! # What is approximate
//!
//! Shapes are traced as boxes, cylinders and ellipsoids: a hull as its box, a cone as its
//! cylinder, a turned shape as discs and rings of eight boxes, an extruded outline as six slices
//! at most (exact where it has right angles; so are rooms over such floors), a mesh as 8 by 8 columns.
//! Scaling a part that is turned against its asset's axes keeps its right angles. Of a thing
//! of which only the box is known, what is put on it may be in the upper half of its box.

#![warn(clippy::disallowed_methods)]

mod body;
mod box_trace;
mod carve;
mod distance;
mod edges;
mod error;
mod evidence;
mod explain;
mod explanation;
mod facts;
mod form;
mod hollow;
mod lanes;
mod near;
mod pair;
mod proximity;
mod region;
mod relations;
mod room;
mod rule;
mod sight;
mod solid;
mod support;
mod sweep;
mod targets;
pub mod threshold;
mod tree;
mod virtual_home;
mod walls;
mod world;
mod write;

pub use box_trace::Trace;
pub use error::{Flaw, InputError};
pub use evidence::{Attachment, Contact, Evidence};
pub use explanation::{Explanation, Hit, Hook, Seat, Sight, Traced, Verdict, Within};
pub use near::Side;
pub use proximity::Proximity;
pub use relations::{Near, Relations, relations};
pub use rule::Rule;
pub use support::{Ground, Support};
