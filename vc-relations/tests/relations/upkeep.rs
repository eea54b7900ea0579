//! Incremental updates equal a full rebuild, whatever changes: poses, states, hands, drawers, contacts, joints,
//! and the set of nodes itself.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::shared;

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{UnitQuaternion, Vector3};
use proptest::prelude::*;
use vc_graph::{Bounds, Draft, Edge, NodeId, NodeKind, Pose, Relation, SceneGraph, Seed, State, Stream};
use vc_relations::{Attachment, ContactEvidence, Evidence, NodeEvidence, RelationRule, Relations};

/// In addition to the rooms of objects: people, and things to look at, sit on, hang on and pull.
const MORE: [&str; 11] = [
    "tv = tv 0.1 1.2 0.7 @ 1.8 0.5 0.8 r 0 0 180",
    "sofa = sofa 2 @ -1 1.2 0",
    "bed = bed 1.4 @ 5 1 0",
    "drawers = drawers! 0.45 0.8 0.9 3 @ 1.2 -0.6 0",
    "sock = box 0.1 0.1 0.05 @ 1.2 -0.6 0.02",
    "hooks = hooks 0.8 @ 1.98 1 1.7 r 0 0 180",
    "coat = coat @ 1.9 1.1 1.7 r 0 0 180",
    "leaf = door 0.9 2 @ 2.08 -1 0",
    "me = boxed 0.3 0.45 1.3 @ 0.5 0 0.01 class character",
    "you = boxed 0.3 0.45 1.7 @ -0.5 0.5 0 class character state sitting",
    "me holds_right sock",
];

/// A changing scene and its evidence.
struct Life {
    graph: SceneGraph,
    evidence: Evidence,
    /// Assets with joints, and how many each has.
    moving: Vec<(NodeId, usize)>,
    /// Nodes that the last changes affected.
    changed: Vec<NodeId>,
    rng: Stream,
}

impl Life {
    fn new(seed: Seed) -> Self {
        let (home, _) = shared::home::home_with(50, &MORE);
        let moving = vec![(home.id("drawers"), 3), (home.id("fridge0"), 1), (home.id("fridge1"), 1)];
        Self { graph: home.graph, evidence: home.evidence, moving, changed: Vec::new(), rng: seed.stream() }
    }

    /// A random node that is not part of the building.
    fn thing(&mut self, wanted: impl Fn(NodeKind) -> bool) -> NodeId {
        let building = |n: &vc_graph::Node| &*n.spec().category == "structure";
        let all: Vec<NodeId> =
            self.graph.nodes().filter(|n| wanted(n.kind()) && !building(n)).map(vc_graph::Node::id).collect();
        all[self.rng.below(all.len())]
    }

    fn object(&mut self) -> NodeId {
        self.thing(|kind| kind == NodeKind::Object)
    }

    fn pose(&mut self) -> Pose {
        let goal = self.thing(|kind| kind != NodeKind::Room);
        let at = self.graph.node(goal).unwrap().pose().unwrap().translation.vector;
        let rng = &mut self.rng;
        let far = if rng.chance(0.2) { 3.0 } else { 0.3 };
        let off = Vector3::new(rng.between(-far, far), rng.between(-far, far), rng.between(-0.05, 0.8));
        let (roll, yaw) = (if rng.chance(0.2) { rng.between(-3.0, 3.0) } else { 0.0 }, rng.between(-3.0, 3.0));
        Pose::from_parts((at + off).into(), UnitQuaternion::from_euler_angles(roll, 0.0, yaw))
    }

