//! The s-expressions of BDDL and PDDL.
//!
//! ```
//! use vc_tasks::format::sexpr::SexprTree;
//! let tree = SexprTree::read("example", "(and (open door_1) ; a comment\n (hot tea_1))")?;
//! let parts: Vec<String> = tree.root().items().map(|e| e.to_string()).collect();
//! assert_eq!(parts, ["and", "(open door_1)", "(hot tea_1)"]);
//! # Ok::<(), vc_tasks::format::ReadError>(())
//! ```
//!
//! A tree is one list of words and brackets in the order of the text, each with the place where it begins and
//! the index of the element after it; it has no pointers and no recursion. Reading costs a few nanoseconds a
//! byte.

use std::fmt;

use vc_graph::clip;
use vc_graph::format::{LARGEST, unmarked};

use super::ReadError;
use super::error::line_and_column;

/// The maximal depth of nested brackets.
pub const DEEPEST: usize = 128;

/// A parsed text: one expression, and the text itself in lower case.
#[derive(Debug, Clone)]
pub struct SexprTree {
    format: &'static str,
    text: Box<str>,
    nodes: Vec<Node>,
}

/// A word or a list.
#[derive(Debug, Clone, Copy)]
struct Node {
    /// The first byte.
    start: u32,
    /// One past the last byte.
    end: u32,
    /// The index of the node after this one and everything within it.
    after: u32,
}

impl SexprTree {
    /// Reads a text of one expression. Case does not matter in these languages; the text is converted to lower
    /// case.
    ///
    /// # Errors
    /// [`ReadError`] for unbalanced brackets, more than one expression, text nested deeper than [`DEEPEST`] or
    /// larger than [`LARGEST`].
    pub fn read(format: &'static str, text: &str) -> Result<Self, ReadError> {
        if text.len() > LARGEST {
            let found = format!("one of {} bytes", text.len());
            return Err(ReadError::at(format, "", 0, format!("a text of at most {LARGEST} bytes"), found));
        }
        let text = lower(unmarked(text)).into_boxed_str();
        match scan(&text) {
            Ok(nodes) => Ok(Self { format, text, nodes }),
            Err((at, expected, found)) => Err(ReadError::at(format, &text, at, expected, found)),
        }
    }

    /// The expression.
    pub fn root(&self) -> Expr<'_> {
        Expr { tree: self, index: 0 }
    }

    pub(crate) fn expr(&self, index: u32) -> Expr<'_> {
        Expr { tree: self, index }
    }
}

/// Converts a text to lower case; a letter whose lower case has another length is kept, so that positions in
/// the text stay the same.
fn lower(text: &str) -> String {
    if text.is_ascii() {
        return text.to_ascii_lowercase();
    }
    let small = |c: char| Some(c.to_lowercase().next()?).filter(|s| s.len_utf8() == c.len_utf8());
    text.chars().map(|c| small(c).unwrap_or(c)).collect()
}

type Fault = (usize, &'static str, String);

fn scan(text: &str) -> Result<Vec<Node>, Fault> {
    let bytes = text.as_bytes();
    // A bracket or word takes seven bytes or more in most files.
    let mut nodes: Vec<Node> = Vec::with_capacity(bytes.len() / 7 + 1);
    let mut open = [0_u32; DEEPEST];
    let (mut depth, mut at) = (0, space_end(bytes, 0));
    while let Some(&byte) = bytes.get(at) {
        if depth == 0 && !nodes.is_empty() && byte != b';' {
            let found = if byte == b')' { "a `)` that no `(` opened" } else { "more text" };
            return Err((at, "the end", found.to_owned()));
        }
        let start = at;
        match byte {
            b';' => at = bytes[at..].iter().position(|b| matches!(b, b'\n' | b'\r')).map_or(bytes.len(), |n| at + n),
            b'(' => {
                let Some(top) = open.get_mut(depth) else {
                    return Err((at, "at most 128 brackets within each other", "another one".to_owned()));
                };
                *top = nodes.len() as u32;
                depth += 1;
                nodes.push(Node { start: start as u32, end: 0, after: 0 });
                at += 1;
            }
            b')' if depth == 0 => return Err((at, "an expression", "`)`".to_owned())),
            b')' => {
                depth -= 1;
                let after = nodes.len() as u32;
                let list = &mut nodes[open[depth] as usize];
                (list.end, list.after) = (start as u32 + 1, after);
                at += 1;
            }
            _ => {
                at = word_end(bytes, at);
                let after = nodes.len() as u32 + 1;
                nodes.push(Node { start: start as u32, end: at as u32, after });
            }
        }
        at = space_end(bytes, at);
    }
    match depth.checked_sub(1) {
        Some(last) => {
            let unclosed = nodes[open[last] as usize].start as usize;
            Err((unclosed, "a `)` for this `(`", "the end".to_owned()))
        }
        None if nodes.is_empty() => Err((text.len(), "an expression", "the end".to_owned())),
        None => Ok(nodes),
    }
}

/// The value one in each of eight bytes, and their highest bits.
const EACH: u64 = 0x0101_0101_0101_0101;
const HIGH: u64 = EACH << 7;

/// The end of the spaces that begin here, and the end of a word. Eight bytes are tested at once (Warren,
/// Hacker's Delight, 6-1), because words are short and a branch per byte would be mispredicted.
fn space_end(bytes: &[u8], at: usize) -> usize {
    find(bytes, at, |block| !spaces(block) & HIGH)
}

fn word_end(bytes: &[u8], at: usize) -> usize {
    // The two brackets differ only in the lowest bit.
    find(bytes, at, |block| spaces(block) | equal(block | EACH, b')') | equal(block, b';'))
}

/// The first byte from `at` on that is marked by its highest bit.
fn find(bytes: &[u8], mut at: usize, mark: impl Fn(u64) -> u64) -> usize {
    while at < bytes.len() {
        let marked = mark(block(bytes, at));
        at += (marked.trailing_zeros() / 8) as usize;
        if marked != 0 {
            break;
        }
    }
    at.min(bytes.len())
}

/// Eight bytes from `at` on, the first one lowest; bytes beyond the end are spaces.
fn block(bytes: &[u8], at: usize) -> u64 {
    match bytes[at..].first_chunk() {
        Some(eight) => u64::from_le_bytes(*eight),
        None => bytes[at..].iter().rev().fold(EACH * u64::from(b' '), |block, &b| (block << 8) | u64::from(b)),
    }
}

/// Marks spaces and control characters.
fn spaces(block: u64) -> u64 {
    let above = (block | HIGH) - EACH * u64::from(b' ' + 1);
    !(above | block) & HIGH
}

/// Marks bytes equal to a given one; only the first mark is reliable.
fn equal(block: u64, byte: u8) -> u64 {
    let differ = block ^ (EACH * u64::from(byte));
    differ.wrapping_sub(EACH) & !differ & HIGH
}

/// A word or a list of a [`SexprTree`].
#[derive(Clone, Copy)]
pub struct Expr<'t> {
    tree: &'t SexprTree,
    index: u32,
}

