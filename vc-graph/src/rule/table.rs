//! The rule table: each built-in verb's arity, preconditions, effects, aims and motion.

use std::borrow::Cow;

use crate::rule::aim::AimRule;
use crate::rule::aim_sets;
use crate::rule::condition::Condition::{self, *};
use crate::rule::effect::Argument::{self, X, Y};
use crate::rule::effect::Effect::{self, *};
use crate::rule::motion::Motion;
use crate::{Property, State, Verb};

/// A verb's arity, preconditions, effects, aims and motion.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ActionRule {
    /// The verb.
    pub verb: Verb,
    /// The number of objects that it takes.
    pub arity: usize,
    /// The preconditions, in the order in which a planner would bring them about.
    pub preconditions: Cow<'static, [Condition<Argument>]>,
    /// The effects, in order.
    pub effects: Cow<'static, [Effect<Argument>]>,
    /// The aims that it takes.
    pub aims: AimRule,
    /// The motion by which a body shows it.
    pub motion: Motion,
    /// A description in one sentence.
    pub description: Cow<'static, str>,
}

impl ActionRule {
    /// The rule with aims that the verb takes.
    const fn aims(mut self, aims: AimRule) -> Self {
        self.aims = aims;
        self
    }
}

const fn rule(
    verb: Verb,
    arity: usize,
    preconditions: &'static [Condition<Argument>],
    effects: &'static [Effect<Argument>],
    motion: Motion,
    description: &'static str,
) -> ActionRule {
    let (preconditions, effects) = (Cow::Borrowed(preconditions), Cow::Borrowed(effects));
    let (aims, description) = (AimRule::NONE, Cow::Borrowed(description));
    ActionRule { verb, arity, preconditions, effects, aims, motion, description }
}

