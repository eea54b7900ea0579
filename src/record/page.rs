//! The page that shows a record.

use std::fmt::Write;

use vc_planner::Episode;
use vc_tasks::Task;

const STYLE: &str = "body{font:16px/1.5 system-ui,sans-serif;max-width:60em;margin:2em auto;padding:0 1em}\
    img{max-width:100%;display:block;margin:.5em 0}td{padding:0 1em 0 0}";
const MODALITIES: &str = "<h2>The six modalities</h2><p>Colours, instances, classes; depth, optical flow, boxes and \
    masks: from the agent's eyes, and from a corner of the room.</p><img src=\"eyes.png\"><img src=\"corner.png\">";
const BELIEF: &str = "<h2>What it believed in the end</h2><p>Of the things that the goal is about: green, where it \
    has seen them; blue, where they may be, the darker the likelier, with a dot where it supposed them.</p>\
    <img src=\"belief.svg\">";

/// What the page says.
pub(super) struct Page<'a> {
    pub(super) home: &'a str,
    pub(super) task: &'a Task,
    pub(super) episode: &'a Episode,
    /// Every action, and the home's time after it, seconds.
    pub(super) actions: &'a [(String, f64)],
    pub(super) has_modalities: bool,
    pub(super) has_belief: bool,
}

impl Page<'_> {
    pub(super) fn html(&self) -> String {
        let mut rows = String::new();
        for (number, (action, time)) in self.actions.iter().enumerate() {
            let _ = writeln!(rows, "<tr><td>{}</td><td>{}</td><td>{time:.1} s</td></tr>", number + 1, escaped(action));
        }
        let reason = self.episode.reason.as_deref().map(|r| format!("<p>{}</p>", escaped(r))).unwrap_or_default();
        format!(
            "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>{title}</title><style>{STYLE}</style>\
             <h1>{title}</h1><p>{home}: <code>{goal}</code></p>\
             <p><b>{outcome:?}</b>: {count} actions, {score:.0}% of the goal holds.</p>{reason}\
             <h2>The film</h2><p>From the agent's eyes and from a corner of the room, at twice the speed.</p>\
             <img src=\"film.png\"><h2>The way</h2><p>From blue to red.</p><img src=\"map.png\">{modalities}\
             <h2>The end</h2><img src=\"end.png\">{belief}\
             <h2>What it did</h2><table>{rows}</table><p><a href=\"trajectory.jsonl\">trajectory.jsonl</a></p></html>\n",
            title = escaped(&self.task.title),
            home = escaped(self.home),
            goal = escaped(&self.task.goal.to_string()),
            outcome = self.episode.outcome,
            count = self.actions.len(),
            score = 100.0 * self.episode.score,
            modalities = if self.has_modalities { MODALITIES } else { "" },
            belief = if self.has_belief { BELIEF } else { "" },
        )
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
