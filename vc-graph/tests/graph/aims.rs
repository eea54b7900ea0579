//! Points, headings, seats, slots and sides of actions: their text, their rule, and what they bring about.
#![allow(clippy::unwrap_used)]

use nalgebra::Point3;
use proptest::prelude::*;
use vc_graph::asset::{Hold, Surface};
use vc_graph::format::program::{self, Program};
use vc_graph::rule::table::RULES;
use vc_graph::{
    Action, ActionTextError, Aim, AimError, AimPart, AimPoint, Asset, AssetLibrary, Bounds, Draft, Effect, Heading,
    NodeId, Place, Pose, Refusal, Relation, SceneBuilder, SceneGraph, Semantics, Side, Simulator, Verb, Vocabulary,
    Word, rule,
};
use vc_testkit::cases;
use vc_testkit::goals::words;

fn part() -> impl Strategy<Value = AimPart> {
    prop_oneof![
        any::<u16>().prop_map(AimPart::Seat),
        any::<u16>().prop_map(AimPart::Slot),
        words::<Side>().prop_map(AimPart::Side),
    ]
}

/// Numbers of all sizes, as a program would have them.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![-10.0..10.0, -1e6..1e6, (-5000_i32..5000).prop_map(|thousandths| f64::from(thousandths) / 1000.0)]
}

fn aim() -> impl Strategy<Value = Aim> {
    let point = prop::option::of((number(), number(), prop::option::of(number())));
    (point, prop::option::of(number()), prop::option::of(part())).prop_map(|(point, degrees, part)| {
        let aim = point.map_or(Aim::NOTHING, |(x, y, z)| Aim::NOTHING.with_point(AimPoint::new(x, y, z).unwrap()));
        let aim = degrees.map_or(aim, |degrees| aim.with_heading(Heading::new(degrees).unwrap()));
        part.map_or(aim, |part| aim.with_part(part))
    })
}

fn action() -> impl Strategy<Value = Action> {
    (words::<Verb>(), any::<u32>(), any::<u32>(), aim()).prop_map(|(verb, x, y, aim)| {
        let alone = RULES[verb.index()].aims.stands_for_object(&aim) && x % 2 == 0;
        let things = if alone { 0 } else { verb.arity() };
        Action::with_aim(verb, &[NodeId(x), NodeId(y)][..things], aim).unwrap()
    })
}

proptest! {
    #![proptest_config(cases(1000))]

    #[test]
    fn aims_read_back(action in action()) {
        let text = action.to_string();
        prop_assert_eq!(text.parse::<Action>(), Ok(action), "{}", text);
        let json = serde_json::to_string(&action).unwrap();
        prop_assert_eq!(serde_json::from_str::<Action>(&json).unwrap(), action);
    }

    #[test]
    fn aims_read_back_in_programs(actions in prop::collection::vec(action(), 0..6)) {
        let program = Program::from_actions(actions);
        let again = program::read(&program::write_native(&program, &home().graph)).unwrap();
        prop_assert!(again.actions().eq(program.actions()), "{:?}", again);
    }

    #[test]
    fn numbers_are_met(x in number(), degrees in -720.0..720.0_f64) {
        let (point, heading) = (AimPoint::new(x, x, Some(x)).unwrap(), Heading::new(degrees).unwrap());
        prop_assert!((f64::from(point.plan().x) - x).abs() <= 0.0005 + 1e-7 * x.abs());
        let off = (f64::from(heading.degrees()) - degrees).rem_euclid(360.0);
        prop_assert!(off.min(360.0 - off) < 0.0051, "{degrees} {}", heading.degrees());
    }

    /// Judging and doing never panic, and what is done is undone by its changes.
    #[test]
    fn any_aim_is_judged(actions in prop::collection::vec((words::<Verb>(), 0..8_usize, 0..8_usize, aim()), 1..6)) {
        let Home { graph, me, .. } = home();
        let ids: Vec<NodeId> = graph.nodes().map(|n| n.id()).collect();
        let mut graph = graph;
        for (verb, x, y, aim) in actions {
            let things = [ids[x % ids.len()], ids[y % ids.len()]];
            let action = Action::with(verb, &things[..verb.arity()]).unwrap().aimed(aim);
            let (before, refusals) = (graph.clone(), rule::refusals(&graph, me, &action));
            prop_assert_eq!(rule::allows(&graph, me, &action), refusals.is_empty());
            match rule::step(&mut graph, me, &action) {
                Ok(changes) => {
                    prop_assert!(graph.validate().is_empty());
                    let mut back = graph.clone();
                    changes.undo(&mut back).unwrap();
                    prop_assert!(back == before);
                }
                Err(why) => prop_assert!(why == refusals && graph == before),
            }
        }
    }
}

