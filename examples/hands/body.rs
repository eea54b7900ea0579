//! A body under control: it walks to poses, and its right hand goes to poses.

use nalgebra::{Point2, Vector2, Vector3};
use virtualcity::graph::clock::Span;
use virtualcity::graph::{NodeId, Pose};
use virtualcity::physics::{Floor, FloorOptions, Hand, HandGoal};
use virtualcity::{Control, Environment};

use crate::sight::Witness;
use crate::support::{Complaint, say};
use crate::target::Target;

/// Ticks between two decisions.
const EVERY: Span = Span(3);
/// Decisions after which a body that does not arrive gives up.
const PATIENCE: u32 = 400;

/// The force of the grip, newtons.
const FORCE: f32 = 80.0;

/// A body in a home, and who watches it.
pub(crate) struct Body {
    pub(crate) home: Environment,
    pub(crate) me: NodeId,
    pub(crate) witness: Witness,
    hand: Option<HandGoal>,
}

impl Body {
    pub(crate) fn new(home: Environment, witness: Witness) -> Result<Self, Complaint> {
        let me = *home.agents().first().ok_or_else(|| Complaint::new("nobody is at home"))?;
        Ok(Self { home, me, witness, hand: None })
    }

    fn feet(&self) -> Pose {
        self.home.world().pose(self.me).unwrap_or_else(Pose::identity)
    }

    /// One decision: a velocity ahead and to the left, and a turn.
    fn act(&mut self, velocity: Vector2<f32>, turn: f32) -> Result<(), Complaint> {
        let control = Control { velocity, turn, head: None, hands: [self.hand, None] };
        self.home.control(self.me, &control)?;
        self.home.step(EVERY);
        self.witness.look(&self.home)
    }

    /// Walks along the shortest way to a pose.
    pub(crate) fn walk(&mut self, to: &Pose) -> Result<(), Complaint> {
        let floor = Floor::new(self.home.world(), FloorOptions::default());
        let (from, goal) = (self.feet().translation.vector.xy(), to.translation.vector.xy());
        let route = floor.route(from.into(), goal.into()).ok_or_else(|| Complaint::new("there is no way there"))?;
        let is_shut = |door: &NodeId| self.home.world().parts(*door).openness() == Some(0.0);
        if route.doors.iter().any(is_shut) {
            return Err(Complaint::new("a door on the way is closed, and this program opens none: try another seed"));
        }
        for point in route.points.into_iter().chain([goal.into()]) {
            self.walk_straight(&point, if point.coords == goal { 0.02 } else { 0.2 })?;
        }
        self.turn(to)
    }

    fn walk_straight(&mut self, to: &Point2<f32>, near: f32) -> Result<(), Complaint> {
        for _ in 0..PATIENCE {
            let way =
                self.feet().inverse_transform_vector(&(to.coords.push(0.0) - self.feet().translation.vector)).xy();
            if way.norm() < near {
                return Ok(());
            }
            let aside = way.y.atan2(way.x);
            // Near the goal it steps aside rather than turn around.
            let turn = if way.norm() < 0.3 { 0.0 } else { (4.0 * aside).clamp(-3.0, 3.0) };
            let slow = if turn.abs() > 2.0 { 0.1 } else { 1.0 };
            self.act(way * (slow * (3.0_f32).min(1.0 / way.norm())), turn)?;
        }
        Err(Complaint::new(format!("it does not get to {to}")))
    }

    fn turn(&mut self, to: &Pose) -> Result<(), Complaint> {
        for _ in 0..PATIENCE {
            let front = self.feet().inverse_transform_vector(&(to.rotation * Vector3::x()));
            let aside = front.y.atan2(front.x);
            if aside.abs() < 0.005 {
                return self.act(Vector2::zeros(), 0.0);
            }
            self.act(Vector2::zeros(), (6.0 * aside).clamp(-2.0, 2.0))?;
        }
        Err(Complaint::new("it does not turn"))
    }

    /// Brings the right hand to a pose of the world, closed by a share, until it does not move any more.
    pub(crate) fn reach(&mut self, to: &Pose, grip: f32) -> Result<(), Complaint> {
        self.hand = Some(HandGoal { pose: self.feet().inverse() * to, grip, force: FORCE });
        let mut before = (Vector3::repeat(f32::NAN), f32::NAN);
        for _ in 0..PATIENCE {
            self.act(Vector2::zeros(), 0.0)?;
            let hand = self.home.controlled_hand(self.me, Hand::Right);
            let hand = hand.ok_or_else(|| Complaint::new("the hand is not under control"))?.body;
            let now = (hand.pose.translation.vector, hand.opening);
            if (now.0 - before.0).norm() < 5e-4 && (now.1 - before.1).abs() < 5e-4 {
                return Ok(());
            }
            before = now;
        }
        Err(Complaint::new("the hand does not come to rest"))
    }

    /// Says what the graph says, and keeps a picture.
    pub(crate) fn tell(&mut self, stage: &str, target: &Target) -> Result<(), Complaint> {
        let (graph, world) = (self.home.graph(), self.home.world());
        let spoon = graph.place(target.spoon).map(|p| format!("{} {}", p.relation, graph.label(p.at)));
        let state = graph.node(target.cabinet).map(|node| node.states().to_string()).unwrap_or_default();
        let open = 100.0 * world.parts(target.cabinet).openness().unwrap_or_default();
        let hand = self.home.controlled_hand(self.me, Hand::Right);
        let holds = hand.as_ref().and_then(|hand| hand.body.holds);
        let holds = holds.map_or("nothing".into(), |(id, part)| match part {
            Some(part) => format!("{} by part {part}", graph.label(id)),
            None => graph.label(id).to_string(),
        });
        let short = hand.map_or(0.0, |hand| hand.short);
        let spoon = spoon.unwrap_or_else(|| "nowhere in particular".into());
        say!(
            "  {:>6} {stage:<20} cabinet {state}, {open:.0}% open; spoon {spoon}; hand holds {holds}, {short:.2} m short",
            self.home.tick()
        );
        self.witness.keep(&self.home)
    }
}
