//! Actions by the names of their verbs.

use super::{Action, Verb};
use crate::NodeId;

/// Declares a constructor for each line: `name(things) = number of things, verb`.
macro_rules! actions {
    ($($(#[$doc:meta])* $name:ident($($thing:ident),*) = $make:ident $verb:ident;)*) => {
        /// Actions by the names of their verbs; [`Action::zero`], [`Action::one`] and [`Action::two`] make those of
        /// all others.
        ///
        /// ```
        /// use vc_graph::{Action, Draft, SceneBuilder, Simulator};
        /// let mut scene = SceneBuilder::new("flat");
        /// let kitchen = scene.add(Draft::new("kitchen"))?;
        /// let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
        /// scene.add_on(table, Draft::new("mug"))?;
        /// let me = scene.add_in(kitchen, Draft::new("character"))?;
        /// let graph = scene.build();
        /// let mug = graph.first_of_class("mug").ok_or("no mug")?;
        /// let mut home = Simulator::new(graph);
        /// for action in [Action::walk(mug), Action::grab(mug), Action::place(mug, table)] {
        ///     home.step(me, &action).map_err(|refusal| format!("{refusal:?}"))?;
        /// }
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        impl Action {
            $($(#[$doc])* pub const fn $name($($thing: NodeId),*) -> Self { Self::$make(Verb::$verb, $($thing),*) })*
        }
    };
}

actions! {
    /// The agent walks up to a thing or into a room.
    walk(to) = one Walk;
    /// The agent walks up to a thing and looks at it.
    find(thing) = one Find;
    /// A free hand takes a thing.
    grab(thing) = one Grab;
    /// A hand puts a thing on another.
    place(thing, on) = two Place;
    /// A hand puts a thing into another.
    put_in(thing, into) = two PutIn;
    /// A hand puts a thing back to where it was taken from.
    put_back(thing) = one PutBack;
    /// A hand lets a thing fall.
    drop(thing) = one Drop;
    /// The agent opens a thing.
    open(thing) = one Open;
    /// The agent closes a thing.
    close(thing) = one Close;
    /// The agent switches a thing on.
    switch_on(thing) = one SwitchOn;
    /// The agent switches a thing off.
    switch_off(thing) = one SwitchOff;
    /// The agent sits down on a thing.
    sit(on) = one Sit;
    /// The agent lies down on a thing.
    lie(on) = one Lie;
    /// The agent stands up.
    stand() = zero Stand;
    /// The agent eats a thing.
    eat(thing) = one Eat;
    /// The agent drinks a drink, or from a vessel.
    drink(thing) = one Drink;
    /// The agent pours the contents of a vessel into another.
    pour(from, into) = two Pour;
    /// The agent washes a thing.
    wash(thing) = one Wash;
    /// The agent puts a piece of clothing on.
    wear(clothes) = one Wear;
    /// The agent takes a piece of clothing off.
    take_off(clothes) = one TakeOff;
}
