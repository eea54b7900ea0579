//! The transition rules in PDDL.
//!
//! The conditions and effects of the rules are translated to the typed STRIPS fragment, which all
//! planners support: conditions are conjunctions of facts, and a condition that can be fulfilled in
//! several ways gives several actions for a verb. Facts that no action changes (`affords_openable`,
//! `fits`) are taken from the scene. The agent is at a spot, and every object is by one: by the
//! furniture it is on or in, by itself, or by `self` while it is held. Every object is within a
//! cover: within a container that opens, or within `air`. Being near is therefore `(by x s) (at
//! s)`, and being accessible `(within x c) (lets_in c)`.
//!
//! The domain never allows more than the rules do, except that a plan does not see a container fill
//! up. The domain allows less in these points: an object that carries another, or ever did, is not
//! moved, heated or cooled; the agent sits and lies down only from standing, and only on an object
//! that rests on something that is not carried; a container inside another one that opens receives
//! nothing; heat and cold reach an object through at most one other object.

use std::collections::BTreeSet;

use vc_graph::rule::{Argument, Condition, Effect};
use vc_graph::{Property, State, Verb, Vocabulary};

use super::{AtomicFormula, Domain, Formula, Operator, OperatorEffect, Signature, TypedName};

/// A verb that is left out, and the reason.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct LeftOut {
    /// The verb.
    pub verb: Verb,
    /// The part of the verb that PDDL cannot express.
    pub why: String,
}

/// A static fact, which no action changes, with the condition that decides it in a scene.
pub(super) type Lasting = (String, Condition<Argument>);

/// The domain of some verbs of a vocabulary, with those that are left out.
///
/// ```
/// use vc_graph::{Verb, Vocabulary, Word};
/// use vc_tasks::format::pddl;
/// let (domain, left_out) = pddl::domain(&Vocabulary::builtin(), Verb::ALL);
/// assert!(domain.operators.iter().any(|o| o.name == "put_in"));
/// assert!(left_out.iter().any(|l| l.verb == Verb::Drive));
/// assert_eq!(domain.to_string().parse::<pddl::Domain>()?, domain);
/// # Ok::<(), vc_tasks::format::ReadError>(())
/// ```
pub fn domain(words: &Vocabulary, verbs: &[Verb]) -> (Domain, Vec<LeftOut>) {
    let rules = Rules::new(words, verbs);
    (rules.domain("virtualcity"), rules.left_out)
}

/// The action schemas, the static facts they need from a scene, and the verbs left out.
pub(super) struct Rules {
    pub(super) operators: Vec<Operator>,
    pub(super) lasting: Vec<Lasting>,
    pub(super) left_out: Vec<LeftOut>,
}

/// The spot where the agent starts.
pub(super) const HERE: &str = "here";
/// The spot of held objects.
pub(super) const HANDS: &str = "self";
/// The cover and the support of objects that have no other.
pub(super) const AIR: &str = "air";
/// The fact that an object is not carried and cannot be.
pub(super) const STILL: &str = "still";
/// The fact that a machine has no switch.
pub(super) const UNSWITCHED: &str = "unswitched";

impl Rules {
    pub(super) fn new(words: &Vocabulary, verbs: &[Verb]) -> Self {
        let mut rules = Self { operators: Vec::new(), lasting: Vec::new(), left_out: Vec::new() };
        for &verb in verbs {
            match ways(words, verb) {
                Ok(ways) => {
                    for (i, way) in ways.into_iter().enumerate() {
                        for fact in &way.lasting {
                            if rules.lasting.iter().all(|(known, _)| *known != fact.0) {
                                rules.lasting.push(fact.clone());
                            }
                        }
                        let name = if i == 0 { verb.to_string() } else { format!("{verb}-{}", i + 1) };
                        rules.operators.push(way.operator(verb, name));
                    }
                }
                Err(why) => rules.left_out.push(LeftOut { verb, why }),
            }
        }
        rules.lasting.retain(|(name, _)| rules.operators.iter().any(|o| mentions(o, name)));
        rules
    }

