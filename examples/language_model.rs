//! Lets a language model tidy up the breakfast.
//!
//! `cargo run --release --example language_model` needs no network: the model's answers
//! were recorded, mistakes among them, and are read from
//! `examples/data/language_model.txt`. With `--endpoint
//! http://127.0.0.1:8080/v1/chat/completions` it asks a local server instead that speaks
//! as OpenAI's does (llama.cpp, Ollama, vLLM ...); `--record FILE` keeps the answers.

#[expect(dead_code, reason = "this example reads no packed files")]
mod support;

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::PathBuf;
use std::time::Duration;

use clap::Parser;
use support::{Complaint, say};
use vc_graph::{Draft, EditError, SceneBuilder, SceneGraph, Simulator};
use vc_planner::language::Prompt;
use vc_planner::{LanguageModel, Run};
use vc_tasks::Task;

const RECORDED: &str = include_str!("data/language_model.txt");
/// What stands between two answers.
const BREAK: &str = "\n---\n";

/// Lets a language model tidy up the breakfast.
#[derive(Parser)]
struct Options {
    /// A local server, `http://HOST:PORT/PATH`.
    #[arg(long)]
    endpoint: Option<String>,
    /// The model's name, for servers that have several.
    #[arg(long, default_value = "default")]
    model: String,
    /// Where the answers are kept.
    #[arg(long)]
    record: Option<PathBuf>,
    /// Shows what the model is asked.
    #[arg(long)]
    prompts: bool,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let scene = home().map_err(Complaint::new)?;
    let goal = "Inside(milk, fridge) & Closed(fridge) & On(mug, kitchen_counter)".parse().map_err(Complaint::new)?;
    let mut task = Task::new("tidy up the breakfast", goal);
    task.step_limit = 40;
    let mut recorded = RECORDED.split(BREAK);
    let mut answers = Vec::new();
    let mut model = LanguageModel::new(|prompt: &Prompt| {
        if options.prompts {
            say!("\n{}\n\n{}", prompt.system, prompt.user);
        }
        let answer = match &options.endpoint {
            Some(url) => ask(url, &options.model, prompt)?,
            None => recorded.next().ok_or("there are no more recorded answers")?.to_owned(),
        };
        say!("model: {}", answer.trim().replace('\n', " / "));
        answers.push(answer.trim().to_owned());
        Ok(answer)
    });
    let mut world = Simulator::new(scene);
    let episode = Run::seeded(0).episode(&mut model, &task, &mut world, &mut |step| match &step.refused {
        Some(why) => say!("{:>4}  {}: {why}", step.step, step.described),
        None => say!("{:>4}  {}", step.step, step.described),
    });
    drop(model);
    say!(
        "{:?} after {} steps{}",
        episode.outcome,
        episode.steps,
        episode.reason.map_or(String::new(), |r| format!(": {r}"))
    );
    match options.record {
        Some(path) => std::fs::write(path, answers.join(BREAK)).map_err(Complaint::new),
        None => Ok(()),
    }
}

/// A kitchen after breakfast, and the room next to it.
fn home() -> Result<SceneGraph, EditError> {
    let mut scene = SceneBuilder::new("breakfast");
    let kitchen = scene.add(Draft::new("kitchen"))?;
    let living = scene.add(Draft::new("living_room"))?;
    scene.add_in(kitchen, Draft::new("fridge"))?;
    scene.add_in(kitchen, Draft::new("kitchen_counter"))?;
    let table = scene.add_in(kitchen, Draft::new("kitchen_table"))?;
    scene.add_on(table, Draft::new("milk"))?;
    let low = scene.add_in(living, Draft::new("coffee_table"))?;
    scene.add_on(low, Draft::new("mug"))?;
    scene.add_in(living, Draft::new("character"))?;
    Ok(scene.build())
}

/// Asks a server; over HTTP 1.0, so that it answers in one piece and hangs up.
fn ask(url: &str, model: &str, prompt: &Prompt) -> Result<String, String> {
    let address = url.strip_prefix("http://").ok_or("an endpoint begins with http://")?;
    let (host, path) = address.split_once('/').unwrap_or((address, ""));
    let body = serde_json::json!({
        "model": model,
        "messages": [
            { "role": "system", "content": prompt.system },
            { "role": "user", "content": prompt.user },
        ],
        "temperature": 0,
        "response_format": { "type": "json_schema", "json_schema": { "name": "action", "schema": prompt.schema } },
    })
    .to_string();
    let fail = |e: std::io::Error| format!("{host}: {e}");
    let mut stream = TcpStream::connect(host).map_err(fail)?;
    stream.set_read_timeout(Some(Duration::from_secs(300))).map_err(fail)?;
    let head = format!(
        "POST /{path} HTTP/1.0\r\nHost: {host}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\r\n",
        body.len()
    );
    stream.write_all((head + &body).as_bytes()).map_err(fail)?;
    let mut answer = String::new();
    stream.read_to_string(&mut answer).map_err(fail)?;
    content(&answer)
}

/// The text of the first choice of an answer.
fn content(answer: &str) -> Result<String, String> {
    let (head, body) = answer.split_once("\r\n\r\n").ok_or("the server's answer has no body")?;
    let status = head.lines().next().unwrap_or_default();
    if status.split(' ').nth(1) != Some("200") {
        return Err(format!("{status}: {body}"));
    }
    let value: serde_json::Value = serde_json::from_str(body).map_err(|e| e.to_string())?;
    let text = value.pointer("/choices/0/message/content").and_then(|t| t.as_str());
    text.map(str::to_owned).ok_or_else(|| format!("no text in the answer: {body}"))
}
