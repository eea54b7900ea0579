//! No text makes a reader panic.
#![allow(clippy::unwrap_used)]

use proptest::prelude::*;
use vc_graph::format::{eai, native, program, read_scene, thesis, virtualhome};
use vc_graph::{Action, ClassTable, Goal, Label, SceneGraph, State, Word};
use vc_testkit::{cases, documents};

/// Gives a text to every reader, and uses the results.
fn read_all(text: &str) {
    let classes = ClassTable::builtin();
    let readers = [native::read, thesis::read, virtualhome::read, read_scene];
    for graph in readers.into_iter().filter_map(|read| read(text, &classes).ok()) {
        look_at(&graph);
        let written = native::write(&graph);
        assert!(native::read(&written, &classes).as_ref() == Ok(&graph), "{written}");
        let written = virtualhome::write(&graph);
        virtualhome::read(&written, &classes).unwrap_or_else(|e| panic!("{e}: {written}"));
    }
    if let Ok(record) = eai::read_record(text) {
        let graphs = [&record.initial, &record.last].map(|g| g.build("EAI", &classes));
        graphs.iter().flatten().for_each(look_at);
    }
    let goals = [text.parse::<Goal>().ok(), Goal::from_eai(text).ok()];
    let tasks = eai::read_tasks(text).unwrap_or_default();
    let tasks = tasks.into_values().flat_map(|t| [Some(t.goal), t.formula]);
    goals.into_iter().chain(tasks).flatten().for_each(|goal| drop(goal.to_string()));
    if let Ok(program) = program::read(text) {
        let nothing = SceneGraph::new("", classes);
        let _ = program.cast(&nothing);
        if let Ok(written) = program::write(&program, &nothing) {
            let again = program::read(&written).unwrap_or_else(|e| panic!("{e}: {written}"));
            assert!(again.actions().eq(program.actions()) && again.heading == program.heading, "{written}");
        }
    }
    let _ = (text.parse::<Action>(), text.parse::<Label>(), State::parse(text));
    if let Ok(table) = ClassTable::parse("mine", text) {
        table.iter().for_each(|c| assert!(table.get(&c.name).is_some()));
    }
    let _ = ClassTable::builtin().get(text);
}

/// Calls everything that traverses a scene, on a scene as read from a file.
fn look_at(graph: &SceneGraph) {
    let _ = (graph.validate(), graph.digest(), native::write(graph), thesis::write(graph), virtualhome::write(graph));
    for node in graph.nodes() {
        let _ = (graph.place(node.id()), graph.support_chain(node.id()), graph.carried_with(node.id()));
        let _ = (graph.hidden_in(node.id()), graph.of_class(node.class()), graph.label(node.id()).to_string());
    }
    for &agent in graph.agents() {
        for node in graph.nodes() {
            let _ = (graph.near(agent, node.id()), graph.distance(agent, node.id()));
        }
        let _ = graph.observe(agent, vc_graph::Scope::Room);
    }
}

/// A mutation of a document: position, length, kind, and replacement.
type Cut = (prop::sample::Index, usize, u8, usize);

const TOKENS: &[&str] = &[
    "",
    "NaN",
    "1e400",
    "1e39",
    "-1",
    "4294967295",
    "4294967296",
    "null",
    "\"\"",
    "[]",
    "{}",
    "true",
    "0.5",
    "\\u0000",
    "\u{fffd}",
    "\"",
    "[",
    "}",
    ",",
    ":",
    "(",
    ")",
    ".",
    "|",
    "?",
    "#",
    "é",
    "\n",
    "1:1",
    "not",
    "forall ?x.",
    "-0",
];

fn cuts() -> impl Strategy<Value = Vec<Cut>> {
    prop::collection::vec((any::<prop::sample::Index>(), 0_usize..40, any::<u8>(), 0..TOKENS.len()), 1..6)
}

