//! Programs run with bodies in a scene that they fit.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use vc_graph::format::eai::{Record, read_record};
use vc_graph::{ClassTable, NodeId, SceneGraph};
use virtualcity::{ActionError, Environment, Impossible};

use crate::support::{Complaint, read, say};

/// Runs every program that fits a scene in it, and counts how many are executable, and the reasons why
/// others are not.
pub(crate) fn replay(files: &[PathBuf], scene: &Path) -> Result<(), Complaint> {
    let home = Environment::make(&format!("scene:{}", scene.display()), 1).map_err(Complaint::new)?;
    let (mut all, mut fit, mut done, mut why) = (0, 0, 0, BTreeMap::<String, usize>::new());
    for file in files {
        for line in read(file)?.lines().filter(|l| !l.trim().is_empty()) {
            let record = read_record(line).map_err(Complaint::new)?;
            all += 1;
            if !fits(&record, home.graph())? {
                continue;
            }
            fit += 1;
            match run(&mut home.clone(), &record) {
                Ok(()) => done += 1,
                Err((index, error)) => {
                    say!("{} {}: action {}: {error}", record.id, record.title, index + 1);
                    *why.entry(reason(&error)).or_default() += 1;
                }
            }
        }
    }
    say!("\n{}: {fit} of {all} programs fit, {done} run with bodies", scene.display());
    why.iter().for_each(|(reason, count)| say!("  {count} {reason}"));
    Ok(())
}

/// Whether everything that a program names has the same class in a scene; its own agent stands for the one
/// that acts there.
fn fits(record: &Record, scene: &SceneGraph) -> Result<bool, Complaint> {
    let own =
        record.initial.build(&record.id, &ClassTable::builtin()).map_err(|(_, problem)| Complaint::new(problem))?;
    let class = |graph: &SceneGraph, id: NodeId| graph.node(id).map(|n| n.class().clone());
    let is_actor = |id: NodeId| own.agents().first() == Some(&id);
    let named: Vec<NodeId> = record.program.actions().flat_map(|action| action.things().collect::<Vec<_>>()).collect();
    Ok(named.into_iter().all(|id| is_actor(id) || class(&own, id).is_some() && class(&own, id) == class(scene, id)))
}

fn run(home: &mut Environment, record: &Record) -> Result<(), (usize, ActionError)> {
    let me = home.agents()[0];
    let mut numbered = record.program.actions().enumerate();
    numbered.try_for_each(|(index, action)| home.set_action(me, action).map(drop).map_err(|error| (index, error)))
}

/// The kind of a reason, without names.
fn reason(error: &ActionError) -> String {
    match error {
        ActionError::Refused(_) => "refused by the rule".into(),
        ActionError::Impossible { why: Impossible::NoStand(_), .. } => "out of reach".into(),
        ActionError::Impossible { why: Impossible::NoSpot { .. }, .. } => "no free spot".into(),
        ActionError::Impossible { .. } => "bodies cannot".into(),
        ActionError::Disagreement(_) => "bodies and rule disagree".into(),
        _ => "another".into(),
    }
}
