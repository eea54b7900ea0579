//! Things and bodies from outside that stand where people walk or vehicles drive.

use std::sync::Arc;

use vc_map::Point;

use crate::block::Block;
use crate::bytes::{Reader, Writer};
use crate::ground::{Links, Span};
use crate::save::SaveError;
use crate::{Traffic, TrafficError};

/// Vehicles wait for what is so near to the middle of their way, metres, and so far before and behind it.
const BESIDE: f64 = 1.35;
const BEFORE: f64 = 0.3;
/// The largest radius, metres.
const LARGEST: f32 = 2.0;

/// A disc on the ground that is not of this traffic: somebody's body, a thing that fell. People walk around it, vehicles wait for it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Obstacle {
    /// Its middle, metres.
    pub at: [f32; 2],
    /// Its radius, metres, above 0 and at most 2: a larger thing is several.
    pub radius: f32,
    /// The layer of the roads on which it is: 0 on the ground.
    pub layer: i8,
}

impl Traffic {
    /// Sets what stands in the way from the next step on, instead of what did. Those who move are set anew with each step. Costs a look at
    /// the links around each, and the first time one at each link.
    ///
    /// # Errors
    /// [`TrafficError::Obstacle`]: a place that is none, a radius out of its range.
    ///
    /// ```
    /// # use vc_graph::Seed;
    /// # use vc_map::{Control, CrossSection, MapDraft, RoadClass, RoadId, Strip};
    /// # use vc_traffic::{Kerb, Obstacle, Traffic, TrafficOptions, Trip, VehicleId};
    /// # let mut draft = MapDraft::new("street", 48.1, 11.6);
    /// # let ends = [[0.0, 0.0], [200.0, 0.0], [400.0, 0.0]].map(|at| draft.junction(at, Control::Priority));
    /// # let side = vec![Strip::driving(3.0, 13.9)];
    /// # for pair in ends.windows(2) {
    /// #     let section = CrossSection { forward: side.clone(), backward: side.clone(), median: 0.0 };
    /// #     draft.road(pair[0], pair[1], RoadClass::Residential, section);
    /// # }
    /// # let map = draft.build()?; // a street of two roads along X
    /// # let kerb = |road, station| Kerb { road: RoadId(road), forward: true, station };
    /// # let trips = vec![Trip { class: 0, departs: 0.0, from: kerb(0, 20.0), to: kerb(1, 150.0) }];
    /// let mut traffic = Traffic::new(&map, trips, &TrafficOptions::default(), Seed(7))?;
    /// traffic.set_obstacles(vec![Obstacle { at: [120.0, -1.0], radius: 0.3, layer: 0 }])?;
    /// (0..600).for_each(|_| traffic.step());
    /// // It waits before that, and goes on as soon as that is gone.
    /// assert!(traffic.vehicle(VehicleId(0)).is_some_and(|pose| pose.speed < 0.1 && (115.0..119.0).contains(&pose.station)));
    /// traffic.set_obstacles(Vec::new())?;
    /// (0..600).for_each(|_| traffic.step());
    /// assert!(traffic.is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set_obstacles(&mut self, obstacles: Vec<Obstacle>) -> Result<(), TrafficError> {
        for (number, obstacle) in obstacles.iter().enumerate() {
            let reason = if obstacle.at.iter().any(|metres| !metres.is_finite()) {
                format!("it is at {:?}", obstacle.at)
            } else if !(obstacle.radius > 0.0 && obstacle.radius <= LARGEST) {
                format!("a radius of {} m: give one above 0, of at most {LARGEST} m", obstacle.radius)
            } else {
                continue;
            };
            return Err(TrafficError::Obstacle { number, reason });
        }
        self.obstruct(obstacles);
        Ok(())
    }

    fn obstruct(&mut self, obstacles: Vec<Obstacle>) {
        let links = self.links();
        self.obstructed.clear();
        for obstacle in &obstacles {
            let at = Point::new(f64::from(obstacle.at[0]), f64::from(obstacle.at[1]));
            let radius = f64::from(obstacle.radius);
            let near = links.within(&at, &[obstacle.layer], radius + BESIDE);
            let span = |(link, station): (u32, f64)| {
                let [from, to] = [station - radius - BEFORE, station + radius + BEFORE].map(|metres| metres as f32);
                Block { span: Span { link, from, to }, firm: true }
            };
            self.obstructed.extend(near.into_iter().map(span));
        }
        self.foot.crowd.set_discs(obstacles.iter().map(|obstacle| (obstacle.at.into(), obstacle.radius)).collect());
        self.obstacles = obstacles;
    }

    /// The links, to be found by their places.
    pub(crate) fn links(&mut self) -> Arc<Links> {
        let network = &self.network;
        self.links.get_or_insert_with(|| Arc::new(Links::new(network))).clone()
    }

    pub(crate) fn save_obstacles(&self, to: &mut Writer) {
        to.list(self.obstacles.iter(), |to, obstacle| {
            to.reals([obstacle.at[0], obstacle.at[1], obstacle.radius]);
            to.word(u32::from(obstacle.layer as u8));
        });
    }

    pub(crate) fn read_obstacles(&mut self, from: &mut Reader) -> Result<(), SaveError> {
        let obstacles = from.list(|from| {
            let [x, y, radius] = from.reals("obstacle")?;
            Ok(Obstacle { at: [x, y], radius, layer: from.below(256, "layer")? as u8 as i8 })
        })?;
        if obstacles != self.obstacles {
            self.set_obstacles(obstacles).map_err(|_| SaveError::Wrong("obstacle"))?;
        }
        Ok(())
    }
}
