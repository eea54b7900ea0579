//! The appearance of a person.

use nalgebra::{Point3, UnitQuaternion, Vector3};
use vc_graph::asset::{AssetError, Material, Part, Shape};
use vc_graph::{Asset, AssetLibrary, Pose};

use super::ADULT;
use super::bone::{ARM, BodySide, Bone, LEG};

/// Linear reflectance of shirts and trousers, by the person's number.
const CLOTHES: [[[f32; 3]; 2]; 4] = [
    [[0.05, 0.17, 0.42], [0.035, 0.04, 0.06]],
    [[0.42, 0.07, 0.05], [0.10, 0.08, 0.06]],
    [[0.09, 0.30, 0.12], [0.03, 0.035, 0.05]],
    [[0.48, 0.36, 0.08], [0.06, 0.05, 0.09]],
];
/// Linear reflectance of skin and hair.
const LOOKS: [[[f32; 3]; 2]; 3] = [
    [[0.58, 0.34, 0.24], [0.045, 0.025, 0.015]],
    [[0.24, 0.12, 0.07], [0.012, 0.010, 0.009]],
    [[0.66, 0.42, 0.31], [0.16, 0.08, 0.03]],
];

/// Radius of the shoulders, metres.
const SHOULDER: f32 = 0.056;

/// Materials of a person, by their index in the library.
struct Stuff {
    skin: u32,
    hair: u32,
    shirt: u32,
    trousers: u32,
    shoes: u32,
    eyes: u32,
}

impl Stuff {
    fn new(library: &mut AssetLibrary, number: usize) -> Result<Self, AssetError> {
        let ([shirt, trousers], [skin, hair]) = (CLOTHES[number % CLOTHES.len()], LOOKS[number % LOOKS.len()]);
        let mut add = |name: &str, colour, roughness| {
            library.add_material(Material { restitution: 0.0, roughness, ..Material::new(name, colour) })
        };
        Ok(Self {
            skin: add("skin", skin, 0.55)?,
            hair: add("hair", hair, 0.9)?,
            shirt: add("shirt", shirt, 0.9)?,
            trousers: add("trousers", trousers, 0.9)?,
            shoes: add("shoes", [0.025, 0.02, 0.018], 0.4)?,
            eyes: add("eyes", [0.01, 0.01, 0.012], 0.1)?,
        })
    }
}

/// A standing person with its arms down, facing X, feet at the origin.
pub(super) fn person(library: &mut AssetLibrary, number: usize) -> Result<Asset, AssetError> {
    let stuff = Stuff::new(library, number)?;
    let mut parts = Vec::new();
    trunk(&stuff, &mut parts);
    head(&stuff, &mut parts);
    for side in BodySide::BOTH {
        arm(&stuff, side, &mut parts);
        leg(&stuff, side, &mut parts);
    }
    Ok(Asset { name: format!("person_{number}").into(), parts, ..Asset::default() })
}

fn part(name: &str, bone: Bone, shape: Shape, material: u32, at: Vector3<f32>) -> Part {
    let pose = Pose::from_parts((bone.anchor().coords + at).into(), UnitQuaternion::identity());
    Part { name: name.into(), shape, material, pose, joint: Some(bone.joint()) }
}

fn block(half: [f32; 3], radius: f32) -> Shape {
    Shape::RoundedBox { half: half.into(), radius }
}

/// A limb with round ends that hangs down from its anchor.
fn limb(name: &str, bone: Bone, length: f32, radius: f32, material: u32) -> Part {
    let shape = Shape::Capsule { radius, half_height: length / 2.0 };
    part(name, bone, shape, material, Vector3::new(0.0, 0.0, -length / 2.0))
}

/// A limb with round ends between two points.
fn bar(name: &str, bone: Bone, [from, to]: [Vector3<f32>; 2], radius: f32, material: u32) -> Part {
    let way = to - from;
    let shape = Shape::Capsule { radius, half_height: way.norm() / 2.0 };
    let mut part = part(name, bone, shape, material, (from + to) / 2.0);
    part.pose.rotation = UnitQuaternion::rotation_between(&Vector3::z(), &way).unwrap_or_default();
    part
}