    /// The domain of the action schemas.
    pub(super) fn domain(&self, name: &str) -> Domain {
        let mut predicates = BTreeSet::new();
        for operator in &self.operators {
            atoms(operator).for_each(|atom| {
                predicates.insert((atom.predicate.clone(), atom.arguments.iter().map(|a| kind(a)).collect::<Vec<_>>()));
            });
        }
        let signature = |(name, kinds): (String, Vec<&'static str>)| {
            let parameters = kinds.iter().zip(["?x", "?y"]).map(|(kind, name)| TypedName::new(name, *kind));
            Signature { name, parameters: parameters.collect() }
        };
        Domain {
            name: name.to_owned(),
            requirements: vec![":strips".to_owned(), ":typing".to_owned()],
            types: vec![TypedName::new("thing", "object"), TypedName::new("hand", "object")],
            constants: vec![
                TypedName::new(HERE, "thing"),
                TypedName::new(HANDS, "thing"),
                TypedName::new(AIR, "thing"),
                TypedName::new("right", "hand"),
                TypedName::new("left", "hand"),
            ],
            predicates: predicates.into_iter().map(signature).collect(),
            functions: Vec::new(),
            operators: self.operators.clone(),
        }
    }
}

/// The type of a name: variables of hands begin with `?h`.
pub(super) fn kind(name: &str) -> &'static str {
    if name.starts_with("?h") || ["right", "left"].contains(&name) { "hand" } else { "thing" }
}

fn mentions(operator: &Operator, predicate: &str) -> bool {
    atoms(operator).any(|a| a.predicate == predicate)
}

/// All atoms of an action schema in the STRIPS fragment.
pub(super) fn atoms(operator: &Operator) -> impl Iterator<Item = &AtomicFormula> {
    let needs = match &operator.precondition {
        Formula::And(parts) => parts.as_slice(),
        other => std::slice::from_ref(other),
    };
    let needs = needs.iter().filter_map(|f| if let Formula::Atom(atom) = f { Some(atom) } else { None });
    needs.chain(operator.effect.iter().filter_map(|c| match c {
        OperatorEffect::Add(atom) | OperatorEffect::Delete(atom) => Some(atom),
        _ => None,
    }))
}

/// One variant of an action.
#[derive(Clone, Default)]
struct Way {
    needs: Vec<AtomicFormula>,
    does: Vec<OperatorEffect>,
    lasting: Vec<Lasting>,
}

/// All variants of an action.
fn ways(words: &Vocabulary, verb: Verb) -> Result<Vec<Way>, String> {
    let rule = words.rule(verb).ok_or("it is no verb of the scene")?;
    let mut all = vec![Way::default()];
    for need in &*rule.preconditions {
        let choices = condition(*need, verb)?;
        all = all.iter().flat_map(|way| choices.iter().map(|choice| way.with(choice))).collect();
    }
    for way in &mut all {
        for does in &*rule.effects {
            way.effect(words, *does)?;
        }
        let things = [Argument::X, Argument::Y].into_iter().take(rule.arity).map(variable);
        let did = AtomicFormula::new(format!("did_{verb}"), &things.collect::<Vec<_>>());
        way.does.push(OperatorEffect::Add(did));
    }
    Ok(all)
}

fn variable(role: Argument) -> &'static str {
    match role {
        Argument::X => "?x",
        Argument::Y => "?y",
    }
}

/// The variables for an object's spot and for its cover.
fn spot(role: Argument) -> (&'static str, &'static str) {
    match role {
        Argument::X => ("?sx", "?cx"),
        Argument::Y => ("?sy", "?cy"),
    }
}

fn lasting(name: impl Into<String>, condition: Condition<Argument>, role: Argument) -> Way {
    let name = name.into();
    let needs = vec![AtomicFormula::new(&*name, &[variable(role)])];
    // The condition is about one object, whichever role it has here.
    Way { needs, lasting: vec![(name, condition)], ..Way::default() }
}

fn affords(property: Property, role: Argument) -> Way {
    lasting(format!("affords_{property}"), Condition::Affords(Argument::X, property), role)
}

fn facts(needs: &[(&str, &[&str])]) -> Way {
    let needs = needs.iter().map(|(predicate, things)| AtomicFormula::new(*predicate, things)).collect();
    Way { needs, ..Way::default() }
}

/// The predicates for a state and for its absence.
pub(super) fn is(state: State) -> String {
    format!("is_{state}")
}

pub(super) fn is_not(state: State) -> String {
    format!("not_{state}")
}

