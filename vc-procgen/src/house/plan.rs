//! The plan of a house: its regions, and the portals between them.

use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

use nalgebra::{UnitQuaternion, Vector3};
use vc_graph::space::{
    Portal, PortalId, PortalKind, PortalSide, Region, RegionFrame, RegionId, RegionKind, Space, SpaceBuilder,
};
use vc_graph::{NodeId, Pose};

use super::error::HouseError;
use super::flat::Flat;
use super::landing::{self, lift_pose};
use super::measures::{Measures, SHAFT, STREET_DOOR, WALL};
use crate::circulation::{cabin, lift};

/// The node numbers of a home, and of any other region of a house.
const HOME: u32 = 4096;
const OTHER: u32 = 1024;

/// A storey: its regions and the portals of its landing.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct HouseStorey {
    /// The group of its regions.
    pub region: RegionId,
    /// The corridor with the lobby before the lift; on the ground it is the hall.
    pub landing: RegionId,
    /// The flats.
    pub homes: Vec<RegionId>,
    /// The portals between landing and flats, in the same order: their front doors.
    pub front_doors: Vec<PortalId>,
    /// The stairs to the landing above; none on the last storey.
    pub stairs: Option<PortalId>,
    /// The portal between landing and cabin: the stop with the storey's number.
    pub stop: PortalId,
    /// The leaf of the lift's door, on the landing.
    pub lift_door: NodeId,
    /// The button that calls the lift, on the landing.
    pub call_button: NodeId,
    /// The button of this storey, in the cabin.
    pub floor_button: NodeId,
}

/// The regions and portals of a house.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Plan {
    pub(super) space: Arc<Space>,
    pub(super) storeys: Vec<HouseStorey>,
    pub(super) cabin: RegionId,
    pub(super) street: RegionId,
    pub(super) street_door: NodeId,
    pub(super) entrance: PortalId,
}

impl Plan {
    pub(super) fn new(name: &str, measures: &Measures, flats: &[Vec<Flat>]) -> Result<Self, HouseError> {
        let mut planner = Planner { builder: SpaceBuilder::new(), measures };
        let house = planner.add(Region::new(RegionKind::Building, name).at(measures.frame))?;
        let cabin = Region::new(RegionKind::Stairwell, "lift").within(house).moving(planner.stops());
        let cabin = planner.add(cabin.with_numbers(OTHER))?;
        let street = planner.add(Region::new(RegionKind::Street, "street").within(house).with_numbers(OTHER))?;
        let mut storeys: Vec<HouseStorey> = Vec::new();
        for (number, flats) in flats.iter().enumerate() {
            let storey = planner.storey((house, cabin), number, flats)?;
            if let Some(below) = storeys.last_mut() {
                below.stairs = Some(planner.stairs(number - 1, [below.landing, storey.landing])?);
            }
            storeys.push(storey);
        }
        let hall = storeys.first().map_or(street, |storey| storey.landing);
        let street_door = planner.node(hall, 1 + landing::STREET_DOOR);
        let entrance = planner.entrance([hall, street], street_door)?;
        Ok(Self { space: Arc::new(planner.builder.build()), storeys, cabin, street, street_door, entrance })
    }
}

struct Planner<'a> {
    builder: SpaceBuilder,
    measures: &'a Measures,
}

