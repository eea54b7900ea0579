//! Tests of the scene graph, the rule, goals and formats, in one program: each program links anew.

mod aims;
mod assets;
mod classes;
mod clock;
mod clock_processes;
mod edit_moves;
mod edits;
mod goal_pairs;
mod goal_scores;
mod goal_texts;
mod goal_traces;
mod goals;
mod hostile;
mod mesh;
mod odd_files;
mod own_words;
mod queries;
mod reader_errors;
mod readers;
mod round_trips;
mod rule;
mod rule_liquids;
mod rule_people;
mod rule_random;
mod rule_repairs;
mod texts;
