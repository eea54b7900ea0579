//! A scene format of your own: a text of one line for each object, read into a scene and simulated.
//!
//! `cargo run --release --example own_format`

#[path = "support/no_options.rs"]
mod no_options;
mod support;

use std::collections::HashMap;

use support::{Complaint, say};
use vc_graph::{Draft, Edge, EditError, NodeId, Relation, SceneBuilder, SceneGraph, Simulator};

/// `name: class, where`, the rooms first.
const TEXT: &str = "
k: kitchen
t: kitchen_table in k
c: cup on t
f: fridge in k
me: character in k
";

/// An error in a text, with its line.
#[derive(Debug, thiserror::Error)]
enum ReadError {
    #[error("line {0}: a line is `name: class`, or `name: class on|in name`")]
    Form(usize),
    #[error("line {0}: there is no `{1}` above")]
    Unknown(usize, String),
    #[error("line {0}: {1}")]
    Edit(usize, EditError),
}

fn read(text: &str) -> Result<SceneGraph, ReadError> {
    let mut scene = SceneBuilder::new("mine");
    let mut names: HashMap<&str, NodeId> = HashMap::new();
    for (line, row) in text.lines().enumerate().filter(|(_, row)| !row.trim().is_empty()) {
        let (name, rest) = row.split_once(':').ok_or(ReadError::Form(line + 1))?;
        let words: Vec<&str> = rest.split_whitespace().collect();
        let at = |name: &str| names.get(name).copied().ok_or(ReadError::Unknown(line + 1, name.into()));
        let added = match words[..] {
            [class] => scene.add(Draft::new(class)),
            [class, "in", place] => scene.add_in(at(place)?, Draft::new(class)),
            [class, "on", place] => scene.add_on(at(place)?, Draft::new(class)),
            _ => return Err(ReadError::Form(line + 1)),
        };
        names.insert(name.trim(), added.map_err(|e| ReadError::Edit(line + 1, e))?);
    }
    Ok(scene.build())
}

fn main() -> Result<(), Complaint> {
    no_options::no_options();
    let mut world = Simulator::new(read(TEXT)?);
    let agent = world.graph().agents()[0];
    for action in ["walk cup.3", "grab cup.3", "walk fridge.4", "open fridge.4", "put_in cup.3 fridge.4"] {
        world.step(agent, &action.parse()?).map_err(|refusals| refusals[0].clone())?;
    }
    let (cup, fridge) = (NodeId(3), NodeId(4));
    say!(
        "{} is in {}: {}",
        world.graph().label(cup),
        world.graph().label(fridge),
        world.graph().has(Edge::new(cup, Relation::Inside, fridge))
    );
    if let Err(error) = read("k: kitchen\nc: cup beside k") {
        say!("{error}");
    }
    Ok(())
}
