//! A scene at one moment.

use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

use vc_graph::asset::Joint;
use vc_graph::{Aabb, Node, NodeId, NodeKind, ObjectRole, Pose, Property, SceneGraph, State};

use super::body::{Gives, Poured, Stands, Tied};
use super::classes::Classes;
use super::cover::{Around, hang};
use super::{Body, Instance, NO_ROOM, Store, liquid};
use crate::RenderError;
use crate::math::{Affine, Ball};
use crate::mesh::Link;
use crate::surface::Coat;

/// Everything visible in a scene at one moment: the meshes and their poses, and which lamps are on.
///
/// A snapshot is made by [`Renderer::snapshot`](crate::Renderer::snapshot) and is cheap to clone. Optical flow
/// takes a clone whose bodies were moved as the moment before or after. A snapshot keeps no link to the graph.
///
/// ```
/// # use nalgebra::{Point3, Vector3};
/// # use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
/// use vc_render::{Camera, Frame, Modality, Renderer, Shot};
/// # let mut scene = SceneBuilder::new("flat");
/// # let kitchen = scene.add(Draft::new("kitchen"))?;
/// # let size = Bounds::standing(Vector3::new(0.6, 0.6, 1.8));
/// # let fridge = scene.add_in(kitchen, Draft::new("fridge").at(Pose::translation(2.0, 0.0, 0.0)).bounds(size))?;
/// # let scene = scene.build();
/// # let mut renderer = Renderer::new();
/// # let camera = Camera::with_fov(64, 48, 1.0).looking(Point3::new(0.0, 0.0, 1.0), Point3::new(2.0, 0.0, 1.0));
/// let snapshot = renderer.snapshot(&scene)?;
/// assert_eq!(snapshot.nodes().collect::<Vec<_>>(), [fridge]);
///
/// let mut frame = Frame::new();
/// renderer.render(&Shot::new(&snapshot, &camera, Modality::Class | Modality::Depth), &mut frame)?;
/// let middle = 24 * 64 + 32;
/// assert_eq!(snapshot.class(frame.class[middle]), scene.node(fridge).map(|node| node.class()));
///
/// // Moves a body in a clone: the graph and the first snapshot stay as they are.
/// let mut moved = snapshot.clone();
/// moved.place(fridge, &Pose::translation(2.5, 0.0, 0.0))?;
/// renderer.render(&Shot::new(&moved, &camera, Modality::Depth), &mut frame)?;
/// assert!((frame.depth[middle] - 2.2).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Snapshot {
    pub(crate) bodies: Vec<Body>,
    pub(crate) instances: Vec<Instance>,
    pub(super) classes: Arc<Classes>,
    pub(crate) rooms: Arc<Vec<NodeId>>,
    /// Boxes around rooms, where the graph has them.
    pub(crate) bounds: Arc<Vec<Option<Aabb>>>,
    /// Rooms of which only the outside is drawn, by their places in the list of rooms.
    pub(super) closed: Arc<BTreeSet<usize>>,
    /// Whether it is of several scenes.
    pub(crate) is_joined: bool,
    pub(super) by_node: Arc<HashMap<NodeId, u32>>,
    /// Identity of the store that holds its meshes.
    pub(super) store: Arc<()>,
}

impl Snapshot {
    /// Takes all nodes of a graph that have a pose and a shape or box. `joint` gives the position of a node's
    /// joint, where the caller knows it.
    pub(crate) fn new(
        store: &mut Store,
        graph: &SceneGraph,
        joint: &mut dyn FnMut(NodeId, &Joint) -> Option<f32>,
    ) -> Result<Self, RenderError> {
        let rooms = graph.rooms().iter().copied().zip(0..NO_ROOM).collect();
        let (bodies, instances) = (Vec::new(), Vec::new());
        let classes = Classes::new(graph)?;
        let mut taken = Taken { store, graph, joint, classes, rooms, bodies, instances, around: Around::default() };
        graph.nodes().filter(|n| n.kind() != NodeKind::Room).try_for_each(|node| taken.add(node))?;
        Ok(taken.snapshot())
    }

    /// Whether its meshes are in a store.
    pub(crate) fn is_in(&self, store: &Store) -> bool {
        Arc::ptr_eq(&self.store, &store.name)
    }

