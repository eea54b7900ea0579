//! Our own file format for tasks, as JSON.
//!
//! ```
//! use vc_tasks::format::json;
//! let text = r#"{"virtualcity_tasks": 1, "tasks": [
//!     {"title": "breakfast", "goal": "On(apple, table) & did sit(chair)", "step_limit": 100}]}"#;
//! let tasks = json::read(text)?;
//! assert_eq!(tasks[0].step_limit, 100);
//! assert_eq!(json::read(&json::write(&tasks))?, tasks);
//! # Ok::<(), vc_tasks::format::ReadError>(())
//! ```

use serde::{Deserialize, Serialize};

use super::ReadError;
use super::error::from_json;
use crate::Task;

const FORMAT: &str = "task file";

/// The version that is written; it and earlier ones are read.
pub const VERSION: u32 = 1;

#[derive(Deserialize)]
struct File {
    #[serde(rename = "virtualcity_tasks")]
    version: u32,
    tasks: Vec<Task>,
}

#[derive(Serialize)]
struct Written<'t> {
    #[serde(rename = "virtualcity_tasks")]
    version: u32,
    tasks: &'t [Task],
}

/// Reads tasks.
///
/// # Errors
/// [`ReadError`] if the text is not such JSON, a goal cannot be parsed, or the version is newer.
pub fn read(text: &str) -> Result<Vec<Task>, ReadError> {
    let file: File = from_json(FORMAT, text)?;
    if file.version > VERSION {
        let at = text.find("virtualcity_tasks").unwrap_or(0);
        let found = format!("version {}", file.version);
        return Err(ReadError::at(FORMAT, text, at, format!("a version up to {VERSION}"), found));
    }
    Ok(file.tasks)
}

/// Writes tasks.
pub fn write(tasks: &[Task]) -> String {
    // Goals are written as text and numbers as numbers: this cannot fail.
    serde_json::to_string_pretty(&Written { version: VERSION, tasks }).unwrap_or_default()
}
