//! Regions and portals: a world as many scenes, each in its own frame.
//!
//! A *region* is whatever is near enough to be one scene: a flat, a shop, a corridor, a stretch of street. Its
//! [`SceneGraph`](crate::SceneGraph) is as local and as light as that of a single home, with poses from its own origin. A
//! [`Space`] is the fixed plan of a world: the tree of its regions with their [`RegionFrame`]s and blocks of node numbers, and the
//! [`Portal`]s (doors, windows, passages, landings) that join them. [`RegionGraphs`] is the state of a world: the scenes of
//! the regions that are active, the changes of those that are dormant, and the region of each thing that has moved.
//!
//! ```
//! use vc_graph::space::{RegionFrame, Portal, PortalKind, PortalSide, Region, RegionGraphs, RegionKind, SpaceBuilder};
//! use vc_graph::{Draft, Pose, SceneBuilder, SceneGraph};
//!
//! // A flat four kilometres away, and a yard before its door.
//! let mut plan = SpaceBuilder::new();
//! let house = plan.add(Region::new(RegionKind::Building, "house").at(RegionFrame::new([4000.0, -3000.0, 60.0], 0.6)))?;
//! let flat = plan.add(Region::new(RegionKind::Unit, "flat").within(house).with_numbers(1000))?;
//! let yard = plan.add(Region::new(RegionKind::Yard, "yard").within(house).shifted(5.0, 0.0, 0.0).with_numbers(1000))?;
//! let inside = PortalSide { region: flat, pose: Pose::translation(5.0, 0.0, 0.0), room: None };
//! let outside = PortalSide { region: yard, pose: Pose::rotation([0.0, 0.0, std::f32::consts::PI].into()), room: None };
//! let door = plan.join(Portal::new(PortalKind::Passage, [inside, outside], 0.9, 2.0))?;
//! let space = plan.build();
//!
//! // The scenes of the two, with numbers of their blocks.
//! let scene = |region| -> Result<SceneGraph, Box<dyn std::error::Error>> {
//!     let mut scene = SceneBuilder::new("scene");
//!     scene.numbers(space.region(region).ok_or("planned")?.numbers);
//!     scene.add(Draft::new("hallway"))?;
//!     Ok(scene.build())
//! };
//! let mut world = RegionGraphs::new(space.clone().into());
//! world.insert(flat, scene(flat)?)?;
//! world.insert(yard, scene(yard)?)?;
//!
//! // Somebody goes from the flat into the yard with a cup in hand.
//! let hall = world.graph(flat).ok_or("active")?.rooms()[0];
//! let mut edit = world.edit(flat).ok_or("active")?;
//! let me = edit.add(Draft::new("character").at(Pose::translation(4.5, 0.0, 0.0)))?;
//! edit.move_to_room(me, hall)?;
//! let cup = edit.add(Draft::new("cup"))?;
//! edit.hold(me, cup)?;
//! edit.commit();
//! world.pass(me, door)?;
//! assert_eq!((world.region_of(me), world.region_of(cup)), (Some(yard), Some(yard)));
//! assert_eq!(world.node(me).and_then(|node| node.position()).map(|at| at.x), Some(-0.5));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod error;
mod frame;
mod gather;
mod graphs;
mod load;
mod numbers;
mod pass;
mod plan;
mod portal;
mod region;
mod route;
mod save;

pub use error::{PassError, SpaceError, WorldFileError};
pub use frame::RegionFrame;
pub use gather::gather;
pub use graphs::RegionGraphs;
pub use load::Load;
pub use numbers::NumberBlock;
pub use pass::Crossing;
pub use plan::{Space, SpaceBuilder};
pub use portal::{Portal, PortalId, PortalKind, PortalSide, PortalState};
pub use region::{Region, RegionId, RegionKind};
