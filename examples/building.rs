//! Something to eat is taken to neighbours two floors up, by stairs or by lift, and whoever brings it comes back.
//!
//! `cargo run --release --example building -- [--seed N] [--lift]`

#[path = "support/seed.rs"]
mod seed;
mod support;

use clap::Parser;
use support::{Complaint, say};
use virtualcity::City;
use virtualcity::graph::space::{PortalKind, RegionId, RegionKind};
use virtualcity::graph::{Action, Node, NodeId, Place, Property, Relation, SceneGraph};

/// Takes something to eat to neighbours.
#[derive(Parser)]
struct Options {
    /// The building.
    #[arg(long, default_value_t = 7, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// Takes the lift instead of the stairs.
    #[arg(long)]
    lift: bool,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let mut city = City::make(&format!("building/{}", options.seed), 1)?;
    let me = city.agents().next().ok_or_else(|| Complaint::new("nobody lives here"))?;
    let units = city.space().regions().filter(|(_, region)| region.kind == RegionKind::Unit).map(|(id, _)| id);
    let homes: Vec<RegionId> = units.collect();
    let [home, above] = [homes[0], homes[4]];
    let lift = options.lift;
    // Stairs are landings with a way over steps, the others are those of the lift.
    city.set_ways(me, move |plan| plan.kind != PortalKind::Landing || plan.stairs.is_empty() == lift);

    let food = first_done(
        &mut city,
        me,
        |node| node.affords(Property::Eatable) && node.is_graspable(),
        |city, food| {
            city.set_action(me, Action::walk(food))?;
            city.set_action(me, Action::grab(food)).map(drop)
        },
    )?;
    tell(&city, me, &format!("has taken {}", city.label(food)));
    city.go(me, above)?;
    tell(&city, me, "has arrived");
    let table = first_done(
        &mut city,
        me,
        |node| node.class().ends_with("table"),
        |city, table| {
            city.set_action(me, Action::walk(table))?;
            city.set_action(me, Action::place(food, table)).map(drop)
        },
    )?;
    tell(&city, me, &format!("has put it on {}", city.label(table)));
    let is_there =
        |graph: &SceneGraph| graph.places(food).any(|place| place == Place { relation: Relation::On, at: table });
    let brought = city.environment(above).is_some_and(|there| is_there(there.graph()));
    city.go(me, home)?;
    tell(&city, me, "is back");
    match brought && city.region_of(food) == Some(above) && city.region_of(me) == Some(home) {
        true => Ok(()),
        false => Err(Complaint::new("the food is not where it was brought")),
    }
}

/// Does something with the first thing in the agent's region with which it can be done.
fn first_done(
    city: &mut City,
    me: NodeId,
    is_meant: impl Fn(&Node) -> bool,
    mut done: impl FnMut(&mut City, NodeId) -> Result<(), virtualcity::CityError>,
) -> Result<NodeId, Complaint> {
    let here = city.environment_of(me).ok_or_else(|| Complaint::new("nobody is there"))?;
    let all: Vec<NodeId> = here.graph().nodes().filter(|node| is_meant(node)).map(Node::id).collect();
    let found = all.into_iter().find(|thing| done(city, *thing).is_ok());
    found.ok_or_else(|| Complaint::new("nothing of the kind is at hand here"))
}

fn tell(city: &City, me: NodeId, what: &str) {
    let region = city.region_of(me).map(|region| city.space().path(region)).unwrap_or_default();
    say!("{:6.1} s  {} {what}: {region}", city.tick().seconds(), city.label(me));
}
