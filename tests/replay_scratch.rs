mod common;
use vc_graph::format::eai;
use vc_graph::format::virtualhome::{EnvironmentGraph, RelationType};
use vc_graph::*;
use std::collections::BTreeSet;
#[test]
fn scratch() {
    let classes = ClassTable::builtin();
    for line in common::text("eai/programs_dev.jsonl.gz").unwrap().lines() {
        let r = eai::read_record(line).unwrap();
        let g = r.initial.build("x", &classes).unwrap();
        let agent = g.agents()[0];
        let mut sim = Simulator::new(g);
        let mut ok = true;
        for a in &r.actions {
            if let Err(e) = sim.step(agent, a) { println!("{} REFUSED {} : {}", r.id, a.describe(sim.graph()), e[0]); ok=false; break; }
        }
        if !ok { continue; }
        let ours = EnvironmentGraph::of(sim.graph());
        let theirs = EnvironmentGraph::of(&r.last.build("x",&classes).unwrap());
        let a: BTreeSet<_> = ours.edges.iter().copied().collect();
        let b: BTreeSet<_> = theirs.edges.iter().copied().collect();
        let l = |id: u32| sim.graph().label(NodeId(id)).to_string();
        for e in a.difference(&b).filter(|e| e.relation_type != RelationType::Close) { println!("{} only ours: {} {:?} {}", r.id, l(e.from_id), e.relation_type, l(e.to_id)); }
        for e in b.difference(&a).filter(|e| e.relation_type != RelationType::Close) { println!("{} only theirs: {} {:?} {}", r.id, l(e.from_id), e.relation_type, l(e.to_id)); }
        let c1 = a.difference(&b).filter(|e| e.relation_type == RelationType::Close).count();
        let c2 = b.difference(&a).filter(|e| e.relation_type == RelationType::Close).count();
        for e in a.difference(&b).filter(|e| e.relation_type == RelationType::Close && e.from_id==65) { println!("   {} only ours: {} {:?} {}", r.id, l(e.from_id), e.relation_type, l(e.to_id)); }
        for e in b.difference(&a).filter(|e| e.relation_type == RelationType::Close&& e.from_id==65) { println!("   {} only theirs: {} {:?} {}", r.id, l(e.from_id), e.relation_type, l(e.to_id)); }
        if c1+c2>0 { println!("{} close: {} only ours, {} only theirs", r.id, c1, c2); }
        for (x,y) in ours.nodes.iter().zip(&theirs.nodes) { if x.states != y.states { println!("{} state {} ours {:?} theirs {:?}", r.id, l(x.id), x.states, y.states); } }
    }
}
