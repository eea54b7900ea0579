//! An HTML page about an episode, which shows the files beside it.

use std::fmt::Write;

use vc_planner::{Step, Summary, Trajectory};

const STYLE: &str = include_str!("page.css");
const PLAYER: &str = include_str!("player.js");

/// An HTML page about an episode in any world, as plain data: it shows the fields that are filled in.
///
/// [`Recorder`](crate::Recorder) writes a page with film, pictures and log; [`Page::from_trajectory`] makes a page with the
/// log from a trajectory in any world, the symbolic simulator or your own. The page is one HTML file that loads
/// nothing from the network, so that it opens from a disk; the pictures it names lie beside it.
///
/// ```
/// use virtualcity::Page;
/// use virtualcity::graph::{Draft, SceneBuilder, Simulator};
/// use virtualcity::planner::{PlannerPolicy, EpisodeOptions, Trajectory};
/// use virtualcity::tasks::Task;
///
/// let mut scene = SceneBuilder::new("flat");
/// let kitchen = scene.add(Draft::new("kitchen"))?;
/// let fridge = scene.add_in(kitchen, Draft::new("fridge"))?;
/// scene.add_in(fridge, Draft::new("milk"))?;
/// scene.add_in(kitchen, Draft::new("character"))?;
/// let task = Task::new("fetch the milk", "Holds(milk)".parse()?);
/// let mut world = Simulator::new(scene.build());
/// let trajectory = Trajectory::record(&EpisodeOptions::default(), &mut PlannerPolicy::best(), &task, &mut world);
///
/// let page = Page::from_trajectory(&trajectory);
/// assert!(page.html().contains("open fridge.2"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Page {
    /// The task's title.
    pub title: String,
    /// The scene's name.
    pub scene: String,
    /// The goal, as text.
    pub goal: String,
    /// The outcome of the episode.
    pub summary: Summary,
    /// Further facts for the first line, such as "5.3 m walked".
    pub facts: Vec<String>,
    /// Every action, in order.
    pub actions: Vec<PageAction>,
    /// The film, if there is one.
    pub film: Option<PageFilm>,
    /// Pictures, in order.
    pub figures: Vec<PageFigure>,
    /// Files for download: name, and content in words.
    pub files: Vec<(String, String)>,
}

/// An action: one row of the page's log.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct PageAction {
    /// The agent that did it, where there are several.
    pub agent: Option<String>,
    /// The action: `open fridge.1`.
    pub action: String,
    /// The reason why the action was refused, if it was.
    pub refused: Option<String>,
    /// The room in which it was done.
    pub room: Option<String>,
    /// The world's time after it, seconds.
    pub seconds: Option<f64>,
    /// Things that were observed for the first time.
    pub found: Vec<String>,
}

/// The film of an episode as pictures, which the page plays.
#[derive(Debug, Clone, PartialEq)]
pub struct PageFilm {
    /// The pictures' files, in order.
    pub pictures: Vec<String>,
    /// Pictures per second.
    pub per_second: u16,
    /// The index of the picture with which each action begins, in the order of [`Page::actions`].
    pub starts: Vec<usize>,
    /// The pictures that show some actions best: index of the action, index of the picture, from zero.
    pub moments: Vec<(usize, usize)>,
    /// One sentence about the film's content.
    pub caption: String,
}

/// A picture of the page.
#[derive(Debug, Clone, PartialEq)]
pub struct PageFigure {
    /// The picture's file.
    pub file: String,
    /// The heading above it.
    pub heading: String,
    /// One sentence below it.
    pub caption: String,
}

impl Page {
    /// The caption of a picture that [`Belief::to_svg`](vc_planner::Belief::to_svg) draws.
    pub const BELIEF: &str = "The things that the goal is about: green, where it has seen them; blue, where they may \
        be, the darker the likelier, with a dot where it supposed them.";

