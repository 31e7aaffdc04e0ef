//! The frame of plots and drawings: axes, grid, names, legend.

use super::ShowError;
use super::dash::dashes;
use super::palette::{AXIS, Colour, GRID, INK, ZERO};
use super::scene::{Anchor, Label, Point, Scene, fit, most_room, room};
use super::ticks::{Axis, FEW, Round};

const TITLE: f64 = 20.0;
const NAME: f64 = 17.0;
const NUMBER: f64 = 15.0;
const LEGEND: f64 = 16.0;

/// The space around everything.
const MARGIN: f64 = 14.0;
/// The length of a tick.
const TICK: f64 = 6.0;
/// The length of the line before an entry of a legend.
const SAMPLE: f64 = 30.0;
/// The distance between rows of a legend.
const ROW: f64 = 25.0;
/// The distance from a legend to its figure, and between columns.
const APART: f64 = 22.0;
/// The height of a line of text above the data.
pub(super) const LINE: f64 = NAME + 6.0;
/// The widest legend beside the data.
const WIDEST: f64 = 300.0;

/// The data area, on the sheet and in numbers.
pub(super) struct Frame {
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
    pub(super) x: Axis,
    pub(super) y: Axis,
    /// Whether the lines at zero stand out from the grid.
    pub(super) zero: bool,
}

/// The text around the data area.
pub(super) struct Names<'a> {
    pub(super) title: &'a str,
    pub(super) x: &'a str,
    pub(super) y: &'a str,
    /// Whether the ordinate's name stands level above the data area, and not upright beside it.
    pub(super) above: bool,
}

/// An entry of a legend.
pub(super) struct Entry {
    pub(super) label: String,
    pub(super) colour: Colour,
    pub(super) width: f64,
    pub(super) style: Style,
}

/// The dashes of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Style {
    Solid,
    Dashed,
    Dotted,
}

impl Style {
    /// The lines a polyline is drawn by.
    pub(super) fn lines(self, points: Vec<Point>) -> Vec<Vec<Point>> {
        match self {
            Style::Solid => vec![points],
            Style::Dashed => dashes(&points, 9.0, 7.0, 0.0),
            Style::Dotted => dashes(&points, 1.0, 6.0, 0.0),
        }
    }
}

/// Entries, and where they are.
pub(super) struct Legend {
    entries: Vec<Entry>,
    heading: Option<String>,
    column: f64,
    beside: bool,
}

impl Legend {
    /// A legend beside the data if it fits there, otherwise below.
    pub(super) fn new(entries: Vec<Entry>, heading: Option<String>, height: f64) -> Result<Self, ShowError> {
        let labels = most_room(entries.iter().map(|entry| entry.label.as_str()).chain(heading.as_deref()), LEGEND)?;
        let column = SAMPLE + 8.0 + labels;
        let rows = entries.len() + usize::from(heading.is_some());
        let beside = column <= WIDEST && rows as f64 * ROW <= height;
        Ok(Legend { entries, heading, column, beside })
    }

    /// A legend beside the data, with long labels cut.
    pub(super) fn beside(entries: Vec<Entry>) -> Result<Self, ShowError> {
        let legend = Legend::new(entries, None, f64::INFINITY)?;
        Ok(Legend { column: legend.column.min(WIDEST), beside: true, ..legend })
    }

    /// The width it takes beside the data.
    pub(super) fn width(&self) -> f64 {
        if self.beside && !self.entries.is_empty() { APART + self.column } else { 0.0 }
    }

    /// The height of its entries beside the data.
    pub(super) fn rows(&self) -> f64 {
        ROW * self.places() as f64
    }

    /// The height it takes below, on a sheet of this width.
    pub(super) fn height(&self, width: f64) -> f64 {
        if self.beside || self.entries.is_empty() {
            return 0.0;
        }
        12.0 + ROW * (self.places() as f64 / self.columns(width) as f64).ceil()
    }

    fn places(&self) -> usize {
        self.entries.len() + usize::from(self.heading.is_some())
    }

    fn columns(&self, width: f64) -> usize {
        let most = (width - 2.0 * MARGIN + APART) / (self.column + APART);
        (most.floor() as usize).clamp(1, self.places().max(1))
    }

