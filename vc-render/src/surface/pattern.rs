//! Procedural textures of materials.

use vc_graph::asset::Material;
use vc_graph::portable::Portable;

use super::Role;
use super::matter::Matter;
use super::noise::{cells, hash, octaves, value};

/// A kind of procedural texture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Pattern {
    Plain,
    Grain,
    Boards,
    Weave,
    Leather,
    Tiles,
    Bricks,
    Speckle,
    Marble,
    Rough,
    Brushed,
    Paper,
    Wall,
}

/// The texture at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sample {
    /// Factor for the colour.
    pub(super) tint: [f32; 3],
    /// Factor for the roughness.
    pub(super) roughness: f32,
    /// Height above the surface, as a share of the tile's side.
    pub(super) height: f32,
}

impl Pattern {
    pub(crate) const ALL: [Self; 13] = [
        Self::Plain,
        Self::Grain,
        Self::Boards,
        Self::Weave,
        Self::Leather,
        Self::Tiles,
        Self::Bricks,
        Self::Speckle,
        Self::Marble,
        Self::Rough,
        Self::Brushed,
        Self::Paper,
        Self::Wall,
    ];

    /// The pattern that suits a material.
    pub(crate) fn from_material(material: &Material, role: Role) -> Self {
        match Matter::from_name(&material.name) {
            _ if material.transmission > 0.3 => Self::Plain,
            Some(Matter::Smooth) => Self::Plain,
            Some(Matter::Wood) if role == Role::Floor => Self::Boards,
            Some(Matter::Wood | Matter::Bark) => Self::Grain,
            Some(Matter::Leather) => Self::Leather,
            Some(Matter::Textile) => Self::Weave,
            Some(Matter::Brick) => Self::Bricks,
            Some(Matter::Tile) => Self::Tiles,
            Some(Matter::Granular) => Self::Speckle,
            Some(Matter::Marble) => Self::Marble,
            Some(Matter::WallPaint) => Self::Wall,
            Some(Matter::Mineral) => Self::Rough,
            _ if material.metallic > 0.5 && material.roughness > 0.15 => Self::Brushed,
            Some(Matter::Paper) => Self::Paper,
            None => Self::Plain,
        }
    }

    /// Side of a tile, metres.
    pub(crate) fn side(self) -> f32 {
        match self {
            Self::Boards => 2.4,
            Self::Grain | Self::Marble => 1.2,
            Self::Weave => 0.06,
            Self::Leather => 0.15,
            Self::Tiles => 1.2,
            Self::Bricks => 1.0,
            Self::Speckle | Self::Brushed | Self::Paper => 0.4,
            Self::Rough | Self::Wall => 1.5,
            Self::Plain => 1.0,
        }
    }

    /// Texels along a side of a tile: a power of two.
    pub(super) fn texels(self) -> usize {
        match self {
            Self::Plain => 4,
            Self::Boards => 1024,
            Self::Grain | Self::Tiles | Self::Bricks | Self::Marble => 512,
            _ => 256,
        }
    }

    /// The texture at a point of the tile, coordinates 0 to 1; fibres run along `v`.
    pub(super) fn sample(self, u: f32, v: f32) -> Sample {
        match self {
            Self::Plain => even(1.0, 1.0, 0.0),
            Self::Grain => grain(u, v, 1),
            Self::Boards => boards(u, v),
            Self::Weave => weave(u, v),
            Self::Leather => leather(u, v),
            Self::Tiles => tiles(u, v),
            Self::Bricks => bricks(u, v),
            Self::Speckle => speckle(u, v),
            Self::Marble => marble(u, v),
            Self::Rough => rough(u, v, 0.22),
            Self::Brushed => brushed(u, v),
            Self::Paper => even(0.97 + 0.05 * octaves(u, v, (32, 32), 3, 91), 1.0, 0.0004 * value(u, v, (64, 64), 93)),
            Self::Wall => wall(u, v),
        }
    }
}

