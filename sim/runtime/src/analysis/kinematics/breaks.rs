//! Where loads and constraints change their form along a step of a sweep: its quantities are searched from one such place to the
//! next, so that none passes unseen between two nodes.

use super::piece::Piece;
use super::search::Search;
use super::series::{NODES, Series, nodes};
use crate::numerics::root::find_root;
use sim_kernel::Switching;
use std::convert::Infallible;

/// The error of a polynomial through a condition, beside its largest value, with which its zeros are known; and the number of
/// halvings of an interval in which it is larger.
const RESOLVED: f64 = 1e-9;
const MOST_HALVINGS: usize = 6;
/// The part of an interval by which it ends before a break: what jumps there has one value in it.
const ASIDE: f64 = 1e-9;

impl Search<'_> {
    /// The intervals between the breaks of one.
    pub(super) fn between_breaks(&self, piece: &Piece, [from, to]: [f64; 2]) -> Vec<[f64; 2]> {
        let mut breaks = Vec::new();
        self.find_breaks(piece, [from, to], 0, &mut breaks);
        breaks.sort_by(f64::total_cmp);
        let ends: Vec<f64> = [from].into_iter().chain(breaks).chain([to]).collect();
        let last = ends.len() - 2;
        let part = |i: usize| {
            let aside = ASIDE * (ends[i + 1] - ends[i]);
            let [begin, end] = [i > 0, i < last].map(|is_break| if is_break { aside } else { 0.0 });
            [ends[i] + begin, ends[i + 1] - end]
        };
        let longest = to - from;
        (0..=last).map(part).filter(|[begin, end]| end - begin > f64::EPSILON * longest).collect()
    }

    /// The conditions at a place, if there is a motion.
    fn conditions(&self, piece: &Piece, x: f64) -> Option<Vec<f64>> {
        let motion = self.path.motion_at(piece, x).ok()?;
        let mechanism = self.path.system.mechanism;
        let mut all = mechanism.load_conditions(motion.at());
        all.extend(mechanism.switching_functions(motion.at().time));
        Some(all)
    }

    fn find_breaks(&self, piece: &Piece, [from, to]: [f64; 2], halvings: usize, found: &mut Vec<f64>) {
        let description = self.path.system.mechanism.description();
        let functions: Vec<&Switching> = description.load_conditions.iter().chain(description.switching).collect();
        if functions.is_empty() {
            return;
        }
        let place = |x: f64| from + (to - from) * (1.0 + x) / 2.0;
        let rows: Option<Vec<Vec<f64>>> = nodes().into_iter().map(|x| self.conditions(piece, place(x))).collect();
        let Some(rows) = rows else { return };
        let ends = [-1.0, 1.0].map(|x| self.conditions(piece, place(x)));
        let series = |k: usize| Series::through(std::array::from_fn(|node: usize| rows[node][k]));
        let is_resolved = |k: usize| {
            let largest = rows.iter().fold(0.0, |largest: f64, row| largest.max(row[k].abs()));
            let off = |(x, end): (f64, &Option<Vec<f64>>)| {
                end.as_ref().map_or(0.0, |values| (values[k] - series(k).at(x)).abs())
            };
            let off = [-1.0, 1.0].into_iter().zip(&ends).map(off).fold(series(k).tail(), f64::max);
            !largest.is_finite() || off <= RESOLVED * largest
        };
        if halvings < MOST_HALVINGS && !(0..functions.len()).all(is_resolved) {
            let middle = (from + to) / 2.0;
            self.find_breaks(piece, [from, middle], halvings + 1, found);
            return self.find_breaks(piece, [middle, to], halvings + 1, found);
        }
        for (k, function) in functions.into_iter().enumerate() {
            let values: [f64; NODES] = std::array::from_fn(|node| rows[node][k]);
            if values.iter().all(|value| value.is_finite()) {
                found.extend(crossings(function, &Series::through(values)).into_iter().map(place));
            }
        }
    }
}

/// Where a function takes a value at which expressions change their form.
fn crossings(function: &Switching, series: &Series) -> Vec<f64> {
    let turns: Vec<f64> = [-1.0].into_iter().chain(series.turns()).chain([1.0]).collect();
    let crossed = |pair: &[f64]| {
        let ends = [series.at(pair[0]), series.at(pair[1])];
        let (least, greatest) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let rows = function.table.map(|table| {
            let next = move |row: &f64| Some(table.next_row(*row));
            std::iter::successors(Some(table.next_row(least)), next).take_while(move |row| *row < greatest)
        });
        let zero = rows.is_none().then_some(0.0).filter(|_| least < 0.0 && greatest > 0.0);
        let levels = rows.into_iter().flatten().chain(zero);
        let root = |level: f64| {
            let at = |fraction: f64| pair[0] + fraction * (pair[1] - pair[0]);
            let mut beyond = |fraction: f64| Ok::<f64, Infallible>(series.at(at(fraction)) - level);
            find_root(ends[0] - level, ends[1] - level, 1e-15, &mut beyond).ok().map(at)
        };
        levels.filter_map(root).collect::<Vec<f64>>()
    };
    turns.windows(2).flat_map(crossed).collect()
}
