//! Episodes written down while they happen, so that a person can look at them and a program can
//! load them.

mod dataset;
mod film;
mod journal;
mod map;
mod own;
mod trajectory;

use std::path::{Path, PathBuf};

use nalgebra::Point2;
use vc_graph::clock::Span;
use vc_graph::{Action, ChangeSet, History, Label, NodeId, SceneGraph};
use vc_planner::Summary;
use vc_render::picture;
use vc_render::{Daylight, RenderError};
use vc_tasks::{Task, World, WorldError};

use crate::{Environment, FileError, Page, PageAction, PageFilm, PictureError, PictureOptions, SaveError, files};
pub use dataset::Dataset;
use film::Film;
pub use own::OwnFiles;
use trajectory::Trajectory;

/// The caption of a sheet of six modalities.
const SIX: &str = "Colours, instances, classes; depth, optical flow, boxes and masks.";

/// An environment that writes down what happens in it.
///
/// It is a [`World`], so that a policy acts in it as in any other; each action is shown in time
/// ([`Environment::set_action_in_time`]), and after every sixth of a second pictures are made, in actions that take minutes
/// a few in all; in long episodes after every third, and so on, so that a film has no more than 180. The folder then has
///
/// | file | content |
/// |---|---|
/// | `index.html` | a page that plays the film and shows all of it ([`Page`]) |
/// | `trajectory.jsonl` | a line about the run, one for each action that was tried, with time, place and digest, one about its end: [fields](#the-trajectory) |
/// | `film/` | the film's pictures as JPEG, for the page and for tools that make videos: from the agent's eyes and from a corner of the room |
/// | `film.gif`, `film.png` | the film in half its size at twice the speed, as GIF and as animated PNG |
/// | `map.png` | the home from above, and the ways the agents went |
/// | `strip.png` | a picture of each action with its words, eight at most |
/// | `eyes.png`, `corner.png` | the six modalities at the moment that tells most |
/// | `end.png` | the end |
/// | `belief.svg` | what the agent believed in the end, if it is told |
/// | `files.txt` | the names of all these files ([`OwnFiles`]): another run removes them, and no others |
/// | `frames/`, `annotations.json`, `scene.glb` | with [`RecordOptions::dataset`]: see there |
///
/// ```no_run
/// use virtualcity::planner::{PlannerPolicy, run_episode};
/// use virtualcity::tasks::Task;
/// use virtualcity::{Environment, RecordOptions, Recorder};
///
/// let home = Environment::make("apartment/42", 1)?;
/// let task = Task::new("fetch a book", "Holds(novel)".parse()?);
/// let me = home.agents()[0];
/// let mut recorder = Recorder::create("out/episode", home, me, &task, RecordOptions::default())?;
/// let episode = run_episode(&mut PlannerPolicy::best(), &task, &mut recorder);
/// let page = recorder.finish(&episode, None)?;
/// println!("look at {}", page.display());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # The trajectory
///
/// `trajectory.jsonl` has one JSON object a line. The first is about the run:
///
/// | field | content |
/// |---|---|
/// | `scene`, `digest` | the scene's name, and the [digest](Environment::digest) of the home as the run began |
/// | `agent` | the label of the agent that the camera follows |
/// | `task`, `goal` | the title of the task, and its goal as text |
///
/// Then there is one for each action that was tried, in the order of the agents' orders. Agents that act together do so in
/// one round: all lines of it are written when the last of its actions has ended, and tell the home as it is then.
///
/// | field | content |
/// |---|---|
/// | `agent`, `action` | the label of who acted, and the action with labels, `grab cup.12` |
/// | `refused` | why it was not done, whatever the reason; `null` if it was |
/// | `round` | the number of the round, counted from 1 |
/// | `time` | the home's time at the end of the round, seconds since the record began; a reset does not count |
/// | `step` | the number of actions that all agents have done by the end of the round, since the last reset |
/// | `at` | the agent's place, metres: X, Y and Z of the point between its feet, or on its seat; `null` without a pose |
/// | `room` | the label of its room, or `null` |
/// | `held` | the labels of what it holds |
/// | `digest` | that of the home |
///
/// A [`reset`](Environment::reset) through the recorder adds a line with the scene's name as `reset` and a `digest`. The last
/// line is the [`Summary`]: `outcome` is `won`, `lost`, `timed_out` or `aborted`, `score` the share of the goal that holds, 0
/// to 1, `steps` the number of actions that were done or tried, `reason` why it ended, or `null`.
///
/// `begin.save` is the home as the run began, [saved](Environment::save). It is restored by an environment that was made
/// alike, and [`Environment::set_actions`] with the actions of each round in turn, those that were refused with them, goes
/// through the record again, digest by digest:
///
/// ```
/// use virtualcity::graph::Action;
/// use virtualcity::planner::Summary;
/// use virtualcity::tasks::{Outcome, Task, World};
/// use virtualcity::{Environment, RecordOptions, Recorder};
///
/// # let folder = std::env::temp_dir().join(format!("vc-trajectory-{}", std::process::id()));
/// let home = Environment::make("apartment/42", 2)?;
/// let (me, you) = (home.agents()[0], home.agents()[1]);
/// let walk = Action::walk(home.graph().of_class("fridge")[0]);
/// let task = Task::new("to the fridge", "Near(fridge)".parse()?);
/// let options = RecordOptions { width: 64, ..RecordOptions::default() };
/// let mut recorder = Recorder::create(&folder, home, me, &task, options)?;
/// // A round of both: waving is over before the walk.
/// let outcomes = recorder.step_together(&[(me, walk), (you, "wave".parse()?)]);
/// assert!(outcomes.iter().all(Result::is_ok));
/// recorder.finish(Summary { outcome: Outcome::Won, score: 1.0, steps: 2, reason: None }, None)?;
///
/// let text = std::fs::read_to_string(folder.join("trajectory.jsonl"))?;
/// let lines: Vec<serde_json::Value> = text.lines().map(serde_json::from_str).collect::<Result<_, _>>()?;
/// assert_eq!((lines.len(), &lines[0]["goal"]), (4, &"Near(me, fridge)".into()));
/// assert_eq!(lines[2]["action"], "wave");
/// for field in ["time", "step", "digest"] {
///     assert_eq!(lines[1][field], lines[2][field]);
/// }
/// assert_eq!((&lines[1]["step"], &lines[3]["outcome"]), (&2.into(), &"won".into()));
///
/// let begin = std::fs::read(folder.join("begin.save"))?;
/// let mut again = Environment::make("apartment/42", 2)?.restore(&begin)?;
/// assert_eq!(lines[0]["digest"], again.digest().to_string());
/// let text = |line: usize, field: &str| lines[line][field].as_str().unwrap_or_default();
/// let mut round = Vec::new();
/// for line in [1, 2] {
///     let who: virtualcity::graph::Label = text(line, "agent").parse()?;
///     round.push((who.id, text(line, "action").parse::<Action>()?));
/// }
/// again.set_actions(&round);
/// assert_eq!(lines[2]["digest"], again.digest().to_string());
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Pictures
///
/// In the film an eye that comes through a door into other light adapts to it within half a second.
///
/// Costs one pair of pictures for each sixth of a second of the home's time: 480 pixels across,
/// some twenty milliseconds. The same run writes the same files. Each file is written whole or not at all; the
/// trajectory is `trajectory.jsonl.part` until the record is finished. A run with a dataset that was broken off is
/// started again with the same arguments: actions are done again, but the dataset's pictures that are there are not
/// made again ([`Dataset`]).
pub struct Recorder {
    home: Environment,
    task: Task,
    own: OwnFiles,
    film: Film,
    dataset: Option<Dataset>,
    trajectory: Trajectory,
    /// The paths of all agents, in their order.
    ways: Vec<Vec<Point2<f32>>>,
    /// The home's time, seconds.
    time: f64,
    actions: Vec<PageAction>,
    attempts: Vec<Vec<(NodeId, Action)>>,
    /// The first thing that went wrong with pictures and files.
    failed: Option<RecordError>,
}

