//! All relations of a scene, with explanations.
//!
//! `cargo run --release --example relations` builds a corner of a kitchen by hand, derives its relations from
//! poses and shapes, lists them beside the results of the thesis's rule, and explains one pair as text and as a
//! picture (SVG). `--scene FILE` takes any scene file with poses instead, `--why apple.8 bowl.7` another pair.

mod kitchen;
mod picture;
#[path = "../support/mod.rs"]
mod support;

use std::path::{Path, PathBuf};

use clap::Parser;
use support::{Complaint, say};
use vc_graph::{ClassTable, Edge, NodeId, Relation, SceneGraph, Word};
use virtualcity::relations::{Evidence, RelationRule, Relations};

/// All relations of a scene, with explanations.
#[derive(Parser)]
struct Options {
    /// A scene file with poses; by default a kitchen corner built by hand.
    #[arg(long)]
    scene: Option<PathBuf>,
    /// Two objects, as `apple.8 bowl.7`, whose relations are explained.
    #[arg(long, num_args = 2, value_names = ["THING", "OTHER"])]
    why: Option<Vec<String>>,
    /// Also list near, touching and sides.
    #[arg(long)]
    all: bool,
    /// The output file of the picture.
    #[arg(long, default_value = "out/relations.svg")]
    out: PathBuf,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let graph = match &options.scene {
        Some(file) => virtualcity::read_scene(file, &ClassTable::builtin())?,
        None => kitchen::build().map_err(Complaint::new)?,
    };
    let relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default()).map_err(Complaint::new)?;
    list(&graph, &relations, options.all);
    compare(&graph, &relations)?;
    let (from, to) = pair(&graph, &relations, options.why.as_deref())?;
    let none = || Complaint::new("one of the two has no pose or no shape");
    let why = relations.explain(from, to).ok_or_else(none)?;
    say!("\nWhy: {} and {}", graph.label(from), graph.label(to));
    say!("{}", named(&graph, &why.to_string()));
    write(&options.out, &picture::draw(&graph, &why))?;
    say!("Picture: {}", options.out.display());
    Ok(())
}

fn write(path: &Path, text: &str) -> Result<(), Complaint> {
    Ok(virtualcity::files::write(path, text)?)
}

/// Whether a relation gives a placement: these are listed first, the rest with `--all`.
fn is_placement(relation: Relation) -> bool {
    use Relation::{Between, Facing, Inside, LyingOn, On, SittingOn, Under};
    matches!(relation, On | Inside | Under | SittingOn | LyingOn | Between | Facing)
}

fn list(graph: &SceneGraph, relations: &Relations, all: bool) {
    say!("{} nodes, {} relations", graph.len(), relations.edges().len());
    for node in graph.nodes() {
        let edges = relations.edges_of(node.id());
        let shown = edges.iter().filter(|e| all || is_placement(e.relation));
        let words: Vec<String> = shown.map(|e| format!("{} {}", e.relation.as_str(), graph.label(e.to))).collect();
        if !words.is_empty() {
            say!("{:>20}  {}", node.label().to_string(), words.join(", "));
        }
    }
}

/// Lists the differences from the thesis's rule.
fn compare(graph: &SceneGraph, relations: &Relations) -> Result<(), Complaint> {
    let plain = Relations::new(graph, RelationRule::BoxTrace, Evidence::default()).map_err(Complaint::new)?;
    let placed = |r: &Relations, id| -> Vec<Edge> {
        let counts = |e: &Edge| matches!(e.relation, Relation::On | Relation::Inside | Relation::Under);
        r.edges_of(id).into_iter().filter(counts).collect()
    };
    say!("\nWhat the plain box traces say instead:");
    for node in graph.nodes() {
        let (ours, theirs) = (placed(relations, node.id()), placed(&plain, node.id()));
        if ours != theirs {
            let words: Vec<String> =
                theirs.iter().map(|e| format!("{} {}", e.relation.as_str(), graph.label(e.to))).collect();
            let words = if words.is_empty() { "nothing".to_owned() } else { words.join(", ") };
            say!("{:>20}  {words}", node.label().to_string());
        }
    }
    Ok(())
}

/// The pair to explain: the requested one, else the first object that is inside another.
fn pair(graph: &SceneGraph, relations: &Relations, why: Option<&[String]>) -> Result<(NodeId, NodeId), Complaint> {
    if let Some([from, to]) = why {
        let find = |text: &String| {
            let label: vc_graph::Label = text.parse().map_err(Complaint::new)?;
            graph.check_label(&label).map_err(Complaint::new)?;
            graph.node(label.id).map(vc_graph::Node::id).ok_or_else(|| Complaint::new(format!("no node is {text}")))
        };
        return Ok((find(from)?, find(to)?));
    }
    let edges = relations.edges();
    let first = |relation| edges.iter().find(|e| e.relation == relation);
    let edge = first(Relation::Inside).or_else(|| first(Relation::On));
    edge.map(|e| (e.from, e.to)).ok_or_else(|| Complaint::new("nothing is on or in anything"))
}

/// Replaces numbers by labels: `#7` by `bowl.7`.
pub(crate) fn named(graph: &SceneGraph, text: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find('#') {
        let digits: String = rest[at + 1..].chars().take_while(char::is_ascii_digit).collect();
        out += &rest[..at];
        match digits.parse() {
            Ok(number) => out += &graph.label(NodeId(number)).to_string(),
            Err(_) => out += "#",
        }
        rest = &rest[at + 1 + digits.len()..];
    }
    out + rest
}
