//! Lets a language model on a local server tidy up after breakfast.
//!
//! `cargo run --release --features endpoint --example language_endpoint -- --url URL` asks a server with OpenAI's
//! interface (llama.cpp, Ollama, vLLM ...) for each action, by default the one at
//! `http://127.0.0.1:8080/v1/chat/completions`; `--record FILE` stores the answers in the form that the example
//! `language_model` reads. It uses plain HTTP, so it is only for one's own machines.

#[path = "support/breakfast.rs"]
mod breakfast;
mod support;

use std::io::{Read, Write};
use std::net::TcpStream;
use std::path::PathBuf;
use std::time::Duration;

use breakfast::{BREAK, tidy_up};
use clap::Parser;
use support::Complaint;
use vc_planner::language::Prompt;

/// Lets a language model on a local server tidy up after breakfast.
#[derive(Parser)]
struct Options {
    /// The server, `http://HOST:PORT/PATH`.
    #[arg(long, default_value = "http://127.0.0.1:8080/v1/chat/completions")]
    url: String,
    /// The model's name, for servers with several models.
    #[arg(long, default_value = "default")]
    model: String,
    /// The file in which the answers are stored.
    #[arg(long)]
    record: Option<PathBuf>,
    /// Show the prompts.
    #[arg(long)]
    prompts: bool,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let answers = tidy_up(options.prompts, |prompt| ask(&options.url, &options.model, prompt))?;
    match options.record {
        Some(path) => std::fs::write(path, answers.join(BREAK)).map_err(Complaint::new),
        None => Ok(()),
    }
}

/// Timeout for one answer of the model.
const PATIENCE: Duration = Duration::from_secs(300);

/// Longest answer that is accepted, bytes.
const LONGEST: u64 = 1 << 24;

/// Asks a server, over HTTP 1.0, so that it answers in one piece and closes the connection.
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
    stream.set_read_timeout(Some(PATIENCE)).map_err(fail)?;
    let head = format!(
        "POST /{path} HTTP/1.0\r\nHost: {host}\r\nContent-Type: application/json\r\nContent-Length: {}\r\n\r\n",
        body.len()
    );
    stream.write_all((head + &body).as_bytes()).map_err(fail)?;
    let mut answer = String::new();
    stream.take(LONGEST).read_to_string(&mut answer).map_err(fail)?;
    content(&answer)
}

/// The text of the first choice in a response.
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

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests stop where something is wrong")]
mod tests {
    use std::net::TcpListener;
    use std::thread::JoinHandle;

    use super::*;

    fn prompt() -> Prompt {
        let (system, user) = ("be brief".into(), "what now?".into());
        Prompt { system, user, actions: vec!["walk fridge.3".into()], schema: serde_json::json!({"type": "object"}) }
    }

    /// A server that takes one request, gives one answer and closes; returns its URL, and the request.
    fn serve(answer: String) -> (String, JoinHandle<String>) {
        let listener = TcpListener::bind("127.0.0.1:0").unwrap();
        let url = format!("http://{}/v1/chat/completions", listener.local_addr().unwrap());
        let request = std::thread::spawn(move || {
            let (mut stream, _) = listener.accept().unwrap();
            let request = read_request(&mut stream);
            stream.write_all(answer.as_bytes()).unwrap();
            request
        });
        (url, request)
    }

    /// Reads a head, and a body of the length that the head gives.
    fn read_request(stream: &mut TcpStream) -> String {
        let (mut text, mut buffer) = (String::new(), [0; 1024]);
        loop {
            let number = stream.read(&mut buffer).unwrap();
            assert_ne!(number, 0, "the request ends too early: {text}");
            text.push_str(std::str::from_utf8(&buffer[..number]).unwrap());
            let Some((head, body)) = text.split_once("\r\n\r\n") else { continue };
            let length = head.lines().find_map(|l| l.strip_prefix("Content-Length: ")).unwrap();
            if body.len() == length.parse::<usize>().unwrap() {
                return text;
            }
        }
    }

    fn reply(status: &str, body: &str) -> String {
        format!("HTTP/1.0 {status}\r\nContent-Type: application/json\r\n\r\n{body}")
    }

    #[test]
    fn a_server_is_asked_and_its_answer_read() {
        let body = r#"{"choices": [{"message": {"role": "assistant", "content": "walk fridge.3"}}]}"#;
        let (url, request) = serve(reply("200 OK", body));
        assert_eq!(ask(&url, "small", &prompt()), Ok("walk fridge.3".into()));
        let request = request.join().unwrap();
        let (head, body) = request.split_once("\r\n\r\n").unwrap();
        assert!(head.starts_with("POST /v1/chat/completions HTTP/1.0\r\nHost: 127.0.0.1:"), "{head}");
        let body: serde_json::Value = serde_json::from_str(body).unwrap();
        assert_eq!(body["model"], "small");
        assert_eq!(body["messages"][0]["content"], "be brief");
        assert_eq!(body["messages"][1]["content"], "what now?");
        assert_eq!(body["response_format"]["json_schema"]["schema"], prompt().schema);
    }

    #[test]
    fn what_a_server_refuses_is_told() {
        let (url, request) = serve(reply("503 Service Unavailable", "loading"));
        assert_eq!(ask(&url, "small", &prompt()), Err("HTTP/1.0 503 Service Unavailable: loading".into()));
        request.join().unwrap();
        assert!(ask("https://127.0.0.1/", "small", &prompt()).unwrap_err().contains("http://"));
        // Bound and released, so that no server listens there.
        let free = TcpListener::bind("127.0.0.1:0").unwrap().local_addr().unwrap();
        assert!(ask(&format!("http://{free}/"), "small", &prompt()).unwrap_err().starts_with(&free.to_string()));
    }

    #[test]
    fn answers_without_text_are_told() {
        assert_eq!(content("nonsense"), Err("the server's answer has no body".into()));
        assert!(content(&reply("200 OK", "{}")).unwrap_err().starts_with("no text in the answer"));
        assert!(content(&reply("200 OK", "{")).is_err());
        assert_eq!(content(&reply("200 OK", r#"{"choices": [{"message": {"content": "done"}}]}"#)), Ok("done".into()));
    }
}
