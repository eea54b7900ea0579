//! Recipes for the first day. Each is a complete program, and all of them run as tests.
//!
//! | page | recipes |
//! |---|---|
//! | [`homes`] | [settings](homes#settings-of-a-home) · [a scene of VirtualHome with bodies](homes#a-scene-of-virtualhome-with-bodies) · [many homes at once](homes#many-homes-at-once) · [placing things and agents](homes#placing-things-and-agents) · [resetting to an edited graph](homes#resetting-to-an-edited-graph) · [words of your own](homes#words-of-your-own) |
//! | [`acting`] | [actions at points](acting#actions-at-points) · [legal actions with things in view](acting#legal-actions-with-things-in-view) · [control in every tick](acting#control-in-every-tick) · [paths from your own planner](acting#paths-from-your-own-planner) |
//! | [`clock`] | [several agents at the same time](clock#several-agents-at-the-same-time) · [the ending of an action](clock#the-ending-of-an-action) · [orders that change](clock#orders-that-change) · [processes and durations](clock#processes-and-durations) · [saved in the middle of actions](clock#saved-in-the-middle-of-actions) |
//! | [`search`] | [a search that tries actions on copies](search#a-search-that-tries-actions-on-copies) · [states of a search](search#states-of-a-search) |
//! | [`policies`] | [a policy of your own](policies#a-policy-of-your-own) · [rewards, action by action](policies#rewards-action-by-action) · [a team](policies#a-team) · [a language model](policies#a-language-model) · [tasks that are certainly feasible](policies#tasks-that-are-certainly-feasible) |
//! | [`pictures`] | [pictures as data](pictures#pictures-as-data) · [cameras and sensors of your own](pictures#cameras-and-sensors-of-your-own) · [a data set of several homes](pictures#a-data-set-of-several-homes) |
//! | [`buildings`] | [a walk to the neighbours](buildings#a-walk-to-the-neighbours) · [seen through doors](buildings#seen-through-doors) · [goals beyond the home](buildings#goals-beyond-the-home) · [a city that is saved](buildings#a-city-that-is-saved) |
//! | [`streets`] | [streets of a real place](streets#streets-of-a-real-place) |

pub mod acting;
pub mod buildings;
pub mod clock;
pub mod homes;
pub mod pictures;
pub mod policies;
pub mod search;
pub mod streets;
