//! Every verb has its effects, and is refused when it should be.
#![allow(clippy::unwrap_used)]

use vc_graph::rule::{self, table::RULES};
use vc_graph::{Action, ActionRule, Condition, Effect, NodeId, Property, Refusal, State, Verb, Vocabulary, Word};
use vc_testkit::flat::{Flat, plain};

#[test]
fn the_table_is_in_the_order_of_the_verbs() {
    assert_eq!(RULES.len(), Verb::ALL.len());
    for (rule, &verb) in RULES.iter().zip(Verb::ALL) {
        assert_eq!((rule.verb, Vocabulary::builtin().rule(verb).unwrap().verb, verb.arity()), (verb, verb, rule.arity));
        assert!(rule.description.ends_with('.'), "{verb}: {}", rule.description);
        let action = Action::with(verb, &[NodeId(1), NodeId(2)][..rule.arity]).unwrap();
        assert_eq!(
            rule::preconditions(&Vocabulary::builtin(), &action).len(),
            rule.preconditions.len(),
            "{verb} needs a thing it does not take"
        );
        assert_eq!(
            rule::effects(&Vocabulary::builtin(), &action).len(),
            rule.effects.len(),
            "{verb} is about a thing it does not take"
        );
    }
}

/// The affordance that a state needs is demanded by each verb that brings the state about.
#[test]
fn states_need_what_their_verbs_demand() {
    for &state in State::ALL {
        let enters = |rule: &&ActionRule| {
            rule.effects
                .iter()
                .any(|effect| matches!(effect, Effect::Enter(_, s) | Effect::EnterWith(_, s) if *s == state))
        };
        let demands = |rule: &ActionRule, property| {
            rule.preconditions.iter().any(|need| match need {
                Condition::Affords(_, p) => *p == property,
                Condition::Cuttable(_) => property == Property::Cuttable,
                _ => false,
            })
        };
        let verbs: Vec<&ActionRule> = RULES.iter().filter(enters).collect();
        let common = |property: &&Property| !verbs.is_empty() && verbs.iter().all(|rule| demands(rule, **property));
        let found = Property::ALL.iter().find(common).copied();
        assert!(verbs.is_empty() || found == state.needs(), "{state}: {found:?}");
        let opposite = state.opposites().iter().all(|other| state.needs().is_none() || other.needs() == state.needs());
        assert!(opposite, "{state}");
    }
}

/// Actions performed before, and an action that is then possible. Separated by commas.
const DONE: &[(&str, &str)] = &[
    ("", "walk cup"),
    ("", "run book"),
    ("", "find cup"),
    ("", "turn_to book"),
    ("turn_to book", "look_at book"),
    ("turn_to book", "point_at book"),
    ("walk living_room, turn_to television", "watch television"),
    ("walk cup", "grab cup"),
    ("walk cup, grab cup", "place cup kitchen_table"),
    ("walk cup, grab cup, walk sink", "put_in cup sink"),
    ("walk cup, grab cup", "put_back cup"),
    ("walk cup, grab cup", "drop cup"),
    ("walk fridge", "open fridge"),
    ("walk fridge, open fridge", "close fridge"),
    ("walk television", "switch_on television"),
    ("walk television, switch_on television", "switch_off television"),
    ("walk television, plug_out television", "plug_in television"),
    ("walk television", "plug_out television"),
    ("walk chair", "sit chair"),
    ("walk single_bed", "lie single_bed"),
    ("walk chair, sit chair", "stand"),
    ("walk single_bed, lie single_bed", "sleep"),
    ("walk single_bed, lie single_bed, sleep", "wake_up"),
    ("walk bread", "eat bread"),
    ("walk plate", "eat plate"),
    ("walk fridge, open fridge", "eat fridge"),
    ("walk fridge, open fridge, grab milk", "drink milk"),
    ("walk cat", "touch cat"),
    ("walk book, grab book", "read book"),
    ("walk sponge, grab sponge, walk kitchen_table", "wipe kitchen_table"),
    ("walk plate", "wash plate"),
    ("walk plate", "rinse plate"),
    ("walk plate", "scrub plate"),
    ("walk fridge, open fridge, grab milk, walk cup", "pour milk cup"),
    ("walk cup, grab cup, walk faucet, switch_on faucet", "fill cup faucet"),
    ("walk knife, grab knife, walk bread", "cut bread"),
    ("walk potato, grab potato, walk stove, place potato frying_pan, switch_on stove", "cook potato"),
    ("walk wardrobe, open wardrobe, grab shirt", "wear shirt"),
    ("walk wardrobe, open wardrobe, grab shirt, wear shirt", "take_off shirt"),
    ("walk wardrobe, open wardrobe, grab shirt", "fold shirt"),
    ("walk wardrobe, open wardrobe", "unfold towel"),
    ("walk cat", "push cat"),
    ("walk chair", "pull chair"),
    ("walk chair", "move chair"),
    ("walk sponge", "squeeze sponge"),
    ("walk laptop", "type laptop"),
    ("", "greet other"),
    ("walk guitar", "play guitar"),
    ("walk car", "enter car"),
    ("walk car, enter car", "leave"),
    ("walk car, switch_on car, enter car", "drive car street"),
    ("", "dance"),
    ("", "wave"),
    ("walk chair, sit chair", "exercise"),
    ("", "stretch"),
    ("", "smile"),
    ("walk cup, grab cup, walk stove, place cup stove, switch_on stove", "heat cup"),
    ("walk cup, grab cup, walk fridge, open fridge, put_in cup fridge, close fridge, switch_on fridge", "cool cup"),
    ("walk towel, open wardrobe, grab towel, walk plate", "dry plate"),
    ("walk plate", "soil plate"),
];

