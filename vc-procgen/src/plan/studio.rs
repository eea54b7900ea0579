//! Studios: one main room; bathroom, stores and the entrance along the landing.

use vc_graph::Stream;
use vc_graph::portable::Portable;

use super::programme::Programme;
use super::{Arrangement, Rect, Room, RoomKind};

/// Lays out a studio: service rooms side by side at the north wall, the main room around them.
pub(super) fn lay_out(programme: &Programme, rng: &mut Stream) -> Option<Arrangement> {
    (0..200).find_map(|_| attempt(programme, rng))
}

fn attempt(programme: &Programme, rng: &mut Stream) -> Option<Arrangement> {
    let mut services: Vec<usize> = (1..programme.wishes.len()).collect();
    rng.shuffle(&mut services);
    let depth = rng.count(94, 140) as i32;
    let band = rng.count(38, 46) as i32;
    let gross = |index: usize| (programme.wishes[index].area.sqrt() + 0.1).raised(2) * 400.0;
    let total: f32 = (0..programme.wishes.len()).map(gross).sum();
    let hall = rng.chance(0.5).then(|| rng.count(26, 36) as i32);
    let length = ((total + hall.map_or(0.0, |w| (w * band) as f32)) / depth as f32).round() as i32;
    let mut rooms: Vec<Room> =
        programme.wishes.iter().map(|w| Room { kind: w.kind, rects: Vec::new(), of: None }).collect();
    let mut x = 0;
    for index in services {
        let width = (gross(index) / band as f32).round() as i32;
        let cut = Rect { x0: x, x1: x + width, y0: depth - band, y1: depth };
        rooms[index].rects.push(cut);
        x += width;
    }
    if let Some(width) = hall {
        let rect = Rect { x0: x, x1: x + width, y0: depth - band, y1: depth };
        rooms.push(Room::new(RoomKind::Hall, rect));
        x += width;
    }
    let rest = length - x;
    if rest < 0 || (rest > 0 && rest < 30) || (rest == 0 && hall.is_none()) || length < 62 {
        return None;
    }
    rooms[0].rects.push(Rect { x0: 0, x1: length, y0: 0, y1: depth - band });
    if rest > 0 {
        rooms[0].rects.push(Rect { x0: x, x1: length, y0: depth - band, y1: depth });
    }
    let wide = rooms.iter().all(|r| r.widest() >= r.kind.least_side());
    let shaped = rooms[0].hull().width() * 2 >= depth - band;
    let facades = [rng.chance(0.25), rng.chance(0.25), true, false];
    (wide && shaped).then_some(Arrangement { rooms, facades })
}