/// Options of a [`Recorder`]: which files it writes, how large its pictures are, and in which light.
///
/// ```
/// use virtualcity::RecordOptions;
/// use virtualcity::render::Daylight;
/// let evening = RecordOptions { daylight: Some(Daylight::at(19.0)), finer: 3, ..RecordOptions::default() };
/// assert_eq!(evening.width, 480);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RecordOptions {
    /// Pixels across of each picture; it is three quarters as high.
    pub width: u32,
    /// Whether a dataset is written as well: every sixth of a second a picture from the agent's eyes as a PNG in
    /// `frames`, boxes and masks of all that is seen in them as a COCO document for
    /// `pycocotools`, `annotations.json`, and the home as it is in the end as glTF, `scene.glb`.
    pub dataset: bool,
    /// How many times finer colours are made along each side before they are shrunk. The default is 2, as films
    /// are small and grooves of furniture thin. See [`PictureOptions::finer`].
    pub finer: u32,
    /// The light outside; by default that of the environment's [`pictures`](Environment::pictures).
    pub daylight: Option<Daylight>,
}

impl Default for RecordOptions {
    fn default() -> Self {
        Self { width: 480, dataset: false, finer: 2, daylight: None }
    }
}

/// Why an episode could not be written down.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum RecordError {
    /// A file could not be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// A picture could not be made.
    #[error("no picture of the episode can be made: {0}")]
    Picture(#[from] PictureError),
    /// The home could not be saved as the run began.
    #[error("the home cannot be saved: {0}")]
    Begin(#[from] SaveError),
    /// The scene could not be written as glTF.
    #[error("the scene cannot be written as glTF: {0}")]
    Scene(#[from] vc_gltf::GltfError),
    /// The folder has a file of a needed name that is not listed among those that this program wrote.
    #[error(
        "{path} is in the way, and no `files.txt` beside it or above lists it as written by this program (earlier \
         versions kept no list): choose another folder, or move or remove the file"
    )]
    Foreign {
        /// The path of the file.
        path: String,
    },
    /// The folder has a data set, and the run writes none.
    #[error("{path} is of a data set, and this run writes none: choose another folder, or remove the data set")]
    OfDataset {
        /// The path of one of its files.
        path: String,
    },
    /// The agent that is followed is none of the environment's.
    #[error("{agent} is no agent of this environment; it has {}", listed(.there))]
    NoSuchAgent {
        /// The agent that is to be followed.
        agent: Label,
        /// The environment's agents.
        there: Vec<Label>,
    },
}

