//! Reused frames allocate nothing, and huge rooms take no more memory than others.
//!
//! This is a single test, as the allocator counts the allocations of all threads.

#![allow(clippy::unwrap_used, unsafe_code, reason = "an allocator that counts")]

mod common;

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

use common::{Stage, block, cameras, lamplit};
use nalgebra::Point3;
use vc_graph::Pose;
use vc_render::{Camera, Daylight, Frame, Modalities, Modality, Renderer, Shot};

/// The system's allocator with counters.
struct Counting;

/// Number of allocations so far, bytes in use, and peak bytes.
static COUNT: AtomicUsize = AtomicUsize::new(0);
static BYTES: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: everything is passed on to the system's allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.fetch_add(1, Relaxed);
        let now = BYTES.fetch_add(layout.size(), Relaxed) + layout.size();
        MOST.fetch_max(now, Relaxed);
        // SAFETY: guaranteed by the caller.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        BYTES.fetch_sub(layout.size(), Relaxed);
        // SAFETY: guaranteed by the caller.
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Number of allocations and the peak of additional megabytes while a function runs.
fn during<T>(done: impl FnOnce() -> T) -> (usize, f64, T) {
    let (count, bytes) = (COUNT.load(Relaxed), BYTES.load(Relaxed));
    MOST.store(bytes, Relaxed);
    let made = done();
    (COUNT.load(Relaxed) - count, (MOST.load(Relaxed) - bytes) as f64 / 1e6, made)
}

fn frames_used_again_allocate_nothing() {
    let (mut renderer, scene) = (Renderer::new(), lamplit());
    let mut snapshot = renderer.snapshot(&scene).unwrap();
    snapshot.nodes().collect::<Vec<_>>().into_iter().for_each(|n| snapshot.switch(n, true).unwrap());
    let mut then = snapshot.clone();
    then.place(scene.of_class("ball")[0], &Pose::translation(0.2, 0.3, 0.9)).unwrap();
    let lighting = renderer.light(&snapshot, &Daylight::noon());
    let all = Modality::ALL.iter().fold(Modalities::NONE, |all, one| all | *one);
    let sets = [
        ("depth", Modality::Depth.into(), 1),
        ("labels", Modalities::SIX.without(Modality::Rgb), 1),
        ("six", Modalities::SIX, 1),
        ("all", all, 1),
        ("six, finer", Modalities::SIX, 2),
    ];
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().unwrap();
    for (name, wanted, finer) in sets {
        pool.install(|| {
            let mut frame = Frame::new();
            let mut render = |camera: &Camera| {
                let shot = Shot::new(&snapshot, camera, wanted).lit(&lighting).supersampled(finer);
                renderer.render(&shot.after(&then, camera).before(&then, camera), &mut frame).unwrap();
            };
            // All cameras are rendered until all buffers have their final lengths.
            let cameras = cameras(160, 120);
            for _ in 0..2 {
                cameras.iter().for_each(&mut render);
            }
            let (count, ..) = during(|| cameras.iter().for_each(&mut render));
            assert_eq!(count, 0, "{name}: allocations in {} frames", cameras.len());
            assert!(during(|| render(&Camera::with_fov(320, 240, 1.0))).0 > 0, "what is larger needs more");
        });
    }
}

fn huge_rooms_take_no_more_memory() {
    for (half, most) in [(3.0, 400.0), (1000.0, 400.0)] {
        let mut stage = Stage::new();
        stage.one("floor", block([half, half, 0.1]), Pose::translation(0.0, 0.0, -0.1), 0);
        stage.one("ceiling", block([half, half, 0.1]), Pose::translation(0.0, 0.0, 30.1), 1);
        stage.one("ceiling_lamp", block([0.2, 0.2, 0.02]), Pose::translation(0.0, 0.0, 2.0), 3);
        let mut renderer = Renderer::new();
        let mut snapshot = renderer.snapshot(&stage.build()).unwrap();
        snapshot.nodes().collect::<Vec<_>>().into_iter().for_each(|n| snapshot.switch(n, true).unwrap());
        let (_, megabytes, lighting) = during(|| renderer.light(&snapshot, &Daylight::night()));
        eprintln!("a room of {} m: {megabytes:.0} MB", 2.0 * half);
        assert!(megabytes < most, "light in a room of {} m takes {megabytes} MB", 2.0 * half);
        // It is bright below the lamp, and darker far away.
        let camera = Camera::with_fov(64, 48, 1.2).looking(Point3::new(-2.0, 0.0, 1.5), Point3::new(0.0, 0.0, 0.0));
        let mut frame = Frame::new();
        renderer.render(&Shot::new(&snapshot, &camera, Modality::Rgb).lit(&lighting), &mut frame).unwrap();
        assert!(frame.rgb[40 * 64 + 32].iter().any(|v| *v > 20), "{:?}", frame.rgb[40 * 64 + 32]);
    }
}

#[test]
fn memory_is_bounded() {
    frames_used_again_allocate_nothing();
    huge_rooms_take_no_more_memory();
}
