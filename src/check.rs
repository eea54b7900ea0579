//! The contract that every environment keeps, as a test that anybody can run.

use vc_graph::clock::Span;
use vc_graph::{Action, Label, NodeId, NodeKind, SceneGraph, Seed, Stream, Verb, Violation, rule};

use crate::Batch;
use crate::environment::{ActionError, Attempt, Disagreement, Environment, MakeError, SaveError};
#[cfg(feature = "render")]
use crate::{PictureError, Viewpoint, render::Modality};

/// Number of actions that are also shown in time.
const SHOWN: usize = 4;
/// The shortest time after which an action in time is looked at, and how often a long one is.
const EVERY: Span = Span(7);
const LOOKS: u64 = 50;
/// The time in which agents act side by side, and the parts into which it is divided.
const LONG: Span = Span(3600);
const PART: Span = Span(11);

/// Number of environments in the batch.
const BATCH: usize = 3;
/// Size of the pictures in pixels, width and height.
#[cfg(feature = "render")]
const PICTURE: (u32, u32) = (64, 48);

/// A violation of the contract of an environment.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ContractViolation {
    /// Two environments that were made alike differ.
    #[error("two environments that were made alike differ before any action")]
    MadeDifferently,
    /// The same actions lead to different states.
    #[error("after {actions} equal actions two equal environments differ")]
    RunDifferently {
        /// The number of actions after which they differ.
        actions: usize,
    },
    /// An observation changed the environment.
    #[error("an observation changed the environment, after {actions} actions")]
    ImpureObservation {
        /// The number of actions done before the observation.
        actions: usize,
    },
    /// An action that the transition rule refused changed something.
    #[error("`{attempt}` was refused ({error}) and changed the environment")]
    RefusedAndChanged {
        /// The refused action.
        attempt: Attempt,
        /// The refusal.
        error: ActionError,
    },
    /// The environment did an action that the transition rule refuses.
    #[error("`{0}` was done although the transition rule refuses it")]
    DoneThoughRefused(Attempt),
    /// The result depends on the order in which actions are listed.
    #[error("the order in which agents' actions are listed matters")]
    OrderMatters,
    /// An action that is shown in time ends differently from the same action done at once.
    #[error("`{0}` ends differently in time than at once")]
    ClocksDiffer(Attempt),
    /// Agents that act side by side end differently if time is divided otherwise.
    #[error("side by side, actions end differently when time is divided otherwise")]
    DivisionMatters,
    /// Agents that act side by side end differently if they are saved in between.
    #[error("side by side, actions end differently when they are saved in between")]
    SavingMatters,
    /// Rendering changed the environment, or two pictures of the same moment differ.
    #[error("rendering changed the environment, or two pictures of the same moment differ")]
    ImpureRender,
    /// The environment cannot be rendered.
    #[cfg(feature = "render")]
    #[error("it cannot be rendered: {0}")]
    NotRendered(PictureError),
    /// An environment in a batch evolves differently from the same environment alone.
    #[error("in a batch the environment evolves differently than alone")]
    BatchDiffers,
    /// A saved and restored environment evolves differently from the original.
    #[error("a restored environment differs after {actions} more actions")]
    RestoredDiffers {
        /// The number of actions after which they differ.
        actions: usize,
    },
    /// The environment could not be saved or restored.
    #[error("it cannot be saved and restored: {0}")]
    NotSaved(SaveError),
    /// The graph violates an invariant.
    #[error("after `{attempt}`: {violation}")]
    Invariant {
        /// The action after which the invariant is violated.
        attempt: Attempt,
        /// The violation.
        violation: Violation,
    },
    /// The pose of a thing is not finite.
    #[error("after `{attempt}` the pose of {thing} is not finite")]
    NotFinite {
        /// The action after which this happened.
        attempt: Attempt,
        /// The thing.
        thing: Label,
    },
    /// A thing is outside the home.
    #[error("after `{attempt}` {thing} is outside the home")]
    Outside {
        /// The action after which this happened.
        attempt: Attempt,
        /// The thing.
        thing: Label,
    },
    /// A thing was stopped.
    #[error("after `{attempt}` {thing} was stopped: it became non-finite, or fell below everything")]
    Stopped {
        /// The action after which this happened.
        attempt: Attempt,
        /// The thing.
        thing: Label,
    },
    /// A reset to the environment's own initial scene leads to a different state.
    #[error("a reset to the initial scene does not lead back to it")]
    ResetDiffers,
}

