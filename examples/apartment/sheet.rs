//! A sheet of floor plans.

use std::path::Path;

use indicatif::ProgressBar;
use virtualcity::graph::Seed;
use virtualcity::procgen::picture::{Canvas, Image};
use virtualcity::procgen::{Apartment, Specification};

use crate::support::{Complaint, say};

/// Plans per row, and number of rows.
const GRID: [usize; 2] = [6, 4];
/// Plans on a sheet.
pub(crate) const PLANS: u64 = (GRID[0] * GRID[1]) as u64;
/// Width and height of a plan, pixels.
const TILE: [usize; 2] = [560, 560];
/// White margin between plans, pixels.
const GAP: usize = 10;

/// Draws the plans of 24 seeds on a sheet.
pub(crate) fn write(specification: &Specification, seed: u64, out: &Path) -> Result<(), Complaint> {
    let [wide, tall] = [0, 1].map(|i| GRID[i] * (TILE[i] + GAP) + GAP);
    let mut sheet = Image::new(wide, tall, [255; 3]);
    let progress = ProgressBar::new(PLANS);
    for i in 0..PLANS {
        let home = Apartment::generate(specification, Seed(seed + i));
        let home = home.map_err(|e| Complaint::new(format!("seed {}: {e}", seed + i)))?;
        let tile = fitted(&home.floor_plan())?;
        let place = [i as usize % GRID[0], i as usize / GRID[0]];
        let [x, y] = [0, 1].map(|a| GAP + place[a] * (TILE[a] + GAP));
        sheet.paste(x + (TILE[0] - tile.width) / 2, y + (TILE[1] - tile.height) / 2, &tile);
        progress.inc(1);
    }
    progress.finish_and_clear();
    let path = out.join(format!("plans_{seed}.png"));
    virtualcity::files::write(&path, sheet.to_png().map_err(Complaint::new)?)?;
    say!("plans of seeds {seed} to {} in {}", seed + (PLANS - 1), path.display());
    Ok(())
}

/// A drawing as large as a tile holds.
fn fitted(drawing: &Canvas) -> Result<Image, Complaint> {
    // A pixel less: rounding must not make it higher than the tile.
    let width = (TILE[0] as f32).min((TILE[1] - 1) as f32 * drawing.aspect()) as usize;
    drawing.to_image(width.max(1)).map_err(Complaint::new)
}
