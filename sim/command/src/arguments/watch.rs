//! The arguments of `watch`.

use super::RunArguments;
use super::common::{Size, WrittenArguments};
use crate::settings::SettingsArguments;
use clap::Args;
use sim_output::Format;

/// The arguments of `watch`.
#[derive(Args)]
#[command(after_help = "Example:\n  sim watch linkage.mech --t-end 5\n\n\
    Prints an address for a browser on this computer. The page follows the file and the tables that it names: what is saved is\n\
    run as `run` does and shown within a moment; time, view, zoom and choices stay. Mistakes are shown at their line, over\n\
    the last good report. Nothing is written. Whoever knows the address can look, on this computer alone. Ctrl-C ends it.")]
pub(crate) struct WatchArguments {
    /// A file that declares the mechanism: FILE or FILE:NAME.
    #[arg(value_name = "FILE")]
    pub(crate) model: String,

    /// The port of 127.0.0.1 to listen on; 0 leaves the choice to the system.
    #[arg(long, value_name = "PORT", default_value_t = 0)]
    pub(crate) port: u16,

    #[command(flatten)]
    settings: SettingsArguments,

    /// Sets a parameter, as in `--set O2A=180mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,

    /// Sets a start value, as in `--initial alpha=30deg`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    initial: Vec<String>,

    /// Holds an input at a value instead of its declared course, as in `--input tau=0.5`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    input: Vec<String>,
}

impl WatchArguments {
    /// Those of `run` that make the same run.
    pub(crate) fn as_of_run(&self) -> RunArguments {
        RunArguments {
            model: self.model.clone(),
            settings: self.settings.clone(),
            set: self.set.clone(),
            initial: self.initial.clone(),
            input: self.input.clone(),
            out: None,
            written: WrittenArguments {
                format: vec![Format::Csv],
                columns: Vec::new(),
                size: Size(960.0, 540.0),
                csv_comments: false,
                no_figures: false,
                no_png: false,
            },
            no_report: false,
            no_comparison: false,
        }
    }
}
