//! Initial environments in generated homes that suit an activity.

use std::convert::Infallible;
use std::fmt;

#[cfg(feature = "environment")]
use vc_graph::{
    Goal, Label, NodeId, NodeKind, Place, Relation,
    goal::{Predicate, Term},
};
use vc_graph::{SceneGraph, Seed};
use vc_procgen::{Apartment, Specification, SpecificationError};
use vc_shapes::Generators;
use vc_tasks::initial::{Initial, InitialError, InitialGenerator};
use vc_tasks::library::Activity;
use vc_tasks::{World, WorldError};

pub use crate::catalogue::Catalogue;
#[cfg(feature = "environment")]
use crate::{Environment, NoRoom};

/// An initial environment in a home that was generated for it.
#[derive(Debug, Clone, PartialEq)]
pub struct AtHome<W> {
    /// The initial environment.
    pub initial: Initial,
    /// The world that is in this initial state.
    pub world: W,
    /// The seed of the home.
    pub home: Seed,
    /// The home before anything was added for the activity.
    pub bare: SceneGraph,
    /// Number of homes that were tried, starting at one.
    pub homes: usize,
    /// The reasons why the earlier homes did not suit.
    pub passed_over: Vec<InitialError>,
}

/// The reason why no home was found for an activity.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum NoHome {
    /// No home has the rooms that the activity needs.
    #[error(transparent)]
    Impossible(#[from] SpecificationError),
    /// No world could be made from a home.
    #[error(transparent)]
    World(#[from] WorldError),
    /// None of the tried homes could be prepared for the activity.
    #[error("none of {homes} homes suits, the last: {last}")]
    Unsuitable {
        /// Number of homes that were tried.
        homes: usize,
        /// The error of the last home.
        last: InitialError,
    },
}

/// Number of homes that are tried before an activity is given up.
const HOMES: usize = 40;

/// Generates a home with the rooms that an activity needs and prepares it for the activity. If a home does not
/// suit (it has no balcony door to open, or its milk is in the fridge already), the next one is tried.
///
/// `open` makes a world from a home: [`Simulator::new`](vc_graph::Simulator::new), or an environment with
/// bodies and an agent. Costs some milliseconds for each home, and a reset of the world for each try.
///
/// ```
/// use virtualcity::graph::{Seed, Simulator};
/// use virtualcity::initial::{at_home, generator};
/// use virtualcity::tasks::library::Benchmark;
///
/// let benchmark = Benchmark::v1();
/// let activity = benchmark.get("setup_table-01").ok_or("no such task")?;
/// let made = at_home(activity, Seed(7), &generator(), |home| Ok(Simulator::new(home)))?;
/// assert!(made.initial.credit < 1.0);
/// assert_eq!(*made.world.graph(), made.initial.scene);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`NoHome`] says what was wrong with the last home.
pub fn at_home<W: World>(
    activity: &Activity,
    seed: Seed,
    generator: &InitialGenerator<'_>,
    open: impl FnMut(SceneGraph) -> Result<W, WorldError>,
) -> Result<AtHome<W>, NoHome> {
    at_home_that(activity, seed, generator, open, |_, _| Ok::<(), Infallible>(()))
}

/// As [`at_home`], with a further condition on the home: `suits` returns the reason why a home does not suit, which is
/// reported as [`InitialError::Unconfirmed`]. [`feasible`] is such a condition for environments with bodies.
///
/// # Errors
/// As [`at_home`].
pub fn at_home_that<W: World, E: fmt::Display>(
    activity: &Activity,
    seed: Seed,
    generator: &InitialGenerator<'_>,
    mut open: impl FnMut(SceneGraph) -> Result<W, WorldError>,
    mut suits: impl FnMut(&W, &Initial) -> Result<(), E>,
) -> Result<AtHome<W>, NoHome> {
    let mut passed_over = Vec::new();
    for index in 0..HOMES {
        let home = seed.child("home").nth(index as u64);
        let mut world = open(Apartment::generate(&wishes(activity, home), home)?.scene())?;
        let bare = world.graph().clone();
        let made = generator.make(activity, &bare, seed, &mut world).and_then(|initial| {
            let tries = initial.tries;
            let unsuited = |why: E| InitialError::Unconfirmed { difference: why.to_string(), tries };
            suits(&world, &initial).map(|()| initial).map_err(unsuited)
        });
        match made {
            Ok(initial) => return Ok(AtHome { initial, world, home, bare, homes: index + 1, passed_over }),
            Err(error) => passed_over.push(error),
        }
    }
    let last = passed_over.pop().unwrap_or_else(|| InitialError::NoRoom(activity.places.join(", ")));
    Err(NoHome::Unsuitable { homes: HOMES, last })
}

/// The reason why bodies cannot do an activity in a home.
#[cfg(feature = "environment")]
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Infeasible {
    /// A thing that was added for the activity is out of reach.
    #[error("nobody gets at {0}")]
    Unreachable(Label),
    /// Too few things of a class are within reach.
    #[error("nobody gets at {number} {class}")]
    TooFew {
        /// Number of things that the activity needs.
        number: usize,
        /// Their class.
        class: String,
    },
    /// A thing has no room where the goal wants it.
    #[error(transparent)]
    NoRoom(#[from] NoRoom),
}

/// Whether bodies can do an activity as far as the places of things tell: the added things and as many things
/// of each class as the activity needs are reachable, and there is room for the things that are to be put on or
/// in something.
///
/// Uses [`Environment::can_get_at`] and [`Environment::has_room`].
///
/// # Errors
/// [`Infeasible`] with the thing that is not reachable, or for which there is no room.
#[cfg(feature = "environment")]
pub fn feasible(activity: &Activity, home: &Environment, initial: &Initial) -> Result<(), Infeasible> {
    let (graph, agent) = (home.graph(), initial.agent);
    let activity = &*activity.expanded(graph.vocabulary());
    let gets_at = |id: &NodeId| home.can_get_at(agent, *id);
    let objects = |class: &str| {
        let all = graph.of_class(class).into_iter();
        all.filter(|id| graph.node(*id).is_some_and(|n| n.kind() == NodeKind::Object)).collect::<Vec<NodeId>>()
    };
    let added = initial.added.iter().map(|a| a.id).filter(|id| *id != agent);
    if let Some(id) = added.into_iter().find(|id| !gets_at(id)) {
        return Err(Infeasible::Unreachable(graph.label(id)));
    }
    for need in activity.all_needs() {
        let (all, number) = (objects(&need.class), need.number);
        let there = all.iter().filter(|id| gets_at(id)).take(number).count();
        if !all.is_empty() && there < number {
            return Err(Infeasible::TooFew { number, class: need.class.to_string() });
        }
    }
    let wants = wanted(activity, graph, objects);
    Ok(home.has_room(agent, &wants)?)
}

/// The things that still have to be put on or in something for an activity's goal, each with its possible
/// places.
#[cfg(feature = "environment")]
fn wanted(activity: &Activity, graph: &SceneGraph, objects: impl Fn(&str) -> Vec<NodeId>) -> Vec<(NodeId, Vec<Place>)> {
    let literals = activity.goal.conjuncts().iter().filter_map(|part| match part {
        Goal::Literal(literal) => Some((literal, 1)),
        Goal::Count { literal, number, .. } => Some((literal, *number as usize)),
        _ => None,
    });
    let mut wants = Vec::new();
    for (literal, number) in literals {
        let (Predicate::Relation(relation @ (Relation::On | Relation::Inside)), [Term::Class(thing), Term::Class(at)]) =
            (literal.predicate, &literal.terms[..])
        else {
            continue;
        };
        let places: Vec<Place> = objects(at).into_iter().map(|at| Place { relation, at }).collect();
        let is_there = |id: &NodeId| graph.places(*id).any(|p| places.contains(&p));
        let (there, others): (Vec<NodeId>, Vec<NodeId>) = objects(thing).into_iter().partition(is_there);
        let missing = number.saturating_sub(there.len());
        wants.extend(others.into_iter().take(missing).map(|id| (id, places.clone())));
    }
    wants
}

/// A generator that takes missing things from the [`Catalogue`].
pub fn generator() -> InitialGenerator<'static> {
    static BUILTIN: Catalogue = Catalogue::new(Generators::BUILTIN);
    InitialGenerator::new(&BUILTIN)
}

/// The specification of a home with an activity's rooms. Studios are left out: their single room is neither a
/// kitchen nor a bedroom.
fn wishes(activity: &Activity, home: Seed) -> Specification {
    let bedrooms = home.child("bedrooms").stream().count(1, 4);
    let named = |room: &str| activity.places.iter().any(|p| p == room).then_some(true);
    Specification {
        bedrooms: Some(bedrooms),
        study: named("home_office"),
        laundry: named("laundry_room"),
        storage: named("storage_room"),
        balconies: named("balcony").map(|_| 1),
        ..Specification::default()
    }
}
