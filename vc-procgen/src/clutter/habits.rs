//! Habitual places of objects, from the class table.

use std::borrow::Cow;
use std::collections::HashMap;
use std::sync::LazyLock;

use vc_graph::asset::Hold;
use vc_graph::{Class, ClassTable, Property, PropertySet, Relation};
use vc_shapes::{Generators, object};

use crate::plan::RoomKind;

/// For each class of support or container, the classes habitually kept on and inside it, with their
/// rooms.
#[derive(Clone, Default)]
pub(super) struct Habits {
    kept: HashMap<(Relation, String), Vec<Habit>>,
    affordances: HashMap<&'static str, PropertySet>,
    /// The rooms that habits name.
    rooms: Vec<String>,
}

#[derive(Clone)]
struct Habit {
    class: &'static str,
    /// The only room it applies to, by index among the rooms.
    room: Option<usize>,
    weight: f32,
}

impl Habits {
    /// The habits of the built-in classes that have a generator.
    fn known() -> &'static Self {
        static KNOWN: LazyLock<Habits> = LazyLock::new(|| {
            let (classes, mut habits) = (ClassTable::builtin(), Habits::default());
            let rows = object::generators().filter_map(|g| Some((g.class, classes.get(g.class)?)));
            rows.for_each(|(class, row)| habits.add(class, row));
            habits
        });
        &KNOWN
    }

    /// The habits of the classes that generators make.
    pub(super) fn with(generators: &Generators) -> Cow<'static, Self> {
        let mut habits = Cow::Borrowed(Self::known());
        generators.registered().for_each(|(generator, row)| habits.to_mut().add(generator.class, row));
        habits
    }

    fn add(&mut self, class: &'static str, row: &Class) {
        self.affordances.insert(class, row.affordances);
        if *row.name != *class || !row.affordances.contains(Property::Graspable) {
            return;
        }
        for place in &row.kept {
            let Some((relation, at)) = &place.at else { continue };
            let room = place.room.as_ref().map(|room| self.number(similar(room)));
            let habit = Habit { class, room, weight: place.weight as f32 };
            self.kept.entry((*relation, at.to_string())).or_default().push(habit);
        }
    }

    /// The number of a room.
    fn number(&mut self, room: &str) -> usize {
        self.rooms.iter().position(|known| known == room).unwrap_or_else(|| {
            self.rooms.push(room.to_owned());
            self.rooms.len() - 1
        })
    }

    /// Whether a class is one that objects are put on or in.
    fn holds(&self, carrier: &str, relation: Relation) -> bool {
        let affordances = self.affordances.get(carrier).copied().unwrap_or(PropertySet::EMPTY);
        let needs: &[Property] = match relation {
            Relation::Inside => &[Property::Container, Property::Recipient],
            _ => &[Property::Surface, Property::Sittable, Property::Lieable],
        };
        needs.iter().any(|&p| affordances.contains(p))
    }

    /// The classes kept in a place, with weights.
    pub(super) fn choice(&self, place: &Place) -> Choice {
        let relation = if place.hold == Hold::Inside { Relation::Inside } else { Relation::On };
        let mut choice = Choice::default();
        if !self.holds(place.carrier, relation) {
            return choice;
        }
        let here = self.rooms.iter().position(|r| r == similar(place.room));
        for name in standing_for(place, relation) {
            let habits = self.kept.get(&(relation, (*name).to_owned())).into_iter().flatten();
            let kept = habits.filter(|h| h.room.is_none() || h.room == here);
            kept.for_each(|h| choice.add(h.class, h.weight));
        }
        choice
    }
}

/// A kind of surface on which objects are kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Place {
    pub(super) carrier: &'static str,
    /// Whether it is a drawer of the carrier.
    pub(super) drawer: bool,
    pub(super) hold: Hold,
    /// The class of the room whose habits apply.
    pub(super) room: &'static str,
}

/// Classes to sample by weight.
#[derive(Debug, Default)]
pub(super) struct Choice {
    classes: Vec<&'static str>,
    /// The cumulative weights.
    sums: Vec<f32>,
}

impl Choice {
    fn add(&mut self, class: &'static str, weight: f32) {
        self.classes.push(class);
        self.sums.push(self.sums.last().unwrap_or(&0.0) + weight);
    }

    pub(super) fn is_empty(&self) -> bool {
        self.classes.is_empty()
    }

    /// The class that a number of the unit interval selects.
    pub(super) fn draw(&self, unit: f32) -> Option<&'static str> {
        let drawn = unit * self.sums.last()?;
        self.classes.get(self.sums.partition_point(|&sum| sum <= drawn)).copied()
    }
}

/// The kind of room whose habits a piece brings into a studio's only room.
pub(super) fn studio_corner(carrier: &str) -> &'static str {
    match carrier {
        "kitchen_cabinet"
        | "kitchen_wall_cabinet"
        | "kitchen_island"
        | "kitchen_counter"
        | "fridge"
        | "freezer"
        | "stove"
        | "dishwasher"
        | "microwave" => RoomKind::Kitchen.class(),
        "single_bed" | "double_bed" | "nightstand" | "wardrobe" | "dresser" => RoomKind::Bedroom.class(),
        _ => RoomKind::Living.class(),
    }
}

/// Substitutes a room whose habits are similar.
fn similar(room: &str) -> &str {
    match room {
        "dining_room" | "kitchen_living" | "game_room" => "living_room",
        "garage" | "laundry_room" => "storage_room",
        other => other,
    }
}

/// The classes of the class table that a support or container represents.
fn standing_for(place: &Place, relation: Relation) -> Vec<&'static str> {
    let (room, inside) = (place.room, relation == Relation::Inside);
    match place.carrier {
        "kitchen_cabinet" | "kitchen_island" if !inside => vec!["kitchen_counter"],
        "kitchen_cabinet" | "kitchen_island" if place.drawer => vec!["kitchen_drawer"],
        "kitchen_cabinet" | "kitchen_wall_cabinet" | "kitchen_island" if inside => {
            vec!["kitchen_cabinet", "pantry_cabinet"]
        }
        "kitchen_counter" | "dishwasher" if !inside => vec!["kitchen_counter"],
        "kitchen_sink" => vec![],
        "stove" if inside => vec![],
        "bathroom_vanity" if !inside => vec!["bathroom_counter"],
        "bathroom_vanity" => vec!["under_sink_cabinet", "bathroom_cabinet"],
        "dining_table" if room == "kitchen" => vec!["kitchen_table"],
        "dining_table" => vec!["dining_table"],
        "double_bed" | "single_bed" => vec!["bed"],
        "storage_shelf" | "shelf" if room != "living_room" => vec!["storage_shelf", "garage_shelf", "utility_cabinet"],
        "wall_shelf" => vec!["shelf", "wall_shelf"],
        "low_bookcase" | "bookshelf" if inside && room == "kids_room" => vec!["bookshelf", "toy_box"],
        "low_bookcase" | "bookshelf" if inside => vec!["bookshelf"],
        "low_bookcase" | "bookshelf" => vec!["shelf"],
        "wardrobe" if inside => vec!["wardrobe", "closet"],
        "sideboard" if inside => vec!["sideboard", "china_cabinet"],
        "side_table" => vec!["side_table", "coffee_table"],
        "desk" if inside => vec!["drawer_pedestal"],
        "nightstand" if inside => vec!["drawer_pedestal"],
        "rug" | "bath_mat" | "duvet" => vec![],
        other => vec![other],
    }
}
