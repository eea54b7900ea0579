//! Policies, rewards, teams and tasks.
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
