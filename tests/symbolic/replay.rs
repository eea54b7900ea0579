//! The 100 programs of the Embodied Agent Interface, executed and compared with the results of VirtualHome's
//! simulator.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::BTreeMap;

use vc_graph::format::eai;
use vc_graph::format::virtualhome::{EnvironmentEdge, EnvironmentGraph, RelationType};
use vc_graph::{ClassTable, Simulator};

/// A fault of VirtualHome's simulator that changes the result of a program.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Defect {
    /// `PLUGOUT` of a running machine logs an error and succeeds.
    PlugOutWhileOn,
    /// Grabbing an object that is in one hand puts it into the other as well.
    GrabbedTwice,
    /// Walking with a bottle undoes pouring from it.
    PouringForgotten,
    /// Objects on a plate stay behind when the plate is grabbed.
    LeftBehind,
}

/// Programs with different results, and the reasons.
const EXPLAINED: [(&str, Defect); 5] = [
    ("file538_1", Defect::PlugOutWhileOn),
    ("file624_1", Defect::GrabbedTwice),
    ("file688_1", Defect::GrabbedTwice),
    ("file621_2", Defect::PouringForgotten),
    ("file961_1", Defect::LeftBehind),
];

struct Replay {
    id: String,
    refused: Option<String>,
    states: usize,
    /// Differences in ON, INSIDE and HOLDS.
    firm: Vec<EnvironmentEdge>,
    /// Differences in FACING.
    facing: usize,
    /// Differences in CLOSE, those of a node with itself left out.
    close: Vec<EnvironmentEdge>,
}

fn replay_all() -> Option<Vec<Replay>> {
    let text = vc_testkit::data::text("eai/programs_dev.jsonl.gz")?;
    Some(text.lines().map(replay).collect())
}

fn replay(line: &str) -> Replay {
    let classes = ClassTable::builtin();
    let record = eai::read_record(line).unwrap();
    let scene = record.initial.build(&record.id, &classes).unwrap();
    let me = scene.agents()[0];
    let mut world = Simulator::new(scene);
    let mut refused = None;
    for action in record.program.actions() {
        if let Err(refusals) = world.step(me, &action) {
            refused = Some(refusals[0].to_string());
            break;
        }
    }
    let difference = EnvironmentGraph::from_scene(world.graph()).difference(&record.last);
    let edges = || difference.added.iter().chain(&difference.missing).copied().filter(|e| e.from_id != e.to_id);
    let (loose, firm): (Vec<_>, Vec<_>) =
        edges().partition(|e| matches!(e.relation_type, RelationType::Close | RelationType::Facing));
    let (close, facing): (Vec<_>, Vec<_>) = loose.into_iter().partition(|e| e.relation_type == RelationType::Close);
    Replay { id: record.id, refused, states: difference.states.len(), firm, facing: facing.len(), close }
}

#[test]
fn programs_are_executable() {
    let Some(replays) = replay_all() else { return };
    let refused: BTreeMap<&str, &str> =
        replays.iter().filter_map(|r| Some((r.id.as_str(), r.refused.as_deref()?))).collect();
    assert!(replays.len() - refused.len() >= 98, "{refused:?}");
    for id in refused.keys() {
        assert!(EXPLAINED.contains(&(id, Defect::PlugOutWhileOn)), "{id}: {refused:?}");
    }
}

#[test]
fn final_graphs_agree_but_for_named_defects() {
    let Some(replays) = replay_all() else { return };
    for replay in replays.iter().filter(|r| r.refused.is_none()) {
        assert_eq!(replay.states, 0, "{}", replay.id);
        assert_eq!(replay.facing, 0, "{}", replay.id);
        let defect = EXPLAINED.iter().find(|(id, _)| *id == replay.id).map(|(_, defect)| *defect);
        match (defect, replay.firm.as_slice()) {
            (None, differences) => assert_eq!(differences, [], "{}", replay.id),
            (Some(defect), [edge]) => assert!(explains(defect, edge.relation_type), "{}: {edge:?}", replay.id),
            (Some(_), differences) => panic!("{}: {differences:?}", replay.id),
        }
    }
}

fn explains(defect: Defect, relation: RelationType) -> bool {
    match defect {
        Defect::PlugOutWhileOn => false,
        Defect::GrabbedTwice => relation == RelationType::HoldsLh,
        Defect::PouringForgotten => relation == RelationType::Inside,
        Defect::LeftBehind => relation == RelationType::On,
    }
}

/// CLOSE differs in three ways, all of them edges that only VirtualHome has: it makes an agent close to the
/// room that it walks to, to hair and other body parts wherever they are, and on grabbing to some object that
/// the grabbed one was close to.
#[test]
fn nearness_agrees_but_for_a_few_edges() {
    let Some(replays) = replay_all() else { return };
    let differing: BTreeMap<&str, usize> = replays
        .iter()
        .filter(|r| r.refused.is_none() && !r.close.is_empty())
        .map(|r| (r.id.as_str(), r.close.len()))
        .collect();
    eprintln!("CLOSE differs in {differing:?}");
    assert!(differing.len() <= 5, "{differing:?}");
    assert!(differing.values().all(|&edges| edges <= 2), "{differing:?}");
}
