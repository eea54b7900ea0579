//! Pictures of an episode: from the agent's eyes, and from a corner of the room it is in.

use std::collections::BTreeSet;

use rayon::prelude::*;
use vc_graph::NodeId;
use vc_procgen::picture::{Anchor, Canvas, Colour};
use vc_render::picture::{self, Picture};
use vc_render::{Adaptation, Frame, Modalities, Modality};

use super::dataset::Dataset;
use super::{OwnFiles, RecordError, feet, save};
use crate::environment::{GLANCE, sight_of};
use crate::{Environment, PageFilm, PictureError, PictureOptions, Viewpoint};

/// Ticks of the home between two pictures, at first.
pub(super) const EVERY: u32 = 10;
/// Most pictures; when there are more, every other one is dropped and fewer are made.
const MOST: usize = 180;

/// Quality of the film's pictures as JPEG: no blocks are seen.
const JPEG_QUALITY: u8 = 88;
/// The width of a caption's line as a multiple of its height, and the height of its letters as a share of it.
const CAPTION: (f32, f32) = (36.0, 0.6);
/// Actions that the strip shows at most.
const SHOWN: usize = 8;
/// Ticks in which somebody is seen, but not well, before the corner's camera goes elsewhere.
const PATIENCE: u32 = 3 * EVERY;

/// Pictures of an episode.
pub(super) struct Film {
    me: NodeId,
    size: (u32, u32),
    pictures: Vec<Picture>,
    /// The pictures before which actions began.
    starts: Vec<usize>,
    every: u32,
    ticks: u32,
    room: Option<NodeId>,
    /// The camera in that room, and for how many ticks the agent has not been seen well from it.
    corner: Option<(Viewpoint, u32)>,
    /// All modalities of the moment that tells most, from the eyes and from the corner.
    modalities: Option<[Picture; 2]>,
    /// How much that moment tells.
    most_telling: usize,
    /// The moment of the last picture, for flow.
    before: Option<Environment>,
    /// The exposures that the eyes and the corner's camera are used to, each with its viewpoint.
    used: [Option<(Viewpoint, [f32; 3])>; 2],
}

impl Film {
    pub(super) fn new(home: &Environment, me: NodeId, width: u32) -> Self {
        Self {
            me,
            size: (width, width * 3 / 4),
            pictures: Vec::new(),
            starts: Vec::new(),
            every: EVERY,
            ticks: 0,
            room: home.graph().room_of(me),
            corner: None,
            modalities: None,
            most_telling: 0,
            before: None,
            used: [None; 2],
        }
    }

    /// All modalities of the moment that tells most, from the eyes and from the corner.
    pub(super) fn modalities(&self) -> Option<&[Picture; 2]> {
        self.modalities.as_ref()
    }

    /// Pictures a second, at twice the speed of the home as far as whole numbers allow.
    pub(super) fn rate(&self) -> u16 {
        (2 * 60 / self.every).max(1) as u16
    }

    /// How many times faster than the home the film is.
    fn speed(&self) -> f64 {
        let speed = f64::from(u32::from(self.rate()) * self.every) / 60.0;
        (speed * 100.0).round() / 100.0
    }

    /// A new action of an agent begins, whom the cameras follow from now on.
    pub(super) fn begin_action(&mut self, home: &Environment, agent: NodeId) {
        if agent != self.me {
            (self.me, self.room, self.corner) = (agent, home.graph().room_of(agent), None);
        }
        self.starts.push(self.pictures.len());
    }

    /// The pictures of some actions, eight at most, at the moment when the hand is at the thing: number of the
    /// action, number of the picture.
    fn moments(&self) -> Vec<(usize, usize)> {
        let starts: Vec<usize> = self.starts.iter().copied().chain([self.pictures.len()]).collect();
        let count = self.starts.len();
        // Evenly from the first to the last.
        let shown = |k: usize| if count <= SHOWN { k } else { k * (count - 1) / (SHOWN - 1) };
        let moment = |action: usize| (action, starts[action] + (starts[action + 1] - starts[action]) * 4 / 5);
        (0..count.min(SHOWN)).map(shown).map(moment).filter(|(_, at)| *at < self.pictures.len()).collect()
    }

