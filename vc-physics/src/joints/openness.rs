//! Opening and closing at once, where nothing is in the way.

use vc_graph::NodeId;
use vc_graph::asset::JointKind;

use super::motion::fraction;
use super::travel::POSITIONS;
use crate::displaced::{Displaced, NONE};
use crate::world::PhysicsWorld;
use crate::{PhysicsError, convert};

/// Smallest share of its range that a part opens if it cannot open completely.
const HALF: f32 = 0.5;
/// The vertical part of an axis from which on a door swings to the side, and the share of its way from which on one that
/// folds down is out of the way of the racks behind it.
const UPRIGHT: f32 = 0.7;
const DOWN: f32 = 0.995;

/// # Opening at once
impl PhysicsWorld {
    /// Opens or closes every part of a node at once, with the contents of drawers, where neither loose things
    /// nor agents are in the way; returns whether it did. Nodes in `ignored` are no obstacles: an agent that opens a door
    /// gives way to it. The parts then end where [`drive`](Self::drive) takes
    /// them, except in two cases in which `drive` would press a part against things: a part that cannot open
    /// completely, because its contents would hit a wall, opens as far as possible if that is at least half of
    /// the range; a drawer that cannot open stays closed if others open, and racks behind a door that is not folded down
    /// completely stay as they are.
    ///
    /// Doors and lids open before drawers, whose contents would be in their way, and close after them. Where it returns
    /// false, the parts that came before the one that is stuck have moved; [`PartsView::plan`](crate::PartsView::plan)
    /// asks first.
    ///
    /// Costs some ten microseconds for each part.
    ///
    /// # Errors
    /// As [`Self::drive`].
    ///
    /// ```
    /// # let home = vc_testkit::kitchen::kitchen();
    /// # let mut world = vc_physics::PhysicsWorld::build(&home.graph, &Default::default(), Default::default())?;
    /// assert!(world.set_openness(home.cabinet, 1.0, &[])?);
    /// assert!(world.parts(home.cabinet).openness().is_some_and(|open| open > 0.99));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_openness(&mut self, id: NodeId, open: f32, ignored: &[NodeId]) -> Result<bool, PhysicsError> {
        let mut plan = Plan::new(self, id, open, ignored);
        let goes = plan.all()?;
        let moves = plan.moves;
        moves.into_iter().try_for_each(|(part, open)| self.put_part(id, part, open))?;
        Ok(goes)
    }

    /// The openness that [`set_openness`](Self::set_openness) would give each part of a node, 0 to 1.
    pub(crate) fn plan_openness(
        &self,
        id: NodeId,
        open: f32,
        ignored: &[NodeId],
    ) -> Result<Option<Vec<f32>>, PhysicsError> {
        let mut plan = Plan::new(self, id, open, ignored);
        let goes = plan.all()?;
        let mut openness: Vec<f32> = self.moving_parts(id).iter().map(|part| part.open).collect();
        for &(part, open) in &plan.moves {
            openness[part] = open;
        }
        Ok(goes.then_some(openness))
    }

    /// Whether a part meets no obstacle on its way to a fraction of its range.
    pub(crate) fn is_free_way(&self, id: NodeId, part: usize, open: f32) -> bool {
        self.way(id, part, open).is_ok_and(|way| self.free_share(self.sweep((id, part), way, &[], &NONE)) == 1.0)
    }

    /// The present position of a part, and its position at a fraction of its range.
    fn way(&self, id: NodeId, part: usize, open: f32) -> Result<(f32, f32), PhysicsError> {
        let target = self.target(id, part, open)?;
        Ok((self.part_position(self.thing(id)?, part).unwrap_or(target), target))
    }

    /// The nodes that block the parts of a node on the way to a fraction of their range, sorted by number.
    pub(crate) fn blockers(&self, id: NodeId, open: f32) -> Result<Vec<NodeId>, PhysicsError> {
        let mut hits = Vec::new();
        for part in 0..self.thing(id)?.state.moving.len() {
            let way = self.way(id, part, open)?;
            let Some(sweep) = self.sweep((id, part), way, &[], &NONE) else { continue };
            let first = (1..=POSITIONS).map(|step| self.obstacles(&sweep, step)).find(|hits| !hits.is_empty());
            hits.extend(first.unwrap_or_default());
        }
        hits.sort_unstable();
        hits.dedup();
        Ok(hits)
    }
}

