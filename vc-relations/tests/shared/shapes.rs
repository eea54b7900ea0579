//! Named shapes with measures, the building blocks of test scenes. The origin is the centre of the base, and X
//! points to the front. With `slots`, containers declare their hollows; without, these must be found from the
//! parts.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::asset::{Hold, Joint, JointKind, Part, Shape, Surface};
use vc_graph::{Asset, Pose};

type P = [f32; 3];

/// An asset under construction.
pub(crate) struct Kit {
    pub(crate) asset: Asset,
    slots: bool,
    joint: Option<Joint>,
}

impl Kit {
    fn part(&mut self, shape: Shape, pose: Pose) -> &mut Self {
        let name = format!("part_{}", self.asset.parts.len()).into();
        self.asset.parts.push(Part { name, shape, material: 0, pose, joint: self.joint });
        self
    }

    /// A box between two corners.
    fn block(&mut self, low: P, high: P) -> &mut Self {
        let (low, high) = (Vector3::from(low), Vector3::from(high));
        let shape = Shape::Box { half: (high - low) / 2.0 };
        self.part(shape, Pose::from_parts(((low + high) / 2.0).into(), UnitQuaternion::identity()))
    }

    fn shape(&mut self, shape: Shape, at: P) -> &mut Self {
        self.part(shape, Pose::from_parts(Vector3::from(at).into(), UnitQuaternion::identity()))
    }

    fn surface(&mut self, hold: Hold, centre: P, half: (f32, f32), clearance: Option<f32>) -> &mut Self {
        if self.slots || hold == Hold::Hook {
            let name = format!("place_{}", self.asset.surfaces.len()).into();
            let (centre, joint) = (Point3::from(centre), self.joint);
            self.asset.surfaces.push(Surface { name, hold, centre, half, clearance, joint });
        }
        self
    }

    fn legs(&mut self, x: f32, y: f32, h: f32, t: f32) -> &mut Self {
        for (sx, sy) in [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)] {
            let (cx, cy): (f32, f32) = (sx * (x / 2.0 - t), sy * (y / 2.0 - t));
            self.block([cx - t / 2.0, cy - t / 2.0, 0.0], [cx + t / 2.0, cy + t / 2.0, h]);
        }
        self
    }

    /// Four walls and a floor of thickness `t`, open above.
    fn tub(&mut self, low: P, high: P, t: f32) -> &mut Self {
        let ([x0, y0, z0], [x1, y1, z1]) = (low, high);
        self.block(low, [x1, y1, z0 + t]);
        self.block([x0, y0, z0 + t], [x0 + t, y1, z1]).block([x1 - t, y0, z0 + t], [x1, y1, z1]);
        self.block([x0 + t, y0, z0 + t], [x1 - t, y0 + t, z1]).block([x0 + t, y1 - t, z0 + t], [x1 - t, y1, z1]);
        let (cx, cy) = (f32::midpoint(x0, x1), f32::midpoint(y0, y1));
        let half = ((x1 - x0) / 2.0 - t, (y1 - y0) / 2.0 - t);
        self.surface(Hold::Inside, [cx, cy, z0 + t], half, Some(z1 - z0 - t))
    }

    /// A case with boards, open in front: `n` compartments one above the other.
    fn case(&mut self, x: f32, y: f32, h: f32, n: usize) -> &mut Self {
        let t = 0.02;
        self.block([-x / 2.0, -y / 2.0, 0.0], [-x / 2.0 + t, y / 2.0, h]);
        self.block([-x / 2.0 + t, -y / 2.0, 0.0], [x / 2.0, -y / 2.0 + t, h]);
        self.block([-x / 2.0 + t, y / 2.0 - t, 0.0], [x / 2.0, y / 2.0, h]);
        for i in 0..=n {
            let z = (h - t) * i as f32 / n as f32;
            self.block([-x / 2.0 + t, -y / 2.0 + t, z], [x / 2.0, y / 2.0 - t, z + t]);
            if i < n {
                let half = (x / 2.0 - t, y / 2.0 - t);
                self.surface(Hold::Inside, [t / 2.0, 0.0, z + t], half, Some((h - t) / n as f32 - t));
            }
        }
        self.surface(Hold::On, [0.0, 0.0, h], (x / 2.0, y / 2.0), None)
    }

    fn hinge(&mut self, anchor: P) -> &mut Self {
        self.joint =
            Some(Joint { kind: JointKind::Hinge, anchor: anchor.into(), axis: Vector3::z(), limits: (0.0, 1.9) });
        self
    }

    fn turned(&mut self, profile: &[(f32, f32)]) -> &mut Self {
        self.shape(Shape::Lathe { profile: profile.to_vec() }, [0.0; 3])
    }
}

