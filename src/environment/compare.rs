//! Comparison of the bodies' result with the prediction of the transition rule.

use std::fmt;

use vc_graph::{Action, Change, ChangeSet, Effect, Label, NodeId, NodeKind, Place, Relation, SceneGraph, State, rule};
use vc_physics::PhysicsWorld;

use super::{ActionError, Attempt, PhysicalRefusal};

/// Distance below which a thing counts as not moved, metres.
const STILL: f32 = 0.02;

/// The bodies did an action, and the result is not what the transition rule predicts.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("{attempt}: the bodies and the rule disagree: {}", listed(.differences))]
pub struct Disagreement {
    /// The action that was done.
    pub attempt: Attempt,
    /// The differences between rule and bodies.
    pub differences: Vec<Difference>,
}

/// One thing about which the rule and the bodies disagree.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// The thing.
    pub thing: Label,
    /// The prediction of the transition rule.
    pub rule: String,
    /// The state that the bodies show.
    pub bodies: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is {} by the rule and {} by the bodies", self.thing, self.rule, self.bodies)
    }
}

fn listed(differences: &[Difference]) -> String {
    differences.iter().map(Difference::to_string).collect::<Vec<_>>().join("; ")
}

/// The graph that the rule predicts, the graph observed afterwards, and the bodies.
pub(super) struct Outcome<'a> {
    pub(super) before: &'a SceneGraph,
    pub(super) ruled: &'a SceneGraph,
    pub(super) observed: &'a SceneGraph,
    pub(super) world: &'a PhysicsWorld,
}

impl Outcome<'_> {
    /// All differences among the nodes that may have changed.
    pub(super) fn differences(
        &self,
        agent: NodeId,
        action: &Action,
        changes: &ChangeSet,
        met: &[NodeId],
    ) -> Vec<Difference> {
        let mut nodes: Vec<NodeId> = changes.changes().iter().flat_map(touched).chain(met.iter().copied()).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let effects = rule::effects(self.before.vocabulary(), action);
        let let_go = |id: NodeId| effects.contains(&Effect::LetGo(id)) || self.lost_origin(&effects, id);
        let kept = nodes.iter().filter(|id| !let_go(**id));
        let mut found: Vec<Difference> = kept.filter_map(|&id| self.place(id)).collect();
        // A released thing lies where it falls, which may be beyond a threshold in the next room.
        let fell = |id: NodeId| self.fell_with(&effects, id);
        // The rule knows rooms by boxes: in which one a point is, bodies tell. It does not know of steps to what is near.
        let goes_to_thing = effects.iter().any(|effect| matches!(effect, Effect::GoTo(_) | Effect::Approach(_)));
        let went = |id: NodeId| !goes_to_thing && (id == agent || self.before.rests_at(id, agent));
        found.extend(nodes.iter().filter(|id| !fell(**id) && !went(**id)).filter_map(|&id| self.room(id)));
        found.extend(nodes.iter().filter_map(|&id| self.open(id)));
        found.extend(effects.iter().filter_map(|effect| self.nearness(agent, effect)));
        found.extend(effects.iter().filter_map(|effect| self.facing(agent, effect)));
        found
    }

    /// Whether a thing is released, or lies on or in a released thing.
    fn fell_with(&self, effects: &[Effect<NodeId>], id: NodeId) -> bool {
        let carries = |at: NodeId| at == id || self.before.rests_at(id, at);
        effects.iter().any(|effect| matches!(effect, Effect::LetGo(at) if carries(*at)))
    }

    /// Whether a thing is put back where it was taken from, for which the rule's graph has no place.
    fn lost_origin(&self, effects: &[Effect<NodeId>], id: NodeId) -> bool {
        effects.contains(&Effect::PutWhereItWas(id)) && self.ruled.places(id).next().is_none()
    }

    fn place(&self, id: NodeId) -> Option<Difference> {
        let (rule, bodies) = (self.places(self.ruled, id), self.places(self.observed, id));
        let was = self.places(self.before, id);
        // A thing that the rule puts somewhere may rest on further things besides its new support, and no
        // longer rests on its former one.
        let ended = was.iter().any(|p| !rule.contains(p) && bodies.contains(p));
        let held = rule.iter().all(|p| bodies.contains(p)) && !ended;
        let agrees = if rule == was { self.stays(id, &rule, &bodies) } else { held };
        (!agrees).then(|| self.difference(id, |s| s.describe(&rule), |s| s.describe(&bodies)))
    }

    /// Whether a thing that the rule does not move stays where it was. A knife that slides onto another while
    /// its drawer is pulled is still in the drawer: the end of the support chain counts.
    fn stays(&self, id: NodeId, rule: &[Place], bodies: &[Place]) -> bool {
        let same_end = || {
            let end = ends(self.ruled, id);
            !end.is_empty() && end == ends(self.observed, id)
        };
        // A thing in a lifted bowl is no longer on the table below the bowl.
        let lifted = || self.observed.support_chain(id).iter().any(|at| self.observed.holder(*at).is_some());
        let lost_some = !bodies.is_empty() && bodies.iter().all(|p| rule.contains(p)) && lifted();
        rule == bodies || lost_some || same_end() || self.lies_still(id)
    }

    /// Whether a thing has approximately kept its pose. A thing that lay half on a newspaper lies on the table
    /// once the newspaper is taken away, and the cover of a sleeper lies on the bed: neither has moved, but its
    /// support is another one.
    fn lies_still(&self, id: NodeId) -> bool {
        let pose = |graph: &SceneGraph| graph.node(id).and_then(|n| n.pose().copied());
        let moved = pose(self.before).zip(pose(self.observed));
        moved.is_some_and(|(was, is)| (is.translation.vector - was.translation.vector).norm() < STILL)
    }

    /// The places of a thing, without those that only say that it stands on the building.
    fn places(&self, graph: &SceneGraph, id: NodeId) -> Vec<Place> {
        let mut places: Vec<Place> = graph.places(id).filter(|p| !is_ground(graph, id, p)).collect();
        places.sort_unstable();
        places
    }

    fn room(&self, id: NodeId) -> Option<Difference> {
        let (rule, bodies) = (self.ruled.room_of(id), self.observed.room_of(id));
        let name =
            |room: Option<NodeId>| room.map_or("in no room".to_owned(), |r| format!("in {}", self.ruled.label(r)));
        (rule != bodies).then(|| self.difference(id, |_| name(rule), |_| name(bodies)))
    }

    fn open(&self, id: NodeId) -> Option<Difference> {
        let shown = self.world.parts(id).state()?;
        let node = self.ruled.node(id)?;
        let said = [State::Open, State::Closed].into_iter().find(|s| node.is(*s))?;
        (said != shown).then(|| self.difference(id, |_| said.to_string(), |_| shown.to_string()))
    }

    fn nearness(&self, agent: NodeId, effect: &Effect<NodeId>) -> Option<Difference> {
        let (Effect::GoTo(id) | Effect::Approach(id)) = *effect else { return None };
        let label = self.ruled.label(id);
        let far = || match self.observed.distance(agent, id) {
            Some(metres) => format!("{metres:.2} m from {label}"),
            None => format!("not near {label}"),
        };
        (!self.observed.near(agent, id)).then(|| self.difference(agent, |_| format!("near {label}"), |_| far()))
    }

    fn facing(&self, agent: NodeId, effect: &Effect<NodeId>) -> Option<Difference> {
        let Effect::Face(id) = *effect else { return None };
        let label = self.ruled.label(id);
        let agrees = self.observed.facing(agent, id);
        (!agrees).then(|| self.difference(agent, |_| format!("facing {label}"), |_| format!("not facing {label}")))
    }

    fn difference(&self, id: NodeId, rule: impl Fn(&Self) -> String, bodies: impl Fn(&Self) -> String) -> Difference {
        Difference { thing: self.ruled.label(id), rule: rule(self), bodies: bodies(self) }
    }

    fn describe(&self, places: &[Place]) -> String {
        let word = |p: &Place| match p.relation {
            Relation::HoldsRight => format!("in the right hand of {}", self.ruled.label(p.at)),
            Relation::HoldsLeft => format!("in the left hand of {}", self.ruled.label(p.at)),
            relation => format!("{relation} {}", self.ruled.label(p.at)),
        };
        let words: Vec<String> = places.iter().map(word).collect();
        if words.is_empty() { "on nothing in particular".into() } else { words.join(" and ") }
    }
}

