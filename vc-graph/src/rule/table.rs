//! The rule table: each verb's arity, preconditions, effects and aims.

use crate::rule::aim::{self, AimRule};
use crate::rule::condition::Condition::{self, *};
use crate::rule::effect::Argument::{self, X, Y};
use crate::rule::effect::Effect::{self, *};
use crate::{Property, State, Verb};

/// A verb's arity, preconditions, effects and aims.
#[derive(Debug)]
#[non_exhaustive]
pub struct ActionRule {
    /// The verb.
    pub verb: Verb,
    /// The number of objects that it takes.
    pub arity: usize,
    /// The preconditions, in the order in which a planner would bring them about.
    pub preconditions: &'static [Condition<Argument>],
    /// The effects, in order.
    pub effects: &'static [Effect<Argument>],
    /// The aims that it takes.
    pub aims: AimRule,
    /// A description in one sentence.
    pub description: &'static str,
}

impl ActionRule {
    /// The rule with aims that the verb takes.
    const fn aims(self, aims: AimRule) -> Self {
        Self { aims, ..self }
    }
}

impl Verb {
    /// The verb's arity, preconditions and effects.
    ///
    /// ```
    /// use vc_graph::Verb;
    /// assert!(!Verb::Grab.rule().preconditions.is_empty());
    /// ```
    pub fn rule(self) -> &'static ActionRule {
        // A test checks that the table is in the order of the verbs.
        &RULES[self as usize]
    }
}

const fn rule(
    verb: Verb,
    arity: usize,
    preconditions: &'static [Condition<Argument>],
    effects: &'static [Effect<Argument>],
    description: &'static str,
) -> ActionRule {
    ActionRule { verb, arity, preconditions, effects, aims: AimRule::NONE, description }
}

