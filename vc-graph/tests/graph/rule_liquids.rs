//! Pouring, filling, cooking, cutting, folding: changes of objects.
#![allow(clippy::unwrap_used)]

use vc_graph::{Relation, State};
use vc_testkit::flat::{Flat, plain};

fn contents(flat: &Flat, name: &str) -> Option<String> {
    flat.graph().node(flat.id(name)).unwrap().contents().map(ToString::to_string)
}

#[test]
fn what_is_poured_fills_the_vessel() {
    let mut flat = Flat::after(&["walk fridge", "open fridge", "grab milk", "walk cup", "pour milk cup"]);
    assert_eq!(contents(&flat, "cup").as_deref(), Some("milk"));
    assert!(flat.is("cup", State::Filled) && flat.has("milk", Relation::PouredInto, "cup"));
    assert!(flat.has("me", Relation::HoldsRight, "milk"), "the carton stays in the hand");
    flat.all(&["grab cup", "drink cup", "walk frying_pan", "pour cup frying_pan"]);
    assert_eq!((contents(&flat, "cup"), contents(&flat, "frying_pan").as_deref()), (None, Some("milk")));
    assert!(flat.is("cup", State::Empty));
    assert!(
        plain(&flat.step("pour cup sink").unwrap_err()).contains("cup is not pourable") || flat.is("cup", State::Empty)
    );
}

#[test]
fn water_itself_leaves_the_hand() {
    let flat = Flat::after(&["walk water", "grab water", "walk cup", "pour water cup"]);
    assert!(flat.graph().held(flat.me).next().is_none() && flat.has("water", Relation::Inside, "cup"));
    assert_eq!(contents(&flat, "cup").as_deref(), Some("water"));
    assert_eq!(flat.graph().validate(), []);
}

#[test]
fn water_on_a_sponge_leaves_a_sound_scene() {
    let flat = Flat::after(&["walk water", "grab water", "walk sponge", "pour water sponge"]);
    assert_eq!(flat.graph().validate(), []);
}

#[test]
fn a_vessel_is_not_poured_into_itself() {
    let mut flat = Flat::after(&["walk cup", "grab cup", "walk faucet", "switch_on faucet", "fill cup faucet"]);
    assert_eq!(contents(&flat, "cup").as_deref(), Some("water"));
    let refused = flat.step("pour cup cup").is_err();
    assert!(refused || contents(&flat, "cup").is_some(), "it is not emptied by it");
    assert!(!flat.has("cup", Relation::PouredInto, "cup"));
}

#[test]
fn cooking_needs_heat_and_makes_hot() {
    let mut flat = Flat::after(&["walk potato", "grab potato", "walk stove", "place potato frying_pan"]);
    assert!(flat.step("cook potato").is_err() && flat.is("potato", State::Raw));
    flat.all(&["switch_on stove", "cook potato"]);
    assert!(flat.is("potato", State::Cooked) && flat.is("potato", State::Hot) && !flat.is("potato", State::Raw));
}

#[test]
fn what_is_in_a_vessel_gets_hot_and_cold_with_it() {
    let mut flat = Flat::after(&["walk potato", "grab potato", "walk stove", "put_in potato frying_pan"]);
    flat.all(&["switch_on stove", "heat frying_pan"]);
    assert!(flat.is("frying_pan", State::Hot) && flat.is("potato", State::Hot));
    assert!(!flat.is("potato", State::Cooked) && !flat.is("stove", State::Hot));
    flat.all(&["walk fridge", "open fridge", "walk frying_pan", "grab frying_pan", "walk fridge"]);
    flat.all(&["put_in frying_pan fridge", "close fridge", "switch_on fridge", "cool frying_pan"]);
    assert!(flat.is("potato", State::Cold) && !flat.is("potato", State::Hot) && flat.is("frying_pan", State::Cold));
    assert!(!flat.is("milk", State::Cold), "it was not named");
}

#[test]
fn a_cooler_cools_what_is_inside_it() {
    let mut flat = Flat::new();
    let (fridge, cup) = (flat.id("fridge"), flat.id("cup"));
    flat.edit(|edit| {
        edit.place(cup, vc_graph::Place { relation: Relation::On, at: fridge }).unwrap();
        edit.enter_state(fridge, State::On).unwrap();
    });
    flat.all(&["walk fridge", "cool milk"]);
    assert_eq!(plain(&flat.step("cool cup").unwrap_err()), "cup is not in anything that cools and runs");
}

#[test]
fn cutting_needs_a_knife_and_a_hand() {
    let mut flat = Flat::after(&["walk kitchen_table", "grab knife", "grab cup"]);
    assert_eq!(plain(&flat.step("cut bread").unwrap_err()), "character has no free hand: put something down first");
    flat.all(&["place cup kitchen_table", "cut bread"]);
    assert!(flat.is("bread", State::Sliced));
}

#[test]
fn cleaning_cleans_and_folding_folds() {
    let mut flat = Flat::new();
    let (plate, towel) = (flat.id("plate"), flat.id("towel"));
    for verb in ["wash", "rinse", "scrub"] {
        flat.edit(|edit| edit.enter_state(plate, State::Dirty).unwrap());
        flat.all(&["walk plate", &format!("{verb} plate")]);
        assert!(flat.is("plate", State::Clean) && !flat.is("plate", State::Dirty), "{verb}");
    }
    flat.all(&["walk towel", "open wardrobe", "unfold towel"]);
    assert!(flat.graph().node(towel).unwrap().is(State::Unfolded));
    flat.all(&["fold towel"]);
    assert!(flat.is("towel", State::Folded));
}
