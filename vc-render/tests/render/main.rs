//! Tests of pictures, in one program: each program links anew. Those of `golden` and `memory` are apart, because they
//! write files and count what is allocated.

#[path = "../common/mod.rs"]
mod common;

mod amodal;
mod beside;
mod boxes;
mod camera;
mod colours;
mod covers;
mod cull;
mod detail;
mod doors;
mod edges;
mod exact;
mod files;
mod finer;
mod flow;
mod home;
mod hung;
mod labels;
mod light;
mod liquid;
mod looks;
mod mirror;
mod modalities;
mod moving;
mod odd;
mod other;
mod panes;
mod penumbra;
mod smooth;
mod specks;
mod texture;
mod tone;
mod viewpoints;
