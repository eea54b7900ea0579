//! Hand-specified configurations: a small scene, a pair, and the relations that people say hold between the
//! two.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::shared;

use std::collections::{BTreeMap, BTreeSet};

use serde_json::Value;
use vc_graph::Relation;
use vc_relations::{Proximity, RelationRule, Relations};

/// Relations of which a configuration must list all that hold; other relations are listed only if they must
/// hold, or must `not` hold.
const COMPLETE: [Relation; 10] = [
    Relation::On,
    Relation::Inside,
    Relation::Under,
    Relation::SittingOn,
    Relation::LyingOn,
    Relation::InRoom,
    Relation::HoldsRight,
    Relation::HoldsLeft,
    Relation::WornBy,
    Relation::Between,
];

struct Configuration {
    name: String,
    theme: String,
    scene: shared::Named,
    pair: [String; 2],
    expect: BTreeSet<Relation>,
    not: BTreeSet<Relation>,
}

fn words(value: &Value) -> Vec<String> {
    value.as_array().into_iter().flatten().map(|v| v.as_str().unwrap().to_owned()).collect()
}

/// All configurations of a file. A scene is a list of lines; a line that starts with `+` names a scene of
/// `scenes.json` to include.
fn configurations(file: &str) -> Vec<Configuration> {
    let bases: BTreeMap<String, Value> = serde_json::from_str(include_str!("../data/scenes.json")).unwrap();
    let relations = |value: &Value| words(value).iter().map(|w| w.parse().unwrap()).collect();
    let read = |(number, line): (usize, &str)| {
        let value: Value = serde_json::from_str(line).unwrap_or_else(|e| panic!("line {}: {e}", number + 1));
        let mut lines = Vec::new();
        for line in words(&value["scene"]) {
            match line.strip_prefix('+') {
                Some(base) => lines.extend(words(bases.get(base).unwrap_or_else(|| panic!("no scene `{base}`")))),
                None => lines.push(line),
            }
        }
        Configuration {
            name: value["name"].as_str().unwrap().to_owned(),
            theme: value["theme"].as_str().unwrap_or("").to_owned(),
            scene: shared::scene(lines.iter().map(String::as_str)),
            pair: words(&value["pair"]).try_into().unwrap(),
            expect: relations(&value["expect"]),
            not: relations(&value["not"]),
        }
    };
    file.lines().enumerate().filter(|(_, l)| !l.trim().is_empty()).map(read).collect()
}

/// The deviation from the expected relations, if any.
fn judge(c: &Configuration, rule: RelationRule) -> Option<String> {
    let relations = Relations::new(&c.scene.graph, rule, c.scene.evidence.clone()).unwrap();
    let [from, to] = [0, 1].map(|i| c.scene.id(&c.pair[i]));
    let found: BTreeSet<Relation> = relations.between(from, to).into_iter().collect();
    let complete: BTreeSet<Relation> = COMPLETE.into();
    let more = found.intersection(&complete).any(|r| !c.expect.contains(r)) || found.intersection(&c.not).count() > 0;
    let fewer = c.expect.difference(&found).count() > 0;
    let why = || format!("{}\n    expected {:?}, not {:?}, found {found:?}", c.name, c.expect, c.not);
    (more || fewer).then(why)
}

fn all() -> Vec<Configuration> {
    configurations(include_str!("../data/configurations.jsonl"))
}

#[test]
fn every_configuration_is_right_by_the_default_rule() {
    let all = all();
    let wrong: Vec<String> = all.iter().filter_map(|c| judge(c, RelationRule::Contacts)).collect();
    assert!(all.len() >= 200, "only {} configurations", all.len());
    assert!(wrong.is_empty(), "{} of {} wrong:\n{}", wrong.len(), all.len(), wrong.join("\n"));
}

/// Things with a low rim, and things that are open in front and behind.
#[test]
fn low_rims_and_missing_backs_hold_things() {
    let all = configurations(include_str!("../data/rims_and_backs.jsonl"));
    let wrong: Vec<String> = all.iter().filter_map(|c| judge(c, RelationRule::Contacts)).collect();
    assert!(all.len() == 10 && wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The named degrees of nearness, in both directions.
#[test]
fn nearness_has_names() {
    use Proximity::{ArmsReach, BehindWall, Far, Near, TouchingDistance};
    let lines = |more: &[&str]| {
        let base: BTreeMap<String, Value> = serde_json::from_str(include_str!("../data/scenes.json")).unwrap();
        words(&base["room"]).into_iter().chain(more.iter().map(|l| (*l).to_owned())).collect::<Vec<String>>()
    };
    let partition = "p = wall 0.1 2 2.5 @ 0.35 0 0";
    let cases: [(&[&str], &str, Proximity, bool); 6] = [
        (&["b = box 0.1 0.1 0.1 @ 0.13 0 0"], "b", TouchingDistance, true),
        (&["b = box 0.1 0.1 0.1 @ 0.7 0 0"], "b", ArmsReach, true),
        (&["b = box 0.1 0.1 0.1 @ 1.0 0 0"], "b", Near, true),
        (&["b = box 0.1 0.1 0.1 @ 0.7 0 0", partition], "b", BehindWall, true),
        (&["b = box 0.1 0.1 0.1 @ 0.7 1.5 0", partition], "b", Far, false),
        (&["b = box 0.1 0.1 0.1 @ 2.5 0 0"], "b", Far, false),
    ];
    for (more, other, proximity, near) in cases {
        let lines = lines(&[&["a = box 0.1 0.1 0.1"], more].concat());
        let scene = shared::scene(lines.iter().map(String::as_str));
        let relations = Relations::new(&scene.graph, RelationRule::Contacts, scene.evidence.clone()).unwrap();
        let (a, b) = (scene.id("a"), scene.id(other));
        assert_eq!([(a, b), (b, a)].map(|(a, b)| relations.proximity(a, b)), [Some(proximity); 2], "{more:?}");
        assert_eq!(relations.between(a, b).contains(&Relation::Near), near, "{more:?}");
        assert_eq!(relations.proximity(a, scene.id("wall_e")), None, "a wall is no thing");
    }
}

#[test]
fn names_are_unique() {
    let all = all();
    let names: BTreeSet<&str> = all.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names.len(), all.len());
}

/// The share of configurations that the thesis's rule gets right, by theme. Near and touching do not count
/// against it, as it has no touching and sees only the first thing on each side.
#[test]
fn the_box_traces_are_reported_beside_it() {
    let mut table: BTreeMap<String, (usize, usize)> = BTreeMap::new();
    for mut c in all() {
        c.not.clear();
        c.expect.retain(|r| COMPLETE.contains(r));
        let entry = table.entry(c.theme.clone()).or_default();
        entry.1 += 1;
        entry.0 += usize::from(judge(&c, RelationRule::BoxTrace).is_none());
    }
    let (right, of) = table.values().fold((0, 0), |s, v| (s.0 + v.0, s.1 + v.1));
    for (theme, (right, of)) in &table {
        eprintln!("{theme:>24}: box traces {right:>3} of {of}");
    }
    eprintln!("{:>24}: box traces {right:>3} of {of}", "all");
    // The numbers reported in the benches' README.
    assert_eq!((right, of), (135, 318));
    let theme = |name: &str| table[name];
    assert_eq!([theme("cupboards"), theme("two supports"), theme("open containers")], [(3, 18), (1, 9), (9, 49)]);
}
