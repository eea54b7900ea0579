//! The plan of a building: its regions, and the portals between them.

use std::f32::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::space::{
    Portal, PortalId, PortalKind, PortalSide, Region, RegionFrame, RegionId, RegionKind, Space, SpaceBuilder,
};
use vc_graph::{NodeId, Pose};

use super::error::BuildingError;
use super::measures::{CLEAR, DECK, GATE, LIFT, STAIRS, STOREY};
use super::place::Place;
use super::{BuildingSpecification, gallery};
use crate::circulation::{cabin, lift};

/// The node numbers of a home, and of any other region of a building.
pub(super) const HOME: u32 = 4096;
const OTHER: u32 = 1024;

/// A storey: its regions and the portals of its gallery.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct BuildingStorey {
    /// The group of its regions.
    pub region: RegionId,
    /// The gallery.
    pub gallery: RegionId,
    /// The homes, in the west and in the east.
    pub homes: [RegionId; 2],
    /// The portals between gallery and homes: their front doors.
    pub front_doors: [PortalId; 2],
    /// The landing to the gallery above; none on the last storey.
    pub stairs: Option<PortalId>,
    /// The landing between gallery and cabin: the stop with the storey's number.
    pub stop: PortalId,
    /// The leaf of the lift's door, in the gallery.
    pub lift_door: NodeId,
    /// The button that calls the lift, in the gallery.
    pub call_button: NodeId,
    /// The button of this storey, in the cabin.
    pub floor_button: NodeId,
}

/// The regions and portals of a building.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Plan {
    pub(super) space: Arc<Space>,
    pub(super) storeys: Vec<BuildingStorey>,
    pub(super) cabin: RegionId,
    pub(super) cabin_door: NodeId,
    pub(super) yard: RegionId,
    pub(super) gate: PortalId,
}

impl Plan {
    pub(super) fn new(
        name: &str,
        wishes: &BuildingSpecification,
        places: &[[Place; 2]],
    ) -> Result<Self, BuildingError> {
        let mut planner = Planner::default();
        let building = planner.add(Region::new(RegionKind::Building, name).at(wishes.frame))?;
        let stops: Vec<RegionFrame> = (0..places.len()).map(stop).collect();
        let cabin = Region::new(RegionKind::Stairwell, "lift").within(building).moving(stops);
        let cabin = planner.add(cabin.with_numbers(OTHER))?;
        let yard = planner.add(Region::new(RegionKind::Yard, "yard").within(building).with_numbers(OTHER))?;
        let mut storeys: Vec<BuildingStorey> = Vec::new();
        for (number, homes) in places.iter().enumerate() {
            let storey = planner.storey((building, cabin), number, homes)?;
            if let Some(below) = storeys.last_mut() {
                below.stairs = Some(planner.stairs(below.gallery, storey.gallery)?);
            }
            storeys.push(storey);
        }
        let ground = storeys.first().map_or(yard, |storey| storey.gallery);
        let gate = planner.gate(ground, yard)?;
        let cabin_door = planner.node(cabin, 1 + cabin::DOOR);
        Ok(Self { space: Arc::new(planner.builder.build()), storeys, cabin, cabin_door, yard, gate })
    }
}

/// The frame of the cabin at a stop.
fn stop(storey: usize) -> RegionFrame {
    RegionFrame::new([f64::from(LIFT), f64::from(DECK.y1), height(storey)], 0.0)
}

/// The height of a storey's floor.
fn height(storey: usize) -> f64 {
    f64::from(STOREY) * storey as f64
}

#[derive(Default)]
struct Planner {
    builder: SpaceBuilder,
}

impl Planner {
    fn add(&mut self, region: Region) -> Result<RegionId, BuildingError> {
        Ok(self.builder.add(region)?)
    }

    /// A node of a region, by its place in the scene.
    fn node(&self, region: RegionId, place: usize) -> NodeId {
        NodeId(self.builder.region(region).map_or(0, |region| region.numbers.first) + place as u32)
    }

