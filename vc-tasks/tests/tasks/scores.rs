//! Credits compared with an enumeration of all ways, and scores with known answers.
#![allow(clippy::unwrap_used)]

use crate::common;
use std::collections::BTreeSet;

use common::{Room, flips, timeless};
use proptest::prelude::*;
use vc_graph::goal::{Comparison, Literal, Pairing, Pairs, Situation, Term};
use vc_graph::{Goal, NodeId};
use vc_tasks::compile::GoalProgram;
use vc_tasks::score::percent_complete;
use vc_testkit::cases;

/// A condition: its atom, whether it is wanted true, whether it is fulfilled.
type Condition = (String, bool, bool);
type Ways = Vec<Vec<Condition>>;

/// The greatest number of ways that is enumerated.
const MOST: usize = 3000;

/// Enumerates all ways to make a goal true or false, by the definition; `None` if there are too
/// many.
struct Lister<'g, 'a> {
    now: Situation<'a>,
    bound: Vec<(&'g str, NodeId)>,
}

impl<'g> Lister<'g, '_> {
    fn ways(&mut self, goal: &'g Goal, wanted: bool) -> Option<Ways> {
        match goal {
            Goal::Literal(l) => self.literal(l, Comparison::AtLeast, 1, wanted),
            Goal::Count { literal, comparison, number } => self.literal(literal, *comparison, *number, wanted),
            Goal::Same(a, b) => {
                let same = self.meant(a).is_some() && self.meant(a) == self.meant(b);
                Some(if same == wanted { vec![vec![]] } else { vec![] })
            }
            Goal::And(parts) => {
                let each = self.each(parts.iter())?;
                count(each, Comparison::AtLeast, parts.len() as u32, wanted)
            }
            Goal::Or(parts) => count(self.each(parts.iter())?, Comparison::AtLeast, 1, wanted),
            Goal::Not(part) => self.ways(part, !wanted),
            Goal::Imply(a, b) => {
                let [no, yes] = [self.ways(a, false)?, self.ways(a, true)?];
                let each = vec![[no, yes], [self.ways(b, true)?, self.ways(b, false)?]];
                count(each, Comparison::AtLeast, 1, wanted)
            }
            Goal::ForAll(q) => {
                let each = self.quantified(&q.variable, q.class.as_deref(), &q.body)?;
                let number = each.len() as u32;
                count(each, Comparison::AtLeast, number, wanted)
            }
            Goal::Exists(q) => {
                count(self.quantified(&q.variable, q.class.as_deref(), &q.body)?, Comparison::AtLeast, 1, wanted)
            }
            Goal::ForN { comparison, number, of } => {
                count(self.quantified(&of.variable, of.class.as_deref(), &of.body)?, *comparison, *number, wanted)
            }
            Goal::ForPairs(pairs) => self.pairs(pairs, wanted),
            _ => None,
        }
    }

    fn each(&mut self, parts: impl Iterator<Item = &'g Goal>) -> Option<Vec<[Ways; 2]>> {
        parts.map(|p| Some([self.ways(p, true)?, self.ways(p, false)?])).collect()
    }

    fn quantified(&mut self, variable: &'g str, class: Option<&str>, body: &'g Goal) -> Option<Vec<[Ways; 2]>> {
        let things = self.now.graph.of_class(class.unwrap());
        let with = |id| {
            self.bound.push((variable, id));
            let both = self.ways(body, true).zip(self.ways(body, false));
            self.bound.pop();
            both.map(|(yes, no)| [yes, no])
        };
        things.into_iter().map(with).collect()
    }

    fn meant(&self, term: &Term) -> Option<NodeId> {
        match term {
            Term::Variable(name) => self.bound.iter().rev().find(|(n, _)| n == name).map(|b| b.1),
            Term::Node(_, id) => Some(*id),
            Term::Me => Some(self.now.agent),
            _ => None,
        }
    }

