//! Tests of belief, plans and policies, in one program: each program links anew.

#[path = "../support/shortest.rs"]
mod brute;
#[path = "../support/homes.rs"]
mod homes;
#[path = "../support/placements.rs"]
mod placements;

mod any;
mod bayes;
mod behaviour;
mod belief;
mod benchmark;
mod best;
mod carried;
mod chances;
mod everything;
mod fetched;
mod hands;
mod manners;
mod model;
mod negation;
mod own_words;
mod plans;
mod policies;
mod reasons;
mod records;
mod refused;
mod team;
mod unknown_home;
