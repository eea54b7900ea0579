//! Pavements that are mapped as ways of their own.

use super::network::{Network, Part};
use super::{Element, Guessed, ImportReport};
use crate::index::PointIndex;
use crate::{DrivingSide, Polyline, StripKind};

/// A footway is the pavement of a street at most this far from it, metres.
const BESIDE: f64 = 18.0;

impl Network<'_> {
    /// Takes guessed pavements away where footways lie beside the street, and lists those that are left.
    pub(super) fn separate_pavements(&mut self, parts: &[Part], report: &mut ImportReport) {
        let source = self.source;
        let sidewalk = |way: i64| source.way(way).is_some_and(|way| source.way_tags(way).is("footway", "sidewalk"));
        let lines: Vec<Polyline> =
            parts.iter().filter(|part| sidewalk(part.way)).filter_map(|part| self.line(&part.nodes)).collect();
        let index = PointIndex::new(lines.iter().enumerate().map(|(id, line)| (id as u32, line)));
        let guessed = |part: &&Part| self.streets[part.street].guessed_pavements;
        let guessed: Vec<&Part> = parts.iter().filter(guessed).collect();
        for part in &guessed {
            let Some(line) = self.line(&part.nodes) else { continue };
            for (left, has) in [false, true].into_iter().zip(beside(&line, &lines, &index)) {
                if has {
                    let forward = left != (self.side == DrivingSide::Right);
                    let section = &mut self.streets[part.street].section;
                    let strips = if forward { &mut section.forward } else { &mut section.backward };
                    strips.retain(|strip| strip.kind != StripKind::Pavement);
                }
            }
        }
        for part in guessed.chunk_by(|a, b| a.way == b.way).map(|parts| parts[0]) {
            let strips = self.streets[part.street].section.strips();
            let count = strips.filter(|(_, strip)| strip.kind == StripKind::Pavement).count() as u32;
            if count > 0 {
                report.guess(Element::Way(part.way), Guessed::Pavements(count));
            }
        }
    }
}

/// Whether some lines accompany the right and the left side of a line for more than half of its length.
fn beside(line: &Polyline, lines: &[Polyline], index: &PointIndex) -> [bool; 2] {
    let steps = (line.length() / 15.0).ceil().clamp(1.0, 1000.0) as u32;
    let mut beside = [0, 0];
    for step in 0..steps {
        let at = line.at((f64::from(step) + 0.5) * line.length() / f64::from(steps));
        let mut seen = [false; 2];
        for near in index.each(&at, BESIDE, |id| &lines[id as usize]).values() {
            seen[usize::from(line.project(&near.point).left > 0.0)] = true;
        }
        beside.iter_mut().zip(seen).for_each(|(count, seen)| *count += u32::from(seen));
    }
    beside.map(|count| 2 * count > steps)
}
