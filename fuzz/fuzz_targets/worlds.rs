//! Worlds of regions that are read are written and read again as the same.
#![no_main]

use std::sync::{Arc, OnceLock};

use libfuzzer_sys::fuzz_target;
use vc_graph::space::{Region, RegionGraphs, RegionKind, Space, SpaceBuilder};
use vc_graph::{ClassTable, SceneBuilder};

fn plan() -> Arc<Space> {
    static PLAN: OnceLock<Arc<Space>> = OnceLock::new();
    PLAN.get_or_init(|| {
        let mut space = SpaceBuilder::new();
        for name in ["one", "two"] {
            space.add(Region::new(RegionKind::Unit, name).with_numbers(100)).expect("there is room for both");
        }
        space.build().into()
    })
    .clone()
}

fuzz_target!(|text: &str| {
    let (space, classes) = (plan(), ClassTable::builtin());
    let made = |_| SceneBuilder::new("home").build();
    let Ok(world) = RegionGraphs::read(text, space.clone(), &classes, made) else { return };
    let again = world.write();
    let read = RegionGraphs::read(&again, space, &classes, made).expect("it was written");
    assert_eq!(read.write(), again);
});
