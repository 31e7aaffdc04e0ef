//! Static figures, each as SVG and as PNG: curves over time, and a mechanism in several positions; and the report, a
//! page on which it moves.
//!
//! A figure is first laid out as a scene in logical pixels. The scene is written as SVG with real text, and the
//! PNG is that SVG rendered with two pixels to a logical one. Both say where they come from. The same input gives the same bytes.

#![cfg_attr(test, allow(clippy::unwrap_used))]

mod chunks;
mod dash;
mod decimate;
mod error;
mod figures;
mod font;
mod frame;
#[cfg(test)]
mod layout;
mod length;
mod mechanism;
mod names;
mod palette;
mod parts;
mod plot;
mod png;
mod report;
mod scene;
mod section;
mod svg;
mod sweep;
mod symbols;
mod text;
mod ticks;
mod trace;
mod vectors;
mod view;

use crate::whole::whole_bytes;
use sim_runtime::Provenance;
use std::fs;
use std::path::Path;

use scene::Scene;

pub use error::ShowError;
pub use figures::{Figures, figures};
pub use length::Length;
pub use parts::Shapes;
pub use report::{About, report};
pub use section::section_figures;
pub use sweep::sweep_figures;
pub use text::typeset;

// For the command line.
#[doc(hidden)]
pub use figures::figures_of;
#[doc(hidden)]
pub use report::{Live, live_report, report_of, report_text, sweep_report, sweep_report_text, waiting_page};
#[doc(hidden)]
pub use sweep::SWEEP_FIGURES;

/// A curve of a plot.
#[derive(Clone, Debug)]
pub struct Curve<'a> {
    /// Its label in the legend; units as in `m/s^2` are typeset.
    pub label: &'a str,
    /// Its values, as many as the plot has abscissae. Values that are not finite are gaps.
    pub values: Vec<f64>,
}

/// Curves over a common abscissa.
#[derive(Clone, Debug)]
pub struct Plot<'a> {
    /// The title; may be empty.
    pub title: &'a str,
    /// The label of the abscissa: `time [s]`.
    pub x_label: &'a str,
    /// The label of the ordinate: `angular speed [rad/s]`. If it is empty, the label of a single curve is used.
    pub y_label: &'a str,
    /// The abscissae.
    pub x: &'a [f64],
    /// The curves.
    pub curves: Vec<Curve<'a>>,
}

/// The size of a figure, in logical pixels: 96 to the inch. PNG has twice as many.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// Its width.
    pub width: f64,
    /// Its height, without a legend below the data.
    pub height: f64,
}

impl Default for Size {
    fn default() -> Size {
        Size { width: 960.0, height: 540.0 }
    }
}

/// How figures are written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FigureSettings {
    /// Their size.
    pub size: Size,
    /// Whether PNG are written beside SVG. They take most of the time.
    pub png: bool,
}

impl Default for FigureSettings {
    fn default() -> FigureSettings {
        Size::default().into()
    }
}

impl From<Size> for FigureSettings {
    /// In both formats.
    fn from(size: Size) -> FigureSettings {
        FigureSettings { size, png: true }
    }
}

/// One position of a mechanism.
#[derive(Clone, Copy, Debug)]
pub struct Pose<'a> {
    /// The numbers of the mechanism's shapes, in the order of its description.
    pub numbers: &'a [f64],
    /// What tells it from the others: the time, or the value of what is driven, in the unit of the heading.
    pub at: f64,
}

/// A mechanism in several positions.
#[derive(Clone, Copy, Debug)]
pub struct Positions<'a> {
    /// The title; may be empty.
    pub title: &'a str,
    /// What is drawn.
    pub shapes: Shapes<'a>,
    /// The unit of the axes.
    pub unit: Length<'a>,
    /// What poses differ in, with its unit: `t [s]`.
    pub heading: &'a str,
    /// The positions, the first of them strong and later ones fainter.
    pub poses: &'a [Pose<'a>],
    /// The numbers of the shapes at many samples in their order, through which traced points are drawn; may be empty.
    pub motion: &'a [Vec<f64>],
}

/// Writes the plot to `NAME.svg` and `NAME.png` in the directory, which is created if necessary.
///
/// # Errors
///
/// The plot has nothing to show, a curve has too few or too many values, or a file cannot be written.
pub fn plot(plot: &Plot, directory: &Path, name: &str) -> Result<(), ShowError> {
    panels(std::slice::from_ref(plot), Size::default(), directory, name)
}

/// Writes plots below each other, over one abscissa, to `NAME.svg` and `NAME.png` in the directory, which is made if
/// need be. The abscissa is named as the last plot says. Where so many need it, the figure is higher than its size says.
///
/// # Errors
///
/// As [`plot`].
pub fn panels(plots: &[Plot], size: Size, directory: &Path, name: &str) -> Result<(), ShowError> {
    panels_with(plots, size.into(), directory, name, &Provenance::default())
}

/// The same with more of its origin than the program.
#[doc(hidden)]
pub fn panels_with(
    plots: &[Plot],
    settings: FigureSettings,
    directory: &Path,
    name: &str,
    provenance: &Provenance,
) -> Result<(), ShowError> {
    save(&plot::scene(plots, settings.size, name)?, settings.png, directory, name, provenance)
}

/// Writes a plot of lengths against a length with equal scales, as the path of a point is drawn, to `NAME.svg` and `NAME.png`
/// in the directory, which is created if necessary. `ratio` is the size of the ordinate's unit in that of the abscissa.
///
/// # Errors
///
/// As [`plot`].
pub fn path(plot: &Plot, ratio: f64, size: Size, directory: &Path, name: &str) -> Result<(), ShowError> {
    path_with(plot, ratio, size.into(), directory, name, &Provenance::default())
}

/// The same with more of its origin than the program.
#[doc(hidden)]
pub fn path_with(
    plot: &Plot,
    ratio: f64,
    settings: FigureSettings,
    directory: &Path,
    name: &str,
    provenance: &Provenance,
) -> Result<(), ShowError> {
    save(&plot::path(plot, ratio, settings.size, name)?, settings.png, directory, name, provenance)
}

/// Writes a mechanism in several positions to `NAME.svg` and `NAME.png` in the directory, which is created if necessary, on a
/// sheet of about this size, with equal scales.
///
/// # Errors
///
/// There is nothing to show, a pose has too few or too many numbers, or a file cannot be written.
pub fn mechanism(positions: &Positions, size: Size, directory: &Path, name: &str) -> Result<(), ShowError> {
    mechanism_with(positions, size.into(), directory, name, &Provenance::default())
}

/// The same with more of its origin than the program.
#[doc(hidden)]
pub fn mechanism_with(
    positions: &Positions,
    settings: FigureSettings,
    directory: &Path,
    name: &str,
    provenance: &Provenance,
) -> Result<(), ShowError> {
    save(&mechanism::scene(positions, settings.size, name)?, settings.png, directory, name, provenance)
}

/// Writes a scene as SVG and, if asked for, as PNG.
fn save(scene: &Scene, png: bool, directory: &Path, name: &str, provenance: &Provenance) -> Result<(), ShowError> {
    let document = svg::document(scene, provenance);
    fs::create_dir_all(directory).map_err(|why| ShowError::write(directory, why))?;
    let path = directory.join(format!("{name}.svg"));
    whole_bytes(&path, document.as_bytes()).map_err(|why| ShowError::write(&path, why))?;
    match png {
        true => png::write(scene, provenance, &directory.join(format!("{name}.png"))),
        false => Ok(()),
    }
}
