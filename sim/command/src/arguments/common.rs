//! Arguments of several commands.

use crate::missing;
use clap::Args;
use sim_output::Format;
use sim_output::show::FigureSettings;
use sim_runtime::Table;
use std::borrow::Cow;

/// The form of the output.
#[derive(Args, Clone, Copy)]
pub(crate) struct Voice {
    /// Prints JSON, for programs.
    #[arg(long, global = true, conflicts_with = "quiet")]
    pub(crate) json: bool,

    /// Prints nothing but errors.
    #[arg(long, short, global = true)]
    pub(crate) quiet: bool,
}

/// Width and height, in logical pixels.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Size(pub(crate) f64, pub(crate) f64);

impl Size {
    /// For figures.
    pub(crate) fn show(self) -> sim_output::show::Size {
        sim_output::show::Size { width: self.0, height: self.1 }
    }
}

impl std::str::FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Size, String> {
        let side = |text: &str| text.parse().ok().filter(|side| (240.0..=8000.0).contains(side));
        let sides = text.split_once('x').and_then(|(width, height)| Some(Size(side(width)?, side(height)?)));
        sides.ok_or_else(|| "width and height from 240 to 8000 are needed, as in 960x540".to_owned())
    }
}

impl std::fmt::Display for Size {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}x{}", self.0, self.1)
    }
}

/// Which files are written, and how large figures are.
#[derive(Args)]
pub(crate) struct WrittenArguments {
    /// Formats of the table: csv, jsonl, npy, npz and, if built in, parquet.
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', default_value = "csv", value_parser = format)]
    pub(crate) format: Vec<Format>,

    /// Columns of the table, besides the time, as in `--columns 'alpha*,work'`; `*` stands for anything [default: all].
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    pub(crate) columns: Vec<String>,

    /// Width and height of figures in pixels of SVG; PNG has twice as many.
    #[arg(long, value_name = "WxH", default_value = "960x540")]
    pub(crate) size: Size,

    /// Begins trajectory.csv with lines after `#` that say where it comes from; readers have to be told, as pandas by
    /// `comment="#"`.
    #[arg(long)]
    pub(crate) csv_comments: bool,

    /// Writes no figures.
    #[arg(long)]
    pub(crate) no_figures: bool,

    /// Writes figures as SVG alone, which is faster.
    #[arg(long)]
    pub(crate) no_png: bool,
}

impl WrittenArguments {
    /// The asked columns of a table.
    ///
    /// # Errors
    /// If one is not there.
    pub(crate) fn chosen<'t>(&self, table: &'t Table) -> Result<Cow<'t, Table>, String> {
        if self.columns.is_empty() {
            return Ok(Cow::Borrowed(table));
        }
        let names: Vec<&str> = table.columns.iter().map(|column| column.name.as_str()).collect();
        table.choose(&self.columns).map(Cow::Owned).map_err(|word| missing("column", word, &names))
    }

    /// How figures are written.
    pub(crate) fn figures(&self) -> FigureSettings {
        FigureSettings { size: self.size.show(), png: !self.no_png }
    }
}

pub(crate) fn format(name: &str) -> Result<Format, String> {
    let names = || Format::ALL.iter().map(|format| format.name());
    let found = Format::ALL.iter().copied().find(|format| format.name() == name);
    found.ok_or_else(|| match name {
        "parquet" => "this program was built without the feature `parquet`".to_owned(),
        _ => format!("known are {}", names().collect::<Vec<_>>().join(", ")),
    })
}

/// A mechanism and its start.
#[derive(Args)]
pub(crate) struct StartArguments {
    /// The mechanism, as `list` names it, or a file that declares it: FILE or FILE:NAME.
    pub(crate) model: String,

    /// Sets a parameter, as in `--set O2A=180mm`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE")]
    pub(crate) set: Vec<String>,

    /// Sets a start value, as in `--initial alpha=30deg`; may be repeated.
    #[arg(long, value_name = "NAME=VALUE", allow_hyphen_values = true)]
    pub(crate) initial: Vec<String>,
}
