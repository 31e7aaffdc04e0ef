//! A kernel as the graph of its operations, for display.

use super::{Columns, Kernel, LookUp, Statement, Tree, Wave};
use rustc_hash::FxHashMap;

/// The operations of a kernel, operands before what uses them.
pub struct Diagram {
    /// Values, each once.
    pub vertices: Vec<Vertex>,
    /// The results, by vertex.
    pub results: Vec<usize>,
}

/// A value: an operation on others, an input or a number.
pub struct Vertex {
    /// The operation, the input or the number.
    pub label: String,
    /// The local name that the value has.
    pub name: Option<String>,
    /// The operands by vertex, each with whether it is subtracted.
    pub operands: Vec<(bool, usize)>,
}

impl Diagram {
    /// The graph of a kernel.
    pub fn of(kernel: &Kernel) -> Diagram {
        let mut drawing = Drawing::default();
        for statement in &kernel.statements {
            match statement {
                Statement::Let { name, value } => {
                    let vertex = drawing.tree(value);
                    drawing.name(vertex, name);
                }
                Statement::SinCos(waves) => waves.iter().for_each(|wave| drawing.wave(wave)),
                Statement::Table(look_up) => drawing.look_up(look_up),
                Statement::Columns(columns) => drawing.columns(columns),
            }
        }
        let mut results = Vec::new();
        kernel.results.entries().into_iter().for_each(|tree| results.push(drawing.tree(tree)));
        Diagram { vertices: drawing.vertices, results }
    }

    /// The number of operations without sharing.
    pub fn operations_without_sharing(&self) -> f64 {
        let mut operations: Vec<f64> = Vec::with_capacity(self.vertices.len());
        for vertex in &self.vertices {
            let own = match vertex.operands.len() {
                0 => 0,
                1 => 1,
                n => n - 1,
            };
            let below: f64 = vertex.operands.iter().map(|(_, operand)| operations[*operand]).sum();
            operations.push(own as f64 + below);
        }
        self.results.iter().fold(0.0, |sum, result| sum + operations[*result])
    }
}

#[derive(Default)]
struct Drawing {
    vertices: Vec<Vertex>,
    /// The vertices of local names, inputs and numbers.
    known: FxHashMap<String, usize>,
}

impl Drawing {
    fn vertex(&mut self, label: &str, operands: Vec<(bool, usize)>) -> usize {
        self.vertices.push(Vertex { label: label.to_owned(), name: None, operands });
        self.vertices.len() - 1
    }

    fn leaf(&mut self, label: &str) -> usize {
        if let Some(vertex) = self.known.get(label) {
            return *vertex;
        }
        let vertex = self.vertex(label, vec![]);
        self.known.insert(label.to_owned(), vertex);
        vertex
    }

    fn name(&mut self, vertex: usize, name: &str) {
        self.known.insert(name.to_owned(), vertex);
        self.vertices[vertex].name = Some(name.to_owned());
    }

    fn wave(&mut self, wave: &Wave) {
        let argument = self.tree(&wave.argument);
        for (function, name) in [("sin", &wave.sin), ("cos", &wave.cos)] {
            if let Some(name) = name {
                let vertex = self.vertex(function, vec![(false, argument)]);
                self.name(vertex, name);
            }
        }
    }

    fn look_up(&mut self, look_up: &LookUp) {
        let argument = self.tree(&look_up.argument);
        for (order, name) in look_up.names.iter().enumerate() {
            if let Some(name) = name {
                let vertex = self.vertex(&format!("table{}", "'".repeat(order)), vec![(false, argument)]);
                self.name(vertex, name);
            }
        }
    }

    fn columns(&mut self, columns: &Columns) {
        let operands = columns.operands().map(|tree| (false, self.tree(tree))).collect();
        let matrix = self.vertex("solve", operands);
        for (i, row) in columns.names.iter().enumerate() {
            for (j, name) in row.iter().enumerate() {
                if let Some(name) = name {
                    let vertex = self.vertex(&format!("[{i}, {j}]"), vec![(false, matrix)]);
                    self.name(vertex, name);
                }
            }
        }
    }

    fn tree(&mut self, tree: &Tree) -> usize {
        let mut operands = |trees: &[&Tree]| trees.iter().map(|tree| (false, self.tree(tree))).collect::<Vec<_>>();
        match tree {
            Tree::Constant(value) => self.leaf(&value.to_string()),
            Tree::Name(name) | Tree::Field(name) => self.leaf(name),
            Tree::Sum(terms) => {
                let operands = terms.iter().map(|(minus, term)| (*minus, self.tree(term))).collect();
                self.vertex("+", operands)
            }
            Tree::Product(factors) => {
                let operands = operands(&factors.iter().collect::<Vec<_>>());
                self.vertex("*", operands)
            }
            Tree::Quotient(above, below) => {
                let operands = operands(&[above, below]);
                self.vertex("/", operands)
            }
            Tree::Negate(value) => {
                let operands = operands(&[value]);
                self.vertex("-", operands)
            }
            Tree::Method(name, arguments) => {
                let operands = operands(&arguments.iter().collect::<Vec<_>>());
                self.vertex(name, operands)
            }
        }
    }
}