/// The result of a run of random actions.
#[derive(Debug, Default)]
pub struct Tally {
    /// Number of actions that were done.
    pub done: usize,
    /// Number of actions that the transition rule refused.
    pub refused: usize,
    /// The errors of the actions that the bodies could not do.
    pub impossible: Vec<ActionError>,
    /// The disagreements between bodies and rule.
    pub disagreements: Vec<Disagreement>,
    /// The breaches found.
    pub breaches: Vec<ContractViolation>,
}

impl Tally {
    /// Whether another run went the same way.
    fn is_like(&self, other: &Self) -> bool {
        (self.done, self.refused, self.breaches.len()) == (other.done, other.refused, other.breaches.len())
            && self.impossible == other.impossible
            && self.disagreements == other.disagreements
    }
}

/// Checks the contract of an environment, as Gymnasium's checker does, and returns every breach; a sound
/// environment has none. The contract: the same seed gives the same bytes; observing and rendering change
/// nothing; a refused action changes nothing; the result depends neither on the order of a list of
/// actions, nor on how time is divided, nor on whether actions are shown, nor on whether the environment is one of a
/// batch; an environment that was saved and restored, even in the middle of actions, evolves as the original does; a
/// reset leads back to the beginning.
///
/// `make` makes the environment; it is called twice and has to give equal environments. `actions` random actions
/// are tried.
///
/// # Errors
/// [`MakeError`] if the environment cannot be made.
///
/// ```no_run
/// use virtualcity::{Environment, check_environment};
/// use virtualcity::graph::Seed;
/// let breaches = check_environment(|| Environment::make("apartment/42", 2), 40, Seed(1))?;
/// assert!(breaches.is_empty(), "{breaches:?}");
/// # Ok::<(), virtualcity::MakeError>(())
/// ```
pub fn check_environment(
    make: impl Fn() -> Result<Environment, MakeError>,
    actions: usize,
    seed: Seed,
) -> Result<Vec<ContractViolation>, MakeError> {
    let (mut one, mut other) = (make()?, make()?);
    if one.digest() != other.digest() {
        return Ok(vec![ContractViolation::MadeDifferently]);
    }
    let mut breaches = Vec::new();
    check_order(&one, seed, &mut breaches);
    check_clocks(&one, seed.child("clocks"), &mut breaches);
    check_time(&one, seed.child("time"), &mut breaches);
    check_batch(&one, seed.child("batch"), &mut breaches);
    #[cfg(feature = "render")]
    check_render(&one, &mut breaches);
    let first = run(&mut one, actions / 2, seed.child("first"));
    let again = run(&mut other, actions / 2, seed.child("first"));
    if one.digest() != other.digest() || !first.is_like(&again) {
        breaches.push(ContractViolation::RunDifferently { actions: actions / 2 });
    }
    breaches.extend(first.breaches);
    check_saving(&mut one, actions - actions / 2, seed.child("second"), &mut breaches);
    check_reset(&mut one, &mut breaches);
    Ok(breaches)
}

/// Lets an agent do a few legal actions, once at once and once in time, and compares the results.
fn check_clocks(environment: &Environment, seed: Seed, breaches: &mut Vec<ContractViolation>) {
    let (mut at_once, mut in_time, mut stream) = (environment.clone(), environment.clone(), seed.stream());
    for _ in 0..SHOWN {
        let Some(&agent) = stream.pick(environment.agents()) else { return };
        let action = legal_action(at_once.graph(), agent, &mut stream);
        let every = EVERY.max(Span(at_once.duration(&action).unwrap_or_default().0 / LOOKS));
        let outcome = at_once.set_action(agent, action);
        if in_time.set_action_in_time(agent, action, every, |_| {}) != outcome || at_once.digest() != in_time.digest() {
            breaches.push(ContractViolation::ClocksDiffer(Attempt::new(&action, environment.graph())));
            return;
        }
    }
}

/// Lets each agent begin a legal action; then time passes at once, in small steps, and after saving and restoring.
fn check_time(environment: &Environment, seed: Seed, breaches: &mut Vec<ContractViolation>) {
    let (mut begun, mut stream) = (environment.clone(), seed.stream());
    for &agent in environment.agents() {
        begun.give(agent, legal_action(environment.graph(), agent, &mut stream));
    }
    // Endings that nobody has read would not be saved.
    drop(begun.step(Span(1 + stream.below(90) as u64)));
    let mut whole = begun.clone();
    let endings = whole.step(LONG);
    let mut parts = begun.clone();
    let mut told = Vec::new();
    while parts.tick() < whole.tick() {
        told.extend(parts.step(PART.min(whole.tick() - parts.tick())));
    }
    if told != endings || parts.digest() != whole.digest() {
        breaches.push(ContractViolation::DivisionMatters);
    }
    let mut restored = match begun.save().and_then(|bytes| begun.restore(&bytes)) {
        Ok(restored) => restored,
        Err(error) => return breaches.push(ContractViolation::NotSaved(error)),
    };
    if restored.step(LONG) != endings || restored.digest() != whole.digest() {
        breaches.push(ContractViolation::SavingMatters);
    }
}