    /// A picture of each action with its words, eight at most; of the home as it is if nothing was done.
    pub(super) fn strip(&mut self, home: &Environment, words: &[String]) -> Result<Picture, PictureError> {
        let caption = |action: usize| words.get(action).map_or("", String::as_str);
        let moments = self.moments();
        let shown = moments.iter().map(|(action, at)| captioned(&self.pictures[*at], caption(*action)));
        let shown: Vec<Picture> = shown.collect();
        if shown.is_empty() { self.pair(home) } else { Ok(Picture::sheet(&shown, 2, 4)) }
    }

    /// The home as it is, from the eyes and from the corner.
    fn pair(&mut self, home: &Environment) -> Result<Picture, PictureError> {
        let views = self.views(home)?;
        let pair = [self.shot(home, views, 0)?, self.shot(home, views, 1)?];
        Ok(Picture::sheet(&pair, 2, 4))
    }

    /// Writes the film in its formats; none if it has no picture.
    pub(super) fn write(&self, own: &mut OwnFiles) -> Result<Option<PageFilm>, RecordError> {
        if self.pictures.is_empty() {
            return Ok(None);
        }
        let small: Vec<Picture> = self.pictures.iter().map(|picture| picture.shrunk(2)).collect();
        own.write("film.gif", &picture::gif(&small, self.rate())?)?;
        own.write("film.png", &picture::apng(&small, self.rate())?)?;
        let pictures: Vec<String> = (0..self.pictures.len()).map(|i| format!("film/{i:03}.jpg")).collect();
        own.claim(pictures.iter().map(String::as_str))?;
        let (folder, written) = (own.folder(), pictures.par_iter().zip(&self.pictures));
        written.try_for_each(|(name, one)| save(&folder.join(name), &picture::jpeg(one, JPEG_QUALITY)?))?;
        Ok(Some(PageFilm {
            pictures,
            per_second: self.rate(),
            starts: self.starts.clone(),
            moments: self.moments(),
            caption: format!("From the agent's eyes and from a corner of the room, {} times as fast.", self.speed()),
        }))
    }

    /// So many ticks have passed, or the last ones of an action: now and then a picture is made, and a frame of a
    /// dataset.
    pub(super) fn go_on(&mut self, home: &Environment, dataset: Option<&mut Dataset>) -> Result<(), RecordError> {
        self.ticks += EVERY;
        if self.ticks.is_multiple_of(self.every) {
            let views = self.views(home)?;
            let pair = [self.shot(home, views, 0)?, self.shot(home, views, 1)?];
            self.pictures.push(Picture::sheet(&pair, 2, 4));
            if self.pictures.len() > MOST {
                self.thin();
            }
            self.look(home, views)?;
            self.before = Some(home.clone());
        }
        // However long the episode is, and however few pictures its film has.
        match dataset {
            Some(dataset) => dataset.add(home, Viewpoint::Agent(self.me), self.size.0, self.size.1),
            None => Ok(()),
        }
    }

    /// Keeps every other picture.
    fn thin(&mut self) {
        let mut index = 0;
        self.pictures.retain(|_| {
            index += 1;
            index % 2 == 1
        });
        self.starts.iter_mut().for_each(|t| *t /= 2);
        self.every *= 2;
    }

    /// The agent's eyes, and the camera of the room it is in.
    fn views(&mut self, home: &Environment) -> Result<[Viewpoint; 2], PictureError> {
        let room = home.room_at(feet(home, self.me)).or(self.room);
        if room != self.room {
            (self.room, self.corner) = (room, None);
        }
        let Some(room) = room else { return Ok([Viewpoint::Agent(self.me); 2]) };
        let (view, missed) = self.corner.unwrap_or((Viewpoint::Room(room), PATIENCE));
        let glance = home.render(view, Modality::Instance, GLANCE.0, GLANCE.1)?;
        let sight = sight_of(&glance, self.me);
        let missed = if sight >= 1.0 { 0 } else { missed + self.every };
        // Somebody who is not in the picture at all is looked for at once.
        let now = match sight > 0.0 && missed < PATIENCE {
            true => (view, missed),
            false => (Viewpoint::Free(home.witness(self.me, room, self.size)?), 0),
        };
        self.corner = Some(now);
        Ok([Viewpoint::Agent(self.me), now.0])
    }

