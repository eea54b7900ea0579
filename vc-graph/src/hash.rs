//! Hashes that are the same on every machine: of text, of words, and for digests.

use std::fmt;

/// The published constants of 64-bit FNV-1a (Fowler, Noll, Vo).
const OFFSET: u64 = 0xcbf2_9ce4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01b3;

/// The 64-bit FNV-1a hash of bytes, or of larger words each taken as one unit.
///
/// ```
/// assert_eq!(vc_graph::hash::fnv1a("a".bytes()), 0xaf63_dc4c_8601_ec8c);
/// ```
pub fn fnv1a<W: Into<u64>>(words: impl IntoIterator<Item = W>) -> u64 {
    words.into_iter().fold(OFFSET, |hash, word| (hash ^ word.into()).wrapping_mul(PRIME))
}

/// The finaliser of `SplitMix64` (Steele, Lea and Flood, OOPSLA 2014), with its increment: a bijection in which
/// every input bit affects all output bits.
///
/// ```
/// assert_eq!(vc_graph::hash::splitmix(0), 0xe220_a839_7b1d_cdaf);
/// ```
pub fn splitmix(value: u64) -> u64 {
    finalised(value.wrapping_add(0x9e37_79b9_7f4a_7c15))
}

/// The finaliser of `SplitMix64` alone. Zero stays zero.
pub fn finalised(value: u64) -> u64 {
    let v = (value ^ (value >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let v = (v ^ (v >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    v ^ (v >> 31)
}

/// A 64-bit digest of a scene's content, the same on every machine. It is computed by a [`Digester`], which
/// detects differences but does not protect against an adversary.
///
/// ```
/// use vc_graph::Digest;
/// assert_eq!(Digest(255).to_string(), "00000000000000ff");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Digest(pub u64);

impl fmt::Display for Digest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

/// Computes a [`Digest`] from a sequence of values: FNV-1a over 64-bit words, with a fold after each. It
/// detects differences but does not protect against an adversary.
///
/// ```
/// use vc_graph::hash::Digester;
/// let mut first = Digester::new();
/// first.word(1).text("cup").reals([0.5, 0.25]);
/// let mut second = Digester::new();
/// second.word(1).text("cup").reals([0.5, 0.75]);
/// assert_ne!(first.digest(), second.digest());
/// ```
#[derive(Debug, Clone)]
pub struct Digester(u64);

impl Default for Digester {
    fn default() -> Self {
        Self(OFFSET)
    }
}

impl Digester {
    /// A digester without input.
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds one word.
    pub fn word(&mut self, word: u64) -> &mut Self {
        // The fold brings down the high bits, which FNV's multiplication alone never does.
        let mixed = (self.0 ^ word).wrapping_mul(PRIME);
        self.0 = mixed ^ (mixed >> 32);
        self
    }

    /// Adds several words, without their count.
    ///
    /// ```
    /// use vc_graph::hash::Digester;
    /// let digest = |words: [u64; 2]| Digester::new().words(words).digest();
    /// assert_eq!(digest([1, 2]), digest([1, 2]));
    /// assert_ne!(digest([1, 2]), digest([2, 1]));
    /// ```
    pub fn words(&mut self, words: impl IntoIterator<Item = u64>) -> &mut Self {
        words.into_iter().for_each(|word| _ = self.word(word));
        self
    }

    /// Adds bytes: their count, then eight per word.
    pub fn bytes(&mut self, bytes: &[u8]) -> &mut Self {
        self.word(bytes.len() as u64);
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            self.word(u64::from_le_bytes(word));
        }
        self
    }

    /// Adds text, as its bytes.
    pub fn text(&mut self, text: &str) -> &mut Self {
        self.bytes(text.as_bytes())
    }

    /// Adds numbers by their bits: zero and minus zero differ.
    pub fn reals(&mut self, values: impl IntoIterator<Item = f32>) -> &mut Self {
        self.words(values.into_iter().map(|value| u64::from(value.to_bits())))
    }

    /// The digest of all input.
    pub fn digest(&self) -> Digest {
        Digest(self.0)
    }
}