/// Lets each agent act, alone and in a batch, and compares the results.
fn check_batch(environment: &Environment, seed: Seed, breaches: &mut Vec<ContractViolation>) {
    let mut stream = seed.stream();
    let act = |agent: &NodeId| (*agent, legal_action(environment.graph(), *agent, &mut stream));
    let actions: Vec<(NodeId, Action)> = environment.agents().iter().map(act).collect();
    let mut alone = environment.clone();
    let mut batch = Batch::new(vec![environment.clone(); BATCH]);
    let outcomes = alone.set_actions(&actions);
    let together = batch.set_actions(&vec![actions; BATCH]);
    let same = batch.environments().iter().all(|e| e.digest() == alone.digest());
    if !same || together.iter().any(|own| *own != outcomes) {
        breaches.push(ContractViolation::BatchDiffers);
    }
}

/// Renders the view of each agent twice.
#[cfg(feature = "render")]
fn check_render(environment: &Environment, breaches: &mut Vec<ContractViolation>) {
    let before = environment.digest();
    for &agent in environment.agents() {
        let look = || {
            let all = Modality::Rgb | Modality::Depth | Modality::Instance;
            environment.render(Viewpoint::Agent(agent), all, PICTURE.0, PICTURE.1)
        };
        match (look(), look()) {
            (Ok(one), Ok(other)) => {
                let bits = |depth: &[f32]| depth.iter().map(|d| d.to_bits()).collect::<Vec<u32>>();
                let alike = one.rgb == other.rgb && one.instance == other.instance;
                if !alike || bits(&one.depth) != bits(&other.depth) || environment.digest() != before {
                    breaches.push(ContractViolation::ImpureRender);
                }
            }
            (Err(error), _) | (_, Err(error)) => breaches.push(ContractViolation::NotRendered(error)),
        }
    }
}

/// Lets random agents do random actions, half of them legal, and checks after each action whether the
/// environment is sound.
pub fn run(environment: &mut Environment, actions: usize, seed: Seed) -> Tally {
    let mut stream = seed.stream();
    let mut tally = Tally::default();
    for _ in 0..actions {
        let Some(&agent) = stream.pick(environment.agents()) else { break };
        let action = random_action(environment.graph(), agent, &mut stream);
        try_action(environment, agent, action, &mut tally);
    }
    tally
}

fn try_action(environment: &mut Environment, agent: NodeId, action: Action, tally: &mut Tally) {
    let before = environment.digest();
    let attempt = Attempt::new(&action, environment.graph());
    let refused = !rule::refusals(environment.graph(), agent, &action).is_empty();
    let outcome = environment.set_action(agent, action);
    let after = environment.digest();
    match outcome {
        Ok(_) if refused => tally.breaches.push(ContractViolation::DoneThoughRefused(attempt.clone())),
        Ok(_) => tally.done += 1,
        Err(error @ (ActionError::Refused(_) | ActionError::Twice(_))) if before != after => {
            tally.breaches.push(ContractViolation::RefusedAndChanged { attempt: attempt.clone(), error });
        }
        Err(ActionError::Disagreement(why)) => tally.disagreements.push(*why),
        Err(ActionError::Refused(_)) => tally.refused += 1,
        Err(other) => tally.impossible.push(other),
    }
    let _ = (environment.observation(agent, 3.0), environment.room_observation(agent));
    if environment.digest() != after {
        tally.breaches.push(ContractViolation::ImpureObservation { actions: environment.history().events().len() });
    }
    tally.breaches.extend(unsound(environment, &attempt));
}