    fn edit(&mut self, change: impl FnOnce(&mut vc_graph::Edit<'_>)) {
        let mut edit = self.graph.edit();
        change(&mut edit);
        edit.commit();
    }

    fn moves(&mut self) {
        let (id, pose) = (self.thing(|kind| kind != NodeKind::Room), self.pose());
        self.edit(|edit| edit.set_pose(id, Some(pose)).unwrap());
        self.changed.push(id);
    }

    fn poses_itself(&mut self) {
        let (id, state) = (self.thing(|kind| kind == NodeKind::Agent), self.rng.below(3));
        self.edit(|edit| {
            [State::Sitting, State::Lying].into_iter().for_each(|s| edit.leave_state(id, s).unwrap());
            if let Some(state) = [State::Sitting, State::Lying].get(state) {
                edit.enter_state(id, *state).unwrap();
            }
        });
        self.changed.push(id);
    }

    /// Takes something in a hand or lets it go; reports either the thing as changed, or its present and former
    /// holders.
    fn takes(&mut self) {
        let (agent, thing, lets_go) = (self.thing(|kind| kind == NodeKind::Agent), self.object(), self.rng.chance(0.5));
        let own = self.graph.related(agent, Relation::HoldsRight).next().filter(|_| lets_go);
        let thing = own.unwrap_or(thing);
        let before = self.graph.holder(thing).map(|p| p.at);
        // Full hands and cycles are rejected.
        self.edit(|edit| drop(if own.is_some() { edit.detach(thing) } else { edit.hold(agent, thing) }));
        if self.rng.chance(0.5) {
            self.changed.push(thing);
        } else {
            self.changed.push(agent);
            self.changed.extend(before);
        }
    }

    fn comes(&mut self) {
        let (class, size) =
            [("cup", 0.1), ("television", 0.6), ("chair", 0.5), ("character", 1.5), ("carton", 0.3)][self.rng.below(5)];
        let draft = Draft::new(class).bounds(Bounds::standing(Vector3::new(size * 0.5, size * 0.6, size)));
        let pose = self.pose();
        let mut id = None;
        self.edit(|edit| id = Some(edit.add(draft.at(pose)).unwrap()));
        self.changed.extend(id);
    }

    fn goes(&mut self) {
        let agents = self.graph.agents().len();
        let id = self.thing(|kind| kind == NodeKind::Object || (kind == NodeKind::Agent && agents > 1));
        self.edit(|edit| edit.remove(id).unwrap());
        self.changed.push(id);
    }

    /// Changes the evidence at random.
    fn is_said(&mut self) {
        let (agent, one, other) = (self.thing(|kind| kind == NodeKind::Agent), self.object(), self.object());
        let (node, links) = self.moving[self.rng.below(self.moving.len())];
        let (rng, evidence) = (&mut self.rng, &mut self.evidence);
        match rng.below(5) {
            0 | 1 => {
                let position = if rng.chance(0.3) { 0.0 } else { rng.between(0.0, 0.4) };
                evidence.positions.insert((node, rng.below(links) as u32), position);
            }
            2 => {
                let held = [Edge::new(agent, Relation::HoldsLeft, one), Edge::new(one, Relation::WornBy, agent)];
                evidence.held.push(held[rng.below(2)]);
            }
            3 => {
                let impulse = Vector3::new(rng.between(-1.0, 1.0), 0.0, rng.between(-1.0, 1.0));
                evidence.contacts.push(ContactEvidence { between: (one, other), impulse });
            }
            _ => evidence.attachments.push(Attachment { child: one, parent: other }),
        }
        if rng.chance(0.2) {
            *evidence = Evidence::default();
        }
    }

    /// Changes the evidence about one node, and says so.
    fn tells(&mut self) -> NodeEvidence {
        let (node, links) = self.moving[self.rng.below(self.moving.len())];
        let node = if self.rng.chance(0.3) { self.object() } else { node };
        let rng = &mut self.rng;
        let positions: Vec<f32> =
            (0..links).map(|_| if rng.chance(0.4) { 0.0 } else { rng.between(0.0, 0.4) }).collect();
        let is_carried = rng.chance(0.3);
        for (joint, position) in (0..).zip(0..links.max(3)) {
            self.evidence.positions.remove(&(node, joint));
            if let Some(at) = positions.get(position).filter(|at| **at != 0.0) {
                self.evidence.positions.insert((node, joint), *at);
            }
        }
        if let Some(carried) = &mut self.evidence.carried {
            if is_carried {
                carried.insert(node)
            } else {
                carried.remove(&node)
            };
        }
        NodeEvidence { node, positions, is_carried }
    }

    /// Makes a few changes; returns whether the evidence changed.
    fn goes_on(&mut self) -> bool {
        self.changed.clear();
        let said = self.rng.chance(0.5);
        for _ in 0..self.rng.count(1, 4) {
            match self.rng.below(12) {
                0..6 => self.moves(),
                6 | 7 => self.poses_itself(),
                8 | 9 => self.takes(),
                10 => self.comes(),
                _ => self.goes(),
            }
            if said {
                self.is_said();
            }
        }
        said
    }
}

fn by_node(edges: &[Edge]) -> BTreeMap<NodeId, BTreeSet<Edge>> {
    let mut map: BTreeMap<NodeId, BTreeSet<Edge>> = BTreeMap::new();
    for edge in edges {
        map.entry(edge.from).or_default().insert(*edge);
    }
    map
}

/// Checks that two agree about everything, in all queries.
fn compare(updated: &Relations, fresh: &Relations, life: &mut Life) -> Result<(), TestCaseError> {
    let (ours, theirs): (BTreeSet<Edge>, BTreeSet<Edge>) =
        (updated.edges().into_iter().collect(), fresh.edges().into_iter().collect());
    prop_assert_eq!(updated.edges().len(), ours.len(), "an edge occurs twice");
    let apart: Vec<&Edge> = ours.symmetric_difference(&theirs).collect();
    prop_assert!(apart.is_empty(), "after {:?}: {apart:?}", life.changed);
    for node in life.graph.nodes() {
        let id = node.id();
        prop_assert!(updated.edges_of(id).iter().eq(ours.iter().filter(|e| e.from == id)), "{}", node.label());
        let (a, b) = (updated.supports(id), fresh.supports(id));
        prop_assert!(a == b, "{}: {a:?}, anew {b:?}", node.label());
        let (a, b) = (updated.near(id), fresh.near(id));
        let differ = a.iter().zip(&b).find(|(a, b)| a != b);
        prop_assert!(a == b, "{}: near {} and anew {}, first {differ:?}", node.label(), a.len(), b.len());
    }
    for edge in &ours {
        let is_there = |id| life.graph.node(id).is_some();
        prop_assert!(is_there(edge.from) && is_there(edge.to), "{edge:?} is with nothing");
    }
    for _ in 0..8 {
        let (one, other) = (life.thing(|kind| kind != NodeKind::Room), life.thing(|_| true));
        prop_assert_eq!(updated.explain(one, other), fresh.explain(one, other));
    }
    Ok(())
}

/// Ten rounds of a few changes, an incremental update and a rebuild.
fn live(seed: Seed) -> Result<(), TestCaseError> {
    let mut life = Life::new(seed);
    let mut relations = Relations::new(&life.graph, RelationRule::Contacts, life.evidence.clone()).unwrap();
    for _ in 0..10 {
        let before = by_node(&relations.edges());
        let said = life.goes_on();
        let first = life.rng.chance(0.5);
        if said && first {
            relations.set_evidence(&life.graph, life.evidence.clone()).unwrap();
        }
        let met = relations.update(&life.graph, &life.changed).unwrap();
        if said && !first {
            relations.set_evidence(&life.graph, life.evidence.clone()).unwrap();
        }
        let fresh = Relations::new(&life.graph, RelationRule::Contacts, life.evidence.clone()).unwrap();
        compare(&relations, &fresh, &mut life)?;
        let (after, none) = (by_node(&relations.edges()), BTreeSet::new());
        for id in life.graph.nodes().map(vc_graph::Node::id).filter(|_| !said) {
            let [was, is] = [&before, &after].map(|edges| edges.get(&id).unwrap_or(&none));
            let apart: Vec<&Edge> = was.symmetric_difference(is).collect();
            prop_assert!(apart.is_empty() || met.contains(&id), "unsaid after {:?}: {apart:?}", life.changed);
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn upkeep_equals_a_rebuild(seed in any::<u64>()) {
        live(Seed(seed))?;
    }
}

/// Evidence that is given node by node equals the same evidence given as a whole.
fn is_told_node_by_node(seed: Seed) -> Result<(), TestCaseError> {
    let mut life = Life::new(seed);
    life.evidence.carried = seed.stream().chance(0.8).then(BTreeSet::new);
    let mut relations = Relations::new(&life.graph, RelationRule::Contacts, life.evidence.clone()).unwrap();
    let mut whole = relations.clone();
    for _ in 0..10 {
        life.changed.clear();
        (0..life.rng.below(3)).for_each(|_| life.moves());
        let said: Vec<NodeEvidence> = (0..life.rng.count(1, 3)).map(|_| life.tells()).collect();
        let met = relations.update_nodes(&life.graph, &life.changed, &said).unwrap();
        let by_whole = whole.update_with(&life.graph, &life.changed, life.evidence.clone()).unwrap();
        prop_assert_eq!(relations.evidence(), &life.evidence);
        prop_assert!(by_whole.iter().all(|id| met.contains(id)));
        compare(&relations, &whole, &mut life)?;
    }
    let wrong = NodeEvidence { node: life.moving[0].0, positions: vec![0.1, f32::NAN], is_carried: true };
    prop_assert!(relations.update_nodes(&life.graph, &[], &[wrong]).is_err());
    prop_assert_eq!(relations.evidence(), &life.evidence);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn evidence_node_by_node_equals_the_whole(seed in any::<u64>()) {
        is_told_node_by_node(Seed(seed))?;
    }
}

/// Rooms that come and go change the room relations of the things in them.
#[test]
fn rooms_come_and_go() {
    let mut scene = shared::scene(["old = room 4 4", "cup = box 0.1 0.1 0.1 @ 1 1 0", "door = door 0.9 2 @ 2 0 0"]);
    let mut relations = Relations::new(&scene.graph, RelationRule::Contacts, Evidence::default()).unwrap();
    let (old, cup) = (scene.id("old"), scene.id("cup"));
    assert!(relations.has(Edge::new(cup, Relation::InRoom, old)));
    let mut edit = scene.graph.edit();
    let size = Bounds::standing(Vector3::new(4.0, 4.0, 2.5));
    let new = edit.add(Draft::new("bedroom").bounds(size).at(Pose::translation(4.2, 0.0, 0.0))).unwrap();
    edit.commit();
    relations.update(&scene.graph, &[new]).unwrap();
    assert_eq!(
        relations.edges(),
        Relations::new(&scene.graph, RelationRule::Contacts, Evidence::default()).unwrap().edges()
    );
    let door = scene.id("door");
    assert!(
        relations.has(Edge::new(door, Relation::Between, old))
            && relations.has(Edge::new(door, Relation::Between, new))
    );
    let mut edit = scene.graph.edit();
    edit.remove(old).unwrap();
    edit.commit();
    relations.update(&scene.graph, &[old]).unwrap();
    assert_eq!(
        relations.edges(),
        Relations::new(&scene.graph, RelationRule::Contacts, Evidence::default()).unwrap().edges()
    );
    assert!(!relations.has(Edge::new(cup, Relation::InRoom, old)));
}

/// Such nodes may be added later.
#[test]
fn what_is_said_of_nodes_that_are_not_there_counts_for_nothing() {
    let mut scene =
        shared::scene(["t = table 0.8 1.2 0.75", "cup = mug 0.08 0.1 @ 0 0 0.75", "me = person 1.7 @ 1 0 0"]);
    let [table, cup, me] = ["t", "cup", "me"].map(|n| scene.id(n));
    let (none, up) = (NodeId(99), Vector3::new(0.0, 0.0, 9.0));
    let mut evidence = Evidence::default()
        .attached(Attachment { child: cup, parent: none })
        .contact(ContactEvidence { between: (none, cup), impulse: up })
        .contact(ContactEvidence { between: (table, cup), impulse: up / 9.0 })
        .holding(Edge::new(none, Relation::HoldsRight, cup))
        .holding(Edge::new(me, Relation::HoldsRight, none));
    let mut relations = Relations::new(&scene.graph, RelationRule::Contacts, evidence.clone()).unwrap();
    let supports = relations.supports(cup);
    assert!(supports.len() == 1 && supports[0].by == table && (supports[0].share - 1.0).abs() < 1e-6, "{supports:?}");
    assert!(
        relations.edges_of(me).iter().all(|e| e.to != none) && relations.explain(cup, table).unwrap().held.is_empty()
    );
    // The holder of a thing may disappear, too.
    evidence = Evidence::default().holding(Edge::new(me, Relation::HoldsRight, cup));
    relations.set_evidence(&scene.graph, evidence).unwrap();
    assert!(relations.supports(cup).is_empty());
    let mut edit = scene.graph.edit();
    edit.remove(me).unwrap();
    edit.commit();
    let met = relations.update(&scene.graph, &[me]).unwrap();
    assert!(met.contains(&cup) && relations.has(Edge::new(cup, Relation::On, table)));
}

/// Things in a container stay in it when both change rooms, in whatever order they are written: the graph
/// updated step by step equals one written anew.
#[test]
fn contents_change_rooms_with_their_container() {
    for seed in 0..8 {
        let mut rng = Seed(seed).stream();
        let mut lines: Vec<String> = (0..3_u8)
            .flat_map(|i| {
                let x = 4.2 * f32::from(i);
                [format!("room{i} = room 4 4 @ {x} 0 0"), format!("floor{i} = floor 4 4 @ {x} 0 0")]
            })
            .collect();
        let mut things: Vec<String> = (0..4_u8)
            .flat_map(|i| {
                let y = f32::from(i) - 1.5;
                let basket = format!("basket{i} = basket! 0.35 0.45 0.3 @ 0 {y} 0");
                let toy = format!("toy{i} = box 0.15 0.15 0.02 @ 0 {y} 0.0105");
                [basket, toy, format!("cup{i} = box 0.05 0.05 0.05 @ 0 {y} 0.0305")]
            })
            .collect();
        while !things.is_empty() {
            lines.push(things.swap_remove(rng.below(things.len())));
        }
        lines.extend((0..3).map(|i| format!("floor{i} in room{i}")));
        let scene = shared::scene(lines.iter().map(String::as_str));
        let mut graph = scene.graph.clone();
        let all: Vec<NodeId> = graph.nodes().map(vc_graph::Node::id).collect();
        let mut relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default()).unwrap();
        relations.write(&mut graph, &all).unwrap();
        for _ in 0..12 {
            let (set, to) = (rng.below(4), 4.2 * rng.below(3) as f32);
            let moved = ["toy", "basket", "cup"].map(|name| scene.id(&format!("{name}{set}")));
            let mut edit = graph.edit();
            for id in moved {
                let mut pose = *edit.graph().node(id).unwrap().pose().unwrap();
                pose.translation.x = to;
                edit.set_pose(id, Some(pose)).unwrap();
            }
            edit.commit();
            let met = relations.update(&graph, &moved).unwrap();
            relations.write(&mut graph, &met).unwrap();
            let mut anew = graph.clone();
            Relations::new(&anew, RelationRule::Contacts, Evidence::default()).unwrap().write(&mut anew, &all).unwrap();
            let [ours, theirs] = [&graph, &anew].map(|g| g.edges().collect::<BTreeSet<Edge>>());
            let apart: Vec<&Edge> = ours.symmetric_difference(&theirs).collect();
            assert!(apart.is_empty(), "seed {seed}: {apart:?}");
            let [toy, basket, cup] = moved;
            assert!(graph.rests_at(toy, basket) && graph.rests_at(cup, basket), "seed {seed}");
        }
    }
}

/// A wall switch does not rest on a thing held below it, nor on its contents; a cup does.
#[test]
fn a_hand_carries_nothing_built_in() {
    let scene = shared::scene([
        "room = room 4 4 @ 0 0 0",
        "wall = wall 0.1 4 2.5 @ 2.05 0 0",
        "switch = box 0.02 0.08 0.1 @ 1.985 0 1.1 class lightswitch",
        "carton = box 0.3 0.3 0.2 @ 1.85 0 0.879",
        "pillow = pillow 0.1 0.1 0.02 @ 1.94 0 1.0795",
        "cup = box 0.05 0.05 0.05 @ 1.75 0 1.0795 class mug",
        "me = person 1.7 @ 1.4 0 0",
        "me holds_right carton",
    ]);
    let [switch, wall, carton, pillow, cup, me] =
        ["switch", "wall", "carton", "pillow", "cup", "me"].map(|n| scene.id(n));
    let on = |evidence: Evidence, graph: &SceneGraph, id: NodeId| -> Vec<NodeId> {
        let relations = Relations::new(graph, RelationRule::Contacts, evidence).unwrap();
        relations.supports(id).into_iter().map(|s| s.by).collect()
    };
    let held = || scene.evidence.clone().holding(Edge::new(me, Relation::HoldsRight, carton));
    assert_eq!(on(held(), &scene.graph, switch), [wall]);
    assert_eq!((on(held(), &scene.graph, pillow), on(held(), &scene.graph, cup)), (vec![carton], vec![carton]));
    let mut graph = scene.graph.clone();
    let mut edit = graph.edit();
    edit.remove(pillow).unwrap();
    edit.set_pose(carton, Some(Pose::translation(1.85, 0.0, 0.9))).unwrap();
    edit.commit();
    assert_eq!(on(held(), &graph, switch), [wall]);
}