fn even(brightness: f32, roughness: f32, height: f32) -> Sample {
    Sample { tint: [brightness; 3], roughness, height }
}

/// A wood colour: darker wood is redder.
fn wood(brightness: f32, roughness: f32, height: f32) -> Sample {
    let dark = (1.0 - brightness).max(-0.3);
    Sample { tint: [brightness + 0.18 * dark, brightness, brightness - 0.12 * dark], roughness, height }
}

fn grain(u: f32, v: f32, seed: u32) -> Sample {
    let bend = octaves(u, v, (3, 1), 3, seed * 31);
    let rings = (std::f32::consts::TAU * (6.0 * u + 5.0 * bend)).sine();
    let fibres = octaves(u, v, (96, 3), 3, seed * 31 + 7);
    let pores = (value(u, v, (220, 10), seed * 31 + 13) - 0.72).max(0.0) * 1.6;
    let broad = value(u, v, (4, 2), seed * 31 + 19);
    let brightness = 0.82 + 0.09 * rings + 0.24 * (fibres - 0.5) + 0.16 * broad - 0.5 * pores;
    wood(brightness, 1.0 + 0.5 * pores - 0.2 * (fibres - 0.5), 0.0006 * fibres - 0.0012 * pores)
}

/// Boards twelve centimetres wide, two along a tile.
fn boards(u: f32, v: f32) -> Sample {
    const ACROSS: i32 = 20;
    let column = ((u * ACROSS as f32) as i32).min(ACROSS - 1);
    let shifted = (v + hash(column, 0, 3)).fract();
    let row = (shifted * 2.0) as i32;
    let (inner, along) = ((u * ACROSS as f32).fract(), (shifted * 2.0).fract());
    let tone = hash(column, row, 5);
    let at = grain((inner / ACROSS as f32 * 2.0 + tone) * 1.0, v + 0.37 * tone, 2);
    let edge = (inner.min(1.0 - inner) * 0.12).min(along.min(1.0 - along) * 1.2);
    let seam = (1.0 - edge / 0.0022).clamp(0.0, 1.0);
    let brightness = (at.tint[1] * (0.84 + 0.28 * tone)) * (1.0 - 0.6 * seam);
    wood(brightness, at.roughness + 0.8 * seam, at.height * 0.4 - 0.0006 * seam)
}

fn weave(u: f32, v: f32) -> Sample {
    const THREADS: f32 = 24.0;
    let (x, y) = (u * THREADS, v * THREADS);
    let over = ((x as i32) + (y as i32)) % 2 == 0;
    let bump = |t: f32| (std::f32::consts::PI * t.fract()).sine();
    let (along, across) = if over { (bump(x), bump(y)) } else { (bump(y), bump(x)) };
    let height = 0.35 + 0.65 * along * (0.6 + 0.4 * across);
    let yarn = octaves(u, v, (24, 24), 2, 41);
    let broad = value(u, v, (3, 3), 47);
    even(0.72 + 0.3 * height + 0.16 * (yarn - 0.5) + 0.05 * broad, 1.0, 0.012 * height)
}

fn leather(u: f32, v: f32) -> Sample {
    let (near, second) = cells(u, v, 40, 51);
    let ridge = (second - near).min(0.35) / 0.35;
    let broad = octaves(u, v, (3, 3), 3, 57);
    even(0.78 + 0.16 * ridge + 0.16 * broad, 1.15 - 0.3 * ridge, 0.006 * ridge)
}

/// Four by four tiles, thirty centimetres each.
fn tiles(u: f32, v: f32) -> Sample {
    let (x, y) = (u * 4.0, v * 4.0);
    let edge = [x.fract(), y.fract()].map(|t| t.min(1.0 - t) * 0.3);
    let edge = edge[0].min(edge[1]);
    let joint = (1.0 - (edge - 0.001) / 0.0015).clamp(0.0, 1.0);
    let tone = hash(x as i32, y as i32, 61);
    let glaze = octaves(u, v, (12, 12), 3, 67);
    let brightness = (0.93 + 0.07 * tone + 0.06 * (glaze - 0.5)) * (1.0 - 0.42 * joint);
    even(brightness, 1.0 + 4.0 * joint, -0.0014 * joint + 0.00015 * glaze)
}

