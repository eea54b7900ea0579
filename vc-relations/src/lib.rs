//! Relations read from geometry.
//!
//! This crate is reserved: nothing is built here yet, and nothing is public. It
//! will hold the six box traces of the thesis: a box of about an object's shape is
//! swept in six directions, and what it hits says what the object is on, in, under
//! and near. Input and output will be types of `vc-graph`.
