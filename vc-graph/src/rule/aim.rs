//! Aims as parameters of actions: which verbs take which, what they bring about, and why one is refused.

use nalgebra::{Point2, Point3, Vector3};

use crate::AimWord::{At, By, Seat, Slot, Yaw};
use crate::asset::Hold;
use crate::class::SlotKind;
use crate::rule::effect::Effect;
use crate::rule::effects;
use crate::rule::refusal::Refusal;
use crate::{
    Action, Aim, AimPart, AimPoint, AimWord, BoundsFrame, Label, Motion, NEAR, Node, NodeId, NodeKind, ObjectRole,
    Relation, SceneGraph, State, Verb,
};

/// Half the height up to which a thing is a sheet on which others can stand, metres.
const SHEET: f32 = 0.005;
/// How far a point of a surface may be beside the surface's box, metres: numbers are rounded.
const BESIDE: f32 = 0.01;

/// How far from the height of a surface a thing on it may begin, metres: less than shelves are apart.
const LEVEL: f32 = 0.05;
/// Floors whose heights differ by less are on one storey, metres.
const STOREY: f32 = 1.0;

/// The words of an aim that a verb takes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AimForm {
    /// Whether it stands for the verb's only object; otherwise it comes with all objects.
    pub alone: bool,
    /// Its words.
    pub words: &'static [AimWord],
}

/// The part of the scene that an aim places.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Aimed {
    /// The agent's feet.
    Feet,
    /// The direction in which the agent is turned.
    Front,
    /// The first object.
    Object,
}

/// The aims that a verb takes.
///
/// ```
/// use vc_graph::{Verb, Vocabulary};
/// let words = Vocabulary::builtin();
/// let aims = |verb| words.rule(verb).map(|rule| rule.aims).ok_or("no such verb");
/// assert_eq!(aims(Verb::Sit)?.texts(Verb::Sit), ["sit THING seat N"]);
/// let eat = "eat apple.3 at 1 2".parse()?;
/// assert!(!aims(Verb::Eat)?.fit(&eat));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct AimRule {
    /// The combinations of words.
    pub forms: &'static [AimForm],
    /// The part of the scene that point and heading place, if the verb takes them.
    pub places: Option<Aimed>,
}

impl AimRule {
    fn takes(&self, aim: &Aim, alone: bool) -> bool {
        let words = aim.words();
        self.forms
            .iter()
            .any(|form| form.alone == alone && form.words.iter().copied().collect::<crate::Set<_>>() == words)
    }

    /// Whether an aim stands for the verb's only object.
    pub fn stands_for_object(&self, aim: &Aim) -> bool {
        !aim.is_nothing() && self.takes(aim, true)
    }

    /// Whether the verb takes the aim that an action has, if any.
    pub fn fit(&self, action: &Action) -> bool {
        action.aim.is_nothing() || self.takes(&action.aim, action.object.is_none())
    }

    /// The aims that a verb takes, as they are written.
    pub fn texts(&self, verb: Verb) -> Vec<String> {
        let things = ["", " THING", " THING PLACE"][verb.arity().min(2)];
        let word = |word: &AimWord| match word {
            At => " at X Y [Z]",
            Yaw => " yaw DEGREES",
            Seat => " seat N",
            Slot => " slot N",
            By => " by SIDE",
        };
        let text = |form: &AimForm| {
            let words: String = form.words.iter().map(word).collect();
            format!("{verb}{}{words}", if form.alone { "" } else { things })
        };
        self.forms.iter().map(text).collect()
    }

    pub(super) fn refusal(&self, action: &Action) -> Refusal {
        let (verb, given) = (action.verb, action.aim.to_string().trim_start().to_owned());
        Refusal::Aim { verb, takes: self.texts(verb), given }
    }