/// The breaches that an environment shows after an action.
fn unsound(environment: &Environment, attempt: &Attempt) -> Vec<ContractViolation> {
    let (graph, world, known) = (environment.graph(), environment.world(), environment.start().validate());
    let attempt = || attempt.clone();
    // A falling object comes to rest on whatever is there: a pillow on a duvet, a sock on a pencil.
    let fallen = |v: &Violation| matches!(v, Violation::NotASurface(..));
    let violations = graph.validate().into_iter().filter(|v| !known.contains(v) && !fallen(v));
    let broken = violations.map(|violation| ContractViolation::Invariant { attempt: attempt(), violation });
    let wild = |n: &&vc_graph::Node| n.pose().is_some_and(|p| !p.translation.vector.iter().all(|v| v.is_finite()));
    let not_finite = graph.nodes().filter(wild).map(|n| n.id());
    let not_finite = not_finite.map(|id| ContractViolation::NotFinite { attempt: attempt(), thing: graph.label(id) });
    let outside = world.outside().into_iter();
    let outside = outside.map(|id| ContractViolation::Outside { attempt: attempt(), thing: graph.label(id) });
    let stopped = world.stopped().iter();
    let stopped = stopped.map(|id| ContractViolation::Stopped { attempt: attempt(), thing: graph.label(*id) });
    broken.chain(not_finite).chain(outside).chain(stopped).collect()
}

fn check_order(environment: &Environment, seed: Seed, breaches: &mut Vec<ContractViolation>) {
    let mut stream = seed.child("order").stream();
    let act = |agent: &NodeId| (*agent, legal_action(environment.graph(), *agent, &mut stream));
    let mut actions: Vec<(NodeId, Action)> = environment.agents().iter().map(act).collect();
    let (mut one, mut other) = (environment.clone(), environment.clone());
    one.set_actions(&actions);
    actions.reverse();
    other.set_actions(&actions);
    if one.digest() != other.digest() {
        breaches.push(ContractViolation::OrderMatters);
    }
}

fn check_saving(environment: &mut Environment, actions: usize, seed: Seed, breaches: &mut Vec<ContractViolation>) {
    let restored = environment.save().and_then(|bytes| environment.restore(&bytes));
    let mut restored = match restored {
        Ok(restored) => restored,
        Err(error) => return breaches.push(ContractViolation::NotSaved(error)),
    };
    let own = run(environment, actions, seed);
    let theirs = run(&mut restored, actions, seed);
    if environment.digest() != restored.digest() || !own.is_like(&theirs) {
        breaches.push(ContractViolation::RestoredDiffers { actions });
    }
    breaches.extend(own.breaches);
}

fn check_reset(environment: &mut Environment, breaches: &mut Vec<ContractViolation>) {
    let start = environment.start().clone();
    let report = environment.reset(&start);
    if report.is_err() || environment.graph() != &start {
        breaches.push(ContractViolation::ResetDiffers);
    }
}

/// A random action, legal in about half of the cases.
pub fn random_action(graph: &SceneGraph, agent: NodeId, stream: &mut Stream) -> Action {
    if stream.chance(0.5) { legal_action(graph, agent, stream) } else { any_action(graph, agent, stream) }
}

/// A random action that the rule allows, or a dance if none is found.
pub fn legal_action(graph: &SceneGraph, agent: NodeId, stream: &mut Stream) -> Action {
    let tries = (0..60).map(|_| any_action(graph, agent, stream));
    let legal = |action: &Action| rule::allows(graph, agent, action);
    tries.into_iter().find(legal).unwrap_or(Action::zero(Verb::Dance))
}

/// An action of any verb with any things, more often with things that are near or in hand.
fn any_action(graph: &SceneGraph, agent: NodeId, stream: &mut Stream) -> Action {
    let verbs: Vec<Verb> = graph.vocabulary().verbs().collect();
    let verb = stream.pick(&verbs).copied().unwrap_or(Verb::Dance);
    let all: Vec<NodeId> = graph.nodes().map(vc_graph::Node::id).collect();
    let body = graph.node(agent).and_then(vc_graph::Node::position);
    let near: Vec<NodeId> = body.map(|at| graph.within(at, 2.0)).unwrap_or_default();
    let held: Vec<NodeId> = graph.held(agent).collect();
    let of_the_home = |id: &NodeId| graph.node(*id).is_some_and(|n| n.kind() != NodeKind::Room);
    let near: Vec<NodeId> = near.into_iter().filter(of_the_home).collect();
    let mut thing = || {
        let list = match stream.below(4) {
            0 if !held.is_empty() => &held,
            1 | 2 if !near.is_empty() => &near,
            _ => &all,
        };
        stream.pick(list).copied().unwrap_or(agent)
    };
    let things: Vec<NodeId> = (0..verb.arity()).map(|_| thing()).collect();
    Action::with(verb, &things).unwrap_or(Action::zero(Verb::Dance))
}
