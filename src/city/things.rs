//! Things that go through portals by themselves: that roll, fall, or are pushed from region to region.
//!
//! Each region has bodies of its own, and around it [stands](super::border) what is fixed beyond its portals. A thing goes
//! over to the region beyond where its middle is. Things that move together stay together until they rest or are a metre beyond: a
//! thing that is touched through a portal comes over to that which touches it, so that both are bodies of one world.

use std::collections::BTreeSet;

use nalgebra::{Point3, Vector3};
use vc_graph::space::{Portal, PortalSide, RegionId};
use vc_graph::{Aabb, NodeId, Pose};
use vc_physics::BodyRole;

use super::measures::{
    ASIDE, BEHIND, CREEPS, DEEPEST, EDGE, FALLS, FLUSH, LEDGE, NEAR, ON_LINE, OVER, TOGETHER, TOUCHING, WAKES,
};
use super::record::Order;
use super::{City, CityError};
use crate::Environment;

/// A portal as things of a region go through it.
pub(super) struct Gate {
    from: RegionId,
    into: RegionId,
    /// The sides of both regions, in the frame of the first.
    own: Pose,
    across: Pose,
    /// Takes poses of the first region to the other.
    shift: Pose,
    width: f32,
    /// How high above the threshold things go through it, metres.
    top: f32,
    leaf: Option<NodeId>,
    room: Option<NodeId>,
}

impl Gate {
    /// How far a point is over the line between both regions, metres, if it is behind this portal.
    pub(super) fn beyond(&self, at: &Point3<f32>) -> Option<f32> {
        let (out, back) = (self.own.inverse_transform_point(at), self.across.inverse_transform_point(at));
        let over = (out.x - back.x) / 2.0;
        let (aside, lowest) = (self.width / 2.0 + ASIDE, -ASIDE);
        let is_behind = out.y.abs() < aside && (lowest..self.top).contains(&out.z);
        (is_behind && over < BEHIND).then_some(over)
    }

    /// Whether a point is in the opening of this portal, or beyond it.
    pub(super) fn is_at(&self, at: &Point3<f32>) -> bool {
        let out = self.own.inverse_transform_point(at);
        let is_in_opening = out.y.abs() < self.width / 2.0 + TOUCHING && out.z > -ASIDE;
        is_in_opening && self.beyond(at).is_some_and(|over| over > -ASIDE)
    }

    /// How far a thing of the first region is over the line, metres, if it is to go to the other region. The floor decides: whatever is
    /// over something fixed of its own region stays, on the next flight of stairs, too, and at the edge of its floor if none goes on
    /// beyond; near the line, whatever is over the floor beyond goes, or lies on the edge of that. Both sides decide alike, so that
    /// nothing goes to and fro.
    fn takes(&self, there: &Environment, thing: NodeId) -> Option<f32> {
        let body = there.world().body(thing).ok()?;
        let at = body.centre_of_mass();
        let over = self.beyond(&at).filter(|over| *over > -ON_LINE)?;
        let loose: Vec<NodeId> = there.world().nodes().into_iter().filter(|id| is_loose(there, *id)).collect();
        // The thing below a point so far back on the own side, loose ones left out: whether it is the region's own, and level with the
        // threshold.
        let below = |back: f32| {
            let from = at - self.own.rotation * Vector3::x() * back;
            let (id, hit) = there.world().ray(from, from - DEEPEST * Vector3::z(), &loose)?;
            let is_level = self.own.inverse_transform_point(&hit).z.abs() < FLUSH;
            Some((there.graph().node(id).is_some(), is_level))
        };
        // A thing that lies higher than the edge is on it even if it leans far over; a lower one may lie on the step below.
        let height = self.own.inverse_transform_point(&at).z;
        let ledge = if height > 0.0 { 2.0 * LEDGE } else { LEDGE };
        let lowest = there.world().aabb(thing).map_or(height, |around| height + around.min.z - at.z);
        let falls = body.velocity().z < -FALLS;
        let goes = match below(0.0) {
            Some((true, is_level)) => {
                let lies = body.velocity().norm() < WAKES && lowest > -FLUSH / 2.0;
                !is_level && lies && below(-2.0 * LEDGE) == Some((false, true))
            }
            Some((false, true)) => over > OVER || below(EDGE) == Some((false, true)),
            // No edge holds what falls, nor anything that it touches.
            _ if falls && over > OVER => return Some(f32::INFINITY),
            _ => over > OVER && below(ledge) != Some((true, true)),
        };
        goes.then_some(over)
    }

