//! Paths between crossings and the pavements beside them that are mapped as ways of their own.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Vector2;

use super::marks::crossing;
use super::network::{Network, Part};
use super::street::Street;
use super::{Guessed, ImportReport};
use crate::index::PointIndex;
use crate::polyline::normal;
use crate::{CrossSection, DrivingSide, Point, Polyline, RoadClass, Strip, StripKind, Users};

/// A footway is a pavement to which people cross at most this far from a crossing, metres.
const BESIDE: f64 = 25.0;
/// The path to it leads across the street rather than along it: the cosine of the angle that it has with the shortest way.
const ACROSS: f64 = 0.5;
/// A path leads to a node of a footway that is nearer than this to its end, metres.
const SAME: f64 = 1.0;

/// A path that is to be added.
struct Link {
    crossing: u32,
    /// The part of a footway that it leads to, the station there, and the point.
    part: usize,
    station: f64,
    at: Point,
}

impl Network<'_> {
    /// Adds paths from the crossings that no footway passes to the footways on those sides of their streets that have no
    /// pavement.
    pub(super) fn link_crossings(&mut self, parts: &mut Vec<Part>, report: &mut ImportReport) {
        let is_footway = |part: &Part| {
            let street = &self.streets[part.street];
            let users = street.section.users(true) | street.section.users(false);
            !street.class.is_street() && street.class != RoadClass::Steps && users.has(Users::FOOT)
        };
        let (footways, streets): (Vec<usize>, Vec<usize>) = (0..parts.len())
            .filter(|part| !self.streets[parts[*part].street].class.is_rail())
            .partition(|part| is_footway(&parts[*part]));
        let walked: BTreeSet<u32> = footways.iter().flat_map(|part| parts[*part].nodes.iter().copied()).collect();
        let lines = |of: &[usize]| -> BTreeMap<u32, Polyline> {
            of.iter().filter_map(|part| Some((*part as u32, self.line(&parts[*part].nodes)?))).collect()
        };
        let (footways, others) = (lines(&footways), lines(&streets));
        let near = Beside {
            footways: PointIndex::new(footways.iter().map(|(id, line)| (*id, line))),
            streets: PointIndex::new(others.iter().map(|(id, line)| (*id, line))),
        };
        // Where a street only ends nobody knows how it goes on.
        let mut ends: BTreeMap<u32, usize> = BTreeMap::new();
        for nodes in streets.iter().map(|part| &parts[*part].nodes) {
            nodes.first().into_iter().chain(nodes.last()).for_each(|node| *ends.entry(*node).or_default() += 1);
        }
        let mut found: Vec<Link> = Vec::new();
        let mut done = BTreeSet::new();
        for number in streets {
            let part = &parts[number];
            for (place, node) in part.nodes.iter().enumerate() {
                let end = ends.get(node) == Some(&1);
                if end || walked.contains(node) || !self.is_crossing(*node) || !done.insert(*node) {
                    continue;
                }
                let [before, after] = [place.saturating_sub(1), (place + 1).min(part.nodes.len() - 1)];
                let along = self.point(part.nodes[after]) - self.point(part.nodes[before]);
                let street = &self.streets[part.street];
                for left in [false, true] {
                    if !self.has_pavement(street, left) {
                        found.extend(near.link(*node, self.point(*node), along, left, &footways, &others));
                    }
                }
            }
        }
        self.add_links(parts, found, report);
    }

    /// Whether a node of the file is a crossing.
    fn is_crossing(&self, node: u32) -> bool {
        let tags = self.source.nodes.get(node as usize).map(|node| self.source.node_tags(node));
        tags.is_some_and(|tags| !tags.is_empty() && crossing(tags, false).is_some())
    }

    /// Whether the left or the right side of a street has a pavement.
    fn has_pavement(&self, street: &Street, left: bool) -> bool {
        let forward = left != (self.side == DrivingSide::Right);
        street.section.side(forward).iter().any(|strip| strip.kind == StripKind::Pavement)
    }

    /// Adds paths, and nodes to the footways that they lead to.
    fn add_links(&mut self, parts: &mut Vec<Part>, mut links: Vec<Link>, report: &mut ImportReport) {
        let mut counts: BTreeMap<u32, u32> = BTreeMap::new();
        // The last of a footway comes first, so that the stations of others hold.
        links.sort_by(|a, b| {
            a.part.cmp(&b.part).then(b.station.total_cmp(&a.station)).then(a.crossing.cmp(&b.crossing))
        });
        for link in links {
            *counts.entry(link.crossing).or_default() += 1;
            let end = self.node_at(&mut parts[link.part], &link);
            let street = &self.streets[parts[link.part].street];
            let strip = Strip::new(StripKind::Path, 2.0, Users::FOOT, 1.4);
            let path = Street {
                class: RoadClass::Path,
                section: CrossSection { forward: vec![strip], ..CrossSection::default() },
                name: None,
                layer: street.layer,
                structure: street.structure,
                roundabout: false,
                slip: false,
                private: false,
                reversed: false,
                guessed_pavements: [None; 2],
            };
            self.streets.push(path);
            parts.push(Part { way: None, street: self.streets.len() - 1, nodes: vec![link.crossing, end] });
        }
        counts.into_iter().for_each(|(node, count)| report.guess(self.element(node), Guessed::Links(count)));
    }

    /// The node of a footway at which a path ends: one that it has, or a new one.
    fn node_at(&mut self, part: &mut Part, link: &Link) -> u32 {
        let mut station = 0.0;
        let mut after = part.nodes.len() - 1;
        for (place, pair) in part.nodes.windows(2).enumerate() {
            let length = (self.point(pair[1]) - self.point(pair[0])).norm();
            if station + length >= link.station {
                after = place + 1;
                break;
            }
            station += length;
        }
        let known = [after - 1, after].into_iter().map(|place| part.nodes[place]);
        if let Some(node) = known.into_iter().find(|node| (self.point(*node) - link.at).norm() < SAME) {
            return node;
        }
        let node = self.add_node(link.at);
        part.nodes.insert(after, node);
        node
    }
}

/// Footways and streets by place.
struct Beside {
    footways: PointIndex,
    streets: PointIndex,
}

impl Beside {
    /// The path from a crossing to the nearest footway on one side of its street, rather across the street than along it, and over
    /// no other street.
    fn link(
        &self,
        crossing: u32,
        at: Point,
        along: Vector2<f64>,
        left: bool,
        footways: &BTreeMap<u32, Polyline>,
        streets: &BTreeMap<u32, Polyline>,
    ) -> Option<Link> {
        let across = normal(along.try_normalize(1e-6)?) * if left { 1.0 } else { -1.0 };
        let near = self.footways.each(&at, BESIDE, |id| &footways[&id]);
        let fits = |(_, near): &(u32, crate::Projection)| {
            let way = near.point - at;
            way.dot(&across) > way.norm() * ACROSS
        };
        let nearest = near.into_iter().filter(fits);
        let (part, near) = nearest.min_by(|a, b| a.1.left.abs().total_cmp(&b.1.left.abs()).then(a.0.cmp(&b.0)))?;
        let way = Polyline::new([at + (near.point - at) * 0.1, near.point])?;
        let around = self.streets.each(&at, BESIDE, |id| &streets[&id]);
        let over = around.keys().any(|id| streets[id].crosses(&way));
        (!over).then_some(Link { crossing, part: part as usize, station: near.station, at: near.point })
    }
}
