//! Own states, properties and verbs: any number of them, in files, rules and goals, whatever the order in which they were
//! declared.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::fmt::Write;

use proptest::prelude::*;
use vc_graph::format::native;
use vc_graph::goal::Situation;
use vc_graph::rule::{legal_actions, refusals, regress::achievers, step};
use vc_graph::{
    Action, ClassTable, Condition, Draft, Goal, History, Node, NodeId, Property, Refusal, SceneBuilder, SceneGraph,
    State, StateSet, Verb, Violation, Vocabulary, VocabularyProblem, Word,
};
use vc_testkit::cases;
use vc_testkit::flat::Flat;

const POLISH: &str = "
    property polishable
    state waxed | excludes: dusty dirty | needs: polishable
    verb polish 2 | needs: affords x polishable; affords y wiper; holding y; near x | effects: enter x waxed | motion: use_at
";

fn words(text: &str) -> Vocabulary {
    Vocabulary::parse("words.txt", text).unwrap()
}

fn problem(text: &str) -> VocabularyProblem {
    Vocabulary::parse("words.txt", text).unwrap_err().problem
}

/// A hallway with boots, a rag and an agent; boots can be polished and are dusty.
fn hallway(words: Vocabulary) -> (SceneGraph, [NodeId; 3]) {
    let boots = "leather_boots | boots | | clothing | graspable polishable | 0.3 0.3 0.3 | 1 | dusty | | ";
    let classes = ClassTable::builtin().with_vocabulary(words).extended("classes.txt", boots).unwrap();
    let mut scene = SceneBuilder::with_classes("hallway", classes.into());
    let hall = scene.add(Draft::new("hallway")).unwrap();
    let things = ["leather_boots", "rag", "character"].map(|class| scene.add_in(hall, Draft::new(class)).unwrap());
    (scene.build(), things)
}

fn act(graph: &mut SceneGraph, agent: NodeId, lines: &[&str]) {
    for line in lines {
        step(graph, agent, &line.parse().unwrap()).unwrap();
    }
}

#[test]
fn a_verb_of_ones_own_is_done_as_any_other() {
    let (mut graph, [boots, rag, me]) = hallway(words(POLISH));
    let polish: Action = format!("polish leather_boots.{} rag.{}", boots.0, rag.0).parse().unwrap();
    let waxed = State::parse("waxed").unwrap();
    let why = refusals(&graph, me, &polish);
    assert!(matches!(why[..], [Refusal::NotHeld(_), Refusal::NotNear { .. }]), "{why:?}");
    assert_eq!(achievers(&graph, me, &Condition::In(boots, waxed)), [polish], "the rag is the only wiper");
    act(&mut graph, me, &["walk rag.3", "grab rag.3", "walk leather_boots.2", "polish leather_boots.2 rag.3"]);
    let states = graph.node(boots).unwrap().states();
    assert!(states.contains(waxed) && !states.contains(State::Dusty), "{states}");
    assert_eq!(polish.describe(&graph).to_string(), "polish leather_boots.2 rag.3");
    let goal: Goal = "Waxed(boots) & !Dusty(boots)".parse().unwrap();
    assert_eq!(goal.to_string(), "Waxed(boots) & !Dusty(boots)");
    assert!(goal.holds(&Situation::new(&graph, me, &History::default())));
    assert_eq!("did polish(boots, rag)".parse::<Goal>().unwrap().to_string(), "did polish(boots, rag)");
    assert!("Polish(boots)".parse::<Goal>().is_err(), "an own verb is a predicate only after `did`");
}

/// A vocabulary with so many states, properties and verbs that there are 200 of each, built-in ones included.
fn two_hundred() -> String {
    let mut text = String::new();
    for n in State::ALL.len() + 1..=200 {
        writeln!(text, "state state_{n} | excludes: dirty | needs: property_{}", n.max(36)).unwrap();
    }
    for n in Property::ALL.len() + 1..=200 {
        writeln!(text, "property property_{n}").unwrap();
    }
    for n in Verb::ALL.len() + 1..=200 {
        writeln!(text, "verb verb_{n} 1 | needs: affords x property_{n}; near x | effects: enter x state_{n}").unwrap();
    }
    text
}

