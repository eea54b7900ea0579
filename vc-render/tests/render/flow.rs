//! Optical flow and occlusion for a moving camera, turning things and drawers, compared with a ray caster.

#![allow(clippy::unwrap_used)]

use crate::common;

use common::caster::{Caster, projected};
use common::{cameras, furnished};
use nalgebra::{Isometry3, Point3, Vector3};
use vc_graph::{NodeId, Pose, SceneGraph, State};
use vc_render::{Camera, Frame, Modality, NOTHING, RenderError, Renderer, Shot, Snapshot};

const SIZE: (usize, usize) = (160, 120);

/// Two moments of a room: the camera moves and turns, a drawer slides in, things turn and move.
struct Moments {
    now: (Snapshot, Camera, Caster),
    then: (Snapshot, Camera, Caster),
    renderer: Renderer,
    dresser: NodeId,
    /// Nodes that have turned, with their motions.
    turned: Vec<(NodeId, Isometry3<f64>)>,
    slid: Vector3<f64>,
}

fn moments(number: usize) -> Moments {
    let graph = furnished();
    let mut renderer = Renderer::new().with_detail(0.0);
    let snapshot = renderer.snapshot(&graph).unwrap();
    let mut then = snapshot.clone();
    let dresser = graph.nodes().find(|n| n.is(State::Open)).unwrap().id();
    then.articulate(dresser, |joint| Some(joint.limits.1 - 0.17)).unwrap();
    let slid = graph.node(dresser).unwrap().pose().unwrap().cast::<f64>().rotation * Vector3::new(-0.17, 0.0, 0.0);
    let mut turned = Vec::new();
    for (i, node) in loose(&graph).into_iter().enumerate().filter(|(i, _)| i % 3 == 0) {
        let own = *graph.node(node).unwrap().pose().unwrap();
        let turn = Vector3::new(0.1, -0.05 * i as f32, 0.3);
        let new = Pose::new(own.translation.vector + Vector3::new(0.05, -0.02, 0.03), turn) * own.rotation;
        then.place(node, &new).unwrap();
        turned.push((node, new.cast::<f64>() * own.cast::<f64>().inverse()));
    }
    let camera = cameras(SIZE.0 as u32, SIZE.1 as u32)[number];
    let step = Pose::new(Vector3::new(0.06, 0.01, 0.08), Vector3::new(0.01, -0.03, 0.02));
    let later = Camera { pose: camera.pose * step, ..camera };
    let caster = Caster::new(&graph, 0.0005);
    let moved = caster.moved(|node, part, p| motion(&turned, dresser, slid, node, part) * p);
    Moments { now: (snapshot, camera, caster), then: (then, later, moved), renderer, dresser, turned, slid }
}

fn loose(graph: &SceneGraph) -> Vec<NodeId> {
    graph
        .nodes()
        .filter(|n| !["wall", "dresser"].contains(&&**n.class()) && n.pose().is_some())
        .map(|n| n.id())
        .collect()
}

/// Motion of a part from now to then.
fn motion(
    turned: &[(NodeId, Isometry3<f64>)],
    dresser: NodeId,
    slid: Vector3<f64>,
    node: NodeId,
    part: u16,
) -> Isometry3<f64> {
    if (node, part) == (dresser, 1) {
        return Isometry3::from_parts(slid.into(), nalgebra::UnitQuaternion::identity());
    }
    turned.iter().find(|t| t.0 == node).map_or_else(Isometry3::identity, |t| t.1)
}

impl Moments {
    /// Position of a pixel's point at the other moment, by the caster: node and part, and pixels and depth
    /// there.
    fn followed(&self, forward: bool, index: usize) -> Option<(NodeId, u16, [f64; 3])> {
        let ((_, camera, caster), (_, other, _)) =
            if forward { (&self.now, &self.then) } else { (&self.then, &self.now) };
        let (x, y) = ((index % SIZE.0) as f64 + 0.5, (index / SIZE.0) as f64 + 0.5);
        let hit = caster.cast(camera, x, y)?;
        let motion = motion(&self.turned, self.dresser, self.slid, hit.node, hit.part);
        let motion = if forward { motion } else { motion.inverse() };
        let point: Point3<f64> = motion * hit.point(camera, x, y);
        Some((hit.node, hit.part, projected(other, &point)))
    }

    /// Whether the caster sees something in front of a point of the other moment; none if that differs nearby.
    fn hidden(&self, forward: bool, [x, y, z]: [f64; 3]) -> Option<bool> {
        let (_, camera, caster) = if forward { &self.then } else { &self.now };
        let verdict = |x: f64, y: f64, nearer: f64| {
            let inside = z > 0.0 && x >= 0.0 && y >= 0.0 && x < SIZE.0 as f64 && y < SIZE.1 as f64;
            !inside || caster.cast(camera, x, y).is_some_and(|h| h.depth < z * nearer)
        };
        let own = verdict(x, y, 0.998);
        // Beside the point its own surface may be nearer, because of its slope.
        let nearer = if own { 0.998 } else { 0.93 };
        let near = [(-0.8, 0.0), (0.8, 0.0), (0.0, -0.8), (0.0, 0.8)];
        near.iter().all(|(dx, dy)| verdict(x + dx, y + dy, nearer) == own).then_some(own)
    }

