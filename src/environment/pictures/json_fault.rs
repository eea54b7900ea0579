//! Faults of JSON texts, in errors that are compared.

use std::sync::Arc;

/// The reason why a JSON text cannot be read, with line and column. Two are equal that say the same.
///
/// ```
/// use virtualcity::{CameraError, Environment};
/// let mut home = Environment::make("apartment/42", 1)?;
/// let Err(CameraError::NotAList(fault)) = home.add_cameras("[\n1]") else { return Err("1 is no camera".into()) };
/// assert_eq!((fault.line(), fault.column()), (2, 1));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug, Clone, thiserror::Error)]
#[error(transparent)]
pub struct JsonFault(Arc<serde_json::Error>);

impl JsonFault {
    /// The line of the text, counted from 1; 0 if it has none.
    pub fn line(&self) -> usize {
        self.0.line()
    }

    /// The column of the line, counted from 1; 0 if it has none.
    pub fn column(&self) -> usize {
        self.0.column()
    }
}

impl From<serde_json::Error> for JsonFault {
    fn from(error: serde_json::Error) -> Self {
        Self(Arc::new(error))
    }
}

impl PartialEq for JsonFault {
    fn eq(&self, other: &Self) -> bool {
        self.to_string() == other.to_string()
    }
}
