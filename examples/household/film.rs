//! Pictures of a run: from the agent's eyes, and from a corner of the room it is in.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Point2;
use vc_graph::NodeId;
use virtualcity::render::picture::{self, Picture};
use virtualcity::render::{Camera, Frame, Modalities, Modality};
use virtualcity::{Environment, Viewpoint};

use crate::support::Complaint;

/// Ticks of the home between two pictures, at first.
const EVERY: u32 = 10;
/// Most pictures; when there are more, every other one is dropped and fewer are made.
const MOST: usize = 180;

/// Pictures of a run.
pub(crate) struct Film {
    me: NodeId,
    size: (u32, u32),
    /// Cameras in rooms, chosen when the agent first comes there.
    corners: BTreeMap<NodeId, Camera>,
    pictures: Vec<Picture>,
    /// The titles of actions, by the number of the picture before which they began.
    titles: Vec<(usize, String)>,
    every: u32,
    ticks: u32,
    room: Option<NodeId>,
    /// All modalities of the moment that tells most, from the eyes and from the corner.
    pub(crate) modalities: Option<[Picture; 2]>,
    /// How much that moment tells.
    most_telling: usize,
    /// The moment of the last picture, for flow.
    before: Option<Environment>,
    pub(crate) last: Option<Picture>,
}

impl Film {
    pub(crate) fn new(home: &Environment, me: NodeId, width: u32) -> Self {
        Self {
            me,
            size: (width, width * 3 / 4),
            corners: BTreeMap::new(),
            pictures: Vec::new(),
            titles: Vec::new(),
            every: EVERY,
            ticks: 0,
            room: home.graph().room_of(me),
            modalities: None,
            most_telling: 0,
            before: None,
            last: None,
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.pictures.len()
    }

    pub(crate) fn pictures(&self) -> &[Picture] {
        &self.pictures
    }

    /// Actions, by the picture with which they begin.
    pub(crate) fn titles(&self) -> &[(usize, String)] {
        &self.titles
    }

    /// Pictures a second, at twice the speed of the home.
    pub(crate) fn rate(&self) -> u16 {
        (2 * 60 / self.every).max(1) as u16
    }

    /// A new action begins.
    pub(crate) fn title(&mut self, words: &str) {
        self.titles.push((self.pictures.len(), words.to_owned()));
    }

    /// Where the agent's feet are.
    pub(crate) fn feet(&self, home: &Environment) -> Point2<f32> {
        home.world().pose(self.me).map_or_else(Point2::origin, |p| p.translation.vector.xy().into())
    }

    /// A tick has passed: now and then a picture is made.
    pub(crate) fn tick(&mut self, home: &Environment) -> Result<(), Complaint> {
        self.ticks += 1;
        if !self.ticks.is_multiple_of(self.every) {
            return Ok(());
        }
        let [eyes, corner] = self.views(home)?;
        let wanted = Modality::Rgb;
        let shots = [eyes, corner].map(|view| self.shot(home, view, wanted.into()).map(|f| picture::rgb(&f)));
        let [a, b] = shots;
        self.pictures.push(Picture::sheet(&[a?, b?], 2, 4));
        if self.pictures.len() > MOST {
            self.thin();
        }
        self.look(home, [eyes, corner])?;
        self.before = Some(home.clone());
        Ok(())
    }

    /// Keeps every other picture.
    fn thin(&mut self) {
        let mut index = 0;
        self.pictures.retain(|_| {
            index += 1;
            index % 2 == 1
        });
        self.titles.iter_mut().for_each(|t| t.0 /= 2);
        self.every *= 2;
    }

    /// The agent's eyes, and the camera of the room it is in.
    fn views(&mut self, home: &Environment) -> Result<[Viewpoint; 2], Complaint> {
        self.room = home.room_at(self.feet(home)).or(self.room);
        let Some(room) = self.room else { return Ok([Viewpoint::Agent(self.me); 2]) };
        let camera = match self.corners.get(&room) {
            Some(camera) => *camera,
            None => {
                let view = Viewpoint::Room(room);
                let camera = home.camera(view, self.size.0, self.size.1).map_err(Complaint::new)?;
                self.corners.insert(room, camera);
                camera
            }
        };
        Ok([Viewpoint::Agent(self.me), Viewpoint::Free(camera)])
    }

    fn shot(&self, home: &Environment, view: Viewpoint, wanted: Modalities) -> Result<Frame, Complaint> {
        home.render(view, wanted, self.size.0, self.size.1).map_err(Complaint::new)
    }

    /// Keeps all modalities of the moment that tells most.
    fn look(&mut self, home: &Environment, views: [Viewpoint; 2]) -> Result<(), Complaint> {
        let Some(before) = self.before.take() else { return Ok(()) };
        let telling = self.telling(&before, home, views[0])?;
        if telling <= self.most_telling {
            return Ok(());
        }
        self.most_telling = telling;
        let sheet = |view| -> Result<Picture, Complaint> {
            let frame = before.render_until(home, view, Modalities::SIX, self.size.0, self.size.1);
            Ok(six(&frame.map_err(Complaint::new)?))
        };
        self.modalities = Some([sheet(views[0])?, sheet(views[1])?]);
        Ok(())
    }

    /// How much a moment tells: nothing unless the agent moves; more while it holds something,
    /// and the more things it sees.
    fn telling(&self, before: &Environment, now: &Environment, eyes: Viewpoint) -> Result<usize, Complaint> {
        if (self.feet(before) - self.feet(now)).norm() <= 1e-3 {
            return Ok(0);
        }
        let frame = now.render(eyes, Modality::Instance, 80, 60).map_err(Complaint::new)?;
        let seen: BTreeSet<NodeId> = frame.instance.iter().copied().collect();
        let holds = now.graph().held(self.me).next().is_some();
        Ok(seen.len() + if holds { 1000 } else { 0 })
    }

    /// The end: one more picture, from the corner.
    pub(crate) fn last(&mut self, home: &Environment) -> Result<(), Complaint> {
        let [_, corner] = self.views(home)?;
        self.last = Some(picture::rgb(&self.shot(home, corner, Modality::Rgb.into())?));
        Ok(())
    }
}

/// The six modalities: colours, instances, classes; depth, flow, boxes with masks.
fn six(frame: &Frame) -> Picture {
    let all = [
        picture::rgb(frame),
        picture::instances(frame),
        picture::classes(frame),
        picture::depth(frame, 8.0),
        picture::flow(frame, 20.0),
        picture::with_boxes(picture::masks(frame), frame, 60),
    ];
    Picture::sheet(&all, 3, 4)
}
