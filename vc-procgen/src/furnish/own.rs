//! Furniture of a program's own classes.

use vc_graph::{Class, ObjectRole};

use super::Furnisher;
use super::place::Need;

/// The floor in front of a piece that stays free, metres.
const FRONT: f32 = 0.5;

/// Places a piece of each class that is kept in such a room, in the space that is left.
pub(super) fn furnish(s: &mut Furnisher<'_>) {
    let room = s.kind().class();
    for (generator, row) in s.generators.registered() {
        if row.role() == ObjectRole::Furniture && is_kept_in(row, room) {
            let size = generator.usual_size(s.seed.child(generator.class));
            s.first_against(generator.class, &[size.into()], Need::front(FRONT), |_, _| 0.0);
        }
    }
}

/// Whether things of a class stand in rooms of a class, and not on or in something.
fn is_kept_in(row: &Class, room: &str) -> bool {
    row.kept.iter().any(|kept| kept.at.is_none() && kept.room.as_deref() == Some(room))
}
