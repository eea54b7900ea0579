//! Acting: actions at points, the actions that are possible, control of bodies, and paths of your own.
//!
//! # Actions at points
//!
//! An action may have an [`Aim`](crate::graph::Aim): a coordinate, a rotation, a seat, a slot or a side. Points are in the
//! world's frame, metres, Z up; headings are degrees counter-clockwise from X. Point and heading of a thing are those of
//! its pose, those of an agent are of its feet. In the text of an action they come after its objects.
//!
//! | text | meaning |
//! |---|---|
//! | `walk at 3.20 1.50 yaw 90`, `run at 3.20 1.50` | to a point of the floor, turned so |
//! | `walk table.3 at 3.20 1.50`, `walk table.3 yaw 90` | to this point near a thing; up to it and turned so |
//! | `turn_to yaw 90`, `turn_to at 3.20 1.50`, `point_at at 3.20 1.50 1.80` | to a heading, to a point, at a place |
//! | `place cup.12 table.3 at 1.20 0.40 yaw 90` | at a point of a surface, turned so; `put_in` takes the same |
//! | `put_in plate.7 dishwasher.4 slot 2`, `place pan.5 stove.6 slot 1` | in this rack, shelf or drawer; on this burner |
//! | `drop cup.12 at 2.00 1.00` | at a point of the floor |
//! | `grab cup.12 by left` | by the front, back, left, right or top |
//! | `sit sofa.9 seat 2` | on this seat |
//!
//! A thing that is put down rests within one centimetre and two degrees of the pose asked for, and so do feet; otherwise
//! the action ends in an error with the reason. Where the rule can tell, the action is refused and nothing has changed; where the
//! planner finds out (no room, no way), the agent is left where it has walked meanwhile; and after
//! [`PhysicalRefusal::OffAim`](crate::PhysicalRefusal::OffAim) the thing lies where it has come to rest.
//!
//! ```
//! use virtualcity::graph::{Action, Place, Relation};
//! use virtualcity::{ActionError, Environment, PhysicalRefusal};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let (me, table) = (home.agents()[0], home.graph().of_class("coffee_table")[0]);
//! let mug = home.spawn("mug", Place { relation: Relation::On, at: table })?;
//! home.set_action(me, Action::walk(mug))?;
//! home.set_action(me, Action::grab(mug))?;
//! let middle = home.graph().node(table).and_then(|node| node.aabb()).ok_or("no box")?.centre();
//! let place = format!("place mug.{} coffee_table.{} at {:.3} {:.3} yaw 90", mug.0, table.0, middle.x, middle.y);
//! home.set_action(me, place.parse()?)?;
//! let far = home.world().pose(mug).ok_or("no body")?.translation.vector.xy() - middle.coords.xy();
//! assert!(far.norm() < 0.01);
//! // The table is in the way.
//! let walk = format!("walk at {:.3} {:.3}", middle.x, middle.y);
//! let error = home.set_action(me, walk.parse()?).unwrap_err();
//! assert!(matches!(error, ActionError::Impossible { why: PhysicalRefusal::PointTaken { .. }, .. }), "{error}");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Legal actions with things in view
//!
//! [`legal_actions`](crate::Environment::legal_actions) lists all actions that are possible in the whole home.
//! For an agent that chooses among visible things, `rule::legal_actions_with` takes these things as an
//! argument. [`objects_in_view`](crate::Environment::objects_in_view) lists the visible things as data for
//! JSON.
//!
//! ```
//! use virtualcity::Environment;
//! use virtualcity::graph::{Action, NodeId, Verb, rule};
//!
//! let home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let view: Vec<NodeId> = home.room_observation(me).ids().collect();
//! let mut able = rule::legal_actions_with(home.graph(), me, &view);
//! // Rooms are always known. Two verbs are excluded: nobody types on a table.
//! able.retain(|action| !matches!(action.verb, Verb::Rinse | Verb::Type));
//! assert!(able.iter().flat_map(Action::things).all(|id| view.contains(&id)));
//! assert!(able.len() < home.legal_actions(me).len());
//! println!("{}", serde_json::to_string(&home.objects_in_view(me))?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Control in every tick
//!
//! Beside actions there is the low level: [`Environment::control`](crate::Environment::control) gives a body a velocity, a turn,
//! a direction of the head and goals of its hands, until the next control. Goals are in the body's own frame: X ahead, Y to
//! the left, the origin between the feet. A hand that closes around something holds it if the rule allows it, and the graph says
//! so; the example `hands` opens a drawer and takes a spoon out of it.
//!
//! ```
//! use virtualcity::graph::clock::Span;
//! use virtualcity::graph::{Action, Place, Relation};
//! use virtualcity::nalgebra::{Point3, UnitQuaternion, Vector3};
//! use virtualcity::physics::{Hand, HandGoal};
//! use virtualcity::{Control, Environment};
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let (me, table) = (home.agents()[0], home.graph().of_class("dining_table")[0]);
//! let glass = home.spawn("water_glass", Place { relation: Relation::On, at: table })?;
//! home.set_action(me, Action::walk(glass))?;
//!
//! // Fingers ahead, the thumb on the left: at first above the glass and before it, then around it, then up.
//! let feet = home.world().pose(me).ok_or("no body")?;
//! let glass_at = feet.inverse() * home.world().aabb(glass).ok_or("no body")?.centre();
//! let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), std::f32::consts::FRAC_PI_2);
//! let pose = |back: f32, up: f32| {
//!     let at: Point3<f32> = glass_at + Vector3::new(-back, 0.0, up);
//!     virtualcity::graph::Pose::from_parts(at.coords.into(), turn)
//! };
//! for (pose, grip) in [(pose(0.2, 0.2), 0.0), (pose(0.15, 0.0), 0.0), (pose(0.0, 0.0), 0.0), (pose(0.0, 0.0), 1.0)] {
//!     let hand = HandGoal { pose, grip, ..HandGoal::default() };
//!     home.control(me, &Control { hands: [Some(hand), None], ..Control::default() })?;
//!     home.step(Span::from_seconds(1.0));
//! }
//! let hand = home.controlled_hand(me, Hand::Right).ok_or("not under control")?;
//! assert_eq!(hand.body.holds, Some((glass, None)), "{:?}", hand.refused);
//! assert_eq!(home.graph().holder(glass).map(|place| place.relation), Some(Relation::HoldsRight));
//!
//! // Control ends, and an action goes on with it.
//! home.interrupt(me);
//! home.set_action(me, Action::place(glass, table))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Paths from your own planner
//!
//! The walkable floor is available as a grid for your own planner; here it is searched breadth first. The body
//! is then steered, or teleported to the end of the path. (`home.floor().route(from, to)` is the built-in
//! planner, for paths at any angle.)
//!
//! ```
//! use std::collections::{BTreeMap, VecDeque};
//! use virtualcity::Environment;
//! use virtualcity::nalgebra::Point2;
//!
//! let mut home = Environment::make("apartment/42", 1)?;
//! let me = home.agents()[0];
//! let grid = home.occupancy();
//! let here = Point2::from(home.world().pose(me).ok_or("no body")?.translation.vector.xy());
//! let start = grid.cell_of(here).ok_or("off the grid")?;
//! let mut from = BTreeMap::from([(start, start)]);
//! let mut open = VecDeque::from([start]);
//! let mut last = start;
//! while let Some((column, row)) = open.pop_front() {
//!     last = (column, row);
//!     let beside = [(column + 1, row), (column.wrapping_sub(1), row), (column, row + 1), (column, row.wrapping_sub(1))];
//!     for next in beside {
//!         if grid.is_free(next.0, next.1) && !from.contains_key(&next) {
//!             from.insert(next, (column, row));
//!             open.push_back(next);
//!         }
//!     }
//! }
//! // The farthest reachable cell.
//! let steps = std::iter::successors(Some(last), |cell| (*cell != start).then(|| from[cell])).count();
//! assert!(steps as f32 * grid.cell > 4.0, "{steps} cells of {} m", grid.cell);
//! home.teleport(me, grid.centre(last.0, last.1))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