impl<N> From<RenderError<N>> for RecordError
where
    PictureError: From<RenderError<N>>,
{
    fn from(error: RenderError<N>) -> Self {
        Self::Picture(error.into())
    }
}

fn listed(labels: &[Label]) -> String {
    labels.iter().map(Label::to_string).collect::<Vec<_>>().join(", ")
}

impl Recorder {
    /// Begins to write down what happens in an environment into a folder, which is made; the files that this program
    /// wrote there before are removed ([`OwnFiles`]). The camera follows one of its agents.
    ///
    /// # Errors
    /// [`RecordError::NoSuchAgent`]; [`RecordError::Foreign`] if the folder has files of a record's names, such as
    /// `index.html`, that this program did not write; [`RecordError::OfDataset`] if it has a data set and this record
    /// has none; [`RecordError::File`] if the folder or a file in it cannot be made.
    pub fn create(
        folder: impl AsRef<Path>,
        mut home: Environment,
        agent: NodeId,
        task: &Task,
        options: RecordOptions,
    ) -> Result<Self, RecordError> {
        if !home.agents().contains(&agent) {
            let label = |id: &NodeId| home.graph().label(*id);
            let there = home.agents().iter().map(label).collect();
            return Err(RecordError::NoSuchAgent { agent: label(&agent), there });
        }
        let width = options.width;
        if width == 0 || width > vc_render::camera::MAX_SIDE {
            let bad = RenderError::BadSize { width, height: width, longest: vc_render::camera::MAX_SIDE };
            return Err(PictureError::Render(bad).into());
        }
        let daylight = options.daylight.unwrap_or(home.pictures().daylight);
        home.set_pictures(PictureOptions { daylight, finer: options.finer, ..*home.pictures() });
        let folder = folder.as_ref();
        std::fs::create_dir_all(folder).map_err(at(folder))?;
        let mut own = OwnFiles::open(folder)?;
        clear(&mut own, options.dataset)?;
        own.claim([trajectory::FILES[1]])?;
        own.write(BEGIN, &home.save()?)?;
        let trajectory = Trajectory::begin(folder, &home, agent, task)?;
        let dataset = options.dataset.then(|| Dataset::create(folder)).transpose()?;
        let film = Film::new(&home, agent, options.width);
        let ways = home.agents().iter().map(|agent| vec![feet(&home, *agent)]).collect();
        let task = task.clone();
        let (actions, attempts, failed) = (Vec::new(), Vec::new(), None);
        Ok(Self { home, task, own, film, dataset, trajectory, ways, time: 0.0, actions, attempts, failed })
    }

    /// The environment as it is.
    pub fn environment(&self) -> &Environment {
        &self.home
    }

