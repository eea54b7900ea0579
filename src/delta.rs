//! Bytes as what differs from other bytes: runs that are copied from these, and what is new between the runs.

use std::collections::HashMap;

/// The shortest run that is looked for anywhere, and the shortest after which one goes on behind a difference.
const BLOCK: usize = 16;
const GOES_ON: usize = 8;
/// The bytes that are made of a delta are at most so many times those that it differs from.
const MOST: usize = 4;

/// The difference of some bytes from others.
pub(crate) fn between(base: &[u8], bytes: &[u8]) -> Vec<u8> {
    let all = base.chunks_exact(BLOCK).enumerate().rev();
    let blocks: HashMap<&[u8], usize> = all.map(|(number, block)| (block, number * BLOCK)).collect();
    let mut out = Vec::new();
    write(&mut out, bytes.len());
    // How much is written, and the place in the base behind the last run.
    let (mut written, mut behind, mut at) = (0, 0, 0);
    while at + BLOCK <= bytes.len() {
        let beside = behind + (at - written);
        let goes_on = base.get(beside..beside + GOES_ON).is_some_and(|next| next == &bytes[at..at + GOES_ON]);
        let found = if goes_on { Some(beside) } else { blocks.get(&bytes[at..at + BLOCK]).copied() };
        let Some(from) = found else {
            at += 1;
            continue;
        };
        let length = base[from..].iter().zip(&bytes[at..]).take_while(|(a, b)| a == b).count();
        write_run(&mut out, &bytes[written..at], (from, length));
        (written, behind, at) = (at + length, from + length, at + length);
    }
    write_run(&mut out, &bytes[written..], (0, 0));
    out
}

/// The bytes that differ so from others; none if the delta is none.
pub(crate) fn applied(base: &[u8], delta: &[u8]) -> Option<Vec<u8>> {
    let (total, mut rest) = read(delta)?;
    if total > base.len().saturating_mul(MOST).saturating_add(delta.len()) {
        return None;
    }
    let mut bytes = Vec::with_capacity(total);
    while !rest.is_empty() {
        let (count, after) = read(rest)?;
        let (new, after) = after.split_at_checked(count)?;
        let (from, after) = read(after)?;
        let (length, after) = read(after)?;
        let run = base.get(from..from.checked_add(length)?)?;
        if bytes.len() + new.len() + run.len() > total {
            return None;
        }
        bytes.extend(new);
        bytes.extend(run);
        rest = after;
    }
    (bytes.len() == total).then_some(bytes)
}

/// New bytes, and a run that is copied after them.
fn write_run(out: &mut Vec<u8>, new: &[u8], (from, length): (usize, usize)) {
    write(out, new.len());
    out.extend(new);
    write(out, from);
    write(out, length);
}

/// A number, seven bits a byte, the least first.
fn write(out: &mut Vec<u8>, mut number: usize) {
    while number >= 0x80 {
        out.push(number as u8 | 0x80);
        number >>= 7;
    }
    out.push(number as u8);
}

fn read(bytes: &[u8]) -> Option<(usize, &[u8])> {
    let end = bytes.iter().position(|byte| *byte < 0x80)?;
    let (number, rest) = bytes.split_at(end + 1);
    let bits = |(at, byte): (usize, &u8)| usize::from(byte & 0x7f).checked_shl(7 * at as u32);
    let parts = number.iter().enumerate().map(bits).collect::<Option<Vec<usize>>>()?;
    Some((parts.into_iter().fold(0, |all, part| all | part), rest))
}

#[cfg(test)]
mod tests {
    use super::{applied, between};

    /// Edited, shortened, moved and repeated bytes come back from what differs, which is small where little does.
    #[test]
    fn what_differs_makes_the_same_bytes() {
        let base: Vec<u8> = (0..5000_u32).flat_map(|n| n.wrapping_mul(2_654_435_761).to_le_bytes()).collect();
        let mut edited = base.clone();
        edited[7000] ^= 1;
        edited.splice(9000..9003, [1, 2, 3, 4, 5]);
        let moved = [&base[12_000..], &base[..12_000]].concat();
        let cases = [(edited, 60), (moved, 40), (base[..100].to_vec(), 20), (base.clone(), 20), (Vec::new(), 10)];
        for (bytes, most) in cases {
            let delta = between(&base, &bytes);
            assert_eq!(applied(&base, &delta).as_deref(), Some(&*bytes));
            assert!(delta.len() < most, "{} bytes", delta.len());
            assert_eq!(applied(&[], &between(&[], &bytes)).as_deref(), Some(&*bytes));
        }
    }

    /// No delta makes more than a few times the bytes that it differs from, and none panics.
    #[test]
    fn what_is_no_delta_makes_nothing() {
        let base = [7_u8; 64];
        for delta in
            [&[][..], &[1], &[0xff; 12], &[200, 1, 0, 0, 64], &[64, 0, 1, 64], &[4, 9, 1], &[255, 255, 3, 0, 0, 64]]
        {
            assert_eq!(applied(&base, delta), None, "{delta:?}");
        }
    }
}
