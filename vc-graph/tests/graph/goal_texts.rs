//! The text form of goals: the thesis's notation, tolerant names, helpful errors.
#![allow(clippy::unwrap_used)]

use vc_graph::Goal;
use vc_graph::goal::{Comparison, GoalError, GoalProblem};

fn parse(text: &str) -> Goal {
    text.parse().unwrap_or_else(|e| panic!("{text}: {e}"))
}

fn fail(text: &str) -> GoalError {
    text.parse::<Goal>().expect_err(text)
}

#[test]
fn the_thesis_writes_counts_after_literals() {
    let goal = parse("On(apple, kitchentable), 3 & Closed(fridge)");
    let [Goal::Count { literal, comparison: Comparison::AtLeast, number: 3 }, Goal::Literal(closed)] = goal.conjuncts()
    else {
        panic!("{goal:?}")
    };
    assert_eq!(
        (literal.to_string().as_str(), closed.to_string().as_str()),
        ("On(apple, kitchentable)", "Closed(fridge)")
    );
    assert_eq!(parse("On(apple, table), 1"), parse("On(apple, table)"));
    assert_eq!(parse("On(plate, table), 1, Sit(chair), 2"), parse("On(plate, table) & Sit(chair), 2"));
    assert_eq!(parse("On(plate, table), Sit(chair)"), parse("On(plate, table) & Sit(chair)"));
}

#[test]
fn the_same_goal_in_many_spellings() {
    for (text, plain) in [
        ("on(apple,table)", "On(apple, table)"),
        ("ON ( apple , table )", "On(apple, table)"),
        ("Close(fridge)", "Closed(fridge)"),
        ("On(lamp)", "SwitchedOn(lamp)"),
        ("TurnOff(lamp)", "SwitchedOff(lamp)"),
        ("In(milk, fridge)", "Inside(milk, fridge)"),
        ("Next_To(cup)", "Near(me, cup)"),
        ("Grab(cup)", "Holds(me, cup)"),
        ("Sit(sofa)", "SittingOn(me, sofa)"),
        ("Wear(shirt)", "WornBy(shirt, me)"),
        ("On(*, table)", "On(_, table)"),
        ("did PUTIN(cup, sink)", "did put_in(cup, sink)"),
        ("not Open(door) and Open(box) or Dirty(cup)", "!Open(door) & Open(box) | Dirty(cup)"),
        ("Open(a) && Open(b) || Open(c)", "Open(a) & Open(b) | Open(c)"),
        ("Open(a); Open(b)", "Open(a) & Open(b)"),
        ("forall x: cup. Clean(x)", "forall ?x: cup. Clean(?x)"),
        ("Open(cup.12), == 2", "Open(cup.12), = 2"),
        ("(((Open(a))))", "Open(a)"),
        ("Filled(cup, water)", "FilledWith(cup, water)"),
        ("Filled(cup)", "Filled(cup)"),
        ("Open(a) imply Open(b)", "Open(a) => Open(b)"),
        ("Open(a) | Open(b) => Open(c)", "Open(a) | Open(b) => Open(c)"),
        ("exists x: cup. me = x", "exists ?x: cup. me = ?x"),
        ("exists ?x. exists ?y. (Open(?x) & !(?x = ?y))", "exists ?x. exists ?y. Open(?x) & ?x != ?y"),
        ("EXACTLY 2 x: cup. Clean(x)", "exactly 2 ?x: cup. Clean(?x)"),
        ("at least 2 pairs ?p: plate, ?c: chair. Near(?p, ?c)", "at least 2 pairs ?p: plate, ?c: chair. Near(?p, ?c)"),
        ("marginal pairs ?p: plate, ?c. Near(?p, ?c)", "marginal pairs ?p: plate, ?c. Near(?p, ?c)"),
        ("within 5 Open(a)", "within 5 steps Open(a)"),
        ("at the end Open(a)", "at end Open(a)"),
        ("always !Broken(cup) & eventually Open(a)", "always !Broken(cup) & eventually Open(a)"),
        ("did open(a) before did grab(b) & Open(c)", "did open(a) before did grab(b) & Open(c)"),
        ("forall ?\"x\": \"apple.n.01\". On(\"x\", ?x)", "forall ?x: \"apple.n.01\". On(\"x\", ?x)"),
        ("On(\"apple.n.01\".12, \"me\")", "On(\"apple.n.01\".12, \"me\")"),
    ] {
        assert_eq!(parse(text).to_string(), plain, "{text}");
    }
}

#[test]
fn formulas_of_the_embodied_agent_interface() {
    for (text, plain) in [
        ("ON(computer.417)", "SwitchedOn(computer.417)"),
        ("ONTOP(cup.1, table.2) and INSIDE(milk.3, fridge.4)", "On(cup.1, table.2) & Inside(milk.3, fridge.4)"),
        ("HOLDS_RH(character.65, cup.1)", "HoldsRight(me, cup.1)"),
        ("NEXT_TO(character.65, cat.1000)", "Near(me, cat.1000)"),
        ("FACING(character.65, tv.2) or not CLOSED(door.3)", "Facing(me, tv.2) | !Closed(door.3)"),
        (
            "exists x0. (LOOKAT(x0)) then exists x1. (LIE(x1))",
            "(exists ?x0. did look_at(?x0)) then (exists ?x1. did lie(?x1))",
        ),
        ("forall x. (not ON(x) or CLEAN(x))", "forall ?x. !SwitchedOn(?x) | Clean(?x)"),
    ] {
        assert_eq!(Goal::from_eai(text).unwrap_or_else(|e| panic!("{text}: {e}")).to_string(), plain);
    }
}

