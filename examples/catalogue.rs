//! Contact sheets of generated objects.
//!
//! `cargo run --release --example catalogue -- --out out/catalogue` writes PNG sheets of objects by category,
//! and a list of them as JSON Lines. `--class chair --open` shows one class, with doors and drawers open;
//! `--per-class 4` shows at most four of each; `--gltf` also writes each object as a model.

#[path = "support/seed.rs"]
mod seed;
mod support;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::Parser;
use indicatif::ProgressBar;
use support::{Complaint, say};
use vc_graph::{AssetLibrary, ClassTable, Pose, Seed, Word, did_you_mean};
use virtualcity::gltf;
use virtualcity::procgen::picture::{Anchor, Canvas, Colour, Ink, SketchView, sketch};
use virtualcity::shapes::catalogue::Instance;
use virtualcity::shapes::material;
use virtualcity::shapes::object::{Generator, Realm, generator, generators};

/// Contact sheets of generated objects.
#[derive(Parser)]
struct Options {
    /// The output folder; it is created if it does not exist.
    #[arg(long, default_value = "out/catalogue")]
    out: PathBuf,
    /// Only these classes.
    #[arg(long = "class")]
    classes: Vec<String>,
    /// At most this number of objects of each class.
    #[arg(long, value_parser = at_least_one)]
    per_class: Option<usize>,
    /// Open doors and drawers.
    #[arg(long)]
    open: bool,
    /// Also write each object as glTF.
    #[arg(long)]
    gltf: bool,
    /// The seed from which the objects are generated.
    #[arg(long, default_value_t = 0, allow_negative_numbers = true, value_parser = seed::seed)]
    seed: u64,
    /// Width of a tile, pixels.
    #[arg(long, default_value_t = 200)]
    tile: usize,
    /// Tiles per row.
    #[arg(long, default_value_t = 8)]
    columns: usize,
    /// Rows of tiles per sheet.
    #[arg(long, default_value_t = 9)]
    rows: usize,
}

/// Parses a number of objects.
fn at_least_one(text: &str) -> Result<usize, String> {
    text.parse().ok().filter(|number| *number > 0).ok_or_else(|| "a whole number from 1 up".to_owned())
}

/// One object on a sheet.
struct Tile {
    instance: Instance,
    /// The number of objects of its class; the first of a class shows the name.
    of: usize,
}

fn main() -> Result<(), Complaint> {
    let options = Options::parse();
    let (tile, columns, rows) = (options.tile, options.columns, options.rows);
    if !(40..=1000).contains(&tile) || !(1..=30).contains(&columns) || !(1..=30).contains(&rows) {
        return Err(Complaint::new("--tile is from 40 to 1000, --columns and --rows from 1 to 30"));
    }
    virtualcity::files::create_folder(&options.out)?;
    let groups = groups(&options)?;
    let list = options.out.join("objects.jsonl");
    let mut lines = String::new();
    let total: usize = groups.values().flatten().map(|g| shown(&options, g)).sum();
    let progress = ProgressBar::new(total as u64);
    let library = material::library();
    for (name, members) in &groups {
        let tiles = tiles(&options, members);
        for tile in &tiles {
            lines.push_str(&format!("{}\n", line(tile)));
            if options.gltf {
                model(tile, &library, &options.out)?;
            }
        }
        for (page, tiles) in tiles.chunks(columns * rows).enumerate() {
            let path = options.out.join(format!("{name}_{:02}.png", page + 1));
            sheet(&options, name, tiles, &library, &path)?;
            progress.inc(tiles.len() as u64);
        }
    }
    virtualcity::files::write(&list, lines)?;
    progress.finish_and_clear();
    say!("{total} objects of {} classes in {}", groups.values().map(Vec::len).sum::<usize>(), options.out.display());
    Ok(())
}

/// The requested generators, by category.
fn groups(options: &Options) -> Result<BTreeMap<String, Vec<&'static Generator>>, Complaint> {
    let table = ClassTable::builtin();
    let find = |name: &String| {
        let near = || did_you_mean(name, generators().map(|g| g.class));
        generator(name).ok_or_else(|| Complaint::new(format!("no generator makes `{name}`{}", near())))
    };
    let asked = match options.classes.is_empty() {
        true => generators().collect(),
        false => options.classes.iter().map(find).collect::<Result<Vec<_>, _>>()?,
    };
    let mut groups = BTreeMap::new();
    for generator in asked {
        let realm = if generator.realm == Realm::Outdoor { "outdoor" } else { "indoor" };
        let category = table.get(generator.class).map_or("other", |c| c.category.as_str());
        groups.entry(format!("{realm}_{category}")).or_insert_with(Vec::new).push(generator);
    }
    Ok(groups)
}

