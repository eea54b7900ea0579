//! Rays follow moving things, and hit the same as in a rebuilt tree.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::{cameras, furnished, lamplit, pose};
use nalgebra::{Point3, Vector3};
use vc_graph::{Draft, NodeId, Pose, SceneGraph, Seed, State};
use vc_render::{Daylight, Frame, Modality, PathTracing, RayCaster, RenderError, Renderer, Shot, Snapshot};

type Ray = (Point3<f32>, Vector3<f32>);

fn rays(count: usize) -> Vec<Ray> {
    let mut chance = Seed(11).stream();
    let mut place = || Vector3::new(chance.between(-2.8, 2.8), chance.between(-2.3, 2.3), chance.between(0.1, 2.5));
    (0..count).map(|_| (Point3::from(place()), place() - place())).collect()
}

/// Moves every third thing elsewhere, and the drawer halfway in.
fn moved(scene: &SceneGraph, snapshot: &mut Snapshot, seed: u64) {
    let mut chance = Seed(seed).stream();
    let loose = |id: &NodeId| scene.node(*id).is_some_and(|n| !["wall", "dresser"].contains(&&**n.class()));
    let nodes: Vec<NodeId> = snapshot.nodes().filter(loose).collect();
    for node in nodes.into_iter().step_by(3) {
        let at = [chance.between(-2.4, 2.4), chance.between(-2.0, 2.0), chance.between(0.2, 2.2)];
        snapshot.place(node, &pose(at, chance.between(0.0, 6.0), chance.between(0.0, 3.0))).unwrap();
    }
    let dresser = scene.nodes().find(|n| n.is(State::Open)).unwrap().id();
    snapshot.articulate(dresser, |_| Some(chance.between(0.0, 0.3))).unwrap();
}

/// Checks that both casters give the same hits for all rays except those that graze an edge.
fn assert_alike(one: &RayCaster, other: &RayCaster) {
    let rays = rays(20_000);
    let mut differ = 0;
    for (from, along) in &rays {
        let (a, b) = (one.first(from, along, 50.0), other.first(from, along, 50.0));
        let same = match (a, b) {
            (Some(a), Some(b)) => {
                let facing = (a.normal - b.normal).norm() < 1e-3;
                (a.distance - b.distance).abs() < 1e-4 && a.node == b.node && a.part == b.part && facing
            }
            (None, None) => true,
            _ => false,
        };
        let to = from + along;
        differ += usize::from(!same || one.sees(from, &to) != other.sees(from, &to));
    }
    assert!(differ <= rays.len() / 2000, "{differ} of {} rays", rays.len());
}

#[test]
fn rays_meet_what_has_moved_where_it_is() {
    let scene = furnished();
    let mut snapshot = Renderer::new().snapshot(&scene).unwrap();
    let mut caster = RayCaster::new(&snapshot);
    let start = (snapshot.clone(), caster.clone());
    for seed in 0..3 {
        moved(&scene, &mut snapshot, seed);
        caster.follow(&snapshot).unwrap();
        assert_alike(&caster, &RayCaster::new(&snapshot));
    }
    // Finally, everything moves back to its original place.
    caster.follow(&start.0).unwrap();
    assert_alike(&caster, &start.1);
}

#[test]
fn nothing_changes_while_nothing_moves() {
    let snapshot = Renderer::new().snapshot(&furnished()).unwrap();
    let caster = RayCaster::new(&snapshot);
    let mut other = caster.clone();
    other.follow(&snapshot).unwrap();
    let rays = rays(5000);
    assert_eq!(caster.first_of_each(&rays, 50.0), other.first_of_each(&rays, 50.0));
}

#[test]
fn another_scene_is_refused() {
    let (mut renderer, scene) = (Renderer::new(), furnished());
    let snapshot = renderer.snapshot(&scene).unwrap();
    let mut caster = RayCaster::new(&snapshot);
    let mut edit = vc_graph::SceneBuilder::new("other");
    edit.add(Draft::new("kitchen").at(Pose::identity())).unwrap();
    let other = renderer.snapshot(&edit.build()).unwrap();
    assert!(matches!(caster.follow(&other), Err(RenderError::OtherScene { there: 0, .. })));
    assert_alike(&caster, &RayCaster::new(&snapshot));
}

