//! Random goals in random scenes: the score is one if and only if the goal holds, and the unmet parts fit.
#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use vc_graph::goal::Situation;
use vc_graph::{Goal, History};
use vc_testkit::goals::goal;
use vc_testkit::scenes::{scene, steps};
use vc_testkit::{cases, flat::Flat};

proptest! {
    #![proptest_config(cases(200))]

    #[test]
    fn a_score_is_one_if_and_only_if_the_goal_holds(goal in goal(0, 3), steps in steps(12), posed: bool) {
        let graph = scene(&steps, posed);
        let history = History::default();
        let now = Situation::new(&graph, graph.agents()[0], &history);
        let score = goal.score(&now);
        prop_assert!((0.0..=1.0).contains(&score), "{score}");
        prop_assert_eq!(score == 1.0, goal.holds(&now), "{}", goal);
        prop_assert_eq!(goal.unmet(&now).is_empty(), goal.holds(&now) || goal == Goal::And(vec![]));
    }

    #[test]
    fn after_things_were_done(goal in goal(0, 2)) {
        let flat = Flat::after(&["walk bread", "eat bread", "walk cup", "grab cup", "walk sink", "put_in cup sink", "walk sofa", "sit sofa"]);
        let now = Situation::new(flat.graph(), flat.me, flat.sim.history());
        prop_assert_eq!(goal.score(&now) == 1.0, goal.holds(&now), "{}", goal);
        let not = Goal::Not(Box::new(goal.clone()));
        prop_assert_eq!(not.holds(&now), !goal.holds(&now));
        let both = Goal::And(vec![goal.clone(), not.clone()]);
        let either = Goal::Or(vec![goal, not]);
        prop_assert!(!both.holds(&now) && either.holds(&now));
        prop_assert_eq!(both.unmet(&now).len(), 1);
    }
}