fn shown(options: &Options, generator: &Generator) -> usize {
    options.per_class.map_or(generator.instances, |most| generator.instances.min(most))
}

fn tiles(options: &Options, members: &[&'static Generator]) -> Vec<Tile> {
    let of = |g: &'static Generator| {
        let count = shown(options, g);
        (0..count).map(move |i| Tile { instance: g.instance(Seed(options.seed), i), of: count })
    };
    members.iter().copied().flat_map(of).collect()
}

/// The list entry of an object.
fn line(tile: &Tile) -> serde_json::Value {
    let object = &tile.instance.object;
    serde_json::json!({
        "class": object.class,
        "index": tile.instance.index,
        "name": &*object.asset.name,
        "size": <[f32; 3]>::from(object.size()),
        "triangles": triangles(tile),
        "parts": object.asset.parts.len(),
        "surfaces": object.asset.surfaces.len(),
        "shape": object.shape_key().to_string(),
    })
}

fn triangles(tile: &Tile) -> usize {
    let object = &tile.instance.object;
    let tolerance = object.size().norm() * 0.002;
    object.asset.parts.iter().map(|p| p.shape.mesh(tolerance).triangles.len()).sum()
}

fn model(tile: &Tile, library: &AssetLibrary, folder: &Path) -> Result<(), Complaint> {
    let Instance { object, index, .. } = &tile.instance;
    let glb = gltf::asset_of_class(object.class, &object.asset, library).map_err(Complaint::new)?;
    let path = folder.join(format!("{}_{:03}.glb", object.class, index + 1));
    Ok(virtualcity::files::write(&path, glb)?)
}

fn sheet(options: &Options, title: &str, tiles: &[Tile], library: &AssetLibrary, path: &Path) -> Result<(), Complaint> {
    let (wide, label) = (options.tile, 36);
    let (tall, head) = (wide * 7 / 8 + label, 34);
    let rows = tiles.len().div_ceil(options.columns);
    let (width, height) = (options.columns * wide, head + rows * tall);
    let place = |i: usize| (i % options.columns * wide, head + i / options.columns * tall);
    let mut canvas = Canvas::new([0.0, 0.0], [width as f32, height as f32]);
    canvas.text([8.0, height as f32 - 24.0], 16.0, Anchor::Start, Colour::BLACK, title);
    for (i, tile) in tiles.iter().enumerate() {
        let (x, y) = place(i);
        let at = [x as f32 + 4.0, height as f32 - (y + tall - label) as f32];
        legend(&mut canvas, at, wide as f32, tile);
    }
    let mut image = canvas.to_image(width).map_err(Complaint::new)?;
    for (i, tile) in tiles.iter().enumerate() {
        let (x, y) = place(i);
        let asset = &tile.instance.object.asset;
        let Some((low, high)) = asset.extent() else { continue };
        let (w, h) = (wide - 2, tall - label);
        let view = SketchView::around(low, high, w as f32 / h as f32);
        let view = SketchView { open: if options.open { 1.0 } else { 0.0 }, ..view };
        image.paste(x, y, &sketch(&[(asset, Pose::identity())], library, &view, w, h));
    }
    let png = image.to_png().map_err(Complaint::new)?;
    Ok(virtualcity::files::write(path, png)?)
}

/// Class and number, size in centimetres and triangles below a tile.
fn legend(canvas: &mut Canvas, at: [f32; 2], wide: f32, tile: &Tile) {
    let Instance { object, index, .. } = &tile.instance;
    let cm = object.size() * 100.0;
    let name = format!("{} {}/{}", object.class, index + 1, tile.of);
    let fit = |text: &str| (wide - 8.0) / Canvas::text_width(1.0, text);
    let colour = if *index == 0 { Colour::hex(0xa02020) } else { Colour::BLACK };
    canvas.text([at[0], at[1] - 14.0], fit(&name).min(11.0), Anchor::Start, colour, &name);
    let size = format!("{:.0}x{:.0}x{:.0}cm {}t", cm.x, cm.y, cm.z, triangles(tile));
    canvas.text([at[0], at[1] - 29.0], fit(&size).min(10.0), Anchor::Start, Colour::hex(0x606060), &size);
    let rule = Ink::line(Colour::hex(0xd0d0d0), 1.0);
    canvas.line(&[[at[0] - 4.0, at[1] - 35.5], [at[0] + wide - 4.0, at[1] - 35.5]], rule);
}
