//! Domains and problems use only names that they declare, and read back equal.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

mod walk;

use std::collections::{BTreeMap, BTreeSet};

use vc_graph::{Draft, Goal, NodeId, SceneBuilder, SceneGraph};
use vc_tasks::format::pddl::{
    AtomicFormula, Domain, Formula, Keep, NumericExpression, NumericLiteral, Operator, OperatorEffect, PlanningProblem,
    planning,
};

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

/// The declarations of a domain or problem: names, and predicates with their arity.
struct Declared {
    names: BTreeSet<String>,
    predicates: BTreeMap<String, usize>,
}

impl Declared {
    fn new(domain: &Domain) -> Self {
        let names = domain.constants.iter().map(|c| c.name.clone()).collect();
        let predicates = domain.predicates.iter().map(|p| (p.name.clone(), p.parameters.len())).collect();
        Self { names, predicates }
    }

    fn check(&self, atom: &AtomicFormula, bound: &[&str]) {
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

    fn changes<'f>(&self, changes: &'f [OperatorEffect], bound: &mut Vec<&'f str>) {
        for change in changes {
            match change {
                OperatorEffect::Add(atom) | OperatorEffect::Delete(atom) => self.check(atom, bound),
                OperatorEffect::ForAll(variables, changes) => {
                    bound.extend(variables.iter().map(|v| v.name.as_str()));
                    self.changes(changes, bound);
                    bound.truncate(bound.len() - variables.len());
                }
                OperatorEffect::When(condition, changes) => {
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
            let mut declared = Declared::new(&planning.domain);
            planning.domain.operators.iter().for_each(|operator| declared.operator(operator));
            for object in &planning.problem.objects {
                assert!(declared.names.insert(object.name.clone()), "{text}: {} twice", object.name);
            }
            planning.problem.initial.iter().for_each(|fact| declared.check(fact, &[]));
            declared.formula(&planning.problem.goal, &mut Vec::new());
            assert_eq!(planning.domain.to_string().parse::<Domain>().unwrap(), planning.domain, "{text}");
            assert_eq!(planning.problem.to_string().parse::<PlanningProblem>().unwrap(), planning.problem, "{text}");
        }
    }
}

fn refused<T: std::str::FromStr>(text: &str) -> String
where
    T::Err: ToString,
{
    text.parse::<T>().err().map_or_else(|| panic!("read: {text}"), |error| error.to_string())
}

/// A text that other readers refuse is not accepted with parts silently dropped.
#[test]
fn what_is_said_twice_or_too_much_is_refused() {
    let problem = |rest: &str| format!("(define (problem x) (:domain k) (:objects a b - cup t - table) {rest})");
    for (rest, why) in [
        ("(:init) (:goal (on a t) (on b t))", "`)` after a condition; `and` joins several, found `(on ...)`"),
        ("(:init) (:goal (on a t)) (:goal (on b t))", "a section `:goal` only once"),
        ("(:init) (:init) (:goal (on a t))", "a section `:init` only once"),
        ("(:init) (:goal (not (on a t) (on b t)))", "`)` after a condition"),
        ("(:init (not (on a t) (on b t))) (:goal (on a t))", "`)` after a predicate of things"),
        ("(:init (on a t) (not (on a t))) (:goal (on a t))", "not both said and denied"),
        ("(:init) (:goal (on a t)) (:objects c)", "a section `:objects` only once"),
        ("(:init (= (total-cost) few)) (:goal (on a t))", "a number, found `few`"),
        ("(:init) (:goal (on a t)) (:metric minimize (+ (total-cost) 1))", "not a sum"),
    ] {
        let error = refused::<PlanningProblem>(&problem(rest));
        assert!(error.contains(why), "{rest}: {error}");
    }
    assert!(refused::<PlanningProblem>("(define (problem x) (:domain k l) (:init) (:goal (p)))").contains("found `l`"));
    assert!(
        refused::<PlanningProblem>("(define (problem x) (:domain k) (:objects a a) (:goal (p)))").contains("only once")
    );
    for (rest, why) in [
        ("(:predicates (p ?x)) (:predicates (q ?x))", "a section `:predicates` only once"),
        ("(:types a) (:types b)", "a section `:types` only once"),
        ("(:predicates (p ?x) (p ?x ?y))", "the predicate `p` only once"),
        ("(:action a :effect (not (p) (q)))", "`)` after a predicate of things"),
        ("(:action a :precondition (not (p) (q)))", "`)` after a condition"),
        ("(:action a :effect (p) :effect (q))", "the key `:effect` only once"),
        ("(:action a :effect (p)) (:action a :effect (q))", "the action `a` only once"),
        ("(:action a :effect (decrease (total-cost) 1))", "`increase`: numbers are costs"),
        ("(:derived (q ?x) (p ?x))", "`:functions` or `:action`"),
        ("(:predicates (p ?x - (either)))", "a type"),
        ("(:functions (dist ?a) - object)", "`- number`"),
    ] {
        let error = refused::<Domain>(&format!("(define (domain k) {rest})"));
        assert!(error.contains(why), "{rest}: {error}");
    }
}

#[test]
fn either_costs_metric_and_what_is_denied_are_read() {
    let text = "(define (domain k) (:requirements :typing :action-costs) (:types a b c - (either d e) d e - object)
        (:predicates (on ?x - (either cup plate) ?t - table))
        (:functions (total-cost) - number (dist ?a ?b - place) - number)
        (:action go :parameters (?p ?q - place ?x - (either cup plate))
            :effect (and (at ?p) (increase (total-cost) 1.5) (increase (total-cost) (dist ?p ?q)))))";
    let domain: Domain = text.parse().unwrap();
    assert_eq!(domain.types[0].kind.any, ["d", "e"]);
    assert_eq!(domain.predicates[0].parameters[0].kind.to_string(), "(either cup plate)");
    let names: Vec<&str> = domain.functions.iter().map(|f| f.name.as_str()).collect();
    assert_eq!(names, ["total-cost", "dist"]);
    let cost = |by| OperatorEffect::Increase(AtomicFormula::new("total-cost", &[]), by);
    assert_eq!(domain.operators[0].effect[1], cost(NumericExpression::Number(NumericLiteral::new("1.5").unwrap())));
    assert_eq!(domain.operators[0].effect[2], cost(NumericExpression::Of(AtomicFormula::new("dist", &["?p", "?q"]))));
    assert_eq!(domain.to_string().parse::<Domain>().unwrap(), domain);

    let text = "(define (problem x) (:domain k) (:objects a b - (either cup plate) c)
        (:init (p a) (not (p b)) (= (total-cost) 0) (= (dist a b) 2.5)) (:goal (p b)) (:metric minimize (total-cost)))";
    let problem: PlanningProblem = text.parse().unwrap();
    assert_eq!((problem.initial.len(), &problem.denied[..]), (1, &[AtomicFormula::new("p", &["b"])][..]));
    assert_eq!(problem.values[1].1.value(), 2.5);
    let metric = problem.metric.clone().unwrap();
    assert_eq!((metric.maximize, metric.to_string().as_str()), (false, "(:metric minimize (total-cost))"));
    assert_eq!(problem.to_string().parse::<PlanningProblem>().unwrap(), problem);
}

/// Letters beyond ASCII are case-insensitive too, and a comment ends with its line, whatever the line
/// ending.
#[test]
fn case_and_line_ends_are_those_of_all_texts() {
    let text = |thing: &str, end: &str| {
        format!("(define (problem p) ; a comment{end}(:domain d) (:objects {thing} - t) (:init) (:goal (wet {thing})))")
    };
    let read = |text: String| text.parse::<vc_tasks::format::pddl::PlanningProblem>().unwrap();
    for end in ["\n", "\r", "\r\n"] {
        assert_eq!(read(text("BÜGELÉ", end)), read(text("bügelé", "\n")), "{end:?}");
    }
    // A letter whose lower case has another length is kept.
    assert_eq!(read(text("\u{130}X", "\n")).objects[0].name, "\u{130}x");
}
