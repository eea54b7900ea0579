//! The attempt that an error is about.

use std::borrow::Cow;
use std::fmt;

use vc_graph::{Action, SceneGraph};

/// Something that an agent was to do: an action, or a control of its body.
///
/// ```
/// use virtualcity::{ActionError, Control, Environment};
/// let mut home = Environment::builder("apartment/42").bodies(false).make()?;
/// let refused = home.control(home.agents()[0], &Control::default());
/// let Err(ActionError::Impossible { attempt, .. }) = refused else { return Err("nobody is controlled".into()) };
/// assert_eq!((attempt.action(), attempt.to_string()), (None, "control".to_owned()));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Attempt(Box<Attempted>);

/// Boxed, as results that hardly ever fail should be small.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Attempted {
    action: Option<Action>,
    text: Cow<'static, str>,
}

impl Attempt {
    /// An action, with the labels that a scene gives its things.
    pub(crate) fn new(action: &Action, graph: &SceneGraph) -> Self {
        let text = action.describe(graph).to_string().into();
        Self(Box::new(Attempted { action: Some(*action), text }))
    }

    /// Something that is no action: a control of a body.
    pub(super) fn named(text: &'static str) -> Self {
        Self(Box::new(Attempted { action: None, text: text.into() }))
    }

    /// The action, if it was one.
    pub fn action(&self) -> Option<Action> {
        self.0.action
    }
}

/// The action with the labels of its things (`grab cup.12`), or the name of the control.
impl fmt::Display for Attempt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.text)
    }
}
