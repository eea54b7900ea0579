//! Searches an apartment for violations by brute force, from its scene and plan alone: nothing here
//! is shared with the generator.

mod collide;
mod doors;
mod rest;
mod rooms;
pub(crate) mod shape;
mod thing;
mod walk;

use std::collections::HashMap;
use std::fmt::Write as _;

use vc_graph::{NodeId, SceneGraph};
use vc_procgen::Apartment;
use vc_procgen::plan::{FloorPlan, metres};

use thing::{Thing, things};

/// The rules.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Rule {
    Generated,
    Valid,
    Collision,
    Support,
    Outside,
    UnreachableRoom,
    UnreachableObject,
    BlockedDoor,
    BlockedFront,
    Incomplete,
    Passage,
}

/// A violated rule of a seed: the classes concerned, and the values.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Finding {
    pub(crate) rule: Rule,
    /// The classes concerned, by which findings are grouped.
    pub(crate) group: String,
    pub(crate) seed: u64,
    pub(crate) text: String,
}

/// An apartment under examination.
pub(crate) struct House<'a> {
    seed: u64,
    plan: &'a FloorPlan,
    scene: &'a SceneGraph,
    things: Vec<Thing>,
    at: HashMap<NodeId, usize>,
    found: Vec<Finding>,
}

/// All violations in an apartment.
pub(crate) fn examine(seed: u64, home: &Apartment) -> Vec<Finding> {
    let scene = home.scene();
    let things = things(&scene);
    let at = things.iter().enumerate().map(|(i, t)| (t.id, i)).collect();
    let mut house = House { seed, plan: &home.plan, scene: &scene, things, at, found: Vec::new() };
    for violation in scene.validate() {
        house.note(Rule::Valid, "scene", format!("{violation}"));
    }
    collide::look(&mut house);
    rest::look(&mut house);
    walk::look(&mut house);
    doors::look(&mut house);
    rooms::look(&mut house);
    house.found
}

impl House<'_> {
    fn note(&mut self, rule: Rule, group: impl Into<String>, text: String) {
        self.found.push(Finding { rule, group: group.into(), seed: self.seed, text });
    }

    /// Whether a point, metres, is on the floor between the walls of a room: half a partition, 5
    /// cm, inside the line of its rectangles.
    fn is_within(&self, room: usize, x: f64, y: f64, slack: f64) -> bool {
        let gross = |x: f64, y: f64| {
            self.plan.rooms[room].rects.iter().any(|r| {
                let [x0, x1, y0, y1] = [r.x0, r.x1, r.y0, r.y1].map(|c| f64::from(metres(c)));
                x >= x0 - 1e-6 && x <= x1 + 1e-6 && y >= y0 - 1e-6 && y <= y1 + 1e-6
            })
        };
        let wall = 0.05 - slack;
        [(-wall, -wall), (-wall, wall), (wall, -wall), (wall, wall)].iter().all(|d| gross(x + d.0, y + d.1))
    }

    /// A room's index in the plan.
    fn room_index(&self, id: NodeId) -> Option<usize> {
        self.scene.rooms().iter().position(|&r| r == id)
    }
}

/// The findings by rule and classes, the most frequent first.
pub(crate) fn report(findings: &[&Finding]) -> String {
    let mut groups: HashMap<(Rule, &str), Vec<&Finding>> = HashMap::new();
    for finding in findings {
        groups.entry((finding.rule, &finding.group)).or_default().push(finding);
    }
    let mut groups: Vec<_> = groups.into_iter().collect();
    groups.sort_by(|a, b| b.1.len().cmp(&a.1.len()).then(a.0.cmp(&b.0)));
    let mut text = String::new();
    for ((rule, group), list) in groups {
        let _ = writeln!(text, "{rule:?} {group}: {}", list.len());
        list.iter().for_each(|f| {
            let _ = writeln!(text, "    seed {}: {}", f.seed, f.text);
        });
    }
    text
}
