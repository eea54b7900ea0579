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
