//! Clothes: the bones that a piece of clothing covers, by its class.

use vc_graph::asset::Part;
use vc_graph::{AssetLibrary, Node};

use super::Bone;

/// The part of the body that is covered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Cover {
    Hands,
    Feet,
    Legs,
    /// From the chest to the thighs.
    Dress,
    Chest,
    /// The chest with sleeves.
    Coat,
}

/// The cover by words of class names; classes with none of the words cover the chest.
const COVERS: [(&str, Cover); 23] = [
    ("glove", Cover::Hands),
    ("mitten", Cover::Hands),
    ("shoe", Cover::Feet),
    ("boot", Cover::Feet),
    ("slipper", Cover::Feet),
    ("sandal", Cover::Feet),
    ("sneaker", Cover::Feet),
    ("heels", Cover::Feet),
    ("sock", Cover::Feet),
    ("trouser", Cover::Legs),
    ("pants", Cover::Legs),
    ("jeans", Cover::Legs),
    ("shorts", Cover::Legs),
    ("legging", Cover::Legs),
    ("skirt", Cover::Legs),
    ("tights", Cover::Legs),
    ("dress", Cover::Dress),
    ("robe", Cover::Coat),
    ("coat", Cover::Coat),
    ("jacket", Cover::Coat),
    ("suit", Cover::Coat),
    ("sweater", Cover::Coat),
    ("hoodie", Cover::Coat),
];

/// Worn things that cover none of the figure's bones.
const SMALL: [&str; 14] = [
    "watch", "ring", "glasses", "necklace", "bracelet", "earring", "belt", "tie", "backpack", "purse", "hat", "cap",
    "beanie", "helmet",
];

/// Whether a piece of clothing of a class covers a bone.
///
/// ```
/// use vc_people::{BodySide, Bone, clothes};
/// assert!(clothes::covers("coat", Bone::Forearm(BodySide::Right)));
/// assert!(!clothes::covers("watch", Bone::Forearm(BodySide::Right)));
/// ```
pub fn covers(class: &str, bone: Bone) -> bool {
    if SMALL.iter().any(|word| class.contains(word)) {
        return false;
    }
    let cover = COVERS.iter().find(|(word, _)| class.contains(word)).map_or(Cover::Chest, |(_, cover)| *cover);
    match bone {
        Bone::Head => false,
        Bone::Hand(_) => cover == Cover::Hands,
        Bone::Foot(_) => cover == Cover::Feet,
        Bone::Shin(_) => cover == Cover::Legs,
        Bone::Thigh(_) | Bone::Pelvis => matches!(cover, Cover::Legs | Cover::Dress),
        Bone::Chest | Bone::UpperArm(_) => matches!(cover, Cover::Chest | Cover::Coat | Cover::Dress),
        Bone::Forearm(_) => cover == Cover::Coat,
    }
}

/// The linear reflectance of a piece of clothing: that of its largest part.
pub fn colour(library: &AssetLibrary, node: &Node) -> Option<[f32; 3]> {
    let asset = library.get(node.spec().asset?)?;
    let size = |part: &&Part| {
        let (low, high) = part.shape.extent();
        (high - low).product()
    };
    let largest = asset.parts.iter().max_by(|a, b| size(a).total_cmp(&size(b)))?;
    library.material(largest.material).map(|material| material.colour)
}