    /// A page about an episode without a log: only its summary.
    pub fn new(title: &str, scene: &str, goal: &str, summary: Summary) -> Self {
        Self {
            title: title.into(),
            scene: scene.into(),
            goal: goal.into(),
            summary,
            facts: Vec::new(),
            actions: Vec::new(),
            film: None,
            figures: Vec::new(),
            files: Vec::new(),
        }
    }

    /// A page about a trajectory, with its log.
    pub fn from_trajectory(trajectory: &Trajectory) -> Self {
        let Trajectory { header, steps, summary } = trajectory;
        let actions = steps.iter().map(PageAction::of).collect();
        Self { actions, ..Self::new(&header.task, &header.scene, &header.goal.to_string(), summary.clone()) }
    }

    /// Adds a picture below the others.
    #[must_use]
    pub fn figure(mut self, file: &str, heading: &str, caption: &str) -> Self {
        let [file, heading, caption] = [file, heading, caption].map(str::to_owned);
        self.figures.push(PageFigure { file, heading, caption });
        self
    }

    /// Adds a file for download.
    #[must_use]
    pub fn file(mut self, name: &str, about: &str) -> Self {
        self.files.push((name.into(), about.into()));
        self
    }

    /// The page as HTML.
    pub fn html(&self) -> String {
        let title = escaped(&self.title);
        format!(
            "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\
             <meta name=\"viewport\" content=\"width=device-width\"><title>{title}</title>\n<style>\n{STYLE}</style></head>\n\
             <body>\n<header><h1>{title}</h1>\n{head}</header>\n{film}{figures}{log}{files}</body></html>\n",
            head = self.head(),
            film = self.film.as_ref().map(|film| self.player(film)).unwrap_or_default(),
            figures = self.figures.iter().map(PageFigure::html).collect::<String>(),
            log = self.log(),
            files = self.downloads(),
        )
    }

    fn head(&self) -> String {
        let Summary { outcome, score, steps, reason } = &self.summary;
        let outcome = format!("{outcome:?}");
        let facts: String = self.facts.iter().map(|fact| format!(", {}", escaped(fact))).collect();
        let reason = reason.as_deref().map(|why| format!("<p>{}</p>\n", escaped(why))).unwrap_or_default();
        format!(
            "<p><b class=\"{class}\">{outcome}</b> {steps} actions{facts}; {score:.0}% of the goal holds.</p>\n{reason}\
             <p class=\"small\">{scene}: <code>{goal}</code></p>\n",
            class = outcome.to_lowercase(),
            score = 100.0 * score,
            scene = escaped(&self.scene),
            goal = escaped(&self.goal),
        )
    }

    /// The film with its caption and controls, and the strip of pictures below.
    fn player(&self, film: &PageFilm) -> String {
        let Some(first) = film.pictures.first() else { return String::new() };
        let captions: Vec<String> = self.actions.iter().enumerate().map(|(i, a)| a.caption(i)).collect();
        let data = serde_json::json!({
            "pictures": film.pictures, "rate": film.per_second.max(1), "starts": film.starts, "captions": captions,
        });
        // Text in the data must not end the script element.
        let data = data.to_string().replace('<', "\\u003c");
        let shown = film.moments.iter().filter_map(|(action, picture)| {
            let (file, caption) = (film.pictures.get(*picture)?, captions.get(*action)?);
            let (file, caption) = (escaped(file), escaped(caption));
            Some(format!(
                "<figure data-at=\"{picture}\"><img src=\"{file}\" alt=\"\"><figcaption>{caption}</figcaption></figure>\n"
            ))
        });
        format!(
            "<section id=\"film\"><img id=\"screen\" src=\"{first}\" alt=\"film\">\n<p id=\"caption\"></p>\n\
             <p id=\"controls\"><button id=\"play\">pause</button><input id=\"seek\" type=\"range\" min=\"0\" \
             max=\"{last}\" value=\"0\"></p>\n<p class=\"small\">{about}</p></section>\n\
             <section id=\"strip\">\n{shown}</section>\n<script>const film = {data};\n{PLAYER}</script>\n",
            first = escaped(first),
            last = film.pictures.len() - 1,
            about = escaped(&film.caption),
            shown = shown.collect::<String>(),
        )
    }

