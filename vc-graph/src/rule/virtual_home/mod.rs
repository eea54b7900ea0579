//! VirtualHome's own transition rule, beside ours, for comparisons with results made by it.
//!
//! It is the symbolic simulator that made the graphs after VirtualHome's programs (its release of 2019), which
//! the Embodied Agent Interface took over; [`Semantics`] tells it apart from ours. Its accidents happen here as
//! well, as a [`Simulator`](crate::Simulator) of [`Semantics::VirtualHome`] is to end in the very states and edges
//! in which theirs ends.
//!
//! | | [`Semantics::VirtualCity`] | [`Semantics::VirtualHome`] |
//! |---|---|---|
//! | what is on or in a thing that is grabbed | goes along | stays behind in the room, on and in nothing |
//! | what is in a thing that is held, on a walk | goes along | falls out: a glass loses what was poured into it |
//! | a bottle that was poured out of, on a walk | its liquid stays poured | is poured out no longer |
//! | the room of a held thing, after a walk | the agent's | the room that the agent came from |
//! | a thing that is put down or dropped | is in one room | is also still in the rooms where it was held |
//! | grabbing what one holds | changes nothing | puts it into the other hand as well |
//! | grabbing what another holds, wears or rests on | refused | possible; then both hold it |
//! | nearness through what is grabbed | to what it was on or in | to the first thing that it was on, in, or else close to |
//! | parts of a body (`teeth`, `hair`) | always near | near after the first walk |
//! | near | by poses too, and through any number of supports | as the graph says, through one thing |
//! | on a walk one comes near | the thing, what it is in, what is on it or, if it opens and is open, in it | the thing, be it a room, what it is in and, if it is a surface, what is on it |
//! | hidden | inside anything closed, at any depth | inside something closed, directly |
//! | `put_back` of what was taken from beside something | put down in the room | out of the hand, close to that |
//! | `place` on what is no surface, `put_in` into what is no container | refused | possible |
//! | things that do not fit | refused where sizes are known | always fit |
//! | a thing put on or into itself | refused | possible |
//! | `open` of a desk or a window that is closed | if a state says that it opens | by its name |
//! | `open` of what runs | fridges and ovens open | nothing that is on opens |
//! | `open`, `close`, `switch`, `wash`, `wipe` of what is shut in | refused | possible, if near |
//! | `watch` of what is shut in, `plug_out` of what runs | refused | possible |
//! | `take_off` | into a free hand | the clothes are in no hand and on nothing |
//! | `stand` | leaves the seat | leaves the posture; the agent is still on the seat |
//! | sitting down where one lies, lying down where one sits | one place | both places |
//! | a seat is taken | by those who sit there | by all that is on it, cushions as well |
//! | how many have place | the class table | four on a bed or sofa, two on a bench, else one; of lying ones fewer |
//! | `sleep`, `wake_up` | `asleep`, and no longer | nothing |
//! | `cut` | `sliced`; a cutter in hand and a hand free, or the food in it | nothing; something called `knife` in hand and a hand free |
//! | `pour` | fills; of a bottle only some is in the vessel, which `poured_into` says | the bottle itself is inside, and in hand |
//! | `push`, `pull`, `move`, `squeeze` of what one holds | possible | only with the other hand free |
//! | verbs that VirtualHome lacks: `fill`, `cook`, `fold`, `drive`, `dance`, ... | done | refused |
//! | properties and names | those of the class table are added to what is written | as they are written |
//!
//! Where theirs ends with a fault of its program, as in grabbing something while in no room, the action is
//! refused. In two things it is as in all later versions: doors do not block, and an action may be about a thing
//! that the program has not found before. The Embodied Agent Interface's copy differs from it in what one comes
//! near on a walk (what is in a thing that opens, what it stands on, nothing of a room's own), in that what has
//! been grabbed and worn or poured cannot be grabbed again, and in `put_back`, which succeeds there in any case.
//! Where theirs takes the first of several in the order of a Python set, that order is found in `order`.

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
    /// The transition rule by which actions are done; [`virtual_home`](crate::rule::virtual_home) has a table of the
    /// differences.
    Semantics, "semantics" {
        /// Ours: what a sensible person would expect.
        VirtualCity = "virtualcity",
        /// That of VirtualHome's symbolic simulator, its accidents included.
        VirtualHome = "virtualhome",
    }
}

/// The memory of VirtualHome's simulator between actions: where each thing was grabbed.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Memory {
    taken: BTreeMap<NodeId, (NodeId, Link)>,
}

impl Memory {
    /// Why VirtualHome's simulator does not do an action.
    pub(crate) fn refusals(&self, graph: &SceneGraph, agent: NodeId, action: &Action) -> Vec<Refusal> {
        let judged = match check_things(graph, agent, action) {
            // Theirs puts a thing into itself.
            Some(Refusal::WithItself(_)) | None => View { graph, agent }.needs(action, self),
            Some(refusal) => Err(refusal),
        };
        judged.err().into_iter().collect()
    }

    /// Does an action as VirtualHome's simulator does.
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