    /// Whether a box reaches over the line.
    fn is_reached_by(&self, around: &Aabb) -> bool {
        around.corners().iter().any(|corner| self.beyond(corner).is_some_and(|over| over > -TOUCHING))
    }

    /// Whether a box is where the leaf swings.
    fn is_swept(&self, around: &Aabb) -> bool {
        around.distance(&Point3::from(self.own.translation.vector)) < self.width + TOUCHING
    }
}

impl City {
    /// Pushes a loose thing, wherever it is: [`Environment::push`], the impulse and the point in the frame of its region.
    ///
    /// ```
    /// use virtualcity::City;
    /// use virtualcity::graph::clock::Span;
    /// use virtualcity::nalgebra::Vector3;
    /// let mut city = City::make("building/7", 1)?;
    /// let home = city.active().next().ok_or("a home")?;
    /// let there = city.environment(home).ok_or("a home")?;
    /// let chair = there.graph().of_class("dining_chair")[0];
    /// let middle = there.world().body(chair)?.centre_of_mass();
    /// city.push(chair, Vector3::new(0.0, 0.0, 10.0), middle)?;
    /// city.step(Span(6));
    /// assert!(city.environment(home).ok_or("a home")?.world().body(chair)?.centre_of_mass().z > middle.z + 0.05);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`CityError::NoSuchThing`], [`CityError::Bodies`]; [`CityError::NoScene`] and other reasons for which a region cannot be made.
    pub fn push(&mut self, thing: NodeId, impulse: Vector3<f32>, at: Point3<f32>) -> Result<(), CityError> {
        let region = self.region_of(thing).ok_or(CityError::NoSuchThing(thing))?;
        self.write_down(thing, Order::Push(impulse.into(), at.into()));
        Ok(self.wake(region)?.push(thing, impulse, at)?)
    }

    /// Lets things go over to the regions where they are, from some regions in which something moves; returns the regions
    /// into which something reaches.
    pub(super) fn things_pass(&mut self, moving: &BTreeSet<RegionId>) -> BTreeSet<RegionId> {
        let mut reached = BTreeSet::new();
        for region in moving {
            self.bar_behind(*region);
            for (gate, is_open) in self.passable_gates(*region) {
                if is_open {
                    reached.extend(self.draw_near(&gate));
                }
                self.send_over(&gate);
            }
            self.fall_out(*region);
        }
        reached
    }

    /// Things beyond its leaf are in its way when somebody begins to move it.
    pub(super) fn make_way_for_leaves(&mut self) {
        let moves = |(region, there): (&RegionId, &Environment)| {
            let mut leaves = self.gates(*region).filter_map(|(_, plan, ..)| plan.leaf);
            leaves.any(|leaf| there.is_moved_by_hand(leaf)).then_some(*region)
        };
        for region in self.active.iter().filter_map(moves).collect::<Vec<RegionId>>() {
            for gate in self.gates_of(region) {
                self.draw_near(&gate);
            }
        }
    }

    /// Things beyond a leaf of a region that is about to swing are in its way.
    pub(super) fn draw_to_leaf(&mut self, region: RegionId, leaf: NodeId) {
        for gate in self.gates_of(region).iter().filter(|gate| gate.leaf == Some(leaf)) {
            self.draw_near_swinging(gate, true);
        }
    }

