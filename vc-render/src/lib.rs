//! Pictures of a scene.
//!
//! This crate is reserved: nothing is built here yet, and nothing is public. It
//! will render six modalities from one camera, on a CPU by default: RGB, instance
//! and class segmentation, optical flow, depth, bounding boxes and object masks.
