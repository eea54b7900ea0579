//! Convex collision pieces for physics.

use std::collections::HashMap;
use std::panic::catch_unwind;

use nalgebra::{Point3, Vector3};
use parry3d::math::Vector;
use parry3d::transformation::vhacd::{VHACD, VHACDParameters};
use vc_graph::asset::{Part, Shape};

/// The number of corners up to which a piece keeps all of them; of more, at most 98 are left.
const CORNERS: usize = 64;
/// The share of its hull that a connected part must fill to count as convex.
const FULL: f32 = 0.97;
/// Half the thickness given to flat parts, metres.
const THIN: f64 = 0.0005;

/// Triangles and the points they use.
#[derive(Clone, Default)]
struct Soup {
    points: Vec<Point3<f32>>,
    triangles: Vec<[u32; 3]>,
}

/// The convex pieces of the parts, at most `most` for each group of parts that move together.
pub(super) fn pieces(parts: &[Part], most: usize) -> Vec<Part> {
    let mut links: Vec<Vec<&Part>> = Vec::new();
    for part in parts {
        match links.iter_mut().find(|link| link[0].joint == part.joint) {
            Some(link) => link.push(part),
            None => links.push(vec![part]),
        }
    }
    if most == 0 { Vec::new() } else { links.iter().flat_map(|link| link_pieces(link, most)).collect() }
}

fn link_pieces(parts: &[&Part], most: usize) -> Vec<Part> {
    let soups = || parts.iter().flat_map(|part| components(part).into_iter().map(move |soup| (*part, soup)));
    let apart: Vec<(&Part, Soup)> = soups().take(most + 1).collect();
    if apart.len() > most {
        let mut whole = Soup::default();
        soups().for_each(|(_, soup)| whole.append(&soup));
        return named(parts[0], decomposed(&whole, most));
    }
    let hulls: Vec<_> = apart.iter().map(|(_, soup)| whole_hull(soup)).collect();
    let hollow = hulls.iter().filter(|h| h.is_none()).count();
    let share = (most + hollow - apart.len()) / hollow.max(1);
    let pieces = apart
        .iter()
        .zip(hulls)
        .flat_map(|((part, soup), hull)| named(part, hull.map_or_else(|| decomposed(soup, share), |hull| vec![hull])));
    pieces.collect()
}

fn named(part: &Part, hulls: Vec<Vec<Point3<f32>>>) -> Vec<Part> {
    let piece = |points| Part { shape: Shape::Hull { points }, ..part.clone() };
    hulls.into_iter().filter(|points| !points.is_empty()).map(piece).collect()
}

impl Soup {
    fn append(&mut self, other: &Self) {
        let first = self.points.len() as u32;
        self.points.extend(&other.points);
        self.triangles.extend(other.triangles.iter().map(|t| t.map(|v| v + first)));
    }
}

/// The connected components of a mesh.
fn components(part: &Part) -> Vec<Soup> {
    let Shape::Mesh { vertices, triangles, .. } = &part.shape else { return Vec::new() };
    let mut leader: Vec<usize> = (0..vertices.len()).collect();
    fn find(leader: &mut [usize], mut v: usize) -> usize {
        while leader[v] != v {
            leader[v] = leader[leader[v]];
            v = leader[v];
        }
        v
    }
    for &[a, b, c] in triangles {
        for other in [b, c] {
            let (x, y) = (find(&mut leader, a as usize), find(&mut leader, other as usize));
            leader[x.max(y)] = x.min(y);
        }
    }
    let mut soups: Vec<Soup> = Vec::new();
    let mut numbers = HashMap::new();
    let mut moved = HashMap::new();
    for triangle in triangles {
        let root = find(&mut leader, triangle[0] as usize);
        let number = *numbers.entry(root).or_insert_with(|| {
            soups.push(Soup::default());
            soups.len() - 1
        });
        let soup = &mut soups[number];
        let corners = triangle.map(|v| {
            *moved.entry(v).or_insert_with(|| {
                soup.points.push(vertices[v as usize]);
                soup.points.len() as u32 - 1
            })
        });
        soup.triangles.push(corners);
    }
    soups
}

