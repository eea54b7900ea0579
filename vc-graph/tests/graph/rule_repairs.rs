//! Faults of VirtualHome's symbolic simulator that VirtualCity does not have: one test for each item of the
//! list in the rule's documentation.
#![allow(clippy::unwrap_used)]

mod virtual_home;

use vc_graph::{Action, Bounds, Condition, Draft, NodeId, Place, Property, Relation, SceneBuilder, State, Verb, rule};
use vc_testkit::flat::{Flat, plain};

#[test]
fn find_walks_when_it_must_with_hands_full() {
    let flat = Flat::after(&["walk cup", "grab cup", "grab plate", "find book"]);
    assert_eq!(flat.graph().room_of(flat.me), Some(flat.id("living_room")));
    assert!(flat.graph().near(flat.me, flat.id("book")));
}

#[test]
fn find_does_not_walk_away_from_what_is_near() {
    let flat = Flat::after(&["walk kitchen_table", "find cup", "find plate"]);
    assert!(flat.has("me", Relation::Near, "kitchen_table") && flat.has("me", Relation::Near, "cup"));
}

#[test]
fn what_is_carried_comes_along_with_all_on_it() {
    let flat = Flat::after(&["walk plate", "grab plate", "walk book"]);
    let living_room = flat.id("living_room");
    for thing in ["me", "plate", "bread"] {
        assert_eq!(flat.graph().room_of(flat.id(thing)), Some(living_room), "{thing}");
    }
    assert!(flat.has("bread", Relation::On, "plate") && flat.graph().near(flat.me, flat.id("bread")));
    assert!(!flat.graph().near(flat.me, flat.id("cup")), "what stayed is not near any more");
}

#[test]
fn taken_off_clothes_are_in_a_hand() {
    let mut flat = Flat::after(&["walk wardrobe", "open wardrobe", "grab shirt", "wear shirt"]);
    assert!(flat.has("shirt", Relation::WornBy, "me") && flat.graph().held(flat.me).next().is_none());
    flat.all(&["walk kitchen", "take_off shirt"]);
    assert!(flat.has("me", Relation::HoldsRight, "shirt") && !flat.has("shirt", Relation::WornBy, "me"));
    assert_eq!(flat.graph().room_of(flat.id("shirt")), Some(flat.id("kitchen")));
}

#[test]
fn put_back_goes_where_a_thing_was_taken_from() {
    let flat = Flat::after(&["walk cup", "grab cup", "walk fridge", "walk kitchen_table", "put_back cup"]);
    assert!(flat.has("cup", Relation::On, "kitchen_table") && flat.graph().held(flat.me).next().is_none());
    let flat = Flat::after(&["walk fridge", "open fridge", "grab milk", "put_back milk"]);
    assert!(flat.has("milk", Relation::Inside, "fridge"));
}

#[test]
fn put_back_refuses_when_it_cannot() {
    let mut flat = Flat::after(&["walk fridge", "open fridge", "grab milk", "close fridge"]);
    assert_eq!(plain(&flat.step("put_back milk").unwrap_err()), "fridge is closed");
    flat.all(&["walk book"]);
    assert!(flat.step("put_back milk").is_err());
    assert!(flat.has("me", Relation::HoldsRight, "milk"));
}

#[test]
fn what_was_taken_from_nowhere_is_put_down_in_the_room() {
    let flat = Flat::after(&["walk cat", "grab cat", "walk bedroom", "put_back cat"]);
    assert_eq!(flat.place("cat"), None);
    assert_eq!(flat.graph().room_of(flat.id("cat")), Some(flat.id("bedroom")));
}

#[test]
fn standing_up_leaves_the_seat() {
    let mut flat = Flat::after(&["walk chair", "sit chair"]);
    assert!(flat.has("me", Relation::SittingOn, "chair") && !flat.has("me", Relation::On, "chair"));
    assert!(flat.is("me", State::Sitting));
    flat.all(&["stand"]);
    assert!(!flat.is("me", State::Sitting) && flat.place("me").is_none());
    flat.all(&["other walk chair", "other sit chair"]);
}

#[test]
fn lying_ends_sitting_and_standing_ends_sleep() {
    let mut flat = Flat::after(&["walk single_bed", "sit single_bed", "lie single_bed", "sleep"]);
    assert!(flat.has("me", Relation::LyingOn, "single_bed") && !flat.has("me", Relation::SittingOn, "single_bed"));
    assert!(flat.is("me", State::Lying) && !flat.is("me", State::Sitting) && flat.is("me", State::Asleep));
    flat.all(&["wake_up"]);
    assert!(!flat.is("me", State::Asleep) && flat.is("me", State::Lying));
    flat.all(&["sleep", "stand"]);
    assert!(!flat.is("me", State::Asleep) && !flat.is("me", State::Lying));
}

#[test]
fn a_running_machine_keeps_its_plug() {
    let mut flat = Flat::after(&["walk television", "switch_on television"]);
    assert_eq!(plain(&flat.step("plug_out television").unwrap_err()), "television is on");
    flat.all(&["switch_off television", "plug_out television"]);
    assert!(flat.step("switch_on television").is_err());
}

#[test]
fn a_hidden_screen_is_not_watched() {
    let mut flat =
        Flat::after(&["walk laptop", "grab laptop", "walk wardrobe", "open wardrobe", "put_in laptop wardrobe"]);
    flat.all(&["turn_to laptop", "watch laptop", "close wardrobe"]);
    assert_eq!(plain(&flat.step("watch laptop").unwrap_err()), "laptop is inside wardrobe, which is closed");
}

