//! Records of what was ordered in a city, by which it is played again.

use serde::{Deserialize, Serialize};
use vc_graph::clock::{Span, Tick};
use vc_graph::space::RegionId;
use vc_graph::{Action, Digest, NodeId, ObjectNames};

use super::{City, CityError};

/// The orders of an episode in a city, from which it is played again: [`City::begin_record`] begins one,
/// [`City::record`] returns it, [`City::replay`] plays it.
///
/// It is plain data for serde: some tens of bytes for each order.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CityRecord {
    /// The digest of the plan of regions.
    plan: u64,
    /// The digest of the city when the record began, and its tick.
    begin: (Tick, u64),
    orders: Vec<Given>,
    /// The same of the end.
    end: (Tick, u64),
}

/// An order and the tick in which it was given.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Given {
    tick: Tick,
    agent: NodeId,
    order: Order,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum Order {
    Act(Action, Names),
    Go(RegionId),
    Stop,
    /// A push of the thing that stands for the agent: impulse and point.
    Push([f32; 3], [f32; 3]),
}

/// The names by which an action calls its things; two orders that differ in these alone are the same.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
#[serde(transparent)]
pub(super) struct Names(ObjectNames);

impl PartialEq for Names {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// Why a record is not played again.
#[derive(Debug, Clone, thiserror::Error)]
#[non_exhaustive]
pub enum ReplayError {
    /// The record is of another city.
    #[error("the record is of another plan of regions: make this city of the same name or source")]
    OtherPlan,
    /// The city is not as it was when the record began.
    #[error(
        "the city is at {here} with digest {found}, and the record began at {begin} with {expected}: make it anew in the same way"
    )]
    OtherBeginning {
        /// The tick of the city.
        here: Tick,
        /// The tick of the record.
        begin: Tick,
        /// The digest of the city.
        found: Digest,
        /// The digest of the record.
        expected: Digest,
    },
    /// Another city has come of it.
    #[error("the city came out with digest {found}, and the record has {expected}: the program has changed since")]
    OtherEnd {
        /// The digest of the city.
        found: Digest,
        /// The digest of the record.
        expected: Digest,
    },
    /// An order that was taken then is not taken now.
    #[error(transparent)]
    City(#[from] Box<CityError>),
}

impl City {
    /// Writes down from now on what agents are ordered and what is pushed. Settings of the city are no part of a record, nor
    /// are [ways](Self::set_ways) and agents that come later.
    pub fn begin_record(&mut self) {
        self.orders = Some(CityRecord {
            plan: self.space().digest().0,
            begin: (self.tick, self.digest().0),
            orders: Vec::new(),
            end: (self.tick, 0),
        });
    }

    /// The record so far; none if none was begun. Costs a [digest](Self::digest).
    pub fn record(&self) -> Option<CityRecord> {
        let record = self.orders.clone()?;
        Some(CityRecord { end: (self.tick, self.digest().0), ..record })
    }

    /// Plays a record again, from the city as it was when that began; `self` is not changed. The result is the same city, bit
    /// for bit, which is checked.
    ///
    /// ```
    /// use virtualcity::{City, CityRecord};
    /// let start = City::make("building/7", 1)?;
    /// let mut city = start.clone();
    /// city.begin_record();
    /// let me = city.agents().next().ok_or("nobody")?;
    /// let yard = city.space().regions().find(|(_, region)| &*region.name == "yard").ok_or("no yard")?.0;
    /// city.go(me, yard)?;
    /// let text = serde_json::to_string(&city.record())?;
    /// let record: Option<CityRecord> = serde_json::from_str(&text)?;
    /// assert_eq!(start.replay(&record.ok_or("none")?)?.digest(), city.digest());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ReplayError`].
    pub fn replay(&self, record: &CityRecord) -> Result<Self, ReplayError> {
        if record.plan != self.space().digest().0 {
            return Err(ReplayError::OtherPlan);
        }
        let ((begin, expected), found) = (record.begin, self.digest());
        if begin != self.tick || expected != found.0 {
            return Err(ReplayError::OtherBeginning { here: self.tick, begin, found, expected: Digest(expected) });
        }
        let mut city = self.clone();
        city.orders = None;
        for Given { tick, agent, order } in &record.orders {
            city.wait_until(*tick);
            // Those that were refused then are refused again.
            let _ = city.order(*agent, *order);
        }
        city.wait_until(record.end.0);
        let found = city.digest();
        if record.end.1 == found.0 {
            Ok(city)
        } else {
            Err(ReplayError::OtherEnd { found, expected: Digest(record.end.1) })
        }
    }

    fn wait_until(&mut self, tick: Tick) {
        self.step(Span(tick.0.saturating_sub(self.tick.0)));
    }

    fn order(&mut self, agent: NodeId, order: Order) -> Result<(), CityError> {
        match order {
            Order::Act(action, Names(called)) => self.give(agent, Action { called, ..action }),
            Order::Go(region) => self.send(agent, region),
            Order::Stop => {
                self.interrupt(agent);
                Ok(())
            }
            Order::Push(impulse, at) => self.push(agent, impulse.into(), at.into()),
        }
    }

    /// Takes note of an order, if a record goes on.
    pub(super) fn write_down(&mut self, agent: NodeId, order: Order) {
        let tick = self.tick;
        self.orders.iter_mut().for_each(|record| record.orders.push(Given { tick, agent, order }));
    }
}

impl Order {
    pub(super) fn act(action: Action) -> Self {
        Self::Act(action, Names(action.called))
    }
}