/// All built-in rules, in the order of the verbs.
#[rustfmt::skip]
pub static RULES: &[ActionRule] = &[
    rule(Verb::Walk, 1, &[Reachable(X), Other(X), Upright], &[GoTo(X)],
        Motion::Go, "Walks to a room, or into the room of a thing and up to it. Doors do not block: one opens and closes them in passing. What was near is no longer.")
        .aims(aim_sets::GOING),
    rule(Verb::Run, 1, &[Reachable(X), Other(X), Upright], &[GoTo(X)],
        Motion::Run, "As walk, faster.")
        .aims(aim_sets::GOING),
    rule(Verb::Find, 1, &[Reachable(X), Other(X), UprightOrNear(X)], &[Approach(X)],
        Motion::Go, "Notices a thing that is near, or walks up to it."),
    rule(Verb::TurnTo, 1, &[Other(X)], &[Face(X)],
        Motion::Look, "Turns towards a thing, near or not.")
        .aims(aim_sets::TURNING),
    rule(Verb::LookAt, 1, &[Facing(X)], &[],
        Motion::Look, "Looks at a thing one faces, or that is faced by what one faces."),
    rule(Verb::PointAt, 1, &[Facing(X)], &[],
        Motion::Point, "Points at a thing one faces.")
        .aims(aim_sets::POINTING),
    rule(Verb::Watch, 1, &[Affords(X, Property::Lookable), SameRoom(X), Accessible(X), Facing(X)], &[],
        Motion::Look, "Watches a screen or picture in the same room."),
    rule(Verb::Grab, 1, &[Graspable(X), NotElsewhereHeld(X), Accessible(X), FreeHandOrHolding(X), Near(X)], &[Hold(X)],
        Motion::Hold, "Takes a thing into a free hand, with all that lies on it. Grabbing what one holds changes nothing.")
        .aims(aim_sets::TAKING),
    rule(Verb::Place, 2, &[Carries(Y), Fits(X, Y), Holding(X), Accessible(Y), Near(Y)], &[PutOn(X, Y)],
        Motion::Hold, "Puts a held thing on a surface.")
        .aims(aim_sets::PUTTING),
    rule(Verb::PutIn, 2, &[Encloses(Y), Fits(X, Y), Holding(X), Accessible(Y), Accepts(Y), Near(Y)], &[PutInto(X, Y)],
        Motion::Hold, "Puts a held thing into a container, which must be open if it opens.")
        .aims(aim_sets::PUTTING),
    rule(Verb::PutBack, 1, &[Holding(X), OriginNear(X)], &[PutWhereItWas(X)],
        Motion::Hold, "Puts a held thing back where it was taken from; that must be near, and open if it opens."),
    rule(Verb::Drop, 1, &[Holding(X)], &[LetGo(X)],
        Motion::Hold, "Lets a held thing go: it is in the room, on nothing in particular.")
        .aims(aim_sets::DROPPING),
    rule(Verb::Open, 1, &[Affords(X, Property::Openable), In(X, State::Closed), SafeToOpen(X), FreeHand, Accessible(X), Near(X)],
        &[Enter(X, State::Open)],
        Motion::Reach, "Opens what is closed; machines only when they are off, fridges and ovens at any time."),
    rule(Verb::Close, 1, &[Affords(X, Property::Openable), In(X, State::Open), Accessible(X), Near(X)],
        &[Enter(X, State::Closed)],
        Motion::Reach, "Closes what is open; an elbow does, no free hand is needed."),
    rule(Verb::SwitchOn, 1, &[Affords(X, Property::Switchable), In(X, State::Off), NotIn(X, State::PluggedOut), Accessible(X), Near(X)],
        &[Enter(X, State::On)],
        Motion::Switch, "Switches on what is off and not unplugged."),
    rule(Verb::SwitchOff, 1, &[Affords(X, Property::Switchable), In(X, State::On), Accessible(X), Near(X)],
        &[Enter(X, State::Off)],
        Motion::Switch, "Switches off what is on."),
    rule(Verb::PlugIn, 1, &[Affords(X, Property::Plug), In(X, State::PluggedOut), FreeHand, Accessible(X), Near(X)],
        &[Enter(X, State::PluggedIn)],
        Motion::Reach, "Puts the plug into a socket."),
    rule(Verb::PlugOut, 1, &[Affords(X, Property::Plug), In(X, State::PluggedIn), NotIn(X, State::On), FreeHand, Accessible(X), Near(X)],
        &[Enter(X, State::PluggedOut)],
        Motion::Reach, "Pulls the plug of what is off."),
    rule(Verb::Sit, 1, &[Affords(X, Property::Sittable), SeatFree(X), Steady(X), NotSitting, Near(X)],
        &[SitOn(X)],
        Motion::Sit, "Sits down; one then faces what the seat faces. One may sit up from lying.")
        .aims(aim_sets::SITTING),
    rule(Verb::Lie, 1, &[Affords(X, Property::Lieable), BedFree(X), Steady(X), NotLying, Near(X)],
        &[LieOn(X)],
        Motion::Sit, "Lies down; one may lie down from sitting."),
    rule(Verb::Stand, 0, &[AtRest], &[StandUp],
        Motion::Nothing, "Stands up from what one sits or lies on."),
    rule(Verb::Sleep, 0, &[AtRest], &[EnterOwn(State::Asleep)],
        Motion::Nothing, "Falls asleep, sitting or lying."),
    rule(Verb::WakeUp, 0, &[AtRest], &[LeaveOwn(State::Asleep)],
        Motion::Nothing, "Wakes up; one stays sitting or lying."),
    rule(Verb::Eat, 1, &[Edible(X), Accessible(X), Near(X)], &[],
        Motion::Eat, "Eats something, or something on the plate that is named. It stays in the scene."),
    rule(Verb::Drink, 1, &[Potable(X), Holding(X)], &[],
        Motion::Drink, "Drinks what is held, or what is in it."),
    rule(Verb::Touch, 1, &[Tangible(X), Accessible(X), Near(X)], &[],
        Motion::Reach, "Touches a thing."),
    rule(Verb::Read, 1, &[Affords(X, Property::Readable), Holding(X)], &[],
        Motion::Read, "Reads something that is held."),
    rule(Verb::Wipe, 1, &[Tangible(X), HoldingSomething, Accessible(X), Near(X)], &[Enter(X, State::Clean)],
        Motion::UseAt, "Wipes a thing with what is in one's hand."),
    rule(Verb::Wash, 1, &[Tangible(X), Accessible(X), Near(X)], &[Enter(X, State::Clean)],
        Motion::UseAt, "Washes a thing."),
    rule(Verb::Rinse, 1, &[Tangible(X), Accessible(X), Near(X)], &[Enter(X, State::Clean)],
        Motion::UseAt, "Rinses a thing."),
    rule(Verb::Scrub, 1, &[Tangible(X), Accessible(X), Near(X)], &[Enter(X, State::Clean)],
        Motion::UseAt, "Scrubs a thing."),
    rule(Verb::Pour, 2, &[Liquid(X), Receives(Y), Holding(X), Accessible(Y), Near(Y)], &[PourInto(X, Y)],
        Motion::Pour, "Pours what is held into something, which is then filled with it. Water itself leaves the hand; a bottle stays in it."),
    rule(Verb::Fill, 2, &[Affords(X, Property::Recipient), Affords(Y, Property::WaterSource), Holding(X), In(Y, State::On), Near(Y)],
        &[FillWithWater(X)],
        Motion::Fill, "Fills a held vessel at running water."),
    rule(Verb::Cut, 1, &[Cuttable(X), HoldingKind(Property::Cutter), FreeHandOrHolding(X), Accessible(X), Near(X)], &[Enter(X, State::Sliced)],
        Motion::Cut, "Cuts food with a knife in one hand, holding it with the other."),
    rule(Verb::Cook, 1, &[Affords(X, Property::Cookable), OnHeat(X), Near(X)], &[Enter(X, State::Cooked), Enter(X, State::Hot)],
        Motion::UseAt, "Cooks what is, in a pot or not, on or in a heater that is on."),
    rule(Verb::Wear, 1, &[Affords(X, Property::Wearable), Holding(X)], &[PutOnBody(X)],
        Motion::Hold, "Puts on clothes that are held."),
    rule(Verb::TakeOff, 1, &[Worn(X), FreeHand], &[Hold(X)],
        Motion::Hold, "Takes worn clothes off, into a free hand."),
    rule(Verb::Fold, 1, &[Affords(X, Property::Foldable), Accessible(X), Near(X)], &[Enter(X, State::Folded)],
        Motion::Reach, "Folds cloth or paper."),
    rule(Verb::Unfold, 1, &[Affords(X, Property::Foldable), In(X, State::Folded), Accessible(X), Near(X)], &[Enter(X, State::Unfolded)],
        Motion::Reach, "Spreads out what is folded."),
    rule(Verb::Push, 1, &[Tangible(X), Other(X), Accessible(X), FreeHandOrHolding(X), Near(X)], &[],
        Motion::Reach, "Pushes a thing, a button as well."),
    rule(Verb::Pull, 1, &[Mobile(X), Accessible(X), FreeHandOrHolding(X), Near(X)], &[],
        Motion::Reach, "Pulls a thing that moves."),
    rule(Verb::Move, 1, &[Mobile(X), Accessible(X), FreeHandOrHolding(X), Near(X)], &[],
        Motion::Reach, "Moves a thing that moves a little."),
    rule(Verb::Squeeze, 1, &[Soft(X), FreeHandOrHolding(X), Accessible(X), Near(X)], &[],
        Motion::Reach, "Squeezes a cloth, a sponge, a tube."),
    rule(Verb::Type, 1, &[Typable(X), Accessible(X), Near(X)], &[],
        Motion::Play, "Types on a keyboard or a device."),
    rule(Verb::Greet, 1, &[Personal(X), Other(X)], &[],
        Motion::Wave, "Greets a person."),
    rule(Verb::Play, 1, &[Tangible(X), Other(X), Accessible(X), Near(X)], &[],
        Motion::Play, "Plays with a toy or game, or on an instrument."),
    rule(Verb::Enter, 1, &[Affords(X, Property::Drivable), SeatInside(X), Steady(X), Upright, Near(X)], &[Board(X)],
        Motion::Reach, "Gets into a vehicle; doors do not block."),
    rule(Verb::Leave, 0, &[Aboard], &[Alight],
        Motion::Nothing, "Gets out of the vehicle one is in, into the place where it stands."),
    rule(Verb::Drive, 2, &[Affords(X, Property::Drivable), AboardOf(X), In(X, State::On), Reachable(Y)], &[DriveTo(X, Y)],
        Motion::Reach, "Drives the running vehicle one is in to a place, with all that is in it."),
    rule(Verb::Dance, 0, &[Upright], &[],
        Motion::Dance, "Dances."),
    rule(Verb::Wave, 0, &[], &[],
        Motion::Wave, "Waves."),
    rule(Verb::Exercise, 0, &[], &[],
        Motion::Exercise, "Does exercises."),
    rule(Verb::Stretch, 0, &[], &[],
        Motion::Stretch, "Stretches."),
    rule(Verb::Smile, 0, &[], &[],
        Motion::Nothing, "Smiles."),
    rule(Verb::Heat, 1, &[Graspable(X), OnHeat(X), Near(X)], &[EnterWith(X, State::Hot)],
        Motion::Reach, "Heats what is on or in a heater that is on, with all that is on or in it: a pot and the soup in it."),
    rule(Verb::Cool, 1, &[Graspable(X), InCold(X), Near(X)], &[EnterWith(X, State::Cold)],
        Motion::Reach, "Cools what is inside a cooler that is on, with all that is on or in it."),
    rule(Verb::Dry, 1, &[Tangible(X), HoldingKind(Property::Wiper), Accessible(X), Near(X)], &[Enter(X, State::Dry)],
        Motion::UseAt, "Dries a thing with the cloth in one's hand."),
    rule(Verb::Soil, 1, &[Tangible(X), Accessible(X), Near(X)], &[Enter(X, State::Dirty)],
        Motion::UseAt, "Makes a thing dirty."),
];