    /// A storey of a building, without the stairs up; the gallery's only room has the first of its numbers.
    fn storey(
        &mut self,
        (building, cabin): (RegionId, RegionId),
        number: usize,
        homes: &[Place; 2],
    ) -> Result<BuildingStorey, BuildingError> {
        let storey = Region::new(RegionKind::Storey, format!("storey {number}")).within(building);
        let region = self.add(storey.shifted(0.0, 0.0, height(number)))?;
        let gallery = Region::new(RegionKind::Corridor, "gallery").within(region).with_numbers(OTHER);
        let gallery = self.add(gallery)?;
        let [west, east] = homes;
        let (west, east) = (self.home((region, gallery), west)?, self.home((region, gallery), east)?);
        let lift_door = self.node(gallery, 1 + gallery::DOOR);
        let call_button = self.node(gallery, 1 + gallery::CALL);
        let floor_button = self.node(cabin, 1 + cabin::BUTTONS + number);
        Ok(BuildingStorey {
            region,
            gallery,
            homes: [west.0, east.0],
            front_doors: [west.1, east.1],
            stairs: None,
            stop: self.stop((gallery, cabin), (lift_door, [call_button, floor_button]), number)?,
            lift_door,
            call_button,
            floor_button,
        })
    }

    /// A home on a storey, with its front door to the gallery.
    fn home(
        &mut self,
        (storey, gallery): (RegionId, RegionId),
        place: &Place,
    ) -> Result<(RegionId, PortalId), BuildingError> {
        let home = Region::new(RegionKind::Unit, format!("apartment/{}", place.seed.0)).within(storey);
        let home = self.add(home.at(place.frame()).with_numbers(HOME))?;
        let door = place.door;
        let (leaf, room) = (self.node(home, door.numbers.0 as usize), self.node(home, door.numbers.1 as usize));
        let inward = if door.outside.0 < 0.0 { PI } else { 0.0 };
        let inside =
            PortalSide { region: home, pose: side((door.at.0, door.at.1, 0.0), door.out.yaw()), room: Some(room) };
        let outside = self.side(gallery, (door.outside.0, door.outside.1, 0.0), inward);
        let portal = Portal::new(PortalKind::Door, [inside, outside], door.size.0, door.size.1);
        Ok((home, self.builder.join(portal.with_leaf(leaf))?))
    }

    /// The landing between a gallery and the cabin.
    fn stop(
        &mut self,
        (gallery, cabin): (RegionId, RegionId),
        (leaf, buttons): (NodeId, [NodeId; 2]),
        storey: usize,
    ) -> Result<PortalId, BuildingError> {
        let [landing, inside] = lift::THRESHOLDS;
        let here = self.side(gallery, (LIFT, DECK.y1 + landing, 0.0), FRAC_PI_2);
        let there = self.side(cabin, (0.0, inside, 0.0), -FRAC_PI_2);
        let portal = Portal::new(PortalKind::Landing, [here, there], lift::DOOR.0, lift::DOOR.1);
        Ok(self.builder.join(portal.with_leaf(leaf).at_stop(storey as u32).called_by(buttons))?)
    }

    /// The landing at the upper end of the stairs from one gallery to the next.
    fn stairs(&mut self, gallery: RegionId, above: RegionId) -> Result<PortalId, BuildingError> {
        let (x, y) = STAIRS.head();
        let here = self.side(gallery, (x, y, STOREY), -FRAC_PI_2);
        let there = self.side(above, (x, y, 0.0), FRAC_PI_2);
        let portal = Portal::new(PortalKind::Landing, [here, there], STAIRS.back.1 - STAIRS.back.0, CLEAR);
        Ok(self.builder.join(portal.over_stairs(STAIRS.way()))?)
    }

    /// The passage from the gallery on the ground to the yard.
    fn gate(&mut self, gallery: RegionId, yard: RegionId) -> Result<PortalId, BuildingError> {
        let here = self.side(gallery, (0.0, DECK.y0, 0.0), -FRAC_PI_2);
        let there = self.side(yard, (0.0, DECK.y0, 0.0), FRAC_PI_2);
        Ok(self.builder.join(Portal::new(PortalKind::Passage, [here, there], GATE, CLEAR))?)
    }

    /// A side of a portal in the only room of a region.
    fn side(&self, region: RegionId, at: (f32, f32, f32), yaw: f32) -> PortalSide {
        PortalSide { region, pose: side(at, yaw), room: Some(self.node(region, 0)) }
    }
}

/// A threshold, with the way out of its region.
fn side((x, y, z): (f32, f32, f32), yaw: f32) -> Pose {
    Pose::from_parts(Vector3::new(x, y, z).into(), UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw))
}
