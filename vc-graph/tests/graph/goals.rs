//! When goals hold, their scores, and their unmet parts.
#![allow(clippy::unwrap_used)]

use vc_graph::Goal;
use vc_graph::goal::Situation;
use vc_testkit::flat::Flat;

fn parse(text: &str) -> Goal {
    text.parse().unwrap_or_else(|e| panic!("{text}: {e}"))
}

fn score(flat: &Flat, text: &str) -> f64 {
    let goal = parse(text);
    let now = Situation::new(flat.graph(), flat.me, flat.sim.history());
    assert_eq!(goal.holds(&now), goal.score(&now) == 1.0, "{text}");
    goal.score(&now)
}

fn holds(flat: &Flat, text: &str) -> bool {
    score(flat, text) == 1.0
}

fn check(flat: &Flat, yes: &[&str], no: &[&str]) {
    yes.iter().for_each(|text| assert!(holds(flat, text), "{text} does not hold"));
    no.iter().for_each(|text| assert!(!holds(flat, text), "{text} holds"));
}

#[test]
fn states() {
    let flat = Flat::after(&["walk television", "switch_on television"]);
    let yes = [
        "Closed(fridge)",
        "On(television)",
        "SwitchedOn(television)",
        "PluggedIn(television)",
        "plug_in(tv)",
        "Off(faucet)",
        "Clean(cup)",
        "Raw(potato)",
    ];
    check(
        &flat,
        &yes,
        &["Open(fridge)", "Off(television)", "Dirty(_)", "Cooked(potato)", "On(nothing_such)", "Open(cup.99)"],
    );
}

#[test]
fn things_on_and_in_others() {
    let flat = Flat::new();
    let yes = [
        "On(cup, kitchen_table)",
        "On(cup, table)",
        "On(cup, KitchenTable)",
        "On(cup, _)",
        "On(_, stove)",
        "Inside(milk, fridge)",
        "In(milk, fridge)",
        "Inside(cup, kitchen)",
        "In(milk, kitchen)",
        "InRoom(cup, kitchen)",
        "Inside(me, kitchen)",
        "On(bread, plate)",
    ];
    let no = [
        "On(cup, fridge)",
        "On(bread, kitchen_table)",
        "Inside(cup, garage)",
        "Inside(kitchen, kitchen)",
        "On(kitchen_table, cup)",
    ];
    check(&flat, &yes, &no);
}

#[test]
fn inside_reaches_through_what_is_inside() {
    let flat = Flat::after(&["walk plate", "grab plate", "walk wardrobe", "open wardrobe", "put_in plate wardrobe"]);
    check(
        &flat,
        &["Inside(bread, wardrobe)", "Inside(plate, wardrobe)", "In(bread, bedroom)"],
        &["Inside(bread, fridge)"],
    );
}

#[test]
fn the_agent_itself() {
    let mut flat = Flat::after(&["walk cup", "grab cup", "turn_to book"]);
    let yes = [
        "Near(cup)",
        "Near(kitchen)",
        "Walk(kitchen)",
        "Holds(cup)",
        "Grab(cup)",
        "HoldsRight(cup)",
        "Holds(me, cup)",
        "Facing(book)",
        "Near(me, cup)",
        "did walk(cup)",
    ];
    check(&flat, &yes, &["Near(book)", "HoldsLeft(cup)", "Holds(book)", "Facing(cup)", "Sit(chair)", "did run(_)"]);
    flat.all(&["place cup kitchen_table", "walk chair", "sit chair"]);
    check(
        &flat,
        &["Sit(chair)", "Sitting(me)", "On(me, chair)", "SittingOn(me, chair)", "Sit(seat)"],
        &["Lie(chair)", "Holds(cup)"],
    );
    flat.all(&["stand", "walk wardrobe", "open wardrobe", "grab shirt", "wear shirt"]);
    check(&flat, &["Wear(shirt)", "WornBy(shirt, me)", "On(shirt, me)"], &["Wear(towel)", "Sitting(me)"]);
}

#[test]
fn things_done() {
    let mut flat = Flat::after(&["walk bread", "eat bread", "other walk book", "other grab book", "other read book"]);
    let yes = ["Eat(bread)", "did eat(bread)", "Eat(_)", "did walk(_)", "did eat(plate) | Eat(bread)"];
    check(&flat, &yes, &["Eat(apple)", "did read(book)", "Drink(milk)", "did put_in(_, _)"]);
    flat.all(&["walk cup", "grab cup", "walk sink", "put_in cup sink"]);
    check(
        &flat,
        &["did put_in(cup, sink)", "did put_in(_, sink)", "did put_in(cup, _)"],
        &["did put_in(sink, cup)", "did place(cup, _)"],
    );
}

