//! The settings by which an environment goes on, as words: a save is restored only where they are the same.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde_json::Value;
use vc_graph::ClassTable;
use vc_graph::clock::{Durations, ProcessTable};
use vc_graph::hash::Digester;

use super::{Environment, SaveError};

/// The settings by the names that the builder has for them, with their values as text.
type Told = BTreeMap<String, String>;

impl Environment {
    /// The settings that change what follows. Those of pictures, sensors and threads do not.
    pub(crate) fn saved_settings(&self) -> Result<String, SaveError> {
        serde_json::to_string(&self.told_settings()).map_err(SaveError::Settings)
    }

    /// Refuses a save that was made under other settings.
    pub(crate) fn check_settings(&self, saved: &str) -> Result<(), SaveError> {
        let (saved, own): (Told, Told) =
            (serde_json::from_str(saved).map_err(SaveError::Settings)?, self.told_settings());
        let value = |told: &Told, name: &str| told.get(name).map_or("nothing", String::as_str).to_owned();
        match own.keys().chain(saved.keys()).find(|name| own.get(*name) != saved.get(*name)) {
            None => Ok(()),
            Some(name) => {
                let (expected, found) = (value(&own, name), value(&saved, name));
                Err(SaveError::OtherSetting { setting: name.clone(), expected, found })
            }
        }
    }

    fn told_settings(&self) -> Told {
        let (start, time) = (&self.start, &self.start.time);
        let processes = table(*time.processes == *ProcessTable::builtin(), || format!("{:?}", time.processes));
        let durations = table(*time.durations == *Durations::builtin(), || format!("{:?}", time.durations));
        let classes = start.graph.classes();
        let builtin = Arc::ptr_eq(classes, &ClassTable::builtin());
        let named = [
            ("bodies", time.bodies.to_string()),
            ("processes", processes),
            ("durations", durations),
            ("processes_at_once", time.at_once.to_string()),
            ("begins_at", time.begin.to_string()),
            ("relations", text(&start.relations.rule())),
            ("tolerance", start.relations.tolerance().to_string()),
            ("classes", table(builtin, || classes.iter().map(|class| format!("{class:?}\n")).collect())),
        ];
        let physics = fields(start.world.settings());
        named.map(|(name, value)| (name.to_owned(), value)).into_iter().chain(physics).collect()
    }
}

/// A table: the built-in one, or one of the user's own by its digest.
fn table(builtin: bool, content: impl Fn() -> String) -> String {
    if builtin {
        "the built-in table".to_owned()
    } else {
        format!("table {}", Digester::new().text(&content()).digest())
    }
}

/// The settings of the bodies: gravity by the name that the builder has for it, the others by those of their fields.
fn fields(settings: &vc_physics::Settings) -> Vec<(String, String)> {
    let all: BTreeMap<String, Value> = serde_json::from_str(&text(settings)).unwrap_or_default();
    let name = |field: String| if field == "gravity" { field } else { format!("physics.{field}") };
    all.into_iter().map(|(field, value)| (name(field), value.to_string())).collect()
}

/// Plain data as text.
fn text(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}