/// The ways in which a condition is fulfilled.
fn condition(needed: Condition<Argument>, verb: Verb) -> Result<Vec<Way>, String> {
    use Condition as C;
    let x = Argument::X;
    Ok(vec![match needed {
        C::Affords(t, property) => affords(property, t),
        C::Reachable(t) => lasting("spot", C::Reachable(x), t),
        C::Tangible(t) => lasting("tangible", C::Tangible(x), t),
        C::Graspable(t) => lasting("graspable", C::Graspable(x), t),
        C::Carries(t) => lasting("carries", C::Carries(x), t),
        C::Encloses(t) => lasting("encloses", C::Encloses(x), t),
        C::Potable(t) => lasting("potable", C::Potable(x), t),
        C::Receives(t) => lasting("receives", C::Receives(x), t),
        C::Cuttable(t) => lasting("cuttable", C::Cuttable(x), t),
        C::Mobile(t) => lasting("mobile", C::Mobile(x), t),
        C::Soft(t) => lasting("soft", C::Soft(x), t),
        C::Typable(t) => lasting("typable", C::Typable(x), t),
        C::Personal(t) => lasting("personal", C::Personal(x), t),
        C::Other(t) => lasting("other", C::Other(x), t),
        C::NotElsewhereHeld(t) => lasting("loose", C::NotElsewhereHeld(x), t),
        C::SeatFree(t) => lasting("seat_free", C::SeatFree(x), t),
        C::BedFree(t) => lasting("bed_free", C::BedFree(x), t),
        // Objects on a plate can be removed: only the object itself counts.
        C::Edible(t) => affords(Property::Eatable, t),
        C::Fits(a, b) => {
            let needs = vec![AtomicFormula::new("fits", &[variable(a), variable(b)])];
            Way { needs, lasting: vec![("fits".to_owned(), C::Fits(Argument::X, Argument::Y))], ..Way::default() }
        }
        C::In(t, state) => facts(&[(&is(state), &[variable(t)])]),
        C::NotIn(t, state) => facts(&[(&is_not(state), &[variable(t)])]),
        C::Near(t) => facts(&[("by", &[variable(t), spot(t).0]), ("at", &[spot(t).0])]),
        C::Accessible(t) => facts(&[("within", &[variable(t), spot(t).1]), ("lets_in", &[spot(t).1])]),
        C::FreeHand => facts(&[("free_hand", &["?h"])]),
        C::Holding(t) => facts(&[("held", &[variable(t), "?h"])]),
        C::HoldingSomething => facts(&[("held", &["?k", "?hk"])]),
        C::HoldingKind(property) => {
            let mut tool = lasting(format!("affords_{property}"), C::Affords(x, property), x);
            tool.needs = vec![
                AtomicFormula::new("held", &["?k", "?hk"]),
                AtomicFormula::new(format!("affords_{property}"), &["?k"]),
            ];
            tool
        }
        C::Upright | C::NotSitting | C::NotLying => facts(&[("upright", &[])]),
        C::Worn(t) => facts(&[("worn", &[variable(t)])]),
        C::FreeHandOrHolding(_) if verb == Verb::Grab => facts(&[("free_hand", &["?h"])]),
        C::FreeHandOrHolding(t) => {
            return Ok(vec![facts(&[("free_hand", &["?h"])]), facts(&[("held", &[variable(t), "?h"])])]);
        }
        C::AtRest => return Ok(vec![facts(&[("sitting_on", &["?k"])]), facts(&[("lying_on", &["?k"])])]),
        C::Accepts(t) => {
            let shut = lasting("closes_over", C::Affords(x, Property::Openable), t);
            let plain = lasting("always_open", C::Accepts(x), t);
            return Ok(vec![shut.with(&facts(&[("lets_in", &[variable(t)]), ("within", &[variable(t), AIR])])), plain]);
        }
        C::SafeToOpen(t) => {
            let off = facts(&[(&is_not(State::On), &[variable(t)])]);
            return Ok(vec![off, affords(Property::Cooler, t), affords(Property::Heater, t)]);
        }
        C::OnHeat(t) => return Ok(on_heat(variable(t))),
        C::InCold(t) => return Ok(in_cold(variable(t))),
        // A held object rests on nothing, and the support of another object may itself be held.
        C::Steady(t) => {
            let mut steady = facts(&[("rests", &[variable(t), "?r"]), (STILL, &["?r"])]);
            steady.lasting = vec![(STILL.to_owned(), C::Steady(x))];
            steady
        }
        other => return Err(format!("the condition {other:?}")),
    }])
}

