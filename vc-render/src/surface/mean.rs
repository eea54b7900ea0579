//! Bilinear means of texels, many at a time.
//!
//! Bytes are mixed in integer arithmetic, so that every processor gives the same result.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

#[cfg(target_arch = "x86_64")]
mod v3;

/// Two horizontally neighbouring texels of four bytes, the left one first.
pub(super) type Pair = [[u8; 4]; 2];

/// Position between four neighbours: weights of the right and the lower ones, in 64ths.
#[derive(Clone, Copy)]
pub(super) struct Shares<const N: usize> {
    pub(super) right: [u16; N],
    pub(super) lower: [u16; N],
}

/// Computes bilinear means of bytes.
#[derive(Clone, Copy)]
pub(super) struct Mixer {
    #[cfg(target_arch = "x86_64")]
    v3: Option<pulp::x86::V3>,
}

impl Mixer {
    #[inline(always)]
    pub(super) fn new() -> Self {
        Self {
            #[cfg(target_arch = "x86_64")]
            v3: crate::math::simd::wide(),
        }
    }

    /// Eight means of four texels each, times 64: all first bytes, then all second bytes and so on. The four
    /// are two texels above and the two below them.
    #[inline(always)]
    pub(super) fn means<'a>(self, four: impl Fn(usize) -> [&'a Pair; 2], shares: &Shares<8>) -> [[i16; 8]; 4] {
        // The compiler would process single bytes.
        #[cfg(target_arch = "x86_64")]
        if let Some(v3) = self.v3 {
            return v3::means(v3, four, shares);
        }
        let mut all = [[0; 8]; 4];
        for i in 0..8 {
            let mean = mean(four(i), [shares.right[i], shares.lower[i]]);
            (0..4).for_each(|k| all[k][i] = mean[k]);
        }
        all
    }
}

/// The mean of four texels, times 64.
#[inline(always)]
pub(super) fn mean([upper, lower]: [&Pair; 2], shares: [u16; 2]) -> [i16; 4] {
    let [right, down] = shares.map(i32::from);
    std::array::from_fn(|k| {
        let row = |pair: &Pair| i32::from(pair[0][k]) * (64 - right) + i32::from(pair[1][k]) * right;
        let (upper, lower) = (row(upper), row(lower));
        // Rounded like the processor's instruction.
        (upper + (((((lower - upper) * (down << 9)) >> 14) + 1) >> 1)) as i16
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use vc_graph::Seed;

    #[test]
    fn processors_come_to_the_same() {
        let mut rng = Seed(5).stream();
        for _ in 0..2000 {
            let byte = |rng: &mut vc_graph::Stream| [0, 255, rng.below(256) as u8][rng.below(3)];
            let rows: [[Pair; 2]; 8] =
                [[[[0; 4]; 2]; 2]; 8].map(|rows| rows.map(|pair| pair.map(|t| t.map(|_| byte(&mut rng)))));
            let shares =
                Shares { right: [0; 8].map(|_| rng.below(64) as u16), lower: [0; 8].map(|_| rng.below(64) as u16) };
            let means = Mixer::new().means(|i| [&rows[i][0], &rows[i][1]], &shares);
            for i in 0..8 {
                let [upper, lower] = &rows[i];
                let (right, down) = (f64::from(shares.right[i]) / 64.0, f64::from(shares.lower[i]) / 64.0);
                let one = mean([upper, lower], [shares.right[i], shares.lower[i]]);
                for k in 0..4 {
                    assert_eq!(means[k][i], one[k]);
                    let row = |pair: &Pair| f64::from(pair[0][k]) * (1.0 - right) + f64::from(pair[1][k]) * right;
                    let exact = 64.0 * (row(upper) * (1.0 - down) + row(lower) * down);
                    assert!((f64::from(one[k]) - exact).abs() <= 0.5, "{} for {exact}", one[k]);
                }
            }
        }
    }
}
