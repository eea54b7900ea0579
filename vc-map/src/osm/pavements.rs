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
        let sidewalk = |way: Option<i64>| {
            way.and_then(|way| source.way(way)).is_some_and(|way| source.way_tags(way).is("footway", "sidewalk"))
        };
        let lines: Vec<Polyline> =
            parts.iter().filter(|part| sidewalk(part.way)).filter_map(|part| self.line(&part.nodes)).collect();
        let index = PointIndex::new(lines.iter().enumerate().map(|(id, line)| (id as u32, line)));
        let guessed = |part: &&Part| self.streets[part.street].guessed_pavements != [None; 2];
        let guessed: Vec<&Part> = parts.iter().filter(guessed).collect();
        for part in &guessed {
            let Some(line) = self.line(&part.nodes) else { continue };
            for (left, share) in [false, true].into_iter().zip(beside(&line, &lines, &index)) {
                let forward = left != (self.side == DrivingSide::Right);
                let street = &mut self.streets[part.street];
                if street.guessed_pavements[usize::from(!forward)].is_some_and(|least| share > least) {
                    let section = &mut street.section;
                    let strips = if forward { &mut section.forward } else { &mut section.backward };
                    strips.retain(|strip| strip.kind != StripKind::Pavement);
                }
            }
        }
        for part in guessed.chunk_by(|a, b| a.way == b.way).map(|parts| parts[0]) {
            let street = &self.streets[part.street];
            let left = |forward: bool| {
                let strips = street.section.side(forward).iter();
                strips.filter(|strip| strip.kind == StripKind::Pavement).count()
            };
            let guessed =
                [true, false].into_iter().zip(street.guessed_pavements).filter(|(_, guessed)| guessed.is_some());
            let count = guessed.map(|(forward, _)| left(forward)).sum::<usize>() as u32;
            if count > 0 {
                part.way.iter().for_each(|way| report.guess(Element::Way(*way), Guessed::Pavements(count)));
            }
        }
    }
}

/// The parts of a line that some lines accompany on its right and on its left.
fn beside(line: &Polyline, lines: &[Polyline], index: &PointIndex) -> [f64; 2] {
    let steps = (line.length() / 15.0).ceil().clamp(1.0, 1000.0) as u32;
    let mut beside = [0_u32; 2];
    for step in 0..steps {
        let at = line.at((f64::from(step) + 0.5) * line.length() / f64::from(steps));
        let mut seen = [false; 2];
        for near in index.each(&at, BESIDE, |id| &lines[id as usize]).values() {
            seen[usize::from(line.project(&near.point).left > 0.0)] = true;
        }
        beside.iter_mut().zip(seen).for_each(|(count, seen)| *count += u32::from(seen));
    }
    beside.map(|count| f64::from(count) / f64::from(steps))
}