    /// The leaves of a region bar the thresholds of those beyond.
    fn bar_behind(&mut self, region: RegionId) {
        let leaves = self.gates(region).filter(|(_, plan, ..)| plan.leaf.is_some());
        let beyond: BTreeSet<RegionId> = leaves.map(|(.., across)| across.region).collect();
        beyond.into_iter().for_each(|other| self.set_bars_to(other, |leads| leads == region));
    }

    pub(super) fn gates_of(&self, region: RegionId) -> Vec<Gate> {
        self.gates(region).filter_map(|(_, plan, side, across)| self.gate(plan, side, across)).collect()
    }

    /// The gates of a region that let things through, and those that its own leaf shuts: what lies beyond that has been drawn in, out of
    /// the way of the leaf.
    fn passable_gates(&self, region: RegionId) -> Vec<(Gate, bool)> {
        let all = self.gates(region).map(|(_, plan, side, across)| {
            let is_open = self.lets_things_through(region, plan);
            self.gate(plan, side, across).map(|gate| (gate, is_open))
        });
        all.flatten().filter(|(gate, is_open)| *is_open || gate.leaf.is_some()).collect()
    }

    fn gate(&self, plan: &Portal, side: &PortalSide, across: &PortalSide) -> Option<Gate> {
        let (from, into) = (side.region, across.region);
        let back = self.pose_in(from, into)?;
        Some(Gate {
            from,
            into,
            own: side.pose,
            across: back * across.pose,
            shift: self.pose_in(into, from)?,
            width: plan.width,
            // Over the head of stairs is the next storey.
            top: if plan.stairs.is_empty() { plan.height + ASIDE } else { plan.height },
            leaf: plan.leaf.filter(|leaf| self.region_of(*leaf) == Some(from)),
            room: across.room,
        })
    }

    /// Lets those things come over to a region that something of it is about to touch beyond a portal; tells the region
    /// beyond if something reaches into it.
    fn draw_near(&mut self, gate: &Gate) -> Option<RegionId> {
        let there = self.active.get(&gate.from)?;
        let swings = gate.leaf.is_some_and(|leaf| there.is_moved_by_hand(leaf));
        self.draw_near_swinging(gate, swings)
    }

    fn draw_near_swinging(&mut self, gate: &Gate, swings: bool) -> Option<RegionId> {
        let there = self.active.get(&gate.from)?;
        let mut reaching: Vec<Aabb> = moving_boxes(there).filter(|own| gate.is_reached_by(own)).collect();
        if reaching.is_empty() && !swings {
            return None;
        }
        reaching.iter_mut().for_each(|own| *own = own.grown(TOUCHING, TOUCHING));
        let back = gate.shift.inverse();
        let beyond = self.wake(gate.into).ok()?;
        let is_met = |id: &NodeId| {
            let around = beyond.world().aabb(*id).map(|own| shifted(&own, &back));
            around.is_some_and(|own| reaching.iter().any(|other| other.meets(&own)) || (swings && gate.is_swept(&own)))
        };
        let near = |id: &NodeId| {
            beyond.world().pose(*id).is_some_and(|at| gate.beyond(&(back * at * Point3::origin())).is_some())
        };
        let met: BTreeSet<NodeId> = loose(beyond).filter(near).filter(is_met).map(|id| beyond.carrier(id)).collect();
        for thing in met {
            // A thing that cannot come over stays where it is.
            let _ = self.carry_over(thing, (gate.into, gate.from), &back, None);
        }
        Some(gate.into)
    }