/// Actions performed before, an action that is then impossible, and the reason.
const REFUSED: &[(&str, &str, &str)] = &[
    ("walk chair, sit chair", "walk cup", "character must stand up first"),
    ("walk single_bed, lie single_bed", "run cup", "character must stand up first"),
    ("walk chair, sit chair", "find book", "character must stand up first"),
    ("", "look_at book", "one does not face book; turn to it first"),
    ("turn_to cup", "point_at book", "one does not face book; turn to it first"),
    ("turn_to television", "watch television", "television is in living_room, another room"),
    ("", "grab cup", "not near: cup is too far away"),
    ("walk fridge", "grab fridge", "fridge is not graspable"),
    ("", "place cup kitchen_table", "cup is not in hand; not near: kitchen_table is too far away"),
    ("walk cup, grab cup, walk fridge", "put_in cup fridge", "fridge is closed"),
    ("walk cup, grab cup, walk book", "put_back cup", "not near: kitchen_table is too far away"),
    ("", "drop cup", "cup is not in hand"),
    ("walk fridge, open fridge", "open fridge", "fridge is not closed"),
    ("walk sofa", "open sofa", "sofa is not openable; sofa is not closed"),
    ("walk fridge", "close fridge", "fridge is not open"),
    ("walk television, plug_out television", "switch_on television", "television is plugged_out"),
    ("walk television", "switch_off television", "television is not on"),
    ("walk television", "plug_in television", "television is not plugged_out"),
    ("walk television, switch_on television", "plug_out television", "television is on"),
    ("walk chair, other walk chair, other sit chair", "sit chair", "all 1 places on chair are taken"),
    ("walk sofa, sit sofa", "sit sofa", "one is sitting already"),
    ("", "lie single_bed", "not near: single_bed is too far away"),
    ("", "stand", "character neither sits nor lies"),
    ("", "sleep", "character neither sits nor lies"),
    ("", "wake_up", "character neither sits nor lies"),
    ("walk cup", "eat cup", "cup is not eatable"),
    ("walk fridge", "eat fridge", "fridge is not eatable"),
    ("walk fridge, open fridge", "drink milk", "milk is not in hand"),
    ("walk fridge", "touch milk", "milk is inside fridge, which is closed"),
    ("walk kitchen", "touch kitchen", "kitchen is a room: name a thing in it, such as its floor"),
    ("walk kitchen", "wash kitchen", "kitchen is a room"),
    ("walk kitchen", "push kitchen", "kitchen is a room"),
    ("walk book", "read book", "book is not in hand"),
    ("walk plate", "wipe plate", "character holds nothing: take something first"),
    ("", "wash plate", "not near: plate is too far away"),
    ("", "rinse plate", "not near: plate is too far away"),
    ("", "scrub plate", "not near: plate is too far away"),
    ("walk fridge, open fridge, grab milk, walk book", "pour milk book", "book is not a recipient"),
    ("walk cup, grab cup, walk faucet", "fill cup faucet", "faucet is not on"),
    ("walk bread", "cut bread", "nothing in hand is a cutter"),
    ("walk potato", "cook potato", "potato is not on or in anything hot that is switched on"),
    ("walk wardrobe, open wardrobe", "wear shirt", "shirt is not in hand"),
    ("walk wardrobe, open wardrobe", "take_off shirt", "one does not wear shirt"),
    ("walk cup", "fold cup", "cup is not foldable"),
    ("walk wardrobe, open wardrobe", "unfold shirt", "shirt is not folded"),
    ("", "push cat", "not near: cat is too far away"),
    ("walk fridge", "pull fridge", "fridge is not movable"),
    ("walk fridge", "move fridge", "fridge is not movable"),
    ("walk cup", "squeeze cup", "cup is not soft"),
    ("walk cup", "type cup", "cup is not something to type on"),
    ("", "greet cat", "cat is not a person"),
    ("", "play guitar", "not near: guitar is too far away"),
    ("walk fridge", "enter fridge", "fridge is not drivable"),
    ("", "leave", "one is not in any vehicle"),
    ("walk car, enter car", "drive car street", "car is not on"),
    ("walk chair, sit chair", "dance", "character must stand up first"),
    ("walk cup, grab cup, walk stove, place cup stove", "heat cup", "cup is not on or in anything hot"),
    ("walk apple", "cool apple", "apple is not in anything that cools and runs"),
    ("walk plate", "dry plate", "nothing in hand is a wiper"),
    ("", "soil plate", "not near: plate is too far away"),
    ("walk knife, grab knife, walk book", "put_in knife book", "book is not a container"),
];

