//! Tables in expressions.

use super::{Expr, Graph, Node, Table, TableId};

impl Graph {
    /// Adds a table; equal tables are interned.
    pub fn add_table(&mut self, table: Table) -> TableId {
        let known = self.tables.iter().position(|other| *other == table);
        let index = known.unwrap_or_else(|| {
            self.tables.push(table);
            self.tables.len() - 1
        });
        TableId(index as u32)
    }

    /// The tables, by index.
    pub fn tables(&self) -> &[Table] {
        &self.tables
    }

    /// A table.
    pub fn table(&self, id: TableId) -> &Table {
        &self.tables[id.index()]
    }

    /// All look-ups, by table and order of the derivative.
    pub fn look_ups(&self) -> Vec<(Expr, TableId, u8)> {
        let look_up = |(index, node): (usize, &Node)| match node {
            Node::Table(table, order, _) => Some((Expr::at(index), *table, *order)),
            _ => None,
        };
        self.nodes().enumerate().filter_map(look_up).collect()
    }

    /// The derivative of some order of a table at an argument; 0 beyond its degree.
    pub fn look_up(&mut self, id: TableId, order: u8, argument: Expr) -> Expr {
        match order > self.table(id).degree {
            true => self.zero(),
            false => self.intern(Node::Table(id, order, argument)),
        }
    }
}