/// Two rooms side by side, four metres each way, with furniture and somebody.
struct Home {
    graph: SceneGraph,
    kitchen: NodeId,
    table: NodeId,
    cup: NodeId,
    sofa: NodeId,
    me: NodeId,
}

fn home() -> Home {
    let mut scene = SceneBuilder::new("posed");
    let standing = |x, y, z| Bounds::standing([x, y, z].into());
    let room = |class: &str, x| Draft::new(class).bounds(standing(4.0, 4.0, 2.5)).at(Pose::translation(x, 2.0, 0.0));
    let kitchen = scene.add(room("kitchen", 2.0)).unwrap();
    let living = scene.add(room("living_room", 6.0)).unwrap();
    // A table along Y.
    let turned = Pose::new([1.0, 2.0, 0.0].into(), [0.0, 0.0, std::f32::consts::FRAC_PI_2].into());
    let table = Draft::new("kitchen_table").bounds(standing(1.6, 0.8, 0.75)).at(turned);
    let table = scene.add_in(kitchen, table).unwrap();
    let cup = Draft::new("cup").bounds(standing(0.08, 0.08, 0.1)).at(Pose::translation(1.0, 2.0, 0.75));
    let cup = scene.add_on(table, cup).unwrap();
    let sofa = Draft::new("sofa").bounds(standing(0.9, 2.0, 0.8)).at(Pose::translation(6.0, 3.0, 0.0));
    let sofa = scene.add_in(living, sofa).unwrap();
    let body = Draft::new("character").bounds(standing(0.5, 0.5, 1.7)).at(Pose::translation(2.0, 2.0, 0.0));
    let me = scene.add_in(kitchen, body).unwrap();
    Home { graph: scene.build(), kitchen, table, cup, sofa, me }
}

impl Home {
    fn act(&mut self, text: &str) -> Result<(), Vec<Refusal>> {
        let action = self.action(text);
        rule::step(&mut self.graph, self.me, &action).map(drop)
    }

    /// An action with names for things.
    fn action(&self, text: &str) -> Action {
        let names = [("kitchen", self.kitchen), ("table", self.table), ("cup", self.cup), ("sofa", self.sofa)];
        let word = |word: &str| match names.iter().find(|(name, _)| *name == word) {
            Some((_, id)) => id.to_string(),
            None => word.to_owned(),
        };
        text.split(' ').map(word).collect::<Vec<_>>().join(" ").parse().unwrap()
    }

    fn done(&mut self, text: &str) {
        self.act(text).unwrap_or_else(|why| panic!("{text}: {why:?}"));
    }

    fn refused(&mut self, text: &str) -> String {
        let before = self.graph.clone();
        let why = self.act(text).unwrap_err();
        assert_eq!(self.graph, before, "{text}");
        why.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
    }

    fn pose(&self, id: NodeId) -> Pose {
        *self.graph.node(id).unwrap().pose().unwrap()
    }

    /// Where a node is and by how much it is turned, degrees.
    fn is_at(&self, id: NodeId, (x, y): (f32, f32), degrees: f32) {
        let pose = self.pose(id);
        let front = pose.rotation * nalgebra::Vector3::x();
        let turned = front.y.atan2(front.x).to_degrees();
        let (at, off) = (pose.translation.vector, (turned - degrees).rem_euclid(360.0));
        assert!((at.x - x).abs() < 1e-4 && (at.y - y).abs() < 1e-4, "{at}");
        assert!(off.min(360.0 - off) < 0.01, "{turned}");
    }
}

