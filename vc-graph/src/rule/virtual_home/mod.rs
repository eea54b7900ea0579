//! VirtualHome's own transition rule, beside VirtualCity's, for comparisons with results of VirtualHome.
//!
//! It is the rule of the symbolic simulator that produced the graphs after VirtualHome's programs (its release
//! of 2019), which the Embodied Agent Interface adopted; [`Semantics`] selects one of the two rules. Faults of
//! that simulator are reproduced, so that a [`Simulator`](crate::Simulator) with [`Semantics::VirtualHome`]
//! ends in exactly the same states and edges.
//!
//! | | [`Semantics::VirtualCity`] | [`Semantics::VirtualHome`] |
//! |---|---|---|
//! | objects on or in a grabbed object | move along | stay behind in the room, on and in nothing |
//! | contents of a held object, on a walk | move along | fall out: a glass loses the liquid poured into it |
//! | a bottle that was poured from, on a walk | its liquid stays poured | no longer counts as poured |
//! | the room of a held object, after a walk | the agent's | the room that the agent came from |
//! | an object that is put down or dropped | is in one room | is also still in the rooms where it was held |
//! | grabbing an object that the agent holds | changes nothing | puts it into the other hand as well |
//! | grabbing an object that another agent holds, wears or rests on | refused | possible; then both hold it |
//! | nearness through a grabbed object | to its support or container | to the first object that it was on, in, or else close to |
//! | body parts (`teeth`, `hair`) | always near | near after the first walk |
//! | near | by poses too, and through any number of supports | as the graph says, through one object |
//! | a walk makes near | the object, its containers, the objects on it and, if it opens and is open, in it | the object, even a room, its containers and, if it is a surface, the objects on it |
//! | hidden | inside anything closed, at any depth | inside something closed, directly |
//! | `put_back` of an object taken from beside another | puts it down in the room | takes it out of the hand, close to that object |
//! | `place` on a node that is not a surface, `put_in` into one that is not a container | refused | possible |
//! | objects that do not fit | refused if sizes are known | always fit |
//! | an object put on or into itself | refused | possible |
//! | `open` of a closed desk or window | possible if a state says that it opens | depends on its name |
//! | `open` of a running machine | fridges and ovens open | nothing that is on opens |
//! | `open`, `close`, `switch`, `wash`, `wipe` of an object in a closed container | refused | possible, if near |
//! | `watch` of an object in a closed container, `plug_out` of a running machine | refused | possible |
//! | `take_off` | into a free hand | the clothes are in no hand and on nothing |
//! | `stand` | leaves the seat | ends the posture; the agent is still on the seat |
//! | sitting down where one lies, lying down where one sits | one place | both places |
//! | a seat is occupied | by agents who sit there | by everything on it, cushions as well |
//! | number of places | the class table | four on a bed or sofa, two on a bench, else one; fewer when lying |
//! | `sleep`, `wake_up` | sets and ends `asleep` | no effect |
//! | `cut` | sets `sliced`; needs a cutter in hand, and a free hand or the food in it | no effect; needs an object called `knife` in hand and a free hand |
//! | `pour` | fills; for a bottle only some is in the target, as `poured_into` says | the bottle itself is inside, and in hand |
//! | `push`, `pull`, `move`, `squeeze` of a held object | possible | only with the other hand free |
//! | verbs that VirtualHome lacks: `fill`, `cook`, `fold`, `drive`, `dance`, ... | possible | refused |
//! | properties and names | those of the class table are added to the written ones | as they are written |
//!
//! Where VirtualHome's simulator ends with a program fault, as when an agent in no room grabs something, the
//! action is refused. In two respects the rule is that of all later versions: doors do not block, and an action
//! may concern an object that the program has not found before. The Embodied Agent Interface's copy differs in
//! the objects that a walk makes near (the contents of an object that opens, the objects it stands on, nothing
//! for a room), in that an object that was grabbed and then worn or poured cannot be grabbed again, and in
//! `put_back`, which always succeeds there. If VirtualHome's simulator takes the first of several in the order
//! of a Python set, `order` computes that order.

mod effects;
mod needs;
mod order;
mod view;

use std::collections::BTreeMap;

use super::check::check_things;
use crate::vocabulary::vocabulary;
use crate::{Action, ChangeSet, NodeId, Refusal, SceneGraph};
use view::{Link, View};

vocabulary! {
    /// The transition rule that is applied; [`virtual_home`](crate::rule::virtual_home) has a table of the
    /// differences.
    Semantics, "semantics" {
        /// VirtualCity's rule, which follows common sense.
        VirtualCity = "virtualcity",
        /// The rule of VirtualHome's symbolic simulator, with its faults.
        VirtualHome = "virtualhome",
    }
}

/// The state of VirtualHome's simulator between actions: the place where each object was grabbed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Memory {
    taken: BTreeMap<NodeId, (NodeId, Link)>,
}

impl Memory {
    /// The reasons why VirtualHome's simulator refuses an action.
    pub(crate) fn refusals(&self, graph: &SceneGraph, agent: NodeId, action: &Action) -> Vec<Refusal> {
        if !action.aim.is_nothing() {
            return vec![Refusal::AimNotInVirtualHome(action.aim.to_string().trim_start().to_owned())];
        }
        let judged = match check_things(graph, agent, action) {
            // VirtualHome's simulator permits putting an object into itself.
            Some(Refusal::WithItself(_)) | None => View { graph, agent }.needs(action, self),
            Some(refusal) => Err(refusal),
        };
        judged.err().into_iter().collect()
    }

    /// Performs an action as VirtualHome's simulator does.
    pub(crate) fn step(
        &mut self,
        graph: &mut SceneGraph,
        agent: NodeId,
        action: &Action,
    ) -> Result<ChangeSet, Vec<Refusal>> {
        let refusals = self.refusals(graph, agent, action);
        if !refusals.is_empty() {
            return Err(refusals);
        }
        let mut edit = graph.edit();
        self.carry_out(&mut edit, agent, action).map_err(|e| vec![Refusal::Edit(e)])?;
        Ok(edit.commit())
    }
}
