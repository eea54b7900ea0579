//! Checks whether a building is sound: every violation, with the regions and nodes it concerns.

mod overlap;

use vc_graph::space::{PortalKind, RegionFrame, RegionId, Space};
use vc_graph::{Label, NodeId, ObjectRole, SceneGraph};

use super::measures::{BEYOND, DECK, LIFT, STAIRS, STOREY};
use super::scene::Part;
use super::{Building, BuildingStorey, BuildingViolation};
use crate::area::Area;
use crate::circulation::cabin::CABIN_WALL;
use crate::circulation::lift;
use crate::circulation::stairs::POST;
pub(crate) use overlap::{Made, overlaps};

/// The greatest difference between two rises, and the greatest distance of what is to be in line, metres.
const EVEN: f32 = 0.005;
/// How far trims and ledges may stand out of a home.
const TRIM: f32 = 0.15;

impl Building {
    /// Lists every violation; a building that was generated has none. Makes all its scenes.
    ///
    /// ```
    /// use vc_graph::Seed;
    /// use vc_procgen::Building;
    /// assert_eq!(Building::from_seed(Seed(7))?.violations(), []);
    /// # Ok::<(), vc_procgen::BuildingError>(())
    /// ```
    pub fn violations(&self) -> Vec<BuildingViolation> {
        let (made, mut found) = sound(self.space(), &self.wishes.frame, |region| self.scene(region));
        found.extend(made.iter().flat_map(|this| self.outside(this)));
        found.extend(overlaps(&made));
        found.extend(self.storeys().iter().flat_map(|storey| self.front_doors(storey)));
        let scene = |region| made.iter().find(|this| this.region == region).map(|this| &this.scene);
        let galleries = self.storeys().iter().filter_map(|storey| Some((storey, scene(storey.gallery)?)));
        let galleries: Vec<_> = galleries.collect();
        found.extend(lift_doors(&galleries));
        found.extend(galleries.iter().flat_map(|(_, scene)| stairs(scene, galleries[0].1)));
        found
    }

    /// Things outside the space that the plan has for a region, seen from above.
    fn outside(&self, this: &Made) -> Vec<BuildingViolation> {
        let Some(space) = self.part(this.region).map(|part| self.ground(part)) else { return Vec::new() };
        let mut wrong: Vec<NodeId> =
            this.boxes.iter().filter(|piece| !space.holds(&piece.area())).map(|piece| piece.node).collect();
        wrong.dedup();
        wrong.into_iter().map(|node| BuildingViolation::Outside(this.scene.label(node), this.region)).collect()
    }

    /// The space of a part, seen from above, in the frame of the building.
    fn ground(&self, part: Part) -> Area {
        let around = |areas: &[Area]| areas.iter().copied().reduce(Area::around_both).unwrap_or_default();
        let stairs = STAIRS.area();
        let tower = Area { y1: stairs.y1 + POST, ..stairs };
        let shaft = lift::within().moved((LIFT, DECK.y1));
        match part {
            Part::Home(storey, side) => around(&self.places[storey][side].outline).grown(TRIM),
            Part::Gallery(storey) => {
                let [west, east] = self.places[storey].each_ref().map(|place| place.bridge);
                around(&[DECK, west, east, tower, shaft.grown(lift::WALL)])
            }
            Part::Cabin => shaft.grown(CABIN_WALL),
            Part::Yard => self.plot().grown(BEYOND),
        }
    }

    fn front_doors(&self, storey: &BuildingStorey) -> Vec<BuildingViolation> {
        let gallery = storey.gallery;
        let doors = |home: RegionId| {
            let plans = self.space().portals_of(home).filter_map(|portal| self.space().portal(portal));
            plans.filter(|plan| plan.kind == PortalKind::Door && plan.side(gallery).is_some()).count()
        };
        let all = storey.homes.map(|home| (home, doors(home)));
        let wrong = all.into_iter().filter(|(_, doors)| *doors != 1);
        wrong.map(|(home, doors)| BuildingViolation::FrontDoors { home, gallery, doors }).collect()
    }
}