    /// Every action that was tried, whatever came of it, with those that were tried at the same time: in a home that
    /// began alike, [`Environment::set_actions`] with each list in turn leads to the same end.
    pub fn attempts(&self) -> &[Vec<(NodeId, Action)>] {
        &self.attempts
    }

    /// The length of all agents' paths together, metres.
    pub fn metres(&self) -> f32 {
        let length = |way: &Vec<Point2<f32>>| -> f32 { way.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum() };
        // A sum of nothing is minus zero.
        self.ways.iter().map(length).sum::<f32>() + 0.0
    }

    /// The home's time, seconds.
    pub fn seconds(&self) -> f64 {
        self.time
    }

    /// Writes the files that are made at the end, among them `belief` (an SVG, as
    /// [`Belief::to_svg`](vc_planner::Belief::to_svg) draws it), and returns the path of the page
    /// that shows them all. `end` is an [`Episode`](vc_planner::Episode), a
    /// [`TeamEpisode`](vc_planner::TeamEpisode) or the summary of one.
    ///
    /// # Errors
    /// [`RecordError`], the first that there was.
    pub fn finish(mut self, end: impl Into<Summary>, belief: Option<&str>) -> Result<PathBuf, RecordError> {
        let summary: Summary = end.into();
        if let Some(error) = self.failed.take() {
            return Err(error);
        }
        self.trajectory.end(&summary)?;
        let end = self.film.end(&self.home)?;
        self.own.write("end.png", &picture::png(&end)?)?;
        self.own.write("map.png", &picture::png(&map::of(&self.home, &self.ways)?)?)?;
        let words: Vec<String> = self.actions.iter().enumerate().map(|(i, action)| action.caption(i)).collect();
        let strip = self.film.strip(&self.home, &words)?;
        self.own.write("strip.png", &picture::png(&strip)?)?;
        let film = self.film.write(&mut self.own)?;
        if let Some([eyes, corner]) = self.film.modalities() {
            self.own.write("eyes.png", &picture::png(eyes)?)?;
            self.own.write("corner.png", &picture::png(corner)?)?;
        }
        if let Some(belief) = belief {
            self.own.write("belief.svg", belief.as_bytes())?;
        }
        let page = self.page(summary, film, belief.is_some());
        if let Some(dataset) = self.dataset.take() {
            dataset.finish()?;
            self.own.write("scene.glb", &self.home.gltf()?)?;
        }
        self.own.write("index.html", page.html().as_bytes())?;
        self.own.settle()?;
        Ok(self.own.folder().join("index.html"))
    }

    /// The page about the files in the folder.
    fn page(&self, summary: Summary, film: Option<PageFilm>, has_belief: bool) -> Page {
        let (title, scene, goal) = (&self.task.title, self.home.graph().name(), self.task.goal.to_string());
        let mut page = Page::new(title, scene, &goal, summary);
        let way = if self.ways.len() > 1 { "The first agent's from blue to red." } else { "From blue to red." };
        page.facts = vec![format!("{:.1} m", self.metres()), format!("{:.0} s in the home", self.time)];
        page.actions.clone_from(&self.actions);
        page = page.figure("map.png", "The way", way).figure("end.png", "The end", "");
        if has_belief {
            page = page.figure("belief.svg", "What it believed in the end", Page::BELIEF);
        }
        if self.film.modalities().is_some() {
            page = page.figure("eyes.png", "Six modalities from the agent's eyes", SIX);
            page = page.figure("corner.png", "Six modalities from a corner of the room", SIX);
        }
        page = page.file("trajectory.jsonl", "every action with time, place and digest, as JSON Lines");
        page = page.file(BEGIN, "the home as the run began, for `Environment::restore`");
        if let Some(film) = &film {
            let video =
                format!("the film; `ffmpeg -framerate {} -i film/%03d.jpg film.mp4` makes a video", film.per_second);
            page = page.file("film.gif", &video).file("film.png", "the same as animated PNG");
        }
        if self.dataset.is_some() {
            page = page.file("annotations.json", "boxes and masks of `frames/` as COCO");
            page = page.file("scene.glb", "the home in the end as glTF");
        }
        page.film = film;
        page
    }

    /// The time between two looks at an action. One that takes minutes is shown in a few seconds.
    fn every(&self, action: &Action) -> Span {
        let long = self.home.duration(action).unwrap_or_default();
        Span(u64::from(film::EVERY).max(long.0 / LOOKS))
    }

