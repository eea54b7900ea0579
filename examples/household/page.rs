//! The folder: pictures, the map with the way, and a page that shows them.

use std::fmt::Write;
use std::path::Path;

use nalgebra::{Point2, Point3};
use virtualcity::render::picture::{self, Picture};
use virtualcity::render::{Camera, Modality};
use virtualcity::{Environment, Viewpoint};

use crate::film::Film;
use crate::physical::Story;
use crate::support::Complaint;

/// Size of the map, pixels.
const MAP: (u32, u32) = (960, 720);
/// Colours of the way from its beginning to its end.
const WAY: [[f32; 3]; 2] = [[40.0, 110.0, 255.0], [255.0, 60.0, 30.0]];

/// Writes everything.
pub(crate) fn write(folder: &Path, story: &Story, film: &Film, home: &Environment) -> Result<(), Complaint> {
    save(folder, "map.png", &picture::png(&map(home, story)?).map_err(Complaint::new)?)?;
    if !film.pictures().is_empty() {
        save(folder, "film.png", &picture::apng(film.pictures(), film.rate()).map_err(Complaint::new)?)?;
    }
    if let Some([eyes, corner]) = &film.modalities {
        save(folder, "eyes.png", &picture::png(eyes).map_err(Complaint::new)?)?;
        save(folder, "corner.png", &picture::png(corner).map_err(Complaint::new)?)?;
    }
    if let Some(last) = &film.last {
        save(folder, "end.png", &picture::png(last).map_err(Complaint::new)?)?;
    }
    if let Some(belief) = &story.belief {
        save(folder, "belief.svg", belief.as_bytes())?;
    }
    save(folder, "strip.png", &picture::png(&strip(film)).map_err(Complaint::new)?)?;
    save(folder, "index.html", page(story, film).as_bytes())
}

fn save(folder: &Path, name: &str, bytes: &[u8]) -> Result<(), Complaint> {
    let path = folder.join(name);
    std::fs::write(&path, bytes).map_err(|e| Complaint::new(format!("{}: {e}", path.display())))
}

/// A picture of each action, eight at most: of when the hand is at what it is done to.
fn strip(film: &Film) -> Picture {
    let starts: Vec<usize> = film.titles().iter().map(|(at, _)| *at).chain([film.len()]).collect();
    let every = film.titles().len().div_ceil(8).max(1);
    let moment = |pair: &[usize]| pair[0] + (pair[1] - pair[0]) * 4 / 5;
    let shown = starts.windows(2).step_by(every).filter_map(|pair| film.pictures().get(moment(pair))).cloned();
    Picture::sheet(&shown.collect::<Vec<_>>(), 2, 4)
}

/// The home from above, and the way.
fn map(home: &Environment, story: &Story) -> Result<Picture, Complaint> {
    let frame = home.render(Viewpoint::Overhead, Modality::Rgb, MAP.0, MAP.1).map_err(Complaint::new)?;
    let camera = home.camera(Viewpoint::Overhead, MAP.0, MAP.1).map_err(Complaint::new)?;
    let mut picture = picture::rgb(&frame);
    let (count, level) = (story.way.len().max(1) as f32, home.floor().plan().level);
    for (i, pair) in story.way.windows(2).enumerate() {
        let share = i as f32 / count;
        let colour = [0, 1, 2].map(|c: usize| (WAY[0][c] * (1.0 - share) + WAY[1][c] * share) as u8);
        line(&mut picture, &camera, (pair[0], pair[1]), level, colour);
    }
    Ok(picture)
}

fn line(picture: &mut Picture, camera: &Camera, (a, b): (Point2<f32>, Point2<f32>), level: f32, colour: [u8; 3]) {
    let steps = ((b - a).norm() / 0.005).ceil().max(1.0) as usize;
    for step in 0..=steps {
        let p = a + (b - a) * (step as f32 / steps as f32);
        let Some(seen) = camera.project(&Point3::new(p.x, p.y, level)) else { continue };
        for (dx, dy) in (-2..=2).flat_map(|dx| (-2..=2).map(move |dy| (dx, dy))).filter(|(x, y)| x * x + y * y < 6) {
            let (x, y) = (seen.x as i32 + dx, seen.y as i32 + dy);
            if (0..picture.width as i32).contains(&x) && (0..picture.height as i32).contains(&y) {
                picture.pixels[y as usize * picture.width + x as usize] = colour;
            }
        }
    }
}

fn page(story: &Story, film: &Film) -> String {
    let mut rows = String::new();
    for (number, (action, time)) in story.actions.iter().enumerate() {
        let _ = writeln!(rows, "<tr><td>{}</td><td>{}</td><td>{time:.1} s</td></tr>", number + 1, escaped(action));
    }
    let reason = story.reason.as_deref().map(|r| format!("<p>{}</p>", escaped(r))).unwrap_or_default();
    let modalities = match film.modalities {
        Some(_) => concat!(
            "<h2>The six modalities</h2><p>Colours, instances, classes; depth, optical flow, boxes and masks: from the ",
            "agent's eyes, and from a corner of the room.</p><img src=\"eyes.png\"><img src=\"corner.png\">"
        ),
        None => "",
    };
    let belief = match story.belief {
        Some(_) => concat!(
            "<h2>What it believed in the end</h2><p>Of the things that the goal is about: green, where it has seen ",
            "them; blue, where they may be, the darker the likelier, with a dot where it supposed them.</p>",
            "<img src=\"belief.svg\">"
        ),
        None => "",
    };
    format!(
        "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>{title}</title>\
         <style>body{{font:16px/1.5 system-ui,sans-serif;max-width:60em;margin:2em auto;padding:0 1em}}\
         img{{max-width:100%;display:block;margin:.5em 0}}td{{padding:0 1em 0 0}}</style>\
         <h1>{title}</h1><p>{home}: <code>{goal}</code></p>\
         <p><b>{outcome:?}</b>: {count} actions, {score:.0}% of the goal holds.</p>{reason}\
         <h2>The film</h2><p>From the agent's eyes and from a corner of the room, at twice the speed.</p>\
         <img src=\"film.png\"><h2>The way</h2><p>From blue to red.</p><img src=\"map.png\">{modalities}\
         <h2>The end</h2><img src=\"end.png\">\
         {belief}<h2>What it did</h2><table>{rows}</table><p><a href=\"trajectory.jsonl\">trajectory.jsonl</a></p></html>\n",
        title = escaped(&story.task.title),
        home = escaped(&story.home),
        goal = escaped(&story.task.goal.to_string()),
        outcome = story.outcome,
        count = story.actions.len(),
        score = 100.0 * story.score,
    )
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}
