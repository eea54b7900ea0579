//! The content of a file of OpenStreetMap, packed: tags are numbers of words, lists are ranges of one long list.

use std::ops::Range;

use super::words::{Full, Room, Words};

/// A part of the data.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Element {
    /// A node.
    Node(i64),
    /// A way.
    Way(i64),
    /// A relation.
    Relation(i64),
}

impl Element {
    /// Its number among those of its kind.
    pub fn id(self) -> i64 {
        match self {
            Self::Node(id) | Self::Way(id) | Self::Relation(id) => id,
        }
    }
}

impl std::fmt::Display for Element {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Node(id) => write!(f, "node {id}"),
            Self::Way(id) => write!(f, "way {id}"),
            Self::Relation(id) => write!(f, "relation {id}"),
        }
    }
}

#[derive(Debug, Clone)]
pub(super) struct Node {
    pub(super) id: i64,
    /// Degrees of latitude and longitude times ten million, as in the database.
    pub(super) at: [i32; 2],
    pub(super) tags: Range<u32>,
}

impl Node {
    /// Degrees of latitude and longitude.
    pub(super) fn degrees(&self) -> [f64; 2] {
        self.at.map(|tiny| f64::from(tiny) / 1e7)
    }
}

#[derive(Debug, Clone)]
pub(super) struct Way {
    pub(super) id: i64,
    refs: Range<u32>,
    pub(super) tags: Range<u32>,
}

#[derive(Debug, Clone)]
pub(super) struct Relation {
    pub(super) id: i64,
    members: Range<u32>,
    pub(super) tags: Range<u32>,
}

/// A member of a relation: what it is, and the number of its role's word.
#[derive(Debug, Clone, Copy)]
pub(super) struct Member {
    pub(super) element: Element,
    role: u32,
}

/// The content of a file of OpenStreetMap: nodes, ways and relations with their tags. [`Self::draft`](OsmData::draft) makes a map
/// of it.
#[derive(Debug, Default)]
pub struct OsmData {
    pub(super) nodes: Vec<Node>,
    pub(super) ways: Vec<Way>,
    pub(super) relations: Vec<Relation>,
    /// Elements whose number another one had before.
    pub(super) repeated: Vec<Element>,
    /// South, west, north and east edge, degrees, if the file says so.
    pub(super) bounds: Option<[f64; 4]>,
    refs: Vec<i64>,
    members: Vec<Member>,
    pub(super) tags: Vec<[u32; 2]>,
    words: Words,
    /// How far all of these may still grow.
    pub(super) room: Room,
    /// The bytes of the file.
    pub(super) size: usize,
}

/// The lists of elements that are being read.
#[derive(Default)]
pub(super) struct Open {
    pub(super) refs: usize,
    pub(super) members: usize,
    pub(super) tags: usize,
}

impl OsmData {
    /// Nothing yet of a file of some bytes.
    pub(super) fn of_file(size: usize, room: Room) -> Self {
        Self { size, room, ..Self::default() }
    }

    /// The number of nodes, ways and relations.
    pub fn counts(&self) -> [usize; 3] {
        [self.nodes.len(), self.ways.len(), self.relations.len()]
    }

    /// The bytes that it takes: at most 20 times those of the file.
    pub fn bytes(&self) -> usize {
        fn list<T>(list: &Vec<T>) -> usize {
            list.capacity() * size_of::<T>()
        }
        let elements = list(&self.nodes) + list(&self.ways) + list(&self.relations) + list(&self.repeated);
        elements + list(&self.refs) + list(&self.members) + list(&self.tags) + self.words.bytes()
    }

    /// Notes the edges, as finely as places of nodes, so that each form of a file gives the same ones.
    pub(super) fn set_bounds(&mut self, edges: [f64; 4]) {
        self.bounds = Some(edges.map(|degrees| (degrees * 1e7).round() / 1e7));
    }

    pub(super) fn open(&self) -> Open {
        Open { refs: self.refs.len(), members: self.members.len(), tags: self.tags.len() }
    }

