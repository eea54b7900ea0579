//! The part of a node that the thesis's format has no words for, under a key of ours that other readers pass over.

use serde::{Deserialize, Serialize};

use super::super::FormatProblem;
use crate::serial::{BoundsFile, FARTHEST, within};
use crate::spelling::{clip, key};
use crate::vocabulary::Word;
use crate::{Bounds, BoundsFrame, Class, ClassTable, Draft, Node, Property, PropertySet, State, StateSet};

/// Metres, in our axes. A field is there where the rest of the object would be read otherwise.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(super) struct Beyond {
    /// The class, where the name does not say it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) class: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    category: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    properties: Option<Vec<Property>>,
    /// States in which its class starts and it is not.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    without: Vec<State>,
    /// The box, where it does not stand on the node's origin, is along the world's axes, or is of no class's.
    #[serde(skip_serializing_if = "Option::is_none")]
    bounds: Option<BoundsFile>,
    #[serde(skip_serializing_if = "Option::is_none")]
    contents: Option<String>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    lacks: Vec<Lack>,
}

/// The facts that a node lacks and every object of the thesis has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Lack {
    Pose,
    Box,
}

impl Beyond {
    /// The facts that reading a node by its name, its states and its scale would not tell; `bounds` is its box, where
    /// these do not tell that.
    pub(super) fn new(node: &Node, name: &str, classes: &ClassTable, bounds: Option<Bounds>) -> Option<Self> {
        let spec = node.spec();
        let named = classes.get(name);
        let is_named = *spec.class == *named.map_or_else(|| key(name).into(), |c| c.name.clone());
        let class = classes.get(&spec.class);
        let lacks = [
            (Lack::Pose, node.pose().is_none()),
            (Lack::Box, spec.bounds.is_none() && class.is_some_and(|c| c.typical_size().is_some())),
        ];
        let read = entered(class, node.states());
        let beyond = Self {
            class: (!is_named).then(|| spec.spelling.to_string()),
            category: (*spec.category != *category(class)).then(|| spec.category.to_string()),
            properties: (spec.properties != affordances(class)).then(|| spec.properties.iter().collect()),
            without: read.minus(node.states()).iter().collect(),
            bounds: bounds.as_ref().map(BoundsFile::from),
            contents: node.contents().map(|c| c.to_string()),
            lacks: lacks.into_iter().filter_map(|(lack, does)| does.then_some(lack)).collect(),
        };
        (beyond != Self::default()).then_some(beyond)
    }

    /// Adds it to what the rest of the object says, at whose pose the base of the box is.
    pub(super) fn add_to(&self, draft: &mut Draft, class: Option<&Class>) -> Result<(), FormatProblem> {
        draft.category = self.category.as_deref().map(Into::into);
        draft.properties = self.properties.as_ref().map(|all| all.iter().copied().collect());
        draft.contents = self.contents.as_deref().map(Into::into);
        let without: StateSet = self.without.iter().copied().collect();
        draft.states = (!without.is_empty()).then(|| starts(class).minus(without));
        if let Some(file) = &self.bounds {
            let bounds = file.bounds().ok_or_else(|| FormatProblem::Number(clip(&format!("{file:?}"))))?;
            draft.pose = draft.pose.map(|base| above(&base, &bounds));
            let far = draft.pose.filter(|pose| !within(pose.translation.vector.as_slice(), FARTHEST));
            far.map_or(Ok(()), |pose| Err(FormatProblem::Number(clip(&format!("{pose}")))))?;
            draft.bounds = Some(bounds);
        }
        for lack in &self.lacks {
            match lack {
                Lack::Pose => draft.pose = None,
                Lack::Box => draft.bounds = None,
            }
        }
        Ok(())
    }
}

/// From the origin of a node to the middle of the base of its box, in the axes of the box.
pub(super) fn down(bounds: &Bounds) -> nalgebra::Vector3<f32> {
    bounds.offset - nalgebra::Vector3::z() * bounds.half.z
}

/// The pose of a node whose box has the middle of its base at a pose.
fn above(base: &crate::Pose, bounds: &Bounds) -> crate::Pose {
    let up = nalgebra::Translation3::from(-down(bounds));
    match bounds.frame {
        BoundsFrame::Object => base * up,
        BoundsFrame::World => up * base,
    }
}

fn starts(class: Option<&Class>) -> StateSet {
    class.map_or(StateSet::EMPTY, |c| c.starts)
}

/// The states of a thing of a class that enters some.
fn entered(class: Option<&Class>, states: StateSet) -> StateSet {
    states.iter().fold(starts(class), StateSet::entering)
}

fn affordances(class: Option<&Class>) -> PropertySet {
    class.map_or(PropertySet::EMPTY, |c| c.affordances)
}

fn category(class: Option<&Class>) -> &str {
    class.map_or("prop", |c| c.category.as_str())
}
