//! Apache Parquet.

use crate::table::Table;
use crate::write::WriteError;
use parquet::basic::Repetition;
use parquet::basic::Type as Physical;
use parquet::data_type::DoubleType;
use parquet::errors::Result;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::Type;
use std::fs::File;
use std::path::Path;
use std::sync::Arc;

/// A column of doubles for each of the table's, and `unit:NAME` for each in the file's metadata.
pub(super) fn write(table: &Table, path: &Path) -> std::result::Result<(), WriteError> {
    let write = || -> Result<()> {
        let file = File::create(path)?;
        let columns = table.columns.iter().map(|column| {
            let kind = Type::primitive_type_builder(&column.name, Physical::DOUBLE);
            Ok(Arc::new(kind.with_repetition(Repetition::REQUIRED).build()?))
        });
        let columns: Result<Vec<_>> = columns.collect();
        let schema = Arc::new(Type::group_type_builder("trajectory").with_fields(columns?).build()?);
        let unit = |name: &str, unit: &str| KeyValue::new(format!("unit:{name}"), unit.to_owned());
        let units = table.columns.iter().map(|column| unit(&column.name, column.unit)).collect();
        let properties = WriterProperties::builder().set_key_value_metadata(Some(units)).build();
        let mut writer = SerializedFileWriter::new(file, schema, Arc::new(properties))?;
        let mut rows = writer.next_row_group()?;
        for column in &table.columns {
            if let Some(mut out) = rows.next_column()? {
                out.typed::<DoubleType>().write_batch(&column.values, None, None)?;
                out.close()?;
            }
        }
        rows.close()?;
        writer.close()?;
        Ok(())
    };
    write().map_err(|why| WriteError::new(path, why))
}
