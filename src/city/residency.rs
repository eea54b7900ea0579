//! The regions that are there: those with agents, and those in which something still moves.

use std::collections::BTreeSet;

use vc_graph::clock::Span;
use vc_graph::space::{RegionId, SpaceError};
use vc_graph::{Event, Node, NodeId, State, Verb};

use super::{City, CityError, RegionLabel};
use crate::Environment;

impl City {
    /// The environment of a region, which is made or woken if it is not there.
    pub(super) fn wake(&mut self, region: RegionId) -> Result<&mut Environment, CityError> {
        if !self.active.contains_key(&region) {
            let mut environment = match self.asleep.get(&region) {
                Some(dormant) => self.as_it_fell_asleep(region, dormant)?,
                None => self.first(region)?,
            };
            self.asleep.remove(&region);
            // Time has passed there as well; nobody could tell the difference.
            environment.step(Span(self.tick.0.saturating_sub(environment.tick().0)));
            self.active.insert(region, environment);
            self.move_lift_doors(region);
            self.set_bars(region);
        }
        let space = self.source.space();
        self.active.get_mut(&region).ok_or_else(|| CityError::NoScene(RegionLabel::new(space, region)))
    }

    /// The environment of a region as it is before anybody has been there.
    pub(super) fn made(&self, region: RegionId) -> Result<Environment, CityError> {
        let plan = self.space().region(region).filter(|plan| plan.has_scene());
        let label = || self.region_label(region);
        let plan = plan.ok_or_else(|| CityError::NoScene(label()))?;
        let scene = self.source.scene(region).map_err(|why| CityError::Scene { region: label(), why: why.into() })?;
        if let Some(node) = scene.nodes().find(|node| !plan.numbers.has(node.id())) {
            return Err(SpaceError::ForeignNumber { region, node: Node::label(node) }.into());
        }
        let made = self.settings.clone().scene(scene).unpeopled().amid(self.around(region)).make();
        made.map_err(|why| CityError::Make { region: label(), why: why.into() })
    }

    /// Lets regions go in which nobody is and nothing moves, and into which nothing reaches.
    pub(super) fn let_rest(&mut self, reached: &BTreeSet<RegionId>) {
        let is_needed = |region: &RegionId| {
            let crossed = |journey: &super::Journey| journey.needs(*region);
            self.agents.iter().any(|agent| self.whereabouts.get(agent) == Some(region))
                || self.journeys.values().any(crossed)
                || self.has_open_lift(*region)
                || reached.contains(region)
        };
        let rests = |(region, environment): (&RegionId, &Environment)| {
            (!is_needed(region) && environment.is_still()).then_some(*region)
        };
        let gone: Vec<RegionId> = self.active.iter().filter_map(rests).collect();
        for region in gone {
            let Some(environment) = self.active.remove(&region) else { continue };
            // A region that nobody has changed, or done more in than walk, is made anew the next time.
            let is_done = |event: &Event| event.action.verb != Verb::Walk;
            if !environment.is_as_made() || environment.history().events().iter().any(is_done) {
                let dormant = self.asleep(region, environment);
                self.asleep.insert(region, dormant);
            }
        }
    }

    /// Whether the doors of a lift are not shut at a region.
    fn has_open_lift(&self, region: RegionId) -> bool {
        let plans = self.space().portals_of(region).filter_map(|portal| self.space().portal(portal));
        let mut lifts = plans.filter_map(|plan| Some((plan, self.lifts.at(plan)?.1)));
        lifts.any(|(plan, lift)| lift.is_standing_open(plan.stop))
    }

    /// Whether the leaf of a door or window is open.
    pub(super) fn is_open(&self, leaf: NodeId) -> bool {
        let Some(region) = self.region_of(leaf) else { return false };
        self.seen(region).is_ok_and(|there| there.graph().node(leaf).is_some_and(|node| node.is(State::Open)))
    }
}