fn trunk(stuff: &Stuff, parts: &mut Vec<Part>) {
    let v = Vector3::new;
    parts.push(part("pelvis", Bone::Pelvis, block([0.1, 0.16, 0.11], 0.09), stuff.trousers, v(0.0, 0.0, 0.03)));
    parts.push(part("belly", Bone::Chest, block([0.1, 0.15, 0.13], 0.09), stuff.shirt, v(0.0, 0.0, 0.06)));
    parts.push(part("chest", Bone::Chest, block([0.11, 0.18, 0.17], 0.1), stuff.shirt, v(0.0, 0.0, 0.25)));
    for side in BodySide::BOTH {
        let anchor = Bone::UpperArm(side).anchor() - Bone::Chest.anchor();
        let inner = v(0.0, 0.06 * side.sign(), anchor.z);
        // The shoulder blade fills the corner between the chest and the arm, the other one slopes up to the neck.
        parts.push(bar("shoulder blade", Bone::Chest, [inner, anchor], SHOULDER, stuff.shirt));
        let [low, high] = [v(0.0, 0.15 * side.sign(), anchor.z + 0.012), inner + Vector3::z() * 0.045];
        parts.push(bar("collar", Bone::Chest, [low, high], 0.045, stuff.shirt));
    }
}

fn head(stuff: &Stuff, parts: &mut Vec<Part>) {
    let v = Vector3::new;
    let ball = |radius| Shape::Sphere { radius };
    let neck = Shape::Capsule { radius: 0.05, half_height: 0.05 };
    parts.push(part("neck", Bone::Head, neck, stuff.skin, v(0.0, 0.0, -0.01)));
    let skull = Shape::Capsule { radius: 0.085, half_height: 0.035 };
    parts.push(part("face", Bone::Head, skull, stuff.skin, v(0.012, 0.0, 0.115)));
    parts.push(part("hair", Bone::Head, ball(0.102), stuff.hair, v(-0.016, 0.0, 0.155)));
    parts.push(part("hair", Bone::Head, ball(0.087), stuff.hair, v(-0.03, 0.0, 0.095)));
    parts.push(part("nose", Bone::Head, ball(0.014), stuff.skin, v(0.1, 0.0, 0.105)));
    for side in BodySide::BOTH {
        parts.push(part("eye", Bone::Head, ball(0.011), stuff.eyes, v(0.089, 0.034 * side.sign(), 0.13)));
        parts.push(part("ear", Bone::Head, ball(0.02), stuff.skin, v(0.0, 0.085 * side.sign(), 0.11)));
    }
}

fn arm(stuff: &Stuff, side: BodySide, parts: &mut Vec<Part>) {
    // A little larger than the end of the shoulder blade: of two colours in one place, either would be seen by chance.
    let shoulder = Shape::Sphere { radius: SHOULDER + 0.001 };
    parts.push(part("shoulder", Bone::UpperArm(side), shoulder, stuff.shirt, Vector3::zeros()));
    parts.push(limb("upper arm", Bone::UpperArm(side), ARM[0], 0.046, stuff.shirt));
    parts.push(limb("forearm", Bone::Forearm(side), ARM[1] - 0.08, 0.036, stuff.skin));
    let palm = block([0.036, 0.017, 0.05], 0.016);
    parts.push(part("palm", Bone::Hand(side), palm, stuff.skin, Vector3::new(0.0, 0.0, -0.06)));
    let fingers = block([0.034, 0.011, 0.035], 0.01);
    parts.push(part("fingers", Bone::Hand(side), fingers, stuff.skin, Vector3::new(0.0, 0.0, -0.125)));
    let thumb = Shape::Capsule { radius: 0.011, half_height: 0.02 };
    parts.push(part("thumb", Bone::Hand(side), thumb, stuff.skin, Vector3::new(0.042, 0.0, -0.06)));
}

fn leg(stuff: &Stuff, side: BodySide, parts: &mut Vec<Part>) {
    parts.push(limb("thigh", Bone::Thigh(side), LEG[0], 0.074, stuff.trousers));
    parts.push(limb("shin", Bone::Shin(side), LEG[1] - 0.02, 0.054, stuff.trousers));
    let shoe = block([0.125, 0.046, 0.038], 0.034);
    parts.push(part("shoe", Bone::Foot(side), shoe, stuff.shoes, Vector3::new(0.055, 0.0, 0.038 - ADULT.ankle)));
}

/// The position of the palm when the arm hangs down.
pub fn palm(side: BodySide) -> Point3<f32> {
    Bone::UpperArm(side).anchor() - Vector3::z() * (ARM[0] + ARM[1])
}