    /// Checks that another snapshot is a moment of the same scene: the same nodes in the same order, with as
    /// many meshes each. Costs next to nothing if one is a clone of the other, otherwise a nanosecond for each
    /// node.
    pub(crate) fn with(&self, what: &'static str, other: &Self) -> Result<(), RenderError> {
        let like = |(a, b): (&Body, &Body)| a.node == b.node && a.instances == b.instances;
        let same = || self.bodies.len() == other.bodies.len() && self.bodies.iter().zip(&other.bodies).all(like);
        if Arc::ptr_eq(&self.store, &other.store) && (Arc::ptr_eq(&self.by_node, &other.by_node) || same()) {
            return Ok(());
        }
        Err(RenderError::OtherScene { what, here: self.instances.len(), there: other.instances.len() })
    }

    /// Whether only the outside of a room is drawn, by its place in the list of rooms.
    pub(crate) fn is_closed(&self, room: usize) -> bool {
        self.closed.contains(&room)
    }

    /// Whether all bodies and their parts have the same poses as at another moment of the same scene.
    pub(crate) fn stands_as(&self, other: &Self) -> bool {
        let (own, others) = (&self.instances, &other.instances);
        own.len() == others.len() && own.iter().zip(others).all(|(a, b)| a.world == b.world)
    }

    /// The class of a number in [`Frame::class`](crate::Frame::class); `None` if no class has this number. A
    /// class has the same number in all scenes with the same class table.
    pub fn class(&self, number: u16) -> Option<&Arc<str>> {
        self.classes.named(number).map(|(name, _)| name)
    }

    /// The category of a class number, such as `furniture`, as in [`Node::spec`](vc_graph::Node::spec).
    pub fn category(&self, number: u16) -> Option<&Arc<str>> {
        self.classes.named(number).map(|(_, category)| category)
    }

    /// Nodes that have a body, in order.
    pub fn nodes(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.bodies.iter().map(|b| b.node)
    }

    /// Nodes that light rooms when they are on, in order: their role is that of a lamp. Other things, such as candles
    /// and screens, may glow too.
    pub fn lamps(&self) -> impl Iterator<Item = NodeId> + '_ {
        self.bodies.iter().filter(|b| b.role == ObjectRole::Light).map(|b| b.node)
    }

    /// Number of visible triangles at the finest level of detail. Costs a step for each mesh.
    pub fn triangles(&self) -> usize {
        let seen = self.instances.iter().filter(|i| i.is_there());
        seen.map(|i| i.link.levels[0].len()).sum()
    }

    pub(super) fn body(&self, node: NodeId) -> Result<usize, RenderError> {
        self.by_node.get(&node).map(|&i| i as usize).ok_or(RenderError::NoBody(node))
    }

    /// The body of a node, if it has one.
    pub(crate) fn body_of(&self, node: NodeId) -> Option<&Body> {
        self.body(node).ok().map(|i| &self.bodies[i])
    }
}

/// A snapshot in the making: the bodies taken so far.
struct Taken<'a> {
    store: &'a mut Store,
    graph: &'a SceneGraph,
    joint: &'a mut dyn FnMut(NodeId, &Joint) -> Option<f32>,
    classes: Classes,
    rooms: HashMap<NodeId, u16>,
    bodies: Vec<Body>,
    instances: Vec<Instance>,
    around: Around,
}

impl Taken<'_> {
    /// Adds the body of a node, if it has a pose.
    fn add(&mut self, node: &Node) -> Result<(), RenderError> {
        let Some(pose) = node.pose() else { return Ok(()) };
        let links = links(self.store, self.graph, node)?;
        let (first, number) = (self.instances.len() as u32, self.bodies.len() as u32);
        let room = self.graph.room_of(node.id()).and_then(|r| self.rooms.get(&r).copied()).unwrap_or(NO_ROOM);
        let scale = if node.spec().asset.is_some() { node.spec().scale } else { nalgebra::Vector3::repeat(1.0) };
        if !Affine::placed(pose, &scale).is_finite() {
            return Err(RenderError::BadPose(node.id()));
        }
        for piece in links {
            self.instances.extend(instance(piece, number, node, (pose, &scale), self.joint));
        }
        let mut body = Body {
            node: node.id(),
            class: self.classes.number(node.class()),
            room,
            role: node.role(),
            stands: Stands::from_role(node.role()),
            gives: gives(self.graph, node),
            lit: self.graph.is_lit(node.id()),
            pose: *pose,
            scale,
            instances: first..self.instances.len() as u32,
            bounds: Default::default(),
        };
        body.bounds = body.measured(&self.instances[first as usize..]);
        self.note(node);
        self.bodies.push(body);
        Ok(())
    }

    /// Notes whether the next body is a window cover, an opening, or a thing that may stand before one.
    fn note(&mut self, node: &Node) {
        let (number, around) = (self.bodies.len(), &mut self.around);
        if self.graph.covers_windows(node.id()) {
            around.covers.push((number, node.is(State::Closed)));
        } else if matches!(node.role(), ObjectRole::Door | ObjectRole::Window) {
            around.openings.push(number);
        } else if node.kind() == NodeKind::Object && !node.affords(Property::Graspable) {
            around.standing.push(number);
        }
    }

    /// Hangs the window covers; the whole.
    fn snapshot(self) -> Snapshot {
        let Self { store, graph, classes, mut bodies, mut instances, around, .. } = self;
        hang((&mut bodies, &mut instances), &around);
        let by_node = bodies.iter().zip(0..).map(|(b, i)| (b.node, i)).collect();
        let (classes, rooms) = (Arc::new(classes), Arc::new(graph.rooms().to_vec()));
        let bounds = Arc::new(rooms.iter().map(|room| graph.node(*room)?.aabb()).collect());
        let (closed, is_joined, by_node, store) = (Arc::default(), false, Arc::new(by_node), store.name.clone());
        Snapshot { bodies, instances, classes, rooms, bounds, closed, is_joined, by_node, store }
    }
}

