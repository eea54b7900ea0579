//! Beginnings of actions, and the events of their motions.

use std::collections::VecDeque;

use vc_graph::asset::JointKind;
use vc_graph::{Action, NodeId, Pose, rule};
use vc_physics::{AgentError, MovingPart, PhysicsError, Posture};

use super::Interruption;
use super::passing::Walk;
use super::schedule::{NEVER, Phase, Schedule, Truth, lasts};
use super::show::Settling;
use super::track::{Leaf, Track, Turn};
use crate::environment::execute::{Bodies, Plan, Planner, Step, Task, WIDE};
use crate::environment::motion::{BodyMotion, Drive};
use crate::environment::observe::moved_by_rule;
use crate::environment::whereabouts::Whereabouts;
use crate::environment::{ActionError, Attempt, Environment, PhysicalRefusal};

/// Ticks after which a door that is pushed counts as stuck.
const PUSHING: u32 = 300;

type Going = Result<(), ActionError>;

impl Environment {
    /// Begins an action. One that the rule refuses changes nothing; another one breaks off what the agent is doing.
    pub(super) fn begin_action(&mut self, agent: NodeId, action: Action) {
        if self.is_refused(agent, &action) {
            return;
        }
        if self.clock.running.contains_key(&agent) {
            self.interrupt_for(agent, Interruption::Replaced(Attempt::new(&action, &self.graph)));
            // That may have left things otherwise.
            if self.is_refused(agent, &action) {
                return;
            }
        }
        if self.controlled(agent).is_some() {
            return self.end(agent, action, Err(ActionError::Busy(self.graph.label(agent))));
        }
        self.stays_aside(agent);
        let tasks = if self.start.time.bodies { Task::of(self.graph.vocabulary(), &action) } else { VecDeque::new() };
        self.clock.running.insert(agent, Schedule::new(action, tasks));
        self.go_on(agent);
    }

    /// Ends an action that the rule refuses; whether it does.
    fn is_refused(&mut self, agent: NodeId, action: &Action) -> bool {
        let mut refusals = rule::refusals(&self.graph, agent, action);
        if refusals.is_empty() && !action.verb.is_builtin() {
            // Effects that a vocabulary puts together may not all be possible at once.
            refusals = rule::step(&mut self.graph.clone(), agent, action).err().unwrap_or_default();
        }
        let refused = !refusals.is_empty();
        if refused {
            self.end(agent, *action, Err(ActionError::Refused(refusals)));
        }
        refused
    }

    /// The event that is due.
    pub(super) fn fire(&mut self, agent: NodeId) {
        let now = self.tick();
        // Somebody else's event may have ended it in this tick.
        let Some(schedule) = self.clock.running.get_mut(&agent).filter(|s| s.until <= now) else {
            return;
        };
        let done = match schedule.phase {
            Phase::Out => self.at_hand(agent),
            // Somebody else may have opened or shut it meanwhile.
            Phase::Pushes(_, false) => self.still_allowed(agent).and_then(|()| self.push_behind(agent)),
            Phase::Leaf | Phase::Pushes(_, true) => self.still_allowed(agent).and_then(|()| self.perform(agent)),
            Phase::Ends => return self.finish_in_time(agent),
            Phase::Back | Phase::Rests | Phase::Waits => Ok(()),
        };
        match done {
            Ok(()) => self.go_on(agent),
            Err(error) => self.stop(agent, error),
        }
    }

    /// Goes on to the next motion that takes time.
    pub(super) fn go_on(&mut self, agent: NodeId) {
        loop {
            let now = self.tick();
            match self.clock.running.get(&agent) {
                Some(schedule) if schedule.until <= now => {}
                _ => return,
            }
            match self.next(agent) {
                Ok(true) => {}
                Ok(false) => return,
                Err(error) => return self.stop(agent, error),
            }
        }
    }