    fn literal(&self, literal: &Literal, comparison: Comparison, number: u32, wanted: bool) -> Option<Ways> {
        let things = |t: &Term| match t {
            Term::Class(_) | Term::Anything => self.now.candidates(t).into_iter().map(Some).collect(),
            t => self.meant(t).map(Some).into_iter().collect::<Vec<_>>(),
        };
        let lists: Vec<Vec<Option<NodeId>>> = literal.terms.iter().map(things).collect();
        let counted = literal.counted().unwrap_or(0);
        let nothing = vec![None];
        let (firsts, others) = (
            lists.get(counted).unwrap_or(&nothing),
            match lists.len() {
                2 => &lists[1 - counted],
                _ => &nothing,
            },
        );
        let mut each = Vec::new();
        for &a in firsts {
            let atom = |&b: &Option<NodeId>| {
                let things = if counted == 0 { [a, b] } else { [b, a] };
                let (name, holds) =
                    (format!("{:?}{things:?}", literal.predicate), self.now.holds(literal.predicate, things));
                [vec![vec![(name.clone(), true, holds)]], vec![vec![(name, false, !holds)]]]
            };
            let inner: Vec<[Ways; 2]> = others.iter().map(atom).collect();
            each.push([
                count(inner.clone(), Comparison::AtLeast, 1, true)?,
                count(inner, Comparison::AtLeast, 1, false)?,
            ]);
        }
        count(each, comparison, number, wanted)
    }

    fn pairs(&mut self, pairs: &'g Pairs, wanted: bool) -> Option<Ways> {
        let range = |class: &Option<String>| self.now.graph.of_class(class.as_deref().unwrap());
        let (rows, columns) = (range(&pairs.first.class), range(&pairs.second.class));
        let mut table = Vec::new();
        for &a in &rows {
            let mut row = Vec::new();
            for &b in &columns {
                self.bound.extend([(pairs.first.name.as_str(), a), (pairs.second.name.as_str(), b)]);
                row.push(if a == b { Some(vec![]) } else { self.ways(&pairs.body, true) });
                self.bound.truncate(self.bound.len() - 2);
            }
            table.push(row.into_iter().collect::<Option<Vec<Ways>>>()?);
        }
        let found = pairs.pairing.number(&met(&table), columns.len()) as u32;
        let most = rows.len().min(columns.len()) as u32;
        let at_least = |number: u32, wanted: bool| match (number, wanted) {
            (0, _) => Some(if wanted { vec![vec![]] } else { vec![] }),
            (n, _) if n > most => Some(if wanted { vec![] } else { vec![vec![]] }),
            (n, false) => Some(vec![vec![(format!("{pairs:?} {n} {:?}", self.bound), false, found < n)]]),
            (n, true) => pairings(&table, n as usize),
        };
        match pairs.number {
            None => at_least(most, wanted),
            Some((Comparison::AtLeast, n)) => at_least(n, wanted),
            Some((Comparison::AtMost, n)) => at_least(n + 1, !wanted),
            Some((Comparison::Exactly, n)) => {
                let each =
                    vec![[at_least(n, true)?, at_least(n, false)?], [at_least(n + 1, false)?, at_least(n + 1, true)?]];
                count(each, Comparison::AtLeast, 2, wanted)
            }
        }
    }
}

/// The cells that hold because one of their ways is fulfilled.
fn met(table: &[Vec<Ways>]) -> Vec<Vec<usize>> {
    let holds = |ways: &Ways| ways.iter().any(|way| way.iter().all(|c| c.2));
    table.iter().map(|row| (0..row.len()).filter(|&c| holds(&row[c])).collect()).collect()
}

/// The ways of choosing a number of cells in different rows and columns.
fn pairings(table: &[Vec<Ways>], number: usize) -> Option<Ways> {
    fn from(table: &[Vec<Ways>], number: usize, row: usize, taken: u32) -> Option<Ways> {
        if number == 0 {
            return Some(vec![vec![]]);
        }
        let Some(cells) = table.get(row) else { return Some(vec![]) };
        let mut all = from(table, number, row + 1, taken)?;
        for (column, ways) in cells.iter().enumerate().filter(|(c, _)| taken & (1 << c) == 0) {
            let rest = from(table, number - 1, row + 1, taken | (1 << column))?;
            all.extend(both(ways, &rest)?);
        }
        (all.len() <= MOST).then_some(all)
    }
    from(table, number, 0, 0)
}