/// The class and asset of a named shape with its measures, metres.
pub(crate) fn make(name: &str, m: &[f32], slots: bool) -> (&'static str, Asset) {
    let m = |i: usize| *m.get(i).unwrap_or_else(|| panic!("shape `{name}` needs measure {i}"));
    let asset = Asset { name: name.into(), ..Asset::default() };
    let mut kit = Kit { asset, slots, joint: None };
    let k = &mut kit;
    let class = match name {
        "floor" => (k.block([-m(0) / 2.0, -m(1) / 2.0, -0.2], [m(0) / 2.0, m(1) / 2.0, 0.0]), "floor").1,
        "l_floor" => {
            // A square without the corner at +X and +Y: its arms are `m(1)` wide.
            let (far, near) = (m(0) / 2.0, m(1) - m(0) / 2.0);
            let outline = vec![(far, -far), (far, near), (near, near), (near, far), (-far, far), (-far, -far)];
            k.shape(Shape::Extrusion { outline, height: 0.2 }, [0.0, 0.0, -0.2]);
            "floor"
        }
        "ceiling" => (k.block([-m(0) / 2.0, -m(1) / 2.0, 0.0], [m(0) / 2.0, m(1) / 2.0, 0.2]), "ceiling").1,
        "wall" => (upright(k, m(0), m(1), m(2)), "wall").1,
        "door" => (upright(k, 0.04, m(0), m(1)), "door").1,
        "box" => (upright(k, m(0), m(1), m(2)), "carton").1,
        "book" => (upright(k, m(0), m(1), m(2)), "book").1,
        "picture" => (upright(k, m(0), m(1), m(2)), "picture").1,
        "rug" => (upright(k, m(0), m(1), m(2)), "rug").1,
        "pillow" => (upright(k, m(0), m(1), m(2)), "pillow").1,
        "tv" => (upright(k, m(0), m(1), m(2)), "television").1,
        "person" => (upright(k, 0.3, 0.45, m(0)), "character").1,
        "ball" => (k.shape(Shape::Sphere { radius: m(0) / 2.0 }, [0.0, 0.0, m(0) / 2.0]), "apple").1,
        "can" => {
            k.shape(Shape::Cylinder { radius: m(0) / 2.0, half_height: m(1) / 2.0 }, [0.0, 0.0, m(1) / 2.0]);
            "milk"
        }
        "mug" => {
            let (r, h, t) = (m(0) / 2.0, m(1), 0.004);
            k.turned(&[(r, 0.0), (r, h), (r - t, h), (r - t, t)]).block([r, -0.01, h * 0.3], [r + 0.03, 0.01, h * 0.8]);
            k.surface(Hold::Inside, [0.0, 0.0, t], ((r - t) * 0.7, (r - t) * 0.7), Some(h - t));
            "mug"
        }
        "plate" => {
            let r = m(0) / 2.0;
            k.turned(&[(r * 0.6, 0.0), (r, 0.018), (r, 0.022), (r * 0.6, 0.006)]);
            "plate"
        }
        "bowl" => {
            let (r, h, t) = (m(0) / 2.0, m(1), 0.005);
            k.turned(&[(r * 0.5, 0.0), (r * 0.8, h * 0.3), (r, h), (r - t, h), (r * 0.8 - t, h * 0.3), (r * 0.5, t)]);
            k.surface(Hold::Inside, [0.0, 0.0, t], (r * 0.65, r * 0.65), Some(h - t));
            "bowl"
        }
        "table" => {
            k.legs(m(0), m(1), m(2) - 0.03, 0.05);
            k.block([-m(0) / 2.0, -m(1) / 2.0, m(2) - 0.03], [m(0) / 2.0, m(1) / 2.0, m(2)]);
            k.surface(Hold::On, [0.0, 0.0, m(2)], (m(0) / 2.0, m(1) / 2.0), None);
            "table"
        }
        "side_table" => {
            k.legs(m(0), m(1), m(2) - 0.02, 0.04);
            k.block([-m(0) / 2.0, -m(1) / 2.0, m(2) - 0.02], [m(0) / 2.0, m(1) / 2.0, m(2)]);
            k.block([-m(0) / 2.0, -m(1) / 2.0, 0.12], [m(0) / 2.0, m(1) / 2.0, 0.14]);
            k.surface(Hold::On, [0.0, 0.0, m(2)], (m(0) / 2.0, m(1) / 2.0), None);
            k.surface(Hold::On, [0.0, 0.0, 0.14], (m(0) / 2.0, m(1) / 2.0), Some(m(2) - 0.16));
            "side_table"
        }
        "chair" => {
            k.legs(0.45, 0.45, 0.43, 0.04).block([-0.225, -0.225, 0.43], [0.225, 0.225, 0.46]);
            k.block([-0.225, -0.225, 0.46], [-0.195, 0.225, 0.95]);
            "chair"
        }
        "stool" => {
            k.legs(0.35, 0.35, 0.42, 0.04).block([-0.175, -0.175, 0.42], [0.175, 0.175, 0.45]);
            "stool"
        }
        "sofa" => {
            let y = m(0) / 2.0;
            k.block([-0.45, -y, 0.0], [0.45, y, 0.42]).block([-0.45, -y, 0.42], [-0.2, y, 0.85]);
            k.block([-0.2, -y, 0.42], [0.45, -y + 0.2, 0.62]).block([-0.2, y - 0.2, 0.42], [0.45, y, 0.62]);
            "sofa"
        }
        "bed" => {
            k.legs(2.0, m(0), 0.3, 0.06).block([-1.0, -m(0) / 2.0, 0.3], [1.0, m(0) / 2.0, 0.5]);
            k.block([-1.05, -m(0) / 2.0, 0.0], [-1.0, m(0) / 2.0, 1.0]);
            "bed"
        }
        "shelf" => (k.case(m(0), m(1), m(2), m(3) as usize), "bookshelf").1,
        "cupboard" => {
            k.case(m(0), m(1), m(2), m(3) as usize);
            let (x, y) = (m(0) / 2.0, m(1) / 2.0);
            k.hinge([x, -y, 0.0]).block([x, -y, 0.0], [x + 0.02, y, m(2)]);
            "cupboard"
        }
        "drawers" => {
            let (x, y, h, n) = (m(0) / 2.0, m(1) / 2.0, m(2), m(3) as usize);
            k.block([-x, -y, 0.0], [-x + 0.02, y, h]).block([-x, -y, 0.0], [x, -y + 0.02, h]);
            k.block([-x, y - 0.02, 0.0], [x, y, h]).block([-x, -y, h - 0.02], [x, y, h]);
            for i in 0..n {
                let (z, step) = ((h - 0.02) / n as f32 * i as f32, (h - 0.02) / n as f32);
                k.joint = Some(Joint {
                    kind: JointKind::Slide,
                    anchor: Point3::new(0.0, 0.0, z),
                    axis: Vector3::x(),
                    limits: (0.0, 2.0 * x - 0.05),
                });
                k.tub([-x + 0.03, -y + 0.025, z + 0.005], [x, y - 0.025, z + step * 0.8], 0.012);
            }
            k.joint = None;
            k.surface(Hold::On, [0.0, 0.0, h], (x, y), None);
            "dresser"
        }
        "basket" => (k.tub([-m(0) / 2.0, -m(1) / 2.0, 0.0], [m(0) / 2.0, m(1) / 2.0, m(2)], 0.01), "basket").1,
        "deep_tray" => (k.tub([-m(0) / 2.0, -m(1) / 2.0, 0.0], [m(0) / 2.0, m(1) / 2.0, m(2)], 0.006), "tray").1,
        "rack" => {
            // A case without a back.
            let (x, y, h, n, t) = (m(0) / 2.0, m(1) / 2.0, m(2), m(3) as usize, 0.02);
            k.block([-x, -y, 0.0], [x, -y + t, h]).block([-x, y - t, 0.0], [x, y, h]);
            for i in 0..=n {
                let z = (h - t) * i as f32 / n as f32;
                k.block([-x, -y + t, z], [x, y - t, z + t]);
            }
            "bookshelf"
        }
        "two_storey_table" => {
            k.legs(m(0), m(1), m(2) - 0.03, 0.05);
            k.block([-m(0) / 2.0, -m(1) / 2.0, m(2) - 0.03], [m(0) / 2.0, m(1) / 2.0, m(2)]);
            k.block([-m(0) / 2.0, -m(1) / 2.0, 0.1], [m(0) / 2.0, m(1) / 2.0, 0.12]);
            "table"
        }
        "tray" => (k.tub([-m(0) / 2.0, -m(1) / 2.0, 0.0], [m(0) / 2.0, m(1) / 2.0, 0.02], 0.006), "tray").1,
        "bag" => (k.tub([-m(0) / 2.0, -m(1) / 2.0, 0.0], [m(0) / 2.0, m(1) / 2.0, m(2)], 0.004), "bag").1,
        "bath" => {
            k.tub([-0.35, -0.8, 0.12], [0.35, 0.8, 0.56], 0.04).legs(0.6, 1.4, 0.12, 0.05);
            "bathtub"
        }
        "sink" => {
            k.tub([-0.22, -0.3, 0.7], [0.22, 0.3, 0.88], 0.01);
            k.block([-0.3, -0.6, 0.86], [0.3, -0.3, 0.88]).block([-0.3, 0.3, 0.86], [0.3, 0.6, 0.88]);
            k.block([-0.3, -0.6, 0.0], [-0.28, 0.6, 0.86]);
            k.block([-0.28, -0.6, 0.0], [0.3, -0.58, 0.86]).block([-0.28, 0.58, 0.0], [0.3, 0.6, 0.86]);
            "sink"
        }
        "rail" => {
            let y = m(0) / 2.0;
            k.block([-0.01, -y, -0.01], [0.01, y, 0.01]);
            k.block([-0.08, -y, -0.01], [-0.01, -y + 0.02, 0.01]).block([-0.08, y - 0.02, -0.01], [-0.01, y, 0.01]);
            "towel_rack"
        }
        "hooks" => {
            let y = m(0) / 2.0;
            k.block([-0.01, -y, -0.05], [0.01, y, 0.05]);
            for i in 0..4 {
                let at = -y + (i as f32 + 0.5) * m(0) / 4.0;
                k.block([0.01, at - 0.005, -0.02], [0.05, at + 0.005, -0.01]);
                k.surface(Hold::Hook, [0.045, at, -0.01], (0.0, 0.0), Some(1.5));
            }
            "coat_rack"
        }
        "coat" => (k.block([-0.06, -0.25, -1.0], [0.06, 0.25, 0.0]), "coat").1,
        "towel" => {
            let y = m(0) / 2.0;
            k.block([0.012, -y, -0.45], [0.018, y, 0.018]).block([-0.018, -y, -0.4], [-0.012, y, 0.018]);
            k.block([-0.018, -y, 0.012], [0.018, y, 0.018]);
            "towel"
        }
        "lamp" => {
            k.shape(Shape::Cone { radius: 0.2, half_height: 0.1 }, [0.0, 0.0, -m(0) + 0.1]);
            k.block([-0.005, -0.005, -m(0) + 0.2], [0.005, 0.005, 0.0]);
            "ceiling_lamp"
        }
        "pot" => {
            let (r, h, t) = (m(0) / 2.0, m(1), 0.004);
            k.turned(&[(r, 0.0), (r, h), (r - t, h), (r - t, t)]);
            "pot"
        }
        "lid" => {
            k.shape(Shape::Cylinder { radius: m(0) / 2.0, half_height: 0.005 }, [0.0, 0.0, 0.005]);
            "pot_lid"
        }
        "stick" => {
            k.shape(Shape::Cylinder { radius: m(0) / 2.0, half_height: m(1) / 2.0 }, [0.0, 0.0, m(1) / 2.0]);
            "broom"
        }
        "hat" => (upright(k, 0.25, 0.25, 0.1), "hat").1,
        "corner_sofa" => {
            let outline = vec![(0.45, 1.2), (-0.45, 1.2), (-0.45, -1.2), (1.6, -1.2), (1.6, -0.4), (0.45, -0.4)];
            k.shape(Shape::Extrusion { outline, height: 0.42 }, [0.0; 3]);
            "sofa"
        }
        other => panic!("no shape is called `{other}`"),
    };
    (class, kit.asset)
}

fn upright(kit: &mut Kit, x: f32, y: f32, h: f32) {
    kit.block([-x / 2.0, -y / 2.0, 0.0], [x / 2.0, y / 2.0, h]);
}
