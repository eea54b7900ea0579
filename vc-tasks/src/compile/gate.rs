//! Gates, the parts of a compiled goal.

use vc_graph::hash::finalised;

use super::Bits;

/// A reference to an atom, a gate or a constant, possibly negated, in one number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct Ref(u32);

impl Ref {
    pub(crate) const TRUE: Self = Self(u32::MAX - 1);
    pub(crate) const FALSE: Self = Self(u32::MAX);

    pub(crate) fn atom(index: usize) -> Self {
        Self((index as u32) << 2)
    }

    pub(crate) fn gate(index: usize) -> Self {
        Self(((index as u32) << 2) | 2)
    }

    #[inline]
    pub(crate) fn index(self) -> usize {
        (self.0 >> 2) as usize
    }

    #[inline]
    pub(crate) fn is_negated(self) -> bool {
        self.0 & 1 != 0
    }

    #[inline]
    pub(crate) fn is_atom(self) -> bool {
        self.0 & 2 == 0
    }

    #[inline]
    pub(crate) fn is_constant(self) -> bool {
        self.0 | 1 == u32::MAX
    }

    pub(crate) fn constant(value: bool) -> Self {
        if value { Self::TRUE } else { Self::FALSE }
    }

    pub(crate) fn negated_if(self, negate: bool) -> Self {
        Self(self.0 ^ u32::from(negate))
    }

    /// The same reference without negation.
    pub(crate) fn plain(self) -> Self {
        Self(self.0 & !1)
    }
}

impl std::ops::Not for Ref {
    type Output = Self;

    fn not(self) -> Self {
        self.negated_if(true)
    }
}

/// The condition under which a gate is true. Every other connective becomes one of these with
/// negated inputs or a negated output: "at most k" is the negation of "at least k + 1".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum GateKind {
    /// All inputs are true.
    All,
    /// Some input is true.
    Any,
    /// At least this many inputs are true.
    AtLeast(u32),
    /// Exactly this many inputs are true.
    Exactly(u32),
    /// The inputs are a table, row by row, and enough pairs can be formed in it.
    Pairs(Table),
}

/// A table of pairs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) struct Table {
    pub(crate) rows: u32,
    pub(crate) columns: u32,
    /// The number of pairs needed.
    pub(crate) need: u32,
    pub(crate) pairing: vc_graph::goal::Pairing,
}

/// A gate and the range of its inputs. Inputs precede the gates that use them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Gate {
    pub(crate) kind: GateKind,
    pub(crate) start: u32,
    pub(crate) end: u32,
    pub(crate) mask: Mask,
}

/// The inputs of a gate as a bit mask, if they are distinct atoms in one word and can therefore be
/// read all at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Mask {
    /// The index of the word.
    pub(crate) word: u32,
    /// The atoms; 0 if the inputs are not of this form.
    pub(crate) care: u64,
    /// The negated atoms.
    pub(crate) flip: u64,
}

impl Mask {
    fn from_refs(inputs: &[Ref]) -> Self {
        let Some(first) = inputs.first() else { return Self::default() };
        let mut mask = Self { word: (first.index() / 64) as u32, care: 0, flip: 0 };
        for input in inputs {
            let bit = 1 << (input.index() % 64);
            if !input.is_atom() || input.index() / 64 != mask.word as usize || mask.care & bit != 0 {
                return Self::default();
            }
            mask.care |= bit;
            mask.flip |= if input.is_negated() { bit } else { 0 };
        }
        mask
    }

    /// The inputs that are true.
    #[inline]
    pub(crate) fn read(self, bits: &Bits) -> u64 {
        (bits.word(self.word as usize) ^ self.flip) & self.care
    }
}

impl Gate {
    /// A gate with these inputs, which are stored from `start` on.
    pub(crate) fn new(kind: GateKind, start: usize, inputs: &[Ref]) -> Self {
        let mask = if let GateKind::Pairs(_) = kind { Mask::default() } else { Mask::from_refs(inputs) };
        Self { kind, start: start as u32, end: (start + inputs.len()) as u32, mask }
    }

    #[inline]
    pub(crate) fn inputs(self) -> std::ops::Range<usize> {
        self.start as usize..self.end as usize
    }
}

impl GateKind {
    pub(super) fn key(self, inputs: &[Ref]) -> u64 {
        let own = match self {
            Self::All => 1,
            Self::Any => 2,
            Self::AtLeast(k) => 3 | (u64::from(k) << 8),
            Self::Exactly(k) => 4 | (u64::from(k) << 8),
            Self::Pairs(t) => 5 | (u64::from(t.need) << 8) ^ (u64::from(t.columns) << 40),
        };
        inputs.iter().fold(own, |key, input| finalised(key ^ u64::from(input.0)))
    }
}

impl Table {
    /// Whether enough pairs can be formed, given the cells that are true.
    pub(crate) fn is_met(self, mut cell: impl FnMut(usize) -> bool) -> bool {
        self.number(&mut cell) >= self.need as usize
    }

    /// The size of the largest matching, whatever the table's pairing.
    pub(crate) fn matching(self, mut cell: impl FnMut(usize) -> bool) -> usize {
        Self { pairing: vc_graph::goal::Pairing::Matching, ..self }.number(&mut cell)
    }

    /// The number of pairs.
    pub(crate) fn number(self, cell: &mut impl FnMut(usize) -> bool) -> usize {
        let (rows, columns) = (self.rows as usize, self.columns as usize);
        if rows <= 64 && columns <= 64 {
            let mut masks = [0_u64; 64];
            for (row, mask) in masks[..rows].iter_mut().enumerate() {
                *mask = (0..columns).filter(|c| cell(row * columns + c)).fold(0, |mask, c| mask | 1 << c);
            }
            return match self.pairing {
                vc_graph::goal::Pairing::Matching => small_matching(&masks[..rows]),
                vc_graph::goal::Pairing::Marginal => marginal(&masks[..rows]),
            };
        }
        let row = |r: usize| (0..columns).filter(|c| cell(r * columns + c)).collect();
        let table: Vec<Vec<usize>> = (0..rows).map(row).collect();
        self.pairing.number(&table, columns)
    }
}

fn marginal(rows: &[u64]) -> usize {
    let seconds = rows.iter().fold(0, |all, row| all | row).count_ones() as usize;
    rows.iter().filter(|&&row| row != 0).count().min(seconds)
}

/// The largest matching of at most 64 rows and columns, by augmenting paths (Kuhn 1955); allocates
/// no memory.
fn small_matching(rows: &[u64]) -> usize {
    let mut partner = [u8::MAX; 64];
    (0..rows.len()).filter(|&row| augment(row, rows, &mut partner, &mut 0)).count()
}

/// Each call marks one more column as seen, so the recursion is at most 64 deep.
fn augment(row: usize, rows: &[u64], partner: &mut [u8; 64], seen: &mut u64) -> bool {
    loop {
        let open = rows[row] & !*seen;
        if open == 0 {
            return false;
        }
        let column = open.trailing_zeros() as usize;
        *seen |= 1 << column;
        if partner[column] == u8::MAX || augment(partner[column].into(), rows, partner, seen) {
            partner[column] = row as u8;
            return true;
        }
    }
}
