//! A home as one line of a data set.

use serde::Serialize;
use virtualcity::graph::{Pose, State};
use virtualcity::procgen::plan::FloorPlan;
use virtualcity::procgen::{Apartment, Fingerprint};
use virtualcity::procgen::{Item, Support};

use crate::one::is_building;

/// Description of the fields of a line, for the manifest.
pub(crate) const FORMAT: &str = "\
One JSON object for each home. `plan`: rooms and openings in cells of 5 cm (`rects`, `at`, `from`, `to`, `shell`), \
`sill`, `head` and `ceiling` in metres; `low`, `high` and `of` are positions in `rooms`; `net_m2` is the net area of \
each room. `items`: all objects but walls, floors and ceilings; `id` is the object's node in the scene that \
Apartment::scene makes; `at` is its origin in millimetres (X east, Y north, Z up), `yaw` its turn around Z in degrees, \
counter-clockwise, or `turn` its rotation as a quaternion (x, y, z, w); `room` and `to` are positions in `rooms` (`to`: \
the other room of a door); `rest` is what carries it: floor, wall, ceiling, built (in), or `on` and `inside`, with the \
carrier's id in `by` and the number of its surface in `surface`.";

/// A home.
#[derive(Serialize)]
pub(crate) struct Record<'a> {
    seed: u64,
    fingerprint: Fingerprint,
    plan_fingerprint: Fingerprint,
    /// Net area without balconies, m², to a hundredth.
    area_m2: f64,
    net_m2: Vec<f64>,
    plan: &'a FloorPlan,
    items: Vec<Thing<'a>>,
}

/// An object in a home.
#[derive(Serialize)]
struct Thing<'a> {
    id: u32,
    class: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    asset: Option<&'a str>,
    at: [i32; 3],
    #[serde(skip_serializing_if = "Option::is_none")]
    yaw: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    turn: Option<[f32; 4]>,
    room: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    to: Option<usize>,
    rest: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    by: Option<u32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    surface: Option<usize>,
    #[serde(skip_serializing_if = "<[State]>::is_empty")]
    states: &'a [State],
}

impl<'a> Record<'a> {
    pub(crate) fn new(home: &'a Apartment, fingerprint: Fingerprint, plan_fingerprint: Fingerprint) -> Self {
        let hundredths = |area: f32| f64::from((area * 100.0).round()) / 100.0;
        let things = home.items.iter().enumerate().filter(|(_, i)| !is_building(i.object.class));
        Self {
            seed: home.seed.0,
            fingerprint,
            plan_fingerprint,
            area_m2: hundredths(home.plan.area()),
            net_m2: home.plan.rooms.iter().map(|r| hundredths(r.area())).collect(),
            plan: &home.plan,
            items: things.map(|(index, item)| Thing::new(home, index, item)).collect(),
        }
    }
}

impl<'a> Thing<'a> {
    fn new(home: &Apartment, index: usize, item: &'a Item) -> Self {
        let (rest, by) = match item.support {
            Support::Floor => ("floor", None),
            Support::Wall => ("wall", None),
            Support::Ceiling => ("ceiling", None),
            Support::Built => ("built", None),
            Support::On(at, surface) => ("on", Some((at, surface))),
            Support::Inside(at, surface) => ("inside", Some((at, surface))),
        };
        let at = item.pose.translation.vector;
        let yaw = yaw(&item.pose);
        let name = &*item.object.asset.name;
        Self {
            id: home.item_id(index).0,
            class: item.object.class,
            asset: (name != item.object.class).then_some(name),
            at: [at.x, at.y, at.z].map(|v| (1000.0 * v).round() as i32),
            yaw,
            turn: yaw.is_none().then(|| item.pose.rotation.coords.into()),
            room: item.room,
            to: item.between,
            rest,
            by: by.map(|(at, _)| home.item_id(at).0),
            surface: by.map(|(_, surface)| surface),
            states: &item.states,
        }
    }
}

/// The rotation around Z in degrees, to a hundredth; `None` for a tilted object.
fn yaw(pose: &Pose) -> Option<f64> {
    let turn = pose.rotation.coords;
    let upright = turn.x.abs() < 1e-4 && turn.y.abs() < 1e-4;
    upright.then(|| {
        let degrees = 2.0 * f64::from(turn.z).atan2(f64::from(turn.w)).to_degrees();
        let within = if degrees > 180.0 { degrees - 360.0 } else { degrees };
        // Adding zero makes a negative zero positive.
        (within * 100.0).round() / 100.0 + 0.0
    })
}