/// The hull of a component that is convex or flat; `None` if it is neither, empty if it is a line.
fn whole_hull(soup: &Soup) -> Option<Vec<Point3<f32>>> {
    let Some(hull) = hull(&soup.points) else { return Some(hull(&thickened(soup)).unwrap_or_default()) };
    let own =
        Shape::Mesh { vertices: soup.points.clone(), triangles: soup.triangles.clone(), uvs: Vec::new() }.mesh(0.0);
    let around = Shape::Hull { points: hull.clone() }.mesh(0.0);
    (own.is_closed() && own.volume() >= FULL * around.volume()).then_some(hull)
}

/// The corners of the convex hull, limited in number; `None` if it has no volume.
fn hull(points: &[Point3<f32>]) -> Option<Vec<Point3<f32>>> {
    let corners = |points: &[Point3<f32>]| {
        let mut all = Shape::Hull { points: points.to_vec() }.mesh(0.0).positions;
        all.sort_unstable_by(|a, b| {
            a.coords.as_slice().partial_cmp(b.coords.as_slice()).unwrap_or(std::cmp::Ordering::Equal)
        });
        all.dedup();
        (!all.is_empty()).then_some(all)
    };
    let all = corners(points)?;
    if all.len() <= CORNERS { Some(all) } else { corners(&extremes(&all)).or(Some(all)) }
}

/// The farthest points in 98 directions.
fn extremes(points: &[Point3<f32>]) -> Vec<Point3<f32>> {
    let steps = || -2i8..=2;
    let directions = steps().flat_map(|x| steps().flat_map(move |y| steps().map(move |z| [x, y, z])));
    let primitive = |d: &[i8; 3]| d.iter().any(|v| v % 2 != 0);
    let far = |d: [i8; 3]| {
        let direction = Vector3::from(d.map(f32::from));
        points.iter().copied().reduce(|a, b| if b.coords.dot(&direction) > a.coords.dot(&direction) { b } else { a })
    };
    directions.filter(primitive).filter_map(far).collect()
}

/// The points of a flat component, offset to both sides.
fn thickened(soup: &Soup) -> Vec<Point3<f32>> {
    let at = |v: u32| soup.points[v as usize].cast::<f64>();
    let normal = |&[a, b, c]: &[u32; 3]| (at(b) - at(a)).cross(&(at(c) - at(a)));
    let widest = soup.triangles.iter().map(normal).reduce(|a, b| if b.norm() > a.norm() { b } else { a });
    let Some(up) = widest.and_then(|n| n.try_normalize(0.0)) else { return Vec::new() };
    let shifted =
        |sign: f64| soup.points.iter().map(move |p| Point3::from(p.cast().coords + up * (sign * THIN)).cast());
    shifted(-1.0).chain(shifted(1.0)).collect()
}

/// At most `most` convex pieces of a hollow component; one if `most` is below four.
fn decomposed(soup: &Soup, most: usize) -> Vec<Vec<Point3<f32>>> {
    let whole = || hull(&soup.points).into_iter().collect();
    let (Some(low), Some(high)) =
        (soup.points.iter().copied().reduce(|a, b| a.inf(&b)), soup.points.iter().copied().reduce(|a, b| a.sup(&b)))
    else {
        return Vec::new();
    };
    let size = (high - low).max();
    // V-HACD halves until it has twice the requested number of pieces, rounded up to a power of
    // two.
    let asked = (most / 2 + 1).next_power_of_two() / 2;
    if asked < 2 || size <= 0.0 {
        return whole();
    }
    // Scaled to a cube of size one, for which V-HACD's tolerances are meant.
    let inside = |p: &Point3<f32>| (p - low) / size;
    let points: Vec<Vector> = soup.points.iter().map(inside).map(|v| Vector::new(v.x, v.y, v.z)).collect();
    let parameters = VHACDParameters { max_convex_hulls: asked as u32, ..VHACDParameters::default() };
    // For some sets of voxels parry3d 0.31 finds no hull and panics; then a single piece is used.
    let parts = catch_unwind(|| {
        let parts = VHACD::decompose(&parameters, &points, &soup.triangles, true);
        parts.compute_exact_convex_hulls(&points, &soup.triangles)
    });
    let Ok(found) = parts.map(IntoIterator::into_iter) else { return whole() };
    let back = |p: &Vector| low + Vector3::new(p.x, p.y, p.z) * size;
    let hulls: Vec<_> = found.filter_map(|(points, _)| hull(&points.iter().map(back).collect::<Vec<_>>())).collect();
    if hulls.is_empty() { whole() } else { hulls }
}