    /// Lets things go over to the region beyond a portal where they are, unless they go on with others here.
    fn send_over(&mut self, gate: &Gate) {
        let Some(there) = self.active.get(&gate.from) else { return };
        if !loose(there).any(|id| gate.takes(there, id).is_some()) {
            return;
        }
        let Some(there) = self.active.get_mut(&gate.from) else { return };
        there.catch_up();
        let there = &*there;
        let alone = loose(there).filter(|id| there.carrier(*id) == *id);
        let goes = |id: &NodeId| {
            gate.takes(there, *id).is_some_and(|over| over > TOGETHER || !is_with_others(there, gate, *id))
        };
        for thing in alone.filter(goes).collect::<Vec<NodeId>>() {
            // It stays here if there is no place for it beyond.
            let _ = self.carry_over(thing, (gate.from, gate.into), &gate.shift, gate.room);
        }
    }

    /// Takes a thing, and what is on or in it, from region to region as it moves.
    pub(super) fn carry_over(
        &mut self,
        thing: NodeId,
        (from, into): (RegionId, RegionId),
        shift: &Pose,
        room: Option<NodeId>,
    ) -> Result<(), CityError> {
        let space = self.space().clone();
        let travel = |why| CityError::of_travel(&space, why);
        self.wake(into)?;
        let both = [from, into].into_iter().filter_map(|region| Some((region, self.active.get(&region)?.clone())));
        let before: Vec<(RegionId, Environment)> = both.collect();
        let Some(home) = self.active.get_mut(&from) else { return Ok(()) };
        let freight = home.send_off(thing, from).map_err(travel)?;
        let Some(next) = self.active.get_mut(&into) else { return Ok(()) };
        let room = room.or_else(|| next.graph().rooms().first().copied()).unwrap_or(NodeId(0));
        if let Err(why) = next.take_in(&freight, (into, room), shift) {
            self.active.extend(before);
            return Err(travel(why));
        }
        self.are_now_in(freight.nodes(), into);
        Ok(())
    }
}

/// The loose things of a region.
pub(super) fn loose(there: &Environment) -> impl Iterator<Item = NodeId> + '_ {
    there.world().nodes().into_iter().filter(|id| is_loose(there, *id))
}

fn is_loose(there: &Environment, id: NodeId) -> bool {
    there.world().role(id) == Some(BodyRole::Loose)
}

/// The boxes around what moves in a region, grown by what it moves in a tick. A thing that has only been woken draws nothing near: it falls for a
/// tick before its support holds it again.
fn moving_boxes(there: &Environment) -> impl Iterator<Item = Aabb> + '_ {
    let tick = there.world().settings().dt;
    there.world().awake_things().into_iter().filter_map(move |id| {
        let velocity = there.world().body(id).ok()?.velocity();
        let moves = velocity.xy().norm() > CREEPS || velocity.z.abs() > WAKES;
        let reach = velocity.norm() * tick;
        moves.then(|| there.world().aabb(id).map(|own| own.grown(reach, reach)))?
    })
}

/// Whether a thing touches others of its region while one of both moves, or a leaf in somebody's hand.
fn is_with_others(there: &Environment, gate: &Gate, thing: NodeId) -> bool {
    let Some(around) = there.world().aabb(thing).map(|own| own.grown(NEAR, NEAR)) else { return false };
    let by_hand = gate.leaf.is_some_and(|leaf| there.is_moved_by_hand(leaf));
    let (awake, own) = (there.world().awake_things(), there.graph().carried_with(thing));
    let moves = awake.contains(&thing);
    let others = loose(there).filter(|id| !own.contains(id) && (moves || awake.contains(id)));
    let touches = |id: NodeId| there.world().aabb(id).is_some_and(|other| other.meets(&around));
    (by_hand && gate.is_swept(&around)) || others.into_iter().any(touches)
}

/// A box in another frame.
fn shifted(around: &Aabb, shift: &Pose) -> Aabb {
    let corners = around.corners().map(|corner| shift * corner);
    let first = Aabb { min: corners[0], max: corners[0] };
    corners.iter().fold(first, |all, corner| Aabb { min: all.min.inf(corner), max: all.max.sup(corner) })
}
