//! Blocks: the land between streets.

use vc_map::Point;

use super::convex::{Beyond, Convex};
use super::near::Near;
use super::net::Net;
use super::street_class::StreetClass;
use super::view::View;
use super::zone::CityZone;

/// The room for people at the corner of a house, metres.
const ROOM: f64 = 1.5;
/// Corners are cut off by so much whose cosine is greater, of 66 and of 84 degrees, metres.
const CHAMFERS: [(f64, f64); 2] = [(0.4, 4.0), (0.1, 3.0)];

/// A block of a plan.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct CityBlock {
    /// The face of the network of streets: its corners are on the middles of carriageways.
    pub face: Convex,
    /// The edge of the carriageways around it, with rounded corners, counter-clockwise; pavements lie within.
    pub kerb: Vec<Point>,
    /// The land within its building lines.
    pub land: Convex,
    /// Its use.
    pub zone: CityZone,
}

/// The blocks of a network, whose classes are final.
pub(super) fn blocks(net: &Net) -> Vec<CityBlock> {
    let class = |beyond: Beyond| match beyond {
        Beyond::Street(street) => net.lines[street].class,
        _ => StreetClass::Residential,
    };
    let block = |face: &super::face::Face| {
        let face = face.polygon(&net.points);
        let kerb = face.inset(None, |beyond| class(beyond).kerb())?;
        let land = face.inset(None, |beyond| class(beyond).edge())?;
        let land = chamfered(land);
        let sides: Vec<Beyond> = kerb.sides().map(|(_, _, beyond)| beyond).collect();
        let radius = |corner: usize| {
            radius(&kerb, corner, [sides[(corner + sides.len() - 1) % sides.len()], sides[corner]].map(class))
        };
        Some(CityBlock { kerb: kerb.rounded(radius), land, face, zone: CityZone::Homes })
    };
    net.faces.iter().filter_map(block).collect()
}

/// The radius of a kerb at a corner of two streets: that of the greater, less where people would have no room before a house at
/// a sharp corner.
fn radius(kerb: &Convex, corner: usize, classes: [StreetClass; 2]) -> f64 {
    let count = kerb.corners().len();
    let [before, at, after] = [count - 1, 0, 1].map(|step| kerb.corners()[(corner + step) % count]);
    let cosine = (before - at).normalize().dot(&(after - at).normalize());
    // By half the corner's angle: the curve goes that far from the corner, and the house's corner lies that far.
    let (sine, square) = (((1.0 - cosine) / 2.0).sqrt(), (1.0 + cosine) / 2.0);
    let pavement = classes[0].pavement().min(classes[1].pavement());
    let room = 2.0 * (pavement - ROOM * sine) / square.max(1e-6);
    classes[0].corner().max(classes[1].corner()).min(room)
}

/// Land without its sharp corners, where houses would hide who comes.
fn chamfered(land: Convex) -> Convex {
    let count = land.corners().len();
    let sides: Vec<(Point, Point, Beyond)> = land.sides().collect();
    (0..count).fold(land, |part, i| {
        let (before, after) = (sides[(i + count - 1) % count], sides[i]);
        let (back, on) = ((before.0 - before.1).normalize(), (after.1 - after.0).normalize());
        let inward = (back + on).normalize();
        let Some((_, depth)) = CHAMFERS.into_iter().find(|(cosine, _)| back.dot(&on) > *cosine) else { return part };
        let longer = if (before.1 - before.0).norm() > (after.1 - after.0).norm() { before } else { after };
        let at = after.0 + inward * depth;
        part.cut(&at, &nalgebra::Vector2::new(inward.y, -inward.x), longer.2).unwrap_or(part)
    })
}

/// Takes from the land of blocks the corners that would hide who comes from drivers who give way.
pub(super) fn clear_views(blocks: &mut [CityBlock], views: &[View]) {
    let middles: Vec<Point> = blocks.iter().map(|block| block.land.middle()).collect();
    let size = |(block, middle): (&CityBlock, &Point)| {
        block.land.corners().iter().map(|corner| (corner - middle).norm()).fold(0.0, f64::max)
    };
    let reach = blocks.iter().zip(&middles).map(size).fold(0.0, f64::max);
    let near = Near::of(&middles);
    for view in views {
        for index in view.near(&near, reach).collect::<Vec<_>>() {
            let land = &blocks[index].land;
            if view.ground.shared(land) <= 0.0 {
                continue;
            }
            // The part beyond the line from the eye, on the side away from the junction.
            let along = (view.target - view.eye).normalize();
            let along = if along.perp(&(view.ground.middle() - view.eye)) < 0.0 { along } else { -along };
            let street =
                land.longest(|beyond| matches!(beyond, Beyond::Street(_))).map_or(Beyond::Neighbour, |side| side.2);
            if let Some(kept) = land.cut(&view.eye, &along, street) {
                blocks[index].land = kept;
            }
        }
    }
}
