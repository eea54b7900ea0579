//! Shadows that follow moving things while indirect light stays as it is.

use std::sync::Arc;

use rayon::prelude::*;

use super::Lighting;
use super::lamp::{Lamp, lamps, others};
use crate::RenderError;
use crate::scene::{Snapshot, Store};

impl Lighting {
    /// Updates shadows, mirrors and reference pictures to another moment of the same scene.
    pub(crate) fn follow_shadows(&mut self, store: &Store, snapshot: &Snapshot) -> Result<(), RenderError> {
        self.check(store)?;
        self.tracer.snapshot.with("snapshot to follow", snapshot)?;
        self.tracer.follow(snapshot)?;
        let before = std::mem::replace(&mut self.cast, Arc::new(snapshot.clone()));
        let pairs = before.instances.iter().zip(&snapshot.instances).zip(0..);
        let moved: Vec<u32> = pairs.filter(|((a, b), _)| a.world != b.world).map(|(_, index)| index).collect();
        if moved.is_empty() {
            return Ok(());
        }
        let moments = [&*before, snapshot];
        let all = 0..snapshot.instances.len() as u32;
        let sun = self.sun.as_ref().and_then(|map| map.followed(store, moments, &moved, all));
        if let Some(sun) = sun {
            self.sun = Some(Arc::new(sun));
        }
        self.follow_lamps(store, moments, &moved);
        Ok(())
    }

    /// Updates the shadows of lamps, and rebuilds the lamps that have moved.
    fn follow_lamps(&mut self, store: &Store, moments: [&Snapshot; 2], moved: &[u32]) {
        let bodies: Vec<u32> = moved.iter().map(|i| moments[1].instances[*i as usize].body).collect();
        let stays = |lamp: &&Lamp| !bodies.contains(&lamp.body);
        let followed = |lamp: &Lamp| {
            let others = others(moments[1], lamp.body);
            Lamp { shadows: lamp.shadows.followed(store, moments, moved, others), ..lamp.clone() }
        };
        let count = self.lamps.len();
        let mut all: Vec<Lamp> = self.lamps.par_iter().filter(stays).map(followed).collect();
        if all.len() < count {
            let anew = lamps(store, &self.tracer, &all);
            (self.gains, self.screens, all) = (anew.gains, anew.screens, anew.lamps);
        }
        self.lamps = Arc::new(all);
    }
}

#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
#[cfg(test)]
mod tests {
    use vc_graph::{NodeId, Pose};

    use crate::common::lamplit;
    use crate::light::Daylight;
    use crate::light::shadow::ShadowMap;
    use crate::renderer::Renderer;

    fn same(name: &str, a: &ShadowMap, b: &ShadowMap) {
        let bits = |map: &ShadowMap| map.depth.iter().map(|v| v.to_bits()).collect::<Vec<u32>>();
        let other = bits(a).iter().zip(&bits(b)).filter(|(a, b)| a != b).count();
        assert_eq!(other, 0, "{name}: {other} texels are others");
        assert!(a.blocks == b.blocks, "{name}: ends of blocks are others");
    }

    /// Shadows updated step by step are bit for bit those made at once.
    #[test]
    fn shadows_that_followed_are_as_if_made_anew() {
        let mut renderer = Renderer::new();
        let mut snapshot = renderer.snapshot(&lamplit()).unwrap();
        let nodes: Vec<NodeId> = snapshot.nodes().collect();
        let lamp = snapshot.lamps().next().unwrap();
        snapshot.switch(lamp, true).unwrap();
        // The sun is low enough to shine in where a wall is left out.
        snapshot.hide(nodes[2], true).unwrap();
        let daylight = Daylight::clear(0.3, 0.1);
        let mut lighting = renderer.light(&snapshot, &daylight);
        let things: Vec<NodeId> = nodes.into_iter().rev().filter(|node| *node != lamp).take(30).collect();
        let mut drawn = 0;
        for (step, moved) in things.chunks(3).enumerate() {
            for (i, node) in moved.iter().enumerate() {
                let at = [0.5 * step as f32 - 2.2, 0.9 * i as f32 - 1.0, 0.4 + 0.15 * step as f32];
                snapshot.place(*node, &crate::common::pose(at, step as f32, 0.3)).unwrap();
            }
            // In the last step the lamp is carried, too.
            if step == 8 {
                snapshot.place(lamp, &Pose::translation(0.9, 0.2, 1.9)).unwrap();
            }
            let before = lighting.sun.clone().unwrap();
            renderer.follow(&mut lighting, &snapshot).unwrap();
            drawn += usize::from(!std::sync::Arc::ptr_eq(&before, lighting.sun.as_ref().unwrap()));
            let anew = renderer.light(&snapshot, &daylight);
            same("sun", lighting.sun.as_ref().unwrap(), anew.sun.as_ref().unwrap());
            let [own, other] = [&lighting.lamps[0], &anew.lamps[0]];
            assert!(own.at == other.at && own.flux == other.flux);
            own.shadows.0.iter().zip(&other.shadows.0).for_each(|(a, b)| same("lamp", a, b));
        }
        assert!(drawn > 2, "the sun shines on {drawn} of these moves");
    }
}
