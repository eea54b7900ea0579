//! The measures of a person.

/// The measures of a person: every crate goes by these.
///
/// Lengths are metres; heights along the body are shares of the stature, so that they fit a person of any size. The
/// stature is between the medians of men and women in ANSUR II (Gordon and others, 2014), 1.755 m and 1.626 m, and so
/// is the share of the shoulders.
///
/// Some measures look alike and answer different questions: a body squeezes through a gap of twice its
/// [`radius`](Self::radius), but people choose ways that leave them [`clearance`](Self::clearance).
///
/// ```
/// use vc_graph::Anthropometry;
/// let person = Anthropometry::ADULT;
/// assert!((person.shoulder * person.stature - 1.39).abs() < 0.01);
/// assert!(person.radius < person.clearance);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Anthropometry {
    /// Stature, metres.
    pub stature: f32,
    /// Height of the shoulders, as a share of the stature.
    pub shoulder: f32,
    /// Height of the eyes, as a share of the stature.
    pub eye: f32,
    /// From the hips to the shoulders, as a share of the stature.
    pub torso: f32,
    /// Height of the ankles, metres, with shoes.
    pub ankle: f32,
    /// From the shoulder to the elbow, metres.
    pub upper_arm: f32,
    /// From the elbow to the middle of the hand, metres.
    pub forearm: f32,
    /// From the middle of the body to a shoulder joint, metres.
    pub half_shoulders: f32,
    /// From the middle of the body to a hip joint, metres.
    pub half_hips: f32,
    /// Height of one who sits above the seat, as a share of the stature.
    pub sitting: f32,
    /// Depth of a standing body from back to front, metres: the box around it.
    pub depth: f32,
    /// Breadth of a standing body with its arms, metres: the box around it.
    pub breadth: f32,
    /// Radius of the upright capsule that a walking body is for physics, metres: less than half the breadth, since
    /// people turn their shoulders where it is narrow.
    pub radius: f32,
    /// Distance that a person who walks keeps from obstacles, from the middle of the body, metres. Ways are planned,
    /// and homes are furnished, so that there is as much.
    pub clearance: f32,
    /// Distance of two people who stand beside each other, middle to middle, metres.
    pub apart: f32,
    /// Height of free space that a person who walks needs, metres: the stature, shoes, and what a step lifts the head.
    pub headroom: f32,
    /// The highest step that a person climbs, metres.
    pub climbs: f32,
    /// Height that is walked over without effort, metres: rugs, sills.
    pub walked_over: f32,
    /// Height up to which nothing is in the way where a home is furnished, metres: less than what is walked over, so
    /// that a tray that lies on the floor does not count as floor.
    pub flat: f32,
    /// From the shoulder to the middle of the hand with the arm stretched and the shoulder turned forward, metres.
    pub reach: f32,
    /// How far the shoulders come forward when a person leans, metres: the trunk bent by 54 degrees, as over a table.
    pub lean: f32,
    /// The farthest that the trunk bends forward, radians.
    pub bend: f32,
    /// The farthest that the trunk turns around the spine, radians.
    pub twist: f32,
    /// How far the hips move forward over the feet at most, metres.
    pub sway: f32,
    /// How far the hips sink at most when a person squats, metres.
    pub squat: f32,
    /// How far the body rises on its toes, metres.
    pub tiptoe: f32,
    /// The length of an arm to the tips of the fingers, metres: things no farther from each other are within arm's
    /// reach.
    pub arm: f32,
    /// Distance along the floor, from the middle of the body to a thing, at which the thing is to be reached in a home
    /// that is being furnished, metres: less than reach and lean together, so that nobody has to bend far.
    pub ahead: f32,
    /// The greatest height at which a thing is taken from a place, metres: hands above the head, on tiptoe.
    pub overhead: f32,
    /// The greatest height at which people put things on a surface, metres: they want to see what stands there.
    pub shelf: f32,
    /// The height at which people put things most easily, metres.
    pub handy: f32,
    /// Height from which pictures at eye level are taken, metres: the eyes of a person of 1.67 m.
    pub view: f32,
}

impl Anthropometry {
    /// A grown-up person.
    pub const ADULT: Self = Self {
        stature: 1.7,
        shoulder: 0.82,
        eye: 0.93,
        torso: 0.29,
        ankle: 0.08,
        upper_arm: 0.29,
        forearm: 0.33,
        half_shoulders: 0.2,
        half_hips: 0.095,
        sitting: 0.52,
        depth: 0.4,
        breadth: 0.5,
        radius: 0.2,
        clearance: 0.25,
        apart: 0.42,
        headroom: 1.8,
        climbs: 0.2,
        walked_over: 0.05,
        flat: 0.03,
        reach: 0.8,
        lean: 0.4,
        bend: 1.25,
        twist: 0.85,
        sway: 0.2,
        squat: 0.6,
        tiptoe: 0.08,
        arm: 0.75,
        ahead: 0.95,
        overhead: 2.1,
        shelf: 1.6,
        handy: 1.0,
        view: 1.55,
    };

    /// Height of the hips of one who stands, metres.
    ///
    /// ```
    /// use vc_graph::Anthropometry;
    /// assert!((Anthropometry::ADULT.hip() - 0.9).abs() < 0.01);
    /// ```
    pub const fn hip(&self) -> f32 {
        (self.shoulder - self.torso) * self.stature
    }
}

impl Default for Anthropometry {
    /// [`ADULT`](Self::ADULT).
    fn default() -> Self {
        Self::ADULT
    }
}
