//! Verbs, states and properties of one's own in homes with bodies: they are planned, done, saved and seen as built-in ones.

mod by_chance;

use virtualcity::Environment;
use virtualcity::graph::asset::Hold;
use virtualcity::graph::clock::{Durations, Span};
use virtualcity::graph::{
    Action, Node, NodeId, Place, Pose, Property, Refusal, Relation, SceneGraph, Seed, State, Verb, Vocabulary, Word,
    rule,
};
use virtualcity::physics::Posture;
use virtualcity::planner::{PlannerPolicy, run_episode};
use virtualcity::procgen::Apartment;
use virtualcity::tasks::{Outcome, Task};
use virtualcity::{ActionError, Ending};

const WORDS: &str = "
    property polishable
    state shiny | excludes: dusty dirty | needs: polishable
    verb polish 2 | needs: affords x polishable; holding y; accessible x; near x | effects: enter x shiny | motion: use_at
    verb bow 0 | needs: upright | motion: stretch
    verb stow 2 | needs: carries y; fits x y; holding x; accessible y; near y | effects: put_on x y | aims: putting
";

/// A generated home with these words, in which tables have all own affordances.
fn home(seed: u64, words: &str) -> Environment {
    let mut scene = Apartment::from_seed(Seed(seed)).unwrap().scene();
    scene.set_vocabulary(Vocabulary::parse("words.txt", words).unwrap());
    let (tables, own) = (scene.of_class("table"), scene.vocabulary().own_properties().to_vec());
    let mut edit = scene.edit();
    for (table, property) in tables.into_iter().flat_map(|table| own.iter().map(move |own| (table, *own))) {
        edit.allow(table, property).unwrap();
    }
    edit.commit();
    // Wiping takes no longer than it is shown.
    Environment::builder_from_scene(scene).durations(Durations::default()).make().unwrap()
}

fn task(goal: &str) -> Task {
    Task::new(goal, goal.parse().unwrap())
}

/// The actions of an episode in which the best planner reaches a goal.
fn won(home: &mut Environment, goal: &str) -> Vec<String> {
    let episode = run_episode(&mut PlannerPolicy::best(), &task(goal), home);
    assert_eq!(episode.outcome, Outcome::Won, "{goal}: {:?}", episode.reason);
    home.history().events().iter().map(|event| event.action.to_string()).collect()
}

#[test]
fn the_planner_reaches_a_goal_by_an_own_verb() {
    for seed in [9, 42, 7] {
        let mut first = home(seed, WORDS);
        let begun = first.clone();
        let table = first.graph().of_class("coffee_table").first().copied().or(first.graph().first_of_class("table"));
        let goal = format!("Shiny(#{})", table.unwrap().0);
        let actions = won(&mut first, &goal);
        assert!(actions.iter().any(|action| action.starts_with("polish ")), "{actions:?}");
        assert!(first.graph().node(table.unwrap()).unwrap().is(State::parse("shiny").unwrap()));
        let mut again = begun;
        assert_eq!(won(&mut again, &goal), actions);
        assert_eq!(again.digest(), first.digest());
    }
}

#[test]
fn effects_of_own_verbs_are_done_by_bodies() {
    let mut home = home(42, WORDS);
    let goal = "did stow(cup, table) & did bow()";
    let actions = won(&mut home, goal);
    assert!(actions.iter().any(|action| action.starts_with("stow ")), "{actions:?}");
    let stowed = home.history().events().iter().find(|event| event.action.verb.as_str() == "stow").unwrap().action;
    let (cup, table) = (stowed.object.unwrap(), stowed.target.unwrap());
    assert_eq!(home.graph().place(cup).map(|place| place.at), Some(table));
    let [cup, top] = [cup, table].map(|id| home.world().aabb(id).unwrap());
    assert!((cup.min.z - top.max.z).abs() < 0.05, "the cup stands on the table: {} {}", cup.min.z, top.max.z);
}

