//! Traffic lights: phases, and which light rules which connection.

use std::fmt::Display;

use super::connections::ends;
use super::{LightName, Metres};
use crate::format::xml::Xml;
use crate::{Light, StreetMap};

pub(super) fn lights(map: &StreetMap) -> String {
    let mut xml = Xml::new("tlLogics", &[]);
    for signal in map.signals() {
        let id = LightName(signal.junction);
        xml.open("tlLogic", &[("id", &id), ("type", &"static"), ("programID", &"0"), ("offset", &0)]);
        for phase in &signal.phases {
            let state: String = phase.lights.iter().map(letter).collect();
            xml.tag("phase", &[("duration", &Metres(phase.seconds)), ("state", &state)]);
        }
        xml.close();
    }
    for signal in map.signals() {
        let id = LightName(signal.junction);
        let own = map.junction(signal.junction).into_iter().flat_map(|junction| junction.movements.iter().enumerate());
        for (row, movement) in own.filter_map(|(row, movement)| Some((row, map.movement(*movement)?))) {
            let Some([from, to, lane, onto]) = ends(map, movement) else { continue };
            let attributes: [(&str, &dyn Display); 6] = [
                ("from", &from),
                ("to", &to),
                ("fromLane", &lane),
                ("toLane", &onto),
                ("tl", &id),
                ("linkIndex", &row),
            ];
            xml.tag("connection", &attributes);
        }
    }
    xml.finish()
}

fn letter(light: &Light) -> char {
    match light {
        Light::Red => 'r',
        Light::Green => 'G',
        Light::GreenYield => 'g',
        Light::Yellow => 'y',
    }
}
