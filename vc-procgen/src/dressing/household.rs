//! The household that lives in a home: what it has and is, by which rules apply to it.

use vc_graph::Seed;
use vc_shapes::Style;
use vc_shapes::material::*;

use super::Dressing;
use super::rule::{Rule, bit};
use crate::plan::{FloorPlan, RoomKind, Scheme};

/// The traits that are known without a line of a table.
pub(super) const KNOWN: [&str; 7] = ["child", "studio", "nordic", "modern", "classic", "country", "midcentury"];

/// The place of `studio` among them.
const STUDIO: usize = 1;

/// A table with the traits of one household.
#[derive(Debug, Clone)]
pub(crate) struct Household {
    dressing: Dressing,
    traits: u64,
    seed: Seed,
}

impl Household {
    /// Draws the household that lives in a plan; the same for all attempts of a seed.
    pub(crate) fn draw(dressing: &Dressing, plan: &FloorPlan, style: &Style, seed: Seed) -> Self {
        let seed = seed.child("household");
        let child = plan.rooms.iter().any(|room| room.kind == RoomKind::Kids);
        let studio = plan.scheme == Scheme::Studio;
        let known = [("child", child), ("studio", studio), (manner(style), true)];
        let mut traits = 0;
        for (name, _) in known.into_iter().filter(|(_, has)| *has) {
            traits |= KNOWN.iter().position(|known| *known == name).map_or(0, |at| 1 << at);
        }
        for (index, row) in dressing.0.traits.iter().enumerate() {
            let has = row.when.holds(traits) && seed.child(&row.name).stream().chance(row.chance);
            traits |= u64::from(has) << (KNOWN.len() + index);
        }
        Self { dressing: dressing.clone(), traits, seed }
    }

    /// The rules that apply to a room, each with a seed of its own.
    pub(crate) fn rules(&self, room: usize, kind: RoomKind) -> impl Iterator<Item = (&Rule, Seed)> {
        let seed = self.seed.nth(room as u64);
        let one_room = kind == RoomKind::Living && self.traits & 1 << STUDIO != 0;
        let kinds: &[RoomKind] = match (one_room, &kind) {
            (true, _) => &[RoomKind::Living, RoomKind::Kitchen, RoomKind::Bedroom],
            (false, kind) => std::slice::from_ref(kind),
        };
        let bits = kinds.iter().fold(0, |all, kind| all | bit(*kind));
        let rules = self.dressing.0.rules.iter();
        rules.filter(move |rule| rule.rooms & bits != 0 && self.is_met(rule)).map(move |rule| (rule, rule.seed(seed)))
    }

    /// Whether the household has the traits that a rule needs.
    pub(crate) fn is_met(&self, rule: &Rule) -> bool {
        rule.when.holds(self.traits)
    }
}

/// The manner of a style: the one of its palettes that its wood belongs to.
fn manner(style: &Style) -> &'static str {
    match style.wood {
        GREY_OAK | WENGE => "modern",
        CHERRY | MAHOGANY => "classic",
        PINE | MAPLE => "country",
        TEAK | WALNUT => "midcentury",
        _ => "nordic",
    }
}