    fn log(&self) -> String {
        if self.actions.is_empty() {
            return String::new();
        }
        let has = |column: fn(&PageAction) -> bool| self.actions.iter().any(column);
        let columns = Columns {
            time: has(|a| a.seconds.is_some()),
            agent: has(|a| a.agent.is_some()),
            room: has(|a| a.room.is_some()),
            found: has(|a| !a.found.is_empty()),
        };
        let rows: String = self.actions.iter().enumerate().map(|(i, a)| a.row(i, &columns)).collect();
        format!("<section><h2>Log</h2>\n<table id=\"log\">\n{}{rows}</table></section>\n", columns.head())
    }

    fn downloads(&self) -> String {
        if self.files.is_empty() {
            return String::new();
        }
        let mut list = String::from("<section><h2>Files</h2>\n<ul>\n");
        for (name, about) in &self.files {
            let (name, about) = (escaped(name), escaped(about));
            let _ = writeln!(list, "<li><a href=\"{name}\">{name}</a> {about}</li>");
        }
        list + "</ul></section>\n"
    }
}

/// The columns that the log has besides number and action.
struct Columns {
    time: bool,
    agent: bool,
    room: bool,
    found: bool,
}

impl Columns {
    fn head(&self) -> String {
        let all = [(true, ""), (self.time, "time"), (self.agent, "agent"), (true, "action"), (self.room, "room")];
        let all = all.into_iter().chain([(self.found, "seen for the first time")]);
        let cells: String = all.filter(|(has, _)| *has).map(|(_, name)| format!("<th>{name}</th>")).collect();
        format!("<tr>{cells}</tr>\n")
    }
}

impl PageAction {
    fn of(step: &Step) -> Self {
        Self {
            action: step.described.clone(),
            refused: step.refused.clone(),
            room: step.room.clone(),
            found: step.found.clone(),
            ..Self::default()
        }
    }

    pub(crate) fn caption(&self, index: usize) -> String {
        let agent = self.agent.as_deref().map(|who| format!("{who}: ")).unwrap_or_default();
        let refused = if self.refused.is_some() { " (could not)" } else { "" };
        format!("{}. {agent}{}{refused}", index + 1, self.action)
    }

    fn row(&self, index: usize, columns: &Columns) -> String {
        let why = self.refused.as_deref().map(|why| format!("<br><i>{}</i>", escaped(why))).unwrap_or_default();
        let time = self.seconds.map(|s| format!("{s:.1} s")).unwrap_or_default();
        let text = |text: &Option<String>| escaped(text.as_deref().unwrap_or_default());
        let cells = [
            (true, (index + 1).to_string()),
            (columns.time, time),
            (columns.agent, text(&self.agent)),
            (true, format!("{}{why}", escaped(&self.action))),
            (columns.room, text(&self.room)),
            (columns.found, escaped(&few(&self.found))),
        ];
        let cells: String = cells.iter().filter(|(has, _)| *has).map(|(_, c)| format!("<td>{c}</td>")).collect();
        format!("<tr data-action=\"{index}\">{cells}</tr>\n")
    }
}

impl PageFigure {
    fn html(&self) -> String {
        let [file, heading, caption] = [&self.file, &self.heading, &self.caption].map(|text| escaped(text));
        format!(
            "<section><h2>{heading}</h2>\n<img src=\"{file}\" alt=\"{heading}\">\n<p class=\"small\">{caption}</p></section>\n"
        )
    }
}

/// The first items of a list, and the number of the remaining ones.
fn few(items: &[String]) -> String {
    const SHOWN: usize = 6;
    match items.len() {
        n if n <= SHOWN => items.join(", "),
        n => format!("{} and {} more", items[..SHOWN].join(", "), n - SHOWN),
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
