//! The fixed plan of a world: its regions and portals.

use nalgebra::Vector3;

use super::{NumberBlock, Portal, PortalId, Region, RegionFrame, RegionId, SpaceError};
use crate::geometry::is_finite;
use crate::hash::Digester;
use crate::{Digest, NodeId, Word};

/// The greatest distance between the two sides of a portal, metres: the thickness of a wall.
const WALL: f64 = 0.6;
/// The greatest deviation of the two sides from facing each other, degrees.
const FACING: f64 = 5.0;

/// The plan of a world: a tree of regions, and the portals between them. It does not change; keep it in an `Arc`.
/// A region takes some hundred bytes, whatever is in it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Space {
    regions: Vec<Region>,
    portals: Vec<Portal>,
    children: Lists,
    openings: Lists,
    /// The regions with scenes, whose blocks of numbers are in the same order.
    scenes: Vec<RegionId>,
}

impl Space {
    /// A world of a single region, with all node numbers: that of a scene that stands alone.
    ///
    /// # Errors
    /// [`SpaceError::NotFinite`].
    pub fn single(region: Region) -> Result<Self, SpaceError> {
        if !region.frame.is_finite() {
            return Err(SpaceError::NotFinite(region.name.to_string()));
        }
        let region = Region { numbers: NumberBlock::ALL, parent: None, ..region };
        let lists = || Lists::new(1, &[]);
        Ok(Self {
            regions: vec![region],
            portals: Vec::new(),
            children: lists(),
            openings: lists(),
            scenes: vec![RegionId(0)],
        })
    }

    /// The number of regions, groups included.
    pub fn len(&self) -> usize {
        self.regions.len()
    }

    /// Whether there are no regions.
    pub fn is_empty(&self) -> bool {
        self.regions.is_empty()
    }

    /// All regions with their numbers, each after the one that it is part of.
    pub fn regions(&self) -> impl Iterator<Item = (RegionId, &Region)> {
        (0..).map(RegionId).zip(&self.regions)
    }

    /// The region with a number.
    pub fn region(&self, id: RegionId) -> Option<&Region> {
        self.regions.get(id.0 as usize)
    }

    /// The regions that are directly part of a region, in order.
    pub fn parts(&self, id: RegionId) -> impl Iterator<Item = RegionId> + '_ {
        self.children.of(id).map(RegionId)
    }

    /// The names of a region and of those that it is part of, the outermost first: `house/storey 1/flat 3`.
    pub fn path(&self, id: RegionId) -> String {
        let mut names = Vec::new();
        let mut next = self.region(id);
        while let Some(region) = next {
            names.push(&*region.name);
            next = region.parent.and_then(|parent| self.region(parent));
        }
        names.reverse();
        names.join("/")
    }

    /// All portals with their numbers.
    pub fn portals(&self) -> impl Iterator<Item = (PortalId, &Portal)> {
        (0..).map(PortalId).zip(&self.portals)
    }

    /// The portal with a number.
    pub fn portal(&self, id: PortalId) -> Option<&Portal> {
        self.portals.get(id.0 as usize)
    }

    /// The portals of a region, in order.
    pub fn portals_of(&self, id: RegionId) -> impl Iterator<Item = PortalId> + '_ {
        self.openings.of(id).map(PortalId)
    }

    /// The portal of a region to whose stop a node calls a moving region when it is pushed.
    pub fn called_with(&self, region: RegionId, button: NodeId) -> Option<&Portal> {
        let mut portals = self.portals_of(region).filter_map(|id| self.portal(id));
        portals.find(|portal| portal.buttons.contains(&button))
    }

    /// A digest of the plan: of all that regions and portals say.
    pub fn digest(&self) -> Digest {
        let mut digester = Digester::new();
        for region in &self.regions {
            let numbers =
                [region.numbers.first, region.numbers.count, region.parent.map_or(u32::MAX, |parent| parent.0)];
            digester.text(region.kind.as_str()).text(&region.name).words(numbers.map(u64::from));
            let origin = region.frame.origin.iter().copied();
            digester.words(origin.chain([region.frame.heading]).map(f64::to_bits));
            for stop in region.stops.iter() {
                digester.words(stop.origin.iter().copied().chain([stop.heading]).map(f64::to_bits));
            }
        }
        for portal in &self.portals {
            digester.text(portal.kind.as_str()).reals([portal.width, portal.height]).word(u64::from(portal.glazed));
            digester.word(portal.leaf.map_or(u64::MAX, |leaf| u64::from(leaf.0))).word(u64::from(portal.stop));
            digester.words(portal.buttons.iter().map(|button| u64::from(button.0)));
            digester.reals(portal.stairs.iter().flat_map(|point| point.coords.iter().copied().collect::<Vec<f32>>()));
            for side in &portal.sides {
                let pose = side.pose.translation.vector.iter().chain(side.pose.rotation.coords.iter()).copied();
                digester.word(u64::from(side.region.0)).reals(pose);
                digester.word(side.room.map_or(u64::MAX, |room| u64::from(room.0)));
            }
        }
        digester.digest()
    }

    /// The region in whose block a node's number is. Costs a binary search.
    pub fn made_in(&self, node: NodeId) -> Option<RegionId> {
        let first = |id: &RegionId| self.regions[id.0 as usize].numbers.first;
        let place = self.scenes.partition_point(|id| first(id) <= node.0).saturating_sub(1);
        self.scenes.get(place).copied().filter(|id| self.regions[id.0 as usize].numbers.has(node))
    }
}

