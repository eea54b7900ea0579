//! People and objects: hands, seats, trays, vehicles.
#![allow(clippy::unwrap_used)]

use vc_graph::{Place, Relation, State, Verb};
use vc_testkit::flat::{Flat, plain};

fn why(flat: &mut Flat, action: &str) -> String {
    let (who, text) = action.strip_prefix("other ").map_or((flat.me, action), |rest| (flat.other, rest));
    let wanted = flat.action(text);
    plain(&flat.sim.step(who, &wanted).expect_err(action))
}

#[test]
fn two_hands_hold_two_things() {
    let mut flat = Flat::after(&["walk kitchen_table", "grab cup", "grab knife"]);
    assert!(flat.has("me", Relation::HoldsRight, "cup") && flat.has("me", Relation::HoldsLeft, "knife"));
    assert_eq!(why(&mut flat, "grab plate"), "character has no free hand: put something down first");
    assert_eq!(why(&mut flat, "grab tray"), "character has no free hand: put something down first");
    flat.all(&["place cup tray", "grab plate"]);
    assert!(flat.has("me", Relation::HoldsRight, "plate") && flat.has("cup", Relation::On, "tray"));
}

#[test]
fn a_tray_carries_what_is_on_it_to_another_room() {
    let mut flat =
        Flat::after(&["walk kitchen_table", "grab plate", "place plate tray", "grab tray", "walk coffee_table"]);
    let living_room = flat.id("living_room");
    for thing in ["tray", "plate", "bread"] {
        assert_eq!(flat.graph().room_of(flat.id(thing)), Some(living_room), "{thing}");
    }
    flat.all(&["grab bread", "place tray coffee_table"]);
    assert_eq!(flat.graph().support_chain(flat.id("plate")), [flat.id("tray"), flat.id("coffee_table")]);
    assert_eq!(flat.graph().validate(), []);
}

#[test]
fn nothing_is_taken_from_anothers_hand() {
    let mut flat = Flat::after(&["other walk cup", "other grab cup", "walk cup"]);
    assert_eq!(why(&mut flat, "grab cup"), "character holds cup");
    assert!(flat.has("other", Relation::HoldsRight, "cup"));
    flat.all(&["other place cup kitchen_table", "grab cup"]);
    assert!(flat.has("me", Relation::HoldsRight, "cup"));
}

#[test]
fn clothes_are_not_taken_off_others() {
    let mut flat = Flat::after(&["other walk wardrobe", "other open wardrobe", "other grab shirt", "other wear shirt"]);
    flat.all(&["walk other"]);
    assert!(flat.step("take_off shirt").is_err());
    assert!(flat.step("grab shirt").is_err(), "somebody wears it");
}

#[test]
fn a_sofa_seats_three() {
    let mut flat = Flat::after(&["walk sofa", "sit sofa", "other walk sofa", "other sit sofa"]);
    assert_eq!(flat.graph().validate(), []);
    let mut one_seat = Flat::after(&["walk chair", "other walk chair", "other sit chair"]);
    assert_eq!(why(&mut one_seat, "sit chair"), "all 1 places on chair are taken");
    flat.all(&["lie sofa", "stand", "other lie sofa"]);
    flat.all(&["find sofa"]);
    assert_eq!(why(&mut flat, "lie sofa"), "all 1 places on sofa are taken");
}

#[test]
fn nobody_carries_what_he_rests_on() {
    let mut flat = Flat::new();
    let (me, tray) = (flat.me, flat.id("tray"));
    flat.edit(|edit| edit.place(me, Place { relation: Relation::On, at: tray }).unwrap());
    assert!(why(&mut flat, "grab tray").contains("one rests on tray oneself"));
}

#[test]
fn a_seat_in_hand_is_not_sat_on() {
    let mut flat = Flat::after(&["walk book", "grab book"]);
    assert_eq!(why(&mut flat, "sit book"), "book is not sittable; character holds book");
    let mut flat = with_ball();
    flat.all(&["other walk exercise_ball", "other grab exercise_ball", "walk other"]);
    assert_eq!(why(&mut flat, "sit exercise_ball"), "character holds exercise_ball");
    assert_eq!(why(&mut flat, "other sit exercise_ball"), "character holds exercise_ball");
    flat.all(&["other drop exercise_ball", "walk exercise_ball", "sit exercise_ball"]);
}

/// A flat with a seat in the kitchen that can be carried.
fn with_ball() -> Flat {
    let mut flat = Flat::new();
    let kitchen = flat.id("kitchen");
    flat.edit(|edit| {
        let ball = edit.add(vc_graph::Draft::new("exercise_ball")).unwrap();
        edit.move_to_room(ball, kitchen).unwrap();
    });
    flat
}