/// On or in a heater that is on.
fn on_heat(x: &str) -> Vec<Way> {
    let hot = Way { needs: vec![AtomicFormula::new(is(State::On), &["?k"])], ..Way::default() };
    at_machine(Property::Heater, x, &["on", "in"], &hot)
}

/// In a cooler that is on, or that has no switch.
fn in_cold(x: &str) -> Vec<Way> {
    let on = Way { needs: vec![AtomicFormula::new(is(State::On), &["?k"])], ..Way::default() };
    let lasting = vec![(UNSWITCHED.to_owned(), Condition::Affords(Argument::X, Property::Cooler))];
    let always = Way { needs: vec![AtomicFormula::new(UNSWITCHED, &["?k"])], lasting, ..Way::default() };
    [on, always].iter().flat_map(|cold| at_machine(Property::Cooler, x, &["in"], cold)).collect()
}

/// At a working machine of a kind: directly, or on or in an object that is at it.
fn at_machine(kind: Property, x: &str, how: &[&str], works: &Way) -> Vec<Way> {
    let affords = format!("affords_{kind}");
    let machine = Way {
        needs: vec![AtomicFormula::new(&*affords, &["?k"])],
        lasting: vec![(affords, Condition::Affords(Argument::X, kind))],
        ..Way::default()
    };
    let at = |needs: Vec<AtomicFormula>| Way { needs, ..Way::default() }.with(&machine).with(works);
    let direct = how.iter().map(|how| at(vec![AtomicFormula::new(*how, &[x, "?k"])]));
    let carried = |on, how| at(vec![AtomicFormula::new(on, &[x, "?p"]), AtomicFormula::new(how, &["?p", "?k"])]);
    direct
        .chain(
            ["on", "in"]
                .into_iter()
                .flat_map(|on| how.iter().map(move |how| (on, *how)))
                .map(|(on, how)| carried(on, how)),
        )
        .collect()
}

impl Way {
    fn with(&self, more: &Self) -> Self {
        let mut both = self.clone();
        more.needs.iter().for_each(|atom| both.need(atom.clone()));
        both.lasting.extend(more.lasting.iter().cloned());
        both
    }

    fn need(&mut self, atom: AtomicFormula) {
        if !self.needs.contains(&atom) {
            self.needs.push(atom);
        }
    }

    fn needs(&self, predicate: &str) -> bool {
        self.needs.iter().any(|a| a.predicate == predicate)
    }

    fn add(&mut self, predicate: impl Into<String>, things: &[&str]) {
        self.does.push(OperatorEffect::Add(AtomicFormula::new(predicate, things)));
    }

    fn delete(&mut self, predicate: impl Into<String>, things: &[&str]) {
        self.does.push(OperatorEffect::Delete(AtomicFormula::new(predicate, things)));
    }

    fn effect(&mut self, words: &Vocabulary, effect: Effect<Argument>) -> Result<(), String> {
        match effect {
            Effect::Enter(t, state) => self.enter(words, variable(t), state),
            // Objects on or in it would enter the state as well.
            Effect::EnterWith(t, state) => {
                self.need(AtomicFormula::new("free", &[variable(t)]));
                self.enter(words, variable(t), state);
            }
            Effect::Leave(t, state) => {
                self.settle(is_not(state), is(state), variable(t));
                if state == State::Closed {
                    self.last(OperatorEffect::Add, "lets_in", variable(t));
                }
            }
            Effect::EnterOwn(state) => self.last(OperatorEffect::Add, is(state), HANDS),
            Effect::LeaveOwn(state) => self.last(OperatorEffect::Delete, is(state), HANDS),
            Effect::GoTo(t) => {
                self.need(AtomicFormula::new("at", &["?from"]));
                self.need(AtomicFormula::new("leaves", &["?from"]));
                self.delete("at", &["?from"]);
                self.add("at", &[variable(t)]);
            }
            Effect::Hold(t) => self.hold(variable(t)),
            Effect::PutOn(t, on) => self.put("on", variable(t), variable(on), spot(on).1),
            Effect::PutInto(t, into) => {
                let cover = if self.needs("closes_over") { variable(into) } else { spot(into).1 };
                self.put("in", variable(t), variable(into), cover);
            }
            Effect::SitOn(t) => self.rest("sitting_on", variable(t)),
            Effect::LieOn(t) => self.rest("lying_on", variable(t)),
            Effect::StandUp => {
                self.add("upright", &[]);
                self.delete("sitting_on", &["?k"]);
                self.delete("lying_on", &["?k"]);
                self.add("vacant", &["?k"]);
                self.delete(is(State::Asleep), &[HANDS]);
            }
            Effect::FillWithWater(t) => self.enter(words, variable(t), State::Filled),
            Effect::PutOnBody(t) => {
                self.delete("held", &[variable(t), "?h"]);
                self.add("free_hand", &["?h"]);
                self.add("worn", &[variable(t)]);
            }
            other => return Err(format!("the effect {other:?}")),
        }
        Ok(())
    }

