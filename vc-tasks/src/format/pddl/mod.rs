//! PDDL: domains, problems and plans.
//!
//! [`Domain`] and [`PlanningProblem`] are read and written as they are: types, constants, predicates, and
//! actions with conditions and effects of the ADL fragment and with costs. A repeated section, or
//! one with too many parts, is an error, as for other readers. [`planning`] converts a scene, its
//! transition rules and a goal into both, in the typed STRIPS fragment that Fast Downward, pyperplan
//! and VAL all support; [`read_plan`] converts a planner's answer into actions.
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

pub use domain::{
    AtomicFormula, Domain, Formula, Metric, NumericExpression, NumericLiteral, Operator, OperatorEffect,
    PlanningProblem, Signature, TypeUnion, TypedName,
};
pub use plan::read_plan;
pub use rules::{LeftOut, domain};
pub use scene::{Keep, Planning, planning};

/// The format's name in errors.
const FORMAT: &str = "PDDL";
