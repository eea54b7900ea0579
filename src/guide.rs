//! Recipes for the first day. Each is a complete program, and all of them run as tests.
//!
//! 1. [Many homes at once](#many-homes-at-once)
//! 2. [A policy of your own](#a-policy-of-your-own)
//! 3. [Rewards, action by action](#rewards-action-by-action)
//! 4. [A data set of several homes](#a-data-set-of-several-homes)
//! 5. [A scene of VirtualHome with bodies](#a-scene-of-virtualhome-with-bodies)
//! 6. [A team](#a-team)
//! 7. [A search that tries actions on copies](#a-search-that-tries-actions-on-copies)
//! 8. [Placing things and agents](#placing-things-and-agents)
//! 9. [Paths from your own planner](#paths-from-your-own-planner)
//! 10. [A language model](#a-language-model)
//! 11. [Pictures as data](#pictures-as-data)
//! 12. [Cameras and sensors of your own](#cameras-and-sensors-of-your-own)
//! 13. [Legal actions with things in view](#legal-actions-with-things-in-view)
//! 14. [Tasks that are certainly feasible](#tasks-that-are-certainly-feasible)
//! 15. [Resetting to an edited graph](#resetting-to-an-edited-graph)
//! 16. [Several agents at the same time](#several-agents-at-the-same-time)
//! 17. [Actions at points](#actions-at-points)
//! 18. [Words of your own](#words-of-your-own)
//! 19. [Control in every tick](#control-in-every-tick)
//! 20. [Streets of a real place](#streets-of-a-real-place)
//!
//! # Many homes at once
//!
//! A [`Batch`](crate::Batch) steps environments side by side on all cores; outcomes do not depend on how many there
//! are.
//!
//! ```
//! use virtualcity::Batch;
//!
//! let mut batch = Batch::make((0..3).map(|seed| format!("apartment/{seed}")), 1)?;
//! for turn in 0..3 {
//!     // One list of actions for each home, with one action for each agent that acts.
//!     let mut actions = Vec::new();
//!     for home in batch.environments() {
//!         let me = home.agents()[0];
//!         let legal = home.legal_actions(me);
//!         println!("{} things in view, {} actions to choose from", home.room_observation(me).len(), legal.len());
//!         actions.push(vec![(me, legal[turn])]);
//!     }
//!     let outcomes = batch.set_actions(&actions);
//!     assert!(outcomes.iter().flatten().all(Result::is_ok), "{outcomes:?}");
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A policy of your own
//!
//! A type that implements [`Policy`](crate::planner::Policy) can be run like the built-in policies,
//! symbolically or with bodies, and be recorded. This one goes to the first thing of a class that it sees and takes it.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::{Action, NodeId, Observation, Verb};
//! use virtualcity::planner::{EpisodeStart, Decision, Learned, Plan, Policy, run_episode};
//! use virtualcity::tasks::{Outcome, Task};
//!
//! #[derive(Default)]
//! struct Taker {
//!     wanted: Option<NodeId>,
//!     walked: bool,
//! }
//!
//! impl Policy for Taker {
//!     fn name(&self) -> &str {
//!         "taker"
//!     }
//!
//!     // Then an episode ends as soon as the goal holds.
//!     fn knows_when_to_stop(&self) -> bool {
//!         false
//!     }
//!
//!     fn begin(&mut self, _: &EpisodeStart<'_>) {
//!         *self = Self::default();
//!     }
//!
//!     fn see(&mut self, seen: &Observation) -> Learned {
//!         let novel = seen.nodes().find(|node| &**node.class() == "novel");
//!         self.wanted = novel.map(|node| node.id());
//!         Learned::default()
//!     }
//!
//!     fn decide(&mut self) -> Decision {
//!         let Some(novel) = self.wanted else { return Decision::Done };
//!         let verb = if self.walked { Verb::Grab } else { Verb::Walk };
//!         Decision::Act(Action::one(verb, novel), Plan::default())
//!     }
//!
//!     fn did(&mut self, _: &Action) {
//!         self.walked = true;
//!     }
//! }
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let task = Task::new("take a novel", "Holds(novel)".parse()?);
//! let episode = run_episode(&mut Taker::default(), &task, &mut home);
//! assert_eq!((episode.outcome, episode.steps), (Outcome::Won, 2));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A refused action ends the episode, unless the policy overrides [`refused`](crate::planner::Policy::refused). This one
//! tries a list of verbs on a sofa and goes on with the next when one is refused.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::{Action, NodeId, Observation, Verb};
//! use virtualcity::planner::{EpisodeStart, Decision, Learned, Plan, Policy, RefusalResponse, run_episode};
//! use virtualcity::tasks::{Outcome, Task, WorldError};
//!
//! #[derive(Default)]
//! struct Trier {
//!     sofa: Option<NodeId>,
//!     verbs: Vec<Verb>,
//! }
//!
//! impl Policy for Trier {
//!     fn name(&self) -> &str {
//!         "trier"
//!     }
//!
//!     fn begin(&mut self, brief: &EpisodeStart<'_>) {
//!         self.sofa = brief.scene.of_class("sofa").first().copied();
//!         self.verbs = vec![Verb::Sit, Verb::Walk, Verb::Grab, Verb::Open]; // from the last to the first
//!     }
//!
//!     fn see(&mut self, _: &Observation) -> Learned {
//!         Learned::default()
//!     }
//!
//!     fn decide(&mut self) -> Decision {
//!         let (Some(sofa), Some(verb)) = (self.sofa, self.verbs.pop()) else { return Decision::Done };
//!         Decision::Act(Action::one(verb, sofa), Plan::default())
//!     }
//!
//!     fn did(&mut self, _: &Action) {}
//!
//!     fn refused(&mut self, action: &Action, why: &WorldError) -> RefusalResponse {
//!         println!("{action}: {why}");
//!         RefusalResponse::GoOn
//!     }
//! }
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let task = Task::new("sit down", "SittingOn(me, sofa)".parse()?);
//! let episode = run_episode(&mut Trier::default(), &task, &mut home);
//! assert_eq!((episode.outcome, episode.steps), (Outcome::Won, 4));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Rewards, action by action
//!
//! A [`Trial`](crate::tasks::Trial) turns the control around: your loop asks for observations and rewards.
//! [`legal_actions`](crate::Environment::legal_actions) lists the actions to choose from.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::{Seed, Verb};
//! use virtualcity::tasks::{Task, Trial};
//!
//! let home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let task = Task { step_limit: 5, ..Task::new("sit down", "SittingOn(me, sofa)".parse()?) };
//! let mut trial = Trial::new(home, task, me);
//! let mut stream = Seed(1).stream();
//! let mut seen = trial.reset()?;
//! loop {
//!     let legal = trial.world().legal_actions(me);
//!     let Some(action) = stream.pick(&legal).copied() else { break };
//!     let step = trial.step(&action);
//!     println!("{}: {} ({} things in view)", action.describe(trial.world().graph()), step.reward, seen.len());
//!     if step.terminated || step.truncated || step.lost.is_some() {
//!         break;
//!     }
//!     seen = step.observation;
//! }
//! assert!(trial.steps() <= 5);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A data set of several homes
//!
//! One COCO document for all homes, with identifiers that are unique across them: `pycocotools` reads it.
//!
//! ```
//! use virtualcity::{Dataset, Environment, Viewpoint};
//!
//! # let folder = std::env::temp_dir().join(format!("vc-guide-{}", std::process::id()));
//! # let out = folder.join("rooms");
//! let mut dataset = Dataset::create(&out)?;
//! for seed in [1, 2] {
//!     let home = Environment::make(&format!("apartment/{seed}"), 1)?;
//!     for room in home.graph().rooms().iter().take(2) {
//!         dataset.add(&home, Viewpoint::Room(*room), 64, 48)?;
//!     }
//! }
//! assert_eq!(dataset.pictures(), 4);
//! let annotations = dataset.finish()?;
//! assert!(std::fs::read_to_string(annotations)?.contains("supercategory"));
//! # std::fs::remove_dir_all(folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A scene of VirtualHome with bodies
//!
//! `scene:FILE` reads VirtualHome's environment graphs, gzipped or not, the thesis's JSON and VirtualCity's own
//! format. The files are not part of this project: this recipe looks for them in the folder that `VC_DATA`
//! names, and does nothing if they are missing.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::{Action, Verb};
//!
//! let file = std::path::PathBuf::from(std::env::var_os("VC_DATA").unwrap_or_default()).join("virtualhome/scene1.json.gz");
//! if !file.is_file() {
//!     println!("SKIPPED: there is no {}", file.display());
//!     return Ok::<(), Box<dyn std::error::Error>>(());
//! }
//! let mut home = Environment::make(&format!("scene:{}", file.display()), 1)?;
//! let me = home.agents()[0];
//! println!("{} things; {} have no place", home.graph().len(), home.left_out().len());
//! let fridge = home.graph().of_class("fridge")[0];
//! match home.set_action(me, Action::one(Verb::Walk, fridge)) {
//!     Ok(_) => println!("at the fridge"),
//!     Err(why) => println!("{why}"),
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A team
//!
//! A [`Team`](crate::planner::Team) shares a goal and the observations of its agents. A
//! [`Recorder`](crate::Recorder) around the environment writes a film and a page; its `finish` takes the
//! episode of a team or of a single agent.
//!
//! ```
//! use virtualcity::planner::Team;
//! use virtualcity::tasks::{Outcome, Task};
//! use virtualcity::{Environment, RecordOptions, Recorder};
//!
//! # let folder = std::env::temp_dir().join(format!("vc-guide-team-{}", std::process::id()));
//! # let out = folder.join("team");
//! let home = Environment::make("apartment/42", 2)?;
//! let agents = home.agents().to_vec();
//! let task = Task::new("a book and a pillow", "Holds(novel) & On(pillow, sofa)".parse()?);
//! let mut team = Team::oracles(home.graph(), &agents, &task.goal);
//! let options = RecordOptions { width: 64, ..RecordOptions::default() };
//! let mut recorder = Recorder::create(&out, home, agents[0], &task, options)?;
//! let episode = team.run(&task, &mut recorder);
//! assert_eq!(episode.outcome, Outcome::Won);
//! let page = recorder.finish(&episode, None)?;
//! assert!(page.is_file());
//! # std::fs::remove_dir_all(folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A search that tries actions on copies
//!
//! A clone is a snapshot that costs about a millisecond and evolves as the original does, bit for bit. A tree
//! search needs nothing else; this one has depth two and is greedy by the share of the goal that holds.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::{Action, NodeId, Verb};
//! use virtualcity::tasks::Task;
//!
//! /// The best score within `depth` actions, and the first of those actions.
//! fn search(home: &Environment, me: NodeId, task: &Task, depth: usize) -> (f64, Option<Action>) {
//!     let mut best = (task.score(home, me), None);
//!     if depth == 0 || best.0 == 1.0 {
//!         return best;
//!     }
//!     let verbs = [Verb::Open, Verb::Close, Verb::SwitchOn];
//!     let fridge = home.graph().of_class("fridge")[0];
//!     let television = home.graph().of_class("television")[0];
//!     for action in verbs.into_iter().flat_map(|verb| [fridge, television].map(|id| Action::one(verb, id))) {
//!         let mut copy = home.clone();
//!         if copy.set_action(me, action).is_ok() {
//!             let (score, _) = search(&copy, me, task, depth - 1);
//!             if score > best.0 {
//!                 best = (score, Some(action));
//!             }
//!         }
//!     }
//!     best
//! }
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let television = home.graph().of_class("television")[0];
//! home.set_action(me, Action::one(Verb::Walk, television))?;
//! let task = Task::new("television", "SwitchedOn(television)".parse()?);
//! let before = home.digest();
//! let (score, first) = search(&home, me, &task, 2);
//! assert_eq!((score, first), (1.0, Some(Action::one(Verb::SwitchOn, television))));
//! assert_eq!(home.digest(), before);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A copy in which somebody has acted takes megabytes. A search that keeps many keeps their
//! [states](crate::EnvironmentState) instead, some kilobytes each; bodies are built anew where somebody acts, and evolve
//! alike, bit for bit, in the home that was saved and in all that are restored. This one is breadth first.
//!
//! ```
//! use std::collections::{HashSet, VecDeque};
//! use virtualcity::Environment;
//! use virtualcity::graph::Verb;
//! use virtualcity::tasks::Task;
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let (me, fridge) = (home.agents()[0], home.graph().of_class("fridge")[0]);
//! let task = Task::new("milk", "Open(fridge)".parse()?);
//! let mut open = VecDeque::from([home.save_state()?]);
//! let mut seen = HashSet::from([home.graph().digest()]);
//! let won = 'search: loop {
//!     let state = open.pop_front().ok_or("no way")?;
//!     let parent = home.restore_state(&state)?;
//!     let about = |verb| matches!(verb, Verb::Walk | Verb::Open | Verb::SwitchOn);
//!     for action in parent.legal_actions(me).into_iter().filter(|a| about(a.verb) && a.object == Some(fridge)) {
//!         let mut child = parent.clone();
//!         if child.set_action(me, action).is_err() || !seen.insert(child.graph().digest()) {
//!             continue;
//!         }
//!         if task.score(&child, me) == 1.0 {
//!             break 'search child;
//!         }
//!         // One in which something still rolls, say, is passed over.
//!         open.extend(child.save_state().ok());
//!     }
//! };
//! let verbs: Vec<Verb> = won.history().events().iter().map(|event| event.action.verb).collect();
//! assert_eq!(verbs, [Verb::Walk, Verb::Open]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Placing things and agents
//!
//! ```
//! use virtualcity::graph::{Place, Relation};
//! use virtualcity::nalgebra::Point2;
//! use virtualcity::{AlterError, Environment};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let (me, kitchen) = (home.agents()[0], home.graph().of_class("kitchen")[0]);
//! let table = home.graph().of_class("coffee_table")[0];
//! let fridge = home.graph().of_class("fridge")[0];
//! // A new mug on the table, and then in the fridge, which stays closed.
//! let mug = home.spawn("mug", Place { relation: Relation::On, at: table })?;
//! home.put(mug, Place { relation: Relation::Inside, at: fridge })?;
//! assert_eq!(home.graph().hidden_in(mug), Some(fridge));
//! // The agent in another room, and at a point.
//! home.teleport(me, kitchen)?;
//! let here = home.world().pose(me).ok_or("no body")?.translation.vector.xy();
//! home.teleport(me, Point2::from(here))?;
//! // An impossible request is an error and changes nothing.
//! assert!(matches!(home.spawn("flooble", Place { relation: Relation::On, at: table }), Err(AlterError::NoSuchClass { .. })));
//! assert!(home.objects().iter().any(|object| object.id == mug && object.room == Some(kitchen)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Paths from your own planner
//!
//! The walkable floor is available as a grid for your own planner; here it is searched breadth first. The body
//! is then steered, or teleported to the end of the path. (`home.floor().route(from, to)` is the built-in
//! planner, for paths at any angle.)
//!
//! ```
//! use std::collections::{BTreeMap, VecDeque};
//! use virtualcity::Environment;
//! use virtualcity::nalgebra::Point2;
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let grid = home.occupancy();
//! let here = Point2::from(home.world().pose(me).ok_or("no body")?.translation.vector.xy());
//! let start = grid.cell_of(here).ok_or("off the grid")?;
//! let mut from = BTreeMap::from([(start, start)]);
//! let mut open = VecDeque::from([start]);
//! let mut last = start;
//! while let Some((column, row)) = open.pop_front() {
//!     last = (column, row);
//!     let beside = [(column + 1, row), (column.wrapping_sub(1), row), (column, row + 1), (column, row.wrapping_sub(1))];
//!     for next in beside {
//!         if grid.is_free(next.0, next.1) && !from.contains_key(&next) {
//!             from.insert(next, (column, row));
//!             open.push_back(next);
//!         }
//!     }
//! }
//! // The farthest reachable cell.
//! let steps = std::iter::successors(Some(last), |cell| (*cell != start).then(|| from[cell])).count();
//! assert!(steps as f32 * grid.cell > 4.0, "{steps} cells of {} m", grid.cell);
//! home.teleport(me, grid.centre(last.0, last.1))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A language model
//!
//! [`LanguageModel`](crate::planner::LanguageModel) is a policy that asks a closure, in which you call your
//! model. The closure gets a prompt: the task, the things in view, the actions done so far and the actions
//! possible now, as text and as a JSON schema of answers. The examples `language_model` and
//! `language_endpoint` show recorded answers and a local server.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::planner::language::Prompt;
//! use virtualcity::planner::{LanguageModel, run_episode};
//! use virtualcity::tasks::{Outcome, Task};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let task = Task { step_limit: 8, ..Task::new("have a seat", "SittingOn(me, sofa)".parse()?) };
//! // In place of a model: the first action that sits down on a sofa.
//! let mut model = LanguageModel::new(|prompt: &Prompt| {
//!     let answer = prompt.actions.iter().find(|action| action.starts_with("sit sofa"));
//!     Ok::<String, String>(answer.cloned().unwrap_or_else(|| "done".into()))
//! });
//! let episode = run_episode(&mut model, &task, &mut home);
//! assert_eq!(episode.outcome, Outcome::Won, "{:?}", episode.reason);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Pictures as data
//!
//! Frames hold plain lists, one value for each pixel, row by row: node and class numbers, depths in metres,
//! colours.
//!
//! ```
//! use virtualcity::render::{Modality, format, picture};
//! use virtualcity::{Environment, Viewpoint};
//!
//! let home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let wanted = Modality::Rgb | Modality::Instance | Modality::Depth;
//! let frame = home.render(Viewpoint::Agent(me), wanted, 64, 48)?;
//! let seen: std::collections::BTreeSet<_> = frame.instance.iter().collect();
//! println!("{} things are seen; the middle is {:.2} m away", seen.len(), frame.depth[24 * 64 + 32]);
//! let png: Vec<u8> = picture::png(&picture::rgb(&frame))?;
//! let npy: Vec<u8> = format::npy(&frame.depth, &[frame.height, frame.width])?;
//! assert!(png.starts_with(b"\x89PNG") && npy.len() > 4 * 64 * 48);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Cameras and sensors of your own
//!
//! [`cameras`](crate::Environment::cameras) lists all cameras by number and name. Others are added at a pose, on a head, a
//! hand or a thing, behind an agent, or above; by a field of view or by intrinsics. [`sensors`](crate::sensors) has a
//! fisheye, noisy depth and a lidar, and the trait for sensors of your own.
//!
//! ```
//! use virtualcity::graph::Pose;
//! use virtualcity::physics::Hand;
//! use virtualcity::render::Modality;
//! use virtualcity::sensors::Lidar;
//! use virtualcity::{Environment, Lens, Mount, Viewpoint};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! home.add_camera("behind", Mount::Following { agent: me, behind: 1.8, above: 0.7 }, Lens::FieldOfView(1.1))?;
//! home.add_camera("wrist", Mount::wrist(me, Hand::Right), Lens::Options)?;
//! for (id, camera) in home.cameras() {
//!     let frame = home.render(Viewpoint::Camera(id), Modality::Depth, 32, 24)?;
//!     println!("{id}, {}: {:.2} m in the middle", camera.name, frame.depth[12 * 32 + 16]);
//! }
//! // Cameras are kept with `save`, and as a list of their own.
//! let list: String = home.cameras_json();
//!
//! let hat = Mount::Head { agent: me, offset: Pose::translation(-0.14, 0.0, 0.25) };
//! let lidar = home.add_sensor("lidar", hat, Lidar { columns: 90, ..Lidar::default() })?;
//! let points = home.sense(lidar)?.scan().map_or(0, |scan| scan.in_home().count());
//! assert!(points > 1000, "{points} of 1440 rays come back");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Legal actions with things in view
//!
//! [`legal_actions`](crate::Environment::legal_actions) lists all actions that are possible in the whole home.
//! For an agent that chooses among visible things, `rule::legal_actions_with` takes these things as an
//! argument. [`objects_in_view`](crate::Environment::objects_in_view) lists the visible things as data for
//! JSON.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::{Action, NodeId, Verb, rule};
//!
//! let home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let view: Vec<NodeId> = home.room_observation(me).ids().collect();
//! let mut able = rule::legal_actions_with(home.graph(), me, &view);
//! // Rooms are always known. Two verbs are excluded: nobody types on a table.
//! able.retain(|action| !matches!(action.verb, Verb::Rinse | Verb::Type));
//! assert!(able.iter().flat_map(Action::things).all(|id| view.contains(&id)));
//! assert!(able.len() < home.legal_actions(me).len());
//! println!("{}", serde_json::to_string(&home.objects_in_view(me))?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Tasks that are certainly feasible
//!
//! A home generated from a seed may have no mug, and then an episode about mugs is lost at once: its
//! [`reason`](crate::planner::Episode::reason) says which things the home lacks. `Task::obstacles` says so
//! beforehand. For the 145 tasks of the benchmark, and your own tasks in that form,
//! [`at_home_that`](crate::initial::at_home_that) finds a home and adds the missing things to it, so that
//! nothing of the goal is done yet and all of it can be.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::Seed;
//! use virtualcity::initial::{at_home_that, feasible, generator};
//! use virtualcity::planner::{PlannerPolicy, run_episode};
//! use virtualcity::tasks::library::Benchmark;
//! use virtualcity::tasks::{Outcome, Task, WorldError};
//!
//! let home = Environment::make("apartment/42", 1)?;
//! let asked = Task::new("to the sea", "Holds(surfboard)".parse()?);
//! println!("{}", asked.obstacles(home.graph())[0]);
//!
//! let benchmark = Benchmark::v1();
//! let activity = benchmark.get("put_fridge-01").ok_or("no such task")?;
//! let open = |scene| Environment::from_scene(scene, 1).map_err(WorldError::failed);
//! let suits = |home: &Environment, initial: &_| feasible(activity, home, initial);
//! let mut made = at_home_that(activity, Seed(3), &generator(), open, suits)?;
//! let episode = run_episode(&mut PlannerPolicy::best(), &made.initial.task, &mut made.world);
//! assert_eq!(episode.outcome, Outcome::Won, "{:?}", episode.reason);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Resetting to an edited graph
//!
//! A graph in which things and agents have other places is put in force by [`reset`](crate::Environment::reset). Poses
//! need not be given: a thing with its old pose and a new place gets a free spot there, with all that it carries. The
//! report has what moved, and what could not be put where the graph has it, with the reason.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::{Place, Relation};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let (me, mut graph) = (home.agents()[0], home.start().clone());
//! let one = |class: &str| home.start().of_class(class)[0];
//! let (table, novel, sofa) = (one("coffee_table"), one("novel"), one("sofa"));
//! let kitchen = one("kitchen");
//! let mut edit = graph.edit();
//! edit.place(novel, Place { relation: Relation::On, at: table })?;
//! edit.move_to_room(me, kitchen)?;
//! edit.place(sofa, Place { relation: Relation::On, at: table })?; // too large
//! edit.commit();
//! let report = home.reset(&graph)?;
//! assert_eq!(report.moved, [novel, me]);
//! assert!(home.world().supports(novel).contains(&table));
//! assert_eq!(home.graph().room_of(me), Some(kitchen));
//! for left in &report.elsewhere {
//!     println!("{left}"); // sofa.103 is not on coffee_table.104: no spot on coffee_table.104 is free and ...
//! }
//! assert_eq!(report.elsewhere.len(), 1);
//! // Nothing remains of it after a reset to the start.
//! home.reset(&home.start().clone())?;
//! assert_ne!(home.graph().room_of(me), Some(kitchen));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Several agents at the same time
//!
//! [`Environment::set_actions`](crate::Environment::set_actions) lets several agents act side by side, each to the end of its
//! action. With [`give`](crate::Environment::give) and [`step`](crate::Environment::step) a program decides in between: one
//! tick is a sixtieth of a second. Actions that end in a step come back with their tick; one that somebody thwarts ends with
//! an [`Interruption`](crate::Interruption).
//!
//! ```
//! use virtualcity::graph::clock::Span;
//! use virtualcity::graph::{Action, Relation, Verb};
//! use virtualcity::{ActionError, Environment};
//!
//! let mut home = Environment::make("apartment/42", 2)?;
//! let (me, you) = (home.agents()[0], home.agents()[1]);
//! let fridge = home.graph().of_class("fridge")[0];
//! home.give(me, Action::one(Verb::Walk, fridge));
//! home.give(you, Action::one(Verb::Walk, fridge));
//! let minute = Span::from_seconds(60.0);
//! for ending in home.step_until_idle(minute) {
//!     println!("{}: {} is there", ending.tick, home.graph().label(ending.agent));
//! }
//!
//! // Both open it; one is faster, or has the lower number.
//! home.give(me, Action::one(Verb::Open, fridge));
//! home.give(you, Action::one(Verb::Open, fridge));
//! while home.is_busy() {
//!     for ending in home.step(Span(6)) {
//!         match ending.outcome {
//!             Ok(_) => println!("{}: {} has done it", ending.tick, home.graph().label(ending.agent)),
//!             Err(ActionError::Interrupted { why, .. }) => println!("{}: {why}", ending.tick),
//!             Err(other) => println!("{}: {other}", ending.tick),
//!         }
//!     }
//!     // This tick as it is seen, the door half open; nothing that is done to it changes the home.
//!     let moment = home.moment();
//!     let open = moment.world().parts(fridge).openness();
//!     println!("{}: open {:?}, {} things in it", moment.tick(), open, moment.graph().relating(Relation::Inside, fridge).count());
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Actions at points
//!
//! An action may have an [`Aim`](crate::graph::Aim): a coordinate, a rotation, a seat, a slot or a side. Points are in the
//! world's frame, metres, Z up; headings are degrees counter-clockwise from X. Point and heading of a thing are those of
//! its pose, those of an agent are of its feet. In the text of an action they come after its objects.
//!
//! | text | meaning |
//! |---|---|
//! | `walk at 3.20 1.50 yaw 90`, `run at 3.20 1.50` | to a point of the floor, turned so |
//! | `walk table.3 at 3.20 1.50`, `walk table.3 yaw 90` | to this point near a thing; up to it and turned so |
//! | `turn_to yaw 90`, `turn_to at 3.20 1.50`, `point_at at 3.20 1.50 1.80` | to a heading, to a point, at a place |
//! | `place cup.12 table.3 at 1.20 0.40 yaw 90` | at a point of a surface, turned so; `put_in` takes the same |
//! | `put_in plate.7 dishwasher.4 slot 2`, `place pan.5 stove.6 slot 1` | in this rack, shelf or drawer; on this burner |
//! | `drop cup.12 at 2.00 1.00` | at a point of the floor |
//! | `grab cup.12 by left` | by the front, back, left, right or top |
//! | `sit sofa.9 seat 2` | on this seat |
//!
//! A thing that is put down rests within one centimetre and two degrees of the pose asked for, and so do feet; otherwise
//! the action ends in an error with the reason. Where the rule can tell, the action is refused and nothing has changed; where the
//! planner finds out (no room, no way), the agent is left where it has walked meanwhile; and after
//! [`PhysicalRefusal::OffAim`](crate::PhysicalRefusal::OffAim) the thing lies where it has come to rest.
//!
//! ```
//! use virtualcity::graph::{Action, Place, Relation};
//! use virtualcity::{ActionError, Environment, PhysicalRefusal};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let (me, table) = (home.agents()[0], home.graph().of_class("coffee_table")[0]);
//! let mug = home.spawn("mug", Place { relation: Relation::On, at: table })?;
//! home.set_action(me, Action::walk(mug))?;
//! home.set_action(me, Action::grab(mug))?;
//! let middle = home.graph().node(table).and_then(|node| node.aabb()).ok_or("no box")?.centre();
//! let place = format!("place mug.{} coffee_table.{} at {:.3} {:.3} yaw 90", mug.0, table.0, middle.x, middle.y);
//! home.set_action(me, place.parse()?)?;
//! let far = home.world().pose(mug).ok_or("no body")?.translation.vector.xy() - middle.coords.xy();
//! assert!(far.norm() < 0.01);
//! // The table is in the way.
//! let walk = format!("walk at {:.3} {:.3}", middle.x, middle.y);
//! let error = home.set_action(me, walk.parse()?).unwrap_err();
//! assert!(matches!(error, ActionError::Impossible { why: PhysicalRefusal::PointTaken { .. }, .. }), "{error}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Words of your own
//!
//! A scene may have verbs, states and properties of its own: lines of a [`Vocabulary`](vc_graph::Vocabulary), whose rules
//! are made of the conditions and effects of the built-in verbs, and predicates derived from goals. The planner plans with
//! them, and bodies show the motion that a rule names. Classes of your own can have them too, see
//! [`ClassTable::with_vocabulary`](vc_graph::ClassTable::with_vocabulary).
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::Vocabulary;
//! use virtualcity::planner::{PlannerPolicy, run_episode};
//! use virtualcity::tasks::{Outcome, Task};
//! let words = Vocabulary::parse("words.txt", "
//!     state blessed
//!     verb bless 1 | needs: upright; facing x | effects: enter_with x blessed | motion: wave
//!     predicate hallowed ?x | is: Blessed(?x) & did bless(?x)
//! ")?;
//! let mut home = Environment::builder("apartment/9").vocabulary(words).make()?;
//! let task = Task::new("bless the fridge", "Hallowed(fridge)".parse()?);
//! let episode = run_episode(&mut PlannerPolicy::best(), &task, &mut home);
//! assert_eq!(episode.outcome, Outcome::Won);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Control in every tick
//!
//! Beside actions there is the low level: [`Environment::control`](crate::Environment::control) gives a body a velocity, a turn,
//! a direction of the head and goals of its hands, until the next control. Goals are in the body's own frame: X ahead, Y to
//! the left, the origin between the feet. A hand that closes around something holds it if the rule allows it, and the graph says
//! so; the example `hands` opens a drawer and takes a spoon out of it.
//!
//! ```
//! use virtualcity::graph::clock::Span;
//! use virtualcity::graph::{Action, Place, Relation};
//! use virtualcity::nalgebra::{Point3, UnitQuaternion, Vector3};
//! use virtualcity::physics::{Hand, HandGoal};
//! use virtualcity::{Control, Environment};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let (me, table) = (home.agents()[0], home.graph().of_class("dining_table")[0]);
//! let glass = home.spawn("water_glass", Place { relation: Relation::On, at: table })?;
//! home.set_action(me, Action::walk(glass))?;
//!
//! // Fingers ahead, the thumb on the left: at first above the glass and before it, then around it, then up.
//! let feet = home.world().pose(me).ok_or("no body")?;
//! let glass_at = feet.inverse() * home.world().aabb(glass).ok_or("no body")?.centre();
//! let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f32::consts::FRAC_PI_2);
//! let pose = |back: f32, up: f32| {
//!     let at: Point3<f32> = glass_at + Vector3::new(-back, 0.0, up);
//!     virtualcity::graph::Pose::from_parts(at.coords.into(), turn)
//! };
//! for (pose, grip) in [(pose(0.2, 0.2), 0.0), (pose(0.15, 0.0), 0.0), (pose(0.0, 0.0), 0.0), (pose(0.0, 0.0), 1.0)] {
//!     let hand = HandGoal { pose, grip, ..HandGoal::default() };
//!     home.control(me, &Control { hands: [Some(hand), None], ..Control::default() })?;
//!     home.step(Span::from_seconds(1.0));
//! }
//! let hand = home.controlled_hand(me, Hand::Right).ok_or("not under control")?;
//! assert_eq!(hand.body.holds, Some((glass, None)), "{:?}", hand.refused);
//! assert_eq!(home.graph().holder(glass).map(|place| place.relation), Some(Relation::HoldsRight));
//!
//! // Control ends, and an action goes on with it.
//! home.interrupt(me);
//! home.set_action(me, Action::place(glass, table))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Streets of a real place
//!
//! [`map`](crate::map) reads OpenStreetMap's files. The report lists whatever was guessed and dropped, with numbers by
//! which it is found on the map; `validate` lists with places whatever is wrong. Cars, bicycles and people on foot have routes,
//! and drawings are SVG. The example `map` does all of this with a file of your own, and writes it for SUMO and OpenDRIVE.
//!
//! ```
//! # #[cfg(feature = "map")]
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! use virtualcity::map::osm::{ImportOptions, OsmData};
//! use virtualcity::map::picture::Drawing;
//! use virtualcity::map::route::{Mode, Router};
//!
//! // `std::fs::read("place.osm")`, or a file of PBF; here a street with a cross street that has lights.
//! let file = br#"<osm><node id="1" lat="48.100" lon="11.600"/><node id="2" lat="48.101" lon="11.600"/>
//!   <node id="3" lat="48.102" lon="11.600"/><node id="4" lat="48.101" lon="11.602"/>
//!   <way id="7"><nd ref="1"/><nd ref="2"/><nd ref="3"/><tag k="highway" v="secondary"/><tag k="name" v="Long Street"/></way>
//!   <way id="8"><nd ref="2"/><nd ref="4"/><tag k="highway" v="residential"/></way></osm>"#;
//! let (draft, report) = OsmData::read(file)?.draft(&ImportOptions::default())?;
//! let map = draft.build_of_file(file.len())?;
//! assert!(report.to_string().contains("guessed  way 8"));
//! assert_eq!(map.validate(), []);
//!
//! let (south, east) = ([0.0, -80.0].into(), [60.0, 0.0].into());
//! let drive = Router::new(&map, Mode::Car).route(&south, &east).ok_or("no way")?;
//! let walk = Router::new(&map, Mode::Foot).route(&south, &east).ok_or("no way")?;
//! assert!(drive.seconds < walk.seconds);
//! assert!(Drawing::of(&map).svg(2.0).contains("Long Street"));
//! # Ok(())
//! # }
//! # #[cfg(not(feature = "map"))]
//! # fn main() {}
//! ```
