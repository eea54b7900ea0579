//! The contents of vessels are visible in them, and nowhere else.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{Stage, block, part};
use nalgebra::Point3;
use vc_graph::asset::Shape;
use vc_graph::{NodeId, Pose};
use vc_render::{Camera, Daylight, Frame, Lighting, Modality, Renderer, Shot, Snapshot};

/// Side of the picture in pixels, and index of its centre.
const SIDE: u32 = 64;
const MIDDLE: usize = (SIDE / 2 * SIDE + SIDE / 2) as usize;
/// Height of the table, and wall thickness and height of the mug on it, metres.
const TABLE: f32 = 0.5;
const WALL: f32 = 0.004;
const HEIGHT: f32 = 0.1;

struct Shown {
    renderer: Renderer,
    snapshot: Snapshot,
    lighting: Lighting,
    mug: NodeId,
}

impl Shown {
    fn new(mug: Vec<Shape>) -> Self {
        let mut stage = Stage::new();
        stage.one("table", block([0.4, 0.4, TABLE / 2.0]), Pose::translation(0.0, 0.0, TABLE / 2.0), 0);
        let lamp = stage.one("ceiling_lamp", Shape::Sphere { radius: 0.1 }, Pose::translation(0.3, 0.2, 2.0), 3);
        let parts = mug.into_iter().map(|shape| part("mug", shape, [0.0; 3], 1)).collect();
        let mug = stage.asset(parts);
        let mug = stage.put("mug", mug, Pose::translation(0.0, 0.0, TABLE));
        let mut renderer = Renderer::new();
        let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
        snapshot.switch(lamp, true).unwrap();
        let lighting = renderer.light(&snapshot, &Daylight::noon());
        Self { renderer, snapshot, lighting, mug }
    }

    fn open() -> Self {
        Self::new(vec![hollow()])
    }

    fn filled(&self, contents: Option<&str>) -> Snapshot {
        let mut snapshot = self.snapshot.clone();
        snapshot.fill(self.mug, contents).unwrap();
        snapshot
    }

    fn frame(&self, snapshot: &Snapshot, eye: [f32; 3]) -> Frame {
        let target = Point3::new(0.0, 0.0, TABLE + HEIGHT / 2.0);
        let camera = Camera::with_fov(SIDE, SIDE, 0.5).looking(Point3::from(eye), target);
        let mut lighting = self.lighting.clone();
        lighting.follow(snapshot).unwrap();
        let shot = Shot::new(snapshot, &camera, Modality::Rgb | Modality::Instance | Modality::Depth);
        let mut frame = Frame::new();
        self.renderer.render(&shot.lit(&lighting), &mut frame).unwrap();
        frame
    }
}

/// An open mug of 10 by 10 centimetres.
fn hollow() -> Shape {
    let (outer, inner) = (HEIGHT / 2.0, HEIGHT / 2.0 - WALL);
    Shape::Lathe { profile: vec![(outer, 0.0), (outer, HEIGHT), (inner, HEIGHT), (inner, WALL)] }
}

/// Eye position from which the camera looks nearly straight down.
const ABOVE: [f32; 3] = [0.001, 0.0, TABLE + 0.6];

#[test]
fn a_full_mug_is_full() {
    let shown = Shown::open();
    let (empty, full) = (shown.filled(None), shown.filled(Some("water")));
    let (before, after) = (shown.frame(&empty, ABOVE), shown.frame(&full, ABOVE));
    let rise = before.depth[MIDDLE] - after.depth[MIDDLE];
    assert!((rise - 0.8 * (HEIGHT - WALL)).abs() < 0.002, "the water is {rise} m deep");
    assert_eq!(before.instance, after.instance, "what is in the mug belongs to it");
    for (pixel, id) in before.instance.iter().enumerate().filter(|(_, id)| **id != shown.mug) {
        assert_eq!(before.depth[pixel], after.depth[pixel], "{id:?}");
    }
}

#[test]
fn an_emptied_mug_is_as_it_was() {
    let shown = Shown::open();
    let mut again = shown.filled(Some("milk"));
    again.fill(shown.mug, None).unwrap();
    let (before, after) = (shown.frame(&shown.snapshot, ABOVE), shown.frame(&again, ABOVE));
    assert_eq!((before.rgb, before.depth), (after.rgb, after.depth));
}

#[test]
fn walls_and_bottoms_hide_it() {
    let shown = Shown::open();
    let full = shown.filled(Some("milk"));
    for eye in [[0.6, 0.0, TABLE + 0.02], [0.0, 0.7, TABLE + 0.05]] {
        let (before, after) = (shown.frame(&shown.snapshot, eye), shown.frame(&full, eye));
        assert_eq!((before.instance, before.depth), (after.instance, after.depth), "{eye:?}");
    }
    // Seen from below, without the table.
    let mut lifted = [shown.snapshot.clone(), full];
    lifted.iter_mut().for_each(|s| s.place(shown.mug, &Pose::translation(0.0, 0.0, 3.0)).unwrap());
    let camera = Camera::with_fov(SIDE, SIDE, 0.5).looking(Point3::new(0.001, 0.0, 2.4), Point3::new(0.0, 0.0, 3.0));
    let [before, after] = lifted.map(|snapshot| {
        let mut frame = Frame::new();
        shown.renderer.render(&Shot::new(&snapshot, &camera, Modality::Depth), &mut frame).unwrap();
        frame
    });
    assert!(before.depth[MIDDLE].is_finite());
    assert_eq!(before.depth, after.depth);
}

#[test]
fn milk_is_not_coffee() {
    let shown = Shown::open();
    let bright = |contents: &str| {
        let frame = shown.frame(&shown.filled(Some(contents)), ABOVE);
        frame.rgb[MIDDLE].iter().map(|c| u32::from(*c)).sum::<u32>()
    };
    assert!(bright("milk") > 2 * bright("coffee"), "{} and {}", bright("milk"), bright("coffee"));
}

#[test]
fn what_is_solid_holds_nothing() {
    let shown = Shown::new(vec![Shape::Cylinder { radius: 0.05, half_height: 0.05 }]);
    let (before, after) = (shown.frame(&shown.snapshot, ABOVE), shown.frame(&shown.filled(Some("milk")), ABOVE));
    assert_eq!((before.rgb, before.depth), (after.rgb, after.depth));
}

#[test]
fn a_bail_is_no_lid() {
    // The bail goes over the middle and over the rim.
    let bail = [[0.06, 0.003], [0.003, 0.06]].map(|[x, y]| {
        let corners = [-1.0, 1.0].into_iter().flat_map(|i| [-1.0, 1.0].map(|j| (i * x, j * y)));
        let points = corners.flat_map(|(x, y)| [HEIGHT, HEIGHT + 0.005].map(|z| Point3::new(x, y, z)));
        Shape::Hull { points: points.collect() }
    });
    let shown = Shown::new([vec![hollow()], bail.to_vec()].concat());
    let (before, after) = (shown.frame(&shown.snapshot, ABOVE), shown.frame(&shown.filled(Some("tea")), ABOVE));
    let risen = before.depth.iter().zip(&after.depth).filter(|(before, after)| **before - **after > 0.06).count();
    assert!(risen > 20, "{risen} pixels show tea");
}