#[test]
fn errors_say_where_and_what() {
    for (text, shown) in [
        ("On(breakfast; kitchen table)", "goal, character 13: expected `,` or `)`, found `;`"),
        ("On(apple", "goal, character 9: expected `,` or `)`, found the end"),
        ("", "goal, character 1: expected a predicate such as `On(apple, table)`, found the end"),
        ("apple", "goal, character 6: expected `(` after the predicate, found the end"),
        ("Open(door) Open(box)", "goal, character 12: expected `&`, `|`, `then` or the end, found `Open`"),
        ("Open(door) & ", "goal, character 14: expected a predicate such as `On(apple, table)`, found the end"),
        ("Open(door), many", "goal, character 11: expected `&`, `|`, `then` or the end, found `,`"),
        ("Open(door), = many", "goal, character 15: expected a number, found `many`"),
        ("Open(door), 99999999999", "goal, character 13: expected a number, found `99999999999`"),
        (
            "Fly(bird)",
            "goal, character 1: unknown predicate `Fly`; use a state (Open, Clean), a relation (On, Inside, Near) or a verb (Sit, Eat); your own are declared in a `Vocabulary` first",
        ),
        ("Open(door, box)", "goal, character 1: `Open` takes one thing, two are given"),
        ("On(a, b, c)", "goal, character 1: `On` takes two things, 3 are given"),
        ("Clean(?p)", "goal, character 7: no forall or exists binds the variable `?p`"),
        ("forall ?p plate. Clean(?p)", "goal, character 11: expected `.` after the variable, found `plate`"),
        ("On(\"apple, table)", "goal, character 18: expected a closing `\"`, found the end"),
        ("cup = me", "goal, character 1: expected a variable, a node such as `cup.12` or `me`, found `cup`"),
        ("at once Open(x)", "goal, character 4: expected `end`, `least` or `most`, found `once`"),
        ("pairs ?x: cup. Open(?x)", "goal, character 14: expected `,` and the other variable, found `.`"),
        ("Öffne(tür) @", "goal, character 12: expected a name, a number or one of `( ) , : . ! & |`, found `@`"),
    ] {
        assert_eq!(fail(text).to_string(), shown);
    }
}

#[test]
fn long_and_deep_goals_are_refused() {
    let long = "Open(door) & ".repeat(6000);
    assert_eq!(fail(&long).problem, GoalProblem::TooLong(long.len()));
    let deep = |levels: usize| "(".repeat(levels) + "Open(x)" + &")".repeat(levels);
    assert_eq!(fail(&deep(140)).problem, GoalProblem::TooDeep);
    assert_eq!(parse(&deep(50)), parse("Open(x)"));
    assert_eq!(fail(&("!".repeat(70) + "Open(x)")).problem, GoalProblem::TooDeep);
}

/// `On` can be said of a single lamp, or of an apple and a table.
#[test]
fn two_things_without_a_comma_are_not_one_that_is_on() {
    let error = "On(apple table)".parse::<vc_graph::Goal>().unwrap_err();
    assert_eq!(
        error.to_string(),
        "goal, character 10: expected `,` between two things; a class of two words is joined, `kitchen_table`, \
         found `table`"
    );
    assert!("Filled(glass milk)".parse::<vc_graph::Goal>().is_err());
    for (text, read) in [
        ("On(table lamp)", "SwitchedOn(table_lamp)"),
        ("On(apple, kitchen table)", "On(apple, kitchen_table)"),
        ("Open(kitchen cabinet)", "Open(kitchen_cabinet)"),
        ("Near(blue table)", "Near(me, blue_table)"),
        ("On(apple_table)", "SwitchedOn(apple_table)"),
        ("Filled(water glass)", "Filled(water_glass)"),
    ] {
        let goal: vc_graph::Goal = text.parse().unwrap();
        assert_eq!(goal, read.parse().unwrap(), "{text}");
    }
}

/// A predicate of another number of things and an action without any get the form that was meant.
#[test]
fn errors_name_the_form_that_was_meant() {
    for (text, meant) in [
        ("Sitting(me, sofa)", "`Sitting` takes one thing, two are given (did you mean `SittingOn`?)"),
        ("Lying(me, bed)", "(did you mean `LyingOn`?)"),
        ("Hold(mug)", "unknown predicate `Hold` (did you mean `holds` or "),
        ("did dance", "expected `()` after a name that is about nothing, as in `did dance()`, found the end"),
        ("dance & Open(door)", "expected `()` after a name that is about nothing, as in `did dance()`, found `&`"),
    ] {
        let error = fail(text).to_string();
        assert!(error.contains(meant), "{text}: {error}");
    }
    assert_eq!(parse("did dance()"), parse("Dance()"));
}

/// After `did` stands a verb: a state is none, and only verbs are suggested.
#[test]
fn actions_done_are_of_verbs() {
    assert_eq!(
        fail("did wet(mug)").to_string(),
        "goal, character 1: unknown verb `wet` after `did`; use one such as `did grab(cup)`; your own are declared in a `Vocabulary` first"
    );
    assert!(fail("did gras(mug)").to_string().contains("`gras` after `did` (did you mean `grab`?)"));
}
