//! The clock: actions that take time and overlap, processes, and homes that are saved in the middle of it.
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
//! # The ending of an action
//!
//! `step` and `step_until_idle` return an [`Ending`](crate::Ending) for each action that was given: its tick, its agent, the
//! action, and the changes of the graph or the reason for which it was not done.
//!
//! | outcome | meaning | what has changed |
//! |---|---|---|
//! | `Ok(changes)` | done | the changes of the graph since the last action that anybody has done, those of machines with them |
//! | [`Refused`](crate::ActionError::Refused) | the transition rule forbids it | nothing |
//! | [`Impossible`](crate::ActionError::Impossible) | bodies cannot do it | the agent may have walked |
//! | [`Interrupted`](crate::ActionError::Interrupted) | somebody or something came between | what was done until that tick |
//! | [`Disagreement`](crate::ActionError::Disagreement) | bodies did it, and something else came of it than the rule says | what bodies did |
//!
//! An action that lets something happen, such as grabbing, has two moments: the tick in which its effect comes true, and
//! the later one in which the hand is back and all rests, which is its ending's. Whoever comes too late is told in the
//! first.
//!
//! ```
//! use virtualcity::graph::clock::Span;
//! use virtualcity::graph::{Action, Place, Relation};
//! use virtualcity::{ActionError, Environment, Interruption};
//!
//! let mut home = Environment::make("apartment/42", 2)?;
//! let (me, you) = (home.agents()[0], home.agents()[1]);
//! let table = home.graph().of_class("dining_table")[0];
//! let mug = home.spawn("mug", Place { relation: Relation::On, at: table })?;
//! let minute = Span::from_seconds(60.0);
//! home.give(me, Action::walk(mug));
//! home.give(you, Action::walk(mug));
//! home.step_until_idle(minute);
//!
//! // Both take it, you a tenth of a second later.
//! home.give(me, Action::grab(mug));
//! home.step(Span(6));
//! home.give(you, Action::grab(mug));
//! let endings = home.step_until_idle(minute);
//! assert_eq!(endings.iter().map(|ending| ending.agent).collect::<Vec<_>>(), [you, me]);
//! let late = endings[0].outcome.as_ref().unwrap_err();
//! assert!(
//!     matches!(late, ActionError::Interrupted { why, .. } if matches!(**why, Interruption::Taken { .. })),
//!     "{late}"
//! );
//! assert!(endings[1].outcome.is_ok() && endings[0].tick < endings[1].tick);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Orders that change
//!
//! An action is broken off by [`interrupt`](crate::Environment::interrupt), and by another action that is given to its agent
//! and that the rule allows. Everything stays as it is in that tick, and the ending is among those of the next `step`.
//! [`current_action`](crate::Environment::current_action) tells what an agent is doing, and
//! [`moment`](crate::Environment::moment) shows it: a still copy of the home with walkers on their way, hands at what they take
//! and doors half open. Time advances in single ticks or thousands at once to the same end, bit for bit.
//!
//! ```
//! use virtualcity::graph::Action;
//! use virtualcity::graph::clock::{Span, Tick};
//! use virtualcity::{ActionError, Environment, Interruption};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let (fridge, sofa) = (home.graph().of_class("fridge")[0], home.graph().of_class("sofa")[0]);
//! let feet = |home: &Environment| home.moment().world().pose(me).map(|pose| pose.translation.vector);
//!
//! let walk = Action::walk(fridge);
//! home.give(me, walk);
//! let set_out = feet(&home);
//! assert!(home.step(Span(30)).is_empty());
//! assert_eq!((home.tick(), home.current_action(me)), (Tick(30), Some(&walk)));
//! assert_ne!(feet(&home), set_out);
//!
//! // Rather to the sofa: the first order ends half a second after it has begun.
//! home.give(me, Action::walk(sofa));
//! let endings = home.step(Span(1));
//! assert!(matches!(&endings[0].outcome, Err(ActionError::Interrupted { why, .. }) if matches!(**why, Interruption::Replaced(_))));
//! home.interrupt(me);
//! let endings = home.step(Span(0));
//! assert!(matches!(&endings[0].outcome, Err(ActionError::Interrupted { why, .. }) if matches!(**why, Interruption::Cancelled)));
//! assert!(!home.is_busy());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Processes and durations
//!
//! Machines and matter go on while time passes: [`processes`](crate::Environment::processes) lists what goes on and until
//! when. Actions that no body's motion times, such as reading, take as long as
//! [`duration`](crate::Environment::duration) says. The tables of both are settings: see [`homes`](super::homes#settings-of-a-home).
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::clock::Span;
//! use virtualcity::graph::{Place, Relation, State};
//!
//! let mut home = Environment::builder("apartment/42").hour(7.0).make()?;
//! let table = home.graph().of_class("dining_table")[0];
//! let ice = home.spawn("ice", Place { relation: Relation::On, at: table })?;
//! let is_cold = |home: &Environment| home.graph().node(ice).is_some_and(|ice| ice.is(State::Cold));
//! assert!(is_cold(&home));
//! home.step(Span(1));
//! for since in home.processes() {
//!     println!("{}: {} until {}", home.graph().label(since.node), since.process, since.due());
//! }
//! // An hour in which nobody acts costs next to nothing.
//! home.step(Span::from_seconds(3600.0));
//! assert!(!is_cold(&home));
//! assert_eq!(home.day_time().to_string(), "day 0, 08:00:00");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Saved in the middle of actions
//!
//! [`save`](crate::Environment::save) writes all of a home as bytes, whatever goes on in it, and
//! [`restore`](crate::Environment::restore) makes a home of them that goes on as the saved one does, bit for bit. It has to
//! be asked of an environment that was made of the same scene with the same settings; otherwise
//! [`SaveError::OtherSetting`](crate::SaveError::OtherSetting) or [`OtherStart`](crate::SaveError::OtherStart) says what
//! differs. Endings that no `step` has returned yet are not saved, so `save` refuses until they are read.
//!
//! | | [`clone`](Clone::clone) | [`save_state`](crate::Environment::save_state) | [`save`](crate::Environment::save) |
//! |---|---|---|---|
//! | keeps | everything | a home at rest | a home in the middle of actions |
//! | as | another environment, megabytes once somebody has acted | some kilobytes in memory | bytes for a file, some three megabytes |
//! | goes on in | itself | the environment and its clones | every environment made alike, in another program, too |
//! | costs | about a millisecond | some milliseconds | some tens of milliseconds |
//!
//! ```
//! use virtualcity::graph::Action;
//! use virtualcity::graph::clock::Span;
//! use virtualcity::{Environment, SaveError};
//!
//! let made = || Environment::builder("apartment/42").agents(2).hour(19.5).make();
//! let mut home = made()?;
//! let (me, you) = (home.agents()[0], home.agents()[1]);
//! let fridge = home.graph().of_class("fridge")[0];
//! home.give(me, Action::walk(fridge));
//! home.give(you, "wave".parse()?);
//! home.step(Span(20));
//! let bytes: Vec<u8> = home.save()?; // std::fs::write("home.save", bytes)
//!
//! let mut again = made()?.restore(&bytes)?;
//! assert_eq!((again.digest(), again.tick()), (home.digest(), home.tick()));
//! let minute = Span::from_seconds(60.0);
//! assert_eq!(again.step_until_idle(minute), home.step_until_idle(minute));
//! assert_eq!(again.digest(), home.digest());
//!
//! let noon = Environment::make("apartment/42", 2)?;
//! match noon.restore(&bytes) {
//!     Err(SaveError::OtherSetting { setting, expected, found }) => {
//!         assert_eq!([&*setting, &*expected, &*found], ["begins_at", "day 0, 12:00:00", "day 0, 19:30:00"]);
//!     }
//!     other => println!("{:?}", other.map(drop)),
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
