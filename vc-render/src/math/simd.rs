//! Loops compiled for the widest vector instructions of the processor.
//!
//! The code is plain Rust, compiled several times; the version is chosen at run time. Sums and products are
//! never fused, so every version gives the same bits.

use pulp::{Simd, WithSimd};

/// Runs `work` in the version for this processor. Code that is to be vectorized must be inlined into it, the
/// closure itself first of all: `widest(#[inline(always)] || ...)`.
#[inline]
pub(crate) fn widest<R>(work: impl FnOnce() -> R) -> R {
    struct Work<F>(F);
    impl<R, F: FnOnce() -> R> WithSimd for Work<F> {
        type Output = R;
        #[inline(always)]
        fn with_simd<S: Simd>(self, _: S) -> R {
            (self.0)()
        }
    }
    dispatch(Work(work))
}

/// Runs work with vectors of at most eight numbers. Loops here process lists of eight as whole vectors; with
/// the next wider instructions, which another crate may have enabled in `pulp`, such a list would be less than
/// a vector.
#[inline]
pub(crate) fn dispatch<W: WithSimd>(work: W) -> W::Output {
    #[cfg(target_arch = "x86_64")]
    if let Some(v3) = wide() {
        return Simd::vectorize(v3, work);
    }
    #[cfg(target_arch = "x86_64")]
    return Simd::vectorize(pulp::Scalar::new(), work);
    #[cfg(not(target_arch = "x86_64"))]
    pulp::Arch::new().dispatch(work)
}

/// The instruction set for vectors of eight numbers, if the processor has it.
#[cfg(target_arch = "x86_64")]
#[inline(always)]
pub(crate) fn wide() -> Option<pulp::x86::V3> {
    #[cfg(test)]
    if tests::PLAIN.load(std::sync::atomic::Ordering::Relaxed) {
        return None;
    }
    pulp::x86::V3::try_new()
}

/// Added to a number of magnitude below 2^22, leaves the nearest integer in the low bits.
const ROUNDER: f32 = 12_582_912.0;

/// Rounds a number of magnitude below 2^22 to the nearest integer, in two's complement.
#[inline(always)]
pub(crate) fn whole(v: f32) -> u32 {
    (v + ROUNDER).to_bits().wrapping_sub(ROUNDER.to_bits())
}

/// Compares eight numbers with eight others: bit i is set if the i-th is at most the other.
#[inline(always)]
pub(crate) fn at_most<S: Simd>(simd: S, these: &[f32; 8], others: &[f32; 8]) -> u32 {
    // A single instruction, which the compiler does not find by itself.
    #[cfg(target_arch = "x86_64")]
    if let Some(v3) = (&simd as &dyn std::any::Any).downcast_ref::<pulp::x86::V3>() {
        let mask = v3.cmp_le_f32x8(pulp::cast(*these), pulp::cast(*others));
        return v3.avx._mm256_movemask_ps(pulp::cast(mask)) as u32;
    }
    (0..8).fold(0, |all, lane| all | u32::from(these[lane] <= others[lane]) << lane)
}

/// Compares eight numbers with eight others: bit i is set if the i-th differs.
#[inline(always)]
fn differ<S: Simd>(simd: S, these: &[u32; 8], others: &[u32; 8]) -> u32 {
    #[cfg(target_arch = "x86_64")]
    if let Some(v3) = (&simd as &dyn std::any::Any).downcast_ref::<pulp::x86::V3>() {
        let mask = Simd::equal_u32s(*v3, pulp::cast(*these), pulp::cast(*others));
        return !v3.avx._mm256_movemask_ps(pulp::cast(mask)) as u32 & 0xff;
    }
    (0..8).fold(0, |all, lane| all | u32::from(these[lane] != others[lane]) << lane)
}

/// Like [`runs`], for loops that leave vectorization to the compiler.
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

/// Splits a row into runs of equal numbers, and calls `run` with the number, the first position and the one
/// after the last.
#[inline(always)]
pub(crate) fn runs<S: Simd>(simd: S, row: &[u32], mut run: impl FnMut(u32, usize, usize)) {
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

#[allow(clippy::unwrap_used, reason = "tests")]
#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, Ordering};

    use vc_graph::Pose;

    use crate::{Camera, Daylight, Frame, Modalities, Modality, PathTracing, Renderer, Shot, common};

    /// Makes `wide` report a processor without vectors of eight.
    pub(super) static PLAIN: AtomicBool = AtomicBool::new(false);

    /// All modalities by day and by lamplight, and reference pictures of the path tracer.
    fn pictures() -> Vec<Vec<u32>> {
        let mut renderer = Renderer::new();
        let mut snapshot = renderer.snapshot(&common::lamplit()).unwrap();
        let mut next = snapshot.clone();
        for (place, node) in snapshot.clone().nodes().enumerate() {
            snapshot.switch(node, true).unwrap();
            if place % 3 == 0 {
                next.place(node, &Pose::translation(0.04 * place as f32, 0.3, 0.5)).unwrap();
            }
        }
        let mut all = Vec::new();
        for (camera, daylight) in common::cameras(76, 52).into_iter().zip([Daylight::noon(), Daylight::night()]) {
            let lighting = renderer.light(&snapshot, &daylight);
            let then = Camera { pose: camera.pose * nalgebra::Translation3::new(0.05, 0.0, 0.1), ..camera };
            let shot = Shot::new(&snapshot, &camera, Modalities::new(Modality::ALL)).lit(&lighting);
            let shot = shot.after(&next, &then).before(&next, &then);
            let mut frame = Frame::new();
            renderer.render(&shot, &mut frame).unwrap();
            all.extend(Modality::ALL.iter().map(|modality| common::contents(&frame, *modality)));
            let how = PathTracing { samples: 2, ..PathTracing::default() };
            let reference_picture = renderer.reference_picture(&lighting, &camera, &how, |_| true).unwrap();
            all.push(reference_picture.light.as_flattened().iter().map(|v| v.to_bits()).collect());
        }
        all
    }

    #[test]
    fn processors_without_vectors_make_the_same_pictures() {
        let wide = pictures();
        PLAIN.store(true, Ordering::Relaxed);
        let plain = pictures();
        PLAIN.store(false, Ordering::Relaxed);
        for (at, (wide, plain)) in wide.iter().zip(&plain).enumerate() {
            let other = wide.iter().zip(plain).filter(|(a, b)| a != b).count();
            assert!(wide.len() == plain.len() && other == 0, "list {at}: {other} of {} differ", wide.len());
        }
    }
}