/// The motions of a node's parts, one after the other, as they are planned.
struct Plan<'w> {
    world: &'w PhysicsWorld,
    id: NodeId,
    open: f32,
    /// Nodes that are no obstacles.
    ignored: &'w [NodeId],
    /// The parts that move, and how far, 0 to 1.
    moves: Vec<(usize, f32)>,
    /// The things that have moved along by then.
    moved: Displaced,
}

impl<'w> Plan<'w> {
    fn new(world: &'w PhysicsWorld, id: NodeId, open: f32, ignored: &'w [NodeId]) -> Self {
        Self { world, id, open, ignored, moves: Vec::new(), moved: Displaced::default() }
    }

    /// Plans the motion of every part; whether the node then is as open as it was to be.
    fn all(&mut self) -> Result<bool, PhysicsError> {
        let thing = self.world.thing(self.id)?;
        let slides = |part: &usize| thing.form.links[part + 1].joint.is_some_and(|j| j.kind == JointKind::Slide);
        let parts = 0..thing.state.moving.len();
        parts.clone().try_for_each(|part| self.world.target(self.id, part, self.open).map(drop))?;
        let (drawers, doors): (Vec<usize>, Vec<usize>) = parts.partition(slides);
        if self.open == 0.0 {
            return Ok(self.each(drawers)? && self.each(doors)?);
        }
        if !self.each(doors)? {
            return Ok(false);
        }
        let folds = |part: usize| thing.form.links[part + 1].joint.is_some_and(|j| j.axis.z.abs() < UPRIGHT);
        if self.moves.iter().any(|&(part, open)| folds(part) && open < self.open * DOWN) {
            // The load of a rack would hit a door that is not folded down.
            return Ok(self.openness() >= HALF);
        }
        // A drawer that stays closed does not matter if another part is open.
        Ok(self.each(drawers)? || self.openness() >= HALF)
    }

    /// Plans the motion of some parts as far as they go, the freest first; whether all of them move.
    fn each(&mut self, mut parts: Vec<usize>) -> Result<bool, PhysicsError> {
        let least = if self.open > 0.0 { HALF } else { 1.0 };
        while let Some((at, share)) = self.freest(&parts)?.filter(|(_, share)| *share >= least) {
            let part = parts.remove(at);
            let (from, target) = self.world.way(self.id, part, self.open)?;
            let limits = self.world.thing(self.id)?.state.moving[part].limits;
            let reached = if share < 1.0 { fraction(limits, from + (target - from) * share) } else { self.open };
            self.note(part, reached)?;
        }
        Ok(parts.is_empty())
    }

    /// The first of some parts that can move completely, otherwise the one that gets farthest: its index among
    /// them, and the share of its way.
    fn freest(&self, parts: &[usize]) -> Result<Option<(usize, f32)>, PhysicsError> {
        let mut best: Option<(usize, f32)> = None;
        for (at, &part) in parts.iter().enumerate() {
            let way = self.world.way(self.id, part, self.open)?;
            let share = self.world.free_share(self.world.sweep((self.id, part), way, self.ignored, &self.moved));
            if best.is_none_or(|(_, most)| share > most) {
                best = Some((at, share));
            }
            if share == 1.0 {
                break;
            }
        }
        Ok(best)
    }

    /// Notes that a part moves, and with it the things that it carries, as by [`PhysicsWorld::put_open`].
    fn note(&mut self, part: usize, open: f32) -> Result<(), PhysicsError> {
        self.moves.push((part, open));
        let target = self.world.target(self.id, part, open)?;
        let thing = self.world.thing(self.id)?;
        let Some((before, after)) = self.world.poses_when_put(thing, part, target) else { return Ok(()) };
        let motion = after * before.inverse();
        for load in self.world.load_of_part_with(self.id, part, &self.moved) {
            let base = self.world.thing(load)?.state.base;
            let Some(now) = self.world.body_pose(base, &self.moved) else { continue };
            let then = convert::pose(&(motion * convert::isometry(&now)));
            // A body that is put where it is sleeps on.
            if then != now {
                self.moved.set(base, then);
            }
        }
        Ok(())
    }

    /// How open the most open part is after the motions so far.
    fn openness(&self) -> f32 {
        let Ok(thing) = self.world.thing(self.id) else { return 0.0 };
        let now = |part: usize| {
            let planned = self.moves.iter().find(|(moved, _)| *moved == part);
            let position = match planned {
                Some((_, open)) => self.world.position_when_put(thing, part, *open),
                None => self.world.part_position(thing, part),
            };
            Some(fraction(thing.form.links[part + 1].joint?.limits, position?))
        };
        (0..thing.state.moving.len()).filter_map(now).fold(0.0, f32::max)
    }
}
