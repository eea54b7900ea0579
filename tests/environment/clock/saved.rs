//! A home that is saved in any tick of an action goes on as if it had not been.

use virtualcity::graph::clock::{Durations, ProcessTable, Span};
use virtualcity::graph::{Action, ClassTable, NodeId, Place, Property, Relation, State, Verb};
use virtualcity::relations::RelationRule;
use virtualcity::{Ending, Environment, PictureOptions, SaveError, physics};

use super::super::act;
use super::{LONG, home};

/// Ticks between two saves.
const EVERY: Span = Span(10);

/// A home in which an action is about to begin, and the orders of its agents.
type Case = fn() -> (Environment, Vec<(NodeId, Action)>);

fn first(home: &Environment, class: &str) -> NodeId {
    home.graph().of_class(class)[0]
}

/// Puts a new thing onto something, and lets an agent take it.
fn fetch(home: &mut Environment, agent: NodeId, class: &str, at: NodeId) -> NodeId {
    let thing = home.spawn(class, Place { relation: Relation::On, at }).unwrap();
    act(home, agent, Verb::Walk, &[thing]);
    act(home, agent, Verb::Grab, &[thing]);
    thing
}

const CASES: &[(&str, Case)] = &[
    ("cloth is folded", || {
        let mut home = home(24, 1);
        let (me, duvet) = (home.agents()[0], first(&home, "duvet"));
        act(&mut home, me, Verb::Walk, &[duvet]);
        act(&mut home, me, Verb::Grab, &[duvet]);
        let table = first(&home, "nightstand");
        (home, vec![(me, Action::place(duvet, table))])
    }),
    ("a drink is poured", || {
        let mut home = home(42, 1);
        let (me, table) = (home.agents()[0], first(&home, "coffee_table"));
        let cup = home.spawn("cup", Place { relation: Relation::On, at: table }).unwrap();
        let bottle = fetch(&mut home, me, "bottled_water", table);
        act(&mut home, me, Verb::Walk, &[cup]);
        (home, vec![(me, Action::two(Verb::Pour, bottle, cup))])
    }),
    ("an apple is cut", || {
        let mut home = home(42, 1);
        let (me, table) = (home.agents()[0], first(&home, "coffee_table"));
        let apple = home.spawn("apple", Place { relation: Relation::On, at: table }).unwrap();
        fetch(&mut home, me, "knife", table);
        act(&mut home, me, Verb::Walk, &[apple]);
        (home, vec![(me, Action::one(Verb::Cut, apple))])
    }),
    ("a lamp is switched", || {
        let mut home = home(42, 1);
        let me = home.agents()[0];
        let is_off = |n: &virtualcity::graph::Node| n.affords(Property::Switchable) && n.is(State::Off);
        let lamp = home.graph().nodes().find(|n| is_off(n)).unwrap().id();
        act(&mut home, me, Verb::Walk, &[lamp]);
        (home, vec![(me, Action::one(Verb::SwitchOn, lamp))])
    }),
    ("a thing is put into a fridge while another walks", || {
        let mut home = home(42, 2);
        let (a, b, fridge) = (home.agents()[0], home.agents()[1], first(&home, "fridge"));
        let table = first(&home, "coffee_table");
        let apple = fetch(&mut home, a, "apple", table);
        act(&mut home, a, Verb::Walk, &[fridge]);
        act(&mut home, a, Verb::Open, &[fridge]);
        (home, vec![(a, Action::put_in(apple, fridge)), (b, Action::walk(table))])
    }),
    ("one makes way for another, who walks to the fridge", || {
        let home = home(42, 2);
        let (a, fridge) = (home.agents()[0], first(&home, "fridge"));
        (home, vec![(a, Action::walk(fridge))])
    }),
    ("a hat is taken off", || {
        let mut home = home(42, 1);
        let (me, table) = (home.agents()[0], first(&home, "coffee_table"));
        let hat = fetch(&mut home, me, "hat", table);
        act(&mut home, me, Verb::Wear, &[hat]);
        (home, vec![(me, Action::one(Verb::TakeOff, hat))])
    }),
    ("a fridge is opened while another sits down", || {
        let mut home = home(42, 2);
        let (a, b, fridge) = (home.agents()[0], home.agents()[1], first(&home, "fridge"));
        let sofa = first(&home, "sofa");
        act(&mut home, a, Verb::Walk, &[fridge]);
        act(&mut home, b, Verb::Walk, &[sofa]);
        (home, vec![(a, Action::open(fridge)), (b, Action::one(Verb::Sit, sofa))])
    }),
];

/// How the actions of a home end, and the home then.
fn goes_on(mut home: Environment) -> (Vec<Ending>, Environment) {
    let endings = home.step_until_idle(LONG);
    (endings, home)
}

