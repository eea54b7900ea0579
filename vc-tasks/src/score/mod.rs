//! How much of a goal holds: exact partial credit, and the published scores.
//!
//! A way to make a goal true is a set of conditions, each an atom that is to be true
//! or false: all of those of a conjunction, those of one part of a disjunction, of k
//! parts for "at least k", of k parts and the negations of the others for "exactly
//! k", of the pairs of one pairing. Ways that contradict themselves do not count.
//! The *credit* of a state is the largest share of its conditions that a way has met.
//! It is 1 if and only if the goal holds.
//!
//! There may be more ways than atoms in the universe, so none is listed. The best
//! share is found by Dinkelbach's method (Management Science 13, 1967): for a share p/q the
//! way with the largest q * met - p * conditions is found in one pass over the gates,
//! since sums, maxima and assignments are all it takes; its own share is the next
//! p/q, until none is better. Where the parts of that way contradict each other about
//! an atom, it is tried true and false (branch and bound, the pass being the bound);
//! parts that share no such atom are searched apart.
//!
//! | score | source |
//! |---|---|
//! | [`Program::credit`] | this crate |
//! | [`Program::bddl_reward`] | `get_reward` of the `bddl` package, 3.6.0 (Srivastava et al., CoRL 2021), without its cut at 20 ways |
//! | [`Program::q_score`] | BEHAVIOR-1K challenge: ways by what was false at the start and is true now |
//! | [`Program::conditions`] | ALFRED's goal-condition success (Shridhar et al., CVPR 2020) |
//! | [`percent_complete`] | PARTNR (Chang et al., ICLR 2025) |

mod assign;
mod pass;
mod rates;
mod search;
mod way;

pub use rates::{Conditions, percent_complete};
pub use search::{Credit, Scorer};

use crate::compile::{Bits, Program};

/// Which ways there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Options {
    /// Those that make the goal true.
    Sound,
    /// Those of BDDL's package: "exactly k" leaves the others alone.
    Bddl,
}

impl Program {
    /// The share of its conditions that the best way to the goal has met; 1 if and
    /// only if the goal holds. [`Scorer`] does several with the same memory.
    ///
    /// ```
    /// use vc_graph::goal::Situation;
    /// use vc_graph::{Draft, History, SceneBuilder};
    /// use vc_tasks::compile::Program;
    /// let mut scene = SceneBuilder::new("flat");
    /// let kitchen = scene.add(Draft::new("kitchen"))?;
    /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    /// scene.add_on(table, Draft::new("cup"))?;
    /// scene.add_in(kitchen, Draft::new("fridge"))?;
    /// let me = scene.add_in(kitchen, Draft::new("character"))?;
    /// let (graph, history) = (scene.build(), History::default());
    /// let now = Situation::new(&graph, me, &history);
    /// let goal = "On(cup, table) & Dirty(cup) & (Open(fridge) | Closed(fridge))".parse()?;
    /// let program = Program::new(&goal, &now)?;
    /// let credit = program.credit(&program.read(&now));
    /// assert_eq!((credit.met, credit.conditions), (2, 3));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn credit(&self, bits: &Bits) -> Credit {
        Scorer::new().credit(self, bits)
    }

    /// BDDL's reward: the best share over the ways that `bddl` lists, in which
    /// "exactly k" asks for k parts and nothing of the others. So it can be 1 while
    /// the goal does not hold; [`Program::credit`] cannot.
    pub fn bddl_reward(&self, bits: &Bits) -> Credit {
        Scorer::new().bddl_reward(self, bits)
    }

    /// The q score: 1 if the goal holds, else the best share of conditions that were
    /// not met at the start and are now.
    pub fn q_score(&self, start: &Bits, now: &Bits) -> f64 {
        Scorer::new().q_score(self, start, now)
    }
}