/// The legal actions with own verbs are those without a refusal.
#[test]
fn legal_actions_have_own_verbs() {
    let mut home = home(42, WORDS);
    won(&mut home, "Holds(cup)");
    let (me, graph) = (home.agents()[0], home.graph().clone());
    let ids: Vec<NodeId> = graph.nodes().map(|node| node.id()).collect();
    let all = |verb: Verb| match verb.arity() {
        0 => vec![Action::zero(verb)],
        _ => ids.iter().flat_map(|x| ids.iter().map(move |y| Action::two(verb, *x, *y))).collect::<Vec<_>>(),
    };
    let own = graph.vocabulary().own_rules().iter().flat_map(|rule| all(rule.verb));
    let expected: Vec<Action> = own.filter(|action| rule::allows(&graph, me, action)).collect();
    let legal = home.legal_actions(me).into_iter().filter(|action| !action.verb.is_builtin());
    assert_eq!(legal.collect::<Vec<_>>(), expected);
    assert!(expected.contains(&"bow".parse().unwrap()));
}

/// The poses of a held thing from tick to tick while an action is done in a copy of the home.
fn shown(home: &Environment, action: Action, held: NodeId) -> Vec<Pose> {
    let (mut home, mut poses) = (home.clone(), Vec::new());
    let me = home.agents()[0];
    let watch = |now: &Environment| poses.push(now.world().pose(held).unwrap());
    home.set_action_in_time(me, action, Span(1), watch).unwrap();
    poses
}

/// A body shows an own verb by the motion that its rule names: polishing looks as wiping does, and bowing does not.
#[test]
fn own_verbs_are_shown_by_their_motion() {
    let mut home = home(42, WORDS);
    won(&mut home, "Holds(cup) & Near(coffee_table)");
    let me = home.agents()[0];
    let (cup, table) = (home.graph().held(me).next().unwrap(), home.graph().of_class("coffee_table")[0]);
    let polish = shown(&home, Action::two(Verb::parse("polish").unwrap(), table, cup), cup);
    let wipe = shown(&home, Action::one(Verb::Wipe, table), cup);
    assert!(polish.len() > 60 && polish[..60] == wipe[..60]);
    let top = home.world().aabb(table).unwrap();
    let far = |poses: &[Pose]| {
        let distances = poses
            .iter()
            .map(|pose| (top.nearest(&pose.translation.vector.into()) - pose.translation.vector).coords.norm());
        distances.fold(f32::INFINITY, f32::min)
    };
    let bow = shown(&home, Action::zero(Verb::parse("bow").unwrap()), cup);
    assert!(far(&polish) < 0.15 && far(&bow) > 0.3, "{} {}", far(&polish), far(&bow));
}

/// Verbs that are built-in ones by another name.
const NAMESAKES: &str = "
    verb stow 2 | needs: encloses y; fits x y; holding x; accessible y; accepts y; near y | effects: put_into x y | aims: putting
    verb hurry 1 | needs: reachable x; other x; upright | effects: go_to x | aims: going | motion: run
    verb front 1 | needs: other x | effects: face x | aims: turning | motion: look
";

/// An action with another verb.
fn by_name(verb: &str, action: Action) -> Action {
    Action { verb: Verb::parse(verb).unwrap(), ..action }
}

/// Does an action by its own verb and by the built-in one in copies of a home; both end in the same scene and tick.
fn alike(home: &Environment, own: &str, action: Action) -> Result<Environment, ActionError> {
    let (mut named, mut builtin, me) = (home.clone(), home.clone(), home.agents()[0]);
    let done = [named.set_action(me, by_name(own, action)), builtin.set_action(me, action)];
    assert_eq!(done[0].is_ok(), done[1].is_ok(), "{action}: {done:?}");
    assert!(named.graph() == builtin.graph() && named.tick() == builtin.tick(), "{action}");
    let [done, _] = done;
    done.map(|_| named)
}

