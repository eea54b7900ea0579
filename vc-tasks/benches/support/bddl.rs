//! Activities of BEHAVIOR as goals: as much of BDDL as the bench of goals needs.

use std::collections::BTreeMap;
use std::path::Path;

use vc_graph::goal::{Comparison, Goal, Literal, Pairing, Pairs, Predicate, Quantified, Term, Variable};
use vc_graph::{NodeId, Relation, State};
use vc_tasks::compile::Things;

/// An activity: its goal, its objects by class, and what holds at the start.
pub(crate) struct Activity {
    pub(crate) goal: Goal,
    pub(crate) objects: Objects,
    pub(crate) start: Vec<Literal>,
}

/// Objects by class; node 1 is the first that is declared.
#[derive(Default)]
pub(crate) struct Objects {
    names: BTreeMap<String, NodeId>,
    classes: BTreeMap<String, Vec<NodeId>>,
}

impl Things for Objects {
    fn each(&self, class: Option<&str>, things: &mut Vec<NodeId>) {
        match class {
            Some(class) => things.extend(self.classes.get(class).into_iter().flatten()),
            None => things.extend(self.names.values()),
        }
    }

    fn agent(&self) -> NodeId {
        NodeId(0)
    }
}

/// All activities under a folder, sorted by path; those that do not read are counted.
pub(crate) fn read_all(folder: &Path) -> (Vec<Activity>, usize) {
    let mut files = Vec::new();
    find(folder, &mut files);
    files.sort();
    let texts = files.iter().filter_map(|file| std::fs::read_to_string(file).ok());
    let read: Vec<Option<Activity>> = texts.map(|text| activity(&text)).collect();
    let failed = read.iter().filter(|a| a.is_none()).count();
    (read.into_iter().flatten().collect(), failed)
}

fn find(folder: &Path, files: &mut Vec<std::path::PathBuf>) {
    for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            find(&path, files);
        } else if path.file_name().is_some_and(|n| n.to_string_lossy().starts_with("problem"))
            && path.extension().is_some_and(|e| e == "bddl")
        {
            files.push(path);
        }
    }
}

enum Tree {
    Word(String),
    List(Vec<Tree>),
}

impl Tree {
    fn word(&self) -> Option<&str> {
        if let Self::Word(word) = self { Some(word.trim_start_matches('?')) } else { None }
    }

    fn list(&self) -> Option<&[Tree]> {
        if let Self::List(list) = self { Some(list) } else { None }
    }
}

fn parse(text: &str) -> Option<Tree> {
    let plain: String = text.lines().map(|line| line.split(';').next().unwrap_or("").to_lowercase() + " ").collect();
    let mut open = vec![Vec::new()];
    for token in plain.replace('(', " ( ").replace(')', " ) ").split_whitespace() {
        match token {
            "(" => open.push(Vec::new()),
            ")" => {
                let list = Tree::List(open.pop()?);
                open.last_mut()?.push(list);
            }
            word => open.last_mut()?.push(Tree::Word(word.to_owned())),
        }
    }
    open.pop()?.into_iter().next()
}

fn activity(text: &str) -> Option<Activity> {
    let tree = parse(text)?;
    let section = |name: &str| {
        let found = tree.list()?.iter().filter_map(Tree::list).find(|l| l.first().and_then(Tree::word) == Some(name));
        found.map(|l| &l[1..])
    };
    let objects = objects(section(":objects")?)?;
    let reader = Reader { objects: &objects };
    let goal = reader.goal(section(":goal")?.first()?, &mut Vec::new())?;
    let fact = |tree: &Tree| match reader.goal(tree, &mut Vec::new()) {
        Some(Goal::Literal(literal)) => Some(literal),
        _ => None,
    };
    let start = section(":init")?.iter().filter_map(fact).collect();
    Some(Activity { goal, objects, start })
}

fn objects(section: &[Tree]) -> Option<Objects> {
    let mut objects = Objects::default();
    let (mut pending, mut at) = (Vec::new(), 0);
    while let Some(tree) = section.get(at) {
        match tree.word()? {
            "-" => {
                at += 1;
                let class = section.get(at)?.word()?;
                objects.classes.entry(class.to_owned()).or_default().append(&mut pending);
            }
            name if !objects.names.contains_key(name) => {
                let id = NodeId(objects.names.len() as u32 + 1);
                objects.names.insert(name.to_owned(), id);
                pending.push(id);
            }
            _ => {}
        }
        at += 1;
    }
    Some(objects)
}