/// All scenes of a plan whose frame is given, and the violations in each alone and at its portals.
pub(crate) fn sound<E: std::error::Error>(
    space: &Space,
    frame: &RegionFrame,
    scene: impl Fn(RegionId) -> Result<SceneGraph, E>,
) -> (Vec<Made>, Vec<BuildingViolation>) {
    let (mut made, mut found) = (Vec::new(), Vec::new());
    for (region, plan) in space.regions().filter(|(_, region)| region.has_scene()) {
        let stops = if plan.stops.is_empty() { vec![plan.frame] } else { plan.stops.to_vec() };
        let frames = stops.iter().map(|stop| stop.to(frame)).collect();
        match scene(region) {
            Ok(scene) => made.push(Made::new(region, scene, frames)),
            Err(why) => found.push(BuildingViolation::Broken(region, why.to_string())),
        }
    }
    for this in &made {
        found.extend(this.scene.validate().into_iter().map(|fault| BuildingViolation::Scene(this.region, fault)));
        let numbers = space.region(this.region).map(|region| region.numbers);
        let wrong = this.scene.nodes().filter(|node| !numbers.is_some_and(|block| block.has(node.id())));
        found.extend(wrong.map(|node| BuildingViolation::Number(node.label(), this.region)));
    }
    found.extend(leaves(space, &made));
    (made, found)
}

/// Portals whose leaf is no door of the scene that it should be in.
fn leaves(space: &Space, made: &[Made]) -> Vec<BuildingViolation> {
    let leaves = space.portals().filter_map(|(portal, plan)| Some((portal, plan.leaf?)));
    let wrong = leaves.filter_map(|(portal, leaf)| {
        let of = |scene: &SceneGraph| scene.node(leaf).map(|node| (node.label(), node.role() == ObjectRole::Door));
        match made.iter().find_map(|this| of(&this.scene)) {
            Some((_, true)) => None,
            Some((label, false)) => Some(BuildingViolation::NoLeaf(portal, label)),
            None => Some(BuildingViolation::NoLeaf(portal, Label { class: "?".into(), id: leaf })),
        }
    });
    wrong.collect()
}

/// Doors of the lift that are not above that on the ground.
fn lift_doors(galleries: &[(&BuildingStorey, &SceneGraph)]) -> Vec<BuildingViolation> {
    let at = |(storey, scene): &(&BuildingStorey, &SceneGraph)| {
        let node = scene.node(storey.lift_door)?;
        Some((node.label(), node.position()?))
    };
    let doors: Vec<_> = galleries.iter().filter_map(at).collect();
    let off = doors.iter().map(|(label, place)| (label, (place - doors[0].1).norm()));
    off.filter(|(_, off)| *off > EVEN).map(|(label, off)| BuildingViolation::LiftDoor(label.clone(), off)).collect()
}

/// Stairs that are not above those on the ground, and steps that are not as high as others.
fn stairs(scene: &SceneGraph, ground: &SceneGraph) -> Vec<BuildingViolation> {
    let mut found = Vec::new();
    let lowest = ground.of_class("stairs").first().and_then(|id| ground.node(*id)?.position());
    for node in scene.of_class("stairs").iter().filter_map(|id| scene.node(*id)) {
        let off = node.position().zip(lowest).map_or(f32::INFINITY, |(here, there)| (here - there).norm());
        if off > EVEN {
            found.push(BuildingViolation::Stairs(node.label(), off));
        }
        let asset = node.spec().asset.and_then(|asset| scene.assets().get(asset));
        let treads = asset.iter().flat_map(|asset| asset.surfaces.iter().map(|tread| tread.centre.z));
        let floor = node.position().map_or(0.0, |place| place.z);
        let heights: Vec<f32> = [-floor].into_iter().chain(treads).chain([STOREY - floor]).collect();
        let rises: Vec<f32> = heights.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let wrong = rises.iter().enumerate().filter(|(_, rise)| (*rise - rises[0]).abs() > EVEN);
        found.extend(wrong.map(|(step, rise)| BuildingViolation::Rise(node.label(), step + 1, *rise, rises[0])));
    }
    found
}