#[test]
fn connectives() {
    let flat = Flat::new();
    let (yes, no) = ("Closed(fridge)", "Open(fridge)");
    check(&flat, &[yes, "true", "!false"], &[no, "false", "not true"]);
    let both = |sign: &str| {
        [(yes, yes), (yes, no), (no, yes), (no, no)].map(|(a, b)| holds(&flat, &format!("{a} {sign} {b}")))
    };
    assert_eq!((both("&"), both("and")), ([true, false, false, false], [true, false, false, false]));
    assert_eq!((both("|"), both("or")), ([true, true, true, false], [true, true, true, false]));
    check(
        &flat,
        &[&format!("{no} & {no} | {yes}"), &format!("!{no} & {yes}")],
        &[&format!("{no} & ({no} | {yes})"), &format!("!({no} | {yes})")],
    );
}

#[test]
fn quantifiers() {
    let flat = Flat::after(&["walk fridge", "open fridge"]);
    let yes = [
        "forall ?f: fruit. Inside(?f, fridge)",
        "forall ?x: unicorn. Open(?x)",
        "exists ?x. Open(?x)",
        "exists ?t: table. (On(cup, ?t) & On(plate, ?t))",
        "forall ?c: character. exists ?r: kitchen. Inside(?c, ?r)",
        "forall ?x: food. (exists ?y. (On(?x, ?y) | Inside(?x, ?y)) | InRoom(?x, kitchen))",
    ];
    let no = [
        "forall ?x. Open(?x)",
        "exists ?x: unicorn. Open(?x)",
        "exists ?t: table. (On(cup, ?t) & On(book, ?t))",
        "forall ?x: food. Inside(?x, fridge)",
    ];
    check(&flat, &yes, &no);
}

#[test]
fn counts() {
    let flat = Flat::new();
    let yes = [
        "On(_, kitchen_table), 5",
        "On(_, kitchen_table), = 5",
        "On(_, kitchen_table), <= 5",
        "On(_, kitchen_table), >= 2",
        "Inside(apple, fridge), 1",
        "Open(fridge), 0",
        "Open(fridge), = 0",
    ];
    let no = [
        "On(_, kitchen_table), 6",
        "On(_, kitchen_table), = 4",
        "On(_, kitchen_table), <= 4",
        "Inside(apple, fridge), 2",
        "Inside(apple, fridge), = 0",
    ];
    check(&flat, &yes, &no);
    assert_eq!(score(&flat, "On(_, kitchen_table), 10"), 0.5);
    assert_eq!(score(&flat, "On(cup, kitchen_table), 4"), 0.25);
}

#[test]
fn a_count_is_of_different_things_in_the_first_open_place() {
    let flat = Flat::after(&["walk cup", "grab cup"]);
    // One cup is near many things; it is still one cup.
    check(&flat, &["Near(cup, _), = 1", "Near(me, _), >= 2", "Holds(me, _), = 1"], &["Near(cup, _), 2"]);
}

#[test]
fn scores_are_shares() {
    let flat = Flat::new();
    assert_eq!(score(&flat, "Closed(fridge) & Open(wardrobe)"), 0.5);
    assert_eq!(score(&flat, "Open(fridge) & Open(wardrobe) & Clean(cup) & On(cup, _)"), 0.5);
    assert_eq!(score(&flat, "Open(fridge) | (Closed(fridge) & Open(wardrobe))"), 0.5);
    assert_eq!(score(&flat, "!Closed(fridge)"), 0.0);
    assert_eq!(score(&flat, "forall ?f: food. Inside(?f, fridge)"), 0.5, "milk and apple; not bread, potato");
}

#[test]
fn the_unmet_parts_are_named() {
    let flat = Flat::new();
    let goal = parse("Closed(fridge) & Open(wardrobe) & (Dirty(cup) | Clean(cup)) & Holds(book)");
    let now = Situation::new(flat.graph(), flat.me, flat.sim.history());
    let unmet: Vec<String> = goal.unmet(&now).iter().map(ToString::to_string).collect();
    assert_eq!(unmet, ["Open(wardrobe)", "Holds(me, book)"]);
    assert_eq!(parse("Closed(fridge)").unmet(&now), Vec::<&Goal>::new());
    let alone = parse("Open(fridge)");
    assert_eq!(alone.unmet(&now), [&alone]);
}

#[test]
fn then_is_an_order() {
    let flat = Flat::after(&["walk bread", "eat bread", "touch bread", "walk book", "touch book"]);
    let yes = [
        "did eat(bread) then did touch(book)",
        "did walk(bread) then did eat(bread) then did walk(book) then did touch(book)",
        "did touch(_) then did touch(_)",
        "did eat(bread) then Near(book)",
        "(did touch(bread) & did eat(bread)) then did touch(book)",
    ];
    let no = [
        "did touch(book) then did eat(bread)",
        "did eat(bread) then did eat(bread)",
        "did touch(_) then did touch(_) then did touch(_)",
        "did eat(bread) then did touch(book) then did walk(_)",
    ];
    check(&flat, &yes, &no);
    assert!(score(&flat, "did touch(book) then did eat(bread)") < 1.0);
}