#[test]
fn bad_aims_are_told() {
    let bad = |text: &str| match text.parse::<Action>().unwrap_err() {
        ActionTextError::Aim(error) => error,
        other => panic!("{text}: {other}"),
    };
    assert!(matches!(bad("walk at x 1"), AimError::Number(_)));
    assert!(matches!(bad("walk at yaw 90"), AimError::Number(_)));
    assert!(matches!(bad("walk at 1"), AimError::Missing(_)));
    assert!(matches!(bad("walk at inf 1"), AimError::OutOfRange(_)));
    assert!(matches!(bad("walk at 1 1e9"), AimError::OutOfRange(_)));
    assert!(matches!(bad("turn_to yaw nan"), AimError::OutOfRange(_)));
    assert!(matches!(bad("walk at 1 2 at 3 4"), AimError::Again(_)));
    assert!(matches!(bad("sit sofa.1 seat 1 by left"), AimError::Again(_)));
    assert!(matches!(bad("sit sofa.1 seat -1"), AimError::Whole(_)));
    assert!(matches!(bad("grab cup.1 by handle"), AimError::Side(_)));
    assert!(matches!(bad("place cup.1 table.2 at 1 2 3 4"), AimError::Unexpected(_)));
    assert!(matches!(bad("walk at 1 2 table.2"), AimError::Number(_)));
    // A heading alone leads nowhere, and a point takes nothing into a hand.
    for text in ["walk yaw 90", "grab at 1 2", "place cup.1 at 1 2", "walk"] {
        assert!(matches!(text.parse::<Action>(), Err(ActionTextError::Arity { .. })), "{text}");
    }
}

#[test]
fn virtualhome_says_no_points() {
    let mut home = home();
    let action = home.action("walk at 1 3");
    assert!(matches!(action.to_virtualhome(&home.graph), Err(ActionTextError::AimNotInVirtualHome(_))));
    assert!("[WALK] <kitchen> (1) at 1 3".parse::<Action>().is_err());
    assert!(program::write(&Program::from_actions([action]), &home.graph).is_err());
    let mut theirs = Simulator::with(home.graph.clone(), Semantics::VirtualHome);
    assert!(matches!(theirs.step(home.me, &action).unwrap_err()[..], [Refusal::AimNotInVirtualHome(_)]));
    home.done("walk at 1 3.5");
}

#[test]
fn lines_with_points_are_steps() {
    let program = program::read("Lay the table\n\nwalk at 3.2 1.5 yaw 90\nturn_to yaw -12.5\n").unwrap();
    assert_eq!((program.heading.len(), program.steps.len()), (1, 2));
    let error = program::read("walk at 3.2 1.5\nwalk at 3.2\n").unwrap_err();
    assert_eq!(error.line, Some(2));
    for (text, fault) in [
        ("walk at x y 100", "program, line 1: `x` is not a number"),
        ("walk at 3.2 north", "program, line 1: `north` is not a number"),
        (
            "walk yaw 90",
            "program, line 1: `walk` takes one thing, none is given: write its class and number, as in `walk cup.12`, or a point as in `walk at 1.20 0.40`",
        ),
    ] {
        let told = program::read(&format!("{text}\n\ndance\n")).unwrap_err().to_string();
        assert!(told.starts_with(fault), "{told}");
    }
    // A title, though it begins as an action does.
    let program = program::read("Walk at night\n\nwalk at 3.2 1.5\n").unwrap();
    assert_eq!((program.heading, program.steps.len()), (vec!["Walk at night".to_owned()], 1));
}

/// Each verb takes the aims of its row and no others, and says which.
#[test]
fn verbs_take_their_aims() {
    let home = home();
    let aims =
        ["at 1.2 2.1", "yaw 90", "at 1.2 2.1 yaw 90", "seat 1", "slot 1", "yaw 90 slot 1", "by left", "at 1 2 seat 1"];
    for (verb, aim) in Verb::ALL.iter().flat_map(|verb| aims.map(|aim| (*verb, aim))) {
        let things = ["", " cup", " cup table"][verb.arity()];
        let action = home.action(&format!("{verb}{things} {aim}"));
        let told = rule::refusals(&home.graph, home.me, &action);
        let takes =
            RULES[verb.index()].aims.forms.iter().any(|form| {
                !form.alone && form.words.iter().copied().collect::<vc_graph::Set<_>>() == action.aim.words()
            });
        assert_eq!(!told.iter().any(|why| matches!(why, Refusal::Aim { .. })), takes, "{action}: {told:?}");
    }
    let told = rule::refusals(&home.graph, home.me, &home.action("sit sofa yaw 90"));
    assert_eq!(told[0].to_string(), "`sit` takes `sit THING seat N`, not `yaw 90`");
    assert!(RULES[Verb::Walk.index()].aims.texts(Verb::Walk).contains(&"walk at X Y [Z] yaw DEGREES".to_owned()));
    let told = rule::refusals(&home.graph, home.me, &home.action("eat cup at 1 2"));
    assert_eq!(told[0].to_string(), "`eat` takes no point, heading, seat, slot or side: leave `at 1.00 2.00` out");
}

