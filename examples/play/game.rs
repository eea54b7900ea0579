//! The effects of keyboard and mouse in a home, and its picture; independent of the window.

use nalgebra::{Isometry3, UnitQuaternion, Vector2, Vector3};
use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, NodeId, SceneGraph, Verb, rule};
use virtualcity::physics::{Hand, Posture};
use virtualcity::render::picture::{self, Picture};
use virtualcity::render::{Camera, Modalities, Modality};
use virtualcity::{Environment, Steering, Viewpoint};

use crate::support::Complaint;
use crate::text;

/// Largest view angle up and down, radians.
const TILT: f32 = 1.3;
/// Ticks between two displayed pictures of an action.
const SHOWN: Span = Span(3);
/// The possible meanings of a click on the object pointed at; the first that the rule allows is chosen.
const CLICKS: [Verb; 10] = [
    Verb::Grab,
    Verb::Open,
    Verb::Close,
    Verb::SwitchOn,
    Verb::SwitchOff,
    Verb::Sit,
    Verb::Lie,
    Verb::Drink,
    Verb::Eat,
    Verb::Read,
];

/// The input from keyboard and mouse.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Hands {
    /// Speed forward, and to the left: from -1 to 1.
    pub(crate) ahead: f32,
    pub(crate) left: f32,
    pub(crate) runs: bool,
    pub(crate) jumps: bool,
    /// Rotation to the left and up since the last picture, radians.
    pub(crate) turn: f32,
    pub(crate) tilt: f32,
    /// The modality to show.
    pub(crate) shows: Option<usize>,
    pub(crate) wish: Option<Wish>,
}

/// The request of a mouse button.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Wish {
    Act,
    LetGo,
}

/// A home and its player.
pub(crate) struct Game {
    home: Environment,
    /// The home at the time of the previous picture, for optical flow.
    before: Option<Environment>,
    me: NodeId,
    size: (u32, u32),
    heading: f32,
    tilt: f32,
    shows: usize,
    target: Option<NodeId>,
    pressed: bool,
    words: String,
}

/// Size of the picture from its width.
pub(crate) fn size(width: u32) -> (u32, u32) {
    (width, width * 3 / 4)
}

impl Game {
    pub(crate) fn new(home: Environment, width: u32) -> Self {
        let me = home.agents()[0];
        let ahead = home.world().pose(me).map_or_else(Vector3::x, |p| p.rotation * Vector3::x());
        Self {
            heading: ahead.y.atan2(ahead.x),
            me,
            home,
            before: None,
            size: size(width),
            tilt: -0.15,
            shows: 0,
            target: None,
            pressed: false,
            words: "click to act, W A S D to go, 1 to 6 to see otherwise".to_owned(),
        }
    }

    /// Duration of a tick, seconds.
    pub(crate) fn dt(&self) -> f32 {
        self.home.world().settings().dt
    }

    /// The last action, or the refused action and the reason.
    pub(crate) fn words(&self) -> &str {
        &self.words
    }

    /// Turns the view as the mouse requests, and performs the action of a click; `show` receives pictures
    /// meanwhile.
    pub(crate) fn act(&mut self, hands: &Hands, mut show: impl FnMut(&Picture)) -> Result<(), Complaint> {
        self.heading += hands.turn;
        self.tilt = (self.tilt + hands.tilt).clamp(-TILT, TILT);
        self.shows = hands.shows.unwrap_or(self.shows);
        let wish = hands.wish.filter(|_| !self.pressed);
        self.pressed = hands.wish.is_some();
        let rises = self.home.posture(self.me) != Some(Posture::Standing) && (hands.ahead != 0.0 || hands.left != 0.0);
        let action = match (rises, wish) {
            (true, _) => Some(Action::zero(Verb::Stand)),
            (_, Some(Wish::Act)) => self.target.and_then(|target| self.meant(target)),
            (_, Some(Wish::LetGo)) => self.held().map(|held| Action::one(Verb::Drop, held)),
            _ => None,
        };
        let Some(action) = action else { return Ok(()) };
        let (me, size, view) = (self.me, self.size, self.view());
        let name = action.describe(self.home.graph()).to_string();
        let outcome = self.home.set_action_in_time(me, action, SHOWN, |home| {
            if let Ok(frame) = home.render(Viewpoint::Free(view), Modality::Rgb, size.0, size.1) {
                show(&picture::rgb(&frame));
            }
        });
        self.words = outcome.map_or_else(|e| e.to_string(), |_| name);
        Ok(())
    }

    /// Advances the simulation by one tick.
    pub(crate) fn tick(&mut self, hands: &Hands) {
        if self.home.posture(self.me) != Some(Posture::Standing) {
            return;
        }
        let plan = self.home.world().agent(self.me).map_or((1.2, 3.0), |me| (me.plan().walk, me.plan().run));
        let speed = if hands.runs { plan.1 } else { plan.0 };
        let (sin, cos) = self.heading.sin_cos();
        let way = Vector2::new(cos * hands.ahead - sin * hands.left, sin * hands.ahead + cos * hands.left);
        let velocity = way.try_normalize(1e-3).map_or_else(Vector2::zeros, |way| way * speed);
        let steering = Steering { velocity, heading: self.heading, jump: hands.jumps };
        if let Err(error) = self.home.steer(self.me, &steering) {
            self.words = error.to_string();
        }
    }