    fn enter(&mut self, words: &Vocabulary, thing: &str, state: State) {
        for opposite in words.opposites(state).iter() {
            self.settle(is_not(opposite), is(opposite), thing);
        }
        self.settle(is(state), is_not(state), thing);
        match state {
            State::Open => self.last(OperatorEffect::Add, "lets_in", thing),
            State::Closed => self.last(OperatorEffect::Delete, "lets_in", thing),
            _ => {}
        }
    }

    /// One fact comes true of a thing and its negation false, whatever earlier effects of the action have said.
    fn settle(&mut self, holds: String, fails: String, thing: &str) {
        self.last(OperatorEffect::Delete, fails, thing);
        self.last(OperatorEffect::Add, holds, thing);
    }

    /// A fact about a thing comes true or false, whatever earlier effects of the action have said of it.
    fn last(&mut self, change: fn(AtomicFormula) -> OperatorEffect, predicate: impl Into<String>, thing: &str) {
        let fact = AtomicFormula::new(predicate, &[thing]);
        self.does.retain(|effect| match effect {
            OperatorEffect::Add(atom) | OperatorEffect::Delete(atom) => *atom != fact,
            _ => true,
        });
        self.does.push(change(fact));
    }

    /// Into the hand, from its support or from the body.
    fn hold(&mut self, x: &str) {
        self.add("held", &[x, "?h"]);
        self.delete("free_hand", &["?h"]);
        if self.needs("worn") {
            return self.delete("worn", &[x]);
        }
        self.need(AtomicFormula::new("free", &[x]));
        self.need(AtomicFormula::new("vacant", &[x]));
        self.need(AtomicFormula::new("rests", &[x, "?r"]));
        for (predicate, was) in [("rests", "?r"), ("on", "?r"), ("in", "?r"), ("by", "?sx"), ("within", "?cx")] {
            self.delete(predicate, &[x, was]);
        }
        self.add("by", &[x, HANDS]);
        self.add("within", &[x, AIR]);
    }

    /// From the hand onto or into another object.
    fn put(&mut self, how: &str, x: &str, y: &str, cover: &str) {
        self.need(AtomicFormula::new("free", &[x]));
        self.delete("held", &[x, "?h"]);
        self.add("free_hand", &["?h"]);
        self.delete("by", &[x, HANDS]);
        self.delete("within", &[x, AIR]);
        self.delete("free", &[y]);
        for (predicate, now) in [("rests", y), (how, y), ("by", "?sy"), ("within", cover)] {
            self.add(predicate, &[x, now]);
        }
    }

    fn rest(&mut self, how: &str, x: &str) {
        self.delete("upright", &[]);
        self.delete("vacant", &[x]);
        self.add(how, &[x]);
    }

    fn operator(&self, verb: Verb, name: String) -> Operator {
        let mut names: Vec<&str> = ["?x", "?y"].into_iter().take(verb.arity()).collect();
        let changed = self.does.iter().filter_map(|c| match c {
            OperatorEffect::Add(atom) | OperatorEffect::Delete(atom) => Some(atom),
            _ => None,
        });
        for argument in self.needs.iter().chain(changed).flat_map(|a| &a.arguments) {
            if argument.starts_with('?') && !names.contains(&argument.as_str()) {
                names.push(argument);
            }
        }
        Operator {
            name,
            parameters: names.into_iter().map(|n| TypedName::new(n, kind(n))).collect(),
            precondition: Formula::And(self.needs.iter().cloned().map(Formula::Atom).collect()),
            effect: self.does.clone(),
        }
    }
}