#[test]
fn reference_pictures_show_what_has_moved() {
    let (mut renderer, scene) = (Renderer::new(), lamplit());
    let mut snapshot = renderer.snapshot(&scene).unwrap();
    scene.nodes().filter(|n| &**n.class() == "ceiling_lamp").for_each(|n| snapshot.switch(n.id(), true).unwrap());
    let mut lighting = renderer.light(&snapshot, &Daylight::night());
    moved(&scene, &mut snapshot, 7);
    let anew = renderer.light(&snapshot, &Daylight::night());
    let how = PathTracing { samples: 8, denoise: false, ..PathTracing::default() };
    let camera = cameras(48, 36)[0];
    let made =
        |lighting: &vc_render::Lighting| renderer.reference_picture(lighting, &camera, &how, |_| true).unwrap().light;
    let (before, wanted) = (made(&lighting), made(&anew));
    lighting.follow(&snapshot).unwrap();
    let own = made(&lighting);
    let off = |other: &[[f32; 3]]| {
        let far = |(a, b): &(&[f32; 3], &[f32; 3])| (a[1] - b[1]).abs() > 0.02 * (a[1] + b[1]);
        wanted.iter().zip(other).filter(far).count()
    };
    // Pixels differ where rounding sends a path another way.
    assert!(off(&own) * 20 < wanted.len(), "{} of {} pixels differ", off(&own), wanted.len());
    assert!(off(&before) * 4 > wanted.len());
}

#[test]
fn light_brought_up_to_date_is_as_light_made_anew() {
    let (mut renderer, scene) = (Renderer::new(), lamplit());
    let mut snapshot = renderer.snapshot(&scene).unwrap();
    let lamp = scene.nodes().find(|n| &**n.class() == "ceiling_lamp").unwrap().id();
    let day = Daylight::clear(0.5, 1.0);
    let mut lighting = renderer.light(&snapshot, &day);
    let camera = cameras(96, 72)[0];
    let mut frame = Frame::new();
    let mut colours = |snapshot: &Snapshot, lighting: &vc_render::Lighting| {
        renderer.render(&Shot::new(snapshot, &camera, Modality::Rgb).lit(lighting), &mut frame).unwrap();
        frame.rgb.clone()
    };
    let far = |one: &[[u8; 3]], other: &[[u8; 3]], by: u8| {
        one.iter().zip(other).filter(|(a, b)| (0..3).any(|c| a[c].abs_diff(b[c]) > by)).count()
    };
    // A lamp is switched, things and a drawer move, and the lamp is switched again.
    for step in 0..3 {
        let before = colours(&snapshot, &lighting);
        match step {
            1 => moved(&scene, &mut snapshot, 5),
            _ => snapshot.switch(lamp, step == 0).unwrap(),
        }
        renderer.relight(&mut lighting, &snapshot).unwrap();
        let (own, anew) = (colours(&snapshot, &lighting), colours(&snapshot, &renderer.light(&snapshot, &day)));
        assert!(far(&own, &before, 2) * 4 > own.len(), "step {step} changed nothing");
        assert!(far(&own, &anew, 2) * 50 < own.len(), "step {step}: {} pixels differ", far(&own, &anew, 2));
    }
    let other = renderer.snapshot(&furnished()).unwrap();
    assert!(matches!(renderer.relight(&mut lighting, &other), Err(RenderError::OtherScene { .. })));
}

#[test]
fn plain_light_has_no_shadows() {
    let (mut renderer, scene) = (Renderer::new(), lamplit());
    let mut snapshot = renderer.snapshot(&scene).unwrap();
    scene.nodes().filter(|n| &**n.class() == "ceiling_lamp").for_each(|n| snapshot.switch(n.id(), true).unwrap());
    let lighting = renderer.light(&snapshot, &Daylight::night());
    let camera = cameras(96, 72)[0];
    let shot = Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting);
    let (mut real, mut plain) = (Frame::new(), Frame::new());
    renderer.render(&shot, &mut real).unwrap();
    renderer.render(&shot.unshadowed(), &mut plain).unwrap();
    let darker = real.rgb.iter().zip(&plain.rgb).filter(|(a, b)| a[1].saturating_add(8) < b[1]).count();
    let brighter = real.rgb.iter().zip(&plain.rgb).filter(|(a, b)| a[1] > b[1].saturating_add(8)).count();
    assert!(darker * 25 > real.rgb.len(), "{darker} pixels are in shadow");
    assert!(brighter * 100 < real.rgb.len(), "{brighter} pixels are brighter with shadows");
}