impl Planner<'_> {
    fn add(&mut self, region: Region) -> Result<RegionId, HouseError> {
        Ok(self.builder.add(region)?)
    }

    /// A node of a region, by its place in the scene.
    fn node(&self, region: RegionId, place: usize) -> NodeId {
        NodeId(self.builder.region(region).map_or(0, |region| region.numbers.first) + place as u32)
    }

    /// The frames of the cabin at its stops.
    fn stops(&self) -> Vec<RegionFrame> {
        let at =
            |floor| RegionFrame::new([f64::from(SHAFT), f64::from(self.measures.lift), floor], f64::from(FRAC_PI_2));
        self.measures.heights.iter().map(|height| at(height.floor)).collect()
    }

    /// A storey, without the stairs up; the landing's only room has the first of its numbers.
    fn storey(
        &mut self,
        (house, cabin): (RegionId, RegionId),
        number: usize,
        flats: &[Flat],
    ) -> Result<HouseStorey, HouseError> {
        let storey = Region::new(RegionKind::Storey, format!("storey {number}")).within(house);
        let region = self.add(storey.shifted(0.0, 0.0, self.measures.heights[number].floor))?;
        let name = if number == 0 { "hall" } else { "landing" };
        let landing = self.add(Region::new(RegionKind::Corridor, name).within(region).with_numbers(OTHER))?;
        let (mut homes, mut front_doors) = (Vec::new(), Vec::new());
        for (place, flat) in flats.iter().enumerate() {
            let home = Region::new(RegionKind::Unit, format!("flat {}", place + 1)).within(region);
            homes.push(self.add(home.at(flat.frame).with_numbers(HOME))?);
            front_doors.push(self.front_door(homes[place], landing, flat)?);
        }
        let [lift_door, call_button] = [landing::LIFT_DOOR, landing::CALL].map(|place| self.node(landing, 1 + place));
        let floor_button = self.node(cabin, 1 + cabin::BUTTONS + number);
        let stop = self.stop([landing, cabin], (lift_door, [call_button, floor_button]), number)?;
        Ok(HouseStorey {
            region,
            landing,
            homes,
            front_doors,
            stairs: None,
            stop,
            lift_door,
            call_button,
            floor_button,
        })
    }

    fn front_door(&mut self, home: RegionId, landing: RegionId, flat: &Flat) -> Result<PortalId, HouseError> {
        let door = flat.door;
        let [leaf, room] = [door.numbers.0, door.numbers.1].map(|number| self.node(home, number as usize));
        let inside = PortalSide { region: home, pose: side((door.at.0, door.at.1, 0.0), FRAC_PI_2), room: Some(room) };
        let inward = if door.is_north { FRAC_PI_2 } else { -FRAC_PI_2 };
        let outside = self.side(landing, side((door.outside.0, door.outside.1, 0.0), inward));
        let portal = Portal::new(PortalKind::Door, [inside, outside], door.size.0, door.size.1);
        Ok(self.builder.join(portal.with_leaf(leaf))?)
    }

    /// The stop of the cabin at a landing.
    fn stop(
        &mut self,
        [landing, cabin]: [RegionId; 2],
        (leaf, buttons): (NodeId, [NodeId; 2]),
        storey: usize,
    ) -> Result<PortalId, HouseError> {
        let [threshold, inside] = lift::THRESHOLDS;
        let here = lift_pose(self.measures) * side((0.0, threshold, 0.0), FRAC_PI_2);
        let there = side((0.0, inside, 0.0), -FRAC_PI_2);
        let sides = [self.side(landing, here), self.side(cabin, there)];
        let portal = Portal::new(PortalKind::Landing, sides, lift::DOOR.0, lift::DOOR.1);
        Ok(self.builder.join(portal.with_leaf(leaf).at_stop(storey as u32).called_by(buttons))?)
    }

    /// The landing at the upper end of the stairs from a storey.
    fn stairs(&mut self, storey: usize, [below, above]: [RegionId; 2]) -> Result<PortalId, HouseError> {
        let stairs = self.measures.stairs(storey);
        let (x, y) = stairs.head();
        let here = self.side(below, side((x, y, stairs.storey), -FRAC_PI_2));
        let there = self.side(above, side((x, y, 0.0), FRAC_PI_2));
        let clear = self.measures.heights[storey + 1].clear;
        let portal = Portal::new(PortalKind::Landing, [here, there], stairs.back.1 - stairs.back.0, clear);
        Ok(self.builder.join(portal.over_stairs(stairs.way()))?)
    }

    /// The door from the hall to the street.
    fn entrance(&mut self, [hall, street]: [RegionId; 2], leaf: NodeId) -> Result<PortalId, HouseError> {
        let facade = self.measures.facade;
        let here = self.side(hall, side((0.0, facade - WALL / 2.0, 0.0), FRAC_PI_2));
        let there = self.side(street, side((0.0, facade, 0.0), -FRAC_PI_2));
        let portal = Portal::new(PortalKind::Door, [here, there], STREET_DOOR.0, STREET_DOOR.1);
        Ok(self.builder.join(portal.with_leaf(leaf))?)
    }

    /// A side of a portal in the only room of a region.
    fn side(&self, region: RegionId, pose: Pose) -> PortalSide {
        PortalSide { region, pose, room: Some(self.node(region, 0)) }
    }
}

/// A threshold, with the way out of its region.
fn side((x, y, z): (f32, f32, f32), yaw: f32) -> Pose {
    Pose::from_parts(Vector3::new(x, y, z).into(), UnitQuaternion::from_axis_angle(&Vector3::z_axis(), yaw))
}
