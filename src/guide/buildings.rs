//! Several homes with stairs and a lift between them.
//!
//! # A walk to the neighbours
//!
//! [`City`](crate::City) has an [`Environment`](crate::Environment) for each region in which somebody is: a home, a gallery, the
//! cabin of a lift. A walk to a thing elsewhere leads through doors, over stairs and by lift, and whatever is held comes along.
//! [`Building`](crate::procgen::Building) says by name which regions and buttons there are; `building/7` is the same
//! building for [`City::make`](crate::City::make).
//!
//! ```
//! use virtualcity::graph::Seed;
//! use virtualcity::graph::clock::Span;
//! use virtualcity::procgen::Building;
//! use virtualcity::{City, LiftState};
//!
//! let building = Building::from_seed(Seed(7))?;
//! let (storeys, cabin) = (building.storeys().to_vec(), building.cabin());
//! let mut city = City::of(building).agents(2).make()?;
//! let agents: Vec<_> = city.agents().collect();
//!
//! // The first takes the stairs to the gallery above, the other goes down to the yard meanwhile.
//! let yard = city.space().regions().find(|(_, region)| &*region.name == "yard").ok_or("no yard")?.0;
//! city.set_ways(agents[0], move |portal| portal.sides.iter().all(|side| side.region != cabin));
//! city.send(agents[1], yard)?;
//! city.go(agents[0], storeys[1].gallery)?;
//!
//! // A button calls the lift.
//! let button = storeys[1].call_button.0;
//! city.set_action(agents[0], format!("walk call_button.{button}").parse()?)?;
//! city.set_action(agents[0], format!("push call_button.{button}").parse()?)?;
//! while city.lift(cabin) != Some(LiftState::Open(1)) {
//!     city.step(Span(30));
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A city that is saved
//!
//! A city is saved at any tick, also while somebody is on the stairs; it is restored by one that was made in the same way, in
//! another process too. Regions that nobody has changed take nothing.
//!
//! ```
//! use virtualcity::City;
//! use virtualcity::graph::clock::Span;
//!
//! let mut city = City::make("building/7", 1)?;
//! let me = city.agents().next().ok_or("nobody")?;
//! let yard = city.space().regions().find(|(_, region)| &*region.name == "yard").ok_or("no yard")?.0;
//! city.send(me, yard)?;
//! city.step(Span(200));
//! let saved = city.save()?;
//!
//! let mut other = City::make("building/7", 1)?.restore(&saved)?;
//! city.step(Span(2000));
//! other.step(Span(2000));
//! assert_eq!(city.digest(), other.digest());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