#[test]
fn the_65th_and_the_200th_word_are_words() {
    let words = words(&two_hundred());
    for n in [65, 66, 200] {
        let state: State = format!("state_{n}").parse().unwrap();
        let property: Property = format!("property_{n}").parse().unwrap();
        let (state_200, off) = (State::parse("state_200").unwrap(), StateSet::from_words(&[State::Off, State::Dirty]));
        let set = words.entering(off, state);
        assert!(set.contains(state) && !set.contains(State::Dirty) && set.len() == 2, "{set}");
        assert!(set.intersects(StateSet::from_words(&[state])) && !off.intersects(StateSet::from_words(&[state])));
        assert_eq!(set.iter().collect::<Vec<_>>(), [State::Off, state]);
        assert_eq!(set.with(state_200).without(state_200).contains(state), n != 200);
        assert_eq!(set.minus(StateSet::from_words(&[state])), off.without(State::Dirty));
        let again: StateSet = serde_json::from_str(&serde_json::to_string(&set).unwrap()).unwrap();
        assert_eq!(again, set);

        let class = format!("lump | | | prop | graspable {property} | 0.1 0.1 0.1 | 1 | off dirty | | ");
        let classes = ClassTable::builtin().with_vocabulary(words.clone()).extended("own.txt", &class).unwrap();
        let mut scene = SceneBuilder::with_classes("many", classes.into());
        let room = scene.add(Draft::new("kitchen")).unwrap();
        let lump = scene.add_in(room, Draft::new("lump")).unwrap();
        let me = scene.add_in(room, Draft::new("character")).unwrap();
        let mut graph = scene.build();
        let before = graph.digest();
        let verb = Verb::parse(&format!("verb_{n}")).unwrap();
        act(&mut graph, me, &["walk lump.2"]);
        assert!(legal_actions(&graph, me).contains(&Action::one(verb, lump)));
        let other = Verb::parse("verb_100").unwrap();
        assert!(matches!(refusals(&graph, me, &Action::one(other, lump))[..], [Refusal::NotAfforded(..)]));
        step(&mut graph, me, &Action::one(verb, lump)).unwrap();
        assert!(graph.node(lump).unwrap().is(state));
        assert_ne!(graph.digest(), before);
        let goal: Goal = format!("State{n}(lump) & did verb_{n}(lump)").parse().unwrap();
        assert_eq!(goal.to_string(), format!("State{n}(lump) & did verb_{n}(lump)"));
        let read = native::read(&native::write(&graph), &ClassTable::builtin()).unwrap();
        assert_eq!((read.digest(), &read), (graph.digest(), &graph));
    }
}

/// Bytes, digests and legal actions go by names, so this text is the same in whatever order tests run.
#[test]
fn the_order_of_declaration_changes_no_bytes() {
    let lines =
        ["verb zip 1 | needs: near x", "state zesty", "verb buff 1 | needs: near x", "state bland | excludes: zesty"];
    let scene = |lines: &[&str]| {
        let mut scene =
            SceneBuilder::with_classes("s", ClassTable::builtin().with_vocabulary(words(&lines.join("\n"))).into());
        let room = scene.add(Draft::new("kitchen")).unwrap();
        let [zesty, bland] = ["zesty", "bland"].map(|word| State::parse(word).unwrap());
        let apple = Draft { states: Some(StateSet::from_words(&[zesty, State::Raw])), ..Draft::new("apple") };
        scene.add_in(room, apple.state(bland).state(zesty)).unwrap();
        let me = scene.add_in(room, Draft::new("character")).unwrap();
        let mut scene = scene.build();
        act(&mut scene, me, &["walk apple.2"]);
        scene
    };
    let (first, second) = (scene(&lines), scene(&[lines[3], lines[2], lines[1], lines[0]]));
    assert_eq!(native::write(&first), native::write(&second));
    assert_eq!(first.digest(), second.digest());
    let written = native::write(&first);
    let (start, _) = written.split_once(" \"nodes\"").unwrap();
    assert_eq!(
        start,
        r#"{"virtualcity": 1, "name": "s",
 "words": [
  "state bland | excludes: zesty",
  "state zesty",
  "verb buff 1 | needs: near x",
  "verb zip 1 | needs: near x"],
"#
    );
    let own = |graph: &SceneGraph| -> Vec<String> {
        let legal = legal_actions(graph, graph.agents()[0]);
        legal.iter().filter(|action| !action.verb.is_builtin()).map(Action::to_string).collect()
    };
    assert_eq!(own(&first), ["buff #1", "buff #2", "buff #3", "zip #1", "zip #2", "zip #3"]);
    let mut sorted = legal_actions(&first, first.agents()[0]);
    sorted.sort_unstable();
    assert_eq!(sorted, legal_actions(&first, first.agents()[0]), "verbs are ordered as actions are");
    assert_eq!(first.digest().to_string(), "005598de2a7726b5");
}