    /// Adds an action that has ended to the trajectory and to the page.
    fn write_action(&mut self, agent: NodeId, words: String, why: Option<String>) {
        let when = (self.attempts.len(), self.time);
        let noted = self.trajectory.step(&self.home, agent, &words, when, why.as_deref());
        self.note(noted);
        let label = |id| self.home.graph().label(id).to_string();
        self.actions.push(PageAction {
            agent: (self.home.agents().len() > 1).then(|| label(agent)),
            action: words,
            refused: why,
            room: self.home.graph().room_of(agent).map(label),
            seconds: Some(self.time),
            found: Vec::new(),
        });
    }

    fn note(&mut self, outcome: Result<(), RecordError>) {
        if self.failed.is_none() {
            self.failed = outcome.err();
        }
    }
}

impl World for Recorder {
    fn graph(&self) -> &SceneGraph {
        self.home.graph()
    }

    fn history(&self) -> &History {
        self.home.history()
    }

    fn step(&mut self, agent: NodeId, action: &Action) -> Result<ChangeSet, WorldError> {
        self.step_together(&[(agent, *action)]).pop().unwrap_or_else(|| Ok(ChangeSet::default()))
    }

    /// The film follows the first agent.
    fn step_together(&mut self, actions: &[(NodeId, Action)]) -> Vec<Result<ChangeSet, WorldError>> {
        let words: Vec<String> =
            actions.iter().map(|(_, action)| action.describe(self.home.graph()).to_string()).collect();
        actions.iter().rev().for_each(|(agent, _)| self.film.begin_action(&self.home, *agent));
        self.attempts.push(actions.to_vec());
        let every = actions.iter().map(|(_, action)| self.every(action)).max().unwrap_or_default();
        let (begin, mut failed) = (self.home.tick(), None);
        let outcomes = self.home.set_actions_in_time(actions, every, |now| {
            go_on(&mut self.ways, now);
            if failed.is_none() {
                failed = self.film.go_on(now, self.dataset.as_mut()).err();
            }
        });
        self.note(failed.map_or(Ok(()), Err));
        self.time += (self.home.tick() - begin).seconds();
        go_on(&mut self.ways, &self.home);
        for (((agent, _), words), outcome) in actions.iter().zip(words).zip(&outcomes) {
            self.write_action(*agent, words, outcome.as_ref().err().map(ToString::to_string));
        }
        outcomes.into_iter().map(|outcome| outcome.map_err(WorldError::from)).collect()
    }

    fn has_clock(&self) -> bool {
        true
    }

    /// The record goes on, with a line that says so.
    fn reset(&mut self, graph: &SceneGraph) -> Result<(), WorldError> {
        World::reset(&mut self.home, graph)?;
        let noted = self.trajectory.reset(&self.home);
        self.note(noted);
        Ok(())
    }
}

/// Adds to each agent's path where it is now.
fn go_on(ways: &mut [Vec<Point2<f32>>], home: &Environment) {
    ways.iter_mut().zip(home.agents()).for_each(|(way, agent)| way.push(feet(home, *agent)));
}

/// Where an agent's feet are.
fn feet(home: &Environment, agent: NodeId) -> Point2<f32> {
    home.world().pose(agent).map_or_else(Point2::origin, |p| p.translation.vector.xy().into())
}

/// Looks at an action that takes longer than bodies need.
const LOOKS: u64 = 24;

/// The home as the run began.
const BEGIN: &str = "begin.save";

/// The files of a record, besides those of its film and its dataset.
const FILES: [&str; 13] = [
    BEGIN,
    "index.html",
    "film.gif",
    "film.png",
    "map.png",
    "strip.png",
    "eyes.png",
    "corner.png",
    "end.png",
    "belief.svg",
    "scene.glb",
    trajectory::FILES[0],
    trajectory::FILES[1],
];

/// Removes the files of another run, which would stay among the new ones. A data set stays if this record
/// has one, as it may go on with that.
fn clear(own: &mut OwnFiles, has_dataset: bool) -> Result<(), RecordError> {
    if has_dataset {
        Dataset::check(own)?
    } else {
        Dataset::spare(own)?
    }
    own.refuse(&FILES, &[("film", "jpg")])?;
    own.remove(|name| !Dataset::is_of_one(name))
}

/// The error of a file, or of a folder whose files they are.
fn at(path: &Path) -> impl Fn(std::io::Error) -> RecordError {
    move |error| FileError::unwritten(path, error).into()
}

fn save(path: &Path, bytes: &[u8]) -> Result<(), RecordError> {
    Ok(files::write(path, bytes)?)
}