/// All rules, in the order of the verbs.
#[rustfmt::skip]
pub const RULES: &[ActionRule] = &[
    rule(Verb::Walk, 1, &[Reachable(X), Other(X), Upright], &[GoTo(X)],
        "Walks to a room, or into the room of a thing and up to it. Doors do not block: one opens and closes them in passing. What was near is no longer.")
        .aims(aim::GOING),
    rule(Verb::Run, 1, &[Reachable(X), Other(X), Upright], &[GoTo(X)],
        "As walk, faster.")
        .aims(aim::GOING),
    rule(Verb::Find, 1, &[Reachable(X), Other(X), UprightOrNear(X)], &[Approach(X)],
        "Notices a thing that is near, or walks up to it."),
    rule(Verb::TurnTo, 1, &[Other(X)], &[Face(X)],
        "Turns towards a thing, near or not.")
        .aims(aim::TURNING),
    rule(Verb::LookAt, 1, &[Facing(X)], &[],
        "Looks at a thing one faces, or that is faced by what one faces."),
    rule(Verb::PointAt, 1, &[Facing(X)], &[],
        "Points at a thing one faces.")
        .aims(aim::POINTING),
    rule(Verb::Watch, 1, &[Affords(X, Property::Lookable), SameRoom(X), Accessible(X), Facing(X)], &[],
        "Watches a screen or picture in the same room."),
    rule(Verb::Grab, 1, &[Graspable(X), NotElsewhereHeld(X), Accessible(X), FreeHandOrHolding(X), Near(X)], &[Hold(X)],
        "Takes a thing into a free hand, with all that lies on it. Grabbing what one holds changes nothing.")
        .aims(aim::TAKING),
    rule(Verb::Place, 2, &[Carries(Y), Fits(X, Y), Holding(X), Accessible(Y), Near(Y)], &[PutOn(X, Y)],
        "Puts a held thing on a surface.")
        .aims(aim::PUTTING),
    rule(Verb::PutIn, 2, &[Encloses(Y), Fits(X, Y), Holding(X), Accessible(Y), Accepts(Y), Near(Y)], &[PutInto(X, Y)],
        "Puts a held thing into a container, which must be open if it opens.")
        .aims(aim::PUTTING),
    rule(Verb::PutBack, 1, &[Holding(X), OriginNear(X)], &[PutWhereItWas(X)],
        "Puts a held thing back where it was taken from; that must be near, and open if it opens."),
    rule(Verb::Drop, 1, &[Holding(X)], &[LetGo(X)],
        "Lets a held thing go: it is in the room, on nothing in particular.")
        .aims(aim::DROPPING),
    rule(Verb::Open, 1, &[Affords(X, Property::Openable), In(X, State::Closed), SafeToOpen(X), FreeHand, Accessible(X), Near(X)],
        &[Enter(X, State::Open)],
        "Opens what is closed; machines only when they are off, fridges and ovens at any time."),
    rule(Verb::Close, 1, &[Affords(X, Property::Openable), In(X, State::Open), Accessible(X), Near(X)],
        &[Enter(X, State::Closed)],
        "Closes what is open; an elbow does, no free hand is needed."),
    rule(Verb::SwitchOn, 1, &[Affords(X, Property::Switchable), In(X, State::Off), NotIn(X, State::PluggedOut), Accessible(X), Near(X)],
        &[Enter(X, State::On)],
        "Switches on what is off and not unplugged."),
    rule(Verb::SwitchOff, 1, &[Affords(X, Property::Switchable), In(X, State::On), Accessible(X), Near(X)],
        &[Enter(X, State::Off)],
        "Switches off what is on."),
    rule(Verb::PlugIn, 1, &[Affords(X, Property::Plug), In(X, State::PluggedOut), FreeHand, Accessible(X), Near(X)],
        &[Enter(X, State::PluggedIn)],
        "Puts the plug into a socket."),
    rule(Verb::PlugOut, 1, &[Affords(X, Property::Plug), In(X, State::PluggedIn), NotIn(X, State::On), FreeHand, Accessible(X), Near(X)],
        &[Enter(X, State::PluggedOut)],
        "Pulls the plug of what is off."),
    rule(Verb::Sit, 1, &[Affords(X, Property::Sittable), SeatFree(X), Steady(X), NotSitting, Near(X)],
        &[SitOn(X)],
        "Sits down; one then faces what the seat faces. One may sit up from lying.")
        .aims(aim::SITTING),
    rule(Verb::Lie, 1, &[Affords(X, Property::Lieable), BedFree(X), Steady(X), NotLying, Near(X)],
        &[LieOn(X)],
        "Lies down; one may lie down from sitting."),
    rule(Verb::Stand, 0, &[AtRest], &[StandUp],
        "Stands up from what one sits or lies on."),
    rule(Verb::Sleep, 0, &[AtRest], &[EnterOwn(State::Asleep)],
        "Falls asleep, sitting or lying."),
    rule(Verb::WakeUp, 0, &[AtRest], &[LeaveOwn(State::Asleep)],
        "Wakes up; one stays sitting or lying."),
    rule(Verb::Eat, 1, &[Edible(X), Accessible(X), Near(X)], &[],
        "Eats something, or something on the plate that is named. It stays in the scene."),
    rule(Verb::Drink, 1, &[Potable(X), Holding(X)], &[],
        "Drinks what is held, or what is in it."),
    rule(Verb::Touch, 1, &[Tangible(X), Accessible(X), Near(X)], &[],
        "Touches a thing."),
    rule(Verb::Read, 1, &[Affords(X, Property::Readable), Holding(X)], &[],
        "Reads something that is held."),
    rule(Verb::Wipe, 1, &[Tangible(X), HoldingSomething, Accessible(X), Near(X)], &[Enter(X, State::Clean)],
        "Wipes a thing with what is in one's hand."),
    rule(Verb::Wash, 1, &[Tangible(X), Accessible(X), Near(X)], &[Enter(X, State::Clean)],
        "Washes a thing."),
    rule(Verb::Rinse, 1, &[Tangible(X), Accessible(X), Near(X)], &[Enter(X, State::Clean)],
        "Rinses a thing."),
    rule(Verb::Scrub, 1, &[Tangible(X), Accessible(X), Near(X)], &[Enter(X, State::Clean)],
        "Scrubs a thing."),
    rule(Verb::Pour, 2, &[Liquid(X), Receives(Y), Holding(X), Accessible(Y), Near(Y)], &[PourInto(X, Y)],
        "Pours what is held into something, which is then filled with it. Water itself leaves the hand; a bottle stays in it."),
    rule(Verb::Fill, 2, &[Affords(X, Property::Recipient), Affords(Y, Property::WaterSource), Holding(X), In(Y, State::On), Near(Y)],
        &[FillWithWater(X)],
        "Fills a held vessel at running water."),
    rule(Verb::Cut, 1, &[Cuttable(X), HoldingKind(Property::Cutter), FreeHandOrHolding(X), Accessible(X), Near(X)], &[Enter(X, State::Sliced)],
        "Cuts food with a knife in one hand, holding it with the other."),
    rule(Verb::Cook, 1, &[Affords(X, Property::Cookable), OnHeat(X), Near(X)], &[Enter(X, State::Cooked), Enter(X, State::Hot)],
        "Cooks what is, in a pot or not, on or in a heater that is on."),
    rule(Verb::Wear, 1, &[Affords(X, Property::Wearable), Holding(X)], &[PutOnBody(X)],
        "Puts on clothes that are held."),
    rule(Verb::TakeOff, 1, &[Worn(X), FreeHand], &[Hold(X)],
        "Takes worn clothes off, into a free hand."),
    rule(Verb::Fold, 1, &[Affords(X, Property::Foldable), Accessible(X), Near(X)], &[Enter(X, State::Folded)],
        "Folds cloth or paper."),
    rule(Verb::Unfold, 1, &[Affords(X, Property::Foldable), In(X, State::Folded), Accessible(X), Near(X)], &[Enter(X, State::Unfolded)],
        "Spreads out what is folded."),
    rule(Verb::Push, 1, &[Tangible(X), Other(X), Accessible(X), FreeHandOrHolding(X), Near(X)], &[],
        "Pushes a thing, a button as well."),
    rule(Verb::Pull, 1, &[Mobile(X), Accessible(X), FreeHandOrHolding(X), Near(X)], &[],
        "Pulls a thing that moves."),
    rule(Verb::Move, 1, &[Mobile(X), Accessible(X), FreeHandOrHolding(X), Near(X)], &[],
        "Moves a thing that moves a little."),
    rule(Verb::Squeeze, 1, &[Soft(X), FreeHandOrHolding(X), Accessible(X), Near(X)], &[],
        "Squeezes a cloth, a sponge, a tube."),
    rule(Verb::Type, 1, &[Typable(X), Accessible(X), Near(X)], &[],
        "Types on a keyboard or a device."),
    rule(Verb::Greet, 1, &[Personal(X), Other(X)], &[],
        "Greets a person."),
    rule(Verb::Play, 1, &[Tangible(X), Other(X), Accessible(X), Near(X)], &[],
        "Plays with a toy or game, or on an instrument."),
    rule(Verb::Enter, 1, &[Affords(X, Property::Drivable), SeatInside(X), Steady(X), Upright, Near(X)], &[Board(X)],
        "Gets into a vehicle; doors do not block."),
    rule(Verb::Leave, 0, &[Aboard], &[Alight],
        "Gets out of the vehicle one is in, into the place where it stands."),
    rule(Verb::Drive, 2, &[Affords(X, Property::Drivable), AboardOf(X), In(X, State::On), Reachable(Y)], &[DriveTo(X, Y)],
        "Drives the running vehicle one is in to a place, with all that is in it."),
    rule(Verb::Dance, 0, &[Upright], &[],
        "Dances."),
    rule(Verb::Wave, 0, &[], &[],
        "Waves."),
    rule(Verb::Exercise, 0, &[], &[],
        "Does exercises."),
    rule(Verb::Stretch, 0, &[], &[],
        "Stretches."),
    rule(Verb::Smile, 0, &[], &[],
        "Smiles."),
    rule(Verb::Heat, 1, &[Graspable(X), OnHeat(X), Near(X)], &[EnterWith(X, State::Hot)],
        "Heats what is on or in a heater that is on, with all that is on or in it: a pot and the soup in it."),
    rule(Verb::Cool, 1, &[Graspable(X), InCold(X), Near(X)], &[EnterWith(X, State::Cold)],
        "Cools what is inside a cooler that is on, with all that is on or in it."),
    rule(Verb::Dry, 1, &[Tangible(X), HoldingKind(Property::Wiper), Accessible(X), Near(X)], &[Enter(X, State::Dry)],
        "Dries a thing with the cloth in one's hand."),
    rule(Verb::Soil, 1, &[Tangible(X), Accessible(X), Near(X)], &[Enter(X, State::Dirty)],
        "Makes a thing dirty."),
];
