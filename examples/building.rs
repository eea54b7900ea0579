//! Something to eat is taken to neighbours two floors up, by stairs or by lift, and whoever brings it comes back; next door
//! plants are watered meanwhile. Writes a film, pictures of it, and a map of
//! each storey.
//!
//! `cargo run --release --example building -- [--seed N] [--lift] [--out DIR]`

#[path = "support/seed.rs"]
mod seed;
mod support;

use std::collections::VecDeque;
use std::path::PathBuf;

use clap::Parser;
use support::{Complaint, say};
use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{PortalKind, RegionId};
use virtualcity::graph::{Action, Goal, Node, NodeId, Property, Seed, State, Verb, Vocabulary, Word};
use virtualcity::procgen::Building;
use virtualcity::render::Modality;
use virtualcity::render::picture::{self, Picture};
use virtualcity::{City, Environment, GoalScope, Viewpoint};

/// Takes something to eat to neighbours.
#[derive(Parser)]
struct Options {
    /// The building.
    #[arg(long, default_value_t = 7, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// Takes the lift instead of the stairs.
    #[arg(long)]
    lift: bool,
    /// The output folder; it is created if it does not exist.
    #[arg(long, default_value = "out/building")]
    out: PathBuf,
    /// Width of the film, pixels.
    #[arg(long, default_value_t = 320, value_parser = clap::value_parser!(u32).range(16..=1920))]
    width: u32,
}

/// A verb of this program's own.
const WORDS: &str = "verb water 2 | needs: in x filled; holding x; near y | effects: enter y wet | motion: pour";
/// Ticks between two pictures of the film, and pictures a second: it is six times as fast.
const EVERY: Span = Span(60);
const RATE: u16 = 6;
/// Pictures of the film in the strip.
const SHOWN: usize = 16;
/// Width of a map, pixels.
const MAP: usize = 1200;

/// An order for an agent.
#[derive(Clone, Copy)]
enum Order {
    Go(RegionId),
    Do(Action),
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let building = Building::from_seed(Seed(options.seed))?;
    virtualcity::files::create_folder(&options.out)?;
    for storey in 0..building.storeys().len() {
        let map = building.floor_plan(storey)?.to_png(MAP)?;
        virtualcity::files::write(options.out.join(format!("storey_{storey}.png")), map)?;
    }
    let (home, above) =
        (building.storeys()[0].homes[0], building.storeys().last().map_or(building.yard(), |s| s.homes[0]));
    let settings = Environment::builder("").vocabulary(Vocabulary::parse("words", WORDS)?);
    let mut city = City::of(building).agents(2).settings(settings).make()?;
    let agents: Vec<NodeId> = city.agents().collect();
    let [me, you] = [agents[0], agents[1]];
    let lift = options.lift;
    // Stairs are landings with a way over steps, the others are those of the lift.
    city.set_ways(me, move |plan| plan.kind != PortalKind::Landing || plan.stairs.is_empty() == lift);

    let food = |node: &Node| node.affords(Property::Eatable) && node.is_graspable();
    let (food, orders) = first_that_works(&city, me, food, |food| vec![Action::walk(food), Action::grab(food)])?;
    let mut play = Play { city, me, width: options.width, pictures: Vec::new(), waterer: (you, VecDeque::new()) };
    play.waterer.1 = watering(&play.city, you)?.into();
    let waters = !play.waterer.1.is_empty();
    tell(&play.city, me, &format!("takes {}", play.city.label(food)));
    play.play(orders.into_iter().map(Order::Do).chain([Order::Go(above)]))?;
    tell(&play.city, me, "has arrived");
    let table = |node: &Node| node.class().ends_with("table");
    let put = |table| vec![Action::walk(table), Action::place(food, table)];
    let (table, orders) = first_that_works(&play.city, me, table, put)?;
    play.play(orders.into_iter().map(Order::Do))?;
    tell(&play.city, me, &format!("has put it on {}", play.city.label(table)));
    let goal: Goal = format!("On({}, {})", play.city.label(food), play.city.label(table)).parse()?;
    play.play([Order::Go(home)])?;
    tell(&play.city, me, "is back");
    let wet = play.finish_watering()?;
    virtualcity::files::write(options.out.join("film.gif"), picture::gif(&play.pictures, RATE)?)?;
    virtualcity::files::write(options.out.join("strip.png"), picture::png(&play.strip())?)?;
    say!("film.gif, strip.png and a map of each storey in {}", options.out.display());
    let Play { city, .. } = play;
    let brought = city.holds(&goal, me, GoalScope::Place(above))?;
    let is_back = city.home(me) == Some(home) && city.region_of(me) == Some(home);
    match brought && wet == waters && is_back {
        true => {
            say!("verified: {goal} holds in {}", city.space().path(above));
            Ok(())
        }
        false => Err(Complaint::new("the food is not where it was brought, or plants are as dry as before")),
    }
}

/// Orders that are carried out side by side, and filmed.
struct Play {
    city: City,
    me: NodeId,
    width: u32,
    pictures: Vec<Picture>,
    /// Whoever waters plants, and what is left to do.
    waterer: (NodeId, VecDeque<Action>),
}