    fn rendered(&self, forward: bool, wanted: impl Into<vc_render::Modalities>) -> Frame {
        let ((now, camera, _), (then, later, _)) =
            if forward { (&self.now, &self.then) } else { (&self.then, &self.now) };
        let mut frame = Frame::new();
        let shot = Shot::new(now, camera, wanted);
        let shot = if forward { shot.after(then, later) } else { shot.before(then, later) };
        self.renderer.render(&shot, &mut frame).unwrap();
        frame
    }
}

#[test]
fn flow_is_where_a_ray_caster_finds_points_again() {
    for (number, forward) in [(0, true), (1, false), (2, true), (2, false)] {
        let made = moments(number);
        let wanted = Modality::FlowForward | Modality::Instance | Modality::Part;
        let back = Modality::FlowBackward | Modality::Instance | Modality::Part;
        let frame = made.rendered(forward, if forward { wanted } else { back });
        let flow = if forward { &frame.flow_forward } else { &frame.flow_backward };
        let (mut kinds, mut wrong, mut all) = ([0; 3], 0, 0);
        for (i, flow) in flow.iter().enumerate() {
            let Some((node, part, [x, y, z])) = made.followed(forward, i) else { continue };
            // At edges another thing may be visible.
            if (node, part) != (frame.instance[i], frame.part[i]) || z < 0.05 {
                continue;
            }
            let (dx, dy) = (x - (i % SIZE.0) as f64 - 0.5, y - (i / SIZE.0) as f64 - 0.5);
            all += 1;
            wrong += usize::from((f64::from(flow[0]) - dx).hypot(f64::from(flow[1]) - dy) > 0.1);
            let kind = if (node, part) == (made.dresser, 1) {
                1
            } else {
                2 * usize::from(made.turned.iter().any(|t| t.0 == node))
            };
            kinds[kind] += usize::from(dx.hypot(dy) > 1.0);
        }
        eprintln!("camera {number}: {kinds:?} pixels move; {wrong} of {all} elsewhere");
        assert!(wrong * 2000 < all, "{wrong} of {all} pixels go elsewhere");
        assert!(kinds[0] > 1000 && kinds[2] > 500, "{kinds:?}");
    }
    // The drawer is visible while it slides.
    let made = moments(0);
    let frame = made.rendered(true, Modality::FlowForward | Modality::Instance | Modality::Part);
    let drawer = (0..frame.part.len()).filter(|i| (frame.instance[*i], frame.part[*i]) == (made.dresser, 1)).count();
    assert!(drawer > 30, "{drawer} pixels of the drawer");
}

#[test]
fn what_is_hidden_at_the_other_moment_is_what_a_ray_caster_cannot_see() {
    for (number, forward) in [(0, true), (0, false), (1, true), (2, false)] {
        let made = moments(number);
        let frame = made.rendered(forward, Modality::Occlusion | Modality::Instance);
        let occluded = if forward { &frame.occluded_forward } else { &frame.occluded_backward };
        let (mut wrong, mut hidden, mut all) = (0, 0, 0);
        for (i, occluded) in occluded.iter().enumerate() {
            assert!(frame.instance[i] != NOTHING || *occluded == 1);
            let Some((node, _, there)) = made.followed(forward, i) else { continue };
            let Some(truth) = made.hidden(forward, there) else { continue };
            if node != frame.instance[i] {
                continue;
            }
            all += 1;
            hidden += usize::from(truth);
            wrong += usize::from(truth != (*occluded == 1));
        }
        eprintln!("camera {number}: {wrong} of {all} differ, {hidden} hidden");
        assert!(hidden > 200 && all > 10_000, "{hidden} of {all} are hidden");
        assert!(wrong * 500 < all, "{wrong} of {all} pixels are said to be hidden or seen, and are not");
    }
}

#[test]
fn occlusion_needs_a_moment_but_no_flow() {
    let made = moments(0);
    let ((now, camera, _), (then, later, _)) = (&made.now, &made.then);
    let mut frame = Frame::new();
    let shot = Shot::new(now, camera, Modality::Occlusion);
    assert!(matches!(made.renderer.render(&shot, &mut frame), Err(RenderError::Missing { wanted: "occlusion", .. })));
    let pixels = SIZE.0 * SIZE.1;
    for (shot, lengths) in [
        (shot.after(then, later), [pixels, 0]),
        (shot.before(then, later), [0, pixels]),
        (shot.after(then, later).before(then, later), [pixels; 2]),
    ] {
        made.renderer.render(&shot, &mut frame).unwrap();
        assert_eq!([frame.occluded_forward.len(), frame.occluded_backward.len()], lengths);
        assert!(frame.flow_forward.is_empty() && frame.flow_backward.is_empty());
    }
    // The mask is the same whether flow is requested or not.
    made.renderer.render(&shot.after(then, later), &mut frame).unwrap();
    let alone = frame.occluded_forward.clone();
    let both = Shot { modalities: Modality::Occlusion | Modality::FlowForward, ..shot };
    made.renderer.render(&both.after(then, later), &mut frame).unwrap();
    assert!(frame.occluded_forward == alone && alone.contains(&0) && alone.contains(&1));
}
