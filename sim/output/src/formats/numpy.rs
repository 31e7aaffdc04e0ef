//! NumPy's files.
//!
//! Source: NumPy Enhancement Proposal 1, "A simple file format for NumPy arrays", versions 1.0 to 3.0.

use crate::whole::whole;
use crate::write::WriteError;
use nalgebra::DMatrix;
use sim_runtime::{Column, Provenance, Table};
use std::io::{BufWriter, Error, Result, Seek, SeekFrom, Write};
use std::path::Path;
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, DateTime, ZipWriter};

/// One array of records, a field for each column: `numpy.load(path)["alpha"]`.
pub(super) fn write_npy(table: &Table, path: &Path) -> std::result::Result<(), WriteError> {
    let written = whole(path, |file| -> Result<()> {
        let mut out = BufWriter::new(file);
        let rows = table.times().len();
        out.write_all(&header(&fields(&table.columns), &[rows]))?;
        for row in 0..rows {
            for column in &table.columns {
                out.write_all(&column.values[row].to_le_bytes())?;
            }
        }
        out.flush()
    });
    written.map_err(|why| WriteError::new(path, why))
}

/// An archive with an array for each column: `numpy.load(path)["alpha"]`. Where it comes from is the archive's comment, as JSON:
/// `zipfile.ZipFile(path).comment`.
pub(super) fn write_npz(table: &Table, path: &Path) -> std::result::Result<(), WriteError> {
    let columns =
        table.columns.iter().map(|column| (column.name.as_str(), vec![column.values.len()], column.values.as_slice()));
    write_archive(columns, &table.provenance, path)
}

/// An archive with these matrices: `numpy.load(path)["A"]`.
pub fn write_matrices(
    matrices: &[(&str, &DMatrix<f64>)],
    provenance: &Provenance,
    path: &Path,
) -> std::result::Result<(), WriteError> {
    // nalgebra's matrices are stored by columns, NumPy's by rows.
    let rows: Vec<DMatrix<f64>> = matrices.iter().map(|(_, matrix)| matrix.transpose()).collect();
    let arrays = matrices.iter().zip(&rows);
    write_archive(
        arrays.map(|((name, matrix), rows)| (*name, vec![matrix.nrows(), matrix.ncols()], rows.as_slice())),
        provenance,
        path,
    )
}

fn write_archive<'a>(
    arrays: impl Iterator<Item = (&'a str, Vec<usize>, &'a [f64])>,
    provenance: &Provenance,
    path: &Path,
) -> std::result::Result<(), WriteError> {
    let written = whole(path, |file| -> Result<()> {
        let mut out = KeepsError { inner: BufWriter::new(file), error: None, position: 0 };
        let written = archive(arrays, &provenance.to_json().to_string(), &mut out);
        out.error.map_or(written, Err)
    });
    written.map_err(|why| WriteError::new(path, why))
}

/// A writer that keeps its first error and discards whatever follows: an archive that cannot be written would print a
/// message of its own when dropped.
struct KeepsError<W> {
    inner: W,
    error: Option<Error>,
    /// The position without the error.
    position: u64,
}

impl<W> KeepsError<W> {
    fn kept<T>(&mut self, instead: T, act: impl FnOnce(&mut W) -> Result<T>) -> Result<T> {
        if self.error.is_some() {
            return Ok(instead);
        }
        act(&mut self.inner).or_else(|error| {
            self.error = Some(error);
            Ok(instead)
        })
    }
}

impl<W: Write> Write for KeepsError<W> {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        self.position += bytes.len() as u64;
        self.kept(bytes.len(), |inner| inner.write_all(bytes).map(|()| bytes.len()))
    }

    fn flush(&mut self) -> Result<()> {
        self.kept((), Write::flush)
    }
}

impl<W: Seek> Seek for KeepsError<W> {
    fn seek(&mut self, to: SeekFrom) -> Result<u64> {
        self.position = match to {
            SeekFrom::Start(position) => position,
            SeekFrom::Current(offset) => self.position.saturating_add_signed(offset),
            SeekFrom::End(_) => self.position,
        };
        self.kept(self.position, |inner| inner.seek(to))
    }
}

fn archive<'a>(
    arrays: impl Iterator<Item = (&'a str, Vec<usize>, &'a [f64])>,
    comment: &str,
    out: impl Write + Seek,
) -> Result<()> {
    // Stored, as numpy.savez does, and without the time of day: the same table gives the same bytes.
    let stored = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .last_modified_time(DateTime::default());
    let mut archive = ZipWriter::new(out);
    // More than this an archive cannot say.
    if comment.len() <= usize::from(u16::MAX) {
        archive.set_comment(comment)?;
    }
    for (name, shape, values) in arrays {
        let stored = stored.large_file(8 * values.len() > u32::MAX as usize / 2);
        archive.start_file(format!("{name}.npy"), stored)?;
        archive.write_all(&header("'<f8'", &shape))?;
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        archive.write_all(&bytes)?;
    }
    archive.finish()?.flush()
}

/// The type of a record.
fn fields(columns: &[Column]) -> String {
    let fields: Vec<String> = columns.iter().map(|column| format!("('{}', '<f8')", column.name)).collect();
    format!("[{}]", fields.join(", "))
}

/// Magic, version, length and a Python dictionary, padded so that the numbers start at a multiple of 64 bytes.
fn header(kind: &str, shape: &[usize]) -> Vec<u8> {
    let sides: String = shape.iter().map(|side| format!("{side},")).collect();
    let text = format!("{{'descr': {kind}, 'fortran_order': False, 'shape': ({sides}), }}");
    // Version 1 allows 65535 bytes and Latin letters only; version 3 is for all others.
    let old = text.is_ascii() && text.len() < 65_000;
    let before = if old { 10 } else { 12 };
    let padding = (64 - (before + text.len() + 1) % 64) % 64;
    let length = text.len() + padding + 1;
    let mut header = b"\x93NUMPY".to_vec();
    if old {
        header.extend([1, 0]);
        header.extend((length as u16).to_le_bytes());
    } else {
        header.extend([3, 0]);
        header.extend((length as u32).to_le_bytes());
    }
    header.extend(text.bytes());
    header.extend(std::iter::repeat_n(b' ', padding));
    header.push(b'\n');
    header
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_start_at_multiples_of_64_bytes() {
        for rows in [0, 1, 12_345_678] {
            let header = header("'<f8'", &[rows]);
            assert!(
                header.len().is_multiple_of(64) && header.ends_with(b"\n") && header.starts_with(b"\x93NUMPY\x01\x00")
            );
            assert_eq!(usize::from(header[8]) + 256 * usize::from(header[9]), header.len() - 10);
        }
        let greek = header("[('\u{3b1}', '<f8')]", &[3]);
        assert!(greek.len().is_multiple_of(64) && greek[6] == 3);
    }
}
