//! Actions at points: a mug on a table, turned by 90 degrees; the second seat of a sofa; a walk to a point.
//!
//! `cargo run --release --example points`

#[path = "support/no_options.rs"]
mod no_options;
mod support;

use support::{Complaint, say};
use virtualcity::Environment;
use virtualcity::graph::{Action, Place, Relation, Verb};

fn main() -> Result<(), Complaint> {
    no_options::no_options();
    let mut home = Environment::make("apartment/42", 1)?;
    let me = home.agents()[0];
    let [table, sofa] = ["coffee_table", "sofa"].map(|class| home.graph().of_class(class)[0]);
    let mug = home.spawn("mug", Place { relation: Relation::On, at: table })?;
    home.set_action(me, Action::walk(mug))?;
    let feet = home.world().pose(me).unwrap_or_default().translation;
    home.set_action(me, Action::grab(mug))?;
    // Four centimetres beside the middle of the table, and turned.
    let middle = home.graph().node(table).and_then(|node| node.aabb()).map(|aabb| aabb.centre()).unwrap_or_default();
    let (x, y) = (f64::from(middle.x) + 0.04, f64::from(middle.y));
    home.set_action(me, Action::place(mug, table).at(x, y)?.turned(90.0)?)?;
    let at = home.world().pose(mug).unwrap_or_default().translation;
    say!("{} is at ({:.3}, {:.3})", home.graph().label(mug), at.x, at.y);
    home.set_action(me, Action::sit(sofa).on_seat(2))?;
    home.set_action(me, Action::stand())?;
    home.set_action(me, Action::zero(Verb::Walk).at(f64::from(feet.x), f64::from(feet.y))?.turned(180.0)?)?;
    let last = home.history().events().last().map(|event| event.action.to_string());
    say!("{} did `{}`", home.graph().label(me), last.unwrap_or_default());
    Ok(())
}
