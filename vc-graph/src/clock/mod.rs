//! Time: ticks, days, weather, and what machines and matter do by themselves.
//!
//! Everything here is a function of the [`Tick`], so it is the same however one gets there. Nothing acts by itself: a
//! program that wants things to go on keeps a [`Running`] beside its graph and advances it.
//!
//! ```
//! use vc_graph::clock::{ProcessTable, Running, Span};
//! use vc_graph::{Draft, SceneBuilder, State};
//! let mut scene = SceneBuilder::new("flat");
//! let bathroom = scene.add(Draft::new("bathroom"))?;
//! let machine = scene.add_in(bathroom, Draft::new("washing_machine").state(State::On))?;
//! let shirt = scene.add_in(machine, Draft::new("shirt").state(State::Dirty))?;
//! let mut graph = scene.build();
//! let (table, mut running) = (ProcessTable::builtin(), Running::default());
//! let mut after = |span: &str| -> Result<bool, Box<dyn std::error::Error>> {
//!     running.advance(&table, &mut graph, span.parse()?)?;
//!     Ok(graph.node(shirt).is_some_and(|node| node.is(State::Clean)))
//! };
//! assert!(!after("60 min")? && after("30 min")?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod day;
mod durations;
mod error;
mod kind;
mod needs;
mod noise;
mod process;
mod process_table;
mod running;
mod text;
mod tick;
mod weather;

pub use day::{DAY, DayTime, DayTimeError};
pub use durations::Durations;
pub use error::{ClockError, ClockProblem};
pub use process::Process;
pub use process_table::ProcessTable;
pub use running::{Running, Since};
pub use tick::{Span, SpanError, TICKS_PER_SECOND, Tick};
pub use weather::{Weather, weather};