/// The last things of a node's support chain before the building. A plum in a bowl in a cabinet may be in both.
fn ends(graph: &SceneGraph, id: NodeId) -> Vec<NodeId> {
    let is_built = |at: &NodeId| graph.node(*at).is_none_or(vc_graph::Node::is_building);
    let chain: Vec<NodeId> = graph.support_chain(id).into_iter().filter(|at| !is_built(at)).collect();
    let rests = |at: &NodeId| graph.places(*at).any(|p| p.at != *at && chain.contains(&p.at));
    let mut ends: Vec<NodeId> = chain.iter().copied().filter(|at| !rests(at)).collect();
    ends.sort_unstable();
    ends
}

/// Whether a place says no more than that a thing stands on the floor: always for agents, and for things only
/// where the rule has no word for it.
fn is_ground(graph: &SceneGraph, id: NodeId, place: &Place) -> bool {
    let agent = graph.node(id).is_some_and(|n| n.kind() == NodeKind::Agent);
    agent && place.relation == Relation::On
}

fn touched(change: &Change) -> Vec<NodeId> {
    match change {
        Change::Add(node) | Change::Remove(node) => vec![node.id()],
        Change::States { id, .. } | Change::Pose { id, .. } | Change::Contents { id, .. } => vec![*id],
        Change::Link(edge) | Change::Unlink(edge) => vec![edge.from, edge.to],
        _ => Vec::new(),
    }
}

/// The error of an action after which only a thing that would not stay where it was put is elsewhere: bodies know
/// that they cannot do this.
pub(super) fn unsteady(error: ActionError, balanced: Option<NodeId>) -> ActionError {
    let ActionError::Disagreement(both) = error else { return error };
    match both.differences.iter().find(|d| Some(d.thing.id) == balanced) {
        Some(own) if both.differences.iter().all(|d| d.thing.id == own.thing.id) => {
            let why = PhysicalRefusal::Unsteady(own.thing.clone());
            ActionError::Impossible { attempt: both.attempt, why }
        }
        _ => ActionError::Disagreement(both),
    }
}