#[test]
fn one_goes_to_a_point_and_turns() {
    let mut home = home();
    home.done("walk at 3.2 1.5 yaw 90");
    home.is_at(home.me, (3.2, 1.5), 90.0);
    home.done("walk at 3.2 3.5");
    home.is_at(home.me, (3.2, 3.5), 90.0);
    home.done("turn_to yaw -45");
    home.is_at(home.me, (3.2, 3.5), -45.0);
    home.done("turn_to at 2.2 3.5 1.2");
    home.is_at(home.me, (3.2, 3.5), 180.0);
    home.done("run at 5 1");
    assert_ne!(home.graph.room_of(home.me), Some(home.kitchen));
    assert!(!home.graph.has(vc_graph::Edge::new(home.me, Relation::Near, home.table)));
    home.done("walk table at 2 1.5 yaw 0");
    home.is_at(home.me, (2.0, 1.5), 0.0);
    assert!(home.graph.near(home.me, home.table));
    home.done("walk kitchen at 3.5 3.5");
    home.is_at(home.me, (3.5, 3.5), 90.0);
    let all = rule::effects(&Vocabulary::builtin(), &home.action("point_at at 1 1"));
    assert!(matches!(all[..], [Effect::TurnAs(_)]));
}

/// A stated height says on which of two floors, one above the other, somebody goes.
#[test]
fn one_goes_to_a_storey() {
    let mut scene = SceneBuilder::new("posed");
    let mut room = |class: &str, z: f32, side: f32| {
        let room = scene.add(Draft::new(class)).unwrap();
        let slab = Bounds::standing([side, side, 0.2].into());
        scene.add_in(room, Draft::new("floor").bounds(slab).at(Pose::translation(2.0, 2.0, z - 0.2))).unwrap();
        room
    };
    let (kitchen, attic) = (room("kitchen", 0.0, 4.0), room("bedroom", 2.7, 8.0));
    let me = scene.add_in(kitchen, Draft::new("character").at(Pose::translation(2.0, 2.0, 0.0))).unwrap();
    let mut graph = scene.build();
    for (text, room, level) in [
        ("walk at 1 1 0", kitchen, 0.0),
        ("walk at 1 1 2.7", attic, 2.7),
        ("walk at 1 2 0.9", kitchen, 0.0),
        ("walk at 1 1 4", attic, 2.7),
        ("walk at 2 2", attic, 2.7),
    ] {
        rule::step(&mut graph, me, &text.parse().unwrap()).unwrap_or_else(|why| panic!("{text}: {why:?}"));
        let height = graph.node(me).unwrap().position().unwrap().z;
        assert_eq!(graph.room_of(me), Some(room), "{text}");
        assert!((height - level).abs() < 1e-4, "{text}: {height}");
    }
}

#[test]
fn a_thing_is_put_to_a_point() {
    let mut home = home();
    home.done("grab cup");
    home.done("place cup table at 1.2 2.6 yaw 90");
    home.is_at(home.cup, (1.2, 2.6), 90.0);
    assert!((home.pose(home.cup).translation.z - 0.75).abs() < 1e-4);
    home.done("grab cup");
    home.done("place cup table yaw 30");
    home.is_at(home.cup, (1.0, 2.0), 30.0);
    home.done("grab cup");
    home.done("drop cup at 2.5 2.5 yaw 180");
    home.is_at(home.cup, (2.5, 2.5), 180.0);
    assert!(home.pose(home.cup).translation.z.abs() < 1e-4, "it is on the floor");
}

