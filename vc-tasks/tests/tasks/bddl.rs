//! The activities of BEHAVIOR from the PyPI packages bddl 3.6.0 and 1.0.1.
#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use crate::behavior::activities;
use vc_tasks::format::bddl::ActivityDefinition;

#[test]
fn every_activity_reads_and_what_is_written_reads_back_equal() {
    for (file, text) in activities() {
        let activity = ActivityDefinition::read(&text).unwrap_or_else(|e| panic!("{}", e.in_file(&file)));
        assert!(activity.objects().count() > 0, "{file}");
        let written = activity.to_string();
        let again = ActivityDefinition::read(&written).unwrap_or_else(|e| panic!("{e}\n{written}"));
        assert_eq!(again, activity, "{file}");
    }
}