#[test]
fn two_scenes_may_have_different_rules_for_one_name() {
    let (mut shines, [boots, _, me]) =
        hallway(words("property polishable\nverb rub 1 | needs: near x | effects: enter x clean"));
    let (mut soils, _) = hallway(words("property polishable\nverb rub 1 | effects: enter x dirty | says: With mud."));
    let (neither, _) = hallway(words("property polishable"));
    let rub = Action::one(Verb::parse("rub").unwrap(), boots);
    assert_eq!(refusals(&shines, me, &rub).len(), 1, "it is not near");
    assert_eq!(refusals(&neither, me, &rub), [Refusal::NoSuchVerb(rub.verb)]);
    assert!(legal_actions(&neither, me).iter().all(|action| action.verb != rub.verb));
    assert!(refusals(&neither, me, &rub)[0].to_string().contains("no verb `rub`"));
    act(&mut shines, me, &["walk leather_boots.2", "rub leather_boots.2"]);
    act(&mut soils, me, &["rub leather_boots.2"]);
    let is = |graph: &SceneGraph, state| graph.node(boots).unwrap().is(state);
    assert!(is(&shines, State::Clean) && is(&soils, State::Dirty));
    assert_ne!(shines, soils);
    // Both survive their files.
    for graph in [&shines, &soils] {
        let plain = graph.classes().with_vocabulary(Vocabulary::builtin()).into();
        assert_eq!(&native::read(&native::write(graph), &plain).unwrap(), graph);
    }
    let error = native::read(&native::write(&shines), soils.classes()).unwrap_err();
    assert!(error.to_string().contains("field `words`: words, line 2: `rub` is declared already"), "{error}");
}

#[test]
fn text_and_vocabulary_are_one() {
    let text = "property polishable
state waxed | excludes: dirty dusty | needs: polishable
verb bow 0 | motion: wave | says: Bows: low.
verb polish 2 | needs: affords x polishable; affords y wiper; holding y; near x | effects: enter x waxed | motion: use_at
verb stow 2 | needs: not_in y hot; related x on y; fits x y; other x; at_rest; holding_kind cutter; encloses y; holding x; accessible y; accepts y; near y | effects: put_into x y; enter_own asleep; stand_up; leave_own asleep | aims: putting
";
    assert_eq!(words(text).to_string(), text);
    let reversed: Vec<&str> = text.lines().rev().collect();
    assert_eq!(words(&reversed.join("\n\n# A comment.\n")), words(text));
    assert_eq!(words(text).extended("more.txt", text).unwrap(), words(text), "a word may be declared again");
    assert_eq!(
        words(text).extended("more.txt", "state waxed").unwrap_err().problem,
        VocabularyProblem::Redeclared("waxed")
    );
    assert!(Vocabulary::builtin().is_builtin() && !words(text).is_builtin() && words("").is_builtin());
}