#[test]
fn nobody_carries_off_what_another_rests_on() {
    let mut flat = with_ball();
    flat.all(&["walk exercise_ball", "sit exercise_ball", "other walk exercise_ball"]);
    assert_eq!(why(&mut flat, "other grab exercise_ball"), "character is on exercise_ball");
    flat.all(&["stand", "other grab exercise_ball"]);
    let (me, tray) = (flat.me, flat.id("tray"));
    flat.edit(|edit| edit.place(me, Place { relation: Relation::On, at: tray }).unwrap());
    flat.all(&["other walk tray"]);
    assert_eq!(why(&mut flat, "other grab tray"), "character is on tray");
}

#[test]
fn a_car_takes_all_in_it_along() {
    let mut flat =
        Flat::after(&["walk workbench", "grab hammer", "walk car", "open car", "put_in hammer car", "close car"]);
    flat.all(&["other walk car", "other enter car", "switch_on car", "enter car"]);
    assert!(flat.has("me", Relation::Inside, "car") && flat.is("me", State::Sitting));
    assert_eq!(why(&mut flat, "walk street"), "character must stand up first");
    flat.all(&["drive car street"]);
    let street = flat.id("street");
    for thing in ["car", "me", "other", "hammer"] {
        assert_eq!(flat.graph().room_of(flat.id(thing)), Some(street), "{thing}");
    }
    assert_eq!(flat.graph().validate(), []);
    flat.all(&["leave", "dance"]);
    assert!(flat.place("me").is_none() && flat.has("me", Relation::Near, "car"));
    assert_eq!(why(&mut flat, "drive car garage"), "one is not in car");
}

#[test]
fn a_car_arrives_near_what_it_is_driven_to() {
    let mut flat = Flat::after(&["walk car", "switch_on car", "enter car", "drive car parasol"]);
    assert!(flat.has("car", Relation::Near, "parasol"));
    flat.all(&["drive car workbench", "leave"]);
    assert!(!flat.has("car", Relation::Near, "parasol"));
    assert_eq!(flat.graph().room_of(flat.me), Some(flat.id("garage")));
}

#[test]
fn a_car_has_so_many_seats() {
    let mut flat = Flat::new();
    let (car, garage) = (flat.id("car"), flat.id("garage"));
    flat.edit(|edit| {
        for _ in 0..5 {
            let passenger = edit.add(vc_graph::Draft::new("character")).unwrap();
            edit.move_to_room(passenger, garage).unwrap();
            edit.place(passenger, Place { relation: Relation::Inside, at: car }).unwrap();
        }
    });
    flat.all(&["walk car"]);
    assert_eq!(why(&mut flat, "enter car"), "all 5 places on car are taken");
}

#[test]
fn driving_away_leaves_behind_what_was_near() {
    let mut flat = Flat::new();
    let (car, bench) = (flat.id("car"), flat.id("workbench"));
    flat.edit(|edit| edit.relate(vc_graph::Edge::new(car, Relation::Near, bench)).unwrap());
    flat.all(&["walk workbench", "switch_on car", "enter car", "drive car street"]);
    assert!(!flat.graph().near(flat.me, flat.id("hammer")), "the hammer is in the garage");
    assert!(flat.step("grab hammer").is_err());
}

#[test]
fn walking_leaves_what_one_stood_on() {
    let mut flat = Flat::new();
    let (me, rug) = (flat.me, flat.id("rug"));
    flat.edit(|edit| edit.place(me, Place { relation: Relation::On, at: rug }).unwrap());
    flat.all(&["walk kitchen"]);
    assert_eq!(flat.place("me"), None);
    assert_eq!(flat.graph().validate(), []);
}

#[test]
fn leaving_ends_nearness_of_what_is_on_the_tray() {
    let mut flat = Flat::new();
    let (cup, tray, table) = (flat.id("cup"), flat.id("tray"), flat.id("kitchen_table"));
    flat.edit(|edit| {
        edit.place(cup, Place { relation: Relation::On, at: tray }).unwrap();
        edit.relate(vc_graph::Edge::new(cup, Relation::Near, table)).unwrap();
    });
    flat.all(&["walk tray", "grab tray", "walk book"]);
    assert!(!flat.has("cup", Relation::Near, "kitchen_table"), "the cup is in another room");
}

/// One goes to others, pushes, greets and plays with others, not with oneself.
#[test]
fn nobody_greets_pushes_or_plays_oneself() {
    let mut flat = Flat::new();
    let (me, other) = (flat.me, flat.other);
    flat.all(&["walk kitchen"]);
    let legal = vc_graph::rule::legal_actions(flat.graph(), me);
    let verbs = |id| legal.iter().filter(|a| a.object == Some(id)).map(|a| a.verb).collect::<Vec<_>>();
    let social = [Verb::Walk, Verb::Run, Verb::Find, Verb::TurnTo, Verb::Greet, Verb::Play, Verb::Push];
    assert!(social.iter().all(|verb| !verbs(me).contains(verb)), "{:?}", verbs(me));
    assert!(
        [Verb::Walk, Verb::Find, Verb::TurnTo, Verb::Greet].iter().all(|verb| verbs(other).contains(verb)),
        "{:?}",
        verbs(other)
    );
    assert_eq!(why(&mut flat, "greet me"), "character is oneself");
}