fn both(a: &Ways, b: &Ways) -> Option<Ways> {
    if a.len() * b.len() > MOST {
        return None;
    }
    Some(a.iter().flat_map(|x| b.iter().map(move |y| [x.clone(), y.clone()].concat())).collect())
}

/// The ways of making a number of parts true.
fn count(each: Vec<[Ways; 2]>, comparison: Comparison, number: u32, wanted: bool) -> Option<Ways> {
    // A part whose truth is constant is no condition.
    let sure = each.iter().filter(|[yes, no]| no.is_empty() && *yes == [vec![]]).count() as u32;
    let open = |[yes, no]: &[Ways; 2]| !(no.is_empty() && *yes == [vec![]] || yes.is_empty() && *no == [vec![]]);
    let each: Vec<[Ways; 2]> = each.into_iter().filter(open).collect();
    if comparison == Comparison::Exactly && number < sure {
        return Some(if wanted { vec![] } else { vec![vec![]] });
    }
    let number = if comparison == Comparison::AtMost { number } else { number.saturating_sub(sure) };
    let (n, k) = (each.len(), number as usize);
    match (comparison, wanted) {
        (Comparison::AtLeast, true) => so_many(&each, k, 0),
        (Comparison::AtLeast, false) if k == 0 => Some(vec![]),
        (Comparison::AtLeast, false) if k > n => Some(vec![vec![]]),
        (Comparison::AtLeast, false) => so_many(&each, 0, n + 1 - k),
        (Comparison::AtMost, _) if sure > number => Some(if wanted { vec![] } else { vec![vec![]] }),
        (Comparison::AtMost, _) => count(each, Comparison::AtLeast, number + 1 - sure, !wanted),
        (Comparison::Exactly, true) if k > n => Some(vec![]),
        (Comparison::Exactly, true) => so_many(&each, k, n - k),
        (Comparison::Exactly, false) => {
            let mut all = so_many(&each, k + 1, 0)?;
            all.extend(if k > n { vec![vec![]] } else { so_many(&each, 0, n + 1 - k)? });
            Some(all)
        }
    }
}

/// The ways of making a number of parts true and a number of others false.
fn so_many(each: &[[Ways; 2]], yes: usize, no: usize) -> Option<Ways> {
    if yes + no == 0 {
        return Some(vec![vec![]]);
    }
    let Some((first, rest)) = each.split_first() else { return Some(vec![]) };
    let mut all = so_many(rest, yes, no)?;
    if yes > 0 {
        all.extend(both(&first[0], &so_many(rest, yes - 1, no)?)?);
    }
    if no > 0 {
        all.extend(both(&first[1], &so_many(rest, yes, no - 1)?)?);
    }
    (all.len() <= MOST).then_some(all)
}

fn is_sound(way: &[Condition]) -> bool {
    let wanted: BTreeSet<(&str, bool)> = way.iter().map(|c| (c.0.as_str(), c.1)).collect();
    wanted.iter().all(|&(name, value)| !wanted.contains(&(name, !value)))
}

/// Whether a goal counts pairs by margins.
fn has_margins(goal: &Goal) -> bool {
    matches!(goal, Goal::ForPairs(p) if p.pairing == Pairing::Marginal) || goal.parts().into_iter().any(has_margins)
}