fn gives(graph: &SceneGraph, node: &Node) -> Gives {
    match node.role() {
        ObjectRole::Light => Gives::Lamplight,
        _ if graph.classes().is_a(node.class(), "candle") => Gives::Candlelight,
        _ => Gives::Glow,
    }
}

/// A link, and the conditions under which it is there: for liquids, and for curtains tied or untied.
struct Piece {
    link: Arc<Link>,
    liquid: Option<Poured>,
    tied: Option<Tied>,
}

impl Piece {
    fn new(link: Arc<Link>) -> Self {
        Self { link, liquid: None, tied: None }
    }
}

/// The links of a node, including the liquid that it can hold and its untied form.
fn links(store: &mut Store, graph: &SceneGraph, node: &Node) -> Result<Vec<Piece>, RenderError> {
    let solid = |links: Vec<Arc<Link>>| links.into_iter().map(Piece::new).collect::<Vec<Piece>>();
    let Some(id) = node.spec().asset else { return Ok(solid(store.stand_in(node.spec())?)) };
    let missing = RenderError::NoSuchAsset { node: node.id(), asset: id.0 };
    let asset = graph.assets().get(id).ok_or(missing)?;
    let cover = graph.covers_windows(node.id());
    let mut all = solid(store.links(graph.assets(), asset, cover)?);
    if node.affords(Property::Recipient) {
        let poured = |bottom| Poured { there: node.contents().is_some(), bottom };
        let liquid = store.liquid(graph.assets(), asset)?;
        all.extend(liquid.map(|(link, bottom)| Piece { liquid: Some(poured(bottom)), ..Piece::new(link) }));
    }
    let untied = if cover { store.untied(graph.assets(), asset)? } else { None };
    if let Some((link, [band, cloth])) = untied {
        all.iter_mut().for_each(|piece| piece.tied = Some(Tied { drawn: false, hidden: cloth }));
        all.push(Piece { tied: Some(Tied { drawn: true, hidden: band }), ..Piece::new(link) });
    }
    Ok(all)
}

/// The instance of a link; none if its scale leaves it no volume.
fn instance(
    Piece { link, liquid, tied }: Piece,
    body: u32,
    node: &Node,
    (pose, scale): (&Pose, &nalgebra::Vector3<f32>),
    joint: &mut dyn FnMut(NodeId, &Joint) -> Option<f32>,
) -> Option<Instance> {
    let position = link.joint.map_or(0.0, |j| {
        let given = joint(node.id(), &j).filter(|p| p.is_finite());
        given.unwrap_or_else(|| if node.is(State::Open) { opened(&j) } else { closed(&j) })
    });
    let (world, inverse) = (Affine::IDENTITY, [[0.0; 4]; 3]);
    let coat = match (liquid, node.contents()) {
        (None, _) => Coat::from_node(node),
        (Some(_), contents) => contents.map_or(Coat::NONE, |class| liquid::coat(class)),
    };
    let mut instance = Instance {
        link,
        body,
        joint: position,
        world,
        inverse,
        ball: Ball::default(),
        mirrored: false,
        ground: None,
        coat,
        liquid,
        drawn: None,
        tied,
        hidden: false,
    };
    (instance.put(pose, scale) && instance.world.is_finite()).then_some(instance)
}

/// The position of an open joint: the limit farther from zero.
fn opened(joint: &Joint) -> f32 {
    let (low, high) = joint.limits;
    if high >= -low { high } else { low }
}

/// The position of a closed joint: zero, or the limit nearest to it.
fn closed(joint: &Joint) -> f32 {
    let (low, high) = joint.limits;
    0.0_f32.max(low).min(high)
}
