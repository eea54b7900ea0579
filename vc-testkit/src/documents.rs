//! Small valid documents, one for each reader.

/// A scene in the native format.
pub const NATIVE: &str = r#"{"virtualcity": 1, "name": "flat",
 "nodes": [
  {"id": 1, "class": "kitchen", "category": "room"},
  {"id": 2, "class": "kitchen_table", "category": "furniture", "affordances": ["surface"],
   "pose": {"position": [1.5, 2, 0.75], "rotation": [0, 0, 0, 1]},
   "bounds": {"offset": [0, 0, 0.4], "half": [0.5, 0.5, 0.4], "world": true}, "scale": [1, 2, 1]},
  {"id": 3, "class": "character", "category": "character", "kind": "agent", "states": ["sitting"]},
  {"id": 4, "class": "cup", "category": "prop", "properties": ["graspable"], "contents": "water",
   "slots": [{"kind": "seat", "number": 2}], "asset": 0}],
 "edges": [
  [2, "in_room", 1],
  [3, "in_room", 1],
  [4, "on", 2], [2, "near", 3]],
 "materials": [{"name": "oak", "colour": [0.4, 0.3, 0.1], "density": 700, "friction": 0.5, "restitution": 0.1,
  "roughness": 0.6, "metallic": 0, "transmission": 0, "emission": [0, 0, 0]}],
 "assets": [{"name": "cup_1", "parts": [{"name": "body", "shape": {"cylinder": {"radius": 0.04, "half_height": 0.05}},
  "material": 0, "pose": {"position": [0, 0, 0.05], "rotation": [0, 0, 0, 1]},
  "joint": {"kind": "hinge", "anchor": [0, 0, 0], "axis": [0, 0, 1], "limits": [0, 1.5]}}]}]}
"#;

/// A scene in the format of the thesis.
pub const THESIS: &str = r#"{"Apartment_0": [
 {"conatiner": 0, "id": 1, "name": "Kitchen", "relation": [], "state": [],
  "transform": ["X=0 Y=0 Z=0", "P=0 Y=0 R=0", "X=1 Y=1 Z=1"]},
 {"conatiner": 5, "id": 2, "name": "SM_L_Table", "relation": ["SM_L_Table inside Kitchen"], "state": [],
  "transform": ["X=120 Y=-40.5 Z=0", "P=0 Y=90 R=0", "X=1 Y=1 Z=1"]},
 {"container": 0, "id": 7, "name": "SM_Glass", "relation": ["SM_Glass supported by SM_L_Table"], "state": ["Clean"],
  "transform": ["X=120 Y=-40 Z=75", "P=0 Y=90 R=-10", "X=1 Y=1 Z=1"]}]}
"#;

/// A scene of VirtualHome.
pub const VIRTUALHOME: &str = r#"{"nodes": [
 {"id": 11, "category": "Rooms", "class_name": "kitchen", "prefab_name": "PRE_ROO_Kitchen_01",
  "bounding_box": {"center": [1, 1.25, 2], "size": [4, 2.5, 3]}, "properties": [], "states": []},
 {"id": 12, "category": "Appliances", "class_name": "fridge", "prefab_name": null,
  "obj_transform": {"position": [1, 0, 2.5], "rotation": [0, 0.707107, 0, 0.707107], "scale": [1, 1, 1]},
  "bounding_box": {"center": [1, 0.9, 2.5], "size": [0.7, 1.8, 0.7]},
  "properties": ["CAN_OPEN", "CONTAINERS"], "states": ["CLOSED"]},
 {"id": 1, "category": "Characters", "class_name": "character", "properties": [], "states": ["SITTING"]}],
 "edges": [
 {"from_id": 12, "relation_type": "INSIDE", "to_id": 11},
 {"from_id": 1, "relation_type": "CLOSE", "to_id": 12},
 {"from_id": 1, "relation_type": "INSIDE", "to_id": 11}]}
"#;

/// A program of VirtualHome.
pub const PROGRAM: &str = "Drink\nGo and drink something.\n\n[WALK] <kitchen> (11)\n[FIND] <fridge> (1.12)\n\
    [PUTIN] <milk> (3) <fridge> (12)\n[SLEEP]\n";

/// A program of two people.
pub const TOGETHER: &str = "Sleep\n\n# A comment.\n<char0> [WALK] <kitchen> (11) [0] | <char1> [STANDUP]\n\
    <char1> grab cup.12\n";

/// A recorded program of the Embodied Agent Interface.
pub const RECORD: &str = r#"{"id": "file1_1", "title": "Drink", "program": ["[WALK] <kitchen> (11)", "[OPEN] <fridge> (12)"],
 "init_graph": {"nodes": [{"id": 11, "class_name": "kitchen", "category": "Rooms"}, {"id": 12, "class_name": "fridge", "states": ["CLOSED"], "properties": ["CAN_OPEN"]}],
  "edges": [{"from_id": 12, "relation_type": "INSIDE", "to_id": 11}]},
 "final_graph": {"nodes": [], "edges": []}}"#;

/// Tasks of the Embodied Agent Interface.
pub const TASKS: &str = r#"{"file1_1": {"title": "Wash hands",
 "vh_goal": {"actions": ["TOUCH|PUSH", "WASH"], "goal": [{"id": 12, "class_name": "fridge", "state": "CLOSED"},
  {"from_id": 1, "relation_type": "CLOSE", "to_id": 12}]},
 "tl_goal": "(exists x0. (TOUCH(x0)) then NEXT_TO(character.1, fridge.12) and not OPEN(fridge.12))"}}"#;

/// A goal.
pub const GOAL: &str = "On(apple, kitchentable), 3 & !(Closed(fridge) | Near(me, cup.12)) then did put_in(#4, _), <= 2 \
    & forall ?p: plate. exists ?q. (Inside(?p, ?q) | Clean(?p))";

/// A goal of the Embodied Agent Interface.
pub const EAI_GOAL: &str =
    "(exists x0. (TOUCH(x0)) then NEXT_TO(character.65, cat.1000) and forall y. (not ON(y) or ONTOP(y, table.3)))";

/// An action.
pub const ACTION: &str = "put_in cup.12 #3";
/// An action in VirtualHome's notation.
pub const NOTATION: &str = "<char0> [PUTIN] <cup> (1.12) <dishwasher> (3)";
/// A label.
pub const LABEL: &str = "kitchen_table.12";

/// A class table.
pub const CLASSES: &str = "# name | kind of | aliases | category | affordances | size | mass | starts | slots | kept\n\
    kitchen | | | room | | 2-4 3 2.5 | | | |\n\
    rack | furniture | peg_board | furniture | surface openable | 0.2-0.4 0.3 1e0 | 1.5-2 | closed | hook:6 | kitchen:1\n\
    furniture | | | group | | | | | |\n\
    mug | | beaker, cup | prop | graspable | 0.1 0.1 0.1 | 0.3 | clean | | kitchen/on/rack:8 */in/rack:2\n";

/// All of them.
pub const ALL: &[&str] =
    &[NATIVE, THESIS, VIRTUALHOME, PROGRAM, TOGETHER, RECORD, TASKS, GOAL, EAI_GOAL, ACTION, NOTATION, LABEL, CLASSES];
