//! There is room for 192 own words of a kind in a process: a program of its own, since others need some.

#![allow(clippy::unwrap_used, reason = "tests may unwrap")]

use vc_graph::{NameProblem, State, StateSet, Vocabulary, VocabularyProblem, Word};

#[test]
fn the_193rd_own_word_is_refused() {
    let text: String = (0..192).rev().map(|n| format!("state own_{n:03}\n")).collect();
    let words = Vocabulary::parse("words.txt", &text).unwrap();
    let error = Vocabulary::parse("more.txt", "\nstate one_more").unwrap_err();
    assert_eq!(error.problem, VocabularyProblem::Name(NameProblem::TooMany("one_more".into())));
    assert!(error.to_string().contains("at most 192 own words of a kind"), "{error}");
    assert!(State::parse("one_more").is_err());
    // All of them are words, and sets are by name although the last were declared first.
    let all: StateSet = words.own_states().iter().map(|own| own.state).chain(State::ALL.iter().copied()).collect();
    assert_eq!(all.len(), 192 + State::ALL.len());
    let names: Vec<&str> = all.own().map(State::as_str).collect();
    assert!(names.is_sorted() && names.len() == 192);
    // Other kinds have numbers of their own, and threads agree about names.
    let threads: Vec<_> = (0..4)
        .map(|_| {
            std::thread::spawn(|| Vocabulary::parse("verbs.txt", "verb nod 0\nverb shrug 0\nproperty soft").unwrap())
        })
        .collect();
    let found: Vec<Vocabulary> = threads.into_iter().map(|thread| thread.join().unwrap()).collect();
    assert!(found.windows(2).all(|pair| pair[0] == pair[1]));
}
