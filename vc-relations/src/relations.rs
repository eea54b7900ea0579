//! The relations of a scene.

use std::sync::Arc;

use nalgebra::Point3;
use vc_graph::{Edge, NodeId, Relation, SceneGraph};

use crate::edges::Reader;
use crate::error::{InputError, InputFlaw, check_assets, check_evidence, check_scene};
use crate::evidence::Evidence;
use crate::facts::Facts;
use crate::near::NearSide;
use crate::pair::Tolerance;
use crate::rule::RelationRule;
use crate::support::{Support, Supports};
use crate::threshold::{BOX_GAP, SUPPORT_GAP};
use crate::world::World;
use crate::{box_trace, virtual_home};

/// A thing near another.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Near {
    /// The nearby thing.
    pub to: NodeId,
    /// Distance between the two boxes, metres; zero if they overlap.
    pub distance: f32,
    /// The side of the queried thing at which it is; none if above, below or around.
    pub side: Option<NearSide>,
}

/// All relations of a scene, read from its poses and shapes.
///
/// ```
/// use vc_graph::{Bounds, Draft, Edge, Pose, Relation, SceneBuilder};
/// use vc_relations::{Evidence, Relations, RelationRule};
/// let mut scene = SceneBuilder::new("corner");
/// let size = |x, y, z| Bounds::standing(nalgebra::Vector3::new(x, y, z));
/// let table = scene.add(Draft::new("table").bounds(size(0.8, 1.2, 0.75)).at(Pose::identity()))?;
/// let cup = Draft::new("cup").bounds(size(0.08, 0.08, 0.1)).at(Pose::translation(0.1, 0.2, 0.751));
/// let cup = scene.add(cup)?;
/// let mut graph = scene.build();
///
/// let mut relations = Relations::new(&graph, RelationRule::Contacts, Evidence::default())?;
/// assert!(relations.has(Edge::new(cup, Relation::On, table)));
///
/// let mut edit = graph.edit();
/// edit.set_pose(cup, Some(Pose::translation(0.7, 0.2, 0.0)))?;
/// edit.commit();
/// relations.update(&graph, &[cup])?;
/// assert!(!relations.has(Edge::new(cup, Relation::On, table)));
/// assert!(relations.has(Edge::new(table, Relation::NearFront, cup)));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone)]
pub struct Relations {
    pub(crate) rule: RelationRule,
    pub(crate) world: World,
    pub(crate) evidence: Evidence,
    pub(crate) facts: Facts,
    /// The edges by the other rules, sorted; those by [`RelationRule::Contacts`] are read on request.
    fixed: Arc<Vec<Edge>>,
}