    /// The picture, with the crosshair, the object pointed at, and the last action.
    pub(crate) fn picture(&mut self) -> Result<Picture, Complaint> {
        let (width, height) = self.size;
        let (wanted, view): (Modalities, _) = match self.shows {
            // From the actual eyes, since the flow includes their motion.
            4 => (Modality::FlowForward | Modality::Instance, Viewpoint::Agent(self.me)),
            1 | 2 => (Modality::Instance | Modality::Class, Viewpoint::Free(self.view())),
            3 => (Modality::Depth | Modality::Instance, Viewpoint::Free(self.view())),
            5 => (Modality::Masks | Modality::Instance | Modality::Boxes, Viewpoint::Free(self.view())),
            _ => (Modality::Rgb | Modality::Instance, Viewpoint::Free(self.view())),
        };
        let before = self.before.take().filter(|_| self.shows == 4);
        let earlier = before.as_ref().unwrap_or(&self.home);
        let frame = match self.shows {
            4 => earlier.render_until(&self.home, view, wanted, width, height),
            _ => self.home.render(view, wanted, width, height),
        }
        .map_err(Complaint::new)?;
        let mut shown = match self.shows {
            1 => picture::instances(&frame),
            2 => picture::classes(&frame),
            3 => picture::depth(&frame, 8.0),
            4 => picture::flow(&frame, 12.0),
            5 => picture::with_boxes(picture::masks(&frame), &frame, 150),
            _ => picture::rgb(&frame),
        };
        let centre = frame.instance.get((frame.height / 2) * frame.width + frame.width / 2).copied();
        self.target = centre.filter(|id| self.home.graph().node(*id).is_some());
        self.before = (self.shows == 4).then(|| self.home.clone());
        text::crosshair(&mut shown);
        if let Some(target) = self.target {
            let middle = (shown.width / 2, shown.height / 2 + 12);
            text::write(&mut shown, middle, &self.named(target));
        }
        let bottom = (shown.width / 2, shown.height.saturating_sub(14));
        text::write(&mut shown, bottom, &self.words);
        Ok(shown)
    }

    /// The camera at the eyes, in the direction set by the mouse.
    fn view(&self) -> Camera {
        let (width, height) = self.size;
        let eyes = self.home.camera(Viewpoint::Agent(self.me), width, height);
        let camera = eyes.unwrap_or_else(|_| Camera::with_fov(width, height, 1.15));
        let turned = UnitQuaternion::from_euler_angles(0.0, -self.tilt, self.heading);
        let at = Isometry3::from_parts(camera.pose.translation, turned);
        camera.mounted(&at)
    }

    /// An object's name, and the effect of a click on it.
    fn named(&self, target: NodeId) -> String {
        let graph = self.home.graph();
        let class = graph.node(target).map_or("", |n| n.class());
        match self.meant(target).filter(|action| allowed(graph, self.me, action)) {
            Some(action) => format!("{class}: {}", action.verb),
            None => class.to_owned(),
        }
    }

    /// The action of a click on an object: the first that the rule allows; if it allows none, the first of all,
    /// to be refused with a reason.
    fn meant(&self, target: NodeId) -> Option<Action> {
        let graph = self.home.graph();
        let put = self
            .held()
            .into_iter()
            .flat_map(|held| [Verb::PutIn, Verb::Place, Verb::Pour].map(|verb| Action::two(verb, held, target)));
        let mut all = put.chain(CLICKS.map(|verb| Action::one(verb, target)));
        let first = all.clone().next();
        all.find(|action| allowed(graph, self.me, action)).or(first)
    }

    fn held(&self) -> Option<NodeId> {
        Hand::BOTH.iter().find_map(|hand| self.home.world().held(self.me, *hand))
    }
}

fn allowed(graph: &SceneGraph, me: NodeId, action: &Action) -> bool {
    rule::refusals(graph, me, action).is_empty()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use super::*;

    /// All modalities, a walk, a jump and a click, without a window.
    #[test]
    fn hands_move_look_and_act() {
        let mut game = Game::new(Environment::make("apartment/3", 1).unwrap(), 64);
        let feet = |game: &Game| game.home.world().pose(game.me).unwrap().translation.vector;
        let start = feet(&game);
        let mut highest: f32 = 0.0;
        for i in 0..90 {
            // Turns around, so that some direction is free.
            let hands = Hands { ahead: 1.0, turn: 0.05, jumps: i == 5, ..Hands::default() };
            game.act(&hands, |_| ()).unwrap();
            game.tick(&hands);
            highest = highest.max(feet(&game).z - start.z);
        }
        assert!((feet(&game) - start).xy().norm() > 0.2, "it went");
        assert!(highest > 0.2, "it jumped");
        let mut seen = Vec::new();
        for shows in 0..6 {
            game.act(&Hands { shows: Some(shows), tilt: -0.1, ..Hands::default() }, |_| ()).unwrap();
            let picture = game.picture().unwrap();
            assert_eq!((picture.width, picture.height), (64, 48));
            seen.push(picture.pixels);
        }
        seen.sort();
        seen.dedup();
        assert_eq!(seen.len(), 6, "six different pictures");
        assert!(game.target.is_some(), "it points at something");
        let before = game.words.clone();
        game.act(&Hands { wish: Some(Wish::Act), ..Hands::default() }, |_| ()).unwrap();
        assert_ne!(game.words, before, "done, or refused with a reason");
    }
}
