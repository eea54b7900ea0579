//! The numbers of objects of each kind in the thesis (its Appendix C).

use std::collections::{BTreeMap, HashSet};

use vc_graph::{ClassTable, Property};
use vc_shapes::object::{Realm, generator, generators};

/// The number of objects, and their classes including subclasses; `in` restricts them to indoor
/// classes.
const LISTED: &[(usize, &str)] = &[
    (50, "in chair"),
    (8, "stool"),
    (86, "in table"),
    (37, "dining_table"),
    (15, "high_table"),
    (33, "low_table coffee_table"),
    (2, "printer"),
    (2, "audio_amplifier"),
    (9, "camera"),
    (10, "computer laptop tablet"),
    (1, "drone"),
    (1, "dvd_player"),
    (2, "graphic_tablet"),
    (3, "headset earphone"),
    (2, "microphone"),
    (3, "keyboard"),
    (4, "mouse"),
    (7, "speaker"),
    (10, "television monitor"),
    (1, "softbox"),
    (2, "tripod"),
    (1, "turntable"),
    (1, "virtual_headset"),
    (2, "webcam"),
    (44, "bookshelf"),
    (
        58,
        "bathroom_cabinet bathroom_vanity bathroom_shelf medicine_cabinet towel_cabinet \
         under_sink_cabinet towel_rack laundry_hamper shower_caddy linen_cabinet",
    ),
    (
        47,
        "kitchen_rack prep_table commercial_fridge blast_chiller ice_machine refrigerated_counter \
         steam_oven deep_fryer griddle bain_marie plate_warmer meat_slicer commercial_dishwasher \
         plate_rack_cart gastronorm_pan hot_plate vacuum_sealer stand_mixer",
    ),
    (17, "sport_machine"),
    (72, "sports_gear"),
    (2, "air_hockey_table"),
    (3, "arcade_machine pinball_machine claw_machine"),
    (2, "foosball_table"),
    (1, "console"),
    (2, "controller"),
    (1, "dartboard"),
    (1, "hoverboard"),
    (4, "joystick"),
    (1, "jukebox"),
    (2, "ping_pong_table"),
    (4, "pool_table"),
    (4, "stroller"),
    (
        49,
        "swing swing_set slide sandbox trampoline seesaw climbing_frame monkey_bars play_tower playhouse \
         tree_house spring_rider playground_carousel bouncy_castle mud_kitchen water_play_table \
         rope_ladder zip_line play_tunnel croquet_set balance_bike tricycle",
    ),
    (39, "in toy"),
    (24, "decoration"),
    (52, "book"),
    (10, "candle"),
    (6, "frame"),
    (40, "kitchen_utensil cookware dish cutlery"),
    (10, "mirror"),
    (11, "vase"),
    (4, "campfire"),
    (3, "firewood"),
    (1, "pizza_oven"),
    (3, "barbecue"),
    (4, "buoy"),
    (2, "carport"),
    (1, "composter"),
    (1, "diving_board"),
    (5, "bird_bath bird_feeder bird_house garden_gnome fountain garden_statue garden_lantern wind_chime"),
    (3, "garden_hose"),
    (3, "garden_shed"),
    (2, "garden_storage_box"),
    (1, "gas_tank"),
    (3, "jacuzzi"),
    (1, "kennel"),
    (2, "ladder"),
    (3, "lawnmower"),
    (6, "pool"),
    (1, "pool_goal"),
    (1, "pool_volleyball"),
    (1, "solar_shower"),
    (2, "watering_can"),
    (1, "wheelbarrow"),
    (24, "garden_chair deck_chair"),
    (20, "garden_sofa"),
    (27, "garden_table"),
    (97, "food"),
];

/// The number of drivable classes in the thesis.
const DRIVABLE: usize = 13;

/// The kinds of which there are fewer than in the thesis.
pub(crate) fn missing(shapes: &BTreeMap<&str, HashSet<u64>>) -> Vec<String> {
    let table = ClassTable::builtin();
    let mut missing = Vec::new();
    for &(count, names) in LISTED {
        let realm = names.strip_prefix("in ").map(|_| Realm::Indoor);
        let names = names.strip_prefix("in ").unwrap_or(names);
        let fits = |class: &str| {
            let there = realm.is_none_or(|r| generator(class).is_some_and(|g| g.realm == r));
            there && names.split(' ').any(|name| table.is_a(class, name))
        };
        let found: usize = shapes.iter().filter(|(class, _)| fits(class)).map(|(_, keys)| keys.len()).sum();
        if found < count {
            missing.push(format!("{names}: {found} shapes, the thesis has {count}"));
        }
    }
    let drivable = |class: &str| table.get(class).is_some_and(|c| c.affordances.contains(Property::Drivable));
    let vehicles = generators().filter(|g| drivable(g.class)).count();
    missing.extend((vehicles < DRIVABLE).then(|| format!("{vehicles} drivable classes, the thesis has {DRIVABLE}")));
    missing
}
