//! Own verbs whose effects are put together by chance: graph and bodies stay one.

use virtualcity::Environment;
use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, NodeId, Seed, State, Verb, Vocabulary, rule};
use virtualcity::physics::{Hand, Posture};

/// Effects for one thing; with `y` for `x` those of two.
const EFFECTS: &[&str] = &[
    "go_to x",
    "approach x",
    "face x",
    "hold x",
    "put_where_it_was x",
    "let_go x",
    "sit_on x",
    "lie_on x",
    "stand_up",
    "fill_with_water x",
    "enter x open",
    "enter x closed",
    "enter x clean",
    "enter x folded",
    "enter_own asleep",
];
const OF_TWO: &[&str] = &["put_on x y", "put_into y x", "pour_into x y"];
const MOTIONS: &[&str] = &["none", "go", "reach", "hold", "sit", "use_at", "dance"];

/// Forty verbs with one to three effects and, now and then, nearness for a need.
fn verbs(seed: u64) -> String {
    let mut chance = Seed(seed).child("own verbs by chance").stream();
    let mut lines = String::new();
    for n in 0..40 {
        let things = 1 + n % 2;
        let effect = |_| {
            let of = if things == 2 && chance.chance(0.4) { OF_TWO } else { EFFECTS };
            let effect = chance.pick(of).copied().unwrap_or_default();
            if things == 2 && chance.chance(0.5) { effect.replace(" x", " y") } else { effect.to_owned() }
        };
        let effects: Vec<String> = (0..1 + n % 3).map(effect).collect();
        let needs = if n % 4 == 0 { " | needs: near x" } else { "" };
        let motion = MOTIONS[n % MOTIONS.len()];
        lines += &format!("verb chance_{n} {things}{needs} | effects: {} | motion: {motion}\n", effects.join("; "));
    }
    lines
}

/// An action of one of the own verbs that the rule allows near an agent, or a built-in one.
fn some_action(home: &Environment, agent: NodeId, chance: &mut virtualcity::graph::Stream) -> Option<Action> {
    let at = home.graph().node(agent)?.position()?;
    let legal = rule::legal_actions_with(home.graph(), agent, &home.graph().within(at, 2.0));
    let mut verbs: Vec<Verb> = legal.iter().map(|action| action.verb).collect();
    verbs.dedup();
    let own = chance.chance(0.8);
    verbs.retain(|verb| verb.is_builtin() != own);
    let verb = *chance.pick(&verbs)?;
    let all: Vec<&Action> = legal.iter().filter(|action| action.verb == verb).collect();
    chance.pick(&all).map(|action| **action)
}

/// Checks that bodies are as the graph has them: poses, hands, postures.
fn is_one(home: &Environment, after: &str) {
    let graph = home.graph();
    let poses = graph.nodes().filter_map(|node| Some((node, node.pose()?, home.world().pose(node.id())?)));
    for (node, said, is) in poses {
        let far = (said.translation.vector - is.translation.vector).norm();
        assert!(far < 0.02, "{after}: {} is {far} m off", node.label());
    }
    for &agent in home.agents() {
        let mut said: Vec<NodeId> = graph.held(agent).collect();
        let mut held: Vec<NodeId> = Hand::BOTH.into_iter().filter_map(|hand| home.world().held(agent, hand)).collect();
        said.sort_unstable();
        held.sort_unstable();
        assert_eq!(said, held, "{after}: hands");
        let rests = graph.node(agent).is_some_and(|node| node.is(State::Sitting) || node.is(State::Lying));
        assert_eq!(rests, home.world().posture(agent) != Some(Posture::Standing), "{after}: posture");
    }
    let before = home.start().validate();
    let new: Vec<_> = graph.validate().into_iter().filter(|fault| !before.contains(fault)).collect();
    assert_eq!(new, [], "{after}");
}

/// An action with its effects.
fn described(home: &Environment, action: &Action) -> String {
    let effects = home.graph().vocabulary().rule(action.verb).map(|rule| rule.effects.to_vec());
    format!("{} {effects:?}", action.describe(home.graph()))
}

#[test]
fn own_verbs_put_together_by_chance_keep_graph_and_bodies_one() {
    let mut done = 0;
    for seed in 0..6 {
        let words = Vocabulary::parse("words.txt", &verbs(seed)).unwrap();
        let home = Environment::builder(format!("apartment/{seed}")).agents(2).vocabulary(words);
        let mut home = home.make().unwrap();
        let mut chance = Seed(seed).child("own actions by chance").stream();
        for round in 0..25 {
            let agents = home.agents().to_vec();
            let act = |agent: &NodeId| Some((*agent, some_action(&home, *agent, &mut chance)?));
            let actions: Vec<(NodeId, Action)> = agents.iter().filter_map(act).collect();
            let named: Vec<String> = actions.iter().map(|(_, action)| described(&home, action)).collect();
            let outcomes = home.set_actions(&actions);
            done += outcomes.iter().filter(|outcome| outcome.is_ok()).count();
            // Something may roll still.
            home.step(Span::from_seconds(5.0));
            is_one(&home, &format!("{seed}, {round}: {}, {outcomes:?}", named.join(", ")));
        }
    }
    assert!(done > 150, "{done} of 300");
}