impl<'t> Expr<'t> {
    fn node(self) -> Node {
        self.tree.nodes[self.index as usize]
    }

    /// The index in the tree, in the order of the text.
    pub(crate) fn index(self) -> u32 {
        self.index
    }

    fn text(self) -> &'t str {
        let node = self.node();
        &self.tree.text[node.start as usize..node.end as usize]
    }

    /// Whether it is a list, not a word.
    pub(crate) fn is_list(self) -> bool {
        self.tree.text.as_bytes()[self.node().start as usize] == b'('
    }

    /// The word; `None` for a list.
    pub fn word(self) -> Option<&'t str> {
        (!self.is_list()).then(|| self.text())
    }

    /// The elements of a list; none for a word.
    pub fn items(self) -> Items<'t> {
        Items { tree: self.tree, next: self.index + 1, end: self.node().after }
    }

    /// The first word of a list.
    ///
    /// ```
    /// use vc_tasks::format::sexpr::SexprTree;
    /// let tree = SexprTree::read("example", "(and\n (open door_1))")?;
    /// assert_eq!(tree.root().head(), Some("and"));
    /// let open = tree.root().items().last().ok_or("no element")?;
    /// assert_eq!(open.position(), (2, 2));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn head(self) -> Option<&'t str> {
        self.items().next()?.word()
    }

    /// The line and column where it begins, counted from one.
    pub fn position(self) -> (usize, usize) {
        line_and_column(&self.tree.text, self.node().start as usize)
    }

    /// An error that something else was expected here.
    pub(crate) fn error(self, expected: impl Into<String>) -> ReadError {
        let found = match self.head() {
            _ if !self.is_list() => format!("`{}`", clip(self.text())),
            Some(head) => format!("`({} ...)`", clip(head)),
            None if self.items().next().is_none() => "`()`".to_owned(),
            None => "`(( ...`".to_owned(),
        };
        ReadError::at(self.tree.format, &self.tree.text, self.node().start as usize, expected, found)
    }

    /// An error that an element is missing at the end of a list.
    pub(crate) fn error_at_end(self, expected: impl Into<String>) -> ReadError {
        let last = (self.node().end as usize).saturating_sub(1);
        ReadError::at(self.tree.format, &self.tree.text, last, expected, "`)`")
    }

    /// Whether two expressions read the same. Nesting is bounded, see [`DEEPEST`].
    pub fn same(self, other: Expr<'_>) -> bool {
        let alike = |(a, b): (Expr<'_>, Expr<'_>)| a.same(b);
        match (self.word(), other.word()) {
            (None, None) => self.items().count() == other.items().count() && self.items().zip(other.items()).all(alike),
            (mine, theirs) => mine == theirs,
        }
    }
}

impl fmt::Display for Expr<'_> {
    /// On one line, with one space between words.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(word) = self.word() {
            return f.write_str(word);
        }
        for (i, item) in self.items().enumerate() {
            write!(f, "{}{item}", if i == 0 { "(" } else { " " })?;
        }
        f.write_str(if self.items().next().is_none() { "()" } else { ")" })
    }
}

impl fmt::Debug for Expr<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

/// The elements of a list.
#[derive(Clone)]
pub struct Items<'t> {
    tree: &'t SexprTree,
    next: u32,
    end: u32,
}

impl<'t> Iterator for Items<'t> {
    type Item = Expr<'t>;

    fn next(&mut self) -> Option<Expr<'t>> {
        let here = (self.next < self.end).then_some(Expr { tree: self.tree, index: self.next })?;
        self.next = here.node().after;
        Some(here)
    }
}
