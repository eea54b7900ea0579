//! Clothes: the bones that a piece of clothing covers, by its class.

use std::sync::LazyLock;

use vc_graph::asset::Part;
use vc_graph::{AssetLibrary, ClassTable, Node};

use super::{BodySide, Bone};

/// One line of the table.
struct Row {
    class: &'static str,
    bones: Vec<Bone>,
}

static TABLE: LazyLock<Vec<Row>> = LazyLock::new(|| {
    // A test reads the table and shows the line that cannot be read.
    rows(include_str!("../data/clothes.txt")).unwrap_or_default()
});

/// The lines of a table; the error is the line that cannot be read.
fn rows(text: &'static str) -> Result<Vec<Row>, &'static str> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| row(line).ok_or(line)).collect()
}

fn row(line: &'static str) -> Option<Row> {
    let (class, bones) = line.split_once('|')?;
    let named: Option<Vec<Vec<Bone>>> = bones.split_whitespace().map(named).collect();
    Some(Row { class: class.trim(), bones: named?.concat() })
}

/// The bones that a word of the table names.
fn named(word: &str) -> Option<Vec<Bone>> {
    let (sides, word) = match word.split_once('_') {
        Some(("right", word)) => (&BodySide::BOTH[..1], word),
        Some(("left", word)) => (&BodySide::BOTH[1..], word),
        _ => (&BodySide::BOTH[..], word),
    };
    let bone = match word {
        "pelvis" => return Some(vec![Bone::Pelvis]),
        "chest" => return Some(vec![Bone::Chest]),
        "upper_arm" => Bone::UpperArm,
        "forearm" => Bone::Forearm,
        "hand" => Bone::Hand,
        "thigh" => Bone::Thigh,
        "shin" => Bone::Shin,
        "foot" => Bone::Foot,
        _ => return None,
    };
    Some(sides.iter().map(|side| bone(*side)).collect())
}

/// The bones that a worn thing of a class covers: by the table `data/clothes.txt`, which names classes with all their
/// kinds. A thing of any other class covers none.
///
/// ```
/// use vc_graph::ClassTable;
/// use vc_people::{BodySide, Bone, clothes};
/// let classes = ClassTable::builtin();
/// assert!(clothes::covered(&classes, "raincoat").contains(&Bone::Forearm(BodySide::Right)));
/// assert!(clothes::covered(&classes, "watch").is_empty());
/// // A class of your own covers what its kind covers.
/// let row = "clogs | shoes | | clothing | graspable wearable | 0.3 0.2 0.1 | 0.8 | | | hallway/on/shoe_rack:1";
/// let classes = classes.extended("mine.txt", row)?;
/// assert_eq!(clothes::covered(&classes, "clogs"), BodySide::BOTH.map(Bone::Foot));
/// # Ok::<(), vc_graph::ClassError>(())
/// ```
pub fn covered(classes: &ClassTable, class: &str) -> &'static [Bone] {
    TABLE.iter().find(|row| classes.is_a(class, row.class)).map_or(&[], |row| &row.bones)
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

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use vc_graph::Property;
    use vc_graph::class::Category;

    use super::*;

    #[test]
    fn every_line_is_read_and_names_a_class_that_is_worn() {
        let table = rows(include_str!("../data/clothes.txt"));
        assert_eq!(table.as_ref().err(), None);
        let classes = ClassTable::builtin();
        for row in table.iter().flatten() {
            let class = classes.get(row.class).filter(|class| *class.name == *row.class);
            assert!(class.is_some_and(|c| c.affordances.contains(Property::Wearable)), "{}", row.class);
        }
        // Faults are found.
        assert_eq!(rows("hat |\ngloves | hands").err(), Some("gloves | hands"));
        assert_eq!(rows("gloves").err(), Some("gloves"));
    }

    /// A class that is worn is in the table, itself or by its kind, so that nothing colours a bone by default.
    #[test]
    fn the_table_decides_about_every_class_that_is_worn() {
        let classes = ClassTable::builtin();
        let worn = classes.iter().filter(|c| c.affordances.contains(Property::Wearable));
        let decided = |class: &str| TABLE.iter().any(|row| classes.is_a(class, row.class));
        let left: Vec<&str> =
            worn.filter(|c| c.category != Category::Group).map(|c| &*c.name).filter(|c| !decided(c)).collect();
        assert_eq!(left, [""; 0]);
    }

    #[test]
    fn things_cover_the_bones_that_they_are_worn_on() {
        let classes = ClassTable::builtin();
        let covers = |class, bone| covered(&classes, class).contains(&bone);
        let left = BodySide::Left;
        for small in ["sunglasses", "cap", "headset", "knee_pads", "scarf", "belt", "vase", "unheard-of"] {
            assert!(covered(&classes, small).is_empty(), "{small}");
        }
        for shoes in ["sneakers", "high_heels", "socks", "ice_skates", "swim_fins"] {
            assert_eq!(covered(&classes, shoes), BodySide::BOTH.map(Bone::Foot), "{shoes}");
        }
        for (class, bone) in [("shorts", Bone::Shin(left)), ("life_jacket", Bone::UpperArm(left))] {
            assert!(!covers(class, bone), "{class} {bone:?}");
        }
        // A swimsuit is no suit, and underwear is worn on the hips.
        assert!(!covers("swimsuit", Bone::Forearm(left)) && covers("swimsuit", Bone::Chest));
        assert!(covers("underwear", Bone::Pelvis) && !covers("underwear", Bone::Chest));
        assert_eq!(covered(&classes, "baseball_glove"), [Bone::Hand(left)]);
    }
}