/// Slots are those of the inside for a verb that puts into things: the rule and bodies go by the effect.
#[test]
fn own_verbs_put_things_into_slots() {
    let mut home = home(42, NAMESAKES);
    won(&mut home, "Holds(cup)");
    let (me, graph) = (home.agents()[0], home.graph().clone());
    let cup = graph.held(me).next().unwrap();
    let shelves = |id: NodeId| {
        let asset = graph.node(id).and_then(|node| graph.assets().get(node.spec().asset?));
        asset.map_or(0, |asset| asset.surfaces.iter().filter(|surface| surface.hold == Hold::Inside).count())
    };
    let shelved = |node: &&Node| node.affords(Property::Container) && shelves(node.id()) > 2;
    let mut put = 0;
    for at in graph.nodes().filter(shelved).map(Node::id) {
        let mut home = home.clone();
        let closed = graph.node(at).unwrap().is(State::Closed);
        let near = home.set_action(me, Action::walk(at)).is_ok();
        if !near || closed && home.set_action(me, Action::open(at)).is_err() {
            continue;
        }
        for slot in 1..=shelves(at) as u16 + 1 {
            let put_in = Action::put_in(cup, at).in_slot(slot);
            let (stow, mut symbolic) = (by_name("stow", put_in), home.graph().clone());
            let allowed = rule::step(&mut symbolic, me, &stow);
            assert_eq!(allowed.is_ok(), rule::allows(home.graph(), me, &put_in), "{stow}: {allowed:?}");
            if let Ok(home) = alike(&home, "stow", put_in) {
                for graph in [&symbolic, home.graph()] {
                    assert!(graph.related(cup, Relation::Inside).any(|id| id == at));
                }
                put += 1;
            }
        }
    }
    assert!(put > 3, "{put}");
}

/// Feet run for a verb with that motion, and who sits turns by no verb that turns the body.
#[test]
fn own_verbs_run_and_turn() {
    let mut home = home(42, NAMESAKES);
    let (me, sofa) = (home.agents()[0], home.graph().first_of_class("sofa").unwrap());
    let mut walker = home.clone();
    walker.set_action(me, Action::walk(sofa)).unwrap();
    home = alike(&home, "hurry", Action::one(Verb::Run, sofa)).unwrap();
    assert!(home.tick() < walker.tick(), "{:?} {:?}", home.tick(), walker.tick());
    let yaw = |verb: &str| format!("{verb} yaw 90").parse::<Action>().unwrap();
    alike(&home, "front", yaw("turn_to")).unwrap();
    home.set_action(me, Action::one(Verb::Sit, sofa)).unwrap();
    let refused = home.set_action(me, yaw("front")).unwrap_err();
    assert!(matches!(&refused, ActionError::Refused(why) if matches!(why[..], [Refusal::NotUpright(_)])), "{refused}");
}

/// Verbs that bring about nothing, with the motions of verbs that do.
const SHOWN: &str = "
    verb visit 1 | needs: upright; near x | motion: go
    verb weigh 1 | needs: near x | motion: hold
    verb try_out 1 | needs: upright; near x | motion: sit
";

/// The moments of an action that brings nothing about; in the end all but the agent is as before.
fn moments(home: &mut Environment, verb: &str, thing: NodeId) -> Vec<Environment> {
    let (me, before, mut seen) = (home.agents()[0], home.graph().clone(), Vec::new());
    let action = Action::one(Verb::parse(verb).unwrap(), thing);
    let mut at_once = home.clone();
    at_once.set_action(me, action).unwrap();
    home.set_action_in_time(me, action, Span(6), |now| seen.push(now.clone())).unwrap();
    assert_eq!(home.digest(), at_once.digest(), "{action}");
    let said = |graph: &SceneGraph, id: NodeId| {
        (graph.node(id).unwrap().states(), graph.places(id).collect::<Vec<_>>(), graph.holder(id))
    };
    for id in before.nodes().map(Node::id) {
        assert_eq!(said(home.graph(), id), said(&before, id), "{action}");
    }
    seen
}

/// Whoever goes without an effect that says so goes up to what is near.
#[test]
fn feet_go_up_to_what_is_near() {
    let mut home = home(42, SHOWN);
    let (me, fridge) = (home.agents()[0], home.graph().first_of_class("fridge").unwrap());
    home.set_action(me, Action::walk(fridge)).unwrap();
    let far = |home: &Environment| home.graph().distance(me, fridge).unwrap();
    let close = far(&home);
    // A step back.
    let feet = home.world().pose(me).unwrap().translation.vector.xy();
    let way = feet - home.world().aabb(fridge).unwrap().centre().xy().coords;
    let back = home.floor().nearest((feet + 0.7 * way.normalize()).into(), 0.5).unwrap();
    home.teleport(me, back).unwrap();
    let before = far(&home);
    assert!(home.graph().near(me, fridge) && before > close + 0.3, "{close} {before}");
    let seen = moments(&mut home, "visit", fridge);
    assert!(far(&home) < close + 0.1, "{} {close}", far(&home));
    let on_the_way = |now: &Environment| (close + 0.15..before - 0.1).contains(&far(now));
    assert!(seen.iter().any(on_the_way), "{:?}", seen.iter().map(far).collect::<Vec<_>>());
}