#[test]
fn points_that_cannot_be_are_refused() {
    let mut home = home();
    home.done("grab cup");
    // Beside the table as it is turned, though within a box around it as it is not.
    assert_eq!(home.refused("place cup table at 1.7 2"), "the point 1.70 2.00 is not on or in kitchen_table.3");
    home.done("walk at 3.4 2");
    assert!(home.refused("place cup table at 1 2").contains("not near"), "the table is far away");
    home.done("walk at 2.3 1");
    assert_eq!(home.refused("place cup table at 1 2.7"), "the point 1.00 2.70 is 2.1 m away: walk closer first");
    assert_eq!(home.refused("drop cup at 4.5 2"), "the point 4.50 2.00 is not on or in kitchen.1");
    assert_eq!(home.refused("walk at 9 9"), "the point 9.00 9.00 is in no room of the scene");
    assert_eq!(home.refused("walk table at 3.6 2"), "the point 3.60 2.00 is too far from kitchen_table.3: 2.2 m");
    assert_eq!(home.refused("walk kitchen at 5 2"), "the point 5.00 2.00 is not on or in kitchen.1");
    // Another thing stands there.
    home.done("place cup table at 1.2 1.4");
    let mut edit = home.graph.edit();
    let plate = edit
        .add(
            Draft::new("plate").bounds(Bounds::standing([0.3, 0.3, 0.03].into())).at(Pose::translation(1.2, 1.6, 0.75)),
        )
        .unwrap();
    edit.place(plate, Place { relation: Relation::On, at: home.table }).unwrap();
    edit.commit();
    home.done("grab cup");
    let taken =
        format!("plate.{} stands at 1.25 1.60: choose another point, or put plate.{} away first", plate.0, plate.0);
    assert_eq!(home.refused("place cup table at 1.25 1.6"), taken);
    home.done("place cup table at 1.3 1.3");
    home.done("walk sofa");
    assert_eq!(home.refused("sit sofa seat 4"), "sofa.5 has 3 seats, numbered from 1: there is no seat 4");
    assert_eq!(home.refused("sit sofa seat 0"), "sofa.5 has 3 seats, numbered from 1: there is no seat 0");
    home.done("sit sofa seat 2");
    assert_eq!(home.refused("turn_to yaw 10"), "character.6 must stand up first");
    assert_eq!(home.refused("walk at 5 1"), "character.6 must stand up first");
}

/// Without poses a point for a thing changes nothing, and nobody goes to one.
#[test]
fn without_poses_points_change_nothing() {
    let mut flat = vc_testkit::flat::Flat::after(&["walk cup", "grab cup"]);
    let (cup, table) = (flat.id("cup"), flat.id("kitchen_table"));
    let mut plain = flat.clone();
    flat.sim.step(flat.me, &Action::place(cup, table).at(1.0, 2.0).unwrap()).unwrap();
    plain.sim.step(plain.me, &Action::place(cup, table)).unwrap();
    assert_eq!(flat.graph(), plain.graph());
    let walk: Action = "walk at 1 2".parse().unwrap();
    assert!(matches!(flat.sim.step(flat.me, &walk).unwrap_err()[..], [Refusal::NoPoses(_)]));
    assert!(flat.sim.history().events()[2].action.aim.point().is_some(), "the history keeps it");
}

#[test]
fn actions_stay_small() {
    assert!(size_of::<Action>() <= 52, "{}", size_of::<Action>());
}

/// A point of a rack is taken when something stands below it on each of the boards that are meant.
#[test]
fn a_point_of_a_rack_is_taken_board_by_board() {
    let home = home();
    let mut scene = SceneBuilder::from_graph(home.graph.clone());
    let board = |name: &str, height: f32| Surface {
        name: name.into(),
        hold: Hold::On,
        centre: Point3::new(0.0, 0.0, height),
        half: (0.2, 0.5),
        clearance: None,
        joint: None,
    };
    let rack = Asset { name: "rack".into(), surfaces: vec![board("low", 0.4), board("top", 0.8)], ..Asset::default() };
    let mut shapes = AssetLibrary::default();
    let asset = Some(shapes.add(rack).unwrap());
    scene.assets(shapes.into());
    let at = Pose::translation(2.0, 3.0, 0.0);
    let bounds = Bounds::standing([0.4, 1.0, 0.8].into());
    let rack = Draft { asset, ..Draft::new("bookshelf").bounds(bounds).at(at) };
    let rack = scene.add_in(home.kitchen, rack).unwrap();
    let thing = Bounds::standing([0.1, 0.1, 0.1].into());
    let mut edit = scene.edit();
    edit.hold(home.me, home.cup).unwrap();
    edit.commit();
    let taken = |scene: &mut SceneBuilder, height: Option<f32>| {
        if let Some(z) = height {
            scene.add_on(rack, Draft::new("bowl").bounds(thing).at(Pose::translation(2.0, 2.8, z))).unwrap();
        }
        let place = Action::place(home.cup, rack);
        let points = [None, Some(0.4), Some(0.8)].map(|z| AimPoint::new(2.0, 2.8, z).unwrap());
        points.map(|point| {
            let action = Action { aim: Aim::NOTHING.with_point(point), ..place };
            let refusals = rule::refusals(scene.graph(), home.me, &action);
            refusals.iter().any(|refusal| matches!(refusal, Refusal::PointTaken { .. }))
        })
    };
    assert_eq!(taken(&mut scene, None), [false, false, false]);
    assert_eq!(taken(&mut scene, Some(0.401)), [false, true, false]);
    assert_eq!(taken(&mut scene, Some(0.801)), [true, true, true]);
}