    /// A picture from one of the views. An eye gets used to other light little by little, unless its view has
    /// jumped to another room.
    fn shot(&mut self, home: &Environment, views: [Viewpoint; 2], which: usize) -> Result<Picture, PictureError> {
        let (view, seconds) = (views[which], self.every as f32 * home.world().settings().dt);
        let used = self.used[which].filter(|(from, _)| *from == view);
        let adapts = used.map(|(_, from)| Adaptation::after(from, seconds));
        let frame = home.picture(
            &PictureOptions { adapts, ..*home.pictures() },
            None,
            (view, Modality::Rgb.into()),
            self.size,
        )?;
        self.used[which] = Some((view, frame.exposure));
        Ok(picture::rgb(&frame))
    }

    /// Keeps all modalities of the moment that tells most.
    fn look(&mut self, home: &Environment, views: [Viewpoint; 2]) -> Result<(), PictureError> {
        let Some(before) = self.before.take() else { return Ok(()) };
        let telling = self.telling(&before, home, views)?;
        if telling <= self.most_telling {
            return Ok(());
        }
        self.most_telling = telling;
        let sheet = |view| -> Result<Picture, PictureError> {
            let frame = before.render_until(home, view, Modalities::SIX, self.size.0, self.size.1);
            Ok(six(&frame?))
        };
        self.modalities = Some([sheet(views[0])?, sheet(views[1])?]);
        Ok(())
    }

    /// How much a moment tells: nothing unless the agent moves; more while it holds something, while
    /// all of it is seen from the corner, and the more things it sees.
    fn telling(&self, before: &Environment, now: &Environment, views: [Viewpoint; 2]) -> Result<usize, PictureError> {
        if (feet(before, self.me) - feet(now, self.me)).norm() <= 1e-3 {
            return Ok(0);
        }
        let [eyes, corner] = [(now, views[0]), (before, views[1])]
            .map(|(home, view)| home.render(view, Modality::Instance, GLANCE.0, GLANCE.1));
        let seen: BTreeSet<NodeId> = eyes?.instance.iter().copied().collect();
        let holds = now.graph().held(self.me).next().is_some();
        Ok(seen.len() + if holds { 1000 } else { 0 } + if sight_of(&corner?, self.me) >= 1.0 { 500 } else { 0 })
    }

    /// One more picture, from the corner.
    pub(super) fn end(&mut self, home: &Environment) -> Result<Picture, PictureError> {
        let views = self.views(home)?;
        self.shot(home, views, 1)
    }
}

/// A picture with a line of text below it, in smaller letters if it is long.
fn captioned(picture: &Picture, text: &str) -> Picture {
    let width = picture.width as f32;
    let high = width / CAPTION.0;
    let size = (CAPTION.1 * high).min(width / Canvas::text_width(1.0, text).max(1.0));
    let mut canvas = Canvas::new([0.0, 0.0], [width, high]);
    canvas.text([0.5 * size, 0.5 * (high - size)], size, Anchor::Start, Colour::BLACK, text);
    // A picture that can be made has a line that can be made.
    let line = canvas.to_image(picture.width).ok();
    let height = line.as_ref().map_or(0, |line| line.height);
    let mut whole = Picture::new(picture.width, picture.height + height, [255; 3]);
    whole.paste(picture, 0, 0);
    let pixels = line.map_or_else(Vec::new, |line| line.rgb.as_chunks().0.to_vec());
    whole.paste(&Picture { width: picture.width, height, pixels }, 0, picture.height);
    whole
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

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use vc_graph::clock::Span;
    use vc_graph::{Action, Verb};

    use super::*;

    /// However few pictures a film has, somebody is in each that is made from the corner.
    #[test]
    fn corners_show_the_agent() {
        let mut home = Environment::make("apartment/44756", 1).unwrap();
        let me = home.agents()[0];
        let mut film = Film { every: 4 * EVERY, ..Film::new(&home, me, 64) };
        let mut sights = Vec::new();
        let classes = ["fridge", "double_bed", "washbasin", "sofa", "wardrobe", "stove"];
        for class in classes.into_iter().take(vc_testkit::amount(3, 6)) {
            let Some(at) = home.graph().of_class(class).first().copied() else { continue };
            let every = Span(u64::from(film.every));
            let walked = home.set_action_in_time(me, Action::one(Verb::Walk, at), every, |now| {
                let [_, corner] = film.views(now).unwrap();
                sights.push(sight_of(&now.render(corner, Modality::Instance, GLANCE.0, GLANCE.1).unwrap(), me));
            });
            walked.unwrap();
        }
        assert!(sights.len() > 8 && sights.iter().all(|sight| *sight > 0.0), "{sights:?}");
    }
}