impl Play {
    /// Lets the first agent carry out orders, one after the other, while the other waters plants.
    fn play(&mut self, orders: impl IntoIterator<Item = Order>) -> Result<(), Complaint> {
        for order in orders {
            match order {
                Order::Go(region) => self.city.send(self.me, region)?,
                Order::Do(action) => self.city.give(self.me, action)?,
            }
            while !self.pass(self.me)? {}
        }
        Ok(())
    }

    /// Waters what is left to water, and says whether anything is wet.
    fn finish_watering(&mut self) -> Result<bool, Complaint> {
        let waterer = self.waterer.0;
        while self.city.is_busy(waterer) || !self.waterer.1.is_empty() {
            self.pass(waterer)?;
        }
        let there = self.city.environment_of(waterer);
        let wet = |node: &Node| is_plant(node) && node.is(State::Wet);
        let number = there.map_or(0, |there| there.graph().nodes().filter(|node| wet(node)).count());
        tell(&self.city, waterer, &format!("has watered {number} plants"));
        Ok(number > 0)
    }

    /// Lets a second pass, and takes a picture; whether an agent has ended what it was doing.
    fn pass(&mut self, whom: NodeId) -> Result<bool, Complaint> {
        let waterer = self.waterer.0;
        if self.city.current_action(waterer).is_none()
            && let Some(next) = self.waterer.1.pop_front()
        {
            self.city.give(waterer, next)?;
        }
        let mut ended = false;
        for ending in self.city.step(EVERY) {
            ending.outcome?;
            ended |= ending.agent == whom;
        }
        self.pictures.extend(self.picture()?);
        Ok(ended)
    }

    /// Pictures of the film, evenly from its beginning to its end.
    fn strip(&self) -> Picture {
        let last = self.pictures.len().saturating_sub(1);
        let shown: Vec<Picture> = (0..SHOWN).map(|k| self.pictures[k * last / (SHOWN - 1)].clone()).collect();
        Picture::sheet(&shown, 4, 4)
    }

    /// The room in which the first agent is, with what is seen from there through open doors.
    fn picture(&self) -> Result<Option<Picture>, Complaint> {
        let now = self.city.moment();
        let there = now.environment_of(self.me);
        let Some(room) = there.and_then(|there| there.graph().room_of(self.me)) else { return Ok(None) };
        let frame = now.render(Viewpoint::Room(room), Modality::Rgb, self.width, self.width * 3 / 4)?;
        Ok(Some(picture::rgb(&frame)))
    }
}

fn is_plant(node: &Node) -> bool {
    &**node.class() == "houseplant"
}

/// The first thing in an agent's region with which actions can be done, and these.
fn first_that_works(
    city: &City,
    me: NodeId,
    is_meant: impl Fn(&Node) -> bool,
    actions: impl Fn(NodeId) -> Vec<Action>,
) -> Result<(NodeId, Vec<Action>), Complaint> {
    let here = city.environment_of(me).ok_or_else(|| Complaint::new("nobody is there"))?;
    let all = here.graph().nodes().filter(|node| is_meant(node)).map(Node::id);
    let works = |thing: &NodeId| {
        let mut tried = city.clone();
        actions(*thing).into_iter().all(|action| tried.set_action(me, action).is_ok())
    };
    let thing = all.collect::<Vec<NodeId>>().into_iter().find(works);
    let thing = thing.ok_or_else(|| Complaint::new("nothing of the kind is at hand here"))?;
    Ok((thing, actions(thing)))
}

/// The actions with which an agent waters the plants of its region.
fn watering(city: &City, me: NodeId) -> Result<Vec<Action>, Complaint> {
    let here = city.environment_of(me).ok_or_else(|| Complaint::new("nobody is there"))?;
    let all = |is_meant: fn(&Node) -> bool| {
        here.graph().nodes().filter(move |node| is_meant(node)).map(Node::id).collect::<Vec<NodeId>>()
    };
    let plants = all(is_plant);
    if plants.is_empty() {
        say!("next door are no plants");
        return Ok(Vec::new());
    }
    let water = Verb::parse("water")?;
    for source in all(|node| node.affords(Property::WaterSource)) {
        let fill = |vessel| {
            let mut fill = vec![Action::walk(vessel), Action::grab(vessel), Action::walk(source)];
            let on = here.graph().node(source).is_some_and(|node| node.is(State::On));
            fill.extend((!on).then(|| Action::one(Verb::SwitchOn, source)));
            fill.push(Action::two(Verb::Fill, vessel, source));
            let pour = |plant: &NodeId| [Action::walk(*plant), Action::two(water, vessel, *plant)];
            fill.extend(plants.iter().flat_map(pour));
            fill
        };
        let vessel = |node: &Node| node.affords(Property::Recipient) && node.is_graspable();
        if let Ok((_, actions)) = first_that_works(city, me, vessel, fill) {
            return Ok(actions);
        }
    }
    say!("next door is nothing to fill with water for {} plants", plants.len());
    Ok(Vec::new())
}

fn tell(city: &City, me: NodeId, what: &str) {
    let region = city.region_of(me).map(|region| city.space().path(region)).unwrap_or_default();
    say!("{:6.1} s  {} {what}: {region}", city.tick().seconds(), city.label(me));
}
