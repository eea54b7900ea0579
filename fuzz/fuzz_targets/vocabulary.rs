//! A vocabulary that parses is written as a text that parses to the same.
#![no_main]

use libfuzzer_sys::fuzz_target;
use vc_graph::Vocabulary;

fuzz_target!(|text: &str| {
    let Ok(words) = Vocabulary::parse("fuzz", text) else { return };
    assert_eq!(Vocabulary::parse("again", &words.to_string()).as_ref(), Ok(&words));
    assert_eq!(words.extended("again", text).as_ref(), Ok(&words));
});