    /// The effects of an action's aim, besides those of its verb.
    pub(super) fn effects(&self, action: &Action) -> impl Iterator<Item = Effect<NodeId>> + use<> {
        let aim = action.aim;
        let places = self.places.filter(|_| aim.point().is_some() || aim.heading().is_some());
        let (first, second) = match places {
            None => (None, None),
            Some(Aimed::Front) => (Some(Effect::TurnAs(aim)), None),
            Some(Aimed::Object) => (action.object.map(|id| Effect::PoseAs(id, aim)), None),
            Some(Aimed::Feet) => {
                (action.object.is_none().then_some(Effect::GoToPoint(aim)), Some(Effect::StandAs(aim)))
            }
        };
        first.into_iter().chain(second)
    }
}

/// Every reason why the aim of an action cannot be met, as far as poses and boxes tell; its form is not judged.
pub(super) fn refusals(graph: &SceneGraph, agent: NodeId, action: &Action) -> Vec<Refusal> {
    let (of, aim) = (Judged { graph, agent, action }, &action.aim);
    if aim.is_nothing() {
        return Vec::new();
    }
    let rule = graph.vocabulary().rule(action.verb);
    let point = aim.point().and_then(|point| match rule?.aims.places? {
        Aimed::Feet => of.standing_at(point),
        Aimed::Front => None,
        Aimed::Object => of.putting_at(point),
    });
    let part = aim.part().and_then(|part| of.part(part));
    // Pointing turns no more than the arm of one who rests.
    let turns = rule.is_some_and(|rule| rule.aims.places == Some(Aimed::Front) && rule.motion != Motion::Point);
    let rests = graph.node(agent).is_some_and(|body| body.is(State::Sitting) || body.is(State::Lying));
    point.into_iter().chain(part).chain((turns && rests).then(|| Refusal::NotUpright(graph.label(agent)))).collect()
}

struct Judged<'a> {
    graph: &'a SceneGraph,
    agent: NodeId,
    action: &'a Action,
}