impl Relations {
    /// Reads all relations. Costs one to two milliseconds for five hundred objects, and some hundred
    /// microseconds for each asset that does not declare its hollows.
    ///
    /// # Errors
    /// [`InputError`] with every number that is not finite, too large, or not a valid size or rotation.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// use vc_relations::{Evidence, RelationRule, Relations};
    /// let relations = Relations::new(&home.graph, RelationRule::Contacts, Evidence::default())?;
    ///
    /// assert!(relations.supports(home.cup).iter().any(|support| support.by == home.table));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(graph: &SceneGraph, rule: RelationRule, evidence: Evidence) -> Result<Self, InputError> {
        Self::with_tolerance(graph, rule, evidence, SUPPORT_GAP)
    }

    /// As [`Self::new`], with another distance down to a support up to which a thing is on it, metres, instead of
    /// [`SUPPORT_GAP`]: 0 to [`BOX_GAP`]. Where only a box is known of one of the two it stays [`BOX_GAP`]; only
    /// [`RelationRule::Contacts`] asks for it.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut graph = home.graph.clone();
    /// use vc_graph::Pose;
    /// use vc_relations::{Evidence, RelationRule, Relations};
    /// # let higher = Pose::translation(0.0, 0.0, 0.01) * graph.node(home.cup).and_then(|n| n.pose()).ok_or("no pose")?;
    /// # let mut edit = graph.edit();
    /// # edit.set_pose(home.cup, Some(higher))?;
    /// # edit.commit();
    /// // The cup is a centimetre above the table.
    /// let on_table = |tolerance: f32| {
    ///     let read = Relations::with_tolerance(&graph, RelationRule::Contacts, Evidence::default(), tolerance);
    ///     read.map(|relations| relations.supports(home.cup).iter().any(|support| support.by == home.table))
    /// };
    /// assert!(on_table(0.02)? && !on_table(0.005)?);
    /// assert!(on_table(f32::NAN).is_err());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`Self::new`], and a tolerance out of range.
    pub fn with_tolerance(
        graph: &SceneGraph,
        rule: RelationRule,
        evidence: Evidence,
        tolerance: f32,
    ) -> Result<Self, InputError> {
        if !(0.0..=BOX_GAP).contains(&tolerance) {
            return Err(InputError { flaws: vec![InputFlaw::Tolerance(tolerance)] });
        }
        check_evidence(graph, &evidence)?;
        let world = World::with(Tolerance(tolerance));
        let mut relations = Self { rule, world, facts: Facts::default(), evidence, fixed: Arc::default() };
        relations.rebuild(graph)?;
        Ok(relations)
    }

    /// The rule by which relations are read.
    pub fn rule(&self) -> RelationRule {
        self.rule
    }

    /// The distance down to a support up to which a thing is on it, metres.
    pub fn tolerance(&self) -> f32 {
        self.world.tolerance.0
    }

    /// The evidence that the caller has given beside the geometry.
    pub fn evidence(&self) -> &Evidence {
        &self.evidence
    }

    /// The room of a point, metres: the one whose floors it is above; in a doorway, and within the thickness of
    /// a wall, the nearest.
    ///
    /// ```
    /// use vc_graph::{Bounds, Draft, Pose, SceneBuilder};
    /// use vc_relations::{Evidence, Relations, RelationRule};
    /// let mut scene = SceneBuilder::new("flat");
    /// let size = Bounds::standing([4.0, 3.0, 2.5].into());
    /// let hall = scene.add(Draft::new("hallway").bounds(size).at(Pose::identity()))?;
    /// let relations = Relations::new(&scene.build(), RelationRule::Contacts, Evidence::default())?;
    /// assert_eq!(relations.room_at(&[1.0, 1.0, 1.0].into()), Some(hall));
    /// assert_eq!(relations.room_at(&[9.0, 1.0, 1.0].into()), None);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn room_at(&self, point: &Point3<f32>) -> Option<NodeId> {
        self.world.rooms.at(&point.coords)
    }

    /// Reads everything anew; the computed forms of assets are kept.
    ///
    /// # Errors
    /// [`InputError`] as for [`Self::new`]; nothing is changed then.
    pub fn rebuild(&mut self, graph: &SceneGraph) -> Result<(), InputError> {
        check_scene(graph)?;
        if !self.world.knows(graph.assets()) {
            check_assets(graph.assets())?;
        }
        self.facts = Facts::from_scene(graph, &self.evidence);
        self.world.rebuild(graph, &self.evidence);
        self.fixed = Arc::new(match self.rule {
            RelationRule::Contacts => Vec::new(),
            RelationRule::BoxTrace => box_trace::edges(&self.world),
            RelationRule::VirtualHome => virtual_home::edges(graph),
        });
        Ok(())
    }

    /// All relations, sorted by start, kind and end; symmetric ones occur in both directions.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let relations = vc_relations::Relations::new(&home.graph, Default::default(), Default::default())?;
    /// use vc_graph::Relation;
    /// let on: Vec<_> = relations.edges().into_iter().filter(|edge| edge.relation == Relation::On).collect();
    /// assert!(on.iter().any(|edge| (edge.from, edge.to) == (home.cup, home.table)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn edges(&self) -> Vec<Edge> {
        if self.rule != RelationRule::Contacts {
            return self.fixed.to_vec();
        }
        let reader = Reader::for_all(&self.world, &self.facts);
        let mut edges = Vec::with_capacity(32 * self.world.ids.len());
        for index in 0..self.world.ids.len() {
            reader.edges(index, &mut edges);
        }
        edges
    }

    /// All relations that start at a node, sorted.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let relations = vc_relations::Relations::new(&home.graph, Default::default(), Default::default())?;
    /// use vc_graph::{Edge, Relation};
    /// let edges = relations.edges_of(home.cup);
    /// assert!(edges.contains(&Edge::new(home.cup, Relation::On, home.table)));
    /// assert!(edges.contains(&Edge::new(home.cup, Relation::InRoom, home.room)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn edges_of(&self, id: NodeId) -> Vec<Edge> {
        let mut edges = Vec::new();
        if self.rule != RelationRule::Contacts {
            let from = self.fixed.partition_point(|e| e.from < id);
            edges.extend(self.fixed[from..].iter().take_while(|e| e.from == id));
        } else if let Some(index) = self.world.index(id) {
            Reader::new(&self.world, &self.facts).edges(index, &mut edges);
        }
        edges
    }

    /// All relations that start at some nodes, as given by [`Self::edges_of`]. If these are most of a scene, all
    /// supports are found in one pass.
    pub(crate) fn edges_of_each(&self, nodes: &[NodeId]) -> Vec<(NodeId, Vec<Edge>)> {
        if self.rule != RelationRule::Contacts {
            return nodes.iter().map(|&id| (id, self.edges_of(id))).collect();
        }
        let most = 2 * nodes.len() > self.world.ids.len();
        let of = if most { Reader::for_all } else { Reader::new };
        let reader = of(&self.world, &self.facts);
        let edges = |id: NodeId| {
            let mut edges = Vec::new();
            if let Some(index) = self.world.index(id) {
                reader.edges(index, &mut edges);
            }
            edges
        };
        nodes.iter().map(|&id| (id, edges(id))).collect()
    }

    /// Whether a relation holds.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let relations = vc_relations::Relations::new(&home.graph, Default::default(), Default::default())?;
    /// use vc_graph::{Edge, Relation};
    /// assert!(relations.has(Edge::new(home.cup, Relation::On, home.table)));
    /// assert!(!relations.has(Edge::new(home.cup, Relation::Inside, home.cabinet)));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn has(&self, edge: Edge) -> bool {
        self.edges_of(edge.from).binary_search(&edge).is_ok()
    }

    /// The relations that hold from one node to another.
    pub fn between(&self, from: NodeId, to: NodeId) -> Vec<Relation> {
        self.edges_of(from).into_iter().filter(|e| e.to == to).map(|e| e.relation).collect()
    }

    /// The supports of a thing and how they are known, also if the relation is inside, sitting or lying; empty
    /// for things that fall and for unknown nodes. By [`RelationRule::Contacts`], whichever rule is selected.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let relations = vc_relations::Relations::new(&home.graph, Default::default(), Default::default())?;
    /// let supports = relations.supports(home.cup);
    /// assert_eq!((supports.len(), supports[0].by, supports[0].kind), (1, home.table, vc_relations::SupportKind::Trace));
    /// assert!((supports[0].gap - 0.001).abs() < 1e-4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn supports(&self, id: NodeId) -> Vec<Support> {
        let supports = Supports::new(&self.world, &self.facts);
        self.world.index(id).map_or_else(Vec::new, |index| supports.of(index))
    }

    /// The things near a thing, by number. By [`RelationRule::Contacts`], whichever rule is selected.
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let relations = vc_relations::Relations::new(&home.graph, Default::default(), Default::default())?;
    /// let near = relations.near(home.person);
    /// let table = near.iter().find(|near| near.to == home.table).ok_or("too far")?;
    /// assert_eq!(table.side, Some(vc_relations::NearSide::Front));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn near(&self, id: NodeId) -> Vec<Near> {
        let pairs = self.world.index(id).map_or(&[][..], |index| &self.world.pairs[index]);
        let near = pairs.iter().filter(|p| p.distance.is_finite());
        near.map(|p| Near { to: self.world.ids[p.other as usize], distance: p.distance, side: p.side }).collect()
    }
}

/// The relations of a scene by the default rule, from geometry alone.
///
/// # Errors
/// [`InputError`] as for [`Relations::new`].
///
/// ```
/// let empty = vc_graph::SceneBuilder::new("nothing").build();
/// assert!(vc_relations::relations(&empty)?.is_empty());
/// # Ok::<(), vc_relations::InputError>(())
/// ```
pub fn relations(graph: &SceneGraph) -> Result<Vec<Edge>, InputError> {
    Ok(Relations::new(graph, RelationRule::Contacts, Evidence::default())?.edges())
}