proptest! {
    #![proptest_config(cases(3000))]

    #[test]
    fn a_credit_is_one_if_and_only_if_the_goal_holds(goal in timeless(3), flips in flips(30)) {
        let room = Room::new(&flips);
        let program = GoalProgram::new(&goal, &room.now()).unwrap();
        let credit = program.credit(&program.read(&room.now()));
        prop_assert!(credit.satisfied <= credit.conditions && credit.exact);
        prop_assert_eq!(credit.value() == 1.0, goal.holds(&room.now()), "{} {:?}", goal, credit);
    }

    #[test]
    fn a_credit_is_the_best_of_all_ways(goal in timeless(2), flips in flips(30)) {
        let room = Room::new(&flips);
        let program = GoalProgram::new(&goal, &room.now()).unwrap();
        let bits = program.read(&room.now());
        let mut lister = Lister { now: room.now(), bound: Vec::new() };
        let Some(ways) = lister.ways(&goal, true) else { return Ok(()) };
        let share = |way: &Vec<Condition>| match way.len() {
            0 => 1.0,
            n => way.iter().filter(|c| c.2).count() as f64 / n as f64,
        };
        let sound: Vec<&Vec<Condition>> = ways.iter().filter(|w| is_sound(w)).collect();
        let best = sound.iter().map(|w| share(w)).fold(0.0, f64::max);
        let credit = program.credit(&bits);
        prop_assert_eq!(credit.possible, !sound.is_empty() || goal.holds(&room.now()), "{}", goal);
        if !has_margins(&goal) || !goal.holds(&room.now()) {
            prop_assert!((credit.value() - best).abs() < 1e-12, "{}: {:?}, not {}", goal, credit, best);
        }
    }

    #[test]
    fn what_is_unmet_are_the_minimal_sets(goal in timeless(2), flips in flips(30)) {
        let room = Room::new(&flips);
        let program = GoalProgram::new(&goal, &room.now()).unwrap();
        let bits = program.read(&room.now());
        let found = program.unmet(&bits, 1 << 13);
        let changed = |set: &[usize]| {
            let mut bits = bits.clone();
            set.iter().for_each(|&atom| bits.set(atom, !bits.has(atom)));
            program.holds(&bits)
        };
        let index = |unmet: &vc_tasks::Unmet| program.atoms().iter().position(|a| *a == unmet.atom).unwrap();
        let sets: Vec<Vec<usize>> = found.sets.iter().map(|set| set.iter().map(index).collect()).collect();
        prop_assert!(found.sets.iter().flatten().all(|u| bits.has(index(u)) != u.wanted));
        prop_assert!(sets.is_sorted_by_key(Vec::len), "{}: {:?}", goal, sets);
        for set in &sets {
            prop_assert!(changed(set), "{}: {:?}", goal, set);
        }
        // The reference: all minimal sets, by trying every set.
        let number = program.atoms().len();
        if number <= 10 {
            let of = |set: usize| (0..number).filter(|atom| set >> atom & 1 != 0).collect::<Vec<usize>>();
            let mut minimal: Vec<usize> = Vec::new();
            let mut all: Vec<usize> = (0..1 << number).collect();
            all.sort_by_key(|set: &usize| set.count_ones());
            for set in all {
                if minimal.iter().all(|m| m & set != *m) && changed(&of(set)) {
                    minimal.push(set);
                }
            }
            let mut listed: Vec<Vec<usize>> = minimal.into_iter().map(of).collect();
            let mut sets = sets;
            listed.sort();
            sets.sort();
            prop_assert!(found.complete);
            prop_assert_eq!(sets, listed, "{}", goal);
        }
    }

    #[test]
    fn the_scores_of_others(goal in timeless(3), before in flips(20), then in flips(20)) {
        let mut room = Room::new(&before);
        let program = GoalProgram::new(&goal, &room.now()).unwrap();
        let start = program.read(&room.now());
        then.into_iter().for_each(|flip| {
            room.flip(flip);
        });
        let now = program.read(&room.now());
        let (reward, q, rate) = (program.bddl_reward(&now).value(), program.q_score(&start, &now), program.conditions(&now).rate());
        let holds = program.holds(&now);
        prop_assert!((0.0..=1.0).contains(&reward) && (0.0..=1.0).contains(&q));
        prop_assert_eq!(rate == 1.0, holds);
        prop_assert!(!holds || q == 1.0);
        // A condition that held at the start and still holds earns nothing.
        prop_assert!(holds || program.q_score(&now, &now) == 0.0 || program.bddl_reward(&now).conditions == 0);
    }
}

/// Two dusty cups, one covered by the first plate.
fn room() -> Room {
    Room::new(&[(0, 0, 0), (0, 1, 0), (2, 0, 3)])
}

fn credit(text: &str) -> (u32, u32) {
    let room = room();
    let program = GoalProgram::new(&text.parse().unwrap(), &room.now()).unwrap();
    let credit = program.credit(&program.read(&room.now()));
    (credit.satisfied, credit.conditions)
}