    /// Draws it beside the data area or at the foot of the sheet.
    pub(super) fn draw(&self, scene: &mut Scene, frame: &Frame) -> Result<(), ShowError> {
        let columns = if self.beside { 1 } else { self.columns(scene.width) };
        let corner = if self.beside {
            (frame.right + APART, frame.top)
        } else {
            let width = columns as f64 * (self.column + APART) - APART;
            let left = ((frame.left + frame.right - width) / 2.0).min(scene.width - MARGIN - width).max(MARGIN);
            (left, scene.height - self.height(scene.width))
        };
        let place = |index: usize| {
            let (row, column) = (index / columns, index % columns);
            (corner.0 + column as f64 * (self.column + APART), corner.1 + (row as f64 + 0.5) * ROW)
        };
        if let Some(heading) = &self.heading {
            let at = place(0);
            scene.text(heading, (at.0, at.1 + 0.35 * LEGEND), LEGEND, Anchor::Start, INK);
        }
        for (index, entry) in self.entries.iter().enumerate() {
            let at = place(index + usize::from(self.heading.is_some()));
            for line in entry.style.lines(vec![at, (at.0 + SAMPLE, at.1)]) {
                scene.line(line, entry.width, entry.colour);
            }
            let space = (scene.width - at.0).min(self.column.max(WIDEST)) - SAMPLE - 8.0;
            let (label, size) = fit(&entry.label, LEGEND, space)?;
            scene.text(&label, (at.0 + SAMPLE + 8.0, at.1 + 0.35 * size), size, Anchor::Start, INK);
        }
        Ok(())
    }
}

/// The least distance of ticks, in numbers, on a level axis of this range and width: their labels do not touch, and they are a
/// few, if there is room for them.
pub(super) fn apart(range: (f64, f64), width: f64, round: Round) -> Result<f64, ShowError> {
    let unit = (range.1 - range.0) / width;
    // The usual distances, wider ones for long labels, nearer ones on short axes.
    let mut most: Option<(usize, f64)> = None;
    for least in [60.0, 80.0, 110.0, 150.0, 200.0, 50.0, 40.0, 30.0] {
        let ticks = Axis::new(range, least * unit, round).ticks;
        let labels = most_room(ticks.iter().map(|tick| tick.label.as_str()), NUMBER)?;
        if ticks.windows(2).any(|pair| pair[1].at - pair[0].at < (labels + 14.0) * unit) {
            continue;
        }
        if ticks.len() >= FEW {
            return Ok(least * unit);
        }
        if most.is_none_or(|(count, _)| ticks.len() > count) {
            most = Some((ticks.len(), least));
        }
    }
    Ok(most.map_or(300.0, |(_, least)| least) * unit)
}

/// The room left of the data area, with or without the ordinate's name.
pub(super) fn left_room(y: &Axis, named: bool) -> Result<f64, ShowError> {
    let numbers = most_room(y.ticks.iter().map(|tick| tick.label.as_str()), NUMBER)?;
    let name = if named { NAME + 12.0 } else { 0.0 };
    Ok(MARGIN + name + numbers.max(20.0) + TICK + 5.0)
}

/// The room right of the data area, without the legend.
pub(super) fn right_room(x: &Axis) -> Result<f64, ShowError> {
    let number = x.ticks.last().map_or(Ok(0.0), |tick| room(&tick.label, NUMBER))?;
    Ok(MARGIN.max(number / 2.0) + 4.0)
}

/// The room above the data area, with or without a line of text next to it: a note or the ordinate's name.
pub(super) fn top_room(title: &str, line: bool) -> f64 {
    let title = if title.is_empty() { 0.0 } else { TITLE + 14.0 };
    let line = if line { LINE } else { 0.0 };
    MARGIN + title + line
}

/// The room below the data area, without the legend.
pub(super) fn bottom_room() -> f64 {
    TICK + 4.0 + NUMBER + 10.0 + NAME + MARGIN
}

impl Frame {
    /// The place of a data point on the sheet.
    pub(super) fn place(&self, point: Point) -> Point {
        let across = self.x.share(point.0) * (self.right - self.left);
        (self.left + across, self.bottom - self.y.share(point.1) * (self.bottom - self.top))
    }

