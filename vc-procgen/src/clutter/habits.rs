//! What people keep where, from the class table.

use std::collections::HashMap;
use std::sync::LazyLock;

use vc_graph::asset::Hold;
use vc_graph::{ClassTable, Property, PropertySet, Relation};

use crate::object;

/// For each kind of carrier what is kept on and inside it, with the rooms where.
pub(super) struct Habits {
    kept: HashMap<(Relation, String), Vec<Habit>>,
    affordances: HashMap<&'static str, PropertySet>,
    /// Rooms that habits name.
    rooms: Vec<String>,
}

struct Habit {
    class: &'static str,
    /// The only room it is for, by position among the rooms.
    room: Option<usize>,
    weight: f32,
}

impl Habits {
    /// The habits of the built-in classes that have a generator.
    pub(super) fn known() -> &'static Self {
        static KNOWN: LazyLock<Habits> = LazyLock::new(Habits::read);
        &KNOWN
    }

    fn read() -> Self {
        let classes = ClassTable::builtin();
        let mut kept: HashMap<(Relation, String), Vec<Habit>> = HashMap::new();
        let mut rooms: Vec<String> = Vec::new();
        let mut number = |room: &str| {
            rooms.iter().position(|r| r == similar(room)).unwrap_or_else(|| {
                rooms.push(similar(room).to_owned());
                rooms.len() - 1
            })
        };
        for generator in object::generators() {
            let Some(class) = classes.get(generator.class).filter(|c| *c.name == *generator.class) else { continue };
            if !class.affordances.contains(Property::Graspable) {
                continue;
            }
            for place in &class.kept {
                let Some((relation, at)) = &place.at else { continue };
                let room = place.room.as_ref().map(|r| number(r));
                let habit = Habit { class: generator.class, room, weight: place.weight as f32 };
                kept.entry((*relation, at.to_string())).or_default().push(habit);
            }
        }
        let known = object::generators().filter_map(|g| Some((g.class, classes.get(g.class)?.affordances)));
        Self { kept, affordances: known.collect(), rooms }
    }

    /// Whether a class is one that things are put on or in.
    fn holds(&self, carrier: &str, relation: Relation) -> bool {
        let affordances = self.affordances.get(carrier).copied().unwrap_or(PropertySet::EMPTY);
        let needs: &[Property] = match relation {
            Relation::Inside => &[Property::Container, Property::Recipient],
            _ => &[Property::Surface, Property::Sittable, Property::Lieable],
        };
        needs.iter().any(|&p| affordances.contains(p))
    }

    /// What is kept on a surface of a carrier in a room, with weights.
    pub(super) fn of(&self, carrier: &str, surface: &str, hold: Hold, room: &str) -> Vec<(&'static str, f32)> {
        let relation = if hold == Hold::Inside { Relation::Inside } else { Relation::On };
        if !self.holds(carrier, relation) {
            return Vec::new();
        }
        let here = self.rooms.iter().position(|r| r == similar(room));
        let mut found = Vec::new();
        for name in standing_for(carrier, surface, relation, room) {
            let habits = self.kept.get(&(relation, (*name).to_owned())).into_iter().flatten();
            let kept = habits.filter(|h| h.room.is_none() || h.room == here);
            found.extend(kept.map(|h| (h.class, h.weight)));
        }
        found
    }
}

/// Rooms that do for each other.
fn similar(room: &str) -> &str {
    match room {
        "dining_room" | "kitchen_living" | "game_room" => "living_room",
        "garage" | "laundry_room" => "storage_room",
        other => other,
    }
}

/// The classes of the table that a carrier stands for.
fn standing_for<'a>(carrier: &'a str, surface: &str, relation: Relation, room: &str) -> Vec<&'a str> {
    let inside = relation == Relation::Inside;
    match carrier {
        "kitchen_cabinet" | "kitchen_island" if !inside => vec!["kitchen_counter"],
        "kitchen_cabinet" | "kitchen_island" if surface.starts_with("drawer") => vec!["kitchen_drawer"],
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
