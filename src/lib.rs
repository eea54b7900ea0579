//! VirtualCity.
pub use vc_graph as graph;