fn mutated(document: &str, cuts: &[Cut]) -> String {
    let mut bytes = document.as_bytes().to_vec();
    for (at, span, what, token) in cuts {
        let from = at.index(bytes.len() + 1);
        let to = (from + span).min(bytes.len());
        match what % 5 {
            0 => drop(bytes.splice(from..to, [])),
            1 => {
                let twice = bytes[from..to].to_vec();
                bytes.splice(to..to, twice);
            }
            2 => drop(bytes.splice(from..to, TOKENS[*token].bytes())),
            _ => {
                // The next number after the position.
                let start = bytes[from..].iter().position(u8::is_ascii_digit).map_or(from, |p| from + p);
                let is_number = |b: &u8| b.is_ascii_digit() || *b == b'.';
                let end = start + bytes[start..].iter().take_while(|b| is_number(b)).count();
                bytes.splice(start..end, TOKENS[*token].bytes());
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn any_string(text in "\\PC{0,60}") {
        read_all(&text);
    }

    #[test]
    fn any_string_of_our_signs(text in "[\\[\\]{}()<>!&|?#.,:\"a-dxN0-9 \n_-]{0,80}") {
        read_all(&text);
    }

    #[test]
    fn mutated_documents(which in prop::sample::select(documents::ALL), cuts in cuts()) {
        read_all(&mutated(which, &cuts));
    }
}

#[test]
fn the_documents_are_valid() {
    let classes = ClassTable::builtin();
    native::read(documents::NATIVE, &classes).unwrap();
    thesis::read(documents::THESIS, &classes).unwrap();
    virtualhome::read(documents::VIRTUALHOME, &classes).unwrap();
    program::read(documents::PROGRAM).unwrap();
    eai::read_record(documents::RECORD).unwrap();
    assert!(eai::read_tasks(documents::TASKS).unwrap()["file1_1"].formula.is_some());
    documents::GOAL.parse::<Goal>().unwrap();
    Goal::from_eai(documents::EAI_GOAL).unwrap();
    assert!(documents::ACTION.parse::<Action>().is_ok() && documents::NOTATION.parse::<Action>().is_ok());
    documents::LABEL.parse::<Label>().unwrap();
    ClassTable::parse("mine", documents::CLASSES).unwrap();
    for text in [documents::NATIVE, documents::THESIS, documents::VIRTUALHOME] {
        read_scene(text, &classes).unwrap();
    }
}

#[test]
fn documents_cut_short() {
    for document in documents::ALL {
        (0..document.len()).filter(|&end| document.is_char_boundary(end)).for_each(|end| read_all(&document[..end]));
    }
}

#[test]
fn deep_nesting_is_refused() {
    let deep = |open: &str| open.repeat(10_000);
    for open in
        ["[", "{\"a\":", "[{\"nodes\":", "(", "!", "!(", "not ", "forall ?x. ", "exists ?x: a. (", "a(", "|", "<("]
    {
        read_all(&deep(open));
        read_all(&format!("{{\"virtualcity\": 1, \"name\": \"\", \"nodes\": {}", deep(open)));
        read_all(&format!("{{\"a\": {}", deep(open)));
        read_all(&format!("{}Open(x)", deep(open)));
    }
    let closed = deep("(") + "Open(x)" + &deep(")");
    read_all(&closed);
    assert!(closed.parse::<Goal>().unwrap_err().to_string().contains("nest"));
}

/// Run with a large stack: a reader that recurses without bound then returns instead of ending the process.
#[test]
fn deep_quantifiers_are_refused() {
    let read = || {
        let text = "exists x.".repeat(7000) + "TOUCH(x)";
        let goal = Goal::from_eai(&text);
        let refused = goal.is_err();
        std::mem::forget(goal);
        refused
    };
    let reader = std::thread::Builder::new().stack_size(256 << 20).spawn(read).unwrap();
    assert!(reader.join().unwrap(), "7000 nested quantifiers are read");
}

#[test]
fn numbers_of_places_do_not_overflow() {
    let places = r#"[{"kind": "seat", "number": 4294967295}, {"kind": "seat", "number": 4294967295}]"#;
    let text = documents::NATIVE.replace(r#"[{"kind": "seat", "number": 2}]"#, places);
    look_at(&native::read(&text, &ClassTable::builtin()).unwrap());
}