impl Judged<'_> {
    /// Going to a point: it is in a room, and near the object to which one goes.
    fn standing_at(&self, point: AimPoint) -> Option<Refusal> {
        let (graph, plan) = (self.graph, point.plan());
        let known = graph.rooms().iter().any(|room| !extents(graph, *room).is_empty());
        match self.action.object.and_then(|id| graph.node(id)) {
            None if !known => Some(Refusal::NoPoses(point)),
            _ if known && room_at(graph, &point).is_none() => Some(Refusal::OutsideRooms(point)),
            Some(to) => {
                let room = graph.room_of(to.id()).filter(|room| is_outside(graph, *room, &plan));
                let elsewhere = room.map(|room| Refusal::PointElsewhere { point, at: graph.label(room) });
                let far = || distance(to, &plan).filter(|far| *far > NEAR && to.kind() != NodeKind::Room);
                let apart = |distance| Refusal::PointApart { point, thing: to.label(), distance };
                elsewhere.or_else(|| far().map(apart))
            }
            None => None,
        }
    }

    /// Putting a thing to a point: it is on the surface, in the container or in the room, within reach, and on a surface
    /// no other thing stands there. Boxes tell no more: whether the thing has room and would rest there is found out by bodies.
    fn putting_at(&self, point: AimPoint) -> Option<Refusal> {
        let (graph, plan) = (self.graph, point.plan());
        let elsewhere = |at: NodeId| Refusal::PointElsewhere { point, at: graph.label(at) };
        let beside = match self.action.target {
            Some(at) => (!graph.node(at)?.has_in_plan(&plan).unwrap_or(true)).then_some(at),
            None => graph.room_of(self.agent).filter(|room| is_outside(graph, *room, &plan)),
        };
        let distance = graph.node(self.agent).and_then(Node::position).map(|feet| (feet.xy() - plan).norm());
        let far = distance.filter(|distance| *distance > NEAR);
        let out_of_reach = || far.map(|distance| Refusal::PointOutOfReach { point, distance });
        let taken = || self.standing_there(&point).map(|by| Refusal::PointTaken { point, by });
        beside.map(elsewhere).or_else(out_of_reach).or_else(taken)
    }

    /// Another thing on the target that stands at a point as far as boxes tell: the middle half of its box is there, on each
    /// level of the target that is below the point.
    fn standing_there(&self, point: &AimPoint) -> Option<Label> {
        let target = self.graph.node(self.action.target?)?;
        let slot = self.action.aim.part();
        let others = self.graph.relating(Relation::On, target.id()).filter(|id| Some(*id) != self.action.object);
        let nodes: Vec<&Node> = others.filter_map(|id| self.graph.node(id)).collect();
        let there = |node: &&&Node| node.stands_at(&point.plan());
        if self.levels(target, Hold::On).is_none() {
            return nodes.iter().find(there).map(|node| node.label());
        }
        let heights = self.level_heights(target, point).filter(|_| slot.is_none())?;
        let on = |height: f32| {
            let stands = |node: &&&Node| node.aabb().is_some_and(|b| (b.min.z - height).abs() <= LEVEL);
            nodes.iter().filter(there).find(stands).map(|node| node.label())
        };
        let by: Vec<Label> = heights.into_iter().map(on).collect::<Option<_>>()?;
        by.into_iter().next()
    }

    /// The heights of the surfaces on a thing that are below a point, at the height that is asked for; `None` if some are
    /// not known, as they move.
    fn level_heights(&self, node: &Node, point: &AimPoint) -> Option<Vec<f32>> {
        let (asset, pose) = (self.graph.assets().get(node.spec().asset?)?, node.pose()?);
        let scale = node.spec().scale;
        let mut heights = Vec::new();
        for surface in asset.surfaces.iter().filter(|surface| surface.hold == Hold::On) {
            if surface.joint.is_some() {
                return None;
            }
            let centre = pose * Point3::from(surface.centre.coords.component_mul(&scale));
            let off = pose.rotation.inverse() * (Point3::new(point.plan().x, point.plan().y, centre.z) - centre);
            let is_over = off.x.abs() <= surface.half.0 * scale.x && off.y.abs() <= surface.half.1 * scale.y;
            let is_meant = point.height().is_none_or(|height| (height - centre.z).abs() <= LEVEL);
            if is_over && is_meant {
                heights.push(centre.z);
            }
        }
        Some(heights)
    }

    fn part(&self, part: AimPart) -> Option<Refusal> {
        let (word, number, at) = match part {
            AimPart::Seat(number) => (AimWord::Seat, number, self.action.object?),
            AimPart::Slot(number) => (AimWord::Slot, number, self.action.target?),
            AimPart::Side(_) => return None,
        };
        let node = self.graph.node(at)?;
        let has = match part {
            AimPart::Seat(_) => node.capacity(SlotKind::Seat),
            _ => self.slots(node)?,
        };
        let within = (1..=has).contains(&u32::from(number));
        (!within).then(|| Refusal::NoSuchPart { thing: node.label(), part: word, number, has })
    }

    /// The number of level surfaces in or on a thing, to which the action puts another, if its shape is known.
    fn slots(&self, node: &Node) -> Option<u32> {
        let goes_in = |effect: &Effect<NodeId>| matches!(effect, Effect::PutInto(_, at) if *at == node.id());
        let inside = effects(self.graph.vocabulary(), self.action).iter().any(goes_in);
        self.levels(node, if inside { Hold::Inside } else { Hold::On })
    }

    /// The number of level surfaces of a kind, if the shape of the thing is known.
    fn levels(&self, node: &Node, hold: Hold) -> Option<u32> {
        let asset = self.graph.assets().get(node.spec().asset?)?;
        u32::try_from(asset.surfaces.iter().filter(|s| s.hold == hold).count()).ok()
    }
}

/// The room in whose extent a point is deepest; if its height is stated, of those on the nearest storey.
pub(super) fn room_at(graph: &SceneGraph, point: &AimPoint) -> Option<NodeId> {
    let plan = point.plan();
    let within = |room: NodeId| {
        let all = extents(graph, room).into_iter().filter_map(|node| Some((depth(node, &plan)?, level(node)?)));
        all.filter(|(depth, _)| *depth >= 0.0).map(move |(depth, level)| (room, depth, level)).collect::<Vec<_>>()
    };
    let found: Vec<(NodeId, f32, f32)> = graph.rooms().iter().flat_map(|room| within(*room)).collect();
    let storey = point.height().and_then(|height| nearest(height, found.iter().map(|(.., level)| *level)));
    let is_on_it = |level: f32| storey.is_none_or(|storey| (level - storey).abs() < STOREY);
    let here = found.into_iter().filter(|(.., level)| is_on_it(*level));
    here.reduce(|best, next| if next.1 > best.1 { next } else { best }).map(|(room, ..)| room)
}