    /// The number of a word, by which tags and roles name it. Its end is cut off if it is longer than any should be.
    pub(super) fn number(&mut self, word: &str) -> Result<u32, Full> {
        self.words.number(cut(word), &mut self.room)
    }

    pub(super) fn word(&self, number: u32) -> &str {
        self.words.word(number)
    }

    /// Adds a tag by the numbers of its key and value.
    pub(super) fn add_tag(&mut self, tag: [u32; 2]) -> Result<(), Full> {
        self.room.push(&mut self.tags, tag)
    }

    pub(super) fn add_ref(&mut self, node: i64) -> Result<(), Full> {
        self.room.push(&mut self.refs, node)
    }

    /// Adds a member by the number of its role.
    pub(super) fn add_member(&mut self, element: Element, role: u32) -> Result<(), Full> {
        self.room.push(&mut self.members, Member { element, role })
    }

    /// Adds a node at degrees of latitude and longitude that are on Earth.
    pub(super) fn add_node(&mut self, id: i64, at: [f64; 2], open: &Open) -> Result<(), Full> {
        let at = at.map(|degrees| (degrees * 1e7).round() as i32);
        let node = Node { id, at, tags: open.tags as u32..self.tags.len() as u32 };
        self.room.push(&mut self.nodes, node)
    }

    pub(super) fn add_way(&mut self, id: i64, open: &Open) -> Result<(), Full> {
        let refs = open.refs as u32..self.refs.len() as u32;
        let way = Way { id, refs, tags: open.tags as u32..self.tags.len() as u32 };
        self.room.push(&mut self.ways, way)
    }

    pub(super) fn add_relation(&mut self, id: i64, open: &Open) -> Result<(), Full> {
        let members = open.members as u32..self.members.len() as u32;
        let relation = Relation { id, members, tags: open.tags as u32..self.tags.len() as u32 };
        self.room.push(&mut self.relations, relation)
    }

    /// Sorts elements by their numbers; of those that occur twice the first stays, and the others are noted.
    pub(super) fn close(&mut self) -> Result<(), Full> {
        let (noted, room) = (&mut self.repeated, &mut self.room);
        once(&mut self.nodes, |node| Element::Node(node.id), noted, room)?;
        once(&mut self.ways, |way| Element::Way(way.id), noted, room)?;
        once(&mut self.relations, |relation| Element::Relation(relation.id), noted, room)
    }

    /// The position of a node.
    pub(super) fn node(&self, id: i64) -> Option<usize> {
        self.nodes.binary_search_by_key(&id, |node| node.id).ok()
    }

    pub(super) fn way(&self, id: i64) -> Option<&Way> {
        self.ways.binary_search_by_key(&id, |way| way.id).ok().map(|index| &self.ways[index])
    }

    pub(super) fn refs(&self, way: &Way) -> &[i64] {
        &self.refs[way.refs.start as usize..way.refs.end as usize]
    }

    pub(super) fn members(&self, relation: &Relation) -> &[Member] {
        &self.members[relation.members.start as usize..relation.members.end as usize]
    }

    pub(super) fn role(&self, member: Member) -> &str {
        self.words.word(member.role)
    }
}

/// The longest word, bytes. The database takes 255 characters.
const LONGEST: usize = 255;

fn cut(word: &str) -> &str {
    let fits = |end: &usize| word.is_char_boundary(*end);
    let end = (0..=LONGEST.min(word.len())).rev().find(fits).unwrap_or(0);
    &word[..end]
}

fn once<T>(
    list: &mut Vec<T>,
    element: impl Fn(&T) -> Element,
    noted: &mut Vec<Element>,
    room: &mut Room,
) -> Result<(), Full> {
    list.sort_by_key(&element);
    let mut full = Ok(());
    list.dedup_by(|later, first| {
        let same = element(later) == element(first);
        if same {
            full = full.and(room.push(noted, element(later)));
        }
        same
    });
    full
}
