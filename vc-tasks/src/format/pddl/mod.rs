//! PDDL: domains, problems and plans.
//!
//! [`Domain`] and [`Problem`] are read and written as they are: types, constants,
//! predicates, actions with conditions and effects of the ADL fragment and with costs. A section
//! that comes twice or has too many parts is an error, as it is for other readers. [`planning`]
//! makes both of a scene, its transition rule and a goal, in the STRIPS fragment
//! with types that Fast Downward, pyperplan and VAL all take; [`read_plan`] makes
//! actions of what a planner answers.
//!
//! ```
//! use vc_graph::{Draft, SceneBuilder};
//! use vc_tasks::format::pddl::{self, Keep};
//! let mut scene = SceneBuilder::new("flat");
//! let kitchen = scene.add(Draft::new("kitchen"))?;
//! let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
//! scene.add_in(kitchen, Draft::new("apple"))?;
//! let me = scene.add_in(kitchen, Draft::new("character"))?;
//! let planning = pddl::planning(&scene.build(), me, &"On(apple, table)".parse()?, Keep::Relevant)?;
//! assert!(planning.problem.to_string().contains("(met)"));
//! let plan = "(walk apple_3 here)\n(grab apple_3 apple_3 air air right)\n";
//! let actions = pddl::read_plan(plan)?;
//! assert_eq!(actions[1].to_string(), "grab #3");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod domain;
mod goal;
mod parts;
mod plan;
mod read;
mod rules;
mod scene;
mod write;

pub use domain::{Amount, Atom, Change, Domain, Formula, Metric, Number, Operator, Problem, Signature, Type, Typed};
pub use plan::read_plan;
pub use rules::{LeftOut, domain};
pub use scene::{Keep, Planning, planning};

/// What the format is called in errors.
const FORMAT: &str = "PDDL";