#[test]
fn errors_say_what_is_wrong() {
    for (text, message) in [
        ("noun x", "`noun x` is no declaration"),
        ("state", "`` is no name of a word"),
        ("state 2nd", "`2nd` is no name of a word"),
        ("state Very_Wet", "`Very_Wet` is no name"),
        ("state dull_", "`dull_` is no name"),
        ("state gew\u{e4}ssert", "is no name"),
        ("state glossy\u{7}", "is no name"),
        ("state soaking wet", "is no declaration"),
        ("state open", "`open` has a meaning already"),
        ("state plugged_i_n", "has a meaning already"),
        ("state grab", "has a meaning already"),
        ("state inside", "has a meaning already"),
        ("state forall", "has a meaning already"),
        ("property surface", "has a meaning already"),
        ("verb walk 1", "has a meaning already"),
        ("verb puton 1", "has a meaning already"),
        ("verb bend", "`` is no number of things"),
        ("verb bend 3", "`3` is no number of things"),
        ("verb bend 1 | needs: naer x", "unknown condition `naer` (did you mean `near`"),
        ("verb bend 1 | needs: near", "`near` has too few words or too many"),
        ("verb bend 1 | needs: near x y", "too few words or too many"),
        ("verb bend 1 | needs: near z", "`z` is no thing of an action"),
        ("verb bend 1 | needs: near y", "`bend` takes one thing, so there is no `y`"),
        ("verb bend 1 | needs: in x bendd", "unknown state `bendd`"),
        ("verb bend 1 | effects: pose_as x aim", "effects of an aim are not written"),
        ("verb bend 1 | effects: enter x opened; ", "unknown state `opened`"),
        ("verb bend 1 | effects: leave x closed", "bodies tell what is closed: write `sit_on`"),
        ("verb flump 0 | effects: enter_own sitting", "bodies tell what is sitting"),
        ("state creaky | excludes: dirty open", "bodies tell what is open"),
        ("verb bend 1 | aims: putting", "the aims `putting` are for verbs with 2 things"),
        ("verb bend 1 | aims: flying", "unknown set of aims `flying`"),
        ("verb bend 1 | motion: fly", "unknown motion `fly`"),
        ("verb bend 1 | tool: knife", "`tool` is no field of a verb: it has `needs`, `effects`"),
        ("property soft | needs: x", "`needs` is no field of a property: it has none"),
        ("verb bend 1 | says: a | says: b", "`says` is given twice"),
    ] {
        let error = Vocabulary::parse("words.txt", &format!("# Words.\n{text}")).unwrap_err();
        assert!(error.to_string().contains(message), "{text}: {error}");
        assert_eq!((error.file.as_str(), error.line), ("words.txt", 2), "{text}");
    }
    words("state waxed\nverb bend 1");
    assert_eq!(
        problem("verb bow 0 | needs: in y waxed"),
        VocabularyProblem::NoSuchThing { verb: "bow".into(), things: 0, thing: "y" }
    );
    assert_eq!(problem("verb bend 1 | effects: enter x waxed"), VocabularyProblem::Undeclared("waxed"));
    let spelling = problem("state wa_xed").to_string();
    assert!(spelling.contains("is spelled `waxed` elsewhere"), "{spelling}");
    let things = problem("verb bend 2").to_string();
    assert!(things.contains("takes one thing elsewhere in this program, not 2"), "{things}");
    let unknown = State::parse("moonlit").unwrap_err().to_string();
    assert!(unknown.ends_with("; your own are declared in a `Vocabulary` first"), "{unknown}");
}

/// A misspelt word is held against own ones, too.
#[test]
fn misspelt_own_words() {
    words("state varnished\nverb varnish 1 | effects: enter x varnished\npredicate gleaming ?x | is: Varnished(?x)");
    let goal = |text: &str| text.parse::<Goal>().unwrap_err().to_string();
    for (told, meant) in [
        ("varnsh cup.3".parse::<Action>().unwrap_err().to_string(), "unknown verb `varnsh` (did you mean `varnish`?)"),
        (State::parse("varnishd").unwrap_err().to_string(), "unknown state `varnishd` (did you mean `varnished`?)"),
        (goal("Varnishd(cup)"), "unknown predicate `Varnishd` (did you mean `varnished`?)"),
        (goal("Gleamin(cup)"), "unknown predicate `Gleamin` (did you mean `gleaming`?)"),
        (goal("did varnsh(cup)"), "unknown verb `varnsh` after `did` (did you mean `varnish`?)"),
        (problem("verb gild 1 | effects: enter x varnishd").to_string(), "(did you mean `varnished`?)"),
    ] {
        assert!(told.contains(meant), "{told}");
    }
}

#[test]
fn words_that_a_scene_lacks_are_found() {
    let (graph, [boots, ..]) = hallway(words(POLISH));
    let written = native::write(&graph);
    let (head, rest) = written.split_once(" \"words\"").unwrap();
    let (_, rest) = rest.split_once("],\n").unwrap();
    let error = native::read(&format!("{head}{rest}"), &ClassTable::builtin()).unwrap_err();
    assert!(error.to_string().contains("`polishable` is not declared"), "{error}");
    let mut other = graph;
    other.set_vocabulary(words(""));
    assert!(other.validate().contains(&Violation::UndeclaredWord(other.label(boots), "polishable")));
}

