//! What is found about mechanisms, as text, tables, figures and reports: read by people and by other programs.

mod formats;
mod happening;
mod outcome;
pub mod show;
mod whole;
mod write;

pub use formats::{Format, write_table};
pub use write::{WriteError, summary, write_commented_csv, write_csv, write_json};

// For the command line, which is compiled once for all mechanisms.
#[doc(hidden)]
pub use formats::write_matrices;
#[doc(hidden)]
pub use happening::{happening, impulses};
#[doc(hidden)]
pub use outcome::{Outcome, Recorded, Until, list};
#[doc(hidden)]
pub use whole::whole;
#[doc(hidden)]
pub use write::summary_of;