#[test]
fn credits_by_hand() {
    for (text, expected) in [
        ("Dusty(cup.2) & Dusty(cup.4)", (1, 2)),
        ("forall ?c: cup. Dusty(?c)", (2, 3)),
        ("exactly 1 ?c: cup. Dusty(?c)", (2, 3)),
        ("at least 3 ?c: cup. Dusty(?c)", (2, 3)),
        ("at most 1 ?c: cup. Dusty(?c)", (1, 2)),
        ("(Dusty(cup.4) & Stained(cup.4)) | (Dusty(cup.2) & Dusty(cup.3) & Stained(cup.4))", (2, 3)),
        ("pairs ?c: cup, ?p: plate. Covered(?c, ?p)", (1, 3)),
        ("pairs ?c: cup, ?p: plate. Dusty(?c) & Covered(?c, ?p)", (3, 6)),
        ("Dusty(cup.2) & !Dusty(cup.2)", (0, 0)),
        ("(Dusty(cup.4) | Stained(cup.4)) & (!Dusty(cup.4) | !Dusty(cup.2))", (1, 2)),
    ] {
        assert_eq!(credit(text), expected, "{text}");
    }
}

#[test]
fn bddl_counts_the_asked_for_alone() {
    let room = room();
    let reward = |text: &str| {
        let program = GoalProgram::new(&text.parse().unwrap(), &room.now()).unwrap();
        program.bddl_reward(&program.read(&room.now())).value()
    };
    assert_eq!(reward("exactly 1 ?c: cup. Dusty(?c)"), 1.0, "two are dusty");
    assert_eq!(reward("exactly 2 ?p: plate. Dusty(?p)"), 0.0);
    assert_eq!(reward("(forall ?c: cup. Dusty(?c)) & Dusty(plate.5)"), 0.5);
}

#[test]
fn propositions_that_last_and_such_that_need_not() {
    let mut room = Room::new(&[]);
    let mut trace = vc_graph::goal::EpisodeTrace::new(room.graph.clone(), room.me);
    for flip in [(0, 0, 0), (0, 1, 0), (0, 0, 0)] {
        room.flip(flip);
        trace.push(room.graph.clone(), []);
    }
    let complete = |text: &str| {
        let goal: Goal = text.parse().unwrap();
        let found = percent_complete(&goal, &trace);
        (found.satisfied, found.conditions)
    };
    assert_eq!(complete("Dusty(cup.2) & Dusty(cup.3)"), (1, 2), "the first was undone");
    assert_eq!(complete("eventually Dusty(cup.2) & Dusty(cup.3)"), (2, 2));
    assert_eq!(complete("Dusty(cup), 3 & Dusty(cup.3)"), (2, 4));
    assert_eq!(complete("Dusty(cup.2) before Dusty(cup.3)"), (1, 1));
    let goal: Goal = "Dusty(cup.2) & Dusty(cup.3) & Dusty(plate) & eventually Dusty(cup.2)".parse().unwrap();
    assert_eq!(vc_tasks::first_held(&goal, &trace), [Some(1), Some(2), None, Some(1)]);
}

#[test]
fn explanations_name_things() {
    let room = room();
    let goal: Goal = "(forall ?c: cup. Dusty(?c)) & (exists ?p: plate. Covered(cup.2, ?p))".parse().unwrap();
    let parts = vc_tasks::explain(&goal, &room.now()).unwrap();
    let shown: Vec<String> = parts[0].unmet.iter().flatten().map(ToString::to_string).collect();
    assert_eq!((parts[0].holds, shown), (false, vec!["Dusty(#4)".to_owned()]));
    let bindings = parts[0].bindings.as_ref().unwrap();
    assert_eq!(
        (bindings.satisfied.as_slice(), bindings.unsatisfied.as_slice()),
        (&[NodeId(2), NodeId(3)][..], &[NodeId(4)][..])
    );
    assert!(parts[1].holds && parts[1].unmet == [vec![]]);
    assert_eq!(parts[1].bindings.as_ref().unwrap().satisfied, [NodeId(5)]);
}
