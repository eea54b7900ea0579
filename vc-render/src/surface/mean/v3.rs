//! Bilinear means by processor instructions that the compiler does not find.

#![allow(clippy::needless_range_loop, reason = "lists of one length go side by side, as vectors do")]

use std::arch::x86_64::__m128i;

use pulp::x86::V3;

use super::{Pair, Shares};

/// Weights of the left and right columns of eight pixels, a byte each, and weights of their lower rows.
struct Weights {
    columns: __m128i,
    down: __m128i,
}

impl Weights {
    #[inline(always)]
    fn new(shares: &Shares<8>) -> Self {
        let (mut columns, mut down) = ([0_u16; 8], [0_u16; 8]);
        for i in 0..8 {
            columns[i] = shares.right[i] << 8 | (64 - shares.right[i]);
            down[i] = shares.lower[i] << 9;
        }
        Self { columns: pulp::cast(columns), down: pulp::cast(down) }
    }

    /// The upper and the lower row of a pixel, each averaged over its columns.
    #[inline(always)]
    fn rows(&self, v3: V3, i: u8, [upper, lower]: [&Pair; 2]) -> __m128i {
        let [upper, lower]: [i64; 2] = [pulp::cast(*upper), pulp::cast(*lower)];
        let beside: __m128i = pulp::cast([0_u8, 4, 1, 5, 2, 6, 3, 7, 8, 12, 9, 13, 10, 14, 11, 15]);
        let both = v3.ssse3._mm_shuffle_epi8(v3.sse2._mm_set_epi64x(lower, upper), beside);
        let own: __m128i = pulp::cast([[2 * i, 2 * i + 1]; 8]);
        v3.ssse3._mm_maddubs_epi16(both, v3.ssse3._mm_shuffle_epi8(self.columns, own))
    }

    /// The means of two pixels, given their rows.
    #[inline(always)]
    fn two(&self, v3: V3, i: u8, [first, second]: [__m128i; 2]) -> __m128i {
        let (upper, lower) = (v3.sse2._mm_unpacklo_epi64(first, second), v3.sse2._mm_unpackhi_epi64(first, second));
        let own: __m128i = pulp::cast([[[2 * i, 2 * i + 1]; 4], [[2 * i + 2, 2 * i + 3]; 4]]);
        let down = v3.ssse3._mm_shuffle_epi8(self.down, own);
        v3.sse2._mm_add_epi16(upper, v3.ssse3._mm_mulhrs_epi16(v3.sse2._mm_sub_epi16(lower, upper), down))
    }

    /// For four pixels, all first and second bytes of their means, and all third and fourth ones.
    #[inline(always)]
    fn sorted(&self, v3: V3, i: u8, rows: [__m128i; 4]) -> [__m128i; 2] {
        let [a, b, c, d] = rows;
        let (first, last) = (self.two(v3, i, [a, b]), self.two(v3, i + 2, [c, d]));
        let (even, odd) = (v3.sse2._mm_unpacklo_epi16(first, last), v3.sse2._mm_unpackhi_epi16(first, last));
        [v3.sse2._mm_unpacklo_epi16(even, odd), v3.sse2._mm_unpackhi_epi16(even, odd)]
    }
}

/// Like [`super::Mixer::means`].
#[inline(always)]
pub(super) fn means<'a>(v3: V3, four: impl Fn(usize) -> [&'a Pair; 2], shares: &Shares<8>) -> [[i16; 8]; 4] {
    let weights = Weights::new(shares);
    let mut rows = [v3.sse2._mm_setzero_si128(); 8];
    for i in 0..8 {
        rows[i] = weights.rows(v3, i as u8, four(i));
    }
    let [a, b, c, d, e, f, g, h] = rows;
    let ([a, c], [b, d]) = (weights.sorted(v3, 0, [a, b, c, d]), weights.sorted(v3, 4, [e, f, g, h]));
    [
        pulp::cast(v3.sse2._mm_unpacklo_epi64(a, b)),
        pulp::cast(v3.sse2._mm_unpackhi_epi64(a, b)),
        pulp::cast(v3.sse2._mm_unpacklo_epi64(c, d)),
        pulp::cast(v3.sse2._mm_unpackhi_epi64(c, d)),
    ]
}
