//! The probabilities of a thing's places, and the text of a belief.

use std::fmt;

use vc_graph::hash::fnv1a;
use vc_graph::{NodeId, Place, SceneGraph};

use super::Belief;
use crate::prior::{HABIT, Kinds, STRAY};

/// The chances of places for a thing.
pub(crate) struct Chances<'a> {
    each: f64,
    by: [f64; 2],
    likely: Option<&'a [[f64; 2]]>,
    kinds: &'a Kinds,
}

impl Chances<'_> {
    /// The chance of a place not seen, by its number.
    pub(crate) fn at(&self, place: usize) -> f64 {
        let likely = self.likely.map_or([0.0; 2], |likely| likely[self.kinds.of_place(place)]);
        self.each + self.by[HABIT] * likely[HABIT] + self.by[STRAY] * likely[STRAY]
    }
}

impl Belief {
    /// The chances of the places not seen for a missing thing.
    pub(crate) fn chances_of(&self, id: NodeId) -> Option<Chances<'_>> {
        let class = self.supposed.get(self.graph.node(id)?.class())?;
        let (each, by) = self.tidiness.mix(class, self.unseen_share(), self.even());
        Some(Chances { each, by, likely: class.likely.as_deref(), kinds: &self.kinds })
    }

    /// The chance of a place where all are alike.
    pub(super) fn even(&self) -> f64 {
        1.0 / self.places.len().max(1) as f64
    }

    pub(super) fn unseen_share(&self) -> f64 {
        self.open_places() as f64 * self.even()
    }

    /// Everywhere a thing can be, with the chance that it is there; likeliest first.
    /// They sum to one.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Scope};
    /// use vc_planner::Agent;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let mut agent = Agent::in_known_home(&graph, me, "Holds(milk)".parse()?, 1);
    /// agent.see(&graph.observe(me, Scope::Room));
    /// let chances: f64 = agent.belief().distribution(milk).iter().map(|(_, chance)| chance).sum();
    /// assert!((chances - 1.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn distribution(&self, id: NodeId) -> Vec<(Place, f64)> {
        if !self.is_missing(id) {
            return self.graph.place(id).map(|p| (p, 1.0)).into_iter().collect();
        }
        let Some(chances) = self.chances_of(id) else { return Vec::new() };
        let mut all: Vec<(Place, f64)> = self.sites().map(|(i, place, _)| (place, chances.at(i))).collect();
        all.sort_by(|a, b| b.1.total_cmp(&a.1));
        all
    }

    /// Where a thing is most likely.
    ///
    /// ```
    /// use vc_graph::{Draft, SceneBuilder, Scope};
    /// use vc_planner::Agent;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let milk = scene.add_in(fridge, Draft::new("milk"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let graph = scene.build();
    /// let mut agent = Agent::in_known_home(&graph, me, "Holds(milk)".parse()?, 1);
    /// agent.see(&graph.observe(me, Scope::Room));
    /// assert_eq!(agent.belief().most_likely(milk).map(|place| place.at), Some(fridge));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn most_likely(&self, id: NodeId) -> Option<Place> {
        self.distribution(id).first().map(|(place, _)| *place)
    }

    /// The state with every thing where it is most likely, and all that is known.
    pub fn most_likely_state(&self) -> SceneGraph {
        let mut likely = self.clone();
        for (id, _) in &self.missing {
            let at = self.most_likely(*id).and_then(|p| self.places.iter().position(|q| *q == p));
            if let Some(at) = at {
                likely.suppose(*id, at);
            }
        }
        likely.graph
    }

    /// A number that tells beliefs apart: what is missing, where it is guessed, what
    /// has been searched.
    pub fn digest(&self) -> u64 {
        let seen = self.seen.iter().enumerate().filter(|(_, s)| **s).map(|(i, _)| i as u64);
        let missing = self.missing.iter().map(|&(id, place)| u64::from(id.0) << 32 | place as u64);
        fnv1a(missing.chain(seen))
    }

    /// How likely a thing is at a place, 0 to 1.
    pub fn probability(&self, id: NodeId, place: Place) -> f64 {
        if !self.is_missing(id) {
            return f64::from(u8::from(self.graph.places(id).any(|p| p == place)));
        }
        self.distribution(id).iter().find(|(p, _)| *p == place).map_or(0.0, |(_, chance)| *chance)
    }
}

/// The missing things, each with its likeliest places.
impl fmt::Display for Belief {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        const SHOWN: usize = 3;
        writeln!(f, "{} things not found, {} places not searched", self.missing.len(), self.open_places())?;
        for (id, _) in &self.missing {
            write!(f, "{}:", self.graph.label(*id))?;
            for (place, chance) in self.distribution(*id).into_iter().take(SHOWN) {
                write!(f, " {:.0}% {} {}", 100.0 * chance, place.relation, self.graph.label(place.at))?;
            }
            writeln!(f)?;
        }
        Ok(())
    }
}