/// Makes a [`Space`] region by region, from the whole to its parts, and portal by portal.
///
/// ```
/// use vc_graph::space::{Region, RegionKind, SpaceBuilder, SpaceError};
/// let mut plan = SpaceBuilder::new();
/// let house = plan.add(Region::new(RegionKind::Building, "house").shifted(100.0, 0.0, 0.0))?;
/// let flat = plan.add(Region::new(RegionKind::Unit, "apartment/42").within(house).with_numbers(2000))?;
/// let space = plan.build();
/// assert_eq!(space.path(flat), "house/apartment/42");
/// assert_eq!(space.region(flat).map(|region| region.frame.origin.x), Some(100.0));
/// # Ok::<(), SpaceError>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct SpaceBuilder {
    regions: Vec<Region>,
    portals: Vec<Portal>,
    used: u32,
}

impl SpaceBuilder {
    /// An empty plan.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a region; its frame and its block of numbers are worked out.
    ///
    /// # Errors
    /// [`SpaceError::NoSuchParent`], [`SpaceError::NotFinite`], [`SpaceError::NumbersExhausted`].
    pub fn add(&mut self, mut region: Region) -> Result<RegionId, SpaceError> {
        let name = || region.name.to_string();
        let outer = match region.parent {
            None => RegionFrame::WORLD,
            Some(parent) => match self.regions.get(parent.0 as usize) {
                Some(outer) => outer.frame,
                None => return Err(SpaceError::NoSuchParent { name: name(), parent }),
            },
        };
        let frame = region.frame.within(&outer);
        if !frame.is_finite() {
            return Err(SpaceError::NotFinite(name()));
        }
        let (count, left) = (region.numbers.count, NumberBlock::OVERFLOW.first - 1 - self.used);
        if count > left {
            return Err(SpaceError::NumbersExhausted { name: name(), count, left });
        }
        let stops: Vec<RegionFrame> = region.stops.iter().map(|stop| stop.within(&outer)).collect();
        if !stops.iter().all(RegionFrame::is_finite) {
            return Err(SpaceError::NotFinite(name()));
        }
        (region.frame, region.stops) = (frame, stops.into());
        region.numbers.first = self.used + 1;
        self.used += count;
        self.regions.push(region);
        Ok(RegionId(self.regions.len() as u32 - 1))
    }

    /// A region that was added: with its frame in the world and its block of numbers, from which leaves of portals are named.
    pub fn region(&self, id: RegionId) -> Option<&Region> {
        self.regions.get(id.0 as usize)
    }

