//! How the trunk follows a hand: it bends, turns, leans forward, squats or rises on its toes.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::Pose;

use super::bone::{ARM, Bone, LEG, Side};
use super::pose::{STRETCH, about, pitch};

/// How far one bends at the waist and turns the shoulder forward, radians.
const BEND: f32 = 1.25;
const TWIST: f32 = 0.85;
/// How far the hips come forward, go down and come up, metres.
const LEAN: f32 = 0.2;
const SQUAT: f32 = 0.6;
const TIPTOE: f32 = 0.08;
/// How far the hips go back for each metre of a squat.
const BACK: f32 = 0.2;
/// Steps in which each of them is tried.
const STEPS: usize = 16;

/// A hand that goes out; the body bends as far as it has to, and the eyes follow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Reach {
    pub(crate) side: Side,
    pub(crate) point: Point3<f32>,
    /// How far it has got, 0 to 1.
    pub(crate) share: f32,
    /// How far the eyes have turned to it, 0 to 1.
    pub(crate) looks: f32,
}

/// How the trunk is for a hand that goes out.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Stoop {
    /// Radians, at the waist and around the spine.
    pub(super) bend: f32,
    twist: f32,
    /// Metres that the hips move, forward and up.
    lean: f32,
    rise: f32,
}

/// Ways in which one stoops: what they lead to, and the stages in which the hips come forward and
/// up or down; one bends and turns in the first.
const WAYS: [(Stoop, [usize; 2]); 4] = [
    // Squats, then leans; or first leans.
    (Stoop { bend: BEND, twist: TWIST, lean: LEAN, rise: -SQUAT }, [2, 1]),
    (Stoop { bend: BEND, twist: TWIST, lean: LEAN, rise: -SQUAT }, [1, 2]),
    // On one's toes, upright or over something.
    (Stoop { bend: 0.0, twist: TWIST, lean: LEAN, rise: TIPTOE }, [1, 0]),
    (Stoop { bend: BEND / 2.0, twist: TWIST, lean: LEAN, rise: TIPTOE }, [1, 0]),
];

impl Stoop {
    /// As little as it takes to reach a point, or what brings the hand nearest; of one who sits the
    /// hips stay where they are.
    pub(super) fn to(reach: &Reach, seat: Option<Pose>) -> Self {
        let length = (ARM[0] + ARM[1]) * STRETCH;
        let tried = (0..=3 * STEPS).flat_map(|i| WAYS.map(|(end, stages)| end.after(i, stages)));
        let tried = tried.map(|stoop| match seat {
            Some(_) => Self { lean: 0.0, rise: 0.0, ..stoop },
            None => stoop,
        });
        let tried = tried.map(|stoop| Self { twist: -reach.side.sign() * stoop.twist, ..stoop });
        let short = |stoop: &Self| (reach.point - stoop.shoulder(reach.side, seat.as_ref())).norm().max(length);
        let best = tried.min_by(|a, b| short(a).total_cmp(&short(b)));
        let Self { bend, twist, lean, rise } = best.unwrap_or_default();
        let share = reach.share;
        Self { bend: bend * share, twist: twist * share, lean: lean * share, rise: rise * share }
    }

    /// What leads to it after so many steps.
    fn after(self, steps: usize, [forward, up]: [usize; 2]) -> Self {
        let share = |stage: usize| (steps.saturating_sub(stage * STEPS) as f32 / STEPS as f32).min(1.0);
        let Self { bend, twist, lean, rise } = self;
        Self { bend: bend * share(0), twist: twist * share(0), lean: lean * share(forward), rise: rise * share(up) }
    }

    /// How the hips of one who stands move, so that the feet stay on the floor.
    pub(super) fn hips(&self) -> Vector3<f32> {
        let forward = self.lean + BACK * self.rise.min(0.0);
        let (leg, bent) = (LEG[0] + LEG[1], (LEG[0] + LEG[1]) * STRETCH);
        let lowest = (bent * bent - forward * forward).max(0.0).sqrt() - leg;
        Vector3::new(forward, 0.0, self.rise.min(lowest) + self.toes())
    }

    /// How far the heels are off the floor, metres.
    pub(super) fn toes(&self) -> f32 {
        self.rise.max(0.0)
    }

    /// How the chest turns.
    pub(super) fn chest(&self) -> UnitQuaternion<f32> {
        pitch(self.bend) * UnitQuaternion::from_axis_angle(&Vector3::z_axis(), self.twist)
    }

    fn shoulder(&self, side: Side, seat: Option<&Pose>) -> Point3<f32> {
        let bent = about(Bone::Chest.anchor(), self.chest()) * Bone::UpperArm(side).anchor();
        seat.map_or_else(|| bent + self.hips(), |seat| seat * bent)
    }
}