#[test]
fn grabbing_what_one_holds_does_nothing() {
    let mut flat = Flat::after(&["walk cup", "grab cup"]);
    let before = flat.graph().clone();
    assert!(flat.step("grab cup").unwrap().is_empty());
    assert_eq!(*flat.graph(), before);
    assert_eq!(flat.graph().held(flat.me).count(), 1);
}

#[test]
fn surfaces_are_surfaces_and_containers_containers() {
    let mut flat = Flat::after(&["walk cup", "grab cup", "walk cat"]);
    assert_eq!(plain(&flat.step("place cup cat").unwrap_err()), "cat is not a surface");
    assert_eq!(plain(&flat.step("put_in cup cat").unwrap_err()), "cat is not a container");
    flat.all(&["walk other"]);
    assert_eq!(plain(&flat.step("place cup other").unwrap_err()), "character is not a surface");
    assert!(flat.step("place cup me").is_err() && flat.step("place cup kitchen").is_err());
    assert!(flat.step("place cup cup").is_err());
}

#[test]
fn things_must_fit_where_sizes_are_known() {
    let mut flat = Flat::new();
    let size = |x, y, z| Bounds::standing(nalgebra::Vector3::new(x, y, z));
    let (kitchen, me) = (flat.id("kitchen"), flat.me);
    let mut ids = Vec::new();
    flat.edit(|edit| {
        let drafts = [
            ("box", size(0.4, 0.3, 0.3)),
            ("tray", size(0.39, 0.29, 0.29)),
            ("guitar", size(1.0, 0.1, 0.3)),
            ("ball", size(0.2, 0.2, 0.2)),
        ];
        for (class, bounds) in drafts {
            let id = edit.add(Draft::new(class).bounds(bounds).state(State::Open)).unwrap();
            edit.move_to_room(id, kitchen).unwrap();
            ids.push(id);
        }
    });
    let [carton, tray, guitar, ball] = ids[..] else { panic!() };
    let put = |flat: &mut Flat, id: NodeId| {
        let walk = |id| vc_graph::Action::one(vc_graph::Verb::Walk, id);
        flat.sim.step(me, &walk(id)).unwrap();
        flat.sim.step(me, &vc_graph::Action::one(vc_graph::Verb::Grab, id)).unwrap();
        flat.sim.step(me, &walk(carton)).unwrap();
        let refused = flat.sim.step(me, &vc_graph::Action::two(vc_graph::Verb::PutIn, id, carton)).err();
        flat.sim.step(me, &vc_graph::Action::one(vc_graph::Verb::Drop, id)).ok();
        refused.map(|r| plain(&r))
    };
    assert_eq!(put(&mut flat, guitar).as_deref(), Some("guitar does not fit: box is too small"));
    assert_eq!(put(&mut flat, tray), None);
    assert_eq!(flat.graph().place(tray), Some(Place { relation: Relation::Inside, at: carton }));
    assert_eq!(put(&mut flat, ball).as_deref(), Some("ball does not fit: box is full"));
}

#[test]
fn slots_hold_one_thing_each() {
    let mut flat = Flat::new();
    let kitchen = flat.id("kitchen");
    let mut add = |class: &str| {
        let mut id = NodeId(0);
        flat.edit(|edit| {
            id = edit.add(Draft::new(class)).unwrap();
            edit.move_to_room(id, kitchen).unwrap();
        });
        id
    };
    let (cup, egg, second) = (add("egg_cup"), add("apple"), add("apple"));
    flat.edit(|edit| edit.place(egg, Place { relation: Relation::Inside, at: cup }).unwrap());
    let act = |flat: &mut Flat, verb, things: &[NodeId]| {
        let (me, action) = (flat.me, vc_graph::Action::with(verb, things).unwrap());
        flat.sim.step(me, &action).map_err(|r| plain(&r))
    };
    act(&mut flat, vc_graph::Verb::Walk, &[second]).unwrap();
    act(&mut flat, vc_graph::Verb::Grab, &[second]).unwrap();
    act(&mut flat, vc_graph::Verb::Walk, &[cup]).unwrap();
    let refused = act(&mut flat, vc_graph::Verb::PutIn, &[second, cup]).unwrap_err();
    assert_eq!(refused, "apple does not fit: egg_cup has no free slot");
}

#[test]
fn seats_are_taken_by_people_not_by_things() {
    let mut flat = Flat::after(&["walk book", "grab book", "walk chair", "place book chair"]);
    flat.all(&["sit chair"]);
    assert_eq!(flat.graph().validate(), []);
}

#[test]
fn only_what_holds_things_takes_them() {
    let mut scene = SceneBuilder::new("flat");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    let fork = scene.add_in(kitchen, Draft::new("fork")).unwrap();
    let open = [Property::Openable].into_iter().collect();
    let add = |scene: &mut SceneBuilder, class: &str| {
        scene.add_in(kitchen, Draft { properties: Some(open), ..Draft::new(class) }.state(State::Open))
    };
    let takes = ["kitchen_cabinet", "backpack", "thingamajig"].map(|class| add(&mut scene, class).unwrap());
    let refuses = ["door", "window", "book", "umbrella", "curtain"].map(|class| add(&mut scene, class).unwrap());
    let graph = scene.build();
    let encloses = |at| Condition::Encloses(at).holds(&graph, me);
    assert!(takes.into_iter().all(encloses) && !refuses.into_iter().any(encloses));
    let why = rule::refusals(&graph, me, &Action::two(Verb::PutIn, fork, refuses[0]));
    assert_eq!(why[0].to_string(), format!("{} is not a container", graph.label(refuses[0])));
}