    /// Adds a portal between two regions that have scenes.
    ///
    /// # Errors
    /// [`SpaceError::NoScene`], [`SpaceError::JoinsItself`], [`SpaceError::NoOpening`], [`SpaceError::NotFinite`],
    /// [`SpaceError::NoStop`], [`SpaceError::SidesApart`], [`SpaceError::ForeignLeaf`].
    pub fn join(&mut self, portal: Portal) -> Result<PortalId, SpaceError> {
        let [one, other] = &portal.sides;
        let (first, second) = (self.with_scene(one.region)?, self.with_scene(other.region)?);
        if one.region == other.region {
            return Err(SpaceError::JoinsItself(one.region));
        }
        let positive = |value: f32| value.is_finite() && value > 0.0;
        if !positive(portal.width) || !positive(portal.height) {
            return Err(SpaceError::NoOpening(one.region, other.region, portal.width, portal.height));
        }
        if let Some((_, region)) = [(one, first), (other, second)].into_iter().find(|(side, _)| !is_finite(&side.pose))
        {
            return Err(SpaceError::NotFinite(region.name.to_string()));
        }
        if !portal.stairs.iter().flat_map(|point| point.iter()).all(|value| value.is_finite()) {
            return Err(SpaceError::NotFinite(first.name.to_string()));
        }
        let stop = portal.stop as usize;
        if stop > 0 && ![first, second].iter().any(|region| stop < region.stops.len()) {
            return Err(SpaceError::NoStop { regions: [one.region, other.region], stop: portal.stop });
        }
        let (here, there) = (first.frame_at(stop).pose(&one.pose), second.frame_at(stop).pose(&other.pose));
        let apart = (here.translation.vector - there.translation.vector).norm();
        let facing = (here * Vector3::x()).angle(&(there * -Vector3::x()));
        let tilted = (here * Vector3::z()).angle(&(there * Vector3::z()));
        let turned = facing.max(tilted).to_degrees();
        if apart > WALL || turned > FACING {
            return Err(SpaceError::SidesApart(one.region, other.region, apart, turned));
        }
        if let Some(leaf) = portal.leaf.filter(|leaf| !first.numbers.has(*leaf) && !second.numbers.has(*leaf)) {
            return Err(SpaceError::ForeignLeaf { leaf, regions: portal.sides.map(|side| side.region) });
        }
        self.portals.push(portal);
        Ok(PortalId(self.portals.len() as u32 - 1))
    }

    /// The finished plan.
    pub fn build(self) -> Space {
        let Self { regions, portals, .. } = self;
        let count = regions.len();
        let numbered = || (0_u32..).zip(&regions);
        let children: Vec<(RegionId, u32)> = numbered().filter_map(|(id, region)| Some((region.parent?, id))).collect();
        let sides = (0_u32..).zip(&portals).flat_map(|(id, portal)| portal.sides.map(|side| (side.region, id)));
        let openings: Vec<(RegionId, u32)> = sides.collect();
        let scenes = numbered().filter(|(_, region)| region.has_scene()).map(|(id, _)| RegionId(id)).collect();
        let (children, openings) = (Lists::new(count, &children), Lists::new(count, &openings));
        Space { children, openings, scenes, regions, portals }
    }

    fn with_scene(&self, id: RegionId) -> Result<&Region, SpaceError> {
        self.region(id).filter(|region| region.has_scene()).ok_or(SpaceError::NoScene(id))
    }
}

/// A list of numbers for each region, one after the other.
#[derive(Debug, Clone, PartialEq, Default)]
struct Lists {
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Lists {
    fn new(regions: usize, pairs: &[(RegionId, u32)]) -> Self {
        let mut sorted = pairs.to_vec();
        sorted.sort_unstable();
        let starts = (0..=regions as u32).map(|id| sorted.partition_point(|(of, _)| of.0 < id) as u32).collect();
        Self { starts, items: sorted.into_iter().map(|(_, item)| item).collect() }
    }

    fn of(&self, id: RegionId) -> impl Iterator<Item = u32> + '_ {
        let place = |at: u32| self.starts.get(at as usize).map(|start| *start as usize);
        let range = place(id.0).zip(place(id.0.saturating_add(1))).map_or(0..0, |(from, to)| from..to);
        self.items[range].iter().copied()
    }
}
