//! Each modality is the same alone as among all others, and for any number of threads, and a frame is unchanged
//! if a picture is refused.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{cameras, contents, crowded, lamplit};
use vc_graph::Pose;
use vc_render::{Camera, Daylight, Frame, Lighting, Modalities, Modality, RenderError, Renderer, Shot, Snapshot, View};

/// A room with its lamp on, and another moment of it.
struct Moments {
    renderer: Renderer,
    now: Snapshot,
    then: Snapshot,
}

impl Moments {
    fn new() -> Self {
        let (mut renderer, scene) = (Renderer::new(), lamplit());
        let mut now = renderer.snapshot(&scene).unwrap();
        now.nodes().collect::<Vec<_>>().into_iter().for_each(|n| now.switch(n, true).unwrap());
        let mut then = now.clone();
        then.place(scene.of_class("ball")[0], &Pose::translation(0.2, 0.3, 0.9)).unwrap();
        Self { renderer, now, then }
    }

    /// A shot with everything that any modality needs.
    fn shot<'a>(
        &'a self,
        lighting: &'a Lighting,
        [camera, later]: &'a [Camera; 2],
        wanted: impl Into<Modalities>,
    ) -> Shot<'a> {
        Shot::new(&self.now, camera, wanted).lit(lighting).after(&self.then, later).before(&self.now, later)
    }
}

/// A camera, and the same camera a moment later.
fn pair(camera: Camera) -> [Camera; 2] {
    [camera, Camera { pose: camera.pose * Pose::translation(0.04, 0.01, 0.05), ..camera }]
}

fn everything() -> Modalities {
    Modalities::new(Modality::ALL)
}

fn all(frame: &Frame) -> Vec<Vec<u32>> {
    Modality::ALL.iter().map(|one| contents(frame, *one)).collect()
}

#[test]
fn each_alone_is_what_it_is_among_all() {
    let made = Moments::new();
    let lighting = made.renderer.light(&made.now, &Daylight::noon());
    // One frame is reused, so that each render must clear the leftovers of the one before.
    let (mut whole, mut alone) = (Frame::new(), Frame::new());
    for camera in cameras(64, 48).into_iter().take(2) {
        let cameras = pair(camera);
        made.renderer.render(&made.shot(&lighting, &cameras, everything()), &mut whole).unwrap();
        assert_eq!(whole.modalities, everything());
        for one in Modality::ALL {
            let wanted = contents(&whole, *one);
            assert!(!wanted.is_empty(), "there is no {one:?} to compare");
            made.renderer.render(&made.shot(&lighting, &cameras, *one), &mut alone).unwrap();
            assert_eq!(alone.modalities, Modalities::from(*one));
            assert!(contents(&alone, *one) == wanted, "{one:?} alone is not what it is among all");
            for other in Modality::ALL.iter().filter(|other| *other != one) {
                // The visible fraction, which comes with amodal masks, is stored in boxes.
                let goes_along = (*one, *other) == (Modality::Amodal, Modality::Boxes);
                assert!(goes_along || contents(&alone, *other).is_empty(), "{one:?} alone has {other:?} too");
            }
        }
    }
}

#[test]
fn fractions_of_boxes_are_there_with_amodal_masks_only() {
    let made = Moments::new();
    let camera = cameras(64, 48)[0];
    let mut frame = Frame::new();
    for (wanted, known) in [
        (Modality::Boxes | Modality::Amodal, true),
        (Modality::Boxes.into(), false),
        (Modality::Boxes | Modality::Masks, false),
    ] {
        made.renderer.render(&Shot::new(&made.now, &camera, wanted), &mut frame).unwrap();
        assert!(frame.boxes.len() > 5, "{wanted:?}");
        assert!(frame.boxes.iter().all(|b| b.visible_fraction.is_some() == known), "{wanted:?}");
    }
}

