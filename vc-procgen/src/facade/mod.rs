//! Facades: walls with windows, shop fronts and doors, courses between storeys, roofs.
//!
//! A [`Style`] of `data/facades.txt` is held along a street; [`Facade`] is what a building draws from it. [`Shell`] is a building
//! from outside, [`Pane`] a window of the room behind, [`Side`] a side of its outline.

mod pane;
mod panel;
mod roof;
mod shell;
mod side;
mod style;

pub(crate) use pane::{Pane, PaneKind, of_flat, of_unit};
pub(crate) use panel::{Panel, around};
pub(crate) use shell::{Level, Shell};
pub(crate) use side::{Side, sides};
pub(crate) use style::Facade;
