//! One home in worlds of a thousand to a million nodes: what happens in it costs the same.
//!
//! `cargo bench --bench city` prints a table: CPU time of the thread, medians, one agent in the first of many homes in a
//! row. The other homes are in the plan, and their scenes are made when somebody comes: that is what the world costs.
//! Worlds take turns, so that all meet the same machine. *cold* is the first time after a world was
//! made, in a process that has made others.

#![allow(missing_docs, clippy::unwrap_used, reason = "benches print and stop where something is wrong")]

use std::error::Error;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Duration;

use cpu_time::ThreadTime;
use vc_testkit::page::{Page, time};
use virtualcity::graph::clock::Span;
use virtualcity::graph::space::{Portal, PortalKind, PortalSide, Region, RegionId, RegionKind, Space, SpaceBuilder};
use virtualcity::graph::{Action, NodeId, Pose, SceneGraph, Seed};
use virtualcity::nalgebra::Vector3;
use virtualcity::procgen::Apartment;
use virtualcity::render::Modality;
use virtualcity::{City, RegionScenes, Viewpoint};

#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Homes in the worlds, and the numbers of nodes of each. The smallest has all that is near: the two homes in sight, which are made
/// when somebody looks, and the one beyond, whose walls stand around them.
const WORLDS: [u32; 4] = [4, 22, 220, 2200];
const NUMBERS: u32 = 4096;
/// Rounds in which worlds take turns, and those with new worlds.
const ROUNDS: usize = 9;
const COLD_ROUNDS: usize = 5;
/// The size of a picture.
const SIZE: (u32, u32) = (96, 72);

/// Homes in a row, each with a passage to the next.
struct Row(Arc<Space>);

impl Row {
    fn of(homes: u32) -> Self {
        let mut plan = SpaceBuilder::new();
        for home in 0..homes {
            let region = Region::new(RegionKind::Unit, format!("apartment/{home}")).with_numbers(NUMBERS);
            plan.add(region.shifted(f64::from(home) * 30.0, 0.0, 0.0)).unwrap();
        }
        for home in 1..homes {
            let side = |home: u32, x: f32, yaw: f32| {
                let pose = Pose::translation(x, 0.0, 0.0) * Pose::rotation(Vector3::z() * yaw);
                PortalSide { region: RegionId(home), pose, room: None }
            };
            let sides = [side(home - 1, 15.0, 0.0), side(home, -15.0, std::f32::consts::PI)];
            plan.join(Portal::new(PortalKind::Passage, sides, 1.0, 2.1)).unwrap();
        }
        Self(Arc::new(plan.build()))
    }
}

impl RegionScenes for Row {
    fn space(&self) -> &Arc<Space> {
        &self.0
    }

    fn scene(&self, region: RegionId) -> Result<SceneGraph, Box<dyn Error + Send + Sync>> {
        let plan = self.0.region(region).ok_or("no region")?;
        // The same home everywhere, so that worlds differ in nothing but their size.
        Ok(Apartment::from_seed(Seed(42))?.scene().renumbered(plan.numbers).ok_or("too many nodes")?)
    }
}

struct World {
    homes: u32,
    city: City,
    me: NodeId,
    goals: [NodeId; 2],
    at: usize,
}

/// A cost that is measured, and how often it is done at a time.
type Cost = (&'static str, u32, fn(&mut World));

const COSTS: [Cost; 4] = [
    ("action", 2, |world| {
        world.at = 1 - world.at;
        world.city.set_action(world.me, Action::walk(world.goals[world.at])).unwrap();
    }),
    ("observation", 20, |world| _ = black_box(world.city.observation(world.me, 5.0).unwrap())),
    ("picture", 1, |world| {
        let home = world.city.environment_of(world.me).unwrap();
        _ = black_box(home.render(Viewpoint::Agent(world.me), Modality::Rgb, SIZE.0, SIZE.1).unwrap());
    }),
    ("tick", 20, |world| _ = black_box(world.city.step(Span(1)))),
];

fn timed(times: u32, mut act: impl FnMut()) -> Duration {
    let start = ThreadTime::now();
    (0..times).for_each(|_| act());
    start.elapsed() / times
}

impl World {
    fn make(homes: u32) -> (Self, Duration) {
        let row = Row::of(homes);
        let mut city = None;
        let made = timed(1, || city = Some(City::of(Row(row.0.clone())).make().unwrap()));
        let city = city.unwrap();
        let me = city.agents().next().unwrap();
        let graph = city.environment_of(me).unwrap().graph();
        let goals = ["fridge", "sofa"].map(|class| graph.of_class(class)[0]);
        (Self { homes, city, me, goals, at: 0 }, made)
    }

    fn nodes(&self) -> usize {
        self.homes as usize * self.city.environment_of(self.me).unwrap().graph().nodes().count()
    }
}

fn median(mut all: Vec<Duration>) -> Duration {
    all.sort_unstable();
    all[all.len() / 2]
}

/// A row: a cost in each world, and the most by the least.
fn row(name: &str, how: &str, all: &[Duration]) -> Vec<String> {
    let seconds = || all.iter().map(Duration::as_secs_f64);
    let ratio = seconds().fold(0.0, f64::max) / seconds().fold(f64::INFINITY, f64::min);
    let cells = seconds().map(time).chain([format!("{ratio:.2}")]);
    [name.to_owned(), how.to_owned()].into_iter().chain(cells).collect()
}

/// The costs in worlds that have just been made, making among them, each by its worlds.
fn cold() -> Vec<Vec<Duration>> {
    let mut all = vec![vec![Vec::new(); WORLDS.len()]; COSTS.len() + 1];
    for _ in 0..COLD_ROUNDS {
        for (at, homes) in WORLDS.into_iter().enumerate() {
            let (mut world, made) = World::make(homes);
            all[0][at].push(made);
            for (cost, (_, _, act)) in COSTS.iter().enumerate() {
                all[cost + 1][at].push(timed(1, || act(&mut world)));
            }
        }
    }
    all.into_iter().map(|worlds| worlds.into_iter().map(median).collect()).collect()
}

/// A cost in worlds that have had it before.
fn warm(worlds: &mut [World], (_, times, act): &Cost) -> Vec<Duration> {
    let mut all = vec![Vec::new(); worlds.len()];
    for _ in 0..ROUNDS {
        for (world, all) in worlds.iter_mut().zip(&mut all) {
            all.push(timed(*times, || act(world)));
        }
    }
    all.into_iter().map(median).collect()
}

fn main() {
    let mut worlds: Vec<World> = WORLDS.map(|homes| World::make(homes).0).into();
    let nodes = worlds.iter().map(|world| format!("{} nodes", world.nodes()));
    let head: Vec<String> =
        [String::new(), String::new()].into_iter().chain(nodes).chain(["most by least".into()]).collect();
    let cold = cold();
    let mut rows = vec![row("make", "cold", &cold[0])];
    for (cost, cold) in COSTS.iter().zip(&cold[1..]) {
        rows.push(row(cost.0, "cold", cold));
        // The first time of all is no measure.
        warm(&mut worlds, cost);
        rows.push(row(cost.0, "warm", &warm(&mut worlds, cost)));
    }
    let mut page = Page::new("city");
    page.table(&head.iter().map(String::as_str).collect::<Vec<_>>(), &rows);
    let sizes = [("a region", size_of::<Region>()), ("a portal", size_of::<Portal>())];
    page.table(&["in the plan", "bytes"], &sizes.map(|(what, bytes)| vec![what.to_owned(), bytes.to_string()]));
    page.finish();
}
