//! A hand-made flat: no poses, every class once unless stated otherwise.

use vc_graph::{
    Action, ChangeSet, Draft, Edge, NodeId, Place, Refusal, Relation, SceneBuilder, SceneGraph, Simulator, State,
};

/// Rooms and the objects that stand in them.
const STANDING: &[(&str, &str)] = &[
    ("kitchen", "kitchen_table fridge stove sink faucet chair cat water dishwasher"),
    ("living_room", "sofa television coffee_table lamp computer rug"),
    ("bedroom", "single_bed wardrobe"),
    ("garage", "car workbench"),
    ("street", "parasol"),
];

/// Objects and their supports.
const ON: &[(&str, &str)] = &[
    ("cup", "kitchen_table"),
    ("plate", "kitchen_table"),
    ("knife", "kitchen_table"),
    ("tray", "kitchen_table"),
    ("bread", "plate"),
    ("potato", "kitchen_table"),
    ("frying_pan", "stove"),
    ("sponge", "sink"),
    ("book", "coffee_table"),
    ("laptop", "coffee_table"),
    ("guitar", "sofa"),
    ("hammer", "workbench"),
];

/// Objects and their containers.
const IN: &[(&str, &str)] = &[("milk", "fridge"), ("apple", "fridge"), ("shirt", "wardrobe"), ("towel", "wardrobe")];

/// A flat with two people in the kitchen, `me` and `other`.
#[derive(Debug, Clone)]
pub struct Flat {
    /// The scene, in which actions can be done.
    pub sim: Simulator,
    /// The first person.
    pub me: NodeId,
    /// The second person.
    pub other: NodeId,
}

impl Default for Flat {
    fn default() -> Self {
        Self::new()
    }
}

impl Flat {
    /// The flat as it is at first.
    pub fn new() -> Self {
        let mut scene = SceneBuilder::new("flat");
        for (room, things) in STANDING {
            let room = scene.add(Draft::new(*room)).unwrap();
            for thing in things.split(' ') {
                scene.add_in(room, Draft::new(thing)).unwrap();
            }
        }
        let find = |scene: &SceneBuilder, class: &str| scene.graph().of_class(class)[0];
        for (thing, at) in ON {
            scene.add_on(find(&scene, at), Draft::new(*thing)).unwrap();
        }
        for (thing, at) in IN {
            scene.add_in(find(&scene, at), Draft::new(*thing)).unwrap();
        }
        let kitchen = find(&scene, "kitchen");
        let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
        let other = scene.add_in(kitchen, Draft::new("character")).unwrap();
        Self { sim: Simulator::new(scene.build()), me, other }
    }

    /// The flat after some actions of `me`.
    pub fn after(actions: &[&str]) -> Self {
        let mut flat = Self::new();
        flat.all(actions);
        flat
    }

    /// The scene.
    pub fn graph(&self) -> &SceneGraph {
        self.sim.graph()
    }

    /// The first object of a class; `me` and `other` are the people.
    pub fn id(&self, name: &str) -> NodeId {
        match name {
            "me" => self.me,
            "other" => self.other,
            class => *self.graph().of_class(class).first().unwrap_or_else(|| panic!("no {class} in the flat")),
        }
    }

    /// Parses `put_in milk fridge`, with classes for objects.
    pub fn action(&self, text: &str) -> Action {
        let mut words = text.split(' ');
        let verb = words.next().unwrap().parse().unwrap();
        let things: Vec<NodeId> = words.map(|w| self.id(w)).collect();
        Action::with(verb, &things).unwrap()
    }

    /// Performs an action of `me`.
    ///
    /// # Errors
    /// The refusals.
    pub fn step(&mut self, text: &str) -> Result<ChangeSet, Vec<Refusal>> {
        let (me, action) = (self.me, self.action(text));
        self.sim.step(me, &action)
    }

    /// Performs the actions, of `other` if it is named first; panics with the refusals.
    pub fn all(&mut self, actions: &[&str]) {
        for text in actions {
            let (who, text) = text.strip_prefix("other ").map_or((self.me, *text), |rest| (self.other, rest));
            let action = self.action(text);
            self.sim.step(who, &action).unwrap_or_else(|refusals| panic!("{text}: {}", plain(&refusals)));
        }
    }

    /// Whether the first objects of two classes are related.
    pub fn has(&self, from: &str, relation: Relation, to: &str) -> bool {
        self.graph().has(Edge::new(self.id(from), relation, self.id(to)))
    }

    /// Whether the first object of a class has a state.
    pub fn is(&self, name: &str, state: State) -> bool {
        self.graph().node(self.id(name)).unwrap().is(state)
    }

    /// The place of the first object of a class.
    pub fn place(&self, name: &str) -> Option<Place> {
        self.graph().place(self.id(name))
    }

    /// Edits the scene without any action.
    pub fn edit(&mut self, edit: impl FnOnce(&mut vc_graph::Edit<'_>)) {
        let mut graph = self.graph().clone();
        let mut change = graph.edit();
        edit(&mut change);
        change.commit();
        self.sim = Simulator::new(graph);
    }
}

/// Refusals as text, without the numbers of the nodes: `cup is not open`.
pub fn plain(refusals: &[Refusal]) -> String {
    let text = refusals.iter().map(Refusal::to_string).collect::<Vec<_>>().join("; ");
    let mut parts = text.split('.');
    let first = parts.next().unwrap_or_default().to_owned();
    parts.fold(first, |all, part| all + part.trim_start_matches(|c: char| c.is_ascii_digit()))
}
