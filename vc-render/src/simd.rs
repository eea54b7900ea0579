//! Loops with the widest vectors the processor has.
//!
//! The code is plain Rust, compiled several times and chosen when it runs. Sums and
//! products are never fused, so every version gives the same bits.

/// Runs `work` in the version for this processor. What is to profit must be inlined
/// into it, the closure itself first of all: `widest(#[inline(always)] || ...)`.
#[inline]
pub(crate) fn widest<R>(work: impl FnOnce() -> R) -> R {
    struct Work<F>(F);
    impl<R, F: FnOnce() -> R> pulp::NullaryFnOnce for Work<F> {
        type Output = R;
        #[inline(always)]
        fn call(self) -> R {
            (self.0)()
        }
    }
    pulp::Arch::new().dispatch(Work(work))
}

/// Added to a number of less than 2^22, leaves the nearest whole number in the low bits.
const ROUNDER: f32 = 12_582_912.0;

/// The nearest whole number of one of less than 2^22, negative ones as two's complement.
#[inline(always)]
pub(crate) fn whole(v: f32) -> u32 {
    (v + ROUNDER).to_bits().wrapping_sub(ROUNDER.to_bits())
}

/// Which of eight numbers are no greater than others, a bit each.
#[inline(always)]
pub(crate) fn at_most<S: pulp::Simd>(simd: S, these: &[f32; 8], others: &[f32; 8]) -> u32 {
    // One instruction, which the compiler does not find by itself.
    #[cfg(target_arch = "x86_64")]
    if let Some(v3) = (&simd as &dyn std::any::Any).downcast_ref::<pulp::x86::V3>() {
        let mask = v3.cmp_le_f32x8(pulp::cast(*these), pulp::cast(*others));
        return v3.avx._mm256_movemask_ps(pulp::cast(mask)) as u32;
    }
    (0..8).fold(0, |all, lane| all | u32::from(these[lane] <= others[lane]) << lane)
}

/// Which of eight numbers differ from others, a bit each.
#[inline(always)]
fn differ<S: pulp::Simd>(simd: S, these: &[u32; 8], others: &[u32; 8]) -> u32 {
    #[cfg(target_arch = "x86_64")]
    if let Some(v3) = (&simd as &dyn std::any::Any).downcast_ref::<pulp::x86::V3>() {
        let mask = pulp::Simd::equal_u32s(*v3, pulp::cast(*these), pulp::cast(*others));
        return !v3.avx._mm256_movemask_ps(pulp::cast(mask)) as u32 & 0xff;
    }
    (0..8).fold(0, |all, lane| all | u32::from(these[lane] != others[lane]) << lane)
}

/// Finds means of bytes.
#[derive(Clone, Copy)]
pub(crate) struct Mixer {
    #[cfg(target_arch = "x86_64")]
    v3: Option<pulp::x86::V3>,
}

impl Mixer {
    #[inline(always)]
    pub(crate) fn new() -> Self {
        Self {
            #[cfg(target_arch = "x86_64")]
            v3: pulp::x86::V3::try_new(),
        }
    }

    /// Eight means of four bytes each, the same weights for all eight: the left and the right one's, eight bits
    /// each, and the upper and the lower one's, sixteen bits each. Both sums must be 64.
    #[inline(always)]
    pub(crate) fn means(self, [upper, lower]: [[[u8; 8]; 2]; 2], across: u16, down: u32) -> [[i32; 4]; 2] {
        // The compiler takes byte by byte.
        #[cfg(target_arch = "x86_64")]
        if let Some(v3) = self.v3 {
            let across = v3.sse2._mm_set1_epi16(across as i16);
            let row = |pair: [[u8; 8]; 2]| {
                let pair = pulp::cast(pair);
                let mixed = v3.sse2._mm_unpacklo_epi8(pair, v3.sse2._mm_srli_si128::<8>(pair));
                v3.ssse3._mm_maddubs_epi16(mixed, across)
            };
            let (upper, lower, down) = (row(upper), row(lower), v3.sse2._mm_set1_epi32(down as i32));
            let first = v3.sse2._mm_madd_epi16(v3.sse2._mm_unpacklo_epi16(upper, lower), down);
            let last = v3.sse2._mm_madd_epi16(v3.sse2._mm_unpackhi_epi16(upper, lower), down);
            return [pulp::cast(first), pulp::cast(last)];
        }
        let row = |pair: [[u8; 8]; 2], i: usize| {
            i32::from(pair[0][i]) * i32::from(across & 255) + i32::from(pair[1][i]) * i32::from(across >> 8)
        };
        let mean = |i: usize| row(upper, i) * (down & 0xffff) as i32 + row(lower, i) * (down >> 16) as i32;
        [0, 4].map(|from| std::array::from_fn(|i| mean(from + i)))
    }
}

/// As [`runs`], where vectors are the compiler's business.
#[inline(always)]
pub(crate) fn stretches(row: &[u32], mut stretch: impl FnMut(u32, usize, usize)) {
    const PART: usize = 8;
    let (mut from, mut at) = (0, 0);
    let (these, next) = (row.as_chunks::<PART>().0, row.get(1..).unwrap_or(&[]).as_chunks::<PART>().0);
    for (these, next) in these.iter().zip(next) {
        if these != next {
            for lane in 0..PART {
                if these[lane] != next[lane] {
                    stretch(row[from], from, at + lane + 1);
                    from = at + lane + 1;
                }
            }
        }
        at += PART;
    }
    for to in at + 1..=row.len() {
        if row.get(to) != Some(&row[to - 1]) {
            stretch(row[from], from, to);
            from = to;
        }
    }
}

/// Cuts a row into runs of equal numbers, by their first positions and those after their last.
#[inline(always)]
pub(crate) fn runs<S: pulp::Simd>(simd: S, row: &[u32], mut run: impl FnMut(u32, usize, usize)) {
    let (mut from, mut at) = (0, 0);
    let (these, next) = (row.as_chunks::<8>().0, row.get(1..).unwrap_or(&[]).as_chunks::<8>().0);
    for (these, next) in these.iter().zip(next) {
        let mut changes = differ(simd, these, next);
        while changes != 0 {
            let to = at + changes.trailing_zeros() as usize + 1;
            changes &= changes - 1;
            run(row[from], from, to);
            from = to;
        }
        at += 8;
    }
    for to in at + 1..=row.len() {
        if row.get(to) != Some(&row[to - 1]) {
            run(row[from], from, to);
            from = to;
        }
    }
}
