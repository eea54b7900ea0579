//! Goals in a city: what has to hold, and where.

use std::borrow::Cow;

use vc_graph::goal::{Situation, Term};
use vc_graph::space::{RegionId, gather};
use vc_graph::{Event, Goal, NodeId, SceneGraph};

use super::{City, CityError};
use crate::Environment;

/// The part of a city that a goal is about.
///
/// ```
/// use virtualcity::{City, GoalScope};
/// let city = City::make("building/7", 2)?;
/// let me = city.agents().next().ok_or("nobody")?;
/// // Each of the two homes has a fridge.
/// let goal = "Closed(fridge), 2".parse()?;
/// assert!(!city.holds(&goal, me, GoalScope::Home)? && city.holds(&goal, me, GoalScope::World)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[non_exhaustive]
pub enum GoalScope {
    /// The home of the agent, and what it carries wherever it is.
    #[default]
    Home,
    /// A region, or all that are part of it: a storey, a building.
    Place(RegionId),
    /// The world: all regions in which somebody is or has changed something, and those of the nodes that the goal names by
    /// number. Homes that nobody has changed are known by the plan alone, and count as empty.
    World,
}

impl City {
    /// The region that is an agent's home: where it began.
    pub fn home(&self, agent: NodeId) -> Option<RegionId> {
        self.homes.get(&agent).copied()
    }

    /// Whether a goal holds of a part of the city now, `me` being an agent. Past actions are those done in the regions of the
    /// scope. Changes nothing; costs a pointer for each node in the scope, and an evaluation.
    ///
    /// ```
    /// use virtualcity::graph::Goal;
    /// use virtualcity::{City, GoalScope};
    /// let mut city = City::make("building/7", 1)?;
    /// let me = city.agents().next().ok_or("nobody")?;
    /// let yard = city.space().regions().find(|(_, region)| &*region.name == "yard").ok_or("no yard")?.0;
    /// let goal: Goal = "Inside(me, garden)".parse()?;
    /// assert!(!city.holds(&goal, me, GoalScope::Place(yard))?);
    /// city.go(me, yard)?;
    /// assert!(city.holds(&goal, me, GoalScope::Place(yard))?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CityError::NoSuchAgent`]; reasons for which a region cannot be made.
    pub fn holds(&self, goal: &Goal, agent: NodeId, scope: GoalScope) -> Result<bool, CityError> {
        let (graph, events) = self.situation(goal, agent, scope)?;
        Ok(goal.holds(&Situation { graph: &graph, agent, events: &events }))
    }

    /// How much of a goal holds of a part of the city now, 0 to 1: [`Goal::score`].
    ///
    /// # Errors
    /// As [`holds`](Self::holds).
    pub fn score(&self, goal: &Goal, agent: NodeId, scope: GoalScope) -> Result<f64, CityError> {
        let (graph, events) = self.situation(goal, agent, scope)?;
        Ok(goal.score(&Situation { graph: &graph, agent, events: &events }))
    }

    /// The scenes of a scope as one, and what has been done there.
    fn situation(&self, goal: &Goal, agent: NodeId, scope: GoalScope) -> Result<(SceneGraph, Vec<Event>), CityError> {
        let there = self.environment_with(agent)?;
        let regions = self.regions_of(goal, agent, scope);
        let seen = regions.iter().map(|region| self.seen(*region)).collect::<Result<Vec<Cow<'_, Environment>>, _>>()?;
        let is_away = scope == GoalScope::Home && self.region_of(agent).is_none_or(|at| !regions.contains(&at));
        let carries = is_away.then(|| (there.graph(), agent));
        let events = seen.iter().flat_map(|home| home.history().events().iter().copied());
        Ok((gather(seen.iter().map(|home| home.graph()), carries), events.collect()))
    }

    /// The regions of a scope, in order.
    fn regions_of(&self, goal: &Goal, agent: NodeId, scope: GoalScope) -> Vec<RegionId> {
        let mut regions: Vec<RegionId> = match scope {
            GoalScope::Home => self.home(agent).into_iter().collect(),
            GoalScope::Place(place) => self.parts_of(place),
            GoalScope::World => {
                let named = goal.terms().into_iter().filter_map(|term| match term {
                    Term::Node(_, id) => self.region_of(id),
                    _ => None,
                });
                self.active.keys().chain(self.asleep.keys()).copied().chain(named).collect()
            }
        };
        regions.sort_unstable();
        regions.dedup();
        regions
    }

    /// A region with all that are part of it, without groups.
    fn parts_of(&self, place: RegionId) -> Vec<RegionId> {
        let (mut all, mut at) = (vec![place], 0);
        while let Some(region) = all.get(at).copied() {
            all.extend(self.space().parts(region));
            at += 1;
        }
        all.retain(|region| self.space().region(*region).is_some_and(|plan| plan.has_scene()));
        all
    }
}
