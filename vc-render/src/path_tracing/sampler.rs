//! Low-discrepancy points, decorrelated between pixels and purposes.

/// Sample points of one path: Sobol's sequence in two dimensions, shuffled and scrambled by a hash of the pixel
/// and of the point's purpose (Burley 2020), so that no two purposes are correlated.
pub(super) struct Sampler {
    pixel: u32,
    round: u32,
    used: u32,
}

impl Sampler {
    pub(super) fn new((x, y): (usize, usize), round: u32, seed: u32) -> Self {
        Self { pixel: mixed(x as u32 ^ mixed(y as u32 ^ mixed(seed))), round, used: 0 }
    }

    /// The next point of the unit square.
    pub(super) fn pair(&mut self) -> [f32; 2] {
        self.used += 1;
        let seed = mixed(self.pixel ^ mixed(self.used));
        let index = scrambled(self.round, seed);
        let [x, y] = sobol(index);
        // The topmost bits as a number below one.
        [scrambled(x, mixed(seed ^ 1)), scrambled(y, mixed(seed ^ 2))].map(|v| (v >> 8) as f32 / (1 << 24) as f32)
    }

    pub(super) fn one(&mut self) -> f32 {
        self.pair()[0]
    }
}

/// The first two dimensions of Sobol's sequence; the second is the first one multiplied by Pascal's triangle
/// modulo 2, in steps that halve.
fn sobol(index: u32) -> [u32; 2] {
    let masks = [(1, 0x5555_5555), (2, 0x3333_3333), (4, 0x0f0f_0f0f), (8, 0x00ff_00ff), (16, 0x0000_ffff)];
    let pascal = masks.into_iter().fold(index, |v, (shift, mask)| v ^ ((v >> shift) & mask));
    [index.reverse_bits(), pascal.reverse_bits()]
}

/// Owen scrambling of a number's bits, each by a hash of the bits above it (Laine and Karras 2011, with
/// Vegdahl's constants).
fn scrambled(value: u32, seed: u32) -> u32 {
    let mut v = value.reverse_bits();
    v ^= v.wrapping_mul(0x3d20_adea);
    v = v.wrapping_add(seed);
    v = v.wrapping_mul((seed >> 16) | 1);
    v ^= v.wrapping_mul(0x0552_6c56);
    v ^= v.wrapping_mul(0x53a2_2864);
    v.reverse_bits()
}

/// A 32-bit hash (Wellons's lowbias32).
fn mixed(value: u32) -> u32 {
    let v = (value ^ (value >> 16)).wrapping_mul(0x7feb_352d);
    let v = (v ^ (v >> 15)).wrapping_mul(0x846c_a68b);
    v ^ (v >> 16)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_box_of_a_power_of_two_holds_as_many_points() {
        for pixel in 0..20 {
            for (across, down) in [(1, 64), (2, 32), (4, 16), (8, 8), (16, 4), (64, 1)] {
                let mut counts = vec![0; across * down];
                for round in 0..64 {
                    let [a, b] = Sampler::new((pixel, 3), round, 7).pair();
                    counts[(a * across as f32) as usize * down + (b * down as f32) as usize] += 1;
                }
                assert!(counts.iter().all(|c| *c == 1), "{across} x {down}: {counts:?}");
            }
        }
    }

    #[test]
    fn purposes_do_not_go_together() {
        // The mean product of two purposes is that of independent numbers, in every pixel.
        for pixel in 0..50 {
            let product = |round| {
                let mut sampler = Sampler::new((pixel, 1), round, 0);
                let first = sampler.pair();
                first[0] * sampler.pair()[0]
            };
            let mean = (0..1024).map(product).sum::<f32>() / 1024.0;
            assert!((mean - 0.25).abs() < 0.02, "{mean}");
        }
    }
}
