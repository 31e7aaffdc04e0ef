//! Hessenberg form by reflections.

use super::Form;
use super::balance::length;
use std::ops::Range;

/// Brings a diagonal block to Hessenberg form: nothing below the first subdiagonal.
pub(super) fn reduce(form: &mut Form, block: Range<usize>) {
    for k in block.start..block.end.saturating_sub(2) {
        let below: Vec<f64> = (k + 1..block.end).map(|i| form.t[(i, k)]).collect();
        let Some(reflection) = Reflection::of(&below) else { continue };
        reflection.apply(form, k + 1, k + 1, block.end);
        form.t[(k + 1, k)] = reflection.length;
        (k + 2..block.end).for_each(|i| form.t[(i, k)] = 0.0);
    }
}

/// I - 2 w w'/w'w, which takes a vector to a multiple of the first unit vector.
pub(super) struct Reflection {
    /// w, its first entry 1.
    w: Vec<f64>,
    /// 2/w'w.
    weight: f64,
    /// That multiple.
    pub(super) length: f64,
}

impl Reflection {
    /// No reflection if the vector is such a multiple already.
    pub(super) fn of(v: &[f64]) -> Option<Reflection> {
        let (first, rest) = v.split_first()?;
        if rest.iter().all(|entry| *entry == 0.0) {
            return None;
        }
        let length = -length(v.iter().copied()).copysign(*first);
        let w = [1.0].into_iter().chain(rest.iter().map(|entry| entry / (first - length))).collect();
        Some(Reflection { w, weight: (length - first) / length, length })
    }

    /// T = R T R and Z = Z R where the reflection R acts on the entries from `at`: the rows from column `from` on, and the columns
    /// down to row `to`.
    pub(super) fn apply(&self, Form { t, z }: &mut Form, at: usize, from: usize, to: usize) {
        let n = t.nrows();
        for j in from..n {
            let share = self.weight * self.w.iter().enumerate().map(|(k, w)| w * t[(at + k, j)]).sum::<f64>();
            self.w.iter().enumerate().for_each(|(k, w)| t[(at + k, j)] -= share * w);
        }
        for (matrix, rows) in [(t, to), (z, n)] {
            for i in 0..rows {
                let share = self.weight * self.w.iter().enumerate().map(|(k, w)| w * matrix[(i, at + k)]).sum::<f64>();
                self.w.iter().enumerate().for_each(|(k, w)| matrix[(i, at + k)] -= share * w);
            }
        }
    }
}
