//! Errors of the oracle.

use std::fmt;

/// Why a declaration could not be evaluated.
///
/// A declaration that the later stages accept never causes one, except where the equations of motion are singular.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OracleError(String);

impl OracleError {
    pub(super) fn new(message: impl Into<String>) -> OracleError {
        OracleError(message.into())
    }
}

impl fmt::Display for OracleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for OracleError {}

/// A result of the oracle.
pub type Result<T> = std::result::Result<T, OracleError>;

pub(super) fn refuse<T>(message: impl Into<String>) -> Result<T> {
    Err(OracleError::new(message))
}