/// Verbs that are always possible.
const FREE: [Verb; 5] = [Verb::TurnTo, Verb::Wave, Verb::Exercise, Verb::Stretch, Verb::Smile];

fn after(before: &str) -> Flat {
    Flat::after(&before.split(", ").filter(|s| !s.is_empty()).collect::<Vec<_>>())
}

#[test]
fn every_verb_is_in_both_lists() {
    let first = |text: &str| text.split(' ').next().unwrap().parse::<Verb>().unwrap();
    for verb in Verb::ALL {
        assert!(DONE.iter().any(|(_, action)| first(action) == *verb), "{verb}");
        assert!(FREE.contains(verb) || REFUSED.iter().any(|(_, action, _)| first(action) == *verb), "{verb}");
    }
}

#[test]
fn what_can_be_done() {
    for (before, action) in DONE {
        let mut flat = after(before);
        let old = flat.graph().clone();
        let changes = flat.step(action).unwrap_or_else(|e| panic!("{before}, {action}: {}", plain(&e)));
        assert_eq!(flat.graph().validate(), [], "{before}, {action}");
        assert_eq!(flat.sim.history().events().last().unwrap().action, flat.action(action));
        let mut back = flat.graph().clone();
        changes.undo(&mut back).unwrap();
        assert_eq!(back, old, "{before}, {action}");
    }
}

#[test]
fn what_is_refused_and_why() {
    for (before, action, why) in REFUSED {
        let mut flat = after(before);
        let (old, events) = (flat.graph().clone(), flat.sim.history().clone());
        let refusals = flat.step(action).expect_err(action);
        assert!(plain(&refusals).contains(why), "{before}, {action}: {}", plain(&refusals));
        assert_eq!((flat.graph(), flat.sim.history()), (&old, &events), "{before}, {action}");
        assert_eq!(rule::refusals(&old, flat.me, &flat.action(action)), refusals);
    }
}

#[test]
fn all_reasons_are_given_at_once() {
    let mut flat = after("walk book, grab book, walk guitar, grab guitar");
    let why = plain(&flat.step("grab apple").unwrap_err());
    assert_eq!(
        why,
        "apple is inside fridge, which is closed; character has no free hand: put something down first; not near: apple is too far away"
    );
}

#[test]
fn only_agents_act_and_only_on_things_there_are() {
    let mut flat = Flat::new();
    let (cup, none) = (flat.id("cup"), NodeId(999));
    let old = flat.graph().clone();
    for &verb in Verb::ALL {
        let things = [cup, cup];
        let action = Action::with(verb, &things[..verb.arity()]).unwrap();
        assert_eq!(plain(&flat.sim.step(cup, &action).unwrap_err()), "cup is no agent and cannot act");
        assert_eq!(flat.sim.step(none, &action).unwrap_err(), [Refusal::NoSuchThing(none)]);
        if verb.arity() > 0 {
            let action = Action::with(verb, &[none, cup][..verb.arity()]).unwrap();
            assert_eq!(flat.sim.step(flat.me, &action).unwrap_err(), [Refusal::NoSuchThing(none)]);
        }
        let wrong = Action { object: Some(cup), ..Action::zero(verb) };
        if verb.arity() != 1 {
            assert!(matches!(flat.sim.step(flat.me, &wrong).unwrap_err()[..], [Refusal::Arity { given: 1, .. }]));
        }
    }
    assert_eq!(*flat.graph(), old);
}

#[test]
fn distances_are_told_where_poses_are_known() {
    use vc_graph::{Draft, Pose, SceneBuilder};
    let mut scene = SceneBuilder::new("posed");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let cup = scene.add_in(kitchen, Draft::new("cup").at(Pose::translation(3.1, 0.0, 0.7))).unwrap();
    let me = scene.add_in(kitchen, Draft::new("character").at(Pose::identity())).unwrap();
    let mut graph = scene.build();
    let refused = rule::step(&mut graph, me, &Action::one(Verb::Grab, cup)).unwrap_err();
    assert_eq!(refused[0].to_string(), "not near: cup.2 is 3.1 m away");
    rule::step(&mut graph, me, &Action::one(Verb::Walk, cup)).unwrap();
    assert!(graph.distance(me, cup).unwrap() < 0.5 && graph.near(me, cup));
    rule::step(&mut graph, me, &Action::one(Verb::Grab, cup)).unwrap();
    assert!(graph.node(cup).unwrap().position().unwrap().z > 0.9, "it is in the hand");
}