/// The agent without orders in one of the cases does step aside.
#[test]
fn one_makes_way_in_a_case() {
    let (_, case) = CASES.iter().find(|(name, _)| name.starts_with("one makes way")).unwrap();
    let (mut home, orders) = case();
    let other = *home.agents().iter().find(|agent| orders.iter().all(|(ordered, _)| ordered != *agent)).unwrap();
    let stood = home.world().pose(other).unwrap().translation;
    orders.iter().for_each(|(agent, action)| home.give(*agent, *action));
    let mut farthest: f32 = 0.0;
    while home.is_busy() {
        drop(home.step(EVERY));
        let now = home.moment().world().pose(other).unwrap().translation;
        farthest = farthest.max((now.vector - stood.vector).norm());
    }
    assert!(farthest > 0.2, "{farthest}");
}

#[test]
fn saved_in_every_tenth_tick() {
    for (name, case) in CASES {
        let (mut home, orders) = case();
        let (begin, still) = (home.tick(), home.save().unwrap().len());
        orders.iter().for_each(|(agent, action)| home.give(*agent, *action));
        let (told, end) = goes_on(home.clone());
        assert!(told.iter().all(|ending| ending.outcome.is_ok()), "{name}: {told:?}");
        let last = end.save().unwrap();
        let mut endings = Vec::new();
        while home.is_busy() {
            let at = format!("{name}, after {} ticks", (home.tick() - begin).0);
            let saved = home.save().unwrap();
            assert!(saved.len() < still + (1 << 20), "{at}: {} bytes more", saved.len() - still);
            let again = home.restore(&saved).unwrap();
            assert_eq!(again.digest(), home.digest(), "{at}");
            assert_eq!(again.changes(), home.changes(), "{at}");
            assert!(again.save().unwrap() == saved, "{at}: saved again it differs");
            let (after, other) = goes_on(again);
            assert_eq!([endings.as_slice(), &after].concat(), told, "{at}");
            assert!(*other.graph() == *end.graph(), "{at}: the graph differs");
            assert_eq!(other.world().digest(), end.world().digest(), "{at}");
            assert_eq!(other.changes(), end.changes(), "{at}");
            assert!(other.save().unwrap() == last, "{at}: the bytes differ");
            endings.extend(home.step(EVERY));
        }
    }
}

/// The name by which an action calls its thing is checked when the action begins, also in a home that has been saved before.
#[test]
fn a_saved_action_keeps_the_names_that_it_uses() {
    let mut home = Environment::make("apartment/3", 1).unwrap();
    let (me, fridge) = (home.agents()[0], first(&home, "fridge"));
    home.give(me, format!("walk mug.{}", fridge.0).parse().unwrap());
    let mut restored = home.restore(&home.save().unwrap()).unwrap();
    let outcomes = [&mut home, &mut restored].map(|home| home.step(Span(1000)));
    assert!(outcomes.iter().all(|endings| endings[0].outcome.is_err()));
    assert_eq!(home.digest(), restored.digest());
}

/// A save goes on only under the settings that it was made under, and says which one differs; what does not change what
/// follows may be set otherwise.
#[test]
fn a_save_is_of_its_settings() {
    let plain = || Environment::builder("apartment/3");
    let saved = plain().make().unwrap().save().unwrap();
    let classes = ClassTable::builtin();
    let longer = Durations::builtin().extended("mine.txt", "eat | * | 3 min", &classes).unwrap();
    let slower =
        ProcessTable::builtin().extended("mine.txt", "cooling | * | hot | | | -hot | | | 5 h", &classes).unwrap();
    let stiff = physics::Settings { hinge_friction: 0.5, ..physics::Settings::default() };
    for (name, other) in [
        ("gravity", plain().gravity(1.62)),
        ("physics.hinge_friction", plain().physics(stiff)),
        ("tolerance", plain().tolerance(0.01)),
        ("relations", plain().relations(RelationRule::VirtualHome)),
        ("begins_at", plain().hour(7.0)),
        ("bodies", plain().bodies(false)),
        ("processes_at_once", plain().processes_at_once()),
        ("durations", plain().durations(longer)),
        ("processes", plain().processes(slower)),
    ] {
        let other = other.make().unwrap();
        let error = other.restore(&saved).unwrap_err();
        assert!(matches!(&error, SaveError::OtherSetting { setting, .. } if setting == name), "{name}: {error}");
        let again = other.restore(&other.save().unwrap()).unwrap();
        assert_eq!(again.digest(), other.digest(), "{name}");
    }
    let eyes = PictureOptions { eye_height: Some(0.5), ..PictureOptions::default() };
    assert!(plain().pictures(eyes).threads(1).make().unwrap().restore(&saved).is_ok());
    let two = plain().agents(2).make().unwrap();
    assert!(matches!(two.restore(&saved), Err(SaveError::OtherStart { .. })));
}

/// The longest span ends with the last tick that can be counted.
#[test]
fn the_longest_span_has_an_end() {
    let mut home = Environment::make("apartment/3", 1).unwrap();
    home.step(Span::MAX);
    let last = home.tick();
    home.step(Span::MAX);
    home.step_until_idle(Span::MAX);
    assert_eq!(home.tick(), last);
}
