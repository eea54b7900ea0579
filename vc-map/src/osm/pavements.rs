//! Pavements that are mapped as ways of their own.

use super::network::Network;
use crate::index::PointIndex;
use crate::{DrivingSide, Polyline, StripKind};

/// A footway is the pavement of a street at most this far from it, metres.
const BESIDE: f64 = 18.0;

impl Network<'_> {
    /// Takes guessed pavements away where footways lie beside the street.
    pub(super) fn separate_pavements(&mut self, parts: &[(i64, usize, Vec<u32>)]) {
        let sidewalk =
            |way: i64| self.data.way(way).is_some_and(|way| self.data.way_tags(way).is("footway", "sidewalk"));
        let lines: Vec<Polyline> =
            parts.iter().filter(|(way, ..)| sidewalk(*way)).filter_map(|(_, _, nodes)| self.line(nodes)).collect();
        let index = PointIndex::new(lines.iter().enumerate().map(|(id, line)| (id as u32, line)));
        for (_, street, nodes) in parts {
            let Some(line) = self.line(nodes).filter(|_| self.streets[*street].guessed_pavements) else { continue };
            let steps = (line.length() / 15.0).ceil().clamp(1.0, 1000.0) as u32;
            let mut beside = [0, 0];
            for step in 0..steps {
                let at = line.at((f64::from(step) + 0.5) * line.length() / f64::from(steps));
                let mut seen = [false; 2];
                index.around(&at, BESIDE, |id| {
                    let near = lines[id as usize].project(&at);
                    if near.left.abs() <= BESIDE {
                        seen[usize::from(line.project(&near.point).left > 0.0)] = true;
                    }
                    f64::INFINITY
                });
                beside.iter_mut().zip(seen).for_each(|(count, seen)| *count += u32::from(seen));
            }
            for (left, count) in [(false, beside[0]), (true, beside[1])] {
                if 2 * count > steps {
                    let forward = left != (self.side == DrivingSide::Right);
                    let section = &mut self.streets[*street].section;
                    let strips = if forward { &mut section.forward } else { &mut section.backward };
                    strips.retain(|strip| strip.kind != StripKind::Pavement);
                }
            }
        }
    }
}
