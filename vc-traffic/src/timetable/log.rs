//! The steps of all vehicles while a timetable is made, and where each stands in its queue.

use super::pace::Paces;
use super::step::Step;
use crate::network::{NONE, Network};

/// A step with the one of whoever was ahead, and the journey that it is of.
struct Entry {
    step: Step,
    ahead: u32,
    drive: u32,
}

/// All steps in the order in which they began.
#[derive(Default)]
pub(super) struct Log {
    entries: Vec<Entry>,
    drives: u32,
}

impl Log {
    /// The number of another journey.
    pub(super) fn new_drive(&mut self) -> u32 {
        self.drives += 1;
        self.drives - 1
    }

    /// A step with the one of whoever is ahead, of a journey; its number.
    pub(super) fn add(&mut self, step: Step, ahead: u32, drive: u32) -> u32 {
        self.entries.push(Entry { step, ahead, drive });
        self.entries.len() as u32 - 1
    }

    pub(super) fn step(&self, number: u32) -> &Step {
        &self.entries[number as usize].step
    }

    /// The journey of a step.
    pub(super) fn drive(&self, number: u32) -> u32 {
        self.entries[number as usize].drive
    }

    /// Sets when a step has ended.
    pub(super) fn leave(&mut self, number: u32, now: u32) {
        self.entries[number as usize].step.leaves = now;
    }

    /// The steps of all journeys, one journey after the other, and where each begins. Vehicles take a space in metres in a queue.
    pub(super) fn finish(mut self, network: &Network, paces: &Paces, space: f64) -> (Vec<Step>, Vec<u32>) {
        for number in 0..self.entries.len() {
            self.entries[number].step.stands = self.stands(number, network, paces, space);
        }
        let mut first = vec![0_u32; self.drives as usize + 1];
        self.entries.iter().for_each(|entry| first[entry.drive as usize + 1] += 1);
        (1..first.len()).for_each(|drive| first[drive] += first[drive - 1]);
        self.entries.sort_by_key(|entry| entry.drive);
        (self.entries.into_iter().map(|entry| entry.step).collect(), first)
    }

    /// Where somebody stands until those ahead of them have gone, metres: behind each whom they would come too near to otherwise.
    fn stands(&self, number: usize, network: &Network, paces: &Paces, space: f64) -> f32 {
        let Entry { step, mut ahead, .. } = self.entries[number];
        let speed = paces.of(step.lane);
        let begins = f64::from(step.enters) - f64::from(step.begin) / speed;
        let mut stands = step.end;
        while ahead != NONE {
            let Entry { step: other, ahead: before, .. } = self.entries[ahead as usize];
            let gone = other.leaves <= step.enters;
            // Those who arrive leave from within the queue.
            if gone && other.end >= network.length[other.lane as usize] {
                break;
            }
            let meets = f64::from(other.leaves) > begins + (f64::from(other.end) - space) / speed;
            if !gone && meets {
                stands = stands.min(other.stands - space as f32);
            }
            ahead = before;
        }
        stands.max(step.begin).min(step.end)
    }
}
