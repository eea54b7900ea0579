//! Homes: how to make one, with which settings, and how to arrange what is in it.
//!
//! # Settings of a home
//!
//! [`Environment::make`](crate::Environment::make) has a default for everything.
//! [`Environment::builder`](crate::Environment::builder) takes other settings;
//! [its page](crate::EnvironmentBuilder) has the table of all of them with their defaults. They are set once, when the
//! environment is made; [`reset`](crate::Environment::reset), clones and restored environments keep them.
//!
//! | to set | with | unit |
//! |---|---|---|
//! | whether bodies do the actions, or the rule alone says their outcome | `bodies` | yes or no |
//! | gravity; fixed things, friction of hinges and slides, latches | `gravity`, `physics` | m/s² |
//! | daylight and the beginning of the clock | `hour`, `begins_at`, `pictures` | hours, seconds of a day |
//! | field of view of eyes and cameras, height of eyes | `pictures` | radians, metres |
//! | classes of a scene file, words of your own | `classes`, `vocabulary` | |
//! | the rule of relations, and its tolerance | `relations`, `tolerance` | metres |
//! | cameras and sensors | `camera`, `sensor` | |
//! | threads of pictures and sensors | `threads` | |
//! | durations of actions and of machines, or machines that are done at once | `durations`, `processes`, `processes_at_once` | as in `0.5 s`, `45 min`, `2 h` |
//!
//! ```
//! use virtualcity::graph::ClassTable;
//! use virtualcity::graph::clock::{Durations, ProcessTable, Span};
//! use virtualcity::graph::{Action, Pose, Verb};
//! use virtualcity::relations::RelationRule;
//! use virtualcity::render::Daylight;
//! use virtualcity::sensors::Lidar;
//! use virtualcity::{Environment, Lens, Mount, PictureOptions};
//!
//! let classes = ClassTable::builtin();
//! let eyes = PictureOptions { field_of_view: 1.4, eye_height: Some(0.9), daylight: Daylight::at(19.5), ..Default::default() };
//! let tripod = Mount::Fixed(Pose::translation(2.0, 2.0, 1.2));
//! let mut home = Environment::builder("apartment/42")
//!     .agents(2)
//!     .gravity(3.71) // Mars
//!     .hour(19.5)
//!     .pictures(eyes) // after `hour`, which sets its own daylight
//!     .relations(RelationRule::Contacts)
//!     .tolerance(0.01)
//!     .durations(Durations::builtin().extended("mine.txt", "eat | * | 3 min", &classes)?)
//!     .processes(ProcessTable::builtin().extended("mine.txt", "cooling | * | hot -on | | | -hot | | | 5 min", &classes)?)
//!     .camera("corner", tripod.clone(), Lens::FieldOfView(1.0))
//!     .sensor("lidar", tripod, Lidar::default())
//!     .threads(2)
//!     .make()?;
//! assert_eq!((home.world().settings().gravity, home.relations().tolerance()), (3.71, 0.01));
//! assert_eq!(home.day_time().to_string(), "day 0, 19:30:00");
//! assert_eq!((home.cameras().len() > 1, home.sensors().count()), (true, 1));
//! let sofa = home.graph().of_class("sofa")[0];
//! assert_eq!(home.duration(&Action::one(Verb::Eat, sofa)), Some(Span::from_seconds(180.0)));
//!
//! // What is no setting is an error, with what to do.
//! let error = Environment::builder("apartment/42").hour(25.0).make().unwrap_err();
//! assert_eq!(error.to_string(), "25 is no hour of a day: an hour is from 0 up to 24, 24 excluded");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Without bodies the same home is symbolic: actions take their time and machines run, but nothing has to be reached or
//! to fit. With `processes_at_once` what a machine does is done in the tick in which it is switched on.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::clock::Span;
//! use virtualcity::graph::{Action, Place, Relation, State, Verb};
//!
//! let mut home = Environment::builder("apartment/42").bodies(false).processes_at_once().make()?;
//! let (me, stove) = (home.agents()[0], home.graph().of_class("stove")[0]);
//! let soup = home.spawn("soup", Place { relation: Relation::On, at: stove })?;
//! home.set_action(me, Action::walk(stove))?;
//! home.set_action(me, Action::one(Verb::SwitchOn, stove))?;
//! home.step(Span(1));
//! assert!(home.graph().node(soup).is_some_and(|soup| soup.is(State::Hot)));
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