/// Bricks of 25 by 7 centimetres, in courses.
fn bricks(u: f32, v: f32) -> Sample {
    let row = (v * 14.0) as i32;
    let x = u * 4.0 + 0.5 * (row % 2) as f32;
    let edge = (x.fract().min(1.0 - x.fract()) * 0.25).min((v * 14.0).fract().min(1.0 - (v * 14.0).fract()) * 0.071);
    let joint = (1.0 - (edge - 0.003) / 0.003).clamp(0.0, 1.0);
    let tone = hash((x as i32).rem_euclid(4), row, 71);
    let pits = octaves(u, v, (40, 40), 3, 73);
    let brick = 0.75 + 0.35 * tone + 0.3 * (pits - 0.5);
    let mix = |b: f32, m: f32| b + (m - b) * joint;
    Sample {
        tint: [mix(brick, 1.05), mix(brick * 0.97, 1.5), mix(brick * 0.95, 1.7)],
        roughness: 1.2,
        height: -0.006 * joint + 0.002 * pits,
    }
}

fn speckle(u: f32, v: f32) -> Sample {
    let (near, _) = cells(u, v, 36, 81);
    let (fine, _) = cells(u, v, 90, 83);
    let cloud = octaves(u, v, (4, 4), 3, 87);
    even(0.72 + 0.35 * near.min(1.0) + 0.3 * (fine.min(1.0) - 0.5) + 0.2 * (cloud - 0.5), 1.0, 0.0)
}

fn marble(u: f32, v: f32) -> Sample {
    let bend = octaves(u, v, (3, 3), 5, 101);
    let vein = 1.0 - (std::f32::consts::TAU * (2.0 * u + 1.0 * v + 1.8 * bend)).sine().abs();
    let fine = octaves(u, v, (10, 10), 3, 107);
    even(1.04 - 0.5 * vein.raised(6) - 0.12 * fine, 0.6, 0.0)
}

fn rough(u: f32, v: f32, strength: f32) -> Sample {
    let cloud = octaves(u, v, (3, 3), 6, 111);
    let pits = octaves(u, v, (60, 60), 2, 117);
    even(1.0 + strength * (cloud - 0.5) * 2.0 - 0.1 * (0.4 - pits).max(0.0), 1.0, 0.002 * pits + 0.003 * cloud)
}

/// Paint applied with a roller.
fn wall(u: f32, v: f32) -> Sample {
    let cloud = octaves(u, v, (2, 2), 4, 121);
    let peel = octaves(u, v, (90, 90), 2, 127);
    even(0.985 + 0.03 * (cloud - 0.5) + 0.02 * (peel - 0.5), 1.0, 0.0009 * peel)
}

fn brushed(u: f32, v: f32) -> Sample {
    let lines = octaves(u, v, (160, 2), 2, 131);
    even(0.95 + 0.1 * lines, 0.85 + 0.5 * (lines - 0.5), 0.0002 * lines)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_go_by_how_words_begin() {
        let of = |name: &str, role: Role| Pattern::from_material(&crate::common::material(name, [0.5; 3]), role);
        let cases = [
            ("ash", Pattern::Grain),
            ("washed_linen", Pattern::Weave),
            ("cash_green", Pattern::Plain),
            ("red_brick", Pattern::Bricks),
            ("sandstone", Pattern::Rough),
            ("birch_plywood", Pattern::Grain),
        ];
        for (name, pattern) in cases {
            assert_eq!(of(name, Role::Plain), pattern, "{name}");
        }
        assert_eq!(of("oak", Role::Floor), Pattern::Boards);
    }
}
