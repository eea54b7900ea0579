//! Numbers that fill squares evenly, another order of them for each pixel.

/// Points for one path: a lattice after the plastic number (Roberts 2018), shifted by a hash
/// of the pixel and of what the point is for.
pub(super) struct Sampler {
    pixel: u32,
    round: u32,
    used: u32,
}

impl Sampler {
    pub(super) fn new((x, y): (usize, usize), round: u32, seed: u32) -> Self {
        Self { pixel: mixed(x as u32 ^ mixed(y as u32 ^ mixed(seed))), round, used: 0 }
    }

    /// A point of the unit square.
    pub(super) fn pair(&mut self) -> [f32; 2] {
        self.used += 1;
        let shift = mixed(self.pixel ^ mixed(self.used));
        // Whole numbers wrap around as fractions do.
        let x = self.round.wrapping_mul(3_242_174_889).wrapping_add(shift);
        let y = self.round.wrapping_mul(2_447_445_414).wrapping_add(mixed(shift));
        [x, y].map(|v| (v >> 8) as f32 / (1 << 24) as f32)
    }

    pub(super) fn one(&mut self) -> f32 {
        self.pair()[0]
    }
}

/// A hash of 32 bits (Wellons's lowbias32).
fn mixed(value: u32) -> u32 {
    let v = (value ^ (value >> 16)).wrapping_mul(0x7feb_352d);
    let v = (v ^ (v >> 15)).wrapping_mul(0x846c_a68b);
    v ^ (v >> 16)
}