    /// Begins the next motion or plans the next task; returns whether there is more to do in this tick.
    fn next(&mut self, agent: NodeId) -> Result<bool, ActionError> {
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return Ok(false) };
        if schedule.phase == Phase::Out && schedule.motion.is_some() {
            self.at_hand(agent)?;
            return Ok(true);
        }
        if let Some(motion) = schedule.motions.pop_front() {
            self.begin_motion(agent, motion)?;
            return Ok(true);
        }
        if let Some(task) = schedule.tasks.pop_front() {
            self.plan_task(agent, task)?;
            return Ok(true);
        }
        if schedule.truth.is_none() {
            // Effects without a motion of bodies are shown by a gesture.
            let gesture = Task::Gesture(schedule.action);
            schedule.tasks.push_back(gesture);
            return Ok(true);
        }
        (schedule.phase, schedule.track, schedule.until) = (Phase::Ends, Track::Still, NEVER);
        Ok(false)
    }

    fn plan_task(&mut self, agent: NodeId, task: Task) -> Going {
        let checks = matches!(task, Task::CheckOpen { .. });
        let opened = match task {
            Task::CheckOpen { id, open, .. } => Some((id, open)),
            _ => None,
        };
        let plan = self.plan(agent, task);
        let jams = matches!(plan, Err(PhysicalRefusal::Stuck { .. }));
        if let (true, Some((id, open)), Some(schedule)) = (jams, opened, self.clock.running.get_mut(&agent))
            && !std::mem::replace(&mut schedule.pushes, true)
        {
            // It is pushed, then.
            schedule.tasks.push_front(Task::Swing { id, open });
            return Ok(());
        }
        let Plan { motions, tasks } = plan.map_err(|why| self.cannot(agent, why))?;
        if checks {
            self.come_true(agent);
        }
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return Ok(()) };
        tasks.into_iter().rev().for_each(|task| schedule.tasks.push_front(task));
        schedule.motions.extend(motions);
        Ok(())
    }

    pub(super) fn plan(&mut self, agent: NodeId, task: Task) -> Result<Plan, PhysicalRefusal> {
        let Some(schedule) = self.clock.running.get(&agent) else { return Ok(Plan::default()) };
        let (before, mut after) = (self.graph.clone(), self.graph.clone());
        if schedule.truth.is_none() {
            let effects = rule::effects(self.graph.vocabulary(), &schedule.action);
            effects.iter().for_each(|effect| drop(rule::carry_out(&mut after, agent, effect)));
        }
        let (action, pushes) = (schedule.action, schedule.pushes);
        let step = Step { before, after, agent, action, pushes, claims: self.claims(agent) };
        Planner::new(&self.world, &mut self.floor, &self.start, &step).plan(task)
    }

    pub(super) fn cannot(&self, agent: NodeId, why: PhysicalRefusal) -> ActionError {
        let running = self.clock.running.get(&agent).map(|schedule| Attempt::new(&schedule.action, &self.graph));
        let attempt = running.unwrap_or_else(|| Attempt::named("an action that has ended"));
        ActionError::Impossible { attempt, why: why.in_scene(&self.graph) }
    }

    fn begin_motion(&mut self, agent: NodeId, motion: BodyMotion) -> Going {
        let (now, from) = (self.tick(), self.world.pose(agent).unwrap_or_else(Pose::identity));
        let brings_about = self
            .clock
            .running
            .get(&agent)
            .filter(|s| s.truth.is_none() && s.comes_true_with(self.graph.vocabulary(), &motion));
        let takes = brings_about.and_then(|s| self.duration(&s.action));
        let (mut phase, mut track, mut until) = (Phase::Out, Track::Still, now + lasts(&motion, takes).0);
        match &motion {
            BodyMotion::ComeToRest => (phase, until) = (Phase::Rests, NEVER),
            BodyMotion::Turn(to) => {
                let turn = Turn { from, to: *to, begin: now };
                until = turn.end();
                track = Track::Turn(turn);
            }
            BodyMotion::Walk { .. } | BodyMotion::StepAside { .. } => {
                let Some(way) = Walk::of(&motion).and_then(|walk| self.way(agent, walk)) else {
                    return self.wait(agent, motion);
                };
                until = way.end();
                track = Track::Way(way);
            }
            BodyMotion::Put(_) => {
                let there = self.place_of_put(agent).map(|at| Whereabouts::of(&self.world, at));
                track = there.map_or(Track::Still, Track::Reach);
            }
            _ => {}
        }
        if let Some(schedule) = self.clock.running.get_mut(&agent) {
            if matches!(motion, BodyMotion::Walk { .. }) {
                schedule.waits = None;
            }
            (schedule.motion, schedule.done) = (Some(motion).filter(|_| phase == Phase::Out), None);
            (schedule.phase, schedule.begin, schedule.track, schedule.until) = (phase, now, track, until);
        }
        Ok(())
    }

    /// The hand is at what it takes or moves, the feet are where they go: what the motion was for happens, unless a door
    /// has to be moved for that.
    fn at_hand(&mut self, agent: NodeId) -> Going {
        self.still_allowed(agent)?;
        let Some(schedule) = self.clock.running.get(&agent) else { return Ok(()) };
        if let Some(BodyMotion::Drive(drive)) = &schedule.motion
            && !self.graph.rests_at(drive.id, agent)
        {
            return self.begin_leaf(agent, drive.clone());
        }
        self.perform(agent)
    }

    /// Whether the rule allows the action as before, if its effects have not come true yet.
    pub(super) fn still_allowed(&self, agent: NodeId) -> Going {
        let Some(schedule) = self.clock.running.get(&agent).filter(|s| s.truth.is_none()) else { return Ok(()) };
        let refusals = rule::refusals(&self.graph, agent, &schedule.action);
        if refusals.is_empty() {
            return Ok(());
        }
        let holder = |id: NodeId| Some((id, self.graph.holder(id)?.at));
        let why = match schedule.action.things().filter_map(holder).find(|(_, by)| *by != agent) {
            Some((id, by)) => Interruption::Taken { thing: self.graph.label(id), by: self.graph.label(by) },
            None => Interruption::NoLonger(refusals),
        };
        Err(self.interrupted(&schedule.action, why))
    }

    fn begin_leaf(&mut self, agent: NodeId, drive: Drive) -> Going {
        let now = self.tick();
        let moved = self.leaves(agent).find(|leaf| leaf.id == drive.id && leaf.ends_at(drive.open)).cloned();
        if let Some(leaf) = moved {
            // Somebody else has it by the hand already: both move it.
            self.follow_leaf(agent, leaf);
            return Ok(());
        }
        let stands = self.world.posture(agent) == Some(Posture::Standing);
        let mut past: Vec<NodeId> = self.walkers(agent);
        past.extend(stands.then_some(agent));
        let planned = self.world.parts(drive.id).plan(drive.open, &past);
        let ends = planned.map_err(|e| self.cannot(agent, e.into()))?.filter(|_| !drive.pushes);
        // It moves from now on: those who would walk into it are told now, not before.
        let whole = vec![drive.open; self.world.parts(drive.id).all().len()];
        self.heed_passers(agent, &Leaf::new(&self.world, drive.id, &whole, now))?;
        let Some(ends) = ends else { return self.drive_against(agent, &drive, false) };
        let leaf = Leaf::new(&self.world, drive.id, &ends, self.after_walkers(agent, drive.id, drive.open));
        self.follow_leaf(agent, leaf);
        Ok(())
    }

    fn follow_leaf(&mut self, agent: NodeId, leaf: Leaf) {
        let now = self.tick();
        if let Some(schedule) = self.clock.running.get_mut(&agent) {
            (schedule.until, schedule.phase, schedule.begin) = (leaf.end(), Phase::Leaf, now);
            schedule.track = Track::Leaf(leaf);
        }
    }

    /// Motors move what something is in the way of, until they have arrived or given up: doors open before what is
    /// behind them. A part without a motor pushes nothing.
    fn drive_against(&mut self, agent: NodeId, drive: &Drive, behind: bool) -> Going {
        let parts = self.world.parts(drive.id).all();
        let turns = |part: &MovingPart| part.has_motor && part.kind == JointKind::Hinge;
        let all = behind || drive.open <= 0.0 || !parts.iter().any(turns);
        for (part, _) in parts.iter().enumerate().filter(|(_, part)| part.has_motor && (all || turns(part))) {
            let driven = self.world.drive(drive.id, part, drive.open);
            driven.map_err(|e| self.cannot(agent, e.into()))?;
        }
        self.clock.stirred = true;
        if let Some(schedule) = self.clock.running.get_mut(&agent) {
            (schedule.until, schedule.phase, schedule.track) = (NEVER, Phase::Pushes(PUSHING, all), Track::Still);
        }
        Ok(())
    }

    /// Pushes what is behind doors; it stays where it is if no door has opened.
    fn push_behind(&mut self, agent: NodeId) -> Going {
        let drive = match self.clock.running.get(&agent).and_then(|schedule| schedule.motion.as_ref()) {
            Some(BodyMotion::Drive(drive)) => drive.clone(),
            _ => return Ok(()),
        };
        let parts = self.world.parts(drive.id).all();
        if parts.iter().any(|part| part.kind == JointKind::Hinge && part.open >= WIDE) {
            return self.drive_against(agent, &drive, true);
        }
        self.perform(agent)
    }

    /// Does the motion under way; what follows of it takes its time.
    fn perform(&mut self, agent: NodeId) -> Going {
        let now = self.tick();
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return Ok(()) };
        let Some(motion) = schedule.motion.take() else { return Ok(()) };
        let pushed = matches!(schedule.phase, Phase::Pushes(..));
        let track = std::mem::replace(&mut schedule.track, Track::Still);
        (schedule.phase, schedule.begin, schedule.until) = (Phase::Back, now, now + lasts(&motion, None).1);
        schedule.done = Some(motion.clone());
        let settles = matches!(motion, BodyMotion::Rest(..) | BodyMotion::GetUp(_));
        let settling = if settles { Settling::begin(self, agent) } else { None };
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return Ok(()) };
        schedule.settling = settling;
        schedule.picked = match motion {
            BodyMotion::Take(_, id, _) => {
                self.world.pose(agent).zip(self.world.pose(id)).map(|(feet, at)| feet.inverse() * at)
            }
            _ => None,
        };
        let true_now = schedule.truth.is_none() && schedule.comes_true_with(self.graph.vocabulary(), &motion);
        if let BodyMotion::PutAgain(id, _, true) = motion {
            schedule.balanced = Some(id);
        }
        if let (BodyMotion::Drive(drive), Track::Leaf(_)) = (&motion, &track) {
            let drive = drive.clone();
            return self.end_leaf(agent, drive);
        }
        if let Track::Reach(there) = &track
            && there.differ(&self.world)
            && self.puts_elsewhere(agent)
        {
            return Ok(());
        }
        if let (true, BodyMotion::Drive(drive)) = (pushed, &motion) {
            self.pushes_no_longer(agent, drive.id);
        } else {
            let (world, start, before) = (&mut self.world, &self.start, &self.graph);
            if let Err(why) = (Bodies { world, start, before, agent }).perform(&motion) {
                let taken = matches!(why, PhysicalRefusal::Agent(AgentError::World(PhysicsError::Overlap { .. })));
                let puts = taken && matches!(motion, BodyMotion::Put(_));
                return if puts && self.puts_elsewhere(agent) { Ok(()) } else { Err(self.cannot(agent, why)) };
            }
        }
        match &motion {
            BodyMotion::PutAgain(id, pose, true) => self.clock.held.push((*id, *pose)),
            BodyMotion::PutBack(poses) => self.clock.held.extend(poses),
            _ => {}
        }
        if let BodyMotion::Fold(id, scale) = motion {
            self.clock.about_to_change(&self.graph);
            let mut edit = self.graph.edit();
            // It is there, and its scale is sound.
            let _ = edit.set_scale(id, scale);
            let folded = edit.commit();
            self.clock.note(folded);
            self.clock.changed.push(id);
            self.look_anew();
        }
        let mut others = track.way().map_or_else(Vec::new, |way| self.leave_doors(agent, way));
        let aside = track.way().into_iter().flat_map(|way| &way.aside);
        others.extend(aside.flat_map(|step| self.graph.carried_with(step.agent)));
        if true_now && self.goes_after(agent)? {
            return Ok(());
        }
        if true_now {
            self.come_true(agent);
        }
        self.excuse(&others);
        if !matches!(motion, BodyMotion::Gesture(..)) {
            self.clock.stirred = true;
            self.clock.changed.push(agent);
        }
        if let BodyMotion::Take(_, thing, _) = motion {
            self.tell_taken(agent, thing);
        }
        if pushed { self.check_opened(agent) } else { Ok(()) }
    }

    /// A door is where the hand has moved it; if something has come into its way meanwhile, it is pushed.
    fn end_leaf(&mut self, agent: NodeId, drive: Drive) -> Going {
        let past: Vec<NodeId> = self.walkers(agent).into_iter().chain([agent]).collect();
        let moved = self.world.set_openness(drive.id, drive.open, &past);
        if !moved.map_err(|e| self.cannot(agent, e.into()))? {
            self.drive_against(agent, &drive, false)?;
            if let Some(schedule) = self.clock.running.get_mut(&agent) {
                schedule.motion = Some(BodyMotion::Drive(drive));
            }
            return Ok(());
        }
        self.clock.stirred = true;
        self.clock.changed.push(agent);
        self.check_opened(agent)
    }

    /// Looks at once whether a door has opened or shut: by then it holds for others too, not when the hand is back.
    fn check_opened(&mut self, agent: NodeId) -> Going {
        let Some(schedule) = self.clock.running.get_mut(&agent) else { return Ok(()) };
        match schedule.tasks.pop_front() {
            Some(task @ Task::CheckOpen { .. }) => self.plan_task(agent, task),
            other => {
                other.into_iter().for_each(|task| schedule.tasks.push_front(task));
                Ok(())
            }
        }
    }

    /// The action's effects hold from now on.
    pub(super) fn come_true(&mut self, agent: NodeId) {
        let Some(schedule) = self.clock.running.get_mut(&agent).filter(|s| s.truth.is_none()) else { return };
        let mut truth = Truth::new(self.graph.clone(), agent, &schedule.action);
        // Where others are who come and go is not read yet.
        let others = |id: &NodeId| *id != agent && self.graph.agents().contains(id);
        let stale: Vec<NodeId> = self.clock.changed.iter().copied().filter(others).collect();
        truth.excuse(&stale);
        truth.excuse(&Vec::from_iter(self.clock.adrift.iter().copied()));
        let changes = truth.changes.clone();
        let before = std::mem::replace(&mut self.graph, truth.ruled.clone());
        schedule.truth = Some(truth);
        let action = schedule.action;
        self.clock.about_to_change(&before);
        self.let_go_of_leaves(agent, &action);
        self.tell_others(agent, &action);
        self.clock.changed.extend(changes.changes().iter().filter_map(moved_by_rule).chain([agent]));
        self.clock.unseen = true;
        self.clock.note(changes);
    }

    /// A thing that one has opened or shut is no longer moved by others, who may be late: it stays where it is.
    fn let_go_of_leaves(&mut self, agent: NodeId, action: &Action) {
        let moved = self.opened_or_closed(action);
        for (_, other) in self.clock.running.iter_mut().filter(|(id, _)| **id != agent) {
            if matches!(&other.track, Track::Leaf(leaf) if moved.contains(&leaf.id)) {
                other.track = Track::Still;
            }
        }
    }

    /// Effects that an agent has brought about hold for what others are in the middle of, too.
    pub(in crate::environment) fn tell_others(&mut self, agent: NodeId, action: &Action) {
        for (_, other) in self.clock.running.iter_mut().filter(|(id, _)| **id != agent) {
            other.truth.iter_mut().for_each(|truth| truth.goes_on_with(agent, action));
        }
    }

    pub(crate) fn interrupted(&self, action: &Action, why: Interruption) -> ActionError {
        ActionError::Interrupted { attempt: Attempt::new(action, &self.graph), why: Box::new(why) }
    }

    pub(super) fn interrupt_for(&mut self, agent: NodeId, why: Interruption) {
        let Some(schedule) = self.clock.running.get(&agent) else { return };
        let error = self.interrupted(&schedule.action, why);
        self.stop(agent, error);
    }

    /// Ends an action where its motion is.
    pub(super) fn stop(&mut self, agent: NodeId, error: ActionError) {
        let Some(schedule) = self.hand_over(agent) else { return };
        self.stay(agent, &schedule.track);
        if let Some(drive) = schedule.pushing() {
            self.pushes_no_longer(agent, drive.id);
        }
        let broken: Vec<NodeId> = schedule.action.things().chain(self.graph.carried_with(agent)).collect();
        self.clock.changed.extend(broken);
        self.heed_bodies(agent, &schedule.action);
        // Others decide by what they see now; what cannot be told is read when all rests.
        drop(self.read_moved());
        // An action whose effects have come true has been done, however its motions end.
        let undone = |why: &Interruption| matches!(why, Interruption::Undone { .. });
        let broken_off = matches!(&error, ActionError::Interrupted { why, .. } if !undone(why));
        let done = schedule.truth.is_some() && broken_off;
        self.end(agent, schedule.action, if done { Ok(()) } else { Err(error) });
    }

    /// The motors of a thing that an agent has pushed stop where they are, unless somebody else pushes it.
    fn pushes_no_longer(&mut self, agent: NodeId, thing: NodeId) {
        let pushes = |other: &Schedule| other.pushing().is_some_and(|drive| drive.id == thing);
        if self.world.parts(thing).is_driven() && !self.others(agent).any(|(_, other)| pushes(other)) {
            self.halt(thing);
        }
    }

    /// Stops the motors of a thing where they are.
    pub(super) fn halt(&mut self, thing: NodeId) {
        let parts = self.world.parts(thing).all();
        // The parts are there, and stay.
        (0..).zip(parts).for_each(|(part, now)| drop(self.world.put_open(thing, Some(part), now.open)));
    }

    /// Leaves an agent, and what it moves, where its motion has brought them.
    pub(super) fn stay(&mut self, agent: NodeId, track: &Track) {
        let now = self.tick();
        if let Some(feet) = track.feet(now) {
            // It stood there before.
            let _ = self.world.teleport(agent, feet);
        }
        match track {
            Track::Way(way) => {
                way.aside.iter().for_each(|step| self.step_to(step.agent, step.feet(now)));
                self.leave_doors(agent, way);
            }
            // One that somebody else moves goes on.
            Track::Leaf(leaf) if self.leaves(agent).any(|other| other.id == leaf.id) => {}
            Track::Leaf(leaf) => {
                // The part is there, and nothing is in its way.
                leaf.open(now)
                    .into_iter()
                    .for_each(|(part, open)| drop(self.world.put_open(leaf.id, Some(part), open)));
            }
            Track::Turn(_) | Track::Reach(_) | Track::Still => {}
        }
        (self.clock.stirred, self.clock.unseen) = (true, true);
        self.clock.changed.push(agent);
    }
}
