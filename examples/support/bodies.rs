//! Running programs with bodies in a matching scene.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use vc_graph::format::eai::{Record, read_record};
use vc_graph::{ClassTable, NodeId, SceneGraph};
use virtualcity::{ActionError, Environment, PhysicalRefusal};

use crate::plain::characters;
use crate::support::{Complaint, say};

/// Runs every program that fits a scene in it, and counts the executable ones, and the reasons why others are
/// not. Unreadable files and lines, and disagreements of bodies and rule, are named; returns whether there were none.
pub(crate) fn replay(files: &[PathBuf], scene: &Path) -> Result<bool, Complaint> {
    let mut tally = Tally::new(scene);
    for file in files {
        let text = virtualcity::read_text(file).unwrap_or_else(|error| {
            tally.unread(error);
            String::new()
        });
        for (number, line) in text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
            match read_record(line) {
                Ok(record) => {
                    if let Err(complaint) = tally.add(&record) {
                        tally.unread(format!("{}, line {}: {complaint:?}", file.display(), number + 1));
                    }
                }
                Err(error) => tally.unread(format!("{}, line {}: {error}", file.display(), number + 1)),
            }
        }
    }
    say!("\n{}: {} of {} programs fit, {} run with bodies", scene.display(), tally.fit, tally.all, tally.done);
    tally.why.iter().for_each(|(reason, count)| say!("  {count} {reason}"));
    if tally.disagreements > 0 {
        say!("  {} stopped because bodies and rule disagree", tally.disagreements);
    }
    Ok(tally.unread + tally.disagreements == 0)
}

struct Tally<'a> {
    scene: &'a Path,
    /// The initial scene, by the number of characters.
    homes: BTreeMap<usize, Environment>,
    all: usize,
    fit: usize,
    done: usize,
    /// Unreadable files and lines.
    unread: usize,
    /// Programs in which the bodies did something else than the rule says.
    disagreements: usize,
    why: BTreeMap<&'static str, usize>,
}

impl<'a> Tally<'a> {
    fn new(scene: &'a Path) -> Self {
        let (homes, why) = (BTreeMap::new(), BTreeMap::new());
        Self { scene, homes, all: 0, fit: 0, done: 0, unread: 0, disagreements: 0, why }
    }

    fn unread(&mut self, why: impl std::fmt::Display) {
        say!("{why}");
        self.unread += 1;
    }

    fn add(&mut self, record: &Record) -> Result<(), Complaint> {
        let mut home = self.home(characters(&record.program))?;
        self.all += 1;
        if !fits(record, home.graph())? {
            return Ok(());
        }
        self.fit += 1;
        match run(&mut home, record) {
            Ok(()) => self.done += 1,
            Err((index, error)) => {
                say!("{} {}: action {}: {error}", record.id, record.title, index + 1);
                match reason(&error) {
                    Some(reason) => *self.why.entry(reason).or_default() += 1,
                    None => self.disagreements += 1,
                }
            }
        }
        Ok(())
    }

    /// The scene with `characters` characters.
    fn home(&mut self, characters: usize) -> Result<Environment, Complaint> {
        if let Some(home) = self.homes.get(&characters) {
            return Ok(home.clone());
        }
        let home = Environment::make(&format!("scene:{}", self.scene.display()), characters).map_err(Complaint::new)?;
        self.homes.insert(characters, home.clone());
        Ok(home)
    }
}

/// Whether all nodes that a program names have the same class in a scene; the program's own agent corresponds
/// to the scene's agent.
fn fits(record: &Record, scene: &SceneGraph) -> Result<bool, Complaint> {
    let own =
        record.initial.build(&record.id, &ClassTable::builtin()).map_err(|(_, problem)| Complaint::new(problem))?;
    let class = |graph: &SceneGraph, id: NodeId| graph.node(id).map(|n| n.class().clone());
    let is_actor = |id: NodeId| own.agents().first() == Some(&id);
    let named: Vec<NodeId> = record.program.actions().flat_map(|action| action.things().collect::<Vec<_>>()).collect();
    Ok(named.into_iter().all(|id| is_actor(id) || class(&own, id).is_some() && class(&own, id) == class(scene, id)))
}

/// Performs the actions of all characters, one after the other.
fn run(home: &mut Environment, record: &Record) -> Result<(), (usize, ActionError)> {
    let agents = home.agents().to_vec();
    let mut numbered = record.program.steps.iter().flatten().enumerate();
    numbered.try_for_each(|(index, parsed)| {
        // Characters beyond those that fit in the scene have no node.
        let agent = agents.get(parsed.character as usize).copied().unwrap_or(NodeId(u32::MAX));
        home.set_action(agent, parsed.action).map(drop).map_err(|error| (index, error))
    })
}

/// The kind of a refusal, without names; nothing if bodies and rule disagree, which is no refusal.
fn reason(error: &ActionError) -> Option<&'static str> {
    match error {
        ActionError::Disagreement(_) => None,
        ActionError::Refused(_) => Some("refused by the rule"),
        ActionError::Impossible { why: PhysicalRefusal::NoStand(_), .. } => Some("out of reach"),
        ActionError::Impossible { why: PhysicalRefusal::NoSpot { .. }, .. } => Some("no free spot"),
        ActionError::Impossible { why: PhysicalRefusal::KeepsOpen { .. }, .. } => Some("would not shut"),
        ActionError::Impossible { .. } => Some("bodies cannot"),
        _ => Some("another"),
    }
}
