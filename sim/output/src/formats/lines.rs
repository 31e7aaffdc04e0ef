//! JSON lines.

use crate::whole::whole;
use crate::write::WriteError;
use sim_runtime::Table;
use std::io::{BufWriter, Result, Write};
use std::path::Path;

pub(super) fn write(table: &Table, path: &Path) -> std::result::Result<(), WriteError> {
    whole(path, |file| rows(table, BufWriter::new(file))).map_err(|why| WriteError::new(path, why))
}

fn rows(table: &Table, mut out: impl Write) -> Result<()> {
    for row in 0..table.times().len() {
        for (i, column) in table.columns.iter().enumerate() {
            let before = if i == 0 { '{' } else { ',' };
            write!(out, "{before}{}:{}", serde_json::Value::from(column.name.as_str()), number(column.values[row]))?;
        }
        out.write_all(b"}\n")?;
    }
    out.flush()
}

fn number(value: f64) -> String {
    if value.is_finite() { format!("{value:?}") } else { "null".into() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use sim_runtime::Column;

    #[test]
    fn rows_are_objects() {
        let column =
            |name: &str, values: &[f64]| Column { name: name.into(), unit: "s".into(), values: values.to_vec() };
        let table = Table::from_columns(vec![column("t", &[0.0, 0.1]), column("x", &[1e-300, f64::NAN])]);
        let mut text = Vec::new();
        rows(&table, &mut text).unwrap();
        assert_eq!(String::from_utf8(text).unwrap(), "{\"t\":0.0,\"x\":1e-300}\n{\"t\":0.1,\"x\":null}\n");
    }
}