#[test]
fn threads_do_not_change_a_byte_of_any() {
    let made = Moments::new();
    // High enough for five bands of rows.
    let views = [0, 1, 3].map(|i| pair(cameras(64, 160)[i]));
    let of = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let lighting = made.renderer.light(&made.now, &Daylight::noon());
            let shots: Vec<Shot<'_>> = views.iter().map(|view| made.shot(&lighting, view, everything())).collect();
            let mut frames: Vec<Frame> = shots.iter().map(|_| Frame::new()).collect();
            made.renderer.render_all(&shots, &mut frames).unwrap();
            // The first one is also rendered by itself.
            let mut alone = Frame::new();
            made.renderer.render(&shots[0], &mut alone).unwrap();
            frames.push(alone);
            frames.iter().map(all).collect::<Vec<_>>()
        })
    };
    let one = of(1);
    assert!(one[0] == one[3], "a picture differs by what is rendered with it");
    assert!(one[0] != one[1], "two cameras see the same");
    for threads in [2, 5] {
        for (number, (own, wanted)) in of(threads).iter().zip(&one).enumerate() {
            for ((modality, own), wanted) in Modality::ALL.iter().zip(own).zip(wanted) {
                assert!(own == wanted, "{modality:?} of picture {number} differs with {threads} threads");
            }
        }
    }
}

#[test]
fn a_refused_picture_leaves_the_frame_as_it_was() {
    let mut made = Moments::new();
    let elsewhere = made.renderer.snapshot(&crowded(3)).unwrap();
    let strange = Renderer::new().snapshot(&lamplit()).unwrap();
    let lighting = made.renderer.light(&made.now, &Daylight::noon());
    let gone = made.renderer.light(&made.now, &Daylight::clear(f32::NAN, 0.0));
    let views = pair(cameras(64, 48)[0]);
    // The refused shots have another size, so that a frame prepared for them would be noticed.
    let small = Camera { width: 20, height: 10, ..views[0] };
    let [bad, none] = [Camera { near: 0.0, ..small }, Camera { width: 0, ..small }];
    let whole = made.shot(&lighting, &views, everything());
    let tiny = made.shot(&lighting, &views, everything());
    let tiny = Shot { view: View { camera: &small, ..tiny.view }, ..tiny };
    let seen_by = |camera| View { camera, ..whole.view };
    let of = |snapshot| View { snapshot, camera: &small };
    let refused = [
        Shot { view: seen_by(&bad), ..whole },
        Shot { view: seen_by(&none), ..whole },
        Shot { after: Some(seen_by(&bad)), ..tiny },
        Shot { before: Some(seen_by(&bad)), ..tiny },
        Shot { view: of(&elsewhere), ..tiny },
        Shot { view: of(&strange), ..tiny },
        Shot { after: Some(of(&elsewhere)), ..tiny },
        Shot { lighting: None, ..tiny },
        Shot { after: None, ..tiny },
        Shot { before: None, ..tiny },
        Shot { lighting: Some(&gone), ..tiny },
        Shot { lighting: None, ..tiny }.supersampled(2),
        Shot { after: None, ..tiny }.supersampled(2),
        tiny.supersampled(1000),
    ];
    let mut frame = Frame::new();
    made.renderer.render(&whole, &mut frame).unwrap();
    let before = all(&frame);
    for (number, shot) in refused.iter().enumerate() {
        assert!(made.renderer.render(shot, &mut frame).is_err(), "shot {number}");
        assert_eq!((frame.width, frame.height, frame.modalities), (64, 48, everything()), "shot {number}");
        assert!(all(&frame) == before, "shot {number} was refused and changed the frame");
    }
    // Each of several shots has its own frame: the valid ones are rendered.
    let mut frames = [frame, Frame::new()];
    let result = made.renderer.render_all(&[refused[7], whole], &mut frames);
    assert!(matches!(result, Err(RenderError::Missing { .. })), "{result:?}");
    assert!(all(&frames[0]) == before && all(&frames[1]) == before);
}
