//! What is told on standard error.

/// A line on standard error. Where nobody can hear it, as on a full disk or a closed pipe, the exit status still tells.
macro_rules! tell {
    ($($words:tt)*) => {{
        use std::io::Write as _;
        let _ = writeln!(std::io::stderr(), $($words)*);
    }};
}
pub(crate) use tell;
