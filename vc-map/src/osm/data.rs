//! The content of a file of OpenStreetMap, packed: tags are numbers of words, lists are ranges of one long list.

use std::collections::HashMap;
use std::ops::Range;

use super::OsmError;

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
    tags: Range<u32>,
}

#[derive(Debug, Clone)]
pub(super) struct Way {
    pub(super) id: i64,
    refs: Range<u32>,
    tags: Range<u32>,
}

#[derive(Debug, Clone)]
pub(super) struct Relation {
    pub(super) id: i64,
    members: Range<u32>,
    tags: Range<u32>,
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
    /// South, west, north and east edge, degrees, if the file says so.
    pub(super) bounds: Option<[f64; 4]>,
    refs: Vec<i64>,
    members: Vec<Member>,
    tags: Vec<[u32; 2]>,
    words: Words,
}

/// Every word once.
#[derive(Debug, Default)]
struct Words {
    text: String,
    ranges: Vec<Range<u32>>,
    /// The words of each hash; looked up only, so that its order does not matter.
    numbers: HashMap<u64, u32>,
}

impl Words {
    /// The number of a word. Words whose hashes collide are kept twice.
    fn number(&mut self, word: &str) -> u32 {
        let hash = vc_graph::hash::fnv1a(word.bytes());
        if let Some(number) = self.numbers.get(&hash).copied().filter(|number| self.word(*number) == word) {
            return number;
        }
        let start = self.text.len() as u32;
        self.text.push_str(word);
        self.ranges.push(start..self.text.len() as u32);
        let number = self.ranges.len() as u32 - 1;
        self.numbers.insert(hash, number);
        number
    }

    fn word(&self, number: u32) -> &str {
        self.ranges.get(number as usize).map_or("", |range| &self.text[range.start as usize..range.end as usize])
    }
}

/// The tags of an element.
#[derive(Clone, Copy)]
pub(super) struct Tags<'a> {
    data: &'a OsmData,
    tags: &'a [[u32; 2]],
}

impl<'a> Tags<'a> {
    /// The value of a key.
    pub(super) fn get(self, key: &str) -> Option<&'a str> {
        let found = self.tags.iter().find(|[k, _]| self.data.words.word(*k) == key);
        found.map(|[_, value]| self.data.words.word(*value))
    }

    /// Whether a key has one of some values, parted by `|`.
    pub(super) fn is(self, key: &str, values: &str) -> bool {
        self.get(key).is_some_and(|value| values.split('|').any(|other| other == value))
    }

    pub(super) fn is_empty(self) -> bool {
        self.tags.is_empty()
    }
}

/// The lists of elements that are being read.
#[derive(Default)]
pub(super) struct Open {
    pub(super) refs: usize,
    pub(super) members: usize,
    pub(super) tags: usize,
}

impl OsmData {
    /// The number of nodes, ways and relations.
    pub fn counts(&self) -> [usize; 3] {
        [self.nodes.len(), self.ways.len(), self.relations.len()]
    }

    /// The bytes that it takes: at most 20 times those of the file.
    pub fn bytes(&self) -> usize {
        fn list<T>(list: &Vec<T>) -> usize {
            list.capacity() * size_of::<T>()
        }
        let lists =
            list(&self.nodes) + list(&self.ways) + list(&self.relations) + list(&self.refs) + list(&self.members);
        let words = self.words.text.capacity() + list(&self.words.ranges) + self.words.numbers.capacity() * 24;
        lists + list(&self.tags) + words
    }

    pub(super) fn open(&self) -> Open {
        Open { refs: self.refs.len(), members: self.members.len(), tags: self.tags.len() }
    }

    pub(super) fn add_tag(&mut self, key: &str, value: &str) {
        let tag = [self.words.number(key), self.words.number(value)];
        self.tags.push(tag);
    }

    pub(super) fn add_ref(&mut self, node: i64) {
        self.refs.push(node);
    }

    pub(super) fn add_member(&mut self, element: Element, role: &str) {
        let role = self.words.number(role);
        self.members.push(Member { element, role });
    }

    /// Adds a node at degrees of latitude and longitude.
    pub(super) fn add_node(&mut self, id: i64, at: [f64; 2], open: &Open) -> Result<(), OsmError> {
        let [latitude, longitude] = at;
        if !(latitude.abs() <= 90.0 && longitude.abs() <= 180.0) {
            return Err(OsmError::Place(id));
        }
        let at = at.map(|degrees| (degrees * 1e7).round() as i32);
        self.nodes.push(Node { id, at, tags: open.tags as u32..self.tags.len() as u32 });
        Ok(())
    }

    pub(super) fn add_way(&mut self, id: i64, open: &Open) {
        let refs = open.refs as u32..self.refs.len() as u32;
        self.ways.push(Way { id, refs, tags: open.tags as u32..self.tags.len() as u32 });
    }

    pub(super) fn add_relation(&mut self, id: i64, open: &Open) {
        let members = open.members as u32..self.members.len() as u32;
        self.relations.push(Relation { id, members, tags: open.tags as u32..self.tags.len() as u32 });
    }

    /// Sorts nodes by their numbers; of those that occur twice the first stays.
    pub(super) fn close(&mut self) {
        self.nodes.sort_by_key(|node| node.id);
        self.nodes.dedup_by_key(|node| node.id);
        self.ways.sort_by_key(|way| way.id);
        self.ways.dedup_by_key(|way| way.id);
        self.relations.sort_by_key(|relation| relation.id);
        self.relations.dedup_by_key(|relation| relation.id);
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

    fn tags(&self, tags: &Range<u32>) -> Tags<'_> {
        Tags { data: self, tags: &self.tags[tags.start as usize..tags.end as usize] }
    }

    pub(super) fn node_tags(&self, node: &Node) -> Tags<'_> {
        self.tags(&node.tags)
    }

    pub(super) fn way_tags(&self, way: &Way) -> Tags<'_> {
        self.tags(&way.tags)
    }

    pub(super) fn relation_tags(&self, relation: &Relation) -> Tags<'_> {
        self.tags(&relation.tags)
    }
}