/// Own verbs over the flat's things: on the agent, on one thing, on two.
const MORE: &str = "
    state zesty | excludes: clean
    verb bow 0 | needs: upright
    verb buff 1 | needs: tangible x; near x; free_hand_or_holding x | effects: enter x zesty
    verb dip 2 | needs: holding x; receives y; near y; fits x y | effects: enter x wet; enter y dirty
    verb stack 2 | needs: carries y; fits x y; holding x; accessible y; near y | effects: put_on x y | aims: putting
";

/// Every action of every verb with all objects.
fn every_action(graph: &SceneGraph) -> Vec<Action> {
    let ids: Vec<NodeId> = graph.nodes().map(Node::id).collect();
    let of = |verb: Verb| -> Vec<Action> {
        let two = |x: &NodeId| ids.iter().map(|y| Action::two(verb, *x, *y)).collect::<Vec<_>>();
        match verb.arity() {
            0 => vec![Action::zero(verb)],
            1 => ids.iter().map(|id| Action::one(verb, *id)).collect(),
            _ => ids.iter().flat_map(two).collect(),
        }
    };
    graph.vocabulary().verbs().flat_map(of).collect()
}

/// The needs of a verb, as words.
fn needs(text: &str) -> String {
    let all = words(text);
    let line = all.lines().find(|line| line.starts_with("verb")).unwrap();
    let needs = line.split(" | ").find_map(|field| field.strip_prefix("needs: "));
    needs.unwrap_or_default().to_owned()
}

/// An effect has the needs of the built-in verb, but for those that an earlier one brings about.
#[test]
fn effects_need_what_the_verb_with_such_an_effect_needs() {
    let cases = [
        ("effects: hold x", "graspable x; not_elsewhere_held x; accessible x; free_hand_or_holding x; near x"),
        (
            "effects: go_to x; hold x",
            "reachable x; other x; upright; graspable x; not_elsewhere_held x; accessible x; free_hand_or_holding x",
        ),
        ("needs: near x | effects: let_go x; enter x clean", "near x; holding x"),
        ("effects: enter x folded", "affords x foldable; accessible x; near x"),
        ("effects: fill_with_water x", "affords x recipient; holding x"),
        ("effects: enter x dirty; leave x hot", ""),
    ];
    for (n, (fields, expected)) in cases.into_iter().enumerate() {
        assert_eq!(needs(&format!("verb implied_{n} 1 | {fields}")), expected, "{fields}");
    }
    assert_eq!(
        needs("verb implied_swap 2 | effects: put_on y x"),
        "carries x; fits y x; holding y; accessible x; near x",
        "things in the other order"
    );
    assert_eq!(needs("verb implied_rest 1 | effects: stand_up; lie_on x").split("; ").next(), Some("at_rest"));
}

proptest! {
    #![proptest_config(cases(12))]

    /// Legal actions are those without a refusal, own ones as well, and the scene stays valid after them.
    #[test]
    fn legal_actions_with_own_verbs(picks in prop::collection::vec(any::<(bool, usize)>(), 0..12)) {
        let flat = Flat::new();
        let (mut graph, me) = (flat.graph().clone(), flat.me);
        graph.set_vocabulary(words(MORE));
        for (own, pick) in picks {
            let mut legal = legal_actions(&graph, me);
            let expected: Vec<Action> =
                every_action(&graph).into_iter().filter(|a| refusals(&graph, me, a).is_empty()).collect();
            prop_assert_eq!(&legal, &expected);
            if own {
                legal.retain(|action| !action.verb.is_builtin());
            }
            let Some(action) = legal.get(pick % legal.len().max(1)) else { continue };
            let changes = step(&mut graph, me, action).unwrap();
            prop_assert_eq!(graph.validate(), []);
            let mut back = graph.clone();
            changes.undo(&mut back).unwrap();
            changes.apply(&mut back).unwrap();
            prop_assert_eq!(back, graph.clone());
        }
    }

    /// Whatever the text, reading ends with words or a reason, and words are written as they are read.
    #[test]
    fn any_text_is_read_or_refused(text in "(state|verb|property|#)? ?(bow|buff|zesty|open|)[ 0-3]{0,2}( \\| (needs|effects|says|aims|motion):? ?[a-z_;:. ]{0,20}){0,3}") {
        if let Ok(read) = Vocabulary::parse("any", &text) {
            prop_assert_eq!(Vocabulary::parse("again", &read.to_string()).unwrap(), read);
        }
    }
}