/// A thing is in the hand in the middle of the gesture, and then where it was.
#[test]
fn a_hand_holds_for_the_time_of_a_gesture() {
    let mut home = home(42, SHOWN);
    let (me, table) = (home.agents()[0], home.graph().first_of_class("coffee_table").unwrap());
    let cup = home.spawn("cup", Place { relation: Relation::On, at: table }).unwrap();
    home.set_action(me, Action::walk(cup)).unwrap();
    let lay = home.world().pose(cup).unwrap();
    let seen = moments(&mut home, "weigh", cup);
    assert_eq!(home.world().pose(cup), Some(lay));
    let middle = &seen[seen.len() / 2];
    let holder = middle.world().holder(cup).map(|(by, hand)| (by, hand.relation()));
    let said = middle.graph().holder(cup).map(|place| (place.at, place.relation));
    assert!(holder.is_some_and(|(by, _)| by == me) && holder == said, "{holder:?} {said:?}");
    let moved = |now: &Environment| (now.world().pose(cup).unwrap().translation.vector - lay.translation.vector).norm();
    assert!(moved(middle) > 0.1, "{}", moved(middle));
    assert!(moved(&seen[0]) < 1e-3 && moved(seen.last().unwrap()) < 1e-3);
    // A table is not taken: it is touched.
    let seen = moments(&mut home, "weigh", table);
    assert!(seen.iter().all(|now| now.world().holder(table).is_none()));
}

/// The body sits in the middle of the gesture, and then stands where it stood.
#[test]
fn a_body_sits_for_the_time_of_a_gesture() {
    let mut home = home(42, SHOWN);
    let (me, sofa) = (home.agents()[0], home.graph().first_of_class("sofa").unwrap());
    home.set_action(me, Action::walk(sofa)).unwrap();
    let seen = moments(&mut home, "try_out", sofa);
    let stood = home.world().pose(me);
    let middle = &seen[seen.len() / 2];
    assert!(matches!(middle.world().posture(me), Some(Posture::Sitting(on, _)) if on == sofa));
    assert!(middle.graph().node(me).unwrap().is(State::Sitting));
    assert_eq!(home.world().posture(me), Some(Posture::Standing));
    assert_eq!(seen.last().unwrap().world().pose(me), stood);
    // Nobody sits on what has no seat.
    let table = home.graph().first_of_class("coffee_table").unwrap();
    home.set_action(me, Action::walk(table)).unwrap();
    let seen = moments(&mut home, "try_out", table);
    assert!(seen.iter().all(|now| now.world().posture(me) == Some(Posture::Standing)));
}

/// In the middle of an own action the environment is saved, restored and goes on as the first.
#[test]
fn own_actions_are_saved_and_restored() {
    let mut home = home(42, WORDS);
    let begun = home.clone();
    won(&mut home, "Holds(cup)");
    let (me, graph) = (home.agents()[0], home.graph());
    let (cup, table) = (graph.held(me).next().unwrap(), graph.first_of_class("table").unwrap());
    home.set_action(me, Action::walk(table)).unwrap();
    home.give(me, Action::two(Verb::parse("polish").unwrap(), table, cup));
    home.step(Span(30));
    let mut again = begun.restore(&home.save().unwrap()).unwrap();
    for home in [&mut home, &mut again] {
        let endings = home.step_until_idle(Span(6000));
        assert!(matches!(&endings[..], [Ending { outcome: Ok(_), .. }]), "{endings:?}");
        assert!(home.graph().node(table).unwrap().is(State::parse("shiny").unwrap()));
    }
    assert_eq!(again.digest(), home.digest());
    assert!(again.save().unwrap() == home.save().unwrap());
}

#[test]
fn a_verb_that_the_scene_lacks_is_refused() {
    Vocabulary::parse("words.txt", WORDS).unwrap();
    let mut home = super::home(7, 1);
    let (me, bow) = (home.agents()[0], "bow".parse::<Action>().unwrap());
    let before = home.digest();
    let refused = home.set_action(me, bow).unwrap_err();
    assert!(matches!(&refused, ActionError::Refused(why) if why[..] == [Refusal::NoSuchVerb(bow.verb)]), "{refused:?}");
    assert_eq!(home.digest(), before);
}
