//! Two agents act at the same time: their actions take time, overlap, and get in each other's way.
//!
//! ```text
//! cargo run --release --example side_by_side -- out/side_by_side
//! ```
//!
//! prints the end of each action with its time, and writes a picture of the kitchen for every half second into the folder.

#[path = "support/output.rs"]
mod output;
mod support;

use support::{Complaint, say};
use virtualcity::graph::clock::Span;
use virtualcity::graph::{Action, Verb};
use virtualcity::render::{Modality, picture};
use virtualcity::{Environment, Viewpoint};

fn main() -> Result<(), Complaint> {
    let folder = output::output("side_by_side", "out/side_by_side")?;
    virtualcity::files::create_folder(&folder)?;
    let mut home = Environment::make("apartment/42", 2)?;
    let (me, you) = (home.agents()[0], home.agents()[1]);
    let fridge = home.graph().first_of_class("fridge").ok_or_else(|| Complaint::new("there is no fridge"))?;
    let kitchen = home.graph().room_of(fridge).ok_or_else(|| Complaint::new("the fridge is in no room"))?;

    // Each is told the next thing as soon as the last one is done; both want the fridge.
    let mut plans = [
        (me, vec![Action::one(Verb::Walk, fridge), Action::one(Verb::Open, fridge), Action::zero(Verb::Wave)]),
        (you, vec![Action::one(Verb::Walk, fridge), Action::one(Verb::Open, fridge), Action::one(Verb::Close, fridge)]),
    ];
    let mut frame = 0;
    loop {
        for (agent, plan) in &mut plans {
            if home.current_action(*agent).is_none() && !plan.is_empty() {
                home.give(*agent, plan.remove(0));
            }
        }
        if !home.is_busy() {
            break;
        }
        for ending in home.step(Span(30)) {
            let (who, what) = (home.graph().label(ending.agent), ending.action.describe(home.graph()).to_string());
            match ending.outcome {
                Ok(_) => say!("{}  {who}: {what}", ending.tick),
                Err(why) => say!("{}  {who}: {what}, not done: {why}", ending.tick),
            }
        }
        let seen = home.moment().render(Viewpoint::Room(kitchen), Modality::Rgb, 320, 240)?;
        let png = picture::png(&picture::rgb(&seen)).map_err(Complaint::new)?;
        virtualcity::files::write(folder.join(format!("{frame:04}.png")), png)?;
        frame += 1;
    }
    say!("{frame} pictures in {}", folder.display());
    Ok(())
}