fn nearest(height: f32, levels: impl Iterator<Item = f32>) -> Option<f32> {
    levels.min_by(|a, b| (a - height).abs().total_cmp(&(b - height).abs()))
}

/// The height of a room's floor below a point, metres.
pub(super) fn floor_at(graph: &SceneGraph, room: NodeId, plan: &Point2<f32>) -> Option<f32> {
    extents(graph, room).into_iter().filter(|node| node.has_in_plan(plan) == Some(true)).find_map(level)
}

/// The height of the floor of an extent of a room: the top of a floor, or the base of the room itself, metres.
fn level(extent: &Node) -> Option<f32> {
    let aabb = extent.aabb()?;
    Some(if extent.kind() == NodeKind::Room { aabb.min.z } else { aabb.max.z })
}

/// Whether a point is known to be outside a room.
fn is_outside(graph: &SceneGraph, room: NodeId, plan: &Point2<f32>) -> bool {
    let extents = extents(graph, room);
    !extents.is_empty() && !extents.into_iter().any(|node| node.has_in_plan(plan) == Some(true))
}

/// The nodes whose boxes a room extends over: its floors, or itself.
fn extents(graph: &SceneGraph, room: NodeId) -> Vec<&Node> {
    let known = |node: &&Node| node.aabb().is_some();
    let floors = graph.in_room(room).filter_map(|id| graph.node(id)).filter(|node| node.role() == ObjectRole::Floor);
    let floors: Vec<&Node> = floors.filter(known).collect();
    if floors.is_empty() { graph.node(room).into_iter().filter(known).collect() } else { floors }
}

/// How deep a point is within a node's box in plan, metres; negative outside.
fn depth(node: &Node, plan: &Point2<f32>) -> Option<f32> {
    let aabb = node.aabb()?;
    Some((0..2).map(|i| (plan[i] - aabb.min[i]).min(aabb.max[i] - plan[i])).fold(f32::INFINITY, f32::min))
}

fn distance(node: &Node, plan: &Point2<f32>) -> Option<f32> {
    let at = Point3::new(plan.x, plan.y, node.position()?.z);
    let nearest = node.aabb().map_or_else(|| node.position(), |aabb| Some(aabb.nearest(&at)))?;
    Some((nearest - at).xy().norm())
}

impl Node {
    /// Whether a point is within the node's box in plan, also if it is turned; `None` if the box is not known.
    fn has_in_plan(&self, plan: &Point2<f32>) -> Option<bool> {
        let (own, half) = self.in_plan(plan)?;
        Some(own.x.abs() <= half.x + BESIDE && own.y.abs() <= half.y + BESIDE)
    }

    /// Whether the middle half of the node's box is at a point, and it is no sheet.
    fn stands_at(&self, plan: &Point2<f32>) -> bool {
        let middle = |(own, half): (Vector3<f32>, Vector3<f32>)| {
            own.x.abs() <= half.x / 2.0 && own.y.abs() <= half.y / 2.0 && half.z >= SHEET
        };
        self.in_plan(plan).is_some_and(middle)
    }

    /// A point in plan from the middle of the node's box, and half of the box's size, along its own axes.
    fn in_plan(&self, plan: &Point2<f32>) -> Option<(Vector3<f32>, Vector3<f32>)> {
        let (bounds, pose) = (self.spec().bounds?, self.pose()?);
        let at = Point3::new(plan.x, plan.y, pose.translation.z);
        let own = match bounds.frame {
            BoundsFrame::Object => pose.inverse_transform_point(&at).coords,
            BoundsFrame::World => at.coords - pose.translation.vector,
        } - bounds.offset;
        Some((own, bounds.half))
    }
}
