//! How much of a goal holds: exact partial credit, and the published scores.
//!
//! A way to make a goal true is a set of conditions, each an atom that has to be true or false: for a
//! conjunction the conditions of all its parts, for a disjunction those of one part, for "at least k" those of
//! k parts, for "exactly k" those of k parts and the negations of the others, and for pairs those of one
//! pairing. Contradictory ways do not count. The *credit* of a state is the largest share of its conditions
//! that any way has fulfilled. It is 1 if and only if the goal holds.
//!
//! There may be more ways than atoms in the universe, so they are not enumerated. The best share is found by
//! Dinkelbach's method (Management Science 13, 1967): for a share p/q, the way with the largest q * met - p *
//! conditions is found in one pass over the gates, which takes only sums, maxima and assignments; the share of
//! that way is the next p/q, until no better one is found. Where the parts of that way contradict each other
//! about an atom, the atom is fixed to true and to false in turn (branch and bound, with the pass as the
//! bound); parts that share no such atom are searched separately.
//!
//! | score | source |
//! |---|---|
//! | [`GoalProgram::credit`] | this crate |
//! | [`GoalProgram::bddl_reward`] | `get_reward` of the `bddl` package, 3.6.0 (Srivastava et al., CoRL 2021), without its cut at 20 ways |
//! | [`GoalProgram::q_score`] | BEHAVIOR-1K challenge: conditions that were false at the start and are true now |
//! | [`GoalProgram::conditions`] | ALFRED's goal-condition success (Shridhar et al., CVPR 2020) |
//! | [`percent_complete`] | PARTNR (Chang et al., ICLR 2025) |

mod assign;
mod pass;
mod rates;
mod search;
mod way;

pub use rates::{Conditions, percent_complete};
pub use search::{Credit, Scorer};

use crate::compile::{Bits, GoalProgram};

/// The kinds of ways to a goal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Options {
    /// The ways that make the goal true.
    Sound,
    /// The ways of the `bddl` package: "exactly k" puts no condition on the other parts.
    Bddl,
}

impl GoalProgram {
    /// The share of its conditions that the best way to the goal has fulfilled; 1 if and only if the goal
    /// holds. [`Scorer`] computes several and reuses its memory.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::GoalProgram;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// scene.add_on(table, Draft::new("cup"))?;
    /// scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let goal = "On(cup, table) & Dirty(cup) & (Open(fridge) | Closed(fridge))".parse()?;
    /// let program = GoalProgram::new(&goal, &now)?;
    /// let credit = program.credit(&program.read(&now));
    /// assert_eq!((credit.satisfied, credit.conditions), (2, 3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn credit(&self, bits: &Bits) -> Credit {
        Scorer::new().credit(self, bits)
    }

    /// BDDL's reward: the best share over the ways that `bddl` enumerates, in which "exactly k" asks for k
    /// parts and puts no condition on the others. It can therefore be 1 while the goal does not hold;
    /// [`GoalProgram::credit`] cannot.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::GoalProgram;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let program = GoalProgram::new(&"On(apple, kitchen_table) & Holds(apple)".parse()?, &now)?;
    /// assert_eq!(program.bddl_reward(&program.read(&now)).value(), 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn bddl_reward(&self, bits: &Bits) -> Credit {
        Scorer::new().bddl_reward(self, bits)
    }

    /// The q score: 1 if the goal holds, else the best share of conditions that were not fulfilled at the start
    /// and are now.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::GoalProgram;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// let apple = scene.add_on(table, Draft::new("apple"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let program = GoalProgram::new(&"On(apple, kitchen_table) & Holds(apple)".parse()?, &now)?;
    /// let start = program.bits(); // nothing held at the start
    /// assert_eq!(program.q_score(&start, &program.read(&now)), 0.5);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn q_score(&self, start: &Bits, now: &Bits) -> f64 {
        Scorer::new().q_score(self, start, now)
    }
}
