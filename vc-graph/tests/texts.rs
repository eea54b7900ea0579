//! Goals, actions and labels print as what reads back.
#![allow(clippy::unwrap_used)]

mod shared;

use proptest::prelude::*;
use shared::cases;
use shared::goals::{goal, words};
use shared::scenes::{scene, steps};
use vc_graph::format::program::{self, Program};
use vc_graph::{Action, Goal, Label, NodeId, Relation, State, Verb, Word};

fn action() -> impl Strategy<Value = Action> {
    (words::<Verb>(), any::<u32>(), any::<u32>()).prop_map(|(verb, x, y)| {
        let things = [NodeId(x), NodeId(y)];
        Action::with(verb, &things[..verb.arity()]).unwrap()
    })
}

proptest! {
    #![proptest_config(cases(500))]

    #[test]
    fn goals_read_back(goal in goal(0, 3)) {
        let text = goal.to_string();
        prop_assert_eq!(text.parse::<Goal>(), Ok(goal), "{}", text);
    }

    #[test]
    fn actions_read_back(action in action()) {
        prop_assert_eq!(action.to_string().parse::<Action>(), Ok(action));
    }

    #[test]
    fn labels_read_back(class in "[\\p{Alphabetic}0-9_-]{1,20}", id: u32) {
        let label = Label { class: class.into(), id: NodeId(id) };
        prop_assert_eq!(label.to_string().parse::<Label>(), Ok(label));
    }

    #[test]
    fn described_actions_and_virtualhome_notation_read_back(steps in steps(6), verb in words::<Verb>(), x: usize, y: usize) {
        let graph = scene(&steps, false);
        let ids: Vec<NodeId> = graph.nodes().map(|n| n.id()).collect();
        let things = [ids[x % ids.len()], ids[y % ids.len()]];
        let action = Action::with(verb, &things[..verb.arity()]).unwrap();
        prop_assert_eq!(action.describe(&graph).to_string().parse::<Action>(), Ok(action));
        match action.to_virtualhome(&graph) {
            Ok(text) => prop_assert_eq!(text.parse::<Action>(), Ok(action), "{}", text),
            Err(error) => prop_assert!(verb.virtualhome().is_none(), "{}", error),
        }
    }

    #[test]
    fn programs_read_back(actions in prop::collection::vec(action(), 0..8), titled: bool) {
        let actions: Vec<Action> = actions.into_iter().filter(|a| a.verb.virtualhome().is_some()).collect();
        let heading = if titled { vec!["Make coffee".to_owned(), "In the morning.".to_owned()] } else { Vec::new() };
        let program = Program { heading, actions };
        let text = program::write(&program, &scene(&[], false)).unwrap();
        prop_assert_eq!(program::read(&text).unwrap(), program, "{}", text);
    }
}

#[test]
fn words_read_back_in_any_spelling() {
    fn check<W: Word + std::fmt::Display>() {
        for word in W::ALL {
            let spelled = [word.to_string(), word.as_str().to_uppercase(), word.as_str().replace('_', " ")];
            spelled.iter().for_each(|text| assert_eq!(W::parse(text).as_ref(), Ok(word)));
        }
    }
    check::<State>();
    check::<Relation>();
    check::<Verb>();
    check::<vc_graph::Property>();
    check::<vc_graph::class::Category>();
    check::<vc_graph::class::SlotKind>();
}

#[test]
fn virtualhome_names_are_its_own() {
    for verb in Verb::ALL {
        let Some(name) = verb.virtualhome() else { continue };
        assert_eq!(Verb::from_virtualhome(name), Some(*verb));
        assert_eq!(Verb::from_virtualhome(&name.to_lowercase()), Some(*verb));
    }
    assert_eq!(Verb::from_virtualhome("PUTBACK"), Some(Verb::Place));
    assert_eq!(Verb::from_virtualhome("RELEASE"), Some(Verb::Drop));
}

#[test]
fn older_virtualhome_numbers_name_the_instance_after_the_dot() {
    let action: Action = "<char0> [putin] <milk> (1.12) <fridge> (3)".parse().unwrap();
    assert_eq!(action, Action::two(Verb::PutIn, NodeId(12), NodeId(3)));
}

#[test]
fn deep_goals_read_back() {
    let text = "Open(door) & forall ?x. ".repeat(25) + "Open(?x)";
    let goal: Goal = text.parse().unwrap();
    assert_eq!(goal.to_string().parse(), Ok(goal));
}

#[test]
fn odd_classes_read_back() {
    for text in
        ["forall ?q. Inside(p, v ?q)", "On(ch #a.65, b)", "On(p *u, b)", "On(kitchen table, b)", "On(#pple?, b)"]
    {
        if let Ok(goal) = text.parse::<Goal>() {
            assert_eq!(goal.to_string().parse(), Ok(goal), "{text}");
        }
    }
}

#[test]
fn odd_variables_read_back() {
    for text in ["forall #12. Open(#12)", "forall *. Open(*)", "exists x.1. Open(x.1)", "exists ?. Open(?)"] {
        if let Ok(goal) = text.parse::<Goal>() {
            assert_eq!(goal.to_string().parse(), Ok(goal), "{text}");
        }
    }
}

#[test]
fn labels_are_held_against_their_nodes() {
    let mut scene = vc_graph::SceneBuilder::new("flat");
    let kitchen = scene.add(vc_graph::Draft::new("kitchen")).unwrap();
    let knife = scene.add_in(kitchen, vc_graph::Draft::new("cutleryknife")).unwrap();
    let odd = scene.add_in(kitchen, vc_graph::Draft::new("Odd_Thing").named("SM_Gizmo_3")).unwrap();
    let graph = scene.build();
    for (name, id) in [
        ("cutlery_knife", knife),
        ("CutleryKnife", knife),
        ("knife", knife),
        ("cutlery", knife),
        ("odd thing", odd),
        ("sm_gizmo_3", odd),
        ("milk", NodeId(99)),
    ] {
        assert_eq!(graph.check_name(name, id), Ok(()), "{name}");
    }
    for (name, id) in [("milk", knife), ("gizmo", odd), ("kitchen", knife), ("bread_knife", knife)] {
        let label = Label { class: name.into(), id };
        let told = graph.check_label(&label).unwrap_err().to_string();
        assert!(told.contains(&format!("`{label}` names")) && told.contains(&graph.label(id).to_string()), "{told}");
    }
}
