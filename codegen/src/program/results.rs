//! The results of a kernel, over expressions, values or trees.

use crate::kernel_id::Record;

/// The results of a kernel.
pub enum Results<T> {
    /// One number.
    Scalar(T),
    /// A vector, or a struct with a field for each entry.
    Vector(Vec<T>),
    /// A matrix by rows, with its number of columns.
    Matrix(usize, Vec<Vec<T>>),
    /// A matrix of so many rows and columns by the entries that are not always 0, each with its row and column.
    Sparse([usize; 2], Vec<([usize; 2], T)>),
    /// A struct by its fields.
    Record(Record, Vec<(String, Results<T>)>),
    /// Whether a pivot is refused, from each pivot with the magnitude of its terms; without pivots every state is
    /// refused.
    Refused(Option<Vec<(T, T)>>),
}

impl<T> Results<T> {
    /// A struct of fields in order.
    pub(super) fn record<const N: usize>(record: Record, fields: [(&str, Results<T>); N]) -> Results<T> {
        Results::Record(record, fields.into_iter().map(|(name, field)| (name.to_owned(), field)).collect())
    }

    /// How many entries a vector has; 0 of anything else.
    pub(super) fn vector_len(&self) -> usize {
        if let Results::Vector(entries) = self { entries.len() } else { 0 }
    }

    /// Every entry, in order.
    pub fn entries(&self) -> Vec<&T> {
        let mut entries = Vec::new();
        self.visit(&mut |entry| entries.push(entry));
        entries
    }

    fn visit<'a>(&'a self, f: &mut dyn FnMut(&'a T)) {
        match self {
            Results::Scalar(entry) => f(entry),
            Results::Vector(entries) => entries.iter().for_each(f),
            Results::Matrix(_, rows) => rows.iter().flatten().for_each(f),
            Results::Sparse(_, entries) => entries.iter().for_each(|(_, entry)| f(entry)),
            Results::Record(_, fields) => fields.iter().for_each(|(_, field)| field.visit(f)),
            Results::Refused(pivots) => pivots.iter().flatten().for_each(|(pivot, terms)| {
                f(pivot);
                f(terms);
            }),
        }
    }

    /// The same with every entry replaced.
    pub(super) fn map<U>(&self, f: &mut dyn FnMut(&T) -> U) -> Results<U> {
        match self {
            Results::Scalar(entry) => Results::Scalar(f(entry)),
            Results::Vector(entries) => Results::Vector(entries.iter().map(f).collect()),
            Results::Matrix(columns, rows) => {
                Results::Matrix(*columns, rows.iter().map(|row| row.iter().map(&mut *f).collect()).collect())
            }
            Results::Sparse(size, entries) => {
                Results::Sparse(*size, entries.iter().map(|(place, entry)| (*place, f(entry))).collect())
            }
            Results::Record(record, fields) => {
                Results::Record(*record, fields.iter().map(|(name, field)| (name.clone(), field.map(f))).collect())
            }
            Results::Refused(pivots) => Results::Refused(
                pivots.as_ref().map(|pivots| pivots.iter().map(|(pivot, terms)| (f(pivot), f(terms))).collect()),
            ),
        }
    }
}
