//! A home in a window, seen through the eyes of its agent.
//!
//! `cargo run --release --features play --example play -- --seed 42` opens it. W, A, S and D walk, with shift
//! they run; the space bar jumps; the mouse turns the view, continuously at the edge of the window. The object
//! at the crosshair is named below it; a click performs the possible action: take, open, close, switch, sit;
//! with an object in the hand, put it there. The right button lets go of it. Keys 1 to 6 show colours, nodes,
//! classes, depth, optical flow, and boxes with masks. Escape quits.
//!
//! `--frames N` quits after N frames, and `--picture FILE` writes the last one, for a test under Xvfb,
//! `xvfb-run cargo run ...`.

mod game;
#[path = "../support/seed.rs"]
mod seed;
#[path = "../support/mod.rs"]
mod support;
mod text;

use std::path::PathBuf;
use std::time::{Duration, Instant};

use clap::Parser;
use game::{Game, Hands, Wish};
use minifb::{Key, MouseButton, MouseMode, Scale, Window, WindowOptions};
use support::{Complaint, say};
use virtualcity::Environment;
use virtualcity::graph::clock::Durations;
use virtualcity::render::picture::{self, Picture};

/// Radians per pixel of mouse motion.
const TURN: f32 = 0.005;
/// Radians per second while the mouse is at the edge.
const EDGE: f32 = 1.8;
/// Largest number of ticks per picture, when drawing is slow.
const CATCH_UP: u32 = 8;

/// A home in a window.
#[derive(Parser)]
struct Options {
    /// The home's seed.
    #[arg(long, default_value_t = 42, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// Width of the picture, pixels; its height is three quarters of that.
    #[arg(long, default_value_t = 480)]
    width: u32,
    /// Quit after this number of pictures.
    #[arg(long)]
    frames: Option<u32>,
    /// Write the last picture to this file, as PNG.
    #[arg(long)]
    picture: Option<PathBuf>,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let (width, height) = game::size(options.width.clamp(64, 1920));
    let settings = WindowOptions { scale: Scale::X2, ..WindowOptions::default() };
    let mut window = Window::new("VirtualCity", width as usize, height as usize, settings)
        .map_err(|e| Complaint::new(format!("no window: {e} (without a display, use xvfb-run)")))?;
    window.set_target_fps(60);
    let wait = |window: &mut Window, words: &str| present(window, &text::notice(width, height, words));
    let name = format!("apartment/{}", options.seed);
    wait(&mut window, &format!("making {name} ...")).map_err(Complaint::new)?;
    let mut game =
        Game::new(Environment::builder(&name).durations(Durations::default()).make().map_err(Complaint::new)?, width);
    wait(&mut window, "finding its light ...").map_err(Complaint::new)?;
    let (mut mouse, mut clock, mut pictures) = (window.get_mouse_pos(MouseMode::Pass), Clock::default(), 0);
    let mut last = game.picture()?;
    let wanted = options.frames.unwrap_or(u32::MAX);
    while window.is_open() && !window.is_key_down(Key::Escape) && pictures < wanted {
        let hands = hands(&window, &mut mouse, (width as f32, height as f32));
        // Show pictures during the action of a click.
        game.act(&hands, |show| drop(present(&mut window, show)))?;
        for _ in 0..clock.ticks(game.dt()) {
            game.tick(&hands);
        }
        last = game.picture()?;
        present(&mut window, &last).map_err(Complaint::new)?;
        pictures += 1;
    }
    say!("{pictures} pictures, {:.1} a second; {}", clock.rate(pictures), game.words());
    if let Some(path) = &options.picture {
        let png = picture::png(&last).map_err(Complaint::new)?;
        virtualcity::files::write(path, png)?;
        say!("the last one is {}", path.display());
    }
    Ok(())
}

/// Displays a picture.
fn present(window: &mut Window, picture: &Picture) -> Result<(), minifb::Error> {
    let packed = |[r, g, b]: &[u8; 3]| u32::from_be_bytes([0, *r, *g, *b]);
    let pixels: Vec<u32> = picture.pixels.iter().map(packed).collect();
    window.update_with_buffer(&pixels, picture.width, picture.height)
}

/// The input from keyboard and mouse.
fn hands(window: &Window, mouse: &mut Option<(f32, f32)>, (width, height): (f32, f32)) -> Hands {
    let down = |key| f32::from(u8::from(window.is_key_down(key)));
    let now = window.get_mouse_pos(MouseMode::Pass);
    let moved = now.zip(*mouse).map_or((0.0, 0.0), |(n, m)| (n.0 - m.0, n.1 - m.1));
    // When the mouse enters or leaves the window, its position jumps.
    let moved = if moved.0.hypot(moved.1) < width / 4.0 { moved } else { (0.0, 0.0) };
    *mouse = now;
    let beyond = |at: f32, size: f32| f32::from(i8::from(at >= size - 1.0) - i8::from(at <= 1.0));
    let at_edge = now.filter(|_| window.is_active()).map_or(0.0, |n| beyond(n.0, width));
    let numbers = [Key::Key1, Key::Key2, Key::Key3, Key::Key4, Key::Key5, Key::Key6];
    let wish = match (window.get_mouse_down(MouseButton::Left), window.get_mouse_down(MouseButton::Right)) {
        (true, _) => Some(Wish::Act),
        (_, true) => Some(Wish::LetGo),
        _ => None,
    };
    Hands {
        ahead: down(Key::W) - down(Key::S),
        left: down(Key::A) - down(Key::D),
        runs: window.is_key_down(Key::LeftShift),
        jumps: window.is_key_down(Key::Space),
        turn: -moved.0 * TURN - at_edge * EDGE / 60.0,
        tilt: -moved.1 * TURN * f32::from(u8::from(now.is_some_and(|n| n.1 >= 0.0 && n.1 <= height))),
        shows: numbers.iter().position(|key| window.is_key_down(*key)),
        wish,
    }
}

/// Number of ticks that are due since the last picture.
#[derive(Default)]
struct Clock {
    start: Option<Instant>,
    owed: Duration,
    last: Option<Instant>,
}

impl Clock {
    fn ticks(&mut self, dt: f32) -> u32 {
        let now = Instant::now();
        self.start.get_or_insert(now);
        self.owed += self.last.map_or(Duration::ZERO, |last| now - last);
        self.last = Some(now);
        let tick = Duration::from_secs_f32(dt);
        let due = (self.owed.as_secs_f32() / dt) as u32;
        self.owed = if due > CATCH_UP { Duration::ZERO } else { self.owed - tick * due };
        due.min(CATCH_UP)
    }

    fn rate(&self, pictures: u32) -> f32 {
        let passed = self.start.zip(self.last).map_or(0.0, |(a, b)| (b - a).as_secs_f32());
        pictures as f32 / passed.max(1e-3)
    }
}