    /// Draws grid and axes.
    pub(super) fn draw(&self, scene: &mut Scene, names: &Names) -> Result<(), ShowError> {
        self.draw_grid(scene);
        self.draw_axes(scene);
        self.draw_names(scene, names)
    }

    fn draw_grid(&self, scene: &mut Scene) {
        for zero in [false, true] {
            let colour = if zero && self.zero { ZERO } else { GRID };
            for tick in self.x.ticks.iter().filter(|tick| (tick.at == 0.0) == zero) {
                let x = self.place((tick.at, self.y.low)).0;
                scene.line(vec![(x, self.top), (x, self.bottom)], 1.0, colour);
            }
            for tick in self.y.ticks.iter().filter(|tick| (tick.at == 0.0) == zero) {
                let y = self.place((self.x.low, tick.at)).1;
                scene.line(vec![(self.left, y), (self.right, y)], 1.0, colour);
            }
        }
    }

    fn draw_axes(&self, scene: &mut Scene) {
        let corners = vec![(self.left, self.top), (self.left, self.bottom), (self.right, self.bottom)];
        scene.line(corners, 1.2, AXIS);
        for tick in &self.x.ticks {
            let x = self.place((tick.at, self.y.low)).0;
            scene.line(vec![(x, self.bottom), (x, self.bottom + TICK)], 1.2, AXIS);
            let at = (x, self.bottom + TICK + 4.0 + 0.8 * NUMBER);
            scene.text(&tick.label, at, NUMBER, Anchor::Middle, INK);
        }
        for tick in &self.y.ticks {
            let y = self.place((self.x.low, tick.at)).1;
            scene.line(vec![(self.left - TICK, y), (self.left, y)], 1.2, AXIS);
            let at = (self.left - TICK - 5.0, y + 0.35 * NUMBER);
            scene.text(&tick.label, at, NUMBER, Anchor::End, INK);
        }
    }

    /// Writes the title above the data area.
    pub(super) fn draw_title(&self, scene: &mut Scene, title: &str) -> Result<(), ShowError> {
        let middle = (self.left + self.right) / 2.0;
        let space = 2.0 * (middle.min(scene.width - middle) - MARGIN);
        let (title, size) = fit(title, TITLE, space)?;
        scene.text(&title, (middle, MARGIN + 0.8 * TITLE), size, Anchor::Middle, INK);
        Ok(())
    }

    fn draw_names(&self, scene: &mut Scene, names: &Names) -> Result<(), ShowError> {
        self.draw_title(scene, names.title)?;
        let middle = (self.left + self.right) / 2.0;
        let note = self.y.note.as_deref().unwrap_or("");
        match names.above {
            true => self.draw_line_above(scene, names.y, note)?,
            false => {
                scene.text(note, (self.left - TICK, self.top - 8.0), NAME, Anchor::Start, INK);
                let at = (MARGIN + 0.8 * NAME, (self.top + self.bottom) / 2.0);
                let (text, size) = fit(names.y, NAME, self.bottom - self.top + 40.0)?;
                scene.label(Label { text, at, size, anchor: Anchor::Middle, upwards: true, colour: INK });
            }
        }

        let below = self.bottom + TICK + 4.0 + NUMBER + 10.0 + 0.7 * NAME;
        let note = self.x.note.as_deref().unwrap_or("");
        scene.text(note, (self.right, below), NAME, Anchor::End, INK);
        let space = self.right - self.left - 2.0 * room(note, NAME)?;
        let (name, size) = fit(names.x, NAME, space)?;
        scene.text(&name, (middle, below), size, Anchor::Middle, INK);
        Ok(())
    }

    /// The ordinate's name, and after it what its labels are to be multiplied with.
    fn draw_line_above(&self, scene: &mut Scene, name: &str, note: &str) -> Result<(), ShowError> {
        let taken = if note.is_empty() { 0.0 } else { room(note, NAME)? + APART };
        let (name, size) = fit(name, NAME, self.right - self.left - taken)?;
        let base = self.top - 8.0;
        scene.text(&name, (self.left, base), size, Anchor::Start, INK);
        scene.text(note, (self.left + room(&name, size)? + APART, base), NAME, Anchor::Start, INK);
        Ok(())
    }
}
