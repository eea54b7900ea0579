//! Domains and problems say nothing that they do not declare, and read back.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use std::collections::{BTreeMap, BTreeSet};

use vc_graph::{Draft, Goal, NodeId, SceneBuilder, SceneGraph};
use vc_tasks::format::pddl::{Atom, Change, Domain, Formula, Keep, Operator, Problem, planning};

fn home() -> (SceneGraph, NodeId) {
    let mut scene = SceneBuilder::new("home");
    let kitchen = scene.add(Draft::new("kitchen")).unwrap();
    let table = scene.add_in(kitchen, Draft::new("kitchen_table")).unwrap();
    for class in ["apple", "apple", "cup"] {
        scene.add_on(table, Draft::new(class)).unwrap();
    }
    for class in ["fridge", "stove", "sofa"] {
        scene.add_in(kitchen, Draft::new(class)).unwrap();
    }
    let me = scene.add_in(kitchen, Draft::new("character")).unwrap();
    (scene.build(), me)
}

/// What a domain or problem declares: names, and predicates with their arity.
struct Declared {
    names: BTreeSet<String>,
    predicates: BTreeMap<String, usize>,
}

impl Declared {
    fn of(domain: &Domain) -> Self {
        let names = domain.constants.iter().map(|c| c.name.clone()).collect();
        let predicates = domain.predicates.iter().map(|p| (p.name.clone(), p.parameters.len())).collect();
        Self { names, predicates }
    }

    fn check(&self, atom: &Atom, bound: &[&str]) {
        assert_eq!(self.predicates.get(&atom.predicate), Some(&atom.arguments.len()), "{atom}");
        for argument in &atom.arguments {
            assert!(self.names.contains(argument) || bound.contains(&argument.as_str()), "{argument} in {atom}");
        }
    }

    fn formula<'f>(&self, formula: &'f Formula, bound: &mut Vec<&'f str>) {
        match formula {
            Formula::Atom(atom) => self.check(atom, bound),
            Formula::And(parts) | Formula::Or(parts) => parts.iter().for_each(|part| self.formula(part, bound)),
            Formula::Not(part) => self.formula(part, bound),
            Formula::Imply(a, b) => [a, b].into_iter().for_each(|part| self.formula(part, bound)),
            Formula::ForAll(variables, body) | Formula::Exists(variables, body) => {
                bound.extend(variables.iter().map(|v| v.name.as_str()));
                self.formula(body, bound);
                bound.truncate(bound.len() - variables.len());
            }
            Formula::Equal(..) => {}
            other => panic!("{other} is not looked at"),
        }
    }

    fn changes<'f>(&self, changes: &'f [Change], bound: &mut Vec<&'f str>) {
        for change in changes {
            match change {
                Change::Add(atom) | Change::Delete(atom) => self.check(atom, bound),
                Change::ForAll(variables, changes) => {
                    bound.extend(variables.iter().map(|v| v.name.as_str()));
                    self.changes(changes, bound);
                    bound.truncate(bound.len() - variables.len());
                }
                Change::When(condition, changes) => {
                    self.formula(condition, bound);
                    self.changes(changes, bound);
                }
                other => panic!("{other} is not looked at"),
            }
        }
    }

    fn operator(&self, operator: &Operator) {
        let mut bound: Vec<&str> = operator.parameters.iter().map(|p| p.name.as_str()).collect();
        self.formula(&operator.precondition, &mut bound);
        self.changes(&operator.effect, &mut bound);
    }
}

#[test]
fn what_a_problem_speaks_of_is_declared_once() {
    let (graph, me) = home();
    for text in [
        "Open(fridge)",
        "On(apple, kitchen_table), 2",
        "SwitchedOn(stove) & !Open(fridge)",
        "forall ?a: apple. On(?a, kitchen_table)",
        "exists ?a: apple. (Inside(?a, fridge) | Holds(me, ?a))",
        "Near(me, stove) & On(apple.3, sofa)",
        "did open(fridge) | Sit(sofa)",
    ] {
        let goal: Goal = text.parse().unwrap();
        for keep in [Keep::Relevant, Keep::Everything] {
            let planning = planning(&graph, me, &goal, keep).unwrap();
            let mut declared = Declared::of(&planning.domain);
            planning.domain.operators.iter().for_each(|operator| declared.operator(operator));
            for object in &planning.problem.objects {
                assert!(declared.names.insert(object.name.clone()), "{text}: {} twice", object.name);
            }
            planning.problem.initial.iter().for_each(|fact| declared.check(fact, &[]));
            declared.formula(&planning.problem.goal, &mut Vec::new());
            assert_eq!(planning.domain.to_string().parse::<Domain>().unwrap(), planning.domain, "{text}");
            assert_eq!(planning.problem.to_string().parse::<Problem>().unwrap(), planning.problem, "{text}");
        }
    }
}
