//! Parses goals of the thesis, of Watch-And-Help and of EAI; goals that their writers accept parse back equal.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_tasks::format::{eai, thesis, watch_and_help};
use vc_tasks::lint;

fuzz_target!(|text: &str| {
    for goal in [thesis::read(text), watch_and_help::read(text), eai::read_formula(text)].into_iter().flatten() {
        if let Ok(text) = thesis::write(&goal) {
            assert_eq!(thesis::read(&text).as_ref(), Ok(&goal));
        }
        if let Ok(text) = watch_and_help::write(&goal) {
            assert_eq!(watch_and_help::read(&text).as_ref(), Ok(&goal));
        }
        if let Ok(text) = eai::formula(&goal) {
            assert_eq!(eai::read_formula(&text).as_ref(), Ok(&goal));
        }
        lint::goal(&goal, None);
    }
});
