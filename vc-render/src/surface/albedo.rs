//! Albedo of the microfacet gloss: the share of diffuse light that it reflects, used to conserve energy.

use std::sync::LazyLock;

use super::scatter::Gloss;

/// Number of table entries by cosine and by roughness.
const COSINES: usize = 32;
const ROUGHNESSES: usize = 17;
/// Number of directions sampled for each entry.
const DIRECTIONS: usize = 1024;

/// Scale and bias of the reflected share: for the reflectance at normal incidence, and the addition at grazing
/// angles (Karis's split of Schlick's formula, 2013).
pub(super) type Shares = [f32; 2];

struct Table {
    /// By roughness, then by the square root of the cosine.
    shares: Vec<Shares>,
    /// Means over all cosines, by roughness.
    means: Vec<Shares>,
}

static TABLE: LazyLock<Table> = LazyLock::new(Table::new);

impl Table {
    fn new() -> Self {
        let cell = |i: usize| {
            let root = (i % COSINES) as f32 / (COSINES - 1) as f32;
            Gloss::new((i / COSINES) as f32 / (ROUGHNESSES - 1) as f32).shares((root * root).max(1e-3), DIRECTIONS)
        };
        let shares: Vec<Shares> = (0..COSINES * ROUGHNESSES).map(cell).collect();
        Self { means: shares.chunks(COSINES).map(mean).collect(), shares }
    }
}

/// Cosine-weighted mean over the hemisphere: twice the integral of the share times the cosine.
fn mean(row: &[Shares]) -> Shares {
    let cosine = |i: usize| (i as f32 / (COSINES - 1) as f32) * (i as f32 / (COSINES - 1) as f32);
    let piece = |k: usize, i: usize| {
        let (a, b) = (cosine(i), cosine(i + 1));
        (b - a) * (row[i][k] * a + row[i + 1][k] * b)
    };
    [0, 1].map(|k: usize| (0..COSINES - 1).map(|i| piece(k, i)).sum())
}

/// The shares at a cosine and a roughness, interpolated.
pub(super) fn shares(cosine: f32, roughness: f32) -> Shares {
    let (row, down) = place(roughness, ROUGHNESSES);
    let (column, across) = place(cosine.max(0.0).sqrt(), COSINES);
    let at = |r: usize, c: usize| TABLE.shares[r * COSINES + c];
    let [a, b, c, d] = [at(row, column), at(row, column + 1), at(row + 1, column), at(row + 1, column + 1)];
    [0, 1].map(|k: usize| mix(mix(a[k], b[k], across), mix(c[k], d[k], across), down))
}

/// The mean shares over all directions at a roughness.
pub(super) fn mean_shares(roughness: f32) -> Shares {
    let (row, down) = place(roughness, ROUGHNESSES);
    [0, 1].map(|k: usize| mix(TABLE.means[row][k], TABLE.means[row + 1][k], down))
}

/// The table entry below a number from 0 to 1, and the fraction of the way to the next.
fn place(x: f32, count: usize) -> (usize, f32) {
    let x = x.clamp(0.0, 1.0) * (count - 1) as f32;
    let cell = (x as usize).min(count - 2);
    (cell, x - cell as f32)
}

fn mix(a: f32, b: f32, share: f32) -> f32 {
    a + (b - a) * share
}
