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
//! A front door is a thing of both its sides: from the gallery `walk main_door.N` ends before it, and `open` and `close` move
//! it; [`City::legal_actions`](crate::City::legal_actions) lists these. Many at one door or lift heed each other: one waits until there is
//! room beyond, those who stand in the way step aside, and whoever has no room in a lift takes the next ride.
//!
//! # A house of a city
//!
//! [`House`](crate::procgen::House) makes a building of a [city's plan](crate::procgen::city::CityPlan) such a world: a hall with a door to the
//! street, landings with stairs and a lift, flats whose windows are those of the facade. `house/7` is one of a small city.
//!
//! ```
//! use virtualcity::graph::Seed;
//! use virtualcity::procgen::House;
//! use virtualcity::procgen::city::{CityPlan, CitySpecification};
//! use virtualcity::City;
//!
//! let wishes = CitySpecification { area: 0.2, ..CitySpecification::default() };
//! let plan = CityPlan::generate(&wishes, Seed(7))?;
//! let house = (0..plan.buildings().len()).find_map(|building| House::of(&plan, building).ok()).ok_or("no house")?;
//! let (street, top) = (house.street(), house.storeys().last().ok_or("no storey")?.homes[0]);
//! let mut city = City::of(house).make()?;
//! let me = city.agents().next().ok_or("nobody")?;
//! city.go(me, street)?;
//! city.go(me, top)?;
//! println!("{} after {}", city.region_label(top), city.tick());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Streets
//!
//! [`Outdoors`](crate::procgen::Outdoors) makes a scene of all that stands within a distance of a place of a plan: ground, markings, buildings
//! with the windows of their flats, cars, trees. It is drawn as any other scene; nobody walks there yet.
//!
//! ```
//! use virtualcity::graph::Seed;
//! use virtualcity::nalgebra::Point3;
//! use virtualcity::procgen::Outdoors;
//! use virtualcity::procgen::city::{CityPlan, CitySpecification};
//! use virtualcity::render::{Camera, Frame, Modality, Renderer, Shot};
//!
//! let wishes = CitySpecification { area: 0.2, ..CitySpecification::default() };
//! let plan = CityPlan::generate(&wishes, Seed(7))?;
//! let crossroads = plan.streets()[0].line[0];
//! let scene = Outdoors::of(&plan).scene(&crossroads, 30.0)?;
//! let mut renderer = Renderer::new();
//! let snapshot = renderer.snapshot(&scene)?;
//! let camera = Camera::with_fov(160, 120, 1.2).looking(Point3::new(0.0, 0.0, 1.6), Point3::new(10.0, 0.0, 1.6));
//! let mut frame = Frame::new();
//! renderer.render(&Shot::new(&snapshot, &camera, Modality::Depth | Modality::Instance), &mut frame)?;
//! assert!(frame.instance.iter().any(|id| scene.node(*id).is_some()));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Seen through doors
//!
//! Pictures and observations reach through open doors and other portals, also into regions where nobody is; looking changes
//! nothing. Ids of pictures are node numbers, of which each region has its own: [`City::region_of`](crate::City::region_of) says
//! the region of one, [`City::peek`](crate::City::peek) has the node.
//!
//! ```
//! use virtualcity::graph::{Action, Seed, Verb};
//! use virtualcity::procgen::Building;
//! use virtualcity::render::Modality;
//! use virtualcity::{City, Viewpoint};
//!
//! let building = Building::from_seed(Seed(7))?;
//! let (gallery, front_door) = (building.storeys()[0].gallery, building.storeys()[0].front_doors[0]);
//! let mut city = City::of(building).make()?;
//! let me = city.agents().next().ok_or("nobody")?;
//! let door = city.space().portal(front_door).and_then(|portal| portal.leaf).ok_or("no door")?;
//! city.set_action(me, Action::walk(door))?;
//! assert!(city.room_observation(me)?.beyond().is_empty());
//! city.set_action(me, Action::one(Verb::Open, door))?;
//!
//! // Through the open door: in the picture, and in what is observed.
//! let frame = city.render(Viewpoint::Agent(me), Modality::Instance, 160, 120)?;
//! let outside = frame.instance.iter().find(|id| city.region_of(**id) == Some(gallery)).ok_or("a wall")?;
//! println!("{} in {}", city.peek(gallery)?.graph().label(*outside), city.space().path(gallery));
//! let seen = city.room_observation(me)?;
//! assert!(seen.references().any(|(region, _)| region == gallery));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Goals beyond the home
//!
//! A goal has a [scope](crate::GoalScope): unless it is said otherwise the agent's home, with what the agent carries wherever it
//! is; a place with all that is part of it; or the world, as far as somebody has changed it.
//!
//! ```
//! use virtualcity::graph::Goal;
//! use virtualcity::graph::space::RegionKind;
//! use virtualcity::{City, GoalScope};
//!
//! let mut city = City::make("building/7", 1)?;
//! let me = city.agents().next().ok_or("nobody")?;
//! let storey = city.space().regions().find(|(_, region)| region.kind == RegionKind::Storey).ok_or("no storey")?.0;
//! let goal: Goal = "Closed(fridge), 2".parse()?;
//! assert!(!city.holds(&goal, me, GoalScope::Home)?, "it has one");
//! assert!(city.holds(&goal, me, GoalScope::Place(storey))?, "the storey has two homes");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # A city that is saved
//!
//! A city is saved at any tick, also while somebody is on the stairs; it is restored by one that was made in the same way, in
//! another process too. Regions that nobody has changed take nothing. `save_whole` keeps the scenes as well, so that a city is
//! restored after its generator has changed.
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
