//! Searches: many states of one home.
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
//! # States of a search
//!
//! A copy in which somebody has acted takes megabytes. A search that keeps many keeps their
//! [states](crate::EnvironmentState) instead, some kilobytes each:
//! [`save_state`](crate::Environment::save_state) makes one of a home at rest, and
//! [`restore_state`](crate::Environment::restore_state) makes a home of it, from any clone of the same environment. Bodies
//! are built anew where somebody acts, and evolve alike, bit for bit, in the home that was saved and in all that are restored.
//!
//! A search compares the home that *was saved*: saving builds its bodies anew, by which rotations may change in their last
//! place, so that its digest before and after may differ. This search is breadth first.
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
//!         if child.set_action(me, action).is_err() {
//!             continue;
//!         }
//!         if task.score(&child, me) == 1.0 {
//!             break 'search child;
//!         }
//!         // One in which something still rolls, say, is passed over.
//!         let Ok(state) = child.save_state() else { continue };
//!         // The digest of the child as it is saved.
//!         if seen.insert(child.graph().digest()) {
//!             open.push_back(state);
//!         }
//!     }
//! };
//! let verbs: Vec<Verb> = won.history().events().iter().map(|event| event.action.verb).collect();
//! assert_eq!(verbs, [Verb::Walk, Verb::Open]);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
