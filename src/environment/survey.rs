//! Questions that a program asks about a home before it acts: which actions are possible, which things
//! there are, where one can walk.

use nalgebra::Point2;
use vc_graph::format::objects::{ListedObject, objects, seen};
use vc_graph::{Action, Anthropometry, NodeId, Pose, rule};
use vc_physics::{Occupancy, PartsToMoveAside, ShutDoors};

use super::{ActionError, Environment};

impl Environment {
    /// Every action an agent can do now by the transition rule: those for which `rule::refusals` is empty.
    /// Bodies may still refuse a few, for want of a free spot or of a way: [`can_do`](Self::can_do) asks them.
    ///
    /// The whole home is listed, as the rule knows all of it: one may walk to and look for what one has never seen, and
    /// use what is near in other ways than people would: `rinse living_room.0`, or `type radiator.133`, as what has a
    /// switch is a device. The [guide](crate::guide::acting#legal-actions-with-things-in-view) lists those with what is in view.
    ///
    /// ```
    /// use virtualcity::Environment;
    /// use virtualcity::graph::Verb;
    /// let mut home = Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// let legal = home.legal_actions(me);
    /// assert!(legal.iter().any(|action| action.verb == Verb::Sit));
    /// let sit = legal.into_iter().find(|action| action.verb == Verb::Sit).ok_or("no seat")?;
    /// home.can_do(me, &sit)?;
    /// home.set_action(me, sit)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn legal_actions(&self, agent: NodeId) -> Vec<Action> {
        rule::legal_actions(&self.graph, agent)
    }

    /// Tries an action on a copy, bodies included, and says whether it would be done. Costs a copy and the
    /// action: a millisecond or a few.
    ///
    /// # Errors
    /// The [`ActionError`] that [`set_action`](Self::set_action) would give.
    pub fn can_do(&self, agent: NodeId, action: &Action) -> Result<(), ActionError> {
        self.clone().set_action(agent, *action).map(drop)
    }

    /// Everything in the home but its rooms as a plain list, for JSON: classes, rooms, poses (metres), boxes,
    /// states and relations.
    ///
    /// ```no_run
    /// let home = virtualcity::Environment::make("apartment/42", 1)?;
    /// std::fs::write("objects.json", serde_json::to_string_pretty(&home.objects())?)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn objects(&self) -> Vec<ListedObject> {
        objects(&self.graph)
    }

    /// The things that an agent sees in its room ([`room_observation`](Self::room_observation)), as such a list.
    ///
    /// ```
    /// let home = virtualcity::Environment::make("apartment/42", 1)?;
    /// let me = home.agents()[0];
    /// let seen = home.objects_in_view(me);
    /// assert!(seen.iter().any(|object| object.id == me) && seen.len() < home.objects().len());
    /// let json = serde_json::to_string(&seen)?;
    /// assert!(json.contains("\"relations\""));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn objects_in_view(&self, agent: NodeId) -> Vec<ListedObject> {
        seen(&self.room_observation(agent))
    }

    /// The floor on which one can walk now, as a grid for planners of one's own: `Floor::occupancy`. Doors
    /// between rooms count as open, and people are not in the way: to every free cell one can
    /// [`teleport`](Self::teleport) as long as nobody is there. Costs some tens of milliseconds.
    ///
    /// ```no_run
    /// let home = virtualcity::Environment::make("apartment/42", 1)?;
    /// let grid = home.occupancy();
    /// for row in (0..grid.rows).rev() {
    ///     println!("{}", (0..grid.columns).map(|c| if grid.is_free(c, row) { '.' } else { '#' }).collect::<String>());
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn occupancy(&self) -> Occupancy {
        let mut floor = self.floor.clone();
        floor.update(&self.world);
        let mut grid = floor.occupancy();
        let others: Vec<Point2<f32>> = self.agents().iter().skip(1).filter_map(|a| self.feet_of(*a)).collect();
        let taken = |at: &Point2<f32>| others.iter().any(|other| (other - at).norm() < Anthropometry::ADULT.apart);
        for (index, free) in grid.free.clone().into_iter().enumerate().filter(|(_, free)| *free) {
            let at = grid.centre(index % grid.columns, index / grid.columns);
            let stands = |agent: &NodeId| taken(&at) || self.gives_way(*agent, &at).is_some();
            grid.free[index] = free && self.agents().first().is_none_or(stands);
        }
        grid
    }

    fn feet_of(&self, agent: NodeId) -> Option<Point2<f32>> {
        self.world.pose(agent).map(|feet| feet.translation.vector.xy().into())
    }

    /// The doors that have to give way so that an agent can stand at a point of the floor that is free but for doors,
    /// and how far each would then be open; empty if the agent stands free there. `None` if it cannot stand there.
    pub(super) fn gives_way(&self, agent: NodeId, at: &Point2<f32>) -> Option<PartsToMoveAside> {
        let feet = Pose::translation(at.x, at.y, self.floor.options().level);
        if self.world.standing(agent, &feet).ok()?.is_free() {
            return Some(PartsToMoveAside::new());
        }
        self.world.standing(agent, &feet).ok()?.parts_to_move_aside(ShutDoors::Open)
    }
}