struct Reader<'o> {
    objects: &'o Objects,
}

impl Reader<'_> {
    fn goal(&self, tree: &Tree, bound: &mut Vec<String>) -> Option<Goal> {
        let (head, rest) = tree.list()?.split_first()?;
        let boxed = |i: usize, bound: &mut Vec<String>| self.goal(rest.get(i)?, bound).map(Box::new);
        Some(match head.word()? {
            "and" => Goal::And(rest.iter().map(|t| self.goal(t, bound)).collect::<Option<_>>()?),
            "or" => Goal::Or(rest.iter().map(|t| self.goal(t, bound)).collect::<Option<_>>()?),
            "not" => Goal::Not(boxed(0, bound)?),
            "imply" => Goal::Imply(boxed(0, bound)?, boxed(1, bound)?),
            "forall" => Goal::ForAll(self.quantified(rest, bound)?),
            "exists" => Goal::Exists(self.quantified(rest, bound)?),
            "forn" => {
                let number = rest.first()?.list()?.first()?.word()?.parse().ok()?;
                Goal::ForN { comparison: Comparison::Exactly, number, of: self.quantified(&rest[1..], bound)? }
            }
            "forpairs" => self.pairs(rest, bound)?,
            predicate => {
                let terms: Vec<Term> = rest.iter().map(|t| self.term(t, bound)).collect::<Option<_>>()?;
                Goal::Literal(Literal { predicate: meaning(predicate)?, terms })
            }
        })
    }

    fn variable(&self, tree: &Tree) -> Option<Variable> {
        let [name, _, class] = tree.list()? else { return None };
        Some(Variable { name: name.word()?.to_owned(), class: Some(class.word()?.to_owned()) })
    }

    fn quantified(&self, rest: &[Tree], bound: &mut Vec<String>) -> Option<Quantified> {
        let Variable { name, class } = self.variable(rest.first()?)?;
        bound.push(name.clone());
        let body = self.goal(rest.get(1)?, bound).map(Box::new);
        bound.pop();
        Some(Quantified { variable: name, class, body: body? })
    }

    fn pairs(&self, rest: &[Tree], bound: &mut Vec<String>) -> Option<Goal> {
        let (first, second) = (self.variable(rest.first()?)?, self.variable(rest.get(1)?)?);
        bound.extend([first.name.clone(), second.name.clone()]);
        let body = self.goal(rest.get(2)?, bound).map(Box::new);
        bound.truncate(bound.len() - 2);
        Some(Goal::ForPairs(Pairs { first, second, number: None, pairing: Pairing::Matching, body: body? }))
    }

    fn term(&self, tree: &Tree, bound: &[String]) -> Option<Term> {
        let name = tree.word()?;
        match bound.iter().any(|b| b == name) {
            true => Some(Term::Variable(name.to_owned())),
            false => self.objects.names.get(name).map(|&id| Term::Node(None, id)),
        }
    }
}

fn meaning(word: &str) -> Option<Predicate> {
    Some(match word {
        "cooked" => Predicate::State(State::Cooked),
        "frozen" => Predicate::State(State::Frozen),
        "open" => Predicate::State(State::Open),
        "folded" => Predicate::State(State::Folded),
        "unfolded" => Predicate::State(State::Unfolded),
        "toggled_on" => Predicate::State(State::On),
        "hot" => Predicate::State(State::Hot),
        "on_fire" => Predicate::State(State::OnFire),
        "broken" => Predicate::State(State::Broken),
        "future" => Predicate::State(State::Future),
        "real" => Predicate::Real,
        "saturated" => Predicate::Relation(Relation::Saturated),
        "covered" => Predicate::Relation(Relation::Covered),
        "filled" => Predicate::Relation(Relation::FilledWith),
        "contains" => Predicate::Relation(Relation::Contains),
        "insource" => Predicate::Relation(Relation::SourceOf),
        "ontop" => Predicate::Relation(Relation::On),
        "nextto" => Predicate::Relation(Relation::Beside),
        "under" => Predicate::Relation(Relation::Under),
        "touching" => Predicate::Relation(Relation::Touching),
        "inside" => Predicate::Relation(Relation::Inside),
        "overlaid" => Predicate::Relation(Relation::Overlaid),
        "attached" => Predicate::Relation(Relation::Attached),
        "draped" => Predicate::Relation(Relation::Draped),
        "grasped" => Predicate::Holds,
        _ => return None,
    })
}
